//! Into how many pieces a string is cut for the friction along it: by what becomes of the torque
//! at its surface when friction acts in the middles of pieces instead of all along.
//!
//! A string at rest is wound up by its surface so slowly that nothing swings. Down to some depth
//! d it then turns against its friction, and below it stands still. With f the friction per
//! length, F its sum from the surface and C that of the compliance 1/(GJ), the torque at the
//! surface is F(d), and as that grows, all of what turns is twisted by it: dφ = C(d) dF. With
//! friction in the middles m of pieces dφ = C(m) dF, over the torque of each: straight pieces
//! instead of a curve. Both are proportional to the coefficient of friction, so that what they
//! differ by, in parts of the torque at which the whole string breaks loose, is not.
//!
//! The uppermost piece, with half of its compliance above its middle, is off by a quarter of its
//! friction; deeper ones are by less, as the string above them is soft, and may even make up for
//! one another. Not so in a string that is started at speed: the wave that sets it in motion feels
//! no more of the string than it has passed just now, and every piece is taken for one below the
//! surface. (Measured on random strings: `crates/sim/tests/validation/pieces.rs`.)

use thiserror::Error;

/// A short length of string, from the surface down.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    /// m.
    pub length: f64,
    /// That friction may exert on it, N m.
    pub torque: f64,
    /// rad per N m and metre.
    pub compliance: f64,
}

/// The surface of a string that is wound up under friction all along it.
#[derive(Debug, Clone, PartialEq)]
pub struct QuasiStaticTwist {
    /// Where stretches end, the surface first.
    ends: Vec<Front>,
}

/// What turns down to a depth.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Front {
    /// m.
    depth: f64,
    /// F, N m.
    torque: f64,
    /// C, rad/N m.
    compliance: f64,
    /// φ of the surface, rad.
    angle: f64,
}

/// What the torque at the surface is off by for the friction of a piece there, in parts of that.
const OF_UPPERMOST: f64 = 0.25;

impl Front {
    /// A part of the way to the `next`, between which friction and compliance are even.
    fn towards(self, next: Self, part: f64) -> Self {
        let on_the_way = |from: f64, to: f64| from + part * (to - from);
        let torque = on_the_way(self.torque, next.torque);
        let compliance = on_the_way(self.compliance, next.compliance);
        Self {
            depth: on_the_way(self.depth, next.depth),
            torque,
            compliance,
            angle: self.angle + 0.5 * (self.compliance + compliance) * (torque - self.torque),
        }
    }
}

/// No number of pieces is near enough to friction all along.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "no number of pieces up to {most} keeps to {tolerance}: the nearest, {pieces}, is off by {off:.6}"
)]
pub struct TooFine {
    /// What was asked for.
    pub tolerance: f64,
    /// Pieces that were tried.
    pub most: usize,
    /// Those that come nearest.
    pub pieces: usize,
    /// What they are off by.
    pub off: f64,
}

/// The least number of pieces, up to the `most`, that are [off](QuasiStaticTwist::off_by) by no more than
/// a `tolerance`, however the string is pressed on its well.
///
/// # Errors
/// Where there is none.
pub fn least_pieces(
    windings: &[QuasiStaticTwist],
    tolerance: f64,
    most: usize,
) -> Result<usize, TooFine> {
    let mut nearest = (0, f64::INFINITY);
    for pieces in 1..=most {
        let off = |winding: &QuasiStaticTwist| winding.off_by(&winding.friction_torques(pieces));
        let off = windings.iter().map(off).fold(0.0, f64::max);
        if off <= tolerance {
            return Ok(pieces);
        }
        if off < nearest.1 {
            nearest = (pieces, off);
        }
    }
    let (pieces, off) = nearest;
    Err(TooFine {
        tolerance,
        most,
        pieces,
        off,
    })
}

impl QuasiStaticTwist {
    pub(super) fn new(stretches: impl Iterator<Item = Stretch>) -> Self {
        let mut above = Front::default();
        let mut ends = vec![above];
        for stretch in stretches {
            let below = Front {
                depth: above.depth + stretch.length,
                torque: above.torque + stretch.torque,
                compliance: above.compliance + stretch.compliance * stretch.length,
                angle: 0.0,
            };
            above = above.towards(below, 1.0);
            ends.push(above);
        }
        Self { ends }
    }

