//! What came out of a sweep, counted.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use sim::Label;

use campaign::quantities::{STRESS, Units, WIDTH};
use campaign::records::{Certainty, WHIRL_AGREES, WallPush};

use campaign::words::counted;
use sim::{Labels, Motion, TorsionRegime};

/// What came out, counted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Rows.
    pub rows: usize,
    /// Rows per method and label. A row of a scene with bit and wall has two labels,
    /// one of each motion.
    pub labels: BTreeMap<String, BTreeMap<Label, usize>>,
    /// Those of them that are certain, where the run certifies labels.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub certified: BTreeMap<String, BTreeMap<Label, usize>>,
    /// Rows, per method, that whirl by all that certify, at rates or with forces that are not alike.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub other_whirl: BTreeMap<String, usize>,
    /// Sites that were found, per method, where they were looked for.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub found_sites: BTreeMap<String, FoundSites>,
    /// Rows on both sides of the one-slip estimate of stick-slip (Eq. 74), per method, where that is
    /// known.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub one_slip_estimate: BTreeMap<String, BeyondEstimate>,
    /// The fastest whirl per method, turns a second, where any whirls.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub fastest_whirl_turns_per_s: BTreeMap<String, f64>,
    /// Rows below a mud motor, per method, and in how many of them it stalls.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub motor: BTreeMap<String, MotorStalls>,
    /// Pushes into walls, per method, where walls give way.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub wall: BTreeMap<String, WallPushes>,
    /// Stresses per method, where they are known.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub stress: BTreeMap<String, Stresses>,
    /// The deepest cut of a blade per method, mm, where a bit cuts.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub deepest_cut_mm: BTreeMap<String, f64>,
    /// Rows without an answer.
    pub failed: usize,
    /// Settled rows that were followed to the end, and those of them whose label
    /// changed.
    pub settled_checked: usize,
    /// See `settled_checked`.
    pub settled_wrong: usize,
    /// Rows whose stick-slip or swing still faded at the end of the time.
    #[serde(default, skip_serializing_if = "is_none")]
    pub fading: usize,
}

fn is_none(count: &usize) -> bool {
    *count == 0
}

/// Pushes into walls by a method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallPushes {
    /// Cases in which a wall gave way.
    pub cases: usize,
    /// Those of them in which its rock would break.
    pub breaking: usize,
    /// The hardest push; the deepest in folders of earlier versions.
    #[serde(alias = "deepest")]
    pub hardest: WallPush,
}

/// Greatest von Mises stresses by a method, against the least yield of drill pipe (API Spec 5DP).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Stresses {
    /// Cases whose stress is known.
    pub cases: usize,
    /// Cases beyond the yield of grade E75.
    pub beyond_e75: usize,
    /// Cases beyond the yield of grade S135, and so of any collar.
    pub beyond_s135: usize,
}

/// Least yield of drill pipe of grades E75 and S135, Pa.
const YIELD: [f64; 2] = [517e6, 931e6];

/// Widths of cutters, mm: the least, and that above which IADC's largest class of fixed cutters is.
const CUTTERS_MM: [f64; 2] = [8.0, 25.4];

/// Stalls of the mud motor by a method.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct MotorStalls {
    /// Cases with an answer.
    pub cases: usize,
    /// Those of them in which the motor stalls in the closing window.
    pub stalled: usize,
    /// Those of these whose bit turns smoothly all the same, with the string.
    pub stalled_and_smooth: usize,
}

/// Sites that were found by a method.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FoundSites {
    /// Cases in which they were looked for.
    pub cases: usize,
    /// Those of them in which sites other than those of the file were found.
    pub cases_with_sites: usize,
    /// The most of a case, those of the file not counted.
    pub most_sites: usize,
    /// How often a case was run again, at most.
    pub most_rounds: usize,
    /// How often cases were run again, all together.
    pub rounds: usize,
}

/// Rows by a method about the one-slip estimate of stick-slip (Eq. 74), which is no limit: both
/// regimes may be on either side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct BeyondEstimate {
    /// Rows that stick and slip, from one start or from any.
    pub stick_slip: usize,
    /// Those of them above the estimate.
    pub stick_slip_above: usize,
    /// Rows that turn smoothly.
    pub smooth: usize,
    /// Those of them below the estimate.
    pub smooth_below: usize,
}

