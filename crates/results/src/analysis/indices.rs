//! Sobol's indices from blocks of cases that were made for them: of first order, the part of the
//! variance that an axis explains alone (A. Saltelli et al., *Computer Physics Communications* 181,
//! 2010, 259–270, Table 2 (b)), and in all, with what it does together with others (M. J. W.
//! Jansen, *Computer Physics Communications* 117, 1999, 35–43).
//!
//! Sums are kept of batches of neighbouring blocks, however many blocks there are. Intervals are by
//! drawing the batches anew, with replacement (B. Efron and R. Tibshirani, *An Introduction to the
//! Bootstrap*, 1993, Sections 13.3 and 23.2).

use super::interval::{Interval, wilson};
use campaign::random::Stream;

/// Batches at most; once there are more, two neighbours become one.
const MOST_BATCHES: usize = 1024;

/// How often the batches are drawn anew for an interval.
pub const DRAWN: usize = 1000;

/// Fewer blocks than this have no interval: there is too little to draw from.
pub const LEAST_BLOCKS: usize = 20;

/// A regime that fewer of the points A and B have, or lack, has none either: its intervals would
/// not hold.
const LEAST_OF_EITHER: usize = 20;

/// Why a quantity has no indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IndexUnavailable {
    /// All its values are alike.
    Alike,
    /// There are fewer than [`LEAST_BLOCKS`].
    FewBlocks,
    /// So few independent cases have it, or lack it.
    Rare(usize),
}

/// What a quantity is in the cases of one block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block<'a> {
    /// At the point A.
    pub a: f64,
    /// At the point B.
    pub b: f64,
    /// At A with the value of B along one axis, for each axis.
    pub mixed: &'a [f64],
}

/// The indices of one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Indices {
    /// Of first order.
    pub first: Interval,
    /// Of all orders.
    pub total: Interval,
}

/// Sums over blocks, of values less the first of all, so that small differences between large
/// numbers are not lost.
#[derive(Debug, Clone, PartialEq)]
struct Sums {
    blocks: f64,
    /// Of a + b, and of a² + b².
    both: f64,
    squares: f64,
    of_axes: Vec<OfAxis>,
}

/// The sums of one axis; d is the change at A by its value of B.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct OfAxis {
    /// Of b d.
    products: f64,
    /// Of d.
    changes: f64,
    /// Of d².
    squares: f64,
}

impl Sums {
    fn none(axes: usize) -> Self {
        Self {
            blocks: 0.0,
            both: 0.0,
            squares: 0.0,
            of_axes: vec![OfAxis::default(); axes],
        }
    }

    fn add_block(&mut self, block: Block, origin: f64) {
        let (a, b) = (block.a - origin, block.b - origin);
        self.blocks += 1.0;
        self.both += a + b;
        self.squares += a * a + b * b;
        for (sums, mixed) in self.of_axes.iter_mut().zip(block.mixed) {
            let change = mixed - origin - a;
            sums.products += b * change;
            sums.changes += change;
            sums.squares += change * change;
        }
    }

    /// Adds other sums, multiplied.
    fn add(&mut self, other: &Self, times: f64) {
        self.blocks += times * other.blocks;
        self.both += times * other.both;
        self.squares += times * other.squares;
        for (sums, other) in self.of_axes.iter_mut().zip(&other.of_axes) {
            sums.products += times * other.products;
            sums.changes += times * other.changes;
            sums.squares += times * other.squares;
        }
    }

    fn variance(&self) -> f64 {
        let values = 2.0 * self.blocks;
        self.squares / values - (self.both / values).powi(2)
    }

    /// The indices of each axis of first order and of all; none where all values are alike. What
    /// of b is its mean adds nothing to the first but chance, so it is taken off.
    fn indices(&self) -> Option<Vec<[f64; 2]>> {
        let (mean, variance) = (self.both / (2.0 * self.blocks), self.variance());
        let scale = self.blocks * variance;
        let of_axis = |sums: &OfAxis| {
            let first = (sums.products - mean * sums.changes) / scale;
            [first, 0.5 * sums.squares / scale]
        };
        (scale > 0.0).then(|| self.of_axes.iter().map(of_axis).collect())
    }
}

/// The blocks of one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    axes: usize,
    origin: Option<f64>,
    /// Sums of neighbouring blocks, by their numbers.
    batches: Vec<Sums>,
    blocks_of_batch: usize,
    /// In how many blocks each axis changes the value.
    changed: Vec<usize>,
    /// How many blocks there are.
    pub count: usize,
}

