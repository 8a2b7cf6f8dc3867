//! Tables in a schema: objects with `properties`, the root and definitions of others.

use serde_json::{Map, Value};

/// A schema, as JSON has it.
pub type Object = Map<String, Value>;

/// Where definitions are.
const DEFINITIONS: &str = "$defs";

/// The root and every definition that is a table.
pub fn all(root: &Value) -> impl Iterator<Item = &Value> {
    let definitions = root[DEFINITIONS].as_object();
    let tables = definitions.into_iter().flat_map(Map::values);
    std::iter::once(root).chain(tables.filter(|definition| definition["properties"].is_object()))
}

/// The names of the definitions that are tables.
pub fn names(root: &Value) -> Vec<String> {
    let definitions = root[DEFINITIONS].as_object().into_iter().flatten();
    let tables = definitions.filter(|(_, definition)| definition["properties"].is_object());
    tables.map(|(name, _)| name.clone()).collect()
}

/// The keys of a table.
pub fn keys(table: &Value) -> impl Iterator<Item = &String> {
    table["properties"]
        .as_object()
        .into_iter()
        .flat_map(Map::keys)
}

/// A table by the name of its definition; the root has none.
pub fn named<'a>(root: &'a mut Value, name: &str) -> Option<&'a mut Object> {
    match name {
        "" => root.as_object_mut(),
        name => root.get_mut(DEFINITIONS)?.get_mut(name)?.as_object_mut(),
    }
}

/// The name of the definition of the table that stands at a key, not that of the items of a list.
pub fn named_at(table: &Object, key: &str) -> Option<String> {
    let property = table.get("properties")?.get(key)?;
    let name = property.get("$ref")?.as_str()?.rsplit('/').next()?;
    Some(name.to_owned())
}
