//! The schema of a sweep file whose bases are merged in, in SI units: the types as they are.

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use serde_json::Value;

use crate::sweep_file::file::FileContent;

/// The schema that the types have by themselves, in the terms of TOML.
pub fn of_types() -> Value {
    let settings =
        SchemaSettings::draft2020_12().with_transform(RecursiveTransform(as_toml_has_it));
    settings
        .into_generator()
        .into_root_schema_for::<FileContent>()
        .to_value()
}

/// The choices that a keyword of a schema lists.
fn choices<'schema>(schema: &'schema Schema, keyword: &str) -> Option<&'schema [Value]> {
    schema.get(keyword)?.as_array().map(Vec::as_slice)
}

/// TOML has no null: what is optional is left out. Formats of numbers are those of Rust; a
/// default that is a table is given by the defaults of its keys; a description is one paragraph.
fn as_toml_has_it(schema: &mut Schema) {
    let is_null = |value: &Value| value.is_null() || value["type"] == "null" || value == "null";
    for keyword in ["type", "enum", "anyOf"] {
        if let Some(Value::Array(choices)) = schema.get_mut(keyword) {
            choices.retain(|choice| !is_null(choice));
        }
    }
    if let Some([kind]) = choices(schema, "type") {
        let kind = kind.clone();
        schema.insert("type".to_owned(), kind);
    }
    if let Some([Value::Object(only)]) = choices(schema, "anyOf") {
        let only = only.clone();
        schema.remove("anyOf");
        for (keyword, value) in only {
            schema.ensure_object().entry(keyword).or_insert(value);
        }
    }
    schema.remove("format");
    if (schema.get("default")).is_some_and(|default| default.is_null() || default.is_object()) {
        schema.remove("default");
    }
    if let Some(Value::String(description)) = schema.get_mut("description") {
        *description = description.replace('\n', " ");
    }
}
