//! Linear equations with a band of non-zero entries around the diagonal.
//!
//! Elimination without exchanges of rows: the signs of its pivots count the negative eigenvalues
//! of a symmetric matrix (J. J. Sylvester's law of inertia), by which a string in contact is
//! stable or not. The sparse Cholesky decomposition of `numerics` refuses a matrix that is not
//! positive definite, as that of a buckled string or of one that slides with friction.

/// A square matrix with no entries farther than [`Banded::HALF`] from its diagonal.
#[derive(Debug, Clone)]
pub(crate) struct Banded {
    /// Row by row, from left to right.
    entries: Vec<f64>,
}

/// Of the largest pivot, what takes the place of a pivot that is smaller: rounding leaves no more
/// of a motion that nothing resists.
const LEAST_PIVOT: f64 = 1e-18;

/// A pivot that is negative by no more than this part of what it was before elimination is zero:
/// that of a motion that nothing resists.
const ROUNDING: f64 = 1e-14;

impl Banded {
    /// Half of the width of the band: a node of four degrees of freedom and its neighbour.
    const HALF: usize = 7;
    const WIDTH: usize = 2 * Self::HALF + 1;

    pub(crate) fn zeros(size: usize) -> Self {
        Self {
            entries: vec![0.0; size * Self::WIDTH],
        }
    }

    fn size(&self) -> usize {
        self.entries.len() / Self::WIDTH
    }

    fn place(row: usize, column: usize) -> usize {
        row * Self::WIDTH + column + Self::HALF - row
    }

    /// The rows, or columns, that a column, or row, has entries in.
    fn band(&self, of: usize) -> std::ops::Range<usize> {
        of.saturating_sub(Self::HALF)..(of + Self::HALF + 1).min(self.size())
    }

    pub(crate) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.entries[Self::place(row, column)] += value;
    }

    fn get(&self, row: usize, column: usize) -> f64 {
        self.entries[Self::place(row, column)]
    }

    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.entries[Self::place(row, column)] = value;
    }

    /// Turns two degrees of freedom of a node by an angle (its cosine and sine), rows and columns.
    pub(crate) fn turn(&mut self, one: usize, other: usize, [cos, sin]: [f64; 2]) {
        let turned = |a: f64, b: f64| [cos * a + sin * b, cos * b - sin * a];
        let both = self.band(one).start.max(self.band(other).start)
            ..self.band(one).end.min(self.band(other).end);
        for column in both.clone() {
            let [a, b] = turned(self.get(one, column), self.get(other, column));
            self.set(one, column, a);
            self.set(other, column, b);
        }
        for row in both {
            let [a, b] = turned(self.get(row, one), self.get(row, other));
            self.set(row, one, a);
            self.set(row, other, b);
        }
    }

    /// Adds a multiple of a row of a node to another.
    pub(crate) fn add_row(&mut self, times: f64, from: usize, to: usize) {
        for column in self.band(from).start.max(self.band(to).start)
            ..self.band(from).end.min(self.band(to).end)
        {
            self.add(to, column, times * self.get(from, column));
        }
    }

    /// Gives an unknown a value, and takes what it does to the other equations to their right
    /// sides. Its pivot is positive.
    pub(crate) fn hold(&mut self, unknown: usize, value: f64, right: &mut [f64]) {
        let scale = self.get(unknown, unknown).abs().max(1.0);
        for other in self.band(unknown) {
            right[other] -= self.get(other, unknown) * value;
            self.set(other, unknown, 0.0);
            self.set(unknown, other, 0.0);
        }
        self.set(unknown, unknown, scale);
        right[unknown] = scale * value;
    }

    /// Solves the equations in place of their right side, and returns which pivots are negative.
    pub(crate) fn solve(mut self, right: &mut [f64]) -> Vec<bool> {
        let size = self.size();
        let diagonal: Vec<f64> = (0..size).map(|row| self.get(row, row).abs()).collect();
        let least = LEAST_PIVOT * diagonal.iter().copied().fold(0.0, f64::max);
        let mut negative = Vec::with_capacity(size);
        for pivot in 0..size {
            let mut value = self.get(pivot, pivot);
            if value.abs() < least {
                value = least;
                self.set(pivot, pivot, least);
            }
            negative.push(value < -ROUNDING * diagonal[pivot]);
            let end = self.band(pivot).end;
            for row in pivot + 1..end {
                let factor = self.get(row, pivot) / value;
                if factor == 0.0 {
                    continue;
                }
                for column in pivot + 1..end {
                    let above = self.get(pivot, column);
                    self.add(row, column, -factor * above);
                }
                right[row] -= factor * right[pivot];
            }
        }
        for row in (0..size).rev() {
            let known: f64 = (row + 1..self.band(row).end)
                .map(|column| self.get(row, column) * right[column])
                .sum();
            right[row] = (right[row] - known) / self.get(row, row);
        }
        negative
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a chain of masses on springs, with what its middle pushes.
    #[test]
    fn equations_are_solved_and_negative_eigenvalues_counted() {
        let chain = |push: f64| {
            let mut matrix = Banded::zeros(40);
            for row in 0..40 {
                matrix.add(row, row, 2.0);
                for (one, other) in [(row, row + 1), (row, row + 7)] {
                    if other < 40 {
                        matrix.add(one, other, -0.5);
                        matrix.add(other, one, -0.5);
                    }
                }
            }
            matrix.add(20, 20, -push);
            matrix
        };
        let right: Vec<f64> = (0..40).map(|row| f64::from(row).sin()).collect();
        for (push, count) in [(0.0, 0), (20.0, 1)] {
            let matrix = chain(push);
            let mut found = right.clone();
            let negative = matrix.clone().solve(&mut found);
            assert_eq!(negative.iter().filter(|it| **it).count(), count);
            for row in 0..40 {
                let band = matrix.band(row);
                let sum: f64 = band
                    .map(|column| matrix.get(row, column) * found[column])
                    .sum();
                assert!((sum - right[row]).abs() < 1e-13, "{row}: {sum}");
            }
        }
    }

    /// What is held has its value, and the others are as they would be with it.
    #[test]
    fn an_unknown_that_is_held_has_its_value() {
        let mut matrix = Banded::zeros(3);
        for (row, column, value) in [
            (0, 0, 2.0),
            (0, 1, -1.0),
            (1, 0, -1.0),
            (1, 1, 3.0),
            (1, 2, -2.0),
            (2, 1, -2.0),
            (2, 2, 5.0),
        ] {
            matrix.add(row, column, value);
        }
        let mut right = vec![1.0, 0.0, 2.0];
        matrix.hold(1, 4.0, &mut right);
        matrix.solve(&mut right);
        assert_eq!(right, [2.5, 4.0, 2.0]);
    }
}
