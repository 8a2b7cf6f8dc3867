//! The whole string as it is reconstructed between its sites.
//!
//! The forces of a motion are by how much those at the sites differ from what holds the string at rest;
//! one that lies in its hole moves about where it lies. Where springs hold its linear part, what takes
//! them back is among these forces, unless elements were stepped, which need none.

use linear::Method;
use linear::elements::reconstruction::{Reconstruction, WholeString};
use sim::Trajectory;

use super::case::Case;
use super::case_error::CaseError;
use super::stepped::stepped_by;
use crate::plan::{Setting, Sweep};

/// The whole string of a setting that bends, as it is reconstructed.
pub fn whole_string<'a>(sweep: &Sweep, setting: &'a Setting) -> Option<WholeString<'a>> {
    let lateral = setting.lateral.as_ref()?;
    Some(WholeString {
        string: &setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &setting.sites,
        sampling_frequency: setting.sampling_frequency,
        parameters: sweep.content.method.finite_element,
    })
}

/// The whole string of a case, where it bends, as it moved by a method: with its shapes in these steps,
/// in rising order.
///
/// # Errors
/// Where finite elements cannot treat the string.
pub fn reconstructed(
    sweep: &Sweep,
    (setting, case): (&Setting, &Case),
    (method, motion): (&Method, &Trajectory),
    snapshots: &[usize],
) -> Result<Option<Reconstruction>, CaseError> {
    let Some(whole) = whole_string(sweep, setting) else {
        return Ok(None);
    };
    let free = setting.sites.without_springs();
    let whole = match stepped_by(setting, method) {
        Some(_) => WholeString {
            sites: &free,
            ..whole
        },
        None => whole,
    };
    let lying = case.lying(setting)?;
    let resting = |from_bit: f64| {
        let place = lying.as_ref().map(|state| state.at(from_bit));
        place.map_or([0.0; 2], |place| place.displacement)
    };
    let found = whole.reconstruct_about(&resting, &motion.forces, snapshots);
    found
        .map(Some)
        .map_err(|error| CaseError::Responses(error.into()))
}
