//! A chart of maps in the units that people read.

use campaign::quantities::{Axis, Unit, Units};
use campaign::sweep_file::Spacing;
use plot::{self, MapChart};

/// An axis of a map as it is drawn: logarithmic where values are spread evenly in the logarithm.
pub fn plot_axis(axis: Axis, spacing: Spacing, units: Units) -> plot::Axis {
    let title = axis.title(units);
    match spacing {
        Spacing::Linear => plot::Axis::linear(title),
        Spacing::Log => plot::Axis::logarithmic(title),
    }
}

/// Puts every place on a chart in these units of its axes.
pub fn show_in(chart: &mut MapChart, [x, y]: [Unit; 2]) {
    let place = |at: &mut (f64, f64)| *at = (x.number(at.0), y.number(at.1));
    let range = |ends: &mut [[f64; 2]; 2]| {
        *ends = [
            ends[0].map(|end| x.number(end)),
            ends[1].map(|end| y.number(end)),
        ];
    };
    chart.marks.iter_mut().for_each(|mark| place(&mut mark.at));
    for panel in chart.groups.iter_mut().flat_map(|group| &mut group.panels) {
        (panel.cells.iter_mut()).for_each(|cell| range(&mut cell.ends));
        (panel.bands.iter_mut()).for_each(|band| range(&mut band.ends));
        (panel.names.iter_mut()).for_each(|name| place(&mut name.at));
        (panel.points.iter_mut()).for_each(|point| place(&mut point.at));
        panel.reached.iter_mut().for_each(place);
        let lines = panel.lines.iter_mut();
        (lines.flat_map(|line| &mut line.points)).for_each(place);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use campaign::quantities::FORCE;
    use plot::{Band, CellFill, MapCell, MapGroup, MapPanel, MapPoint, Mark};
    use plot::{LineStyle, Series, Symbol};

    /// 4.4482216152605 kN are one klbf.
    #[test]
    fn everything_on_a_map_is_in_the_units_of_its_axes() {
        let (at, ends) = ((4.4482216152605, 60.0), [[4.4482216152605; 2], [60.0; 2]]);
        let name = String::new;
        let fill = CellFill::Symbol(Symbol::Cross);
        let panel = MapPanel {
            title: name(),
            cells: vec![MapCell { ends, fill }],
            points: vec![MapPoint {
                at,
                symbol: Symbol::Cross,
            }],
            reached: vec![at],
            lines: vec![Series {
                name: name(),
                style: LineStyle::default(),
                points: vec![at],
            }],
            bands: vec![Band { name: name(), ends }],
            names: vec![Mark { name: name(), at }],
        };
        let mut chart = MapChart {
            title: name(),
            axes: ["", ""].map(plot::Axis::linear),
            marks: vec![Mark { name: name(), at }],
            groups: vec![MapGroup {
                heading: name(),
                scale: None,
                keys: Vec::new(),
                notes: Vec::new(),
                panels: vec![panel],
                ..MapGroup::default()
            }],
        };
        show_in(
            &mut chart,
            [Units::Field.of(&FORCE), Unit::unchanged("rpm")],
        );
        let panel = &chart.groups[0].panels[0];
        let places = [
            chart.marks[0].at,
            panel.points[0].at,
            panel.lines[0].points[0],
            panel.names[0].at,
            panel.reached[0],
        ];
        assert_eq!(places, [(1.0, 60.0); 5]);
        let ranges = [panel.cells[0].ends, panel.bands[0].ends];
        assert_eq!(ranges, [[[1.0; 2], [60.0; 2]]; 2]);
    }
}
