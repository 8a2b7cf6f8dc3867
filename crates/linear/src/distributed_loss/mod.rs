//! What takes energy from the tubes of a string in one channel, at one frequency or several side by
//! side.

mod drag;
mod interpolated;

use crate::assembly::number::Number;
use crate::channel::Channel;
use crate::drillstring::{Drillstring, Tube};
use crate::loss::mud::Annulus;
use crate::loss::{Fit, Relaxation, sum};
use crate::sites::Sites;
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;
use drag::Drag;
pub(crate) use interpolated::Interpolated;

/// Internal and external radius of a tube and radius of the hole around it, m.
type Radii = [f64; 3];

/// What takes energy from the tubes of a string; the drag of mud, where it is viscous, once for all
/// tubes that are alike.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LossAlong<D> {
    /// In rising order, with the drag on each.
    kinds: Vec<Radii>,
    drags: Vec<D>,
    material: Vec<Relaxation>,
}

/// The same at a frequency.
#[derive(Debug)]
pub(crate) struct LossAt<'a, T> {
    kinds: &'a [Radii],
    drags: Vec<T>,
    stiffening: Option<T>,
}

impl LossAlong<Interpolated> {
    /// Of the tubes between nodes, by the exact flow.
    pub fn exact(string: &Drillstring, channel: Channel, spans: &[SurroundedSpan]) -> Self {
        Self::new(string, tubes(spans), |annulus| {
            Interpolated::new(annulus, channel)
        })
    }
}

impl LossAlong<Fit> {
    /// Of tubes and what is around them, by relaxations that are fitted to it; in bending without
    /// the mass that mud moves aside.
    pub fn fitted<'a>(
        string: &Drillstring,
        channel: Channel,
        tubes: impl Iterator<Item = (&'a Tube, &'a Surroundings)>,
    ) -> Self {
        Self::new(string, tubes, |annulus| Fit::of_drag(&annulus, channel))
    }

    /// The largest error of the drag, as a part of it; `None` where no mud is viscous.
    pub fn error(&self) -> Option<f64> {
        self.drags.iter().map(|fit| fit.error).reduce(f64::max)
    }
}

impl<D: Drag> LossAlong<D> {
    fn new<'a>(
        string: &Drillstring,
        tubes: impl Iterator<Item = (&'a Tube, &'a Surroundings)>,
        drag: impl Fn(Annulus) -> D,
    ) -> Self {
        let loss = string.loss();
        let radii = |(tube, around): (&Tube, &Surroundings)| {
            let hole = around.hole_radius?;
            loss.viscous_mud()?;
            Some([tube.inner_radius, tube.outer_radius, hole])
        };
        let mut kinds: Vec<Radii> = tubes.filter_map(radii).collect();
        kinds.sort_by(compare);
        kinds.dedup();
        let drags = kinds.iter().filter_map(|&[inner, outer, hole]| {
            let annulus = loss.annulus([inner, outer], Some(hole))?;
            Some(drag(annulus))
        });
        Self {
            drags: drags.collect(),
            kinds,
            material: loss.relaxations().to_vec(),
        }
    }

    /// At the Laplace variable `s`, rad/s, which is asked for only where loss depends on it.
    pub fn at<T: Number>(&self, s: impl FnOnce() -> T) -> LossAt<'_, T> {
        let mut found = LossAt {
            kinds: &self.kinds,
            drags: Vec::new(),
            stiffening: None,
        };
        if self.kinds.is_empty() && self.material.is_empty() {
            return found;
        }
        let s = s();
        if !self.drags.is_empty() {
            let places: Vec<D::Place> = (0..T::LANES).map(|lane| D::place(s.lane(lane))).collect();
            let drags = self.drags.iter();
            found.drags = drags
                .map(|drag| T::of_lanes(|lane| drag.at(&places[lane])))
                .collect();
        }
        if !self.material.is_empty() {
            found.stiffening = Some(s.each(|s| sum(&self.material, s) + 1.0));
        }
        found
    }

    /// The drag of mud on a tube in a hole of a radius (m); `None` where no mud is viscous.
    pub fn drag_on(&self, tube: &Tube, hole: Option<f64>) -> Option<&D> {
        index(&self.kinds, tube, hole).map(|index| &self.drags[index])
    }
}

impl<T: Number> LossAt<'_, T> {
    /// Force per length and speed (torque, where it turns) by which mud holds back a tube in a hole
    /// of a radius (m); `None` where no mud is viscous.
    pub fn drag_on(&self, tube: &Tube, hole: Option<f64>) -> Option<T> {
        index(self.kinds, tube, hole).map(|index| self.drags[index])
    }

    /// What the moduli are multiplied by; `None` where the material has no loss.
    pub fn stiffening(&self) -> Option<T> {
        self.stiffening
    }
}

/// Which kind a tube in a hole is of.
fn index(kinds: &[Radii], tube: &Tube, hole: Option<f64>) -> Option<usize> {
    if kinds.is_empty() {
        return None;
    }
    let radii = [tube.inner_radius, tube.outer_radius, hole?];
    kinds.binary_search_by(|kind| compare(kind, &radii)).ok()
}

fn compare(one: &Radii, other: &Radii) -> std::cmp::Ordering {
    let parts = one.iter().zip(other);
    parts.fold(std::cmp::Ordering::Equal, |found, (one, other)| {
        found.then(one.total_cmp(other))
    })
}

/// All tubes between nodes.
pub(crate) fn tubes(spans: &[SurroundedSpan]) -> impl Iterator<Item = (&Tube, &Surroundings)> {
    spans.iter().flatten().flat_map(|part| {
        let tubes = part.runs.iter().flat_map(|run| &run.parts);
        tubes.map(|tube| (tube, &part.around))
    })
}

/// The largest error of the drag of mud as elements have it, between 0.01 and 1000 Hz, as a part of
/// that drag; in bending, of what is left of it without the mass that mud moves aside. `None` where
/// no mud is viscous.
pub fn error_of_drag(string: &Drillstring, channel: Channel) -> Option<f64> {
    // The bit is a place of every string.
    let spans = string.surrounded_spans(channel, &Sites::bit());
    let spans = spans.unwrap_or_default();
    LossAlong::fitted(string, channel, tubes(&spans)).error()
}
