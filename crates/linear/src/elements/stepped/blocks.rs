//! Arithmetic with the values at the nodes of a chain: blocks of a symmetric matrix, and what they
//! multiply.

/// Between the degrees of freedom of two nodes, row by row.
pub(super) type Block<const D: usize> = [[f64; D]; D];

/// Of each degree of freedom of a node, a value in every plane.
pub(super) type Values<const D: usize, const P: usize> = [[f64; P]; D];

/// A symmetric matrix by its nodes.
pub(super) struct Blocks<const D: usize> {
    pub(super) own: Vec<Block<D>>,
    /// Between each node and the next.
    pub(super) below: Vec<Block<D>>,
}

impl<const D: usize> Blocks<D> {
    pub(super) fn new(nodes: usize) -> Self {
        Self {
            own: vec![[[0.0; D]; D]; nodes],
            below: vec![[[0.0; D]; D]; nodes],
        }
    }

    /// Adds an entry; those above the diagonal blocks are their mirrors'.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        let (node, other) = (row / D, column / D);
        if node == other {
            self.own[node][row % D][column % D] += value;
        } else if node == other + 1 {
            self.below[other][row % D][column % D] += value;
        }
    }
}

#[inline(always)]
pub(super) fn add<const D: usize, const P: usize>(sum: &mut Values<D, P>, values: Values<D, P>) {
    sum.iter_mut()
        .zip(values)
        .for_each(|(sum, values)| add_row(sum, values));
}

#[inline(always)]
pub(super) fn add_row<const P: usize>(sum: &mut [f64; P], values: [f64; P]) {
    sum.iter_mut()
        .zip(values)
        .for_each(|(sum, value)| *sum += value);
}

#[inline(always)]
pub(super) fn times<const D: usize, const P: usize>(
    block: &Block<D>,
    values: &Values<D, P>,
) -> Values<D, P> {
    std::array::from_fn(|row| {
        std::array::from_fn(|plane| (0..D).map(|it| block[row][it] * values[it][plane]).sum())
    })
}

#[inline(always)]
pub(super) fn subtract<const D: usize, const P: usize>(
    from: &mut Values<D, P>,
    block: &Block<D>,
    values: &Values<D, P>,
) {
    for (from, row) in from.iter_mut().zip(block) {
        for (entry, values) in row.iter().zip(values) {
            for (from, value) in from.iter_mut().zip(values) {
                *from -= entry * value;
            }
        }
    }
}

#[inline(always)]
pub(super) fn subtract_transposed<const D: usize, const P: usize>(
    from: &mut Values<D, P>,
    block: &Block<D>,
    values: &Values<D, P>,
) {
    subtract(from, &transposed(*block), values);
}

#[inline(always)]
pub(super) fn transposed<const D: usize>(block: Block<D>) -> Block<D> {
    std::array::from_fn(|row| std::array::from_fn(|column| block[column][row]))
}

pub(super) fn difference<const D: usize>(one: Block<D>, other: Block<D>) -> Block<D> {
    std::array::from_fn(|row| std::array::from_fn(|column| one[row][column] - other[row][column]))
}

pub(super) fn product<const D: usize>(one: Block<D>, other: Block<D>) -> Block<D> {
    times(&one, &other)
}

/// The inverse of a positive definite block, by elimination without exchange.
pub(super) fn inverse<const D: usize>(mut block: Block<D>) -> Option<Block<D>> {
    let mut inverse: Block<D> = std::array::from_fn(|row| {
        std::array::from_fn(|column| if row == column { 1.0 } else { 0.0 })
    });
    for pivot in 0..D {
        let value = block[pivot][pivot];
        if !(value > 0.0 && value.is_finite()) {
            return None;
        }
        for matrix in [&mut block, &mut inverse] {
            matrix[pivot] = matrix[pivot].map(|entry| entry / value);
        }
        for row in (0..D).filter(|row| *row != pivot) {
            let factor = block[row][pivot];
            for matrix in [&mut block, &mut inverse] {
                for column in 0..D {
                    matrix[row][column] -= factor * matrix[pivot][column];
                }
            }
        }
    }
    Some(inverse)
}
