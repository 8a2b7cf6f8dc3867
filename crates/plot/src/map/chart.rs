//! Where the maps of a chart and their legends stand: one map alone has its legend at its side, or
//! below where the picture is narrow; groups of one map each stand side by side, the maps of a
//! larger group in rows with the legend below.

use super::panel::{draw_panel, line_stroke, scales};
use super::{MapChart, MapGroup};
use crate::canvas::{Canvas, Title, draw_titled};
use crate::fills::CellFill;
use crate::frame::Frame;
use crate::geometry::Rect;
use crate::legend::{Key, Legend, distinct};
use crate::lettering::Align;
use crate::look::{Look, is_narrow};
use crate::picture::Picture;
use crate::scale::Scale;
use crate::text::{Block, LABEL_SIZE, SMALL_SIZE, TITLE_SIZE};

const MARGIN: f64 = 14.0;

/// Size of a chart with one map.
const WIDTH_ALONE: f64 = 900.0;
const HEIGHT_ALONE: f64 = 620.0;
/// Distance between the plotting area and the legend at its side.
const LEGEND_GAP: f64 = 22.0;

/// Width of a chart with several maps.
const WIDTH: f64 = 1180.0;
/// Distance between maps.
const GAP: f64 = 18.0;
/// Space after a text below a map.
const TEXT_GAP: f64 = 5.0;
/// Room for the half of a number below the right end of a map.
const LABEL_ROOM: f64 = 14.0;
/// Height of a map, by how many stand in a row.
const HEIGHTS: [f64; 3] = [430.0, 430.0, 320.0];
/// The same at most, as a part of its width, and the least width of one that has others at its side.
const HIGHEST: f64 = 0.87;
const LEAST_WIDTH: f64 = 300.0;

/// Draws a chart.
///
/// The axes span the cells, the points and the marks; a chart without points spans
/// its lines and marks, an empty one 0 to 1.
///
/// A map of four cases with a line between its regimes, as SVG.
///
/// ```
/// use plot::{Axis, CellFill, Look, Series, Symbol};
/// use plot::{MapChart, MapGroup, MapPanel, MapPoint, map_chart};
///
/// let point = |at: (f64, f64)| MapPoint {
///     at,
///     symbol: if at.1 < 60.0 { Symbol::Circle } else { Symbol::Cross },
/// };
/// let panel = MapPanel {
///     points: [(40.0, 30.0), (80.0, 30.0), (40.0, 90.0), (80.0, 90.0)].map(point).to_vec(),
///     lines: vec![Series::new("Eq. 74", vec![(40.0, 50.0), (80.0, 70.0)])],
///     ..MapPanel::default()
/// };
/// let keys = [(Symbol::Circle, "stick-slip"), (Symbol::Cross, "smooth")];
/// let group = MapGroup {
///     keys: keys.map(|(symbol, words)| (CellFill::Symbol(symbol), words.to_owned())).to_vec(),
///     panels: vec![panel],
///     ..MapGroup::default()
/// };
/// let chart = MapChart {
///     title: "Where the bit sticks".to_owned(),
///     axes: ["Weight on bit (kN)", "Surface speed (rpm)"].map(Axis::linear),
///     marks: Vec::new(),
///     groups: vec![group],
/// };
/// let svg = map_chart(&Look::default(), &chart).svg();
/// assert!(["Where the bit sticks", "stick-slip", "Eq. 74"].iter().all(|text| svg.contains(text)));
/// ```
pub fn map_chart(look: &Look, chart: &MapChart) -> Picture {
    match &chart.groups[..] {
        [group] if group.panels.len() == 1 && !is_narrow(look.width(WIDTH_ALONE)) => {
            alone(look, chart, group)
        }
        groups => arranged(look, chart, groups),
    }
}

/// The legend of a group.
fn keys(group: &MapGroup) -> Vec<(Key, &str)> {
    let has_fills = group.panels.iter().any(|panel| !panel.cells.is_empty());
    let key = |fill: &CellFill| match fill {
        CellFill::Symbol(symbol) if !has_fills => Key::Symbol(*symbol),
        fill => Key::Cell(*fill),
    };
    let keys = group.keys.iter();
    let mut keys: Vec<(Key, &str)> = keys
        .map(|(fill, text)| (key(fill), text.as_str()))
        .collect();
    let lines = group.lines().into_iter().enumerate();
    keys.extend(lines.map(|(index, (name, style))| (Key::Line(line_stroke(index, style)), name)));
    let bands = group.panels.iter().flat_map(|panel| &panel.bands);
    let bands = distinct(bands.map(|band| &band.name));
    keys.extend(bands.into_iter().map(|name| (Key::Hatching, name)));
    keys
}

fn alone(look: &Look, chart: &MapChart, group: &MapGroup) -> Picture {
    let title = Title::new(look, &chart.title, WIDTH_ALONE, MARGIN);
    let text = |text| (Key::Nothing, text);
    let scale = group.scale.iter().map(String::as_str).map(text);
    let notes = group.notes.iter().map(String::as_str).map(text);
    let legend = Legend::new(scale.chain(keys(group)).chain(notes));
    let top = title.bottom();
    let below: Vec<Block> = (group.below.iter())
        .map(|text| Block::new(text, SMALL_SIZE, title.width - 2.0 * MARGIN))
        .collect();
    let bottom = (HEIGHT_ALONE - MARGIN).max(top + legend.height());
    let texts: f64 = below.iter().map(|text| text.height() + TEXT_GAP).sum();
    let height = bottom + texts + MARGIN;
    let legend_left = title.width - MARGIN - legend.width();
    let outer = Rect {
        left: MARGIN,
        top,
        right: legend_left - LEGEND_GAP,
        bottom,
    };
    let frame = Frame::new(outer, &chart.axes, scales(chart, look.ranges));
    draw_titled(&title, height, |canvas| {
        for panel in &group.panels {
            draw_panel(canvas, &frame, &chart.marks, group, panel);
        }
        legend.draw(canvas, legend_left, top);
        write(canvas, &below, MARGIN, bottom + TEXT_GAP);
    })
}

