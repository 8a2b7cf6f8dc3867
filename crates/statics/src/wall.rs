//! What a Hertzian wall answers, pressed in by d: N = k_c d^1.5 and, where the string slides on it,
//! a force m N sideways.

/// A Hertzian wall where the string is.
pub(crate) struct Hertzian {
    /// Direction from the middle to the string.
    pub(crate) outwards: [f64; 2],
    /// How far the string is beyond the clearance, m.
    pub(crate) pressed_in: f64,
    /// N, N.
    pub(crate) normal: f64,
    /// How N grows outwards, N/m.
    growth: f64,
    /// N/r, N/m.
    by_radius: f64,
}

/// Of a clearance (m) and a stiffness (N/m^1.5), with the string at a place (m).
pub(crate) fn hertzian(clearance: f64, stiffness: f64, [x, y]: [f64; 2]) -> Hertzian {
    let reached = x.hypot(y);
    let pressed_in = (reached - clearance).max(0.0);
    let normal = stiffness * pressed_in * pressed_in.sqrt();
    let outwards = match reached {
        0.0 => [1.0, 0.0],
        _ => [x / reached, y / reached],
    };
    Hertzian {
        outwards,
        pressed_in,
        normal,
        growth: 1.5 * stiffness * pressed_in.sqrt(),
        by_radius: if reached > 0.0 { normal / reached } else { 0.0 },
    }
}

impl Hertzian {
    /// On the string, N, by the m of sliding: 0 at rest.
    pub(crate) fn force(&self, slip: f64) -> [f64; 2] {
        let [cos, sin] = self.outwards;
        [
            self.normal * (-cos - slip * sin),
            self.normal * (-sin + slip * cos),
        ]
    }

    /// −dF/du.
    pub(crate) fn tangent(&self, slip: f64) -> [[f64; 2]; 2] {
        let [cos, sin] = self.outwards;
        let (out, aside) = ([cos, sin], [-sin, cos]);
        let entry = |row: usize, column: usize| {
            self.growth * (out[row] - slip * aside[row]) * out[column]
                + self.by_radius * (aside[row] + slip * out[row]) * aside[column]
        };
        [0, 1].map(|row| [0, 1].map(|column| entry(row, column)))
    }
}

/// A vector along axes that are turned by an angle, by its cosine and sine.
pub(crate) fn turned([x, y]: [f64; 2], [cos, sin]: [f64; 2]) -> [f64; 2] {
    [cos * x + sin * y, cos * y - sin * x]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tangent_is_what_forces_change_by() {
        let (place, slip, step) = ([-0.03, 0.045], -0.4, 1e-8);
        let force = |place| hertzian(0.05, 1e9, place).force(slip);
        let tangent = hertzian(0.05, 1e9, place).tangent(slip);
        for column in 0..2 {
            let moved = |by: f64| {
                let mut moved = place;
                moved[column] += by;
                force(moved)
            };
            let (more, less) = (moved(step), moved(-step));
            for row in 0..2 {
                let change = (less[row] - more[row]) / (2.0 * step);
                let off = (change - tangent[row][column]) / tangent[0][0];
                assert!(off.abs() < 1e-6, "{row} {column}: {change} {tangent:?}");
            }
        }
        assert_eq!(hertzian(0.06, 1e9, place).force(slip), [0.0, 0.0]);
    }
}
