//! `[mud]` and `[well]`: what the string is in.

use linear::well::Survey;
use linear::{Drillstring, DrillstringError, Hole, HoleSection, Mud};

use super::data::Data;
use crate::quantities::LONGEST_STRING;
use crate::sweep_file::{FileContent, HoleTable, Source, SweepFileError};

/// No mud is heavier, kg/m³.
const HEAVIEST_MUD: f64 = 3000.0;

/// The string in its hole, whose mud moves with it where it bends; and the mud that buoys it.
///
/// # Errors
/// Where a key is refused, or something needed is missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: Drillstring,
) -> Result<(Drillstring, Option<Mud>), SweepFileError> {
    let mud = content.mud.map(|mud| {
        let key = "mud.density_kg_m3";
        let density = source.within(key, mud.density_kg_m3, 1.0, HEAVIEST_MUD, "kg/m³")?;
        let message = "the string would float";
        source.refuse_if(density >= string.material().density, key, message)?;
        Ok::<_, SweepFileError>(Mud { density })
    });
    let mud = mud.transpose()?;
    let (bends, rubs) = (content.wall.is_some(), content.string_friction.is_some());
    let hangs = content.axial_force.is_some();
    let message = "moves with a string that bends, and buoys one that rubs: \
                   needs a [wall] or [string_friction]";
    source.refuse_if(mud.is_some() && !bends && !rubs, "mud", message)?;
    let survey = content.well.iter().flat_map(|well| &well.survey).next();
    let message = "says how the string lies in its well: needs [string_friction] or [axial_force]";
    source.refuse_if(survey.is_some() && !rubs && !hangs, "well.survey", message)?;
    let Some(sections) = sections(source, content, string.length())? else {
        let message = "what moves with a string that bends depends on the hole: \
                       needs `hole_radius_m` or [[well.holes]]";
        source.refuse_if(mud.is_some() && bends, "mud", message)?;
        return Ok((string, mud));
    };
    let key = if content.well.iter().any(|well| well.holes.is_empty()) {
        "well.hole_radius_m"
    } else {
        "well.holes"
    };
    let Some(mud) = mud.filter(|_| bends) else {
        let message = "counts where mud moves with a string that bends: needs [mud] and a [wall]";
        return Err(source.error(key, message));
    };
    let string = string.in_hole(Hole { sections, mud }).map_err(|error| {
        let key = match error {
            DrillstringError::WiderThanHole { section, part, .. } => {
                format!("string.sections[{section}].parts[{part}].outer_radius_m")
            }
            _ => key.to_owned(),
        };
        source.error(&key, error.to_string())
    })?;
    Ok((string, Some(mud)))
}

/// How wide the hole is from the surface down, where the file says it.
fn sections(
    source: &Source,
    content: &FileContent,
    length: f64,
) -> Result<Option<Vec<HoleSection>>, SweepFileError> {
    let Some(well) = &content.well else {
        return Ok(None);
    };
    let radius = |key: &str, radius| source.within(key, radius, 1e-3, 2.0, "m");
    if let Some(given) = well.hole_radius_m {
        let radius = radius("well.hole_radius_m", given)?;
        return Ok(Some(vec![HoleSection { length, radius }]));
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
    let sections: Vec<_> = (well.holes.iter().enumerate())
        .map(section)
        .collect::<Result<_, SweepFileError>>()?;
    Ok((!sections.is_empty()).then_some(sections))
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
