//! Friction along the string as a user meets it: what turning takes, interrupted runs, and files that
//! are wrong.

use super::rows::{number, rows};
use crate::support::{Answer, Workplace};

/// A small sweep over friction, and its files.
fn place(sweep: &str) -> Workplace {
    let place = Workplace::new();
    let write = |name: &str, text: &str| std::fs::write(place.path(name), text).unwrap();
    write(
        "survey.csv",
        "md_ft,inc_deg,azi_deg\n0,0,0\n1000,0,0\n2000,40,0\n9000,40,0\n",
    );
    write(
        "recorded.csv",
        "time_s,speed_rpm,torque_klbf_ft\n0,0,0\n2,60,5\n20,60,5\n21,60,5\n",
    );
    write("sweep.toml", sweep);
    place
}

const SWEEP: &str = r#"surface_speed_rpm = 60
surface_speed_rise_s = 2
time_s = 20
sampling_frequency_hz = 40
methods = ["quadrature", "finite-element"]
[string]
shear_modulus_gpa = 79.3
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 0.05
[[string.sections]]
repeat = 200
parts = [{ length_m = 10, inner_diameter_in = 4.276, outer_diameter_in = 5 }]
[well]
survey = "survey.csv"
[mud]
density_ppg = 10
[string_friction]
dynamic_ratio = 0.7
stribeck_rpm = 5
pieces = 8
pressed_by = "weight"
[design]
kind = "grid"
[design.axes]
string_friction = { from = 0.1, to = 0.5, count = 5 }
torsional_damping_nms_rad_m = { values = [0.05, 0.2] }
"#;

fn run(place: &Workplace, more: &[&str]) -> Answer {
    let arguments = [&["run", "sweep.toml", "--out", "out", "--quiet"], more].concat();
    place.sweep(&arguments)
}

/// The mean at the surface is what sliding takes, by both methods; and the number of threads
/// changes no byte.
#[test]
fn val_a_sweep_over_friction_has_what_turning_takes() {
    let compare = "[[compare]]\ntrace = \"surface_torque_nm\"\nfile = \"recorded.csv\"\n\
                   column = \"torque_klbf_ft\"\nfrom_s = 5\nto_s = 20\n";
    let sweep = format!("{SWEEP}{compare}");
    let here = place(&sweep);
    let output = run(&here, &[]);
    assert_eq!(output.code, 0, "{}", output.errors);
    let table = std::fs::read_to_string(here.path("out/labels.csv")).unwrap();
    let rows = rows(&table);
    assert_eq!(rows.len(), 20);
    for row in &rows {
        let (damping, friction) = (
            number(row, "torsional_damping_nms_rad_m"),
            number(row, "string_friction"),
        );
        let mean = number(row, "surface_torque_mean_nm");
        // The buoyed weight across the well: an arc of 304.8 m to 40°, and straight on.
        let area = std::f64::consts::FRAC_PI_4 * (0.127_f64.powi(2) - 0.108_610_4_f64.powi(2));
        let weight = (7850.0 - 1198.26) * area * 9.80665;
        let bend = 40f64.to_radians();
        let across = 304.8 / bend * (1.0 - bend.cos()) + (2000.0 - 609.6) * bend.sin();
        let sliding = 0.7 * friction * weight * 0.0635 * across;
        let damped = damping * 2.0 * std::f64::consts::PI * 2000.0;
        assert!(
            (mean / (sliding + damped) - 1.0).abs() < 0.005,
            "{mean} {sliding} {damped}"
        );
        // Held against 6.78 kN m.
        let misfit = number(row, "misfit_surface_torque_nm");
        assert!(
            (misfit - (mean - 6779.1).abs()).abs() < 0.25 * mean,
            "{misfit} {mean}"
        );
    }
    let again = place_of(&sweep, &["--jobs", "1"]);
    assert_eq!(again, table);
}

