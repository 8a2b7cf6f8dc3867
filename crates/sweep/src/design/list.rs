//! Cases as listed in a CSV file whose header names the axes.

use std::collections::HashMap;
use std::path::Path;

use super::count_string_axes;
use crate::lines::{COMMENT, line_from};
use crate::spec::{Axis, DesignTable, Source, SpecError, TextOf, check_axis_value};
use crate::text_file::LARGEST_TABLE;

/// Listed cases.
#[derive(Debug, Clone, PartialEq)]
pub struct List {
    axes: Vec<Axis>,
    cases: Vec<Vec<f64>>,
    /// The numbers of the cases of each string, in the order in which the
    /// strings first appear.
    strings: Vec<Vec<usize>>,
}

impl List {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        text_of: TextOf,
    ) -> Result<Self, SpecError> {
        let Some(file) = &table.file else {
            return Err(source.error("design", "a list needs `file`, a CSV file of cases"));
        };
        let path = source.folder_of("design.file").join(file);
        let list = read(source, &path, text_of).map_err(|message| {
            source.error("design.file", format!("{}{message}", path.display()))
        })?;
        if list.cases.is_empty() {
            let message = format!("{} lists no case", path.display());
            return Err(source.error("design.file", message));
        }
        Ok(list)
    }

    pub(super) fn axes(&self) -> &[Axis] {
        &self.axes
    }

    pub(super) fn cases(&self) -> usize {
        self.cases.len()
    }

    pub(super) fn values(&self, index: usize) -> &[f64] {
        &self.cases[index]
    }

    pub(super) fn strings(&self) -> usize {
        self.strings.len()
    }

    pub(super) fn cases_of_string(&self, string: usize) -> &[usize] {
        &self.strings[string]
    }

    /// Cases with given values along given axes, which are in order.
    pub fn new(axes: Vec<Axis>, cases: Vec<Vec<f64>>) -> Self {
        let of_string = count_string_axes(&axes);
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
            strings,
        }
    }
}

/// Reads a list; an error starts where the file's name ends.
fn read(source: &Source, path: &Path, text_of: TextOf) -> Result<List, String> {
    let text = text_of(path, LARGEST_TABLE).map_err(|error| format!(" cannot be read: {error}"))?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(COMMENT))
        .flexible(true)
        .from_reader(text.as_bytes());
    let header = reader
        .headers()
        .map_err(|error| format!(": {error}"))?
        .clone();
    let columns = header
        .iter()
        .map(|name| {
            Axis::from_name(name).ok_or_else(|| {
                let line = line_from(&text, 0);
                format!(
                    ":{line}: unknown column `{name}`; known: {}",
                    Axis::NAMES.join(", ")
                )
            })
        })
        .collect::<Result<Vec<Axis>, _>>()?;
    // Columns of results follow the order of the axes, whatever the file's.
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by_key(|&column| columns[column]);
    if let Some(pair) = order
        .windows(2)
        .find(|pair| columns[pair[0]] == columns[pair[1]])
    {
        return Err(format!(
            ":{}: the column `{}` is there twice",
            line_from(&text, 0),
            columns[pair[0]].name()
        ));
    }
    let mut cases = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| format!(": {error}"))?;
        // Counted where there is something to say of it.
        let line = || {
            let byte = record.position().map_or(0, csv::Position::byte);
            line_from(&text, byte as usize)
        };
        if record.len() != columns.len() {
            let (found, expected) = (record.len(), columns.len());
            return Err(format!(
                ":{}: {found} values, but {expected} columns",
                line()
            ));
        }
        let value = |&column: &usize| {
            let (axis, text) = (columns[column], &record[column]);
            let at = |what: &str| format!(":{}: {}: {what}", line(), axis.name());
            let value = text
                .parse()
                .map_err(|_| at(&format!("`{text}` is not a number")))?;
            check_axis_value(source, &axis.name(), axis, value)
                .map_err(|error| at(error.message()))?;
            Ok(value)
        };
        cases.push(order.iter().map(value).collect::<Result<_, String>>()?);
    }
    let axes = order.iter().map(|&column| columns[column]).collect();
    Ok(List::new(axes, cases))
}
