//! Axes that change the string itself: its damping, its sections, the places of
//! its sites. Each value needs a linear system of its own.

use super::file::{FileContent, SectionTable, TubeTable};

/// Longer than any borehole, m.
pub(super) const LONGEST_STRING: f64 = 2e4;

/// A quantity of the string that a design varies. Sections, parts and sites
/// are counted from 0, in the order of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StringAxis {
    /// Distributed torsional damping c_t.
    TorsionalDamping,
    /// Distributed lateral damping c_b.
    BendingDamping,
    /// Pre-compression C.
    Compression,
    /// Number of cells of a section.
    Repeat {
        /// Which section.
        section: usize,
    },
    /// A measure of a tube.
    Tube {
        /// Which section.
        section: usize,
        /// Which part of its cell.
        part: usize,
        /// Which measure.
        measure: TubeMeasure,
    },
    /// The place of a site; impulses and masses there go with it.
    SitePlace {
        /// Which site.
        site: usize,
    },
}

/// A measure of a tube.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TubeMeasure {
    /// Its length.
    Length,
    /// Its internal radius.
    InnerRadius,
    /// Its external radius.
    OuterRadius,
}

impl TubeMeasure {
    const ALL: [Self; 3] = [Self::Length, Self::InnerRadius, Self::OuterRadius];

    /// The key in the sweep file.
    fn key(self) -> &'static str {
        match self {
            Self::Length => "length_m",
            Self::InnerRadius => "inner_radius_m",
            Self::OuterRadius => "outer_radius_m",
        }
    }

    fn of(self, tube: &mut TubeTable) -> &mut f64 {
        match self {
            Self::Length => &mut tube.length_m,
            Self::InnerRadius => &mut tube.inner_radius_m,
            Self::OuterRadius => &mut tube.outer_radius_m,
        }
    }
}

const TORSIONAL_DAMPING: &str = "torsional_damping_nms_rad_m";
const BENDING_DAMPING: &str = "bending_damping_ns_m2";
const COMPRESSION: &str = "compression_kn";

impl StringAxis {
    /// Names to show a user who misspelt one; others count on from 0.
    pub(super) const EXAMPLES: [&'static str; 8] = [
        TORSIONAL_DAMPING,
        BENDING_DAMPING,
        COMPRESSION,
        "section_0_repeat",
        "section_0_part_0_length_m",
        "section_0_part_0_inner_radius_m",
        "section_0_part_0_outer_radius_m",
        "site_0_distance_from_bit_m",
    ];