impl Tally {
    /// Counts on which side of the one-slip estimate the surface of a row turns, by the speed above
    /// it, where both that and the label of the bit are known.
    pub fn add_margin(&mut self, method: &str, labels: Labels, margin: Option<f64>) {
        let (Some(margin), Some(sticks)) = (margin, labels.is_sustained(Motion::Torsion)) else {
            return;
        };
        let of_method = self.one_slip_estimate.entry(method.to_owned()).or_default();
        if sticks {
            of_method.stick_slip += 1;
            of_method.stick_slip_above += usize::from(margin >= 0.0);
        } else {
            of_method.smooth += 1;
            of_method.smooth_below += usize::from(margin < 0.0);
        }
    }

    /// How many rows of each method are on the side of the one-slip estimate of stick-slip that it
    /// does not expect, in words.
    pub fn estimate_words(&self) -> impl Iterator<Item = (&str, String)> {
        self.one_slip_estimate.iter().map(|(method, count)| {
            let parts = [
                (
                    count.stick_slip,
                    count.stick_slip_above,
                    "with stick-slip are above",
                ),
                (
                    count.smooth,
                    count.smooth_below,
                    "that turn smoothly are below",
                ),
            ];
            let parts = parts.into_iter().filter(|(all, ..)| *all > 0);
            let parts =
                parts.map(|(all, part, side)| format!("{part} of {} {side}", counted(all, "case")));
            let parts: Vec<String> = parts.collect();
            let words = format!("{} the one-slip estimate (Eq. 74)", parts.join(" and "));
            (method.as_str(), words)
        })
    }

    /// Counts how many sites a case was found to have by a method, and in how many rounds.
    pub fn add_found(&mut self, method: &str, [sites, rounds]: [usize; 2]) {
        let found = self.found_sites.entry(method.to_owned()).or_default();
        found.cases += 1;
        found.cases_with_sites += usize::from(sites > 0);
        found.most_sites = found.most_sites.max(sites);
        found.most_rounds = found.most_rounds.max(rounds);
        found.rounds += rounds;
    }

    /// Takes note of whirl by a method at a rate, turns a second.
    pub fn add_whirl(&mut self, method: &str, rate: f64) {
        let fastest = self.fastest_whirl_turns_per_s.entry(method.to_owned());
        let fastest = fastest.or_insert(0.0);
        *fastest = fastest.max(rate.abs());
    }

    /// Counts what a case is by a method: whether it failed, its labels, the label predicted
    /// when motion settled, and which labels are certain.
    pub fn add(
        &mut self,
        method: &str,
        failed: bool,
        labels: Labels,
        predicted: Option<Label>,
        certainty: Certainty,
    ) {
        self.rows += 1;
        self.failed += usize::from(failed);
        if let Some(predicted) = predicted {
            self.settled_checked += 1;
            self.settled_wrong += usize::from(labels.each().all(|label| label != predicted));
        }
        for label in labels.each() {
            let of_method = self.labels.entry(method.to_owned()).or_default();
            *of_method.entry(label).or_default() += 1;
            if label.motion() == Motion::Lateral && certainty.whirl_agrees == Some(false) {
                *self.other_whirl.entry(method.to_owned()).or_default() += 1;
            }
            if certainty[label.motion()] == Some(true) {
                let of_method = self.certified.entry(method.to_owned()).or_default();
                *of_method.entry(label).or_default() += 1;
            }
        }
    }

    /// Counts whether the mud motor above the bit stalls in a case of these labels by a method; nothing
    /// where there is no motor.
    pub fn add_motor(&mut self, method: &str, stalled: Option<bool>, labels: Labels) {
        let Some(stalled) = stalled else { return };
        let motor = self.motor.entry(method.to_owned()).or_default();
        let is_smooth = labels[Motion::Torsion] == Some(TorsionRegime::Smooth.into());
        motor.cases += 1;
        motor.stalled += usize::from(stalled);
        motor.stalled_and_smooth += usize::from(stalled && is_smooth);
    }

    /// Counts the greatest von Mises stress of a case by a method, Pa.
    pub fn add_stress(&mut self, method: &str, von_mises: f64) {
        let found = self.stress.entry(method.to_owned()).or_default();
        let [e75, s135] = YIELD.map(|least| usize::from(von_mises > least));
        found.cases += 1;
        found.beyond_e75 += e75;
        found.beyond_s135 += s135;
    }

