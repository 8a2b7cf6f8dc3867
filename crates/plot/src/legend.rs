//! The legend next to a plot.

use super::canvas::Canvas;
use super::colours::{BLACK, Colour};
use super::fills::{CellFill, draw_fill};
use super::geometry::Rect;
use super::hatching::draw_hatching;
use super::lettering::Align;
use super::shapes::Stroke;
use super::symbols::{Marker, Symbol, draw_dot, draw_marker, draw_rim, draw_symbol};
use super::text::{Block, SMALL_SIZE};

/// Width of the line or symbol before an entry's text.
const KEY_WIDTH: f64 = 42.0;
const KEY_GAP: f64 = 8.0;
const SYMBOL_RADIUS: f64 = 5.0;
const CELL_HEIGHT: f64 = 17.0;
/// Text wider than this is broken, in a legend at the side.
const TEXT_WIDTH: f64 = 170.0;
/// The least room for text in one of several columns.
const LEAST_TEXT_WIDTH: f64 = 100.0;
/// Free space after each entry.
const ENTRY_GAP: f64 = 6.0;

/// What stands before an entry's text.
#[derive(Clone, Copy)]
pub(crate) enum Key {
    Symbol(Symbol),
    /// A fill, with the symbol it stands for where it has one.
    Cell(CellFill),
    /// A hatched range.
    Hatching,
    /// A text alone.
    Nothing,
    Line(Stroke),
    /// The marker of a kind of points.
    Marker(Marker),
    /// The rim around what is pointed out.
    Rim,
    /// A bar of a colour, which fills this part of the height of its band.
    Bar(Colour, f64),
    /// A dot, filled or open.
    Dot(bool),
}

/// Keys and their texts, in rows.
pub(crate) struct Legend {
    entries: Vec<(Key, Block)>,
    columns: usize,
    /// Width of all columns; the one column of a legend at the side needs none.
    room: f64,
}

impl Legend {
    /// A legend of the given keys and texts, top to bottom.
    pub fn new<'a>(entries: impl IntoIterator<Item = (Key, &'a str)>) -> Legend {
        let entries = entries
            .into_iter()
            .map(|(key, text)| {
                let width = TEXT_WIDTH + KEY_WIDTH + KEY_GAP - indent(&key);
                (key, Block::new(text, SMALL_SIZE, width))
            })
            .collect();
        Legend {
            entries,
            columns: 1,
            room: 0.0,
        }
    }

    /// The same in as many columns of a width as make it lowest, its texts broken for them.
    pub fn in_rows(self, room: f64) -> Legend {
        let least = KEY_WIDTH + LEAST_TEXT_WIDTH + 3.0 * KEY_GAP;
        let most = ((room / least) as usize).clamp(1, self.entries.len().max(1));
        let mut lowest = self.in_columns(1, room);
        for columns in 2..=most {
            let legend = self.in_columns(columns, room);
            if legend.height() < lowest.height() {
                lowest = legend;
            }
        }
        lowest
    }

    fn in_columns(&self, columns: usize, room: f64) -> Legend {
        let column = room / columns as f64 - 2.0 * KEY_GAP;
        let entries = (self.entries.iter())
            .map(|(key, text)| (*key, text.broken_at(column - indent(key))))
            .collect();
        Legend {
            entries,
            columns,
            room,
        }
    }

    /// Width of the widest entry in pixels; zero for an empty legend.
    pub fn width(&self) -> f64 {
        let entries = self.entries.iter();
        let widths = entries.map(|(key, text)| indent(key) + text.width);
        widths.fold(0.0, f64::max)
    }

    /// Height in pixels.
    pub fn height(&self) -> f64 {
        self.entries.chunks(self.columns).map(tallest).sum()
    }

    /// Draws the legend with its upper left corner at the given place.
    pub fn draw(&self, canvas: &mut Canvas, left: f64, top: f64) {
        let mut top = top;
        for row in self.entries.chunks(self.columns) {
            for (column, (key, text)) in row.iter().enumerate() {
                let left = left + column as f64 * self.room / self.columns as f64;
                let middle = top + text.line_height() / 2.0;
                draw_key(canvas, key, left, middle);
                canvas.text(text, left + indent(key), middle, Align::Left);
            }
            top += tallest(row);
        }
    }
}

