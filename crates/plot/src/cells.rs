//! Charts of cells: what was predicted as the fill, what was seen as a symbol,
//! the number that predicted it next to it. Panels stand in two columns.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::{BLACK, BLUE, Colour, PALE, SAND, SKY, VERMILION};
use super::geometry::{Pixel, Rect};
use super::lettering::Align;
use super::look::Look;
use super::picture::Picture;
use super::shapes::Stroke;
use super::symbols::draw_cross;
use super::text::{self, Block, SMALL_SIZE};

const WIDTH: f64 = 860.0;
const MARGIN: f64 = 16.0;
const CELL_HEIGHT: f64 = 24.0;
/// Columns are no wider, however few there are.
const WIDEST_CELL: f64 = 80.0;
/// Distance between a panel's parts, and between panels.
const GAP: f64 = 6.0;
const PANEL_GAP: f64 = 20.0;
/// Size of the numbers in cells and of the labels next to them.
const CELL_TEXT: f64 = 11.0;
const LABEL_TEXT: f64 = 12.5;
const RADIUS: f64 = 4.0;
/// The frame of a cell that is not as predicted.
const WRONG: Stroke = Stroke::solid(BLACK, 2.0);

/// What was seen of a cell.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Seen {
    /// Nothing wrong: a ring.
    Sound,
    /// A failure that only what is made for it brings out: a disc.
    Provoked,
    /// A failure: a cross.
    Failed,
}

/// One cell.
pub struct ChartCell {
    /// Its column, from the left, from 0.
    pub column: usize,
    /// Its row, from the top, from 0.
    pub row: usize,
    /// Whether it was predicted to be stable, its fill; none where nothing was predicted.
    pub predicted_stable: Option<bool>,
    /// What was seen: its symbol.
    pub seen: Seen,
    /// A number of a few characters.
    pub text: String,
}

/// A table of cells.
pub struct CellPanel {
    /// Title above it.
    pub title: String,
    /// What its columns are, with the unit.
    pub x: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Names of the rows, with the unit where they are numbers.
    pub rows: Vec<String>,
    /// Its cells.
    pub cells: Vec<ChartCell>,
}

