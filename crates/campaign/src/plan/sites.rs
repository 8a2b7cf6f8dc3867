//! The places on the string that are observed, or where the wall may be touched.

use linear::well::GRAVITY;
use linear::{Drillstring, Sites};

use super::candidates::{
    CANDIDATES_TO, CandidatePlaces, Candidates, MOST_CANDIDATES, SAG, SAG_AT_REST, Spans,
};
use super::contacts::StringInHole;
use crate::quantities::LONGEST_STRING;
use crate::sweep_file::{FileContent, SitesName, Source, SweepFileError};

/// The most sites listed in a message; of more, the nearest.
const MOST_LISTED: usize = 12;

/// Distance from a site, m, within which a place touches with it.
const OF_SITE: f64 = 0.25;

/// The sites of a string.
#[derive(Debug, Clone)]
pub struct Places {
    /// From the surface down.
    pub sites: Sites,
    /// Which site of the file each is, if one.
    pub given: Vec<Option<usize>>,
    /// Places no further apart than this, m, are one.
    same_place: f64,
}

/// The sites of the file, the bit where there is no wall, candidates where the file asks for
/// them, and those that were `found`, by their distances from the bit (m).
///
/// # Errors
/// Where one is not on the string, there are none to touch the wall, or too many.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    in_hole: &StringInHole,
    found: &[f64],
) -> Result<Places, SweepFileError> {
    let string = in_hole.string;
    let mut places = given(source, content, string)?;
    let same_place = string.same_place();
    let near = same_place.max(CANDIDATES_TO);
    let candidates = candidates(source, content, in_hole)?;
    for candidate in candidates.into_iter().chain(found.iter().copied()) {
        let is_given = |(given, _): &(f64, _)| (given - candidate).abs() <= near;
        // Candidates are further apart than that.
        if !places.iter().any(is_given) {
            places.push((candidate, None));
        }
    }
    let bit_is_site = places.iter().any(|(distance, _)| *distance == 0.0);
    let missing = if places.is_empty() {
        Some(
            "a wall needs `[[sites]]` where it may be touched, or `wall.sites = \"all\"` or `\"ends\"`",
        )
    } else if content.bit.is_some() && !bit_is_site {
        Some("a bit with `[bit]` is one of the `[[sites]]` of a wall: `distance_from_bit_m = 0`")
    } else {
        None
    };
    if let Some(message) = missing {
        let key = if content.sites.is_empty() {
            "wall"
        } else {
            "sites"
        };
        return Err(source.error(key, message));
    }
    places.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    let (distances, given): (Vec<f64>, Vec<_>) = places.into_iter().unzip();
    Ok(Places {
        sites: source.checked("sites", Sites::new(string, &distances))?,
        given,
        same_place,
    })
}

/// Distances of the file's sites from the bit, with their numbers; and that of the bit, where
/// there is no wall.
fn given(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
) -> Result<Vec<(f64, Option<usize>)>, SweepFileError> {
    let mut places = Vec::with_capacity(content.sites.len());
    // Without a wall, the bit is always observed.
    let has_bit = content.wall.is_none();
    if has_bit {
        places.push((0.0, None));
    }
    for (index, site) in content.sites.iter().enumerate() {
        if !has_bit || site.distance_from_bit_m != 0.0 {
            places.push((site.distance_from_bit_m, Some(index)));
        }
    }
    // The first site with which there is an error is to blame.
    let distances: Vec<f64> = places.iter().map(|(distance, _)| *distance).collect();
    let error_with = |count: usize| Sites::new(string, &distances[..count]).err();
    if !places.is_empty() && error_with(places.len()).is_some() {
        let counts: Vec<usize> = (1..=places.len()).collect();
        let fine = counts.partition_point(|&count| error_with(count).is_none());
        if let (Some((_, Some(index))), Some(error)) = (places.get(fine), error_with(fine + 1)) {
            let key = format!("sites[{index}].distance_from_bit_m");
            return Err(source.error(&key, error.to_string()));
        }
    }
    Ok(places)
}

