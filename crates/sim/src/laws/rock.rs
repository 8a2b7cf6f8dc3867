//! Weight on bit to cutting torque (Section 4.2, Fig. 4(a)).
//!
//! The paper shows the law as a picture. The law behind it is the one of
//! E. Detournay, T. Richard and M. Shepherd, *Drilling response of drag bits:
//! theory and experiment*, Int. J. Rock Mech. Min. Sci. 45 (2008) 1347–1360,
//! piecewise linear in the scaled weight w = W/a and torque t = 2T/a² of a bit
//! of radius a.
//!
//! ```
//! use sim::Rock;
//!
//! let rock = Rock::sandstone();
//! let torque = rock.torque_dynamic(80e3)?;
//! assert!((rock.weight_on_bit(torque)? - 80e3).abs() < 1e-6);
//! // Under the same weight it cuts deeper into shale, and that takes more torque.
//! assert!(torque < Rock::shale().torque_dynamic(80e3)?);
//!
//! let measured = Rock::Table(vec![(0.0, 0.0), (50e3, 2000.0), (100e3, 5000.0)]);
//! assert_eq!(measured.torque_dynamic(75e3)?, 3500.0);
//! assert!(measured.torque_dynamic(120e3).is_err());
//! # Ok::<(), sim::laws::rock::RockError>(())
//! ```

use thiserror::Error;

/// A rock whose law follows from its cutting and contact parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CuttingLaw {
    /// Radius a of the bit, m.
    pub bit_radius: f64,
    /// Intrinsic specific energy ε, Pa.
    pub specific_energy: f64,
    /// Ratio ζ of the vertical to the horizontal cutting force.
    pub cutting_ratio: f64,
    /// μγ: friction at the wear flats times the bit's geometry factor.
    pub friction: f64,
    /// Contact strength σ, Pa.
    pub contact_strength: f64,
    /// Contact growth κ: wear-flat contact gained per depth of cut.
    pub contact_growth: f64,
    /// Wear-flat length ℓ, m.
    pub wear_flat: f64,
    /// Poor cleaning beyond a given weight, if it is modelled.
    pub poor_cleaning: Option<PoorCleaning>,
}

/// Phase III: beyond a weight on bit the torque grows at another slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoorCleaning {
    /// Weight on bit where it begins, N; in phase II.
    pub weight_on_bit: f64,
    /// Torque per weight on bit beyond, N m/N.
    pub slope: f64,
}

/// From weight on bit to the dynamic torque T_d.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Rock {
    /// By the cutting and contact parameters.
    Law(CuttingLaw),
    /// By a table of (weight on bit in N, T_d in N m), joined by straight
    /// lines; both columns increase.
    Table(Vec<(f64, f64)>),
}

/// A weight or torque that a rock gives no answer for.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum RockError {
    /// No straight lines join the table.
    #[error("a rock's table needs two rows or more, and both columns must increase")]
    NoTable,
    /// Outside the table.
    #[error("{value} {unit} is outside the rock's table, {from} to {to} {unit}")]
    OutsideTable {
        /// The value asked for.
        value: f64,
        /// First value of the table.
        from: f64,
        /// Last value of the table.
        to: f64,
        /// Unit of the value.
        unit: &'static str,
    },
}

impl Rock {
    /// Representative sandstone for the illustrative string: values chosen to
    /// give the paper's torques at plausible weights, not read off its figure.
    pub fn sandstone() -> Self {
        Rock::Law(CuttingLaw {
            bit_radius: 0.15,
            specific_energy: 60e6,
            cutting_ratio: 0.6,
            friction: 0.5,
            contact_strength: 60e6,
            contact_growth: 5.0,
            wear_flat: 5e-3,
            poor_cleaning: None,
        })
    }

    /// Representative shale, chosen like [`Rock::sandstone`].
    pub fn shale() -> Self {
        Rock::Law(CuttingLaw {
            bit_radius: 0.15,
            specific_energy: 30e6,
            cutting_ratio: 0.7,
            friction: 0.3,
            contact_strength: 20e6,
            contact_growth: 5.0,
            wear_flat: 5e-3,
            poor_cleaning: None,
        })
    }

    /// Dynamic torque T_d (N m) at a weight on bit (N).
    ///
    /// # Errors
    /// Outside a table, or where its columns do not increase.
    pub fn torque_dynamic(&self, weight_on_bit: f64) -> Result<f64, RockError> {
        match self {
            Rock::Law(law) => Ok(along(&law.corners(), weight_on_bit)),
            Rock::Table(rows) => {
                is_table(rows)?;
                inside(rows, weight_on_bit, "N").map(|()| along(rows, weight_on_bit))
            }
        }
    }

    /// The weight on bit (N) at which the dynamic torque is `torque` (N m).
    ///
    /// # Errors
    /// Outside a table, or where its columns do not increase.
    pub fn weight_on_bit(&self, torque: f64) -> Result<f64, RockError> {
        let flipped = |corners: &[(f64, f64)]| -> Vec<(f64, f64)> {
            corners
                .iter()
                .map(|&(weight, torque)| (torque, weight))
                .collect()
        };
        match self {
            Rock::Law(law) => Ok(along(&flipped(&law.corners()), torque)),
            Rock::Table(rows) => {
                is_table(rows)?;
                let flipped = flipped(rows);
                inside(&flipped, torque, "N m").map(|()| along(&flipped, torque))
            }
        }
    }
}

