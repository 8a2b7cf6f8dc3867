//! Keys in oilfield units: read as those in SI units that they are twins of.

use toml::Value;

use crate::quantities::{Axis, in_si};

/// Keys that carry a unit and are no axis.
pub const KEYS: [&str; 29] = [
    "length_m",
    "inner_radius_m",
    "outer_radius_m",
    "contact_radius_m",
    "hole_radius_m",
    "from_m",
    "to_m",
    "distance_from_bit_m",
    "sites_every_m",
    "sites_to_m",
    "sites_tolerance_mm",
    "offset_m",
    "bit_radius_m",
    "wear_flat_mm",
    "mass_kg",
    "density_kg_m3",
    "inertia_kg_m2",
    "proportional_gain_knms_rad",
    "integral_gain_knm_rad",
    "torque_limit_kn_m",
    "poor_cleaning_from_kn",
    "amount_ns",
    "damping_ns_m2",
    "poor_cleaning_nm_per_kn",
    "table_kn_nm",
    "specific_energy_mpa",
    "contact_strength_mpa",
    "shear_modulus_gpa",
    "youngs_modulus_gpa",
];

/// Of an axis, what has its unit.
const WITH_UNIT: [&str; 7] = [
    "from",
    "to",
    "values",
    "mean",
    "standard_deviation",
    "median",
    "mode",
];

/// A key in SI units for one in others, and the factors of its numbers; `None` for any other.
pub fn key_in_si(key: &str) -> Option<(String, &'static [f64])> {
    in_si(key, |known| {
        KEYS.contains(&known) || Axis::from_name(known).is_some()
    })
}

/// Multiplies the numbers of a value: rows of numbers one by one, of the table of an axis those
/// that have its unit. What is no number stays, to be refused where it is read.
pub fn scale(value: &mut Value, factors: &[f64]) {
    match value {
        Value::Float(number) => *number *= factors[0],
        Value::Integer(number) => *value = Value::Float(*number as f64 * factors[0]),
        Value::Array(items) => {
            for (index, item) in items.iter_mut().enumerate() {
                match item {
                    Value::Array(_) => scale(item, factors),
                    _ => scale(item, &factors[index.min(factors.len() - 1)..]),
                }
            }
        }
        Value::Table(table) => {
            for key in WITH_UNIT {
                if let Some(value) = table.get_mut(key) {
                    scale(value, factors);
                }
            }
        }
        _ => {}
    }
}
