//! Bending moments and displacements along a string from the forces at its sites, by any method.
//!
//! At places that bear no force these follow from the forces as at sites, M(k) = Σ A(k − n) F(n), so
//! that they may be found after a simulation, of the forces that were recorded. A force that lasts
//! bends a cantilever at its tip, whose moment grows straight towards the end that is held:
//!
//! ```
//! use linear::{
//!     Bending, Budget, ChannelRequest, Drillstring, Material, Method, PlacePlan, PlaceQuantity, Request,
//!     Section, Sites, SurfaceSupport, Tube,
//! };
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 2, parts: vec![pipe] }], 0.0)?;
//! let bending = Bending { youngs_modulus: 210e9, damping: 80.0, compression: 0.0 };
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Bending { bending, support: SurfaceSupport::Clamped }],
//!     sampling_frequency: 200.0,
//!     longest_time: 20.0,
//! };
//! let places = (PlaceQuantity::Moment, &[15.0, 5.0][..]);
//! let plan = PlacePlan::new(&string, &Method::Held, &request, places)?;
//! let moments = plan.build(&Budget::unlimited())?;
//! for (distance, taps) in moments.places.iter().zip(&moments.from_forces) {
//!     let lasting: f64 = taps[0].iter().sum();
//!     assert!((lasting / distance - 1.0).abs() < 1e-4);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bending::{BendingPlan, Wanted};
use super::length::taps_of;
use super::place_quantity::PlaceQuantity;
use super::request::{ChannelRequest, Request};
use crate::budget::{Budget, Need, OutOfBudget, REAL, What};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::Method;
use crate::poles::PolePlan;
use crate::sites::{Sites, SitesAndPlaces};

/// What forces at sites make of a quantity at places.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaceResponses {
    /// Distances of the places from the bit, m, from the surface down.
    pub places: Vec<f64>,
    /// `from_forces[place][site]`: taps of the quantity at a place from a force at a site, m/N or N m/N.
    /// By methods that hold loads over a step, means over a step.
    pub from_forces: Vec<Vec<Vec<f64>>>,
}

/// The same before they are built.
#[derive(Debug)]
pub struct PlacePlan<'a> {
    /// From the surface down.
    places: Vec<f64>,
    request: &'a Request,
    made: Made<'a>,
}

/// What responses at places are made of.
#[derive(Debug)]
enum Made<'a> {
    /// Waves or elements, for as many places at a time as there are sites: these take the memory at most that
    /// displacements do.
    InParts(Vec<BendingPlan<'a>>),
    /// Poles, of a number of taps.
    OfPoles(PolePlan<'a>, usize),
}

impl<'a> PlacePlan<'a> {
    /// By one method, from forces at the sites of a request, whose bending it says, at places by
    /// their distances from the bit (m).
    ///
    /// # Errors
    /// Where the request does not bend, there are no places, or two are one, or as
    /// [`crate::ResponsePlan::new`].
    pub fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        (quantity, places): (PlaceQuantity, &[f64]),
    ) -> Result<Self, BuildError> {
        request.check(string)?;
        let bends = request.channels.iter().find_map(|channel| match channel {
            ChannelRequest::Bending { bending, support } => Some((bending, *support)),
            _ => None,
        });
        let bends = bends.ok_or(BuildError::NoBending)?;
        let places = Sites::new(string, places)?.distances_from_bit().to_vec();
        if (*method, quantity) == (Method::Poles, PlaceQuantity::Displacement) {
            let rate = request.sampling_frequency;
            let made = Made::OfPoles(
                PolePlan::new(string, bends, &request.sites, rate)?,
                taps_of(request.longest_time, rate)?,
            );
            return Ok(Self {
                places,
                request,
                made,
            });
        }
        // Cut at all places, so that nothing depends on which others are found with it.
        let cut = request.sites.with_places(string, &places)?;
        let parts = cut.places.chunks(request.sites.len()).map(|places| {
            let cut = SitesAndPlaces {
                places: places.to_vec(),
                ..cut.clone()
            };
            let wanted = Wanted::AtPlaces(quantity, cut);
            BendingPlan::new(string, method, request, bends, wanted)
        });
        Ok(Self {
            places,
            request,
            made: Made::InParts(parts.collect::<Result<_, _>>()?),
        })
    }

    /// Taps of each response.
    pub fn taps(&self) -> usize {
        match &self.made {
            Made::InParts(parts) => parts.first().map_or(0, BendingPlan::taps),
            Made::OfPoles(_, taps) => *taps,
        }
    }

    /// What building takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(self.need(), What::Responses)
    }

    fn need(&self) -> Need {
        match &self.made {
            Made::InParts(parts) => {
                let each = parts.iter().map(BendingPlan::need);
                each.fold(Need::default(), Need::then)
            }
            Made::OfPoles(poles, taps) => {
                let responses = self.places.len() * self.request.sites.len();
                let kept = REAL * (responses * taps) as f64;
                poles.need().then(Need::lasting(kept))
            }
        }
    }

    /// Builds the responses.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::build`].
    pub fn build(&self, budget: &Budget) -> Result<PlaceResponses, BuildError> {
        let parts = match &self.made {
            Made::InParts(parts) => parts,
            Made::OfPoles(poles, _) => {
                let poles = poles.seen_at(&self.places).build(budget)?;
                return poles.place_responses(self.request.longest_time);
            }
        };
        let working = budget.begin(self.need(), What::Responses)?;
        let mut from_forces = Vec::with_capacity(self.places.len());
        for part in parts {
            let mut taps = part.taps_of_pairs()?.into_iter().peekable();
            while taps.peek().is_some() {
                let sites = self.request.sites.len();
                from_forces.push(taps.by_ref().take(sites).collect());
            }
        }
        working.done();
        Ok(PlaceResponses {
            places: self.places.clone(),
            from_forces,
        })
    }
}
