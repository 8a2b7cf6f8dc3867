//! A person's mistakes: each is refused with one message that names the file,
//! the line and the key, and leaves nothing behind.

mod arguments;
mod large_files;
mod lateral;
mod other_files;
mod random_axes;
mod spreadsheets;
mod traces;
mod written;

use crate::refusals::{RUN, each_is_refused, refused, refused_at};
use crate::support::{SMALL, Workplace, small_with_design, with};

#[test]
fn the_small_sweep_itself_has_no_mistake() {
    let answer = Workplace::with_small(SMALL).sweep(&RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
}

#[test]
fn a_misspelt_key_is_named_with_its_line() {
    each_is_refused(
        r#"
        ⏎time_s => ⏎times_s | times_s | did you mean `time_s`?
        density_kg_m3 => densty_kg_m3 | string.densty_kg_m3 | did you mean `density_kg_m3`?
        inner_radius_m = 0.04 => iner_radius_m = 0.04 | string.sections[0].parts[1].iner_radius_m | did you mean `inner_radius_m`?
        [bit] => [bit]⏎weight_on_bit = 10 | bit.weight_on_bit | did you mean `weight_on_bit_kn`?
        [30, 70] } => [30, 70] }⏎[method.finite_element]⏎gamma = 0.6 | method.finite_element | did you mean `finite-element`? | finite_element
        count = 3 => number = 3 | design.axes.surface_speed_rpm.number | known here: from, to, count
        [map] => [plot] | plot | known here: name, title
        density_kg_m3 => density | string.density | did you mean `density_kg_m3`?
        [map] => [map]⏎methods = ["hilbert"] | map.methods | it belongs above the first [table]
        "#,
    );
}

#[test]
fn what_is_missing_is_named() {
    let parts = &SMALL[SMALL.find("[[string.sections]]").unwrap()..SMALL.find("[bit]").unwrap()];
    refused_at(
        &with(SMALL, parts, ""),
        "[string]",
        "string.sections",
        "is missing",
    );
    each_is_refused(
        r#"
        , outer_radius_m = 0.15 } =>  } | string.sections[0].parts[1].outer_radius_m | is missing
        kind = "grid" =>  | design.kind | is missing | [design]
        repeat = 10 =>  | string.sections[0].repeat | is missing | [[string.sections]]
        name = "A",  =>  | map.marks[0].name | is missing | marks
        rock = "sandstone" => rock = "law" | bit.rock | needs a table [bit.law]
        rock = "sandstone" => rock = "table" | bit.rock | table_kn_nm
        "#,
    );
}

/// There is no line to name then.
#[test]
fn a_table_missing_from_the_whole_file_is_named() {
    let start = SMALL.find("[string]").unwrap();
    let text = with(SMALL, &SMALL[start..SMALL.find("[bit]").unwrap()], "");
    refused(
        &Workplace::with_small(&text),
        &RUN,
        &["small.toml: `string`: is missing"],
    );
    let text = with(&small_with_design(""), "surface_speed_rpm = 60\n", "");
    refused(
        &Workplace::with_small(&with(
            &text,
            "\"sandstone\"",
            "\"sandstone\"\nweight_on_bit_kn = 9",
        )),
        &RUN,
        &["small.toml: `surface_speed_rpm`: is needed"],
    );
}

#[test]
fn an_invalid_string_is_refused() {
    each_is_refused(
        r#"
        length_m = 0.5 => length_m = 0 | string.sections[0].parts[1].length_m | 0 m is not between 0.001 and
        length_m = 0.5 => length_m = -1 | string.sections[0].parts[1].length_m | -1 m is not between 0.001 and
        inner_radius_m = 0.04 => inner_radius_m = 0.2 | string.sections[0].parts[1].inner_radius_m | internal radius < external radius, but has 0.2 m and 0.15 m
        inner_radius_m = 0.04 => inner_radius_m = -0.04 | string.sections[0].parts[1].inner_radius_m | -0.04 m is not between 0 and
        repeat = 10 => repeat = 0 | string.sections[0].repeat | 0 is not between 1 and
        rad_m = 10 => rad_m = -10 | string.torsional_damping_nms_rad_m | is not between 0 and
        "#,
    );
}