    /// The axis of a column.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            TORSIONAL_DAMPING => return Some(Self::TorsionalDamping),
            BENDING_DAMPING => return Some(Self::BendingDamping),
            COMPRESSION => return Some(Self::Compression),
            _ => {}
        }
        if let Some((site, "distance_from_bit_m")) = counted(name, "site_") {
            return Some(Self::SitePlace { site });
        }
        let (section, rest) = counted(name, "section_")?;
        if rest == "repeat" {
            return Some(Self::Repeat { section });
        }
        let (part, key) = counted(rest, "part_")?;
        let measure = TubeMeasure::ALL
            .into_iter()
            .find(|measure| measure.key() == key)?;
        Some(Self::Tube {
            section,
            part,
            measure,
        })
    }

    /// The column's name.
    pub fn name(self) -> String {
        match self {
            Self::TorsionalDamping => TORSIONAL_DAMPING.to_owned(),
            Self::BendingDamping => BENDING_DAMPING.to_owned(),
            Self::Compression => COMPRESSION.to_owned(),
            Self::Repeat { section } => format!("section_{section}_repeat"),
            Self::Tube {
                section,
                part,
                measure,
            } => format!("section_{section}_part_{part}_{}", measure.key()),
            Self::SitePlace { site } => format!("site_{site}_distance_from_bit_m"),
        }
    }

    /// The title of a plot's axis.
    pub fn title(self) -> String {
        match self {
            Self::TorsionalDamping => "Torsional damping (N m s/rad per m)".to_owned(),
            Self::BendingDamping => "Lateral damping (N s/m²)".to_owned(),
            Self::Compression => "Pre-compression C (kN)".to_owned(),
            Self::Repeat { section } => format!("Cells of section {section}"),
            Self::Tube {
                section,
                part,
                measure,
            } => {
                let what = match measure {
                    TubeMeasure::Length => "Length",
                    TubeMeasure::InnerRadius => "Internal radius",
                    TubeMeasure::OuterRadius => "External radius",
                };
                format!("{what} of section {section}, part {part} (m)")
            }
            Self::SitePlace { site } => format!("Distance of site {site} from the bit (m)"),
        }
    }

    /// Least and greatest value, and the unit.
    pub(super) fn limits(self) -> (f64, f64, &'static str) {
        match self {
            Self::TorsionalDamping => (0.0, 1e5, "N m s/rad per m"),
            Self::BendingDamping => (0.0, 1e7, "N s/m²"),
            Self::Compression => (-1e5, 1e5, "kN"),
            Self::Repeat { .. } => (1.0, 1e5, ""),
            Self::Tube { measure, .. } => match measure {
                TubeMeasure::Length => (1e-3, LONGEST_STRING, "m"),
                TubeMeasure::InnerRadius => (0.0, 2.0, "m"),
                TubeMeasure::OuterRadius => (1e-3, 2.0, "m"),
            },
            Self::SitePlace { .. } => (0.0, LONGEST_STRING, "m"),
        }
    }

    /// Whether only whole numbers make sense.
    pub(super) fn is_counted(self) -> bool {
        matches!(self, Self::Repeat { .. })
    }

    /// Puts a value in its place.
    ///
    /// # Errors
    /// Where the file has no such place; a sentence.
    pub(super) fn set(self, content: &mut FileContent, value: f64) -> Result<(), String> {
        match self {
            Self::TorsionalDamping => content.string.torsional_damping_nms_rad_m = value,
            Self::BendingDamping => bending(content)?.damping_ns_m2 = value,
            Self::Compression => bending(content)?.compression_kn = value,
            Self::Repeat { section } => self::section(content, section)?.repeat = value as usize,
            Self::Tube {
                section,
                part,
                measure,
            } => {
                let parts = &mut self::section(content, section)?.parts;
                let count = parts.len();
                let tube = parts
                    .get_mut(part)
                    .ok_or_else(|| format!("section {section} has {count} parts, from 0"))?;
                *measure.of(tube) = value;
            }
            Self::SitePlace { site } => move_site(content, site, value)?,
        }
        Ok(())
    }
}

/// `section_3_repeat` with `section_` is 3 and `repeat`. A number spelt with
/// leading zeros or a sign is another name for the same column: none.
fn counted<'a>(name: &'a str, before: &str) -> Option<(usize, &'a str)> {
    let (digits, rest) = name.strip_prefix(before)?.split_once('_')?;
    let number: usize = digits.parse().ok()?;
    (number.to_string() == digits).then_some((number, rest))
}

fn bending(content: &mut FileContent) -> Result<&mut super::lateral::BendingTable, String> {
    (content.string.bending.as_mut()).ok_or_else(|| "needs a table [string.bending]".to_owned())
}

fn section(content: &mut FileContent, section: usize) -> Result<&mut SectionTable, String> {
    let sections = &mut content.string.sections;
    let count = sections.len();
    (sections.get_mut(section)).ok_or_else(|| format!("the string has {count} sections, from 0"))
}

fn move_site(content: &mut FileContent, site: usize, distance: f64) -> Result<(), String> {
    let count = content.sites.len();
    let table = (content.sites.get_mut(site))
        .ok_or_else(|| format!("the file has {count} [[sites]], from 0"))?;
    let before = std::mem::replace(&mut table.distance_from_bit_m, distance);
    let impulses = content.impulses.iter_mut();
    let masses = content.eccentric_masses.iter_mut();
    (impulses.map(|impulse| &mut impulse.distance_from_bit_m))
        .chain(masses.map(|mass| &mut mass.distance_from_bit_m))
        .filter(|place| **place == before)
        .for_each(|place| *place = distance);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back() {
        for name in StringAxis::EXAMPLES.map(str::to_owned).into_iter().chain([
            "section_12_part_3_outer_radius_m".to_owned(),
            "site_7_distance_from_bit_m".to_owned(),
        ]) {
            let axis = StringAxis::from_name(&name);
            assert_eq!(axis.map(StringAxis::name), Some(name));
        }
    }

    #[test]
    fn what_is_no_name_is_none() {
        for name in [
            "",
            "section_repeat",
            "section_00_repeat",
            "section_+1_repeat",
            "section_0_part_0_colour",
            "site_0",
            "section_99999999999999999999_repeat",
        ] {
            assert_eq!(StringAxis::from_name(name), None, "{name}");
        }
    }
}
