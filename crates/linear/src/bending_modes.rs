//! Natural frequencies of a string in bending, without damping, and whether it buckles.
//!
//! As many natural frequencies lie below ω as K − ω² M has negative eigenvalues (J. J. Sylvester's
//! law of inertia); those are counted node by node while finite elements are eliminated from the
//! surface down.
//!
//! A column that is clamped at one end and free at the other buckles under π² E I/(4 L²) (Euler):
//!
//! ```
//! use linear::bending_modes::BendingModes;
//! use linear::{Bending, Drillstring, Material, Section, SurfaceSupport, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 3, parts: vec![pipe] }], 0.0)?;
//! let critical = (std::f64::consts::PI / (2.0 * 30.0)).powi(2) * 210e9 * pipe.second_moment();
//! let buckles_under = |compression: f64| {
//!     let bending = Bending { youngs_modulus: 210e9, damping: 0.0, compression };
//!     BendingModes::new(&string, &bending, SurfaceSupport::Clamped).map(|it| it.is_buckled())
//! };
//! assert!(!buckles_under(0.999 * critical)?);
//! assert!(buckles_under(1.001 * critical)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::elements::beam::{mass_matrix, stiffness_matrix};
use crate::elements::mesh::Mesh;
use crate::error::BuildError;
use crate::sites::{AtSite, Sites};
use crate::well::HangingString;

/// Elements for each cell of the drillpipe: frequencies are off by a fourth power of their length.
const ELEMENTS_PER_CELL: usize = 4;

/// A frequency is known to this part of it.
const SAME_FREQUENCY: f64 = 1e-10;

/// A weight on bit, N, where one under which a string buckles is first looked for.
const LEAST_WEIGHT: f64 = 100.0;

/// It is known to this part of it.
const SAME_WEIGHT: f64 = 1e-3;

/// Springs that hold a string are looked for from this stiffness, N/m, on …
const SOFTEST_SPRING: f64 = 10.0;

/// … to this one, far stiffer than collars between two stabilisers are …
const STIFFEST_SPRING: f64 = 1e9;

/// … by this factor, and taken as much stiffer than the first that is enough.
const FIRMLY: f64 = 4.0;

/// The part of the largest stiffness of an element that rounding may leave to a string that moves
/// as a rigid rod.
const ROUNDING: f64 = 2e-14;

/// Elements shorter than this part of the longest are left out: what cuts them off next to the end
/// of a tube, such as a change of axial force, would leave more rounding than they count.
const SHORTEST: f64 = 0.002;

/// A string divided into elements, to count its natural frequencies.
#[derive(Debug, Clone)]
pub struct BendingModes {
    elements: Vec<Element>,
    support: SurfaceSupport,
    /// Springs and masses at the bottom of elements by their number.
    at_sites: Vec<(usize, AtSite)>,
    /// The square below which a frequency is that of a rigid motion, 1/s².
    nothing: f64,
}

type Matrix = [[f64; 4]; 4];

#[derive(Debug, Clone)]
struct Element {
    mass: Matrix,
    stiffness: Matrix,
}

impl BendingModes {
    /// Divides the string into elements.
    ///
    /// # Errors
    /// Where the string cannot bend so, or its elements would be too many.
    pub fn new(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
    ) -> Result<Self, BuildError> {
        Self::held(string, bending, support, &Sites::bit())
    }

    /// The same of a string that springs hold at sites ([`Sites::held_by`]).
    ///
    /// # Errors
    /// As [`BendingModes::new`], and where the sites are not the string's.
    pub fn held(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
        sites: &Sites,
    ) -> Result<Self, BuildError> {
        Self::down_from(0.0, string, bending, support, sites)
    }

    /// The same of what is below a distance from the bit (m), where it is held in place without a
    /// moment.
    ///
    /// # Errors
    /// As [`BendingModes::held`].
    pub fn of_lower_part(
        string: &Drillstring,
        bending: &Bending,
        distance_from_bit: f64,
        sites: &Sites,
    ) -> Result<Self, BuildError> {
        let depth = string.length() - distance_from_bit;
        Self::down_from(depth, string, bending, SurfaceSupport::Pinned, sites)
    }

