//! What pulls and pushes the string, in words and numbers.

use linear::BuildError;
use serde::Serialize;

use super::rows::row;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, LENGTH, Units};

/// The axial force along a string.
#[derive(Serialize)]
pub struct InspectedForce {
    weight_along_well_kn: f64,
    weight_on_bit_kn: f64,
    /// Length under compression, above the bit.
    compressed_m: f64,
    /// The weight on the bit from which on the string buckles; none where it does so under its own.
    buckling_weight_on_bit_kn: Option<f64>,
    /// Pieces of constant force.
    pieces: usize,
    /// Whether its wall holds it where it would buckle.
    #[serde(skip)]
    lies: bool,
}

impl InspectedForce {
    /// That of a sweep, where it is modelled.
    ///
    /// # Errors
    /// Where the string has too many elements.
    pub fn of(sweep: &Sweep) -> Result<Option<Self>, BuildError> {
        let setting = &sweep.setting;
        let (Some(hanging), Some(lateral)) = (&setting.hanging, &setting.lateral) else {
            return Ok(None);
        };
        let buckling = hanging.buckling_weight(&setting.string, lateral)?;
        let pieces = setting.string.axial_force();
        let pushed = pieces.iter().filter(|piece| piece.tension < 0.0);
        Ok(Some(Self {
            weight_along_well_kn: 1e-3 * hanging.string.weight(),
            weight_on_bit_kn: sweep.conditions.weight_on_bit_kn.unwrap_or(0.0),
            compressed_m: pushed.fold(0.0, |length, piece| length + piece.length),
            buckling_weight_on_bit_kn: buckling.map(|weight| 1e-3 * weight),
            pieces: pieces.len(),
            lies: setting.lying.is_some(),
        }))
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let (force, length) = (units.of(&FORCE), units.of(&LENGTH));
        let on_bit = force.text(self.weight_on_bit_kn, 1);
        let weight = force.text(self.weight_along_well_kn, 1);
        let buckles = match self.buckling_weight_on_bit_kn {
            Some(weight) => format!("from {} on the bit on", force.text(weight, 1)),
            None => "under its own weight".to_owned(),
        };
        let without = match self.lies {
            true => "buckles without its wall",
            false => "buckles",
        };
        let rows = [
            (
                "weight along the well",
                format!("{weight}, of which {on_bit} on the bit"),
            ),
            (
                "under compression",
                format!("{} above the bit", length.text(self.compressed_m, 1)),
            ),
            (without, buckles),
            ("pieces of constant force", self.pieces.to_string()),
        ];
        let lines = rows.iter().map(|(title, value)| row(2, title, value));
        "\naxial force\n".to_owned() + &lines.collect::<String>()
    }
}
