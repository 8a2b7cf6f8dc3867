//! A table that knows on which line of which file each of its values stands, and
//! how one is laid over another.

use std::collections::BTreeMap;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Where a value stands.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Number of the file.
    pub file: usize,
    /// Line of it, from 1.
    pub line: usize,
}

/// Where a value and what is in it stand.
#[derive(Debug, Clone)]
pub struct Places {
    own: Place,
    keys: BTreeMap<String, Places>,
    items: Vec<Places>,
}

/// A table with the places of its values.
#[derive(Debug, Clone, Default)]
pub struct Placed {
    /// The values.
    pub table: toml::Table,
    places: BTreeMap<String, Places>,
}

impl Placed {
    /// The place of the value at a key path (`string.sections[0].repeat`) or, where
    /// it is not given, of what it would be in.
    pub fn find(&self, path: &str) -> Option<Place> {
        let (mut found, mut rest) = key_of(&self.places, path)?;
        while let Some((inner, after)) = found.child(rest) {
            (found, rest) = (inner, after);
        }
        Some(found.own)
    }

    /// Takes a key out.
    pub fn remove(&mut self, key: &str) {
        self.table.remove(key);
        self.places.remove(key);
    }

    /// Lays the table of a file over this one: tables key by key, anything else as a
    /// whole, and a `[design]` as a whole too.
    pub fn lay_over(&mut self, over: &DeTable, file: usize, lines: &LineNumbers) {
        if over.contains_key("design") {
            self.remove("design");
        }
        Layer { file, lines }.lay(self, over);
        self.remove("base");
    }
}

impl Places {
    fn child<'a>(&self, path: &'a str) -> Option<(&Places, &'a str)> {
        let Some(index) = path.strip_prefix('[') else {
            return key_of(&self.keys, path.strip_prefix('.')?);
        };
        let (index, rest) = index.split_once(']')?;
        Some((self.items.get(index.parse::<usize>().ok()?)?, rest))
    }
}

/// What a path begins with, and the rest of the path. A key may have a dot in it.
fn key_of<'p, 'a>(
    keys: &'p BTreeMap<String, Places>,
    path: &'a str,
) -> Option<(&'p Places, &'a str)> {
    let ends = path.match_indices(['.', '[']).map(|(end, _)| end);
    ends.chain([path.len()])
        .find_map(|end| Some((keys.get(&path[..end])?, &path[end..])))
}

/// A file that is laid over others.
struct Layer<'a> {
    file: usize,
    lines: &'a LineNumbers,
}

impl Layer<'_> {
    fn place(&self, start: usize) -> Place {
        Place {
            file: self.file,
            line: self.lines.of(start),
        }
    }

    fn lay(&self, under: &mut Placed, over: &DeTable) {
        for (key, value) in over {
            let name = key.get_ref().as_ref();
            let below = under.table.remove(name).zip(under.places.remove(name));
            let below = match below {
                Some((toml::Value::Table(table), places)) => Placed {
                    table,
                    places: places.keys,
                },
                _ => Placed::default(),
            };
            let (value, mut places) = self.value(value, below);
            places.own = self.place(key.span().start);
            under.table.insert(name.to_owned(), value);
            under.places.insert(name.to_owned(), places);
        }
    }

    fn value(&self, value: &Spanned<DeValue>, mut below: Placed) -> (toml::Value, Places) {
        let mut places = Places {
            own: self.place(value.span().start),
            keys: BTreeMap::new(),
            items: Vec::new(),
        };
        let value = match value.get_ref() {
            DeValue::Table(table) => {
                self.lay(&mut below, table);
                places.keys = below.places;
                toml::Value::Table(below.table)
            }
            DeValue::Array(items) => {
                let items = items.iter().map(|item| {
                    let (item, place) = self.value(item, Placed::default());
                    places.items.push(place);
                    item
                });
                toml::Value::Array(items.collect())
            }
            scalar => plain(scalar),
        };
        (value, places)
    }
}

/// A scalar without its place. A whole number too large for its type becomes
/// the nearest other one, which is refused at its place unless it makes sense.
fn plain(value: &DeValue) -> toml::Value {
    match value {
        DeValue::String(text) => toml::Value::String(text.to_string()),
        DeValue::Boolean(choice) => toml::Value::Boolean(*choice),
        DeValue::Datetime(time) => toml::Value::Datetime(*time),
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix())
            .map_or_else(
                |_| toml::Value::Float(number.as_str().parse().unwrap_or(f64::INFINITY)),
                toml::Value::Integer,
            ),
        DeValue::Float(number) => number.as_str().parse().map_or_else(
            |_| toml::Value::String(number.to_string()),
            toml::Value::Float,
        ),
        DeValue::Array(_) | DeValue::Table(_) => toml::Value::Table(toml::Table::new()),
    }
}

/// Byte offsets to line numbers.
pub struct LineNumbers {
    starts: Vec<usize>,
}

impl LineNumbers {
    /// Of a text.
    pub fn new(text: &str) -> Self {
        let after_breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Self {
            starts: std::iter::once(0).chain(after_breaks).collect(),
        }
    }

    /// The line, from 1, of a byte.
    pub fn of(&self, offset: usize) -> usize {
        self.starts.partition_point(|&start| start <= offset)
    }
}
