//! A top drive that gives no more than its greatest torque.
//!
//! Responses of a string have its drive in them as it is while it is linear: with e the set speed
//! less its own, its motor gives T = K_p e + Q, Q = K_i ∫ e dt. One whose torque is limited gives
//!
//! T_own = min(T_most, max(−T_most, K_p e + Q_own)),
//!
//! and while that is less than its controller asks for, Q_own stands still where e would take it
//! further from what the motor can give, and follows e where it would not (conditional integration).
//! To the string of the responses the difference, T_x = T_own − T, is one more torque at the surface.
//! Of that the speed there, v, is all that is not known in a step: with P what its past leaves of
//! K_p e + Q, T = P − G v; and the string answers with v = v₀ + g T_x, v₀ that of the torques below.
//! K_p e + Q_own falls with v, so that one of three lines is met: none of the torque is missing,
//! or it is T_most or −T_most; and on each a bit that is alone sees one more load line. Where torques
//! act at more places, which hardly feel the surface within a step, they and the drive are solved in turn.
//!
//! By means over a step (`held`) Q is exact at the ends of steps, and within one as if e were straight.

use linear::budget::REAL;
use linear::{DrivenSurface, GrowingTorque, IntegralRule, TopDrive};

use crate::convolution::Convolution;
use crate::error::SimulationError;
use crate::laws::motor::StringEnd;
use crate::laws::torque::LoadLine;
use crate::line::pieces::SurfaceStep;
use crate::line::{Channel, Past};
use crate::ranges::positive;
use crate::sampling::Sampling;
use crate::start::Start;
use crate::surface::{SurfaceProfile, SurfaceResponse};

/// A place where a torque acts on the string, and the surface, in what one makes of the other.
const PORT: usize = 0;
const SURFACE: usize = 1;
const BOTH: usize = 2;

/// A drive of limited torque as all cases share it, above a string with ports at which torques act.
#[derive(Debug, Clone)]
pub struct LimitedDrive {
    drive: TopDrive,
    /// N m.
    limit: f64,
    integral: IntegralRule,
    sampling: Sampling,
    /// Of each port, from torques there and at the surface to speeds, without its own to itself; with that
    /// of the surface in the last alone.
    from_torques: Vec<Channel<1, 1>>,
    /// What the drive is set to, and how fast its surface then turns, per unit of the speed of a
    /// scene.
    set: SurfaceResponse,
    turned: SurfaceResponse,
    /// G, N m s/rad.
    opposes: f64,
}

impl LimitedDrive {
    /// Bytes for a number of ports and responses of a number of taps.
    pub(crate) fn bytes(ports: usize, taps: usize) -> f64 {
        ports as f64 * Channel::<1, 1>::bytes_of_taps(BOTH, taps, false)
            + 2.0 * SurfaceResponse::bytes(taps)
    }

    /// Bytes of a case of a number of steps, and of its torques in them.
    pub(crate) fn case_bytes(ports: usize, taps: usize, steps: f64) -> f64 {
        ports as f64 * Convolution::bytes(BOTH, 1, taps, steps) + REAL * steps
    }

