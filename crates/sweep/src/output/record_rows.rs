//! Reads `labels.csv` as the sweep wrote it: the full records that a run with more cases starts
//! from.

use std::str::{FromStr, Split};

use sim::{
    Ended, Label, LateralMeasures, LateralRegime, Outcome, StringTorque, SurfaceMeasures,
    TorsionMeasures, TorsionRegime,
};

use campaign::engine::{ByStart, Failure, Found, LateralVerdict, Record, Verdict};
use campaign::labels::Certainty;
use campaign::labels::{LATERAL_COLUMNS, LabelTable, TORSION_COLUMNS, to_kn, to_mm, to_turns};
use campaign::plan::{Sweep, to_rpm};

/// The record that a row of a sweep's table was written from; `reason` says why a case
/// has no answer by a method. None where it is not a row as the sweep writes it.
pub fn record_of(
    sweep: &Sweep,
    table: &LabelTable,
    row: &str,
    reason: impl Fn(usize, &str) -> Option<String>,
) -> Option<Record> {
    let mut fields = Fields(row.split(','));
    let case = fields
        .number()
        .filter(|case| *case < sweep.design.cases())?;
    let name = fields.word()?;
    let method = table.methods.iter().position(|method| *method == name)?;
    let values = sweep.design.values(case);
    values.iter().try_for_each(|_| fields.word().map(drop))?;
    let mut record = Record::failed(case, method, values, Failure::new(""));
    if table.shows_torque {
        record.torque_dynamic_nm = fields.optional()?;
    }
    record.outcome = match reason(case, name) {
        Some(reason) => Err(Failure::new(reason)),
        None => {
            let mut outcome = fields.outcome(sweep, &mut record)?;
            if table.shows_surface {
                outcome.surface = Some(fields.surface()?);
            }
            if table.shows_string_torque {
                outcome.string_torque = Some(fields.string_torque()?);
            }
            for _ in &table.misfits {
                record.misfits.push(fields.optional()?);
            }
            Ok(outcome)
        }
    };
    let mut certainty = Certainty::default();
    if table.certifying.is_some() && record.outcome.is_ok() {
        record.finer = fields.finer()?;
        certainty.torsion = fields.optional()?;
        certainty.lateral = fields.optional()?;
        record.agrees_nearby = fields.optional()?;
    }
    if table.shows_starts && record.outcome.is_ok() {
        record.by_start = fields.by_start()?;
    }
    if table.shows_found {
        record.found = found_of(row)?;
    }
    // What is left out above, such as the values, is compared here.
    (table.row(&record, certainty) == row).then_some(record)
}

/// The sites that were found, the last of a row, also of a case without an answer; none where none
/// were looked for.
fn found_of(row: &str) -> Option<Option<Found>> {
    let mut last = row.rsplit(',');
    let (rounds, sites) = (last.next()?, last.next()?);
    if rounds.is_empty() {
        return Some(None);
    }
    let sites = sites.split(';').filter(|site| !site.is_empty());
    Some(Some(Found {
        sites: sites.map(|site| site.parse().ok()).collect::<Option<_>>()?,
        rounds: rounds.parse().ok()?,
    }))
}

/// The fields of a row, in their order.
struct Fields<'a>(Split<'a, char>);

