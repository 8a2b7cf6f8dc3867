//! The laws that act at one port, coupled: friction at a wall turns the bit that the rock
//! holds (Eq. 36).

use crate::axial_motion::AxialMotion;
use crate::coupling::{Load, Solved};
use crate::laws::contact::{Approach, Contact, ContactError, Resistance, Spin, WallLaw};
use crate::laws::cutting::CutStep;
use crate::laws::motor::{MotorMotion, StringEnd, meet_below};
use crate::laws::pipe::{OnLines, PipeMotion};
use crate::laws::torque::{LoadLine, TorqueLaw, TorqueStep};

/// The law of the torque on a port, with what it remembers of the last step.
#[derive(Debug)]
pub(crate) enum PortTorque<'a, B: TorqueLaw> {
    /// None acts.
    Free,
    /// That of the bit, below a motor where there is one.
    Bit(&'a B, &'a B::State, Option<&'a MotorMotion>),
    /// That of a bit that cuts.
    Cut(&'a AxialMotion<'a>, Option<&'a MotorMotion>),
    /// Friction of the pipe along its well.
    Pipe(&'a OnLines, &'a PipeMotion),
}

/// What came of the law of the torque on a port.
#[derive(Debug, Clone)]
pub(crate) enum Turned<S> {
    Free,
    Bit(TorqueStep<S>),
    Cut(CutStep),
    Pipe(TorqueStep<PipeMotion>),
}

/// How a port turns in a step.
#[derive(Debug, Clone)]
pub(crate) struct PortTurn<S> {
    /// The string there, under all torques on it.
    pub(crate) string: StringEnd,
    /// What its own law answered.
    pub(crate) law: Turned<S>,
}

impl<S> Turned<S> {
    /// Its torque, N m.
    fn torque(&self) -> f64 {
        match self {
            Self::Free => 0.0,
            Self::Bit(step) => step.torque,
            Self::Cut(step) => -step.torque,
            Self::Pipe(step) => step.torque,
        }
    }

    /// The speed that it leaves, where a law acts, rad/s.
    fn speed(&self) -> Option<f64> {
        match self {
            Self::Free => None,
            Self::Bit(step) => Some(step.speed),
            Self::Cut(step) => Some(step.speed),
            Self::Pipe(step) => Some(step.speed),
        }
    }
}

/// What a bit under a law does, and the end of its string.
#[inline]
pub(crate) fn meet_bit<B: TorqueLaw>(
    law: &B,
    before: &B::State,
    motor: Option<&MotorMotion>,
    line: LoadLine,
) -> (TorqueStep<B::State>, StringEnd) {
    let act = |line| law.meet(before, line);
    meet_below(motor, line, act, |bit| [bit.torque, bit.speed])
}

/// What a bit that cuts does, and the end of its string.
#[inline]
pub(crate) fn meet_cut(
    axial: &AxialMotion,
    motor: Option<&MotorMotion>,
    line: LoadLine,
) -> (CutStep, StringEnd) {
    let act = |line| axial.meet(line);
    meet_below(motor, line, act, |cut| [-cut.torque, cut.speed])
}

/// Solution of a port that a wall alone turns.
#[inline(always)]
pub(crate) fn turned_by_wall(contact: &Contact, line: LoadLine) -> Solved {
    Solved {
        load: Load {
            force: contact.force,
            torque: contact.torque,
        },
        normal_force: contact.normal_force,
        slack: 0.0,
        speed: line.free_speed + line.compliance * contact.torque,
        // What touches turns as the wall lets it.
        fall: (!contact.touches()).then_some(0.0),
    }
}

impl<B: TorqueLaw> PortTorque<'_, B> {
    /// Meets the load line of what the law acts on, which is not the string below a motor; a `guess` of
    /// the speed (rad/s) saves time.
    #[inline]
    fn meet(&self, line: LoadLine, guess: f64) -> Turned<B::State> {
        match self {
            Self::Free => Turned::Free,
            Self::Bit(law, before, _) => Turned::Bit(law.meet(before, line)),
            Self::Cut(axial, _) => Turned::Cut(axial.meet(line)),
            Self::Pipe(law, before) => Turned::Pipe(law.meet(before, line.free_speed, guess.abs())),
        }
    }

    /// The motor that turns what the law acts on.
    fn motor(&self) -> Option<&MotorMotion> {
        match self {
            Self::Bit(_, _, motor) | Self::Cut(_, motor) => *motor,
            Self::Free | Self::Pipe(..) => None,
        }
    }

    /// How far the torque falls at most where it slips, N m.
    fn largest_drop(&self) -> Option<f64> {
        match self {
            Self::Free => None,
            Self::Bit(law, ..) => Some(law.largest_drop()),
            // Its torque is continuous in the speed.
            Self::Cut(..) => Some(0.0),
            Self::Pipe(law, _) => Some(law.largest_drop()),
        }
    }

    /// By how much the torque against a port falls with its speed, N m per rad/s; that of the bit
    /// as if it stayed.
    fn fall(&self, speed: f64) -> f64 {
        match self {
            Self::Free | Self::Bit(..) | Self::Cut(..) => 0.0,
            Self::Pipe(law, _) => law.fall(speed.abs()),
        }
    }

    /// Meets the load line where there is no wall; a `guess` of the speed (rad/s) saves time.
    #[inline]
    pub(crate) fn turn(&self, line: LoadLine, guess: f64) -> PortTurn<B::State> {
        let act = |line| (self.meet(line, guess), line);
        let read = |(law, line): &(Turned<_>, LoadLine)| {
            [law.torque(), law.speed().unwrap_or(line.free_speed)]
        };
        let ((law, _), string) = meet_below(self.motor(), line, act, read);
        PortTurn { string, law }
    }

    /// Meets all load lines of a port at a wall; gives what the wall does, too. What is at the wall below
    /// a motor is the bit.
    #[inline]
    pub(crate) fn turn_at_wall<W: WallLaw>(
        &self,
        wall: &W,
        approach: &Approach,
        line: LoadLine,
        guess: f64,
    ) -> Result<(Contact, PortTurn<B::State>), ContactError> {
        let act = |line| self.meet_at_wall(wall, approach, line, guess);
        let read = |met: &Result<(Contact, Turned<_>, f64), _>| match met {
            Ok((contact, law, speed)) => [contact.torque + law.torque(), *speed],
            Err(_) => [0.0; 2],
        };
        let (met, string) = meet_below(self.motor(), line, act, read);
        met.map(|(contact, law, _)| (contact, PortTurn { string, law }))
    }

    /// What wall and law do on a load line of the body that both act on, and its speed, rad/s.
    #[inline]
    fn meet_at_wall<W: WallLaw>(
        &self,
        wall: &W,
        approach: &Approach,
        line: LoadLine,
        guess: f64,
    ) -> Result<(Contact, Turned<B::State>, f64), ContactError> {
        let turned = |free_speed: f64| self.meet(LoadLine { free_speed, ..line }, guess);
        let speed = |free: f64| turned(free).speed().unwrap_or(free);
        let resistance = self.largest_drop().map(|drop| Resistance {
            speed: &speed,
            jump: line.compliance * drop,
        });
        let spin = Spin {
            free_speed: line.free_speed,
            compliance: line.compliance,
            resistance,
        };
        let contact = wall.meet(&Approach { spin, ..*approach })?;
        let free_speed = line.free_speed + line.compliance * contact.torque;
        let law = turned(free_speed);
        let speed = law.speed().unwrap_or(free_speed);
        Ok((contact, law, speed))
    }

    /// What the others have to know of a port that has been solved, what its wall does given.
    #[inline]
    pub(crate) fn solved(&self, turn: &PortTurn<B::State>, at_wall: &Contact) -> Solved {
        let StringEnd { torque, speed } = turn.string;
        // What touches a wall, or is held, turns as that lets it.
        let is_held = at_wall.touches() || (speed == 0.0 && !self.is_free());
        Solved {
            load: Load {
                force: at_wall.force,
                torque,
            },
            normal_force: at_wall.normal_force,
            slack: 0.0,
            speed,
            fall: (!is_held).then(|| self.fall(speed)),
        }
    }

    /// Whether no torque acts but that of a wall.
    #[inline]
    pub(crate) fn is_free(&self) -> bool {
        matches!(self, PortTorque::Free)
    }
}
