//! Discrete impulse responses A(0), A(1), …: the only thing that leaves this
//! crate for a simulation (Eqs. 59–61). The matrix of Eqs. 59–60 has a block for
//! torsion and one for each plane of bending, and zeros between them: the blocks
//! are kept apart, and where a scene needs no bending only one is built.

use crate::drillstring::{Sites, SurfaceSupport};
use crate::error::{BuildError, ResponseError};
use crate::method::Method;
use crate::passivity::{Ending, positive_real_margin};

/// What a torsional response is needed for.
#[derive(Debug, Clone, PartialEq)]
pub struct TorsionRequest {
    /// Where speeds are wanted.
    pub sites: Sites,
    /// Which of the sites, by number, a torque acts on. Only these become
    /// inputs.
    pub torque_inputs: Vec<usize>,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// The longest time simulated, s. Longer responses are not computed.
    pub longest_time: f64,
}

impl TorsionRequest {
    /// Number of responses: from the surface to each site, then to each site
    /// from each torque input.
    pub(crate) fn channels(&self) -> usize {
        self.sites.len() * (1 + self.torque_inputs.len())
    }
}

/// Taps from surface speed and site torques to the rotation speeds of the
/// sites.
///
/// With inputs E and taps A, `output(k) = Σ A(k − n) E(n)` for n ≤ k: a tap
/// includes the factor 1/f_s of Eq. 61. Past the last tap the response is zero.
#[derive(Debug, Clone, PartialEq)]
pub struct TorsionResponses {
    /// Where the speeds are; these alone say which of them is the bit's.
    pub sites: Sites,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// To each site from the surface speed: dimensionless.
    pub from_surface: Vec<Vec<f64>>,
    /// `from_torque[site][input]`, to each site from each torque input:
    /// rad/s per N m.
    pub from_torque: Vec<Vec<Vec<f64>>>,
    /// The sites that torques act on, one for each input.
    pub torque_inputs: Vec<usize>,
    /// Whether the response ends with its taps, or only the simulation does.
    pub ending: Ending,
}

impl TorsionResponses {
    /// Number of taps of each response.
    pub fn taps(&self) -> usize {
        self.from_surface.first().map_or(0, Vec::len)
    }

    /// Taps from a torque at the bit to each site, where the bit is a site and a
    /// torque acts there.
    pub fn from_bit(&self) -> Option<Vec<&[f64]>> {
        let bit = self.sites.bit_site()?;
        let input = self.torque_inputs.iter().position(|&site| site == bit)?;
        let from_inputs = self.from_torque.iter();
        Some(from_inputs.map(|inputs| inputs[input].as_slice()).collect())
    }

    /// Taps from a torque at the bit to its own speed.
    pub fn at_bit(&self) -> Option<&[f64]> {
        Some(self.from_bit()?[self.sites.bit_site()?])
    }

    /// The longest time (s) that may be simulated with these taps: without end,
    /// where the response ends with them.
    pub fn longest_time(&self) -> f64 {
        match self.ending {
            Ending::Whole => f64::INFINITY,
            Ending::Cut => time_of(self.taps(), self.sampling_frequency),
        }
    }

    /// Checks that they are what a string gives, whoever made them.
    ///
    /// # Errors
    /// Where they are not.
    pub fn check(&self) -> Result<(), ResponseError> {
        let sites = self.sites.len();
        if let Some(&site) = self.torque_inputs.iter().find(|&&site| site >= sites) {
            return Err(ResponseError::NoSuchSite { site, sites });
        }
        let inputs = self.torque_inputs.len();
        if self.from_surface.len() != sites
            || self.from_torque.len() != sites
            || self.from_torque.iter().any(|row| row.len() != inputs)
        {
            return Err(ResponseError::Shape);
        }
        let all = self
            .from_surface
            .iter()
            .chain(self.from_torque.iter().flatten());
        check_taps(self.sampling_frequency, self.taps(), all)?;
        let driving = (self.torque_inputs.iter().enumerate())
            .map(|(input, &site)| (site, self.from_torque[site][input][0]));
        check_instants(driving)
    }

    /// Positive-real margin of the driving points (see
    /// [`crate::passivity`]); `None` where no torque acts.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn margin(&self) -> Result<Option<f64>, BuildError> {
        self.check()?;
        if self.torque_inputs.is_empty() {
            return Ok(None);
        }
        let points = self.driving_points();
        let taps = |output: usize, input: usize| points[output][input];
        positive_real_margin(self.torque_inputs.len(), self.ending, taps).map(Some)
    }

    /// Responses between the sites that torques act on, `[output][input]`.
    pub fn driving_points(&self) -> Vec<Vec<&[f64]>> {
        let inputs = 0..self.torque_inputs.len();
        (self.torque_inputs.iter())
            .map(|&site| {
                (inputs
                    .clone()
                    .map(|input| self.from_torque[site][input].as_slice()))
                .collect()
            })
            .collect()
    }

    /// Splits channels in the order of [`TorsionRequest::channels`].
    pub(crate) fn from_channels(
        request: &TorsionRequest,
        mut channels: Vec<Vec<f64>>,
        ending: Ending,
    ) -> Self {
        let torques = request.torque_inputs.len();
        let mut from_torque = channels.split_off(request.sites.len()).into_iter();
        Self {
            sites: request.sites.clone(),
            sampling_frequency: request.sampling_frequency,
            from_surface: channels,
            from_torque: (0..request.sites.len())
                .map(|_| from_torque.by_ref().take(torques).collect())
                .collect(),
            torque_inputs: request.torque_inputs.clone(),
            ending,
        }
    }
}