/// A bit that cuts below a drive, on a string that rubs along its well and whirls at a wall: by waves
/// between all pieces, by pieces one after the other and by pieces of elements, which share no
/// code that steps a string.
#[test]
fn val_friction_a_wall_a_bit_and_a_drive_go_together_by_three_methods() {
    let sweep = SWEEP
        .replace("time_s = 20", "time_s = 60")
        .replace("sampling_frequency_hz = 40", "sampling_frequency_hz = 200")
        .replace("[\"quadrature\",", "[\"held\", \"quadrature\",")
        .replace(
            "_rad_m = 0.05\n[[",
            "_rad_m = 0.2\nbending = { youngs_modulus_gpa = 210, damping_ns_m2 = 200 }\n[[",
        )
        .replace("pieces = 8", "pieces = 4\nstatic_coefficient = 0.2")
        .replace(
            "[mud]\ndensity_ppg = 10\n",
            "[top_drive]\ninertia_kg_m2 = 2900\ncontroller = \"stiff\"\n\
             [bit]\ntorque_static_ratio = 1.6\n\
             [wall]\nclearance_mm = 30\nfriction = 0.8\nstiffness_gn_m15 = 1\nlies_on_low_side = false\n\
             [[sites]]\ndistance_from_bit_m = 20\n[[sites]]\ndistance_from_bit_m = 0\n\
             [[impulses]]\ndistance_from_bit_m = 20\namount_ns = 1000\nduration_s = 0.05\nstart_s = 12\n",
        );
    let design =
        "surface_speed_rpm = { values = [15, 150] }\ntorque_dynamic_nm = { values = [6000] }\n";
    let (setting, _) = sweep.split_once("string_friction = {").unwrap();
    let table = place_of(&format!("{setting}{design}"), &[]);
    let rows = rows(&table);
    assert_eq!(rows.len(), 6);
    let text = |row: &[(String, String)], column: &str| {
        let cell = row.iter().find(|(name, _)| name == column);
        cell.unwrap().1.clone()
    };
    for of_case in rows.chunks(3) {
        for row in &of_case[1..] {
            for column in ["torsion", "lateral"] {
                assert_eq!(text(row, column), text(&of_case[0], column), "{column}");
            }
            for (column, tolerance) in [
                ("first_slip_s", 0.1),
                ("first_contact_s", 0.01),
                ("surface_torque_mean_nm", 0.05),
            ] {
                let [one, other] = [row, &of_case[0]].map(|row| number(row, column));
                let off = (one / other - 1.0).abs();
                assert!(off < tolerance, "{column}: {one} {other}");
            }
        }
    }
    let labels: Vec<String> = rows
        .iter()
        .step_by(3)
        .map(|row| text(row, "torsion"))
        .collect();
    assert_eq!(labels, ["stick_slip", "smooth"]);
    assert_ne!(text(&rows[3], "lateral"), "no_contact");
}

fn place_of(sweep: &str, more: &[&str]) -> String {
    let place = place(sweep);
    let output = run(&place, more);
    assert_eq!(output.code, 0, "{}", output.errors);
    std::fs::read_to_string(place.path("out/labels.csv")).unwrap()
}

/// A run that continues with more cases writes what one run does, and one whose recording has
/// changed does not continue.
#[test]
fn results_depend_on_what_the_files_say() {
    let sweep = SWEEP.replace(
        "kind = \"grid\"",
        "kind = \"monte-carlo\"\nseed = 3\ncases = 6",
    );
    let sweep = sweep.replace(
        "{ from = 0.1, to = 0.5, count = 5 }",
        "{ from = 0.1, to = 0.5 }",
    );
    let sweep = sweep.replace("{ values = [0.05, 0.2] }", "{ from = 0.05, to = 0.2 }");
    let sweep = sweep.replace("pieces = 8", "tolerance = 0.03\ntorque_along_string = true");
    let whole = place_of(&sweep, &[]);
    let here = place(&sweep.replace("cases = 6", "cases = 4"));
    assert_eq!(run(&here, &[]).code, 0);
    std::fs::write(here.path("sweep.toml"), &sweep).unwrap();
    assert_eq!(run(&here, &[]).code, 0);
    let grown = std::fs::read_to_string(here.path("out/labels.csv")).unwrap();
    assert_eq!(grown, whole);
    std::fs::write(
        here.path("survey.csv"),
        "md_ft,inc_deg,azi_deg\n0,0,0\n9000,50,0\n",
    )
    .unwrap();
    let output = run(&here, &[]);
    assert_ne!(output.code, 0);
    assert!(
        output.errors.contains("survey and recordings"),
        "{}",
        output.errors
    );
}

