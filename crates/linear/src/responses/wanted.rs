//! Which responses in torsion are wanted, and where they stand in a list.

use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::assembly::torsion::{AtSurface, Driven};
use crate::waves::TorsionAdmittance;

/// What is to be known of a string in torsion.
#[derive(Debug, Clone, Copy)]
pub(super) enum Wanted<'a> {
    /// The speeds of all sites, from the surface and from torques on some.
    Sites {
        /// Those that torques act on.
        torques: &'a [usize],
    },
    /// The torque at the surface, from its speed.
    SurfaceTorque,
    /// The speed of the surface below its drive, from the set speed and from a torque there, and the
    /// speeds of all sites from that torque.
    AtSurface,
}

/// Responses of the surface itself.
const AT_SURFACE: usize = 2;

impl<'a> Wanted<'a> {
    /// The sites that torques act on.
    pub(super) fn torques(self) -> &'a [usize] {
        match self {
            Wanted::Sites { torques } => torques,
            Wanted::SurfaceTorque | Wanted::AtSurface => &[],
        }
    }

    /// How many responses there are, for a number of sites.
    pub(super) fn count(self, sites: usize) -> usize {
        match self {
            Wanted::Sites { torques } => sites * (1 + torques.len()),
            Wanted::SurfaceTorque => 1,
            Wanted::AtSurface => AT_SURFACE + sites,
        }
    }

    /// Those of them, by place, that none before is equal to: where torques act on two sites, each
    /// answers the other's as the other does its own (reciprocity).
    pub(super) fn different(self, sites: usize) -> Vec<usize> {
        let same_as = self.same_as(sites).into_iter().enumerate();
        same_as
            .filter(|(place, same)| place == same)
            .map(|(place, _)| place)
            .collect()
    }

    /// For each the first that it is equal to, by place.
    pub(super) fn same_as(self, sites: usize) -> Vec<usize> {
        let Wanted::Sites { torques } = self else {
            return (0..self.count(sites)).collect();
        };
        let place_of = |site: usize, input: usize| sites + site * torques.len() + input;
        let reciprocal = |site: usize, input: usize| {
            let input_there = torques.iter().position(|&other| other == site)?;
            Some(place_of(torques[input], input_there))
        };
        let from_torques = (0..self.count(sites).saturating_sub(sites)).map(|pair| {
            let (site, input) = (pair / torques.len(), pair % torques.len());
            let own = place_of(site, input);
            reciprocal(site, input).map_or(own, |other| own.min(other))
        });
        let from_surface = 0..self.count(sites).min(sites);
        from_surface.chain(from_torques).collect()
    }

    /// Writes some of them, by place in rising order.
    pub(super) fn write_some<T: Number>(
        self,
        places: &[usize],
        driven: impl FnOnce() -> Driven<T>,
        surface_torque: impl FnOnce() -> T,
        at_surface: impl FnOnce() -> Option<AtSurface<T>>,
        responses: &mut [T],
    ) {
        let torques = match self {
            Wanted::Sites { torques } => torques,
            Wanted::SurfaceTorque => return responses[0] = surface_torque(),
            Wanted::AtSurface => {
                let all = all_at_surface(at_surface());
                for (response, place) in responses.iter_mut().zip(places) {
                    *response = all[*place];
                }
                return;
            }
        };
        let driven = driven();
        let sites = driven.sites();
        let of_surface = places.partition_point(|place| *place < sites);
        let first = places.first().map_or(0, |place| *place);
        for (response, speed) in
            (responses[..of_surface].iter_mut()).zip(driven.turned_by_surface().skip(first))
        {
            *response = speed;
        }
        // Most often one torque after the other, each with the sites below it.
        let (mut upper, mut speeds) = (sites, Vec::with_capacity(sites));
        for (response, place) in responses.iter_mut().zip(places).skip(of_surface) {
            let pair = place - sites;
            let (site, other) = (pair / torques.len(), torques[pair % torques.len()]);
            if upper != site.min(other) {
                upper = site.min(other);
                speeds.clear();
                speeds.extend(driven.turned_by_torque(upper));
            }
            *response = speeds[site.max(other) - upper];
        }
    }

    /// Writes all of them: of all sites from the surface, then of all sites from each torque; or the
    /// torque at the surface.
    pub(super) fn write(
        self,
        admittance: impl FnOnce() -> TorsionAdmittance<Lanes>,
        surface_torque: impl FnOnce() -> Lanes,
        at_surface: impl FnOnce() -> Option<AtSurface<Lanes>>,
        responses: &mut [Lanes],
    ) {
        let torques = match self {
            Wanted::Sites { torques } => torques,
            Wanted::SurfaceTorque => return responses[0] = surface_torque(),
            Wanted::AtSurface => return responses.copy_from_slice(&all_at_surface(at_surface())),
        };
        let admittance = admittance();
        let sites = admittance.from_surface.len();
        responses[..sites].copy_from_slice(&admittance.from_surface);
        let from_torques = (0..sites).flat_map(|site| {
            let admittance = &admittance.from_torque;
            torques.iter().map(move |&input| admittance[(site, input)])
        });
        for (response, value) in responses[sites..].iter_mut().zip(from_torques) {
            *response = value;
        }
    }
}

/// All responses at the surface, in their order; a plan for these has a drive.
fn all_at_surface<T: Number>(found: Option<AtSurface<T>>) -> Vec<T> {
    let own = |at: &AtSurface<T>| [at.by_set, at.by_torque];
    let all = found
        .iter()
        .flat_map(|at| own(at).into_iter().chain(at.sites_by_torque.clone()));
    all.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_sites_that_torques_act_on_are_made_once() {
        let torques = &[0, 2];
        let wanted = Wanted::Sites { torques };
        // From the surface; site 0 from 0 and 2, site 1 from 0 and 2, site 2 from 0 and 2.
        assert_eq!(wanted.same_as(3), [0, 1, 2, 3, 4, 5, 6, 4, 8]);
        assert_eq!(wanted.different(3), [0, 1, 2, 3, 4, 5, 6, 8]);
        assert_eq!(Wanted::SurfaceTorque.different(3), [0]);
        assert_eq!(Wanted::AtSurface.different(2), [0, 1, 2, 3]);
        let none = Wanted::Sites { torques: &[] };
        assert_eq!(none.different(2), [0, 1]);
    }
}
