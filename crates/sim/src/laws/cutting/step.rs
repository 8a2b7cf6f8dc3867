//! Where a bit that cuts stands, and what it does in a step.

/// Where a bit stands.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BitPlace {
    /// φ, rad.
    pub angle: f64,
    /// U, m, from where it began, down.
    pub depth: f64,
    /// The deepest that it was since it last turned, m.
    pub deepest: f64,
    /// Its speed in the last step, rad/s.
    pub speed: f64,
}

/// What a bit does in a step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct CutStep {
    /// ω, rad/s.
    pub speed: f64,
    /// v, m/s, down.
    pub rate: f64,
    /// T: against the rotation, N m; negative where the rock keeps it from turning back.
    pub torque: f64,
    /// W: weight on bit, N.
    pub weight: f64,
    /// Depth of cut of a blade, the mean of all, m; negative off bottom.
    pub depth_of_cut: f64,
    /// Depth of cut of the blade that cuts deepest, m.
    pub deepest_cut: f64,
    /// Whether any blade touches rock.
    pub touches: bool,
    /// φ where the law is met, rad.
    pub angle: f64,
    /// U there, m.
    pub depth: f64,
}

impl CutStep {
    /// How deep the rock is that the blades leave behind, m, the mean of all: the deeper of where they
    /// are and what they found.
    pub fn rock_left(&self) -> f64 {
        self.depth + (-self.depth_of_cut).max(0.0)
    }
}
