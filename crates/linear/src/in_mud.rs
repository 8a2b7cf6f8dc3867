//! A string by its tubes, each with the viscous mud in and around it.

use crate::drillstring::{Drillstring, Tube};
use crate::loss::mud::Annulus;
use crate::sites::Sites;

/// Tubes that are alike and have the same around them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Alike {
    /// Length of all together, m.
    pub(crate) length: f64,
    /// One of them.
    pub(crate) tube: Tube,
    /// Radius of the hole around it, m, where it is in one.
    pub(crate) hole_radius: Option<f64>,
    /// The mud, where it is viscous.
    pub(crate) mud: Option<Annulus>,
}

/// The tubes of a string that turns, from the surface down, those that are alike in a section
/// together.
pub(crate) fn tubes(string: &Drillstring) -> Vec<Alike> {
    runs(string, |run, tubes, add| {
        tubes
            .iter()
            .for_each(|tube| add(run as f64 * tube.length, tube));
    })
}

/// The same one by one.
pub(crate) fn one_by_one(string: &Drillstring) -> Vec<Alike> {
    runs(string, |run, tubes, add| {
        let tubes = (0..run).flat_map(|_| tubes);
        tubes.for_each(|tube| add(tube.length, tube));
    })
}

/// What `each` adds, tubes with their lengths (m), of every section, of a number of cells.
fn runs(
    string: &Drillstring,
    each: impl Fn(usize, &[Tube], &mut dyn FnMut(f64, &Tube)),
) -> Vec<Alike> {
    // The bit is a place of every string.
    let spans = string.surrounded_spans(string.channel(), &Sites::bit());
    let mut all = Vec::new();
    for part in spans.unwrap_or_default().iter().flatten() {
        let mut add = |length: f64, tube: &Tube| {
            let radii = [tube.inner_radius, tube.outer_radius];
            all.push(Alike {
                length,
                tube: *tube,
                hole_radius: part.around.hole_radius,
                mud: string.loss().annulus(radii, part.around.hole_radius),
            });
        };
        for run in &part.runs {
            each(run.repeat, &run.parts, &mut add);
        }
    }
    all
}
