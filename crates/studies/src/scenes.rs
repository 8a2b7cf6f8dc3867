//! The sweeps that are shipped, for studies: built in, so that an installed
//! program needs no file.

use std::io::{Error, ErrorKind};
use std::path::Path;

use campaign::plan::Sweep;
use campaign::sweep_file::{MethodName, SweepFileError};

/// Fig. 12 with a second site.
const TWO_SITES: &str = r#"base = "fig12.toml"
sites = [{ distance_from_bit_m = 10 }, { distance_from_bit_m = 0 }]
"#;

/// Fig. 8(b) on a uniform tube, in cells as long as those of the paper's string.
const UNIFORM_TUBE: &str = r#"base = "fig08b.toml"

[string]
sections = [{ repeat = 100, parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }] }]
"#;

/// Jointed pipe of 5 inches above collars of 6¾ inches; a third of a wave is lost on its way.
const JOINTED_COLLAR: &str = r#"base = "fig08b.toml"
start = "stuck"
time_s = "auto"

[string]
torsional_damping_nms_rad_m = 0.3
sections = [
    { repeat = 80, parts = [
        { length_m = 9.05, inner_radius_m = 0.0543, outer_radius_m = 0.0635 },
        { length_m = 0.45, inner_radius_m = 0.0413, outer_radius_m = 0.0842 },
    ] },
    { repeat = 16, parts = [{ length_m = 9.4, inner_radius_m = 0.0286, outer_radius_m = 0.0857 }] },
]
"#;

/// What takes energy from the strings of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Loss {
    /// One constant in torsion and one in bending, as in the paper.
    Constants,
    /// These, and viscous mud around a material with loss.
    Mud,
}

impl Loss {
    /// That of a command.
    pub fn in_mud(in_mud: bool) -> Self {
        if in_mud { Self::Mud } else { Self::Constants }
    }
}

/// A scene in mud, by the name of that file.
const IN_MUD: &str = "in_mud.toml";

/// The mud that the guide has for 5-inch pipe, in a hole that leaves the paper's collars 50 mm.
const MUD: &str = r#"
[string]
loss_factor = 0.001

[mud]
density_kg_m3 = 1200
viscosity_cp = 30

[well]
hole_diameter_mm = 400
"#;

/// The text of a shipped file.
fn text_of(path: &Path) -> Option<&'static str> {
    Some(match path.to_str()? {
        "two_sites.toml" => TWO_SITES,
        "uniform_tube.toml" => UNIFORM_TUBE,
        "jointed_collar.toml" => JOINTED_COLLAR,
        "academic.toml" => include_str!("../sweeps/academic.toml"),
        "fig08a.toml" => include_str!("../sweeps/fig08a.toml"),
        "fig08b.toml" => include_str!("../sweeps/fig08b.toml"),
        "fig10.toml" => include_str!("../sweeps/fig10.toml"),
        "fig12.toml" => include_str!("../sweeps/fig12.toml"),
        "fig16a.toml" => include_str!("../sweeps/fig16a.toml"),
        "contacts.toml" => include_str!("../sweeps/contacts.toml"),
        "contacts_12in.toml" => include_str!("../sweeps/contacts_12in.toml"),
        "bha_12in_lower.csv" => include_str!("../sweeps/bha_12in_lower.csv"),
        _ => return None,
    })
}

/// A shipped sweep by the name of its file.
///
/// # Errors
/// Where it is not among those built in.
pub fn shipped(name: &str) -> Result<Sweep, SweepFileError> {
    shipped_by(name, &[])
}

/// The same by what takes energy from its string.
///
/// # Errors
/// As [`shipped`].
pub fn shipped_with(name: &str, loss: Loss) -> Result<Sweep, SweepFileError> {
    if loss == Loss::Constants {
        return shipped(name);
    }
    let in_mud = format!("base = \"{name}\"\n{MUD}");
    Sweep::read_from(Path::new(IN_MUD), &[], &|path, _| {
        let is_scene = path == Path::new(IN_MUD);
        let text = text_of(path).map(str::to_owned);
        let text = if is_scene { Some(in_mud.clone()) } else { text };
        text.ok_or_else(|| Error::from(ErrorKind::NotFound))
    })
}

/// The same with these methods, if there are any, in place of the file's.
///
/// # Errors
/// As [`shipped`].
pub fn shipped_by(name: &str, methods: &[MethodName]) -> Result<Sweep, SweepFileError> {
    Sweep::read_from(Path::new(name), methods, &|path, _| {
        let text = text_of(path).map(str::to_owned);
        text.ok_or_else(|| Error::from(ErrorKind::NotFound))
    })
}
