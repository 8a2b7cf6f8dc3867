//! Monte Carlo designs over distributions, as a run has them.

#[allow(dead_code, reason = "it has more than is needed here")]
mod support;

use support::{Workplace, small_with_design};

fn design(cases: usize) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"monte-carlo\"\nseed = 11\ncases = {cases}\n[design.axes]\n\
         surface_speed_rpm = {{ distribution = \"log-normal\", median = 0.3, \
         geometric_standard_deviation = 1.5, from = 0.1, to = 1 }}\n\
         weight_on_bit_klbf = {{ distribution = \"normal\", mean = 10, \
         standard_deviation = 1, from = 5, to = 15 }}\n\
         [[design.correlations]]\naxes = [\"surface_speed_rpm\", \"weight_on_bit_kn\"]\n\
         coefficient = -0.7\n"
    ))
}

fn labels(place: &Workplace, more: &[&str]) -> String {
    let arguments = ["run", "small.toml", "--out", "out", "--quiet"];
    let answer = place.sweep(&[&arguments, more].concat());
    assert_eq!(answer.code, 0, "{}", answer.errors);
    std::fs::read_to_string(place.path("out/labels.csv")).unwrap()
}

/// The values of a run are spread as the file says, those of two axes together; a run that is
/// raised draws what one run draws, whatever the threads.
#[test]
fn a_run_draws_what_its_file_says() {
    let count = 400;
    let place = Workplace::with_small(&design(count));
    let whole = labels(&place, &[]);
    let values: Vec<[f64; 2]> = whole
        .lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            [2, 3].map(|column: usize| cells[column].parse().unwrap())
        })
        .collect();
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| values.iter().map(of).sum::<f64>() / count as f64;
    // Four standard errors.
    let error = 4.0 / (count as f64).sqrt();
    let speed = |it: &[f64; 2]| (it[0] / 0.3).ln() / 1.5f64.ln();
    let weight = |it: &[f64; 2]| it[1] / 4.448_221_615_260_5 - 10.0;
    // The logarithm is cut off at 2.7 deviations below its mean, and at 3 above.
    assert!(mean(&speed).abs() < error, "{}", mean(&speed));
    assert!(mean(&weight).abs() < error, "{}", mean(&weight));
    let together = mean(&|it| speed(it) * weight(it));
    assert!((together + 0.7).abs() < 1.5 * error, "{together}");
    assert!((mean(&|it| weight(it).powi(2)) - 1.0).abs() < 1.5 * error);
    assert_eq!(
        labels(&Workplace::with_small(&design(count)), &["--jobs", "1"]),
        whole
    );
    let grown = Workplace::with_small(&design(50));
    labels(&grown, &[]);
    grown.write("small.toml", design(count));
    assert_eq!(labels(&grown, &[]), whole);
}
