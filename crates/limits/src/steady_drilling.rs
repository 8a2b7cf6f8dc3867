//! Where steady drilling with blades that cut what they leave is about to grow: limits over the
//! surface speed, for values of the weight on bit.

use campaign::plan::{Bit, Sweep};
use campaign::quantities::Axis;
use linear::parallel;

use crate::axes::{position, range_of_axis};
use crate::torsion_limit::{StickSlipPoint, TorsionLimit, WAVES};

/// Weights and speeds at which it is looked whether steady drilling lasts; tongues that are narrower
/// than a step of speed are missed.
const WEIGHTS: usize = 16;
const SPEEDS: usize = 36;

/// Halvings between two speeds, to a thousandth of a step.
const HALVINGS: usize = 10;

/// The limits of a sweep whose design has the weight on bit and the surface speed as axes, from the
/// slowest at each weight on; none where resonances are too sharp to be followed.
pub fn steady_drilling_points(sweep: &Sweep, bit: &Bit) -> Vec<StickSlipPoint> {
    let places = [Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm]
        .map(|axis| position(sweep, |other| other == axis));
    let [Some(weight), Some(speed)] = places else {
        return Vec::new();
    };
    let [weights, speeds] = [weight, speed].map(|place| range_of_axis(sweep, place));
    let Ok(Some(cutting)) = sweep.setting.cutting_loop() else {
        return Vec::new();
    };
    let at = |weight: f64, speed: f64| {
        let conditions = (sweep.conditions)
            .with(Axis::WeightOnBitKn, weight)
            .with(Axis::SurfaceSpeedRpm, speed);
        sweep.setting.steady_drilling(bit, &conditions)?.1
    };
    let stiffest = [weights[0], weights[1]]
        .into_iter()
        .filter_map(|weight| at(weight, speeds[0]))
        .max_by(|one, other| one.weight.total_cmp(&other.weight));
    let cutting = match stiffest {
        Some(cut) => cutting.sampled_for(&cut),
        None => cutting,
    };
    let step = |[from, to]: [f64; 2], index: usize, count: usize| {
        from + (to - from) * index as f64 / (count - 1) as f64
    };
    let of_weight = |index: usize| -> Vec<[f64; 2]> {
        let weight = step(weights, index, WEIGHTS);
        let lasts = |speed: f64| Some(cutting.growing(&at(weight, speed)?)? == 0);
        let speeds: Vec<f64> = (0..SPEEDS)
            .map(|index| step(speeds, index, SPEEDS))
            .collect();
        let known: Vec<Option<bool>> = speeds.iter().map(|speed| lasts(*speed)).collect();
        let pairs = speeds.windows(2).zip(known.windows(2));
        pairs
            .filter_map(|(ends, known)| {
                let [Some(one), Some(other)] = [known[0], known[1]] else {
                    return None;
                };
                (one != other).then(|| [weight, between(ends, one, lasts)])
            })
            .collect()
    };
    let limits = parallel::map(WEIGHTS, 1, of_weight);
    let branches = branches(limits, (speeds[1] - speeds[0]) / SPEEDS as f64);
    let point = |[weight, speed]: [f64; 2]| {
        let conditions = sweep.conditions.with(Axis::WeightOnBitKn, weight);
        Some(StickSlipPoint {
            weight_on_bit_kn: Some(weight),
            torque_dynamic_nm: bit.torque_dynamic(&conditions).ok()??,
            surface_speed_rpm: speed,
            method: WAVES.to_owned(),
            limit: TorsionLimit::SteadyDrilling,
        })
    };
    branches.into_iter().flatten().filter_map(point).collect()
}

/// The speed between two ends of which the first lasts as `one` says, and the other does not.
fn between(ends: &[f64], one: bool, lasts: impl Fn(f64) -> Option<bool>) -> f64 {
    let (mut low, mut high) = (ends[0], ends[1]);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if lasts(middle) == Some(one) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Limits at one weight after the other as lines: each continues to what is nearest at the next
/// weight, unless that is further than a few `step`s of speed. Those that begin at the greatest weight come
/// first: where the weight does not grow from one point to the next, another line begins.
fn branches(limits: Vec<Vec<[f64; 2]>>, step: f64) -> Vec<Vec<[f64; 2]>> {
    const NEAR: f64 = 4.0;
    let mut branches: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    for mut points in limits {
        let mut next = Vec::new();
        for &branch in &open {
            let last = branches[branch].last().map_or(f64::NAN, |point| point[1]);
            let away = |point: &[f64; 2]| (point[1] - last).abs();
            let nearest = (0..points.len())
                .min_by(|one, other| away(&points[*one]).total_cmp(&away(&points[*other])));
            if let Some(nearest) = nearest.filter(|place| away(&points[*place]) <= NEAR * step) {
                branches[branch].push(points.remove(nearest));
                next.push(branch);
            }
        }
        for point in points {
            next.push(branches.len());
            branches.push(vec![point]);
        }
        open = next;
    }
    branches.sort_by(|one, other| other[0][0].total_cmp(&one[0][0]));
    branches
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_joined_to_the_nearest_of_the_next_weight() {
        let limits = vec![
            vec![[1.0, 50.0], [1.0, 90.0]],
            vec![[2.0, 52.0], [2.0, 120.0]],
            vec![[3.0, 54.0], [3.0, 121.0]],
        ];
        let found = branches(limits, 1.0);
        assert_eq!(
            found,
            [
                vec![[2.0, 120.0], [3.0, 121.0]],
                vec![[1.0, 50.0], [2.0, 52.0], [3.0, 54.0]],
                vec![[1.0, 90.0]],
            ]
        );
        // Read in a row, they are as many lines.
        let in_a_row = found.concat();
        assert_eq!(in_a_row.chunk_by(|one, next| one[0] < next[0]).count(), 3);
    }

    #[test]
    fn a_limit_is_found_between_its_ends() {
        let found = between(&[10.0, 20.0], true, |speed| Some(speed < 17.3));
        assert!((found - 17.3).abs() < 0.01);
    }
}
