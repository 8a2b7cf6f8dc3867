//! How often words of safety were wrong: counts over random strings, whose seeds played no part in the rules.

use crate::analysis::wilson;
use campaign::engine::is_by_rule;
use campaign::plan::Sweep;
use campaign::sweep_file::AutoOr;
use campaign::words::{counted, short};

/// Cases of which some are wrong.
#[derive(Clone, Copy)]
struct Wrong {
    count: usize,
    of: usize,
}

/// Random strings of each of the following counts.
const STRINGS: usize = 200;

/// Cases on the low side in cells called safe unless whirl is triggered, and those that whirled when hit.
/// `STRINGS=200 cargo test --release -p drillstring --test commands whirls_when_hit -- --nocapture`
const WHIRLED: Wrong = Wrong {
    count: 293,
    of: 299,
};

/// Labels of stick-slip by the rule of time, and those that differ after ten times the time.
/// `STRINGS=200 SEED=75 cargo test --release -p drillstring --test validation labels_of_stick_slip_are -- --nocapture`
const STICK_SLIP_BY_RULE: Wrong = Wrong { count: 1, of: 200 };

/// Labels of swings by the rule of time, and those that differ after ten times the time.
/// `STRINGS=200 SEED=73 cargo test --release -p drillstring --test validation labels_of_swings_are -- --nocapture`
const SWINGS_BY_RULE: Wrong = Wrong { count: 0, of: 200 };

/// Collars that whirl to the end by explicit steps of lumped masses, and those of which a method misses that.
/// `STRINGS=200 SEED=74 cargo test --release -p drillstring --test validation whirl_that_lasts -- --nocapture`
const WHIRL_MISSED: [(&str, Wrong); 3] = [
    ("held", Wrong { count: 4, of: 153 }),
    ("finite-element", Wrong { count: 20, of: 153 }),
    ("quadrature", Wrong { count: 17, of: 153 }),
];

impl Wrong {
    /// The fraction in words, with its interval.
    fn words(self, what: &str) -> String {
        let interval = wilson(self.count, self.of).map_or_else(String::new, |part| {
            let [value, low, high] =
                [part.value, part.low, part.high].map(|part| short((1000.0 * part).round() / 10.0));
            format!(" ({value} %, 95 % interval {low} to {high} %)")
        });
        format!("{} of {}{interval}", self.count, counted(self.of, what))
    }
}

/// The fraction of hit strings on the low side that whirled, in words.
fn whirl_when_hit() -> String {
    format!(
        "on {STRINGS} random strings that lie, hit at the bit so that 10 m of collar have 1 m/s, {} in cells called \
         safe unless whirl is triggered whirled",
        WHIRLED.words("case")
    )
}

/// How often labels and words of safety were wrong for scenes of the kind of a sweep, a sentence each.
pub fn how_often_wrong(sweep: &Sweep) -> Vec<String> {
    // Without a wall there is no whirl.
    let is_auto = matches!(sweep.content.sampling_frequency_hz, AutoOr::Auto);
    let has_default_frequency = is_auto && sweep.setting.lateral.is_some();
    let lies = sweep.setting.lying.is_some();
    let by_rule = |cases: Wrong, motion: &str| {
        format!(
            "labels of {motion} by the rule of time: of random strings, one case each, {} had another after ten times \
             the time",
            cases.words("string")
        )
    };
    let has_time_by_rule = is_by_rule(sweep, &sweep.setting);
    let turns_against_torque = sweep.bit.is_some() || sweep.setting.friction.is_some();
    let missed = (WHIRL_MISSED.into_iter())
        .filter(|_| has_default_frequency)
        .filter(|(method, _)| sweep.methods.iter().any(|of| of.name() == *method))
        .map(|(method, cases)| {
            format!(
                "whirl that lasts: {method} at its default frequency misses {}",
                cases.words("random collar")
            )
        });
    [
        (lies).then(whirl_when_hit),
        (has_time_by_rule && turns_against_torque)
            .then(|| by_rule(STICK_SLIP_BY_RULE, "stick-slip")),
        (has_time_by_rule && lies).then(|| by_rule(SWINGS_BY_RULE, "swings")),
    ]
    .into_iter()
    .flatten()
    .chain(missed)
    .collect()
}
