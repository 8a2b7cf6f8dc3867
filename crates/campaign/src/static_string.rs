//! The string as it lies at rest in its hole, and turning there: what it lies on, how it bends, and
//! how that stresses it, in the units of files.

use serde::Serialize;
use statics::closed_forms::buckling::half_wave;
use statics::{
    Bit, Contact, ContactState, Leaving, LeavingWay, LyingString, Place, StaticState, StaticsError,
};

use crate::engine::Clearances;
use crate::plan::{Conditions, Setting};
use crate::quantities::{LENGTH, TORQUE, Units, WIDTH};
use crate::snaking_above::SnakingAbove;

/// No weight on bit is larger, N.
const MOST_WEIGHT: f64 = 5e6;

/// A string that goes beyond its wall by more than this part of its greatest clearance is not held by
/// it.
const FAR_BEYOND: f64 = 0.75;

/// Sites to half a wave of buckling on the low side that hold a string about as a wall all along does.
const TO_HALF_WAVE: f64 = 2.5;

/// Cases that begin with a moment or a tilt that differs by more than this part, and a tilt by more than this
/// angle, rad, are reported.
const DIFFERS: f64 = 0.01;
const SAME_TILT: f64 = 5e-5;

/// What does where sites are found.
const FOUND_SITES: &str = "its other sites are found as each case is simulated";

/// The highest contacts that touch are bent by how the string is cut above them.
const BENT_BY_CUT: usize = 3;

/// A static state of the string of a setting.
#[derive(Debug, Clone)]
pub struct StaticString {
    /// As it lies at rest.
    pub state: StaticState,
    /// The same turning, where that is found.
    pub sliding: Option<StaticState>,
    /// What a string without stiffness presses each contact with that touches, N; none of others.
    pub soft: Vec<Option<f64>>,
    buckles_without_contacts: bool,
    /// The weight on bit from which on it does not stay there.
    leaving: Result<Option<Leaving>, StaticsError>,
    weight_on_bit_kn: f64,
    /// State with which cases begin, on their sites alone.
    on_sites: Option<StaticState>,
    /// Where the string of cases goes farthest beyond its wall between its sites.
    beyond: Option<BeyondWall>,
    /// Where it snakes above what is modelled, if it does.
    above: Option<SnakingAbove>,
    /// Distance of sites that hold a string about as its wall does, m.
    sites_every_m: Option<f64>,
    /// How many sites cases have.
    sites: usize,
    /// How long the string is, m.
    length: f64,
}

/// A string at rest in its hole.
#[derive(Debug, Clone, Serialize)]
pub struct AtRest {
    /// What the bit bears.
    pub weight_on_bit_kn: f64,
    /// How far up from the bit it is modelled.
    pub modelled_m: f64,
    /// How far up there are sites.
    pub sites_to_m: Option<f64>,
    /// How far up the greatest moment and stresses are looked for: next to its upper end, and above
    /// the highest sites, the string is bent by how it is cut.
    pub greatest_within_m: f64,
    /// How many sites cases have.
    pub sites: usize,
    /// How many places may touch here: sites, and with `"ends"` others between them.
    pub places: usize,
    /// State with which cases begin, where that differs by more than 1 %.
    pub in_cases: Option<InCases>,
    /// Those that touch, from the bit up.
    pub contacts: Vec<TouchingSite>,
    /// Where it goes farthest beyond its wall between its sites, if it does.
    pub beyond_wall: Option<BeyondWall>,
    /// Where it snakes above what is modelled, if it does.
    pub snakes_above: Option<SnakingAbove>,
    /// Of the bit on the rock, to the high side and to the right looking down.
    pub side_force_of_bit_kn: [f64; 2],
    /// Of the bit to the axis of the hole, towards the same.
    pub tilt_of_bit_deg: [f64; 2],
    /// Of the bending moment.
    pub greatest_moment_knm: Greatest,
    /// Of the stress by bending.
    pub greatest_bending_stress_mpa: Greatest,
    /// Of the von Mises stress, without torque.
    pub greatest_von_mises_mpa: Greatest,
    /// Whether nothing but its contacts keeps it from buckling.
    pub buckles_without_contacts: bool,
    /// Whether it stays there.
    pub is_stable: bool,
    /// The weight on bit from which on it does not stay as it lies at rest; none up to 5 MN, and where
    /// it leaves its place in another way.
    pub snakes_from_kn: Option<f64>,
    /// The weight on bit from which on, in a hole that turns, the greatest moment that weight adds grows
    /// by more than 2.5 % with each 1 % of weight.
    pub runs_away_from_kn: Option<f64>,
    /// The weight on bit at which, in a hole that turns, it jumps to another place before that.
    pub jumps_at_kn: Option<f64>,
    /// Why that weight is not known; none where it is.
    pub snakes_from_unknown: Option<String>,
    /// In steady rotation, sliding on all that it touches, where friction is known.
    pub turning: Option<Turning>,
}

