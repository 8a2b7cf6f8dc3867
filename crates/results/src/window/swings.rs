//! Swing resonances of a string that lies on the low side of its hole: surface speeds that equal, in multiples,
//! the frequencies of its small swings about where it slides steadily.

use std::f64::consts::TAU;

use super::analytic::{Resonance, resonance_limit};
use super::asked::WindowAsked;
use super::chart::Source;
use campaign::plan::Sweep;
use campaign::quantities::{Axis, LENGTH, WallQuantity};
use limits::swing_frequencies;

/// Weights on bit between the ends of the map at which swings are looked for.
const WEIGHTS: usize = 5;

/// The swings of a string that lies, over the weights and speeds of a map.
pub struct Swings<'a> {
    sweep: &'a Sweep,
    asked: &'a WindowAsked,
    /// rpm.
    speeds: [f64; 2],
    /// From the least to the greatest frequency of each swing, Hz, from the slowest on.
    frequencies: Vec<[f64; 2]>,
    /// Whether some weight or friction of the map has no steady state that is found.
    is_incomplete: bool,
}

impl<'a> Swings<'a> {
    /// The swings within ranges of weight on bit (kN) and surface speed (rpm), for all friction of the design.
    pub fn new(sweep: &'a Sweep, [weights, speeds]: [[f64; 2]; 2], asked: &'a WindowAsked) -> Self {
        let most = asked.orders.iter().copied().fold(0.0, f64::max);
        let highest = most * speeds[1] / (1.0 - asked.margin) * TAU / 60.0;
        let axes = sweep.design.axes().iter().copied();
        let frictions = axes.filter(|axis| {
            let of_site = WallQuantity::Friction;
            matches!(axis, Axis::WallAtSite { quantity, .. } if *quantity == of_site)
                || *axis == Axis::FRICTION
        });
        let frictions: Vec<(Axis, [f64; 2])> = frictions
            .filter_map(|axis| Some((axis, sweep.design.ends(axis)?)))
            .collect();
        let sides: &[usize] = if frictions.is_empty() { &[0] } else { &[0, 1] };
        let (mut frequencies, mut is_incomplete) = (Vec::<[f64; 2]>::new(), false);
        for step in 0..WEIGHTS {
            let part = step as f64 / (WEIGHTS - 1) as f64;
            let weight = weights[0] + part * (weights[1] - weights[0]);
            for &side in sides {
                let frictions = frictions.iter().map(|(axis, ends)| (*axis, ends[side]));
                let values: Vec<(Axis, f64)> =
                    frictions.chain([(Axis::WeightOnBitKn, weight)]).collect();
                let Some(found) = swing_frequencies(sweep, &values, highest) else {
                    is_incomplete = true;
                    continue;
                };
                for (place, frequency) in found.iter().map(|omega| omega / TAU).enumerate() {
                    match frequencies.get_mut(place) {
                        None => frequencies.push([frequency; 2]),
                        Some([least, most]) => {
                            (*least, *most) = (least.min(frequency), most.max(frequency));
                        }
                    }
                }
            }
        }
        Self {
            sweep,
            asked,
            speeds,
            frequencies,
            is_incomplete,
        }
    }

    /// Where a multiple of the speed equals a swing frequency.
    pub fn limits(&self) -> Vec<Source<'static>> {
        let WindowAsked { orders, margin, .. } = self.asked;
        let of_order = |&order: &f64| {
            let all = self.frequencies.iter();
            let all = all.map(|frequencies| Resonance::new(order, *frequencies, *margin));
            let [slowest, fastest] = self.speeds;
            let all = all.filter(|it| it.range[1] > slowest && it.range[0] < fastest);
            let about = "small swings about steady sliding";
            resonance_limit("swing resonance", order, (all.collect(), *margin), about)
        };
        orders.iter().map(of_order).collect()
    }

    /// What has no limit on the chart.
    pub fn not_examined(&self) -> Vec<String> {
        let setting = &self.sweep.setting;
        let unit = self.sweep.content.units.of(&LENGTH);
        let highest = setting.sites.distances_from_bit().iter().copied();
        let highest = highest.fold(0.0, f64::max);
        let above = setting.string.length() - highest;
        let above = (above > 0.0).then(|| {
            let [above, place] = [above, highest].map(|it| unit.text(it, 1));
            format!(
                "motion sideways of the {above} of string above {place} from the bit, its uppermost site: \
                 it is taken to lie still"
            )
        });
        let swings = self.is_incomplete.then(|| {
            "swing resonances under some weights on bit: no steady sliding is found there"
                .to_owned()
        });
        above.into_iter().chain(swings).collect()
    }
}
