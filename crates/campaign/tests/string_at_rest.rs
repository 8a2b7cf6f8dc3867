//! Validation of a string at rest in its hole on the default sites: random assemblies in straight,
//! building and turning wells are as those that may touch at every half metre.

use std::f64::consts::PI;
use std::path::Path;

use campaign::plan::Sweep;
use linear::well::GRAVITY;
use numerics::random::Stream;
use statics::closed_forms::buckling;
use statics::{Bit, LeavingWay, LyingString, StaticState};

/// Assemblies that are tried, and the seed of their family.
const COUNT: u64 = 24;
const SEED: u64 = 9316;

/// Numbers agree to this part of themselves, or tilts to this angle, rad.
const SAME: f64 = 0.01;
const SAME_TILT: f64 = 2e-5;

/// Weight on bit is less than this part of that from which on the string leaves its place.
const MOST_WEIGHT: f64 = 0.8;

/// A random assembly with its well.
struct Assembly {
    file: String,
    survey: String,
    blades: Vec<f64>,
    /// Weight on bit, N.
    weight: f64,
}

impl Assembly {
    /// Bit, collars with up to three stabilisers, heavy pipe and drillpipe; a well that is straight,
    /// builds or turns, by its number.
    fn random(number: u64) -> Self {
        let mut stream = Stream::new(SEED, number);
        let mut uniform = |from: f64, to: f64| from + (to - from) * stream.part();
        let hole = [0.1079, 0.1555, 0.2222][(uniform(0.0, 3.0)) as usize];
        let collar = hole * uniform(0.55, 0.8);
        let bore = uniform(0.03, 0.04);
        let part = |length: f64, inner: f64, outer: f64| {
            format!(
                "length_m = {length:.2}, inner_radius_m = {inner:.4}, outer_radius_m = {outer:.4}"
            )
        };
        let mut lower = Vec::new();
        let (mut end, mut blades) = (0.0, Vec::new());
        for _ in 0..uniform(0.0, 4.0) as usize {
            let (collars, long) = ((100.0 * uniform(1.0, 25.0)).round() / 100.0, 0.8);
            lower.push(format!("{{ {} }}", part(collars, bore, collar)));
            let gauge = hole - uniform(0.0008, 0.006);
            let blade = part(long, bore, collar);
            lower.push(format!("{{ {blade}, contact_radius_m = {gauge:.4} }}"));
            blades.push(end + collars + 0.5 * long);
            end += collars + long;
        }
        lower.push(format!("{{ {} }}", part(uniform(20.0, 80.0), bore, collar)));
        lower.reverse();
        let pipe = [0.0635, 0.0699][uniform(0.0, 2.0) as usize];
        let joint = part(0.5, 0.04, pipe + 0.018);
        let pipe = part(9.1, pipe - 0.0095, pipe);
        let (weight, inclination) = (1e3 * uniform(0.0, 200.0), uniform(15.0, 90.0));
        let (build, turn) = (uniform(-0.1, 0.1), uniform(-0.1, 0.1));
        let [build, turn] = match number % 3 {
            0 => [0.0, 0.0],
            1 => [build, 0.0],
            _ => [build, turn],
        };
        let azimuth = uniform(0.0, 360.0);
        let station = |index: u32| {
            let depth = 10.0 * f64::from(index);
            let inclined = (inclination + build * (depth - 500.0)).clamp(10.0, 90.0);
            format!(
                "{depth},{inclined:.4},{:.4}\n",
                azimuth + turn * depth + 60.0
            )
        };
        let stations: String = (0..60).map(station).collect();
        let file = format!(
            "surface_speed_rpm = 60\nmethods = [\"finite-element\"]\nsampling_frequency_hz = 100\n\
             [string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 0.05\n\
             bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = 200, surface = \"pinned\" }}\n\
             [[string.sections]]\nrepeat = 40\nparts = [{{ {pipe} }}, {{ {joint} }}]\n\
             [[string.sections]]\nrepeat = 1\nparts = [{}]\n\
             [axial_force]\n[mud]\ndensity_kg_m3 = {:.0}\n\
             [well]\nhole_radius_m = {hole}\nsurvey = \"s.csv\"\n\
             [wall]\nclearance = \"hole\"\nstiffness_gn_m15 = 1\nfriction = 0.2\n\
             sites = \"ends\"\nsites_to_m = 150\n\
             [bit]\nrock = \"table\"\ntable_kn_nm = [[0, 0], [1000, 10000]]\nweight_on_bit_kn = 10\n",
            lower.join(", "),
            uniform(1000.0, 1800.0),
        );
        Self {
            file,
            survey: format!("measured_depth_m,inclination_deg,azimuth_deg\n{stations}"),
            blades,
            weight,
        }
    }