impl Blocks {
    /// No blocks yet, of cases over a number of axes.
    pub fn none(axes: usize) -> Self {
        Self {
            axes,
            origin: None,
            batches: Vec::new(),
            blocks_of_batch: 1,
            changed: vec![0; axes],
            count: 0,
        }
    }

    /// Adds a block by its number.
    pub fn add(&mut self, number: usize, block: Block) {
        while number / self.blocks_of_batch >= MOST_BATCHES {
            self.join_neighbours();
        }
        let batch = number / self.blocks_of_batch;
        if batch >= self.batches.len() {
            self.batches.resize(batch + 1, Sums::none(self.axes));
        }
        let origin = *self.origin.get_or_insert(block.a);
        self.batches[batch].add_block(block, origin);
        for (changed, mixed) in self.changed.iter_mut().zip(block.mixed) {
            *changed += usize::from(*mixed != block.a);
        }
        self.count += 1;
    }

    fn join_neighbours(&mut self) {
        self.blocks_of_batch *= 2;
        let pairs = self.batches.chunks(2).map(|pair| {
            let mut sum = pair[0].clone();
            (pair.get(1).iter()).for_each(|other| sum.add(other, 1.0));
            sum
        });
        self.batches = pairs.collect();
    }

    /// The indices of each axis; `is_either` tells that every value is 0 or 1.
    ///
    /// # Errors
    /// Why there are none.
    pub fn indices(&self, is_either: bool) -> Result<Vec<Indices>, IndexUnavailable> {
        let filled: Vec<&Sums> = self.batches.iter().filter(|it| it.blocks > 0.0).collect();
        let all = self.all();
        let values = all.indices().ok_or(IndexUnavailable::Alike)?;
        let rarer = self.rarer(&all);
        if self.count < LEAST_BLOCKS {
            return Err(IndexUnavailable::FewBlocks);
        }
        if is_either && rarer < LEAST_OF_EITHER {
            return Err(IndexUnavailable::Rare(rarer));
        }
        let drawn: Vec<Vec<[f64; 2]>> = (0..DRAWN)
            .filter_map(|number| redrawn(&filled, self.axes, number as u64).indices())
            .collect();
        let interval = |axis: usize, order: usize| {
            let mut others: Vec<f64> = drawn.iter().map(|indices| indices[axis][order]).collect();
            others.sort_by(f64::total_cmp);
            within(values[axis][order], &others)
        };
        let of_axis = |axis: usize| {
            let (mut first, mut total) = (interval(axis, 0), interval(axis, 1));
            if is_either {
                // What few blocks show, or none, drawing them anew does not widen.
                let seen = wilson(self.changed[axis], self.count);
                let most = seen.map_or(1.0, |seen| 0.5 * seen.high / all.variance());
                total.high = total.high.max(most.min(1.0));
                if self.changed[axis] == 0 {
                    first.high = total.high;
                }
            }
            Indices { first, total }
        };
        Ok((0..self.axes).map(of_axis).collect())
    }

    /// Whether the points A and B have different values.
    pub fn vary(&self) -> bool {
        self.count > 0 && self.all().variance() > 0.0
    }

    fn all(&self) -> Sums {
        let mut all = Sums::none(self.axes);
        (self.batches.iter()).for_each(|batch| all.add(batch, 1.0));
        all
    }

    /// Of values that are 0 or 1 at the points A and B, how many are what fewer are.
    fn rarer(&self, all: &Sums) -> usize {
        let ones = all.both + 2.0 * all.blocks * self.origin.unwrap_or(0.0);
        ones.min(2.0 * all.blocks - ones) as usize
    }
}

/// As many batches, each drawn from all.
fn redrawn(batches: &[&Sums], axes: usize, number: u64) -> Sums {
    let mut stream = Stream::new(0, number);
    let mut times = vec![0.0; batches.len()];
    for _ in batches {
        times[(stream.part() * batches.len() as f64) as usize] += 1.0;
    }
    let mut sum = Sums::none(axes);
    for (batch, times) in batches.iter().zip(times) {
        if times > 0.0 {
            sum.add(batch, times);
        }
    }
    sum
}

