//! A few of the sweep's own cases, simulated to compare methods, and the limits near
//! them.

mod cutting;
mod islands;

use anyhow::{Result, anyhow};
use linear::parallel;
use sim::Stopping;

use super::answer::{Answer, Quoted, answer_of, is_inside};
use super::bisection::{bisected, geometric};
use super::strings::{Strings, Systems};
use super::trial;
use crate::engine::MethodSystem;
use crate::memory::Limit;
use crate::plan::{Conditions, Sweep};
pub use islands::ISLAND_CASES;

/// Cases compared, evenly spread over the design.
const MOST_PROBES: usize = 8;

/// A limit is looked for up to this many doublings from a case, or halvings.
const DOUBLINGS: i32 = 3;

/// A limit is found to this part of the accuracy.
const LIMIT_PART: f64 = 1.0 / 16.0;

/// A limit is looked for within this factor of a known one.
const NEAR: f64 = 1.2;

/// Cases simulated for one limit before it is halved in on.
pub const HALVINGS_BEFORE: f64 = 2.0;

/// A case, its string among those of the probes, and its scale.
struct Probe {
    case: usize,
    string: usize,
    scale: Scale,
    /// The limit of steady drilling near a case of a bit that cuts, as it is.
    drilling: Option<f64>,
    /// The time of the case, s.
    duration: f64,
}

/// Of what a limit of stick-slip is a multiple. Where nothing but the bit acts, all is
/// proportional to the torque there.
#[derive(Clone, Copy, PartialEq)]
enum Scale {
    /// Surface speed per dynamic torque, rad/s per N m, with T_s/T_d.
    Torque { speed: f64, static_ratio: f64 },
    /// Of nothing that other cases share.
    Own,
}

