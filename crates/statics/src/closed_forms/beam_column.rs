//! A span under a uniform load and an axial force (S. P. Timoshenko and J. M. Gere, *Theory of
//! Elastic Stability*, 2nd ed., 1961, chapter 1).
//!
//! With u = (L/2) √(P/EI), in tension with the functions of the hyperbola,
//!
//! ```text
//! pinned ends: y = 5qL⁴/(384 EI) η,  η = 12(2 sec u − 2 − u²)/(5u⁴);  M = qL²/8 λ,  λ = 2(sec u − 1)/u²
//! fixed ends:  y =  qL⁴/(384 EI) η′, η′ = 12(2 tan(u/2) − u)/u³;
//!              M = qL²/24 ψ in the middle, ψ = 6(u − sin u)/(u² sin u), and −qL²/12 χ at the ends,
//!              χ = 3(tan u − u)/(u² tan u)
//! ```

use std::f64::consts::PI;

use super::trigonometry::{cosine, sine_ratio, tangent_ratio};

/// Below this u² the differences above lose digits, and their series are taken.
const SMALL: f64 = 1e-3;

/// A span of a beam.
///
/// ```
/// use statics::closed_forms::BeamColumn;
///
/// let span = BeamColumn { length: 10.0, rigidity: 17e6, load: 1600.0, compression: 0.0 };
/// let pinned = span.with_pinned_ends().ok_or("it does not buckle")?;
/// assert!((pinned.middle_moment - 1600.0 * 100.0 / 8.0).abs() < 1e-6);
/// let pushed = BeamColumn { compression: 0.5 * span.pinned_buckling_load(), ..span };
/// let pushed = pushed.with_pinned_ends().ok_or("it does not buckle")?;
/// assert!((pushed.deflection / pinned.deflection - 2.003620).abs() < 1e-6);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamColumn {
    /// Length L, m.
    pub length: f64,
    /// EI, N m².
    pub rigidity: f64,
    /// Load q, N/m.
    pub load: f64,
    /// Axial force P, N; tension where negative.
    pub compression: f64,
}

/// How a span is bent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentSpan {
    /// Of its middle, m.
    pub deflection: f64,
    /// Moment in the middle, N m; positive where it is bent as a pinned span is by its weight.
    pub middle_moment: f64,
    /// Moment at its ends, N m.
    pub end_moment: f64,
}

impl BeamColumn {
    /// P under which the span buckles between pinned ends, N. Reaching it is necessary and
    /// sufficient. A row of equal spans over supports that do not hold slopes is bent by its weight
    /// as between fixed ends, but buckles under this.
    pub fn pinned_buckling_load(&self) -> f64 {
        self.rigidity * (PI / self.length).powi(2)
    }

    /// The same between fixed ends.
    pub fn fixed_buckling_load(&self) -> f64 {
        4.0 * self.pinned_buckling_load()
    }

    /// u², below zero in tension.
    fn square(&self) -> f64 {
        0.25 * self.length * self.length * self.compression / self.rigidity
    }

    /// With ends that are pinned; none where it buckles.
    pub fn with_pinned_ends(&self) -> Option<BentSpan> {
        let z = self.square();
        let secant = 1.0 / cosine(z);
        let [deflection, moment] = match z.abs() < SMALL {
            true => [
                1.0 + z * (61.0 / 150.0 + z * 277.0 / 1680.0),
                1.0 + z * (5.0 / 12.0 + z * 61.0 / 360.0),
            ],
            false => [
                2.4 * (2.0 * secant - 2.0 - z) / (z * z),
                2.0 * (secant - 1.0) / z,
            ],
        };
        (self.compression < self.pinned_buckling_load()).then(|| BentSpan {
            deflection: 5.0 * self.deflection_unit() * deflection,
            middle_moment: self.load * self.length.powi(2) / 8.0 * moment,
            end_moment: 0.0,
        })
    }

    /// With ends whose slopes are held; none where it buckles.
    pub fn with_fixed_ends(&self) -> Option<BentSpan> {
        let z = self.square();
        let (sine, tangent) = (sine_ratio(z), tangent_ratio(z));
        let [deflection, middle, end] = match z.abs() < SMALL {
            true => [
                1.0 + z * (0.1 + z * 17.0 / 1680.0),
                (1.0 - z * (0.05 - z / 840.0)) / (1.0 - z * (1.0 / 6.0 - z / 120.0)),
                (1.0 + z * (0.4 + z * 17.0 / 105.0)) / (1.0 + z * (1.0 / 3.0 + z * 2.0 / 15.0)),
            ],
            false => [
                12.0 * (tangent_ratio(0.25 * z) - 1.0) / z,
                6.0 * (1.0 - sine) / (z * sine),
                3.0 * (tangent - 1.0) / (z * tangent),
            ],
        };
        let unit = self.load * self.length.powi(2);
        (self.compression < self.fixed_buckling_load()).then(|| BentSpan {
            deflection: self.deflection_unit() * deflection,
            middle_moment: unit / 24.0 * middle,
            end_moment: -unit / 12.0 * end,
        })
    }

    /// qL⁴/(384 EI), m.
    fn deflection_unit(&self) -> f64 {
        self.load * self.length.powi(4) / (384.0 * self.rigidity)
    }
}
