//! What pulls and pushes the string, in words and numbers.

use linear::BuildError;

use super::description::row;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, LENGTH};

/// The axial force along the string, where it is modelled.
///
/// # Errors
/// Where the string has too many elements.
pub fn describe_axial_force(sweep: &Sweep) -> Result<String, BuildError> {
    let setting = &sweep.setting;
    let (Some(hanging), Some(lateral)) = (&setting.hanging, &setting.lateral) else {
        return Ok(String::new());
    };
    let units = sweep.content.units;
    let (force, length) = (units.of(&FORCE), units.of(&LENGTH));
    let on_bit = force.text(sweep.conditions.weight_on_bit_kn.unwrap_or(0.0), 1);
    let buckles = match hanging.buckling_weight(&setting.string, lateral)? {
        Some(weight) => format!("from {} on the bit on", force.text(1e-3 * weight, 1)),
        None => "under its own weight".to_owned(),
    };
    let weight = force.text(1e-3 * hanging.string.weight(), 1);
    let pieces = setting.string.axial_force();
    let pushed = pieces.iter().filter(|piece| piece.tension < 0.0);
    let compressed = pushed.fold(0.0, |length, piece| length + piece.length);
    let rows = [
        (
            "weight along the well",
            format!("{weight}, of which {on_bit} on the bit"),
        ),
        (
            "under compression",
            format!("{} above the bit", length.text(compressed, 1)),
        ),
        ("buckles", buckles),
        ("pieces of constant force", pieces.len().to_string()),
    ];
    let lines = rows.iter().map(|(title, value)| row(2, title, value));
    Ok("\naxial force\n".to_owned() + &lines.collect::<String>())
}
