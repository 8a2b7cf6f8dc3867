//! Monte Carlo designs over distributions, as a run has them.

use crate::support::{Workplace, small_with_design, with};

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

/// The values along both axes.
fn values_of(labels: &str) -> Vec<[f64; 2]> {
    let rows = labels.lines().skip(1);
    let values = rows.map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        [2, 3].map(|column: usize| cells[column].parse().unwrap())
    });
    values.collect()
}

/// Each axis keeps its distribution at points of Sobol's sequence, and what goes together does so,
/// nearer to it than at random points; they are raised as those are, on any number of threads.
#[test]
fn sobol_points_have_the_same_distributions() {
    let count = 256;
    let text = |cases| with(&design(cases), "seed = 11", "seed = 11\npoints = \"sobol\"");
    let place = Workplace::with_small(&text(count));
    let whole = labels(&place, &[]);
    let values = values_of(&whole);
    // Of each, the expected fraction is below its quantiles: the ends of the
    // logarithm cut off 0.4 % below and 0.15 % above.
    let score = |it: &[f64; 2]| {
        [
            (it[0] / 0.3).ln() / 1.5f64.ln(),
            it[1] / 4.448_221_615_260_5 - 10.0,
        ]
    };
    for axis in 0..2 {
        for (level, part) in [
            (-1.281_55, 0.1),
            (-0.524_40, 0.3),
            (0.0, 0.5),
            (0.841_62, 0.8),
        ] {
            let below = values.iter().filter(|it| score(it)[axis] < level).count();
            let expected = part * count as f64;
            // Random points are off by 6 to 8 on average.
            assert!(
                (below as f64 - expected).abs() < 5.0,
                "{axis} {part} {below}"
            );
        }
    }
    let together = |it: &[f64; 2]| score(it)[0] * score(it)[1];
    let mean = values.iter().map(together).sum::<f64>() / count as f64;
    // That of random points has a standard error of 0.076.
    assert!((mean + 0.7).abs() < 0.06, "{mean}");
    assert_ne!(whole, labels(&Workplace::with_small(&design(count)), &[]));
    assert_eq!(
        labels(&Workplace::with_small(&text(count)), &["--jobs", "1"]),
        whole
    );
    let grown = Workplace::with_small(&text(50));
    labels(&grown, &[]);
    grown.write("small.toml", text(count));
    assert_eq!(labels(&grown, &[]), whole);
}

/// What is so anyway may be said: the results are those of a file that does not.
#[test]
fn random_points_may_be_asked_for() {
    let place = Workplace::with_small(&design(20));
    let before = labels(&place, &[]);
    let said = with(&design(20), "seed = 11", "seed = 11\npoints = \"random\"");
    place.write("small.toml", said);
    let answer = place.sweep(&["run", "small.toml", "--out", "out"]);
    assert!(answer.output.starts_with("complete already"), "{answer:?}");
    assert_eq!(labels(&place, &["--fresh"]), before);
}

/// The values of a run are spread as the file says, those of two axes together; a run that is
/// raised draws what one run draws, on any number of threads.
#[test]
fn a_run_draws_what_its_file_says() {
    let count = 400;
    let place = Workplace::with_small(&design(count));
    let whole = labels(&place, &[]);
    let values = values_of(&whole);
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