    /// The string at rest, with its sites or with others at a distance (m).
    fn resting(&self, every: Option<f64>) -> LyingString {
        let sites = every.map_or(String::new(), |every| format!("sites_every_m = {every}\n"));
        let file = self
            .file
            .replace("sites_to_m", &format!("{sites}sites_to_m"));
        resting(&file, &self.survey, None)
    }
}

/// The string at rest of a file with its survey, its bit held as is said.
fn resting(file: &str, survey: &str, bit: Option<Bit>) -> LyingString {
    let text = |path: &Path, _: u64| {
        let is_survey = path.ends_with("s.csv");
        Ok(if is_survey { survey } else { file }.to_owned())
    };
    let sweep = Sweep::read_from(Path::new("sweep.toml"), &[], &text).unwrap();
    let resting = sweep.setting.resting_string(&sweep.conditions, bit);
    resting.unwrap().unwrap()
}

/// How far the numbers of two states are apart, in parts of what they agree to: moment, tilt, and
/// forces on bit and blades up to a distance.
fn apart([one, other]: [&StaticState; 2], blades: &[f64], to: f64) -> [f64; 3] {
    let part = |one: f64, other: f64| (one - other).abs() / (SAME * other.abs());
    let moment = part(one.greatest_moment(to).1, other.greatest_moment(to).1);
    let [[x, y], [other_x, other_y]] = [one, other].map(StaticState::tilt_of_bit);
    let tilt = (x - other_x).hypot(y - other_y) / (SAME * other_x.hypot(other_y)).max(SAME_TILT);
    let on = |state: &StaticState| -> Vec<f64> {
        let is_wanted =
            |place: f64| place == 0.0 || blades.iter().any(|blade| (blade - place).abs() < 2e-3);
        let contacts = state.contacts().iter();
        let wanted = contacts.filter(|it| is_wanted(it.contact.distance_from_bit));
        wanted.map(|it| it.normal()).collect()
    };
    let (forces, others) = (on(one), on(other));
    assert_eq!(forces.len(), others.len());
    let greatest = others.iter().copied().fold(0.0, f64::max);
    let forces = forces.iter().zip(&others);
    let force = forces.map(|(one, other)| (one - other).abs() / (SAME * greatest));
    [moment, tilt, force.fold(0.0, f64::max)]
}

/// Plain pipe in a hole (m) on the default sites, in a well with its sites.
fn plain_pipe([length, inner, outer, hole]: [f64; 4], well: &str, sites: &str) -> String {
    format!(
        "surface_speed_rpm = 60\nmethods = [\"finite-element\"]\nsampling_frequency_hz = 100\n\
         [string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\n\
         torsional_damping_nms_rad_m = 0.05\n\
         bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = 200, surface = \"pinned\" }}\n\
         [[string.sections]]\nrepeat = 1\n\
         parts = [{{ length_m = {length}, inner_radius_m = {inner}, outer_radius_m = {outer} }}]\n\
         [axial_force]\n[mud]\ndensity_kg_m3 = 1200\n[well]\nhole_radius_m = {hole}\n{well}\n\
         [wall]\nclearance = \"hole\"\nstiffness_gn_m15 = 1\nfriction = 0.2\n\
         sites = \"ends\"\n{sites}\n\
         [bit]\nrock = \"table\"\ntable_kn_nm = [[0, 0], [1000, 10000]]\nweight_on_bit_kn = 50\n"
    )
}

/// Plain pipe on the low side snakes from 2 √(EI q/c) on where the bit is held, and from half of that on
/// where it is free.
#[test]
fn plain_pipe_on_default_sites_snakes_as_by_the_closed_form() {
    let (inner, outer, hole) = (0.0543, 0.0635, 0.10795);
    let file = plain_pipe(
        [100.0, inner, outer, hole],
        "inclination_deg = 90",
        "sites_to_m = 80",
    );
    let rigidity = 206e9 * PI / 4.0 * (outer.powi(4) - inner.powi(4));
    let load = PI * (outer.powi(2) - inner.powi(2)) * (7850.0 - 1200.0) * GRAVITY;
    let exact = buckling::of_lying_string(rigidity, load, hole - outer);
    for (bit, part) in [(Bit::Contact, 1.0), (Bit::Pinned, 1.0), (Bit::Free, 0.5)] {
        let leaving = resting(&file, "", Some(bit)).leaving(2e6).unwrap().unwrap();
        assert_eq!(leaving.way, LeavingWay::Buckles);
        let off = leaving.weight_on_bit / (part * exact) - 1.0;
        assert!(off.abs() < 0.03, "{bit:?} {off}");
    }
}

