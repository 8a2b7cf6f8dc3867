//! The axial part of a step: the one rate of penetration that meets the load line, at a given
//! rotation speed.

/// What a step leaves open along the axis: the bit goes down at `free_speed − compliance × weight`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxialLine {
    /// Speed without weight on the bit in this step, m/s, down.
    pub free_speed: f64,
    /// A(0): speed per force within the step, m/s per N.
    pub compliance: f64,
    /// From the beginning of the step to where its speeds are taken, s.
    pub within: f64,
    /// The whole step, s.
    pub step: f64,
}

/// How the rock holds a bit up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grip {
    /// k_a, N per m of depth of cut, of all blades.
    pub(super) weight: f64,
    /// k_c: the same of the flats while their contact grows; infinite where it is there at once.
    pub(super) growth: f64,
    /// a σ ℓ: the most that the flats of all blades carry, N.
    pub(super) most: f64,
}

/// A blade over its rock at the beginning of a step, at the angle where the law is met.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Gap {
    /// b: how far it is below the rock, m; negative in the air.
    pub(super) depth: f64,
    /// How that changes with the rotation speed, m per rad/s.
    pub(super) change: f64,
}

/// The fastest that a bit can sink in.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    /// m/s.
    pub(super) rate: f64,
    /// How that changes with the rotation speed, m/rad.
    pub(super) change: f64,
}

/// What the axis does.
#[derive(Debug, Clone, Copy)]
pub(super) struct Advance {
    /// v, m/s.
    pub(super) rate: f64,
    /// W, N, and how it changes with the rotation speed, N s/rad.
    pub(super) weight: f64,
    pub(super) weight_change: f64,
    /// δ⁺, the mean of all blades, m, and how it changes.
    pub(super) cut: f64,
    pub(super) cut_change: f64,
    /// δ, the mean of all blades, m.
    pub(super) depth_of_cut: f64,
    /// δ of the blade that cuts deepest, m.
    pub(super) deepest_cut: f64,
    /// The most that the flats could carry at this depth, N, and how it changes.
    pub(super) most_on_flats: f64,
    pub(super) most_change: f64,
    /// Whether any blade touches rock.
    pub(super) touches: bool,
}

/// W(v) = weight + slope (v − rate) from a corner on.
#[derive(Debug, Clone, Copy)]
struct Line {
    weight: f64,
    slope: f64,
}

impl Grip {
    /// The one rate at which load line and rock agree.
    pub(super) fn meet(&self, axial: &AxialLine, gaps: &[Gap], bound: Bound) -> Advance {
        let AxialLine {
            free_speed,
            compliance,
            within,
            ..
        } = *axial;
        let share = 1.0 / gaps.len() as f64;
        let (mut resting, mut on_flats) = (0.0, 0.0);
        for gap in gaps {
            resting += share * gap.depth.max(0.0);
            on_flats += share * self.on_flats(gap.depth);
        }
        let resting = self.weight * resting;
        let taken = free_speed / compliance;
        let rate = if taken > resting + on_flats {
            self.down(axial, gaps)
        } else if taken >= resting {
            0.0
        } else {
            self.up(axial, gaps)
        };
        let is_bound = rate > bound.rate;
        let rate = if is_bound { bound.rate } else { rate };
        let weight = (free_speed - rate) / compliance;
        // What a change of the rotation speed makes of it.
        let rate_change = if is_bound {
            bound.change
        } else if rate == 0.0 {
            0.0
        } else {
            self.change(axial, gaps, rate)
        };
        let advance = within * rate;
        let mut all = Advance {
            rate,
            weight,
            weight_change: -rate_change / compliance,
            cut: 0.0,
            cut_change: 0.0,
            depth_of_cut: 0.0,
            deepest_cut: f64::NEG_INFINITY,
            most_on_flats: 0.0,
            most_change: 0.0,
            touches: false,
        };
        for gap in gaps {
            let depth = gap.depth + advance;
            if depth > 0.0 {
                all.cut += share * depth;
                all.cut_change += share * (gap.change + within * rate_change);
            }
            all.depth_of_cut += share * depth;
            all.deepest_cut = all.deepest_cut.max(depth);
            all.most_on_flats += share * self.on_flats(depth);
        }
        // What they carry still grows with the depth of cut, as long as the deepest blade's does.
        if self.growth * all.deepest_cut.max(0.0) < self.most {
            all.most_change = self.growth * all.cut_change;
        }
        all.touches = weight > 0.0 || all.deepest_cut >= 0.0;
        all
    }

