//! The drag of viscous mud as elements have it: by relaxations fitted to it, each stepped as a
//! separate variable by the trapezoidal rule.

use crate::assembly::number::Number;
use crate::channel::Channel;
use crate::drillstring::{Drillstring, Tube};
use crate::loss::Fit;
use crate::loss::mud::Annulus;
use crate::sites::Sites;
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// The fits of all tubes of a string in one channel.
#[derive(Debug, Clone, Default)]
pub(crate) struct MudFits {
    known: Vec<(Annulus, Fit)>,
}

impl MudFits {
    /// Of the tubes between nodes; none where no mud is viscous.
    pub fn new(string: &Drillstring, channel: Channel, spans: &[SurroundedSpan]) -> Self {
        let tubes = spans.iter().flatten().flat_map(|part| {
            let tubes = part.runs.iter().flat_map(|run| &run.parts);
            tubes.map(|tube| (tube, &part.around))
        });
        Self::of_tubes(string, channel, tubes)
    }

    /// The same of tubes with what is around them.
    pub fn of_tubes<'a>(
        string: &Drillstring,
        channel: Channel,
        tubes: impl Iterator<Item = (&'a Tube, &'a Surroundings)>,
    ) -> Self {
        let mut known: Vec<(Annulus, Fit)> = Vec::new();
        for mud in tubes.filter_map(|(tube, around)| annulus(string, tube, around.hole_radius)) {
            if known.iter().all(|(other, _)| *other != mud) {
                let fit = match channel {
                    Channel::Torsion => Fit::against_turning(&mud),
                    Channel::Bending => Fit::against_moving(&mud),
                };
                known.push((mud, fit));
            }
        }
        Self { known }
    }

    /// That of a tube in a hole of a radius (m); `None` where no mud is viscous.
    pub fn on(&self, string: &Drillstring, tube: &Tube, hole: Option<f64>) -> Option<&Fit> {
        let mud = annulus(string, tube, hole)?;
        let found = self.known.iter().find(|(other, _)| *other == mud);
        found.map(|(_, fit)| fit)
    }

    /// All of them at the Laplace variable `s`, rad/s.
    pub fn at<T: Number>(&self, s: T) -> MudDrag<T> {
        let drag = |(mud, fit): &(Annulus, Fit)| (*mud, s.each(|s| fit.at(s)));
        MudDrag(self.known.iter().map(drag).collect())
    }
}

/// The largest error of the drag of mud as elements have it, between 0.01 and 1000 Hz, as a part of
/// that drag; in bending, of what is left of it without the mass that mud moves aside. `None` where
/// no mud is viscous.
pub fn error_of_drag(string: &Drillstring, channel: Channel) -> Option<f64> {
    // The bit is a place of every string.
    let spans = string.surrounded_spans(channel, &Sites::bit());
    let fits = MudFits::new(string, channel, &spans.unwrap_or_default());
    let errors = fits.known.iter().map(|(_, fit)| fit.error);
    errors.reduce(f64::max)
}

fn annulus(string: &Drillstring, tube: &Tube, hole: Option<f64>) -> Option<Annulus> {
    let radii = [tube.inner_radius, tube.outer_radius];
    string.loss().annulus(radii, hole)
}

/// Drag per length and speed of all tubes of a string.
#[derive(Debug, Clone)]
pub(crate) struct MudDrag<T>(Vec<(Annulus, T)>);

impl<T: Number> MudDrag<T> {
    /// On a tube in a hole of a radius (m); `None` where no mud is viscous.
    pub fn on(&self, string: &Drillstring, tube: &Tube, hole: Option<f64>) -> Option<T> {
        let mud = annulus(string, tube, hole)?;
        let found = self.0.iter().find(|(other, _)| *other == mud);
        found.map(|(_, drag)| *drag)
    }
}
