//! What pictures of the command look like: symbols with their colours and meanings, the colours of
//! methods, words and units of columns. `drillstring._plot` draws by them.

use campaign::quantities::Units;
use campaign::words::site_title;
use plot::{Symbol, method_style};
use pyo3::prelude::*;
use results::folder::{FoundByMethods, column_words};
use sim::{Label, Motion};

use crate::errors::refused;

/// What units are called.
pub const UNITS: [(&str, Units); 2] = [("si", Units::Si), ("field", Units::Field)];

/// Symbols, each by name with its colour and its meaning of a motion, in the order of a legend.
#[pyfunction]
pub fn _symbols(
    motion: &str,
    methods: usize,
    certified: bool,
) -> PyResult<Vec<(&'static str, String, String)>> {
    let by_all = if methods == 1 { "" } else { " by all methods" };
    let meanings = {
        let motion = motion_of(motion)?;
        Symbol::meanings((motion.regimes(), motion.lesser_regime()), by_all)
    };
    let meanings = if certified {
        Symbol::by_certainty(meanings)
    } else {
        meanings
    };
    let symbols = meanings.into_iter();
    Ok(symbols
        .map(|(symbol, meaning)| (name_of(symbol), symbol.colour().to_string(), meaning))
        .collect())
}

/// The first row of each case, and the symbol of what its methods find of a motion; none where one
/// has no answer. Rows of a case follow one another.
#[pyfunction]
pub fn _symbols_of_cases(
    motion: &str,
    cases: Vec<usize>,
    labels: Vec<Option<String>>,
    certified: Option<Vec<Option<bool>>>,
) -> PyResult<Vec<(usize, Option<&'static str>)>> {
    let motion = motion_of(motion)?;
    if labels.len() != cases.len() || certified.as_ref().is_some_and(|it| it.len() != cases.len()) {
        return Err(refused("columns of one table have as many rows"));
    }
    let known = Label::all(motion);
    let labels = labels.iter().map(|word| label_of(&known, word.as_deref()));
    let labels: Vec<Option<Label>> = labels.collect::<PyResult<_>>()?;
    let mut first = 0;
    let chunks = cases.chunk_by(|one, next| one == next).map(|case| {
        let rows = first..first + case.len();
        first = rows.end;
        let is_certain = certified
            .as_ref()
            .is_some_and(|it| it[rows.clone()].contains(&Some(true)));
        let found = FoundByMethods::of(labels[rows.clone()].iter().copied());
        let symbol =
            found.map(|it| Symbol::of_methods([it.sustained, it.bistable, it.snaking], it.methods));
        let drawn = symbol.map(|it| if is_certain { it.filled() } else { it });
        (rows.start, drawn.map(name_of))
    });
    Ok(chunks.collect())
}

/// The title of a motion.
#[pyfunction]
pub fn _motion_title(motion: &str) -> PyResult<&'static str> {
    motion_of(motion).map(Motion::title)
}

/// The colour of a method, where it has one.
#[pyfunction]
pub fn _method_colour(method: &str) -> Option<String> {
    method_style(method).colour().map(|it| it.to_string())
}

/// Words of a column, the unit in which its numbers are shown, and one of the column's in it.
#[pyfunction]
pub fn _column_words(name: &str, units: &str) -> PyResult<(String, String, f64)> {
    let (words, unit) = column_words(name, units_of(units)?);
    let factor = unit.number(1.0);
    Ok((words, unit.name, factor))
}

/// How a site is called, by its distance from the bit in m.
#[pyfunction]
pub fn _site_title(distance: f64, units: &str) -> PyResult<String> {
    Ok(site_title(distance, units_of(units)?))
}

fn motion_of(name: &str) -> PyResult<Motion> {
    let motion = Motion::ALL.into_iter().find(|it| it.name() == name);
    let known = || Motion::ALL.map(Motion::name).join(" or ");
    motion.ok_or_else(|| refused(format_args!("motion {name:?}: not {}", known())))
}

fn units_of(name: &str) -> PyResult<Units> {
    let units = UNITS.into_iter().find(|(known, _)| *known == name);
    let known = UNITS.map(|(known, _)| known).join(" or ");
    let units = units.ok_or_else(|| refused(format_args!("units {name:?}: not {known}")));
    units.map(|(_, units)| units)
}

fn label_of(known: &[Label], word: Option<&str>) -> PyResult<Option<Label>> {
    let label = |word: &str| {
        let label = known.iter().copied().find(|label| label.name() == word);
        label.ok_or_else(|| refused(format_args!("{word:?} is no regime of this motion")))
    };
    word.map(label).transpose()
}

fn name_of(symbol: Symbol) -> &'static str {
    match symbol {
        Symbol::Circle => "circle",
        Symbol::Cross => "cross",
        Symbol::Square => "square",
        Symbol::Disc => "disc",
        Symbol::HeavyCross => "heavy_cross",
        Symbol::Diamond => "diamond",
        Symbol::FilledDiamond => "filled_diamond",
        Symbol::Triangle => "triangle",
    }
}
