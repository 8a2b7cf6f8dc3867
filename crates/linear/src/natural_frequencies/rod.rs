//! Waves without damping along a rod that twists or stretches, the bit free, the surface held or, of
//! a string that hangs, free.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::drillstring::Drillstring;

/// Natural frequencies below ω (rad/s): as many as places at rest on a string that swings so fast
/// with its bit free. With k = ω √(ρ/G), a tube turns as cos(kx − ψ) at the height x above its
/// lower end; these places are its J₀ + s(K), and a phase has no poles.
///
/// An upper end that is free to move with a mass m adds s(−E A k tan ψ − m ω²), the stiffness there.
pub fn below(string: &Drillstring, hanging: Option<f64>, omega: f64) -> Option<usize> {
    let wavenumber = omega / string.torsional_wave_speed();
    let mut at_rest = 0.0;
    // The phase at the upper end of the tubes so far, within a quarter turn; and its tube's J.
    let (mut phase, mut moment) = (0.0_f64, 1.0);
    for section in string.sections().iter().rev() {
        for tube in (0..section.repeat).flat_map(|_| section.parts.iter().rev()) {
            // Rotation and torque G J k sin are those of the tube below.
            let own = string.section_constant(tube);
            let lower_end = (moment * phase.sin()).atan2(own * phase.cos());
            let upper_end = lower_end + wavenumber * tube.length;
            let passed = (upper_end / PI + 0.5).floor();
            at_rest += passed;
            phase = (upper_end - passed * PI).clamp(-FRAC_PI_2, FRAC_PI_2);
            moment = own;
        }
    }
    let is_free = hanging.is_some_and(|mass| {
        let pulled = string.modulus() * moment * wavenumber * phase.tan();
        pulled + mass * omega * omega > 0.0
    });
    at_rest
        .is_finite()
        .then_some(at_rest as usize + usize::from(is_free))
}

/// No natural frequency is below this, rad/s: that of a uniform string as slack and as heavy as
/// the slackest and the heaviest tube, a quarter of a wave long (Rayleigh's principle).
pub fn least(string: &Drillstring) -> f64 {
    let moments = || {
        string
            .tubes()
            .map(|(_, tube)| string.section_constant(tube))
    };
    let slackest = moments().fold(f64::INFINITY, f64::min);
    let heaviest = moments().fold(0.0, f64::max);
    let quarter = FRAC_PI_2 / string.length();
    quarter * string.torsional_wave_speed() * (slackest / heaviest).sqrt()
}
