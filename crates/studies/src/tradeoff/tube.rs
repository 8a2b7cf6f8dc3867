//! Measures of a uniform tube, under the loads of Figs. 8(b) and 9.
//!
//! The joints of the paper's string wear fronts down; on a plain tube they stay as sharp
//! as they began, and what filters and elements make of them decides. Its limit of
//! stick-slip is looked for twice. By the steps of the ladder an echo arrives within one,
//! and a rise that lasts a step has another limit, however short that is. So it is once
//! more by steps next to them that divide the travel time.

use std::collections::BTreeMap;

use anyhow::Result;

use super::measure::Measure;
use super::part::Part;
use super::row::{Reference, extrapolated};
use super::torsion;
use super::tube_waves::UniformTube;
use crate::scenes::shipped;
use campaign::engine::{MethodSystem, Stopwatch};

/// By finer steps nothing changes any more, Hz; finite elements would take minutes.
const HIGHEST: f64 = 2560.0;

/// Steps per travel time of the references: with half and all of them.
const STEPS_TO_BIT: usize = 16_000;

/// The tube, by the ladder as it is and by one that fits, as far as they are wanted, with
/// what the measures should be.
///
/// # Errors
/// Where a reference cannot be computed.
pub fn parts(wanted: &[Measure]) -> Result<Vec<Part>> {
    let mut plain = scene()?;
    let tube = UniformTube::of(&plain.sweep.setting.string);
    let mut fitted = Part {
        whole_steps_of: Some(tube.travel),
        ..scene()?
    };
    let is_simulated = |measure: &Measure| *measure != Measure::TubeUndershoot;
    let limit = (wanted.iter().any(is_simulated))
        .then(|| limit(&plain, &tube))
        .transpose()?;
    for &measure in wanted {
        let (part, reference) = match measure {
            Measure::TubeUndershoot => (&mut plain, Some(Reference::exact(tube.undershoot()))),
            Measure::TubeFittedLimit => (&mut fitted, limit),
            _ => (&mut plain, limit),
        };
        part.references
            .extend(reference.map(|reference| (measure, reference)));
    }
    let parts = [plain, fitted].into_iter();
    Ok(parts.filter(|part| !part.references.is_empty()).collect())
}

fn scene() -> Result<Part> {
    let sweep = shipped("uniform_tube.toml")?;
    Ok(Part {
        longest: torsion::longest_time(&sweep, torsion::bracket(&sweep)?)?,
        sweep,
        impulse_duration: f64::INFINITY,
        highest: HIGHEST,
        whole_steps_of: None,
        history: None,
        references: BTreeMap::new(),
        number: torsion::number,
    })
}

/// The limit of stick-slip in steps far shorter than those of the ladder; sure to what
/// halving them changes.
fn limit(part: &Part, tube: &UniformTube) -> Result<Reference> {
    let coarse = exact_limit(part, tube, STEPS_TO_BIT / 2)?;
    let fine = exact_limit(part, tube, STEPS_TO_BIT)?;
    Ok(Reference {
        // Slips begin and end with steps, so that the order is the first.
        value: extrapolated(coarse, fine, 1),
        uncertainty: (coarse / fine - 1.0).abs(),
    })
}

/// That limit by the stepper of all cases against the waves in closed form, in a number of steps to
/// the travel time.
fn exact_limit(part: &Part, tube: &UniformTube, steps_to_bit: usize) -> Result<f64> {
    let (setting, begun) = (&part.sweep.setting, Stopwatch::start());
    let responses = tube.responses(&setting.string, steps_to_bit, part.longest);
    let setting = setting.sampled_at(responses.sampling_frequency);
    let system = MethodSystem::of(&setting, responses, begun)?;
    Ok(part.numbers_of(&system, &[Measure::TubeStickSlipLimit])?[0])
}

#[cfg(test)]
mod tests {
    use linear::Method;

    use super::*;

    /// Where f_s fits, `held` has the limit in few steps; quadrature is off, and further in
    /// shorter ones.
    #[test]
    fn held_finds_the_limit_of_a_uniform_tube_where_steps_fit() {
        let part = scene().unwrap();
        let tube = UniformTube::of(&part.sweep.setting.string);
        let exact = exact_limit(&part, &tube, 3200).unwrap();
        assert!((exact / 0.05337 - 1.0).abs() < 1e-3, "{exact}");
        let error = |method, steps_to_bit: f64| {
            let frequency = steps_to_bit / tube.travel;
            let limit = [Measure::TubeStickSlipLimit];
            let found = part.numbers(method, frequency, &limit).unwrap();
            found[0] / exact - 1.0
        };
        // It is the way there and back that has to fit.
        for (steps_to_bit, most) in [(50.0, 3e-3), (200.0, 1e-3), (200.5, 1e-3)] {
            let found = error(Method::Held, steps_to_bit);
            assert!(found.abs() < most, "{found}");
        }
        assert!(error(Method::Held, 200.25).abs() > 0.03);
        assert!(error(Method::Quadrature, 200.0) > 0.05);
        assert!(error(Method::Quadrature, 400.0) > error(Method::Quadrature, 200.0));
    }

    #[test]
    fn a_ladder_that_fits_has_whole_steps_to_the_bit() {
        let wanted = [Measure::TubeUndershoot];
        let parts = parts(&wanted).unwrap();
        assert_eq!(parts.len(), 1);
        assert_eq!(parts[0].fitted_frequency(640.0), 640.0);
        let tube = UniformTube::of(&parts[0].sweep.setting.string);
        let fitted = Part {
            whole_steps_of: Some(tube.travel),
            ..scene().unwrap()
        };
        assert!((fitted.fitted_frequency(640.0) * tube.travel - 200.0).abs() < 1e-9);
        assert!((fitted.fitted_frequency(0.1) * tube.travel - 1.0).abs() < 1e-9);
    }
}
