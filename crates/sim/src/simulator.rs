//! One case from rest to its regimes: the stepper, what is skipped, and who watches.
//!
//! On this string a bit sticks again and again below Eq. 74, and well above it never (`responses` of a
//! string as in the example of the crate):
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
//! use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
//! use sim::{BitTorque, Scene, Simulator, Start, Stopping, TorsionRegime};
//!
//! let simulator = Simulator::new(&responses)?;
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.0 };
//! let undershoot = largest_undershoot(responses.at_bit().unwrap_or_default());
//! let limit = stick_slip_speed_limit(undershoot, bit.torque_static, bit.torque_dynamic);
//! let regime = |surface_speed: f64| -> Result<_, sim::SimulationError> {
//!     let timing = sim::torsion_timing(&string, surface_speed, &bit, &Start::Rest);
//!     let scene = Scene {
//!         surface_speed,
//!         start: Start::Rest,
//!         bit: Some(bit),
//!         friction: Vec::new(),
//!         axial: None,
//!         lateral: None,
//!         timing,
//!     };
//!     let outcome = simulator.simulate(&scene, Stopping::Early, None)?;
//!     Ok(outcome.torsion().map(|torsion| torsion.regime))
//! };
//! assert_eq!(regime(0.5 * limit)?, Some(TorsionRegime::StickSlip));
//! assert_eq!(regime(2.0 * limit)?, Some(TorsionRegime::Smooth));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod case;
mod watchers;

use linear::{BendingPoles, Cascade, Responses, Sites, SteppedString};

use crate::error::SimulationError;
use crate::laws::contact::WallLaw;
use crate::laws::motor::MudMotor;
use crate::laws::torque::TorqueLaw;
use crate::limited_drive::LimitedDrive;
use crate::outcome::{Outcome, Stopping};
use crate::scene::Scene;
use crate::shortcuts::BitAlone;
use crate::stepper::Stepper;
use crate::surface::SurfaceProfile;
use crate::system::System;
use crate::trajectory::Trajectory;
use case::Case;

/// A linear system with what is known of all its cases.
#[derive(Debug, Clone)]
pub struct Simulator {
    system: System,
    bit_alone: Option<BitAlone>,
    follows_torque: bool,
}

impl Simulator {
    /// Prepares responses for cases as long as they were built for.
    ///
    /// # Errors
    /// As [`System::new`].
    pub fn new(responses: &Responses) -> Result<Self, SimulationError> {
        Self::started(responses, &SurfaceProfile::default())
    }

    /// The same for cases whose surface reaches its speed in another way.
    ///
    /// # Errors
    /// As [`System::started`].
    pub fn started(
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let system = System::started(responses, profile)?;
        Ok(Self {
            bit_alone: BitAlone::of(&system, responses),
            ..Self::of(system)
        })
    }

    /// Of a string whose elements are stepped, with its responses to the surface: for many
    /// sites.
    ///
    /// # Errors
    /// As [`System::stepped`].
    pub fn stepped(
        string: &SteppedString,
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        System::stepped(string, responses, profile).map(Self::of)
    }

    /// Of a string in pieces, whose nodes torques may act on: for friction all along it.
    ///
    /// # Errors
    /// As [`System::in_pieces`].
    pub fn in_pieces(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        System::in_pieces(cascade, profile, rotor_inertia).map(Self::of)
    }

    /// Of any system.
    pub fn of(system: System) -> Self {
        Self {
            system,
            bit_alone: None,
            follows_torque: false,
        }
    }

    /// The same, which follows the torque all along a string in pieces, or does not: that takes a
    /// little more of each step.
    #[must_use]
    pub fn following_torque(self, follows_torque: bool) -> Self {
        Self {
            follows_torque,
            ..self
        }
    }

    /// The same, which bends by the poles of its sites.
    ///
    /// # Errors
    /// As [`System::bending_by_poles`].
    pub fn bending_by_poles(
        self,
        poles: &BendingPoles,
        sites: &Sites,
    ) -> Result<Self, SimulationError> {
        Ok(Self {
            system: self.system.bending_by_poles(poles, sites)?,
            bit_alone: None,
            ..self
        })
    }

    /// The same with a mud motor between the string's end and the bit, below which no step is left
    /// out.
    ///
    /// # Errors
    /// As [`System::above_motor`].
    pub fn above_motor(self, motor: MudMotor) -> Result<Self, SimulationError> {
        Ok(Self {
            system: self.system.above_motor(motor)?,
            bit_alone: None,
            ..self
        })
    }

    /// The same below a drive whose torque is limited: no step is left out, for those that are
    /// follow from a string that is linear.
    ///
    /// # Errors
    /// As [`System::below_limited`].
    pub fn below_limited(self, drive: LimitedDrive) -> Result<Self, SimulationError> {
        Ok(Self {
            system: self.system.below_limited(drive)?,
            bit_alone: None,
            ..self
        })
    }

    /// What its cases are stepped against.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The torque that holds the bit fast from the first step on, for as long as
    /// any case lasts, N m per rad/s of surface speed; `None` where something else than
    /// the bit may act, or nothing.
    pub fn stuck_torque(&self) -> Option<&[f64]> {
        self.bit_alone.as_ref().map(BitAlone::stuck_torque)
    }

    /// Simulates one case, writing its time history into `record` where asked; nothing
    /// is left out of that.
    ///
    /// # Errors
    /// Where the scene is refused or does not fit the system, the motion is
    /// not finite or coupled sites do not settle.
    pub fn simulate(
        &self,
        scene: &Scene,
        stopping: Stopping,
        record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        // Compiled here, once for all callers.
        self.simulate_laws(scene, stopping, record)
    }

    /// The same under user-defined laws. Which steps are left out follows from the properties that
    /// they declare ([`TorqueLaw`], [`WallLaw`]).
    ///
    /// # Errors
    /// As [`Simulator::simulate`].
    pub fn simulate_laws<B: TorqueLaw, W: WallLaw>(
        &self,
        scene: &Scene<B, W>,
        stopping: Stopping,
        record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        let alone = self.bit_alone.as_ref().zip(scene.bit.as_ref());
        let stepper = match alone {
            Some((alone, law)) => alone.stepper(&self.system, scene, law)?,
            None => Stepper::new(&self.system, scene)?,
        };
        let stopping = match record {
            Some(_) => Stopping::Full,
            None => stopping,
        };
        let alone = alone.map(|(alone, _)| alone);
        let mut case = Case::new(&self.system, scene, (stopping, alone), stepper);
        if self.follows_torque {
            case.follow_torque();
        }
        let ended = match record {
            None => case.step_through(|_| {})?,
            Some(record) => case.record(record)?,
        };
        case.outcome(ended)
    }
}