    /// In how many cases steel yields, in a sentence for each method; none where none does.
    fn stress_words(&self, units: Units) -> impl Iterator<Item = String> {
        let yields = self.stress.iter().filter(|(_, found)| found.beyond_e75 > 0);
        let limits = YIELD.map(|least| units.of(&STRESS).text(1e-6 * least, 0));
        yields.map(move |(method, found)| {
            let [e75, s135] = &limits;
            let any = match found.beyond_s135 {
                0 => String::new(),
                count => format!(", in {count} beyond {s135}, that of S135 and of any collar"),
            };
            format!(
                "warning: {method}: in {} of {} stress is beyond {e75}, the yield of drill pipe of grade E75{any}: \
                 the string is no longer elastic there",
                found.beyond_e75,
                counted(found.cases, "case")
            )
        })
    }

    /// Notes the deepest cut of a case by a method, mm.
    pub fn add_cut(&mut self, method: &str, depth_mm: f64) {
        let deepest = self.deepest_cut_mm.entry(method.to_owned()).or_default();
        *deepest = deepest.max(depth_mm);
    }

    /// How wide cutters have to be to cut as deep, in a sentence for each method; none where the narrowest do.
    fn cut_words(&self, units: Units) -> impl Iterator<Item = String> {
        let in_units = move |mm: f64| units.of(&WIDTH).text(mm, 1);
        let [least, largest] = CUTTERS_MM;
        // One that is set in a pocket by half.
        let deep = (self.deepest_cut_mm.iter()).filter(move |(_, depth)| 2.0 * **depth > least);
        deep.map(move |(method, depth)| {
            let depth_words = units.of(&WIDTH).text(*depth, 2);
            let wider = in_units(2.0 * depth);
            match 2.0 * depth > largest {
                true => format!(
                    "warning: {method}: a blade cuts up to {depth_words} deep, beyond any cutter but those of the \
                     largest class (IADC), wider than {}, if by half its width it stands out: the body of a bit \
                     would rub, which is not modelled",
                    in_units(largest)
                ),
                false => format!(
                    "{method}: a blade cuts up to {depth_words} deep: cutters that stand out by half their width \
                     have to be wider than {wider}"
                ),
            }
        })
    }

    /// Notes on all cases together, in a sentence for each method: walls that would break, steel that
    /// yields, cuts that are deep, mud motors that stall, sites that were found.
    pub fn notes(&self, units: Units) -> impl Iterator<Item = String> {
        (self.wall_words(units))
            .chain(self.stress_words(units))
            .chain(self.cut_words(units))
            .chain(self.motor_words())
            .chain(self.found_words())
    }

    /// Counts the hardest push of a case into a wall by a method.
    pub fn add_push(&mut self, method: &str, push: WallPush) {
        let wall = self.wall.entry(method.to_owned()).or_insert(WallPushes {
            cases: 0,
            breaking: 0,
            hardest: push,
        });
        wall.cases += 1;
        wall.breaking += usize::from(push.breaks == Some(true));
        if push.force > wall.hardest.force {
            wall.hardest = push;
        }
    }

    /// In how many cases the rock of a wall would break, or a rigid one is pressed on, in a sentence for
    /// each method; none where it bears all pushes.
    fn wall_words(&self, units: Units) -> impl Iterator<Item = String> {
        self.wall.iter().filter_map(move |(method, found)| {
            let cases = counted(found.cases, "case");
            let hardest = found.hardest.words(units);
            if found.breaking > 0 {
                return Some(format!(
                    "warning: {method}: in {} of {cases} that press on a wall its rock would break, and the \
                     hole is no longer that of the model; the hardest push: {hardest}",
                    found.breaking,
                ));
            }
            (found.hardest.is_on_rigid()).then(|| {
                format!(
                    "{method}: in {cases} a rigid wall is pressed on, hardest {hardest}: what that does to its \
                     rock is not known"
                )
            })
        })
    }

    /// How many rows still faded at the end of their time, in a sentence; none where none did.
    pub fn fading_words(&self) -> Option<String> {
        (self.fading > 0).then(|| {
            format!(
                "in {} of {} stick-slip or a swing still faded at the end of the time, or the bit still changed \
                 its speed below a drive at its limit: a larger `time_s` decides",
                self.fading,
                counted(self.rows, "row")
            )
        })
    }

    /// In how many cases at most the mud motor stalls by any method, in a sentence; none where it does not.
    pub fn motor_sentence(&self) -> Option<String> {
        let most = self.motor.values().max_by_key(|found| found.stalled)?;
        (most.stalled > 0).then(|| {
            format!(
                "The mud motor stalls in {} of {}: there the bit does not drill smoothly, but stands still or turns \
                 with the string.",
                most.stalled,
                counted(most.cases, "case")
            )
        })
    }

