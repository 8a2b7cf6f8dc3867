//! A table that knows on which line of which file each of its values stands, and
//! how one is laid over another.

use std::collections::BTreeMap;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::units::{key_in_si, scale};

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
pub struct KeyPlaces {
    own: Place,
    /// The key as it was written, where that is in other units.
    written: Option<String>,
    keys: Keys,
    items: Vec<KeyPlaces>,
}

/// The keys of a table in the order of their names: of thousands of small tables, as `[[sites]]` are,
/// a tree would take a kilobyte each.
#[derive(Debug, Clone, Default)]
struct Keys(Vec<(String, KeyPlaces)>);

impl Keys {
    fn find(&self, name: &str) -> Result<usize, usize> {
        self.0.binary_search_by(|(key, _)| key.as_str().cmp(name))
    }

    fn get(&self, name: &str) -> Option<&KeyPlaces> {
        self.find(name).ok().map(|place| &self.0[place].1)
    }

    fn get_mut(&mut self, name: &str) -> Option<&mut KeyPlaces> {
        self.find(name).ok().map(|place| &mut self.0[place].1)
    }

    fn insert(&mut self, name: String, places: KeyPlaces) {
        match self.find(&name) {
            Ok(place) => self.0[place].1 = places,
            Err(place) => self.0.insert(place, (name, places)),
        }
    }

    fn remove(&mut self, name: &str) -> Option<KeyPlaces> {
        self.find(name).ok().map(|place| self.0.remove(place).1)
    }
}

/// A table with the places of its values.
#[derive(Debug, Clone, Default)]
pub struct Placed {
    /// The values.
    pub table: toml::Table,
    places: Keys,
}

impl Placed {
    /// The place of the value at a key path (`string.sections[0].repeat`) or, where
    /// it is not given, of what it would be in; and the path as it was written.
    pub fn find(&self, path: &str) -> Option<(Place, String)> {
        let (mut found, mut key, mut rest) = key_of(&self.places, path)?;
        let mut written = String::new();
        loop {
            written += found.written.as_deref().unwrap_or(key);
            let Some((inner, before, name, after)) = found.child(rest) else {
                return Some((found.own, written + rest));
            };
            written += before;
            (found, key, rest) = (inner, name, after);
        }
    }

    /// Takes a key out.
    pub fn remove(&mut self, key: &str) {
        self.table.remove(key);
        self.places.remove(key);
    }

    /// Takes a key out of a table, or out of this one where that has no name.
    pub fn remove_in(&mut self, table: &str, key: &str) {
        if table.is_empty() {
            return self.remove(key);
        }
        if let Some(toml::Value::Table(values)) = self.table.get_mut(table) {
            values.remove(key);
        }
        if let Some(places) = self.places.get_mut(table) {
            places.keys.remove(key);
        }
    }

    /// Takes the key at a path (`bit.cutting.blades`) out, by its name in SI or another unit; whether it is
    /// there.
    pub fn take_out(&mut self, path: &str) -> bool {
        let (above, key) = path.rsplit_once('.').unwrap_or(("", path));
        let (mut table, mut places) = (&mut self.table, &mut self.places);
        for name in above.split('.').filter(|name| !name.is_empty()) {
            let inner = (table.get_mut(name), places.get_mut(name));
            let (Some(toml::Value::Table(inner)), Some(keys)) = inner else {
                return false;
            };
            (table, places) = (inner, &mut keys.keys);
        }
        let twin = key_in_si(key);
        let name = twin.as_ref().map_or(key, |(name, _)| name);
        places.remove(name);
        table.remove(name).is_some()
    }

    /// Puts a value into a table, as if it stood where another key of it does.
    pub fn put_next_to(&mut self, table: &str, neighbour: &str, key: &str, value: toml::Value) {
        if let Some(toml::Value::Table(values)) = self.table.get_mut(table) {
            values.insert(key.to_owned(), value);
        }
        let Some(places) = self.places.get_mut(table) else {
            return;
        };
        if let Some(place) = places.keys.get(neighbour) {
            let place = KeyPlaces {
                written: Some(neighbour.to_owned()),
                ..place.clone()
            };
            places.keys.insert(key.to_owned(), place);
        }
    }

