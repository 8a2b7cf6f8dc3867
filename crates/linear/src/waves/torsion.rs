//! Torsional waves in a uniform tube (Eqs. 1–3).

use num_complex::Complex64;

use crate::assembly::torsion::DynamicStiffness;
use crate::drillstring::{Drillstring, Tube};

/// Dynamic stiffness of one uniform tube at the Laplace variable `s` (rad/s): its ends are
/// linked by G J γ csch γL, and carried along by G J γ tanh ½γL each, with
/// γ² = s(c_t + sρJ)/(GJ).
pub fn uniform(string: &Drillstring, tube: &Tube, s: Complex64) -> DynamicStiffness {
    let material = string.material();
    let polar_moment = tube.polar_moment();
    let rigidity = material.shear_modulus * polar_moment;
    let inertia = material.density * polar_moment;
    let wavenumber = (s * (string.torsional_damping() + s * inertia) / rigidity).sqrt();
    let (tanh, csch) = scaled_tanh_csch(wavenumber * tube.length);
    let static_stiffness = rigidity / tube.length;
    let carried = tanh * static_stiffness;
    DynamicStiffness {
        top: carried,
        link: csch * static_stiffness,
        bottom: carried,
    }
}

/// x tanh ½x and x csch x for Re x ≥ 0, by decaying exponentials only, so that
/// nothing overflows however long or fast the wave.
fn scaled_tanh_csch(x: Complex64) -> (Complex64, Complex64) {
    // Below this the closed form loses digits to 1 − e^(−x), and the next terms of the
    // series are below rounding.
    const SMALL: f64 = 0.1;
    if x.norm() < SMALL {
        let x2 = x * x;
        let tanh = x2 / 2.0
            * (1.0
                - x2 / 12.0
                    * (1.0
                        - x2 / 10.0 * (1.0 - x2 * (17.0 / 168.0) * (1.0 - x2 * (31.0 / 306.0)))));
        let csch = 1.0
            - x2 / 6.0
                * (1.0
                    - x2 * (7.0 / 60.0)
                        * (1.0 - x2 * (31.0 / 294.0) * (1.0 - x2 * (127.0 / 1240.0))));
        (tanh, csch)
    } else {
        let decay = (-x).exp();
        let tanh = x * (1.0 - decay) / (1.0 + decay);
        (tanh, 2.0 * x * decay / (1.0 - decay * decay))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_form_meet() {
        for angle in [0.0, 0.7, 1.5] {
            let direction = Complex64::from_polar(1.0, angle);
            let below = scaled_tanh_csch(direction * (0.1 * (1.0 - 1e-15)));
            let above = scaled_tanh_csch(direction * (0.1 * (1.0 + 1e-15)));
            assert!((below.0 - above.0).norm() < 1e-14 * above.0.norm());
            assert!((below.1 - above.1).norm() < 1e-14);
            let x = direction * 0.09;
            let exact = (x * (x / 2.0).tanh(), x / x.sinh());
            let series = scaled_tanh_csch(x);
            assert!((series.0 - exact.0).norm() < 1e-14 * exact.0.norm());
            assert!((series.1 - exact.1).norm() < 1e-14);
        }
    }

    #[test]
    fn a_tube_of_any_length_has_finite_stiffness() {
        let (tanh, csch) = scaled_tanh_csch(Complex64::new(1e6, 1e6));
        assert!((tanh / Complex64::new(1e6, 1e6) - 1.0).norm() < 1e-15);
        assert_eq!(csch.norm(), 0.0);
    }
}