impl Scale {
    /// The factor from limits of another to its own; `None` where they are not alike.
    fn from(self, other: Self) -> Option<f64> {
        let (
            Scale::Torque {
                speed,
                static_ratio,
            },
            Scale::Torque {
                speed: other_speed,
                static_ratio: other_ratio,
            },
        ) = (self, other)
        else {
            return None;
        };
        let is_alike = (static_ratio / other_ratio - 1.0).abs() < 1e-12;
        is_alike.then_some(other_speed / speed)
    }
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
            // Cases of an invalid string fail, and there is nothing to compare.
            match found.longest_of(case) {
                Ok(longest) => {
                    let string = found.strings.place_of(case, longest);
                    let (scale, duration) = found.scale_of(case)?;
                    found.probes.push(Probe {
                        case,
                        string,
                        scale,
                        drilling: None,
                        duration,
                    });
                }
                Err(why) => reason = why,
            }
        }
        if found.probes.is_empty() {
            return Err(reason);
        }
        let limits = parallel::map(found.probes.len(), 1, |index| {
            found.exact_drilling_limit(&found.probes[index])
        });
        for (probe, limit) in found.probes.iter_mut().zip(limits) {
            probe.drilling = limit;
        }
        Ok(found)
    }

    /// A probe's system among those of all strings.
    pub fn system<'b>(&self, systems: &'b Systems, index: usize) -> &'b MethodSystem {
        &systems[self.probes[index].string]
    }

    /// Number of the case of a probe.
    pub fn case(&self, index: usize) -> usize {
        self.probes[index].case
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

    /// The scale of a case, and its time, s.
    fn scale_of(&self, case: usize) -> Result<(Scale, f64)> {
        let setting = self.sweep.setting_at(&self.sweep.design.values(case))?;
        let scene = trial::case(self.sweep, &setting, &self.conditions(case, 1.0))?.scene;
        let alone = scene.bit.filter(|_| scene.lateral.is_none());
        let scale = alone.map_or(Scale::Own, |bit| Scale::Torque {
            speed: scene.surface_speed / bit.torque_dynamic,
            static_ratio: bit.torque_static / bit.torque_dynamic,
        });
        Ok((scale, scene.timing.duration))
    }

    /// The factor from limits of one probe to those of another; `None` where the two have
    /// nothing to do with one another.
    fn factor(&self, from: usize, to: usize) -> Option<f64> {
        let [from_probe, to_probe] = [from, to].map(|index| &self.probes[index]);
        if from == to {
            return Some(1.0);
        }
        let has_its_string = from_probe.string == to_probe.string;
        (to_probe.scale.from(from_probe.scale)).filter(|_| has_its_string)
    }

    /// The probes that share their limits, each group once.
    pub fn groups(&self) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for index in 0..self.probes.len() {
            let of_group = |group: &&mut Vec<usize>| self.factor(group[0], index).is_some();
            match groups.iter_mut().find(of_group) {
                Some(group) => group.push(index),
                None => groups.push(vec![index]),
            }
        }
        groups
    }

    /// The conditions of a case with its surface speed, or its friction where there is a
    /// wall, multiplied.
    pub fn conditions(&self, case: usize, factor: f64) -> Conditions {
        let mut conditions = self.sweep.conditions_at(&self.sweep.design.values(case));
        if self.sweep.setting.lateral.is_some() {
            conditions.friction_factor = Some(factor);
        } else if let Some(speed) = &mut conditions.surface_speed_rpm {
            *speed *= factor;
        }
        conditions
    }

    /// The answers to all probes, their limits looked for near those of `known` answers:
    /// in each group by the first that finds one. A bit that cuts has a number of `starts`.
    pub fn answers(
        &self,
        systems: &Systems,
        stopping: Stopping,
        known: &[Answer],
        starts: usize,
    ) -> Vec<Answer> {
        if self.cuts() {
            return self.answers_of_cutting(systems, stopping, starts);
        }
        let found: Vec<(Answer, Option<bool>)> = parallel::map(self.probes.len(), 1, |place| {
            let probe = &self.probes[place];
            self.answer(&systems[probe.string], probe.case, stopping)
        });
        let limit_of = |index: usize| {
            let probe = &self.probes[index];
            let near = known.get(index).and_then(|known| known.limit);
            let system = &systems[probe.string];
            let limit = self.regime_limit(system, probe.case, found[index].1?, near)?;
            Some((index, limit))
        };
        let groups = self.groups();
        let limits: Vec<Option<(usize, f64)>> = parallel::map(groups.len(), 1, |group| {
            groups[group].iter().find_map(|&index| limit_of(index))
        });
        let mut answers: Vec<Answer> = found.into_iter().map(|(answer, _)| answer).collect();
        for (group, limit) in groups.into_iter().zip(limits) {
            for index in group {
                let of_it = |(from, limit)| Some(limit * self.factor(from, index)?);
                answers[index].limit = limit.and_then(of_it);
            }
        }
        answers
    }

    /// Halvings by which a limit is found near a known one.
    pub fn halvings(&self) -> usize {
        self.halvings_between(2.0 * NEAR.ln())
    }

    /// Halvings by which a limit is found within a width, in logarithms.
    fn halvings_between(&self, width: f64) -> usize {
        (width / (LIMIT_PART * self.asked)).log2().ceil() as usize
    }

    /// The answer to one but for its limit, and whether it is in the regime that this bounds.
    fn answer(
        &self,
        system: &MethodSystem,
        case: usize,
        stopping: Stopping,
    ) -> (Answer, Option<bool>) {
        let outcome = trial::outcome(self.sweep, system, &self.conditions(case, 1.0), stopping);
        let inside = outcome.as_ref().ok().map(is_inside);
        let mut found = answer_of(case, &[outcome], system.setting.sites.len());
        let least = (system.least_impulses.iter()).filter(|least| least.is_finite());
        let least = least.map(|&least| Quoted::alone(("least impulse", least)));
        found.measures.extend(least);
        (found, inside)
    }

    /// Where the regime of a case changes, in multiples of its speed or friction.
    fn regime_limit(
        &self,
        system: &MethodSystem,
        case: usize,
        inside: bool,
        near: Option<f64>,
    ) -> Option<f64> {
        let is_inside_at = |factor: f64| self.is_inside_at(system, case, factor);
        self.limit(is_inside_at, inside, near)
    }

    /// Whether a case is inside with its speed or friction multiplied.
    fn is_inside_at(&self, system: &MethodSystem, case: usize, factor: f64) -> Option<bool> {
        let conditions = self.conditions(case, factor);
        let outcome = trial::outcome(self.sweep, system, &conditions, Stopping::Early);
        outcome.ok().map(|outcome| is_inside(&outcome))
    }

    /// Where something changes, in multiples of a case's speed or friction: near a
    /// known limit, or else nearest to the case, where it is `inside`.
    fn limit(
        &self,
        is_inside_at: impl Fn(f64) -> Option<bool>,
        inside: bool,
        near: Option<f64>,
    ) -> Option<f64> {
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
                let halvings = self.halvings_between(width);
                return bisected([from, to], inside, halvings, geometric, is_inside_at);
            }
        }
        None
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

    fn sweep() -> Sweep {
        let name = Path::new("small.toml");
        Sweep::read_from(name, &[], &|_: &Path, _| Ok(SWEEP.to_owned())).unwrap()
    }

    /// Labels between the limit and one that is said to be 5 % above it are those of its other side.
    #[test]
    fn labels_beyond_a_limit_are_counted_up_to_the_furthest() {
        let sweep = sweep();
        let limit = Limit::of(Some(Size(1e9)));
        let probes = Probes::of(&sweep, 0.02, &limit).unwrap();
        let systems = probes
            .strings
            .systems(Method::Held, Steps::Frequency(200.0))
            .unwrap();
        let mut answers = probes.answers(&systems, Stopping::Early, &[], 1);
        let right = probes.islands(&systems, &answers).unwrap();
        assert_eq!((right.labels, right.others), (128, 0));
        for answer in &mut answers {
            answer.limit = answer.limit.map(|limit| 1.05 * limit);
        }
        let wrong = probes.islands(&systems, &answers).unwrap();
        // Of the way from 2 to 30 % 20 of 64 places are nearer than 1 − 1/1.05, 4.3 % of it apart.
        assert_eq!((wrong.labels, wrong.others), (128, 20));
        assert!((wrong.furthest - 0.0466).abs() < 1e-3, "{wrong:?}");
        let wide = Probes::of(&sweep, 0.3, &limit).unwrap();
        assert_eq!(wide.islands(&systems, &answers), None);
    }

    /// In torsion all is proportional to torque: a limit that is known by one case is that of
    /// the others, as if it had been looked for there.
    #[test]
    fn a_limit_is_known_by_that_of_another_torque() {
        let sweep = sweep();
        let limit = Limit::of(Some(Size(1e9)));
        let probes = Probes::of(&sweep, 0.02, &limit).unwrap();
        let systems = probes
            .strings
            .systems(Method::Held, Steps::Frequency(200.0))
            .unwrap();
        let answers = probes.answers(&systems, Stopping::Early, &[], 1);
        assert_eq!(answers.len(), 4);
        assert_eq!(probes.groups(), [[0, 1, 2, 3]]);
        for (answer, probe) in answers.iter().zip(&probes.probes) {
            let (_, inside) = probes.answer(&systems[0], probe.case, Stopping::Early);
            let own = probes.regime_limit(&systems[0], probe.case, inside.unwrap(), None);
            let ratio = answer.limit.unwrap() / own.unwrap();
            assert!((ratio - 1.0).abs() < 2.0 * LIMIT_PART * 0.02, "{ratio}");
        }
    }
}
