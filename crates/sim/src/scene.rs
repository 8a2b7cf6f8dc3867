//! What one case contains.
//!
//! What no law of the bit can be is refused before a step is made:
//!
//! ```
//! # use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//! # let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! # let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! # let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! # let request = Request {
//! #     sites: Sites::bit(),
//! #     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//! #     sampling_frequency: 640.0,
//! #     longest_time: 20.0,
//! # };
//! # let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! use sim::{BitTorque, Scene, SceneError, SimulationError, Start, Stepper, System, Timing};
//!
//! let scene: Scene = Scene {
//!     surface_speed: 6.0,
//!     start: Start::Rest,
//!     bit: Some(BitTorque { torque_static: 900.0, torque_dynamic: 1000.0, decay_speed: 0.0 }),
//!     friction: Vec::new(),
//!     axial: None,
//!     lateral: None,
//!     timing: Timing { duration: 10.0, closing_window: 2.0 },
//! };
//! let system = System::new(&responses)?;
//! let refused = Stepper::new(&system, &scene).err();
//! assert!(matches!(refused, Some(SimulationError::Scene(SceneError::Torques { .. }))));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::excitation::{EccentricMass, Impulse};
use crate::laws::bit::BitTorque;
use crate::laws::contact::WallLaw;
use crate::laws::cutting::Cutting;
use crate::laws::pipe::PipeFriction;
use crate::laws::torque::TorqueLaw;
use crate::laws::wall::Wall;
use crate::lying::Lying;
use crate::ranges::{SceneError, finite, known_site, not_negative, positive};
use crate::start::Start;

/// How long to simulate, and over which part at the end a regime must show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Time simulated, s.
    pub duration: f64,
    /// The closing window, s: no shorter than a cycle of stick-slip.
    pub closing_window: f64,
}

/// One case. The laws may be a user's own ([`TorqueLaw`], [`WallLaw`]).
#[derive(Debug, Clone, PartialEq)]
pub struct Scene<B = BitTorque, W = Wall> {
    /// Final surface rotation speed Ω, rad/s.
    pub surface_speed: f64,
    /// The motion that it begins with.
    pub start: Start,
    /// Torque at the bit; `None` leaves it free.
    pub bit: Option<B>,
    /// Friction of the well on the pipe, at each site that a torque may act on, from the surface
    /// down; empty where the string rubs nowhere. On the bit its own law acts instead.
    pub friction: Vec<Option<PipeFriction>>,
    /// Axial motion above a bit that cuts, where it is modelled: its torque is the bit's.
    pub axial: Option<Axial>,
    /// Lateral motion, where it is modelled.
    pub lateral: Option<Lateral<W>>,
    /// Time simulated and closing window.
    pub timing: Timing,
}

/// The axial part of a scene: a bit that cuts, at the lower end of a string that stretches.
#[derive(Debug, Clone, PartialEq)]
pub struct Axial {
    /// The bit and its rock.
    pub cutting: Cutting,
    /// Speed down that the surface is set to in the end, m/s; below a hoist of damping c that a
    /// force F sets, F/c.
    pub feed: f64,
    /// Rate of penetration of a case that begins with a steady motion, m/s.
    pub start_rate: f64,
    /// A disturbance of the bit at the beginning.
    pub kick: Option<Kick>,
}

/// A torque and a force on the bit from the beginning on, in addition to those of the rock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kick {
    /// In the direction of rotation, N m.
    pub torque: f64,
    /// Down, N.
    pub force: f64,
    /// s.
    pub duration: f64,
}

/// The lateral part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Lateral<W = Wall> {
    /// The borehole wall at each site that bends, from the surface down.
    pub walls: Vec<W>,
    /// Disturbances, at sites numbered as the walls are.
    pub impulses: Vec<Impulse>,
    /// Eccentric masses, at sites numbered as the walls are.
    pub eccentric_masses: Vec<EccentricMass>,
    /// How a string that has weight across its hole lies in it; `None` where it hangs in the middle.
    pub lying: Option<Lying>,
    /// Where accelerations are measured: that sideways, m/s², beyond which a shock is counted.
    pub shocks: Option<f64>,
}

impl<B: TorqueLaw, W: WallLaw> Scene<B, W> {
    /// Whether a law acts on the bit.
    pub(crate) fn turns_against_rock(&self) -> bool {
        self.bit.is_some() || self.axial.is_some()
    }

    /// Checks that it can be simulated: every number in its range, everything at
    /// one of the `sites`, of which a number may have walls.
    pub(crate) fn check(&self, sites: usize, walls: usize) -> Result<(), SceneError> {
        finite("surface speed in rad/s", self.surface_speed)?;
        self.start.check(sites)?;
        not_negative("time simulated in s", self.timing.duration)?;
        not_negative("closing window in s", self.timing.closing_window)?;
        self.bit.iter().try_for_each(TorqueLaw::check)?;
        if let Some(axial) = &self.axial {
            axial.check(self.start.steady().is_some())?;
            if self.bit.is_some() {
                return Err(SceneError::TwoLawsOfTheBit);
            }
        }
        self.friction
            .iter()
            .flatten()
            .try_for_each(TorqueLaw::check)?;
        let Some(lateral) = &self.lateral else {
            return Ok(());
        };
        lateral.walls.iter().try_for_each(WallLaw::check)?;
        if let Some(lying) = &lateral.lying {
            lying.check(walls)?;
            let slides = lying.torques.iter().any(|torque| *torque != 0.0);
            if slides && self.start == Start::Rest {
                return Err(SceneError::SlidesAtRest);
            }
        }
        if let Some(threshold) = lateral.shocks {
            positive("acceleration of a shock in m/s²", threshold)?;
        }
        for impulse in &lateral.impulses {
            known_site("an impulse", impulse.site, walls)?;
            finite("amount of an impulse in N s", impulse.amount)?;
            finite("start of an impulse in s", impulse.start)?;
            finite("direction of an impulse in rad", impulse.direction)?;
            positive("duration of an impulse in s", impulse.duration)?;
        }
        for mass in &lateral.eccentric_masses {
            known_site("an eccentric mass", mass.site, walls)?;
            not_negative("eccentric mass in kg", mass.mass)?;
            finite("offset of an eccentric mass in m", mass.offset)?;
        }
        Ok(())
    }
}

impl Axial {
    fn check(&self, is_steady: bool) -> Result<(), SceneError> {
        self.cutting.check()?;
        finite("speed of the surface down in m/s", self.feed)?;
        not_negative("rate of penetration at the start in m/s", self.start_rate)?;
        if is_steady {
            positive("rate of penetration at the start in m/s", self.start_rate)?;
        }
        if let Some(kick) = &self.kick {
            finite("torque of a kick in N m", kick.torque)?;
            finite("force of a kick in N", kick.force)?;
            not_negative("duration of a kick in s", kick.duration)?;
        }
        Ok(())
    }
}
