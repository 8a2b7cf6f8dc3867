//! `[map]`: the axes of the regime map and the cases pointed out on it.

use serde::{Deserialize, Serialize};

use super::bit::Bit;
use super::setting::Setting;
use crate::design::Design;
use crate::quantities::Axis;
use crate::records::{Measure, Needs};
use crate::sweep_file::{FileContent, MarkTable, Source, SweepFileError};

/// How the regime map is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapSettings {
    /// Axis to the right.
    pub x: Axis,
    /// Axis upwards.
    pub y: Axis,
    /// A measure drawn as colour, on separate maps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub colour: Option<Measure>,
    /// Cases pointed out.
    pub marks: Vec<MapMark>,
}

/// A case pointed out on the map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapMark {
    /// What is written next to it.
    pub name: String,
    /// Its value along the axis to the right.
    pub x: f64,
    /// Its value along the axis upwards.
    pub y: f64,
}

/// The map of a design with two axes or more.
///
/// # Errors
/// Where an axis does not belong to the design, or a mark has no place.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    design: &Design,
    setting: &Setting,
    bit: Option<&Bit>,
) -> Result<Option<MapSettings>, SweepFileError> {
    for (key, axis) in [("map.x", content.map.x), ("map.y", content.map.y)] {
        if let Some(axis) = axis {
            let message = format!("{} is not an axis of the design", axis.name());
            source.refuse_if(!design.axes().contains(&axis), key, message)?;
        }
    }
    let other = |taken: Option<Axis>| {
        // Operating conditions before quantities of the string.
        let mut axes = design.axes().to_vec();
        axes.sort_by_key(|axis| (axis.is_of_string(), *axis));
        axes.into_iter().find(|axis| Some(*axis) != taken)
    };
    let y = content.map.y.or_else(|| other(content.map.x));
    let x = content.map.x.or_else(|| other(y));
    let Some((x, y)) = x.zip(y) else {
        return Ok(None);
    };
    source.refuse_if(x == y, "map.x", "is the axis upwards too")?;
    let marks = (content.map.marks.iter().enumerate())
        .map(|(index, mark)| self::mark(source, index, mark, (x, y), bit))
        .collect::<Result<_, _>>()?;
    let colour = content.map.colour;
    if let Some(measure) = colour {
        is_measured(source, content, setting, measure)?;
    }
    Ok(Some(MapSettings {
        x,
        y,
        colour,
        marks,
    }))
}

/// Refuses a measure of what is not modelled.
fn is_measured(
    source: &Source,
    content: &FileContent,
    setting: &Setting,
    measure: Measure,
) -> Result<(), SweepFileError> {
    let friction = content.string_friction.as_ref();
    let Some(needs) = measure.needs() else {
        return Ok(());
    };
    let (is_there, what) = match needs {
        Needs::Bit => (content.bit.is_some(), "a torque at the bit: `[bit]`"),
        Needs::Wall => (setting.lateral.is_some(), "a wall: `[wall]`"),
        Needs::Cutting => (
            setting.cutting.is_some(),
            "a bit that cuts: `[bit.cutting]`",
        ),
        Needs::Lying => (
            setting.lying.is_some(),
            "a string that lies in its hole: `well.survey` or `well.inclination_deg`, and `[wall]`",
        ),
        Needs::Shocks => (
            setting
                .lateral
                .as_ref()
                .is_some_and(|it| it.shocks.is_some()),
            "accelerations: `[wall] shock_g` or `[[tools]]`",
        ),
        Needs::Stress => (
            content.measures_stress(),
            "bending and stress: `[wall] stress_every_m`",
        ),
        Needs::Motor => (content.motor.is_some(), "a mud motor: `[motor]`"),
        Needs::SurfaceTorque => (
            content.surface_torque || content.follows_surface(),
            "the torque at the surface: `surface_torque = true`",
        ),
        Needs::StringTorque => (
            friction.is_some_and(|table| table.torque_along_string),
            "the torque along the string: `[string_friction] torque_along_string = true`",
        ),
    };
    let message = format!("{} needs {what}", measure.column());
    source.refuse_if(!is_there, "map.colour", message)
}

fn mark(
    source: &Source,
    index: usize,
    mark: &MarkTable,
    (x, y): (Axis, Axis),
    bit: Option<&Bit>,
) -> Result<MapMark, SweepFileError> {
    let given = [
        (Axis::SurfaceSpeedRpm, mark.surface_speed_rpm),
        (Axis::WeightOnBitKn, mark.weight_on_bit_kn),
        (Axis::TorqueDynamicNm, mark.torque_dynamic_nm),
        (Axis::ImpulseRatio, mark.impulse_ratio),
        (Axis::FRICTION, mark.friction),
    ];
    for (axis, value) in given {
        if let Some(value) = value {
            let key = format!("map.marks[{index}].{}", axis.name());
            source.check_axis(&key, axis, value)?;
        }
    }
    let key = format!("map.marks[{index}]");
    let rock = bit.and_then(|bit| bit.rock.as_ref());
    let value = |axis: Axis| {
        let Some((_, value)) = given.iter().find(|(given, _)| *given == axis) else {
            let name = axis.name();
            let message = format!("a mark has no place on a map over {name}: leave it out");
            return Err(source.error(&key, message));
        };
        match (*value, axis, mark.torque_dynamic_nm, rock) {
            (Some(value), ..) => Ok(value),
            (None, Axis::WeightOnBitKn, Some(torque), Some(rock)) => {
                let weight = rock.weight_on_bit(torque);
                Ok(1e-3 * source.checked(&format!("{key}.torque_dynamic_nm"), weight)?)
            }
            _ => Err(source.error(&key, format!("does not say its {}", axis.name()))),
        }
    };
    Ok(MapMark {
        name: mark.name.clone(),
        x: value(x)?,
        y: value(y)?,
    })
}
