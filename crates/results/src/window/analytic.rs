//! Limits that are known without a case.

use super::chart::{Drawn, Source};
use super::standing::Standing;
use campaign::words::short;
use limits::Curve;

/// A critical speed with its margin, rpm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    /// How often a turn the string is shaken.
    pub order: f64,
    /// From the least to the greatest surface speed at which that meets a natural frequency.
    pub speeds: [f64; 2],
    /// From where to where it may be met.
    pub range: [f64; 2],
}

impl Resonance {
    /// A critical speed of an order and a natural frequency (Hz), known to be between two, each of which
    /// may be off by a part.
    pub fn new(order: f64, frequencies: [f64; 2], margin: f64) -> Self {
        let speeds = frequencies.map(|frequency| 60.0 * frequency / order);
        Self {
            order,
            speeds,
            range: [speeds[0] * (1.0 - margin), speeds[1] * (1.0 + margin)],
        }
    }

    /// The critical speed in words, rpm.
    pub fn words(&self) -> String {
        let [least, most] = self.speeds.map(short);
        match least == most {
            true => least,
            false => format!("{least} to {most}"),
        }
    }
}

/// Critical speeds of an order on a map as a limit, with their margin.
pub fn resonance_limit(
    name: &str,
    order: f64,
    (all, margin): (Vec<Resonance>, f64),
    held: &str,
) -> Source<'static> {
    let critical: Vec<String> = all.iter().map(Resonance::words).collect();
    let critical = match &critical[..] {
        [] => "none on the map".to_owned(),
        critical => format!("{} rpm", critical.join(", ")),
    };
    let order = short(order);
    let band = |it: &Resonance| (it.range, format!("{order}×: {} rpm", it.words()));
    Source {
        name: format!("{name} {order}×"),
        description: format!("{critical}, ± {} %; {held}", short(100.0 * margin)),
        edges: [Vec::new(), all.iter().flat_map(|it| it.range).collect()],
        drawn: Drawn::Bands(all.iter().map(band).collect()),
        standing: Box::new(move |ends| near_resonances(&all, ends)),
    }
}

/// Lowest and highest speed of curves over weight; none where no curve reaches.
fn range_over(curves: &[Curve], weights: [f64; 2]) -> Option<[f64; 2]> {
    let ranges = curves.iter().flat_map(|curve| curve.ranges(1, weights));
    ranges.reduce(|one, other| [one[0].min(other[0]), one[1].max(other[1])])
}

/// How a stretch stands to an estimate of slow speeds, which is no limit: what is below its highest curve
/// may be either, and above that cases decide alone.
pub fn below_estimate(curves: &[Curve], [weights, speeds]: [[f64; 2]; 2]) -> Standing {
    match range_over(curves, weights) {
        Some([_, highest]) => Standing::above(speeds, f64::NEG_INFINITY, highest),
        None => Standing::Undetermined,
    }
}

/// How a stretch stands to a limit below which smooth rotation is lost; where no curve reaches, it lasts
/// at every speed.
pub fn below_limit(curves: &[Curve], [weights, speeds]: [[f64; 2]; 2]) -> Standing {
    match range_over(curves, weights) {
        Some([lowest, highest]) => Standing::above(speeds, lowest, highest),
        None => Standing::Clear,
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
        let at = |speeds| below_estimate(&both, [[50.0, 51.0], speeds]);
        assert_eq!(at([40.0, 59.0]), Standing::Near);
        assert_eq!(at([59.0, 61.0]), Standing::Near);
        assert_eq!(at([62.0, 63.0]), Standing::Near);
        assert_eq!(at([70.9, 90.0]), Standing::Near);
        assert_eq!(at([71.1, 90.0]), Standing::Clear);
        let outside = below_estimate(&both, [[101.0, 102.0], [0.0, 1.0]]);
        assert_eq!(outside, Standing::Undetermined);
    }

    #[test]
    fn what_is_between_two_curves_of_a_limit_is_uncertain() {
        let both = [
            curve([[0.0, 10.0], [100.0, 110.0]]),
            curve([[0.0, 20.0], [100.0, 120.0]]),
        ];
        let at = |speeds| below_limit(&both, [[50.0, 51.0], speeds]);
        assert_eq!(at([40.0, 59.0]), Standing::Against);
        assert_eq!(at([59.0, 61.0]), Standing::Near);
        assert_eq!(at([71.1, 90.0]), Standing::Clear);
        let outside = below_limit(&both, [[101.0, 102.0], [0.0, 1.0]]);
        assert_eq!(outside, Standing::Clear);
    }

    #[test]
    fn what_can_last_from_a_speed_on_cannot_below() {
        let at = |speeds| above_speed(100.0, [[0.0, 1.0], speeds]);
        assert_eq!(at([99.0, 100.0]), Standing::Clear);
        assert_eq!(at([100.0, 101.0]), Standing::Possible);
    }

    #[test]
    fn a_critical_speed_is_kept_clear_of_by_its_margin() {
        let found = Resonance::new(2.0, [4.0; 2], 0.1);
        assert_eq!((found.speeds, found.range), ([120.0; 2], [108.0, 132.0]));
        let at = |speeds| near_resonances(&[found], [[0.0, 1.0], speeds]);
        assert_eq!(at([100.0, 108.0]), Standing::Clear);
        assert_eq!(at([107.0, 109.0]), Standing::Near);
        assert_eq!(at([110.0, 111.0]), Standing::Near);
        assert_eq!(at([132.0, 140.0]), Standing::Clear);
    }
}