#[test]
fn a_string_of_nothing_is_refused() {
    let (start, parts) = ("[[string.sections]]", "parts = [");
    let from = |piece| &SMALL[SMALL.find(piece).unwrap()..SMALL.find("[bit]").unwrap()];
    let text = with(SMALL, from(start), "");
    let text = with(&text, "[string]", "[string]\nsections = []");
    refused_at(&text, "sections = []", "string.sections", "has no section");
    let text = with(SMALL, from(parts), "parts = []\n");
    refused_at(
        &text,
        "parts = []",
        "string.sections[0].parts",
        "has no part",
    );
}

#[test]
fn a_site_off_the_string_or_on_another_is_refused() {
    each_is_refused(
        r#"
        from_bit_m = 50 => from_bit_m = 100 | sites[0].distance_from_bit_m | off the string, which is 100 m long
        from_bit_m = 50 => from_bit_m = -5 | sites[0].distance_from_bit_m | -5 m from the bit is off the string
        from_bit_m = 50 => from_bit_m = nan | sites[0].distance_from_bit_m | off the string
        from_bit_m = 50 => from_bit_m = 50⏎[[sites]]⏎distance_from_bit_m = 50.0 | sites[1].distance_from_bit_m | two sites are 50 m from the bit
        "#,
    );
}

#[test]
fn an_axis_without_values_is_refused() {
    each_is_refused(
        r#"
        count = 3 => count = 0 | design.axes.surface_speed_rpm | the grid is empty
        [30, 70] => [] | design.axes.weight_on_bit_kn | the grid is empty
        from = 0.02, to = 0.6 => from = 0.6, to = 0.02 | design.axes.surface_speed_rpm.to | 0.02 is not above `from`, 0.6
        from = 0.02,  =>  | design.axes.surface_speed_rpm | a grid axis has `from`, `to` and `count` | count
        count = 3 => count = 3, values = [1] | design.axes.surface_speed_rpm | a grid axis has `from`, `to` and `count`, or `values`
        ⏎weight_on_bit_kn => ⏎weight_on_bit_n | design.axes.weight_on_bit_n | did you mean `weight_on_bit_kn`?
        from = 0.02, to = 0.6, count = 3 => from = 0, to = 0.6, count = 3, spacing = "log" | design.axes.surface_speed_rpm.from | the surface must turn
        { values = [30, 70] } => { from = 0, to = 70, count = 3, spacing = "log" } | design.axes.weight_on_bit_kn.from | logarithmic spacing starts above zero
        "#,
    );
    let no_axis = small_with_design("[design]\nkind = \"grid\"");
    refused_at(&no_axis, "[design]", "design.axes", "names no axis");
}

#[test]
fn a_design_too_large_for_memory_is_refused() {
    each_is_refused(
        r#"
        count = 3 => count = 1000001 | design.axes.surface_speed_rpm.count | 1000001 values are more than
        0.6, count = 3 }⏎weight_on_bit_kn = { values = [30, 70] } => 0.6, count = 900000 }⏎weight_on_bit_kn = { from = 1, to = 70, count = 900000 } | design | 810000000000 cases are more than | [design]
        "#,
    );
    let random = small_with_design(
        "[design]\nkind = \"monte-carlo\"\ncases = 9_000_000_000\n\
         [design.axes]\nsurface_speed_rpm = { from = 1, to = 2 }\nweight_on_bit_kn = { from = 1, to = 2 }",
    );
    refused_at(
        &random,
        "cases",
        "design.cases",
        "9000000000 cases are more than",
    );
}

