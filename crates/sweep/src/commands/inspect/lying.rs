//! What is said of the string at rest in its hole.

use serde::Serialize;

use super::rows::row;
use campaign::quantities::{FORCE, LENGTH, STRESS, TORQUE, Unit, Units};
use campaign::static_string::{AtRest, Greatest};
use campaign::words::{counted, wrapped};

/// Of more contacts that touch only this number, those next to the bit, have a line each.
const MOST_LINES: usize = 20;

/// The string at rest in numbers; or why it has no such state.
#[derive(Serialize)]
#[serde(untagged)]
pub enum InspectedLying {
    /// It lies there.
    AtRest {
        /// How.
        #[serde(flatten)]
        at_rest: Box<AtRest>,
        /// Whether whirl lasts, once something triggers it.
        whirl_if_triggered: &'static str,
    },
    /// It does not, or that is not found.
    Refused {
        /// Why.
        error: String,
    },
}

impl InspectedLying {
    /// The string at rest, with what is known of its whirl.
    pub fn at_rest(lying: AtRest) -> Self {
        Self::AtRest {
            at_rest: Box::new(lying),
            whirl_if_triggered: "no bound excludes it",
        }
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let title = "\nstring at rest in its hole\n".to_owned();
        match self {
            Self::AtRest {
                at_rest,
                whirl_if_triggered,
            } => {
                let whirl = format!("whirl, if triggered: {whirl_if_triggered}");
                title + &in_words(at_rest, units) + &wrapped(&whirl, 2, 4)
            }
            Self::Refused { error } => title + &row(2, "is not found", error),
        }
    }
}

fn in_words(lying: &AtRest, units: Units) -> String {
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
    let snakes = match &lying.snakes_from_unknown {
        Some(reason) => format!("not known: {reason}"),
        None => {
            let buckles = (lying.snakes_from_kn)
                .map(|it| format!("from {} on the bit on", force.text(it, 1)));
            let turns = "no bifurcation, for the hole turns:";
            let runs_away = lying.runs_away_from_kn.map(|it| {
                let weight = force.text(it, 1);
                format!(
                    "{turns} from {weight} on the bit on the greatest moment that weight adds grows by more than \
                     2.5 % with each 1 % of weight"
                )
            });
            let jumps = (lying.jumps_at_kn)
                .map(|it| format!("{turns} it jumps to another place at {}", force.text(it, 1)));
            let never = || "not up to 5 MN on the bit".to_owned();
            buckles.or(runs_away).or(jumps).unwrap_or_else(never)
        }
    };
    let between = lying
        .beyond_wall
        .map_or_else(|| "within its wall".to_owned(), |it| it.words(units));
    let stays = match (lying.is_stable, lying.buckles_without_contacts) {
        (true, false) => "yes",
        (true, true) => "yes, held by its contacts: it would buckle without them",
        (false, _) => "no: it buckles in spite of its contacts",
    };
    let rows = [
        ("weight on bit", force.text(lying.weight_on_bit_kn, 1)),
        (
            "modelled",
            format!(
                "up to {} from the bit{}",
                length.text(lying.modelled_m, 1),
                lying.sites_to_m.map_or_else(String::new, |to| format!(
                    ", sites up to {}",
                    length.text(to, 1)
                ))
            ),
        ),
        ("between its sites", between),
        ("stays there", stays.to_owned()),
        ("snakes or buckles", snakes),
        (
            "side force of the bit",
            sides(lying.side_force_of_bit_kn, &|it| force.text(it, 3)),
        ),
        (
            "tilt of the bit",
            sides(lying.tilt_of_bit_deg, &|it| format!("{it:.4}°")),
        ),
        (
            "greatest bending moment",
            at(&moment, 2, &lying.greatest_moment_knm),
        ),
        (
            "greatest bending stress",
            at(&stress, 2, &lying.greatest_bending_stress_mpa),
        ),
        (
            "greatest von Mises stress",
            at(&stress, 2, &lying.greatest_von_mises_mpa) + ", without torque",
        ),
        (
            "touches",
            format!(
                "{} of {}, {} of cases among them",
                lying.contacts.len(),
                counted(lying.places, "place"),
                counted(lying.sites, "site")
            ),
        ),
    ];
    let in_cases = (lying.in_cases.iter()).map(|it| row(2, "as cases begin", &it.words(units)));
    let above = (lying.snakes_above.iter()).map(|it| row(2, "above that", &it.words(units)));
    let turning = lying.turning.iter().map(|turning| {
        let [least, greatest] = turning.climb_deg;
        let torque = moment.text(turning.friction_torque_knm, 2);
        let value = format!("{least:.1}° to {greatest:.1}° from the low side, takes {torque}");
        row(2, "turning, sliding on these", &value)
    });
    let lines = rows.iter().map(|(title, value)| row(2, title, value));
    lines
        .chain(in_cases)
        .chain(above)
        .chain(turning)
        .collect::<String>()
        + &contact_lines(lying, [&length, &force])
}

fn contact_lines(lying: &AtRest, [length, force]: [&Unit; 2]) -> String {
    if lying.contacts.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "    from the bit    force     from the low side\n    {:<16}{:<10}°\n",
        length.name, force.name
    );
    let [lengths, forces] = [length, force].map(|unit| unit.decimals(3));
    for contact in lying.contacts.iter().take(MOST_LINES) {
        text += &format!(
            "    {:<16.lengths$}{:<10.forces$}{:.1}\n",
            length.number(contact.site_from_bit_m),
            force.number(contact.force_kn),
            // Without the sign of a rounded zero.
            contact.angle_deg + 0.0
        );
    }
    if lying.contacts.len() > MOST_LINES {
        let more = counted(lying.contacts.len() - MOST_LINES, "more contact");
        text += &format!("    and {more} above\n");
    }
    text
}
