//! The motions of a string that a label is given to, and values by motion.
//!
//! A scene with a bit has a label of torsion, one with a wall a lateral label, one with a bit that
//! cuts an axial one.

use std::fmt;
use std::ops::{Index, IndexMut};

use serde::de::{IgnoredAny, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::words::with_words;

with_words! {
    /// What a label is about. Result files name its column by this word.
    #[derive(PartialOrd, Ord)]
    pub enum Motion {
        /// How the bit turns.
        Torsion = "torsion",
        /// How the string moves sideways.
        Lateral = "lateral",
        /// How the bit moves along its axis.
        Axial = "axial",
    }
}

impl Motion {
    /// As a heading.
    pub fn title(self) -> &'static str {
        match self {
            Motion::Torsion => "Torsion",
            Motion::Lateral => "Lateral motion",
            Motion::Axial => "Axial motion",
        }
    }

    /// As an adjective.
    pub fn adjective(self) -> &'static str {
        match self {
            Motion::Torsion => "torsional",
            Motion::Lateral => "lateral",
            Motion::Axial => "axial",
        }
    }

    /// Sustained vibration, and its absence, as a person reads them.
    pub fn regimes(self) -> [&'static str; 2] {
        match self {
            Motion::Torsion => ["stick-slip", "smooth"],
            Motion::Lateral => ["sustained whirl", "no sustained whirl"],
            Motion::Axial => ["axial vibration", "steady"],
        }
    }

    /// A regime between these, as a person reads it.
    pub fn lesser_regime(self) -> Option<&'static str> {
        match self {
            Motion::Lateral => Some("snaking on its low side"),
            Motion::Torsion | Motion::Axial => None,
        }
    }
}

/// A value for each motion, `values[motion]`. Of optional values, files hold those that are
/// there, by the word of their motion.
///
/// ```
/// use sim::{Motion, PerMotion};
///
/// let cases = PerMotion::from_fn(|motion| match motion {
///     Motion::Torsion => 120,
///     Motion::Lateral => 80,
///     Motion::Axial => 0,
/// });
/// assert_eq!((cases[Motion::Torsion], cases[Motion::Lateral]), (120, 80));
/// assert_eq!(cases.iter().map(|(_, cases)| cases).sum::<i32>(), 200);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PerMotion<T>([T; Motion::ALL.len()]);

impl<T> PerMotion<T> {
    /// By a function of the motion.
    pub fn from_fn(of: impl FnMut(Motion) -> T) -> Self {
        Self(Motion::ALL.map(of))
    }

    /// Each with its motion, in the order of [`Motion::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Motion, &T)> {
        Motion::ALL.into_iter().zip(&self.0)
    }
}

impl<T> PerMotion<Option<T>> {
    /// Of the one motion that has a value.
    pub fn only(motion: Motion, value: T) -> Self {
        let mut value = Some(value);
        Self::from_fn(|of| value.take_if(|_| of == motion))
    }
}

impl<T> Index<Motion> for PerMotion<T> {
    type Output = T;

    fn index(&self, motion: Motion) -> &T {
        &self.0[motion as usize]
    }
}

impl<T> IndexMut<Motion> for PerMotion<T> {
    fn index_mut(&mut self, motion: Motion) -> &mut T {
        &mut self.0[motion as usize]
    }
}

impl<T: Serialize> Serialize for PerMotion<Option<T>> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (motion, value) in self.iter() {
            if let Some(value) = value {
                map.serialize_entry(motion.name(), value)?;
            }
        }
        map.end()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for PerMotion<Option<T>> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ByMotion(Self::from_fn(|_| None)))
    }
}

/// What was read of a map so far. Other keys of it belong to what the map is part of.
struct ByMotion<T>(PerMotion<Option<T>>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for ByMotion<T> {
    type Value = PerMotion<Option<T>>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("values by motion")
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<Self::Value, A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            match Motion::of_name(&key) {
                Some(motion) => self.0[motion] = map.next_value()?,
                None => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        Ok(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_hold_the_values_that_are_there_by_the_word_of_their_motion() {
        let values = PerMotion::only(Motion::Lateral, 2.5);
        let text = serde_json::to_string(&values).unwrap();
        assert_eq!(text, r#"{"lateral":2.5}"#);
        let more = r#"{"other":{"torsion":1},"lateral":2.5,"torsion":null}"#;
        for text in [&text, more] {
            let read: PerMotion<Option<f64>> = serde_json::from_str(text).unwrap();
            assert_eq!(read, values);
        }
        assert!(serde_json::from_str::<PerMotion<Option<f64>>>(r#"{"lateral":"x"}"#).is_err());
    }

    #[test]
    fn each_motion_has_its_own_value() {
        let mut values = PerMotion::from_fn(Motion::title);
        assert_eq!(values[Motion::Lateral], "Lateral motion");
        values[Motion::Lateral] = "sideways";
        let all: Vec<_> = values
            .iter()
            .map(|(motion, value)| (motion, *value))
            .collect();
        assert_eq!(
            all,
            [
                (Motion::Torsion, "Torsion"),
                (Motion::Lateral, "sideways"),
                (Motion::Axial, "Axial motion")
            ]
        );
    }
}
