//! Regime maps: symbols over two parameters, with boundary lines and marks.

use super::canvas::{Canvas, DASHES, Stroke, draw_picture};
use super::frame::Frame;
use super::geometry::{Pixel, Rect};
use super::legend::{Key, Legend};
use super::names::Names;
use super::scale::{Scale, visible};
use super::symbols::{HALO, MARK_RADIUS, Symbol, draw_cell, draw_symbol, draw_triangle};
use super::text::{Block, TITLE_SIZE};
use super::{Axis, Picture};
use anyhow::Result;
use plotters::style::BLACK;
use plotters::style::text_anchor::HPos;

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 620.0;
const MARGIN: f64 = 14.0;
/// Distance between the plotting area and the legend.
const LEGEND_GAP: f64 = 22.0;

/// Widths of lines, one for each of [`DASHES`]: where lines coincide, wider
/// dashes and dots still show on top of the thin solid line.
const LINE_WIDTHS: [f64; 6] = [1.2, 2.2, 3.4, 1.8, 2.6, 2.2];

/// A symbol at a place of a map.
pub struct MapPoint {
    /// Place along the horizontal axis.
    pub x: f64,
    /// Place along the vertical axis.
    pub y: f64,
    /// What to draw there.
    pub symbol: Symbol,
}

/// A named line, such as the boundary of a regime.
pub struct Line {
    /// Name in the legend.
    pub name: String,
    /// Its corners; the line has a gap where one is not finite.
    pub points: Vec<(f64, f64)>,
}

/// A named place: a filled triangle with its name beside it.
pub struct Mark {
    /// Name beside the triangle.
    pub name: String,
    /// Place along the horizontal axis.
    pub x: f64,
    /// Place along the vertical axis.
    pub y: f64,
}

/// A map of regimes over two parameters.
pub struct RegimeMap {
    /// Title above the map.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Filled cells.
    pub cells: Vec<MapCell>,
    /// Symbols; those that are not finite are skipped.
    pub points: Vec<MapPoint>,
    /// Legend texts of circle, cross and, where methods can differ, square.
    pub legend: Vec<String>,
    /// Lines, cut off where they leave the range of points and marks.
    pub lines: Vec<Line>,
    /// Marked places.
    pub marks: Vec<Mark>,
}

/// A part of a map with so many cases that they share a colour.
pub struct MapCell {
    /// Its ends along the horizontal axis.
    pub x: [f64; 2],
    /// Its ends along the vertical axis.
    pub y: [f64; 2],
    /// What its cases are.
    pub symbol: Symbol,
}

/// Draws a regime map.
///
/// The axes span the cells, the points and the marks; a map without points spans its
/// lines and marks, an empty one 0 to 1.
pub fn regime_map(map: &RegimeMap) -> Result<Picture> {
    let title = Block::new(&map.title, TITLE_SIZE, WIDTH - 2.0 * MARGIN)?;
    let legend = legend(map)?;
    let top = 2.0 * MARGIN + title.height();
    let height = HEIGHT.max(top + legend.height() + MARGIN);
    let legend_left = WIDTH - MARGIN - legend.width();
    let outer = Rect {
        left: MARGIN,
        top,
        right: legend_left - LEGEND_GAP,
        bottom: height - MARGIN,
    };
    let (x, y) = scales(map);
    let frame = Frame::new(outer, (&map.x, x), (&map.y, y))?;
    draw_picture(WIDTH, height, |canvas| {
        let title_row = MARGIN + title.line_height() / 2.0;
        canvas.text(&title, WIDTH / 2.0, title_row, HPos::Center)?;
        frame.draw(canvas)?;
        draw_cells(canvas, &frame, &map.cells)?;
        draw_points(canvas, &frame, &map.points)?;
        draw_lines(canvas, &frame, &map.lines)?;
        draw_marks(canvas, &frame, map)?;
        legend.draw(canvas, legend_left, top)
    })
}