    /// In how many cases the mud motor stalls, in a sentence for each method; none without a motor.
    fn motor_words(&self) -> impl Iterator<Item = String> {
        self.motor.iter().map(|(method, found)| {
            let MotorStalls {
                cases,
                stalled,
                stalled_and_smooth,
            } = found;
            let smooth = match stalled_and_smooth {
                0 => String::new(),
                smooth => format!(", {smooth} of them smooth, where the bit turns with the string"),
            };
            let cases = counted(*cases, "case");
            format!("{method}: the mud motor stalls in {stalled} of {cases}{smooth}")
        })
    }

    /// In how many cases sites were found, how many at most and in how many rounds, in a sentence
    /// for each method; none where they were not looked for.
    fn found_words(&self) -> impl Iterator<Item = String> {
        self.found_sites.iter().map(|(method, found)| {
            let cases = counted(found.cases, "case");
            match found.cases_with_sites {
                0 => format!(
                    "{method}: no sites were found other than those of the file, in \
                              {cases}"
                ),
                with => format!(
                    "{method}: sites were found in {with} of {cases}, up to {} in up to {}",
                    counted(found.most_sites, "site"),
                    counted(found.most_rounds, "round"),
                ),
            }
        })
    }

    /// The motions that have labels; that of torsion where no case has any.
    pub fn motions(&self) -> Vec<Motion> {
        let labels = self.labels.values().flat_map(BTreeMap::keys);
        let found: BTreeSet<Motion> = labels.map(|label| label.motion()).collect();
        if found.is_empty() {
            vec![Motion::Torsion]
        } else {
            found.into_iter().collect()
        }
    }

    /// Cases whose label of a motion is certain, with any label: the rows of a method that
    /// certifies them, of which no method has more.
    pub fn certified(&self, motion: Motion) -> usize {
        let of_method = |labels: &BTreeMap<Label, usize>| {
            let of_motion = labels.iter().filter(|(label, _)| label.motion() == motion);
            of_motion.map(|(_, count)| count).sum()
        };
        self.certified.values().map(of_method).max().unwrap_or(0)
    }

    /// In how many cases whirl, that all who certify find, has rates or forces that are not alike, in
    /// a sentence; none where there is no such case.
    pub fn other_whirl_words(&self) -> Option<String> {
        let count = self.other_whirl.values().max()?;
        Some(format!(
            "in {} all four settings whirl, but at rates that differ by over a quarter or with forces that differ by \
             over half: column {WHIRL_AGREES}",
            counted(*count, "case"),
        ))
    }

    /// The labels of a method, each with its rows, in one list for each motion that
    /// has any: every list adds up to the cases with an answer.
    pub fn by_motion(&self, method: &str) -> Vec<(Motion, Vec<(&'static str, usize)>)> {
        let list = |motion: Motion| -> Vec<(&'static str, usize)> {
            let labels = self.labels.get(method).into_iter().flatten();
            labels
                .filter(|(label, _)| label.motion() == motion)
                .map(|(label, count)| (label.name(), *count))
                .collect()
        };
        let lists = Motion::ALL.into_iter().map(|motion| (motion, list(motion)));
        lists.filter(|(_, list)| !list.is_empty()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stress_beyond_yield_is_said_with_the_grade() {
        let mut tally = Tally::default();
        let words = |tally: &Tally| tally.notes(Units::default()).collect::<Vec<String>>();
        tally.add_stress("held", 500e6);
        assert!(words(&tally).is_empty());
        tally.add_stress("held", 600e6);
        assert!(words(&tally)[0].contains("in 1 of 2 cases stress is beyond 517 MPa"));
        assert!(!words(&tally)[0].contains("S135"));
        tally.add_stress("held", 940e6);
        assert!(words(&tally)[0].contains("in 2 of 3 cases"));
        assert!(words(&tally)[0].contains("in 1 beyond 931 MPa, that of S135"));
    }

    #[test]
    fn a_cut_is_held_to_the_width_of_cutters() {
        let mut tally = Tally::default();
        let words = |tally: &Tally| tally.notes(Units::default()).collect::<Vec<String>>();
        tally.add_cut("held", 3.9);
        assert!(words(&tally).is_empty());
        tally.add_cut("held", 5.92);
        tally.add_cut("held", 1.0);
        assert!(words(&tally)[0].ends_with("have to be wider than 11.8 mm"));
        tally.add_cut("held", 13.0);
        assert!(
            words(&tally)[0]
                .starts_with("warning: held: a blade cuts up to 13.00 mm deep, beyond any cutter")
        );
    }
}
