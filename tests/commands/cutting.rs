//! A bit that cuts what its blades leave: what goes together with it, what is refused, and starts by
//! chance.

use std::io::Write;
use std::process::Stdio;

use crate::support::{CUTTING, SMALL, Workplace, with};

pub fn done(place: &Workplace, arguments: &[&str]) -> String {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.errors);
    answer.output
}

/// Columns of a table by their names, row by row.
pub fn columns<const COUNT: usize>(
    place: &Workplace,
    file: &str,
    names: [&str; COUNT],
) -> Vec<[String; COUNT]> {
    let mut table = csv::Reader::from_path(place.path(file)).unwrap();
    let header = table.headers().unwrap().clone();
    let places = names.map(|name| header.iter().position(|other| other == name).unwrap());
    let rows = table.records().map(Result::unwrap);
    rows.map(|row| places.map(|place| row[place].to_owned()))
        .collect()
}

fn before_design(more: &str) -> String {
    with(CUTTING, "[design]\n", &format!("{more}\n[design]\n"))
}

/// Each by its key, with the reason and what to write.
#[test]
fn what_does_not_go_together_with_cutting_is_refused_by_its_key() {
    let first = |key: &str| with(CUTTING, "title = ", &format!("{key}\ntitle = "));
    let friction = "[well]\nsurvey = \"survey.csv\"\n[string_friction]\nstatic_coefficient = 0.3";
    let fed = with(
        CUTTING,
        "weight_on_bit_kn = 20\n",
        "[feed]\nkind = \"speed\"\n",
    );
    let fed = with(
        &fed,
        "weight_on_bit_kn = { values = [10, 30] }",
        "feed_m_h = { values = [3, 5] }",
    );
    let fed_and_rubbing = with(&fed, "[design]\n", &format!("{friction}\n[design]\n"));
    let axis = |axis: &str| format!("{CUTTING}{axis} = {{ values = [1, 2] }}\n");
    let hilbert = with(CUTTING, "\"quadrature\"", "\"hilbert\"");
    for (text, key, words) in [
        (
            first("certify = true"),
            "certify",
            "motion is often chaotic",
        ),
        (first("start = \"stuck\""), "start", "begins at rest"),
        (first("start = \"both\""), "start", "begins at rest"),
        (fed_and_rubbing, "feed.kind", "depends on the weight on bit"),
        (hilbert, "methods", "below a hook load it moves as a whole"),
        (
            axis("torque_dynamic_nm"),
            "design.axes.torque_dynamic_nm",
            "depth of cut",
        ),
        (
            axis("torque_static_ratio"),
            "design.axes.torque_static_ratio",
            "depth of cut",
        ),
        (
            axis("feed_m_h"),
            "design.axes.feed_m_h",
            "the hook load decides",
        ),
        (
            SMALL.replace(
                "weight_on_bit_kn = { values = [30, 70] }",
                "weight_on_bit_kn = { values = [30, 70] }\nstart_number = { values = [1, 2] }",
            ),
            "design.axes.start_number",
            "needs a bit with [bit.cutting]",
        ),
    ] {
        let place = Workplace::with_small(&text);
        place.write("survey.csv", "md_m,inc_deg,azi_deg\n0,0,0\n200,40,0\n");
        let answer = place.sweep(&["run", "small.toml"]);
        assert_eq!(answer.code, 2, "{key}: {}", answer.output);
        assert!(
            answer.errors.contains(&format!("`{key}`")),
            "{key}: {}",
            answer.errors
        );
        assert!(answer.errors.contains(words), "{key}: {}", answer.errors);
    }
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["simulate", "small.toml", "--set", "start_number=2"]);
    assert_eq!(answer.code, 2, "{}", answer.output);
    assert!(
        answer.errors.contains("its bit has no [bit.cutting]"),
        "{}",
        answer.errors
    );
}

