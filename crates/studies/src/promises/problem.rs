//! A string drawn at random, and what is asked of it.

use std::io::{Error, ErrorKind};
use std::path::Path;

use anyhow::Result;
use clap::ValueEnum;
use linear::deviation::exact_undershoot;
use linear::estimates::{first_mode, stick_slip_speed_limit, torsional_wave_left};
use linear::{Drillstring, Material, Section};
use sim::BitTorque;

use super::draw::{Draw, FAMILIES, FIELD, SHAPES, SURFACES, Shape, Sizes, Surface, WIDE, sections};
use super::surroundings::Surroundings;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::to_rpm;
use campaign::sweep_file::StartName;

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
            Motion::Whirl => Axis::FRICTION,
        }
    }
}

/// The motion that cases of stick-slip begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Begins {
    /// The bit held while the string winds up: the default of a sweep
    Stuck,
    /// Rest, the surface at its full speed at once
    Ramp,
}

impl Begins {
    /// The word in a sweep file.
    pub fn name(self) -> &'static str {
        match self {
            Begins::Stuck => StartName::Stuck.name(),
            Begins::Ramp => StartName::Ramp.name(),
        }
    }
}

/// What strings are made of.
const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

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
    /// What turns its surface.
    pub surface: &'static str,
    /// Length, m.
    pub length: f64,
    /// What damping takes of a wave from the surface to the bit: its amplitude is left at
    /// the exponential of minus this. Of a wave of the first mode where loss depends on frequency.
    pub loss: f64,
    /// What it is in, where loss depends on frequency.
    pub surroundings: Option<Surroundings>,
    /// What happens, the first part of its sweep file.
    scene: String,
    /// The string with what turns it, the other.
    text: String,
}

impl Problem {
    /// The problem of a number.
    ///
    /// # Errors
    /// Where its string is invalid, or has no undershoot to guess a limit from.
    pub fn draw(motion: Motion, number: usize, seed: u64) -> Result<Self> {
        let stream = 2 * number as u64 + u64::from(motion == Motion::Whirl);
        let mut draw = Draw::new(seed, stream);
        let shape = SHAPES[number % SHAPES.len()];
        let (string, loss) = string(&mut draw, shape, &WIDE, 5000.0)?;
        let scene = match motion {
            Motion::StickSlip => stick_slip(&mut draw, &string)?,
            Motion::Whirl => whirl(&mut draw),
        };
        Ok(Self {
            number,
            motion,
            shape: shape.name(),
            surface: Surface::Prescribed.name(),
            length: string.length(),
            loss,
            surroundings: None,
            scene,
            text: string_text(&string, 0.0),
        })
    }

    /// Stick-slip on a string of any family, of one half of them with the sizes of wells, and
    /// under a top drive on every other string of a family.
    ///
    /// # Errors
    /// As [`Problem::draw`].
    pub fn draw_family(number: usize, seed: u64, begins: Begins) -> Result<Self> {
        let mut draw = Draw::new(seed, FAMILY_STREAM + number as u64);
        let kind = Kind::of(number);
        let damped = string(&mut draw, kind.shape, &kind.sizes, 6000.0)?;
        Self::of_kind(&mut draw, &kind, damped, None, begins)
    }

    /// The same families in viscous mud, of a material with loss, and with little or no constant
    /// damping: as many are shorter than 1 km as remember echoes for many round trips.
    ///
    /// # Errors
    /// As [`Problem::draw`].
    pub fn draw_in_mud(number: usize, seed: u64, begins: Begins) -> Result<Self> {
        let mut draw = Draw::new(seed, IN_MUD_STREAM + number as u64);
        let kind = Kind::of(number);
        let length = draw.log_uniform(300.0, 6000.0);
        let sections = sections(&mut draw, kind.shape, &kind.sizes, length);
        let surroundings = Surroundings::draw(&mut draw, &sections);
        let has_none = draw.uniform(0.0, 1.0) < 0.5;
        let loss = match has_none {
            true => 0.0,
            false => draw.log_uniform(0.003, 0.1),
        };
        let damped = damped(sections, loss)?;
        Self::of_kind(&mut draw, &kind, damped, Some(surroundings), begins)
    }

