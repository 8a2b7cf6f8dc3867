//! The linear part as all cases share it: lines ready to step against.

use linear::{
    BendingPoles, Cascade, ChannelResponses, ResponseError, Responses, Sites, SteppedString,
};

use crate::convolution::Kernel;
use crate::error::SimulationError;
use crate::laws::motor::{MotorMotion, MudMotor};
use crate::limited_drive::{DriveMotion, LimitedDrive};
use crate::line::pieces::Pieces;
use crate::line::torsion::Whole;
use crate::line::{AxialLines, Bending, Channel, TorsionLine, WallPorts};
use crate::ranges::not_negative;
use crate::sampling::Sampling;
use crate::scene::Scene;
use crate::start::Start;
use crate::surface::{SurfaceProfile, SurfaceResponse};

/// The linear part as all cases share it. What does not depend on the case is computed
/// here once.
#[derive(Debug, Clone)]
pub struct System {
    pub(crate) sites: Sites,
    pub(crate) sampling: Sampling,
    /// The longest case, s.
    longest_time: f64,
    /// Torsion: of the sites that a torque may act on, its ports.
    pub(crate) torsion: TorsionLine,
    /// From forces to displacements, between the ports in `walls`, where bending is modelled.
    pub(crate) from_forces: Option<Bending>,
    /// The ports that may have walls.
    pub(crate) walls: WallPorts,
    /// Springs that hold the linear string at each of these, N/m; nothing where there are none.
    pub(crate) springs: Vec<f64>,
    /// Mass that the linear string carries at each of these besides its own, kg; nothing where there
    /// is none.
    pub(crate) masses: Vec<f64>,
    /// Axial motion of the bit, where it is modelled.
    pub(crate) axial: Option<AxialLines>,
    /// What turns the bit against the string's end.
    pub(crate) motor: Option<MudMotor>,
    /// The drive, where its torque is limited.
    pub(crate) drive: Option<LimitedDrive>,
}

/// Distances from the bit, m, within which two sites are one.
const SAME_PLACE: f64 = 1e-9;

impl System {
    /// Prepares responses for cases as long as they were built for, whose surface turns at
    /// its speed from t = 0 on.
    ///
    /// # Errors
    /// Where they are not those of a string, there are none in torsion, or those in
    /// bending are of sites where no torque may act.
    pub fn new(responses: &Responses) -> Result<Self, SimulationError> {
        Self::started(responses, &SurfaceProfile::default())
    }

    /// The same for cases whose surface reaches its speed in another way.
    ///
    /// # Errors
    /// As [`System::new`], and where there is no such start.
    pub fn started(
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let torsion = checked_torsion(responses, profile)?;
        let sites = responses.sites.len();
        let bending = responses.bending();
        let fits = |bending: &ChannelResponses| {
            bending.loads.iter().copied().eq(0..sites) && torsion.loads == bending.loads
        };
        if !bending.is_none_or(fits) {
            return Err(SimulationError::UnlikeChannels);
        }
        let sampling = sampling(responses);
        let ports = torsion.loads.len();
        let whole = Whole {
            loaded: torsion.loads.clone(),
            from_torques: Channel::of_taps(&torsion.driving_points()),
            surface: to_surface(torsion, profile, sampling),
            to_others: to_others(torsion, responses.sites.bit_site()),
        };
        Ok(Self {
            sites: responses.sites.clone(),
            sampling,
            longest_time: responses.longest_time,
            walls: WallPorts::new(bending.map_or_else(Vec::new, |it| it.loads.clone()), ports),
            axial: None,
            motor: None,
            drive: None,
            from_forces: bending.map(|bending| Channel::of_taps(&bending.from_loads)),
            springs: bending.map_or_else(Vec::new, |_| responses.sites.springs().to_vec()),
            masses: responses.sites.masses().to_vec(),
            torsion: TorsionLine::Whole(whole),
        })
    }

