//! `saturates` of `[top_drive]`: a drive that gives no more than its greatest torque.

use crate::sweep_file::{ControllerName, FileContent, MethodName, Source, SweepFileError};

/// The greatest torque (N m) of the drive of a file, where that is a law of its motion.
///
/// # Errors
/// Where it has no such number, or something else in the file does not go with it.
pub fn resolve(source: &Source, content: &FileContent) -> Result<Option<f64>, SweepFileError> {
    let Some(drive) = content.top_drive.filter(|drive| drive.saturates) else {
        return Ok(None);
    };
    let key = "top_drive.saturates";
    let message = "needs `torque_limit_kn_m`, the most torque that the drive gives";
    let limit = drive
        .torque_limit_kn_m
        .ok_or_else(|| source.error(key, message))?;
    let refusals = [
        (
            key,
            drive.controller == ControllerName::Prescribed,
            "is of a drive with a controller: a surface that turns as prescribed is turned by any torque",
        ),
        (
            "top_drive.delay_ms",
            drive.delay_ms > 0.0,
            "a drive whose torque is limited answers at once: leave out the delay, or `saturates`",
        ),
        (
            key,
            content.bit.is_none() && content.wall.is_none() && content.string_friction.is_none(),
            "needs a torque on the string: [bit], [wall] or [string_friction]",
        ),
        (
            "accuracy",
            content.accuracy.is_some(),
            "nothing is known of the error below a drive whose torque is limited: give `methods` and \
             `sampling_frequency_hz` instead",
        ),
        (
            "certify",
            content.certify,
            "a label is certain far from its limit, and below a drive whose torque is limited none is \
             known: leave it out",
        ),
    ];
    for (key, is_wrong, message) in refusals {
        source.refuse_if(is_wrong, key, message)?;
    }
    check_methods(source, content)?;
    Ok(Some(1e3 * limit))
}

/// Refuses methods in which nothing is integrated step by step.
fn check_methods(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let is_of_frequencies =
        |name: &&MethodName| matches!(**name, MethodName::Hilbert | MethodName::DirectIdft);
    let found = content.methods.iter().find(is_of_frequencies);
    found.map_or(Ok(()), |name| {
        let message = format!(
            "`{}` has no drive whose torque is limited: write `held`, `quadrature` or \
             `finite-element`",
            name.name()
        );
        Err(source.error("methods", message))
    })
}
