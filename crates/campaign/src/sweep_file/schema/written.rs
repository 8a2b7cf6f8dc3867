//! From the schema of the types to that of a file as a person writes it: with its base, with keys
//! in field units, with one of two keys that say the same.

use serde_json::{Value, json};

use super::table::{self, Object};
use crate::quantities::{Axis, Twin, Units, twins_of, unit_of};
use crate::sweep_file::rivals::RIVALS;

/// The table that replaces that of a base as a whole.
const REPLACED_WHOLE: &str = "design";

/// The schema of a file, from that of the types.
pub fn as_written(mut schema: Value) -> Value {
    let required = required_without_base(&mut schema, "");
    let names = [vec![String::new()], table::names(&schema)].concat();
    let rivals = rivals(&schema);
    for name in names {
        let rivals: Vec<_> = rivals.iter().filter(|it| it.table == name).collect();
        if let Some(table) = table::named(&mut schema, &name) {
            let required = table.remove("required");
            table.extend(requirements(&keys_in(required), &rivals));
            exclude(table, &rivals);
            add_units(table);
        }
    }
    describe_axes(&mut schema);
    add_base(&mut schema, required, &rivals);
    schema
}

/// Two keys of a table that say the same, of which a file gives one.
struct Rivals {
    /// The name of the definition of the table.
    table: String,
    keys: [&'static str; 2],
}

/// Those of the reader.
fn rivals(schema: &Value) -> Vec<Rivals> {
    let root = schema.as_object();
    let table = |key: &str| root.and_then(|root| table::named_at(root, key));
    let all = RIVALS.iter().map(|rivals| Rivals {
        table: table(rivals.0).unwrap_or_default(),
        keys: [rivals.1, rivals.2],
    });
    all.collect()
}

/// A key as it may be written: in SI units, and in others.
fn spellings(key: &str) -> Vec<String> {
    let twins = twins_of(key).map(|(twin, _)| twin);
    std::iter::once(key.to_owned()).chain(twins).collect()
}

/// The keys of a list of them.
fn keys_in(list: Option<Value>) -> Vec<String> {
    let Some(Value::Array(list)) = list else {
        return Vec::new();
    };
    let texts = list.iter().filter_map(Value::as_str);
    texts.map(str::to_owned).collect()
}

/// What a table needs to have these keys, each in any unit, or a rival of it.
fn requirements(keys: &[String], rivals: &[&Rivals]) -> Object {
    let mut plain = Vec::new();
    let mut choices = Vec::new();
    for key in keys {
        let others = rivals.iter().filter_map(|rivals| match rivals.keys {
            [one, other] if other == key => Some(one),
            [one, other] if one == key => Some(other),
            _ => None,
        });
        let of_others = others.flat_map(spellings);
        let any: Vec<String> = spellings(key).into_iter().chain(of_others).collect();
        match any.as_slice() {
            [only] => plain.push(json!(only)),
            any => {
                let any: Vec<Value> = any.iter().map(|key| json!({ "required": [key] })).collect();
                choices.push(json!({ "anyOf": any }));
            }
        }
    }
    let mut needed = Object::new();
    if !plain.is_empty() {
        needed.insert("required".to_owned(), Value::Array(plain));
    }
    if !choices.is_empty() {
        needed.insert("allOf".to_owned(), Value::Array(choices));
    }
    needed
}

/// Takes out what has to be given only where no base gives it: the keys of the tables that are
/// laid over those of a base key by key.
fn required_without_base(schema: &mut Value, name: &str) -> Value {
    let Some(table) = table::named(schema, name) else {
        return Value::Null;
    };
    let keys = keys_in(table.remove("required"));
    let properties = table.get("properties").and_then(Value::as_object);
    let below: Vec<(String, String)> = (properties.into_iter().flat_map(Object::keys))
        .filter(|key| key.as_str() != REPLACED_WHOLE)
        .filter_map(|key| Some((key.clone(), table::named_at(table, key)?)))
        .collect();
    let mut tree = Object::new();
    for (key, name) in below {
        let inner = required_without_base(schema, &name);
        if !inner.is_null() {
            tree.insert(key, inner);
        }
    }
    if keys.is_empty() && tree.is_empty() {
        return Value::Null;
    }
    json!({ "keys": keys, "table": name, "below": tree })
}

/// The tree of what is needed without a base, as a schema.
fn needed(tree: &Value, rivals: &[Rivals]) -> Value {
    let of_table: Vec<_> = rivals
        .iter()
        .filter(|it| tree["table"] == it.table)
        .collect();
    let mut needed_here = requirements(&keys_in(Some(tree["keys"].clone())), &of_table);
    let below = tree["below"].as_object().into_iter().flatten();
    let below: Object = below
        .map(|(key, tree)| (key.clone(), needed(tree, rivals)))
        .collect();
    if !below.is_empty() {
        needed_here.insert("properties".to_owned(), Value::Object(below));
    }
    Value::Object(needed_here)
}

/// Refuses a quantity in two units, and two keys that say the same.
fn exclude(table: &mut Object, rivals: &[&Rivals]) {
    let keys = table.get("properties").and_then(Value::as_object);
    let keys: Vec<String> = keys.into_iter().flat_map(Object::keys).cloned().collect();
    let mut pairs = Vec::new();
    for key in &keys {
        let all = spellings(key);
        for (index, one) in all.iter().enumerate() {
            pairs.extend(
                all[index + 1..]
                    .iter()
                    .map(|other| [one.clone(), other.clone()]),
            );
        }
    }
    for [one, other] in rivals.iter().map(|rivals| rivals.keys) {
        for one in spellings(one) {
            pairs.extend(
                spellings(other)
                    .into_iter()
                    .map(|other| [one.clone(), other]),
            );
        }
    }
    if !pairs.is_empty() {
        let pairs: Vec<Value> = pairs
            .iter()
            .map(|pair| json!({ "required": pair }))
            .collect();
        table.insert("not".to_owned(), json!({ "anyOf": pairs }));
    }
}

/// Says the unit of every key, and adds the keys in field units.
fn add_units(table: &mut Object) {
    let Some(Value::Object(properties)) = table.get_mut("properties") else {
        return;
    };
    let mut twins = Vec::new();
    for (key, property) in properties.iter_mut() {
        for (name, twin) in twins_of(key) {
            twins.push((name, in_other_unit(property, key, twin)));
        }
        if let Some(unit) = unit_of(key) {
            let text = description(property);
            property["description"] = json!(format!("{text} Unit: {unit}."));
        }
    }
    properties.extend(twins);
}

fn description(property: &Value) -> String {
    property["description"]
        .as_str()
        .unwrap_or_default()
        .to_owned()
}

/// A key's schema, with its numbers in another unit.
fn in_other_unit(property: &Value, key: &str, twin: &Twin) -> Value {
    let mut other = property.clone();
    let mut text = description(property);
    if twin.twin.starts_with("_diameter") {
        text = text
            .replace("radius", "diameter")
            .replace("Radius", "Diameter");
    }
    let unit = twin.units[1];
    other["description"] = json!(format!("{text} Unit: {unit}, in place of `{key}`."));
    for keyword in ["minimum", "maximum", "exclusiveMinimum", "default"] {
        if let Some(number) = other[keyword].as_f64() {
            other[keyword] = json!(number / twin.factors[0]);
        }
    }
    other
}

/// Says of every axis of a design what it is.
fn describe_axes(schema: &mut Value) {
    let Some(design) = table::named(schema, "DesignTable") else {
        return;
    };
    let axes = design["properties"]["axes"]["properties"].as_object_mut();
    for (name, property) in axes.into_iter().flatten() {
        let words = match Axis::from_name(name) {
            Some(axis) => Some(axis.title(Units::Si)),
            None => Axis::from_field_name(name).map(|(axis, _)| axis.words(Units::Field)),
        };
        if let Some(words) = words {
            property["description"] = json!(words);
        }
    }
}

/// Adds the keys of another file, without which everything is needed that has no default.
fn add_base(schema: &mut Value, required: Value, rivals: &[Rivals]) {
    schema["title"] = json!("A sweep file");
    schema["description"] = json!("A sweep file of the program `sweep`.");
    schema["properties"]["base"] = json!({
        "type": "string",
        "description": BASE,
    });
    schema["properties"]["without"] = json!({
        "type": "array",
        "items": { "type": "string" },
        "description": WITHOUT,
    });
    schema["if"] = json!({ "required": ["base"] });
    schema["else"] = needed(&required, rivals);
}

/// What the key of another file means: it is read before the types are.
const BASE: &str = "Another sweep file, in the folder of this one, which gives everything that is \
                    not given \
    here. A `[design]` replaces the base's as a whole, and so does any list, such as `sites`; of \
    other tables, each key does.";

/// Description of the key that takes keys of another file away.
const WITHOUT: &str = "Keys that the base has and this sweep has not, each with the tables around it: \
                       `[\"bit.cutting.blades\", \"map.x\", \"wall\"]`.";
