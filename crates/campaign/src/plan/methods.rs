//! `methods` and `[method]`: the linear methods, their parameters checked.

use linear::method::{FiniteElement, Method};
use linear::sampling::merged;
use linear::{BuildError, Channel, Drillstring, PolePlan};

use super::setting::Setting;
use crate::design::Design;
use crate::quantities::{Axis, StringAxis};
use crate::sweep_file::{FileContent, MethodName, Source, SweepFileError};

/// More elements in a cell resolve no more than rounding leaves.
const MOST_ELEMENTS_PER_CELL: usize = 10_000;

/// Elements by default in a cell of the drillpipe, as in the paper, and the longest cell, m, of
/// that number: plain pipe that is one part has as many as if it were cut.
const ELEMENTS_OF_CELL: f64 = 20.0;
const LONGEST_CELL: f64 = 12.0;

/// Elements per cell of the drillpipe as the file divides it, where it does not give them: of the
/// length that they have in a cell of the string, however its lengths are divided.
pub fn usual_elements(string: &Drillstring) -> usize {
    let given = string.drillpipe().cell_length();
    let whole = merged(string).map_or(given, |whole| whole.drillpipe().cell_length());
    let length = whole.min(LONGEST_CELL) / ELEMENTS_OF_CELL;
    // A cell that was cut and put together is as long up to rounding.
    let elements = (given / length - 1e-4).ceil().max(1.0);
    (elements as usize).min(MOST_ELEMENTS_PER_CELL)
}

/// Newmark's γ of elements above a bit that cuts: with the usual 0.52 elements damp a resonance of 10 Hz by some
/// hundredths a second, as much as rock feeds it, and steady drilling lasts in rock up to a third too
/// hard. A bit that sticks does not chatter with it.
const GAMMA_ABOVE_CUTTING: f64 = 0.502;

/// Newmark's γ of elements that a file which says nothing of it has. Walls need more than a bit that cuts.
pub fn usual_gamma(content: &FileContent) -> f64 {
    match content.has_cutting() && content.wall.is_none() {
        true => GAMMA_ABOVE_CUTTING,
        false => FiniteElement::default().gamma,
    }
}

/// The most sites of a string that lies which bends by responses where a file names no method; with more
/// it does by poles. Up to here a step costs about the same.
const SITES_BY_RESPONSES: usize = 12;

/// Whether a string bends by poles where a file names no method.
pub fn is_by_poles(content: &FileContent, design: &Design, setting: &Setting) -> bool {
    let Some(lateral) = &setting.lateral else {
        return false;
    };
    // `accuracy` and `certify` choose methods themselves; of strings that rub all along nothing was measured.
    let is_plain =
        content.accuracy.is_none() && !content.certify && content.string_friction.is_none();
    let (sites, frequency) = (&setting.sites, setting.sampling_frequency);
    let bends = (&lateral.bending, lateral.support);
    is_plain
        && setting.lying.is_some()
        && sites.len() > SITES_BY_RESPONSES
        && losses(content, design, Channel::Bending)
            .iter()
            .any(|loss| loss.ends[0] > 0.0)
        && PolePlan::new(&setting.string, bends, sites, frequency).is_ok()
}

/// A cause by which the string loses energy, by how strong it is.
struct Loss {
    /// The strength in the file's own string.
    own: f64,
    /// The least and the greatest of all cases.
    ends: [f64; 2],
}

/// The losses of a motion of the string: its damping as a whole, that of its mud, and that of its material.
fn losses(content: &FileContent, design: &Design, channel: Channel) -> [Loss; 3] {
    let string = &content.string;
    let (axis, as_a_whole) = match channel {
        Channel::Bending => {
            let damping = string.bending.map_or(0.0, |bending| bending.damping_ns_m2);
            (StringAxis::BendingDamping, damping)
        }
        Channel::Torsion | Channel::Axial => (
            StringAxis::TorsionalDamping,
            string.torsional_damping_nms_rad_m,
        ),
    };
    [
        (axis, as_a_whole),
        (
            StringAxis::MudViscosity,
            content.mud.map_or(0.0, |mud| mud.viscosity_cp),
        ),
        (StringAxis::LossFactor, string.loss_factor),
    ]
    .map(|(axis, own)| Loss {
        own,
        ends: design.ends(Axis::String(axis)).unwrap_or([own; 2]),
    })
}

