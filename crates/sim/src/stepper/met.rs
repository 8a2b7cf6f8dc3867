//! The local laws of a step, each met on the load line of its port: one alone, all in turn until they
//! agree, and these with a drive whose torque is limited.

use pulp::{Simd, WithSimd};

use super::Stepper;
use crate::coupling::{Free, Unloaded};
use crate::error::SimulationError;
use crate::lateral_motion::LateralMotion;
use crate::laws::contact::{Contact, WallLaw};
use crate::laws::motor::StringEnd;
use crate::laws::torque::{LoadLine, TorqueLaw};
use crate::line::Torsion;
use crate::port::{PortTorque, Turned, meet_bit, meet_cut};
use crate::wavering::Wavering;

/// Turns in which a drive whose torque is limited and the ports below it have to agree.
const MOST_TURNS_OF_DRIVE: usize = 100;

impl<B: TorqueLaw, W: WallLaw> Stepper<'_, B, W> {
    /// The bit's law, where nothing else acts: its answer is put together where it is kept.
    #[inline]
    pub(super) fn meet_bit_alone(&mut self, torsion: &Torsion) -> Result<(), SimulationError> {
        let Some((law, port)) = self.bit else {
            return Ok(());
        };
        let bit = law.meet(&self.bit_state, self.line(torsion, port));
        let (torque, speed) = (bit.torque, bit.speed);
        self.now.bit = Some(bit);
        self.take_up::<true>(torsion, Some((port, StringEnd { torque, speed })))
    }

    /// The bit's law, where no other port has to agree with it.
    #[inline]
    pub(super) fn meet_bit(&mut self, torsion: &Torsion) -> Result<(), SimulationError> {
        let line = |port: usize| self.line(torsion, port);
        let motor = self.motor.as_ref();
        let met = match (self.bit, &self.axial) {
            (None, None) => {
                let line = line(0);
                (self.drive.as_mut()).map(|drive| {
                    let (_, end) = drive.meet((0, line), |line| ((), free_end(line)));
                    (0, end)
                })
            }
            (Some((law, port)), _) => {
                let line = line(port);
                let act = |line| meet_bit(law, &self.bit_state, motor, line);
                let (bit, end) = match &mut self.drive {
                    None => act(line),
                    Some(drive) => drive.meet((port, line), act),
                };
                self.now.bit = Some(bit);
                Some((port, end))
            }
            (None, Some((axial, port))) => {
                let line = line(*port);
                let act = |line| meet_cut(axial, motor, line);
                let (cut, end) = match &mut self.drive {
                    None => act(line),
                    Some(drive) => drive.meet((*port, line), act),
                };
                self.now.cut = Some(cut);
                Some((*port, end))
            }
        };
        self.take_up::<false>(torsion, met)
    }

    /// The load line of a port: how its speed depends on its torque within this step.
    #[inline]
    fn line(&self, torsion: &Torsion, port: usize) -> LoadLine {
        LoadLine {
            time: self.now.time,
            free_speed: self.free[port],
            compliance: torsion.instant(port, port),
        }
    }

    /// The speeds of all ports from what the only one answers that bears a load.
    #[inline]
    fn take_up<const BIT: bool>(
        &mut self,
        torsion: &Torsion,
        met: Option<(usize, StringEnd)>,
    ) -> Result<(), SimulationError> {
        let speeds = &mut self.now.speeds;
        match met {
            None => speeds.copy_from_slice(&self.free),
            Some((port, end)) => {
                let free = self.free.iter().enumerate();
                for (speed, (index, free)) in speeds.iter_mut().zip(free) {
                    *speed = free + torsion.instant(index, port) * end.torque;
                    if let (Some(drive), false) = (&self.drive, BIT) {
                        *speed += drive.turns(index);
                    }
                }
                speeds[port] = end.speed;
                self.coupling.set_torque(port, end.torque);
            }
        }
        match speeds.iter().position(|speed| !speed.is_finite()) {
            None => Ok(()),
            Some(port) => Err(self.system.not_finite(port, self.now.time)),
        }
    }

    /// All laws of all ports, and the drive above them whose torque is limited: in turn, as the ports
    /// hardly feel the surface within a step.
    pub(super) fn meet_all_and_drive(&mut self) -> Result<(), SimulationError> {
        let (mut asked_for, mut given) = (None, 0.0);
        for _ in 0..MOST_TURNS_OF_DRIVE {
            let Some(drive) = &mut self.drive else {
                return Ok(());
            };
            let torques = self.coupling.loads().iter().map(|load| load.torque);
            let turned = drive.turned_by(torques);
            if asked_for.is_some_and(|before: f64| drive.is_negligible(turned - before)) {
                return Ok(());
            }
            let extra = drive.answer(turned);
            for (port, free) in self.free.iter_mut().enumerate() {
                *free += drive.turns_by(port, extra - given);
            }
            (asked_for, given) = (Some(turned), extra);
            self.meet_all::<false>()?;
        }
        let time = self.now.time;
        Err(SimulationError::NotSettled { time })
    }

    /// The laws of walls, where no others act.
    #[inline]
    pub(super) fn meet_walls(&mut self) -> Result<(), SimulationError> {
        self.arch.dispatch(MeetWalls(self))
    }

    /// All laws of all ports at once; `WALLS` where none acts but those of walls.
    #[inline(always)]
    pub(super) fn meet_all<const WALLS: bool>(&mut self) -> Result<(), SimulationError> {
        let Self {
            system,
            bit,
            friction,
            within,
            lateral,
            axial,
            motor,
            coupling,
            bit_state,
            rubbed,
            free,
            now,
            ..
        } = self;
        let (system, lateral, time) = (*system, lateral.as_ref(), now.time);
        let motor = motor.as_ref();
        let free = Free {
            positions: lateral.map_or(&[], LateralMotion::free_positions),
            turning: free,
        };
        let mut wavering = Wavering::default();
        let settled = coupling.settle(
            free,
            #[inline(always)]
            |port, unloaded: Unloaded| {
                let line = LoadLine {
                    time,
                    free_speed: unloaded.speed,
                    compliance: within.compliance(port),
                };
                let wall = lateral.and_then(|lateral| Some((lateral, lateral.wall_at(port)?)));
                let before;
                let torque = match (&*bit, &*axial, friction.get(port)) {
                    _ if WALLS => PortTorque::Free,
                    (Some((law, at)), _, _) if *at == port => {
                        before = wavering.released().unwrap_or(bit_state).clone();
                        PortTorque::Bit(*law, &before, motor)
                    }
                    (_, Some((axial, at)), _) if *at == port => PortTorque::Cut(axial, motor),
                    (_, _, Some(Some(law))) => PortTorque::Pipe(law, &rubbed[port]),
                    _ => PortTorque::Free,
                };
                let guess = unloaded.guess.unwrap_or(now.speeds[port]);
                let of_contact =
                    |error| SimulationError::of_contact(error, system.torsion.loaded()[port], time);
                let (law, solved) = match wall {
                    None => {
                        let turn = torque.turn(line, guess);
                        let solved = torque.solved(&turn, &Contact::NONE);
                        (turn.law, solved)
                    }
                    Some((lateral, (at, wall))) if torque.is_free() => {
                        let met = lateral.meet(at, wall, (&unloaded, &now.contacts[at]), line);
                        let (contact, solved) = met.map_err(of_contact)?;
                        now.contacts[at] = contact;
                        (Turned::Free, solved)
                    }
                    Some((lateral, (at, wall))) => {
                        let approach = lateral.approach(at, (&unloaded, &now.contacts[at]), line);
                        let met = torque.turn_at_wall(wall, &approach, line, guess);
                        let (contact, turn) = met.map_err(of_contact)?;
                        let mut solved = torque.solved(&turn, &contact);
                        if let Some(spring) = lateral.spring(at) {
                            solved.take_back(spring, contact.position);
                        }
                        now.contacts[at] = contact;
                        (turn.law, solved)
                    }
                };
                if !(solved.speed.is_finite() && solved.load.torque.is_finite()) {
                    return Err(system.not_finite(port, time));
                }
                now.speeds[port] = solved.speed;
                match law {
                    Turned::Free => {}
                    Turned::Bit(answer) => {
                        wavering.see(bit.map(|(law, _)| law.motion(&answer)), &answer.state);
                        now.bit = Some(answer);
                    }
                    Turned::Cut(cut) => now.cut = Some(cut),
                    Turned::Pipe(pipe) => now.rubbing[port] = pipe.state,
                }
                Ok(solved)
            },
        )?;
        match settled {
            true => Ok(()),
            false => Err(SimulationError::NotSettled { time }),
        }
    }
}

/// [`Stepper::meet_all`] of walls with the instructions that the processor has: of three operands, they need
/// fewer copies, which are a tenth of it. Of other laws, whose parts are not in one place, they spare nothing.
struct MeetWalls<'a, 'b, B: TorqueLaw, W: WallLaw>(&'a mut Stepper<'b, B, W>);

impl<B: TorqueLaw, W: WallLaw> WithSimd for MeetWalls<'_, '_, B, W> {
    type Output = Result<(), SimulationError>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        self.0.meet_all::<true>()
    }
}

/// The end of a string that nothing acts on.
fn free_end(line: LoadLine) -> StringEnd {
    StringEnd {
        torque: 0.0,
        speed: line.free_speed,
    }
}