    /// Of what is below a depth (m), to the nearest element.
    fn down_from(
        depth: f64,
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
        sites: &Sites,
    ) -> Result<Self, BuildError> {
        bending.check()?;
        let mesh = Mesh::new(string, Channel::Bending, sites, ELEMENTS_PER_CELL)?;
        let longest = mesh.elements.iter().map(|tube| tube.length);
        let shortest = SHORTEST * longest.fold(0.0, f64::max);
        let depths = mesh.depths();
        let pieces = mesh.elements.iter().zip(&mesh.around).enumerate();
        let kept: Vec<_> = pieces
            .filter(|(element, (tube, _))| {
                let middle = 0.5 * (depths[*element] + depths[element + 1]);
                tube.length >= shortest && middle >= depth
            })
            .collect();
        let loaded = mesh.site_nodes.iter().zip(sites.loads());
        // The bottom of the last element that is kept down to a site.
        let at_sites =
            loaded
                .filter(|(_, load)| *load != AtSite::default())
                .map(|(&node, load)| {
                    let above = kept.partition_point(|(element, _)| *element < node);
                    (above.saturating_sub(1), load)
                });
        let at_sites = at_sites.collect();
        let elements: Vec<Element> = (kept.into_iter())
            .map(|(_, (tube, around))| Element {
                mass: mass_matrix(tube, string.mass_sideways(tube, around.hole_radius)),
                stiffness: stiffness_matrix(tube, &bending.under(around.tension)),
            })
            .collect();
        let stiffness = elements.iter().map(|element| element.stiffness[0][0].abs());
        let mass = elements
            .iter()
            .map(|element| element.mass[0][0])
            .sum::<f64>();
        Ok(Self {
            nothing: ROUNDING * stiffness.fold(0.0, f64::max) / mass,
            elements,
            support,
            at_sites,
        })
    }

    /// What moves sideways, with the mud's share, kg.
    pub fn mass(&self) -> f64 {
        let moved = |element: &Element| -> f64 {
            let between = [(0, 0), (0, 2), (2, 0), (2, 2)];
            between
                .map(|(row, column)| element.mass[row][column])
                .iter()
                .sum()
        };
        self.elements.iter().map(moved).sum()
    }

    /// Natural frequencies whose square is below this, 1/s²; a square below zero is that of the
    /// rate at which a buckled string leaves its place.
    pub fn below(&self, square: f64) -> usize {
        let held = self.support.held();
        // What the string above makes of a node's displacement and slope.
        let mut above = [[0.0; 2]; 2];
        let mut negative = 0;
        let mut at_sites = self.at_sites.iter().peekable();
        for (index, element) in self.elements.iter().enumerate() {
            let entry = |row: usize, column: usize| {
                element.stiffness[row][column] - square * element.mass[row][column]
            };
            let block = |row: usize, column: usize| -> [[f64; 2]; 2] {
                [0, 1].map(|i| [0, 1].map(|j| entry(2 * row + i, 2 * column + j)))
            };
            let mut node = add(above, block(0, 0));
            let mut across = block(0, 1);
            if index == 0 {
                // What the surface holds is no degree of freedom.
                for freedom in 0..held {
                    across[freedom] = [0.0; 2];
                    for other in 0..2 {
                        node[freedom][other] = 0.0;
                        node[other][freedom] = 0.0;
                    }
                    node[freedom][freedom] = 1.0;
                }
            }
            negative += negative_eigenvalues(node);
            above = add(block(1, 1), less_by(node, across));
            while let Some((_, load)) = at_sites.next_if(|(at, _)| *at == index) {
                above[0][0] += load.spring - square * load.mass;
            }
        }
        negative + negative_eigenvalues(above)
    }

    /// Whether nothing brings the string back: of itself it leaves its straight course, as a
    /// column does under too much weight.
    pub fn is_buckled(&self) -> bool {
        self.below(-self.nothing) > 0
    }