fn arranged(look: &Look, chart: &MapChart, groups: &[MapGroup]) -> Picture {
    let title = Title::new(look, &chart.title, WIDTH, MARGIN);
    let all_alone = groups.iter().all(|group| group.panels.len() == 1);
    let columns = if all_alone && !is_narrow(title.width) {
        groups.len().max(1)
    } else {
        1
    };
    let gaps = (columns - 1) as f64 * GAP;
    let width = (title.width - 2.0 * MARGIN - gaps) / columns as f64;
    let scales = scales(chart, look.ranges);
    let (mut blocks, mut bottom) = (Vec::new(), title.bottom());
    let (mut left, mut top) = (MARGIN, bottom);
    for group in groups {
        let (end, draw) = group_block(chart, scales, group, [left, top, width]);
        bottom = bottom.max(end);
        if columns > 1 {
            left += width + GAP;
        } else {
            top = bottom;
        }
        blocks.push(draw);
    }
    draw_titled(&title, bottom + MARGIN, |canvas| {
        blocks.iter().for_each(|draw| draw(canvas))
    })
}

/// The maps of a group in rows, its legend and its notes below: where they end, and what
/// draws them.
fn group_block<'a>(
    chart: &'a MapChart,
    scales: [Scale; 2],
    group: &'a MapGroup,
    [left, top, width]: [f64; 3],
) -> (f64, impl Fn(&mut Canvas) + 'a) {
    let heading = Block::new(&group.heading, TITLE_SIZE, width);
    let maps_top = top + heading.height() + 0.3 * GAP;
    let (frames, texts_top) = frames(chart, scales, group, [left, maps_top, width]);
    let legend = Legend::new(keys(group)).in_rows(width);
    let small = |text: &String| Block::new(text, SMALL_SIZE, width);
    let notes: Vec<Block> = group.notes.iter().map(small).collect();
    let scale = group.scale.as_ref().map(small);
    let below: Vec<Block> = group.below.iter().map(small).collect();
    let texts = scale.iter().chain(&notes).chain(&below);
    let texts: f64 = texts.map(|text| text.height() + TEXT_GAP).sum();
    let bottom = texts_top + legend.height() + texts + 0.5 * GAP;
    let draw = move |canvas: &mut Canvas| {
        let heading_row = top + 0.5 * heading.line_height();
        canvas.text(&heading, left + 0.5 * width, heading_row, Align::Centre);
        for ((title, frame), panel) in frames.iter().zip(&group.panels) {
            let first_row = frame.area.top - 0.3 * GAP - title.height() + 0.5 * title.line_height();
            // Above the plotting area, but not beyond its right end.
            let furthest = frame.area.right - 0.5 * title.width;
            let middle = frame.area.centre().0.min(furthest);
            canvas.text(title, middle, first_row, Align::Centre);
            draw_panel(canvas, frame, &chart.marks, group, panel);
        }
        let row = write(canvas, scale.as_slice(), left, texts_top);
        legend.draw(canvas, left, row);
        let row = write(canvas, &notes, left, row + legend.height());
        write(canvas, &below, left, row);
    };
    (bottom, draw)
}

/// Writes texts below one another and returns where the last ends.
fn write(canvas: &mut Canvas, texts: &[Block], left: f64, mut row: f64) -> f64 {
    for text in texts {
        let first_row = row + 0.5 * text.line_height();
        canvas.text(text, left, first_row, Align::Left);
        row += text.height() + TEXT_GAP;
    }
    row
}

/// The maps of a group in rows, each with its title above, and where the last row ends.
fn frames(
    chart: &MapChart,
    scales: [Scale; 2],
    group: &MapGroup,
    [left, top, width]: [f64; 3],
) -> (Vec<(Block, Frame)>, f64) {
    let columns = match group.panels.len() {
        0 | 1 => 1,
        2 | 4 => 2,
        _ => 3,
    };
    let columns = columns.min(((width / LEAST_WIDTH) as usize).max(1));
    let map_width = (width - (columns - 1) as f64 * GAP) / columns as f64;
    let mut frames = Vec::with_capacity(group.panels.len());
    let mut row_top = top;
    for row in group.panels.chunks(columns) {
        let titles: Vec<Block> = (row.iter())
            .map(|panel| Block::new(&panel.title, LABEL_SIZE, map_width))
            .collect();
        let title_height = titles.iter().map(Block::height).fold(0.0, f64::max);
        let bottom = row_top + title_height + HEIGHTS[columns - 1].min(HIGHEST * map_width);
        for (column, title) in titles.into_iter().enumerate() {
            let left = left + column as f64 * (map_width + GAP);
            let outer = Rect {
                left,
                top: row_top + title_height + 0.3 * GAP,
                right: left + map_width - LABEL_ROOM,
                bottom: bottom - 0.5 * GAP,
            };
            frames.push((title, Frame::new(outer, &chart.axes, scales)));
        }
        row_top = bottom;
    }
    (frames, row_top)
}
