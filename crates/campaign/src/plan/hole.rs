//! `[mud]` and `[well]`: what the string is in.

use linear::well::Survey;
use linear::{Drillstring, Hole, HoleSection, Mud};

use super::contacts::StringInHole;
use super::data::Data;
use crate::design::Design;
use crate::quantities::{Axis, LONGEST_STRING, StringAxis};
use crate::sweep_file::{FileContent, HoleTable, Source, SweepFileError};

/// A centipoise, Pa s.
pub const PA_S_PER_CP: f64 = 1e-3;

/// No mud is heavier, kg/m³.
const HEAVIEST_MUD: f64 = 3000.0;

/// The string in its hole, whose mud moves with it where it bends; the mud that buoys it; and the
/// hole from the surface down, empty where nothing is known of it.
///
/// # Errors
/// Where a key is refused, or something needed is missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: Drillstring,
) -> Result<(Drillstring, Option<Mud>, Vec<HoleSection>), SweepFileError> {
    let mud = content.mud.map(|mud| {
        let key = "mud.density_kg_m3";
        let density = source.within(key, mud.density_kg_m3, 1.0, HEAVIEST_MUD, "kg/m³")?;
        let message = "the string would float";
        source.refuse_if(density >= string.material().density, key, message)?;
        let axis = Axis::String(StringAxis::MudViscosity);
        source.check_axis("mud.viscosity_cp", axis, mud.viscosity_cp)?;
        Ok::<_, SweepFileError>(Mud {
            density,
            viscosity: PA_S_PER_CP * mud.viscosity_cp,
        })
    });
    let mud = mud.transpose()?;
    let bends = content.wall.is_some();
    let decides_clearance = content.clearance_is_of_hole();
    let sections = sections(source, content, string.length())?;
    if sections.is_empty() {
        let message = "what moves with a string that bends depends on the hole: \
                       needs `well.hole_radius_m` or [[well.holes]]";
        source.refuse_if(mud.is_some() && bends, "mud", message)?;
        let message = "how much mud holds the string back depends on the hole: \
                       needs `well.hole_radius_m` or [[well.holes]]";
        let is_viscous = mud.is_some_and(|mud| mud.viscosity > 0.0);
        source.refuse_if(is_viscous, "mud.viscosity_cp", message)?;
        let message = "the clearance is that in a hole: needs `well.hole_radius_m` or \
                       [[well.holes]]";
        source.refuse_if(decides_clearance, "wall.clearance", message)?;
        return Ok((string, mud, sections));
    }
    let key = if content.well.iter().any(|well| well.holes.is_empty()) {
        "well.hole_radius_m"
    } else {
        "well.holes"
    };
    let in_hole = StringInHole {
        string: &string,
        sections: &content.string.sections,
        hole: &sections,
        drills: content.bit.is_some(),
    };
    fits(source, content, &in_hole)?;
    let with_waterways = in_hole.with_waterways();
    let Some(mud) = mud else {
        return Ok((string, None, sections));
    };
    let hole = Hole {
        sections: with_waterways,
        mud,
    };
    let string = source.checked(key, string.in_hole(hole))?;
    Ok((string, Some(mud), sections))
}

/// Refuses a string that is as wide as its hole, or wider, but for a bit or blades that drilled it.
fn fits(
    source: &Source,
    content: &FileContent,
    in_hole: &StringInHole,
) -> Result<(), SweepFileError> {
    let sections = &content.string.sections;
    let Some(wide) = in_hole.too_wide() else {
        return Ok(());
    };
    let (section, part) = (wide.section, wide.part);
    let is_given = sections[section].parts[part].contact_radius_m.is_some();
    let name = if is_given { "contact" } else { "outer" };
    let key = format!("string.sections[{section}].parts[{part}].{name}_radius_m");
    let message = format!(
        "the string does not fit: its radius is {} m, and at a depth of {} m that of the hole is {} m",
        wide.radius, wide.depth, wide.hole_radius
    );
    Err(source.error(&key, message))
}

