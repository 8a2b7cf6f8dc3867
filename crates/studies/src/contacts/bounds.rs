//! What steady whirl needs at least, by the balance of forces, of the same contacts.

use anyhow::{Context, Result};
use linear::bending_decay::friction_if_carried;

use super::subject::StudiedString;
use campaign::records::to_rpm;
use limits::{WhirlMotion, many_sites_limit, whirl_limit};

/// Friction that steady whirl needs at least.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bounds {
    /// Of any contacts together: where less friction does not sustain any. None of one contact
    /// alone, and of more than [`limits::MOST_SITES`].
    pub any_sites: Option<f64>,
    /// Of one contact alone, whichever needs least.
    pub one_site: Option<f64>,
    /// Of a string that its wall carries everywhere, at the fastest rate that a contact may roll
    /// at: friction against damping and mud, c_b/(ρA ω) without viscous mud.
    pub carried: f64,
}

/// The bounds for a number of contacts.
///
/// # Errors
/// Where a contact is not on the string.
pub fn bounds(subject: &StudiedString, count: usize) -> Result<Bounds> {
    let setting = subject.touching_at(&subject.range.even(count))?;
    let lateral = subject.lateral(&setting)?;
    let speed = (subject.conditions().surface_speed()).context("the surface has a speed")?;
    let at_speed = [to_rpm(speed); 2];
    let one_site = whirl_limit(&setting, lateral, at_speed)?;
    let one_site = (one_site.iter()).find(|point| point.motion == WhirlMotion::RollingOrSliding);
    let any_sites = many_sites_limit(&setting, lateral, at_speed)?;
    let ratios = (lateral.walls.iter()).map(|wall| wall.radius / wall.clearance);
    let fastest = speed * ratios.fold(0.0, f64::max);
    Ok(Bounds {
        any_sites: any_sites.last().map(|point| point.friction),
        one_site: one_site.map(|point| point.friction),
        carried: friction_if_carried(&setting.string, &lateral.bending, fastest),
    })
}
