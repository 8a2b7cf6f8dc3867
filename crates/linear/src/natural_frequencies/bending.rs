//! Bending waves without damping, the surface held as the support says and the bit free, unless
//! that or places above it are held.

use num_complex::Complex64;

use crate::assembly::block::Block;
use crate::assembly::nodes::{Relation, StiffnessBetween};
use crate::bending::{Bending, SurfaceSupport};
use crate::drillstring::Drillstring;
use crate::spans::SurroundedSpan;
use crate::waves::bending::short_part;

/// A stretch of a string that bends, above the bit or above a place where it is held.
#[derive(Debug, Clone)]
pub struct Stretch {
    /// Cut where what is around it changes.
    pub span: SurroundedSpan,
    /// Whether its lower end is held.
    pub ends_held: bool,
}

/// What holds a place, N/m: so stiff that rounding hides what it gives way.
const HELD: f64 = 1e100;

/// Natural frequencies below ω (rad/s); none where that is one of a piece to the last bit, or
/// beyond all measure, so that nothing can be counted.
///
/// Node by node from the bit up, tubes are cut into parts so short that none of them has a
/// natural frequency below ω with both ends held: J₀ = 0. A clamped beam has none where
/// (kL)⁴/500.6 + C L²/(4π² E I) < 1 (Rayleigh's principle: 500.6 for the first of a clamped beam,
/// 4π² where that buckles), and parts have kL and C L²/(E I) of at most 1.
pub fn below(
    string: &Drillstring,
    (bending, support): (&Bending, SurfaceSupport),
    stretches: &[Stretch],
    omega: f64,
) -> Option<usize> {
    let s = Complex64::new(0.0, omega);
    let mut negative = 0;
    // What the string below a node opposes to its motion.
    let mut below = Block::zero();
    for stretch in stretches.iter().rev() {
        if stretch.ends_held {
            below.0[0][0] += HELD;
        }
        for surrounded in stretch.span.iter().rev() {
            let around = surrounded.around;
            let bending = bending.under(around.tension);
            for run in surrounded.runs.iter().rev() {
                let parts = run.parts.iter().rev().map(|tube| {
                    let mass = string.mass_sideways(tube, around.hole_radius);
                    short_part(&bending, tube, mass, s)
                });
                let parts: Vec<_> = parts.collect();
                for (part, halvings) in (0..run.repeat).flat_map(|_| &parts) {
                    let ends = part.between_ends();
                    for _ in 0..1_u64.checked_shl(*halvings)? {
                        negative += negative_eigenvalues(ends.bottom + below);
                        // Next to a natural frequency of what is below, that opposes far more than
                        // the part: between its ends, no digits are lost to the difference. Far
                        // less is opposed to slow motions: seen from its top, none are lost to it.
                        below = if is_softer(below, ends.bottom) {
                            part.above(below)
                        } else {
                            ends.above(below)
                        };
                    }
                }
            }
        }
    }
    let Block([[force, _], [_, moment]]) = below;
    negative += match support {
        SurfaceSupport::Free => negative_eigenvalues(below),
        SurfaceSupport::Pinned => usize::from(moment.re < 0.0),
        SurfaceSupport::Clamped => 0,
    };
    (force.re.is_finite() && moment.re.is_finite()).then_some(negative)
}

/// Into how many parts that cuts the string.
pub fn pieces(string: &Drillstring, bending: &Bending, stretches: &[Stretch], omega: f64) -> f64 {
    let s = Complex64::new(0.0, omega);
    let surrounded = stretches.iter().flat_map(|stretch| &stretch.span);
    let parts = surrounded.flat_map(|surrounded| {
        let around = surrounded.around;
        let bending = bending.under(around.tension);
        let runs = surrounded.runs.iter();
        let tubes = runs.flat_map(|run| run.parts.iter().map(|tube| (run.repeat, tube)));
        tubes.map(move |(repeat, tube)| {
            let mass = string.mass_sideways(tube, around.hole_radius);
            let (_, halvings) = short_part(&bending, tube, mass, s);
            repeat as f64 * f64::from(halvings).exp2()
        })
    });
    parts.sum()
}

/// Whether each entry of a block is smaller than that of another.
fn is_softer(one: Block<Complex64>, other: Block<Complex64>) -> bool {
    let entries = one.0.iter().flatten().zip(other.0.iter().flatten());
    let mut sizes = entries.map(|(one, other)| (one.re.abs(), other.re.abs()));
    sizes.all(|(one, other)| one <= other)
}

/// Negative eigenvalues of a symmetric block of real numbers: as many as negative pivots.
fn negative_eigenvalues(Block([[a, b], [_, d]]): Block<Complex64>) -> usize {
    let (first, second) = (a.re, d.re - b.re * b.re / a.re);
    usize::from(first < 0.0) + usize::from(second < 0.0)
}

/// No natural frequency that tension or stiffness brings back is below this, rad/s: that of a
/// uniform beam as slack and as heavy as the slackest and the heaviest tube, clamped at one end
/// (Rayleigh's principle), without compression.
pub fn least(string: &Drillstring, bending: &Bending) -> f64 {
    const CANTILEVER: f64 = 3.516;
    let slackest = string.tubes().map(|(_, tube)| tube.second_moment());
    let rigidity = bending.youngs_modulus * slackest.fold(f64::INFINITY, f64::min);
    let around = string.surroundings();
    let masses = string.tubes().flat_map(|(_, tube)| {
        let holes = around.iter().map(|stretch| stretch.around.hole_radius);
        // A tube is not everywhere, and need not be narrower than every hole.
        let fits = holes.filter(|hole| hole.is_none_or(|radius| radius > tube.outer_radius));
        fits.map(|hole| string.mass_sideways(tube, hole))
    });
    let heaviest = masses.fold(0.0, f64::max);
    CANTILEVER * (rigidity / heaviest).sqrt() / string.length().powi(2)
}