impl<'a> Fields<'a> {
    fn word(&mut self) -> Option<&'a str> {
        self.0.next()
    }

    fn number<Number: FromStr>(&mut self) -> Option<Number> {
        self.word()?.parse().ok()
    }

    fn optional<Field: FromStr>(&mut self) -> Option<Option<Field>> {
        match self.word()? {
            "" => Some(None),
            word => word.parse().ok().map(Some),
        }
    }

    /// A number that was written in a `unit`: the nearest of those that are written so.
    /// Rounding there and back moves it by a few of its last bits at most.
    fn of_unit(&mut self, unit: fn(f64) -> f64) -> Option<f64> {
        const STEPS: i64 = 8;
        let written: f64 = self.number()?;
        let near = (written / unit(1.0)).to_bits();
        (0..=STEPS)
            .flat_map(|step| [step, -step])
            .map(|step| f64::from_bits(near.wrapping_add_signed(step)))
            .find(|&number| unit(number) == written)
    }

    fn optional_of_unit(&mut self, unit: fn(f64) -> f64) -> Option<Option<f64>> {
        let mut ahead = self.0.clone();
        if ahead.next()?.is_empty() {
            self.0 = ahead;
            return Some(None);
        }
        self.of_unit(unit).map(Some)
    }

    fn outcome(&mut self, sweep: &Sweep, record: &mut Record) -> Option<Outcome> {
        let (torsion, lateral) = (self.word()?, self.word()?);
        let torsion = self.torsion(torsion)?;
        record.above_limit = self.optional_of_unit(to_rpm)?;
        Some(Outcome {
            torsion,
            lateral: self.lateral(lateral, sweep, record)?,
            predicted: match self.word()? {
                "" => None,
                word => Some(Label::of_name(word)?),
            },
            simulated: self.number()?,
            ended: {
                let ended = Ended::of_name(self.word()?)?;
                // Its status, which the reasons of failures say.
                self.word()?;
                ended
            },
            surface: None,
            string_torque: None,
        })
    }

    /// None where that has no answer.
    fn finer(&mut self) -> Option<Option<Verdict>> {
        let (torsion, lateral) = (self.word()?, self.word()?);
        let above_limit = self.optional_of_unit(to_rpm)?;
        let lateral = match lateral {
            "" => {
                self.0.nth(1)?;
                None
            }
            regime => Some(LateralVerdict {
                regime: LateralRegime::of_name(regime)?,
                contact_fraction: self.number()?,
                precession_rate: self.of_unit(to_turns)?,
            }),
        };
        let torsion = match torsion {
            "" => None,
            regime => Some(TorsionRegime::of_name(regime)?),
        };
        let verdict = Verdict {
            torsion,
            above_limit,
            lateral,
        };
        Some((verdict != Verdict::default()).then_some(verdict))
    }

    /// None where the bit has no regime.
    fn by_start(&mut self) -> Option<Option<ByStart>> {
        let [stuck, smooth] = [self.word()?, self.word()?];
        if stuck.is_empty() && smooth.is_empty() {
            return Some(None);
        }
        Some(Some(ByStart {
            stuck: TorsionRegime::of_name(stuck)?,
            smooth: TorsionRegime::of_name(smooth)?,
        }))
    }

    fn surface(&mut self) -> Option<SurfaceMeasures> {
        Some(SurfaceMeasures {
            peak_torque: self.number()?,
            least_torque: self.number()?,
            mean_torque: self.number()?,
            greatest_torque: self.number()?,
        })
    }

    fn string_torque(&mut self) -> Option<StringTorque> {
        Some(StringTorque {
            peak_torque: self.number()?,
            from_bit: self.number()?,
        })
    }

    fn torsion(&mut self, regime: &str) -> Option<Option<TorsionMeasures>> {
        if regime.is_empty() {
            return self.0.nth(TORSION_COLUMNS - 1).map(|_| None);
        }
        Some(Some(TorsionMeasures {
            regime: TorsionRegime::of_name(regime)?,
            first_slip: self.optional()?,
            period: self.optional()?,
            slip_time: self.optional()?,
            sticks: self.number()?,
            peak_speed: self.of_unit(to_rpm)?,
            closing_speed: self.of_unit(to_rpm)?,
            severity: self.optional()?,
        }))
    }

    fn lateral(
        &mut self,
        regime: &str,
        sweep: &Sweep,
        record: &mut Record,
    ) -> Option<Option<LateralMeasures>> {
        if regime.is_empty() {
            return self.0.nth(LATERAL_COLUMNS - 1).map(|_| None);
        }
        let distance = self.number()?;
        record.site_from_bit_m = Some(distance);
        let setting = sweep.setting_at(&record.values).ok()?;
        let sites = setting.sites.distances_from_bit();
        Some(Some(LateralMeasures {
            regime: LateralRegime::of_name(regime)?,
            site: sites.iter().position(|site| *site == distance)?,
            first_contact: self.optional()?,
            peak_radius: self.of_unit(to_mm)?,
            mean_radius: self.of_unit(to_mm)?,
            contact_fraction: self.number()?,
            rolling_fraction: self.number()?,
            precession_rate: self.of_unit(to_turns)?,
            mean_normal_force: self.of_unit(to_kn)?,
            ambiguous_steps: self.number()?,
        }))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_number_in_another_unit_is_read_back_to_be_written_the_same(
            number in prop_oneof![
                Just(0.0),
                -1e9..1e9,
                prop::num::f64::NORMAL.prop_filter("in range", |it| it.abs() < 1e300),
            ]
        ) {
            for unit in [to_rpm, to_mm, to_turns, to_kn] {
                let text = unit(number).to_string();
                let found = Fields(text.split(',')).of_unit(unit);
                prop_assert_eq!(found.map(|found| unit(found).to_string()), Some(text));
            }
        }
    }
}
