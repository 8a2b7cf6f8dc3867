//! Columns of `labels.csv` as a person reads them.

use campaign::quantities::{Axis, LENGTH, Measure, TORQUE, Unit, Units};
use serde_json::Value;

/// Words of a column, and the unit in which its numbers are shown; a column that says nothing
/// but what a sweep file calls it keeps that name.
pub fn column_words(name: &str, units: Units) -> (String, Unit) {
    if let Ok(measure) = serde_json::from_value::<Measure>(Value::from(name)) {
        return (measure.words().to_owned(), measure.unit(units));
    }
    if let Some(axis) = Axis::from_name(name) {
        return (axis.words(units), axis.unit(units));
    }
    if let Some((words, unit)) = of_no_map(name, units) {
        return (words.to_owned(), unit);
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

/// Of those that no map is of.
fn of_no_map(name: &str, units: Units) -> Option<(&'static str, Unit)> {
    let plain = || Unit::unchanged("");
    let of = match name {
        "torsion" => ("Torsion", plain()),
        "lateral" => ("Lateral motion", plain()),
        "first_slip_s" => ("First slip at", Unit::unchanged("s")),
        "slip_time_s" => ("Time slipping in a period", Unit::unchanged("s")),
        "site_from_bit_m" => ("Site that decides, from the bit", units.of(&LENGTH)),
        "first_contact_s" => ("First contact at", Unit::unchanged("s")),
        "ambiguous_steps" => ("Steps with more than one answer", plain()),
        "predicted" => ("Label foreseen when it had settled", plain()),
        "simulated_s" => ("Simulated", Unit::unchanged("s")),
        "ended" => ("Ended", plain()),
        "status" => ("Status", plain()),
        "surface_torque_least_nm" => (
            "Least torque at the surface in the closing window",
            units.of(&TORQUE),
        ),
        "surface_torque_mean_nm" => (
            "Mean torque at the surface in the closing window",
            units.of(&TORQUE),
        ),
        "string_torque_peak_from_bit_m" => (
            "Place of the greatest torque along the string, from the bit",
            units.of(&LENGTH),
        ),
        "finer_torsion" => ("Torsion by shorter steps", plain()),
        "finer_lateral" => ("Lateral motion by shorter steps", plain()),
        "finer_stick_slip_margin_rpm" => (
            "Speed above the limit of stick-slip by shorter steps",
            Unit::unchanged("rpm"),
        ),
        "finer_contact_fraction" => (
            "Share of the closing window in contact by shorter steps",
            plain(),
        ),
        "finer_precession_turns_per_s" => (
            "Rate of precession by shorter steps",
            Unit::unchanged("turns/s"),
        ),
        "nearby_torsion_agrees" => (
            "Same label of torsion at speeds up to 10 % lower and higher",
            plain(),
        ),
        "torsion_certified" => ("Label of torsion is certain", plain()),
        "lateral_certified" => ("Label of lateral motion is certain", plain()),
        "torsion_from_stuck" => ("Torsion after the bit was held", plain()),
        "torsion_from_smooth" => ("Torsion after smooth rotation", plain()),
        "found_sites_from_bit_m" => ("Sites found, m from the bit", plain()),
        "found_rounds" => ("Times run again for sites", plain()),
        _ => return None,
    };
    Some(of)
}

#[cfg(test)]
mod tests {
    use campaign::labels::LabelTable;
    use campaign::quantities::Axis;

    use super::*;

    /// A column more needs words here.
    #[test]
    fn every_column_has_words() {
        let all = LabelTable {
            methods: vec!["held"],
            axes: &[Axis::SurfaceSpeedRpm],
            shows_torque: true,
            shows_surface: true,
            shows_string_torque: true,
            misfits: vec!["misfit_surface_torque_nm", "misfit_fit_rpm"],
            certifying: Some([0, 0]),
            shows_starts: true,
            shows_found: true,
        };
        for (name, _) in all.columns() {
            let (words, _) = column_words(&name, Units::Si);
            let is_key = ["case", "method"].contains(&name.as_str());
            assert!(is_key || words != name, "{name} has no words");
            // What is told of each is of its name; `columns_are_what_their_words_say_of_the_motion`
            // holds the names to motions.
            for (part, word) in [
                ("peak_rpm", "greatest"),
                ("peak_nm", "greatest"),
                ("peak_radius", "greatest"),
                ("greatest", "greatest"),
                ("least", "least"),
                ("mean", "mean"),
                ("closing", "mean"),
                ("fraction", "share"),
                ("severity", "severity"),
            ] {
                let is_told = words.to_lowercase().contains(word);
                assert!(!name.contains(part) || is_told, "{name}: {words}");
            }
        }
    }

    #[test]
    fn numbers_are_in_the_units_that_are_shown() {
        let (words, unit) = column_words("string_torque_peak_from_bit_m", Units::Field);
        assert!(words.contains("from the bit"));
        assert_eq!(unit.name, "ft");
        assert!((unit.number(1.0) - 1.0 / 0.3048).abs() < 1e-12);
    }
}