/// The methods. Parameters of the others are checked too: finite elements draw the whole string for
/// every method, and all of the file is read back.
///
/// # Errors
/// Where one is refused.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    design: &Design,
) -> Result<Vec<Method>, SweepFileError> {
    source.refuse_if(content.methods.is_empty(), "methods", "names no method")?;
    finite_element(source, &content.method.finite_element)?;
    for (name, transform) in [
        (MethodName::Hilbert, content.method.hilbert),
        (MethodName::DirectIdft, content.method.direct_idft),
    ] {
        if let Some(seconds) = transform.seconds {
            let key = format!("method.{}.transform_s", name.name());
            source.within(&key, seconds, 1e-2, 1e5, "s")?;
        }
    }
    for (index, name) in content.methods.iter().enumerate() {
        let is_double = content.methods[..index].contains(name);
        source.refuse_if(is_double, &format!("methods[{index}]"), "is named twice")?;
        let bends = content.wall.is_some();
        let message =
            "`poles` are those of a string that bends, and there is no [wall]: take `held`";
        let is_idle = *name == MethodName::Poles && !bends;
        source.refuse_if(is_idle, &format!("methods[{index}]"), message)?;
        let is_transformed = matches!(name, MethodName::Hilbert | MethodName::DirectIdft);
        let is_by_poles = *name == MethodName::Poles;
        for (channel, is_asked, key) in [
            (
                Channel::Torsion,
                is_transformed,
                "string.torsional_damping_nms_rad_m",
            ),
            (
                Channel::Bending,
                bends && (is_transformed || is_by_poles),
                "string.bending.damping_ns_m2",
            ),
        ] {
            let losses = losses(content, design, channel);
            // As a whole a string that bends loses nothing to its material; its poles fade.
            let counted = match channel == Channel::Bending && is_transformed {
                true => &losses[..2],
                false => &losses,
            };
            // The file's own string is built, too.
            let needs_damping = is_asked
                && (counted.iter().all(|loss| loss.own == 0.0)
                    || counted.iter().all(|loss| loss.ends[1] == 0.0));
            let method = name.name();
            let message = BuildError::NeedsDamping { method, channel }.to_string();
            source.refuse_if(needs_damping, key, message)?;
        }
    }
    let names = content.methods.iter();
    Ok(names.map(|&name| method(content, name)).collect())
}

fn finite_element(source: &Source, parameters: &FiniteElement) -> Result<(), SweepFileError> {
    parameters.check().map_err(|error| {
        let key = match &error {
            BuildError::Parameter { name, .. } => format!("method.finite-element.{name}"),
            _ => "method.finite-element".to_owned(),
        };
        source.error(&key, error.to_string())
    })?;
    let elements = parameters.elements_per_cell;
    let message = format!("{elements} are more than {MOST_ELEMENTS_PER_CELL}");
    let key = "method.finite-element.elements_per_cell";
    source.refuse_if(elements > MOST_ELEMENTS_PER_CELL, key, message)
}

/// A method with the parameters the file gives it.
fn method(content: &FileContent, name: MethodName) -> Method {
    match name {
        MethodName::Hilbert => Method::Hilbert(content.method.hilbert),
        MethodName::Held => Method::Held,
        MethodName::Quadrature => Method::Quadrature,
        MethodName::FiniteElement => Method::FiniteElement(content.method.finite_element),
        MethodName::Poles => Method::Poles,
        MethodName::DirectIdft => Method::DirectIdft(content.method.direct_idft),
        MethodName::Trapezoidal => Method::Trapezoidal,
    }
}

