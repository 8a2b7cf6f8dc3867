//! `[bit]`: the torque law and the rock, their numbers checked.

use sim::Rock;
use sim::laws::rock::{CuttingLaw, PoorCleaning};

use super::file::{BitTable, LawTable, RockName};
use super::resolve::{Bit, Check};
use super::source::SweepFileError;
use crate::quantities::Axis;

impl Check<'_> {
    pub(super) fn bit(&self, bit: &BitTable) -> Result<Bit, SweepFileError> {
        self.within(
            "bit.torque_static_ratio",
            bit.torque_static_ratio,
            1.0,
            10.0,
            "",
        )?;
        let rock = match (bit.rock, bit.law, &bit.table_kn_nm) {
            (None, None, None) => None,
            (Some(RockName::Sandstone), None, None) => Some(Rock::sandstone()),
            (Some(RockName::Shale), None, None) => Some(Rock::shale()),
            (Some(RockName::Law), Some(law), None) => Some(Rock::Law(self.law(&law)?)),
            (Some(RockName::Table), None, Some(rows)) => Some(self.table(rows)?),
            (Some(RockName::Law), None, _) => {
                return Err(self.source.error("bit.rock", "needs a table [bit.law]"));
            }
            (Some(RockName::Table), _, None) => {
                return Err(self.source.error("bit.rock", "needs rows `table_kn_nm`"));
            }
            _ => {
                let message = "a rock is one of a built-in name, `law` with [bit.law], \
                               or `table` with `table_kn_nm`";
                return Err(self.source.error("bit.rock", message));
            }
        };
        Ok(Bit {
            rock,
            static_ratio: bit.torque_static_ratio,
        })
    }

    fn law(&self, law: &LawTable) -> Result<CuttingLaw, SweepFileError> {
        let checks = [
            ("bit_radius_m", law.bit_radius_m, 1e-3, 2.0, "m"),
            (
                "specific_energy_mpa",
                law.specific_energy_mpa,
                0.1,
                1e4,
                "MPa",
            ),
            ("cutting_ratio", law.cutting_ratio, 1e-2, 10.0, ""),
            ("friction", law.friction, 0.0, 10.0, ""),
            (
                "contact_strength_mpa",
                law.contact_strength_mpa,
                0.1,
                1e4,
                "MPa",
            ),
            ("contact_growth", law.contact_growth, 1e-3, 1e3, ""),
            ("wear_flat_mm", law.wear_flat_mm, 1e-3, 1e3, "mm"),
        ];
        for (key, value, least, most, unit) in checks {
            self.within(&format!("bit.law.{key}"), value, least, most, unit)?;
        }
        let poor_cleaning = match (law.poor_cleaning_from_kn, law.poor_cleaning_nm_per_kn) {
            (None, None) => None,
            (Some(from), Some(slope)) => {
                self.within("bit.law.poor_cleaning_from_kn", from, 1e-3, 1e5, "kN")?;
                self.within(
                    "bit.law.poor_cleaning_nm_per_kn",
                    slope,
                    1e-6,
                    1e6,
                    "N m/kN",
                )?;
                Some(PoorCleaning {
                    weight_on_bit: 1e3 * from,
                    slope: 1e-3 * slope,
                })
            }
            _ => {
                let message = "poor cleaning needs both `poor_cleaning_from_kn` \
                               and `poor_cleaning_nm_per_kn`";
                return Err(self.source.error("bit.law", message));
            }
        };
        let law = CuttingLaw {
            bit_radius: law.bit_radius_m,
            specific_energy: 1e6 * law.specific_energy_mpa,
            cutting_ratio: law.cutting_ratio,
            friction: law.friction,
            contact_strength: 1e6 * law.contact_strength_mpa,
            contact_growth: law.contact_growth,
            wear_flat: 1e-3 * law.wear_flat_mm,
            poor_cleaning,
        };
        if let Some(poor) = poor_cleaning
            && poor.weight_on_bit <= law.end_of_phase_one().0
        {
            let message = format!(
                "poor cleaning begins in phase II, above {} kN here",
                1e-3 * law.end_of_phase_one().0
            );
            return Err(self.source.error("bit.law.poor_cleaning_from_kn", message));
        }
        Ok(law)
    }

    fn table(&self, rows: &[(f64, f64)]) -> Result<Rock, SweepFileError> {
        for (index, &(weight, torque)) in rows.iter().enumerate() {
            let key = format!("bit.table_kn_nm[{index}]");
            self.source.check_axis(&key, Axis::WeightOnBitKn, weight)?;
            self.source
                .check_axis(&key, Axis::TorqueDynamicNm, torque)?;
        }
        let increasing = rows
            .windows(2)
            .all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1);
        if rows.len() < 2 || !increasing {
            let message = "needs two rows or more of weight on bit (kN) and torque (N m), \
                           both increasing";
            return Err(self.source.error("bit.table_kn_nm", message));
        }
        Ok(Rock::Table(
            rows.iter()
                .map(|&(weight, torque)| (1e3 * weight, torque))
                .collect(),
        ))
    }
}
