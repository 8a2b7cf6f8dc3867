//! `[bit]`: the torque law and the rock, their numbers checked.

use sim::laws::rock::{CuttingLaw, PoorCleaning, RockError};
use sim::{BitTorque, Rock};
use thiserror::Error;

use super::conditions::Conditions;
use crate::design::Design;
use crate::quantities::RPM;
use crate::quantities::{Axis, RockConstant};
use crate::sweep_file::{BitTable, LawTable, RockName, Source, SweepFileError};

/// The bit's torque law, but for the quantities that axes may change.
#[derive(Debug, Clone, PartialEq)]
pub struct Bit {
    /// From weight on bit to T_d.
    pub rock: Option<Rock>,
}

/// A weight on bit beyond that of any well, kN.
const MOST_WEIGHT_KN: f64 = 2e3;

/// Why a rock gives no torque for a weight on bit.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TorqueError {
    /// It does not reach so far.
    #[error("{}", in_kilonewtons(.0))]
    Rock(RockError),
    /// Its constants do not go together.
    #[error("poor cleaning begins in phase II, above {end} kN here, not at {from} kN")]
    Cleaning {
        /// Where poor cleaning is said to begin, kN.
        from: f64,
        /// Where phase I ends, kN.
        end: f64,
    },
}

/// With weights in the unit in which the user gives them.
fn in_kilonewtons(error: &RockError) -> String {
    let RockError::OutsideTable {
        value, from, to, ..
    } = error
    else {
        return error.to_string();
    };
    let [weight, from, to] = [value, from, to].map(|newtons| newtons / 1e3);
    format!(
        "{weight} kN is outside the rock's table, {from} to {to} kN; \
         it must reach as far as the weights"
    )
}

impl Bit {
    /// The law of the rock under the given conditions, where it has one.
    ///
    /// # Errors
    /// Where its constants do not go together.
    pub fn cutting_law(&self, conditions: &Conditions) -> Result<Option<CuttingLaw>, TorqueError> {
        match (conditions.law, &self.rock) {
            (Some(table), _) => consistent(&table).map(Some),
            (None, Some(Rock::Law(law))) => Ok(Some(*law)),
            _ => Ok(None),
        }
    }

    /// The least and the greatest weight on bit (kN) that its rock has a torque for, where it has a rock.
    pub fn weights_kn(&self) -> Option<[f64; 2]> {
        match self.rock.as_ref()? {
            Rock::Table(rows) => {
                let [first, .., last] = &rows[..] else {
                    return None;
                };
                Some([first, last].map(|row| 1e-3 * row.0))
            }
            _ => Some([0.0, MOST_WEIGHT_KN]),
        }
    }

    /// T_d (N m) under the given conditions, where they say enough.
    ///
    /// # Errors
    /// Where the rock gives none for the weight on bit.
    pub fn torque_dynamic(&self, conditions: &Conditions) -> Result<Option<f64>, TorqueError> {
        if let Some(torque) = conditions.torque_dynamic_nm {
            return Ok(Some(torque));
        }
        let Some((weight, rock)) = conditions.weight_on_bit_kn.zip(self.rock.as_ref()) else {
            return Ok(None);
        };
        let own = conditions.law.map(|table| consistent(&table)).transpose()?;
        let torque = match own {
            Some(law) => Rock::Law(law).torque_dynamic(1e3 * weight),
            None => rock.torque_dynamic(1e3 * weight),
        };
        torque.map(Some).map_err(TorqueError::Rock)
    }
}

/// A bit and all conditions under which it turns.
#[derive(Clone, Copy)]
pub(super) struct Cut<'a> {
    pub bit: &'a Bit,
    pub conditions: &'a Conditions,
    pub design: &'a Design,
}

impl Cut<'_> {
    /// By how much the torque falls at most with speed about the steady rotation of any case,
    /// N m s/rad.
    pub fn steepest_fall(&self) -> f64 {
        let never = self.conditions.torque_decay_rpm.unwrap_or_default() == 0.0;
        if never && !self.design.axes().contains(&Axis::TorqueDecay) {
            return 0.0;
        }
        let cases = (0..self.design.cases()).filter_map(|case| self.fall_of(case));
        cases.fold(0.0, f64::max)
    }

    /// The greatest surface speed of any case, rad/s.
    pub fn fastest_surface(&self) -> f64 {
        let cases = (0..self.design.cases()).filter_map(|case| {
            let values = self.design.values(case);
            let conditions = self.conditions.along(self.design.axes(), &values);
            conditions.surface_speed()
        });
        cases.fold(0.0, f64::max)
    }

    /// That of a case; none where the rock gives no torque.
    fn fall_of(&self, case: usize) -> Option<f64> {
        let values = self.design.values(case);
        let conditions = self.conditions.along(self.design.axes(), &values);
        let torque = self.bit.torque_dynamic(&conditions).ok()??;
        Some(
            conditions
                .torques(torque)
                .fall_at(conditions.surface_speed()?),
        )
    }
}

