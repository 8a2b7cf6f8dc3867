//! What is around a string that bends: mud in a hole of some width, and an axial force along it.

/// The fluid inside and around a string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mud {
    /// Density, kg/m³.
    pub density: f64,
    /// Viscosity, Pa s; 0 where only its mass and its buoyancy matter.
    pub viscosity: f64,
}

/// A hole full of mud, in which the string moves sideways.
///
/// Mud slows a string down: what is inside moves with it, and so does, in a wide hole, as much as
/// it displaces.
///
/// ```
/// use linear::natural_frequencies::NaturalFrequencies;
/// use linear::{Bending, Drillstring, Hole, HoleSection, Material, Mud, Section, SurfaceSupport};
/// use linear::Tube;
///
/// let steel = Material { shear_modulus: 80e9, density: 7840.0 };
/// let pipe = Tube { length: 30.0, inner_radius: 0.05, outer_radius: 0.06 };
/// let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
/// let hole = Hole {
///     sections: vec![HoleSection { length: 30.0, radius: 10.0 }],
///     mud: Mud { density: 1200.0, viscosity: 0.0 },
/// };
/// let lowest = |string: &Drillstring| {
///     let bending = Bending { youngs_modulus: 210e9, damping: 0.0, compression: 0.0 };
///     NaturalFrequencies::bending(string, &bending, SurfaceSupport::Clamped)?.lowest(1)
/// };
/// let slower = lowest(&string.clone().in_hole(hole)?)?[0] / lowest(&string)?[0];
/// let [inner, outer] = [0.05f64, 0.06].map(|radius| radius * radius);
/// let (steel, mud) = (7840.0 * (outer - inner), 1200.0 * (outer + inner));
/// assert!((slower / (steel / (steel + mud)).sqrt() - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// How wide it is, from the surface down; the last section ends no higher than the string.
    pub sections: Vec<HoleSection>,
    /// What is in it.
    pub mud: Mud,
}

/// A length of hole of one width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoleSection {
    /// Length, m.
    pub length: f64,
    /// Radius, m.
    pub radius: f64,
}

/// What is around a piece of string that bends.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Surroundings {
    /// Axial force in addition to the pre-compression, N; compression where negative.
    pub(crate) tension: f64,
    /// Radius of the hole of mud, if it is in one, m.
    pub(crate) hole_radius: Option<f64>,
}

/// A length of string with the same around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    /// m.
    pub(crate) length: f64,
    pub(crate) around: Surroundings,
}

/// A length of string along which one axial force acts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxialForce {
    /// Length, m.
    pub length: f64,
    /// Tension, N; compression where negative.
    pub tension: f64,
}

/// Stretches with the same around each, from the surface down; places closer than `same_place`
/// are one.
pub(crate) fn stretches(
    axial_force: &[AxialForce],
    hole: Option<&Hole>,
    length: f64,
    same_place: f64,
) -> Vec<Stretch> {
    let tensions = axial_force.iter().map(|it| (it.length, it.tension));
    let tensions = ends(tensions, (length, 0.0));
    let radii = hole.into_iter().flat_map(|hole| &hole.sections);
    let radii = ends(radii.map(|it| (it.length, Some(it.radius))), (length, None));
    let mut depths: Vec<f64> = tensions.iter().map(|it| it.0).collect();
    depths.extend(radii.iter().map(|it| it.0));
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|one, other| *one - *other <= same_place);
    let mut top = 0.0;
    let stretch = |bottom: f64| {
        let middle = 0.5 * (top + bottom);
        let around = Surroundings {
            tension: at(&tensions, middle),
            hole_radius: at(&radii, middle),
        };
        let length = bottom - top;
        top = bottom;
        Stretch { length, around }
    };
    depths.into_iter().map(stretch).collect()
}

/// The depths at which lengths with something end; all in one where there are none.
fn ends<T>(pieces: impl Iterator<Item = (f64, T)>, all: (f64, T)) -> Vec<(f64, T)> {
    let mut depth = 0.0;
    let mut ends: Vec<(f64, T)> = pieces
        .map(|(length, what)| {
            depth += length;
            (depth, what)
        })
        .collect();
    if ends.is_empty() {
        ends.push(all);
    }
    ends
}

/// What is at a depth; below all ends, what the last has.
fn at<T: Copy>(ends: &[(f64, T)], depth: f64) -> T {
    let place = ends.partition_point(|(end, _)| *end <= depth);
    ends[place.min(ends.len() - 1)].1
}
