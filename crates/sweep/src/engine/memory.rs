//! What the linear systems of a string take in memory, and a case stepped against
//! them: told before anything is built.

use linear::Method;
use linear::cost::{self, Memory};

use super::systems::{bending_request, torsion_request};
use crate::spec::Setting;

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
    /// Of cases up to the longest time (s), their bit cutting or not. Methods are
    /// built side by side.
    pub fn of(setting: &Setting, methods: &[Method], cuts: bool, longest_time: f64) -> Self {
        let of_method = |method| Self::of_method(setting, method, cuts, longest_time);
        methods
            .iter()
            .map(of_method)
            .fold(Self::default(), |all, one| Self {
                systems: all.systems.beside(one.systems),
                case: all.case.max(one.case),
                too_long: longer(all.too_long, one.too_long),
            })
    }

    fn of_method(setting: &Setting, method: &Method, cuts: bool, longest_time: f64) -> Self {
        let sites = setting.sites.len();
        let steps = sim::cost::steps(longest_time, setting.sampling_frequency);
        let request = torsion_request(setting, cuts, longest_time);
        let inputs = request.torque_inputs.len();
        let torsion = cost::torsion_responses(&setting.string, method, &request);
        // A margin is found after the system has been prepared.
        let margin = passing(cost::margin(inputs, torsion.taps));
        let Some(lateral) = &setting.lateral else {
            let prepared = if cuts {
                sim::cost::torsion_system(sites, torsion.taps, steps)
            } else {
                sim::cost::free_system(sites, torsion.taps)
            };
            return Self {
                systems: torsion.memory.then(prepared).then(margin),
                case: sim::cost::torsion_case(torsion.taps, steps),
                too_long: torsion.too_long,
            };
        };
        let request = bending_request(setting, lateral, longest_time);
        let bending = cost::bending_responses(&setting.string, method, &request);
        let prepared = sim::cost::lateral_system(sites, torsion.taps, bending.taps);
        let velocities = cost::bending_margin(sites, bending.taps);
        Self {
            systems: (torsion.memory.beside(bending.memory))
                .then(prepared)
                .then(margin)
                .then(passing(velocities)),
            case: sim::cost::lateral_case(sites, torsion.taps, bending.taps, steps),
            too_long: longer(torsion.too_long, bending.too_long),
        }
    }
}

/// What is taken and given back.
fn passing(peak: f64) -> Memory {
    Memory { peak, kept: 0.0 }
}

fn longer(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.max(other)),
        _ => one.or(other),
    }
}