impl Conditions {
    /// The law of the bit for a dynamic torque, N m.
    pub fn torques(&self, torque_dynamic: f64) -> BitTorque {
        BitTorque {
            torque_static: self.torque_static_ratio.unwrap_or(1.0) * torque_dynamic,
            torque_dynamic,
            decay_speed: RPM * self.torque_decay_rpm.unwrap_or(0.0),
        }
    }
}

/// The torque law of `[bit]`.
///
/// # Errors
/// Where a key of it is refused.
pub fn resolve(source: &Source, bit: &BitTable) -> Result<Bit, SweepFileError> {
    let rock = match (bit.rock, bit.law, &bit.table_kn_nm) {
        (None, None, None) => None,
        (Some(RockName::Sandstone), None, None) => Some(Rock::sandstone()),
        (Some(RockName::Shale), None, None) => Some(Rock::shale()),
        (Some(RockName::Law), Some(law), None) => Some(Rock::Law(self::law(source, &law)?)),
        (Some(RockName::Table), None, Some(rows)) => Some(table(source, rows)?),
        (Some(RockName::Law), None, _) => {
            return Err(source.error("bit.rock", "needs a table [bit.law]"));
        }
        (Some(RockName::Table), _, None) => {
            return Err(source.error("bit.rock", "needs rows `table_kn_nm`"));
        }
        _ => {
            let message = "a rock is one of a built-in name, `law` with [bit.law], \
                           or `table` with `table_kn_nm`";
            return Err(source.error("bit.rock", message));
        }
    };
    Ok(Bit { rock })
}

/// The law of a rock, each of its constants checked.
fn law(source: &Source, table: &LawTable) -> Result<CuttingLaw, SweepFileError> {
    for constant in RockConstant::ALL {
        if let Some(&mut value) = table.clone().constant(constant) {
            let axis = Axis::Rock(constant);
            let key = axis.name().replacen("rock_", "bit.law.", 1);
            source.check_axis(&key, axis, value)?;
        }
    }
    let has_half = table.poor_cleaning_from_kn.is_some() != table.poor_cleaning_nm_per_kn.is_some();
    let message = "poor cleaning needs both `poor_cleaning_from_kn` and `poor_cleaning_nm_per_kn`";
    source.refuse_if(has_half, "bit.law", message)?;
    source.checked("bit.law.poor_cleaning_from_kn", consistent(table))
}

/// The law of a rock whose constants are each in their range, if they go together.
fn consistent(table: &LawTable) -> Result<CuttingLaw, TorqueError> {
    let cleaning = table
        .poor_cleaning_from_kn
        .zip(table.poor_cleaning_nm_per_kn);
    let law = CuttingLaw {
        bit_radius: table.bit_radius_m,
        specific_energy: 1e6 * table.specific_energy_mpa,
        cutting_ratio: table.cutting_ratio,
        friction: table.friction,
        contact_strength: 1e6 * table.contact_strength_mpa,
        contact_growth: table.contact_growth,
        wear_flat: 1e-3 * table.wear_flat_mm,
        poor_cleaning: None,
    };
    let Some((from, slope)) = cleaning else {
        return Ok(law);
    };
    let end = 1e-3 * law.end_of_phase_one().0;
    if from <= end {
        return Err(TorqueError::Cleaning { from, end });
    }
    Ok(CuttingLaw {
        poor_cleaning: Some(PoorCleaning {
            weight_on_bit: 1e3 * from,
            slope: 1e-3 * slope,
        }),
        ..law
    })
}

fn table(source: &Source, rows: &[(f64, f64)]) -> Result<Rock, SweepFileError> {
    for (index, &(weight, torque)) in rows.iter().enumerate() {
        let key = format!("bit.table_kn_nm[{index}]");
        source.check_axis(&key, Axis::WeightOnBitKn, weight)?;
        source.check_axis(&key, Axis::TorqueDynamicNm, torque)?;
    }
    let increasing = rows
        .windows(2)
        .all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1);
    let message = "needs two rows or more of weight on bit (kN) and torque (N m), \
                   both increasing";
    source.refuse_if(rows.len() < 2 || !increasing, "bit.table_kn_nm", message)?;
    let in_newtons = rows.iter().map(|&(weight, torque)| (1e3 * weight, torque));
    Ok(Rock::Table(in_newtons.collect()))
}
