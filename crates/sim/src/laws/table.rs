//! Torque between bit and rock as a table of the bit's speed: stuck up to T_s, turning at ω
//! against T(ω), joined by straight lines from row to row and constant beyond the last.
//!
//! ```
//! use sim::TabulatedFriction;
//!
//! // Dry friction that falls, and viscous friction that rises, have a valley between them.
//! let torque = |speed: f64| 3000.0 + 900.0 * (-speed).exp() + 60.0 * speed;
//! let law = TabulatedFriction::sampled(torque, 40.0, 400);
//! assert_eq!(law.torque_static, 3900.0);
//! let valley = 15f64.ln();
//! assert!((law.torque_at(valley) - torque(valley)).abs() < 1.0);
//! assert!(law.torque_at(valley) < law.torque_at(1.0).min(law.torque_at(6.0)));
//! ```

use super::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, in_order, not_negative};

/// A torque law of the bit by its values: measured ones, or those of any function.
///
/// Where load line and table meet more than once, the bit takes the speed that a little inertia
/// would take it to: from the speed that it had, upwards or downwards, to the first at which line
/// and table agree; on its way down it may stick.
#[derive(Debug, Clone, PartialEq)]
pub struct TabulatedFriction {
    /// T_s, N m: the most torque that a stuck bit holds; no less than that of the first row.
    pub torque_static: f64,
    /// Speed (rad/s), either way, and the torque against it (N m); speeds increase from zero.
    pub rows: Vec<(f64, f64)>,
}

impl TabulatedFriction {
    /// The table of a function from speed (rad/s) to torque (N m), in equal steps up to a
    /// speed; a stuck bit holds what it has at rest.
    pub fn sampled(torque: impl Fn(f64) -> f64, fastest: f64, steps: usize) -> Self {
        let speed = |step: usize| fastest * step as f64 / steps.max(1) as f64;
        let row = |step: usize| (speed(step), torque(speed(step)));
        Self {
            torque_static: torque(0.0),
            rows: (0..=steps).map(row).collect(),
        }
    }

    /// Torque (N m) against a bit that turns at a speed (rad/s), whichever way.
    pub fn torque_at(&self, speed: f64) -> f64 {
        self.piece(self.piece_of(speed)).torque_at(speed)
    }

    /// The row at or below a speed, where the next straight line begins.
    fn piece_of(&self, speed: f64) -> usize {
        let above = self.rows.partition_point(|row| row.0 <= speed);
        above.saturating_sub(1)
    }

    fn piece(&self, index: usize) -> Piece {
        let (from, torque) = self.rows[index];
        let slope = self.rows.get(index + 1).map(|(to, next)| {
            let slope = (next - torque) / (to - from);
            (*to, slope)
        });
        let (to, slope) = slope.unwrap_or((f64::INFINITY, 0.0));
        Piece {
            from,
            to,
            torque,
            slope,
        }
    }

    /// The speed, zero or more, that a bit takes which had a speed that way, where its load line
    /// leaves `driven` without a torque.
    fn turning(&self, before: f64, driven: f64, compliance: f64) -> f64 {
        let excess = |speed: f64| speed + compliance * self.torque_at(speed) - driven;
        let first = self.piece_of(before);
        if excess(before) <= 0.0 {
            let mut pieces = (first..self.rows.len()).map(|index| self.piece(index));
            let met = pieces.find_map(|piece| piece.meet(before, driven, compliance));
            // The last piece has no end, and is met.
            return met.unwrap_or(driven);
        }
        let mut pieces = (0..=first).rev().map(|index| self.piece(index));
        let below = pieces.find(|piece| excess(piece.from) <= 0.0);
        below
            .and_then(|piece| piece.meet(piece.from, driven, compliance))
            .unwrap_or(0.0)
    }

    fn slide(&self, speed: f64, line: LoadLine) -> Option<TorqueStep<f64>> {
        let direction = line.free_speed.signum();
        if speed <= 0.0 {
            return None;
        }
        let torque = -direction * self.torque_at(speed);
        let speed = line.free_speed + line.compliance * torque;
        (direction * speed > 0.0).then_some(TorqueStep {
            torque,
            speed,
            state: speed,
        })
    }
}

/// A straight line of the table.
struct Piece {
    from: f64,
    to: f64,
    torque: f64,
    slope: f64,
}

impl Piece {
    fn torque_at(&self, speed: f64) -> f64 {
        self.torque + self.slope * (speed - self.from)
    }

    /// The speed at which a load line meets it, where that is no lower than one at which the line
    /// leaves more speed than there is.
    fn meet(&self, least: f64, driven: f64, compliance: f64) -> Option<f64> {
        let least = least.max(self.from);
        let steepness = 1.0 + compliance * self.slope;
        let missing = driven - least - compliance * self.torque_at(least);
        let speed = least + missing / steepness;
        // What falls as steeply as the line, or more, is not met from below.
        (steepness > 0.0 && speed <= self.to).then_some(speed)
    }
}

impl TorqueLaw for TabulatedFriction {
    /// The speed, rad/s; zero where it is stuck.
    type State = f64;

