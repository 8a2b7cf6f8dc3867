//! The rock that blades have left, over the angle of the bit.

/// The most blades of a bit that are not evenly spaced.
pub const MOST_PROFILES: usize = 20;

/// What each blade has left where it was when the bit was at an angle, joined by straight lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// Angles of the bit at which steps ended, rad, rising: the last is the furthest it has turned.
    angles: Vec<f64>,
    /// What each blade had then left, m; of even blades what any had.
    depths: Vec<Vec<f64>>,
    /// From each blade to the one before, rad.
    apart: Vec<f64>,
    /// A place near the one that the first blade meets next.
    near: usize,
    /// How the rock rises before all of that, m/rad: as blades leave it that advance steadily.
    advance: f64,
}

impl Face {
    /// Of a bit at the angle and depth zero.
    pub(super) fn new(apart: Vec<f64>, advance: f64) -> Self {
        Self {
            angles: vec![0.0],
            depths: vec![vec![0.0]; apart.len()],
            apart,
            near: 0,
            advance,
        }
    }

    /// The furthest that the bit has turned, rad.
    pub(crate) fn furthest(&self) -> f64 {
        self.angles[self.angles.len() - 1]
    }

    /// Of the rock before a blade when the bit is at an angle: its depth, m, and how it changes with
    /// the angle, m/rad. Where the blade has been it is what the blade itself has left.
    pub(super) fn ahead(&self, blade: usize, angle: f64) -> (f64, f64) {
        if angle < self.furthest() {
            return self.left_by(blade, angle);
        }
        let before = (blade + self.depths.len() - 1) % self.depths.len();
        self.left_by(before, angle - self.apart[blade])
    }

    /// What a blade has left where it was at an angle of the bit.
    fn left_by(&self, blade: usize, angle: f64) -> (f64, f64) {
        let depths = &self.depths[blade];
        if angle <= self.angles[0] {
            // Steady blades were all as far below one another.
            return (
                depths[0] + self.advance * (angle - self.angles[0]),
                self.advance,
            );
        }
        if angle >= self.furthest() {
            // Past the blade: a step that ends there is refused.
            return (depths[depths.len() - 1], 0.0);
        }
        let above = self.place_of(angle);
        let ([from, to], [low, high]) = (
            [self.angles[above - 1], self.angles[above]],
            [depths[above - 1], depths[above]],
        );
        let rise = (high - low) / (to - from);
        (low + rise * (angle - from), rise)
    }

    /// The first angle that is not below one, looked for from where a blade's edge was last.
    fn place_of(&self, angle: f64) -> usize {
        let count = self.angles.len();
        let (mut low, mut high) = (self.near, self.near);
        let mut reach = 1;
        while high < count && self.angles[high] < angle {
            low = high + 1;
            high = (high + reach).min(count);
            reach *= 2;
        }
        while low > 0 && self.angles[low - 1] >= angle {
            high = low - 1;
            low = low.saturating_sub(reach);
            reach *= 2;
        }
        low + self.angles[low..high].partition_point(|it| *it < angle)
    }

    /// Angles of the bit at which a piece of the rock before a blade ends, from a far one back.
    pub(super) fn corners_between(&self, from: f64, to: f64) -> Vec<f64> {
        let mut corners: Vec<f64> = (self.apart.iter().chain([&0.0]))
            .flat_map(|apart| {
                let [first, last] = [from - apart, to - apart].map(|angle| self.place_of(angle));
                self.angles[first..last]
                    .iter()
                    .map(move |angle| angle + apart)
            })
            .filter(|angle| (from..to).contains(angle))
            .collect();
        corners.push(from);
        corners.sort_by(|one, other| other.total_cmp(one));
        corners
    }

    /// The steepest rise of the rock before a blade between two angles of the bit, m/rad.
    pub(super) fn steepest(&self, from: f64, to: f64) -> f64 {
        let corners = self.corners_between(from, to);
        let ends = corners.iter().chain([&to]);
        let rises = ends.flat_map(|angle| {
            let before = angle - 1e-12 * to.abs();
            (0..self.depths.len()).map(move |blade| self.ahead(blade, before).1)
        });
        rises.fold(0.0, f64::max)
    }

    /// Ends a step of the bit at an angle and a depth: where no blade was before, each leaves the
    /// deeper of where it is and what it found.
    pub(crate) fn leave(&mut self, angle: f64, depth: f64) {
        if angle <= self.furthest() {
            return;
        }
        let found: [f64; MOST_PROFILES] =
            std::array::from_fn(|blade| match blade < self.depths.len() {
                true => self.ahead(blade, angle).0,
                false => 0.0,
            });
        for (depths, found) in self.depths.iter_mut().zip(found) {
            depths.push(depth.max(found));
        }
        self.angles.push(angle);
        self.near = self
            .place_of(angle - self.apart[0])
            .min(self.angles.len() - 1);
    }

    /// Bytes of a case of a number of steps.
    pub(crate) fn bytes(profiles: usize, steps: f64) -> f64 {
        linear::budget::REAL * (1 + profiles) as f64 * steps
    }
}
