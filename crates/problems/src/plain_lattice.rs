//! Torsional waves handed on from piece to piece in time, one loop over all pieces a step:
//! what a lattice of waves is by definition, without any transform.

use linear::Drillstring;
use linear::estimates::torsional_impedance;

/// A string in pieces that all take one step to travel, at rest.
pub struct PlainLattice {
    /// Travel time of a piece, s.
    pub step: f64,
    /// Impedance and damping of every piece, N m s/rad, from the surface down.
    pieces: Vec<(f64, f64)>,
    /// Waves in speed (rad/s) that arrive at the lower and at the upper end of each piece.
    down: Vec<f64>,
    up: Vec<f64>,
}

impl PlainLattice {
    /// A string whose tubes are each a whole number of pieces of this length (m) long.
    ///
    /// # Panics
    /// Where one is not.
    pub fn new(string: &Drillstring, piece: f64) -> Self {
        let mut pieces = Vec::new();
        for section in string.sections() {
            for _ in 0..section.repeat {
                for part in &section.parts {
                    let count = (part.length / piece).round();
                    assert!(
                        (count * piece - part.length).abs() < 1e-9,
                        "{}",
                        part.length
                    );
                    let damping = string.torsional_damping() * piece;
                    let one = (torsional_impedance(string, part), damping);
                    pieces.extend(std::iter::repeat_n(one, count as usize));
                }
            }
        }
        let rest = vec![0.0; pieces.len()];
        Self {
            step: piece / string.torsional_wave_speed(),
            pieces,
            down: rest.clone(),
            up: rest,
        }
    }

    /// Speed of the bit (rad/s) per torque (N m) within a step.
    pub fn compliance(&self) -> f64 {
        let (impedance, damping) = self.pieces[self.pieces.len() - 1];
        1.0 / (impedance + 0.5 * damping)
    }

    /// One step: the surface turns at a speed (rad/s), and `torque` answers the speed that
    /// the bit would have without it (N m). Gives the speed of the bit.
    pub fn advance(&mut self, surface_speed: f64, torque: impl FnOnce(f64) -> f64) -> f64 {
        let last = self.pieces.len() - 1;
        let compliance = self.compliance();
        let free = 2.0 * self.pieces[last].0 * self.down[last] * compliance;
        let speed = free + compliance * torque(free);
        let mut leaving = surface_speed - self.up[0];
        for lower in 1..=last {
            let ((above, one), (below, other)) = (self.pieces[lower - 1], self.pieces[lower]);
            let (down, up) = (self.down[lower - 1], self.up[lower]);
            let pushed = 2.0 * (above * down + below * up);
            let node = pushed / (above + below + 0.5 * (one + other));
            self.down[lower - 1] = leaving;
            self.up[lower - 1] = node - down;
            leaving = node - up;
        }
        self.up[last] = speed - self.down[last];
        self.down[last] = leaving;
        speed
    }
}
