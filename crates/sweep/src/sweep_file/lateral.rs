//! The lateral part of a sweep file: bending, the borehole wall at the sites,
//! disturbances.

use linear::{Bending, Drillstring, Sites, SurfaceSupport};
use serde::{Deserialize, Serialize};
use sim::{EccentricMass, Wall};

use super::file::FileContent;
use super::resolve::{Check, Conditions, Sweep};
use super::source::SweepFileError;
use crate::design::Design;
use crate::quantities::{Axis, StringAxis, in_digits};

/// More than any knock, N s: a site whose I₀ is larger cannot reach its wall.
pub const LARGEST_IMPULSE: f64 = 1e9;

/// What pushes the string for longer is no impulse, s.
const LONGEST_IMPULSE: f64 = 100.0;

/// The samples of a raised cosine have its area from two on.
const LEAST_SAMPLES_OF_IMPULSE: f64 = 2.0;

/// Bending constants of the string, `[string.bending]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BendingTable {
    /// Young's modulus E, GPa.
    pub youngs_modulus_gpa: f64,
    /// Distributed lateral damping c_b, N s/m per metre of string.
    pub damping_ns_m2: f64,
    /// Pre-compression C, kN; tension where negative. Default 0.
    #[serde(default)]
    pub compression_kn: f64,
    /// How the surface holds the string laterally. Default `free`.
    #[serde(default)]
    pub surface: SupportName,
}

/// How the surface holds the string laterally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SupportName {
    /// Not at all.
    #[default]
    Free,
    /// No displacement.
    Pinned,
    /// No displacement and no slope.
    Clamped,
}

/// The borehole wall, at every site that does not say otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WallTable {
    /// Clearance between string and wall, mm.
    pub clearance_mm: Option<f64>,
    /// Hertzian stiffness k_c in GN/m^(3/2); left out, the wall is rigid.
    pub stiffness_gn_m15: Option<f64>,
    /// Coefficient of friction μ₀, unless an axis gives it.
    pub friction: Option<f64>,
}

/// A lateral impulse at a site.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ImpulseTable {
    /// Which site, by its distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Its amount, N s.
    #[serde(default)]
    pub amount_ns: Option<f64>,
    /// Its amount in multiples of I₀, which just brings the site to the wall.
    #[serde(default)]
    pub ratio: Option<f64>,
    /// When it begins, s. Default 1.
    #[serde(default = "default_start")]
    pub start_s: f64,
    /// How long it lasts, s. Default 0.02.
    #[serde(default = "default_duration")]
    pub duration_s: f64,
    /// Its direction from the x axis, degrees. Default 0.
    #[serde(default)]
    pub direction_deg: f64,
}

fn default_start() -> f64 {
    1.0
}

fn default_duration() -> f64 {
    0.02
}

/// An eccentric mass at a site.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EccentricMassTable {
    /// Which site, by its distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Mass m_e, kg.
    pub mass_kg: f64,
    /// Offset d from the string's centre, m.
    pub offset_m: f64,
}

/// The lateral part of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct LateralSettings {
    /// Bending constants.
    pub bending: Bending,
    /// How the surface holds the string.
    pub support: SurfaceSupport,
    /// The wall at each site, from the surface down; its friction is the
    /// case's, where an axis gives it.
    pub walls: Vec<Wall>,
    /// Impulses.
    pub impulses: Vec<ImpulseSettings>,
    /// Eccentric masses.
    pub eccentric_masses: Vec<EccentricMass>,
}

/// An impulse whose amount may be relative to what reaches the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulseSettings {
    /// The impulse; its amount in N s, or in multiples of I₀.
    pub impulse: sim::Impulse,
    /// Whether the amount is in multiples of I₀.
    pub relative: bool,
}

impl Sweep {
    /// Refuses an impulse that begins when a case is over: its label would say
    /// nothing of the impulse.
    ///
    /// # Errors
    /// Names the impulse.
    pub fn impulses_are_felt(&self, case: usize, duration: f64) -> Result<(), SweepFileError> {
        for (index, impulse) in self.content.impulses.iter().enumerate() {
            let start = impulse.start_s;
            if start >= duration {
                let message =
                    format!("{start} s is not before the end of case {case}, {duration} s");
                let key = format!("impulses[{index}].start_s");
                return Err(self.source.error(&key, message));
            }
        }
        Ok(())
    }
}

