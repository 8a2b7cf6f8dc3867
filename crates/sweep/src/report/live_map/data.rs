//! The cases of a map as a page holds them: once, by columns, numbers as they are in the table.

use sim::Motion;
use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use csv::StringRecord;
use serde_json::{Value, json};

use super::opening::opening;
use crate::map::MapDrawing;
use campaign::quantities::{Axis, FORCE, LENGTH, TORQUE, Unit, Units, WIDTH};
use campaign::text_file::unreadable;
use campaign::words::file_word;
use plot::{MapAxis, map_axes};
use results::folder::{Manifest, ResultTables, column_words};

/// Of more simulations, no page has the values: they are not even read.
const MOST_ROWS: usize = 40_000;

/// Digits of measures, the first choice that fits: all, or this number.
const DIGITS: [Option<usize>; 3] = [None, Some(4), Some(3)];

/// The cases of a drawing, where they fit into a number of bytes.
///
/// # Errors
/// Where a table cannot be read.
pub fn data(tables: &ResultTables, drawing: &MapDrawing, room: usize) -> Result<Option<Value>> {
    let manifest = &tables.manifest;
    if manifest.tally.rows > MOST_ROWS {
        return Ok(None);
    }
    let table = Table::read(&tables.folder.join("labels.csv"), manifest)?;
    let units = manifest.sweep.units;
    let axes = manifest.axes.iter();
    let drawn = map_axes(&drawing.chart, 2);
    let place = |axis: Axis| manifest.axes.iter().position(|other| *other == axis);
    let mut data = json!({
        "command_parts": command(manifest),
        "axes": axes
            .map(|&axis| described((&axis.name(), &axis.words(units)), &axis.unit(units)))
            .collect::<Value>(),
        "places": drawing.axes.map(place),
        "ends": drawn.each_ref().map(MapAxis::ends),
        "logarithmic": drawn.each_ref().map(MapAxis::is_logarithmic),
        "panels": panels(drawing, place),
        "cases": table.cases,
        "values": table.values,
        "methods": manifest.method_names(),
        "opening": opening(manifest),
        "full": manifest.options.full,
        "shown": {
            "torque": shown(&units.of(&TORQUE)),
            "force": shown(&units.of(&FORCE)),
            "width": shown(&units.of(&WIDTH)),
            "length": shown(&units.of(&LENGTH)),
        },
        "failures": failures(&tables.folder.join("failures.csv"))?,
    });
    for digits in DIGITS {
        let columns = table.columns.iter();
        data["columns"] = columns
            .filter_map(|column| column.json(units, digits))
            .collect();
        data["digits"] = digits.into();
        if data.to_string().len() <= room {
            return Ok(Some(data));
        }
    }
    Ok(None)
}

/// What simulates a case, before and after its number.
fn command(manifest: &Manifest) -> [String; 2] {
    let file = manifest
        .sweep_file
        .as_ref()
        .and_then(|file| file.file_name());
    let file = file.map_or_else(
        || format!("{}.toml", manifest.name),
        |name| name.to_string_lossy().into_owned(),
    );
    let file = file_word(&file);
    let options = manifest.options;
    let after = [
        (options.full, " --full"),
        (options.allow_unstable, " --allow-unstable"),
    ];
    let after = after.map(|(given, option)| if given { option } else { "" });
    [format!("sweep simulate {file} --case "), after.concat()]
}

/// A quantity: its column, its words, its unit, and how much of the column's unit that is.
fn described((name, words): (&str, &str), unit: &Unit) -> Value {
    json!({ "name": name, "words": words, "unit": unit.name, "size": 1.0 / unit.number(1.0) })
}

/// A unit, and how much of the unit in SI it is.
pub fn shown(unit: &Unit) -> Value {
    json!({ "unit": unit.name, "size": 1.0 / unit.number(1.0) })
}

/// Of each map, in the order of the page, what its cases have along other axes and the motion
/// that it is of; a map of all cases has neither.
fn panels(drawing: &MapDrawing, place: impl Fn(Axis) -> Option<usize>) -> Value {
    let groups = drawing.chart.groups.iter().enumerate();
    let panels = groups.flat_map(|(index, group)| {
        let motion = drawing.motions.get(index).copied();
        (0..group.panels.len()).map(move |panel| (motion, panel))
    });
    let panels = panels.map(|(motion, panel)| {
        let combination = motion.and_then(|_| drawing.combinations.get(panel));
        let values = combination.map_or(&[][..], Vec::as_slice);
        let held = drawing.others.iter().zip(values);
        let held = held.map(|(&axis, value)| json!([place(axis), value]));
        let motion = motion.map(Motion::name);
        json!({ "motion": motion, "held": held.collect::<Value>() })
    });
    panels.collect()
}

