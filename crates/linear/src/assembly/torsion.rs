//! Pieces of string in torsion, joined and reduced to the surface and the sites
//! (Eqs. 12–13, 41–48).
//!
//! Stiffnesses of waves relate *rotations* to external torques, both positive in the positive
//! direction of rotation. Dividing by s gives the paper's relation between rotation speeds
//! and torques; the rotation form is finite at s = 0, where the static limit lives. Elements
//! and lattices relate speeds to torques, as their steps do: `reduce` takes either.

use num_complex::Complex64;

use super::chain::{Stiffness, hung};
use super::matrix::ResponseMatrix;
use super::nodes::{Nodes, Piece, StiffnessBetween};
use super::number::Number;
use crate::top_drive::TopDrive;

/// Dynamic stiffness of a piece of string in torsion: torques per rotation, N m/rad, or, where
/// a scheme in time makes them so, torques per speed, N m s/rad.
pub type DynamicStiffness<T = Complex64> = Piece<T>;

impl<T: Number> DynamicStiffness<T> {
    /// A number of equal pieces in a row, each as stiff from above as from below, from the
    /// torque on either end of one where both turn alike, and where they turn against one
    /// another. With p and m their roots, a row has the characteristic impedance pm, and a
    /// wave that goes down it is multiplied by (m − p)/(m + p) from node to node. What turns
    /// a short piece as a rigid body is so far less than what twists it that joining pieces
    /// one by one would lose it to rounding.
    #[inline(always)]
    pub fn row(alike: T, opposite: T, pieces: usize) -> Self {
        let sum = opposite + alike;
        if pieces == 1 {
            return Self {
                top: sum * 0.5,
                cross: (alike - opposite) * 0.5,
                bottom: sum * 0.5,
            };
        }
        // Of both roots that under which waves do not grow.
        let impedance = (alike * opposite).root().towards(sum);
        let both_squared = sum + impedance * 2.0;
        let step = (opposite - alike) * both_squared.inverse();
        let (passed, passed_squared, powers) = powers(step, pieces);
        // 1 − passed² = 4pm (1 + step² + … )/(m + p)²: a difference would lose digits.
        let scale = both_squared * powers.inverse() * 0.25;
        let driving = scale * (passed_squared + 1.0);
        Self {
            top: driving,
            cross: scale * passed * -2.0,
            bottom: driving,
        }
    }
}

/// The power zⁿ, its square, and 1 + z² + … of n terms, by doubling.
#[inline(always)]
fn powers<T: Number>(z: T, n: usize) -> (T, T, T) {
    let mut power = T::real(1.0);
    let (mut squared, mut sum) = (power, T::real(0.0));
    for bit in (0..usize::BITS - n.leading_zeros()).rev() {
        sum = sum * (squared + 1.0);
        power = squared;
        squared = power * power;
        if n >> bit & 1 == 1 {
            sum = sum + squared;
            power = power * z;
            squared = power * power;
        }
    }
    (power, squared, sum)
}

impl<T: Number> Stiffness for DynamicStiffness<T> {
    #[inline(always)]
    fn join(&self, lower: &Self) -> Self {
        self.joined(lower)
    }

    /// Where pieces meet, the top of one and the bottom of another add up to what two ends
    /// alike do: a piece that is stiffer from above is so at the top of the row alone.
    #[inline(always)]
    fn repeated(&self, count: usize) -> Self {
        match count {
            1 => return *self,
            // A few joins take less time than a row.
            2 => return self.join(self),
            3 => return self.join(self).join(self),
            _ => {}
        }
        let mean = (self.top + self.bottom) * 0.5;
        let stiffer = (self.top - self.bottom) * 0.5;
        let row = Self::row(mean + self.cross, mean - self.cross, count);
        Self {
            top: row.top + stiffer,
            bottom: row.bottom - stiffer,
            ..row
        }
    }
}

/// What drives the upper end of a string whose motion there is not prescribed: its torque is
/// `holds` times the motion it is set to, less `opposes` times its own.
#[derive(Debug, Clone, Copy)]
pub struct Drive<T> {
    /// Torque per set motion.
    pub holds: T,
    /// Torque per own motion.
    pub opposes: T,
    /// The motor's share of that.
    pub motor: T,
}

impl<T: Number> Drive<T> {
    /// That of a top drive, from the acceleration, speed and rotation that belong to a unit of
    /// motion, and what a delay makes of these, where its controller has one.
    pub fn of(drive: &TopDrive, [acceleration, speed, rotation]: [T; 3], late: Option<T>) -> Self {
        let holds = speed * drive.proportional_gain + rotation * drive.integral_gain;
        let inert = acceleration * drive.inertia;
        let (inert, motor) = late.map_or((inert, holds), |late| {
            let not_yet = acceleration * drive.late_inertia * (-late + 1.0);
            (inert + not_yet, holds * late)
        });
        Self {
            holds,
            opposes: inert + motor,
            motor,
        }
    }
}