    /// The natural frequency of this number, from 0 for the lowest, rad/s; rigid-body and buckling
    /// modes come first, and theirs is 0. `None` where the elements have fewer.
    pub fn frequency(&self, index: usize) -> Option<f64> {
        let mut high = self.nothing.max(f64::MIN_POSITIVE);
        if self.below(high) > index {
            return Some(0.0);
        }
        let mut low = high;
        while self.below(high) <= index {
            low = high;
            high *= 4.0;
            if !high.is_finite() {
                return None;
            }
        }
        while high - low > SAME_FREQUENCY * high {
            let middle = 0.5 * (low + high);
            if self.below(middle) > index {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some((0.5 * (low + high)).sqrt())
    }
}

/// The weight on bit, N, under which a string that hangs so buckles, with an axial force in pieces
/// of this tolerance; none where it does by its own weight alone.
///
/// # Errors
/// As [`BendingModes::new`].
pub fn buckling_weight(
    string: &Drillstring,
    hanging: &HangingString,
    (bending, support): (&Bending, SurfaceSupport),
    tolerance: f64,
) -> Result<Option<f64>, BuildError> {
    let is_buckled = |weight_on_bit: f64| -> Result<bool, BuildError> {
        let force = hanging.axial_force(bending, weight_on_bit, tolerance);
        let string = string.clone().under_axial_force(force)?;
        Ok(BendingModes::new(&string, bending, support)?.is_buckled())
    };
    if is_buckled(0.0)? {
        return Ok(None);
    }
    let (mut low, mut high) = (0.0, LEAST_WEIGHT);
    while !is_buckled(high)? {
        (low, high) = (high, 2.0 * high);
    }
    while high - low > SAME_WEIGHT * high {
        let middle = 0.5 * (low + high);
        if is_buckled(middle)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(Some(0.5 * (low + high)))
}

/// The stiffness, N/m, of equal springs at sites that keep a string from buckling, if any do: a few
/// times what is just enough. Zero where it needs none.
///
/// # Errors
/// As [`BendingModes::held`].
pub fn holding_spring(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    sites: &Sites,
) -> Result<Option<f64>, BuildError> {
    let is_buckled = |spring: f64| -> Result<bool, BuildError> {
        let sites = sites.clone().held_by(vec![spring; sites.len()])?;
        Ok(BendingModes::held(string, bending, support, &sites)?.is_buckled())
    };
    if !is_buckled(0.0)? {
        return Ok(Some(0.0));
    }
    let mut spring = SOFTEST_SPRING;
    while spring <= STIFFEST_SPRING {
        if !is_buckled(spring)? {
            return Ok(Some(FIRMLY * spring));
        }
        spring *= FIRMLY;
    }
    Ok(None)
}

fn add(one: [[f64; 2]; 2], other: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [0, 1].map(|i| [0, 1].map(|j| one[i][j] + other[i][j]))
}

fn negative_eigenvalues(symmetric: [[f64; 2]; 2]) -> usize {
    let [[a, b], [_, d]] = symmetric;
    match a * d - b * b {
        determinant if determinant < 0.0 => 1,
        _ if a + d < 0.0 => 2,
        _ => 0,
    }
}

/// −cᵀ n⁻¹ c: what a node that nothing acts on takes from the next.
fn less_by(node: [[f64; 2]; 2], across: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [[a, b], [_, d]] = node;
    let determinant = a * d - b * b;
    let inverse = [[d, -b], [-b, a]].map(|row| row.map(|it| it / determinant));
    let times = |i: usize, j: usize| -> f64 {
        (0..2)
            .flat_map(|k| (0..2).map(move |l| (k, l)))
            .map(|(k, l)| across[k][i] * inverse[k][l] * across[l][j])
            .sum()
    };
    [0, 1].map(|i| [0, 1].map(|j| -times(i, j)))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::drillstring::{Material, Section, Tube};

    /// A pinned column with a spring k in its middle buckles under 4π²EI/L² with a node there, if k
    /// is 16π²EI/L³ or more (Timoshenko and Gere, *Theory of Elastic Stability*, 1961, art. 2.6).
    #[test]
    fn a_spring_in_the_middle_holds_a_column_to_its_second_mode() {
        let steel = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let tube = Tube {
            length: 2.0,
            inner_radius: 0.05,
            outer_radius: 0.1,
        };
        let section = Section {
            repeat: 10,
            parts: vec![tube],
        };
        let string = Drillstring::new(steel, vec![section], 0.0).unwrap();
        let rigidity = 210e9 * tube.second_moment();
        let euler = PI * PI * rigidity / (20.0 * 20.0);
        let least = 16.0 * PI * PI * rigidity / 20f64.powi(3);
        let is_buckled = |load: f64, spring: f64| {
            let bending = Bending {
                youngs_modulus: 210e9,
                damping: 0.0,
                compression: load,
            };
            let sites = Sites::new(&string, &[10.0, 0.0]).unwrap();
            let held = sites.held_by(vec![spring, 1e12]).unwrap();
            let support = SurfaceSupport::Pinned;
            let modes = BendingModes::held(&string, &bending, support, &held);
            modes.unwrap().is_buckled()
        };
        assert!(!is_buckled(0.99 * euler, 0.0) && is_buckled(1.01 * euler, 0.0));
        assert!(!is_buckled(3.99 * euler, 1.02 * least) && is_buckled(3.99 * euler, 0.97 * least));
        assert!(is_buckled(4.01 * euler, 100.0 * least));
    }
}