    /// The drive of a string, whose greatest torque is `limit` (N m), for cases in which it is set
    /// to its speed by a profile, and torques act on the sites of these numbers.
    ///
    /// # Errors
    /// Where there is no such site, the limit or the profile is out of range, or no torque could hold the
    /// drive within a step of this length.
    pub fn new(
        surface: &DrivenSurface,
        ports: &[usize],
        limit: f64,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        positive("greatest torque of the drive in N m", limit)?;
        profile.check()?;
        let sampling = Sampling::new(
            surface.sampling_frequency,
            surface.method.collocation_offset(),
        );
        let (own, set) = (&surface.speed_by_torque, &surface.speed_by_set);
        let to_ports: Option<Vec<&Vec<f64>>> = (ports.iter())
            .map(|&port| surface.sites_by_torque.get(port))
            .collect();
        let (Some(to_ports), false) = (to_ports, own.is_empty() || ports.is_empty()) else {
            return Err(linear::ResponseError::Shape.into());
        };
        let none = vec![0.0; own.len()];
        let drive = surface.drive;
        let opposes = drive.proportional_gain + drive.integral_gain * surface.integral.of_values[0];
        if !(own[0] > 0.0 && own[0] * opposes < 1.0) {
            return Err(SimulationError::DriveTooStiff);
        }
        Ok(Self {
            drive,
            limit,
            integral: surface.integral,
            sampling,
            from_torques: (to_ports.iter().enumerate())
                .map(|(port, to_port)| {
                    let own = if port + 1 == to_ports.len() {
                        own
                    } else {
                        &none
                    };
                    Channel::of_taps(&[vec![&none, *to_port], vec![*to_port, own]])
                })
                .collect(),
            set: SurfaceResponse::new(&[1.0], profile, sampling),
            turned: SurfaceResponse::new(set, profile, sampling),
            opposes,
        })
    }

    /// Its torque is no more than this, N m.
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// At how many ports torques act below it.
    pub(crate) fn ports(&self) -> usize {
        self.from_torques.len()
    }

    /// g, rad/s per N m.
    fn own(&self) -> f64 {
        let last = self.from_torques.last();
        last.map_or(0.0, |last| last.instant(SURFACE, SURFACE))
    }

    /// How far a torque at the surface turns a port within the step, and the other way, rad/s per N m.
    fn across(&self, port: usize) -> f64 {
        self.from_torques[port].instant(PORT, SURFACE)
    }

    /// By which steps.
    pub(crate) fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// At the beginning of a case of a number of steps; in a steady motion walls may take `by_walls` (N m),
    /// which its torque at the surface does not have.
    pub(crate) fn begin(
        &self,
        surface_speed: f64,
        (start, by_walls): (&Start, f64),
        steps: usize,
    ) -> DriveMotion<'_> {
        let drive = self.drive;
        let reference = match start.steady() {
            None => Reference::Rest(surface_speed),
            Some(motion) => {
                let torque = GrowingTorque {
                    torque: motion.at_surface.torque + by_walls,
                    ..motion.at_surface
                };
                // What stays of the error makes the torque, or the rate at which it grows.
                let error = match drive.integral_gain > 0.0 {
                    true => torque.rate / drive.integral_gain,
                    false => torque.torque / drive.proportional_gain,
                };
                Reference::Steady {
                    speed: surface_speed - error,
                    torque: [torque.torque, torque.rate],
                }
            }
        };
        DriveMotion {
            drive: self,
            pasts: (self.from_torques.iter())
                .map(|channel| channel.past(steps))
                .collect(),
            errors: [0.0; 2],
            integrals: [0.0; 2],
            integral_torque: reference.integral_torque(0.0),
            reference,
            withheld: 0.0,
            now: Now::default(),
        }
    }
}

/// The part of its greatest torque by which the drive's may be off.
const SETTLED: f64 = 1e-9;

/// The motion that is stepped from: all else is what differs from it.
#[derive(Debug, Clone, Copy)]
enum Reference {
    /// Rest, from which the drive is set to a speed in the end, rad/s.
    Rest(f64),
    /// A steady motion: speed of the surface, rad/s, torque of the motor, N m, and its rate, N m/s.
    Steady { speed: f64, torque: [f64; 2] },
}

impl Reference {
    /// What the integral makes of the torque at a time (s), N m.
    fn integral_torque(&self, time: f64) -> f64 {
        match self {
            Self::Rest(_) => 0.0,
            Self::Steady {
                torque: [torque, rate],
                ..
            } => torque + rate * time,
        }
    }
}

