//! Newmark's scheme without stepping it: what its recurrence makes of generating functions.
//!
//! From rest, each step n has M a(n) + C v(n) + K u(n) = f(n), and Eqs. 64 and 65 tie
//! displacement u and velocity v to the accelerations up to then. For the generating
//! functions A(ζ) = Σ a(n) ζⁿ, U(ζ), V(ζ), F(ζ) that is (1 − ζ) V = h (γ + (1 − γ) ζ) A and
//! (1 − ζ)² U = h² (β + (½ + γ − 2β) ζ + (½ − γ + β) ζ²) A, so that each element has the
//! dynamic stiffness K + (V/U) C + (A/U) M at every ζ, and the string is joined from its
//! elements as it is from waves: equal beams and cells by doubling, those of a tube in torsion
//! in closed form. The taps, U of a unit force in the
//! first step, are what stepping gives ([`super::reduction`]), up to rounding.

use super::beam::{dashpot, mass_matrix, stiffness_matrix};
use super::mesh::{check_number, divided, longest_element};
use super::newmark::Weights;
use super::torsion::Element;
use crate::assembly::bending::Beam;
use crate::assembly::block::Block;
use crate::assembly::chain::{Ends, Stiffness};
use crate::assembly::matrix::ResponseMatrix;
use crate::assembly::nodes::Relation;
use crate::assembly::number::Number;
use crate::assembly::stiff_beam::{StiffBeam, turns};
use crate::assembly::torsion::{AtSurface, Drive, DynamicStiffness, TorsionAdmittance};
use crate::assembly::{bending, chain, torsion};
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::distributed_loss::{LossAlong, tubes};
use crate::drillstring::{Drillstring, Tube};
use crate::error::BuildError;
use crate::loss::Fit;
use crate::sites::{AtSite, Sites, SitesAndPlaces};
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// Velocity and acceleration per displacement at one ζ, and the rate 2(1 − ζ)/(h(1 + ζ)) of what
/// is stepped by the trapezoidal rule, rad/s: loss with a memory, which that keeps passive.
#[derive(Debug, Clone, Copy)]
struct Rates<T> {
    velocity: T,
    acceleration: T,
    trapezoidal: T,
    /// A step later.
    zeta: T,
}

impl<T: Number> Rates<T> {
    /// Those of the scheme at |ζ| < 1.
    fn at(weights: &Weights, zeta: T) -> Self {
        let Weights { gamma, beta, step } = *weights;
        let advance = -zeta + 1.0;
        let in_velocity = zeta * (1.0 - gamma) + gamma;
        let in_displacement =
            zeta * (zeta * (0.5 - gamma + beta) + (0.5 + gamma - 2.0 * beta)) + beta;
        let per_step = advance * (in_displacement * step).inverse();
        Self {
            velocity: per_step * in_velocity,
            acceleration: per_step * advance * step.recip(),
            trapezoidal: advance * (zeta + 1.0).inverse() * (2.0 / step),
            zeta,
        }
    }
}

/// A string cut at its sites, its tubes to be divided into elements.
#[derive(Debug)]
pub(crate) struct ElementChain<'a> {
    string: &'a Drillstring,
    spans: Vec<SurroundedSpan>,
    /// Spring and mass at each site besides the string, in bending.
    at_sites: Vec<AtSite>,
    longest: f64,
    weights: Weights,
    loss: LossAlong<Fit>,
}

impl<'a> ElementChain<'a> {
    /// Divides the string as [`super::mesh`] does.
    ///
    /// # Errors
    /// Where the sites are not the string's, or the elements would be too many.
    pub fn new(
        string: &'a Drillstring,
        channel: Channel,
        sites: &Sites,
        elements_per_cell: usize,
        weights: Weights,
    ) -> Result<Self, BuildError> {
        let spans = string.surrounded_spans(channel, sites)?;
        let longest = longest_element(string, elements_per_cell);
        check_number(&spans, longest)?;
        Ok(Self {
            string,
            loss: LossAlong::fitted(string, channel, tubes(&spans)),
            spans,
            at_sites: sites.loads(),
            longest,
            weights,
        })
    }