    /// The same of a string whose elements are stepped, loads acting at any of its sites, with
    /// its responses to the surface.
    ///
    /// # Errors
    /// As [`System::started`], and where the responses are those of other sites.
    pub fn stepped(
        string: &SteppedString,
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let sites = string.torsion().sites();
        if responses.sites.len() != sites {
            return Err(ResponseError::OtherSites.into());
        }
        let torsion = checked_torsion(responses, profile)?;
        let sampling = sampling(responses);
        let whole = Whole {
            loaded: (0..sites).collect(),
            from_torques: Channel::of_mesh(string.torsion()),
            surface: to_surface(torsion, profile, sampling),
            to_others: Vec::new(),
        };
        Ok(Self {
            sites: responses.sites.clone(),
            sampling,
            longest_time: responses.longest_time,
            torsion: TorsionLine::Whole(whole),
            from_forces: Some(Channel::of_mesh(string.bending())),
            walls: WallPorts::new((0..sites).collect(), sites),
            // Elements that are stepped need none.
            springs: Vec::new(),
            masses: responses.sites.masses().to_vec(),
            axial: None,
            motor: None,
            drive: None,
        })
    }

    /// Of a string in pieces between its nodes, at each of which a torque may act, for cases whose
    /// surface turns by a profile. Where a motor holds the surface at its speed at any torque, it
    /// has a rotor of this inertia, kg m²: what turns that is part of its torque. A top drive of
    /// the string has its own.
    ///
    /// # Errors
    /// Where the profile or the inertia is invalid.
    pub fn in_pieces(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        Ok(Self {
            sites: cascade.nodes.clone(),
            sampling: Sampling::new(cascade.sampling_frequency, 0.0),
            longest_time: cascade.longest_time,
            torsion: TorsionLine::Pieces(Pieces::new(cascade, profile, rotor_inertia)?),
            from_forces: None,
            walls: WallPorts::new(Vec::new(), cascade.nodes.len()),
            springs: Vec::new(),
            masses: Vec::new(),
            axial: None,
            motor: None,
            drive: None,
        })
    }

    /// The same, which bends by responses of some of its sites: there it may have walls.
    ///
    /// # Errors
    /// Where these are not responses in bending by the same steps, or no torque may act at one of
    /// their sites.
    pub fn bending_by(self, responses: &Responses) -> Result<Self, SimulationError> {
        responses.check()?;
        let channel = linear::Channel::Bending;
        let bending = (responses.bending()).ok_or(ResponseError::NoChannel { channel })?;
        if sampling(responses) != self.sampling {
            return Err(SimulationError::UnlikeSteps);
        }
        let own = responses.sites.distances_from_bit();
        let walls = self.ports_at(bending.loads.iter().map(|&site| own[site]))?;
        Ok(Self {
            walls: WallPorts::new(walls, self.torsion.loaded().len()),
            from_forces: Some(Channel::of_taps(&bending.driving_points())),
            springs: responses.sites.springs().to_vec(),
            masses: responses.sites.masses().to_vec(),
            ..self
        })
    }

    /// The same, which bends by the poles of all its sites, each of which may have a wall.
    ///
    /// # Errors
    /// Where these are not as many as the ports at which torques act, or those of other sites.
    pub fn bending_by_poles(
        self,
        poles: &BendingPoles,
        sites: &Sites,
    ) -> Result<Self, SimulationError> {
        if poles.sites() != sites.len() {
            return Err(ResponseError::OtherSites.into());
        }
        Ok(Self {
            walls: WallPorts::new(
                self.ports_at(sites.distances_from_bit().iter().copied())?,
                self.torsion.loaded().len(),
            ),
            from_forces: Some(Channel::of_poles(poles)),
            springs: sites.springs().to_vec(),
            masses: sites.masses().to_vec(),
            ..self
        })
    }

