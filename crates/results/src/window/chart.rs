//! Limits over one another, cell by cell.

use serde::Serialize;

use super::standing::Standing;
use campaign::records::{Field, Kind};

/// A cell is no larger than this part of either axis.
const LARGEST_CELL: f64 = 1.0 / 128.0;

/// Ends of cells that differ by a smaller part of the axis are one.
const SAME_PLACE: f64 = 1e-9;

/// What says of any stretch of the map, from the least to the greatest weight on bit (kN) and from
/// the lowest to the highest surface speed (rpm), how it stands to a limit.
type StandingOf<'a> = Box<dyn Fn([[f64; 2]; 2]) -> Standing + 'a>;

/// A limit as it is found.
pub struct Source<'a> {
    /// Its name in a legend.
    pub name: String,
    /// What it is and how sure, in words.
    pub description: String,
    /// Values along both axes at which it may change: no cell has one of them inside.
    pub edges: [Vec<f64>; 2],
    /// How a stretch of the map stands to it.
    pub standing: StandingOf<'a>,
    /// How it is drawn.
    pub drawn: Drawn,
}

/// How a limit is drawn.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawn {
    /// By the edge of where it is against the motion.
    Edge,
    /// By lines of weights and speeds.
    Lines(Vec<Vec<[f64; 2]>>),
    /// By ranges of surface speed, with the name of each.
    Bands(Vec<([f64; 2], String)>),
}

/// A limit on a chart.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// Its name in a legend.
    pub name: String,
    /// What it is and how sure, in words.
    pub description: String,
    /// How it is drawn.
    #[serde(skip)]
    pub drawn: Drawn,
    /// How each cell stands to it.
    #[serde(skip)]
    pub standings: Vec<Standing>,
}

/// Limits over weight on bit (kN) and surface speed (rpm), in that order, cell by cell: those of
/// one weight follow one another.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// The lines between cells along either axis.
    pub edges: [Vec<f64>; 2],
    /// The limits.
    pub limits: Vec<Limit>,
    /// Rate of penetration in each cell, m/h, where it is known; empty where no bit cuts.
    pub rates: Vec<Option<f64>>,
}

impl Chart {
    /// Puts limits over one another within these ranges of weight and speed.
    pub fn new(ranges: [[f64; 2]; 2], sources: Vec<Source>) -> Self {
        let edges = [0, 1].map(|axis| {
            let all = sources.iter().flat_map(|source| &source.edges[axis]);
            edges(ranges[axis], all.copied())
        });
        let mut chart = Self {
            edges,
            limits: Vec::new(),
            rates: Vec::new(),
        };
        let limits = sources.into_iter().map(|source| Limit {
            standings: (chart.cells())
                .map(|cell| (source.standing)(chart.ends(cell)))
                .collect(),
            name: source.name,
            description: source.description,
            drawn: source.drawn,
        });
        let limits = limits.collect();
        chart.limits = limits;
        chart
    }

    /// The same with the rate of penetration, m/h, at any weight (kN) and speed (rpm).
    #[must_use]
    pub fn with_rates(mut self, at: impl Fn([f64; 2]) -> Option<f64>) -> Self {
        self.rates = self.cells().map(|cell| at(self.middle(cell))).collect();
        self
    }

    /// The rate of penetration in a cell, m/h, where it is known.
    pub fn rate(&self, cell: usize) -> Option<f64> {
        self.rates.get(cell).copied().flatten()
    }

    /// Cells along either axis.
    pub fn size(&self) -> [usize; 2] {
        [0, 1].map(|axis| self.edges[axis].len() - 1)
    }

    /// The numbers of all cells.
    pub fn cells(&self) -> impl Iterator<Item = usize> + use<> {
        let [columns, rows] = self.size();
        0..columns * rows
    }

    /// The number of a cell.
    pub fn number(&self, [column, row]: [usize; 2]) -> usize {
        column * self.size()[1] + row
    }

    /// Where a cell is along either axis.
    pub fn place(&self, cell: usize) -> [usize; 2] {
        let rows = self.size()[1];
        [cell / rows, cell % rows]
    }

    /// From the least to the greatest weight and speed of a cell.
    pub fn ends(&self, cell: usize) -> [[f64; 2]; 2] {
        let place = self.place(cell);
        [0, 1].map(|axis| {
            let (edges, at) = (&self.edges[axis], place[axis]);
            [edges[at], edges[at + 1]]
        })
    }

    /// The middle of a cell.
    pub fn middle(&self, cell: usize) -> [f64; 2] {
        self.ends(cell).map(|[from, to]| 0.5 * (from + to))
    }

    /// From the least to the greatest value of an axis.
    pub fn range(&self, axis: usize) -> [f64; 2] {
        let edges = &self.edges[axis];
        [edges[0], edges[edges.len() - 1]]
    }

    /// The part of the map that a cell is.
    pub fn share(&self, cell: usize) -> f64 {
        let parts = self.ends(cell).into_iter().enumerate();
        let part = |(axis, [from, to]): (usize, [f64; 2])| {
            let [least, most] = self.range(axis);
            (to - from) / (most - least)
        };
        parts.map(part).product()
    }

