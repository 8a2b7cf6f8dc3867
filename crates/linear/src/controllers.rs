//! Controllers of a top drive tuned to the string, and the reflection coefficient of a drive.
//!
//! ```
//! use linear::controllers::{impedance_matched, reflection, stiff};
//! use linear::estimates::first_mode;
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.02)?;
//! let frequency = first_mode(&string).frequency;
//! // Nearly all of a wave comes back from a stiff drive, with the opposite speed.
//! let from_stiff = reflection(&string, &stiff(&string, 2000.0), frequency);
//! assert!((from_stiff + 1.0).norm() < 0.03);
//! let from_matched = reflection(&string, &impedance_matched(&string), frequency);
//! assert!(from_matched.norm() < 0.06);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use num_complex::Complex64;

use crate::drillstring::Drillstring;
use crate::estimates::{FirstMode, first_mode, torsional_impedance};
use crate::top_drive::TopDrive;

/// K_p of a stiff drive, in impedances of the uppermost tube.
const STIFF: f64 = 100.0;

/// What a matched drive's integral gain opposes at the first mode, as a part of the impedance.
const KEEPS_THE_MEAN: f64 = 0.1;

/// Gains as of a plain speed controller: K_p is a hundred times the impedance of the
/// uppermost tube, so that the surface hardly feels the string, and K_i makes up for what
/// is missing within a radian of the first mode. The inertia in kg m².
pub fn stiff(string: &Drillstring, inertia: f64) -> TopDrive {
    let proportional_gain = STIFF * impedance_at_surface(string);
    TopDrive {
        inertia,
        proportional_gain,
        integral_gain: first_mode(string).frequency * proportional_gain,
        delay: 0.0,
        late_inertia: 0.0,
    }
}

/// The gains that damp the first mode most (soft torque), of a drive at least as heavy as
/// that. With a string that swings as one inertia J₁ at the end of a spring, at ω₁ with the
/// surface held, drive and string have two modes; the slower decays fastest where both are one:
/// K_i = ω₁² J, K_p = 2 ω₁ √(J J₁), each then with the damping ratio ½ √(J₁/J). The inertia J in
/// kg m².
///
/// After J. D. Jansen and L. van den Steen, *Journal of Sound and Vibration* 179 (1995),
/// 647–668; ω₁ and J₁ are those of the string's first mode ([`first_mode`]).
pub fn soft_torque(string: &Drillstring, inertia: f64) -> TopDrive {
    let FirstMode {
        frequency,
        inertia: of_string,
    } = first_mode(string);
    TopDrive {
        inertia,
        proportional_gain: 2.0 * frequency * (inertia * of_string).sqrt(),
        integral_gain: frequency * frequency * inertia,
        delay: 0.0,
        late_inertia: 0.0,
    }
}

/// The gain that lets waves out: K_p is the impedance J √(Gρ) of the uppermost tube, and
/// the inertia is made up for. The integral gain is there to keep the mean speed; at the
/// first mode's frequency it is a tenth of the impedance, so that 5 % come back there.
pub fn impedance_matched(string: &Drillstring) -> TopDrive {
    let impedance = impedance_at_surface(string);
    TopDrive {
        inertia: 0.0,
        proportional_gain: impedance,
        integral_gain: KEEPS_THE_MEAN * first_mode(string).frequency * impedance,
        delay: 0.0,
        late_inertia: 0.0,
    }
}

/// Reflection coefficient of a drive for waves in the uppermost tube at an angular frequency
/// (rad/s): the ratio of speeds (Z − Z_d)/(Z + Z_d), −1 for a surface that turns as prescribed.
pub fn reflection(string: &Drillstring, drive: &TopDrive, angular_frequency: f64) -> Complex64 {
    let impedance = impedance_at_surface(string);
    let of_drive = drive.impedance(Complex64::new(0.0, angular_frequency));
    (impedance - of_drive) / (impedance + of_drive)
}

fn impedance_at_surface(string: &Drillstring) -> f64 {
    torsional_impedance(string, &string.sections()[0].parts[0])
}