fn legend(map: &RegimeMap) -> Result<Legend> {
    let symbols = [Symbol::Circle, Symbol::Cross, Symbol::Square]
        .into_iter()
        .zip(&map.legend)
        .map(|(symbol, text)| {
            let key = if map.cells.is_empty() {
                Key::Symbol(symbol)
            } else {
                Key::Cell(symbol)
            };
            (key, text.as_str())
        });
    let lines = map.lines.iter().enumerate();
    let lines = lines.map(|(index, line)| (Key::Line(line_stroke(index)), line.name.as_str()));
    Legend::new(symbols.chain(lines))
}

/// The look of the line with this index.
fn line_stroke(index: usize) -> Stroke {
    let pattern = index % DASHES.len();
    Stroke {
        colour: BLACK,
        width: LINE_WIDTHS[pattern],
        dash: DASHES[pattern],
    }
}

/// The scales that show all points and marks, or lines if there are no points.
fn scales(map: &RegimeMap) -> (Scale, Scale) {
    let mut places: Vec<_> = map.points.iter().map(|p| (p.x, p.y)).collect();
    let corners = |cell: &MapCell| [0, 1].map(|end| (cell.x[end], cell.y[end]));
    places.extend(map.cells.iter().flat_map(corners));
    if places.is_empty() {
        places.extend(map.lines.iter().flat_map(|line| &line.points));
    }
    places.extend(map.marks.iter().map(|mark| (mark.x, mark.y)));
    let places: Vec<_> = visible(&map.x, &map.y, places.into_iter()).collect();
    (
        Scale::new(map.x.logarithmic, places.iter().map(|place| place.0)),
        Scale::new(map.y.logarithmic, places.iter().map(|place| place.1)),
    )
}

/// Ends on whole pixels leave no seam between neighbours.
fn draw_cells(canvas: &mut Canvas, frame: &Frame, cells: &[MapCell]) -> Result<()> {
    for cell in cells {
        let corner = |end: usize| frame.pixel((cell.x[end], cell.y[end]));
        if let (Some((left, bottom)), Some((right, top))) = (corner(0), corner(1)) {
            let area = Rect {
                left: left.round(),
                top: top.round(),
                right: right.round(),
                bottom: bottom.round(),
            };
            draw_cell(canvas, cell.symbol, area)?;
        }
    }
    Ok(())
}

fn draw_points(canvas: &mut Canvas, frame: &Frame, points: &[MapPoint]) -> Result<()> {
    let radius = symbol_radius(frame.area, points.len());
    for point in points {
        if let Some(centre) = frame.pixel((point.x, point.y)) {
            draw_symbol(canvas, point.symbol, centre, radius)?;
        }
    }
    Ok(())
}

/// Symbols as large as their mean distance allows, within legible limits.
fn symbol_radius(area: Rect, count: usize) -> f64 {
    let distance = (area.width() * area.height() / count.max(1) as f64).sqrt();
    (0.28 * distance).clamp(2.0, 5.5)
}

fn draw_lines(canvas: &mut Canvas, frame: &Frame, lines: &[Line]) -> Result<()> {
    for (index, line) in lines.iter().enumerate() {
        for piece in frame.curve(&line.points) {
            for part in frame.area.clip(&piece) {
                canvas.line(&part, line_stroke(index))?;
            }
        }
    }
    Ok(())
}

fn draw_marks(canvas: &mut Canvas, frame: &Frame, map: &RegimeMap) -> Result<()> {
    let marks = map.marks.iter();
    let places: Vec<_> = marks
        .filter_map(|mark| Some((mark, frame.pixel((mark.x, mark.y))?)))
        .collect();
    let mut names = Names::new(frame.area, drawn_lines(frame, map));
    for &(_, centre) in &places {
        draw_triangle(canvas, centre)?;
        let size = 2.0 * MARK_RADIUS;
        names.keep_off(Rect::centred(centre, size, size));
    }
    for (mark, (x, y)) in places {
        let name = names.block(&mark.name)?;
        let beside = MARK_RADIUS + HALO + 2.0 + name.width / 2.0;
        let above = MARK_RADIUS + HALO + name.height() / 2.0;
        let centres = [
            (x + beside, y),
            (x - beside, y),
            (x, y - above),
            (x, y + above),
        ];
        names.write(canvas, &name, &centres)?;
    }
    Ok(())
}

