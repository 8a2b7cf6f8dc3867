//! The positive-real margins of responses (see [`crate::passivity`]): whether a site
//! that sticks, or leans on a wall, stays stable.

use super::bending::reciprocity;
use super::channels::{ChannelResponses, Responses};
use crate::budget::{Budget, Need, OutOfBudget, REAL, What};
use crate::channel::Channel;
use crate::error::BuildError;
use crate::method::Method;
use crate::passivity::{Ending, Reciprocity, bytes, positive_real_margin};

/// The margin of a channel before it is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarginPlan {
    /// Bytes.
    scratch: f64,
}

impl MarginPlan {
    /// Of responses in torsion of a number of taps, between a number of sites that torques act on.
    pub fn in_torsion(sites: usize, taps: usize) -> Self {
        Self::of_speeds(sites, taps, Reciprocity::None)
    }

    fn of_speeds(sites: usize, taps: usize, reciprocity: Reciprocity) -> Self {
        Self {
            scratch: bytes(sites, taps, reciprocity),
        }
    }

    /// The same in bending by a method, where it is that of velocities.
    pub fn in_bending(method: &Method, sites: usize, taps: usize) -> Self {
        Self::of_velocities(sites, taps, reciprocity(method))
    }

    /// The same of elements that are stepped, whose responses are the same in both directions but
    /// for rounding.
    pub fn in_bending_by_steps(sites: usize, taps: usize) -> Self {
        Self::of_velocities(sites, taps, Reciprocity::None)
    }

    fn of_velocities(sites: usize, taps: usize, reciprocity: Reciprocity) -> Self {
        let velocities = REAL * (sites * sites * taps) as f64;
        Self {
            scratch: velocities + bytes(sites, taps, reciprocity),
        }
    }

    fn of(channel: &ChannelResponses) -> Self {
        let (sites, taps) = (channel.loads.len(), channel.taps());
        let points = channel.driving_points();
        let reciprocity = Reciprocity::of(sites, |output, input| points[output][input]);
        match channel.channel {
            Channel::Torsion | Channel::Axial => Self::of_speeds(sites, taps, reciprocity),
            Channel::Bending => Self::of_velocities(sites, taps, reciprocity),
        }
    }

    /// What finding it takes of a budget, and gives back.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(Need::passing(self.scratch), What::Margin)
    }
}

impl Responses {
    /// The margins in torsion and in bending, where these are ([`Responses::torsion_margin`],
    /// [`Responses::bending_margin`]), within a budget.
    ///
    /// # Errors
    /// Where these are not the responses of a string, or more memory is needed than is left.
    pub fn margins(&self, budget: &Budget) -> Result<[Option<f64>; 2], BuildError> {
        for channel in &self.channels {
            MarginPlan::of(channel).ask(budget)?;
        }
        Ok([self.torsion_margin()?, self.bending_margin()?])
    }

    /// Positive-real margin of the driving points in torsion; `None` where no torque
    /// acts.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn torsion_margin(&self) -> Result<Option<f64>, BuildError> {
        self.margin_of_speeds(Channel::Torsion)
    }

    /// The same of axial motion; `None` where no force acts.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn axial_margin(&self) -> Result<Option<f64>, BuildError> {
        self.margin_of_speeds(Channel::Axial)
    }

    fn margin_of_speeds(&self, channel: Channel) -> Result<Option<f64>, BuildError> {
        self.check()?;
        let Some(speeds) = self.channel(channel).filter(|it| !it.loads.is_empty()) else {
            return Ok(None);
        };
        let points = speeds.driving_points();
        let taps = |output: usize, input: usize| points[output][input];
        positive_real_margin(speeds.loads.len(), speeds.ending, taps).map(Some)
    }

    /// Positive-real margin of the velocities at the sites in bending, as the method
    /// differentiates in time; `None` where there is no bending.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn bending_margin(&self) -> Result<Option<f64>, BuildError> {
        self.check()?;
        let Some(velocities) = self.velocities() else {
            return Ok(None);
        };
        let ending = self.ending_in_bending(&velocities);
        margin_of(&velocities, ending).map(Some)
    }

    /// The margin of the differences of positions in bending, times their rate: what a
    /// wall meets that takes them for velocities, as the sliding speed of Eq. 70 does.
    /// They are those from step to step; by `held`, whose wall is met in the middle of a
    /// step, those from its beginning, which are its mean speed. By `hilbert` that is the
    /// method's own derivative too; by `quadrature` the margin stays positive; Newmark's
    /// scheme has its own velocity, a fraction of a step ahead, and this margin may be
    /// below zero where [`Self::bending_margin`] is not.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn margin_of_differences(&self) -> Result<Option<f64>, BuildError> {
        self.check()?;
        if self.method.collocation_offset() > 0.0 {
            return self.bending_margin();
        }
        let differences = self.bending().map(|bending| each(bending, differences));
        differences
            .map(|differences| margin_of(&differences, ending_of(&differences)))
            .transpose()
    }

    /// How velocities in bending end, `[site][input]`.
    fn ending_in_bending(&self, velocities: &[Vec<Vec<f64>>]) -> Ending {
        match (self.method, ending_of(velocities)) {
            // A filter is no longer than it is.
            (Method::Hilbert(_) | Method::DirectIdft(_), _) => Ending::Whole,
            // It takes nothing from the string's own highest frequencies, which ring on as long as
            // others: cut off at once, they would ripple about what they are.
            (Method::Held | Method::Poles, Ending::Cut) => Ending::Ringing,
            (_, ending) => ending,
        }
    }

    /// Taps from the forces at the sites that loads act on to the velocities of these, as the
    /// method differentiates in time; `[output][input]`, m/s per N.
    pub fn velocities(&self) -> Option<Vec<Vec<Vec<f64>>>> {
        let derivative = self.method.derivative();
        let bending = self.bending()?;
        Some(each(bending, |taps| derivative.of(taps)))
    }
}

/// Differences from tap to tap, from rest.
fn differences(taps: &[f64]) -> Vec<f64> {
    let before = std::iter::once(&0.0).chain(taps);
    let pairs = taps.iter().zip(before);
    pairs.map(|(now, before)| now - before).collect()
}

/// Every response between sites that loads act on, changed.
fn each(channel: &ChannelResponses, change: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Vec<Vec<f64>>> {
    let points = channel.driving_points();
    let of_site = |inputs: &Vec<&[f64]>| inputs.iter().map(|taps| change(taps)).collect();
    points.iter().map(of_site).collect()
}

/// How velocities at sites end, `[site][input]`.
fn ending_of(velocities: &[Vec<Vec<f64>>]) -> Ending {
    let instant = (velocities.iter().enumerate()).map(|(site, inputs)| inputs[site][0]);
    let responses = velocities.iter().flatten().map(Vec::as_slice);
    Ending::of(responses, instant.fold(0.0, f64::max))
}

/// The positive-real margin of velocities at sites, `[site][input]`.
fn margin_of(velocities: &[Vec<Vec<f64>>], ending: Ending) -> Result<f64, BuildError> {
    positive_real_margin(velocities.len(), ending, |output, input| {
        &velocities[output][input]
    })
}
