//! Poles before they are built, and the memory that they ask for.

use super::BendingPoles;
use super::elements::Elements;
use super::rates::Rates;
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::{Budget, Need, REAL, What};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::elements::beam;
use crate::elements::mesh::{Mesh, most_elements};
use crate::error::BuildError;
use crate::method::Method;
use crate::responses::{ChannelRequest, Request, ResponsePlan, Responses};
use crate::sites::Sites;

/// Modes that are taken up to this multiple of the sampling frequency: with those up to half of it taps are
/// half as near to the string's again, with those up to all of it no nearer.
const MODES_TO: f64 = 0.7;

/// Elements in a cell of drillpipe.
const ELEMENTS_PER_CELL: usize = 20;

/// Elements, at most: the modes of twice as many degrees of freedom take some seconds.
const MOST_ELEMENTS: usize = 1000;

/// Full matrices of all degrees of freedom that are held at once: what is assembled, its modes, and what
/// finding these takes.
const MATRICES: f64 = 10.0;

/// Coordinates of a projection for each degree of freedom, at most, and full matrices of these.
const COORDINATES: f64 = 2.0;

/// Poles of a string before they are built.
#[derive(Debug, Clone, Copy)]
pub struct PolePlan<'a> {
    string: &'a Drillstring,
    bending: &'a Bending,
    support: SurfaceSupport,
    sites: &'a Sites,
    sampling_frequency: f64,
    /// At most.
    freedoms: f64,
}

impl<'a> PolePlan<'a> {
    /// Those of a string between its sites, for steps of a sampling frequency, Hz.
    ///
    /// # Errors
    /// Where the sites are not the string's, it cannot bend so, or it would need too many elements.
    pub fn new(
        string: &'a Drillstring,
        (bending, support): (&'a Bending, SurfaceSupport),
        sites: &'a Sites,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        sites.check(string)?;
        bending.check()?;
        let elements = most_elements(string, Channel::Bending, sites, ELEMENTS_PER_CELL);
        if elements > MOST_ELEMENTS as f64 {
            let most = MOST_ELEMENTS;
            return Err(BuildError::TooManyElements { elements, most });
        }
        Ok(Self {
            string,
            bending,
            support,
            sites,
            sampling_frequency,
            freedoms: 2.0 * (elements + 1.0),
        })
    }

    /// What building takes of a budget, and keeps.
    pub(crate) fn need(&self) -> Need {
        let kept = self.kept_bytes();
        let projected = COORDINATES * self.freedoms;
        let full = MATRICES * REAL * (self.freedoms * self.freedoms + projected * projected);
        Need {
            peak: kept + full,
            kept,
        }
    }

    /// Bytes of the poles, at most.
    pub fn kept_bytes(&self) -> f64 {
        BendingPoles::bytes(self.sites.len() as f64, self.most_poles())
    }

    /// Number of poles, at most.
    pub fn most_poles(&self) -> f64 {
        COORDINATES * self.freedoms
    }

    /// Asks a budget for what building takes.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), BuildError> {
        Ok(budget.pass(self.need(), What::Elements)?)
    }

    /// Builds them.
    ///
    /// # Errors
    /// Where the string buckles, or its poles are not found or not passive, or more memory is needed than is
    /// left.
    pub fn build(&self, budget: &Budget) -> Result<BendingPoles, BuildError> {
        let working = budget.begin(self.need(), What::Elements)?;
        let mesh = Mesh::new(self.string, Channel::Bending, self.sites, ELEMENTS_PER_CELL)?;
        let matrices =
            beam::assemble(self.string, self.bending, self.support, (&mesh, self.sites))?;
        let held = self.support.held();
        let places = mesh.site_nodes.iter().map(|node| 2 * node - held);
        let fastest = std::f64::consts::TAU * MODES_TO * self.sampling_frequency;
        let projected = Elements::of(&matrices, places.collect()).projected(fastest)?;
        drop(matrices);
        let found = Rates::of(&projected)?.held(self.sampling_frequency)?;
        working.done();
        found.nearer_to(&self.held(budget)?)
    }

    /// The first response by [`Method::Held`] between all sites.
    fn held(&self, budget: &Budget) -> Result<Responses, BuildError> {
        let request = Request {
            sites: self.sites.clone(),
            channels: vec![ChannelRequest::Bending {
                bending: *self.bending,
                support: self.support,
            }],
            sampling_frequency: self.sampling_frequency,
            longest_time: 0.0,
        };
        ResponsePlan::new(self.string, &Method::Held, &request)?.build(&budget.part())
    }
}
