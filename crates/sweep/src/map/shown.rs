//! A sheet of maps in the units that people read.

use crate::plot::MapSheet;
use crate::quantities::Unit;

/// Puts every place on a sheet in these units of its axes.
pub fn show_in(sheet: &mut MapSheet, [x, y]: [Unit; 2]) {
    let place = |at: &mut (f64, f64)| *at = (x.number(at.0), y.number(at.1));
    let range = |ends: &mut [[f64; 2]; 2]| {
        *ends = [
            ends[0].map(|end| x.number(end)),
            ends[1].map(|end| y.number(end)),
        ];
    };
    sheet.marks.iter_mut().for_each(|mark| place(&mut mark.at));
    for panel in sheet.groups.iter_mut().flat_map(|group| &mut group.panels) {
        (panel.cells.iter_mut()).for_each(|cell| range(&mut cell.ends));
        (panel.bands.iter_mut()).for_each(|band| range(&mut band.ends));
        (panel.points.iter_mut()).for_each(|point| place(&mut point.at));
        let lines = panel.lines.iter_mut();
        (lines.flat_map(|line| &mut line.points)).for_each(place);
    }
}
