//! Cases for Sobol's indices of first and of all orders, in blocks: a point A, a point B that is
//! independent of it, and for each axis A with the value of B along that axis alone
//! (A. Saltelli et al., *Computer Physics Communications* 181, 2010, 259–270).

use super::monte_carlo::count_of_points;
use super::points::Points;
use super::random_axes::RandomAxes;
use crate::sweep_file::{DesignTable, Source, SweepFileError};

/// Blocks of cases that tell the axes apart.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    pub(super) random: RandomAxes,
    /// Of each block, the coordinates of A and then those of B.
    pub(super) points: Points,
    pub(super) blocks: usize,
}

/// Cases of a block over a number of axes.
pub const fn cases_of_block(axes: usize) -> usize {
    axes + 2
}

/// A case by its place in its block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Member {
    /// The point A.
    A,
    /// The point B.
    B,
    /// A with the value of B along the axis at a place.
    Mixed(usize),
}

impl Member {
    /// That at a place in a block.
    pub const fn at(place: usize) -> Self {
        match place {
            0 => Member::A,
            1 => Member::B,
            _ => Member::Mixed(place - 2),
        }
    }
}

impl Sensitivity {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let message = "indices of first and of all orders are of axes that are independent: \
                       `kind = \"monte-carlo\"` draws correlated ones";
        let is_correlated = !table.correlations.is_empty();
        source.refuse_if(is_correlated, "design.correlations", message)?;
        let blocks = count_of_points(source, table)?;
        let random = RandomAxes::resolve(source, table, weight_pushes)?;
        Ok(Self {
            blocks,
            points: Points::resolve(source, table, 2 * random.count())?,
            random,
        })
    }

    /// Of more cases than can be counted, as many as can be.
    pub(super) fn cases(&self) -> usize {
        self.blocks.saturating_mul(self.cases_of_block())
    }

    pub(super) fn cases_of_block(&self) -> usize {
        cases_of_block(self.random.count())
    }

    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        let size = self.cases_of_block();
        let both = self.points.point(index / size);
        let (a, b) = both.split_at(self.random.count());
        match Member::at(index % size) {
            Member::A => self.random.at(a),
            Member::B => self.random.at(b),
            Member::Mixed(axis) => {
                let mut parts = a.to_vec();
                parts[axis] = b[axis];
                self.random.at(&parts)
            }
        }
    }
}

/// The strings of a block: that of A, which it shares with every case that has the value of B
/// along an axis that does not change the string; that of B; and one for each axis that does, but
/// that of an only one is that of B.
impl Sensitivity {
    fn strings_of_block(&self) -> usize {
        match self.random.of_string {
            1 => 2,
            axes => 2 + axes,
        }
    }

    /// Which of them the case at a place in its block has.
    fn string_in_block(&self, place: usize) -> usize {
        match Member::at(place) {
            Member::A => 0,
            Member::B => 1,
            Member::Mixed(axis) if axis >= self.random.of_string => 0,
            Member::Mixed(_) if self.random.of_string == 1 => 1,
            Member::Mixed(axis) => 2 + axis,
        }
    }

    /// The places in a block of the cases of a string.
    fn places_of(&self, string: usize) -> impl Iterator<Item = usize> {
        let string = string % self.strings_of_block();
        (0..self.cases_of_block()).filter(move |place| self.string_in_block(*place) == string)
    }

    pub(super) fn strings(&self) -> usize {
        self.blocks * self.strings_of_block()
    }

    pub(super) fn cases_of_string(&self, string: usize) -> usize {
        self.places_of(string).count()
    }

    pub(super) fn case_of_string(&self, string: usize, position: usize) -> usize {
        let place = self.places_of(string).nth(position).unwrap_or(0);
        string / self.strings_of_block() * self.cases_of_block() + place
    }

    pub(super) fn string_of(&self, index: usize) -> usize {
        let size = self.cases_of_block();
        index / size * self.strings_of_block() + self.string_in_block(index % size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::Axis;
    use crate::sweep_file::PointsName;

    fn design(of_string: usize, blocks: usize) -> Sensitivity {
        let axes = vec![
            Axis::SurfaceSpeedRpm,
            Axis::TorqueDynamicNm,
            Axis::FRICTION,
            Axis::ImpulseRatio,
        ];
        let mut random = RandomAxes::uniform(axes, &[[0.0, 1.0]; 4]);
        random.of_string = of_string;
        Sensitivity {
            random,
            points: Points::new(PointsName::Sobol, 3, 8).unwrap(),
            blocks,
        }
    }

    #[test]
    fn a_block_has_two_points_and_their_mixtures() {
        let design = design(0, 5);
        assert_eq!(design.cases(), 30);
        for block in 0..5 {
            let case = |place: usize| design.values(6 * block + place);
            let (a, b) = (case(0), case(1));
            assert_eq!([&a[..], &b].concat(), design.points.point(block));
            for axis in 0..4 {
                let mixed = case(2 + axis);
                let of_b = |place: &usize| mixed[*place] == b[*place] && mixed[*place] != a[*place];
                assert_eq!((0..4).filter(of_b).collect::<Vec<_>>(), [axis]);
                assert!((0..4).all(|place| place == axis || mixed[place] == a[place]));
            }
        }
    }

    /// Every case has one string, that of its values along the axes that change the string.
    #[test]
    fn cases_of_one_string_have_the_same_values_of_it() {
        for of_string in 1..=4 {
            let design = design(of_string, 3);
            let of_case = |case: usize| design.values(case)[..of_string].to_vec();
            let mut seen = vec![0; design.cases()];
            for string in 0..design.strings() {
                for position in 0..design.cases_of_string(string) {
                    let case = design.case_of_string(string, position);
                    assert_eq!(design.string_of(case), string);
                    assert_eq!(of_case(case), of_case(design.case_of_string(string, 0)));
                    seen[case] += 1;
                }
            }
            assert!(seen.iter().all(|count| *count == 1), "{seen:?}");
            let mut distinct: Vec<Vec<u64>> = (0..design.cases())
                .map(|case| of_case(case).into_iter().map(f64::to_bits).collect())
                .collect();
            distinct.sort();
            distinct.dedup();
            assert_eq!(distinct.len(), design.strings());
        }
    }
}