#[test]
fn a_surface_that_does_not_turn_is_refused() {
    each_is_refused(
        r#"
        surface_speed_rpm = 60 => surface_speed_rpm = 0e0 | surface_speed_rpm | 0 rpm: the surface must turn
        surface_speed_rpm = 60 => surface_speed_rpm = -60 | surface_speed_rpm | -60 rpm: the surface must turn
        from = 0.02 => from = 0 | design.axes.surface_speed_rpm.from | 0 rpm: the surface must turn
        { from = 0.02, to = 0.6, count = 3 } => { values = [60, 0, 1] } | design.axes.surface_speed_rpm.values[1] | 0 rpm: the surface must turn
        speed_rpm = 0.3 => speed_rpm = 0 | map.marks[0].surface_speed_rpm | 0 rpm: the surface must turn
        "#,
    );
}

#[test]
fn a_slip_of_units_is_suspected() {
    each_is_refused(
        r#"
        gpa = 80 => gpa = 80e9 | string.shear_modulus_gpa | is it in another unit?
        kg_m3 = 7840 => kg_m3 = 7.84 | string.density_kg_m3 | is it in another unit?
        hz = 100 => hz = 0.64 | sampling_frequency_hz | is it in another unit?
        length_m = 9.5 => length_m = 9500 | string.sections[0].parts[0].length_m | the string is 95005 m long, more than 20000 m; is this in another unit?
        outer_radius_m = 0.125 => outer_radius_m = 125 | string.sections[0].parts[0].outer_radius_m | is it in another unit?
        [30, 70] => [30, 70e3] | design.axes.weight_on_bit_kn.values[1] | 70000 kN is not between 0 and 2000 kN; is it in another unit?
        { values = [30, 70] } => { from = 5, to = 5e4, count = 2 } | design.axes.weight_on_bit_kn.to | is it in another unit?
        "sandstone" => "sandstone"⏎weight_on_bit_kn = 50e3 | bit.weight_on_bit_kn | is it in another unit?
        "#,
    );
}

#[test]
fn methods_that_cannot_be_used_are_refused() {
    each_is_refused(
        r#"
        "quadrature" => "quadratur" | methods[0] | did you mean `quadrature`?
        "quadrature" => "magic" | methods[0] | known here: held
        "quadrature" => "quadrature", "hilbert", "quadrature" | methods[2] | is named twice
        "quadrature" =>  | methods | names no method | methods
        [30, 70] } => [30, 70] }⏎[method.finite-element]⏎gamma = 0.4 | method.finite-element.gamma | 0.5 to 1
        [30, 70] } => [30, 70] }⏎[method.finite-element]⏎gamma = nan | method.finite-element.gamma | 0.5 to 1
        [30, 70] } => [30, 70] }⏎[method.finite-element]⏎beta = 0.1 | method.finite-element.beta | gamma / 2 to 1
        [30, 70] } => [30, 70] }⏎[method.finite-element]⏎elements_per_cell = 0 | method.finite-element.elements_per_cell | at least 1
        [30, 70] } => [30, 70] }⏎[method.finite-element]⏎elements_per_cell = 1_000_000_000 | method.finite-element.elements_per_cell | are more than
        [30, 70] } => [30, 70] }⏎[method.hilbert]⏎transform_s = 0 | method.hilbert.transform_s | 0 s is not between
        "#,
    );
}

#[test]
fn a_method_that_needs_damping_says_so() {
    for method in ["hilbert", "direct-idft"] {
        let text = with(SMALL, "rad_m = 10", "rad_m = 0");
        refused_at(
            &with(&text, "quadrature", method),
            "rad_m = 0",
            "string.torsional_damping_nms_rad_m",
            &format!("{method} needs damping in torsion"),
        );
        refused(
            &Workplace::with_small(&text),
            &["run", "small.toml", "--out", "results", "--methods", method],
            &[
                "small.toml:",
                "string.torsional_damping_nms_rad_m",
                method,
                "needs damping in torsion",
            ],
        );
    }
}

#[test]
fn a_method_that_needs_damping_in_bending_says_so() {
    let bends = "rad_m = 10\nbending = { youngs_modulus_gpa = 210, damping_ns_m2 = 0 }";
    let walls = "[wall]\nclearance_mm = 15\nstiffness_gn_m15 = 1\nfriction = 0.3\n[[sites]]\ndistance_from_bit_m = 0\n[map]";
    let text = with(&with(SMALL, "rad_m = 10", bends), "[map]", walls);
    for method in ["hilbert", "direct-idft"] {
        refused_at(
            &with(&text, "quadrature", method),
            "bending = {",
            "string.bending.damping_ns_m2",
            &format!("{method} needs damping in bending"),
        );
    }
}