    /// In bending: displacements at the sites from forces there, m/N.
    pub fn receptance<T: Number>(
        &self,
        bending: &Bending,
        support: SurfaceSupport,
        zeta: T,
    ) -> ResponseMatrix<T> {
        let rates = Rates::at(&self.weights, zeta);
        let at_sites = bending::at_sites(&self.at_sites, rates.acceleration);
        bending::reduce(self.beams(bending, rates), &at_sites, support)
    }

    /// In bending: moments at some places (row) from forces at the sites (column), N m/N, of a string
    /// cut at both, as its elements are in equilibrium.
    pub fn moments<T: Number>(
        &self,
        bending: &Bending,
        support: SurfaceSupport,
        zeta: T,
        cut: &SitesAndPlaces,
    ) -> Vec<T> {
        let rates = Rates::at(&self.weights, zeta);
        let at_sites = bending::at_sites(&self.at_sites, rates.acceleration);
        bending::moments(self.beams(bending, rates), &at_sites, support, cut)
    }

    fn beams<T: Number>(
        &self,
        bending: &Bending,
        rates: Rates<T>,
    ) -> impl Iterator<Item = Option<Beam<T>>> {
        let loss = self.loss.at(|| rates.trapezoidal);
        let tube = move |around: Surroundings, tube: &Tube| {
            let (count, element) = divided(tube, self.longest);
            // The mass that is moved aside however fast is mass to the scheme as well.
            let mass = self.string.mass_sideways(tube, around.hole_radius);
            let loss = (loss.drag_on(tube, around.hole_radius), loss.stiffening());
            let element = beam_element(&bending.under(around.tension), &element, mass, rates, loss);
            Beam::of(element).repeated(count)
        };
        chain::hanging(&self.spans, tube)
    }
}

impl ElementChain<'_> {
    /// In torsion: rotation speeds at the sites from the surface's and from torques, at ζ,
    /// |ζ| < 1.
    pub fn admittance<T: Number>(&self, zeta: T) -> TorsionAdmittance<T> {
        let rates = Rates::at(&self.weights, zeta);
        let drive = self.drive(rates);
        torsion::reduce(self.rows(rates), self.at_sites.len(), T::real(1.0), drive)
    }

    /// How the surface moves below its drive; `None` without one.
    pub fn at_surface<T: Number>(&self, zeta: T) -> Option<AtSurface<T>> {
        let rates = Rates::at(&self.weights, zeta);
        let drive = self.drive(rates)?;
        let (rows, rate) = (self.rows(rates), T::real(1.0));
        Some(torsion::at_surface(rows, self.at_sites.len(), rate, drive))
    }

    /// Torque with which the surface has to be turned per unit of the speed that it is set to,
    /// no torque acting below, N m s/rad.
    pub fn surface_torque<T: Number>(&self, zeta: T) -> T {
        let rates = Rates::at(&self.weights, zeta);
        torsion::torque_at_surface(self.rows(rates), self.drive(rates))
    }

    /// Elements between nodes and the drive, torques per speed, at ζ, |ζ| < 1.
    pub fn rows_and_drive<T: Number>(
        &self,
        zeta: T,
    ) -> (
        impl Iterator<Item = Option<DynamicStiffness<T>>>,
        Option<Drive<T>>,
    ) {
        let rates = Rates::at(&self.weights, zeta);
        (self.rows(rates), self.drive(rates))
    }

    /// Elements between nodes, torques per speed.
    fn rows<T: Number>(
        &self,
        rates: Rates<T>,
    ) -> impl Iterator<Item = Option<DynamicStiffness<T>>> {
        let loss = self.loss.at(|| rates.trapezoidal);
        let tube = move |around: Surroundings, tube: &Tube| {
            let loss = (loss.drag_on(tube, around.hole_radius), loss.stiffening());
            torsion_row(self.string, divided(tube, self.longest), rates, loss)
        };
        (self.spans.iter()).map(move |span| chain::surrounded(span, Ends::Both, &tube))
    }

    fn drive<T: Number>(&self, rates: Rates<T>) -> Option<Drive<T>> {
        self.string.top_drive().map(|drive| {
            let rotation = rates.velocity.inverse();
            let acceleration = rates.acceleration * rotation;
            let late = torsion::late_in_steps(&drive, rates.zeta, self.weights.step);
            Drive::of(&drive, [acceleration, T::real(1.0), rotation], late)
        })
    }
}

