//! The lateral part of a sweep file: bending, the borehole wall at the sites,
//! disturbances.

use std::sync::Arc;

use linear::well::GRAVITY;
use linear::{Bending, Sites, SurfaceSupport};
use sim::EccentricMass;

use super::conditions::Conditions;
use super::contacts::StringInHole;
use super::finding::{self, Finding};
use super::impulses::{self, ImpulseSettings};
use super::sites::{self, Places};
use super::stress;
use super::wall::{self, WallSettings};
use crate::design::Design;
use crate::quantities::{Axis, StringAxis, WallQuantity};
use crate::sweep_file::{
    BendingTable, EccentricMassTable, FileContent, MassForm, NoPlace, Source, SupportName,
    SweepFileError,
};

/// The acceleration beyond which a shock is counted, where the file does not say it, in g.
const SHOCK_G: f64 = 25.0;

/// Clearances that differ by less than this, m, are the same.
const SAME_CLEARANCE: f64 = 1e-6;

/// The lateral part of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct LateralSettings {
    /// Bending constants.
    pub bending: Bending,
    /// How the surface holds the string.
    pub support: SurfaceSupport,
    /// The wall at each site, from the surface down.
    pub walls: Vec<WallSettings>,
    /// The wall besides sites of `"ends"`, by the distance from the bit, m, from the surface down: there a
    /// string at rest may touch, too.
    pub besides: Arc<[(f64, WallSettings)]>,
    /// The clearance along the string, apart from that of sites: corners by depth and clearance, m,
    /// from the surface down. Empty where only sites have one.
    pub clearances: Arc<[(f64, f64)]>,
    /// How further sites are found, where they are.
    pub finding: Option<Finding>,
    /// The acceleration, m/s², beyond which a shock is counted, where accelerations are measured.
    pub shocks: Option<f64>,
    /// Where bending and stress are measured, m from the bit, from the surface down; nothing where they
    /// are not.
    pub stressed: Vec<f64>,
    /// Impulses.
    pub impulses: Vec<ImpulseSettings>,
    /// Eccentric masses.
    pub eccentric_masses: Vec<EccentricMass>,
}

impl LateralSettings {
    /// Of the sites of a string those of the file's `[[sites]]`, which hold it sideways: distances
    /// from the bit, m. Others of `sites = "all"` are where it may touch.
    pub fn held_places(&self, sites: &Sites) -> Vec<f64> {
        let sites = sites.distances_from_bit().iter().zip(&self.walls);
        let of_file = sites.filter(|(_, wall)| wall.site.is_some());
        of_file.map(|(distance, _)| *distance).collect()
    }
}

/// The lateral part, where the file has a wall.
///
/// # Errors
/// Where a key of it is refused.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    in_hole: &StringInHole,
    (places, found): (&Places, &[f64]),
    conditions: &Conditions,
    design: &Design,
) -> Result<Option<LateralSettings>, SweepFileError> {
    let table = content.string.bending.as_ref();
    // Numbers that are not used, too: all of the file is read back.
    let bending = table.map(|table| bending(source, table)).transpose()?;
    if content.wall.is_none() {
        refuse_keys(source, content, design)?;
        return Ok(None);
    }
    let Some((bending, support)) = bending else {
        let message = "a wall needs a table [string.bending]";
        return Err(source.error("wall", message));
    };
    sites_are_there(source, content, design)?;
    let has = |axis| conditions.has(axis, design);
    let distances = places.sites.distances_from_bit();
    let walls: Vec<WallSettings> = (distances.iter().zip(&places.given))
        .map(|(&distance, &site)| {
            let contact = in_hole.contact(distance);
            let quantity = WallQuantity::Friction;
            let has_own = site.is_some_and(|site| has(Axis::WallAtSite { site, quantity }));
            let has_friction = has(Axis::FRICTION) || has_own;
            wall::resolve(source, content, site, (in_hole, contact), has_friction)
        })
        .collect::<Result<_, _>>()?;
    let highest = distances.first().copied().zip(walls.first().copied());
    let besides = sites::besides_ends(content, in_hole, &places.sites).into_iter();
    let besides = besides.filter_map(|distance| {
        let at = (in_hole, in_hole.contact(distance));
        let wall = wall::resolve(source, content, None, at, has(Axis::FRICTION)).ok()?;
        // Pipe above lies on its next joint.
        let (highest, its_wall) = highest?;
        let is_as_wide = wall.clearance <= its_wall.clearance + SAME_CLEARANCE;
        (distance < highest || is_as_wide).then_some((distance, wall))
    });
    let impulses = (content.impulses.iter().enumerate())
        .map(|(index, table)| {
            impulses::resolve(source, index, table, places, has(Axis::ImpulseRatio))
        })
        .collect::<Result<Vec<_>, _>>()?;
    let has_ratio = impulses.iter().any(ImpulseSettings::is_relative);
    let is_idle = design.axes().contains(&Axis::ImpulseRatio) && !has_ratio;
    let message = "the axis impulse_ratio needs an entry [[impulses]] without `amount_ns`";
    source.refuse_if(is_idle, "design.axes.impulse_ratio", message)?;
    let eccentric_masses = (content.eccentric_masses.iter().enumerate())
        .map(|(index, table)| eccentric_mass(source, index, table, places))
        .collect::<Result<_, _>>()?;
    Ok(Some(LateralSettings {
        bending,
        support,
        walls,
        besides: besides.collect(),
        clearances: clearances(content, in_hole).into(),
        finding: finding::resolve(source, content, in_hole, found)?,
        shocks: shocks(source, content)?,
        stressed: stress::places(source, content, &places.sites)?,
        impulses,
        eccentric_masses,
    }))
}

