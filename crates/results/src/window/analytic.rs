//! Limits that are known without a case.

use super::standing::Standing;
use limits::Curve;

/// A critical speed with its margin, rpm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    /// How often a turn the string is shaken.
    pub order: f64,
    /// The surface speed at which that meets a natural frequency.
    pub speed: f64,
    /// From where to where it may be met.
    pub range: [f64; 2],
}

impl Resonance {
    /// That of an order and a natural frequency (Hz), which may be off by a part.
    pub fn of(order: f64, frequency: f64, margin: f64) -> Self {
        let speed = 60.0 * frequency / order;
        Self {
            order,
            speed,
            range: [speed * (1.0 - margin), speed * (1.0 + margin)],
        }
    }
}

/// How a stretch stands to an estimate of slow speeds by several curves (speed over weight): above the
/// highest of them cases decide, where `has_cases` says that there are any; below it the estimate
/// expects what the cases may not have.
pub fn below_curves(
    curves: &[Curve],
    has_cases: bool,
    [weights, speeds]: [[f64; 2]; 2],
) -> Standing {
    let ranges = curves.iter().flat_map(|curve| curve.ranges(1, weights));
    let Some(highest) = ranges.map(|[_, high]| high).reduce(f64::max) else {
        // No curve reaches there.
        return Standing::Undetermined;
    };
    match Standing::above(speeds, f64::NEG_INFINITY, highest) {
        Standing::Clear if !has_cases => Standing::Undetermined,
        standing => standing,
    }
}

/// How a stretch stands to what can last from a speed on, once begun.
pub fn above_speed(from: f64, [_, [_, high]]: [[f64; 2]; 2]) -> Standing {
    match high <= from {
        true => Standing::Clear,
        false => Standing::Possible,
    }
}

/// How a stretch stands to critical speeds with their margins.
pub fn near_resonances(all: &[Resonance], [_, [low, high]]: [[f64; 2]; 2]) -> Standing {
    let is_met = |it: &Resonance| it.range[0] < high && low < it.range[1];
    match all.iter().any(is_met) {
        true => Standing::Near,
        false => Standing::Clear,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sim::Motion;

    use campaign::quantities::Axis;

    fn curve(ends: [[f64; 2]; 2]) -> Curve {
        Curve {
            name: "Eq. 74".to_owned(),
            method: None,
            motion: Motion::Torsion,
            along: Axis::WeightOnBitKn,
            limited: Axis::SurfaceSpeedRpm,
            pieces: vec![ends.to_vec()],
            is_least: true,
        }
    }

    #[test]
    fn an_estimate_is_no_limit() {
        let both = [
            curve([[0.0, 10.0], [100.0, 110.0]]),
            curve([[0.0, 20.0], [100.0, 120.0]]),
        ];
        let at = |speeds| below_curves(&both, true, [[50.0, 51.0], speeds]);
        assert_eq!(at([40.0, 59.0]), Standing::Near);
        assert_eq!(at([59.0, 61.0]), Standing::Near);
        assert_eq!(at([62.0, 63.0]), Standing::Near);
        assert_eq!(at([70.9, 90.0]), Standing::Near);
        assert_eq!(at([71.1, 90.0]), Standing::Clear);
        // Where no case speaks, the estimate alone calls nothing safe.
        let alone = below_curves(&both, false, [[50.0, 51.0], [71.1, 90.0]]);
        assert_eq!(alone, Standing::Undetermined);
        let outside = below_curves(&both, true, [[101.0, 102.0], [0.0, 1.0]]);
        assert_eq!(outside, Standing::Undetermined);
    }

    #[test]
    fn what_can_last_from_a_speed_on_cannot_below() {
        let at = |speeds| above_speed(100.0, [[0.0, 1.0], speeds]);
        assert_eq!(at([99.0, 100.0]), Standing::Clear);
        assert_eq!(at([100.0, 101.0]), Standing::Possible);
    }

    #[test]
    fn a_critical_speed_is_kept_clear_of_by_its_margin() {
        let found = Resonance::of(2.0, 4.0, 0.1);
        assert_eq!((found.speed, found.range), (120.0, [108.0, 132.0]));
        let at = |speeds| near_resonances(&[found], [[0.0, 1.0], speeds]);
        assert_eq!(at([100.0, 108.0]), Standing::Clear);
        assert_eq!(at([107.0, 109.0]), Standing::Near);
        assert_eq!(at([110.0, 111.0]), Standing::Near);
        assert_eq!(at([132.0, 140.0]), Standing::Clear);
    }
}
