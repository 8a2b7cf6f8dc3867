//! `[axial_force]`: what pulls and pushes the string along its well.

use linear::bending_modes::{BendingModes, buckling_weight};
use linear::well::HangingString;
use linear::{BuildError, Drillstring, Mud};

use super::conditions::Conditions;
use super::data::Data;
use super::hole::survey_along;
use super::lateral::LateralSettings;
use crate::design::Design;
use crate::quantities::Axis;
use crate::sweep_file::{AxialForceTable, FileContent, Source, SweepFileError};

/// A string that hangs in its well.
#[derive(Debug, Clone, PartialEq)]
pub struct Hanging {
    /// Its weight, and where.
    pub string: HangingString,
    /// What natural frequencies in bending may be off by, as a part.
    pub tolerance: f64,
}

impl Hanging {
    /// The weight on bit, N, under which the string buckles; none where its own does that.
    ///
    /// # Errors
    /// Where it has too many elements.
    pub fn buckling_weight(
        &self,
        string: &Drillstring,
        lateral: &LateralSettings,
    ) -> Result<Option<f64>, BuildError> {
        let bends = (&lateral.bending, lateral.support);
        buckling_weight(string, &self.string, bends, self.tolerance)
    }
}

/// The string under its axial force, where the file asks for that.
///
/// # Errors
/// Where a key is refused, something needed is missing, or the string buckles.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    (data, mud): (&Data, Option<Mud>),
    (conditions, design): (&Conditions, &Design),
    string: Drillstring,
    lateral: Option<&LateralSettings>,
) -> Result<(Drillstring, Option<Hanging>), SweepFileError> {
    // A string that lies in its hole bends under its own tension.
    let of_lying = content.lies_on_low_side().then(AxialForceTable::default);
    let Some(table) = content.axial_force.or(of_lying) else {
        return Ok((string, None));
    };
    let is_asked = content.axial_force.is_some();
    let key = if is_asked { "axial_force" } else { "wall" };
    let Some(lateral) = lateral else {
        let message = "matters to a string that bends: needs a [wall]";
        return Err(source.error(key, message));
    };
    let is_known = conditions.has(Axis::WeightOnBitKn, design);
    let message = "the weight on bit is not known: needs that and a rock in [bit], or no [bit] for \
                   a string off bottom";
    let by_default = "the string lies on it under its weight (`lies_on_low_side = false` leaves it in the \
                      middle of its hole), and ";
    let message = match is_asked {
        true => message.to_owned(),
        false => format!("{by_default}{message}"),
    };
    source.refuse_if(content.bit.is_some() && !is_known, key, message)?;
    let tolerance = table.tolerance;
    source.within("axial_force.tolerance", tolerance, 1e-4, 0.1, "")?;
    let survey = survey_along(source, data, &string)?;
    let hanging = Hanging {
        string: HangingString::new(&string, survey, mud),
        tolerance,
    };
    let weight_on_bit = 1e3 * conditions.weight_on_bit_kn.unwrap_or(0.0);
    let bending = &lateral.bending;
    let force = (hanging.string).axial_force(bending, weight_on_bit, tolerance);
    let unloaded = string.clone();
    let string = source.checked(key, string.under_axial_force(force))?;
    if content.lies_on_low_side() {
        // Its wall holds it.
        return Ok((string, Some(hanging)));
    }
    let modes = BendingModes::new(&string, bending, lateral.support);
    if source.checked(key, modes)?.is_buckled() {
        let least = source.checked(key, hanging.buckling_weight(&unloaded, lateral))?;
        let message = match least {
            Some(least) => format!(
                "the string buckles under {} kN on the bit, as it does from {:.1} kN on: nothing \
                 brings it back to where it hangs",
                1e-3 * weight_on_bit,
                1e-3 * least
            ),
            None => "the string buckles by its own weight and compression".to_owned(),
        };
        return Err(source.error(key, message));
    }
    Ok((string, Some(hanging)))
}