/// With a surface that moves at its speed `hilbert` has a string that is held.
#[test]
fn a_fed_string_goes_together_with_hilbert() {
    let fed = with(
        &before_design("[feed]\nkind = \"speed\"\n"),
        "weight_on_bit_kn = 20\n",
        "",
    );
    let fed = with(&fed, "weight_on_bit_kn = {", "feed_m_h = {");
    let place = Workplace::with_small(&with(&fed, "\"quadrature\"", "\"hilbert\""));
    done(&place, &["run", "small.toml"]);
    // What is fed is drilled.
    let names = ["feed_m_h", "rate_of_penetration_m_h"];
    for row in columns(&place, "results/small/labels.csv", names) {
        let [feed, rate] = row.map(|cell| cell.parse::<f64>().unwrap());
        assert!((rate / feed - 1.0).abs() < 0.2, "{feed} m/h: {rate} m/h");
    }
}

#[test]
fn a_recording_is_compared_with_and_a_recorded_speed_followed() {
    let recorded = "time_s,rpm,torque_nm\n0,0,0\n5,60,700\n10,90,900\n30,60,1200\n";
    let compare = "[[compare]]\nname = \"speed\"\nfile = \"recorded.csv\"\ncolumn = \"rpm\"\n\
                   trace = \"bit_speed_rpm\"\nfrom_s = 1\nto_s = 19\n\
                   [[compare]]\nname = \"torque\"\nfile = \"recorded.csv\"\n\
                   column = \"torque_nm\"\ntrace = \"surface_torque_nm\"\nfrom_s = 1\nto_s = 19\n";
    let place = Workplace::with_small(&before_design(compare));
    place.write("recorded.csv", recorded);
    done(&place, &["run", "small.toml"]);
    for row in columns(
        &place,
        "results/small/labels.csv",
        ["misfit_speed_rpm", "misfit_torque_nm"],
    ) {
        assert!(
            row.iter().all(|cell| cell.parse::<f64>().unwrap() > 0.0),
            "{row:?}"
        );
    }
    let followed = with(
        CUTTING,
        "surface_speed_rpm = 60",
        "surface_speed_file = \"recorded.csv\"",
    );
    let followed = with(
        &followed,
        "surface_speed_rpm = { from = 40, to = 160, count = 3 }\n",
        "",
    );
    place.write(
        "followed.toml",
        with(&followed, "time_s = 20", "time_s = 12"),
    );
    done(&place, &["simulate", "followed.toml", "--out", "one"]);
    let history = columns(&place, "one/history.csv", ["time_s", "bit_speed_rpm"]);
    let mean = |from: f64, to: f64| {
        let rows = history
            .iter()
            .map(|row| row.clone().map(|it| it.parse::<f64>().unwrap()));
        let inside: Vec<f64> = rows
            .filter(|row| (from..to).contains(&row[0]))
            .map(|row| row[1])
            .collect();
        inside.iter().sum::<f64>() / inside.len() as f64
    };
    // The bit follows its surface, from 60 to 90 rpm.
    assert!((mean(4.0, 6.0) - 60.0).abs() < 6.0, "{}", mean(4.0, 6.0));
    assert!((mean(9.5, 10.5) - 90.0).abs() < 6.0, "{}", mean(9.5, 10.5));
}

/// A tool at the bit feels what the bit does; one further up something else, and nothing moves otherwise.
#[test]
fn tools_feel_accelerations_along_the_axis() {
    let felt = |tools: &[f64]| {
        let tools = tools
            .iter()
            .map(|place| format!("[[tools]]\ndistance_from_bit_m = {place}\n"));
        let place = Workplace::with_small(&before_design(&tools.collect::<String>()));
        done(&place, &["run", "small.toml", "--out", "out"]);
        let names = [
            "axial_acceleration_band_peak_g",
            "axial_acceleration_step_rms_g",
            "weight_peak_kn",
        ];
        let numbers = |row: [String; 3]| row.map(|number| number.parse::<f64>().unwrap());
        let rows = columns(&place, "out/labels.csv", names).into_iter();
        rows.map(numbers).collect::<Vec<_>>()
    };
    let [bit, at_bit, above] = [&[][..], &[0.0], &[25.0]].map(felt);
    for ((bit, at_bit), above) in bit.iter().zip(&at_bit).zip(&above) {
        for (bit, tool) in bit.iter().zip(at_bit) {
            assert!((bit - tool).abs() <= 1e-9 * bit.abs(), "{bit} {tool}");
        }
        assert!(
            above[0] > 0.0 && (above[0] / bit[0] - 1.0).abs() > 1e-6,
            "{above:?} {bit:?}"
        );
        assert_eq!(above[2], bit[2]);
    }
}

