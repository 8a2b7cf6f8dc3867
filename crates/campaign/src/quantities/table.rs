//! The table of quantities, and what it says of an axis.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::axis::{Axis, RockConstant, StringAxis, TubeMeasure, WallQuantity};
use super::field_units::{in_si, twins_of};
use super::numbered::{numbered, numbers_in};
use super::range::{ValueError, within};
use super::units::{Unit, Units};

/// Longer than any borehole, m.
pub const LONGEST_STRING: f64 = 2e4;

/// What is known of a quantity. Name and title are patterns: where they count, from 0,
/// another number takes the place of each 0.
struct Quantity {
    /// The column's name, with the unit.
    name: &'static str,
    /// What it is, without the unit.
    title: &'static str,
    /// Its letter, where it has one that is short enough for a legend.
    letter: &'static str,
    least: f64,
    most: f64,
    unit: &'static str,
}

const fn row(
    name: &'static str,
    (title, letter): (&'static str, &'static str),
    (least, most, unit): (f64, f64, &'static str),
) -> Quantity {
    Quantity {
        name,
        title,
        letter,
        least,
        most,
        unit,
    }
}

const fn tube(measure: TubeMeasure) -> Axis {
    Axis::String(StringAxis::Tube {
        section: 0,
        part: 0,
        measure,
    })
}

const fn at_site(quantity: WallQuantity) -> Axis {
    Axis::WallAtSite { site: 0, quantity }
}

/// One axis of every kind: operating conditions in the order of their columns, then
/// quantities of the string.
const KINDS: [Axis; 46] = [
    Axis::SurfaceSpeedRpm,
    Axis::WeightOnBitKn,
    Axis::TorqueDynamicNm,
    Axis::FeedMH,
    Axis::ImpulseRatio,
    Axis::Wall(WallQuantity::Clearance),
    Axis::Wall(WallQuantity::Stiffness),
    Axis::FRICTION,
    Axis::Wall(WallQuantity::DynamicRatio),
    Axis::Wall(WallQuantity::StribeckSpeed),
    at_site(WallQuantity::Clearance),
    at_site(WallQuantity::Stiffness),
    at_site(WallQuantity::Friction),
    at_site(WallQuantity::DynamicRatio),
    at_site(WallQuantity::StribeckSpeed),
    Axis::StringFriction,
    Axis::StringFrictionRatio,
    Axis::StringFrictionSpeed,
    Axis::TorqueStaticRatio,
    Axis::TorqueDecay,
    Axis::Rock(RockConstant::BitRadius),
    Axis::Rock(RockConstant::SpecificEnergy),
    Axis::Rock(RockConstant::CuttingRatio),
    Axis::Rock(RockConstant::Friction),
    Axis::Rock(RockConstant::ContactStrength),
    Axis::Rock(RockConstant::ContactGrowth),
    Axis::Rock(RockConstant::WearFlat),
    Axis::Rock(RockConstant::PoorCleaningFrom),
    Axis::Rock(RockConstant::PoorCleaningSlope),
    Axis::StartNumber,
    Axis::String(StringAxis::TorsionalDamping),
    Axis::String(StringAxis::BendingDamping),
    Axis::String(StringAxis::Compression),
    Axis::String(StringAxis::Repeat { section: 0 }),
    tube(TubeMeasure::Length),
    tube(TubeMeasure::InnerRadius),
    tube(TubeMeasure::OuterRadius),
    Axis::String(StringAxis::SitePlace { site: 0 }),
    Axis::String(StringAxis::DriveInertia),
    Axis::String(StringAxis::ProportionalGain),
    Axis::String(StringAxis::IntegralGain),
    Axis::String(StringAxis::MudDensity),
    Axis::String(StringAxis::MudViscosity),
    Axis::String(StringAxis::LossFactor),
    Axis::String(StringAxis::EccentricMass { mass: 0 }),
    Axis::String(StringAxis::EccentricOffset { mass: 0 }),
];

impl Axis {
    #[rustfmt::skip]
    const fn quantity(self) -> Quantity {
        match self {
            Axis::SurfaceSpeedRpm => row("surface_speed_rpm", ("Surface speed Ω", "Ω"), (1e-4, 1e4, "rpm")),
            Axis::WeightOnBitKn => row("weight_on_bit_kn", ("Weight on bit W", "W"), (0.0, 2e3, "kN")),
            Axis::TorqueDynamicNm => row("torque_dynamic_nm", ("Dynamic torque T_d", "T_d"), (0.0, 1e7, "N m")),
            Axis::FeedMH => row("feed_m_h", ("Feed at the surface", ""), (1e-3, 1e4, "m/h")),
            Axis::ImpulseRatio => row("impulse_ratio", ("Impulse I / I₀", "I/I₀"), (0.0, 1e6, "")),
            Axis::Wall(quantity) => match quantity {
                WallQuantity::Clearance => row("clearance_mm", ("Clearance c", "c"), (1e-3, 1e3, "mm")),
                WallQuantity::Stiffness => row("stiffness_gn_m15", ("Stiffness of the wall k_c", "k_c"), (1e-6, 1e6, "GN/m^1.5")),
                WallQuantity::Friction => row("friction", ("Coefficient of friction μ₀", "μ₀"), (0.0, 50.0, "")),
                WallQuantity::DynamicRatio => row("friction_dynamic_ratio", ("Dynamic by static friction of the wall μ_d / μ₀", "μ_d/μ₀"), (0.0, 1.0, "")),
                WallQuantity::StribeckSpeed => row("friction_stribeck_m_s", ("Stribeck speed of the wall v_s", "v_s"), (0.0, 100.0, "m/s")),
            },
            Axis::WallAtSite { quantity, .. } => {
                let of_all = Axis::Wall(quantity).quantity();
                let (name, title) = match quantity {
                    WallQuantity::Clearance => ("site_0_clearance_mm", "Clearance at site 0"),
                    WallQuantity::Stiffness => ("site_0_stiffness_gn_m15", "Stiffness of the wall at site 0"),
                    WallQuantity::Friction => ("site_0_friction", "Coefficient of friction at site 0"),
                    WallQuantity::DynamicRatio => ("site_0_friction_dynamic_ratio", "Dynamic by static friction at site 0"),
                    WallQuantity::StribeckSpeed => ("site_0_friction_stribeck_m_s", "Stribeck speed at site 0"),
                };
                row(name, (title, ""), (of_all.least, of_all.most, of_all.unit))
            }
            Axis::StringFriction => row("string_friction", ("Static friction of the string μ_s", "μ_s"), (0.0, 50.0, "")),
            Axis::StringFrictionRatio => row("string_friction_ratio", ("Dynamic by static friction μ_d / μ_s", "μ_d/μ_s"), (0.0, 1.0, "")),
            Axis::StringFrictionSpeed => row("string_friction_stribeck_rpm", ("Speed of the Stribeck curve ω_s", "ω_s"), (0.0, 1e4, "rpm")),
            Axis::TorqueStaticRatio => row("torque_static_ratio", ("Static by dynamic torque T_s / T_d", "T_s/T_d"), (1.0, 10.0, "")),
            Axis::TorqueDecay => row("torque_decay_rpm", ("Speed over which the torque falls", ""), (0.0, 1e4, "rpm")),
            Axis::Rock(constant) => match constant {
                RockConstant::BitRadius => row("rock_bit_radius_m", ("Radius of the bit", ""), (1e-3, 2.0, "m")),
                RockConstant::SpecificEnergy => row("rock_specific_energy_mpa", ("Specific energy of the rock ε", "ε"), (0.1, 1e4, "MPa")),
                RockConstant::CuttingRatio => row("rock_cutting_ratio", ("Cutting ratio ζ", "ζ"), (1e-2, 10.0, "")),
                RockConstant::Friction => row("rock_friction", ("Friction at the wear flats μγ", "μγ"), (0.0, 10.0, "")),
                RockConstant::ContactStrength => row("rock_contact_strength_mpa", ("Contact strength of the rock σ", "σ"), (0.1, 1e4, "MPa")),
                RockConstant::ContactGrowth => row("rock_contact_growth", ("Contact growth κ", "κ"), (1e-3, 1e3, "")),
                RockConstant::WearFlat => row("rock_wear_flat_mm", ("Wear-flat length ℓ", "ℓ"), (1e-3, 1e3, "mm")),
                RockConstant::PoorCleaningFrom => row("rock_poor_cleaning_from_kn", ("Weight on bit from which cleaning is poor", ""), (1e-3, 1e5, "kN")),
                RockConstant::PoorCleaningSlope => row("rock_poor_cleaning_nm_per_kn", ("Torque per weight on bit where cleaning is poor", ""), (1e-6, 1e6, "N m/kN")),
            },
            Axis::StartNumber => row("start_number", ("Number of the start", ""), (0.0, 1e6, "")),
            Axis::String(axis) => match axis {
                StringAxis::DriveInertia => row("top_drive_inertia_kg_m2", ("Inertia of the top drive", ""), (0.0, 1e6, "kg m²")),
                StringAxis::ProportionalGain => row("proportional_gain_knms_rad", ("Proportional gain K_p", "K_p"), (1e-6, 1e6, "kN m s/rad")),
                StringAxis::IntegralGain => row("integral_gain_knm_rad", ("Integral gain K_i", "K_i"), (1e-6, 1e6, "kN m/rad")),
                StringAxis::MudDensity => row("mud_density_kg_m3", ("Density of the mud", ""), (1.0, 3e3, "kg/m³")),
                StringAxis::MudViscosity => row("mud_viscosity_cp", ("Viscosity of the mud", ""), (0.0, 1e4, "cP")),
                StringAxis::LossFactor => row("loss_factor", ("Loss factor of the string η", "η"), (0.0, 0.2, "")),
                StringAxis::EccentricMass { .. } => row("eccentric_mass_0_mass_kg", ("Eccentric mass 0", ""), (0.0, 1e6, "kg")),
                StringAxis::EccentricOffset { .. } => row("eccentric_mass_0_offset_m", ("Offset of eccentric mass 0", ""), (0.0, 10.0, "m")),
                StringAxis::TorsionalDamping => row("torsional_damping_nms_rad_m", ("Torsional damping", ""), (0.0, 1e5, "N m s/rad per m")),
                StringAxis::BendingDamping => row("bending_damping_ns_m2", ("Lateral damping", ""), (0.0, 1e7, "N s/m²")),
                StringAxis::Compression => row("compression_kn", ("Pre-compression C", ""), (-1e5, 1e5, "kN")),
                StringAxis::Repeat { .. } => row("section_0_repeat", ("Cells of section 0", ""), (1.0, 1e5, "")),
                StringAxis::Tube { measure, .. } => match measure {
                    TubeMeasure::Length => row("section_0_part_0_length_m", ("Length of section 0, part 0", ""), (1e-3, LONGEST_STRING, "m")),
                    TubeMeasure::InnerRadius => row("section_0_part_0_inner_radius_m", ("Internal radius of section 0, part 0", ""), (0.0, 2.0, "m")),
                    TubeMeasure::OuterRadius => row("section_0_part_0_outer_radius_m", ("External radius of section 0, part 0", ""), (1e-3, 2.0, "m")),
                },
                StringAxis::SitePlace { .. } => row("site_0_distance_from_bit_m", ("Distance of site 0 from the bit", ""), (0.0, LONGEST_STRING, "m")),
            },
        }
    }

    /// The names of conditions, and examples of quantities of the string, to show a
    /// user who misspelt one; others count on from 0.
    pub const NAMES: [&str; KINDS.len()] = {
        let mut names = [""; KINDS.len()];
        let mut index = 0;
        while index < names.len() {
            names[index] = KINDS[index].quantity().name;
            index += 1;
        }
        names
    };

    /// The axis of a column.
    pub fn from_name(name: &str) -> Option<Self> {
        let of_kind = |kind: Axis| Some(kind.with_numbers(numbers_in(name, kind.quantity().name)?));
        KINDS.into_iter().find_map(of_kind)
    }

    /// The axis of a name in other units, and what numbers in them are multiplied by.
    pub fn from_field_name(name: &str) -> Option<(Self, f64)> {
        let (known, factors) = in_si(name, |known| Self::from_name(known).is_some())?;
        Some((Self::from_name(&known)?, factors[0]))
    }

    /// The column's name.
    pub fn name(self) -> String {
        numbered(self.quantity().name, self.numbers())
    }

    /// Its name as it is shown in some units.
    pub fn name_in(self, units: Units) -> String {
        let (name, _) = units.named(self.quantity().name);
        numbered(&name, self.numbers())
    }

    /// The unit that its values are shown in.
    pub fn unit(self, units: Units) -> Unit {
        let Quantity { name, unit, .. } = self.quantity();
        let twin = units.twin_of(name);
        twin.map_or_else(|| Unit::unchanged(unit), |twin| units.of(twin))
    }

    /// The symbol and, where it has one, the unit.
    pub fn symbol(self, units: Units) -> String {
        let (letter, unit) = (self.quantity().letter, self.unit(units).name);
        match (letter, unit.as_str()) {
            ("", _) => self.name_in(units),
            (_, "") => letter.to_owned(),
            _ if unit.contains(' ') => format!("{letter}/({unit})"),
            _ => format!("{letter}/{unit}"),
        }
    }

    /// What it is, without a unit.
    pub fn words(self, units: Units) -> String {
        let Quantity { name, title, .. } = self.quantity();
        let title = numbered(title, self.numbers());
        // Twins of radii are diameters.
        match units.twin_of(name) {
            Some(twin) if twin.twin.starts_with("_diameter") => title.replace("radius", "diameter"),
            _ => title,
        }
    }

    /// The title of a plot's axis.
    pub fn title(self, units: Units) -> String {
        let (title, unit) = (self.words(units), self.unit(units).name);
        if unit.is_empty() {
            title
        } else {
            format!("{title} ({unit})")
        }
    }

    /// Its least value.
    pub fn least(self) -> f64 {
        self.quantity().least
    }

    /// Its greatest value.
    pub fn most(self) -> f64 {
        self.quantity().most
    }

    /// Refuses a value that the quantity does not have.
    ///
    /// # Errors
    /// Why it does not.
    pub fn check(self, value: f64) -> Result<(), ValueError> {
        if self == Axis::SurfaceSpeedRpm && value <= 0.0 {
            return Err(ValueError::StandsStill(value));
        }
        if self.is_counted() && value.fract() != 0.0 {
            return Err(ValueError::NotWhole(value));
        }
        let Quantity {
            least, most, unit, ..
        } = self.quantity();
        within(value, least, most, unit)
    }
}

impl Serialize for Axis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

/// As a string, so that an error below `[design.axes]` can name the axis.
impl<'de> Deserialize<'de> for Axis {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        // Its numbers have been converted where the file was read.
        let in_units = || Some(Axis::from_field_name(&name)?.0);
        (Axis::from_name(&name).or_else(in_units))
            .ok_or_else(|| serde::de::Error::unknown_variant(&name, &Axis::NAMES))
    }
}