/// The acceleration, m/s², beyond which a shock is counted, where accelerations are measured.
fn shocks(source: &Source, content: &FileContent) -> Result<Option<f64>, SweepFileError> {
    let given = content.wall.and_then(|wall| wall.shock_g);
    let by_default = content.measures_shocks().then_some(SHOCK_G);
    let shock = given.or(by_default);
    let within = |shock| source.within("wall.shock_g", shock, 1e-3, 1e5, "g");
    Ok(shock.map(within).transpose()?.map(|shock| shock * GRAVITY))
}

/// The clearance along the string as `[wall]` says it, as corners.
fn clearances(content: &FileContent, in_hole: &StringInHole) -> Vec<(f64, f64)> {
    let wall = content.wall.unwrap_or_default();
    match wall.clearance_mm {
        Some(clearance) => [0.0, in_hole.string.length()]
            .map(|depth| (depth, 1e-3 * clearance))
            .to_vec(),
        None if content.clearance_is_of_hole() => in_hole.clearances(),
        None => Vec::new(),
    }
}

/// Refuses an axis of the wall at a site that the file has not.
fn sites_are_there(
    source: &Source,
    content: &FileContent,
    design: &Design,
) -> Result<(), SweepFileError> {
    for axis in design.axes() {
        if let Axis::WallAtSite { site, .. } = axis {
            let key = format!("design.axes.{}", axis.name());
            let nowhere = NoPlace::Site(content.sites.len());
            let is_there = content.sites.get(*site).ok_or(nowhere);
            source.checked(&key, is_there)?;
        }
    }
    Ok(())
}

/// Keys that would be ignored without a wall.
fn refuse_keys(
    source: &Source,
    content: &FileContent,
    design: &Design,
) -> Result<(), SweepFileError> {
    let varies = |axis| design.axes().contains(&axis);
    let message = "needs a table [wall]";
    for (key, is_given) in [
        ("impulses", !content.impulses.is_empty()),
        ("eccentric_masses", !content.eccentric_masses.is_empty()),
        ("design.axes.impulse_ratio", varies(Axis::ImpulseRatio)),
    ] {
        source.refuse_if(is_given, key, message)?;
    }
    if let Some(axis) = design.axes().iter().find(|axis| axis.is_of_wall()) {
        return Err(source.error(&format!("design.axes.{}", axis.name()), message));
    }
    for axis in [StringAxis::BendingDamping, StringAxis::Compression].map(Axis::String) {
        let message = "needs tables [wall] and [string.bending]";
        let key = format!("design.axes.{}", axis.name());
        source.refuse_if(varies(axis), &key, message)?;
    }
    for (index, site) in content.sites.iter().enumerate() {
        for quantity in WallQuantity::ALL {
            let key = format!("sites[{index}].{}", quantity.key());
            source.refuse_if(site.value(quantity).is_some(), &key, message)?;
        }
    }
    Ok(())
}

fn bending(
    source: &Source,
    table: &BendingTable,
) -> Result<(Bending, SurfaceSupport), SweepFileError> {
    let key = |name: &str| format!("string.bending.{name}");
    let modulus = table.youngs_modulus_gpa;
    let modulus = source.within(&key("youngs_modulus_gpa"), modulus, 0.1, 1e3, "GPa")?;
    let (damping, compression) = (table.damping_ns_m2, table.compression_kn);
    for (name, axis, value) in [
        ("damping_ns_m2", StringAxis::BendingDamping, damping),
        ("compression_kn", StringAxis::Compression, compression),
    ] {
        source.check_axis(&key(name), Axis::String(axis), value)?;
    }
    let bending = Bending {
        youngs_modulus: 1e9 * modulus,
        damping,
        compression: 1e3 * compression,
    };
    let support = match table.surface {
        SupportName::Free => SurfaceSupport::Free,
        SupportName::Pinned => SurfaceSupport::Pinned,
        SupportName::Clamped => SurfaceSupport::Clamped,
    };
    Ok((bending, support))
}

/// The sites with the masses that the string carries there.
///
/// # Errors
/// Where masses at one site have different forms.
pub fn carrying(
    source: &Source,
    content: &FileContent,
    lateral: &LateralSettings,
    sites: Sites,
) -> Result<Sites, SweepFileError> {
    let tables = content.eccentric_masses.iter();
    let all: Vec<(EccentricMass, MassForm)> = (lateral.eccentric_masses.iter().copied())
        .zip(tables.map(|table| table.form))
        .collect();
    for (index, (mass, form)) in all.iter().enumerate() {
        let before = &all[..index];
        let differs = before
            .iter()
            .any(|(other, its)| other.site == mass.site && its != form);
        let message = "masses at one place must have the same form";
        let key = format!("eccentric_masses[{index}].form");
        source.refuse_if(differs, &key, message)?;
    }
    let mut masses = vec![0.0; sites.len()];
    for (mass, _) in all.iter().filter(|(_, form)| form.is_carried()) {
        masses[mass.site] += mass.mass;
    }
    if masses.iter().all(|mass| *mass == 0.0) {
        return Ok(sites);
    }
    source.checked("eccentric_masses", sites.carrying(masses))
}

fn eccentric_mass(
    source: &Source,
    index: usize,
    table: &EccentricMassTable,
    places: &Places,
) -> Result<EccentricMass, SweepFileError> {
    let key = |name: &str| format!("eccentric_masses[{index}].{name}");
    let distance = table.distance_from_bit_m;
    let site = places.site_of(source, &key("distance_from_bit_m"), distance)?;
    Ok(EccentricMass {
        site,
        mass: source.within(&key("mass_kg"), table.mass_kg, 0.0, 1e6, "kg")?,
        offset: source.within(&key("offset_m"), table.offset_m, 0.0, 10.0, "m")?,
    })
}