    fn meet(&self, before: &f64, line: LoadLine) -> TorqueStep<f64> {
        let direction = line.free_speed.signum();
        let driven = direction * line.free_speed;
        let torque = -line.free_speed / line.compliance;
        let continues = direction * before > 0.0;
        let slips = torque.abs() > self.torque_static;
        let speed = match continues {
            true => self.turning(direction * before, driven, line.compliance),
            false if slips => self.turning(0.0, driven, line.compliance),
            false => 0.0,
        };
        self.slide(speed, line).unwrap_or(TorqueStep {
            torque,
            speed: 0.0,
            state: 0.0,
        })
    }

    fn turning_at(&self, speed: f64) -> f64 {
        speed
    }

    fn largest_drop(&self) -> f64 {
        let least = self
            .rows
            .iter()
            .map(|row| row.1)
            .fold(f64::INFINITY, f64::min);
        self.torque_static - least
    }

    fn holds(&self) -> Option<f64> {
        Some(self.torque_static)
    }

    fn is_constant_in_slip(&self) -> bool {
        self.rows.windows(2).all(|pair| pair[0].1 == pair[1].1)
    }

    fn is_autonomous(&self) -> bool {
        true
    }

    fn check(&self) -> Result<(), SceneError> {
        let first = self.rows.first().copied().unwrap_or((f64::NAN, f64::NAN));
        not_negative("static torque of the bit in N m", self.torque_static)?;
        if first.0 != 0.0 {
            return Err(SceneError::OutOfRange {
                quantity: "first speed of the bit's table in rad/s",
                value: first.0,
                expected: "zero",
            });
        }
        in_order(
            "speed of the bit's table in rad/s",
            self.rows.iter().map(|row| row.0),
        )?;
        for (_, torque) in &self.rows {
            not_negative("torque of the bit's table in N m", *torque)?;
        }
        if self.torque_static < first.1 {
            return Err(SceneError::Torques {
                torque_static: self.torque_static,
                torque_dynamic: first.1,
            });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::bit::BitTorque;
    use proptest::prelude::*;

    /// Falls, rises again, and falls slowly.
    fn wavy() -> TabulatedFriction {
        TabulatedFriction {
            torque_static: 2.0,
            rows: vec![(0.0, 1.6), (0.5, 0.4), (1.0, 1.2), (3.0, 0.9)],
        }
    }

    fn line(free_speed: f64, compliance: f64) -> LoadLine {
        LoadLine {
            time: 0.0,
            free_speed,
            compliance,
        }
    }

    proptest! {
        /// Load line and law hold together; a bit that turns on has gone no further from its speed
        /// than to the first at which they do, by a dense scan.
        #[test]
        fn a_table_is_met_where_a_little_inertia_comes_to_rest(
            free_speed in -8.0..8.0f64,
            compliance in 1e-2..1e1f64,
            before in prop_oneof![Just(0.0), -4.0..4.0f64],
        ) {
            let law = wavy();
            let step = law.meet(&before, line(free_speed, compliance));
            let on_line = free_speed + compliance * step.torque;
            let rounding = 1e-12 * (free_speed.abs() + compliance);
            prop_assert!((step.speed - on_line).abs() <= rounding);
            prop_assert_eq!(step.state, step.speed);
            if step.speed == 0.0 {
                prop_assert!(step.torque.abs() <= law.torque_static);
                return Ok(());
            }
            let speed = step.speed.abs();
            prop_assert!((step.torque.abs() - law.torque_at(speed)).abs() <= 1e-9);
            prop_assert!(step.torque * step.speed < 0.0);
            let excess = |speed: f64| speed + compliance * law.torque_at(speed) - free_speed.abs();
            let from = if before * step.speed > 0.0 { before.abs() } else { 0.0 };
            let passed = |index: i32| from + f64::from(index) / 1000.0 * (speed - from);
            let way = (1..1000).map(passed).map(excess);
            let side = excess(from);
            for excess in way {
                prop_assert!(excess * side >= -1e-9, "{excess} {side}");
            }
        }

        /// A table of one row is the law of the paper.
        #[test]
        fn one_row_is_the_built_in_law(
            free_speed in -8.0..8.0f64,
            compliance in 1e-2..1e1f64,
            before in prop_oneof![Just(0.0), -4.0..4.0f64],
        ) {
            let built_in = BitTorque { torque_static: 1.5, torque_dynamic: 1.0, decay_speed: 0.0 };
            let table = TabulatedFriction { torque_static: 1.5, rows: vec![(0.0, 1.0)] };
            let load_line = line(free_speed, compliance);
            let expected = built_in.meet(&built_in.turning_at(before), load_line);
            let found = table.meet(&before, load_line);
            prop_assert_eq!((found.torque, found.speed), (expected.torque, expected.speed));
        }
    }

    #[test]
    fn what_is_no_table_is_refused() {
        let with = |torque_static: f64, rows: &[(f64, f64)]| TabulatedFriction {
            torque_static,
            rows: rows.to_vec(),
        };
        let good = [(0.0, 1.0), (1.0, 0.5)];
        assert_eq!(with(1.0, &good).check(), Ok(()));
        for bad in [
            with(0.9, &good),
            with(f64::NAN, &good),
            with(1.0, &[]),
            with(1.0, &[(0.1, 1.0)]),
            with(1.0, &[(0.0, 1.0), (0.0, 0.5)]),
            with(1.0, &[(0.0, 1.0), (f64::NAN, 0.5)]),
            with(1.0, &[(0.0, 1.0), (1.0, -0.5)]),
            with(1.0, &[(0.0, 1.0), (1.0, f64::INFINITY)]),
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }
}
