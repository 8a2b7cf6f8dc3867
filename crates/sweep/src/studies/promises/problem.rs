//! A string drawn at random, and what is asked of it.

use std::io::{Error, ErrorKind};
use std::path::Path;

use anyhow::Result;
use clap::ValueEnum;
use linear::deviation::exact_undershoot;
use linear::estimates::stick_slip_speed_limit;

use super::draw::Draw;
use crate::plan::{Sweep, to_rpm};
use crate::quantities::Axis;

/// Which limit is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Motion {
    /// The surface speed below which the bit sticks and slips
    StickSlip,
    /// The friction above which an impulse starts whirl
    Whirl,
}

impl Motion {
    /// All of them.
    pub const ALL: [Motion; 2] = [Motion::StickSlip, Motion::Whirl];

    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Motion::StickSlip => "stick_slip",
            Motion::Whirl => "whirl",
        }
    }

    /// What the limit is a value of.
    pub fn axis(self) -> Axis {
        match self {
            Motion::StickSlip => Axis::SurfaceSpeedRpm,
            Motion::Whirl => Axis::Friction,
        }
    }
}

/// Kinds of strings, in turn.
const SHAPES: [&str; 4] = ["uniform", "pipe-collar", "jointed", "three-sections"];

/// Shear modulus (Pa) and density (kg/m³) of steel.
const SHEAR_MODULUS: f64 = 80e9;
const DENSITY: f64 = 7840.0;

/// Dynamic torque at the bit, N m: limits in torsion are proportional to it.
pub const TORQUE: f64 = 4000.0;

/// A random string and scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Its number.
    pub number: usize,
    /// Which limit is looked for.
    pub motion: Motion,
    /// The kind of string.
    pub shape: &'static str,
    /// Length, m.
    pub length: f64,
    /// What damping takes of a wave from the surface to the bit: its amplitude is left at
    /// the exponential of minus this.
    pub loss: f64,
    /// Its sweep file, without the method.
    text: String,
}

/// A tube: length, inner and outer radius, m.
type Part = [f64; 3];

/// Equal cells.
struct Section {
    repeat: usize,
    parts: Vec<Part>,
}

impl Problem {
    /// The problem of a number.
    ///
    /// # Errors
    /// Where its string has no undershoot to guess a limit from.
    pub fn draw(motion: Motion, number: usize, seed: u64) -> Result<Self> {
        let stream = 2 * number as u64 + u64::from(motion == Motion::Whirl);
        let mut draw = Draw::new(seed, stream);
        let shape = number % SHAPES.len();
        let length = draw.log_between(100.0, 5000.0);
        let sections = sections(&mut draw, shape, length);
        let loss = draw.log_between(0.03, 0.7);
        let damping = loss / loss_of_one(&sections);
        let length = (sections.iter())
            .map(|section| {
                let parts = section.parts.iter().map(|part| part[0]);
                section.repeat as f64 * parts.sum::<f64>()
            })
            .sum();
        let string = string_text(&sections, damping);
        let text = match motion {
            Motion::StickSlip => stick_slip(&mut draw, &string)?,
            Motion::Whirl => format!("{}\n{string}", whirl(&mut draw)),
        };
        Ok(Self {
            number,
            motion,
            shape: SHAPES[shape],
            length,
            loss,
            text,
        })
    }

    /// Its sweep with a method, or an accuracy, in the first lines of its file.
    ///
    /// # Errors
    /// Where that is refused.
    pub fn sweep(&self, method: &str) -> Result<Sweep> {
        sweep_of(&format!("{method}{}", self.text))
    }
}

/// The sweep of a file that needs no other.
fn sweep_of(text: &str) -> Result<Sweep> {
    let name = Path::new("problem.toml");
    let read = |path: &Path, _| {
        let is_it = path == name;
        let text = is_it.then(|| text.to_owned());
        text.ok_or_else(|| Error::from(ErrorKind::NotFound))
    };
    Ok(Sweep::read_from(name, &[], &read)?)
}

fn tube(draw: &mut Draw, length: f64) -> Part {
    let outer = draw.between(0.06, 0.13);
    [length, outer * draw.between(0.3, 0.85), outer]
}

