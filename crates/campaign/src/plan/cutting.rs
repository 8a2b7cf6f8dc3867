//! `[bit.cutting]`, `[feed]` and `[string.axial]`: a bit whose blades cut what the ones before have
//! left, and the string along its axis.

use linear::estimates::torsional_resistance;
use linear::regenerative::SteadyCut;
use linear::steady::{rotation, rotation_speed};
use linear::{Axial, Drillstring, Hoist, Sites};
use sim::laws::rock::CuttingLaw;
use sim::{Blades, Cutting, FlatContact, Kick, MudMotor, Start, SurfaceProfile};

use super::conditions::Conditions;
use crate::random::Stream;
use crate::sweep_file::{
    ContactName, CuttingTable, FeedName, FeedTable, FileContent, MethodName, RockName, Source,
    StartName, SweepFileError,
};

/// Young's modulus of steel, GPa.
const STEEL: f64 = 210.0;

/// An hour, s.
const HOUR: f64 = 3600.0;

/// The most of a rock's strength that can be meant, as the depth of cut (m) that steady drilling is
/// looked for up to.
const DEEPEST_CUT: f64 = 1.0;

/// Halvings of that.
const HALVINGS: usize = 100;

/// A bit that cuts and the string along its axis, but for what axes may change.
#[derive(Debug, Clone, PartialEq)]
pub struct CuttingSettings {
    /// The string as a rod that stretches, below its hoist.
    pub rod: Drillstring,
    contact: FlatContact,
    blades: Blades,
    /// Tangent of the angle of relief.
    relief: f64,
    feed: Feed,
    /// How the surface reaches its speed along the axis.
    pub profile: SurfaceProfile,
    /// The disturbance of a steady start that the file gives.
    kick: Option<Kick>,
    /// How long any disturbance lasts, s.
    kick_time: f64,
}

/// What is set at the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Feed {
    /// The weight on bit, by a hoist of this damping, N s/m.
    HookLoad(f64),
    /// The speed.
    Speed,
}

/// Drilling at which nothing changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyDrilling {
    /// Of the bit, rad/s.
    pub speed: f64,
    /// Rate of penetration, m/s.
    pub rate: f64,
    /// N m.
    pub torque: f64,
    /// Weight on bit, N.
    pub weight: f64,
}

impl SteadyDrilling {
    /// As small motion about it feels the rock; `None` of uneven blades, whose delays differ.
    pub fn cut(&self, cutting: &Cutting) -> Option<SteadyCut> {
        let Blades::Even(_) = cutting.blades else {
            return None;
        };
        let advance = self.rate / self.speed;
        let apart = std::f64::consts::TAU / cutting.blades() as f64;
        let [torque, weight] = cutting.steady_stiffnesses(advance * apart);
        Some(SteadyCut {
            delay: apart / self.speed,
            advance,
            torque,
            weight,
        })
    }
}

/// The bit of a file that has `[bit.cutting]`.
///
/// # Errors
/// Where a key of it, of `[feed]` or of `[string.axial]` is refused.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
) -> Result<Option<CuttingSettings>, SweepFileError> {
    let Some(table) = content.bit.as_ref().and_then(|bit| bit.cutting.as_ref()) else {
        let message = "needs a bit with [bit.cutting]";
        source.refuse_if(content.feed.is_some(), "feed", message)?;
        source.refuse_if(content.string.axial.is_some(), "string.axial", message)?;
        return Ok(None);
    };
    check_scene(source, content)?;
    let feed = content.feed.unwrap_or_default();
    let rise = source.within("feed.rise_s", feed.rise_s, 0.0, 1e4, "s")?;
    let (feed, hoist) = hoist(source, &feed)?;
    let relief = source.within("bit.cutting.relief_deg", table.relief_deg, 0.5, 60.0, "°")?;
    let kick_time = source.within("bit.cutting.kick_s", table.kick_s, 1e-3, 1e3, "s")?;
    let axial = Axial {
        youngs_modulus: youngs_modulus(source, content)?,
        damping: damping(source, content, string)?,
        hoist,
    };
    let rod = axial.rod(string);
    Ok(Some(CuttingSettings {
        rod: rod.map_err(|error| source.error("string.axial", error.to_string()))?,
        contact: match table.contact {
            ContactName::Grows => FlatContact::Grows,
            ContactName::AtOnce => FlatContact::AtOnce,
        },
        blades: blades(source, table)?,
        relief: relief.to_radians().tan(),
        feed,
        profile: SurfaceProfile::Rise(rise),
        kick: kick(source, content, table)?,
        kick_time,
    }))
}

