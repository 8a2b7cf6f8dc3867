//! How often whirl lasts where a window knows no bound of it: a study of random strings that lie.

use crate::analysis::wilson;
use campaign::words::short;

/// Random strings that lie, hit once where their windows call them safe unless whirl is triggered.
/// `STRINGS=200 cargo test --release -p drillstring --test commands whirls_when_hit -- --nocapture`
/// counts these and the following.
const STRINGS: usize = 200;

/// Cases that are hit there,
const HIT: usize = 299;

/// and how many of these whirl.
const WHIRLED: usize = 293;

/// The fraction of hit strings that whirled, in words: no bound says where whirl cannot last in a string
/// that lies.
pub fn whirl_when_hit() -> String {
    let interval = wilson(WHIRLED, HIT).map_or_else(String::new, |part| {
        let [value, low, high] =
            [part.value, part.low, part.high].map(|part| short((100.0 * part).round()));
        format!(": {value} %, 95 % interval {low} to {high} %")
    });
    format!(
        "on {STRINGS} random strings that lie, {WHIRLED} of {HIT} cases in cells called safe unless whirl is \
         triggered whirled after a hit at the bit that gives 10 m of collar 1 m/s{interval}"
    )
}
