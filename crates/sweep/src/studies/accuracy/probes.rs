//! A few of the sweep's own cases, simulated to compare methods, and the limits near
//! them.

use anyhow::{Result, anyhow, bail};
use rayon::prelude::*;
use sim::Stopping;

use super::answer::{Answer, is_inside, measures, regimes};
use super::strings::{Strings, Systems};
use crate::engine::MethodSystem;
use crate::memory::Limit;
use crate::plan::{Conditions, Sweep};
use crate::studies::limit::{bisected, geometric};
use crate::studies::trial;

/// Cases compared, evenly spread over the design.
const MOST_PROBES: usize = 8;

/// A limit is looked for up to this many doublings from a case, or halvings.
const DOUBLINGS: i32 = 3;

/// A limit is found to this part of the accuracy.
const LIMIT_PART: f64 = 1.0 / 16.0;

/// A limit is looked for within this factor of a known one.
const NEAR: f64 = 1.2;

/// Islands are looked for within this factor of a limit, beyond what was asked for, and so
/// many steps are taken to there on either side, the closer the nearer.
const FURTHEST: f64 = 1.3;
const PLACES: usize = 16;

/// A case, its string among those of the probes, and where nothing but the bit acts, its
/// scale: all is proportional to the torque there.
struct Probe {
    case: usize,
    string: usize,
    scale: Option<Scale>,
}

/// What a limit of stick-slip hangs on beside the string.
#[derive(Clone, Copy)]
struct Scale {
    /// T_s/T_d.
    static_ratio: f64,
    /// Surface speed per dynamic torque, rad/s per N m.
    speed: f64,
}

/// The cases compared.
pub struct Probes<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Their strings.
    pub strings: Strings<'a>,
    probes: Vec<Probe>,
    asked: f64,
}

impl<'a> Probes<'a> {
    /// Chooses the probes of a sweep that asks for an accuracy.
    ///
    /// # Errors
    /// Where none of them can be.
    pub fn of(sweep: &'a Sweep, asked: f64, limit: &Limit) -> Result<Self> {
        let mut found = Self {
            sweep,
            strings: Strings::new(sweep, limit),
            probes: Vec::new(),
            asked,
        };
        let cases = sweep.design.cases();
        let count = cases.min(MOST_PROBES);
        let mut reason = anyhow!("there is nothing to compare");
        for case in (0..count).map(|index| (2 * index + 1) * cases / (2 * count)) {
            // A string that cannot be has cases that fail, and nothing to compare.
            match found.longest_of(case) {
                Ok(longest) => {
                    let string = found.strings.place_of(case, longest);
                    let scale = found.scale_of(case)?;
                    found.probes.push(Probe {
                        case,
                        string,
                        scale,
                    });
                }
                Err(why) => reason = why,
            }
        }
        if found.probes.is_empty() {
            return Err(reason);
        }
        Ok(found)
    }

    /// Numbers of the cases.
    pub fn cases(&self) -> Vec<usize> {
        self.probes.iter().map(|probe| probe.case).collect()
    }

    fn longest_of(&self, case: usize) -> Result<f64> {
        let values = self.sweep.design.values(case);
        let setting = self.sweep.setting_at(&values)?;
        let mut longest = 0.0f64;
        for exponent in [-DOUBLINGS, 0, DOUBLINGS] {
            let conditions = self.conditions(case, 2f64.powi(exponent));
            let case = trial::case(self.sweep, &setting, &conditions)?;
            longest = longest.max(case.scene.timing.duration);
        }
        Ok(longest)
    }

    fn scale_of(&self, case: usize) -> Result<Option<Scale>> {
        let setting = self.sweep.setting_at(&self.sweep.design.values(case))?;
        let scene = trial::case(self.sweep, &setting, &self.conditions(case, 1.0))?.scene;
        let alone = scene.bit.filter(|_| scene.lateral.is_none());
        Ok(alone.map(|bit| Scale {
            static_ratio: bit.torque_static / bit.torque_dynamic,
            speed: scene.surface_speed / bit.torque_dynamic,
        }))
    }

