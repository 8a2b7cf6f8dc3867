//! Poles before they are built, and the memory that they ask for.

use super::BendingPoles;
use super::elements::Elements;
use super::rates::Rates;
use numerics::Mat;

use crate::assembly::lanes::Lanes;
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::{Budget, Need, REAL, What};
use crate::channel::Channel;
use crate::checks::check_sampling;
use crate::drillstring::Drillstring;
use crate::elements::beam;
use crate::elements::mesh::{Mesh, most_elements};
use crate::error::BuildError;
use crate::filters::held;
use crate::method::Method;
use crate::sites::Sites;
use crate::waves::lateral::BendingNetwork;

/// Modes that are taken up to this multiple of the sampling frequency: with those up to half of it taps are
/// half as near to the string's again, with those up to all of it no nearer.
const MODES_TO: f64 = 0.7;

/// The longest element, m, up to this sampling frequency, Hz: beyond it waves become shorter with the root of
/// the frequency.
const LONGEST_ELEMENT: (f64, f64) = (0.5, 640.0);

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
    /// Where displacements are seen besides, m from the bit.
    seen: &'a [f64],
    sampling_frequency: f64,
    elements_per_cell: usize,
    /// At most.
    freedoms: f64,
}

impl<'a> PolePlan<'a> {
    /// Those of a string between its sites, for steps of a sampling frequency, Hz.
    ///
    /// # Errors
    /// Where the sites are not the string's, it cannot bend so, nothing damps it, or it would need too many
    /// elements.
    pub fn new(
        string: &'a Drillstring,
        (bending, support): (&'a Bending, SurfaceSupport),
        sites: &'a Sites,
        sampling_frequency: f64,
    ) -> Result<Self, BuildError> {
        sites.check(string)?;
        bending.check()?;
        check_sampling(sampling_frequency)?;
        // A pole that nothing damps stands on the circle where steps are held to be passive.
        if bending.damping <= 0.0 && !string.loss().has_memory() {
            let (method, channel) = (Method::Poles.name(), Channel::Bending);
            return Err(BuildError::NeedsDamping { method, channel });
        }
        let (length, at) = LONGEST_ELEMENT;
        let longest = length * (at / sampling_frequency).sqrt().min(1.0);
        let elements_per_cell = (string.drillpipe().cell_length() / longest).ceil() as usize;
        let elements = most_elements(string, Channel::Bending, sites, elements_per_cell);
        if elements > MOST_ELEMENTS as f64 {
            let most = MOST_ELEMENTS;
            return Err(BuildError::TooLongForPoles { elements, most });
        }
        Ok(Self {
            string,
            bending,
            support,
            sites,
            seen: &[],
            sampling_frequency,
            elements_per_cell,
            freedoms: 2.0 * (elements + 1.0),
        })
    }

    /// The same with the displacements at some places, m from the bit, which bear no force and change no pole.
    pub fn seen_at(self, places: &'a [f64]) -> Self {
        Self {
            seen: places,
            ..self
        }
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
        let outputs = (self.sites.len() + self.seen.len()) as f64;
        BendingPoles::bytes((outputs, self.sites.len() as f64), self.most_poles())
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
        let mesh = Mesh::new(
            self.string,
            Channel::Bending,
            self.sites,
            self.elements_per_cell,
        )?;
        let matrices =
            beam::assemble(self.string, self.bending, self.support, (&mesh, self.sites))?;
        let held = self.support.held();
        let places = mesh.site_nodes.iter().map(|node| 2 * node - held);
        let seen = self.seen.iter().map(|place| {
            let depth = self.string.length() - place;
            beam::displacement_at(&mesh, depth, self.support)
        });
        let fastest = std::f64::consts::TAU * MODES_TO * self.sampling_frequency;
        let outputs = (places.collect(), seen.collect());
        let projected = Elements::of(&matrices, outputs).projected(fastest)?;
        drop(matrices);
        let found = Rates::of(&projected)?.held(self.sampling_frequency)?;
        working.done();
        found.seen_at(self.seen).nearer_to(&self.held()?)
    }

    /// A(0) by [`Method::Held`](crate::Method::Held) between all sites, m/N.
    fn held(&self) -> Result<Mat<f64>, BuildError> {
        let network = BendingNetwork::new(self.string, *self.bending, self.support, self.sites)?;
        let sites = self.sites.len();
        let row = |row: usize| (0..=row).map(move |column| (row, column));
        let pairs: Vec<(usize, usize)> = (0..sites).flat_map(row).collect();
        let velocity = |s: Lanes, values: &mut [Lanes]| {
            let receptance = network.receptance(s);
            for (value, pair) in values.iter_mut().zip(&pairs) {
                *value = s * receptance[*pair];
            }
        };
        let speeds = held::smooth_taps(self.sampling_frequency, 1, pairs.len(), &velocity);
        // A half of it in the middle of the step.
        let mut first = Mat::zeros(sites, sites);
        for ((row, column), speeds) in pairs.iter().zip(&speeds) {
            first[(*row, *column)] = 0.5 * speeds[0] / self.sampling_frequency;
            first[(*column, *row)] = first[(*row, *column)];
        }
        Ok(first)
    }
}
