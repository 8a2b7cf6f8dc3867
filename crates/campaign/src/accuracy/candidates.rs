//! What is tried, in the order of its cost.

use linear::Method;
use linear::method::{FiniteElement, Transform};

use super::methods::Parameters;
use crate::plan::{Candidate, CuttingSettings, Sweep};

/// The lowest sampling frequency tried, about, Hz.
const LOWEST: f64 = 20.0;

/// How often it may be doubled. The last frequencies are for the reference alone.
const DOUBLINGS: u32 = 10;

/// Sampling frequencies, Hz, on a string that a torsional wave travels in `travel` (s): in
/// a whole number of steps, for a front that arrives within a step is met as a slope of
/// one step, and where it stops a bit that creeps, the limit depends on that.
pub fn frequencies(travel: f64) -> Vec<f64> {
    let steps = (LOWEST * travel).round().max(1.0);
    (0..=DOUBLINGS)
        .map(|doublings| steps * 2f64.powi(doublings as i32) / travel)
        .collect()
}

/// Two frequencies below one, at which a front that has been up the string and down again
/// arrives within a step, in its middle.
pub fn off_beat(frequency: f64, travel: f64) -> [f64; 2] {
    let steps = frequency * travel;
    [0.9, 0.75].map(|part| ((part * steps).round() + 0.25) / travel)
}

/// At one frequency, roughly by what a sweep costs: the quadrature and finite elements take
/// four samples a tap, the more the more elements there are; held responses take those of a
/// lattice whose pieces are far shorter than a step, once for all frequencies, and longer at
/// a wall; the digital filter needs taps for as long as the response lasts twice, and memory
/// for them in every case. Elements have the damping of the scene; what `hangs` from a hook load has no place
/// of rest, which the digital filter needs.
pub fn methods(sweep: &Sweep) -> Vec<Method> {
    let gamma = sweep.usual_gamma();
    let hangs = (sweep.setting.cutting.as_ref()).is_some_and(CuttingSettings::hangs);
    let elements = |elements_per_cell| {
        Method::FiniteElement(FiniteElement {
            elements_per_cell,
            gamma,
            ..FiniteElement::default()
        })
    };
    let filter = (!hangs).then(|| Method::Hilbert(Transform::default()));
    let others = [
        Method::Quadrature,
        elements(2),
        elements(5),
        Method::Held,
        elements(20),
    ];
    others.into_iter().chain(filter).collect()
}

/// A method at a frequency, as it is reported.
pub fn candidate(method: &Method, frequency: f64) -> Candidate {
    Candidate {
        method: method.name().to_owned(),
        elements_per_cell: Parameters::of(method).elements_per_cell,
        sampling_frequency_hz: frequency,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fronts_are_in_time_with_frequencies_and_not_with_others() {
        let travel = 0.313;
        for frequency in frequencies(travel) {
            let steps = frequency * travel;
            assert!((steps - steps.round()).abs() < 1e-9 && steps >= 1.0);
            for other in off_beat(frequency, travel) {
                let round_trip = 2.0 * other * travel;
                assert!((round_trip.fract() - 0.5).abs() < 1e-9, "{round_trip}");
            }
        }
    }
}
