//! One map of a chart.

use super::{MapCell, MapChart, MapGroup, MapPanel, Mark};
use crate::canvas::Canvas;
use crate::colours::{BLACK, WHITE};
use crate::fills::{CellFill, draw_fill};
use crate::frame::Frame;
use crate::geometry::{Pixel, Rect};
use crate::hatching::{RIM, draw_hatching};
use crate::line_styles::{LineStyle, place_among};
use crate::names::Names;
use crate::scale::{Scale, visible};
use crate::shapes::{DASHES, Stroke};
use crate::symbols::{HALO, MARK_RADIUS, draw_symbol, draw_triangle};

/// Widths of lines, one for each of [`DASHES`]: where lines coincide, wider
/// dashes and dots still show on top of the thin solid line.
const LINE_WIDTHS: [f64; 6] = [1.2, 2.2, 3.4, 1.8, 2.6, 2.2];

/// The look of the line with this index: black, unless its style has a colour.
pub(super) fn line_stroke(index: usize, style: LineStyle) -> Stroke {
    let pattern = index % DASHES.len();
    Stroke {
        colour: style.colour().unwrap_or(BLACK),
        width: LINE_WIDTHS[pattern],
        dash: DASHES[pattern],
    }
}

/// The scales that show all points, cells, marks and places reached of a chart, or its lines where
/// there are none of these, unless their ranges are given; the same for all maps, which are there to
/// be compared.
pub(super) fn scales(chart: &MapChart, ranges: [Option<[f64; 2]>; 2]) -> [Scale; 2] {
    let panels = || chart.groups.iter().flat_map(|group| &group.panels);
    let points = panels().flat_map(|panel| &panel.points);
    let mut places: Vec<_> = points.map(|point| point.at).collect();
    let corners = |cell: &MapCell| [0, 1].map(|end| (cell.ends[0][end], cell.ends[1][end]));
    places.extend(panels().flat_map(|panel| panel.cells.iter().flat_map(corners)));
    places.extend(panels().flat_map(|panel| &panel.reached));
    if places.is_empty() {
        let lines = panels().flat_map(|panel| &panel.lines);
        places.extend(lines.flat_map(|line| &line.points));
    }
    places.extend(chart.marks.iter().map(|mark| mark.at));
    let (x, y): (Vec<_>, Vec<_>) = visible(&chart.axes, places.into_iter()).unzip();
    let [x_axis, y_axis] = &chart.axes;
    [
        Scale::with_ends(ranges[0], x_axis.logarithmic, x.into_iter()),
        Scale::with_ends(ranges[1], y_axis.logarithmic, y.into_iter()),
    ]
}

/// Draws a map of a group, with the marks of the chart, into its frame.
pub(super) fn draw_panel(
    canvas: &mut Canvas,
    frame: &Frame,
    marks: &[Mark],
    group: &MapGroup,
    panel: &MapPanel,
) {
    frame.draw(canvas);
    for cell in &panel.cells {
        if let Some(area) = area(frame, cell.ends).and_then(|area| area.within(frame.area)) {
            // Ends on whole pixels leave no seam between neighbours.
            let area = Rect {
                left: area.left.round(),
                top: area.top.round(),
                right: area.right.round(),
                bottom: area.bottom.round(),
            };
            draw_fill(canvas, cell.fill, area);
        }
    }
    for band in &panel.bands {
        if let Some(area) = area(frame, band.ends) {
            draw_hatching(canvas, area, frame.area);
        }
    }
    let radius = symbol_radius(frame.area, panel.points.len());
    for point in &panel.points {
        if let Some(centre) = frame.pixel_inside(point.at) {
            draw_symbol(canvas, point.symbol, centre, radius);
        }
    }
    draw_lines(canvas, frame, &group.lines(), panel);
    draw_marks(canvas, frame, marks, panel)
}

/// The rectangle between two values to the right and two upwards.
fn area(frame: &Frame, [x, y]: [[f64; 2]; 2]) -> Option<Rect> {
    let (left, bottom) = frame.pixel((x[0], y[0]))?;
    let (right, top) = frame.pixel((x[1], y[1]))?;
    Some(Rect {
        left,
        top,
        right,
        bottom,
    })
}

/// Symbols as large as their mean distance allows, within legible limits.
fn symbol_radius(area: Rect, count: usize) -> f64 {
    let distance = (area.width() * area.height() / count.max(1) as f64).sqrt();
    (0.28 * distance).clamp(2.0, 5.5)
}

/// On fills that may be dark, a white rim sets the lines off.
fn draw_lines(canvas: &mut Canvas, frame: &Frame, lines: &[(&str, LineStyle)], panel: &MapPanel) {
    let mut fills = panel.cells.iter().map(|cell| cell.fill);
    let may_be_dark = fills.any(|fill| matches!(fill, CellFill::Fraction(_) | CellFill::Safety(_)));
    for line in &panel.lines {
        let place = place_among(&line.name, lines);
        let stroke = line_stroke(place, line.style);
        for piece in frame.curve(&line.points) {
            for part in frame.area.clip(&piece) {
                if may_be_dark {
                    canvas.line(&part, Stroke::solid(WHITE, stroke.width + RIM));
                }
                canvas.line(&part, stroke);
            }
        }
    }
}

fn draw_marks(canvas: &mut Canvas, frame: &Frame, marks: &[Mark], panel: &MapPanel) {
    let places = marks.iter();
    let places = places.filter_map(|mark| Some((mark, frame.pixel_inside(mark.at)?)));
    let places: Vec<_> = places.collect();
    for &(_, centre) in &places {
        draw_triangle(canvas, centre);
    }
    let size = 2.0 * MARK_RADIUS;
    let centres = places.iter().map(|&(_, centre)| centre);
    let taken = centres.map(|centre| Rect::centred(centre, size, size));
    let mut names = Names::new(frame.area, taken.collect(), drawn_lines(frame, panel));
    for name in &panel.names {
        if let Some(centre) = frame.pixel_inside(name.at) {
            let text = names.block(&name.name);
            names.write(canvas, &text, &[centre]);
        }
    }
    for (mark, (x, y)) in places {
        let name = names.block(&mark.name);
        let sideways = MARK_RADIUS + HALO + 2.0 + name.width / 2.0;
        let above = MARK_RADIUS + HALO + name.height() / 2.0;
        let centres = [
            (x + sideways, y),
            (x - sideways, y),
            (x, y - above),
            (x, y + above),
        ];
        names.write(canvas, &name, &centres);
    }
}

/// What the names of marks should not hide: the lines, and the symbols as
/// short dashes.
fn drawn_lines(frame: &Frame, panel: &MapPanel) -> Vec<Vec<Pixel>> {
    let radius = symbol_radius(frame.area, panel.points.len());
    let centres = panel.points.iter().filter_map(|p| frame.pixel(p.at));
    let symbols = centres.map(|(x, y)| vec![(x - radius, y), (x + radius, y)]);
    let lines = panel.lines.iter();
    let lines = lines.flat_map(|line| frame.curve(&line.points));
    symbols.chain(lines).collect()
}