    /// What the flats of all blades carry at a depth of cut, m, while the bit goes down, N.
    fn on_flats(&self, depth: f64) -> f64 {
        match (depth < 0.0, self.growth.is_finite()) {
            (true, _) => 0.0,
            (false, true) => (self.growth * depth).min(self.most),
            (false, false) => self.most,
        }
    }

    /// The rate of a bit that goes down.
    fn down(&self, axial: &AxialLine, gaps: &[Gap]) -> f64 {
        let within = axial.within;
        let full = self.most / self.growth;
        if gaps.iter().all(|gap| gap.depth >= full) {
            // No corner is ahead: all blades cut, and their flats carry all they can.
            let line = self.going_down(gaps, within, 0.0, 1.0);
            return crossing(axial, line, 0.0).max(0.0);
        }
        let corners = || {
            let two = |gap: &Gap| [-gap.depth / within, (full - gap.depth) / within];
            gaps.iter().flat_map(two)
        };
        let mut from: f64 = 0.0;
        while from.is_finite() {
            let to = next_corner(corners(), from);
            // Half way to the next corner all is as along the piece.
            let inside = if to.is_finite() {
                0.5 * (from + to)
            } else {
                2.0 * from + 1.0
            };
            let line = self.going_down(gaps, within, from, inside);
            let rate = crossing(axial, line, from);
            if rate <= from {
                // A piece that begins above the load line: between is a step up at the corner.
                return from;
            }
            if rate <= to {
                return rate;
            }
            from = to;
        }
        from
    }

    /// The rate of a bit that rises, whose flats carry nothing.
    fn up(&self, axial: &AxialLine, gaps: &[Gap]) -> f64 {
        let within = axial.within;
        let mut from: f64 = 0.0;
        while from.is_finite() {
            let corners = gaps.iter().map(|gap| gap.depth / within);
            let to = -next_corner(corners, -from);
            let inside = if to.is_finite() {
                0.5 * (from + to)
            } else {
                2.0 * from - 1.0
            };
            let line = self.cutting(gaps, within, from, inside);
            let rate = crossing(axial, line, from);
            if rate >= to {
                return rate.min(from);
            }
            from = to;
        }
        from
    }

    /// W of the cutters of blades that touch rock at the rate `inside`.
    fn cutting(&self, gaps: &[Gap], within: f64, at: f64, inside: f64) -> Line {
        let share = 1.0 / gaps.len() as f64;
        let touching = |gap: &&Gap| gap.depth + within * inside > 0.0;
        gaps.iter().filter(touching).fold(
            Line {
                weight: 0.0,
                slope: 0.0,
            },
            |line, gap| Line {
                weight: line.weight + share * self.weight * (gap.depth + within * at),
                slope: line.slope + share * self.weight * within,
            },
        )
    }

    /// The same with their flats.
    fn going_down(&self, gaps: &[Gap], within: f64, at: f64, inside: f64) -> Line {
        let share = 1.0 / gaps.len() as f64;
        let mut line = self.cutting(gaps, within, at, inside);
        for gap in gaps {
            let depth = gap.depth + within * inside;
            if depth < 0.0 {
                continue;
            }
            if self.growth * depth < self.most {
                line.weight += share * self.growth * (gap.depth + within * at);
                line.slope += share * self.growth * within;
            } else {
                line.weight += share * self.most;
            }
        }
        line
    }

    /// How the rate changes with the rotation speed, along the piece that it is on.
    fn change(&self, axial: &AxialLine, gaps: &[Gap], rate: f64) -> f64 {
        let share = 1.0 / gaps.len() as f64;
        let (mut stiffness, mut change) = (0.0, 0.0);
        for gap in gaps {
            let depth = gap.depth + axial.within * rate;
            if depth <= 0.0 {
                continue;
            }
            let grows = rate > 0.0 && self.growth * depth < self.most;
            let stiff = share * (self.weight + if grows { self.growth } else { 0.0 });
            stiffness += stiff;
            change += stiff * gap.change;
        }
        -axial.compliance * change / (1.0 + axial.compliance * stiffness * axial.within)
    }
}

/// The least of some corners of W(v) beyond one; infinite where there is none.
fn next_corner(corners: impl Iterator<Item = f64>, from: f64) -> f64 {
    corners
        .filter(|corner| *corner > from)
        .fold(f64::INFINITY, f64::min)
}

/// Where a load line meets W = weight + slope (v − from).
fn crossing(axial: &AxialLine, line: Line, from: f64) -> f64 {
    let missing = axial.free_speed - axial.compliance * line.weight - from;
    from + missing / (1.0 + axial.compliance * line.slope)
}