/// What the names of marks should not hide: the lines, and the symbols as
/// short dashes.
fn drawn_lines(frame: &Frame, map: &RegimeMap) -> Vec<Vec<Pixel>> {
    let radius = symbol_radius(frame.area, map.points.len());
    let centres = map.points.iter().filter_map(|p| frame.pixel((p.x, p.y)));
    let symbols = centres.map(|(x, y)| vec![(x - radius, y), (x + radius, y)]);
    let lines = map.lines.iter().flat_map(|line| frame.curve(&line.points));
    symbols.chain(lines).collect()
}

#[cfg(test)]
mod tests {
    use super::super::canvas::tests::assert_text_inside;
    use super::*;

    fn map(places: &[(f64, f64)], logarithmic: bool) -> RegimeMap {
        let axis = |label: &str| Axis {
            label: label.to_string(),
            logarithmic,
        };
        RegimeMap {
            title: "Stick-slip regimes".to_string(),
            x: axis("Weight on bit W (kN)"),
            y: axis("Surface speed Ωₛ (rpm)"),
            cells: Vec::new(),
            points: places
                .iter()
                .map(|&(x, y)| MapPoint {
                    x,
                    y,
                    symbol: Symbol::Circle,
                })
                .collect(),
            legend: ["all", "none", "some"].map(String::from).into(),
            lines: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// Circles in the map without the one in the legend.
    fn circles(map: &RegimeMap) -> usize {
        let picture = regime_map(map).expect("drawn");
        picture.svg.matches("<circle").count() - 1
    }

    #[test]
    fn every_point_gets_a_symbol_unless_it_cannot_be_shown() {
        let places = [
            (1.0, 2.0),
            (3.0, 4.0),
            (0.0, 1.0),
            (5.0, -1.0),
            (f64::NAN, 1.0),
        ];
        assert_eq!(circles(&map(&places, false)), 4);
        assert_eq!(circles(&map(&places, true)), 2);
    }

    #[test]
    fn maps_without_range_are_drawn() {
        for places in [
            &[][..],
            &[(1.0, 1.0)],
            &[(2.0, 1.0), (2.0, 5.0)],
            &[(f64::INFINITY, 1.0)],
        ] {
            for logarithmic in [false, true] {
                let picture = regime_map(&map(places, logarithmic)).expect("drawn");
                assert_text_inside(&picture);
            }
        }
    }

    #[test]
    fn lines_do_not_widen_the_axes() {
        let mut map = map(&[(0.0, 0.0), (1.0, 1.0)], false);
        let before = scales(&map).0.fraction(1.0);
        map.lines.push(Line {
            name: "far".to_string(),
            points: vec![(-1e6, 0.5), (1e6, 0.5)],
        });
        assert_eq!(scales(&map).0.fraction(1.0), before);
    }

    #[test]
    fn cells_fill_the_map_and_its_legend() {
        let mut map = map(&[], false);
        map.cells = [Symbol::Circle, Symbol::Square]
            .into_iter()
            .enumerate()
            .map(|(index, symbol)| MapCell {
                x: [index as f64, index as f64 + 1.0],
                y: [0.0, 1.0],
                symbol,
            })
            .collect();
        let picture = regime_map(&map).expect("drawn");
        // Both cells, and a key for each of the three symbols.
        assert_eq!(picture.svg.matches("<polygon").count(), 5);
        assert_text_inside(&picture);
    }

    #[test]
    fn long_texts_and_many_lines_stay_inside() {
        let mut map = map(&[(1e-7, 1e7), (5e-7, 1e9)], true);
        let long = "a rather long text that would not fit on a single line ".repeat(4);
        map.title.clone_from(&long);
        map.x.label.clone_from(&long);
        map.y.label.clone_from(&long);
        map.lines.extend((0..30).map(|i| Line {
            name: format!("{i} {long}"),
            points: Vec::new(),
        }));
        map.marks.push(Mark {
            name: long,
            x: 5e-7,
            y: 1e9,
        });
        assert_text_inside(&regime_map(&map).expect("drawn"));
    }
}
