//! What the linear systems of a string take in memory, and a case stepped against
//! them: told before anything is built.

use linear::cost::{self, Memory};
use linear::method::FiniteElement;
use linear::{Method, Sites};
use sim::cost::Taps;

use super::finding::most_sites;
use super::finer::finer_frequency;
use super::rubbing;
use super::stepped::{looked_at, stepped_by};
use super::systems::request;
use crate::plan::{Setting, StringFriction, Sweep};

/// Memory of one string by all methods, bytes: upper bounds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StringMemory {
    /// What its systems take.
    pub systems: Memory,
    /// What a case takes while it is stepped.
    pub case: f64,
    /// The longest response asked for, in taps, where no method gives one so long.
    pub too_long: Option<f64>,
}

impl StringMemory {
    /// Of the cases of a sweep, up to the longest time (s). Methods are built side by side,
    /// with the shorter steps of those among them that certify labels.
    pub fn of(sweep: &Sweep, setting: &Setting, methods: &[Method], longest_time: f64) -> Self {
        let of_method = |method| Self::of_method(sweep, setting, method, longest_time);
        let places = sweep.certifying.into_iter().flatten();
        let finer = places.filter_map(|place| methods.get(place)).map(|method| {
            let setting = setting.sampled_at(finer_frequency(setting, method));
            Self::of_method(sweep, &setting, method, longest_time)
        });
        (methods.iter().map(of_method).chain(finer)).fold(Self::default(), |all, one| Self {
            systems: all.systems.beside(one.systems),
            case: all.case.max(one.case),
            too_long: (all.too_long.into_iter().chain(one.too_long)).reduce(f64::max),
        })
    }

    fn of_method(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        let mut own = Self::at_sites(sweep, setting, method, longest_time);
        if let Some(most) = with_most_sites(setting, method) {
            // A case is run again with a system of its own, and its whole string looked at.
            let again = Self::at_sites(sweep, &most, method, longest_time);
            let mesh = &sweep.content.method.finite_element;
            let whole = cost::reconstruction(&most.string, &most.sites, mesh, 0);
            own.case = own.case.max(again.systems.peak + again.case) + whole.peak;
        }
        own
    }

    fn at_sites(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        if let Some((_, parameters)) = stepped_by(setting, method) {
            return Self::of_stepped(sweep, setting, &parameters, longest_time);
        }
        let (sites, cuts) = (setting.sites.len(), sweep.bit.is_some());
        let steps = sim::cost::steps(longest_time, setting.sampling_frequency);
        let request = request(setting, cuts, longest_time);
        let built = cost::responses(&setting.string, method, &request);
        let taps = Taps {
            torsion: built.torsion_taps,
            bending: built.bending_taps,
        };
        let loads = match &setting.lateral {
            _ if setting.friction.is_some() => 0,
            Some(_) => sites,
            None => usize::from(cuts),
        };
        let prepared = sim::cost::simulator(sites, loads, taps, steps);
        // Margins are found after the simulator has been prepared.
        let mut systems = (built.memory)
            .then(prepared)
            .then(passing(cost::margin(loads, taps.torsion)));
        if setting.lateral.is_some() {
            systems = systems.then(passing(cost::bending_margin(sites, taps.bending)));
        }
        let mut case = sim::cost::case(sites, taps, steps);
        let mut recorded = sites;
        if let Some(friction) = &setting.friction {
            recorded = friction.nodes.len();
            let (added, of_case) = of_friction(setting, friction, method, longest_time);
            systems = systems.then(added);
            case += of_case;
            if !rubbing::is_in_pieces(method) {
                case += sim::cost::trajectory(2 * recorded, setting.lateral.is_some(), steps);
            }
        }
        Self {
            systems,
            case,
            too_long: built.too_long,
        }
        .with_motion(sweep, setting, recorded, taps.torsion, steps)
    }

    /// Of elements that are stepped.
    fn of_stepped(
        sweep: &Sweep,
        setting: &Setting,
        parameters: &FiniteElement,
        longest_time: f64,
    ) -> Self {
        let (sites, loads) = (setting.sites.len(), looked_at(setting).len());
        let steps = sim::cost::steps(longest_time, setting.sampling_frequency);
        let request = request(setting, false, longest_time);
        let built = cost::stepped(&setting.string, &request, loads, parameters);
        let prepared = Memory::lasting(
            built.memory.kept + sim::cost::stepped_simulator(sites, built.torsion_taps),
        );
        let margins = [
            cost::margin(loads, built.torsion_taps),
            cost::bending_margin(loads, built.bending_taps),
        ];
        let systems = margins.into_iter().map(passing);
        let motion = cost::stepped_motion(&setting.string, &setting.sites, parameters);
        Self {
            systems: systems.fold(built.memory.then(prepared), Memory::then),
            case: motion + sim::cost::stepped_case(sites, steps),
            too_long: built.too_long,
        }
        .with_motion(sweep, setting, sites, built.torsion_taps, steps)
    }

    /// With what a motion of so many places takes that is kept until its row is known.
    fn with_motion(
        mut self,
        sweep: &Sweep,
        setting: &Setting,
        recorded: usize,
        torsion_taps: f64,
        steps: f64,
    ) -> Self {
        let lateral = setting.lateral.as_ref();
        let finds_sites = lateral.is_some_and(|lateral| lateral.finding.is_some());
        if sweep.keeps_motion() || finds_sites {
            self.case += sim::cost::trajectory(recorded, lateral.is_some(), steps);
        }
        if sweep.finds_surface_torque() {
            let kept = sim::cost::surface_torque(recorded, torsion_taps);
            self.systems = self.systems.then(Memory::lasting(kept));
            self.case += sim::cost::surface_torque_of(torsion_taps, steps);
        }
        self
    }
}

/// What friction along the string takes, and a case of it, bytes.
fn of_friction(
    setting: &Setting,
    friction: &StringFriction,
    method: &Method,
    longest_time: f64,
) -> (Memory, f64) {
    let (frequency, nodes) = (setting.sampling_frequency, friction.nodes.len());
    let steps = sim::cost::steps(longest_time, frequency);
    if rubbing::is_in_pieces(method) {
        let (taps, built) =
            cost::cascade(&setting.string, &friction.nodes, frequency, longest_time);
        let kept = sim::cost::cascade(nodes, taps, steps);
        let built = passing(built.peak + kept).then(Memory::lasting(kept));
        return (built, sim::cost::cascade_case(nodes, taps, steps));
    }
    let request = rubbing::request(setting, friction, longest_time);
    let built = cost::responses(&setting.string, method, &request);
    let (prepared, case) = sim::cost::rubbing(nodes, built.torsion_taps, steps);
    let surface = sim::cost::surface_torque(nodes, built.torsion_taps);
    let finding = sim::cost::surface_torque_of(built.torsion_taps, steps);
    let memory = built.memory.then(prepared).then(Memory::lasting(surface));
    (memory, case + finding)
}

/// A setting with as many sites as may be found, where they are looked for, wherever they are.
fn with_most_sites(setting: &Setting, method: &Method) -> Option<Setting> {
    let finding = setting.lateral.as_ref()?.finding.as_ref()?;
    let most = most_sites(setting, method).max(setting.sites.len());
    let reach = finding.to.min(setting.string.length());
    let place = |site: usize| reach * site as f64 / most as f64;
    let places: Vec<f64> = (0..most).rev().map(place).collect();
    let sites = Sites::new(&setting.string, &places).ok()?;
    Some(Setting {
        sites,
        ..setting.clone()
    })
}

/// What is taken and given back.
fn passing(peak: f64) -> Memory {
    Memory { peak, kept: 0.0 }
}