    /// Lays the table of a file over this one: tables key by key, anything else as a
    /// whole, and a `[design]` as a whole too.
    ///
    /// # Errors
    /// Where two keys say the same in two units.
    pub fn lay_over(
        &mut self,
        over: &DeTable,
        file: usize,
        lines: &LineNumbers,
    ) -> Result<(), Twice> {
        if over.contains_key("design") {
            self.remove("design");
        }
        Layer { file, lines }.lay(self, over)?;
        self.remove("base");
        self.remove("without");
        Ok(())
    }
}

/// A key that conflicts with another of the same quantity.
#[derive(Debug)]
pub struct Twice {
    /// Where it stands.
    pub line: usize,
    /// The key.
    pub key: String,
    /// The other.
    pub other: String,
}

impl KeyPlaces {
    /// The next table on a path, with what is written before its name, that name, and the rest of
    /// the path.
    fn child<'a>(&self, path: &'a str) -> Option<(&KeyPlaces, &'a str, &'a str, &'a str)> {
        if path.starts_with('[') {
            let (index, rest) = path.split_at(path.find(']')? + 1);
            let item = self
                .items
                .get(index[1..index.len() - 1].parse::<usize>().ok()?)?;
            return Some((item, "", index, rest));
        }
        let (found, key, rest) = key_of(&self.keys, path.strip_prefix('.')?)?;
        Some((found, ".", key, rest))
    }
}

/// What a path begins with, its name, and the rest of the path. A key may have a dot in it.
fn key_of<'p, 'a>(keys: &'p Keys, path: &'a str) -> Option<(&'p KeyPlaces, &'a str, &'a str)> {
    let ends = path.match_indices(['.', '[']).map(|(end, _)| end);
    ends.chain([path.len()])
        .find_map(|end| Some((keys.get(&path[..end])?, &path[..end], &path[end..])))
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

    fn lay(&self, under: &mut Placed, over: &DeTable) -> Result<(), Twice> {
        let mut seen: BTreeMap<String, &str> = BTreeMap::new();
        for (key, value) in over {
            let written = key.get_ref().as_ref();
            let twin = key_in_si(written);
            let name = twin.as_ref().map_or(written, |(name, _)| name);
            let place = self.place(key.span().start);
            if let Some(other) = seen.insert(name.to_owned(), written) {
                return Err(Twice {
                    line: place.line,
                    key: written.to_owned(),
                    other: other.to_owned(),
                });
            }
            let below = under.table.remove(name).zip(under.places.remove(name));
            let below = match below {
                Some((toml::Value::Table(table), places)) => Placed {
                    table,
                    places: places.keys,
                },
                _ => Placed::default(),
            };
            let (mut value, mut places) = self.value(value, below)?;
            places.own = place;
            if let Some((_, factors)) = &twin {
                scale(&mut value, factors);
                places.written = Some(written.to_owned());
            }
            under.table.insert(name.to_owned(), value);
            under.places.insert(name.to_owned(), places);
        }
        Ok(())
    }

    fn value(
        &self,
        value: &Spanned<DeValue>,
        mut below: Placed,
    ) -> Result<(toml::Value, KeyPlaces), Twice> {
        let mut places = KeyPlaces {
            own: self.place(value.span().start),
            written: None,
            keys: Keys::default(),
            items: Vec::new(),
        };
        let value = match value.get_ref() {
            DeValue::Table(table) => {
                self.lay(&mut below, table)?;
                places.keys = below.places;
                toml::Value::Table(below.table)
            }
            DeValue::Array(items) => {
                let items = items.iter().map(|item| {
                    let (item, place) = self.value(item, Placed::default())?;
                    places.items.push(place);
                    Ok(item)
                });
                toml::Value::Array(items.collect::<Result<_, _>>()?)
            }
            scalar => plain(scalar),
        };
        Ok((value, places))
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
