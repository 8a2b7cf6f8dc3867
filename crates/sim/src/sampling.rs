//! How time is cut into steps, and where in a step its loads and motion are taken.

/// The sampling of responses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Sampling frequency f_s, Hz.
    pub frequency: f64,
    /// The part of a step that is still to go when its loads and motion are taken (see
    /// [`linear::Method::collocation_offset`]).
    pub collocation_offset: f64,
    /// The way of a whole step per way gone, 1/(1 − collocation_offset).
    whole_way: f64,
}

impl Sampling {
    /// At a frequency (Hz), with the [`linear::Method::collocation_offset`] of a method.
    pub fn new(frequency: f64, collocation_offset: f64) -> Self {
        Self {
            frequency,
            collocation_offset,
            whole_way: 1.0 / (1.0 - collocation_offset),
        }
    }

    /// Time at which a step begins, s.
    pub fn start_of(&self, step: usize) -> f64 {
        step as f64 / self.frequency
    }

    /// Time of a step's loads and motion, s.
    pub fn time_of(&self, step: usize) -> f64 {
        (step as f64 + self.collocation_offset) / self.frequency
    }

    /// Where a site is at the end of a step, from where it is in it and at its beginning:
    /// within a step it moves straight on.
    pub fn end_of_step(&self, position: [f64; 2], beginning: [f64; 2]) -> [f64; 2] {
        let end = |axis: usize| {
            (position[axis] - self.collocation_offset * beginning[axis]) * self.whole_way
        };
        [end(0), end(1)]
    }

    /// Velocity in a step per distance from where the site was at its beginning, Hz.
    pub fn rate_in_step(&self) -> f64 {
        self.frequency * self.whole_way
    }
}
