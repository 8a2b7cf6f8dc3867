//! The string at rest in its hole: what it lies on, how it bends, and how that stresses it.

use anyhow::Result;
use serde::Serialize;
use statics::{ContactState, LyingString, Place, StaticState, StaticsError};

use super::rows::row;
use crate::commands::csv_table::csv_table;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, LENGTH, STRESS, TORQUE, Unit, Units, WIDTH};
use campaign::words::counted;
use plot::{Axis, LineStyle, Look, Panel, Picture, Series, Wall, panels};

/// Of more contacts that touch only this number, those next to the bit, have a line each.
const MOST_LINES: usize = 20;

/// No weight on bit is larger, N.
const MOST_WEIGHT: f64 = 5e6;

/// The highest contacts that touch are bent by how the string is cut above them.
const BENT_BY_CUT: usize = 3;

/// The part of the string that is drawn, from the bit up, m: above it the same returns at every joint.
const REACH_SHOWN: f64 = 120.0;

/// The string at rest in numbers; or why it has no such state.
#[derive(Serialize)]
#[serde(untagged)]
pub enum InspectedLying {
    /// It lies there.
    AtRest(AtRest),
    /// It does not, or that is not found.
    Refused {
        /// Why.
        error: String,
    },
}

/// A string at rest in its hole.
#[derive(Serialize)]
pub struct AtRest {
    weight_on_bit_kn: f64,
    /// How far up from the bit it is modelled.
    modelled_m: f64,
    /// How far up there are sites.
    sites_to_m: Option<f64>,
    /// How far up the greatest moment and stresses are looked for: next to its upper end, and above
    /// the highest sites, the string is bent by how it is cut.
    greatest_within_m: f64,
    sites: usize,
    contacts: Vec<InspectedContact>,
    /// Of the bit on the rock, to the high side and to the right looking down.
    side_force_of_bit_kn: [f64; 2],
    /// Of the bit to the axis of the hole, towards the same.
    tilt_of_bit_deg: [f64; 2],
    greatest_moment_knm: Greatest,
    greatest_bending_stress_mpa: Greatest,
    greatest_von_mises_mpa: Greatest,
    /// Whether nothing but its contacts keeps it from buckling.
    buckles_without_contacts: bool,
    is_stable: bool,
    /// The weight on bit from which on it does not stay as it lies at rest; none up to 5 MN.
    snakes_from_kn: Option<f64>,
    /// In steady rotation, sliding on all that it touches, where friction is known.
    turning: Option<Turning>,
}

/// A string that turns and slides where it lies.
#[derive(Serialize)]
struct Turning {
    /// Of all contacts.
    friction_torque_knm: f64,
    /// From the low side, of the contact that climbs least, and of that which climbs most.
    climb_deg: [f64; 2],
}

/// The greatest of what varies along the string.
#[derive(Serialize)]
struct Greatest {
    value: f64,
    from_bit_m: f64,
}

/// Where it touches.
#[derive(Serialize)]
struct InspectedContact {
    site_from_bit_m: f64,
    force_kn: f64,
    /// Around the hole, from its low side to the right looking down.
    angle_deg: f64,
}

/// A static state of a sweep's string.
pub struct LyingView<'a> {
    sweep: &'a Sweep,
    state: StaticState,
    buckles_without_contacts: bool,
    /// The weight on bit from which on it does not stay there, N.
    snaking_weight: Option<f64>,
    /// The same turning, where that is found.
    sliding: Option<StaticState>,
    /// What a string without stiffness presses each contact with that touches, N; none of others.
    soft: Vec<Option<f64>>,
}

impl<'a> LyingView<'a> {
    /// That of a sweep, if the course of its well is known and it may touch its wall; why it has
    /// none, where that is so.
    pub fn of(sweep: &'a Sweep) -> Option<Result<Self, String>> {
        let (setting, conditions) = (&sweep.setting, &sweep.conditions);
        let view = |lying: LyingString| {
            let state = lying.at_rest()?;
            let frictions = setting.sliding_frictions(conditions);
            let touching = state.contacts().iter().filter(|it| it.touches);
            let places: Vec<f64> = touching.map(|it| it.contact.distance_from_bit).collect();
            let soft = setting.soft_forces(conditions, (&places, state.top()));
            let mut soft = soft.unwrap_or_default().into_iter();
            let contacts = state.contacts().iter();
            let soft = contacts.map(|it| it.touches.then(|| soft.next()).flatten());
            Ok::<_, StaticsError>(Self {
                sweep,
                buckles_without_contacts: lying.buckles_without_contacts(),
                snaking_weight: lying.snaking_weight(MOST_WEIGHT),
                sliding: frictions.and_then(|it| lying.sliding_with(&it).ok()),
                soft: soft.collect(),
                state,
            })
        };
        let found = setting.lying_string(conditions)?.and_then(view);
        Some(found.map_err(|error| error.to_string()))
    }

