//! Cases as listed in a CSV file whose header names the axes: a list of the user's, or the
//! `labels.csv` of a run, of which the other columns are ignored.

use std::collections::{HashMap, HashSet};
use std::fmt::Display;

use super::axes::{count_string_axes, place};
use crate::quantities::Axis;
use crate::records::is_of_results;
use crate::sweep_file::{DesignTable, Source, SweepFileError, TextOf};
use crate::tables::Heading;
use crate::tables::hand_table::{HandTable, Mistake, number};
use crate::text_file::LARGEST_TABLE;

/// Listed cases.
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    pub(super) axes: Vec<Axis>,
    pub(super) cases: Vec<Vec<f64>>,
    /// How many of the axes, the first ones, change the string.
    pub(super) of_string: usize,
    /// The numbers of the cases of each string, in the order in which the
    /// strings first appear.
    pub(super) strings: Vec<Vec<usize>>,
}

impl List {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let Some(file) = &table.file else {
            return Err(source.error("design", "a list needs `file`, a CSV file of cases"));
        };
        let path = source.folder_of("design.file").join(file);
        let refused = |words: String| {
            let message = format!("{}{words}", path.display());
            source.error("design.file", message)
        };
        let text = text_of(&path, LARGEST_TABLE)
            .map_err(|error| refused(format!(" cannot be read: {error}")))?;
        let gives = |key| source.value_at("bit", key).is_some();
        let gives_torque = gives("weight_on_bit_kn") || gives("torque_dynamic_nm");
        let list = cases_of(&text, weight_pushes, gives_torque)
            .map_err(|mistake| refused(format!(":{mistake}")))?;
        if list.cases.is_empty() {
            return Err(refused(" lists no case".to_owned()));
        }
        Ok(list)
    }

    /// Cases with given values along given axes, which are in order; the weight on bit may push
    /// the string.
    pub fn new(axes: Vec<Axis>, cases: Vec<Vec<f64>>, weight_pushes: bool) -> Self {
        let of_string = count_string_axes(&axes, weight_pushes);
        let mut strings: Vec<Vec<usize>> = Vec::new();
        let mut known: HashMap<Vec<u64>, usize> = HashMap::new();
        for (index, values) in cases.iter().enumerate() {
            let key = values[..of_string].iter().map(|value| value.to_bits());
            let string = *known.entry(key.collect()).or_insert(strings.len());
            if string == strings.len() {
                strings.push(Vec::new());
            }
            strings[string].push(index);
        }
        Self {
            axes,
            cases,
            of_string,
            strings,
        }
    }
}

/// What a column of a list is.
#[derive(Clone, Copy, PartialEq)]
enum Column {
    /// Values along an axis; what numbers in its unit are multiplied by.
    Axis(Axis, f64),
    /// What a run has found.
    Result,
}

fn cases_of(text: &str, weight_pushes: bool, gives_torque: bool) -> Result<List, Mistake> {
    let is_header = |headings: &[Heading]| {
        let mut columns = headings.iter().map(column_of);
        headings.iter().any(|it| axis_of(it).is_some()) && columns.all(|column| column.is_some())
    };
    let (table, headings) = HandTable::with_headings(text, &is_header)?;
    let columns = columns_of(&table, &headings)?;
    let is_of_results = columns.contains(&Column::Result);
    // Columns of results follow the order of the axes, not that of the file.
    let mut order: Vec<(Axis, f64, usize)> = (columns.iter().enumerate())
        .filter_map(|(place, column)| match column {
            Column::Axis(axis, factor) => Some((*axis, *factor, place)),
            Column::Result => None,
        })
        .collect();
    order.sort_by_key(|(axis, ..)| place(*axis, weight_pushes));
    if let Some(pair) = order.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        let name = pair[0].0.name();
        return Err(table.header_mistake(format!("the column `{name}` is there twice")));
    }
    let has_weight = order.iter().any(|(axis, ..)| *axis == Axis::WeightOnBitKn);
    if is_of_results && has_weight {
        order.retain(|(axis, ..)| *axis != Axis::TorqueDynamicNm);
    }
    let mut cases: Vec<Vec<f64>> = Vec::new();
    for row in table.rows() {
        let row = row?;
        let value = |&(axis, factor, column): &(Axis, f64, usize)| {
            let mistake = |reason: &dyn Display| Mistake {
                line: row.line,
                message: format!("{}: {reason}", axis.name()),
            };
            let value = number(&row.cells[column]).map_err(|error| mistake(&error))? * factor;
            axis.check(value).map_err(|error| mistake(&error))?;
            Ok(value)
        };
        cases.push(order.iter().map(value).collect::<Result<_, Mistake>>()?);
    }
    let mut axes: Vec<Axis> = order.iter().map(|(axis, ..)| *axis).collect();
    if is_of_results {
        remove_torque_that_follows(&mut axes, &mut cases, gives_torque);
        cases = each_once(cases);
    }
    if axes.is_empty() && !columns.is_empty() {
        let known = Axis::NAMES.join(", ");
        return Err(table.header_mistake(format!("no column is an axis; known: {known}")));
    }
    Ok(List::new(axes, cases, weight_pushes))
}

/// Takes the torque out of results that have no column of the weight, where it follows from the
/// sweep file or from the constants of a rock.
fn remove_torque_that_follows(axes: &mut Vec<Axis>, cases: &mut [Vec<f64>], gives_torque: bool) {
    let Some(place) = axes.iter().position(|axis| *axis == Axis::TorqueDynamicNm) else {
        return;
    };
    let varies = cases
        .windows(2)
        .any(|pair| pair[0][place] != pair[1][place]);
    let has_rock = axes.iter().any(|axis| matches!(axis, Axis::Rock(_)));
    if gives_torque && (has_rock || !varies) {
        axes.remove(place);
        for values in cases {
            values.remove(place);
        }
    }
}

/// Cases of which several rows tell, in the order in which they first appear.
fn each_once(cases: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut known: HashSet<Vec<u64>> = HashSet::new();
    let is_new =
        |values: &Vec<f64>| known.insert(values.iter().map(|value| value.to_bits()).collect());
    cases.into_iter().filter(is_new).collect()
}

/// What the columns are.
fn columns_of(table: &HandTable, headings: &[Heading]) -> Result<Vec<Column>, Mistake> {
    let columns = headings.iter().map(|heading| {
        column_of(heading).ok_or_else(|| {
            let (name, known) = (&heading.text, Axis::NAMES.join(", "));
            table.header_mistake(format!("unknown column `{name}`; known: {known}"))
        })
    });
    columns.collect()
}

fn column_of(heading: &Heading) -> Option<Column> {
    let axis = axis_of(heading).map(|(axis, factor)| Column::Axis(axis, factor));
    axis.or_else(|| is_of_results(&heading.text).then_some(Column::Result))
}

/// The axis that a heading names: `surface_speed_rpm`, `Surface speed (rpm)`.
fn axis_of(heading: &Heading) -> Option<(Axis, f64)> {
    let named = |name: &str| {
        let in_units = || Axis::from_field_name(name);
        (Axis::from_name(name).map(|axis| (axis, 1.0))).or_else(in_units)
    };
    named(&heading.text).or_else(|| named(&heading.snake()))
}
