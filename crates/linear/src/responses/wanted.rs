//! Which responses in torsion are wanted, and where they stand in a list.

use crate::assembly::lanes::Lanes;
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
}

impl<'a> Wanted<'a> {
    /// The sites that torques act on.
    pub(super) fn torques(self) -> &'a [usize] {
        match self {
            Wanted::Sites { torques } => torques,
            Wanted::SurfaceTorque => &[],
        }
    }

    /// How many responses there are, for a number of sites.
    pub(super) fn count(self, sites: usize) -> usize {
        match self {
            Wanted::Sites { torques } => sites * (1 + torques.len()),
            Wanted::SurfaceTorque => 1,
        }
    }

    /// Writes them: of all sites from the surface, then of all sites from each torque; or the
    /// torque at the surface.
    pub(super) fn write(
        self,
        admittance: impl FnOnce() -> TorsionAdmittance<Lanes>,
        surface_torque: impl FnOnce() -> Lanes,
        responses: &mut [Lanes],
    ) {
        let torques = match self {
            Wanted::Sites { torques } => torques,
            Wanted::SurfaceTorque => return responses[0] = surface_torque(),
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
