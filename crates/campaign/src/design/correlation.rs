//! Random axes that go together: each keeps its own distribution, and what a normal
//! distribution would be at the same part of all of both is correlated (a Gaussian copula; M. Sklar,
//! *Publications de l'Institut de Statistique de l'Université de Paris* 8, 1959, 229–231).

use super::distribution::{below_normal, normal_score};
use crate::quantities::Axis;
use crate::sweep_file::{DesignTable, Source, SweepFileError};

/// The axes of a design that are correlated.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Correlation {
    /// Their places among the axes.
    places: Vec<usize>,
    /// L of the matrix of their coefficients, which is L Lᵀ: its rows.
    factor: Vec<Vec<f64>>,
}

/// Coefficients nearer to 1 leave nothing of one of the two.
const STRONGEST: f64 = 0.999;

impl Correlation {
    /// What `[[design.correlations]]` says of axes.
    ///
    /// # Errors
    /// If a pair is unknown, its coefficient exceeds 1, or the matrix is not positive definite.
    pub fn resolve(
        source: &Source,
        table: &DesignTable,
        axes: &[Axis],
    ) -> Result<Self, SweepFileError> {
        let mut pairs: Vec<([usize; 2], f64)> = Vec::new();
        for (index, correlation) in table.correlations.iter().enumerate() {
            let key = |key: &str| format!("design.correlations[{index}].{key}");
            let place = |axis: Axis| {
                let place = axes.iter().position(|other| *other == axis);
                let message = format!("`{}` is not an axis of this design", axis.name());
                place.ok_or_else(|| source.error(&key("axes"), message))
            };
            let [one, other] = correlation.axes;
            let mut pair = [place(one)?, place(other)?];
            pair.sort_unstable();
            let is_single = pair[0] == pair[1];
            source.refuse_if(is_single, &key("axes"), "an axis goes with itself anyway")?;
            let is_there = pairs.iter().any(|(known, _)| *known == pair);
            source.refuse_if(is_there, &key("axes"), "this pair is given already")?;
            let (name, given) = (key("coefficient"), correlation.coefficient);
            let coefficient = source.within(&name, given, -STRONGEST, STRONGEST, "")?;
            pairs.push((pair, coefficient));
        }
        let mut places: Vec<usize> = pairs.iter().flat_map(|(pair, _)| *pair).collect();
        places.sort_unstable();
        places.dedup();
        let coefficient = |one: usize, other: usize| {
            let [mut pair, same] = [[places[one], places[other]], [one, other]];
            pair.sort_unstable();
            let given = pairs.iter().find(|(known, _)| *known == pair);
            match same {
                [one, other] if one == other => 1.0,
                _ => given.map_or(0.0, |(_, coefficient)| *coefficient),
            }
        };
        let message = "no numbers can be correlated like that: two that go with a third go \
                       together, too";
        let factor = cholesky(places.len(), coefficient)
            .ok_or_else(|| source.error("design.correlations", message))?;
        Ok(Self { places, factor })
    }

    /// Makes parts (0 to 1) that are independent of one another those of correlated numbers.
    pub fn correlate(&self, parts: &mut [f64]) {
        let scores: Vec<f64> = (self.places.iter())
            .map(|&place| normal_score(parts[place]))
            .collect();
        for (row, &place) in self.factor.iter().zip(&self.places) {
            let score: f64 = row.iter().zip(&scores).map(|(a, b)| a * b).sum();
            parts[place] = below_normal(score);
        }
    }
}

/// The factor L of a matrix L Lᵀ, if it is positive definite.
fn cholesky(size: usize, matrix: impl Fn(usize, usize) -> f64) -> Option<Vec<Vec<f64>>> {
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for row in 0..size {
        let mut next: Vec<f64> = Vec::new();
        for column in 0..row {
            let known: f64 = next.iter().zip(&rows[column]).map(|(a, b)| a * b).sum();
            next.push((matrix(row, column) - known) / rows[column][column]);
        }
        let left = matrix(row, row) - next.iter().map(|it| it * it).sum::<f64>();
        next.push(Some(left.sqrt()).filter(|_| left > 1e-9)?);
        rows.push(next);
    }
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Stream;

    /// Of numbers that are uniform, whose normal scores have a coefficient ρ, it is
    /// (6/π) asin(ρ/2) (K. Pearson, 1907); each stays uniform.
    #[test]
    fn parts_go_together_and_stay_even() {
        for coefficient in [-0.9, 0.4, 0.8] {
            let matrix = |row: usize, column: usize| if row == column { 1.0 } else { coefficient };
            let correlation = Correlation {
                places: vec![0, 2],
                factor: cholesky(2, matrix).unwrap(),
            };
            let count = 20_000;
            let draws: Vec<[f64; 3]> = (0..count)
                .map(|case| {
                    let mut stream = Stream::new(5, case);
                    let mut parts = [0.0; 3].map(|_| stream.part());
                    correlation.correlate(&mut parts);
                    parts
                })
                .collect();
            let mean =
                |of: &dyn Fn(&[f64; 3]) -> f64| draws.iter().map(of).sum::<f64>() / count as f64;
            let expected = 6.0 / std::f64::consts::PI * (0.5 * coefficient).asin();
            // Five standard errors of a mean of products.
            let error = 5.0 / (count as f64).sqrt();
            let together = 12.0 * mean(&|parts| (parts[0] - 0.5) * (parts[2] - 0.5));
            assert!((together - expected).abs() < error, "{together} {expected}");
            let apart = 12.0 * mean(&|parts| (parts[0] - 0.5) * (parts[1] - 0.5));
            assert!(apart.abs() < error, "{apart}");
            for place in 0..3 {
                for tenth in 1..10 {
                    let level = 0.1 * f64::from(tenth);
                    let below = mean(&|parts| f64::from(u8::from(parts[place] < level)));
                    assert!(
                        (below - level).abs() < 0.5 * error,
                        "{place} {level} {below}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_factor_times_itself_is_the_matrix() {
        let matrix = [[1.0, 0.5, -0.3], [0.5, 1.0, 0.2], [-0.3, 0.2, 1.0]];
        let rows = cholesky(3, |row, column| matrix[row][column]).unwrap();
        for (row, column) in (0..3).flat_map(|row| (0..=row).map(move |column| (row, column))) {
            let product: f64 = rows[row]
                .iter()
                .zip(&rows[column])
                .map(|(a, b)| a * b)
                .sum();
            assert!((product - matrix[row][column]).abs() < 1e-14);
        }
        // Two that are nearly a third are not apart.
        let impossible = [[1.0, 0.9, 0.9], [0.9, 1.0, -0.9], [0.9, -0.9, 1.0]];
        assert_eq!(cholesky(3, |row, column| impossible[row][column]), None);
    }
}
