//! The sites of a string (Table 2, Fig. 5): where something acts on it or its motion is observed.

use crate::drillstring::Drillstring;
use crate::error::DrillstringError;

/// The places where something acts on the string or its motion is observed, from the surface down.
///
/// ```
/// use linear::{Drillstring, DrillstringError, Material, Section, Sites, Tube};
///
/// let steel = Material { shear_modulus: 80e9, density: 7840.0 };
/// let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
/// let string = Drillstring::new(steel, vec![Section { repeat: 100, parts: vec![pipe] }], 0.0)?;
/// let sites = Sites::new(&string, &[30.0, 0.0])?;
/// assert_eq!(sites.bit_site(), Some(1));
/// let refused = Sites::new(&string, &[1200.0]);
/// assert!(matches!(refused, Err(DrillstringError::SiteOffString { .. })));
/// # Ok::<(), DrillstringError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sites {
    /// Distances from the bit, m, strictly decreasing.
    distances_from_bit: Vec<f64>,
    /// Stiffness of a spring sideways at each, N/m; empty where there are none.
    springs: Vec<f64>,
    /// Mass that moves sideways with each besides the string's, kg; empty where there is none.
    masses: Vec<f64>,
}

/// A spring and a mass at a site of a string in bending.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct AtSite {
    /// N/m.
    pub spring: f64,
    /// kg.
    pub mass: f64,
}

/// A string cut at its sites and at other places, some of which may be the same.
#[derive(Debug, Clone)]
pub(crate) struct SitesAndPlaces {
    /// Where it is cut, with the springs and masses of the sites.
    pub nodes: Sites,
    /// The sites by their numbers among these, from the surface down.
    pub sites: Vec<usize>,
    /// The same of the places.
    pub places: Vec<usize>,
}

impl SitesAndPlaces {
    /// Each place with each site, by their numbers.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        let with_sites = |place: &usize| {
            let place = *place;
            self.sites.iter().map(move |site| (place, *site))
        };
        self.places.iter().flat_map(with_sites)
    }
}

impl Sites {
    /// Sites at the given distances from the bit (m), in any order; they are
    /// numbered from the surface down, so that the bit, if it is one, is last.
    ///
    /// # Errors
    /// Where there is none, one is not between the bit and the surface, or
    /// two are at one place.
    pub fn new(string: &Drillstring, distances_from_bit: &[f64]) -> Result<Self, DrillstringError> {
        let mut sorted = distances_from_bit.to_vec();
        sorted.sort_by(|a, b| b.total_cmp(a));
        // Distances are differences of sums, on either side of the bit.
        match sorted.last_mut() {
            None => return Err(DrillstringError::NoSites),
            Some(last) if last.abs() <= string.same_place() => *last = 0.0,
            Some(_) => {}
        }
        let sites = Self {
            distances_from_bit: sorted,
            springs: Vec::new(),
            masses: Vec::new(),
        };
        sites.check(string)?;
        Ok(sites)
    }

    /// Checks that these are places of `string`, which may be another than that
    /// they were made for.
    ///
    /// # Errors
    /// Where one is not between the bit and the surface, or two are at one place.
    pub fn check(&self, string: &Drillstring) -> Result<(), DrillstringError> {
        let length = string.length();
        let same_place = string.same_place();
        for &distance in &self.distances_from_bit {
            if !(distance >= 0.0 && distance < length - same_place) {
                return Err(DrillstringError::SiteOffString { distance, length });
            }
        }
        let mut pairs = self.distances_from_bit.windows(2);
        match pairs.find(|pair| pair[0] - pair[1] <= same_place) {
            Some(pair) => Err(DrillstringError::SitesCoincide { distance: pair[1] }),
            None => Ok(()),
        }
    }

    /// The bit alone.
    pub fn bit() -> Self {
        Self {
            distances_from_bit: vec![0.0],
            springs: Vec::new(),
            masses: Vec::new(),
        }
    }

    /// The same sites, each held sideways by a spring (N/m). A string that buckles between the walls
    /// that hold it has no responses that fade; with springs it has, and a law that takes them back,
    /// F + k u in place of F, leaves the string as it is.
    ///
    /// # Errors
    /// Where there is no such spring, or not one for each site.
    pub fn held_by(self, springs: Vec<f64>) -> Result<Self, DrillstringError> {
        let (found, sites) = (springs.len(), self.len());
        if found != sites {
            return Err(DrillstringError::NotASpringForEachSite { found, sites });
        }
        if let Some(value) = not_of_a_site(&springs) {
            return Err(DrillstringError::Spring { value });
        }
        Ok(Self { springs, ..self })
    }

    /// Sites with a mass (kg) at each of these that moves sideways with the string and turns nothing.
    ///
    /// # Errors
    /// Where there is no such mass, or not one for each site.
    pub fn carrying(self, masses: Vec<f64>) -> Result<Self, DrillstringError> {
        let (found, sites) = (masses.len(), self.len());
        if found != sites {
            return Err(DrillstringError::NotAMassForEachSite { found, sites });
        }
        if let Some(value) = not_of_a_site(&masses) {
            return Err(DrillstringError::Mass { value });
        }
        Ok(Self { masses, ..self })
    }