/// Names as they are, and patterns of those that count; in field units, too.
impl JsonSchema for Axis {
    fn schema_name() -> Cow<'static, str> {
        "Axis".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let twins = |name: &&str| twins_of(name).map(|(twin, _)| twin).collect::<Vec<_>>();
        let names = Axis::NAMES.iter();
        let names = names.flat_map(|name| [vec![(*name).to_owned()], twins(name)].concat());
        let (counting, plain): (Vec<_>, Vec<_>) = names.partition(|name| name.contains('0'));
        let counting = counting.join("|").replace('0', "(0|[1-9][0-9]*)");
        json_schema!({
            "anyOf": [
                { "type": "string", "enum": plain },
                { "type": "string", "pattern": format!("^({counting})$") },
            ],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back() {
        let more = [
            "section_12_part_3_outer_radius_m",
            "site_7_distance_from_bit_m",
            "site_12_friction",
            "site_3_friction_stribeck_m_s",
        ];
        for name in Axis::NAMES.into_iter().chain(more) {
            let axis = Axis::from_name(name);
            assert_eq!(axis.map(Axis::name).as_deref(), Some(name));
        }
    }

    #[test]
    fn an_unknown_name_is_rejected() {
        for name in [
            "",
            "section_repeat",
            "section_00_repeat",
            "section_+1_repeat",
            "section_0_part_0_colour",
            "site_0",
            "site_friction",
            "site_00_clearance_mm",
            "section_99999999999999999999_repeat",
        ] {
            assert_eq!(Axis::from_name(name), None, "{name}");
        }
    }

    #[test]
    fn symbols_and_titles_have_units() {
        let axis = |name| Axis::from_name(name).unwrap();
        let [torque, friction] = ["torque_dynamic_nm", "friction"].map(axis);
        assert_eq!(torque.symbol(Units::Si), "T_d/(N m)");
        assert_eq!(torque.symbol(Units::Field), "T_d/(lbf ft)");
        assert_eq!(axis("surface_speed_rpm").symbol(Units::Field), "Ω/rpm");
        assert_eq!(friction.title(Units::Si), "Coefficient of friction μ₀");
        let weight = axis("weight_on_bit_kn");
        assert_eq!(weight.title(Units::Field), "Weight on bit W (klbf)");
        assert_eq!(weight.unit(Units::Field).rounded(200.0), 44.962);
        let tube = axis("section_1_part_2_length_m");
        assert_eq!(tube.title(Units::Si), "Length of section 1, part 2 (m)");
        assert_eq!(tube.symbol(Units::Si), "section_1_part_2_length_m");
        assert_eq!(tube.symbol(Units::Field), "section_1_part_2_length_ft");
    }

    #[test]
    fn radii_are_shown_as_diameters() {
        let radius = Axis::from_name("section_1_part_2_outer_radius_m").unwrap();
        let title = "External diameter of section 1, part 2 (in)";
        assert_eq!(radius.title(Units::Field), title);
        let name = "section_1_part_2_outer_diameter_in";
        assert_eq!(radius.name_in(Units::Field), name);
        assert_eq!(radius.unit(Units::Field).rounded(0.0635), 5.0);
    }

    /// What is shown under a name is what the same name would be read as.
    #[test]
    fn every_axis_with_a_unit_is_shown_as_it_may_be_given() {
        for axis in KINDS {
            let Quantity { name, unit, .. } = axis.quantity();
            let Some(twin) = Units::Field.twin_of(name) else {
                let without = ["", "rpm", "GN/m^1.5", "cP"];
                assert!(without.contains(&unit), "{name} has no twin");
                continue;
            };
            assert_eq!(twin.units[0], unit, "{name}");
            let read = Axis::from_field_name(&axis.name_in(Units::Field));
            assert_eq!(read, Some((axis, twin.factors[0])), "{name}");
        }
    }
}
