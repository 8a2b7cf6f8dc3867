//! Oilfield units: every name that ends in an SI unit has twins that end in others, and what
//! is given under these is converted where it is read.

/// One inch, m.
pub const INCH: f64 = 25.4e-3;

/// One foot, m.
pub const FOOT: f64 = 12.0 * INCH;

/// One pound, kg.
pub const POUND: f64 = 0.453_592_37;

/// One pound-force, N, by the standard acceleration of free fall.
pub const POUND_FORCE: f64 = POUND * 9.806_65;

/// One US gallon, m³.
const GALLON: f64 = 231.0 * INCH * INCH * INCH;

const PSI: f64 = POUND_FORCE / (INCH * INCH);

/// An ending of names, that of a twin, and what a number under the twin is multiplied by: in
/// rows of numbers, each by its own.
pub struct Twin {
    /// The ending in SI units.
    pub si: &'static str,
    /// That in other units.
    pub twin: &'static str,
    /// The units in words: that in SI, and the other.
    pub units: [&'static str; 2],
    /// What numbers in these are multiplied by.
    pub factors: &'static [f64],
}

const fn twin(
    [si, twin]: [&'static str; 2],
    units: [&'static str; 2],
    factors: &'static [f64],
) -> Twin {
    Twin {
        si,
        twin,
        units,
        factors,
    }
}

/// Lengths along the string, and deflections by a force.
pub const LENGTH: Twin = twin(["_m", "_ft"], ["m", "ft"], &[FOOT]);

/// Lengths across the borehole.
pub const WIDTH: Twin = twin(["_mm", "_in"], ["mm", "in"], &[1e3 * INCH]);

/// Rates of penetration, and speeds at which a string is let down.
pub const RATE: Twin = twin(["_m_h", "_ft_h"], ["m/h", "ft/h"], &[FOOT]);

/// Moments of inertia.
pub const INERTIA: Twin = twin(
    ["_kg_m2", "_lb_ft2"],
    ["kg m²", "lb ft²"],
    &[POUND * FOOT * FOOT],
);

/// Torque per speed of rotation.
pub const PROPORTIONAL_GAIN: Twin = twin(
    ["_knms_rad", "_klbf_ft_s_rad"],
    ["kN m s/rad", "klbf ft s/rad"],
    &[POUND_FORCE * FOOT],
);

/// Torque per angle.
pub const INTEGRAL_GAIN: Twin = twin(
    ["_knm_rad", "_klbf_ft_rad"],
    ["kN m/rad", "klbf ft/rad"],
    &[POUND_FORCE * FOOT],
);

/// Forces and weights.
pub const FORCE: Twin = twin(["_kn", "_klbf"], ["kN", "klbf"], &[POUND_FORCE]);

/// Impulses.
pub const IMPULSE: Twin = twin(["_ns", "_lbf_s"], ["N s", "lbf s"], &[POUND_FORCE]);

/// Torques.
pub const TORQUE: Twin = twin(["_nm", "_lbf_ft"], ["N m", "lbf ft"], &[POUND_FORCE * FOOT]);

/// Stress and pressure.
pub const STRESS: Twin = twin(["_mpa", "_psi"], ["MPa", "psi"], &[1e-6 * PSI]);

/// All of them. Where several fit a name that is read, the known names decide; what has a name
/// is shown in the first that fits it by the longest ending.
pub const TWINS: [Twin; 23] = [
    twin(["_radius_m", "_diameter_in"], ["m", "in"], &[0.5 * INCH]),
    twin(["_radius_m", "_diameter_mm"], ["m", "mm"], &[0.5e-3]),
    LENGTH,
    twin(["_m", "_in"], ["m", "in"], &[INCH]),
    WIDTH,
    twin(["_m_s", "_ft_s"], ["m/s", "ft/s"], &[FOOT]),
    RATE,
    twin(["_kg", "_lb"], ["kg", "lb"], &[POUND]),
    twin(["_kg_m3", "_ppg"], ["kg/m³", "ppg"], &[POUND / GALLON]),
    INERTIA,
    PROPORTIONAL_GAIN,
    INTEGRAL_GAIN,
    FORCE,
    IMPULSE,
    TORQUE,
    twin(
        ["_kn_m", "_klbf_ft"],
        ["kN m", "klbf ft"],
        &[POUND_FORCE * FOOT],
    ),
    twin(
        ["_nm_per_kn", "_lbf_ft_per_klbf"],
        ["N m/kN", "lbf ft/klbf"],
        &[FOOT],
    ),
    twin(
        ["_kn_nm", "_klbf_lbf_ft"],
        ["rows `[kN, N m]`", "rows `[klbf, lbf ft]`"],
        &[POUND_FORCE, POUND_FORCE * FOOT],
    ),
    twin(
        ["_nms_rad_m", "_lbf_s_rad"],
        ["N m s/rad per m", "lbf s/rad"],
        &[POUND_FORCE],
    ),
    twin(
        ["_ns_m2", "_lbf_s_ft2"],
        ["N s/m²", "lbf s/ft²"],
        &[POUND_FORCE / (FOOT * FOOT)],
    ),
    twin(
        ["_ns_m", "_lbf_s_ft"],
        ["N s/m", "lbf s/ft"],
        &[POUND_FORCE / FOOT],
    ),
    STRESS,
    twin(["_gpa", "_psi"], ["GPa", "psi"], &[1e-9 * PSI]),
];

/// The twin that a name in SI units is shown as, if it has any.
pub fn shown_as(name: &str) -> Option<&'static Twin> {
    let fitting = TWINS.iter().filter(|twin| name.ends_with(twin.si));
    // The last of equals is the greatest.
    fitting.rev().max_by_key(|twin| twin.si.len())
}

/// Endings of units that are the same everywhere.
const PLAIN: [(&str, &str); 6] = [
    ("_rpm", "rpm"),
    ("_s", "s"),
    ("_hz", "Hz"),
    ("_deg", "°"),
    ("_cp", "cP"),
    ("_gn_m15", "GN/m^1.5"),
];

/// The unit that a name ends in, if it has one: that of the longest ending.
pub fn unit_of(name: &str) -> Option<&'static str> {
    let endings = TWINS.iter().map(|twin| (twin.si, twin.units[0]));
    let fitting = endings
        .chain(PLAIN)
        .filter(|(ending, _)| name.ends_with(ending));
    let longest = fitting.max_by_key(|(ending, _)| ending.len());
    longest.map(|(_, unit)| unit)
}

/// The names in other units that a name in SI units has: `length_ft` and `length_in` of
/// `length_m`.
pub fn twins_of(name: &str) -> impl Iterator<Item = (String, &'static Twin)> {
    let own = shown_as(name);
    TWINS.iter().filter_map(move |twin| {
        let stem = name.strip_suffix(twin.si)?;
        let is_whole = own?.units[0] == twin.units[0];
        is_whole.then(|| (format!("{stem}{}", twin.twin), twin))
    })
}

/// The known name that this one is a twin of, and the factors of its numbers. What ends in a
/// unit of which the ending is a part, as metres are of `_nms_rad_m`, is in another unit.
pub fn in_si(name: &str, is_known: impl Fn(&str) -> bool) -> Option<(String, &'static [f64])> {
    TWINS.iter().find_map(|twin| {
        let stem = name.strip_suffix(twin.twin)?;
        let known = format!("{stem}{}", twin.si);
        let own = shown_as(&known)?;
        let is_whole = own.units[0] == twin.units[0];
        (is_whole && is_known(&known)).then_some((known, twin.factors))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By other tables of units.
    #[test]
    fn units_are_what_tables_of_units_say() {
        for (name, known, expected) in [
            ("a_radius_in", "a_radius_m", 0.0254),
            ("a_diameter_in", "a_radius_m", 0.0127),
            ("a_diameter_mm", "a_radius_m", 0.0005),
            ("a_ft", "a_m", 0.3048),
            ("a_in", "a_mm", 25.4),
            ("a_lb", "a_kg", 0.45359237),
            ("a_ppg", "a_kg_m3", 119.826427317),
            ("a_lb_ft2", "a_kg_m2", 0.0421401101),
            ("a_klbf_ft_s_rad", "a_knms_rad", 1.355817948),
            ("a_klbf_ft_rad", "a_knm_rad", 1.355817948),
            ("a_klbf", "a_kn", 4.448221615),
            ("a_lbf_s", "a_ns", 4.448221615),
            ("a_lbf_ft", "a_nm", 1.355817948),
            (
                "a_lbf_ft_per_klbf",
                "a_nm_per_kn",
                1.355817948 / 4.448221615,
            ),
            ("a_lbf_s_rad", "a_nms_rad_m", 4.448221615),
            ("a_lbf_s_ft2", "a_ns_m2", 47.88025898),
            ("a_psi", "a_mpa", 0.006894757293),
            ("a_psi", "a_gpa", 0.000006894757293),
        ] {
            let (_, factors) = in_si(name, |found| found == known).expect(name);
            let off = factors[0] / expected - 1.0;
            assert!(off.abs() < 2e-9, "{name}: {off:e}");
        }
        assert!(in_si("a_furlong", |_| true).is_none());
        assert!(in_si("a_in", |name| name == "b_m").is_none());
        for (part_of_a_unit, known) in [
            ("a_nms_rad_ft", "a_nms_rad_m"),
            ("a_nm_per_klbf", "a_nm_per_kn"),
            ("a_kn_lbf_ft", "a_kn_nm"),
        ] {
            assert!(in_si(part_of_a_unit, |name| name == known).is_none());
        }
    }
}