    /// Its numbers.
    pub fn numbers(&self) -> AtRest {
        let state = &self.state;
        let greatest = |scale: f64, (from_bit_m, value): (f64, f64)| Greatest {
            value: scale * value,
            from_bit_m,
        };
        let to = self.trusted();
        let touching = state.contacts().iter().rev().filter(|it| it.touches);
        let contact = |it: &ContactState| InspectedContact {
            site_from_bit_m: it.contact.distance_from_bit,
            force_kn: 1e-3 * it.normal(),
            angle_deg: it.climb().to_degrees(),
        };
        AtRest {
            weight_on_bit_kn: self.sweep.conditions.weight_on_bit_kn.unwrap_or(0.0),
            modelled_m: state.top(),
            sites_to_m: state
                .contacts()
                .first()
                .map(|it| it.contact.distance_from_bit),
            greatest_within_m: to,
            sites: state.contacts().len(),
            contacts: touching.map(contact).collect(),
            side_force_of_bit_kn: state.side_force_at_bit().map(|force| 1e-3 * force),
            tilt_of_bit_deg: state.tilt_of_bit().map(f64::to_degrees),
            greatest_moment_knm: greatest(1e-3, state.greatest_moment(to)),
            greatest_bending_stress_mpa: greatest(1e-6, state.greatest_bending_stress(to)),
            greatest_von_mises_mpa: greatest(1e-6, state.greatest_von_mises(to)),
            buckles_without_contacts: self.buckles_without_contacts,
            is_stable: state.is_stable(),
            snakes_from_kn: self.snaking_weight.map(|weight| 1e-3 * weight),
            turning: self.sliding.as_ref().map(Turning::of),
        }
    }

    /// How far from the bit, m, it is as it would be in a longer model: where the string is cut, up to
    /// the last contacts but some.
    fn trusted(&self) -> f64 {
        let top = self.state.top();
        if top >= self.sweep.setting.string.length() {
            return top;
        }
        let touching = self.state.contacts().iter().filter(|it| it.touches);
        let distances = touching.map(|it| it.contact.distance_from_bit);
        let below = distances.skip(BENT_BY_CUT).find(|it| *it > 0.0);
        below.unwrap_or(top)
    }

    /// Its deflection, its contact forces and its moment, next to the bit.
    pub fn picture(&self, look: &Look) -> Picture {
        let title = format!("{}: at rest in its hole", self.sweep.title);
        panels(look, &title, &self.panels())
    }

