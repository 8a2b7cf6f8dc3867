//! Stiffnesses of beams between their ends, joined (Eqs. 50–54).
//!
//! The degrees of freedom at a node are the displacement x and the slope x′; with them go
//! the external force and moment, positive in the same directions.

use num_complex::Complex64;

use super::block::Block;
use super::chain::Stiffness;
use super::nodes::Piece;
use super::number::Number;

/// Dynamic stiffness of a beam between its two ends, with motions u = (x, x′) and loads
/// f = (force, moment); N/m, N, N m.
pub type BeamStiffness<T = Complex64> = Piece<Block<T>>;

/// Of what one end feels of the other, such a part is lost in rounding.
const LOST: f64 = 1e-18;

impl<T: Number> Stiffness for BeamStiffness<T> {
    fn is_endless(&self) -> bool {
        let (Block(top), Block(cross), Block(bottom)) = (self.top, self.cross, self.bottom);
        let is_lost = |i: usize, j: usize| {
            let ends = top[i][i].squares().zip(bottom[j][j].squares());
            let mut all = cross[i][j].squares().zip(ends);
            all.all(|(cross, (top, bottom))| cross <= LOST * (top * bottom).sqrt())
        };
        (0..4).all(|entry| is_lost(entry / 2, entry % 2))
    }

    fn join(&self, lower: &Self) -> Self {
        T::wide(
            #[inline(always)]
            || self.joined(lower),
        )
    }
}