/// Refuses what does not go together with a bit that cuts.
fn check_scene(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let message = "is that of a rock whose torque follows from the weight on bit alone; with \
                   [bit.cutting] it follows from the depth of cut: leave it out";
    for key in [
        "torque_static_ratio",
        "torque_decay_rpm",
        "torque_dynamic_nm",
    ] {
        let key = format!("bit.{key}");
        source.refuse_if(source.gives_path(&key), &key, message)?;
    }
    let rock = content.bit.as_ref().and_then(|bit| bit.rock);
    let message = "a bit that cuts needs the constants of its rock: `sandstone`, `shale`, or `law` \
                   with [bit.law]";
    source.refuse_if(
        matches!(rock, None | Some(RockName::Table)),
        "bit.rock",
        message,
    )?;
    let law = content.bit.as_ref().and_then(|bit| bit.law);
    let cleans_poorly = law.is_some_and(|law| law.poor_cleaning_from_kn.is_some());
    let message = "is not modelled of a bit with [bit.cutting]";
    source.refuse_if(cleans_poorly, "bit.law.poor_cleaning_from_kn", message)?;
    let is_fed = content.feed.unwrap_or_default().kind == FeedName::Speed;
    let message = "what presses the string on its well depends on the weight on bit, which is not known of \
                   one that is fed at a speed: use `kind = \"hook-load\"`";
    source.refuse_if(
        is_fed && content.string_friction.is_some(),
        "feed.kind",
        message,
    )?;
    check_methods(source, content)
}

/// Refuses methods that find a response from its values at rest: a string that hangs from a hook load
/// has no place of rest.
fn check_methods(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let hangs = content.feed.unwrap_or_default().kind == FeedName::HookLoad;
    let needs_rest =
        |name: &&MethodName| matches!(**name, MethodName::Hilbert | MethodName::DirectIdft);
    let found = content.methods.iter().find(needs_rest).filter(|_| hangs);
    found.map_or(Ok(()), |name| {
        let message = format!(
            "`{}` needs a string that its surface holds: below a hook load it moves as a whole. Write \
             `held`, `quadrature` or `finite-element`, or `kind = \"speed\"` in [feed]",
            name.name()
        );
        Err(source.error("methods", message))
    })
}

/// What is set at the surface, and the hoist.
fn hoist(source: &Source, table: &FeedTable) -> Result<(Feed, Option<Hoist>), SweepFileError> {
    let within = |key: &str, value, least, most, unit| {
        source.within(&format!("feed.{key}"), value, least, most, unit)
    };
    let mass = within("hoist_mass_kg", table.hoist_mass_kg, 0.0, 1e6, "kg")?;
    let damping = within(
        "hoist_damping_ns_m",
        table.hoist_damping_ns_m,
        1.0,
        1e9,
        "N s/m",
    )?;
    match table.kind {
        FeedName::HookLoad => {
            let hoist = Hoist {
                mass,
                damping,
                stiffness: 0.0,
            };
            Ok((Feed::HookLoad(damping), Some(hoist)))
        }
        FeedName::Speed => {
            for key in ["hoist_mass_kg", "hoist_damping_ns_m"] {
                let message = "the surface moves at its speed under any force: leave it out";
                let key = format!("feed.{key}");
                source.refuse_if(source.gives_path(&key), &key, message)?;
            }
            Ok((Feed::Speed, None))
        }
    }
}

fn youngs_modulus(source: &Source, content: &FileContent) -> Result<f64, SweepFileError> {
    let own = content
        .string
        .axial
        .and_then(|axial| axial.youngs_modulus_gpa);
    let of_bending = content
        .string
        .bending
        .map(|bending| bending.youngs_modulus_gpa);
    let modulus = own.or(of_bending).unwrap_or(STEEL);
    let modulus = source.within("string.axial.youngs_modulus_gpa", modulus, 0.1, 1e3, "GPa")?;
    Ok(1e9 * modulus)
}

/// c_a, N s/m², by default c_t ∫A dx / ∫J dx: the same rate of decay.
fn damping(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
) -> Result<f64, SweepFileError> {
    if let Some(damping) = content.string.axial.and_then(|axial| axial.damping_ns_m2) {
        return source.within("string.axial.damping_ns_m2", damping, 0.0, 1e7, "N s/m²");
    }
    let (mut area, mut moment) = (0.0, 0.0);
    for section in string.sections() {
        for part in &section.parts {
            let length = section.repeat as f64 * part.length;
            area += length * part.area();
            moment += length * part.polar_moment();
        }
    }
    Ok(string.torsional_damping() * area / moment)
}

