//! `[bit]`: the torque law and the rock, their numbers checked.

use sim::laws::rock::{CuttingLaw, PoorCleaning, RockError};
use sim::{BitTorque, Rock};
use thiserror::Error;

use super::conditions::{Conditions, RPM};
use crate::quantities::Axis;
use crate::sweep_file::{BitTable, LawTable, RockName, Source, SweepFileError};

/// The bit's torque law, but for the quantities that axes may change.
#[derive(Debug, Clone, PartialEq)]
pub struct Bit {
    /// From weight on bit to T_d.
    pub rock: Option<Rock>,
    /// T_s / T_d.
    pub static_ratio: f64,
    /// Speed over which the torque falls from the one to the other, rad/s.
    pub decay_speed: f64,
}

/// Why a rock gives no torque for a weight on bit.
#[derive(Debug, Error)]
#[error("{}", in_kilonewtons(.0))]
pub struct TorqueError(RockError);

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
        let torque = rock.torque_dynamic(1e3 * weight);
        torque.map(Some).map_err(TorqueError)
    }

    /// Both torque limits for a dynamic torque.
    pub fn torques(&self, torque_dynamic: f64) -> BitTorque {
        BitTorque {
            torque_static: self.static_ratio * torque_dynamic,
            torque_dynamic,
            decay_speed: self.decay_speed,
        }
    }
}

/// The torque law of `[bit]`.
///
/// # Errors
/// Where a key of it is refused.
pub fn resolve(source: &Source, bit: &BitTable) -> Result<Bit, SweepFileError> {
    let ratio = bit.torque_static_ratio;
    let static_ratio = source.within("bit.torque_static_ratio", ratio, 1.0, 10.0, "")?;
    let (key, decay) = ("bit.torque_decay_rpm", bit.torque_decay_rpm);
    let decay_speed = RPM * source.within(key, decay, 0.0, 1e4, "rpm")?;
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
    Ok(Bit {
        rock,
        static_ratio,
        decay_speed,
    })
}

fn law(source: &Source, table: &LawTable) -> Result<CuttingLaw, SweepFileError> {
    let within = |key: &str, value: f64, least: f64, most: f64, unit: &'static str| {
        source.within(&format!("bit.law.{key}"), value, least, most, unit)
    };
    let (energy, strength) = (table.specific_energy_mpa, table.contact_strength_mpa);
    let mut law = CuttingLaw {
        bit_radius: within("bit_radius_m", table.bit_radius_m, 1e-3, 2.0, "m")?,
        specific_energy: 1e6 * within("specific_energy_mpa", energy, 0.1, 1e4, "MPa")?,
        cutting_ratio: within("cutting_ratio", table.cutting_ratio, 1e-2, 10.0, "")?,
        friction: within("friction", table.friction, 0.0, 10.0, "")?,
        contact_strength: 1e6 * within("contact_strength_mpa", strength, 0.1, 1e4, "MPa")?,
        contact_growth: within("contact_growth", table.contact_growth, 1e-3, 1e3, "")?,
        wear_flat: 1e-3 * within("wear_flat_mm", table.wear_flat_mm, 1e-3, 1e3, "mm")?,
        poor_cleaning: None,
    };
    let (from, slope) = match (table.poor_cleaning_from_kn, table.poor_cleaning_nm_per_kn) {
        (None, None) => return Ok(law),
        (Some(from), Some(slope)) => (from, slope),
        _ => {
            let message = "poor cleaning needs both `poor_cleaning_from_kn` \
                           and `poor_cleaning_nm_per_kn`";
            return Err(source.error("bit.law", message));
        }
    };
    law.poor_cleaning = Some(PoorCleaning {
        weight_on_bit: 1e3 * within("poor_cleaning_from_kn", from, 1e-3, 1e5, "kN")?,
        slope: 1e-3 * within("poor_cleaning_nm_per_kn", slope, 1e-6, 1e6, "N m/kN")?,
    });
    let end = law.end_of_phase_one().0;
    let message = format!(
        "poor cleaning begins in phase II, above {} kN here",
        1e-3 * end
    );
    source.refuse_if(1e3 * from <= end, "bit.law.poor_cleaning_from_kn", message)?;
    Ok(law)
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