    /// The same families for a bit that cuts, without a scene.
    ///
    /// # Errors
    /// Where the string is invalid.
    pub(super) fn draw_for_cutting(number: usize, seed: u64) -> Result<Self> {
        let mut draw = Draw::new(seed, CUTTING_STREAM + number as u64);
        let kind = Kind::of(number);
        let damped = string(&mut draw, kind.shape, &kind.sizes, 4000.0)?;
        Ok(Self::below_drive(&mut draw, &kind, damped, None))
    }

    /// Under the drive of a kind, with a limit to be looked for.
    fn of_kind(
        draw: &mut Draw,
        kind: &Kind,
        damped: (Drillstring, f64),
        surroundings: Option<Surroundings>,
        begins: Begins,
    ) -> Result<Self> {
        let mut problem = Self::below_drive(draw, kind, damped, surroundings);
        let ratio = draw.uniform(1.1, 1.5);
        // The drive moves the limit.
        let bare = "sampling_frequency_hz = 1000\nsurface_speed_rpm = 60\n";
        let string = problem.sweep(bare)?.setting.string;
        if surroundings.is_some() {
            problem.loss = -torsional_wave_left(&string).ln();
        }
        problem.scene = stick_slip_of(ratio, &string, begins)?;
        Ok(problem)
    }

    /// A string under the drive of a kind, without a scene.
    fn below_drive(
        draw: &mut Draw,
        kind: &Kind,
        (string, loss): (Drillstring, f64),
        surroundings: Option<Surroundings>,
    ) -> Self {
        let (drive, inertia) = match kind.surface {
            Surface::Prescribed => (None, 0.0),
            Surface::Stiff => (Some("stiff"), draw.uniform(500.0, 4000.0)),
            Surface::SoftTorque => {
                let times = draw.uniform(1.2, 4.0);
                (Some("soft-torque"), times * first_mode(&string).inertia)
            }
        };
        let drive = drive.map_or_else(String::new, |controller| {
            format!("[top_drive]\ninertia_kg_m2 = {inertia}\ncontroller = \"{controller}\"\n\n")
        });
        let (around, loss_factor) = match surroundings {
            None => (String::new(), 0.0),
            Some(surroundings) => (surroundings.text(), surroundings.loss_factor),
        };
        Self {
            number: kind.number,
            motion: Motion::StickSlip,
            shape: kind.shape.name(),
            surface: kind.surface.name(),
            length: string.length(),
            loss,
            surroundings,
            scene: String::new(),
            text: drive + &around + &string_text(&string, loss_factor),
        }
    }

    /// Its string below a bit whose torque falls with its speed, the surface at two speeds, rpm.
    pub(super) fn under_falling_torque(&self, bit: BitTorque, speeds: [f64; 2]) -> Self {
        let BitTorque {
            torque_static,
            torque_dynamic,
            decay_speed,
        } = bit;
        let (ratio, decay) = (torque_static / torque_dynamic, to_rpm(decay_speed));
        let scene = format!(
            "start = \"smooth\"\n\n[bit]\ntorque_dynamic_nm = {torque_dynamic}\n\
             torque_static_ratio = {ratio}\ntorque_decay_rpm = {decay}\n\n{}",
            at_speeds(speeds)
        );
        self.with_scene(scene)
    }

    /// Its string in another scene.
    pub(super) fn with_scene(&self, scene: String) -> Self {
        Self {
            scene,
            ..self.clone()
        }
    }

    /// Its sweep file with first lines.
    pub fn text(&self, first: &str) -> String {
        format!("{first}{}{}", self.scene, self.text)
    }

    /// Its sweep with a method, or an accuracy, in the first lines of its file.
    ///
    /// # Errors
    /// Where that is refused.
    pub fn sweep(&self, method: &str) -> Result<Sweep> {
        let name = Path::new("problem.toml");
        let text = self.text(method);
        // It names no other file.
        let read = |path: &Path, _| match path == name {
            true => Ok(text.clone()),
            false => Err(Error::from(ErrorKind::NotFound)),
        };
        Ok(Sweep::read_from(name, &[], &read)?)
    }
}

/// Random numbers of families, of those in mud, and of those whose bit cuts: no other problem has
/// these.
const FAMILY_STREAM: u64 = 1 << 33;
const IN_MUD_STREAM: u64 = 1 << 34;
const CUTTING_STREAM: u64 = 1 << 36;