    /// How a cell stands to all limits: as to the worst of them.
    pub fn standing(&self, cell: usize) -> Standing {
        let limits = self.limits.iter().map(|limit| limit.standings[cell]);
        limits.max().unwrap_or(Standing::Undetermined)
    }

    /// The part of the map that stands so to a limit.
    pub fn part(&self, limit: &Limit, standing: Standing) -> f64 {
        let cells = self.cells().filter(|&it| limit.standings[it] == standing);
        cells.map(|cell| self.share(cell)).sum()
    }

    /// Names of the limits to which a cell stands worse than that.
    pub fn worse_than(&self, standing: Standing, cell: usize) -> Vec<&str> {
        let limits = self.limits.iter();
        let worse = limits.filter(|limit| limit.standings[cell] > standing);
        worse.map(|limit| limit.name.as_str()).collect()
    }
}

/// The columns of a chart as a table, in SI units.
pub const WINDOW_COLUMNS: [(&str, Kind); 7] = [
    ("weight_on_bit_kn_from", Kind::Number),
    ("weight_on_bit_kn_to", Kind::Number),
    ("surface_speed_rpm_from", Kind::Number),
    ("surface_speed_rpm_to", Kind::Number),
    ("standing", Kind::Text),
    ("limits", Kind::Text),
    ("rate_of_penetration_m_h", Kind::Number),
];

impl Chart {
    /// Every cell by these columns: where it is, how it stands, what it is not clear of, and how fast
    /// it drills.
    pub fn rows(&self) -> impl Iterator<Item = [Field<'_>; WINDOW_COLUMNS.len()]> {
        self.cells().map(|cell| {
            let [[weight, to_weight], [speed, to_speed]] = self.ends(cell);
            let limits = self.worse_than(Standing::Clear, cell);
            [
                weight.into(),
                to_weight.into(),
                speed.into(),
                to_speed.into(),
                self.standing(cell).key().into(),
                (!limits.is_empty()).then(|| limits.join("; ")).into(),
                self.rate(cell).into(),
            ]
        })
    }
}

/// The ends of a range, all edges inside it, and enough more that no cell is too large.
fn edges([least, most]: [f64; 2], all: impl Iterator<Item = f64>) -> Vec<f64> {
    let width = most - least;
    let room = SAME_PLACE * width;
    let mut inside: Vec<f64> = all
        .filter(|edge| (least + room..most - room).contains(edge))
        .collect();
    inside.sort_by(f64::total_cmp);
    inside.dedup_by(|next, one| *next - *one <= room);
    let mut found = vec![least];
    for end in inside.into_iter().chain([most]) {
        let start = found[found.len() - 1];
        let parts = ((end - start) / (LARGEST_CELL * width) - SAME_PLACE).ceil();
        let parts = parts.max(1.0) as usize;
        let between = (1..parts).map(|part| start + (end - start) * part as f64 / parts as f64);
        found.extend(between);
        found.push(end);
    }
    found
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Limits without a name, each by how a stretch stands to it.
    pub fn chart(of: Vec<StandingOf>) -> Chart {
        let sources = of.into_iter().enumerate().map(|(index, standing)| Source {
            name: format!("limit {index}"),
            description: String::new(),
            edges: [Vec::new(), Vec::new()],
            standing,
            drawn: Drawn::Edge,
        });
        Chart::new([[0.0, 128.0], [0.0, 256.0]], sources.collect())
    }

    #[test]
    fn cells_end_where_a_limit_may_change_and_are_small() {
        let found = edges(
            [10.0, 20.0],
            [15.0, 15.0 + 1e-12, 10.02, 9.0, 20.0].into_iter(),
        );
        assert_eq!((found[0], found[1]), (10.0, 10.02));
        assert!(found.contains(&15.0) && found[found.len() - 1] == 20.0);
        let mut sizes = found.windows(2).map(|pair| pair[1] - pair[0]);
        assert!(sizes.all(|size| size > 0.01 && size <= 10.0 / 128.0 + 1e-9));
        assert_eq!(edges([0.0, 1.0], std::iter::empty()).len(), 129);
    }

    #[test]
    fn a_cell_is_safe_where_every_limit_is_clear() {
        let chart = chart(vec![
            Box::new(|[_, speeds]| Standing::above(speeds, 64.0, 128.0)),
            Box::new(|[weights, _]| match weights[1] <= 64.0 {
                true => Standing::Clear,
                false => Standing::Undetermined,
            }),
        ]);
        let is_safe = |&cell: &usize| chart.standing(cell) == Standing::Clear;
        let safe: f64 = (chart.cells().filter(is_safe))
            .map(|cell| chart.share(cell))
            .sum();
        assert!((safe - 0.25).abs() < 1e-12);
        assert!((chart.part(&chart.limits[0], Standing::Near) - 0.25).abs() < 1e-12);
        let last = chart.number([127, 127]);
        assert_eq!(chart.standing(last), Standing::Undetermined);
        assert_eq!(chart.worse_than(Standing::Clear, last), ["limit 1"]);
        assert_eq!(chart.ends(last), [[127.0, 128.0], [254.0, 256.0]]);
        assert_eq!(chart.worse_than(Standing::Clear, 0), ["limit 0"]);
    }
}