/// Distinct names, in order of appearance: what has the same name looks the same.
pub(crate) fn distinct<'a>(names: impl Iterator<Item = &'a String>) -> Vec<&'a str> {
    let mut found: Vec<&str> = Vec::new();
    for name in names {
        if !found.contains(&name.as_str()) {
            found.push(name);
        }
    }
    found
}

/// Where an entry's text begins.
fn indent(key: &Key) -> f64 {
    match key {
        Key::Nothing => 0.0,
        _ => KEY_WIDTH + KEY_GAP,
    }
}

/// Height of a row. An entry is one line high even if its text is empty.
fn tallest(row: &[(Key, Block)]) -> f64 {
    let heights = row
        .iter()
        .map(|(_, text)| text.height().max(text.line_height()));
    heights.fold(0.0, f64::max) + ENTRY_GAP
}

fn draw_key(canvas: &mut Canvas, key: &Key, left: f64, y: f64) {
    let centre = (left + KEY_WIDTH / 2.0, y);
    let cell = Rect::centred(centre, 2.0 * CELL_HEIGHT, CELL_HEIGHT);
    match key {
        Key::Symbol(symbol) => draw_symbol(canvas, *symbol, centre, SYMBOL_RADIUS),
        Key::Cell(fill) => {
            draw_fill(canvas, *fill, cell);
            match fill {
                CellFill::Symbol(symbol) => {
                    draw_symbol(canvas, *symbol, cell.centre(), SYMBOL_RADIUS)
                }
                // A fill may be as light as the paper.
                CellFill::Fraction(_) | CellFill::Safety(_) | CellFill::NoCase => {
                    canvas.outline(cell, Stroke::solid(BLACK, 0.5))
                }
            }
        }
        Key::Hatching => draw_hatching(canvas, cell, cell),
        Key::Nothing => {}
        Key::Line(stroke) => canvas.line(&[(left, y), (left + KEY_WIDTH, y)], *stroke),
        Key::Marker(kind) => draw_marker(canvas, *kind, centre, SYMBOL_RADIUS),
        Key::Rim => draw_rim(canvas, centre, 1.5 * SYMBOL_RADIUS),
        Key::Bar(colour, part) => {
            let top = cell.bottom - part * cell.height();
            canvas.polygon(&Rect { top, ..cell }.corners(), *colour);
            canvas.outline(cell, Stroke::solid(BLACK, 0.5))
        }
        Key::Dot(filled) => draw_dot(canvas, *filled, centre, SYMBOL_RADIUS),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn legend(texts: &[&'static str]) -> Legend {
        let key = |&text| (Key::Symbol(Symbol::Circle), text);
        Legend::new(texts.iter().map(key))
    }

    #[test]
    fn long_texts_add_lines_instead_of_width() {
        let long = legend(&["every one of the three methods finds stick-slip here"]);
        assert!(long.width() <= KEY_WIDTH + KEY_GAP + TEXT_WIDTH);
        assert!(long.height() > legend(&["all"]).height());
    }

    #[test]
    fn texts_in_rows_are_broken_for_the_room_there_is() {
        let texts = [
            "every one of the three methods finds stick-slip here",
            "all",
        ];
        let wide = legend(&texts).in_rows(1300.0);
        let narrow = legend(&texts).in_rows(200.0);
        assert_eq!(wide.height(), legend(&["all"]).height());
        assert!(narrow.width() <= 200.0 && narrow.height() > wide.height());
    }

    #[test]
    fn an_empty_legend_takes_no_room() {
        assert_eq!((legend(&[]).width(), legend(&[]).height()), (0.0, 0.0));
    }
}