/// What a delay of a drive's controller makes of the motion that it measures, e^(−s τ), where it has
/// one.
pub fn late<T: Number>(drive: &TopDrive, s: T) -> Option<T> {
    let is_late = drive.delay > 0.0;
    is_late.then(|| s.each(|s| (-drive.delay * s).exp()))
}

/// The same in steps of a time (s), at the delay ζ of one: straight on between two of them.
pub fn late_in_steps<T: Number>(drive: &TopDrive, zeta: T, step: f64) -> Option<T> {
    let steps = drive.delay / step;
    let (whole, part) = (steps.floor(), steps.fract());
    let late = |zeta: Complex64| zeta.powi(whole as i32) * (zeta * part + (1.0 - part));
    (drive.delay > 0.0).then(|| zeta.each(late))
}

/// The frequency response D of Eq. 48 between surface and sites.
#[derive(Debug, Clone)]
pub struct TorsionAdmittance<T = Complex64> {
    /// Speed at each site per unit speed of the surface, or per unit of the speed that its
    /// drive is set to (dimensionless).
    pub from_surface: Vec<T>,
    /// Speed at each site (row) per unit external torque at each site
    /// (column), rad/s per N m.
    pub from_torque: ResponseMatrix<T>,
}

/// The torque with which the surface has to be turned per motion that it is set to (the top row
/// of D in Eq. 48), no torque acting below; of pieces from the surface down.
pub fn torque_at_surface<T: Number>(
    pieces: impl Iterator<Item = Option<DynamicStiffness<T>>>,
    drive: Option<Drive<T>>,
) -> T {
    let whole = hung(pieces.flatten());
    // Below its lower end there is nothing.
    let resists = whole.map_or(T::zero(), |whole| whole.above(T::zero()));
    match drive {
        None => resists,
        // What the set motion does, less what the drive's own takes of it.
        Some(drive) => {
            let own = drive.motor * (drive.opposes + resists).inverse();
            drive.holds * (-own + 1.0)
        }
    }
}

/// How a string below its drive moves at the surface, and answers a torque there.
#[derive(Debug, Clone)]
pub struct AtSurface<T = Complex64> {
    /// Speed of the surface per unit of the speed that its drive is set to (dimensionless).
    pub by_set: T,
    /// Speed of the surface per torque there, rad/s per N m.
    pub by_torque: T,
    /// Speed of each site per torque at the surface, rad/s per N m.
    pub sites_by_torque: Vec<T>,
}

/// The same of pieces from the surface down, with a drive above them; a speed is `rate` times the
/// motion that stiffnesses are of.
pub fn at_surface<T: Number>(
    pieces: impl Iterator<Item = Option<DynamicStiffness<T>>>,
    sites: usize,
    rate: T,
    drive: Drive<T>,
) -> AtSurface<T> {
    let pieces: Vec<_> = pieces.collect();
    let whole = hung(pieces.iter().copied().flatten());
    let resists = whole.map_or(T::zero(), |whole| whole.above(T::zero()));
    let moved = (drive.opposes + resists).inverse();
    // A drive that turned the surface with the set motion itself would be that torque.
    let as_torque = Drive {
        holds: rate,
        ..drive
    };
    AtSurface {
        by_set: drive.holds * moved,
        by_torque: rate * moved,
        sites_by_torque: reduce(pieces.into_iter(), sites, rate, Some(as_torque)).from_surface,
    }
}

/// Nodes of a string below its surface, which answer one by one.
#[derive(Debug, Clone)]
pub(crate) struct Driven<T> {
    nodes: Nodes<T>,
    /// Motion of the first per set motion of the surface.
    by_surface: T,
    rate: T,
    sites: usize,
}

impl<T: Number> Driven<T> {
    /// Nodes from the surface down, of which the first `sites` are sites: each hangs from the one
    /// above by a piece, `None` where there is nothing. Stiffnesses are torques per motion, and a
    /// speed is `rate` times that motion. Without a drive the surface turns as prescribed.
    pub fn new(
        mut pieces: impl Iterator<Item = Option<DynamicStiffness<T>>>,
        sites: usize,
        rate: T,
        drive: Option<Drive<T>>,
    ) -> Self {
        let uppermost = pieces.next().flatten();
        let pieces: Vec<_> = pieces.collect();
        let (pull, above) = match (uppermost, drive) {
            (None, _) => (T::zero(), T::zero()),
            (Some(piece), None) => (-piece.cross, piece.bottom),
            (Some(piece), Some(drive)) => {
                let way = drive.holds * (drive.opposes + piece.top).inverse();
                (-(piece.cross * way), piece.below(drive.opposes))
            }
        };
        let nodes = Nodes::new(above, &pieces);
        let first = nodes.moved_by_load(0).next();
        Self {
            by_surface: first.map_or(T::zero(), |compliance| pull * compliance),
            nodes,
            rate,
            sites,
        }
    }