/// Known only when the responses are built.
#[test]
fn responses_that_cannot_be_built_are_the_files_fault() {
    let short = "[method.hilbert]\ntransform_s = 0.01\n[map]";
    let text = with(&with(SMALL, "[map]", short), "quadrature", "hilbert");
    refused(
        &Workplace::with_small(&text),
        &RUN,
        &[
            "small.toml: ",
            "hilbert",
            "transform_s = 0.01",
            "four samples",
        ],
    );
}

#[test]
fn an_invalid_bit_is_refused() {
    each_is_refused(
        r#"
        "sandstone" => "sandston" | bit.rock | did you mean `sandstone`?
        "sandstone" => "granite" | bit.rock | known here: sandstone, shale
        rock = "sandstone" =>  | bit.rock | a weight on bit needs a rock | [bit]
        [bit] => [bit]⏎weight_on_bit_kn = 50⏎torque_dynamic_nm = 900 | bit.torque_dynamic_nm | not both
        [bit] => [bit]⏎torque_static_ratio = 0.9 | bit.torque_static_ratio | 0.9 is not between 1 and
        rock = "sandstone" => rock = "table"⏎table_kn_nm = [[1, 2], [1, 3]] | bit.table_kn_nm | both increasing
        rock = "sandstone" => rock = "table"⏎table_kn_nm = [[1, 2]] | bit.table_kn_nm | two rows or more
        [bit]⏎rock = "sandstone" =>  | design | the axis weight_on_bit_kn needs a table [bit] | [design]
        "#,
    );
    let no_torque = small_with_design("");
    refused_at(&no_torque, "[bit]", "bit", "needs `torque_dynamic_nm`");
    let both = small_with_design(
        "[design]\nkind = \"grid\"\n[design.axes]\n\
         weight_on_bit_kn = { values = [1] }\ntorque_dynamic_nm = { values = [1] }",
    );
    refused_at(&both, "[design]", "design", "one gives the other");
}

#[test]
fn a_weight_beyond_the_rocks_table_is_refused() {
    let text = with(
        SMALL,
        "rock = \"sandstone\"",
        "rock = \"table\"\ntable_kn_nm = [[10, 200], [60, 3000]]",
    );
    refused(
        &Workplace::with_small(&text),
        &RUN,
        &[
            "small.toml: case 1: ",
            "70 kN is outside the rock's table, 10 to 60 kN",
        ],
    );
}

#[test]
fn a_map_that_cannot_be_drawn_is_refused() {
    each_is_refused(
        r#"
        [map] => [map]⏎x = "torque_dynamic_nm" | map.x | torque_dynamic_nm is not an axis of the design
        [map] => [map]⏎y = "torque_dynamic_nm" | map.y | torque_dynamic_nm is not an axis of the design
        [map] => [map]⏎x = "weight" | map.x | did you mean `weight_on_bit_kn`?
        [map] => [map]⏎x = "weight_on_bit_kn"⏎y = "weight_on_bit_kn" | map.x | is the axis upwards too | x =
        surface_speed_rpm = 0.3,  =>  | map.marks[0] | does not say its surface_speed_rpm | marks
        , weight_on_bit_kn = 50 =>  | map.marks[0] | does not say its weight_on_bit_kn | marks
        surface_speed_rpm = { from = 0.02, to = 0.6, count = 3 } => torsional_damping_nms_rad_m = { values = [5, 9] } | map.marks[0] | a mark has no place on a map over torsional_damping_nms_rad_m | marks
        "#,
    );
    let rock = "rock = \"table\"\ntable_kn_nm = [[10, 200], [80, 6000]]";
    let text = with(SMALL, "rock = \"sandstone\"", rock);
    let text = with(&text, "weight_on_bit_kn = 50", "torque_dynamic_nm = 9000");
    let key = "map.marks[0].torque_dynamic_nm";
    let meant = "9000 N m is outside the rock's table, 200 to 6000 N m";
    refused_at(&text, "9000", key, meant);
    // On a map over the torque, none is asked for its weight.
    let axes = "surface_speed_rpm = { from = 0.02, to = 0.6, count = 3 }\n";
    let by_speed = with(&text, "weight_on_bit_kn = { values = [30, 70] }\n", "");
    let by_torque = "torque_dynamic_nm = { values = [900, 1800] }\n";
    let text = with(&by_speed, axes, &format!("{axes}{by_torque}"));
    let answer = Workplace::with_small(&text).sweep(&RUN);
    assert_eq!((answer.code, answer.errors.as_str()), (0, ""));
}