/// The same numbers on standard input, in shards, as JSON.
#[test]
fn cutting_runs_from_standard_input_and_in_shards() {
    let place = Workplace::with_small(CUTTING);
    done(&place, &["run", "small.toml", "--out", "whole"]);
    for shard in ["0/2", "1/2"] {
        let out = format!("part-{}", &shard[..1]);
        done(
            &place,
            &["run", "small.toml", "--shard", shard, "--out", &out],
        );
    }
    done(&place, &["merge", "part-0", "part-1", "--out", "merged"]);
    let mut command = place.command(&["run", "-", "--out", "piped"]);
    let mut running = command
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    (running.stdin.take().unwrap().write_all(CUTTING.as_bytes())).unwrap();
    assert!(running.wait().unwrap().success());
    let labels = |folder: &str| std::fs::read(place.path(&format!("{folder}/labels.csv"))).unwrap();
    assert_eq!(labels("merged"), labels("whole"));
    assert_eq!(labels("piped"), labels("whole"));
    let json = done(&place, &["summary", "whole", "--json"]);
    assert!(
        json.contains("rate_of_penetration_m_h") || json.contains("axial"),
        "{json}"
    );
}

#[test]
fn sobol_indices_are_found_of_the_rate_of_penetration() {
    let design = with(
        CUTTING,
        "kind = \"grid\"",
        "kind = \"sensitivity\"\ncases = 32",
    );
    let design = with(&design, ", count = 3", "");
    let design = with(&design, "values = [10, 30]", "from = 10, to = 30");
    let place = Workplace::with_small(&with(&design, "time_s = 20", "time_s = 10"));
    done(&place, &["run", "small.toml"]);
    let said = done(&place, &["analyse", "results/small"]);
    assert!(
        said.contains("rate_of_penetration_m_h by quadrature"),
        "{said}"
    );
}

/// Starts that differ by a hundredth have other motions where these are chaotic, the same labels
/// where they are not, and maps with fractions; number 0 is the start of the file.
#[test]
fn starts_by_chance_say_how_sure_a_label_is() {
    // Across the limit of stick-slip.
    let grid = with(
        CUTTING,
        "values = [10, 30]",
        "from = 20, to = 24, count = 17",
    );
    let grid = with(
        &grid,
        "from = 40, to = 160, count = 3",
        "values = [80, 120]",
    );
    let starts = format!("{grid}start_number = {{ from = 0, to = 4, count = 5 }}\n");
    let place = Workplace::with_small(&starts);
    let said = done(&place, &["run", "small.toml"]);
    assert!(said.contains("170 cases"), "{said}");
    place.write("alone.toml", &grid);
    done(&place, &["run", "alone.toml"]);
    let names = [
        "surface_speed_rpm",
        "weight_on_bit_kn",
        "rate_of_penetration_m_h",
        "torsion",
    ];
    let alone = columns(&place, "results/alone/labels.csv", names);
    let [rows, numbers] = [
        columns(&place, "results/small/labels.csv", names),
        columns(
            &place,
            "results/small/labels.csv",
            ["start_number", "case", "case", "case"],
        ),
    ];
    let undisturbed = rows.iter().zip(&numbers).filter(|(_, of)| of[0] == "0");
    let undisturbed: Vec<_> = undisturbed.map(|(row, _)| row.clone()).collect();
    assert_eq!(undisturbed, alone);
    let mut differ = 0;
    for point in rows.chunks(5) {
        assert!(point.iter().all(|row| row[..2] == point[0][..2]));
        let rates = point.iter().map(|row| row[2].parse::<f64>().unwrap());
        let mean = rates.clone().sum::<f64>() / 5.0;
        assert!(
            rates.clone().all(|rate| (rate / mean - 1.0).abs() < 0.2),
            "{point:?}"
        );
        // No two starts are the same.
        let mut rates: Vec<u64> = rates.map(f64::to_bits).collect();
        rates.sort_unstable();
        rates.dedup();
        assert!(rates.len() > 1, "{point:?}");
        differ += usize::from(point.iter().any(|row| row[3] != point[0][3]));
    }
    assert!(
        (1..9).contains(&differ),
        "{differ} of 9 points have starts that differ"
    );
    let map = std::fs::read_to_string(place.path("results/small/map.svg")).unwrap();
    assert!(map.contains("starts by chance"), "no fractions");
    let window = done(&place, &["window", "small.toml", "--accept-chatter"]);
    assert!(window.contains("within its"), "{window}");
}

