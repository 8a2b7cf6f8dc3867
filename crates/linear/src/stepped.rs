//! The whole string as finite elements that are stepped (Section 3), for strings that are
//! touched at many sites.
//!
//! Responses between N sites are N² series of taps, as long as the simulation. A mesh that is
//! stepped has the same memory in the state of its nodes: what a step costs depends on the
//! length of the string, not on the sites, and loads cost where they act alone. It gives what
//! [`crate::responses()`] give by [`Method::FiniteElement`], up to rounding.
//!
//! ```
//! use linear::method::FiniteElement;
//! use linear::{Bending, ChannelRequest, Drillstring, Material, Method, Request, Section, Sites};
//! use linear::{SteppedString, SurfaceSupport, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 10, parts: vec![pipe] }], 0.02)?;
//! let bending = Bending { youngs_modulus: 210e9, damping: 100.0, compression: 0.0 };
//! let (support, newmark) = (SurfaceSupport::Pinned, FiniteElement::default());
//! let stepped = SteppedString::new(&string, &bending, support, &Sites::bit(), &newmark, 200.0)?;
//! let by_stepping = stepped.responses(&[0], 1.0)?;
//!
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: 200.0,
//!     longest_time: 1.0,
//! };
//! let responses = linear::responses(&string, &Method::FiniteElement(newmark), &request)?;
//! let [one, other] = [&by_stepping, &responses].map(|it| it.at_bit().unwrap_or_default());
//! assert!(!one.is_empty() && one.len() <= other.len());
//! let rounding = 1e-9 * other[0];
//! assert!(one.iter().zip(other).all(|(one, other)| (one - other).abs() < rounding));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::bending::{Bending, SurfaceSupport};
use crate::budget::{Budget, Need, REAL, What};
use crate::channel::Channel;
use crate::drillstring::{Drillstring, StringId};
use crate::elements::mesh::most_elements;
use crate::elements::newmark::Weights;
use crate::elements::stepped::{SteppedChannel, SurfaceElement, assembled_bytes, bent, turned};
use crate::error::BuildError;
use crate::method::{FiniteElement, Method};
use crate::passivity::Ending;
use crate::responses::length::taps_of;
use crate::responses::{ChannelResponses, Responses};
use crate::sites::Sites;

/// A string that bends, as finite elements in torsion and in two planes of bending.
#[derive(Debug, Clone)]
pub struct SteppedString {
    string: StringId,
    parameters: FiniteElement,
    sites: Sites,
    sampling_frequency: f64,
    surface: SurfaceElement,
    torsion: SteppedChannel<1, 1>,
    bending: SteppedChannel<2, 2>,
    /// The same in bending, held by the springs of its sites, where there are any: without them
    /// responses of a string that buckles grow for ever.
    held: Option<SteppedChannel<2, 2>>,
}

/// The same before it is divided.
#[derive(Debug, Clone, Copy)]
pub struct SteppedPlan<'a> {
    string: &'a Drillstring,
    bending: &'a Bending,
    support: SurfaceSupport,
    sites: &'a Sites,
    parameters: &'a FiniteElement,
    sampling_frequency: f64,
    /// Nodes in torsion and in bending, at most.
    nodes: [f64; 2],
}