    /// The ports at distances from the bit, m.
    fn ports_at(
        &self,
        distances: impl Iterator<Item = f64>,
    ) -> Result<Vec<usize>, SimulationError> {
        let ports = self.torsion.loaded();
        let places = self.sites.distances_from_bit();
        let port_at = |distance: f64| {
            let is_there = |site: &usize| (places[*site] - distance).abs() <= SAME_PLACE;
            ports.iter().position(is_there)
        };
        let found: Option<Vec<usize>> = distances.map(port_at).collect();
        found.ok_or(SimulationError::UnlikeChannels)
    }

    /// The same, which moves along its axis by responses of its bit, as a surface that reaches its
    /// speed by a profile moves it.
    ///
    /// # Errors
    /// Where these are not axial responses by the same steps, with a force at the bit.
    pub fn moving_along(
        self,
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        profile.check()?;
        responses.check()?;
        let channel = linear::Channel::Axial;
        let axial = (responses.axial()).ok_or(ResponseError::NoChannel { channel })?;
        if sampling(responses) != self.sampling {
            return Err(SimulationError::UnlikeSteps);
        }
        let bit = responses
            .sites
            .bit_site()
            .ok_or(SimulationError::NoAxialInput)?;
        let taps = (axial.taps_between(bit, bit)).ok_or(SimulationError::NoAxialInput)?;
        Ok(Self {
            axial: Some(AxialLines {
                from_forces: Channel::of_taps(&[vec![taps]]),
                surface: SurfaceResponse::new(&axial.from_surface[bit], profile, self.sampling),
            }),
            ..self
        })
    }

    /// The same with a mud motor between the string's end and the bit.
    ///
    /// # Errors
    /// Where there is no such motor.
    pub fn above_motor(self, motor: MudMotor) -> Result<Self, SimulationError> {
        motor.check()?;
        Ok(Self {
            motor: Some(motor),
            ..self
        })
    }

    /// The same below a drive whose torque is limited.
    ///
    /// # Errors
    /// Where it is that of a string with torques at other sites, or with other steps, or the string is in
    /// pieces.
    pub fn below_limited(self, drive: LimitedDrive) -> Result<Self, SimulationError> {
        let (ports, found) = (self.torsion.loaded().len(), drive.ports());
        if self.torsion.whole().is_none() || found != ports {
            return Err(SimulationError::NotOfItsDrive { ports, found });
        }
        if drive.sampling() != self.sampling {
            return Err(SimulationError::UnlikeSteps);
        }
        Ok(Self {
            drive: Some(drive),
            ..self
        })
    }

    /// Whether what turns the surface is known of every step.
    pub(crate) fn knows_surface(&self) -> bool {
        self.torsion.whole().is_none() || self.drive.is_some()
    }

    /// Speeds of all sites, rad/s, in a number of steps: what a start and a surface that turns at
    /// `surface_speed` (rad/s) in the end make of them and, but for sites that bear torques
    /// themselves, the torques on the bit (N m, positive with the rotation). The motion of sites
    /// that are only observed follows from a bit that was simulated without them. Empty for a
    /// string in pieces, all sites of which are stepped, and below a drive of limited torque, which
    /// turns them, too.
    pub fn driven_speeds(
        &self,
        surface_speed: f64,
        start: &Start,
        bit_torque: &[f64],
        steps: usize,
    ) -> Option<Vec<Vec<f64>>> {
        let whole = self.torsion.whole().filter(|_| self.drive.is_none())?;
        let at_start = start.steady();
        let speed = |site: usize, step: usize| match at_start {
            None => surface_speed * whole.surface[site].at(step),
            Some(motion) => motion.speeds[site],
        };
        let of_surface = |site: usize| (0..steps).map(|step| speed(site, step)).collect();
        let mut speeds: Vec<Vec<f64>> = (0..self.sites.len()).map(of_surface).collect();
        let load = |(step, torque): (usize, &f64)| {
            let before = at_start.map_or(0.0, |it| it.at_bit.at(self.sampling.time_of(step)));
            torque - before
        };
        let loads: Vec<f64> = bit_torque.iter().enumerate().map(load).collect();
        for (site, kernel) in &whole.to_others {
            for (step, (speed, load)) in speeds[*site].iter_mut().zip(&loads).enumerate() {
                *speed += kernel.past_sum(&loads[..step]) + kernel.instant() * load;
            }
        }
        Some(speeds)
    }