/// A `labels.csv` by columns.
struct Table {
    cases: Vec<usize>,
    /// Along each axis, by case.
    values: Vec<Vec<f64>>,
    columns: Vec<Column>,
}

/// What follows the axes: a field for each method of each case.
struct Column {
    name: String,
    fields: Vec<String>,
}

impl Table {
    fn read(path: &Path, manifest: &Manifest) -> Result<Self> {
        let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
        let header = reader.headers().with_context(|| unreadable(path))?.clone();
        let axes: Vec<String> = manifest.axes.iter().map(|axis| axis.name()).collect();
        let place = |name: &str| header.iter().position(|other| other == name);
        let known = |name: &str| axes.iter().any(|axis| axis == name) || name == "case";
        let names = header
            .iter()
            .filter(|name| !known(name) && *name != "method");
        let mut table = Self {
            cases: Vec::new(),
            values: vec![Vec::new(); axes.len()],
            columns: (names)
                .map(|name| Column {
                    name: name.to_owned(),
                    fields: Vec::new(),
                })
                .collect(),
        };
        let methods = manifest.method_names();
        for record in reader.records() {
            let record = record.with_context(|| unreadable(path))?;
            let field = |name: &str| place(name).and_then(|place| record.get(place));
            let case = number(field("case")).with_context(|| unreadable(path))?;
            if table.cases.last() != Some(&case) {
                table.cases.push(case);
                for (values, axis) in table.values.iter_mut().zip(&axes) {
                    values.push(number(field(axis)).with_context(|| unreadable(path))?);
                }
            }
            let rows = table.cases.len() * methods.len();
            let method = field("method");
            if let Some(method) = methods.iter().position(|name| Some(*name) == method) {
                let row = rows - methods.len() + method;
                table.add(&record, &header, row, rows);
            }
        }
        Ok(table)
    }

    /// Puts a record in its row, among a number of rows.
    fn add(&mut self, record: &StringRecord, header: &StringRecord, row: usize, rows: usize) {
        for column in &mut self.columns {
            column.fields.resize(rows, String::new());
            let place = header.iter().position(|name| name == column.name);
            let field = place.and_then(|place| record.get(place));
            column.fields[row] = field.unwrap_or_default().to_owned();
        }
    }
}

fn number<Number: std::str::FromStr>(field: Option<&str>) -> Result<Number>
where
    Number::Err: std::error::Error + Send + Sync + 'static,
{
    let field = field.unwrap_or_default();
    (field.parse()).with_context(|| format!("`{field}` is not a number"))
}

impl Column {
    /// What a page holds of it; none where it is empty.
    fn json(&self, units: Units, digits: Option<usize>) -> Option<Value> {
        let mut filled = self
            .fields
            .iter()
            .filter(|field| !field.is_empty())
            .peekable();
        filled.peek()?;
        let (words, unit) = column_words(&self.name, units);
        let mut json = described((&self.name, &words), &unit);
        if filled.all(|field| finite(field).is_some()) {
            let value = |field: &String| finite(field).map(|value| rounded(value, digits));
            json["rows"] = self.fields.iter().map(value).collect();
        } else {
            // Each word once.
            let mut words: Vec<&str> = Vec::new();
            let mut rows = Vec::with_capacity(self.fields.len());
            for field in &self.fields {
                rows.push(if field.is_empty() {
                    Value::Null
                } else if let Some(place) = words.iter().position(|word| word == field) {
                    place.into()
                } else {
                    words.push(field);
                    (words.len() - 1).into()
                });
            }
            json["texts"] = words.into();
            json["rows"] = rows.into();
        }
        Some(json)
    }
}

fn finite(field: &str) -> Option<f64> {
    field.parse().ok().filter(|value: &f64| value.is_finite())
}

/// With a number of digits, or all; a whole number is written as one.
fn rounded(value: f64, digits: Option<usize>) -> Value {
    let in_digits = digits.and_then(|digits| format!("{value:.*e}", digits - 1).parse().ok());
    let value: f64 = in_digits.unwrap_or(value);
    if value == value.trunc() && value.abs() < 1e15 {
        return (value as i64).into();
    }
    value.into()
}

/// Why cases have no answer: by the case, then by the method.
fn failures(path: &Path) -> Result<BTreeMap<String, BTreeMap<String, String>>> {
    let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
    let mut failures: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    for failure in reader.deserialize() {
        let [case, method, reason, _]: [String; 4] = failure.with_context(|| unreadable(path))?;
        failures.entry(case).or_default().insert(method, reason);
    }
    Ok(failures)
}
