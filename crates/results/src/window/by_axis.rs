//! What is known along both axes, in documents by the names of these.

use serde::{Serialize, Serializer};

use super::simulated::AXES;

/// Writes a value for each axis under its name.
///
/// # Errors
/// Those of the serializer.
pub fn by_axis<T: Serialize, S: Serializer>(
    values: &[T; 2],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let named = AXES.iter().zip(values);
    serializer.collect_map(named.map(|(axis, value)| (axis.name(), value)))
}
