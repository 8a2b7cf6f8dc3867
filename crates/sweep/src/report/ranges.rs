//! How often a regime occurs over the range of an axis, as a page draws it: the share of each
//! range as a line, its 95 % interval as an area.

use super::live_map::panel;
use crate::map::{Mesh, plot_axis};
use campaign::quantities::Units;
use plot::{
    Axis, CellFill, Fraction, LineStyle, MapCell, MapChart, MapGroup, MapPanel, Series, map_axes,
};
use results::analysis::{Bins, wilson};
use sim::Motion;

/// Numbers along an axis.
const MOST_TICKS: usize = 5;

/// The fills of the ground and of the interval.
const GROUND: CellFill = CellFill::Fraction(Fraction::EVERY[0]);
const INTERVAL: CellFill = CellFill::Fraction(Fraction::EVERY[1]);

/// The chart of a method and motion over an axis; `sustained` are counts with the regime, and all,
/// by range.
pub fn range_chart(
    method: &str,
    motion: Motion,
    bins: &Bins,
    sustained: &[[usize; 2]],
    units: Units,
) -> String {
    let mesh = Mesh::of_bins([bins, bins]);
    let unit = bins.axis.unit(units);
    let ends = |range: usize| mesh.ends(0, range).map(|end| unit.number(end));
    let last = bins.ranges.len() - 1;
    let ground = MapCell {
        ends: [[ends(0)[0], ends(last)[1]], [0.0, 100.0]],
        fill: GROUND,
    };
    let mut cells = vec![ground];
    let mut points = Vec::new();
    for (range, &[count, of]) in sustained.iter().enumerate() {
        let [from, to] = ends(range);
        let Some(interval) = wilson(count, of) else {
            points.push((f64::NAN, f64::NAN));
            continue;
        };
        let [value, low, high] =
            [interval.value, interval.low, interval.high].map(|part| 100.0 * part);
        cells.push(MapCell {
            ends: [[from, to], [low, high]],
            fill: INTERVAL,
        });
        points.extend([(from, value), (to, value)]);
    }
    let [regime, _] = motion.regimes();
    let chart = MapChart {
        title: String::new(),
        axes: [
            plot_axis(bins.axis, bins.spacing, units),
            Axis::linear(format!("Cases with {regime} (%)")),
        ],
        marks: Vec::new(),
        groups: vec![MapGroup {
            panels: vec![MapPanel {
                title: format!("By {method}"),
                cells,
                lines: vec![Series {
                    name: String::new(),
                    style: LineStyle::default(),
                    points,
                }],
                ..MapPanel::default()
            }],
            ..MapGroup::default()
        }],
    };
    let axes = map_axes(&chart, MOST_TICKS);
    panel(&axes, &[], &chart.groups[0].panels[0], &[])
}