#[test]
fn a_key_of_another_kind_of_design_is_refused() {
    each_is_refused(
        r#"
        "grid" => "grid"⏎seed = 3 | design.seed | does not belong to this kind of design
        "grid" => "grid"⏎cases = 3 | design.cases | does not belong to this kind of design
        "grid" => "grid"⏎file = "a.csv" | design.file | does not belong to this kind of design
        "grid" => "list"⏎file = "a.csv" | design.axes | does not belong to this kind of design | [design.axes]
        "grid" => "grid"⏎points = "sobol" | design.points | does not belong to this kind of design
        "grid" => "random" | design.kind | known here: grid, monte-carlo, list, sensitivity, trace
        "grid" => "sensitivity" | design | needs `cases`, how many to draw | [design]
        "grid" => "sensitivity"⏎cases = 9 | design.axes.surface_speed_rpm | a random axis has `from` and `to` | count = 3
        "grid" => "monte-carlo"⏎cases = 9⏎points = "halton" | design.points | known here: random, sobol
        "grid" => "monte-carlo" | design | needs `cases`, how many to draw | [design]
        "grid" => "monte-carlo"⏎cases = 0 | design.cases | there must be at least one
        "grid" => "monte-carlo"⏎cases = 9 | design.axes.surface_speed_rpm | a random axis has `from` and `to` | count = 3
        "#,
    );
}

#[test]
fn invalid_times_are_refused() {
    each_is_refused(
        r#"
        time_s = 12 => time_s = -12 | time_s | -12 s is not between
        time_s = 12 => time_s = 0 | time_s | 0 s is not between
        hz = 100 => hz = -100 | sampling_frequency_hz | -100 Hz is not between
        "#,
    );
}

#[test]
fn invalid_axes_of_the_string_are_refused() {
    let axes = "count = 3 }\n";
    for (axis, key, meant) in [
        (
            "section_1_repeat = { values = [3] }",
            "design.axes.section_1_repeat",
            "the string has 1 sections, from 0",
        ),
        (
            "section_0_repeat = { values = [3, 3.5] }",
            "design.axes.section_0_repeat.values[1]",
            "3.5 is not a whole number",
        ),
        (
            "section_0_part_2_length_m = { values = [3] }",
            "design.axes.section_0_part_2_length_m",
            "section 0 has 2 parts, from 0",
        ),
        (
            "section_0_part_1_length_m = { from = -1, to = 3, count = 2 }",
            "design.axes.section_0_part_1_length_m.from",
            "between",
        ),
        (
            "site_1_distance_from_bit_m = { values = [3] }",
            "design.axes.site_1_distance_from_bit_m",
            "the file has 1 [[sites]], from 0",
        ),
        (
            "bending_damping_ns_m2 = { values = [3] }",
            "design.axes.bending_damping_ns_m2",
            "[string.bending]",
        ),
        (
            "section_0_part_0_lenght_m = { values = [3] }",
            "design.axes.section_0_part_0_lenght_m",
            "did you mean `section_0_part_0_length_m`?",
        ),
    ] {
        let text = with(SMALL, axes, &format!("{axes}{axis} # here\n"));
        refused_at(&text, "# here", key, meant);
    }
}
