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
    /// A place near the one that each blade meets next.
    near: Vec<usize>,
    /// How the rock rises before all of that, m/rad: as blades leave it that advance steadily.
    advance: f64,
}

/// A straight piece of rock before a blade.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Piece {
    /// Where the bit is, m.
    pub(super) depth: f64,
    /// m/rad.
    pub(super) rise: f64,
    /// Angles of the bit between which it goes, rad.
    pub(super) angles: [f64; 2],
}

impl Face {
    /// Of a bit at the angle and depth zero.
    pub(super) fn new(apart: Vec<f64>, advance: f64) -> Self {
        Self {
            angles: vec![0.0],
            depths: vec![vec![0.0]; apart.len()],
            near: vec![0; apart.len()],
            apart,
            advance,
        }
    }

    /// The furthest that the bit has turned, rad.
    pub(crate) fn furthest(&self) -> f64 {
        self.angles[self.angles.len() - 1]
    }

    /// Of the rock before a blade when the bit is at an angle: its depth, m, and how it changes with
    /// the angle, m/rad. Where the blade has been it is what the blade itself has left.
    #[inline]
    pub(super) fn ahead(&self, blade: usize, angle: f64) -> (f64, f64) {
        if angle < self.furthest() {
            return self.left_by(blade, angle, self.angles.len());
        }
        let ahead = angle - self.apart[blade];
        self.left_by(self.before(blade), ahead, self.near[blade])
    }

    /// The blade that was last where a blade is going.
    fn before(&self, blade: usize) -> usize {
        match blade {
            0 => self.depths.len() - 1,
            blade => blade - 1,
        }
    }

    /// What a blade has left where it was at an angle of the bit, looked for from a place.
    #[inline]
    fn left_by(&self, blade: usize, angle: f64, near: usize) -> (f64, f64) {
        self.left_at(blade, angle, self.place_of(angle, near))
    }

    /// The same with the first angle that is not below. A call would take as long as what it does.
    #[inline(always)]
    fn left_at(&self, blade: usize, angle: f64, above: usize) -> (f64, f64) {
        let depths = &self.depths[blade];
        if above == 0 {
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
        let rise = self.rise(blade, above);
        let low = above - 1;
        (depths[low] + rise * (angle - self.angles[low]), rise)
    }

    /// The straight piece of rock before a blade when the bit is at an angle; `None` where steps did not end
    /// before and behind it.
    #[inline]
    pub(super) fn piece_ahead(&self, blade: usize, angle: f64) -> Option<Piece> {
        let apart = self.apart[blade];
        let ahead = angle - apart;
        let above = self.place_of(ahead, self.near[blade]);
        if angle < self.furthest() || above == 0 || above == self.angles.len() {
            return None;
        }
        let (depth, rise) = self.left_at(self.before(blade), ahead, above);
        Some(Piece {
            depth,
            rise,
            angles: [self.angles[above - 1] + apart, self.angles[above] + apart],
        })
    }

    /// How what a blade has left rises up to the end of a step, m/rad.
    #[inline]
    fn rise(&self, blade: usize, above: usize) -> f64 {
        let (angles, depths) = (&self.angles[above - 1..=above], &self.depths[blade]);
        (depths[above] - depths[above - 1]) / (angles[1] - angles[0])
    }

    /// The first angle that is not below one, looked for from a place: most often it is there, or next to
    /// it.
    #[inline]
    fn place_of(&self, angle: f64, near: usize) -> usize {
        let around = near
            .checked_sub(1)
            .and_then(|low| self.angles.get(low..low + 3));
        match around {
            Some(&[before, here, next]) if before < angle && angle <= next => {
                near + usize::from(here < angle)
            }
            _ => self.place_searched(angle, near),
        }
    }

    /// The same wherever it is.
    fn place_searched(&self, angle: f64, near: usize) -> usize {
        let count = self.angles.len();
        let (mut low, mut high) = (near, near);
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
                let [first, last] =
                    [from - apart, to - apart].map(|angle| self.place_of(angle, self.near[0]));
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
        let furthest = self.furthest();
        let blades = self.apart.iter().enumerate();
        let rises = blades.map(|(blade, apart)| {
            let own = match from < furthest {
                true => {
                    let ends = [from, to.min(furthest)];
                    self.steepest_left_by(blade, ends, self.angles.len())
                }
                false => 0.0,
            };
            let ends = [from.max(furthest) - apart, to - apart];
            own.max(self.steepest_left_by(self.before(blade), ends, self.near[blade]))
        });
        rises.fold(0.0, f64::max)
    }

    /// The steepest rise of what a blade has left between two angles of the bit, m/rad.
    fn steepest_left_by(&self, blade: usize, ends: [f64; 2], near: usize) -> f64 {
        let [first, last] = ends.map(|angle| self.place_of(angle, near));
        let rises = (first..=last).map(|above| match above {
            0 => self.advance,
            above if above < self.angles.len() => self.rise(blade, above),
            _ => 0.0,
        });
        rises.fold(0.0, f64::max)
    }

    /// Ends a step of the bit at an angle and a depth: where no blade was before, each leaves the
    /// deeper of where it is and what it found.
    pub(crate) fn leave(&mut self, angle: f64, depth: f64) {
        if angle <= self.furthest() {
            return;
        }
        // All of it is found before any of it is left.
        let mut several = [0.0; MOST_PROFILES];
        let found = &mut several[..self.depths.len()];
        for (blade, found) in found.iter_mut().enumerate() {
            let ahead = angle - self.apart[blade];
            self.near[blade] = self.place_of(ahead, self.near[blade]);
            *found = self.left_at(self.before(blade), ahead, self.near[blade]).0;
        }
        for (depths, found) in self.depths.iter_mut().zip(found) {
            depths.push(depth.max(*found));
        }
        self.angles.push(angle);
    }

    /// Bytes of a case of a number of steps.
    pub(crate) fn bytes(profiles: usize, steps: f64) -> f64 {
        linear::budget::REAL * (1 + profiles) as f64 * steps
    }
}
