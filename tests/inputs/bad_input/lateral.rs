//! Mistakes in the lateral part of a sweep file.

use crate::refusals::{refused, refused_at};
use crate::support::{SMALL, with};

/// The small sweep with a wall, one site in contact and an impulse there.
fn lateral() -> String {
    let start = SMALL.find("[[sites]]").unwrap();
    let string = with(
        &SMALL[..start],
        "[[string.sections]]",
        "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n[[string.sections]]",
    );
    let string = with(
        &string,
        "rock = \"sandstone\"",
        "rock = \"sandstone\"\nweight_on_bit_kn = 40",
    );
    format!(
        "{string}
[wall]
clearance_mm = 15
stiffness_gn_m15 = 1
friction = 0.5

[[sites]]
distance_from_bit_m = 0

[[impulses]]
distance_from_bit_m = 0
ratio = 3
duration_s = 0.02
"
    )
}

#[test]
fn the_lateral_sweep_itself_has_no_mistake() {
    let place = crate::support::Workplace::with_small(&lateral());
    let answer = place.sweep(&crate::refusals::RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
}

#[test]
fn invalid_values_of_a_wall_are_refused() {
    for (piece, instead, at, key, meant) in [
        (
            "clearance_mm = 15",
            "",
            "[wall]",
            "wall",
            "has no clearance",
        ),
        (
            "clearance_mm = 15",
            "clearance_mm = 0",
            "clearance_mm",
            "wall.clearance_mm",
            "between",
        ),
        (
            "friction = 0.5",
            "friction = -0.1",
            "friction",
            "wall.friction",
            "between",
        ),
        ("friction = 0.5", "", "[wall]", "wall.friction", "is needed"),
        (
            "stiffness_gn_m15 = 1\n",
            "stiffness_gn_m15 = -1\n",
            "stiffness",
            "wall.stiffness_gn_m15",
            "between",
        ),
        (
            "[[sites]]\ndistance_from_bit_m = 0\n",
            "sites = []\n",
            "sites",
            "wall.sites",
            "expected a string, found another kind of value; a list belongs above the first [table]",
        ),
        (
            "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n",
            "",
            "[wall]",
            "wall",
            "[string.bending]",
        ),
        (
            "damping_ns_m2 = 2000",
            "damping_ns_m2 = -1",
            "damping_ns_m2 =",
            "string.bending.damping_ns_m2",
            "between",
        ),
    ] {
        refused_at(&with(&lateral(), piece, instead), at, key, meant);
    }
}

#[test]
fn friction_that_falls_by_what_it_cannot_is_refused() {
    for (key, value) in [
        ("friction_dynamic_ratio", "1.1"),
        ("friction_dynamic_ratio", "-0.1"),
        ("friction_dynamic_ratio", "nan"),
        ("friction_stribeck_m_s", "-1"),
        ("friction_stribeck_m_s", "101"),
    ] {
        let line = format!("{key} = {value} # here\n");
        let of_wall = with(&lateral(), "\n[[sites]]\n", &format!("{line}[[sites]]\n"));
        refused_at(&of_wall, "# here", &format!("wall.{key}"), "between");
        let of_site = with(&lateral(), "\n[[sites]]\n", &format!("[[sites]]\n{line}"));
        refused_at(&of_site, "# here", &format!("sites[0].{key}"), "between");
    }
}

#[test]
fn two_sites_at_one_place_are_refused() {
    let twice = with(
        &lateral(),
        "[[impulses]]",
        "[[sites]]\ndistance_from_bit_m = 0.0 # again\n\n[[impulses]]",
    );
    refused_at(
        &twice,
        "# again",
        "sites[1].distance_from_bit_m",
        "two sites",
    );
}

#[test]
fn invalid_values_of_an_impulse_are_refused() {
    for (piece, instead, at, key, meant) in [
        (
            "duration_s = 0.02",
            "duration_s = -0.02",
            "duration_s",
            "impulses[0].duration_s",
            "ends before it starts",
        ),
        (
            "duration_s = 0.02",
            "duration_s = 0.019",
            "duration_s",
            "impulses[0].duration_s",
            "two samples at 100 Hz",
        ),
        (
            "ratio = 3",
            "ratio = 3\namount_ns = 9",
            "[[impulses]]",
            "impulses[0]",
            "either",
        ),
        (
            "ratio = 3",
            "ratio = -3",
            "ratio = -3",
            "impulses[0].ratio",
            "between",
        ),
        (
            "[[impulses]]\ndistance_from_bit_m = 0",
            "[[impulses]]\ndistance_from_bit_m = 7.5",
            "= 7.5",
            "impulses[0].distance_from_bit_m",
            "no site is 7.5 m",
        ),
    ] {
        refused_at(&with(&lateral(), piece, instead), at, key, meant);
    }
}

/// A millimetre below a clamp, no impulse brings a string of a hundred metres to a wall.
#[test]
fn an_i0_that_does_not_exist_is_refused() {
    let clamped = with(
        &lateral(),
        "damping_ns_m2 = 2000",
        "damping_ns_m2 = 2000\nsurface = \"clamped\"",
    );
    let far =
        "\n[[sites]]\ndistance_from_bit_m = 99.999\n\n[[impulses]]\ndistance_from_bit_m = 99.999";
    let at_clamp = with(&clamped, "\n[[impulses]]\ndistance_from_bit_m = 0", far);
    refused_at(
        &at_clamp,
        "ratio = 3",
        "impulses[0].ratio",
        "there is no I₀",
    );
    let refused = with(&at_clamp, "ratio = 3", "amount_ns = 3");
    let answer = crate::support::Workplace::with_small(&refused).sweep(&crate::refusals::RUN);
    assert_eq!(answer.code, 0, "{answer:?}");
}

#[test]
fn lateral_keys_without_a_wall_are_refused() {
    let text = lateral();
    let start = text.find("[wall]").unwrap();
    let end = text.find("[[sites]]").unwrap();
    let without = with(&text, &text[start..end], "");
    refused_at(&without, "[[impulses]]", "impulses", "needs a table [wall]");
}

/// The small sweep, its string able to bend and no wall to touch.
fn bending() -> String {
    let bending = "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n";
    let sections = "[[string.sections]]";
    with(SMALL, sections, &format!("{bending}{sections}"))
}

#[test]
fn what_changes_nothing_without_a_wall_is_refused() {
    for axis in ["compression_kn", "bending_damping_ns_m2"] {
        let axes = format!("[design.axes]\n{axis} = {{ values = [1, 2] }} # here\n");
        let text = with(&bending(), "[design.axes]\n", &axes);
        let key = format!("design.axes.{axis}");
        refused_at(&text, "# here", &key, "needs tables [wall] and");
        let place = crate::support::Workplace::with_small(&bending());
        let command = ["simulate", "small.toml", "--set", &format!("{axis}=1")];
        let meant = format!("--set {axis}: there is no wall");
        refused(&place, &command, &[&meant]);
    }
    for key in [
        "clearance_mm",
        "stiffness_gn_m15",
        "friction",
        "friction_dynamic_ratio",
        "friction_stribeck_m_s",
    ] {
        let site = format!("distance_from_bit_m = 50\n{key} = 2 # here");
        let text = with(SMALL, "distance_from_bit_m = 50", &site);
        let key = format!("sites[0].{key}");
        refused_at(&text, "# here", &key, "needs a table [wall]");
    }
}

#[test]
fn ratios_of_impulses_given_in_newton_seconds_are_refused() {
    let design = "\n[design]\nkind = \"grid\"\n[design.axes]\n\
                  impulse_ratio = { values = [1, 2] } # here\n";
    let newton_seconds = with(&lateral(), "ratio = 3", "amount_ns = 3");
    let key = "design.axes.impulse_ratio";
    refused_at(
        &(newton_seconds.clone() + design),
        "# here",
        key,
        "without `amount_ns`",
    );
    let another = "\n[[impulses]]\ndistance_from_bit_m = 0\n";
    let place = crate::support::Workplace::with_small(&(newton_seconds + another + design));
    let answer = place.sweep(&["run", "small.toml", "--dry-run"]);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
}

/// They are written down with the results, and no number read back is infinite.
#[test]
fn numbers_that_are_not_used_are_checked() {
    for number in ["nan", "inf"] {
        let damping = format!("damping_ns_m2 = {number} # here");
        let text = with(&bending(), "damping_ns_m2 = 2000", &damping);
        refused_at(&text, "# here", "string.bending.damping_ns_m2", "between");
        let clearance = format!("clearance_mm = {number} # here");
        let text = with(&lateral(), "clearance_mm = 15", &clearance);
        let own = "\n[[sites]]\nclearance_mm = 15\n";
        let text = with(&text, "\n[[sites]]\n", own);
        refused_at(&text, "# here", "wall.clearance_mm", "between");
    }
}

/// Its label would say nothing of the impulse.
#[test]
fn an_impulse_that_begins_after_the_end_of_a_case_is_refused() {
    let with_start = |text: &str, start: &str| {
        let impulse = format!("duration_s = 0.02\nstart_s = {start}\n");
        with(text, "duration_s = 0.02\n", &impulse)
    };
    let key = "impulses[0].start_s";
    for start in ["12", "13"] {
        let meant = format!("{start} s is not before the end of case 0, 12 s");
        refused_at(&with_start(&lateral(), start), "start_s", key, &meant);
    }
    // Times by rule differ: slow cases of Eqs. 72–73 are still under way at 20 s, and
    // the first that is not is named. Left out, the impulse begins at 1 s.
    let design = "\n[design]\nkind = \"grid\"\n[design.axes]\n\
                  surface_speed_rpm = { values = [0.001, 0.002, 30, 60] }\n";
    let by_rule = with(&lateral(), "time_s = 12", "time_s = \"auto\"") + design;
    refused_at(
        &with_start(&by_rule, "20"),
        "start_s",
        key,
        "the end of case 2, 10 s",
    );
    let slow = with(&with_start(&by_rule, "20"), ", 30, 60]", "]");
    let place = crate::support::Workplace::with_small(&slow);
    let answer = place.sweep(&["run", "small.toml", "--dry-run"]);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
    let short = with(&lateral(), "time_s = 12", "time_s = 0.5");
    let meant = "1 s is not before the end of case 0, 0.5 s";
    refused_at(&short, "[[impulses]]", key, meant);
    // Every command that simulates.
    let place = crate::support::Workplace::with_small(&short);
    place.write("labels.csv", "case,method,torsion\n7,quadrature,smooth\n");
    for (arguments, case) in [
        (&["simulate", "small.toml"][..], 0),
        (&["inspect", "small.toml"], 0),
        (&["run", "small.toml", "--dry-run"], 0),
        (&["check", "small.toml", "labels.csv"], 7),
    ] {
        let meant = format!("1 s is not before the end of case {case}, 0.5 s");
        refused(&place, arguments, &[key, &meant]);
    }
}