impl Check<'_> {
    /// The lateral part, where the file has a wall.
    pub(super) fn lateral(
        &self,
        content: &FileContent,
        string: &Drillstring,
        sites: &Sites,
        conditions: &Conditions,
        design: &Design,
    ) -> Result<Option<LateralSettings>, SweepFileError> {
        if content.wall.is_none() {
            self.refuse_lateral_keys(content, design)?;
            return Ok(None);
        }
        let Some(table) = &content.string.bending else {
            let message = "a wall needs a table [string.bending]";
            return Err(self.source.error("wall", message));
        };
        let (bending, support) = self.bending(table)?;
        let has = |axis| conditions.value(axis).is_some() || design.axes().contains(&axis);
        // As the sites are: from the surface down.
        let mut order: Vec<usize> = (0..content.sites.len()).collect();
        let distance = |index: &usize| content.sites[*index].distance_from_bit_m;
        order.sort_by(|one, other| distance(other).total_cmp(&distance(one)));
        let walls = (sites.distances_from_bit().iter().zip(order))
            .map(|(&distance, index)| {
                let radius = string.outer_radius_at(distance);
                self.wall(content, index, radius, has(Axis::Friction))
            })
            .collect::<Result<_, _>>()?;
        let impulses = (content.impulses.iter().enumerate())
            .map(|(index, table)| self.impulse(index, table, sites, has(Axis::ImpulseRatio)))
            .collect::<Result<Vec<_>, _>>()?;
        if design.axes().contains(&Axis::ImpulseRatio) && impulses.is_empty() {
            let message = "the axis impulse_ratio needs an entry [[impulses]]";
            return Err(self.source.error("design.axes.impulse_ratio", message));
        }
        let eccentric_masses = (content.eccentric_masses.iter().enumerate())
            .map(|(index, table)| self.eccentric_mass(index, table, sites))
            .collect::<Result<_, _>>()?;
        Ok(Some(LateralSettings {
            bending,
            support,
            walls,
            impulses,
            eccentric_masses,
        }))
    }

    /// Keys that would be ignored without a wall.
    fn refuse_lateral_keys(
        &self,
        content: &FileContent,
        design: &Design,
    ) -> Result<(), SweepFileError> {
        let keys = [
            ("impulses", !content.impulses.is_empty()),
            ("eccentric_masses", !content.eccentric_masses.is_empty()),
            (
                "design.axes.impulse_ratio",
                design.axes().contains(&Axis::ImpulseRatio),
            ),
            (
                "design.axes.friction",
                design.axes().contains(&Axis::Friction),
            ),
        ];
        match keys.into_iter().find(|(_, given)| *given) {
            Some((key, _)) => Err(self.source.error(key, "needs a table [wall]")),
            None => Ok(()),
        }
    }

    fn bending(&self, table: &BendingTable) -> Result<(Bending, SurfaceSupport), SweepFileError> {
        let key = |name: &str| format!("string.bending.{name}");
        let modulus = table.youngs_modulus_gpa;
        self.within(&key("youngs_modulus_gpa"), modulus, 0.1, 1e3, "GPa")?;
        let damping = table.damping_ns_m2;
        self.measure(&key("damping_ns_m2"), StringAxis::BendingDamping, damping)?;
        let compression = table.compression_kn;
        self.measure(&key("compression_kn"), StringAxis::Compression, compression)?;
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

    /// The wall at a site of the file, where the string has an outer radius (m).
    fn wall(
        &self,
        content: &FileContent,
        index: usize,
        radius: f64,
        friction_by_axis: bool,
    ) -> Result<Wall, SweepFileError> {
        let common = content.wall.unwrap_or_default();
        let site = &content.sites[index];
        let chosen = |own: Option<f64>, common: Option<f64>, name: &str| match own {
            Some(value) => (Some(value), format!("sites[{index}].{name}")),
            None => (common, format!("wall.{name}")),
        };
        let (clearance, key) = chosen(site.clearance_mm, common.clearance_mm, "clearance_mm");
        let Some(clearance) = clearance else {
            let distance = site.distance_from_bit_m;
            let message = format!("the site {distance} m from the bit has no clearance");
            return Err(self.source.error("wall", message));
        };
        self.within(&key, clearance, 1e-3, 1e3, "mm")?;
        let (stiffness, key) = chosen(
            site.stiffness_gn_m15,
            common.stiffness_gn_m15,
            "stiffness_gn_m15",
        );
        if let Some(stiffness) = stiffness {
            self.within(&key, stiffness, 1e-6, 1e6, "GN/m^1.5")?;
        }
        let (friction, key) = chosen(site.friction, common.friction, "friction");
        if let Some(friction) = friction {
            self.within(&key, friction, 0.0, 50.0, "")?;
        }
        let Some(friction) = friction.or(friction_by_axis.then_some(0.0)) else {
            let message = "is needed: give a number, or make it an axis of the design";
            return Err(self.source.error("wall.friction", message));
        };
        Ok(Wall {
            clearance: 1e-3 * clearance,
            stiffness: stiffness.map_or(f64::INFINITY, |stiffness| 1e9 * stiffness),
            friction,
            radius,
        })
    }

    fn site_of(&self, key: &str, distance: f64, sites: &Sites) -> Result<usize, SweepFileError> {
        // They are in order, and may be many.
        let distances = sites.distances_from_bit();
        let index = distances.partition_point(|site| *site > distance);
        let found = distances.get(index).filter(|site| **site == distance);
        found.map(|_| index).ok_or_else(|| {
            let known: Vec<String> = (sites.distances_from_bit().iter())
                .map(|site| format!("{site}"))
                .collect();
            let message = format!(
                "no site is {distance} m from the bit; there are sites at {} m",
                known.join(", ")
            );
            self.source.error(key, message)
        })
    }

    fn impulse(
        &self,
        index: usize,
        table: &ImpulseTable,
        sites: &Sites,
        ratio_by_axis: bool,
    ) -> Result<ImpulseSettings, SweepFileError> {
        let key = |name: &str| format!("impulses[{index}].{name}");
        let site = self.site_of(
            &key("distance_from_bit_m"),
            table.distance_from_bit_m,
            sites,
        )?;
        self.within(&key("start_s"), table.start_s, 0.0, 1e6, "s")?;
        if table.duration_s.is_nan() || table.duration_s <= 0.0 {
            let message = format!("{} s: the impulse ends before it starts", table.duration_s);
            return Err(self.source.error(&key("duration_s"), message));
        }
        if table.duration_s > LONGEST_IMPULSE {
            let duration = in_digits(table.duration_s);
            let message = format!(
                "{duration} s: an impulse lasts {LONGEST_IMPULSE} s at most; is it in another unit?"
            );
            return Err(self.source.error(&key("duration_s"), message));
        }
        self.within(
            &key("direction_deg"),
            table.direction_deg,
            -360.0,
            360.0,
            "°",
        )?;
        let (amount, relative) = match (table.amount_ns, table.ratio) {
            (Some(amount), None) => (amount, false),
            (None, Some(ratio)) => (ratio, true),
            (None, None) if ratio_by_axis => (0.0, true),
            _ => {
                let message = "needs either `amount_ns` or `ratio`, or the axis impulse_ratio";
                return Err(self.source.error(&format!("impulses[{index}]"), message));
            }
        };
        let (name, unit) = if relative {
            ("ratio", "")
        } else {
            ("amount_ns", "N s")
        };
        self.within(&key(name), amount, 0.0, LARGEST_IMPULSE, unit)?;
        Ok(ImpulseSettings {
            impulse: sim::Impulse {
                site,
                amount,
                start: table.start_s,
                duration: table.duration_s,
                direction: table.direction_deg.to_radians(),
            },
            relative,
        })
    }

    /// An impulse between two samples would not be felt at all.
    pub(super) fn impulses_are_sampled(
        &self,
        lateral: Option<&LateralSettings>,
        sampling_frequency: f64,
    ) -> Result<(), SweepFileError> {
        let impulses = lateral.iter().flat_map(|lateral| &lateral.impulses);
        for (index, settings) in impulses.enumerate() {
            let duration = settings.impulse.duration;
            if duration * sampling_frequency < LEAST_SAMPLES_OF_IMPULSE {
                let message =
                    format!("{duration} s is shorter than two samples at {sampling_frequency} Hz");
                let key = format!("impulses[{index}].duration_s");
                return Err(self.source.error(&key, message));
            }
        }
        Ok(())
    }

    fn eccentric_mass(
        &self,
        index: usize,
        table: &EccentricMassTable,
        sites: &Sites,
    ) -> Result<EccentricMass, SweepFileError> {
        let key = |name: &str| format!("eccentric_masses[{index}].{name}");
        let site = self.site_of(
            &key("distance_from_bit_m"),
            table.distance_from_bit_m,
            sites,
        )?;
        self.within(&key("mass_kg"), table.mass_kg, 0.0, 1e6, "kg")?;
        self.within(&key("offset_m"), table.offset_m, 0.0, 10.0, "m")?;
        Ok(EccentricMass {
            site,
            mass: table.mass_kg,
            offset: table.offset_m,
        })
    }
}