impl<'a> SteppedPlan<'a> {
    /// Of a string that is divided into elements, its surface turned as prescribed or by its top
    /// drive: that is stepped with the mesh, as the inertia, the dashpot and the spring that it is
    /// to the string.
    pub fn new(
        string: &'a Drillstring,
        (bending, support): (&'a Bending, SurfaceSupport),
        sites: &'a Sites,
        parameters: &'a FiniteElement,
        sampling_frequency: f64,
    ) -> Self {
        Self {
            string,
            bending,
            support,
            sites,
            parameters,
            sampling_frequency,
            nodes: [Channel::Torsion, Channel::Bending].map(|channel| {
                most_elements(string, channel, sites, parameters.elements_per_cell) + 1.0
            }),
        }
    }

    /// Memory that building takes, and what it keeps.
    fn need(&self) -> Need {
        let ([turned, bent], sites) = (self.nodes, self.sites.len());
        let times = if has_springs(self.sites) { 2.0 } else { 1.0 };
        let kept = SteppedChannel::<1, 1>::bytes(self.string, turned, sites)
            + times * SteppedChannel::<2, 2>::bytes(self.string, bent, sites);
        Need {
            peak: kept + assembled_bytes(self.string, turned.max(bent)),
            kept,
        }
    }

    /// Bytes of the elements.
    pub fn kept_bytes(&self) -> f64 {
        self.need().kept
    }

    /// Bytes of a case that is stepped.
    pub fn motion_bytes(&self) -> f64 {
        let [turned, bent] = self.nodes;
        SteppedChannel::<1, 1>::motion_bytes(self.string, turned)
            + SteppedChannel::<2, 2>::motion_bytes(self.string, bent)
    }

    /// What the elements take of one budget, and the responses to loads at a number of sites,
    /// which are as long as a simulation (s), of another; gives the number of their taps.
    ///
    /// # Errors
    /// Where these are too long, or take more than is left.
    pub fn ask(
        &self,
        loads: usize,
        longest_time: f64,
        (elements, responses): (&Budget, &Budget),
    ) -> Result<usize, BuildError> {
        let taps = taps_of(longest_time, self.sampling_frequency)?;
        elements.pass(self.need(), What::Elements)?;
        let bytes = response_bytes(self.sites.len(), loads, taps);
        responses.reserve(bytes, What::Responses)?.keep();
        Ok(taps)
    }

    /// Divides the string.
    ///
    /// # Errors
    /// Where the sites are not the string's, parameters are out of range, the elements would be
    /// too many or cannot be factorised, or more memory is needed than is left.
    pub fn build(&self, budget: &Budget) -> Result<SteppedString, BuildError> {
        let Self {
            string,
            bending,
            support,
            sites,
            parameters,
            sampling_frequency: frequency,
            ..
        } = *self;
        let working = budget.begin(self.need(), What::Elements)?;
        let (torsion, surface) = turned(string, sites, parameters, frequency)?;
        // Elements that are stepped need no springs, their responses do.
        let bent = |sites: &Sites| -> Result<SteppedChannel<2, 2>, BuildError> {
            Ok(bent(string, bending, support, sites, parameters, frequency)?.0)
        };
        let held = has_springs(sites).then(|| bent(sites)).transpose()?;
        let bending = bent(&sites.without_springs())?;
        working.done();
        Ok(SteppedString {
            string: string.id(),
            parameters: *parameters,
            sites: sites.clone(),
            sampling_frequency: frequency,
            surface,
            torsion,
            bending,
            held,
        })
    }
}

/// Whether springs hold any of the sites.
fn has_springs(sites: &Sites) -> bool {
    sites.springs().iter().any(|spring| *spring > 0.0)
}

/// Bytes of responses of sites from the surface and, in torsion and in bending, from loads.
fn response_bytes(sites: usize, loads: usize, taps: usize) -> f64 {
    REAL * (sites * (1 + 2 * loads) * taps) as f64
}

impl SteppedString {
    /// Divides a string into elements, however much memory that takes ([`SteppedPlan`] asks for
    /// it).
    ///
    /// # Errors
    /// As [`SteppedPlan::build`].
    pub fn new(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
        sites: &Sites,
        parameters: &FiniteElement,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        let bends = (bending, support);
        SteppedPlan::new(string, bends, sites, parameters, sampling_frequency)
            .build(&Budget::unlimited())
    }

    /// In torsion: from torques, N m, to speeds, rad/s.
    pub fn torsion(&self) -> &SteppedChannel<1, 1> {
        &self.torsion
    }

    /// In bending, along x and along y: from forces, N, to displacements, m.
    pub fn bending(&self) -> &SteppedChannel<2, 2> {
        &self.bending
    }

    /// The responses of all sites from the surface and from loads at some of the sites, by
    /// number, as long as a simulation; without any, those in torsion alone. In bending they are those of a
    /// string that the springs of its sites hold.
    ///
    /// # Errors
    /// Where a site does not exist, or the responses would be too long.
    pub fn responses(&self, loads: &[usize], longest_time: f64) -> Result<Responses, BuildError> {
        self.responses_within(loads, longest_time, &Budget::unlimited())
    }

    /// The same, within a budget.
    ///
    /// # Errors
    /// As [`SteppedString::responses`], and where more memory is needed than is left.
    pub fn responses_within(
        &self,
        loads: &[usize],
        longest_time: f64,
        budget: &Budget,
    ) -> Result<Responses, BuildError> {
        let sites = self.sites.len();
        if let Some(&site) = loads.iter().find(|&&site| site >= sites) {
            return Err(BuildError::NoSuchSite { site, sites });
        }
        let count = taps_of(longest_time, self.sampling_frequency)?;
        let bytes = response_bytes(sites, loads.len(), count);
        budget.reserve(bytes, What::Responses)?.keep();
        let method = Method::FiniteElement(self.parameters);
        let pulled = self.surface.torques(count, &self.weights()?);
        let torsion = ChannelResponses {
            channel: Channel::Torsion,
            loads: loads.to_vec(),
            from_surface: self.torsion.driven_from_above(&pulled),
            from_loads: from_loads(&self.torsion, loads, count),
            ending: Ending::Cut,
        };
        let bending = (!loads.is_empty()).then(|| ChannelResponses {
            channel: Channel::Bending,
            loads: loads.to_vec(),
            from_surface: Vec::new(),
            from_loads: from_loads(self.held.as_ref().unwrap_or(&self.bending), loads, count),
            ending: Ending::Cut,
        });
        Ok(Responses {
            string: self.string,
            method,
            sites: self.sites.clone(),
            sampling_frequency: self.sampling_frequency,
            longest_time,
            channels: std::iter::once(torsion).chain(bending).collect(),
        })
    }

    fn weights(&self) -> Result<Weights, BuildError> {
        Weights::new(&self.parameters, self.sampling_frequency)
    }
}

/// `[site][load]`, from a unit load in the first step.
fn from_loads<const FREEDOMS: usize, const PLANES: usize>(
    channel: &SteppedChannel<FREEDOMS, PLANES>,
    loads: &[usize],
    count: usize,
) -> Vec<Vec<Vec<f64>>> {
    let mut found = vec![Vec::with_capacity(loads.len()); channel.sites()];
    for &load in loads {
        for (found, taps) in found.iter_mut().zip(channel.taps_from(load, count)) {
            found.push(taps);
        }
    }
    found
}