    /// The motor at the start of a scene that begins with these speeds of ports, rad/s, where there is
    /// one: at rest, or turning by its chart.
    pub(crate) fn motor<B, W>(&self, scene: &Scene<B, W>, speeds: &[f64]) -> Option<MotorMotion> {
        let motor = self.motor?;
        let turning = (scene.start.steady().zip(self.bit_port())).map(|(steady, port)| {
            let lying = scene.lateral.as_ref().and_then(|it| it.lying.as_ref());
            let by_wall = (self.walls.at(port).zip(lying))
                .and_then(|(wall, lying)| lying.torques.get(wall))
                .map_or(0.0, |torque| *torque);
            speeds[port] + motor.relative_speed(-steady.at_bit.torque - by_wall)
        });
        let step = self.sampling.frequency.recip();
        Some(MotorMotion::new(motor, step, turning.unwrap_or_default()))
    }

    /// The drive of limited torque at the start of a scene of a number of steps, where there is one.
    pub(crate) fn limited_drive<B, W>(
        &self,
        scene: &Scene<B, W>,
        steps: usize,
    ) -> Option<DriveMotion<'_>> {
        let lying = scene.lateral.as_ref().and_then(|it| it.lying.as_ref());
        let by_walls = lying.map_or(0.0, |lying| -lying.torques.iter().sum::<f64>());
        let begins = (&scene.start, by_walls);
        (self.drive.as_ref()).map(|drive| drive.begin(scene.surface_speed, begins, steps))
    }

    /// The port of the bit, where a torque may act there.
    pub(crate) fn bit_port(&self) -> Option<usize> {
        let site = self.sites.bit_site()?;
        let mut loaded = self.torsion.loaded().iter();
        loaded.position(|&loaded| loaded == site)
    }

    /// Steps of a case, that at its start included.
    pub(crate) fn steps_of(&self, duration: f64) -> usize {
        (duration * self.sampling.frequency).ceil() as usize + 1
    }

    /// What is said where the motion of a port is no number.
    pub(crate) fn not_finite(&self, port: usize, time: f64) -> SimulationError {
        let site = self.torsion.loaded()[port];
        SimulationError::NotFinite { site, time }
    }

    /// Refuses a case that lasts longer than this is prepared for.
    pub(crate) fn lasts_for(&self, duration: f64) -> Result<(), SimulationError> {
        let prepared = self.longest_time;
        if duration <= prepared {
            Ok(())
        } else {
            Err(SimulationError::LongerThanPrepared { duration, prepared })
        }
    }
}

fn sampling(responses: &Responses) -> Sampling {
    Sampling::new(
        responses.sampling_frequency,
        responses.method.collocation_offset(),
    )
}

/// The responses in torsion, if they are valid and the start is possible.
fn checked_torsion<'a>(
    responses: &'a Responses,
    profile: &SurfaceProfile,
) -> Result<&'a ChannelResponses, SimulationError> {
    profile.check()?;
    not_negative("longest time in s", responses.longest_time)?;
    responses.check()?;
    let channel = linear::Channel::Torsion;
    Ok((responses.torsion()).ok_or(ResponseError::NoChannel { channel })?)
}

fn to_surface(
    torsion: &ChannelResponses,
    profile: &SurfaceProfile,
    sampling: Sampling,
) -> Vec<SurfaceResponse> {
    let response = |taps: &Vec<f64>| SurfaceResponse::new(taps, profile, sampling);
    torsion.from_surface.iter().map(response).collect()
}

fn to_others(torsion: &ChannelResponses, bit_site: Option<usize>) -> Vec<(usize, Kernel)> {
    let others = (0..torsion.from_loads.len()).filter(|site| !torsion.loads.contains(site));
    let kernel = |site| Some((site, Kernel::new(torsion.taps_between(bit_site?, site)?)));
    others.filter_map(kernel).collect()
}
