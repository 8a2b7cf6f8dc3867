//! `certify`: which two of the methods make labels certain.

use crate::sweep_file::{FileContent, MethodName, Source, SweepFileError};

/// Two methods that share no equation, each passive on every string. `quadrature` is so too,
/// but overshoots at fronts as finite elements do, and they are wrong together more often.
const CERTIFYING: [MethodName; 2] = [MethodName::Held, MethodName::FiniteElement];

/// The places in the list of methods of the two that certify labels, where the file asks for
/// that.
///
/// # Errors
/// Where one is not there, or no limit is known to be far from.
pub fn resolve(
    source: &Source,
    content: &FileContent,
) -> Result<Option<[usize; 2]>, SweepFileError> {
    if !content.certify {
        return Ok(None);
    }
    let refuse = |is_wrong: bool, message: &str| source.refuse_if(is_wrong, "certify", message);
    refuse(
        content.string_friction.is_some(),
        "a label is certain far from its limit, and with friction along the string none is \
         known: leave it out",
    )?;
    refuse(
        content.has_cutting(),
        "a label is certain far from its limit, and with [bit.cutting] motion is often chaotic: \
         leave it out",
    )?;
    refuse(
        content.surface_speed_file.is_some(),
        "a label is certain far from its limit, and none is known for a surface speed that \
         changes: leave it out",
    )?;
    let place = |wanted: MethodName| {
        let place = content.methods.iter().position(|name| *name == wanted);
        place.ok_or_else(|| {
            let [one, other] = CERTIFYING.map(MethodName::name);
            let message = format!(
                "takes two methods that share no equation, `{one}` and `{other}`: `methods` \
                 lacks `{}`",
                wanted.name()
            );
            source.error("certify", message)
        })
    };
    let [one, other] = CERTIFYING.map(place);
    Ok(Some([one?, other?]))
}
