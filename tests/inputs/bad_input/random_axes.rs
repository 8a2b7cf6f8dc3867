//! Random axes whose distribution or correlation makes no sense.

use crate::refusals::{RUN, line_of, refused, refused_at};
use crate::support::{Workplace, small_with_design};

/// An axis of a Monte Carlo design together with one of another quantity.
fn axis(keys: &str) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"monte-carlo\"\ncases = 4\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.1, to = 0.6 }}\nweight_on_bit_kn = {{ {keys} }}\n"
    ))
}

#[test]
fn a_distribution_that_makes_no_sense_is_refused() {
    for (keys, key, meant) in [
        (
            "distribution = \"normal\", from = 1, to = 9",
            "",
            "needs `mean`",
        ),
        (
            "distribution = \"normal\", mean = 5, from = 1, to = 9",
            "",
            "needs `standard_deviation`",
        ),
        (
            "distribution = \"normal\", mean = 5, standard_deviation = 0, from = 1, to = 9",
            ".standard_deviation",
            "is above zero",
        ),
        (
            "distribution = \"normal\", mean = nan, standard_deviation = 1, from = 1, to = 9",
            ".mean",
            "is no number",
        ),
        (
            "distribution = \"normal\", mean = 50, standard_deviation = 1, from = 1, to = 9",
            "",
            "hardly anything of the distribution",
        ),
        (
            "distribution = \"normal\", mean = 5, standard_deviation = 1, to = 9",
            "",
            "has `from` and `to`",
        ),
        (
            "distribution = \"normal\", mean = 5, standard_deviation = 1, from = -1, to = 9",
            ".from",
            "-1 kN is not between",
        ),
        (
            "distribution = \"log-normal\", median = 5, geometric_standard_deviation = 2, \
             from = 0, to = 9",
            ".from",
            "a logarithm needs numbers above zero",
        ),
        (
            "distribution = \"log-normal\", median = 5, geometric_standard_deviation = 1, \
             from = 1, to = 9",
            ".geometric_standard_deviation",
            "a factor above 1",
        ),
        (
            "distribution = \"log-normal\", median = -5, geometric_standard_deviation = 2, \
             from = 1, to = 9",
            ".median",
            "is above zero",
        ),
        (
            "distribution = \"triangular\", mode = 10, from = 1, to = 9",
            ".mode",
            "10 is not between 1 and 9",
        ),
        (
            "mode = 5, from = 1, to = 9",
            ".mode",
            "belongs to `distribution = \"triangular\"`",
        ),
        (
            "distribution = \"log-uniform\", spacing = \"log\", from = 1, to = 9",
            ".spacing",
            "says what `distribution` says",
        ),
        (
            "distribution = \"gauss\", from = 1, to = 9",
            ".distribution",
            "known here: uniform",
        ),
    ] {
        let key = format!("design.axes.weight_on_bit_kn{key}");
        refused_at(&axis(keys), "weight_on_bit_kn", &key, meant);
    }
    let grid = axis("mean = 5, from = 1, to = 9, count = 3");
    let grid = grid.replace("kind = \"monte-carlo\"\ncases = 4", "kind = \"grid\"");
    let grid = grid.replace("to = 0.6", "to = 0.6, count = 2");
    let (key, meant) = ("design.axes.weight_on_bit_kn.mean", "is of random values");
    refused_at(&grid, "weight_on_bit_kn", key, meant);
}

/// Indices of first and of all orders are of independent axes.
#[test]
fn correlated_axes_are_refused_in_a_sensitivity_design() {
    let text = axis("from = 1, to = 9").replace("monte-carlo", "sensitivity")
        + "[[design.correlations]]\naxes = [\"surface_speed_rpm\", \"weight_on_bit_kn\"]\n\
           coefficient = 0.5\n";
    let meant = "are of axes that are independent";
    let place = Workplace::with_small(&text);
    refused(&place, &RUN, &["`design.correlations`: ", meant]);
}

/// Sobol's sequence has a limited number of dimensions, and blocks take two for each axis.
#[test]
fn more_axes_than_sobol_points_have_coordinates_are_refused() {
    let sections = "[[string.sections]]\nrepeat = 1\nparts = [{ length_m = 9, \
                    inner_radius_m = 0.05, outer_radius_m = 0.1 }]\n";
    let text = |kind: &str, count: usize| {
        let range = "{ from = 8, to = 9 }";
        let axis = |index: usize| format!("section_{}_part_0_length_m = {range}\n", index + 1);
        let design = format!(
            "{}[design]\nkind = \"{kind}\"\npoints = \"sobol\"\ncases = 2\n[design.axes]\n\
             surface_speed_rpm = {{ from = 1, to = 2 }}\n\
             weight_on_bit_kn = {{ from = 1, to = 2 }}\n",
            sections.repeat(count - 2)
        );
        let text = small_with_design(&design);
        text + &(0..count - 2).map(axis).collect::<String>()
    };
    for (kind, most, each) in [("monte-carlo", 128, 1), ("sensitivity", 64, 2)] {
        let place = Workplace::with_small(&text(kind, most + 1));
        let meant = format!(
            "at most 128 coordinates, and these axes take {}",
            128 + each
        );
        refused(&place, &RUN, &["`design.points`: ", &meant]);
        let place = Workplace::with_small(&text(kind, most));
        let answer = place.sweep(&["run", "small.toml", "--dry-run"]);
        assert_eq!(answer.code, 0, "{}", answer.errors);
    }
}

#[test]
fn an_invalid_correlation_is_refused() {
    let with = |pairs: &[(&str, f64)]| {
        let mut text = axis("from = 1, to = 9");
        for (axes, coefficient) in pairs {
            text +=
                &format!("[[design.correlations]]\naxes = [{axes}]\ncoefficient = {coefficient}\n");
        }
        text
    };
    let pair = "\"surface_speed_rpm\", \"weight_on_bit_kn\"";
    for (axes, coefficient, at, key, meant) in [
        (
            pair,
            1.0,
            "coefficient = 1",
            "[0].coefficient",
            "is not between",
        ),
        (
            "\"surface_speed_rpm\", \"friction\"",
            0.5,
            "axes = [",
            "[0].axes",
            "`friction` is not an axis",
        ),
        (
            "\"weight_on_bit_kn\", \"weight_on_bit_kn\"",
            0.5,
            "axes = [",
            "[0].axes",
            "goes with itself",
        ),
    ] {
        let key = format!("design.correlations{key}");
        refused_at(&with(&[(axes, coefficient)]), at, &key, meant);
    }
    let turned = "\"weight_on_bit_kn\", \"surface_speed_rpm\"";
    let twice = with(&[(pair, 0.5), (turned, 0.4)]);
    let key = "design.correlations[1].axes";
    refused_at(&twice, &format!("axes = [{turned}]"), key, "given already");
    let of_three = with(&[
        (pair, 0.9),
        (
            "\"surface_speed_rpm\", \"torsional_damping_nms_rad_m\"",
            0.9,
        ),
        (
            "\"weight_on_bit_kn\", \"torsional_damping_nms_rad_m\"",
            -0.9,
        ),
    ]);
    let axes = "weight_on_bit_kn = { from";
    let more = "torsional_damping_nms_rad_m = { from = 5, to = 20 }\nweight_on_bit_kn = { from";
    let of_three = of_three.replace(axes, more);
    let line = line_of(&of_three, &format!("axes = [{pair}]")) - 1;
    let place = format!("error: small.toml:{line}: `design.correlations`: ");
    let place_of_file = Workplace::with_small(&of_three);
    refused(&place_of_file, &RUN, &[&place, "go together, too"]);
}
