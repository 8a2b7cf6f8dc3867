//! What the cases of a results folder span: the range of a map's axes, which motions
//! have labels, and which values the axes take that are not on the map.

use sim::Motion;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::path::Path;

use anyhow::Result;

use campaign::quantities::{Axis, Units};
use campaign::sweep_file::{FileContent, Spacing};
use results::folder::read_cases;

/// Distinct values along an axis are kept up to this number.
const MOST_DISTINCT: usize = 2000;

/// Combinations of the values of further axes are kept up to this number: as many
/// maps as can be compared side by side.
const MOST_COMBINATIONS: usize = 6;

/// What a map spans.
pub struct Extent {
    /// Its axes, to the right and upwards.
    pub axes: [Axis; 2],
    /// The axes of the design that are not on it.
    pub others: Vec<Axis>,
    /// What its numbers are shown in.
    pub units: Units,
    /// Least and greatest value to the right and upwards.
    pub ranges: [[f64; 2]; 2],
    /// In what the values of its axes are spread, and its axes even.
    pub spacing: [Spacing; 2],
    /// Cases.
    pub cases: usize,
    /// Motions that have labels; that of torsion where no case has any.
    pub motions: Vec<Motion>,
    /// Distinct values to the right and upwards, in ascending order; of more than
    /// `MOST_DISTINCT` only as many.
    pub values: [Vec<f64>; 2],
    /// Distinct combinations of values along the further axes, in ascending order;
    /// none where there are more than `MOST_COMBINATIONS`.
    combinations: Option<Vec<Vec<f64>>>,
    /// Least and greatest value along each further axis.
    pub other_ranges: Vec<[f64; 2]>,
    /// Whether cases at one place differ in starts by chance: of these the fraction with a regime says
    /// how sure a label is.
    pub has_starts: bool,
}

impl Extent {
    /// Whether every value to the right comes with every value upwards.
    pub fn is_grid(&self) -> bool {
        let [x, y] = [&self.values[0], &self.values[1]].map(Vec::len);
        x.max(y) < MOST_DISTINCT && x * y <= self.cases
    }

    /// Where both ranges begin, and where they end.
    pub fn corners(&self) -> Vec<(f64, f64)> {
        let [x, y] = self.ranges;
        vec![(x[0], y[0]), (x[1], y[1])]
    }

    /// The same whose cases differ in starts by chance, if so.
    pub fn with_starts(mut self, has_starts: bool) -> Self {
        self.has_starts = has_starts;
        self
    }

    /// The combinations of values of the other axes that have a map each; none of
    /// many, or of such that hardly two cases share: their cases are put together.
    pub fn combinations(&self) -> Option<&[Vec<f64>]> {
        let few = self.combinations.as_deref()?;
        (few.len() <= 1 || 2 * few.len() <= self.cases).then_some(few)
    }

    /// Of a sweep's `labels.csv`: along the `axes` of a map, to the right and upwards, with
    /// `others` as further axes.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn of(
        labels: &Path,
        axes: [Axis; 2],
        others: Vec<Axis>,
        sweep: &FileContent,
    ) -> Result<Self> {
        let mut ranges = vec![[f64::INFINITY, f64::NEG_INFINITY]; axes.len() + others.len()];
        let mut values = [Vec::new(), Vec::new()];
        let mut combinations = Vec::new();
        let mut motions = BTreeSet::new();
        let mut cases = 0;
        let all: Vec<Axis> = axes.iter().chain(&others).copied().collect();
        for case in read_cases(labels, &all)? {
            let case = case?;
            for (range, &value) in ranges.iter_mut().zip(&case.values) {
                *range = [range[0].min(value), range[1].max(value)];
            }
            let (on_map, further) = case.values.split_at(axes.len());
            for (distinct, &value) in values.iter_mut().zip(on_map) {
                if distinct.len() < MOST_DISTINCT {
                    insert(distinct, value);
                }
            }
            // One more than can be shown tells that there are too many.
            if combinations.len() <= MOST_COMBINATIONS {
                insert(&mut combinations, further.to_vec());
            }
            cases += 1;
            motions.extend(Motion::ALL.into_iter().filter(|&motion| case.has(motion)));
        }
        if motions.is_empty() {
            motions.insert(Motion::Torsion);
        }
        Ok(Self {
            axes,
            others,
            units: sweep.units,
            ranges: [ranges[0], ranges[1]],
            spacing: [0, 1].map(|axis| sweep.spread(axes[axis]).from_least(ranges[axis][0])),
            cases,
            motions: motions.into_iter().collect(),
            values,
            combinations: (combinations.len() <= MOST_COMBINATIONS).then_some(combinations),
            other_ranges: ranges.split_off(axes.len()),
            has_starts: false,
        })
    }
}

#[cfg(test)]
impl Extent {
    /// Of cases in torsion over these values, in ascending order.
    pub fn example(values: [&[f64]; 2], cases: usize) -> Self {
        Self {
            axes: [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn],
            others: Vec::new(),
            units: Units::Si,
            ranges: values.map(|values| [values[0], values[values.len() - 1]]),
            spacing: [Spacing::Linear; 2],
            cases,
            motions: vec![Motion::Torsion],
            values: values.map(<[f64]>::to_vec),
            combinations: Some(vec![Vec::new()]),
            other_ranges: Vec::new(),
            has_starts: false,
        }
    }
}

/// Puts a value in its place among distinct ones in ascending order.
fn insert<Value: PartialOrd>(sorted: &mut Vec<Value>, value: Value) {
    let order = |other: &Value| other.partial_cmp(&value).unwrap_or(Ordering::Equal);
    if let Err(place) = sorted.binary_search_by(order) {
        sorted.insert(place, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(rows: &str, others: Vec<Axis>) -> Extent {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let header =
            "case,method,surface_speed_rpm,weight_on_bit_kn,friction,torsion,lateral,axial";
        std::fs::write(file.path(), format!("{header}\n{rows}")).expect("written");
        let axes = [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn];
        let sweep = toml::from_str(
            "[string]\nshear_modulus_gpa = 1\ndensity_kg_m3 = 1\ntorsional_damping_nms_rad_m = 1\nsections = []",
        );
        let sweep = sweep.expect("a sweep");
        Extent::of(file.path(), axes, others, &sweep).expect("a table")
    }

    #[test]
    fn all_motions_are_found_wherever_a_case_has_a_label() {
        let extent = extent(
            "0,a,1,10,1,,,\n1,a,2,20,1,smooth,,\n2,a,1,20,1,,no_contact,steady\n",
            vec![],
        );
        assert_eq!(extent.motions, Motion::ALL);
        assert_eq!(extent.ranges, [[1.0, 2.0], [10.0, 20.0]]);
        assert_eq!(extent.combinations, Some(vec![vec![]]));
    }

    #[test]
    fn few_values_of_further_axes_are_listed_in_order_and_many_are_not() {
        let rows = |count: i32| -> String {
            let row = |case| format!("{case},a,1,10,{},smooth,,\n", 9 - case % count);
            (0..20).map(row).collect()
        };
        let of_three = extent(&rows(3), vec![Axis::FRICTION]);
        let expected = [[7.0], [8.0], [9.0]].map(Vec::from);
        assert_eq!(of_three.combinations(), Some(&expected[..]));
        assert_eq!(of_three.motions, [Motion::Torsion]);
        assert_eq!(of_three.other_ranges, [[7.0, 9.0]]);
        assert_eq!(extent(&rows(7), vec![Axis::FRICTION]).combinations, None);
    }
}
