//! `[string]`: the drillstring, its numbers checked.

use linear::{Drillstring, DrillstringError, Material, Section, Tube};

use super::hole::mud_is_viscous;
use crate::design::Design;
use crate::quantities::{Axis, LONGEST_STRING, StringAxis, TubeMeasure};
use crate::sweep_file::{FileContent, SectionTable, Source, SweepFileError, TubeTable};

/// The drillstring that the file describes.
///
/// # Errors
/// Where a number of it is refused.
pub fn resolve(source: &Source, content: &FileContent) -> Result<Drillstring, SweepFileError> {
    let table = &content.string;
    let (modulus, density) = (table.shear_modulus_gpa, table.density_kg_m3);
    let modulus = source.within("string.shear_modulus_gpa", modulus, 0.1, 1e3, "GPa")?;
    let density = source.within("string.density_kg_m3", density, 100.0, 3e4, "kg/m³")?;
    let damping = table.torsional_damping_nms_rad_m;
    let axis = Axis::String(StringAxis::TorsionalDamping);
    source.check_axis("string.torsional_damping_nms_rad_m", axis, damping)?;
    let sections = (table.sections.iter().enumerate())
        .map(|(section, data)| self::section(source, section, data))
        .collect::<Result<_, _>>()?;
    let material = Material {
        shear_modulus: 1e9 * modulus,
        density,
    };
    let axis = Axis::String(StringAxis::LossFactor);
    source.check_axis("string.loss_factor", axis, table.loss_factor)?;
    let string = Drillstring::new(material, sections, damping)
        .and_then(|string| string.with_loss_factor(table.loss_factor))
        .map_err(|error| source.error(&key_of(&error), error.to_string()))?;
    length(source, &string)?;
    Ok(string)
}

/// Refuses a string of which nothing says what energy it loses: its damping in a motion may be left
/// out where its material or mud takes some.
///
/// # Errors
/// With the key that is missing.
pub fn check_damping(
    source: &Source,
    content: &FileContent,
    design: &Design,
) -> Result<(), SweepFileError> {
    let loses = content.string.loss_factor > 0.0
        || design
            .axes()
            .contains(&Axis::String(StringAxis::LossFactor))
        || mud_is_viscous(content, design);
    let of_bending = content
        .string
        .bending
        .map(|_| "string.bending.damping_ns_m2");
    let keys = [Some("string.torsional_damping_nms_rad_m"), of_bending];
    for key in keys.into_iter().flatten() {
        let message = "is missing; without it give `viscosity_cp` in [mud], or `loss_factor` in \
                       [string]";
        source.refuse_if(!loses && !source.gives_path(key), key, message)?;
    }
    Ok(())
}

/// Millimetres for metres show in the whole string, if not in a part.
fn length(source: &Source, string: &Drillstring) -> Result<(), SweepFileError> {
    if string.length() <= LONGEST_STRING {
        return Ok(());
    }
    let sections = string.sections().iter().enumerate();
    let parts = sections.flat_map(|(index, section)| {
        let parts = section.parts.iter().enumerate();
        parts.map(move |(part, tube)| (section.repeat as f64 * tube.length, index, part))
    });
    let (_, section, part) = parts
        .max_by(|one, other| one.0.total_cmp(&other.0))
        .unwrap_or_default();
    let message = format!(
        "the string is {} m long, more than {LONGEST_STRING} m; is this in another unit?",
        string.length()
    );
    let key = format!("string.sections[{section}].parts[{part}].length_m");
    Err(source.error(&key, message))
}

/// A section. A quantity that could be an axis too has one range for both.
fn section(
    source: &Source,
    section: usize,
    table: &SectionTable,
) -> Result<Section, SweepFileError> {
    let key = format!("string.sections[{section}]");
    let axis = Axis::String(StringAxis::Repeat { section });
    source.check_axis(&format!("{key}.repeat"), axis, table.repeat as f64)?;
    for (part, tube) in table.parts.iter().enumerate() {
        for measure in TubeMeasure::ALL {
            let axis = Axis::String(StringAxis::Tube {
                section,
                part,
                measure,
            });
            let key = format!("{key}.parts[{part}].{}", measure.key());
            source.check_axis(&key, axis, *tube.clone().measure(measure))?;
        }
        let key = format!("{key}.parts[{part}].contact_radius_m");
        contact_radius(source, &key, tube)?;
    }
    let tubes = table.parts.iter().map(|part| Tube {
        length: part.length_m,
        inner_radius: part.inner_radius_m,
        outer_radius: part.outer_radius_m,
    });
    Ok(Section {
        repeat: table.repeat,
        parts: tubes.collect(),
    })
}

/// What a part touches the wall with is no narrower than itself.
fn contact_radius(source: &Source, key: &str, tube: &TubeTable) -> Result<(), SweepFileError> {
    let Some(radius) = tube.contact_radius_m else {
        return Ok(());
    };
    // As wide as a string may be.
    let axis = Axis::String(StringAxis::Tube {
        section: 0,
        part: 0,
        measure: TubeMeasure::OuterRadius,
    });
    source.check_axis(key, axis, radius)?;
    let outer = tube.outer_radius_m;
    let message = format!("{radius} m is less than the external radius, {outer} m");
    source.refuse_if(radius < outer, key, message)
}

/// An axis of the string must have something to change.
///
/// # Errors
/// Names the first that has not.
pub fn check_axes(
    source: &Source,
    content: &FileContent,
    design: &Design,
) -> Result<(), SweepFileError> {
    for &axis in design.axes() {
        if let Axis::String(string_axis) = axis {
            let key = format!("design.axes.{}", axis.name());
            let changed = content.clone().set(string_axis, axis.most());
            source.checked(&key, changed)?;
        }
    }
    Ok(())
}

/// The key that an error about the string is about.
fn key_of(error: &DrillstringError) -> String {
    match error {
        DrillstringError::NoSections => "string.sections".to_owned(),
        DrillstringError::NoRepeat { section } => format!("string.sections[{section}].repeat"),
        DrillstringError::NoParts { section } => format!("string.sections[{section}].parts"),
        DrillstringError::Length { section, part, .. } => {
            format!("string.sections[{section}].parts[{part}].length_m")
        }
        DrillstringError::Radii { section, part, .. } => {
            format!("string.sections[{section}].parts[{part}].inner_radius_m")
        }
        _ => "string".to_owned(),
    }
}