/// Collars rub at the radius of the blades next to them, and where they are too long for that at their
/// own, in a level well.
#[test]
fn val_collars_rub_at_the_radius_of_blades_that_carry_them() {
    let place = Workplace::new();
    place.write(
        "bladed.toml",
        "surface_speed_rpm = 60\ntime_s = 10\n[string]\nshear_modulus_gpa = 79.3\n\
         density_kg_m3 = 7850\ntorsional_damping_nms_rad_m = 0.05\n\
         [[string.sections]]\nrepeat = 1\nparts = [\n\
         { length_m = 60, inner_radius_m = 0.04, outer_radius_m = 0.1 },\n\
         { length_m = 1, inner_radius_m = 0.04, outer_radius_m = 0.1, contact_radius_m = 0.15 },\n\
         { length_m = 8, inner_radius_m = 0.04, outer_radius_m = 0.1 },\n]\n\
         [well]\ninclination_deg = 90\n[string_friction]\nstatic_coefficient = 0.2\n\
         pressed_by = \"weight\"\n",
    );
    let answer = place.sweep(&["inspect", "bladed.toml", "--json"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let inspected: serde_json::Value = serde_json::from_str(&answer.output).unwrap();
    let found = inspected["well"]["torque_to_turn_off_bottom_knm"].as_f64();
    let weight = 7.850 * 9.80665 * std::f64::consts::PI * (0.1_f64.powi(2) - 0.04_f64.powi(2));
    let expected = weight * (60.0 * 0.1 + 9.0 * 0.15);
    assert!(
        (found.unwrap() / expected - 1.0).abs() < 1e-9,
        "{found:?} {expected}"
    );
}

/// As many pieces as a tolerance takes, in words and in the manifest; a file that gives their
/// number may be the base.
#[test]
fn val_a_tolerance_takes_as_many_pieces_as_it_needs() {
    let here = place(SWEEP);
    let tolerance = "base = \"sweep.toml\"\n[string_friction]\ntolerance = 0.01\n\
                     [design]\ncases = 1\nkind = \"monte-carlo\"\n\
                     [design.axes]\nstring_friction = { from = 0.1, to = 0.5 }\n";
    here.write("fine.toml", tolerance);
    let output = here.sweep(&["inspect", "fine.toml"]);
    assert_eq!(output.code, 0, "{}", output.errors);
    let line = (output.output.lines()).find(|line| line.contains("pieces that slip as wholes"));
    let words: Vec<&str> = line.unwrap().split_whitespace().collect();
    let pieces: usize = words[5].trim_end_matches(',').parse().unwrap();
    let off: f64 = words[8].parse().unwrap();
    // Below 300 m of vertical well an even string: no fewer than a quarter of 1/0.01 of what rubs.
    assert!((29..60).contains(&pieces), "{pieces}");
    assert!((0.9..=1.0).contains(&off), "{off}");
    let output = here.sweep(&["run", "fine.toml", "--out", "out", "--quiet"]);
    assert_eq!(output.code, 0, "{}", output.errors);
    let manifest = std::fs::read_to_string(here.path("out/manifest.json")).unwrap();
    assert!(
        manifest.contains(&format!("\"pieces\": {pieces}")),
        "{manifest}"
    );
}

/// The greatest torque along the string has its own columns where it is asked for, and changes no
/// other; runs that are continued and parts that are merged have them to the byte.
#[test]
fn the_greatest_torque_along_the_string_has_columns() {
    let asked = SWEEP.replace("pieces = 8", "pieces = 8\ntorque_along_string = true");
    let (without, whole) = (place_of(SWEEP, &[]), place_of(&asked, &[]));
    for row in rows(&whole) {
        let (torque, at) = (
            number(&row, "string_torque_peak_nm"),
            number(&row, "string_torque_peak_from_bit_m"),
        );
        // Half a piece of 250 m below the surface, or further down.
        assert!(0.0 < at && at <= 1875.0, "{at}");
        let at_surface = number(&row, "surface_torque_peak_nm");
        assert!(torque > 0.8 * at_surface, "{torque} {at_surface}");
    }
    let shorter = |line: &str| -> Vec<String> {
        let fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        fields[..fields.len() - 2].to_vec()
    };
    let lines = |text: &str| -> Vec<Vec<String>> { text.lines().map(shorter).collect() };
    let without: Vec<Vec<String>> = (without.lines())
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect();
    assert_eq!(lines(&whole), without);
    let here = place(&asked);
    for part in ["0/2", "1/2"] {
        let out = format!("part{}", &part[..1]);
        let arguments = [
            "run",
            "sweep.toml",
            "--shard",
            part,
            "--out",
            &out,
            "--quiet",
        ];
        assert_eq!(here.sweep(&arguments).code, 0);
    }
    let output = here.sweep(&["merge", "part0", "part1", "--out", "merged"]);
    assert_eq!(output.code, 0, "{}", output.errors);
    let merged = std::fs::read_to_string(here.path("merged/labels.csv")).unwrap();
    assert_eq!(merged, whole);
}

/// A recording takes the place of its base's speed, with friction along the string and without,
/// and a set speed that of its base's recording.
#[test]
fn a_recorded_surface_and_a_set_speed_replace_one_another() {
    let here = place(SWEEP);
    let free = "[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
                torsional_damping_nms_rad_m = 5\n[[string.sections]]\nrepeat = 50\n\
                parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]\n";
    here.write(
        "free.toml",
        format!("surface_speed_rpm = 9\ntime_s = 20\n{free}"),
    );
    let compare = "[[compare]]\ntrace = \"bit_speed_rpm\"\nfile = \"recorded.csv\"\n\
                   column = \"speed_rpm\"\nfrom_s = 15\nto_s = 20\n";
    let recorded = "surface_speed_file = \"recorded.csv\"\n";
    here.write(
        "recorded.toml",
        format!("base = \"free.toml\"\n{recorded}{compare}"),
    );
    here.write(
        "set.toml",
        "base = \"recorded.toml\"\nsurface_speed_rpm = 30\n",
    );
    for (file, misfit) in [("recorded.toml", 0.0), ("set.toml", 30.0)] {
        let output = here.sweep(&["simulate", file, "--out", file.trim_end_matches(".toml")]);
        assert_eq!(output.code, 0, "{}", output.errors);
        let table = here.path(file.trim_end_matches(".toml")).join("case.csv");
        let row = rows(&std::fs::read_to_string(table).unwrap()).remove(0);
        let found = number(&row, "misfit_bit_speed_rpm");
        assert!((found - misfit).abs() < 1e-3, "{file}: {found}");
    }
}

/// Each with file, line and key.
#[test]
fn what_is_wrong_is_refused_with_its_place() {
    let with = |from: &str, to: &str| SWEEP.replace(from, to);
    let surface = |file: &str| {
        let sweep = with("surface_speed_rpm = 60\nsurface_speed_rise_s = 2\n", "");
        format!("surface_speed_file = \"{file}\"\n{sweep}")
    };
    for (sweep, table, expected) in [
        (
            with("[well]\nsurvey = \"survey.csv\"\n", ""),
            "",
            "`string_friction`: what presses",
        ),
        (
            with("repeat = 200", "repeat = 400"),
            "",
            "`well.survey`: the survey ends at 2743",
        ),
        (
            with("density_ppg = 10", "density_ppg = 80"),
            "",
            "`mud.density_ppg`: ",
        ),
        (
            with(
                "[well]\n",
                "[top_drive]\ninertia_kg_m2 = 9\ncontroller = \"prescribed\"\n[well]\n",
            )
            .replace("surface_speed_rise_s = 2\n", ""),
            "",
            "`top_drive.inertia_kg_m2`: a rotor that is at its speed at once",
        ),
        (
            with("pieces = 8", "pieces = 8\ntolerance = 0.01"),
            "",
            "sweep.toml:21: `tolerance`: conflicts with `pieces`: give only one",
        ),
        (
            with("pieces = 8", "tolerance = 0.5"),
            "",
            "sweep.toml:20: `string_friction.tolerance`: 0.5 is not between 0.0001 and 0.1",
        ),
        (
            with("pieces = 8", "tolerance = 0.0001"),
            "",
            "sweep.toml:20: `string_friction.tolerance`: no number of pieces up to 2000 keeps to \
             0.0001: the nearest, 2000, is off by 0.000",
        ),
        (
            with("pieces = 8", "pieces = 0"),
            "",
            "`string_friction.pieces`: 0 is not between 1",
        ),
        (
            with(
                "[string_friction]\n",
                "[wall]\nfriction = 1\n[string_friction]\n",
            ),
            "",
            "`mud`: what moves with a string that bends",
        ),
        (
            with("pieces = 8", "pieces = 8\ntorque_along_string = true")
                .replace("\"quadrature\", ", "\"held\", "),
            "",
            "sweep.toml:21: `string_friction.torque_along_string`: the torque along the string is \
             followed where that is in pieces",
        ),
        (
            SWEEP.to_owned(),
            "md_ft,inc_deg,azi_deg\n0,0,0\n3000,10,0\n2000,40,0\n9000,40,0\n",
            "survey.csv:4: the depth of station 2",
        ),
        (
            SWEEP.to_owned(),
            "md_ft,inc_deg\n0,0\n9000,1\n",
            "survey.csv:1: there is no column with azimuth",
        ),
        (
            SWEEP.to_owned(),
            "md_ft,inc_deg,azi_deg\n0,0,0\n9000,x,0\n",
            "survey.csv:3: inc_deg: `x` is not",
        ),
        (surface("late.csv"), "", "late.csv cannot be read"),
        (surface("back.csv"), "", "back.csv:5: time 2 s of sample 3"),
        (
            surface("gap.csv"),
            "",
            "gap.csv:7: nothing was recorded for 40 s",
        ),
        (
            surface("recorded.csv").replace("time_s = 20", "time_s = 30"),
            "",
            "`time_s`: the surface was recorded for 21 s only",
        ),
    ] {
        let here = place(&sweep);
        let write = |name: &str, text: &str| std::fs::write(here.path(name), text).unwrap();
        write(
            "back.csv",
            "time_s,speed_rpm\n0,0\n1,10\n2,20\n2,30\n20,30\n",
        );
        write(
            "gap.csv",
            "time_s,speed_rpm\n0,0\n1,1\n2,2\n3,3\n4,4\n44,5\n",
        );
        if !table.is_empty() {
            write("survey.csv", table);
        }
        let output = run(&here, &[]);
        assert_eq!(output.code, 2, "{expected}: {}", output.errors);
        assert!(
            output.errors.contains(expected),
            "{expected}: {}",
            output.errors
        );
        assert!(!here.path("out").exists());
    }
}

/// Pipe that lies on sites up to some height, which may cut a piece: μ w sin(I) r L of the whole string,
/// and what its damping takes.
#[test]
fn val_surface_torque_is_of_contacts_below_and_friction_above() {
    let [length, inner, outer, damping, friction] = [400.0_f64, 0.054, 0.0635, 0.1, 0.2];
    let weight = 7850.0 * 9.80665 * std::f64::consts::PI * (outer * outer - inner * inner);
    let speed = std::f64::consts::TAU;
    let across = weight * 60f64.to_radians().sin();
    let expected = length * (friction * across * outer + damping * speed);
    let string = format!(
        "surface_speed_rpm = 60\nsurface_torque = true\ntime_s = 20\nsampling_frequency_hz = 400\n\
         methods = [\"quadrature\"]\n[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
         torsional_damping_nms_rad_m = {damping}\n\
         bending = {{ youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }}\n[[string.sections]]\n\
         repeat = 1\nparts = [{{ length_m = {length}, inner_radius_m = {inner}, \
         outer_radius_m = {outer} }}]\n[well]\ninclination_deg = 60\n[string_friction]\n\
         static_coefficient = {friction}\npressed_by = \"weight\"\npieces = 10\n"
    );
    let on_sites = |to: f64| {
        format!(
            "{string}[wall]\nclearance_mm = 40\nstiffness_gn_m15 = 1\nfriction = {friction}\n\
             sites = \"ends\"\nsites_to_m = {to}\n"
        )
    };
    let files = [41.0, 100.0, 172.0].map(on_sites);
    for text in [string.clone()].iter().chain(&files) {
        let place = Workplace::new();
        place.write("rubs.toml", text);
        let answer = place.sweep(&["simulate", "rubs.toml", "--out", "out"]);
        assert_eq!(answer.code, 0, "{}", answer.errors);
        let table = std::fs::read_to_string(place.path("out/case.csv")).unwrap();
        let found = number(&rows(&table)[0], "surface_torque_mean_nm");
        assert!((found / expected - 1.0).abs() < 0.005, "{found} {expected}");
    }
}