/// Elements of a tube in a row, torques per speed.
fn torsion_row<T: Number>(
    string: &Drillstring,
    (count, tube): (usize, Tube),
    rates: Rates<T>,
    (mud, stiffening): (Option<T>, Option<T>),
) -> DynamicStiffness<T> {
    let Element {
        inertia,
        spring,
        dashpot,
    } = Element::of(string, &tube);
    // At either node a third of the inertia, and a sixth with the other node's.
    let per_speed = rates.velocity.inverse();
    let in_speed = rates.acceleration * per_speed;
    let mut alike = in_speed * (inertia / 2.0) + dashpot;
    let mut twisted = per_speed * (2.0 * spring);
    if let Some(stiffening) = stiffening {
        twisted = twisted * stiffening;
    }
    let mut opposite = in_speed * (inertia / 6.0) + twisted + dashpot;
    if let Some(mud) = mud {
        let mud = mud * (0.5 * tube.length);
        (alike, opposite) = (alike + mud, opposite + mud);
    }
    DynamicStiffness::row(alike, opposite, count)
}

fn beam_element<T: Number>(
    bending: &Bending,
    tube: &Tube,
    mass_per_length: f64,
    rates: Rates<T>,
    (mud, stiffening): (Option<T>, Option<T>),
) -> StiffBeam<T> {
    let mass = mass_matrix(tube, mass_per_length);
    let mut damping = rates.velocity * dashpot(tube, bending);
    if let Some(mud) = mud {
        damping = damping + rates.velocity * mud * (0.5 * tube.length);
    }
    // Of inertia and dashpots, which a rigid motion meets in full.
    let carried = |row: usize, column: usize| {
        Block([0, 1].map(|i| {
            [0, 1].map(|j| {
                let inertia = rates.acceleration * mass[2 * row + i][2 * column + j];
                let is_damped = row == column && (i, j) == (0, 0);
                if is_damped {
                    inertia + damping
                } else {
                    inertia
                }
            })
        }))
    };
    let (length, cross, bottom) = (tube.length, carried(0, 1), carried(1, 1));
    let (along, zero) = (bottom.carried(length), T::real(0.0));
    // It takes no force to carry a beam along, but for what a compressed one pushes aside.
    let [aside, about] = [1.0, length].map(|arm| T::real(-bending.compression * arm));
    let stiffness = stiffness_matrix(tube, bending);
    let mut elastic = Block([2, 3].map(|i| [2, 3].map(|j| T::real(stiffness[i][j]))));
    if let Some(stiffening) = stiffening {
        // Of the modulus alone, not of what compression takes from it.
        let own = stiffness_matrix(tube, &bending.straight());
        let own = Block([2, 3].map(|i| [2, 3].map(|j| T::real(own[i][j]))));
        elastic = elastic + own.multiplied(stiffening - 1.0);
    }
    let mixed = cross.transpose() + along;
    let inertia = rates.acceleration * mass_per_length;
    let mut foundation = inertia + rates.velocity * bending.damping;
    if let Some(mud) = mud {
        foundation = foundation + rates.velocity * mud;
    }
    StiffBeam {
        length,
        turns: turns(bending, tube, foundation),
        elastic: elastic + bottom,
        mixed: mixed + Block([[zero, aside], [zero, zero]]),
        rigid: carried(0, 0)
            + cross.carried(length)
            + mixed.moved(length)
            + Block([[zero, zero], [zero, about]]),
    }
}