    /// Number of sites.
    pub fn sites(&self) -> usize {
        self.sites
    }

    /// Speed of each site per speed that the surface is set to.
    pub fn turned_by_surface(&self) -> impl Iterator<Item = T> {
        let nodes = self.nodes.carried_from(0, self.by_surface);
        nodes.take(self.sites)
    }

    /// Speed of a site and of each below it per torque at it, rad/s per N m.
    pub fn turned_by_torque(&self, site: usize) -> impl Iterator<Item = T> {
        let moved = self.nodes.moved_by_load(site).map(|it| self.rate * it);
        moved.take(self.sites - site)
    }
}

/// The response of nodes, all sites at once, as [`Driven::new`] has them.
pub fn reduce<T: Number>(
    pieces: impl Iterator<Item = Option<DynamicStiffness<T>>>,
    sites: usize,
    rate: T,
    drive: Option<Drive<T>>,
) -> TorsionAdmittance<T> {
    let driven = Driven::new(pieces, sites, rate, drive);
    TorsionAdmittance {
        from_surface: driven.turned_by_surface().collect(),
        from_torque: ResponseMatrix::reciprocal(sites, |site| driven.turned_by_torque(site)),
    }
}

#[cfg(test)]
mod tests {
    use numerics::{Mat, equations};

    use super::*;

    fn largest(one: &DynamicStiffness) -> f64 {
        one.top.norm().max(one.bottom.norm()).max(one.cross.norm())
    }

    /// Torques per speed or per rotation, of cells that are stiffer from one side.
    #[test]
    fn a_row_is_what_joining_one_by_one_gives() {
        for index in 0..40 {
            let s = Complex64::new(0.02 * f64::from(index % 3), 0.3 * f64::from(index) + 0.1);
            let heavy = |inertia: f64| s * inertia + 0.1;
            let spring = 5.0 / s;
            let cell = DynamicStiffness {
                top: spring + heavy(0.3),
                cross: -spring,
                bottom: spring + heavy(1.2),
            };
            for per_speed in [Complex64::new(1.0, 0.0), s] {
                let cell = DynamicStiffness {
                    top: cell.top * per_speed,
                    cross: cell.cross * per_speed,
                    bottom: cell.bottom * per_speed,
                };
                let mut joined = cell;
                for count in 1..=40 {
                    let row = cell.repeated(count);
                    for (found, expected) in [
                        (row.top, joined.top),
                        (row.cross, joined.cross),
                        (row.bottom, joined.bottom),
                    ] {
                        let error = (found - expected).norm() / largest(&joined);
                        assert!(error < 1e-10, "{index} {count}: {found} {expected}");
                    }
                    joined = joined.join(&cell);
                }
            }
        }
    }

    /// The same with one matrix of all nodes but the surface.
    #[test]
    fn sites_turn_as_elimination_says() {
        let s = Complex64::new(0.1, 3.0);
        let pieces: Vec<DynamicStiffness> = (1..=4)
            .map(|index| {
                let stiff = f64::from(index) * 5.0;
                DynamicStiffness {
                    top: s * 0.7 * stiff + stiff,
                    cross: (-stiff).into(),
                    bottom: s * 0.4 + stiff,
                }
            })
            .collect();
        for sites in 1..=4 {
            for nodes in [sites, (sites + 1).min(4)] {
                let mut stiffness = Mat::<Complex64>::zeros(nodes, nodes);
                let mut loads = Mat::<Complex64>::zeros(nodes, sites + 1);
                for (node, piece) in pieces[..nodes].iter().enumerate() {
                    stiffness[(node, node)] += piece.bottom;
                    if let Some(above) = node.checked_sub(1) {
                        stiffness[(above, above)] += piece.top;
                        stiffness[(above, node)] = piece.cross;
                        stiffness[(node, above)] = piece.cross;
                    }
                }
                loads[(0, 0)] = -pieces[0].cross;
                for site in 0..sites {
                    loads[(site, site + 1)] = s;
                }
                let loads = equations::solve_complex(&stiffness, &loads);
                let found = reduce(pieces[..nodes].iter().copied().map(Some), sites, s, None);
                for row in 0..sites {
                    assert!((found.from_surface[row] - loads[(row, 0)]).norm() < 1e-12);
                    for column in 0..sites {
                        let expected = loads[(row, column + 1)];
                        assert!((found.from_torque[(row, column)] - expected).norm() < 1e-12);
                    }
                }
            }
        }
    }
}
