//! Cases as listed in a CSV file whose header names the axes.

use std::collections::HashMap;
use std::fmt::Display;

use super::axes::{count_string_axes, place};
use crate::quantities::Axis;
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
        let list =
            cases_of(&text, weight_pushes).map_err(|mistake| refused(format!(":{mistake}")))?;
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

fn cases_of(text: &str, weight_pushes: bool) -> Result<List, Mistake> {
    let is_header = |headings: &[Heading]| headings.iter().all(|it| axis_of(it).is_some());
    let (table, headings) = HandTable::with_headings(text, &is_header)?;
    let columns = axes_of(&table, &headings)?;
    // Columns of results follow the order of the axes, not that of the file.
    let mut order: Vec<usize> = (0..columns.len()).collect();
    let axis = |&column: &usize| columns[column].0;
    order.sort_by_key(|column| place(axis(column), weight_pushes));
    if let Some(pair) = (order.windows(2)).find(|pair| axis(&pair[0]) == axis(&pair[1])) {
        let name = axis(&pair[0]).name();
        return Err(table.header_mistake(format!("the column `{name}` is there twice")));
    }
    let mut cases = Vec::new();
    for row in table.rows() {
        let row = row?;
        let value = |&column: &usize| {
            let (axis, factor) = columns[column];
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
    let axes = order.iter().map(axis).collect();
    Ok(List::new(axes, cases, weight_pushes))
}

/// The axes that the columns name, and what numbers in their units are multiplied by.
fn axes_of(table: &HandTable, headings: &[Heading]) -> Result<Vec<(Axis, f64)>, Mistake> {
    let axes = headings.iter().map(|heading| {
        axis_of(heading).ok_or_else(|| {
            let (name, known) = (&heading.text, Axis::NAMES.join(", "));
            table.header_mistake(format!("unknown column `{name}`; known: {known}"))
        })
    });
    axes.collect()
}

/// The axis that a heading names: `surface_speed_rpm`, `Surface speed (rpm)`.
fn axis_of(heading: &Heading) -> Option<(Axis, f64)> {
    let named = |name: &str| {
        let in_units = || Axis::from_field_name(name);
        (Axis::from_name(name).map(|axis| (axis, 1.0))).or_else(in_units)
    };
    named(&heading.text).or_else(|| named(&heading.snake()))
}