    /// The torque at which all of the string turns, per coefficient of friction, N m.
    pub fn break_off_torque(&self) -> f64 {
        self.bottom().torque
    }

    /// Torque that the wall may exert on each of a number of equal pieces of the string, per
    /// coefficient of friction, N m.
    pub fn friction_torques(&self, pieces: usize) -> Vec<f64> {
        let mut above = 0.0;
        let of_next = |piece: usize| {
            let torque = self.at_depth((piece + 1) as f64 / pieces as f64).torque;
            torque - std::mem::replace(&mut above, torque)
        };
        (0..pieces).map(of_next).collect()
    }

    /// By how much the torque at the surface is off at most, in parts of that at which the
    /// string breaks loose, where friction that does not fall with speed acts in the middles of
    /// equal pieces, so much on each (N m per coefficient), instead of all along: wound up slowly,
    /// and, as estimated, started at speed.
    pub fn off_by(&self, torques: &[f64]) -> f64 {
        let largest = torques.iter().copied().fold(0.0, f64::max);
        self.in_parts(OF_UPPERMOST * largest)
            .max(self.off_when_wound_up(torques))
    }

    /// The same of a string that is wound up slowly from rest.
    pub fn off_when_wound_up(&self, torques: &[f64]) -> f64 {
        let mut off: f64 = 0.0;
        // As far as it is wound up under friction in the middles.
        let (mut angle, mut torque) = (0.0, 0.0);
        for (piece, of_piece) in torques.iter().enumerate() {
            let turned = self.at_depth((piece as f64 + 0.5) / torques.len() as f64);
            let torque_to = torque + of_piece;
            let angle_to = angle + turned.compliance * of_piece;
            // The curve grows ever less. So it is farthest above a straight line where both are
            // as steep, which is when what turns ends in the middle, and farthest below it at an
            // end.
            if angle < turned.angle && turned.angle < angle_to {
                let on_line = torque + (turned.angle - angle) / turned.compliance;
                off = off.max((turned.torque - on_line).abs());
            }
            (angle, torque) = (angle_to, torque_to);
            off = off.max((self.torque_at(angle) - torque).abs());
        }
        self.in_parts(off)
    }

    /// What turns down to a part of the string.
    fn at_depth(&self, part: f64) -> Front {
        let depth = part * self.bottom().depth;
        self.to(
            |front| front.depth,
            depth,
            |from, to| (depth - from.depth) / (to.depth - from.depth),
        )
    }

    /// A torque in parts of that at which the string breaks loose; of none, nothing.
    fn in_parts(&self, torque: f64) -> f64 {
        match self.break_off_torque() {
            0.0 => 0.0,
            whole => torque / whole,
        }
    }

    /// Torque at the surface when that has turned by an angle (rad), both per coefficient of
    /// friction, N m.
    pub fn torque_at(&self, angle: f64) -> f64 {
        let turned = self.to(
            |front| front.angle,
            angle,
            |from, to| {
                // C x + ½ ΔC x² = Δφ/ΔF for the part x of the way.
                let (grown, sought) = (
                    to.compliance - from.compliance,
                    (angle - from.angle) / (to.torque - from.torque),
                );
                let root = (from.compliance.powi(2) + 2.0 * grown * sought).sqrt();
                2.0 * sought / (from.compliance + root)
            },
        );
        turned.torque
    }

    /// The front at which something that grows downwards reaches a value, at the given fraction of
    /// the way from one end of a stretch to the other.
    fn to(
        &self,
        of: impl Fn(&Front) -> f64,
        value: f64,
        part: impl Fn(&Front, &Front) -> f64,
    ) -> Front {
        let next = self.ends.partition_point(|end| of(end) < value);
        match (self.ends.get(next.saturating_sub(1)), self.ends.get(next)) {
            (Some(from), Some(to)) if next > 0 => from.towards(*to, part(from, to)),
            (_, Some(first)) => *first,
            _ => self.bottom(),
        }
    }

    fn bottom(&self) -> Front {
        self.ends.last().copied().unwrap_or_default()
    }
}