    fn panels(&self) -> [Panel; 3] {
        let units = self.sweep.content.units;
        let [length, width, force] = [&LENGTH, &WIDTH, &FORCE].map(|twin| units.of(twin));
        let torque = units.of(&TORQUE).kilo();
        let contacts = || {
            let near = |it: &&ContactState| it.contact.distance_from_bit <= REACH_SHOWN;
            self.state.contacts().iter().rev().filter(near)
        };
        let places = || {
            let mut places: Vec<Place> = self.state.along().collect();
            places.reverse();
            places.retain(|it| it.distance_from_bit <= REACH_SHOWN);
            places
        };
        let along = |name: &str, unit: &Unit, value: &dyn Fn(&Place) -> f64| {
            let point = |it: &Place| (length.number(it.distance_from_bit), unit.number(value(it)));
            Series::new(name, places().iter().map(point).collect())
        };
        let panel = |label: String, series: Vec<Series>, walls: Vec<Wall>| Panel {
            axes: [format!("Distance from the bit ({})", length.name), label].map(Axis::linear),
            series,
            references: Vec::new(),
            walls,
            is_difference: false,
        };
        let wall = |sign: f64| {
            let points = contacts().map(|it| {
                let clearance = sign * 1e3 * it.contact.clearance;
                let distance = it.contact.distance_from_bit;
                (length.number(distance), width.number(clearance))
            });
            let points: Vec<(f64, f64)> = points.collect();
            Wall {
                name: "clearance, sites as rings".to_owned(),
                line: points.clone(),
                known: points,
            }
        };
        let stems = contacts().filter(|it| it.touches).flat_map(|it| {
            let distance = length.number(it.contact.distance_from_bit);
            let pressed = force.number(1e-3 * it.normal());
            [(distance, 0.0), (distance, pressed), (f64::NAN, f64::NAN)]
        });
        let soft = contacts()
            .zip(self.soft.iter().rev())
            .filter_map(|(it, soft)| {
                let distance = length.number(it.contact.distance_from_bit);
                soft.map(|pressed| (distance, force.number(1e-3 * pressed)))
            });
        [
            panel(
                format!("Displacement ({})", width.name),
                vec![
                    along("to the high side", &width, &|it| {
                        1e3 * it.by_high_side(it.displacement)[0]
                    }),
                    along("to the right, looking down", &width, &|it| {
                        1e3 * it.by_high_side(it.displacement)[1]
                    }),
                ],
                vec![wall(1.0), wall(-1.0)],
            ),
            panel(
                format!("Contact force ({})", force.name),
                vec![
                    Series::new("contact force", stems.collect()).styled(LineStyle::numbered(2, 0)),
                    Series::new("string without stiffness", soft.collect())
                        .styled(LineStyle::grey(1)),
                ],
                Vec::new(),
            ),
            panel(
                format!("Bending moment ({})", torque.name),
                vec![along("bending moment", &torque, &|it| {
                    1e-3 * it.moment[0].hypot(it.moment[1])
                })],
                Vec::new(),
            ),
        ]
    }

    /// The string at the ends of its elements, from the bit up, as CSV.
    ///
    /// # Errors
    /// Where memory does not take it.
    pub fn along_csv(&self) -> Result<Vec<u8>> {
        let mut places: Vec<Place> = self.state.along().collect();
        places.reverse();
        csv_table(places.iter().map(|it| {
            let [high, right] = it.by_high_side(it.displacement);
            let [moment_high, moment_right] = it.by_high_side(it.moment);
            let stress = it.stress;
            [
                ("distance_from_bit_m", it.distance_from_bit.to_string()),
                ("high_side_mm", (1e3 * high).to_string()),
                ("right_mm", (1e3 * right).to_string()),
                ("tension_kn", (1e-3 * it.tension).to_string()),
                ("moment_to_high_side_knm", (1e-3 * moment_high).to_string()),
                ("moment_to_right_knm", (1e-3 * moment_right).to_string()),
                ("axial_stress_mpa", (1e-6 * stress.axial).to_string()),
                ("bending_stress_mpa", (1e-6 * stress.bending).to_string()),
                ("von_mises_mpa", (1e-6 * stress.von_mises).to_string()),
            ]
        }))
    }

    /// Its sites, from the bit up, as CSV.
    ///
    /// # Errors
    /// Where memory does not take it.
    pub fn contacts_csv(&self) -> Result<Vec<u8>> {
        let sites = self.state.contacts().iter().enumerate().rev();
        let of_soft =
            |force: Option<f64>| force.map_or_else(String::new, |force| (1e-3 * force).to_string());
        csv_table(sites.map(|(site, it)| {
            let [high, right] = it.by_high_side(it.displacement);
            let sliding = self.sliding.as_ref().map(|state| state.contacts()[site]);
            let sliding = sliding.filter(|it| it.touches);
            let of_sliding = |value: &dyn Fn(ContactState) -> f64| {
                sliding.map_or_else(String::new, |it| value(it).to_string())
            };
            [
                ("site_from_bit_m", it.contact.distance_from_bit.to_string()),
                ("clearance_mm", (1e3 * it.contact.clearance).to_string()),
                ("high_side_mm", (1e3 * high).to_string()),
                ("right_mm", (1e3 * right).to_string()),
                ("force_kn", (1e-3 * it.normal()).to_string()),
                ("soft_string_kn", of_soft(self.soft[site])),
                ("sliding_force_kn", of_sliding(&|it| 1e-3 * it.normal())),
                (
                    "sliding_climb_deg",
                    of_sliding(&|it| it.climb().to_degrees()),
                ),
            ]
        }))
    }
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

impl InspectedLying {
    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let title = "\nstring at rest in its hole\n".to_owned();
        match self {
            Self::AtRest(lying) => title + &lying.words(units),
            Self::Refused { error } => title + &row(2, "is not found", error),
        }
    }
}

