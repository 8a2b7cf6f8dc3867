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
}

/// A string cut at its sites and at other places, some of which may be the same.
#[derive(Debug, Clone)]
pub(crate) struct SitesAndPlaces {
    /// Where it is cut, springs at sites held by them.
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
        let is_spring = |it: &&f64| it.is_finite() && **it >= 0.0;
        if let Some(&value) = springs.iter().find(|it| !is_spring(it)) {
            return Err(DrillstringError::Spring { value });
        }
        Ok(Self { springs, ..self })
    }

    /// The same sites, held by nothing.
    pub fn without_springs(&self) -> Self {
        Self {
            distances_from_bit: self.distances_from_bit.clone(),
            springs: Vec::new(),
        }
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
        if !self.springs.is_empty() {
            nodes.springs = vec![0.0; nodes.len()];
            for (site, spring) in sites.iter().zip(&self.springs) {
                nodes.springs[*site] = *spring;
            }
        }
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
