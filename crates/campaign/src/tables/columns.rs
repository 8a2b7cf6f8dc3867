//! What the columns of a table hold, by their headings.

use super::heading::{Heading, Meaning};
use super::table::Row;
use super::units::Dimension;

/// A quantity that a table may have.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<Q: 'static> {
    /// It.
    pub quantity: Q,
    /// What it is called, in small letters with `_` between words; nothing, where its unit alone
    /// says what it is.
    pub names: &'static [&'static str],
    /// What its unit measures, if it has one.
    pub dimension: Option<Dimension>,
    /// Where a table cannot do without it: what is missing then, in words.
    pub needed: Option<&'static str>,
    /// The unit of numbers under a heading without a unit, as it is reported.
    pub assumed: Option<&'static str>,
}

/// A column that is read.
#[derive(Debug, Clone)]
pub struct Column<Q> {
    /// What it holds.
    pub quantity: Q,
    /// Its place.
    pub place: usize,
    /// Its heading, as the file has it.
    pub name: String,
    /// What its numbers are multiplied by.
    pub factor: f64,
}

/// The columns of a table.
#[derive(Debug, Clone)]
pub struct Columns<Q> {
    known: Vec<Column<Q>>,
    /// Headings of the others.
    pub ignored: Vec<String>,
    /// Headings without a unit, each with that which is taken.
    pub assumed: Vec<(String, &'static str)>,
}

impl<Q: Copy + PartialEq> Columns<Q> {
    /// Finds what is wanted. What is named like a quantity and has a unit that this has not is
    /// refused, where the column `is_numeric`.
    ///
    /// # Errors
    /// Where one that is needed is missing, one is there twice, or has no unit that is known.
    pub fn find(
        headings: &[Heading],
        wanted: &[Wanted<Q>],
        is_numeric: &dyn Fn(usize) -> bool,
    ) -> Result<Self, String> {
        let mut columns = Self {
            known: Vec::new(),
            ignored: Vec::new(),
            assumed: Vec::new(),
        };
        for (place, heading) in headings.iter().enumerate() {
            if heading.is_empty() {
                continue;
            }
            let Some((wanted, factor)) =
                columns.quantity(heading, wanted, &|| is_numeric(place))?
            else {
                columns.ignored.push(heading.text.clone());
                continue;
            };
            // Of words the first are taken: a sheet may have a type, a description and remarks.
            let is_words = wanted.dimension.is_none() && !is_numeric(place);
            if is_words && columns.get(wanted.quantity).is_some() {
                columns.ignored.push(heading.text.clone());
                continue;
            }
            if let Some(other) = columns.get(wanted.quantity) {
                let (other, name) = (&other.name, &heading.text);
                return Err(format!("the columns `{other}` and `{name}` say the same"));
            }
            columns.known.push(Column {
                quantity: wanted.quantity,
                place,
                name: heading.text.clone(),
                factor,
            });
        }
        let missing = wanted.iter().find_map(|wanted| {
            let words = wanted.needed?;
            columns
                .get(wanted.quantity)
                .is_none()
                .then_some((wanted, words))
        });
        let Some((missing, words)) = missing else {
            return Ok(columns);
        };
        // One that is there in a unit that is not known is not missing, though its cells be no numbers.
        let alike = headings
            .iter()
            .find_map(|heading| unit_mistake(heading, std::slice::from_ref(missing)));
        Err(alike.unwrap_or_else(|| format!("there is no column with {words}")))
    }

    /// The quantity of a heading, if it has one, and the factor of its unit.
    fn quantity<'w>(
        &mut self,
        heading: &Heading,
        wanted: &'w [Wanted<Q>],
        is_numeric: &dyn Fn() -> bool,
    ) -> Result<Option<(&'w Wanted<Q>, f64)>, String> {
        let meanings = || {
            (wanted.iter()).map(|wanted| (wanted, heading.meaning(wanted.names, wanted.dimension)))
        };
        for (wanted, meaning) in meanings() {
            if let Meaning::Quantity(factor) = meaning {
                return Ok(Some((wanted, factor)));
            }
        }
        for (wanted, meaning) in meanings() {
            if let (Meaning::NoUnit, Some(unit), Some(dimension)) =
                (meaning, wanted.assumed, wanted.dimension)
            {
                self.assumed.push((heading.text.clone(), unit));
                return Ok(dimension.factor(unit).map(|factor| (wanted, factor)));
            }
        }
        match unit_mistake(heading, wanted).filter(|_| is_numeric()) {
            Some(message) => Err(message),
            None => Ok(None),
        }
    }

    /// Whether headings have all that is needed.
    pub fn are_in(headings: &[Heading], wanted: &[Wanted<Q>]) -> bool {
        let mut needed = wanted.iter().filter(|wanted| wanted.needed.is_some());
        needed.all(|wanted| {
            let means = |heading: &Heading| heading.meaning(wanted.names, wanted.dimension);
            headings
                .iter()
                .any(|heading| means(heading) != Meaning::Other)
        })
    }

    /// The number of a quantity in a row, in the unit of its dimension; begins with the heading where
    /// it is refused.
    ///
    /// # Errors
    /// Where it is not a number, or ambiguous, or there is no such column.
    pub fn number(&self, row: &Row, quantity: Q) -> Result<f64, String> {
        let column = self.get(quantity).ok_or("there is no such column")?;
        let number = row.number(column.place);
        let number = number.map_err(|error| self.named(quantity, &error.to_string()))?;
        Ok(column.factor * number)
    }

    /// A message about a quantity, with its heading.
    pub fn named(&self, quantity: Q, message: &str) -> String {
        match self.get(quantity) {
            Some(column) => format!("{}: {message}", column.name),
            None => message.to_owned(),
        }
    }

    /// The column of a quantity, where there is one.
    pub fn get(&self, quantity: Q) -> Option<&Column<Q>> {
        self.known.iter().find(|column| column.quantity == quantity)
    }
}

/// What is wrong with the unit of a heading that is named like something wanted.
fn unit_mistake<Q>(heading: &Heading, wanted: &[Wanted<Q>]) -> Option<String> {
    let meanings =
        || (wanted.iter()).map(|wanted| (wanted, heading.meaning(wanted.names, wanted.dimension)));
    let units = || {
        let alike = meanings().filter(|(_, meaning)| *meaning != Meaning::Other);
        let units = alike.filter_map(|(wanted, _)| wanted.dimension);
        units
            .map(Dimension::units)
            .collect::<Vec<_>>()
            .join("; or ")
    };
    let name = &heading.text;
    meanings().find_map(|(_, meaning)| match meaning {
        Meaning::OtherUnit(unit) => Some(format!(
            "`{name}`: `{unit}` is not one of the known units: {}",
            units()
        )),
        Meaning::NoUnit => Some(format!("`{name}` names no unit: {}", units())),
        _ => None,
    })
}