/// What a chart shows, in words.
pub struct CellWords {
    /// Fills of cells that were predicted to be stable, to be unstable, and neither.
    pub predicted: [&'static str; 3],
    /// A ring, a disc and a cross.
    pub seen: [&'static str; 3],
    /// The frame of a cell that is not as predicted.
    pub framed: &'static str,
    /// The numbers.
    pub number: &'static str,
}

/// Draws panels with one title and one legend.
/// They stand one below another, readable in a page of the guide.
pub fn cell_chart(title: &str, words: &CellWords, panels: &[CellPanel]) -> Picture {
    let title = Title::new(&Look::default(), title, WIDTH, MARGIN);
    let (tops, bottom) = tops(panels, title.bottom());
    let height = bottom + LEGEND_HEIGHT + MARGIN;
    draw_titled(&title, height, |canvas| {
        for (panel, top) in panels.iter().zip(&tops) {
            draw_panel(canvas, panel, MARGIN, *top, WIDTH - 2.0 * MARGIN);
        }
        draw_legend(canvas, words, bottom)
    })
}

/// The top of each panel, and the bottom of all.
fn tops(panels: &[CellPanel], top: f64) -> (Vec<f64>, f64) {
    let mut bottom = top;
    let tops = panels.iter().map(|panel| {
        let top = bottom;
        bottom += panel_height(panel) + PANEL_GAP;
        top
    });
    (tops.collect(), bottom)
}

fn line(size: f64) -> f64 {
    1.4 * size
}

fn panel_height(panel: &CellPanel) -> f64 {
    let labels = 2.0 * line(LABEL_TEXT) + GAP;
    line(SMALL_SIZE) + GAP + panel.rows.len() as f64 * CELL_HEIGHT + labels
}

fn draw_panel(canvas: &mut Canvas, panel: &CellPanel, left: f64, top: f64, width: f64) {
    let grid_left = left + text::widest(&panel.rows, LABEL_TEXT) + GAP;
    let count = panel.columns.len().max(1) as f64;
    let cell_width = ((left + width - grid_left) / count).min(WIDEST_CELL);
    let grid_top = top + line(SMALL_SIZE) + GAP;
    let title_row = top + 0.5 * line(SMALL_SIZE);
    let title = (panel.title.as_str(), SMALL_SIZE);
    write(canvas, title, (grid_left, title_row), Align::Left);
    for (row, name) in panel.rows.iter().enumerate() {
        let middle = grid_top + (row as f64 + 0.5) * CELL_HEIGHT;
        let place = (grid_left - GAP, middle);
        write(canvas, (name, LABEL_TEXT), place, Align::Right);
    }
    for cell in &panel.cells {
        let rect = Rect {
            left: grid_left + cell.column as f64 * cell_width,
            top: grid_top + cell.row as f64 * CELL_HEIGHT,
            right: grid_left + (cell.column + 1) as f64 * cell_width,
            bottom: grid_top + (cell.row + 1) as f64 * CELL_HEIGHT,
        };
        draw_cell(canvas, cell, rect);
    }
    let below = grid_top + panel.rows.len() as f64 * CELL_HEIGHT + GAP;
    for (column, name) in panel.columns.iter().enumerate() {
        let middle = grid_left + (column as f64 + 0.5) * cell_width;
        let place = (middle, below + 0.5 * line(LABEL_TEXT));
        write(canvas, (name, LABEL_TEXT), place, Align::Centre);
    }
    let centre = grid_left + 0.5 * count * cell_width;
    let place = (centre, below + 1.5 * line(LABEL_TEXT));
    write(canvas, (&panel.x, LABEL_TEXT), place, Align::Centre);
}

/// Writes words of a size on one line, and returns their width.
fn write(canvas: &mut Canvas, (words, size): (&str, f64), (x, y): Pixel, align: Align) -> f64 {
    let block = Block::new(words, size, f64::INFINITY);
    canvas.text(&block, x, y, align);
    block.width
}

fn draw_cell(canvas: &mut Canvas, cell: &ChartCell, rect: Rect) {
    let fill = match cell.predicted_stable {
        Some(true) => SKY,
        Some(false) => SAND,
        None => PALE,
    };
    // White lines between cells.
    let inner = Rect::centred(rect.centre(), rect.width() - 2.0, CELL_HEIGHT - 2.0);
    canvas.polygon(&inner.corners(), fill);
    let middle = rect.centre().1;
    draw_seen(canvas, cell.seen, (inner.left + RADIUS + 3.0, middle));
    let was_wrong = matches!(
        (cell.predicted_stable, cell.seen),
        (Some(true), Seen::Provoked | Seen::Failed) | (Some(false), Seen::Sound)
    );
    if was_wrong {
        canvas.outline(inner, WRONG);
    }
    let place = (inner.right - 3.0, middle);
    write(canvas, (&cell.text, CELL_TEXT), place, Align::Right);
}

fn draw_seen(canvas: &mut Canvas, seen: Seen, centre: Pixel) {
    match seen {
        Seen::Sound => canvas.ring(centre, RADIUS, Stroke::solid(BLUE, 1.5)),
        Seen::Provoked => canvas.disc(centre, RADIUS, VERMILION),
        Seen::Failed => draw_cross(canvas, centre, RADIUS, Stroke::solid(VERMILION, 2.0)),
    }
}

/// Two rows of keys.
const LEGEND_HEIGHT: f64 = 3.0 * LEGEND_ROW;
const LEGEND_ROW: f64 = 26.0;
const KEY_WIDTH: f64 = 26.0;
const KEY_GAP: f64 = 28.0;

/// What stands before the words of a key.
enum Key {
    CellFill(Colour),
    Seen(Seen),
    Frame,
    Nothing,
}

fn draw_legend(canvas: &mut Canvas, words: &CellWords, top: f64) {
    let [stable, unstable, unknown] = words.predicted;
    let [sound, provoked, failed] = words.seen;
    let fills = vec![
        (Key::CellFill(SKY), stable),
        (Key::CellFill(SAND), unstable),
        (Key::CellFill(PALE), unknown),
    ];
    let symbols = vec![
        (Key::Seen(Seen::Sound), sound),
        (Key::Seen(Seen::Failed), failed),
        (Key::Frame, words.framed),
    ];
    let others = vec![
        (Key::Seen(Seen::Provoked), provoked),
        (Key::Nothing, words.number),
    ];
    for (index, keys) in [fills, symbols, others].into_iter().enumerate() {
        let row = top + (index as f64 + 0.5) * LEGEND_ROW;
        let mut left = MARGIN;
        for (key, words) in keys {
            let centre = (left + 0.5 * KEY_WIDTH, row);
            let area = Rect::centred(centre, KEY_WIDTH, 16.0);
            match key {
                Key::CellFill(fill) => canvas.polygon(&area.corners(), fill),
                Key::Seen(seen) => draw_seen(canvas, seen, centre),
                Key::Frame => canvas.outline(area, WRONG),
                Key::Nothing => {}
            }
            if !matches!(key, Key::Nothing) {
                left += KEY_WIDTH + GAP;
            }
            left += write(canvas, (words, SMALL_SIZE), (left, row), Align::Left) + KEY_GAP;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    const WORDS: CellWords = CellWords {
        predicted: ["stable", "unstable", "not known"],
        seen: ["nothing wrong", "fails if provoked", "fails"],
        framed: "not as predicted",
        number: "number: the margin",
    };

    fn panels(predicted_stable: Option<bool>, seen: Seen) -> [CellPanel; 3] {
        [(); 3].map(|()| CellPanel {
            title: "Newmark in sticking".to_owned(),
            x: "γ".to_owned(),
            columns: (50..60).map(|n| format!("0.{n}")).collect(),
            rows: vec!["160 Hz".to_owned(), "2560 Hz".to_owned()],
            cells: vec![ChartCell {
                column: 9,
                row: 1,
                predicted_stable,
                seen,
                text: "−0.055".to_owned(),
            }],
        })
    }

    #[test]
    fn every_label_lies_inside_and_only_wrong_cells_are_framed() {
        let lines = |predicted, seen| {
            let panels = panels(predicted, seen);
            let picture = cell_chart("The atlas", &WORDS, &panels);
            assert_text_inside(&picture);
            picture.svg().matches("<polyline").count()
        };
        let right = lines(Some(true), Seen::Sound);
        assert_eq!(lines(Some(false), Seen::Sound), right + 3);
        assert_eq!(lines(Some(true), Seen::Provoked), right + 3);
        assert_eq!(lines(None, Seen::Provoked), right);
    }

    #[test]
    fn panels_stand_one_below_another() {
        let (tops, bottom) = tops(&panels(None, Seen::Sound), 0.0);
        assert!(tops[0] == 0.0 && tops.is_sorted() && tops[2] < bottom);
        assert!(cell_chart("", &WORDS, &[]).svg().contains("nothing wrong"));
    }
}