/// Makes a file name one method alone, with its parameters.
pub fn put(content: &mut FileContent, method: Method) {
    if let Method::FiniteElement(parameters) = method {
        content.method.finite_element = parameters;
    }
    content.methods = MethodName::of(&method).into_iter().collect();
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use linear::method::{FiniteElement, Method};

    use crate::plan::Sweep;
    use crate::sweep_file::SweepFileError;

    /// γ of elements in a shipped sweep with keys before it.
    fn gamma(base: &str, keys: &str) -> f64 {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
        let base = format!("base = \"{base}\"\nmethods = [\"finite-element\"]\n{keys}");
        let read = |path: &Path, _| match path.file_name().and_then(|name| name.to_str()) {
            Some("made_up.toml") => Ok(base.clone()),
            _ => std::fs::read_to_string(path),
        };
        let sweep = Sweep::read_from(&folder.join("made_up.toml"), &[], &read).unwrap();
        match sweep.methods[0] {
            Method::FiniteElement(FiniteElement { gamma, .. }) => gamma,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn elements_hardly_damp_above_a_bit_that_cuts_unless_a_file_says_so() {
        let usual = FiniteElement::default().gamma;
        assert_eq!(gamma("axial.toml", ""), super::GAMMA_ABOVE_CUTTING);
        let given = "method.finite-element.gamma = 0.53\n";
        assert_eq!(gamma("axial.toml", given), 0.53);
        assert_eq!(gamma("fig09.toml", ""), usual);
    }

    /// A string of 152 m that lies on the ends of its joints.
    const LYING: &str = r#"
[string]
shear_modulus_gpa = 79.3
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 0.2

[[string.sections]]
repeat = 16
parts = [
    { length_m = 9, inner_radius_m = 0.0543, outer_radius_m = 0.0635 },
    { length_m = 0.5, inner_radius_m = 0.0413, outer_radius_m = 0.0825 },
]

[string.bending]
youngs_modulus_gpa = 206
damping_ns_m2 = 20

[well]
inclination_deg = 60
hole_diameter_in = 8.5

[wall]
stiffness_gn_m15 = 1
friction = 0.3
clearance = "hole"
sites = "ends"
sites_to_m = 120

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { values = [60, 120] }
"#;

    const ON_LOW_SIDE: &str = "clearance = \"hole\"\nsites = \"ends\"\nsites_to_m = 120";

    fn read(text: &str) -> Result<Sweep, SweepFileError> {
        Sweep::read_from(Path::new("lying.toml"), &[], &|_, _| Ok(text.to_owned()))
    }

    fn methods(text: &str) -> Vec<Method> {
        read(text).unwrap().methods
    }

    #[test]
    fn a_string_that_lies_on_many_sites_bends_by_poles_where_all_of_its_sweep_can() {
        assert_eq!(methods(LYING), [Method::Poles]);
        for (from, to) in [
            ("damping_ns_m2 = 20", "damping_ns_m2 = 0"),
            (
                "[design.axes]",
                "[design.axes]\nbending_damping_ns_m2 = { values = [20, 0] }",
            ),
        ] {
            assert_eq!(methods(&LYING.replace(from, to)), [Method::Held], "{to}");
        }
        let lossy = "shear_modulus_gpa = 79.3\nloss_factor = 0.002";
        let lossy = LYING.replace("shear_modulus_gpa = 79.3", lossy);
        let lossy = lossy.replace("damping_ns_m2 = 20", "damping_ns_m2 = 0");
        assert_eq!(methods(&lossy), [Method::Poles]);
    }

    /// Damping that is an axis counts by its values: where one is enough the others are set aside as cases.
    #[test]
    fn methods_that_need_damping_are_refused_where_no_case_has_any() {
        let keys = [
            ("torsional_damping_nms_rad_m", "0.2"),
            ("damping_ns_m2", "20"),
        ];
        for (method, key, needs) in [
            ("hilbert", 0, true),
            ("hilbert", 1, true),
            ("poles", 0, false),
            ("poles", 1, true),
            ("held", 0, false),
            ("held", 1, false),
        ] {
            let (name, own) = keys[key];
            let axis = ["torsional_damping_nms_rad_m", "bending_damping_ns_m2"][key];
            for (own, values, is_enough) in [
                (own, "[0, 20]", true),
                (own, "[0]", false),
                ("0", "[10, 20]", false),
            ] {
                let text =
                    format!("methods = [{method:?}]\n{LYING}{axis} = {{ values = {values} }}\n");
                let given = format!("{name} = {}", keys[key].1);
                let text = text.replace(
                    ON_LOW_SIDE,
                    "clearance_mm = 50\n[[sites]]\ndistance_from_bit_m = 9",
                );
                let text = text.replace("inclination_deg = 60\n", "");
                let text = text.replacen(&given, &format!("{name} = {own}"), 1);
                let refused = read(&text).err();
                let is_right = match (needs && !is_enough, &refused) {
                    (true, Some(error)) => error.to_string().contains("needs damping in"),
                    (false, None) => true,
                    _ => false,
                };
                assert!(is_right, "{method} {name} {own} {values}: {refused:?}");
            }
        }
    }
}