impl CuttingLaw {
    /// Weight on bit (N) and torque (N m) at the end of phase I, where contact
    /// forces stop growing with the depth of cut.
    pub fn end_of_phase_one(&self) -> (f64, f64) {
        let cutting = self.cutting_ratio * self.specific_energy;
        let contact = self.contact_growth * self.contact_strength;
        let depth = self.wear_flat / self.contact_growth;
        let scaled_weight = (cutting + contact) * depth;
        let scaled_torque = (self.specific_energy + self.friction * contact) * depth;
        (
            scaled_weight * self.bit_radius,
            scaled_torque * self.bit_radius * self.bit_radius / 2.0,
        )
    }

    /// The corners (W, T) of the law; its last straight line has no end.
    fn corners(&self) -> Vec<(f64, f64)> {
        let phase_one = self.end_of_phase_one();
        // Phase II: all further weight cuts, dt/dw = 1/ζ.
        let cutting_slope = self.bit_radius / (2.0 * self.cutting_ratio);
        let further = |from: (f64, f64), weight: f64, slope: f64| {
            (weight, from.1 + (weight - from.0) * slope)
        };
        let mut corners = vec![(0.0, 0.0), phase_one];
        match self.poor_cleaning {
            None => corners.push(further(phase_one, 2.0 * phase_one.0, cutting_slope)),
            Some(PoorCleaning {
                weight_on_bit,
                slope,
            }) => {
                let phase_two = further(phase_one, weight_on_bit, cutting_slope);
                corners.push(phase_two);
                corners.push(further(phase_two, 2.0 * weight_on_bit, slope));
            }
        }
        corners
    }
}

/// The value at `x` of straight lines through `corners`, the outer ones
/// continued.
fn along(corners: &[(f64, f64)], x: f64) -> f64 {
    let piece = corners[1..corners.len() - 1].partition_point(|corner| corner.0 < x);
    let ((x0, y0), (x1, y1)) = (corners[piece], corners[piece + 1]);
    y0 + (x - x0) / (x1 - x0) * (y1 - y0)
}

fn is_table(rows: &[(f64, f64)]) -> Result<(), RockError> {
    let mut pairs = rows.windows(2);
    if rows.len() >= 2 && pairs.all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1) {
        Ok(())
    } else {
        Err(RockError::NoTable)
    }
}

fn inside(rows: &[(f64, f64)], value: f64, unit: &'static str) -> Result<(), RockError> {
    let (from, to) = (rows[0].0, rows[rows.len() - 1].0);
    // Of weights in other units the last digit is that of rounding.
    let rounding = 4.0 * f64::EPSILON * to;
    if (from - rounding..=to + rounding).contains(&value) {
        Ok(())
    } else {
        Err(RockError::OutsideTable {
            value,
            from,
            to,
            unit,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sandstone_gives_the_torques_of_figure_8_at_43_and_63_kilonewtons() {
        let rock = Rock::sandstone();
        for (weight, torque) in [(43e3, 2000.0), (63e3, 4000.0)] {
            let found = rock.weight_on_bit(torque).unwrap();
            assert!((found / weight - 1.0).abs() < 0.01, "{found}");
        }
    }

    #[test]
    fn the_phases_are_those_of_the_scaled_law() {
        let law = CuttingLaw {
            bit_radius: 0.2,
            specific_energy: 40e6,
            cutting_ratio: 0.5,
            friction: 0.4,
            contact_strength: 30e6,
            contact_growth: 4.0,
            wear_flat: 2e-3,
            poor_cleaning: None,
        };
        let rock = Rock::Law(law);
        let scaled = |depth: f64| {
            // Forces as functions of the depth of cut: cutting plus contact,
            // which is saturated past ℓ/κ.
            let contact = 4.0 * 30e6 * depth.min(2e-3 / 4.0);
            let weight = 0.5 * 40e6 * depth + contact;
            let torque = 40e6 * depth + 0.4 * contact;
            (weight * 0.2, torque * 0.2 * 0.2 / 2.0)
        };
        for depth in [1e-5, 3e-4, 5e-4, 7e-4, 3e-3] {
            let (weight, torque) = scaled(depth);
            let found = rock.torque_dynamic(weight).unwrap();
            assert!(
                (found / torque - 1.0).abs() < 1e-12,
                "{depth}: {found} {torque}"
            );
            assert!((rock.weight_on_bit(torque).unwrap() / weight - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_table_is_joined_by_straight_lines_and_never_left() {
        let rock = Rock::Table(vec![(10.0, 1.0), (20.0, 3.0), (40.0, 4.0)]);
        assert_eq!(rock.torque_dynamic(10.0), Ok(1.0));
        assert_eq!(rock.torque_dynamic(15.0), Ok(2.0));
        assert_eq!(rock.torque_dynamic(30.0), Ok(3.5));
        assert_eq!(rock.weight_on_bit(3.5), Ok(30.0));
        assert!(rock.torque_dynamic(9.9).is_err());
        assert!(rock.weight_on_bit(4.1).is_err());
        assert!(rock.torque_dynamic(f64::NAN).is_err());
    }

    #[test]
    fn what_is_no_table_gives_no_torque() {
        for rows in [
            vec![],
            vec![(10.0, 1.0)],
            vec![(10.0, 1.0), (10.0, 2.0)],
            vec![(10.0, 2.0), (20.0, 1.0)],
            vec![(10.0, 1.0), (f64::NAN, 2.0)],
        ] {
            let rock = Rock::Table(rows);
            assert_eq!(rock.torque_dynamic(10.0), Err(RockError::NoTable));
            assert_eq!(rock.weight_on_bit(1.0), Err(RockError::NoTable));
        }
    }
}