fn blades(source: &Source, table: &CuttingTable) -> Result<Blades, SweepFileError> {
    let key = "bit.cutting.blades";
    let count = source.within(key, table.blades as f64, 1.0, 20.0, "")?;
    let Some(angles) = &table.blade_angles_deg else {
        return Ok(Blades::Even(count as usize));
    };
    let key = "bit.cutting.blade_angles_deg";
    let message = "gives the blades: leave `blades` out";
    let is_double = source.gives_within(["bit", "cutting"], "blades");
    source.refuse_if(is_double, key, message)?;
    let turn: f64 = angles.iter().sum();
    let message = format!(
        "needs up to 20 positive angles, 360° together, not {} with {turn}° together",
        angles.len()
    );
    let is_turn = (turn - 360.0).abs() < 1e-3 && angles.iter().all(|angle| *angle > 0.0);
    source.refuse_if(!is_turn || angles.len() > 20, key, message)?;
    // To a whole turn, however it was rounded.
    let radians = angles
        .iter()
        .map(|angle| angle / turn * std::f64::consts::TAU);
    Ok(Blades::Uneven(radians.collect()))
}

/// The disturbance that a file gives itself.
fn kick(
    source: &Source,
    content: &FileContent,
    table: &CuttingTable,
) -> Result<Option<Kick>, SweepFileError> {
    let within = |key: &str, value: Option<f64>, most: f64, unit| {
        let key = format!("bit.cutting.{key}");
        value
            .map(|value| source.within(&key, value, -most, most, unit))
            .transpose()
    };
    let torque = within("kick_nm", table.kick_nm, 1e7, "N m")?;
    let force = within("kick_kn", table.kick_kn, 2e3, "kN")?;
    if torque.is_none() && force.is_none() {
        return Ok(None);
    }
    let key = match torque {
        Some(_) => "bit.cutting.kick_nm",
        None => "bit.cutting.kick_kn",
    };
    let message = "disturbs a steady start: it needs `start = \"smooth\"`";
    let is_steady = content.start == Some(StartName::Smooth);
    source.refuse_if(!is_steady, key, message)?;
    let message = "a kick is given: leave it out";
    source.refuse_if(
        content.start_disturbance.is_some(),
        "start_disturbance",
        message,
    )?;
    Ok(Some(Kick {
        torque: torque.unwrap_or(0.0),
        force: 1e3 * force.unwrap_or(0.0),
        duration: table.kick_s,
    }))
}

impl CuttingSettings {
    /// Number of blades.
    pub fn blades(&self) -> usize {
        match &self.blades {
            Blades::Even(count) => *count,
            Blades::Uneven(angles) => angles.len(),
            _ => 1,
        }
    }

    /// Whether the string hangs from a hook load.
    pub fn hangs(&self) -> bool {
        matches!(self.feed, Feed::HookLoad(_))
    }

    /// Refuses a sampling frequency (Hz) at which a bit that turns at a speed (rad/s) passes a blade in
    /// half a step.
    ///
    /// # Errors
    /// With the least that is needed.
    pub fn check_sampling(
        &self,
        source: &Source,
        speed: f64,
        frequency: f64,
    ) -> Result<(), SweepFileError> {
        let apart = match &self.blades {
            Blades::Uneven(angles) => angles.iter().copied().fold(f64::INFINITY, f64::min),
            _ => std::f64::consts::TAU / self.blades() as f64,
        };
        let least = 0.5 * speed / apart;
        let message = format!(
            "{frequency} Hz is too low for these blades: one passes in half a step. Write more than \
             {:.0} Hz, or leave the key out: the frequency then follows from blades and string",
            least.ceil()
        );
        source.refuse_if(frequency <= least, "sampling_frequency_hz", message)
    }

    /// The bit in a rock.
    pub fn bit_in(&self, law: CuttingLaw) -> Cutting {
        Cutting {
            rock: law,
            contact: self.contact,
            blades: self.blades.clone(),
            relief: self.relief,
        }
    }

    /// What the surface is set to in the end under given conditions, m/s; `None` where they do not say.
    pub fn feed(&self, conditions: &Conditions) -> Option<f64> {
        match self.feed {
            Feed::HookLoad(damping) => Some(1e3 * conditions.weight_on_bit_kn? / damping),
            Feed::Speed => Some(conditions.feed_m_h? / HOUR),
        }
    }

