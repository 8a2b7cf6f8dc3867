//! The units that people read results in: those of the tables, or oilfield units.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::field_units::{Twin, shown_as};

/// One turn a minute, rad/s.
pub const RPM: f64 = std::f64::consts::TAU / 60.0;

/// Digits of a number that was converted.
const CONVERTED: usize = 5;

/// What pictures, reports and words are in; tables are in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// SI units, as in tables.
    #[default]
    Si,
    /// Oilfield units.
    Field,
}

/// A unit of numbers that people read.
#[derive(Debug, Clone, PartialEq)]
pub struct Unit {
    /// Its name; empty where numbers have none.
    pub name: String,
    /// How much of the unit in SI it is.
    size: f64,
}

impl Units {
    /// Whether they are those of the tables.
    pub fn are_si(&self) -> bool {
        *self == Self::Si
    }

    /// The unit of a quantity.
    pub fn of(self, twin: &Twin) -> Unit {
        let [si, other] = twin.units;
        match self {
            Self::Si => Unit::unchanged(si),
            Self::Field => Unit {
                name: other.to_owned(),
                size: twin.factors[0],
            },
        }
    }

    /// The twin that a name in SI units has in these, if it has another one.
    pub(crate) fn twin_of(self, name: &str) -> Option<&'static Twin> {
        match self {
            Self::Si => None,
            Self::Field => shown_as(name),
        }
    }

    /// A name that ends in an SI unit as it ends in these, and the unit; where that is the same
    /// one, it has no name.
    pub fn named(self, name: &str) -> (String, Unit) {
        let renamed = self.twin_of(name).and_then(|twin| {
            let stem = name.strip_suffix(twin.si)?;
            Some((format!("{stem}{}", twin.twin), self.of(twin)))
        });
        renamed.unwrap_or_else(|| (name.to_owned(), Unit::unchanged("")))
    }
}

impl Unit {
    /// One that is the same everywhere, such as seconds.
    pub fn unchanged(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            size: 1.0,
        }
    }

    /// A number of this unit in that in SI.
    pub fn in_si(&self, number: f64) -> f64 {
        number * self.size
    }

    /// A number of the unit in SI in this one.
    pub fn number(&self, value: f64) -> f64 {
        value / self.size
    }

    /// The same as it was given; if it is converted, in few digits.
    pub fn rounded(&self, value: f64) -> f64 {
        if self.size == 1.0 {
            return value;
        }
        let number = self.number(value);
        let text = format!("{number:.*e}", CONVERTED - 1);
        text.parse().unwrap_or(number)
    }

    /// Decimals here of about the same resolution as a number of decimals in SI; no fewer.
    pub fn decimals(&self, in_si: usize) -> usize {
        in_si + self.size.log10().round().max(0.0) as usize
    }

    /// A number with a number of decimals in SI, with the unit.
    pub fn text(&self, value: f64, in_si: usize) -> String {
        let (number, decimals) = (self.number(value), self.decimals(in_si));
        format!("{number:.decimals$} {}", self.name)
    }

    /// A thousand of it, of numbers in thousands of the unit in SI.
    #[must_use]
    pub fn kilo(self) -> Self {
        Self {
            name: format!("k{}", self.name),
            ..self
        }
    }

    /// A thousandth of it, of numbers in thousandths of the unit in SI.
    #[must_use]
    pub fn without_kilo(self) -> Self {
        let name = self.name.strip_prefix('k').unwrap_or(&self.name);
        Self {
            name: name.to_owned(),
            ..self
        }
    }

    /// This by another.
    #[must_use]
    pub fn per(&self, other: &Self) -> Self {
        let over = if other.name.contains(' ') {
            " per "
        } else {
            "/"
        };
        Self {
            name: format!("{}{over}{}", self.name, other.name),
            size: self.size / other.size,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::{FORCE, LENGTH, TORQUE, WIDTH};

    /// By other tables of units.
    #[test]
    fn numbers_are_shown_in_the_units_of_the_field() {
        let near = |unit: &Unit, value, expected: f64| {
            let off = unit.number(value) / expected - 1.0;
            assert!(
                off.abs() < 1e-6,
                "{value} is {} {}",
                unit.number(value),
                unit.name
            );
        };
        let [force, length, torque, width] =
            [&FORCE, &LENGTH, &TORQUE, &WIDTH].map(|twin| Units::Field.of(twin));
        near(&force, 200.0, 44.961789);
        near(&length, 1000.0, 3280.839895);
        near(&torque, 1000.0, 737.562149);
        near(&width, 15.0, 0.590551181);
        near(&torque.clone().kilo(), 10.0, 7.37562149);
        near(&force.clone().without_kilo(), 1.0, 0.224808943);
        // Metres per newton, and radians per second per newton metre.
        let compliance = length.per(&force.clone().without_kilo());
        near(&compliance, 1.0, 14.59390294);
        let mobility = Unit::unchanged("rad/s").per(&torque);
        near(&mobility, 1.0, 1.355817948);
        let names = [compliance.name, mobility.name, torque.kilo().name];
        assert_eq!(names, ["ft/lbf", "rad/s per lbf ft", "klbf ft"]);
    }

    #[test]
    fn what_is_shown_in_si_stays_to_the_bit() {
        let force = Units::Si.of(&FORCE);
        let value = 0.1 + 0.2;
        assert_eq!([force.number(value), force.rounded(value)], [value; 2]);
        assert_eq!(force.text(value, 1), "0.3 kN");
        assert_eq!(
            Units::Si.named("weight_kn"),
            ("weight_kn".to_owned(), Unit::unchanged(""))
        );
    }

    #[test]
    fn names_end_in_the_unit_that_numbers_are_shown_in() {
        for (name, shown) in [
            ("weight_on_bit_kn", "weight_on_bit_klbf"),
            ("misfit_surface_torque_nm", "misfit_surface_torque_lbf_ft"),
            ("torsional_damping_nms_rad_m", "torsional_damping_lbf_s_rad"),
            ("outer_radius_m", "outer_diameter_in"),
            ("length_m", "length_ft"),
            ("clearance_mm", "clearance_in"),
            ("density_kg_m3", "density_ppg"),
            ("surface_speed_rpm", "surface_speed_rpm"),
        ] {
            assert_eq!(Units::Field.named(name).0, shown);
        }
    }

    #[test]
    fn decimals_tell_as_much_in_any_unit() {
        let [force, length, width] = [&FORCE, &LENGTH, &WIDTH].map(|twin| Units::Field.of(twin));
        assert_eq!(force.text(200.0, 2), "44.962 klbf");
        assert_eq!(length.text(1000.0, 3), "3280.840 ft");
        assert_eq!(width.text(15.0, 2), "0.591 in");
        assert_eq!(force.rounded(200.0), 44.962);
    }
}