/// A drive of limited torque in a case.
#[derive(Debug)]
pub(crate) struct DriveMotion<'a> {
    drive: &'a LimitedDrive,
    /// Of each port with the surface.
    pasts: Vec<Past<'a, 1, 1>>,
    reference: Reference,
    /// Errors of the speed in the last two steps, rad/s, and their integrals, rad; of a case that
    /// began with a steady motion, what they differ by.
    errors: [f64; 2],
    integrals: [f64; 2],
    /// What the integral makes of the linear torque, N m.
    integral_torque: f64,
    /// What the drive's own integral makes less than that, N m.
    withheld: f64,
    now: Now,
}

/// A step of it.
#[derive(Debug, Clone, Copy, Default)]
struct Now {
    /// What past torques make of the speed of the surface, rad/s, less the reference's own.
    free_speed: f64,
    /// The set speed less that of the reference, rad/s.
    set: f64,
    /// Integral without the error of this step, rad.
    integral: f64,
    /// What the reference motion makes of the torque, N m.
    base: f64,
    /// Speed of the surface less the reference's own, rad/s.
    speed: f64,
    /// Of the motor, N m, and what that differs by from the linear torque.
    torque: f64,
    extra: f64,
}

/// Which line of the drive is met.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meets {
    /// All that the controller asks for.
    Asked,
    /// The greatest torque in the direction of this sign.
    Most(f64),
}