    /// The probe whose limit is that of another, with the factor between the two: itself,
    /// unless an earlier one has the same string and ratio of torques.
    fn leader_of(&self, index: usize) -> (usize, f64) {
        let own = &self.probes[index];
        let leads = |other: &Probe| {
            let (own_scale, other_scale) = (own.scale?, other.scale?);
            let ratio = other_scale.static_ratio / own_scale.static_ratio;
            let is_same = other.string == own.string && (ratio - 1.0).abs() < 1e-12;
            is_same.then_some(other_scale.speed / own_scale.speed)
        };
        let mut earlier = self.probes[..index].iter().enumerate();
        let found = earlier.find_map(|(other, probe)| Some((other, leads(probe)?)));
        found.unwrap_or((index, 1.0))
    }

    /// The conditions of a case with its surface speed, or its friction where there is a
    /// wall, multiplied.
    fn conditions(&self, case: usize, factor: f64) -> Conditions {
        let mut conditions = self.sweep.conditions_at(&self.sweep.design.values(case));
        if self.sweep.setting.lateral.is_some() {
            conditions.friction_factor = Some(factor);
        } else if let Some(speed) = &mut conditions.surface_speed_rpm {
            *speed *= factor;
        }
        conditions
    }

    /// The answers to all probes, their limits looked for near those of `known`
    /// answers.
    pub fn answers(&self, systems: &Systems, stopping: Stopping, known: &[Answer]) -> Vec<Answer> {
        let mut answers: Vec<Answer> = (self.probes.par_iter().enumerate())
            .map(|(index, probe)| {
                let near = known.get(index).and_then(|known| known.limit);
                let leads = self.leader_of(index).0 == index;
                self.answer(
                    &systems[probe.string],
                    probe.case,
                    stopping,
                    leads.then_some(near),
                )
            })
            .collect();
        for index in 0..answers.len() {
            let (leader, factor) = self.leader_of(index);
            answers[index].limit = answers[leader].limit.map(|limit| limit * factor);
        }
        answers
    }

    /// The answer to one, with its limit where it is to be looked for: near that, or
    /// anywhere.
    fn answer(
        &self,
        system: &MethodSystem,
        case: usize,
        stopping: Stopping,
        limit: Option<Option<f64>>,
    ) -> Answer {
        let mut found = Answer {
            case,
            ..Answer::default()
        };
        match trial::outcome(self.sweep, system, &self.conditions(case, 1.0), stopping) {
            Ok(outcome) => {
                found.regimes = regimes(&outcome);
                found.measures = measures(&outcome, system.setting.sites.len());
                let inside = is_inside(&outcome);
                found.limit = limit.and_then(|near| self.limit(system, case, inside, near));
            }
            Err(reason) => found.regimes = format!("without an answer ({reason})"),
        }
        let least = (system.least_impulses.iter()).filter(|least| least.is_finite());
        let least = least.map(|&least| ("least impulse", least));
        found.measures.extend(least);
        found
    }

    /// Where the regime changes, in multiples of a case's speed or friction: near a
    /// known limit, or else nearest to the case.
    fn limit(
        &self,
        system: &MethodSystem,
        case: usize,
        inside: bool,
        near: Option<f64>,
    ) -> Option<f64> {
        let is_inside_at = |factor: f64| {
            let conditions = self.conditions(case, factor);
            let outcome = trial::outcome(self.sweep, system, &conditions, Stopping::Early);
            outcome.ok().map(|outcome| is_inside(&outcome))
        };
        let around = near.map(|limit| [limit / NEAR, limit * NEAR]);
        let outwards = (1..=DOUBLINGS).flat_map(|exponent| [exponent, -exponent]);
        let octaves = outwards.map(|exponent| {
            let inner = exponent - exponent.signum();
            [2f64.powi(inner), 2f64.powi(exponent)]
        });
        for [from, to] in around.into_iter().chain(octaves) {
            // Inside an octave looked through already nothing has changed.
            let inside = match near {
                Some(_) => is_inside_at(from)?,
                None => inside,
            };
            if is_inside_at(to)? != inside {
                let width = (to / from).ln().abs();
                let halvings = (width / (LIMIT_PART * self.asked)).log2().ceil() as usize;
                return bisected([from, to], inside, halvings, geometric, is_inside_at);
            }
        }
        None
    }