/// A string that rubs along its well above a bit that cuts, drilling steadily: the cut is that of the
/// string that does not rub, and friction adds μ w sin(I) r L to the torque at the surface, by three methods.
#[test]
fn a_string_that_rubs_above_a_bit_that_cuts_takes_both_torques() {
    let [inner, outer, friction] = [0.05_f64, 0.0635, 0.2];
    let weight = 7840.0 * 9.80665 * std::f64::consts::PI * (outer * outer - inner * inner);
    let rubs = friction * weight * 60f64.to_radians().sin() * outer * 400.0;
    let cuts = with(
        &with(
            CUTTING,
            "\"quadrature\"",
            "\"held\", \"quadrature\", \"finite-element\"",
        ),
        "time_s = 20",
        "time_s = 60\nsurface_speed_rise_s = 5\nsurface_torque = true",
    );
    let cuts = with(&cuts, "repeat = 10", "repeat = 40");
    let cuts = with(&cuts, "hz = 200", "hz = 400");
    let damping = "[string.axial]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 400\n[bit]\n";
    let cuts = with(&cuts, "[bit]\n", damping);
    let cuts = with(
        &cuts,
        "surface_speed_rpm = { from = 40, to = 160, count = 3 }",
        "surface_speed_rpm = { values = [160] }",
    );
    let friction = format!(
        "[well]\ninclination_deg = 60\n[string_friction]\nstatic_coefficient = {friction}\n\
         pressed_by = \"weight\"\npieces = 5\n[design]\n"
    );
    let place = Workplace::new();
    place.write("cuts.toml", &cuts);
    place.write("rubs.toml", with(&cuts, "[design]\n", &friction));
    let names = ["axial", "rate_of_penetration_m_h", "surface_torque_mean_nm"];
    let [alone, rubbing] = ["cuts", "rubs"].map(|name| {
        done(
            &place,
            &["run", &format!("{name}.toml"), "--out", name, "--quiet"],
        );
        columns(&place, &format!("{name}/labels.csv"), names)
    });
    assert_eq!(alone.len(), 6);
    for (alone, rubbing) in alone.iter().zip(&rubbing) {
        let number = |text: &String| text.parse::<f64>().unwrap();
        assert_eq!([&alone[0], &rubbing[0]], ["steady"; 2]);
        let [rate, rubbing_rate] = [alone, rubbing].map(|row| number(&row[1]));
        assert!(
            (rubbing_rate / rate - 1.0).abs() < 1e-6,
            "{rubbing_rate} {rate}"
        );
        let [torque, rubbing_torque] = [alone, rubbing].map(|row| number(&row[2]));
        assert!(
            ((rubbing_torque - torque) / rubs - 1.0).abs() < 1e-3,
            "{rubbing_torque} {torque} {rubs}"
        );
    }
}

/// In words, in JSON, in what a run keeps and in its report.
#[test]
fn the_margin_of_axial_motion_is_shown() {
    let place = Workplace::with_small(CUTTING);
    let words = done(&place, &["inspect", "small.toml"]);
    assert!(
        words.contains("in axial motion: stable in sticking"),
        "{words}"
    );
    let json = done(&place, &["inspect", "small.toml", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let inspected = json["methods"][0]["axial_margin"].as_f64().unwrap();
    done(&place, &["run", "small.toml", "--out", "out", "--quiet"]);
    let manifest = std::fs::read_to_string(place.path("out/manifest.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    assert_eq!(
        manifest["methods"][0]["axial_margin"].as_f64(),
        Some(inspected)
    );
    done(&place, &["report", "out"]);
    let page = std::fs::read_to_string(place.path("out/report.html")).unwrap();
    assert!(page.contains("in axial motion"));
}