/// Of which kind the string of a number is.
struct Kind {
    number: usize,
    shape: Shape,
    surface: Surface,
    sizes: Sizes,
}

impl Kind {
    fn of(number: usize) -> Self {
        let (round, shape) = (number / FAMILIES.len(), FAMILIES[number % FAMILIES.len()]);
        let (turn, surface) = (round / SURFACES.len(), SURFACES[round % SURFACES.len()]);
        let sizes = if turn % 2 == 0 { FIELD } else { WIDE };
        Self {
            number,
            shape,
            surface,
            sizes,
        }
    }
}

/// A string of some length up to the longest, m, and what damping takes of a wave.
fn string(
    draw: &mut Draw,
    shape: Shape,
    sizes: &Sizes,
    longest: f64,
) -> Result<(Drillstring, f64)> {
    let length = draw.log_uniform(100.0, longest);
    let sections = sections(draw, shape, sizes, length);
    damped(sections, draw.log_uniform(0.03, 0.7))
}

/// With the constant damping that takes this of a wave.
fn damped(sections: Vec<Section>, loss: f64) -> Result<(Drillstring, f64)> {
    let with_damping = |damping| Drillstring::new(STEEL, sections.clone(), damping);
    let loss_of_one = -torsional_wave_left(&with_damping(1.0)?).ln();
    Ok((with_damping(loss / loss_of_one)?, loss))
}

fn stick_slip(draw: &mut Draw, string: &Drillstring) -> Result<String> {
    stick_slip_of(draw.uniform(1.1, 1.5), string, Begins::Ramp)
}

/// Two speeds about the limit that Eq. 74 has for the string.
fn stick_slip_of(ratio: f64, string: &Drillstring, begins: Begins) -> Result<String> {
    let start = begins.name();
    let undershoot = exact_undershoot(string)?;
    let limit = to_rpm(stick_slip_speed_limit(undershoot, ratio * TORQUE, TORQUE));
    Ok(format!(
        "start = \"{start}\"\n\n[bit]\ntorque_dynamic_nm = {TORQUE}\ntorque_static_ratio = {ratio}\n\n{}",
        at_speeds([0.8 * limit, 1.6 * limit])
    ))
}

/// Cases at two surface speeds, rpm.
fn at_speeds([low, high]: [f64; 2]) -> String {
    format!(
        "[design]\nkind = \"grid\"\n\n[design.axes]\nsurface_speed_rpm = {{ values = [{low}, {high}] }}\n"
    )
}

fn whirl(draw: &mut Draw) -> String {
    let speed = draw.uniform(30.0, 150.0);
    let ratio = draw.uniform(1.5, 5.0);
    let clearance = draw.uniform(5.0, 30.0);
    format!(
        "surface_speed_rpm = {speed}\ntime_s = 10\n\n[wall]\nclearance_mm = {clearance}\n\
         stiffness_gn_m15 = 1\n\n[[sites]]\ndistance_from_bit_m = 0\n\n[[impulses]]\n\
         distance_from_bit_m = 0\nratio = {ratio}\n\n[design]\nkind = \"grid\"\n\n\
         [design.axes]\nfriction = {{ values = [0.9, 1.5] }}\n\n[string.bending]\n\
         youngs_modulus_gpa = 210\ndamping_ns_m2 = {}\n",
        draw.log_uniform(500.0, 5000.0)
    )
}

fn string_text(string: &Drillstring, loss_factor: f64) -> String {
    let material = string.material();
    let mut text = format!(
        "\n[string]\nshear_modulus_gpa = {}\ndensity_kg_m3 = {}\n\
         torsional_damping_nms_rad_m = {}\nloss_factor = {loss_factor}\n",
        material.shear_modulus / 1e9,
        material.density,
        string.torsional_damping(),
    );
    for section in string.sections() {
        text += &format!(
            "\n[[string.sections]]\nrepeat = {}\nparts = [\n",
            section.repeat
        );
        for part in &section.parts {
            text += &format!(
                "    {{ length_m = {}, inner_radius_m = {}, outer_radius_m = {} }},\n",
                part.length, part.inner_radius, part.outer_radius
            );
        }
        text += "]\n";
    }
    text
}
