//! `start`: the motion that a case begins with, which may decide whether the bit sticks and slips.
//!
//! Asked of a map is whether stick-slip can last. So a case begins as one does in which the bit
//! has just been held, unless its file says otherwise: the string winds up steadily, the torque on
//! the bit has reached T_s, and it breaks loose.

use linear::steady::{rotation, rotation_speed, winding};
use sim::{BitTorque, MudMotor, Start};

use super::lying::LyingStart;
use super::setting::Setting;
use crate::sweep_file::{FileContent, Source, StartName, SweepFileError};

/// The step of the torque on a bit that turns smoothly, as a part of that torque.
const DISTURBANCE: f64 = 0.01;

/// A bit that breaks loose in the first step has this part more than T_s on it, so that no rounding
/// holds it for a step more.
const MORE_THAN_HELD: f64 = 1e-9;

/// How the cases of a sweep begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Starts {
    /// As the file says, or by default.
    pub name: StartName,
    /// By what part of itself the torque on a smoothly turning bit rises at t = 0.
    pub disturbance: f64,
}

/// The start of a file: what it says, or that of a bit which has just been held.
///
/// # Errors
/// Where it does not suit the rest of the file.
pub fn resolve(source: &Source, content: &FileContent) -> Result<Starts, SweepFileError> {
    let cuts = content.has_cutting();
    let name = match (content.start, rest_only(content)) {
        (None, None) if cuts || content.bit.is_none() || content.motor.is_some() => StartName::Ramp,
        (None, None) if !source.gives("surface_speed_rise_s") => StartName::Stuck,
        (None, _) => StartName::Ramp,
        (Some(name), why) => {
            check(source, content, name, why)?;
            name
        }
    };
    let is_disturbed = matches!(name, StartName::Smooth | StartName::Both) && content.bit.is_some();
    let disturbance = match content.start_disturbance {
        None => DISTURBANCE,
        Some(part) => {
            let key = "start_disturbance";
            let message = "is the step of torque of a smooth start: it needs `start = \"smooth\"` \
                           or `\"both\"`";
            let part = source.within(key, part, 0.0, 1.0, "")?;
            source.refuse_if(!is_disturbed, key, message)?;
            part
        }
    };
    Ok(Starts { name, disturbance })
}

/// Why the cases of a file can begin at rest only, if so.
fn rest_only(content: &FileContent) -> Option<&'static str> {
    if content.bit.is_none() && !content.lies_on_low_side() {
        return Some("needs a table [bit]: without a torque on the bit there is no other start");
    }
    if content.string_friction.is_some() {
        return Some("with [string_friction] a case begins at rest: only `\"ramp\"` is possible");
    }
    if content.surface_speed_file.is_some() {
        return Some("the surface turns as it was recorded: only `\"ramp\"` is possible");
    }
    if !content.compare.is_empty() {
        return Some("what is compared with a recording begins as that does: use `\"ramp\"`");
    }
    None
}

fn check(
    source: &Source,
    content: &FileContent,
    name: StartName,
    rest_only: Option<&str>,
) -> Result<(), SweepFileError> {
    if name == StartName::Ramp {
        return Ok(());
    }
    if let Some(message) = rest_only {
        return Err(source.error("start", message));
    }
    let cuts = content.has_cutting();
    let message = "with [bit.cutting] a case begins at rest, `\"ramp\"`, or drilling steadily, \
                   `\"smooth\"`";
    source.refuse_if(cuts && name != StartName::Smooth, "start", message)?;
    let message = format!(
        "a case that begins {} does not wait for the surface: leave it out, or write \
         `start = \"ramp\"`",
        match name {
            StartName::Smooth | StartName::Turning => "in smooth rotation",
            _ => "with the bit held",
        }
    );
    let rises = content.surface_speed_rise_s != 0.0;
    source.refuse_if(rises, "surface_speed_rise_s", message)?;
    let lies = content.lies_on_low_side();
    let message = "is how a string begins that lies in its hole: needs `well.survey` or \
                   `well.inclination_deg`, and a [wall]";
    source.refuse_if(name == StartName::Turning && !lies, "start", message)?;
    let message = "holds a bit: needs a table [bit]";
    let is_held = matches!(name, StartName::Stuck | StartName::Both);
    source.refuse_if(is_held && content.bit.is_none(), "start", message)?;
    let message = "a [motor] turns its bit against the string, which does not wind up evenly where that is \
                   held: use `\"ramp\"` or `\"smooth\"`";
    source.refuse_if(is_held && content.motor.is_some(), "start", message)?;
    let has_wall = content.wall.is_some();
    let message = "with a [wall] a case begins one way: `\"stuck\"`, `\"smooth\"` or `\"ramp\"`";
    source.refuse_if(name == StartName::Both && has_wall, "start", message)
}

