//! The small classes of the package, `Tube`, `Wall` and the like, and words, as what they mean in
//! [`linear`] and [`sim`]. They are read by their attributes.

use linear::method::{FiniteElement, Transform};
use linear::{Method, SurfaceSupport};
use pyo3::prelude::*;

use crate::errors::refused;

/// `drillstring.Tube`.
#[derive(FromPyObject)]
pub struct Tube {
    length: f64,
    inner_radius: f64,
    outer_radius: f64,
}

/// `drillstring.Section`.
#[derive(FromPyObject)]
pub struct Section {
    parts: Vec<Tube>,
    repeat: usize,
}

/// `drillstring.Material`.
#[derive(FromPyObject)]
pub struct Material {
    shear_modulus: f64,
    density: f64,
}

/// `drillstring.TopDrive`.
#[derive(FromPyObject)]
pub struct TopDrive {
    inertia: f64,
    proportional_gain: f64,
    integral_gain: f64,
}

/// `drillstring.Bending`.
#[derive(FromPyObject)]
pub struct Bending {
    youngs_modulus: f64,
    damping: f64,
    compression: f64,
    support: String,
}

/// `drillstring.Impulse`.
#[derive(FromPyObject)]
pub struct Impulse {
    amount: f64,
    site: usize,
    start: f64,
    duration: f64,
    direction: f64,
}

/// `drillstring.EccentricMass`.
#[derive(FromPyObject)]
pub struct EccentricMass {
    mass: f64,
    offset: f64,
    site: usize,
}

/// `drillstring.BitTorque`.
#[derive(FromPyObject)]
pub struct BitTorque {
    torque_static: f64,
    torque_dynamic: f64,
    decay_speed: f64,
}

/// `drillstring.TabulatedFriction`.
#[derive(FromPyObject)]
pub struct TabulatedFriction {
    speeds: Vec<f64>,
    torques: Vec<f64>,
    torque_static: Option<f64>,
}

/// `drillstring.Wall`.
#[derive(FromPyObject)]
pub struct BuiltInWall {
    clearance: f64,
    stiffness: f64,
    friction: f64,
    dynamic_ratio: f64,
    stribeck_speed: f64,
    radius: f64,
}

impl From<Section> for linear::Section {
    fn from(section: Section) -> Self {
        let tube = |part: Tube| linear::Tube {
            length: part.length,
            inner_radius: part.inner_radius,
            outer_radius: part.outer_radius,
        };
        linear::Section {
            repeat: section.repeat,
            parts: section.parts.into_iter().map(tube).collect(),
        }
    }
}

impl From<Material> for linear::Material {
    fn from(material: Material) -> Self {
        linear::Material {
            shear_modulus: material.shear_modulus,
            density: material.density,
        }
    }
}

impl From<TopDrive> for linear::TopDrive {
    fn from(drive: TopDrive) -> Self {
        linear::TopDrive {
            inertia: drive.inertia,
            proportional_gain: drive.proportional_gain,
            integral_gain: drive.integral_gain,
            delay: 0.0,
            late_inertia: 0.0,
        }
    }
}

impl Bending {
    /// Constants and support of a string that bends.
    ///
    /// # Errors
    /// Where there is no such support.
    pub fn resolve(&self) -> PyResult<(linear::Bending, SurfaceSupport)> {
        let support = SUPPORTS.iter().find(|(name, _)| *name == self.support);
        let Some((_, support)) = support else {
            let known = SUPPORTS.map(|(name, _)| name).join(", ");
            let name = &self.support;
            return Err(refused(format_args!(
                "unknown support `{name}`; known: {known}"
            )));
        };
        let bending = linear::Bending {
            youngs_modulus: self.youngs_modulus,
            damping: self.damping,
            compression: self.compression,
        };
        Ok((bending, *support))
    }
}

/// How the surface holds a string, by name.
const SUPPORTS: [(&str, SurfaceSupport); 3] = [
    ("free", SurfaceSupport::Free),
    ("pinned", SurfaceSupport::Pinned),
    ("clamped", SurfaceSupport::Clamped),
];

impl From<Impulse> for sim::Impulse {
    fn from(impulse: Impulse) -> Self {
        sim::Impulse {
            site: impulse.site,
            amount: impulse.amount,
            start: impulse.start,
            duration: impulse.duration,
            direction: impulse.direction,
        }
    }
}

impl From<EccentricMass> for sim::EccentricMass {
    fn from(mass: EccentricMass) -> Self {
        sim::EccentricMass {
            site: mass.site,
            mass: mass.mass,
            offset: mass.offset,
        }
    }
}

impl From<BitTorque> for sim::BitTorque {
    fn from(bit: BitTorque) -> Self {
        sim::BitTorque {
            torque_static: bit.torque_static,
            torque_dynamic: bit.torque_dynamic,
            decay_speed: bit.decay_speed,
        }
    }
}

impl TabulatedFriction {
    /// The table row by row; without a static torque that at rest.
    ///
    /// # Errors
    /// Where there are more speeds than torques, or fewer.
    pub fn resolve(self) -> PyResult<sim::TabulatedFriction> {
        let (speeds, torques) = (self.speeds.len(), self.torques.len());
        if speeds != torques {
            return Err(refused(format_args!(
                "a table of friction has {speeds} speeds and {torques} torques: give one torque \
                 for each speed"
            )));
        }
        let at_rest = self.torques.first().copied().unwrap_or(f64::NAN);
        Ok(sim::TabulatedFriction {
            torque_static: self.torque_static.unwrap_or(at_rest),
            rows: self.speeds.into_iter().zip(self.torques).collect(),
        })
    }
}

impl From<BuiltInWall> for sim::Wall {
    fn from(wall: BuiltInWall) -> Self {
        sim::Wall {
            clearance: wall.clearance,
            stiffness: wall.stiffness,
            friction: wall.friction,
            dynamic_ratio: wall.dynamic_ratio,
            stribeck_speed: wall.stribeck_speed,
            radius: wall.radius,
        }
    }
}

/// A method by name, with the parameters of those that have any.
///
/// # Errors
/// Where there is no such method.
pub fn method(name: &str, transform: Transform, elements: FiniteElement) -> PyResult<Method> {
    let all = [
        Method::Held,
        Method::Poles,
        Method::Quadrature,
        Method::Hilbert(transform),
        Method::FiniteElement(elements),
        Method::DirectIdft(transform),
        Method::Trapezoidal,
    ];
    all.into_iter()
        .find(|method| method.name() == name)
        .ok_or_else(|| {
            let known = all.map(|method| method.name()).join(", ");
            refused(format_args!("unknown method `{name}`; known: {known}"))
        })
}
