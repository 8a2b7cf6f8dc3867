//! Labels that were put to the test as a table, and in a few lines.

use campaign::words::{counted, wrapped};
use studies::promises::{Motion, Tested};

/// The columns of the table: their names, and what a case has there.
pub fn columns(tested: &Tested) -> [(&'static str, String); 10] {
    let problem = &tested.problem;
    let truth = tested.truth;
    [
        ("motion", problem.motion.name().to_owned()),
        ("string", problem.number.to_string()),
        ("shape", problem.shape.to_owned()),
        ("length_m", problem.length.to_string()),
        ("loss_of_wave", problem.loss.to_string()),
        (
            "sampling_frequency_hz",
            tested.sampling_frequency.to_string(),
        ),
        ("value", tested.value.to_string()),
        ("is_sustained", tested.label.to_string()),
        ("is_certain", tested.is_certain.to_string()),
        (
            "is_sustained_in_truth",
            truth.map_or_else(String::new, |truth| truth.to_string()),
        ),
    ]
}

/// How many labels are wrong of those that are certain and of the others, by motion.
pub fn summary(tested: &[Tested]) -> String {
    let of_motion = |motion: Motion| {
        let is_of_motion = |one: &&Tested| one.problem.motion == motion;
        let of_motion: Vec<&Tested> = tested.iter().filter(is_of_motion).collect();
        let in_words = |is_certain: bool| {
            let labels = of_motion.iter().filter(|one| one.is_certain == is_certain);
            let known: Vec<bool> = labels.clone().filter_map(|one| one.is_wrong()).collect();
            let wrong = known.iter().filter(|is_wrong| **is_wrong).count();
            let unknown = labels.count() - known.len();
            format!("{wrong} of {} wrong ({unknown} not known)", known.len())
        };
        let words = format!(
            "{}: {} near limits; certain: {}; not certain: {}",
            motion.name(),
            counted(of_motion.len(), "case"),
            in_words(true),
            in_words(false),
        );
        (!of_motion.is_empty()).then(|| wrapped(&words, 0, 2))
    };
    Motion::ALL.into_iter().filter_map(of_motion).collect()
}
