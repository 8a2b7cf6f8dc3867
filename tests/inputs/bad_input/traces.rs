//! Invalid traces.

use crate::refusals::{RUN, refused, refused_at};
use crate::support::{Workplace, small_with_design};

const AXES: &str = "surface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                    weight_on_bit_kn = { from = 5, to = 100 }\n";

fn trace(keys: &str, axes: &str) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"trace\"\n{keys}\n[design.axes]\n{axes}"
    ))
}

#[test]
fn a_trace_goes_over_two_continuous_axes() {
    let speed = "surface_speed_rpm = { from = 0.02, to = 0.6 }\n";
    let two = "a trace has two axes, and these are";
    refused_at(&trace("", speed), "[design.axes]", "design.axes", two);
    let three = format!("{AXES}torsional_damping_nms_rad_m = {{ from = 1, to = 9 }}\n");
    refused_at(&trace("", &three), "[design.axes]", "design.axes", two);
    for (axis, key, meant) in [
        (
            "weight_on_bit_kn = { values = [30, 70] }",
            "weight_on_bit_kn",
            "is continuous",
        ),
        (
            "weight_on_bit_kn = { from = 30 }",
            "weight_on_bit_kn",
            "it has `from` and `to`",
        ),
        (
            "weight_on_bit_kn = { from = 70, to = 30 }",
            "weight_on_bit_kn.to",
            "is not above",
        ),
        (
            "weight_on_bit_kn = { from = 30, to = 70, count = 1 }",
            "weight_on_bit_kn.count",
            "not from 2 to 1000",
        ),
        (
            "weight_on_bit_kn = { from = 30, to = 70, distribution = \"uniform\" }",
            "weight_on_bit_kn.distribution",
            "is of random values",
        ),
        (
            "section_0_repeat = { from = 3, to = 9 }",
            "section_0_repeat",
            "takes whole numbers alone",
        ),
    ] {
        let text = trace("", &format!("{speed}{axis}\n"));
        refused_at(&text, axis, &format!("design.axes.{key}"), meant);
    }
}

#[test]
fn a_tolerance_is_a_part_of_an_axis_and_no_grid_is_too_fine() {
    for (tolerance, meant) in [
        ("0", "not between 0.000001 and 0.5"),
        ("0.7", "not between 0.000001 and 0.5"),
        ("0.00001", "more than 10000000"),
    ] {
        let text = trace(&format!("tolerance = {tolerance}"), AXES);
        refused_at(&text, "tolerance", "design.tolerance", meant);
    }
    let grid = small_with_design(
        "[design]\nkind = \"grid\"\ntolerance = 0.1\n[design.axes]\nfriction = { values = [1] }\n",
    );
    refused_at(
        &grid,
        "tolerance",
        "design.tolerance",
        "does not belong to this kind",
    );
    let drawn = trace("cases = 9", AXES);
    refused_at(
        &drawn,
        "cases = 9",
        "design.cases",
        "does not belong to this kind",
    );
}

#[test]
fn a_trace_is_not_split() {
    let place = Workplace::with_small(&trace("", AXES));
    let arguments = [&RUN[..], &["--shard", "0/2"]].concat();
    refused(&place, &arguments, &["--shard", "a trace is not split"]);
}

#[test]
fn a_table_of_another_is_not_replaced() {
    let place = Workplace::with_small(&trace("", AXES));
    std::fs::create_dir(place.path("results")).unwrap();
    place.write("results/limits.csv", "mine\n");
    refused(&place, &RUN, &["limits.csv", "nothing there says"]);
}

#[test]
fn a_colour_is_a_measure_of_what_is_modelled() {
    for (measure, meant) in [
        ("contact_fraction", "needs a wall"),
        ("surface_torque_peak_nm", "`surface_torque = true`"),
        ("string_torque_peak_nm", "torque_along_string = true"),
        ("severity", "unknown choice `severity`"),
    ] {
        let text = trace("", AXES) + &format!("[map]\ncolour = {measure:?}\n");
        refused_at(&text, "colour", "map.colour", meant);
    }
}
