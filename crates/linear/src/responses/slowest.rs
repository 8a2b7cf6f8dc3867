//! How slowly torsional motion of a string dies away at least, known without finding its modes.
//!
//! A motion φ(x) e^(λt) satisfies m λ² + c λ + k = 0, with m, c and k the integrals of inertia and
//! damping over |φ|² and of stiffness over |dφ/dx|², a top drive's included (P. Lancaster,
//! *Lambda-Matrices and Vibrating Systems*, Pergamon 1966). For any shape c ≥ 2αm and k ≥ κc:
//!
//! - α is half the damping over the inertia of the heaviest tube, or of the drive where that is
//!   damped less.
//! - 1/κ is the greatest ratio c/k. The sum of all such ratios of a string, ∫ c_t F dx with F
//!   the flexibility from the surface down to x, is a quarter more than the greatest of a uniform
//!   string. A drive that is held by its integral gain adds its own.
//!
//! So no motion dies away more slowly than at the lesser of both rates. A scheme in time gives each
//! motion a factor per step that follows from the same m, c and k, and may be much nearer to 1 than
//! e^(λ/f_s): Newmark's scheme leaves 0.96 in each step of what is faster than its sampling, with
//! γ = 0.52, however strongly that is damped.

use crate::drillstring::{Drillstring, Tube};
use crate::elements::newmark::Weights;

/// How a response is made from step to step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scheme {
    /// Waves that are handed on from piece to piece of a lattice.
    Lattice,
    /// Two-step backward differences.
    BackwardDifferences,
    /// Finite elements by Newmark's scheme.
    Newmark(Weights),
    /// The trapezoidal rule.
    Trapezoidal,
}

/// The least loss of any motion in a step, as the logarithm of its amplitude before over that
/// after: 0 where no such number is known, `None` where some motion never decays.
pub(super) fn loss_per_step(
    string: &Drillstring,
    scheme: Scheme,
    sampling_frequency: f64,
) -> Option<f64> {
    if !string.loss().damps_torsion() {
        return None;
    }
    if string.loss().has_memory() && scheme != Scheme::Trapezoidal {
        // Loss that depends on frequency has no such bound in closed form.
        return Some(0.0);
    }
    let (vibrates, seeps) = (vibrating_rate(string), seeping_rate(string));
    let rate = vibrates.min(seeps) / sampling_frequency;
    match scheme {
        Scheme::Trapezoidal => None,
        // A drive without its own damping.
        _ if rate == 0.0 => Some(0.0),
        // Each piece takes the same part of every wave.
        Scheme::Lattice => Some(rate),
        // δ(ζ) = 3/2 − 2ζ + ζ²/2 has a real part of (1 − R²)/2 at least where |ζ| ≤ R: there is no
        // root unless R² > 1 + 2·rate.
        Scheme::BackwardDifferences => Some(0.5 * (2.0 * rate).ln_1p()),
        Scheme::Newmark(weights) => Some(weights.least_loss(2.0 * vibrates, seeps)),
    }
}

/// α, 1/s.
fn vibrating_rate(string: &Drillstring) -> f64 {
    let moments = string
        .tubes()
        .map(|(_, tube)| string.section_constant(tube));
    let heaviest = string.material().density * moments.fold(0.0, f64::max);
    let of_tubes = string.torsional_damping() / (2.0 * heaviest);
    // A drive without inertia does not vibrate by itself.
    let inert = string.top_drive().filter(|drive| drive.inertia > 0.0);
    // One that answers late gives at high frequencies what it takes at low ones.
    if string.top_drive().is_some_and(|drive| drive.delay > 0.0) {
        return 0.0;
    }
    let of_drive = inert.map(|drive| drive.proportional_gain / (2.0 * drive.inertia));
    of_drive.map_or(of_tubes, |of_drive| of_tubes.min(of_drive))
}

/// κ, 1/s.
fn seeping_rate(string: &Drillstring) -> f64 {
    let held = (string.top_drive()).map_or(0.0, |drive| match drive.integral_gain {
        // The string may turn as a whole, at rates of the drive and of its own damping. All
        // other shapes are stiffer for their damping than those with the surface held.
        0.0 => 0.0,
        gain => {
            let damping = string.torsional_damping() * string.length();
            (drive.proportional_gain + damping) / gain
        }
    });
    (seeping_time(string) + held).recip()
}

/// ∫ c_t F dx, s.
fn seeping_time(string: &Drillstring) -> f64 {
    let modulus = string.modulus();
    let flexibility = |tube: &Tube| tube.length / (modulus * string.section_constant(tube));
    // Flexibility above, and its integral.
    let (mut above, mut sum) = (0.0, 0.0);
    for section in string.sections() {
        let (mut of_cell, mut within) = (0.0, 0.0);
        for tube in &section.parts {
            within += tube.length * (of_cell + 0.5 * flexibility(tube));
            of_cell += flexibility(tube);
        }
        let cells = section.repeat as f64;
        let of_cells_above = above + 0.5 * (cells - 1.0) * of_cell;
        sum += cells * (within + section.cell_length() * of_cells_above);
        above += cells * of_cell;
    }
    string.torsional_damping() * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drillstring::{Material, Section};

    /// A uniform string of any number of cells.
    fn uniform(cells: usize) -> Drillstring {
        let tube = |length| Tube {
            length,
            inner_radius: 0.04,
            outer_radius: 0.06,
        };
        let length = 1000.0 / cells as f64;
        let section = Section {
            repeat: cells,
            parts: vec![tube(0.9 * length), tube(0.1 * length)],
        };
        let steel = Material {
            density: 7850.0,
            shear_modulus: 79.3e9,
        };
        Drillstring::new(steel, vec![section], 5.0).unwrap()
    }

    /// ½ c_t L²/(GJ), in any division.
    #[test]
    fn a_uniform_string_seeps_at_the_rate_of_its_closed_form() {
        for cells in [1, 2, 7, 100] {
            let string = uniform(cells);
            let moment = string.sections()[0].parts[0].polar_moment();
            let expected = 0.5 * 5.0 * 1e6 / (79.3e9 * moment);
            assert!(
                (seeping_time(&string) / expected - 1.0).abs() < 1e-12,
                "{cells}"
            );
        }
    }
}