/// Distances of candidates from the bit, m, if the file asks for any.
fn candidates(
    source: &Source,
    content: &FileContent,
    in_hole: &StringInHole,
) -> Result<Vec<f64>, SweepFileError> {
    let wall = content.wall.unwrap_or_default();
    for (key, value) in [
        ("wall.sites_every_m", wall.sites_every_m),
        ("wall.sites_to_m", wall.sites_to_m),
    ] {
        if let Some(value) = value {
            source.within(key, value, 1e-3, LONGEST_STRING, "m")?;
            let message =
                "says where sites may be: needs `sites = \"all\"`, `\"ends\"` or `\"auto\"`";
            source.refuse_if(wall.sites == SitesName::Given, key, message)?;
        }
    }
    let at = match (wall.sites, wall.sites_every_m) {
        (SitesName::Given | SitesName::Auto, _) => return Ok(Vec::new()),
        (SitesName::All, None) => CandidatePlaces::Middles,
        (SitesName::All, Some(every)) => CandidatePlaces::Every(every),
        (SitesName::Ends, every) => {
            CandidatePlaces::Ends(every.map_or_else(|| of_little_sag(content, SAG), Spans::Given))
        }
    };
    let found = candidates_at(at, content, in_hole);
    let within =
        (wall.sites_to_m).map_or_else(String::new, |to| format!(" up to {to} m from the bit"));
    let message = format!(
        "no part of the string{within} is wider than its neighbours: `sites_every_m` makes sites \
         at \
         even distances, and a part's `contact_radius_m` makes it wide"
    );
    source.refuse_if(found.is_empty(), "wall.sites", message)?;
    let message = format!(
        "there are more than {MOST_CANDIDATES} candidates{within}: `sites_to_m` ends them, and a \
         larger `sites_every_m` makes fewer"
    );
    source.refuse_if(found.len() > MOST_CANDIDATES, "wall.sites", message)?;
    Ok(found)
}

/// Where a string touches that lies in its hole, as `sites = "ends"` has it: m from the bit, in rising order.
pub fn ends(content: &FileContent, in_hole: &StringInHole) -> Vec<f64> {
    let at = CandidatePlaces::Ends(of_little_sag(content, SAG));
    let mut ends = candidates_at(at, content, in_hole);
    ends.sort_by(f64::total_cmp);
    ends
}

/// Candidates as far up as the file says, one more than the most at most.
fn candidates_at(at: CandidatePlaces, content: &FileContent, in_hole: &StringInHole) -> Vec<f64> {
    let to = content.wall.and_then(|wall| wall.sites_to_m);
    let which = Candidates {
        at,
        to: to.unwrap_or(f64::INFINITY),
    };
    let found = in_hole.candidates(which).take(MOST_CANDIDATES + 1);
    found.map(|it| it.distance_from_bit).collect()
}

/// Places besides sites of `"ends"`, m from the bit from the surface down, where a string that lies at
/// rest may touch, too: cases step their sites alone, as each takes time.
pub fn besides_ends(content: &FileContent, in_hole: &StringInHole, sites: &Sites) -> Vec<f64> {
    if content.wall.map(|wall| wall.sites) != Some(SitesName::Ends) || !content.lies_on_low_side() {
        return Vec::new();
    }
    let at = CandidatePlaces::Ends(of_little_sag(content, SAG_AT_REST));
    let sites = sites.distances_from_bit();
    let is_other = |place: &f64| {
        let next = sites.partition_point(|site| *site > place + OF_SITE);
        sites.get(next).is_none_or(|site| *site < place - OF_SITE)
    };
    let blades: Vec<[f64; 2]> = (in_hole.parts())
        .filter(|part| part.is_given)
        .map(|part| part.ends)
        .collect();
    let is_of_blades = |place: &f64| blades.iter().any(|[from, to]| (from..=to).contains(&place));
    let mut places = candidates_at(at, content, in_hole);
    places.retain(|place| is_other(place) && !is_of_blades(place));
    places.reverse();
    places
}

/// Spans that sag by no more than a part of what the wall of a file leaves them; of any length where the
/// string does not bend.
fn of_little_sag(content: &FileContent, part: f64) -> Spans {
    let string = &content.string;
    let bending = string.bending.as_ref();
    bending.map_or(Spans::Given(f64::INFINITY), |bending| Spans::OfLittleSag {
        stiffness_by_weight: 1e9 * bending.youngs_modulus_gpa / (string.density_kg_m3 * GRAVITY),
        clearance: content
            .wall
            .and_then(|wall| wall.clearance_mm)
            .map(|it| 1e-3 * it),
        part,
    })
}

impl Places {
    /// The number of the site that a disturbance is at.
    ///
    /// # Errors
    /// Where there is none.
    pub fn site_of(
        &self,
        source: &Source,
        key: &str,
        distance: f64,
    ) -> Result<usize, SweepFileError> {
        // They are in order, and may be many.
        let distances = self.sites.distances_from_bit();
        let index = distances.partition_point(|site| *site > distance + self.same_place);
        let found = distances.get(index);
        if found.is_some_and(|site| (site - distance).abs() <= self.same_place) {
            return Ok(index);
        }
        let listed = |sites: &[f64]| {
            let sites: Vec<String> = sites.iter().map(f64::to_string).collect();
            sites.join(", ")
        };
        let known = if distances.len() <= MOST_LISTED {
            format!("there are sites at {} m", listed(distances))
        } else {
            let nearest = &distances[index.saturating_sub(1)..distances.len().min(index + 1)];
            format!(
                "of {} sites the nearest are at {} m",
                distances.len(),
                listed(nearest)
            )
        };
        let message = format!("no site is {distance} m from the bit; {known}");
        Err(source.error(key, message))
    }
}