/// What a lateral response is needed for: forces at every site, displacements
/// there.
#[derive(Debug, Clone, PartialEq)]
pub struct BendingRequest {
    /// Where forces act and displacements are wanted.
    pub sites: Sites,
    /// How the surface holds the string.
    pub support: SurfaceSupport,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// The longest time simulated, s.
    pub longest_time: f64,
}

/// Taps from the forces at the sites to their displacements, in one plane; the
/// other plane's are the same.
///
/// They last as long as the simulation: a string held by nothing but damping
/// does not come back within any time of interest.
#[derive(Debug, Clone, PartialEq)]
pub struct BendingResponses {
    /// Where the forces act and the displacements are.
    pub sites: Sites,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// `from_force[site][input]`, m/N.
    pub from_force: Vec<Vec<Vec<f64>>>,
}

impl BendingResponses {
    /// Number of taps of each response.
    pub fn taps(&self) -> usize {
        let first = self.from_force.first().and_then(|inputs| inputs.first());
        first.map_or(0, Vec::len)
    }

    /// The longest time (s) that may be simulated with these taps.
    pub fn longest_time(&self) -> f64 {
        time_of(self.taps(), self.sampling_frequency)
    }

    /// Checks that they are what a string gives, whoever made them.
    ///
    /// # Errors
    /// Where they are not.
    pub fn check(&self) -> Result<(), ResponseError> {
        let sites = self.sites.len();
        if self.from_force.len() != sites || self.from_force.iter().any(|row| row.len() != sites) {
            return Err(ResponseError::Shape);
        }
        let all = self.from_force.iter().flatten();
        check_taps(self.sampling_frequency, self.taps(), all)?;
        check_instants((0..sites).map(|site| (site, self.from_force[site][site][0])))
    }

    /// Positive-real margin of the velocities at the sites (see
    /// [`crate::passivity`]), as `method`, which built these responses,
    /// differentiates in time.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn margin(&self, method: &Method) -> Result<f64, BuildError> {
        self.check()?;
        let velocities = self.velocities(method);
        let ending = match method {
            // A filter is no longer than it is.
            Method::Hilbert(_) | Method::DirectIdft(_) => Ending::Whole,
            _ => ending_of(&velocities),
        };
        margin_of(&velocities, ending)
    }

    /// The margin of the differences of positions from step to step, times f_s:
    /// what a wall meets that takes them for velocities, as the sliding speed of
    /// Eq. 70 does. By `hilbert` that is the method's own derivative; by
    /// `quadrature` it stays positive; Newmark's scheme has a velocity of its own,
    /// a part of a step ahead, and this margin may be below zero where
    /// [`Self::margin`] is not.
    ///
    /// # Errors
    /// Where these are not the responses of a string.
    pub fn margin_of_differences(&self) -> Result<f64, BuildError> {
        self.check()?;
        let differences = |taps: &Vec<f64>| -> Vec<f64> {
            let before = std::iter::once(&0.0).chain(taps);
            taps.iter()
                .zip(before)
                .map(|(now, before)| now - before)
                .collect()
        };
        let velocities: Vec<Vec<Vec<f64>>> = (self.from_force.iter())
            .map(|inputs| inputs.iter().map(differences).collect())
            .collect();
        margin_of(&velocities, ending_of(&velocities))
    }

    /// Taps from the forces at the sites to their velocities, as `method`, which
    /// built these responses, differentiates in time; `[site][input]`, m/s per N.
    pub fn velocities(&self, method: &Method) -> Vec<Vec<Vec<f64>>> {
        let derivative = method.derivative();
        (self.from_force.iter())
            .map(|inputs| inputs.iter().map(|taps| derivative.of(taps)).collect())
            .collect()
    }
}

/// Time from the first tap to the last, s.
fn time_of(taps: usize, sampling_frequency: f64) -> f64 {
    taps.saturating_sub(1) as f64 / sampling_frequency
}

/// Responses of one sampling frequency, of `taps` finite taps each.
fn check_taps<'a>(
    sampling_frequency: f64,
    taps: usize,
    mut responses: impl Iterator<Item = &'a Vec<f64>>,
) -> Result<(), ResponseError> {
    if !(sampling_frequency.is_finite() && sampling_frequency > 0.0) {
        return Err(ResponseError::SamplingFrequency {
            value: sampling_frequency,
        });
    }
    responses.try_for_each(|response| {
        if taps == 0 || response.len() != taps {
            return Err(ResponseError::Shape);
        }
        if !response.iter().all(|tap| tap.is_finite()) {
            return Err(ResponseError::NotFinite);
        }
        Ok(())
    })
}

/// A(0) of every driving point, with its site.
fn check_instants(mut instants: impl Iterator<Item = (usize, f64)>) -> Result<(), ResponseError> {
    match instants.find(|(_, value)| *value <= 0.0) {
        Some((site, value)) => Err(ResponseError::Instant { site, value }),
        None => Ok(()),
    }
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