    /// Steady drilling of a string, with a motor above its bit or none, whose surface turns at a speed, rad/s,
    /// and is let down at a feed, m/s.
    pub fn steady(
        &self,
        (string, motor): (&Drillstring, Option<MudMotor>),
        cutting: &Cutting,
        surface_speed: f64,
        feed: f64,
    ) -> SteadyDrilling {
        let at = |depth: f64| {
            let [torque, weight] = cutting.steady(depth);
            let faster = motor.map_or(0.0, |motor| motor.relative_speed(torque));
            let speed = rotation_speed(string, surface_speed, torque) + faster;
            SteadyDrilling {
                speed,
                rate: depth * cutting.blades() as f64 * speed / std::f64::consts::TAU,
                torque,
                weight,
            }
        };
        let resistance = torsional_resistance(&self.rod);
        // What is left over of weight, or of feed: less for a deeper cut.
        let left = |drilling: SteadyDrilling| match self.feed {
            Feed::HookLoad(damping) => {
                damping * feed - (damping + resistance) * drilling.rate - drilling.weight
            }
            Feed::Speed => feed - drilling.rate,
        };
        let (mut low, mut high) = (0.0, DEEPEST_CUT);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if left(at(middle)) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        at(low)
    }

    /// How a case of a string with sites begins, at a rate of penetration (m/s), and what disturbs it.
    pub fn start(
        &self,
        (string, sites): (&Drillstring, &Sites),
        begins: &Begins,
        (surface_speed, steady): (f64, SteadyDrilling),
    ) -> (Start, f64, Option<Kick>) {
        let drills = steady.speed > 0.0 && steady.rate > 0.0;
        let part = begins.disturbance;
        let chance = begins.chance();
        if !(begins.steadily && drills) {
            // Of a bit at rest, until it turns: what it is let go with then differs. Nothing lifts it: on
            // it is no weight yet.
            let kick = chance.filter(|_| drills).map(|[torque, force]| Kick {
                torque: part * torque * steady.torque,
                force: part * force.abs() * steady.weight,
                duration: begins.rise.max(self.profile.rise()) + self.kick_time,
            });
            return (Start::Rest, 0.0, kick);
        }
        let motion = rotation(string, sites, surface_speed, steady.torque);
        let kick = self.kick.unwrap_or(Kick {
            torque: -part * steady.torque,
            force: part * steady.weight,
            duration: self.kick_time,
        });
        let [torque, force] = chance.unwrap_or([1.0; 2]);
        let kick = Kick {
            torque: torque * kick.torque,
            force: force * kick.force,
            ..kick
        };
        (Start::Steady(motion), steady.rate, Some(kick))
    }
}

/// How a case begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Begins {
    /// Drilling steadily; else at rest.
    pub steadily: bool,
    /// What disturbs it, as a part of torque and weight of steady drilling.
    pub disturbance: f64,
    /// The number of a start by chance; at zero, or where there is none, nothing is left to it.
    pub number: Option<f64>,
    /// How long the surface takes to reach its speed, s.
    pub rise: f64,
}

/// What numbers of starts are drawn by: the same start has the same disturbance in any sweep.
const SEED_OF_STARTS: u64 = 46;

impl Begins {
    /// What torque and force of a disturbance are multiplied by, from −1 to 1.
    fn chance(&self) -> Option<[f64; 2]> {
        let number = self.number.filter(|number| *number > 0.0)?;
        let mut stream = Stream::new(SEED_OF_STARTS, number as u64);
        Some([(); 2].map(|()| 2.0 * stream.part() - 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_number_is_the_same_disturbance_every_time() {
        let begins = |number| Begins {
            steadily: false,
            disturbance: 0.01,
            number,
            rise: 0.0,
        };
        assert_eq!(begins(None).chance(), None);
        assert_eq!(begins(Some(0.0)).chance(), None);
        let all: Vec<[f64; 2]> = (1..200)
            .filter_map(|number| begins(Some(f64::from(number))).chance())
            .collect();
        assert_eq!(all.len(), 199);
        assert_eq!(begins(Some(7.0)).chance(), Some(all[6]));
        let inside = all.iter().flatten().all(|it| (-1.0..1.0).contains(it));
        let mean = all.iter().flatten().sum::<f64>() / 398.0;
        assert!(inside && mean.abs() < 0.1, "{mean}");
    }
}
