//! The legend beside a plot.

use super::canvas::{Canvas, Stroke};
use super::geometry::Rect;
use super::grounds::{Ground, draw_ground};
use super::hatching::draw_hatching;
use super::symbols::{Symbol, draw_marker, draw_rim, draw_symbol};
use super::text::{Block, SMALL_SIZE};
use anyhow::Result;
use plotters::style::BLACK;
use plotters::style::text_anchor::HPos;

/// Width of the line or symbol before an entry's text.
const KEY_WIDTH: f64 = 42.0;
const KEY_GAP: f64 = 8.0;
const SYMBOL_RADIUS: f64 = 5.0;
const CELL_HEIGHT: f64 = 17.0;
/// Text wider than this is broken.
const TEXT_WIDTH: f64 = 170.0;
/// Free space after each entry.
const ENTRY_GAP: f64 = 6.0;

/// What stands before an entry's text.
pub(super) enum Key {
    Symbol(Symbol),
    /// A ground, with the symbol it stands for where it has one.
    Cell(Ground),
    /// A hatched range.
    Hatching,
    /// A text alone.
    Nothing,
    Line(Stroke),
    /// The marker of the kind with this index.
    Marker(usize),
    /// The rim around what is pointed out.
    Rim,
}

/// Keys and their texts, top to bottom.
pub(super) struct Legend {
    entries: Vec<(Key, Block)>,
}

impl Legend {
    /// A legend of the given keys and texts.
    pub fn new<'a>(entries: impl Iterator<Item = (Key, &'a str)>) -> Result<Legend> {
        let entries = entries
            .map(|(key, text)| {
                let width = TEXT_WIDTH + KEY_WIDTH + KEY_GAP - indent(&key);
                Ok((key, Block::new(text, SMALL_SIZE, width)?))
            })
            .collect::<Result<_>>()?;
        Ok(Legend { entries })
    }

    /// Width in pixels; zero for an empty legend.
    pub fn width(&self) -> f64 {
        let entries = self.entries.iter();
        let widths = entries.map(|(key, text)| indent(key) + text.width);
        widths.fold(0.0, f64::max)
    }

    /// Height in pixels.
    pub fn height(&self) -> f64 {
        self.entries
            .iter()
            .map(|(_, text)| entry_height(text))
            .sum()
    }

    /// Draws the legend with its upper left corner at the given place.
    pub fn draw(&self, canvas: &mut Canvas, left: f64, top: f64) -> Result<()> {
        let mut top = top;
        for (key, text) in &self.entries {
            let middle = top + text.line_height() / 2.0;
            draw_key(canvas, key, left, middle)?;
            canvas.text(text, left + indent(key), middle, HPos::Left)?;
            top += entry_height(text);
        }
        Ok(())
    }
}

impl Legend {
    /// Entries beside each other, in columns as wide as the legend is.
    fn columns(&self, width: f64) -> usize {
        let column = self.width() + 2.0 * KEY_GAP;
        ((width / column) as usize).clamp(1, self.entries.len().max(1))
    }

    /// Height in pixels where entries stand beside each other.
    pub fn row_height(&self, width: f64) -> f64 {
        let rows = self.entries.chunks(self.columns(width));
        rows.map(tallest).sum()
    }

    /// Draws the entries beside each other, in as many rows as they need.
    pub fn draw_row(&self, canvas: &mut Canvas, left: f64, top: f64, width: f64) -> Result<()> {
        let columns = self.columns(width);
        let mut top = top;
        for row in self.entries.chunks(columns) {
            for (column, (key, text)) in row.iter().enumerate() {
                let left = left + column as f64 * width / columns as f64;
                let middle = top + text.line_height() / 2.0;
                draw_key(canvas, key, left, middle)?;
                canvas.text(text, left + indent(key), middle, HPos::Left)?;
            }
            top += tallest(row);
        }
        Ok(())
    }
}

/// Where an entry's text begins.
fn indent(key: &Key) -> f64 {
    match key {
        Key::Nothing => 0.0,
        _ => KEY_WIDTH + KEY_GAP,
    }
}

fn tallest(row: &[(Key, Block)]) -> f64 {
    let heights = row.iter().map(|(_, text)| entry_height(text));
    heights.fold(0.0, f64::max)
}

/// An entry is one line high even if its text is empty.
fn entry_height(text: &Block) -> f64 {
    text.height().max(text.line_height()) + ENTRY_GAP
}

fn draw_key(canvas: &mut Canvas, key: &Key, left: f64, y: f64) -> Result<()> {
    match key {
        Key::Symbol(symbol) => {
            draw_symbol(canvas, *symbol, (left + KEY_WIDTH / 2.0, y), SYMBOL_RADIUS)
        }
        Key::Cell(ground) => {
            let area = cell(left, y);
            draw_ground(canvas, *ground, area)?;
            match ground {
                Ground::Symbol(symbol) => {
                    draw_symbol(canvas, *symbol, area.centre(), SYMBOL_RADIUS)
                }
                Ground::Part(_) | Ground::NoCase => draw_border(canvas, area),
            }
        }
        Key::Hatching => draw_hatching(canvas, cell(left, y), cell(left, y)),
        Key::Nothing => Ok(()),
        Key::Line(stroke) => canvas.line(&[(left, y), (left + KEY_WIDTH, y)], *stroke),
        Key::Marker(kind) => draw_marker(canvas, *kind, (left + KEY_WIDTH / 2.0, y), SYMBOL_RADIUS),
        Key::Rim => draw_rim(canvas, (left + KEY_WIDTH / 2.0, y), 1.5 * SYMBOL_RADIUS),
    }
}

/// Where a ground is shown.
fn cell(left: f64, y: f64) -> Rect {
    Rect::centred((left + KEY_WIDTH / 2.0, y), 2.0 * CELL_HEIGHT, CELL_HEIGHT)
}

/// A thin line around a ground that may be as light as the paper.
fn draw_border(canvas: &mut Canvas, area: Rect) -> Result<()> {
    let [first, second, third, fourth] = area.corners();
    let closed = [first, second, third, fourth, first];
    canvas.line(&closed, Stroke::solid(BLACK, 0.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn legend(texts: &[&'static str]) -> Legend {
        let keys = texts
            .iter()
            .map(|&text| (Key::Symbol(Symbol::Circle), text));
        Legend::new(keys).expect("measured")
    }

    #[test]
    fn long_texts_add_lines_instead_of_width() {
        let long = legend(&["every one of the three methods finds stick-slip here"]);
        assert!(long.width() <= KEY_WIDTH + KEY_GAP + TEXT_WIDTH);
        assert!(long.height() > legend(&["all"]).height());
    }

    #[test]
    fn an_empty_legend_takes_no_room() {
        assert_eq!((legend(&[]).width(), legend(&[]).height()), (0.0, 0.0));
    }
}
