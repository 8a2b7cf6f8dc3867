//! Torsional waves in a uniform tube (Eqs. 1–3).

use crate::assembly::number::Number;
use crate::assembly::torsion::DynamicStiffness;
use crate::distributed_loss::LossAt;
use crate::drillstring::{Drillstring, Tube};

/// Dynamic stiffness of one uniform tube at the Laplace variable `s` (rad/s):
/// G J γ coth γL and −G J γ csch γL with γ² = s(c_t + sρJ)/(GJ). In a `hole` (its radius, m) of
/// viscous mud, and of a material with loss, c_t grows to c(s) and G to G m(s) (see
/// [`crate::loss`]).
pub fn uniform<T: Number>(
    string: &Drillstring,
    (tube, hole): (&Tube, Option<f64>),
    s: T,
    loss: &LossAt<'_, T>,
) -> DynamicStiffness<T> {
    let material = string.material();
    let section = string.section_constant(tube);
    let rigidity = string.modulus() * section;
    let inertia = material.density * section;
    let mut damped = s * inertia + string.torsional_damping();
    if let Some(mud) = loss.drag_on(tube, hole) {
        damped = damped + mud;
    }
    let mut squared = s * damped * rigidity.recip();
    let stiffening = loss.stiffening();
    if let Some(stiffening) = stiffening {
        squared = squared * stiffening.inverse();
    }
    let (coth, csch) = scaled_coth_csch(squared.root() * tube.length);
    let static_stiffness = rigidity / tube.length;
    let (driving, cross) = match stiffening {
        None => (coth * static_stiffness, csch * -static_stiffness),
        Some(stiffening) => {
            let stiffness = stiffening * static_stiffness;
            (coth * stiffness, csch * -stiffness)
        }
    };
    DynamicStiffness {
        top: driving,
        cross,
        bottom: driving,
    }
}

/// x coth x and x csch x for Re x ≥ 0, by decaying exponentials only, so that
/// nothing overflows however long or fast the wave.
fn scaled_coth_csch<T: Number>(x: T) -> (T, T) {
    // Below this the closed form loses digits to 1 − e^(−2x), and the next
    // term of the series is below rounding.
    const SMALL: f64 = 1e-2;
    let small = (x.squares()).filter(|square| *square < SMALL * SMALL);
    match small.count() {
        0 => {
            let decay = x.each(|x| (-x).exp());
            let round_trip = decay * decay;
            let scale = x * (-round_trip + 1.0).inverse();
            (scale * (round_trip + 1.0), scale * decay * 2.0)
        }
        count if count == T::LANES => {
            let x2 = x * x;
            let coth = x2 * (2.0 / 21.0) - 1.0;
            let coth = x2 * coth * (1.0 / 15.0) + 1.0;
            let csch = x2 * (-31.0 / 294.0) + 1.0;
            let csch = x2 * csch * (-7.0 / 60.0) + 1.0;
            (
                x2 * coth * (1.0 / 3.0) + 1.0,
                x2 * csch * (-1.0 / 6.0) + 1.0,
            )
        }
        _ => (
            x.each(|x| scaled_coth_csch(x).0),
            x.each(|x| scaled_coth_csch(x).1),
        ),
    }
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    #[test]
    fn series_and_closed_form_meet() {
        for angle in [0.0, 0.7, 1.5] {
            let direction = Complex64::from_polar(1.0, angle);
            let below = scaled_coth_csch(direction * 0.009_999_999);
            let above = scaled_coth_csch(direction * 0.010_000_001);
            assert!((below.0 - above.0).norm() < 1e-10);
            assert!((below.1 - above.1).norm() < 1e-10);
            let x = direction * 0.009;
            let exact = (x * x.cosh() / x.sinh(), x / x.sinh());
            let series = scaled_coth_csch(x);
            assert!((series.0 - exact.0).norm() < 1e-13);
            assert!((series.1 - exact.1).norm() < 1e-13);
        }
    }

    #[test]
    fn a_tube_of_any_length_has_finite_stiffness() {
        let (coth, csch) = scaled_coth_csch(Complex64::new(1e6, 1e6));
        assert!((coth / Complex64::new(1e6, 1e6) - 1.0).norm() < 1e-15);
        assert_eq!(csch.norm(), 0.0);
    }
}