fn collar(draw: &mut Draw, length: f64) -> Part {
    let outer = draw.between(0.09, 0.16);
    [length, 0.04, outer]
}

fn sections(draw: &mut Draw, shape: usize, length: f64) -> Vec<Section> {
    let plain = |part: Part| Section {
        repeat: 1,
        parts: vec![part],
    };
    let collars = (draw.between(0.05, 0.3) * length).min(300.0);
    match shape {
        0 => vec![plain(tube(draw, length))],
        1 => vec![
            plain(tube(draw, length - collars)),
            plain(collar(draw, collars)),
        ],
        2 => {
            let cell = draw.between(8.0, 13.0);
            let joint = draw.between(0.3, 0.7);
            let pipe = tube(draw, cell - joint);
            let thicker = pipe[2] * draw.between(1.1, 1.4);
            vec![
                Section {
                    repeat: ((length - collars) / cell).ceil() as usize,
                    parts: vec![pipe, [joint, pipe[1], thicker]],
                },
                plain(collar(draw, collars)),
            ]
        }
        _ => {
            let middle = draw.between(0.1, 0.4) * (length - collars);
            vec![
                plain(tube(draw, length - collars - middle)),
                plain(tube(draw, middle)),
                plain(collar(draw, collars)),
            ]
        }
    }
}

/// What a damping of 1 N m s/rad per metre would take of a wave on its way.
fn loss_of_one(sections: &[Section]) -> f64 {
    let losses = sections.iter().flat_map(|section| {
        section.parts.iter().map(|[length, inner, outer]| {
            let polar = 0.5 * std::f64::consts::PI * (outer.powi(4) - inner.powi(4));
            let impedance = polar * (SHEAR_MODULUS * DENSITY).sqrt();
            section.repeat as f64 * length / (2.0 * impedance)
        })
    });
    losses.sum()
}

/// Two speeds about the limit that Eq. 74 has for the string.
fn stick_slip(draw: &mut Draw, string: &str) -> Result<String> {
    let ratio = draw.between(1.1, 1.5);
    let at = |speeds: &str| {
        format!(
            "[bit]\ntorque_dynamic_nm = {TORQUE}\ntorque_static_ratio = {ratio}\n\n[design]\n\
             kind = \"grid\"\n\n[design.axes]\nsurface_speed_rpm = {{ values = [{speeds}] }}\n\n\
             {string}"
        )
    };
    let undershoot = exact_undershoot(&sweep_of(&at("1.0"))?.setting.string)?;
    let limit = to_rpm(stick_slip_speed_limit(undershoot, ratio * TORQUE, TORQUE));
    Ok(at(&format!("{}, {}", 0.8 * limit, 1.6 * limit)))
}

fn whirl(draw: &mut Draw) -> String {
    let speed = draw.between(30.0, 150.0);
    let ratio = draw.between(1.5, 5.0);
    let clearance = draw.between(5.0, 30.0);
    format!(
        "surface_speed_rpm = {speed}\ntime_s = 10\n\n[wall]\nclearance_mm = {clearance}\n\
         stiffness_gn_m15 = 1\n\n[[sites]]\ndistance_from_bit_m = 0\n\n[[impulses]]\n\
         distance_from_bit_m = 0\nratio = {ratio}\n\n[design]\nkind = \"grid\"\n\n\
         [design.axes]\nfriction = {{ values = [0.9, 1.5] }}\n\n[string.bending]\n\
         youngs_modulus_gpa = 210\ndamping_ns_m2 = {}\n",
        draw.log_between(500.0, 5000.0)
    )
}

fn string_text(sections: &[Section], damping: f64) -> String {
    let mut text = format!(
        "[string]\nshear_modulus_gpa = {}\ndensity_kg_m3 = {DENSITY}\n\
         torsional_damping_nms_rad_m = {damping}\n",
        SHEAR_MODULUS / 1e9
    );
    for section in sections {
        text += &format!(
            "\n[[string.sections]]\nrepeat = {}\nparts = [\n",
            section.repeat
        );
        for [length, inner, outer] in &section.parts {
            text += &format!(
                "    {{ length_m = {length}, inner_radius_m = {inner}, outer_radius_m = {outer} }},\n"
            );
        }
        text += "]\n";
    }
    text
}
