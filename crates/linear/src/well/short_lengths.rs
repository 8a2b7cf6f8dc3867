//! A string in its well cut into lengths so short that what acts along each of them is even: at
//! the ends of its parts, at the stations of the survey, where the well begins to turn
//! or turns another way, and in between as often as weight and bends ask for.

use super::survey::{Survey, Vector};
use crate::drillstring::{Drillstring, Tube};

/// No length is longer than this, m.
const LONGEST: f64 = 2.0;

/// Nor does the well turn by more than this along one, rad: what acts in its middle is what acts
/// along it up to the square of this.
const MOST_TURN: f64 = 0.005;

/// The way down at a vertical depth.
const DOWN: Vector = [0.0, 0.0, 1.0];

/// A short length of string.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShortLength<'string> {
    pub part: &'string Tube,
    /// Number of that part from the surface down, cells that repeat one after the other.
    pub part_index: usize,
    /// Of its middle from the surface, m.
    pub depth: f64,
    /// m.
    pub length: f64,
    /// The way down at its middle.
    pub along: Vector,
    /// How that turns, 1/m.
    pub turn: Vector,
}

/// The short lengths of a string from the surface down; in a well without a survey it hangs.
pub(super) fn short_lengths<'string>(
    string: &'string Drillstring,
    survey: Option<&Survey>,
) -> Vec<ShortLength<'string>> {
    let mut lengths = Vec::new();
    let mut top = 0.0;
    let sections = string.sections().iter();
    let parts = sections.flat_map(|it| (0..it.repeat).flat_map(|_| &it.parts));
    for (part_index, part) in parts.enumerate() {
        let bottom = top + part.length;
        for (from, to) in cuts(survey, top, bottom) {
            let depth = 0.5 * (from + to);
            let (along, turn) = survey.map_or((DOWN, [0.0; 3]), |it| it.course(depth));
            lengths.push(ShortLength {
                part,
                part_index,
                depth,
                length: to - from,
                along,
                turn,
            });
        }
        top = bottom;
    }
    lengths
}

/// Where a part between two depths (m) is cut, as depths from and to.
fn cuts(survey: Option<&Survey>, top: f64, bottom: f64) -> Vec<(f64, f64)> {
    let mut ends = vec![top];
    ends.extend(
        survey
            .into_iter()
            .flat_map(|it| it.depths_between(top, bottom)),
    );
    ends.push(bottom);
    let between_stations = ends.windows(2).map(|pair| (pair[0], pair[1]));
    between_stations
        .flat_map(|(from, to)| {
            let turned = survey.map_or(0.0, |it| it.turn_rate(0.5 * (from + to))) * (to - from);
            let count = ((to - from) / LONGEST)
                .max(turned / MOST_TURN)
                .ceil()
                .max(1.0);
            let length = (to - from) / count;
            let end = move |index: usize| from + index as f64 * length;
            (0..count as usize).map(move |index| (end(index), end(index + 1)))
        })
        .collect()
}
