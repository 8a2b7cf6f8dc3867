//! Bending waves in a uniform tube with pre-compression (Eqs. 19–26).
//!
//! The degrees of freedom at a node are the displacement x and the slope x′;
//! with them go the external force and moment, positive in the same
//! directions. A piece so short that waves hardly turn within it has a rapidly
//! converging power series; longer tubes are joined from equal pieces by
//! doubling, so that no exponential occurs and nothing overflows.

use crate::assembly::beam_stiffness::BeamStiffness;
use crate::assembly::bending::Beam;
use crate::assembly::block::Block;
use crate::assembly::chain::Stiffness;
use crate::assembly::nodes::Relation;
use crate::assembly::number::Number;
use crate::assembly::stiff_beam::{StiffBeam, turns};
use crate::bending::Bending;
use crate::drillstring::Tube;

/// The series is used where |k| times the length is below this, and the length
/// halved until it is.
const SHORT: f64 = 1.0;

/// The series has converged to rounding after this number of powers of the length.
const POWERS: usize = 26;

/// What a tube meets as it bends.
#[derive(Debug, Clone, Copy)]
pub struct Resistance<T> {
    /// Force per length and displacement q, N/m².
    pub foundation: T,
    /// What its modulus is multiplied by; `None` where the material has no loss.
    pub stiffening: Option<T>,
}

impl<T: Number> Resistance<T> {
    /// That of a mass per length (kg/m) and of constant damping at the Laplace variable `s`
    /// (rad/s).
    pub fn constant(bending: &Bending, mass: f64, s: T) -> Self {
        Self {
            foundation: s * (s * mass + bending.damping),
            stiffening: None,
        }
    }

    /// Over a modulus that is multiplied by something, compression and foundation are as much
    /// smaller, and the whole is multiplied by it afterwards: the foundation.
    fn per_modulus(&self) -> T {
        match self.stiffening {
            None => self.foundation,
            Some(stiffening) => self.foundation * stiffening.inverse(),
        }
    }
}

/// Dynamic stiffness of one uniform tube.
pub fn uniform<T: Number>(bending: &Bending, tube: &Tube, resistance: Resistance<T>) -> Beam<T> {
    let (mut stiffness, halvings) = short_part_of(bending, tube, resistance);
    for _ in 0..halvings {
        stiffness = stiffness.join(&stiffness);
    }
    stiffness
}

/// Of what one end of a tube feels of the other, e^(−2 · this) is lost in rounding.
const LOST: f64 = 20.7;

/// The same of a tube at whose ends nothing is felt of the other, as of a beam without end;
/// `None` of any other.
///
/// Its waves e^(λx) that die away downwards have λ₁λ₂ = q with q² the stiffness per metre that
/// E I x⁗ + C x″ + … asks for, over E I, and λ₁ + λ₂ = −σ with σ² = 2q − C/(E I). Then
/// x″ = −σ x′ − q x, and so on.
pub fn endless<T: Number>(
    bending: &Bending,
    tube: &Tube,
    resistance: Resistance<T>,
) -> Option<Beam<T>> {
    let rigidity = bending.youngs_modulus * tube.second_moment();
    let q = resistance.per_modulus();
    // A wave dies away no faster than it turns.
    if turns(bending, tube, q) < LOST {
        return None;
    }
    let compression = bending.compression / rigidity;
    let product = (q * rigidity.recip()).root();
    let less_compressed = |it: T| match resistance.stiffening {
        None => it - compression,
        Some(stiffening) => it - stiffening.inverse() * compression,
    };
    let sum = less_compressed(product * 2.0).root();
    let difference = less_compressed(product * -2.0).root();
    let dies_away = (0..T::LANES).all(|lane| {
        let slowest = 0.5 * (sum.lane(lane).re - difference.lane(lane).re);
        slowest * tube.length >= LOST
    });
    dies_away.then(|| {
        let along = match resistance.stiffening {
            None => sum * rigidity,
            Some(stiffening) => sum * stiffening * rigidity,
        };
        let across = match resistance.stiffening {
            None => product * rigidity,
            Some(stiffening) => product * stiffening * rigidity,
        };
        let (force, moment) = (across * sum, along);
        Beam::Long(BeamStiffness {
            top: Block([[force, across], [across, moment]]),
            cross: Block::zero(),
            bottom: Block([[force, -across], [-across, moment]]),
        })
    })
}