impl AtRest {
    fn words(&self, units: Units) -> String {
        let [length, force, stress] = [&LENGTH, &FORCE, &STRESS].map(|twin| units.of(twin));
        let moment = units.of(&TORQUE).kilo();
        let at = |unit: &Unit, decimals: usize, greatest: &Greatest| {
            let place = length.text(greatest.from_bit_m, 2);
            format!(
                "{}, {place} from the bit",
                unit.text(greatest.value, decimals)
            )
        };
        let sides = |values: [f64; 2], text: &dyn Fn(f64) -> String| {
            let names = [["high side", "low side"], ["right", "left"]];
            let parts = values
                .into_iter()
                .zip(names)
                .filter_map(|(value, [one, other])| {
                    let side = if value > 0.0 { one } else { other };
                    let text = text(value.abs());
                    let is_zero = text.chars().all(|it| !('1'..='9').contains(&it));
                    (!is_zero).then(|| format!("{text} to the {side}"))
                });
            let parts: Vec<String> = parts.collect();
            match parts.is_empty() {
                true => "none".to_owned(),
                false => parts.join(", "),
            }
        };
        let snakes = match self.snakes_from_kn {
            Some(weight) => format!("from {} on the bit on", force.text(weight, 1)),
            None => "not up to 5 MN on the bit".to_owned(),
        };
        let stays = match (self.is_stable, self.buckles_without_contacts) {
            (true, false) => "yes",
            (true, true) => "yes, held by its contacts: it would buckle without them",
            (false, _) => "no: it buckles in spite of its contacts",
        };
        let rows = [
            ("weight on bit", force.text(self.weight_on_bit_kn, 1)),
            (
                "modelled",
                format!(
                    "up to {} from the bit{}",
                    length.text(self.modelled_m, 1),
                    self.sites_to_m.map_or_else(String::new, |to| format!(
                        ", sites up to {}",
                        length.text(to, 1)
                    ))
                ),
            ),
            ("stays there", stays.to_owned()),
            ("snakes or buckles", snakes),
            (
                "side force of the bit",
                sides(self.side_force_of_bit_kn, &|it| force.text(it, 3)),
            ),
            (
                "tilt of the bit",
                sides(self.tilt_of_bit_deg, &|it| format!("{it:.4}°")),
            ),
            (
                "greatest bending moment",
                at(&moment, 2, &self.greatest_moment_knm),
            ),
            (
                "greatest bending stress",
                at(&stress, 2, &self.greatest_bending_stress_mpa),
            ),
            (
                "greatest von Mises stress",
                at(&stress, 2, &self.greatest_von_mises_mpa) + ", without torque",
            ),
            (
                "touches",
                format!("{} of {}", self.contacts.len(), counted(self.sites, "site")),
            ),
        ];
        let turning = self.turning.iter().map(|turning| {
            let [least, greatest] = turning.climb_deg;
            let torque = moment.text(turning.friction_torque_knm, 2);
            let value = format!("{least:.1}° to {greatest:.1}° from the low side, takes {torque}");
            row(2, "turning, sliding on these", &value)
        });
        let lines = rows.iter().map(|(title, value)| row(2, title, value));
        lines.chain(turning).collect::<String>() + &self.contact_lines([&length, &force])
    }

    fn contact_lines(&self, [length, force]: [&Unit; 2]) -> String {
        if self.contacts.is_empty() {
            return String::new();
        }
        let mut text = format!(
            "    from the bit    force     from the low side\n    {:<16}{:<10}°\n",
            length.name, force.name
        );
        let [lengths, forces] = [length, force].map(|unit| unit.decimals(3));
        for contact in self.contacts.iter().take(MOST_LINES) {
            text += &format!(
                "    {:<16.lengths$}{:<10.forces$}{:.1}\n",
                length.number(contact.site_from_bit_m),
                force.number(contact.force_kn),
                // Without the sign of a rounded zero.
                contact.angle_deg + 0.0
            );
        }
        if self.contacts.len() > MOST_LINES {
            let more = counted(self.contacts.len() - MOST_LINES, "more contact");
            text += &format!("    and {more} above\n");
        }
        text
    }
}
