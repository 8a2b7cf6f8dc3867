//! Columns of `labels.csv` as a person reads them.

use campaign::quantities::{Axis, TORQUE, Unit, Units};

use campaign::records::ResultColumn;

/// Words of a column, and the unit in which its numbers are shown; a column that says nothing
/// but what a sweep file calls it keeps that name.
pub fn column_words(name: &str, units: Units) -> (String, Unit) {
    if let Some(column) = ResultColumn::named(name) {
        return (column.words.to_owned(), column.unit(units));
    }
    if let Some(axis) = Axis::from_name(name) {
        return (axis.words(units), axis.unit(units));
    }
    of_misfit(name, units).unwrap_or_else(|| units.named(name))
}

/// Of how far cases are from what was recorded, by the name of the comparison.
fn of_misfit(name: &str, units: Units) -> Option<(String, Unit)> {
    let name = name.strip_prefix("misfit_")?;
    let endings = [("_nm", units.of(&TORQUE)), ("_rpm", Unit::unchanged("rpm"))];
    let mut found = endings
        .into_iter()
        .filter_map(|(ending, unit)| Some((name.strip_suffix(ending)?, unit)));
    let (name, unit) = found.next()?;
    Some((format!("Misfit, {}", name.replace('_', " ")), unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_axes_and_misfits_have_words() {
        for (name, words, unit) in [
            ("ended", "Ended", ""),
            ("peak_radius_mm", "Greatest radius", "in"),
            ("surface_speed_rpm", "Surface speed Ω", "rpm"),
            (
                "misfit_surface_torque_nm",
                "Misfit, surface torque",
                "lbf ft",
            ),
            ("misfit_fit_rpm", "Misfit, fit", "rpm"),
            ("case", "case", ""),
        ] {
            let (found, of) = column_words(name, Units::Field);
            assert_eq!((found.as_str(), of.name.as_str()), (words, unit));
        }
    }
}