/// That of the part of a tube that is left after halving it repeatedly, until its waves turn by no
/// more than [`SHORT`].
pub fn short_part<T: Number>(bending: &Bending, tube: &Tube, mass: f64, s: T) -> (Beam<T>, u32) {
    short_part_of(bending, tube, Resistance::constant(bending, mass, s))
}

fn short_part_of<T: Number>(
    bending: &Bending,
    tube: &Tube,
    resistance: Resistance<T>,
) -> (Beam<T>, u32) {
    let rigidity = bending.youngs_modulus * tube.second_moment();
    // E I x⁗ + C x″ + q x = 0 (Eq. 20).
    let q = resistance.per_modulus();
    let mut length = tube.length;
    let mut halvings = 0;
    let mut turns = turns(bending, tube, q);
    // What has no size is refused when it is found to be no number.
    while turns > SHORT && turns.is_finite() {
        (turns, length) = (0.5 * turns, 0.5 * length);
        halvings += 1;
    }
    let compression = bending.compression * length * length / rigidity;
    let foundation = q * (length.powi(4) / rigidity);
    let unit = match resistance.stiffening {
        None => T::wide(
            #[inline(always)]
            || short_beam(compression, foundation),
        ),
        Some(stiffening) => T::wide(
            #[inline(always)]
            || short_beam(stiffening.inverse() * compression, foundation).multiplied(stiffening),
        ),
    };
    let short = StiffBeam {
        turns,
        ..scaled(&unit, rigidity, length)
    };
    (Beam::of(short), halvings)
}

/// What a solution of x⁗ + p x″ + Q x = 0 on (0, 1) with x^(j)(0)/j! = 1, and the other
/// derivatives up to the third zero at 0, has in addition to the rigid motion of its start.
struct Bent<T> {
    /// x, x′, x″, x‴ at 1.
    ends: [T; 4],
    /// The integrals of x and of ξ x.
    moments: [T; 2],
}

/// Compression over rigidity: a number, or one for each frequency where the modulus
/// depends on these.
trait Compression<T>: Copy {
    /// Whether it is zero.
    fn is_none(self) -> bool;

    /// As numbers are multiplied by it.
    fn times(self, number: T) -> T;

    /// As it is taken from numbers.
    fn taken_from(self, number: T) -> T;

    /// Multiplied by a number.
    fn multiplied(self, by: f64) -> Self;

    /// As what it is.
    fn number(self) -> T;
}

impl<T: Number> Compression<T> for f64 {
    fn is_none(self) -> bool {
        self == 0.0
    }

    fn times(self, number: T) -> T {
        number * self
    }

    fn taken_from(self, number: T) -> T {
        number - self
    }

    fn multiplied(self, by: f64) -> Self {
        self * by
    }

    fn number(self) -> T {
        T::real(self)
    }
}

impl<T: Number> Compression<T> for T {
    fn is_none(self) -> bool {
        self.squares().all(|square| square == 0.0)
    }

    fn times(self, number: T) -> T {
        number * self
    }

    fn taken_from(self, number: T) -> T {
        number - self
    }

    fn multiplied(self, by: f64) -> Self {
        self * by
    }

    fn number(self) -> T {
        self
    }
}