/// Whether mud holds the string back, in some case.
pub fn mud_is_viscous(content: &FileContent, design: &Design) -> bool {
    let axis = Axis::String(StringAxis::MudViscosity);
    design.axes().contains(&axis) || content.mud.is_some_and(|mud| mud.viscosity_cp > 0.0)
}

/// Tables of the file that nothing depends on, each with what it would matter to: a file is often the
/// base of others, whose scenes have more.
pub fn idle_tables(content: &FileContent, design: &Design) -> Vec<String> {
    let (bends, rubs) = (content.wall.is_some(), content.string_friction.is_some());
    let hangs = content.axial_force.is_some();
    let well = content.well.as_ref();
    let has_survey = well.is_some_and(|well| well.survey.is_some());
    let is_inclined = well.is_some_and(|well| well.inclination_deg.is_some());
    let lies = content.lies_on_low_side();
    let has_hole = well.is_some_and(|well| well.hole_radius_m.is_some() || !well.holes.is_empty());
    let is_viscous = mud_is_viscous(content, design);
    let moves_mud = content.mud.is_some() && bends || is_viscous;
    [
        (
            content.mud.is_some() && !bends && !rubs && !is_viscous,
            "[mud] has no effect without a viscosity, [wall] or [string_friction]",
        ),
        (
            has_survey && !rubs && !hangs && !lies,
            "`well.survey` has no effect without [string_friction], [axial_force] or a [wall] that \
             the string lies on",
        ),
        (
            is_inclined && !rubs && !hangs && !lies,
            "`well.inclination_deg` has no effect without [string_friction], [axial_force] or a \
             [wall] that the string lies on",
        ),
        (
            has_hole && !moves_mud && !content.clearance_is_of_hole(),
            "the hole of [well] has no effect without [mud] that is viscous or around a [wall], or \
             `clearance = \"hole\"`",
        ),
    ]
    .into_iter()
    .filter(|(is_idle, _)| *is_idle)
    .map(|(_, words)| words.to_owned())
    .collect()
}

/// How wide the hole is from the surface down; empty where the file does not say it.
pub(super) fn sections(
    source: &Source,
    content: &FileContent,
    length: f64,
) -> Result<Vec<HoleSection>, SweepFileError> {
    let Some(well) = &content.well else {
        return Ok(Vec::new());
    };
    let radius = |key: &str, radius| source.within(key, radius, 1e-3, 2.0, "m");
    if let Some(given) = well.hole_radius_m {
        let radius = radius("well.hole_radius_m", given)?;
        return Ok(vec![HoleSection { length, radius }]);
    }
    let mut depth = 0.0;
    let section = |(index, hole): (usize, &HoleTable)| {
        let key = |name: &str| format!("well.holes[{index}].{name}");
        let (from, to) = (hole.from_m, hole.to_m);
        for (name, depth) in [("from_m", from), ("to_m", to)] {
            source.within(&key(name), depth, 0.0, LONGEST_STRING, "m")?;
        }
        let message = format!("overlaps the section above, which ends at {depth} m");
        source.refuse_if(from < depth, &key("from_m"), message)?;
        let message = format!("leaves no hole from {depth} m to {from} m");
        source.refuse_if(from != depth, &key("from_m"), message)?;
        source.refuse_if(to <= from, &key("to_m"), "is not below `from_m`")?;
        depth = to;
        Ok(HoleSection {
            length: to - from,
            radius: radius(&key("hole_radius_m"), hole.hole_radius_m)?,
        })
    };
    well.holes.iter().enumerate().map(section).collect()
}

/// The survey of the well, if there is one, which is as deep as the string.
///
/// # Errors
/// Where it ends above the bit.
pub fn survey_along<'a>(
    source: &Source,
    data: &'a Data,
    string: &Drillstring,
) -> Result<Option<&'a Survey>, SweepFileError> {
    let Some(survey) = &data.survey else {
        return Ok(None);
    };
    let message = format!(
        "the survey ends at {} m, and the string at {} m",
        survey.depth(),
        string.length()
    );
    // Lengths of pipes and of a survey are sums.
    let is_short = survey.depth() < string.length() * (1.0 - 1e-9);
    source.refuse_if(is_short, "well.survey", message)?;
    Ok(Some(survey))
}