    /// The same sites with their masses, held by nothing.
    pub fn without_springs(&self) -> Self {
        Self {
            springs: Vec::new(),
            ..self.clone()
        }
    }

    /// One of the sites by its number, with others only where they carry a mass, and its number among
    /// these.
    pub fn alone(&self, site: usize) -> (Self, usize) {
        let kept = |other: &usize| *other == site || self.mass_at(*other) > 0.0;
        let kept: Vec<usize> = (0..self.len()).filter(kept).collect();
        let of = |all: &[f64]| kept.iter().filter_map(|it| all.get(*it)).copied().collect();
        let alone = Self {
            distances_from_bit: of(&self.distances_from_bit),
            springs: Vec::new(),
            masses: of(&self.masses),
        };
        let number = kept.iter().position(|other| *other == site);
        (alone, number.unwrap_or(0))
    }

    /// The string cut at other places, too, by their distances from the bit (m, from the surface down),
    /// which nothing holds.
    pub(crate) fn with_places(
        &self,
        string: &Drillstring,
        places: &[f64],
    ) -> Result<SitesAndPlaces, DrillstringError> {
        let same_place = string.same_place();
        let is_at = |place: f64| move |other: &f64| (other - place).abs() <= same_place;
        let own = &self.distances_from_bit;
        let apart = places
            .iter()
            .filter(|place| !own.iter().any(is_at(**place)));
        let all: Vec<f64> = own.iter().chain(apart).copied().collect();
        let mut nodes = Self::new(string, &all)?;
        let numbers = |distances: &[f64]| -> Vec<usize> {
            let all = &nodes.distances_from_bit;
            let number = |place: &f64| all.iter().position(is_at(*place));
            distances.iter().filter_map(number).collect()
        };
        let (sites, places) = (numbers(own), numbers(places));
        let at_nodes = |own: &[f64]| {
            let mut all = vec![0.0; if own.is_empty() { 0 } else { nodes.len() }];
            for (site, own) in sites.iter().zip(own) {
                all[*site] = *own;
            }
            all
        };
        (nodes.springs, nodes.masses) = (at_nodes(&self.springs), at_nodes(&self.masses));
        Ok(SitesAndPlaces {
            nodes,
            sites,
            places,
        })
    }

    /// Stiffness of the spring at each site, N/m; nothing where there are none.
    pub fn springs(&self) -> &[f64] {
        &self.springs
    }

    /// Mass at each site besides the string's, kg; nothing where there is none.
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    fn mass_at(&self, site: usize) -> f64 {
        self.masses.get(site).copied().unwrap_or(0.0)
    }

    /// Spring and mass at each site besides the string.
    pub(crate) fn loads(&self) -> Vec<AtSite> {
        let load = |site: usize| AtSite {
            spring: self.springs.get(site).copied().unwrap_or(0.0),
            mass: self.mass_at(site),
        };
        (0..self.len()).map(load).collect()
    }

    /// Number of sites, at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is always one")]
    pub fn len(&self) -> usize {
        self.distances_from_bit.len()
    }

    /// Distances from the bit, m, from the surface down.
    pub fn distances_from_bit(&self) -> &[f64] {
        &self.distances_from_bit
    }

    /// The number of the site that is the bit itself: the last, if any.
    pub fn bit_site(&self) -> Option<usize> {
        let last = self.len() - 1;
        (self.distances_from_bit[last] == 0.0).then_some(last)
    }

    /// Distances from the surface, m.
    pub(crate) fn depths(&self, string: &Drillstring) -> impl Iterator<Item = f64> {
        let length = string.length();
        self.distances_from_bit
            .iter()
            .map(move |distance| length - distance)
    }
}

/// The first number that is not finite, or below zero.
fn not_of_a_site(numbers: &[f64]) -> Option<f64> {
    let is_one = |number: &&f64| number.is_finite() && **number >= 0.0;
    numbers.iter().find(|number| !is_one(number)).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::academic;

    #[test]
    fn what_is_no_place_of_the_string_is_refused() {
        let string = academic::string();
        for distances in [&[1000.0][..], &[-1.0], &[5.0, 5.0], &[]] {
            assert!(Sites::new(&string, distances).is_err(), "{distances:?}");
        }
    }

    /// 170 × 11.87 m less as much, added up otherwise.
    #[test]
    fn a_site_that_rounding_puts_below_the_bit_is_at_the_bit() {
        let sites = Sites::new(&academic::string(), &[100.0, -2.3e-13]).unwrap();
        assert_eq!(sites.distances_from_bit(), [100.0, 0.0]);
        assert_eq!(sites.bit_site(), Some(1));
    }
}
