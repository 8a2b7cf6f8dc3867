//! Where random points lie in the unit cube. A point depends on the seed and its number alone, so
//! that more of them continue those that are there.

use super::axes::MOST_CASES;
use super::sobol::{MOST_DIMENSIONS, Sobol};
use crate::random::Stream;
use crate::sweep_file::{DesignTable, PointsName, Source, SweepFileError};

// Every point of a design has its number in Sobol's sequence.
const _: () = assert!(MOST_CASES <= u32::MAX as usize);

/// Points with a number of coordinates each.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    pub seed: u64,
    kind: Kind,
}

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Random { dimensions: usize },
    Sobol(Sobol),
}

impl Points {
    /// What `points` and `seed` say, for points with a number of coordinates.
    ///
    /// # Errors
    /// Where there are too many of them for the points asked for.
    pub fn resolve(
        source: &Source,
        table: &DesignTable,
        dimensions: usize,
    ) -> Result<Self, SweepFileError> {
        let seed = table.seed.unwrap_or(0);
        Self::new(table.points.unwrap_or_default(), seed, dimensions).ok_or_else(|| {
            let message = format!(
                "Sobol points have at most {MOST_DIMENSIONS} coordinates, and these axes take \
                 {dimensions}"
            );
            source.error("design.points", message)
        })
    }

    /// Those of a seed, if there are any with this number of coordinates.
    pub fn new(name: PointsName, seed: u64, dimensions: usize) -> Option<Self> {
        let kind = match name {
            PointsName::Random => Kind::Random { dimensions },
            PointsName::Sobol => Kind::Sobol(Sobol::new(seed, dimensions)?),
        };
        Some(Self { seed, kind })
    }

    /// The coordinates of a point by its number, each uniform from 0 to 1.
    pub fn point(&self, number: usize) -> Vec<f64> {
        match &self.kind {
            Kind::Random { dimensions } => {
                let mut stream = Stream::new(self.seed, number as u64);
                (0..*dimensions).map(|_| stream.part()).collect()
            }
            Kind::Sobol(sobol) => sobol.point(number as u32),
        }
    }
}
