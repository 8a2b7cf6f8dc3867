//! What is measured of a case and may be the colour of a map.

use std::borrow::Cow;
use std::sync::LazyLock;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use sim::Motion;

use super::column::{Needs, RecordRow, ResultColumn};
use super::columns::{COLUMNS, RENAMED, name_now};
use super::field::Field;
use crate::quantities::{Unit, Units};

/// A measure of a case: one of the columns of results that a map may have as colour.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    column: &'static ResultColumn,
    /// The name of an earlier version, where it was asked for by that.
    old_name: Option<&'static str>,
}

/// The names of all measures.
static NAMES: LazyLock<Vec<&str>> = LazyLock::new(|| all().map(Measure::column).collect());

fn all() -> impl Iterator<Item = Measure> {
    let measures = COLUMNS.iter().filter(|column| column.is_measure);
    measures.map(|column| Measure {
        column,
        old_name: None,
    })
}

impl Measure {
    /// Those that say how severe a motion is.
    pub fn severities() -> impl Iterator<Item = Self> {
        all().filter(|measure| measure.column.is_severity)
    }

    /// That of a column of `labels.csv`, by its name or an earlier one.
    pub fn named(column: &str) -> Option<Self> {
        let old_name = RENAMED.iter().find(|(old, _)| *old == column);
        let found = all().find(|measure| measure.column() == name_now(column))?;
        Some(Self {
            old_name: old_name.map(|(old, _)| *old),
            ..found
        })
    }

    /// The earlier name that it was asked for by.
    pub fn old_name(self) -> Option<&'static str> {
        self.old_name
    }

    /// Its column in `labels.csv`.
    pub fn column(self) -> &'static str {
        self.column.name
    }

    /// What a row holds of it.
    pub fn field(self, row: &RecordRow) -> Field<'static> {
        self.column.field(row)
    }

    /// As a person reads it.
    pub fn words(self) -> &'static str {
        self.column.words
    }

    /// The unit in which it is shown.
    pub fn unit(self, units: Units) -> Unit {
        self.column.unit(units)
    }

    /// The motion that it is about, where it is about one.
    pub fn motion(self) -> Option<Motion> {
        self.column.motion
    }

    /// What has to be modelled for it.
    pub fn needs(self) -> Option<Needs> {
        self.column.needs()
    }
}

impl PartialEq for Measure {
    fn eq(&self, other: &Self) -> bool {
        self.column() == other.column()
    }
}

impl Serialize for Measure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.column())
    }
}

impl<'de> Deserialize<'de> for Measure {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Self::named(&name).ok_or_else(|| D::Error::unknown_variant(&name, &NAMES))
    }
}

/// Any of the names, each with its words.
impl JsonSchema for Measure {
    fn schema_name() -> Cow<'static, str> {
        "Measure".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let names: Vec<serde_json::Value> = all()
            .map(|measure| {
                serde_json::json!({
                    "type": "string",
                    "const": measure.column(),
                    "description": measure.words(),
                })
            })
            .collect();
        json_schema!({ "description": "A measure of a case, named as its column of `labels.csv`.", "oneOf": names })
    }
}