impl DriveMotion<'_> {
    /// What this step is without its torques, but for some that act on ports anyhow (with their numbers,
    /// N m); adds what the drive did so far to how the ports turn freely, rad/s.
    #[inline]
    pub(crate) fn find_free_motion(
        &mut self,
        (step, time): (usize, f64),
        acting: impl Iterator<Item = (usize, f64)>,
        free: &mut [f64],
    ) {
        let (drive, rule) = (self.drive, &self.drive.integral);
        let mut of_past = 0.0;
        for (past, free) in self.pasts.iter().zip(free) {
            let mut speeds = [0.0; BOTH];
            past.write_past(&mut speeds);
            of_past += speeds[SURFACE];
            *free += speeds[PORT];
        }
        let (set, turned) = match self.reference {
            Reference::Rest(speed) => (speed * drive.set.at(step), speed * drive.turned.at(step)),
            Reference::Steady { .. } => (0.0, 0.0),
        };
        let by_acting = acting.map(|(port, torque)| drive.across(port) * torque);
        let [newest, before, earlier] = rule.of_values;
        let past = before * self.errors[0] + earlier * self.errors[1];
        let kept =
            rule.of_integrals[0] * self.integrals[0] + rule.of_integrals[1] * self.integrals[1];
        self.now = Now {
            free_speed: by_acting.fold(of_past + turned, |sum, speed| sum + speed),
            set,
            integral: past + kept + newest * set,
            base: self.reference.integral_torque(time),
            ..Now::default()
        };
    }

    /// What the linear drive gives while the surface turns at a speed (rad/s), N m.
    fn linear_torque(&self, speed: f64) -> f64 {
        let drive = self.drive.drive;
        let now = &self.now;
        now.base + drive.proportional_gain * now.set + drive.integral_gain * now.integral
            - self.drive.opposes * speed
    }

    /// What acts on the bit, alone of all ports, as it answers to its load line with its torque (N m,
    /// positive with the rotation) and its speed (rad/s): where string, drive and bit agree. Where a bit
    /// that sticks in one way and slips in the other leaves no such line, the drive gives its most.
    #[inline]
    pub(crate) fn meet<A>(
        &mut self,
        (port, line): (usize, LoadLine),
        act: impl Fn(LoadLine) -> (A, StringEnd),
    ) -> (A, StringEnd) {
        let across = self.drive.across(port);
        let met = act(self.line(across, line, Meets::Asked));
        let asked = self.take(Meets::Asked, across * met.1.torque);
        if asked.abs() <= self.drive.limit {
            return met;
        }
        let most = Meets::Most(asked.signum());
        let met = act(self.line(across, line, most));
        self.take(most, across * met.1.torque);
        met
    }

    /// The load line of the bit on one of the drive's lines.
    fn line(&self, across: f64, line: LoadLine, meets: Meets) -> LoadLine {
        // Without a torque on the bit, and by how much it changes with that.
        let [alone, with_one] = [0.0, 1.0].map(|torque| self.extra(meets, across * torque));
        LoadLine {
            free_speed: line.free_speed + across * alone,
            compliance: line.compliance + across * (with_one - alone),
            ..line
        }
    }

    /// How fast the torques on all ports (N m) turn the surface within the step, rad/s.
    pub(crate) fn turned_by(&self, torques: impl Iterator<Item = f64>) -> f64 {
        let speeds = torques
            .enumerate()
            .map(|(port, torque)| self.drive.across(port) * torque);
        speeds.sum()
    }

    /// Answers to torques on the ports that turn the surface by so much (rad/s); gives by how much its
    /// torque differs from that of the linear drive, N m.
    pub(crate) fn answer(&mut self, turned: f64) -> f64 {
        let asked = self.take(Meets::Asked, turned);
        if asked.abs() > self.drive.limit {
            self.take(Meets::Most(asked.signum()), turned);
        }
        self.now.extra
    }

    /// Whether a difference of what turns the surface (rad/s) does not matter.
    pub(crate) fn is_negligible(&self, difference: f64) -> bool {
        difference.abs() * self.drive.opposes <= SETTLED * self.drive.limit
    }

    /// How far a torque at the surface (N m) turns a port within the step, rad/s.
    #[inline]
    pub(crate) fn turns_by(&self, port: usize, torque: f64) -> f64 {
        self.drive.across(port) * torque
    }

    /// How far its own torque turns a port within the step otherwise than the linear drive's, rad/s.
    #[inline]
    pub(crate) fn turns(&self, port: usize) -> f64 {
        self.turns_by(port, self.now.extra)
    }

    /// T_x on one of the drive's lines, N m, while torques on ports turn the surface by so much, rad/s.
    fn extra(&self, meets: Meets, turned: f64) -> f64 {
        let Meets::Most(sign) = meets else {
            return -self.withheld;
        };
        let free = self.now.free_speed + turned;
        let missing = sign * self.drive.limit - self.linear_torque(free);
        missing / (1.0 - self.drive.own() * self.drive.opposes)
    }

    /// Takes one of the drive's lines while torques on ports turn the surface by so much (rad/s); gives
    /// what the controller then asks for, N m.
    fn take(&mut self, meets: Meets, turned: f64) -> f64 {
        let extra = self.extra(meets, turned);
        self.now.extra = extra;
        self.now.speed = self.now.free_speed + turned + self.drive.own() * extra;
        let asked = self.linear_torque(self.now.speed) - self.withheld;
        self.now.torque = match meets {
            Meets::Asked => asked,
            Meets::Most(sign) => sign * self.drive.limit,
        };
        asked
    }

    /// Ends a step with the torques on the ports, N m, of a case that began with a steady motion what
    /// they differ by; gives what turned the surface.
    #[inline]
    pub(crate) fn end_step(&mut self, torques: &[f64]) -> SurfaceStep {
        let Now {
            set,
            integral,
            base,
            speed,
            torque,
            extra,
            ..
        } = self.now;
        let drive = self.drive.drive;
        let error = set - speed;
        let integral = integral - self.drive.integral.of_values[0] * speed;
        self.errors = [error, self.errors[0]];
        self.integrals = [integral, self.integrals[0]];
        let integral_torque = base + drive.integral_gain * integral;
        let change = integral_torque - self.integral_torque;
        self.integral_torque = integral_torque;
        let is_limited = torque.abs() >= self.drive.limit;
        if is_limited && change * torque > 0.0 {
            self.withheld += change;
        }
        for (past, torque) in self.pasts.iter_mut().zip(torques) {
            past.add(&[*torque, extra]);
        }
        let of_reference = match self.reference {
            Reference::Rest(_) => 0.0,
            Reference::Steady { speed, .. } => speed,
        };
        SurfaceStep {
            speed: of_reference + speed,
            torque,
        }
    }
}