    /// Refuses answers whose limits have islands of the other regime near: those are limits
    /// too, and none that would hold still.
    ///
    /// # Errors
    /// Names the first case with one.
    pub fn check_for_islands(&self, systems: &Systems, answers: &[Answer]) -> Result<()> {
        let leaders = (0..self.probes.len()).filter(|&index| self.leader_of(index).0 == index);
        let leaders: Vec<usize> = leaders.collect();
        let probes = leaders
            .par_iter()
            .map(|&index| (&self.probes[index], &answers[index]));
        let found: Vec<Result<()>> = probes
            .map(|(probe, answer)| {
                let Some(limit) = answer.limit else {
                    return Ok(());
                };
                let is_inside_at = |factor: f64| {
                    let conditions = self.conditions(probe.case, limit * factor);
                    let system = &systems[probe.string];
                    let outcome = trial::outcome(self.sweep, system, &conditions, Stopping::Early);
                    outcome.ok().map(|outcome| is_inside(&outcome))
                };
                let reach = FURTHEST.ln();
                for side in [-1.0, 1.0] {
                    let between = (0..=PLACES).map(|place| place as f64 / PLACES as f64);
                    let places = between.map(|part| self.asked * (reach / self.asked).powf(part));
                    let mut regimes = places.map(|distance| {
                        let factor = (side * distance).exp();
                        (factor, is_inside_at(factor))
                    });
                    let Some((_, near)) = regimes.next() else {
                        continue;
                    };
                    if let Some((factor, _)) = regimes.find(|(_, regime)| *regime != near) {
                        let case = probe.case;
                        bail!(
                            "the limit near case {case} is ragged: at {factor:.2} times it there \
                             is another"
                        );
                    }
                }
                Ok(())
            })
            .collect();
        found.into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use linear::Method;

    use super::super::strings::Steps;
    use super::*;
    use crate::memory::Size;

    const SWEEP: &str = "
accuracy = \"2 %\"

[bit]
torque_static_ratio = 1.3

[design]
kind = \"grid\"

[design.axes]
surface_speed_rpm = { values = [1, 2.5] }
torque_dynamic_nm = { values = [3000, 5000] }

[string]
shear_modulus_gpa = 80
density_kg_m3 = 7840
torsional_damping_nms_rad_m = 5

[[string.sections]]
repeat = 1
parts = [
    { length_m = 700, inner_radius_m = 0.05, outer_radius_m = 0.1 },
    { length_m = 80, inner_radius_m = 0.04, outer_radius_m = 0.15 },
]
";

    /// In torsion all is proportional to torque: a limit that is known by one case is that of
    /// the others, as if it had been looked for there.
    #[test]
    fn a_limit_is_known_by_that_of_another_torque() {
        let name = Path::new("small.toml");
        let sweep = Sweep::read_from(name, &[], &|_: &Path, _| Ok(SWEEP.to_owned())).unwrap();
        let limit = Limit::of(Some(Size(1e9)));
        let probes = Probes::of(&sweep, 0.02, &limit).unwrap();
        let systems = probes
            .strings
            .systems(Method::Held, Steps::Frequency(200.0))
            .unwrap();
        let answers = probes.answers(&systems, Stopping::Early, &[]);
        assert_eq!(answers.len(), 4);
        for (answer, probe) in answers.iter().zip(&probes.probes) {
            let own = probes.answer(&systems[0], probe.case, Stopping::Early, Some(None));
            let ratio = answer.limit.unwrap() / own.limit.unwrap();
            assert!((ratio - 1.0).abs() < 2.0 * LIMIT_PART * 0.02, "{ratio}");
        }
    }
}
