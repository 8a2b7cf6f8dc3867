//! Random strings in random wells that build and turn: what they lie on bears what weight and
//! tension press them with, by axes that are carried along step by step.

use linear::Drillstring;
use linear::Mud;
use linear::well::{GRAVITY, Survey};
use problems::wells::{Draw, Well};
use statics::{Conditions, Contact, Course, LyingString, StaticState, Top};

const YOUNGS_MODULUS: f64 = 206e9;
const MUD: Mud = Mud {
    density: 1200.0,
    viscosity: 0.0,
};

type Vector = [f64; 3];

fn dot(one: Vector, other: Vector) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Places every few metres, some on the bit.
fn contacts(string: &Drillstring, to: f64, draw: &mut Draw) -> Vec<Contact> {
    let widest = string.sections().iter().flat_map(|it| &it.parts);
    let widest = widest.map(|part| part.outer_radius).fold(0.0, f64::max);
    let mut distance = 0.0;
    let mut found = Vec::new();
    while distance < to {
        found.push(Contact {
            distance_from_bit: distance,
            clearance: if distance == 0.0 {
                2e-3
            } else {
                draw.uniform(0.02, 0.06)
            },
            radius: widest,
            stiffness: None,
        });
        distance += draw.uniform(3.0, 9.0);
    }
    found
}

/// What loads along the string, with its tension, less what bends it towards the axis, have as a
/// moment about its upper end along the carried axes, and the sum of their amounts, N m.
fn moments(state: &StaticState, string: &Drillstring, survey: &Survey) -> ([f64; 2], f64) {
    let cells = string
        .sections()
        .iter()
        .rev()
        .flat_map(|section| (0..section.repeat).flat_map(|_| section.parts.iter().rev()));
    let mut parts = cells.peekable();
    let mut end = parts.peek().map_or(0.0, |part| part.length);
    let density = string.material().density - MUD.density;
    let (length, top, steps) = (string.length(), state.top(), 160_000);
    let along = survey.direction(length);
    let sin = along[0].hypot(along[1]);
    let high = [along[0] * along[2] / sin, along[1] * along[2] / sin, -sin];
    let mut across = [high, cross(along, high)];
    let (mut sums, mut amount) = ([0.0; 2], 0.0);
    let step = top / f64::from(steps);
    for index in 0..steps {
        let distance = (f64::from(index) + 0.5) * step;
        let (along, curvature) = (
            survey.direction(length - distance),
            survey.curvature(length - distance),
        );
        // To the middle of the step: across what is along there, and at right angles.
        for axis in &mut across {
            let lean = dot(*axis, along);
            for it in 0..3 {
                axis[it] -= lean * along[it];
            }
            let size = dot(*axis, *axis).sqrt();
            *axis = axis.map(|it| it / size);
        }
        let place = state.at(distance);
        while distance > end {
            parts.next();
            end += parts.peek().unwrap().length;
        }
        let down = [0.0, 0.0, density * GRAVITY * parts.peek().unwrap().area()];
        for plane in 0..2 {
            let load = dot(across[plane], down) + place.tension * dot(across[plane], curvature);
            sums[plane] += step * (load * (top - distance) - place.tension * place.slope[plane]);
            amount += step * load.abs() * (top - distance);
        }
    }
    (sums, amount)
}

/// A random string in a random well, without weight on its bit; cut 3 m and more above its contacts, or
/// next above them where it lies on its hole above, too.
fn drawn(number: usize, top: Option<Top>, draw: &mut Draw) -> (Drillstring, Survey, LyingString) {
    let Well { string, survey } = Well::draw(number, draw);
    let highest = string.length().min(300.0);
    let contacts = contacts(&string, highest - 3.0, draw);
    let conditions = Conditions {
        mud: Some(MUD),
        top: top.unwrap_or(Top::At(highest)),
        ..Conditions::new(YOUNGS_MODULUS, Course::Surveyed(survey.clone()))
    };
    let lying = LyingString::new(&string, &conditions, &contacts).unwrap();
    (string, survey, lying)
}

/// Walls push, nothing is beyond them, and what they bear is what presses.
fn assert_in_balance(state: &StaticState, string: &Drillstring, survey: &Survey, what: &str) {
    let top = state.top();
    let mut of_contacts = [0.0; 2];
    for it in state.contacts() {
        let [x, y] = it.displacement;
        let beyond = x.hypot(y) - it.contact.clearance;
        let is_right = beyond <= 1e-9 && (!it.touches || beyond > -1e-9);
        assert!(it.normal() >= 0.0 && is_right, "{what}");
        for plane in 0..2 {
            of_contacts[plane] += it.force[plane] * (top - it.contact.distance_from_bit);
        }
    }
    let (moments, amount) = moments(state, string, survey);
    for plane in 0..2 {
        let off = (moments[plane] + of_contacts[plane]) / amount;
        assert!(off.abs() < 1e-4, "{what}: {off:.1e}");
    }
}

#[test]
fn val_contacts_bear_what_presses_random_strings_in_random_wells() {
    for number in 0..45 {
        let mut draw = Draw::new(number);
        // Every third is cut next above its contacts.
        let top = (number % 3 == 0).then_some(Top::AboveContacts);
        let (string, survey, lying) = drawn(number, top, &mut draw);
        let lying = lying.under(draw.uniform(0.0, 60e3));
        for friction in [0.0, 0.3] {
            let state = lying.sliding(friction).unwrap();
            assert!(state.is_stable() || friction > 0.0, "{number}");
            assert_in_balance(&state, &string, &survey, &format!("{number}, {friction}"));
        }
    }
}

/// Under most of the weight that buckles strings held at all contacts, which is far more than what
/// buckles them free. Of 40 such states of each of 45 strings two were not found, at 96 and 99 % of that
/// weight; of 14 of each cut next above its contacts five, all at 99 %.
#[test]
fn val_random_strings_have_a_state_up_to_where_they_buckle_between_contacts() {
    for top in [None, Some(Top::AboveContacts)] {
        assert_found_under_weight(top);
    }
}

fn assert_found_under_weight(top: Option<Top>) {
    let mut unstable = 0;
    for number in 0..15 {
        let (string, survey, lying) = drawn(number, top, &mut Draw::new(number));
        let (mut low, mut high) = (0.0, 1e7);
        while high - low > 1e-3 * high {
            let middle = 0.5 * (low + high);
            match lying.under(middle).buckles_between_contacts() {
                true => high = middle,
                false => low = middle,
            }
        }
        for part in [0.3, 0.55, 0.9] {
            let state = lying.under(part * low).at_rest().unwrap();
            unstable += usize::from(!state.is_stable());
            assert_in_balance(&state, &string, &survey, &format!("{number}, {part}"));
        }
    }
    assert!((1..15).contains(&unstable), "{unstable}");
}