/// A string at rest on the sites of cases alone.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct InCases {
    /// Greatest bending moment.
    pub greatest_moment_knm: f64,
    /// Tilt of the bit to the axis of the hole, to the high side and to the right looking down.
    pub tilt_of_bit_deg: [f64; 2],
    /// Distance of sites that would bring cases closer, m.
    #[serde(skip)]
    sites_every_m: Option<f64>,
}

/// Where a string goes farthest beyond its wall, which acts at its sites alone.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct BeyondWall {
    /// By how much.
    pub by_mm: f64,
    /// Where, from the bit.
    pub from_bit_m: f64,
    /// The clearance there.
    pub clearance_mm: f64,
    /// Whether sites are too few to hold it to its wall.
    pub is_far: bool,
    /// Distance of sites that hold it, m.
    #[serde(skip)]
    sites_every_m: Option<f64>,
    /// Whether others are found.
    #[serde(skip)]
    finds_sites: bool,
}

/// A string that turns and slides where it lies.
#[derive(Debug, Clone, Serialize)]
pub struct Turning {
    /// Of all contacts.
    pub friction_torque_knm: f64,
    /// From the low side, of the contact that climbs least, and of that which climbs most.
    pub climb_deg: [f64; 2],
}

/// The greatest of what varies along the string.
#[derive(Debug, Clone, Serialize)]
pub struct Greatest {
    /// How great.
    pub value: f64,
    /// Where, from the bit.
    pub from_bit_m: f64,
}

/// Where it touches.
#[derive(Debug, Clone, Serialize)]
pub struct TouchingSite {
    /// Where, from the bit.
    pub site_from_bit_m: f64,
    /// What the wall presses with.
    pub force_kn: f64,
    /// Around the hole, from its low side to the right looking down.
    pub angle_deg: f64,
}