/// A value with the interval that has 95 % of the others, which are in order. An index is between
/// 0 and 1.
fn within(value: f64, others: &[f64]) -> Interval {
    let at = |part: f64| {
        let place = (others.len().saturating_sub(1) as f64 * part).round();
        others.get(place as usize).copied().unwrap_or(value)
    };
    let [low, value, high] = [at(0.025), value, at(0.975)].map(|it| it.clamp(0.0, 1.0));
    Interval { value, low, high }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use campaign::design::{Design, Member, cases_of_block};
    use campaign::sweep_file::PointsName;

    /// A function with what its indices are known to be.
    struct Known {
        ends: Vec<[f64; 2]>,
        function: fn(&[f64]) -> f64,
        /// Of first order and of all, of each axis.
        indices: Vec<[f64; 2]>,
        is_either: bool,
    }

    /// T. Ishigami and T. Homma, *Proceedings of ISUMA '90*, 398–403: the third axis does nothing
    /// alone. Its indices are integrals of polynomials and sines.
    fn ishigami() -> Known {
        const A: f64 = 7.0;
        const B: f64 = 0.1;
        let alone = 0.5 * (1.0 + B * PI.powi(4) / 5.0).powi(2);
        let second = A * A / 8.0;
        let together = 8.0 * B * B * PI.powi(8) / 225.0;
        let all = alone + second + together;
        Known {
            ends: vec![[-PI, PI]; 3],
            function: |x| x[0].sin() + A * x[1].sin().powi(2) + B * x[2].powi(4) * x[0].sin(),
            indices: [[alone, alone + together], [second, second], [0.0, together]]
                .map(|parts| parts.map(|part| part / all))
                .to_vec(),
            is_either: false,
        }
    }

    /// The g-function of Sobol with the constants of Saltelli et al.: a product of factors with
    /// different variances.
    fn product() -> Known {
        const A: [f64; 6] = [0.0, 0.5, 3.0, 9.0, 99.0, 99.0];
        let alone = A.map(|a| 1.0 / (3.0 * (1.0 + a).powi(2)));
        let product = |left_out: usize| -> f64 {
            let factors = alone.iter().enumerate();
            let others = factors.filter(|(axis, _)| *axis != left_out);
            others.map(|(_, variance)| 1.0 + variance).product()
        };
        let all = product(A.len()) - 1.0;
        let of_axis = |axis: usize| [alone[axis] / all, alone[axis] * product(axis) / all];
        Known {
            ends: vec![[0.0, 1.0]; A.len()],
            function: |x| {
                let factor = |(x, a): (&f64, &f64)| ((4.0 * x - 2.0).abs() + a) / (1.0 + a);
                x.iter().zip(&A).map(factor).product()
            },
            indices: (0..A.len()).map(of_axis).collect(),
            is_either: false,
        }
    }

    /// Whether x + 2 y > 1.5, which is so in half of all cases; and whether x y > 0.8, which is in
    /// one of fifty. Of what is left for a given x or y the integrals are known; of two axes what
    /// one does not explain alone is the other's in all.
    fn regime(is_rare: bool) -> Known {
        let part_given = |axis: usize, value: f64| match (is_rare, axis) {
            (false, 0) => (1.0 - 0.5 * (1.5 - value)).clamp(0.0, 1.0),
            (false, _) => (1.0 - (1.5 - 2.0 * value)).clamp(0.0, 1.0),
            (true, _) => (1.0 - 0.8 / value).max(0.0),
        };
        let steps = 200_000;
        let mean = |of: &dyn Fn(f64) -> f64| {
            let at = |step: i32| of((f64::from(step) + 0.5) / f64::from(steps));
            (0..steps).map(at).sum::<f64>() / f64::from(steps)
        };
        let part = mean(&|x| part_given(0, x));
        let alone = [0, 1]
            .map(|axis| mean(&|x| (part_given(axis, x) - part).powi(2)) / (part * (1.0 - part)));
        let [x, y] = alone;
        Known {
            ends: vec![[0.0, 1.0]; 3],
            function: match is_rare {
                false => |x| f64::from(u8::from(x[0] + 2.0 * x[1] > 1.5)),
                true => |x| f64::from(u8::from(x[0] * x[1] > 0.8)),
            },
            indices: vec![[x, 1.0 - y], [y, 1.0 - x], [0.0, 0.0]],
            is_either: true,
        }
    }

    /// The blocks of a design whose cases are answered by a function.
    fn blocks(known: &Known, points: PointsName, seed: u64, count: usize) -> Blocks {
        let design = Design::even_blocks(points, seed, &known.ends, count).unwrap();
        let axes = known.ends.len();
        let size = cases_of_block(axes);
        let mut blocks = Blocks::none(axes);
        for number in 0..count {
            let answer = |place: usize| (known.function)(&design.values(number * size + place));
            let of = |wanted: Member| {
                let is_it = |place: &usize| Member::at(*place) == wanted;
                answer((0..size).find(is_it).unwrap())
            };
            let mixed: Vec<f64> = (0..axes).map(|axis| of(Member::Mixed(axis))).collect();
            let block = Block {
                a: of(Member::A),
                b: of(Member::B),
                mixed: &mixed,
            };
            blocks.add(number, block);
        }
        blocks
    }

    #[test]
    fn indices_of_known_functions_are_found() {
        for known in [ishigami(), product(), regime(false)] {
            for (points, near) in [(PointsName::Random, 0.05), (PointsName::Sobol, 0.015)] {
                let found = blocks(&known, points, 5, 1 << 14);
                let found = found.indices(known.is_either).unwrap();
                for (found, known) in found.iter().zip(&known.indices) {
                    for (found, known) in [(found.first, known[0]), (found.total, known[1])] {
                        assert!((found.value - known).abs() < near, "{found:?} {known}");
                    }
                }
            }
        }
    }

    /// In how many repeats each known index is in its interval: about 95 %. Of Sobol points
    /// intervals are too wide rather than too narrow once there are a thousand blocks.
    #[test]
    fn intervals_hold_about_as_often_as_they_say() {
        for (known, points, count, repeats, least) in [
            (ishigami(), PointsName::Random, 256, 300, 270),
            (regime(false), PointsName::Random, 256, 300, 270),
            (regime(true), PointsName::Random, 1024, 100, 85),
            (regime(false), PointsName::Sobol, 1024, 50, 48),
        ] {
            let mut held = vec![[0; 2]; known.ends.len()];
            for seed in 0..repeats {
                let found = blocks(&known, points, seed, count);
                let found = found.indices(known.is_either).unwrap();
                for ((held, found), known) in held.iter_mut().zip(&found).zip(&known.indices) {
                    let pairs = [(found.first, known[0]), (found.total, known[1])];
                    for (held, (interval, index)) in held.iter_mut().zip(pairs) {
                        *held += i32::from((interval.low..=interval.high).contains(&index));
                    }
                }
            }
            let is_kept = held.iter().flatten().all(|it| *it >= least);
            assert!(is_kept, "{held:?} of {repeats}");
        }
    }

    /// No block is lost where batches are joined, and intervals are as wide as without.
    #[test]
    fn many_blocks_are_kept_as_few_batches() {
        let known = ishigami();
        let many = blocks(&known, PointsName::Random, 1, 3 * MOST_BATCHES);
        assert_eq!((many.batches.len(), many.blocks_of_batch), (768, 4));
        let found = many.indices(false).unwrap();
        let kept: f64 = many.batches.iter().map(|batch| batch.blocks).sum();
        assert_eq!(kept as usize, 3 * MOST_BATCHES);
        let fewer = blocks(&known, PointsName::Random, 1, MOST_BATCHES);
        let width = |indices: &Indices| indices.total.high - indices.total.low;
        for (found, fewer) in found.iter().zip(&fewer.indices(false).unwrap()) {
            let ratio = width(fewer) / width(found);
            assert!((ratio / 3f64.sqrt() - 1.0).abs() < 0.25, "{ratio}");
        }
    }

    #[test]
    fn indices_that_cannot_be_estimated_are_unavailable() {
        let mut blocks = Blocks::none(1);
        let mut add = |number: usize, a: f64, b: f64| {
            let mixed = [b];
            blocks.add(
                number,
                Block {
                    a,
                    b,
                    mixed: &mixed,
                },
            );
            blocks.indices(true)
        };
        assert_eq!(add(0, 1.0, 1.0), Err(IndexUnavailable::Alike));
        assert_eq!(add(1, 0.0, 1.0), Err(IndexUnavailable::FewBlocks));
        let found: Vec<_> = (2..40).map(|number| add(number, 0.0, 1.0)).collect();
        assert_eq!(found[16], Err(IndexUnavailable::FewBlocks));
        assert_eq!(found[17], Err(IndexUnavailable::Rare(19)));
        assert!(found[18].is_ok());
    }
}