#[inline(always)]
fn power_series<T: Number>(p: impl Compression<T>, q: T, j: usize) -> Bent<T> {
    let zero = T::real(0.0);
    let mut coefficients = [zero; POWERS];
    coefficients[j] = T::real(1.0);
    // The others are zero.
    let (first, stride) = if p.is_none() { (j, 4) } else { (j % 2, 2) };
    for n in (first..POWERS - 4).step_by(stride) {
        let m = n as f64;
        let second = p
            .multiplied((m + 2.0) * (m + 1.0))
            .times(coefficients[n + 2]);
        let divisor = (m + 4.0) * (m + 3.0) * (m + 2.0) * (m + 1.0);
        let fourth = second + coefficients[n] * q;
        coefficients[n + 4] = coefficients[n + 4] - fourth * divisor.recip();
    }
    let mut bent = Bent {
        ends: [zero; 4],
        moments: [zero; 2],
    };
    // The first two are the rigid motion.
    for power in (first..POWERS).step_by(stride).rev().filter(|&n| n >= 2) {
        let (n, coefficient) = (power as f64, coefficients[power]);
        let falling = [1.0, n, n * (n - 1.0), n * (n - 1.0) * (n - 2.0)];
        for (end, factor) in bent.ends.iter_mut().zip(falling) {
            *end = *end + coefficient * factor;
        }
        for (moment, power) in bent.moments.iter_mut().zip([n + 1.0, n + 2.0]) {
            *moment = *moment + coefficient * power.recip();
        }
    }
    bent
}

/// Stiffness of a beam of unit length and rigidity.
#[inline(always)]
fn short_beam<T: Number>(p: impl Compression<T>, q: T) -> StiffBeam<T> {
    let (u0, u1) = (power_series(p, q, 0), power_series(p, q, 1));
    let (u2, u3) = (power_series(p, q, 2), power_series(p, q, 3));
    let constant = |rows: [[f64; 2]; 2]| Block(rows.map(|row| row.map(T::real)));
    // What it bends by: near · (x, x′)(0) + far · (a₂, a₃), with x″ = 2 a₂ and x‴ = 6 a₃.
    let motions = |u: &Bent<T>, v: &Bent<T>| Block([0, 1].map(|row| [u.ends[row], v.ends[row]]));
    let (near, far) = (motions(&u0, &u1), motions(&u2, &u3).inverse());
    // (force, moment) on the bottom: (−x‴ − p x′, x″).
    let force = |u: &Bent<T>| -u.ends[3] - p.times(u.ends[1]);
    let forces = |u: &Bent<T>, v: &Bent<T>| Block([[force(u), force(v)], [u.ends[2], v.ends[2]]]);
    let elastic = forces(&u2, &u3) * far;
    let zero = T::real(0.0);
    let by_slope = Block([[zero, p.multiplied(-1.0).number()], [zero, zero]]);
    // All that acts is Q ∫ x dξ and, about the top, Q ∫ ξ x dξ − p (x(1) − x(0)).
    let integrals =
        |u: &Bent<T>, v: &Bent<T>| Block([0, 1].map(|row| [u.moments[row], v.moments[row]]));
    let Block([[a, b], [c, d]]) = constant([[1.0, 0.5], [0.5, 1.0 / 3.0]]) + integrals(&u0, &u1)
        - integrals(&u2, &u3) * (far * near);
    StiffBeam {
        length: 1.0,
        turns: 0.0,
        elastic,
        mixed: forces(&u0, &u1) + by_slope - elastic * near,
        rigid: Block([[a * q, b * q], [c * q, p.taken_from(d * q)]]),
    }
}

/// From unit length and rigidity to the real ones.
fn scaled<T: Number>(beam: &StiffBeam<T>, rigidity: f64, length: f64) -> StiffBeam<T> {
    let scale = |Block([[a, b], [c, d]]): Block<T>| {
        let force = rigidity / length.powi(3);
        Block([
            [a * force, b * (force * length)],
            [c * (force * length), d * (force * length * length)],
        ])
    };
    StiffBeam {
        length,
        turns: beam.turns,
        elastic: scale(beam.elastic),
        mixed: scale(beam.mixed),
        rigid: scale(beam.rigid),
    }
}
