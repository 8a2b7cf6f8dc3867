//! How a string that lies on the low side of a straight hole swings about it.
//!
//! At y aside it lies y²/(2c) higher: a spring q/c per metre. With a wavenumber k along the string
//!
//! ```text
//! frictionless:                m ω² = EI k⁴ − P k² + q/c
//! rolling, free in torsion:    (m + ρJ/R²) ω² = EI k⁴ − (P − GJ/R²) k² + q/c
//! ```
//!
//! for rolling without slip turns it by θ′ = −c φ′/R. Held in torsion it does not move until it
//! slips. Both are for small angles; [`with_amplitude`] has larger ones, where k is 0. A speed of
//! rotation at such a frequency is necessary for unbalance to make a string that slides snake much,
//! and not sufficient.

use std::f64::consts::TAU;

/// A uniform string on the low side.
///
/// ```
/// use statics::closed_forms::LyingPipe;
///
/// let pipe = LyingPipe {
///     mass: 325.0,
///     load: 1600.0,
///     rigidity: 17e6,
///     compression: 0.0,
///     clearance: 0.054,
///     radius: 0.1016,
///     spin_inertia: 1.294,
///     torsional_rigidity: 13.07e6,
/// };
/// // Rolling it turns as well, and is slower.
/// assert!(pipe.rolling(0.0) < pipe.frictionless(0.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LyingPipe {
    /// Mass per length m that moves sideways, with the mud's, kg/m.
    pub mass: f64,
    /// Buoyed weight across the hole q, N/m.
    pub load: f64,
    /// EI, N m².
    pub rigidity: f64,
    /// P, N; tension where negative.
    pub compression: f64,
    /// Clearance c, m.
    pub clearance: f64,
    /// Outer radius R, m.
    pub radius: f64,
    /// ρJ, kg m.
    pub spin_inertia: f64,
    /// GJ, N m².
    pub torsional_rigidity: f64,
}

impl LyingPipe {
    /// Frequency without friction, Hz, at a wavenumber (rad/m) along the string; not finite where
    /// it buckles sideways.
    pub fn frictionless(&self, wavenumber: f64) -> f64 {
        self.frequency(wavenumber, 0.0, 0.0)
    }

    /// Frequency rolling without slip, free in torsion, Hz.
    pub fn rolling(&self, wavenumber: f64) -> f64 {
        let square = self.radius * self.radius;
        self.frequency(
            wavenumber,
            self.spin_inertia / square,
            self.torsional_rigidity / square,
        )
    }

    fn frequency(&self, wavenumber: f64, mass: f64, tension: f64) -> f64 {
        let square = wavenumber * wavenumber;
        let stiffness = self.rigidity * square * square - (self.compression - tension) * square
            + self.load / self.clearance;
        (stiffness / (self.mass + mass)).sqrt() / TAU
    }

    /// The angle of climb in steady sliding rotation with a coefficient of friction, rad: atan μ.
    /// It swings about that faster, by the fourth root of 1 + μ², and with constant friction
    /// nothing but damping stops it.
    pub fn sliding(&self, friction: f64) -> f64 {
        self.frictionless(0.0) * friction.hypot(1.0).sqrt()
    }
}

/// A frequency of small swings, by an amplitude (rad) about the low side: that of a pendulum (by
/// the arithmetic-geometric mean).
///
/// ```
/// use statics::closed_forms::with_amplitude;
///
/// assert!((with_amplitude(1.0, 0.5) - 0.984_4).abs() < 1e-4);
/// ```
pub fn with_amplitude(frequency: f64, amplitude: f64) -> f64 {
    let (mut arithmetic, mut geometric) = (1.0_f64, (0.5 * amplitude).cos());
    while (arithmetic - geometric).abs() > 1e-15 {
        (arithmetic, geometric) = (
            0.5 * (arithmetic + geometric),
            (arithmetic * geometric).sqrt(),
        );
    }
    frequency * arithmetic
}