/// A row of a table: its columns, each with its name.
pub type NamedFields<const COLUMNS: usize> = [(&'static str, Option<f64>); COLUMNS];

impl StaticString {
    /// That of a setting under conditions, if the course of its well is known and it may touch its
    /// wall: its bit held as is said, or else as in a case.
    ///
    /// # Errors
    /// Where it has none.
    pub fn of(
        setting: &Setting,
        conditions: &Conditions,
        bit: Option<Bit>,
    ) -> Option<Result<Self, StaticsError>> {
        let in_cases = setting.lying_string(conditions, bit)?;
        let view = |lying: LyingString| {
            let in_cases = in_cases?;
            let state = lying.at_rest()?;
            let on_sites = in_cases.at_rest().ok();
            let frictions = setting.sliding_frictions(conditions);
            // A pinned bit may be one contact more, which nothing rubs on, and a free one none.
            let frictions = frictions.map(|mut it| {
                it.resize(in_cases.contacts().len(), 0.0);
                it
            });
            let touching = state.contacts().iter().filter(|it| it.touches);
            let places: Vec<f64> = touching.map(|it| it.contact.distance_from_bit).collect();
            let soft = setting.soft_forces(conditions, (&places, state.top()));
            let mut soft = soft.unwrap_or_default().into_iter();
            let contacts = state.contacts().iter();
            let soft = contacts.map(|it| it.touches.then(|| soft.next()).flatten());
            let beyond = on_sites.as_ref();
            Ok(Self {
                buckles_without_contacts: lying.buckles_without_contacts(),
                leaving: lying.leaving(MOST_WEIGHT),
                sliding: frictions.and_then(|it| in_cases.sliding_with(&it).ok()),
                soft: soft.collect(),
                weight_on_bit_kn: conditions.weight_on_bit_kn.unwrap_or(0.0),
                length: setting.string.length(),
                beyond: beyond.and_then(|it| BeyondWall::of(setting, conditions, it)),
                sites_every_m: spacing(setting, conditions),
                above: SnakingAbove::of(setting, conditions),
                sites: setting.sites.len(),
                on_sites,
                state,
            })
        };
        Some(setting.resting_string(conditions, bit)?.and_then(view))
    }

    /// State with which cases begin, where that differs from this.
    fn in_cases(&self, to: f64) -> Option<InCases> {
        let on_sites = self.on_sites.as_ref()?;
        let (_, here) = self.state.greatest_moment(to);
        let (_, there) = on_sites.greatest_moment(to);
        let tilts = [&self.state, on_sites].map(StaticState::tilt_of_bit);
        let [[x, y], [other_x, other_y]] = tilts;
        let differs = (there - here).abs() > DIFFERS * here
            || (x - other_x).hypot(y - other_y) > SAME_TILT.max(DIFFERS * x.hypot(y));
        differs.then(|| InCases {
            greatest_moment_knm: 1e-3 * there,
            tilt_of_bit_deg: tilts[1].map(f64::to_degrees),
            sites_every_m: self.sites_every_m,
        })
    }

    /// Its numbers.
    pub fn numbers(&self) -> AtRest {
        let state = &self.state;
        let greatest = |scale: f64, (from_bit_m, value): (f64, f64)| Greatest {
            value: scale * value,
            from_bit_m,
        };
        // Places besides sites are close together.
        let to = trusted(self.on_sites.as_ref().unwrap_or(state), self.length);
        let touching = state.contacts().iter().rev().filter(|it| it.touches);
        let contact = |it: &ContactState| TouchingSite {
            site_from_bit_m: it.contact.distance_from_bit,
            force_kn: 1e-3 * it.normal(),
            angle_deg: it.climb().to_degrees(),
        };
        AtRest {
            weight_on_bit_kn: self.weight_on_bit_kn,
            modelled_m: state.top(),
            sites_to_m: state
                .contacts()
                .first()
                .map(|it| it.contact.distance_from_bit),
            greatest_within_m: to,
            sites: self.sites,
            places: state.contacts().len(),
            in_cases: self.in_cases(to),
            contacts: touching.map(contact).collect(),
            beyond_wall: self.beyond,
            snakes_above: self.above,
            side_force_of_bit_kn: state.side_force_at_bit().map(|force| 1e-3 * force),
            tilt_of_bit_deg: state.tilt_of_bit().map(f64::to_degrees),
            greatest_moment_knm: greatest(1e-3, state.greatest_moment(to)),
            greatest_bending_stress_mpa: greatest(1e-6, state.greatest_bending_stress(to)),
            greatest_von_mises_mpa: greatest(1e-6, state.greatest_von_mises(to)),
            buckles_without_contacts: self.buckles_without_contacts,
            is_stable: state.is_stable(),
            snakes_from_kn: self.leaving_by(LeavingWay::Buckles),
            runs_away_from_kn: self.leaving_by(LeavingWay::RunsAway),
            jumps_at_kn: self.leaving_by(LeavingWay::Jumps),
            snakes_from_unknown: (self.leaving.as_ref().err()).map(StaticsError::to_string),
            turning: self.sliding.as_ref().map(Turning::of),
        }
    }

    /// The weight on bit from which on it leaves its place in a way, kN.
    fn leaving_by(&self, way: LeavingWay) -> Option<f64> {
        let leaving = self.leaving.as_ref().ok()?.as_ref()?;
        (leaving.way == way).then_some(1e-3 * leaving.weight_on_bit)
    }

    /// The string at the ends of its elements, from the bit up.
    pub fn along(&self) -> Vec<NamedFields<9>> {
        let mut places: Vec<Place> = self.state.along().collect();
        places.reverse();
        let row = |it: &Place| {
            let [high, right] = it.by_high_side(it.displacement);
            let [moment_high, moment_right] = it.by_high_side(it.moment);
            let stress = it.stress;
            [
                ("distance_from_bit_m", it.distance_from_bit),
                ("high_side_mm", 1e3 * high),
                ("right_mm", 1e3 * right),
                ("tension_kn", 1e-3 * it.tension),
                ("moment_to_high_side_knm", 1e-3 * moment_high),
                ("moment_to_right_knm", 1e-3 * moment_right),
                ("axial_stress_mpa", 1e-6 * stress.axial),
                ("bending_stress_mpa", 1e-6 * stress.bending),
                ("von_mises_mpa", 1e-6 * stress.von_mises),
            ]
            .map(|(name, value)| (name, Some(value)))
        };
        places.iter().map(row).collect()
    }

    /// Its sites, from the bit up.
    pub fn sites(&self) -> Vec<NamedFields<8>> {
        let sites = self.state.contacts().iter().enumerate().rev();
        let row = |(site, it): (usize, &ContactState)| {
            let [high, right] = it.by_high_side(it.displacement);
            let is_here = |other: &&ContactState| {
                other.touches && other.contact.distance_from_bit == it.contact.distance_from_bit
            };
            let sliding = self.sliding.as_ref();
            let sliding = sliding.and_then(|state| state.contacts().iter().find(is_here));
            [
                ("site_from_bit_m", Some(it.contact.distance_from_bit)),
                ("clearance_mm", Some(1e3 * it.contact.clearance)),
                ("high_side_mm", Some(1e3 * high)),
                ("right_mm", Some(1e3 * right)),
                ("force_kn", Some(1e-3 * it.normal())),
                ("soft_string_kn", self.soft[site].map(|force| 1e-3 * force)),
                ("sliding_force_kn", sliding.map(|it| 1e-3 * it.normal())),
                (
                    "sliding_climb_deg",
                    sliding.map(|it| it.climb().to_degrees()),
                ),
            ]
        };
        sites.map(row).collect()
    }
}

/// The distance between sites, m, of which there are two to three to half a wave of buckling on the low side
/// wherever it lies in its hole, rounded down to a tenth.
fn spacing(setting: &Setting, conditions: &Conditions) -> Option<f64> {
    let (lying, lateral) = (setting.lying.as_ref()?, setting.lateral.as_ref()?);
    let (modelled, length) = (setting.string.bending_length(), setting.string.length());
    let sites = setting
        .sites
        .distances_from_bit()
        .iter()
        .zip(&lateral.walls);
    let sites = sites.map(|(place, wall)| (*place, wall.in_case(conditions).clearance));
    let walls = Clearances::around(setting, conditions, sites)?;
    let all = lying
        .along(&setting.string, (lateral, conditions))
        .into_iter();
    let within = all.filter(|it| it.load > 0.0 && length - it.depth <= modelled);
    let waves = within.filter_map(|it| {
        let [(section, part), _] = setting.string.parts_around(length - it.depth);
        let tube = setting.string.sections()[section].parts[part];
        let rigidity = lateral.bending.youngs_modulus * tube.second_moment();
        // Pipe lies on its joints.
        let clearance = walls.at(it.depth)? + tube.outer_radius - it.radius;
        (clearance > 0.0).then(|| half_wave(rigidity, it.load, clearance))
    });
    let shortest = waves.fold(f64::INFINITY, f64::min);
    let spacing = (10.0 * shortest / TO_HALF_WAVE).floor() / 10.0;
    (spacing.is_finite() && spacing > 0.0).then_some(spacing)
}

/// How far from the bit, m, a string of a length (m) is as it would be in a longer model: where it is
/// cut, up to the last contacts but some.
fn trusted(state: &StaticState, length: f64) -> f64 {
    let top = state.top();
    if top >= length {
        return top;
    }
    let touching = state.contacts().iter().filter(|it| it.touches);
    let distances = touching.map(|it| it.contact.distance_from_bit);
    let below = distances.skip(BENT_BY_CUT).find(|it| *it > 0.0);
    below.unwrap_or(top)
}

impl BeyondWall {
    /// That of a setting at rest under conditions, where the string lies in its hole and goes far
    /// beyond its wall, and no other sites are found.
    pub fn far(setting: &Setting, conditions: &Conditions) -> Option<Self> {
        let lying = setting.lying_string(conditions, None)?.ok()?;
        let beyond = Self::of(setting, conditions, &lying.at_rest().ok()?)?;
        (beyond.is_far && !beyond.finds_sites).then_some(beyond)
    }

    /// By how much and where, in units, and what keeps it from that where it is far.
    pub fn words(&self, units: Units) -> String {
        let by = units.of(&WIDTH).text(self.by_mm, 2);
        let place = units.of(&LENGTH).text(self.from_bit_m, 2);
        let advice = match (self.is_far, self.finds_sites) {
            (false, _) => String::new(),
            (true, false) => format!(": too few sites there: {}", more_sites(self.sites_every_m)),
            (true, true) => format!(": {FOUND_SITES}"),
        };
        format!("up to {by} beyond its wall, {place} from the bit{advice}")
    }

    /// As far as it is as in a longer model and has sites, unless the bit is the only one.
    fn of(setting: &Setting, conditions: &Conditions, state: &StaticState) -> Option<Self> {
        // One that is held in the middle has no wall.
        let contacts = state.contacts().iter();
        let contacts: Vec<&Contact> = contacts
            .filter(|it| it.displacement != [0.0; 2])
            .map(|it| &it.contact)
            .collect();
        let sites = contacts
            .iter()
            .map(|it| (it.distance_from_bit, it.clearance));
        let walls = Clearances::around(setting, conditions, sites)?;
        let length = setting.string.length();
        let highest = contacts.first().map(|it| it.distance_from_bit);
        let highest = highest.filter(|it| *it > 0.0);
        let to = trusted(state, length).min(highest.unwrap_or(length));
        let is_between = |place: &Place| {
            let mut sites = contacts.iter();
            let is_site = sites.any(|it| it.distance_from_bit == place.distance_from_bit);
            place.distance_from_bit <= to && !is_site
        };
        let sites_every_m = spacing(setting, conditions);
        let clearances = contacts.iter().map(|it| it.clearance);
        let greatest = clearances.fold(0.0, f64::max);
        let beyond = |place: Place| {
            let clearance = walls.at(length - place.distance_from_bit)?;
            let [x, y] = place.displacement;
            let by = x.hypot(y) - clearance;
            Some(Self {
                by_mm: 1e3 * by,
                from_bit_m: place.distance_from_bit,
                clearance_mm: 1e3 * clearance,
                is_far: by > FAR_BEYOND * greatest.max(clearance),
                sites_every_m,
                finds_sites: (setting.lateral.as_ref()).is_some_and(|it| it.finding.is_some()),
            })
        };
        let between = state.along().filter(is_between).filter_map(beyond);
        let farthest = between.max_by(|one, other| one.by_mm.total_cmp(&other.by_mm));
        farthest.filter(|it| it.by_mm > 0.0)
    }
}

impl InCases {
    /// Words and numbers of that, in units.
    pub fn words(&self, units: Units) -> String {
        let moment = units.of(&TORQUE).kilo().text(self.greatest_moment_knm, 2);
        let [high, right] = self.tilt_of_bit_deg;
        let more = more_sites(self.sites_every_m);
        format!(
            "on their sites alone a moment of {moment} and a tilt of {:.4}°: {more} bring them closer",
            high.hypot(right)
        )
    }
}

/// Advice that gives cases more sites, at a distance (m).
fn more_sites(every: Option<f64>) -> String {
    let every = every.map_or("a smaller `sites_every_m`".to_owned(), |it| {
        format!("`sites_every_m = {it}` or less")
    });
    format!("`sites = \"ends\"` with {every}")
}

impl Turning {
    fn of(state: &StaticState) -> Self {
        let touching = state.contacts().iter().filter(|it| it.touches);
        let climbs = touching.map(|it| it.climb().to_degrees());
        let (least, greatest) = climbs.fold((f64::INFINITY, f64::NEG_INFINITY), |ends, climb| {
            (ends.0.min(climb), ends.1.max(climb))
        });
        Self {
            friction_torque_knm: 1e-3 * state.friction_torque(),
            climb_deg: [least, greatest],
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::plan::Sweep;

    /// A string of sections in an inclined hole (deg, in), with sites.
    fn in_hole(sections: &[&str], inclination: f64, hole: f64, sites: &str) -> Sweep {
        let sections: String = (sections.iter())
            .map(|section| format!("[[string.sections]]\n{section}\n"))
            .collect();
        let text = format!(
            "surface_speed_rpm = 60\n[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 10\n\
             bending = {{ youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }}\n{sections}\
             [well]\ninclination_deg = {inclination}\nhole_diameter_in = {hole}\n\
             [wall]\nclearance = \"hole\"\nfriction = 0.3\n{sites}\n"
        );
        let read = |_: &Path, _: u64| Ok(text.clone());
        Sweep::read_from(Path::new("sweep.toml"), &[], &read).unwrap()
    }

    const ONE_PIPE: &str =
        "repeat = 1\nparts = [{ length_m = 800, inner_radius_m = 0.054, outer_radius_m = 0.0635 }]";
    const THIN_PIPE: &str = "repeat = 70\nparts = [{ length_m = 9.6, inner_radius_m = 0.035, outer_radius_m = 0.0445 }]";
    const JOINTED: &str = "repeat = 60\nparts = [\
        { length_m = 9.1, inner_radius_m = 0.054, outer_radius_m = 0.0635 },\
        { length_m = 0.4, inner_radius_m = 0.041, outer_radius_m = 0.084 }]";
    const COLLAR: &str =
        "repeat = 1\nparts = [{ length_m = 90, inner_radius_m = 0.036, outer_radius_m = 0.083 }]";
    const COLLARS: &str =
        "repeat = 12\nparts = [{ length_m = 9.2, inner_radius_m = 0.036, outer_radius_m = 0.083 }]";

    #[test]
    fn strings_on_the_ends_of_their_parts_stay_within_their_wall() {
        let strings: [&[&str]; 6] = [
            &[ONE_PIPE],
            &[THIN_PIPE],
            &[JOINTED],
            &[ONE_PIPE, COLLAR],
            &[THIN_PIPE, COLLARS],
            &[JOINTED, COLLAR],
        ];
        // Level and without mud, spans sag by half of their clearance as that next to a support that
        // turns: a little more where the other end turns, too.
        let mut most = 0.0_f64;
        for sections in strings {
            for inclination in [15.0, 45.0, 90.0] {
                for hole in [8.5, 12.25, 17.5] {
                    let ends = "sites = \"ends\"\nsites_to_m = 250";
                    let sweep = in_hole(sections, inclination, hole, ends);
                    let lying = sweep.setting.lying_string(&sweep.conditions, None);
                    let state = lying.unwrap().unwrap().at_rest().unwrap();
                    let beyond = BeyondWall::of(&sweep.setting, &sweep.conditions, &state);
                    let part = beyond.map_or(0.0, |it| it.by_mm / it.clearance_mm);
                    most = most.max(part);
                }
            }
        }
        assert!((0.3..0.6).contains(&most), "{most}");
    }

    #[test]
    fn a_string_on_two_sites_is_far_beyond_its_wall() {
        let sites = "[[sites]]\ndistance_from_bit_m = 0\n[[sites]]\ndistance_from_bit_m = 60\n";
        let sweep = in_hole(&[ONE_PIPE, COLLAR], 60.0, 12.25, sites);
        let beyond = BeyondWall::far(&sweep.setting, &sweep.conditions).unwrap();
        assert!((20.0..40.0).contains(&beyond.from_bit_m), "{beyond:?}");
        // A bit that is held in the middle of its hole, and no site, has no clearance to compare with.
        let sites = "[[sites]]\ndistance_from_bit_m = 24\n[[sites]]\ndistance_from_bit_m = 48\n";
        let sweep = in_hole(&[ONE_PIPE, COLLAR], 60.0, 12.25, sites);
        let pinned = StaticString::of(&sweep.setting, &sweep.conditions, Some(Bit::Pinned));
        assert!(pinned.unwrap().unwrap().beyond.unwrap().is_far);
    }
}