/// A hole that turns has no bifurcation: the moment of pipe whose bit is free runs away from some 60 kN on,
/// long before a pivot changes its sign.
#[test]
fn the_moment_of_pipe_in_a_hole_that_turns_runs_away() {
    let station = |index: u32| {
        let depth = 10.0 * f64::from(index);
        format!("{depth},60,{}\n", 100.0 + depth / 15.0)
    };
    let stations: String = (0..32).map(station).collect();
    let survey = format!("measured_depth_m,inclination_deg,azimuth_deg\n{stations}");
    let file = plain_pipe(
        [300.0, 0.0543, 0.0635, 0.155],
        "survey = \"s.csv\"",
        "sites_to_m = 150",
    );
    let lying = resting(&file, &survey, Some(Bit::Free));
    let leaving = lying.leaving(2e6).unwrap().unwrap();
    assert_eq!(leaving.way, LeavingWay::RunsAway);
    assert!((40e3..65e3).contains(&leaving.weight_on_bit), "{leaving:?}");
    let moment = |weight: f64| {
        lying
            .under(weight)
            .at_rest()
            .unwrap()
            .greatest_moment(120.0)
            .1
    };
    assert!(moment(70e3) > 3.0 * moment(40e3));
}

/// The tilt of the bit, the greatest moment and the force on blades of long smooth collars below jointed pipe.
#[test]
fn long_collars_lie_on_default_sites_as_on_sites_every_two_metres() {
    let collar = "inner_radius_m = 0.0357, outer_radius_m = 0.1016";
    let parts = format!(
        "parts = [{{ length_m = 9.1, inner_radius_m = 0.0607, outer_radius_m = 0.0699 }}, \
         {{ length_m = 0.5, inner_radius_m = 0.0445, outer_radius_m = 0.0889 }}]\n\
         [[string.sections]]\nrepeat = 1\nparts = [{{ length_m = 56, {collar} }}, \
         {{ length_m = 1.6, {collar}, contact_radius_m = 0.1524 }}, {{ length_m = 12, {collar} }}]\n"
    );
    let plain = plain_pipe(
        [1.0, 0.0, 1.0, 0.155575],
        "inclination_deg = 90",
        "sites_to_m = 120",
    );
    let (before, after) = plain.split_once("repeat = 1\n").unwrap();
    let (_, after) = after.split_once('\n').unwrap();
    let assembly = Assembly {
        file: format!("{before}repeat = 20\n{parts}{after}"),
        survey: String::new(),
        blades: vec![12.8],
        weight: 150e3,
    };
    let states = [None, Some(2.0)].map(|every| {
        let lying = assembly.resting(every).under(assembly.weight);
        lying.at_rest().unwrap()
    });
    let apart = apart([&states[0], &states[1]], &assembly.blades, 100.0);
    assert!(apart.iter().all(|it| *it <= 1.0), "{apart:?}");
}

#[test]
fn random_assemblies_lie_on_default_sites_as_on_sites_every_half_metre() {
    let (mut within, mut tried) = (0, 0);
    for number in 0..COUNT {
        let assembly = Assembly::random(number);
        let lying = assembly.resting(None);
        let leaving = lying.leaving(2e6).unwrap();
        let is_plane = number % 3 < 2;
        assert!(!is_plane || leaving.is_none_or(|it| it.way == LeavingWay::Buckles));
        let most = leaving.map_or(2e6, |it| it.weight_on_bit);
        let weight = assembly.weight.min(MOST_WEIGHT * most);
        let states = [lying, assembly.resting(Some(0.5))].map(|it| it.under(weight).at_rest());
        let [Ok(state), Ok(fine)] = &states else {
            continue;
        };
        let apart = apart([state, fine], &assembly.blades, 100.0);
        tried += 1;
        within += usize::from(apart.iter().all(|it| *it <= 1.0));
    }
    assert!(
        tried + 1 >= COUNT && within + 2 >= tried as usize,
        "{within} of {tried}"
    );
}
