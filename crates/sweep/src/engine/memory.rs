//! What the linear systems of a string take in memory, and a case stepped against
//! them: told before anything is built.

use linear::Method;
use linear::cost::{self, Memory};
use sim::cost::Taps;

use super::systems::request;
use super::verdict::FINER;
use crate::plan::{Setting, Sweep};

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
            let setting = setting.sampled_at(FINER * setting.sampling_frequency);
            Self::of_method(sweep, &setting, method, longest_time)
        });
        (methods.iter().map(of_method).chain(finer)).fold(Self::default(), |all, one| Self {
            systems: all.systems.beside(one.systems),
            case: all.case.max(one.case),
            too_long: (all.too_long.into_iter().chain(one.too_long)).reduce(f64::max),
        })
    }

    fn of_method(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        let (sites, cuts) = (setting.sites.len(), sweep.bit.is_some());
        let steps = sim::cost::steps(longest_time, setting.sampling_frequency);
        let request = request(setting, cuts, longest_time);
        let built = cost::responses(&setting.string, method, &request);
        let taps = Taps {
            torsion: built.torsion_taps,
            bending: built.bending_taps,
        };
        let loads = match &setting.lateral {
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
            let (frequency, nodes) = (setting.sampling_frequency, &friction.nodes);
            let (taps, built) = cost::cascade(&setting.string, nodes, frequency, longest_time);
            let kept = sim::cost::cascade(recorded, taps, steps);
            systems = systems
                .then(passing(built.peak + kept))
                .then(Memory::lasting(kept));
            case = case.max(sim::cost::cascade_case(recorded, taps, steps));
        }
        if sweep.keeps_motion() {
            case += sim::cost::trajectory(recorded, setting.lateral.is_some(), steps);
        }
        if sweep.finds_surface_torque() {
            let kept = sim::cost::surface_torque(sites, taps.torsion);
            systems = systems.then(Memory::lasting(kept));
            case += sim::cost::surface_torque_of(taps.torsion, steps);
        }
        Self {
            systems,
            case,
            too_long: built.too_long,
        }
    }
}

/// What is taken and given back.
fn passing(peak: f64) -> Memory {
    Memory { peak, kept: 0.0 }
}