impl Starts {
    /// The motion that a case of a setting begins with, at a surface speed (rad/s): of both, the
    /// one with the bit held.
    pub fn first(&self, setting: &Setting, surface_speed: f64, bit: Option<&BitTorque>) -> Start {
        let (string, sites) = (&setting.string, &setting.sites);
        let lies = setting.lying.is_some();
        match (self.name, bit) {
            (StartName::Ramp, _) => Start::Rest,
            (StartName::Smooth | StartName::Turning, None) if lies => {
                Start::Steady(rotation(string, sites, surface_speed, 0.0))
            }
            (_, None) => Start::Rest,
            (StartName::Smooth | StartName::Turning, Some(bit)) => {
                self.smooth(setting, surface_speed, bit)
            }
            (StartName::Stuck | StartName::Both, Some(bit)) => {
                let torque = (1.0 + MORE_THAN_HELD) * bit.torque_static;
                Start::Steady(winding(string, sites, surface_speed, torque))
            }
        }
    }

    /// The other one of both.
    pub fn second(
        &self,
        setting: &Setting,
        surface_speed: f64,
        bit: Option<&BitTorque>,
    ) -> Option<Start> {
        let bit = bit.filter(|_| self.name == StartName::Both)?;
        Some(self.smooth(setting, surface_speed, bit))
    }

    /// The start that may lead to another label: smooth rotation, or that of a bit which has been
    /// held; `None` where cases begin both ways, or can begin at rest only.
    pub fn otherwise(&self, content: &FileContent) -> Option<Self> {
        let name = match self.name {
            _ if rest_only(content).is_some() => return None,
            StartName::Both => return None,
            // What cuts begins at rest or steadily.
            _ if content.has_cutting() => {
                return None;
            }
            StartName::Stuck => StartName::Smooth,
            // Without a bit nothing sticks, and below a motor none is held evenly.
            _ if content.bit.is_none() || content.motor.is_some() => return None,
            StartName::Smooth | StartName::Turning | StartName::Ramp => StartName::Stuck,
        };
        Some(Self { name, ..*self })
    }

    /// How a string that lies in its hole finds its walls, its surface turning so in the end, rad/s.
    pub fn lying(&self, surface_speed: f64) -> LyingStart {
        match self.name {
            StartName::Smooth => LyingStart::Sliding(surface_speed),
            _ => LyingStart::AtRest,
        }
    }

    fn smooth(&self, setting: &Setting, surface_speed: f64, bit: &BitTorque) -> Start {
        let string = &setting.string;
        let torque = steady_torque(setting, surface_speed, bit);
        let before = (1.0 - self.disturbance) * torque;
        Start::Steady(rotation(string, &setting.sites, surface_speed, before))
    }
}

/// Torque (N m) against a bit that rotates with its string, below a motor faster by its chart.
fn steady_torque(setting: &Setting, surface_speed: f64, bit: &BitTorque) -> f64 {
    let speed = rotation_speed(&setting.string, surface_speed, bit.torque_dynamic);
    let faster = |motor: &MudMotor| motor.relative_speed(bit.torque_dynamic);
    bit.torque_at((speed + setting.motor.as_ref().map_or(0.0, faster)).abs())
}
