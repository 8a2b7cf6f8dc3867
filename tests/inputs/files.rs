//! Files of other programs and people, as they have them: headings, units, decimals, comments,
//! gaps and workbooks that are not what they say.

use crate::support::{Answer, Workplace};

/// 2 km of 5-inch pipe that rubs along its well.
const RUBS: &str = "\
surface_speed_rpm = 10
time_s = 20
methods = [\"quadrature\"]

[string]
shear_modulus_gpa = 79.3
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 0.02
[[string.sections]]
repeat = 200
parts = [{ length_m = 10, inner_diameter_in = 4.276, outer_diameter_in = 5 }]

[well]
survey = \"survey.csv\"

[string_friction]
static_coefficient = 0.25
pieces = 20
";

#[track_caller]
fn inspected(sweep: &str, files: &[(&str, &[u8])]) -> Answer {
    let place = Workplace::with_small(sweep);
    for (name, content) in files {
        place.write(name, content);
    }
    place.sweep(&["inspect", "small.toml"])
}

/// What a survey is answered, and the torque that turns the string in it, kN m per coefficient.
#[track_caller]
fn surveyed(name: &str, survey: &[u8]) -> (f64, Answer) {
    let sweep = RUBS.replace("survey.csv", name);
    let answer = inspected(&sweep, &[(name, survey)]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let line = answer
        .output
        .lines()
        .find(|line| line.contains("torque to turn it"));
    let number = line.and_then(|line| line.split_whitespace().nth(4));
    (number.unwrap().parse().unwrap(), answer)
}

#[track_caller]
fn refused_survey(survey: &str, words: &str) {
    let answer = inspected(RUBS, &[("survey.csv", survey.as_bytes())]);
    assert_eq!(answer.code, 2, "{survey}: {answer:?}");
    assert!(answer.errors.contains(words), "{survey}: {}", answer.errors);
}

/// The numbers are of an integral of another's making, as that of `crates/linear/tests/side_force.rs`.
#[test]
fn friction_along_the_string_is_added_up_from_station_to_station() {
    for (survey, torque) in [
        ("0,0,0\n1000,0,0\n1000.3,30,0\n2000,30,0", 15.86),
        ("0,0,0\n1000.7,0,0\n1001.7,3,0\n2000,3,0", 1.74),
        (
            "0,0,0\n300,2,120\n800,12,120\n800.5,13.2,120\n2000,55,121",
            11.13,
        ),
    ] {
        let survey = format!("measured_depth_m,inclination_deg,azimuth_deg\n{survey}\n");
        let (found, answer) = surveyed("survey.csv", survey.as_bytes());
        assert!((found - torque).abs() < 0.006, "{survey}: {found}");
        let is_sharp = survey.contains("1000.3,30");
        let words = "survey.csv: the well turns by 30.000° between 1000.00 m and 1000.30 m";
        assert_eq!(answer.errors.contains(words), is_sharp, "{}", answer.errors);
    }
}

#[test]
fn surveys_are_read_as_people_have_them() {
    let (expected, _) = surveyed(
        "survey.csv",
        b"measured_depth_m,inclination_deg,azimuth_deg\n0,0,0\n1000,20,0\n2500,30,90\n",
    );
    for text in [
        "Measured Depth (m),Inc[deg],Azimuth Grid ( deg )\n0,0,0\n1000,20,0\n2500,30,90\n",
        "MD [ft],Inclination [\u{b0}],AZI (\u{b0})\n0,0,0\n3280.8399,20,0\n8202.0997,30,90\n",
        "md,inclination,azimuth\n0,0,0\n1000,20,0\n2500,30,90\n",
        "Well 7 of field A\n\nMD;Incl.;Azim.;TVD\nm;deg;deg;m\n0;0;0;0\n1000;20;0;990\n2500;30;90;2300\n",
        "md_m;inc;azi_deg\nm;deg;deg\n0;0;0\n1000;20;0\n2500;30;90\n",
        "# surveyed twice\n#MD (m)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1000\t20\t0\n2500\t30\t90\n",
        "Meas. Depth (m);Inc (deg);Azi (deg)\n0,0;0;0\n1000,0;20,0;0\n2500;30;90\n",
        "Company;A\nSurvey report\n\nMD (usft);Inc (\u{b0});Azi (azimuth) (\u{b0})\n0,00;0,00;0,00\n\
         3.280,83;20,0;0\n8.202,08;30;90\n",
        "MD (ftKB),Inc (deg),Azi (deg)\n0,0,0\n\"3,280.84\",20,0\n\"8,202.10\",30,90\n",
        "MD (mRT)\tInc (deg)\tAzi (deg)\n0\t0\t0\n1 000,0\t20\t0\n2 500,0\t30\t90\n",
        "MD (km),Drift (rad),Direction (deg)\n0,0,0\n1,0.34906585,0\n2.5,0.523598776,90\n",
    ] {
        let (found, answer) = surveyed("survey.csv", text.as_bytes());
        assert!(
            (found - expected).abs() < 0.02,
            "{text}: {found}, not {expected}"
        );
        let has_units = !text.starts_with("md,");
        let reported = answer
            .errors
            .contains("`md` names no unit: its numbers are taken to be in m");
        assert_eq!(reported, !has_units, "{}", answer.errors);
    }
}

/// By `held` this would take minutes to build, by the others a moment.
#[test]
fn a_method_that_takes_long_for_friction_along_the_string_is_noted() {
    for (methods, note) in [
        ("[\"quadrature\", \"finite-element\"]", None),
        (
            "[\"quadrature\", \"held\"]",
            Some("note: by held the string rubs by responses between all of its 20 pieces"),
        ),
    ] {
        let place = Workplace::with_small(&RUBS.replace("[\"quadrature\"]", methods));
        place.write(
            "survey.csv",
            "md_m,inc_deg,azi_deg\n0,0,0\n1000,20,0\n2500,30,90\n",
        );
        let answer = place.sweep(&["run", "small.toml", "--dry-run"]);
        let found = answer
            .errors
            .contains("the string rubs by responses between all");
        assert_eq!(found, note.is_some(), "{answer:?}");
        assert!(
            answer.errors.contains(note.unwrap_or_default()),
            "{answer:?}"
        );
    }
}

#[test]
fn surveys_that_may_mean_two_things_are_refused() {
    for (survey, words) in [
        (
            "md_m,md_ft,inc,azi\n0,0,0,0\n2500,8000,30,0\n",
            "survey.csv:1: the columns `md_m` and `md_ft` say the same; it has `md_m`, `md_ft`, `inc`, `azi`",
        ),
        (
            "MD (yd),Inc,Azi\n0,0,0\n2500,30,0\n",
            "survey.csv:1: `MD (yd)`: `yd` is not one of the known units: m, ft,",
        ),
        (
            "TVD (m),Inc,Azi\n0,0,0\n2500,30,0\n",
            "survey.csv:1: there is no column with measured depth",
        ),
        // The widest line is the headings, and its rows are not what is wrong with it.
        (
            "Company;A\nSurvey\nTVD (m);Inc;Azi\n0;0;0\n2500;30\n",
            "survey.csv:3: there is no column with measured depth",
        ),
        (
            "MD (yd),Inc,Azi\nzero,0,0\n2500,30,0\n",
            "survey.csv:1: `MD (yd)`: `yd` is not one of the known units: m, ft,",
        ),
        (
            "MD (m),Inc,Azi\n0,0,0\n1000,-999.25,0\n2500,30,0\n",
            "survey.csv:3: Inc: -999.25 deg is not between 0 and 180 deg",
        ),
        (
            "MD (m),Inc,Azi\n0,0,0\n1000,20,1e6\n2500,30,0\n",
            "survey.csv:3: Azi: 1000000 deg is not between -360 and 720 deg",
        ),
        (
            "MD (m),Inc,Azi\n0,0,0\n1e300,20,1\n",
            "survey.csv:3: MD (m): ",
        ),
        (
            "MD (m);Inc;Azi\n0;0,5;0\n1.200;20;1\n2500;20;1\n",
            "survey.csv:3: MD (m): `1.200` may be 1.2 or 1200",
        ),
        (
            "MD (m),Inc,Azi\n0,0,0\n1000,20,0\n900,30,0\n",
            "survey.csv:4: the depth of station 2",
        ),
    ] {
        refused_survey(survey, words);
    }
}

/// A recording of 20 s at 60 rpm, with gaps in it.
#[test]
fn what_was_not_recorded_is_a_gap_and_not_a_speed() {
    let sweep = "surface_speed_file = \"speed.csv\"\ntime_s = 10\nmethods = [\"quadrature\"]\n\
        sampling_frequency_hz = 100\n[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
        torsional_damping_nms_rad_m = 1\n[[string.sections]]\nrepeat = 10\n\
        parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.06 }]\n\
        [bit]\nrock = \"sandstone\"\nweight_on_bit_kn = 50\n";
    let recording = |gap: &str, heading: &str| {
        let rows: String = (0..41)
            .map(|index| {
                let value = if index % 7 == 3 { gap } else { "60" };
                format!("{},{value}\n", 0.5 * f64::from(index))
            })
            .collect();
        format!("{heading}\n{rows}")
    };
    let simulated = |text: &str| {
        let place = Workplace::with_small(sweep);
        place.write("speed.csv", text);
        let answer = place.sweep(&["simulate", "small.toml", "--out", "out"]);
        (
            answer.code,
            answer.errors.clone(),
            std::fs::read_to_string(place.path("out/history.csv")).ok(),
        )
    };
    let expected = simulated(&recording("60", "time_s,speed_rpm"));
    assert_eq!(expected.0, 0, "{}", expected.1);
    for gap in [
        "-999.25",
        "-999",
        "-9999",
        "-9999.00",
        "-999.2500",
        "",
        "NaN",
        "null",
    ] {
        let (code, errors, history) = simulated(&recording(gap, "time_s,speed_rpm"));
        assert_eq!(
            (code, history),
            (0, expected.2.clone()),
            "{gap:?}: {errors}"
        );
        let note = "speed.csv: 6 of 41 rows have no value of `speed_rpm` and are ignored";
        assert!(errors.contains(note), "{gap:?}: {errors}");
    }
    let (code, errors, _) = simulated(&recording(
        "60",
        "# logged at the rig\n# Time (s),Depth (m)",
    ));
    assert_eq!(code, 2, "{errors}");
    assert!(
        errors.contains("it has `Time (s)`, `Depth (m)`"),
        "{errors}"
    );
    for heading in [
        "Time (s),Surface RPM",
        "Elapsed time [s],Speed [rpm]",
        "t_s,rpm",
    ] {
        assert_eq!(simulated(&recording("60", heading)), expected, "{heading}");
    }
    let (code, errors, _) = simulated(&recording("1e300", "time_s,speed_rpm"));
    assert_eq!(code, 2);
    let words = "speed.csv:5: 1e300 rpm is not between -10000 and 10000 rpm";
    assert!(
        errors.contains(words) || errors.contains("speed.csv:5: 1000"),
        "{errors}"
    );
    let (code, errors, _) =
        simulated(&recording("60", "time_s,speed_rpm,speed_rad_s").replace(",60\n", ",60,6\n"));
    assert_eq!(code, 2);
    assert!(errors.contains("several such columns"), "{errors}");
}

/// A string by a sheet.
const BY_SHEET: &str = "\
time_s = 20
methods = [\"quadrature\"]
sampling_frequency_hz = 50

[string]
shear_modulus_gpa = 79.3
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 0.5
file = \"bha.csv\"

[bit]
rock = \"sandstone\"

[design]
kind = \"grid\"
[design.axes]
surface_speed_rpm = { values = [10, 90] }
weight_on_bit_kn = { values = [50, 100] }
";

/// The lines that `inspect` has of a string.
#[track_caller]
fn sheet(text: &str) -> (String, String) {
    let answer = inspected(BY_SHEET, &[("bha.csv", text.as_bytes())]);
    assert_eq!(answer.code, 0, "{text}: {answer:?}");
    let lines = answer
        .output
        .lines()
        .skip_while(|line| !line.starts_with("string"));
    let string = lines.take_while(|line| !line.starts_with("methods"));
    (string.collect::<Vec<_>>().join("\n"), answer.errors)
}

const FROM_SURFACE: &str = "\
element,joints,od_in,id_in,length_m,weight_kg
DP 5\" 19.5#,100,5,4.276,950,29000
Drill Collar,10,8,3,95,
Stabilizer,1,8,3,2,
Bit,1,12.25,3,0.5,
";

#[test]
fn sheets_are_read_as_people_have_them_and_the_right_way_up() {
    let (expected, reported) = sheet(FROM_SURFACE);
    assert!(
        reported
            .contains("note: bha.csv: its rows are from the surface down, by what they are called")
    );
    let mut lines: Vec<&str> = FROM_SURFACE.lines().collect();
    lines[1..].reverse();
    let from_bit = lines.join("\n") + "\n";
    let (found, reported) = sheet(&from_bit);
    assert_eq!(found, expected);
    assert!(reported.contains("note: bha.csv: its rows are from the bit up, by what they are called (`order = \"from-bit\"`)"), "{reported}");
    for text in [
        FROM_SURFACE.replace(
            "element,joints,od_in,id_in,length_m,weight_kg",
            "Component,No. of Joints,O.D. (inch),I.D. (inch),Length (m),Weight (kgs)",
        ),
        FROM_SURFACE.replace(
            "element,joints,od_in,id_in,length_m,weight_kg",
            "\"BHA 3, rig 5\"\nTool,Qty,OD,ID,Length,Weight\n,,(in),(in),(m),(kg)",
        ),
        FROM_SURFACE.replace("element", "# element"),
        FROM_SURFACE
            .replace(',', ";")
            .replace("4.276", "4,276")
            .replace("12.25", "12,25")
            .replace("0.5", "0,5"),
    ] {
        assert_eq!(sheet(&text).0, expected, "{text}");
    }
    let wordy = FROM_SURFACE.replace("element,", "Component,Description,Remarks,");
    let wordy: String = wordy
        .lines()
        .map(|line| match line.split_once(',') {
            Some((name, rest)) if !line.starts_with("Component") => {
                format!("{name},{name},none,{rest}\n")
            }
            _ => format!("{line}\n"),
        })
        .collect();
    let (found, reported) = sheet(&wordy);
    assert_eq!(found, expected);
    assert!(
        reported.contains("ignored columns: `Remarks`"),
        "{reported}"
    );
    let (found, reported) = sheet(&format!("{FROM_SURFACE}Total,112,,,1047.5,\n"));
    assert_eq!(found, expected);
    assert!(
        reported.contains("note: bha.csv:6: a total, ignored"),
        "{reported}"
    );
    let (marked, _) = sheet(&FROM_SURFACE.replace("\nStabilizer,", "\n\"#2 Stabilizer\","));
    assert!(marked.contains("1 × 2.000 m, #2 Stabilizer"), "{marked}");
    let (_, reported) = sheet(&FROM_SURFACE.replace("\nStabilizer,1,8", "\n#Stabilizer,1,8"));
    assert!(
        reported.contains("note: bha.csv:4: 1 line below the headings ignored as comments"),
        "{reported}"
    );
}

#[test]
fn sheets_that_may_mean_two_things_are_refused_or_doubted() {
    let refused = |text: &str, words: &str| {
        let answer = inspected(BY_SHEET, &[("bha.csv", text.as_bytes())]);
        assert_eq!(answer.code, 2, "{text}: {answer:?}");
        assert!(answer.errors.contains(words), "{}", answer.errors);
    };
    let unnamed = FROM_SURFACE
        .replace("DP 5\" 19.5#", "one")
        .replace("Drill Collar", "two")
        .replace("\nBit", "\nthree");
    refused(
        &unnamed,
        "bha.csv: its rows do not say whether they are from the surface down or from the bit up",
    );
    refused(
        &FROM_SURFACE.replace("weight_kg", "Weight (stone)"),
        "bha.csv:1: `Weight (stone)`: `stone` is not one of the known units: kg, lb",
    );
    refused(
        &FROM_SURFACE.replace("Drill Collar,10,8,3,95,", "Drill Collar,10,8,3,9.5,"),
        "bha.csv:3: 10 joints in 9.50 m are 0.95 m each: is that the length of one?",
    );
    refused(
        &FROM_SURFACE.replace("joints,od_in", "od_mm,od_in"),
        "bha.csv:1: the columns `od_mm` and `od_in` say the same",
    );
    let (_, reported) = sheet(&FROM_SURFACE.replace(",8,3,95,", ",127,3,95,"));
    assert!(
        reported.contains("warning: bha.csv:3: Drill Collar: the part has"),
        "{reported}"
    );
    let (_, reported) = sheet(&FROM_SURFACE.replace("\nStabilizer,", "\n\"Mud motor, 5:6\","));
    assert!(
        reported.contains(
            "warning: bha.csv:4: Mud motor, 5:6: a mud motor is a tube of its dimensions here"
        ),
        "{reported}"
    );
    let one = FROM_SURFACE
        .replace("length_m", "joint_length_m")
        .replace(",950,", ",9.5,")
        .replace(",95,", ",9.5,");
    assert_eq!(sheet(&one).0, sheet(FROM_SURFACE).0);
}

/// Such a file is often the base of others.
#[test]
fn tables_without_effect_are_noted_and_doubtful_bits_warned_of() {
    let (expected, _) = sheet(FROM_SURFACE);
    let idle = "\n[mud]\ndensity_ppg = 10\n[well]\nsurvey = \"survey.csv\"\nhole_diameter_in = 12.25\n[design]\n";
    let sweep = BY_SHEET.replace("\n[design]\n", idle);
    let survey = b"MD (m),Inc (deg),Azi (deg)\n0,0,0\n2000,0,0\n";
    let answer = inspected(
        &sweep,
        &[("bha.csv", FROM_SURFACE.as_bytes()), ("survey.csv", survey)],
    );
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(
        answer.output.contains(expected.trim_end()),
        "{}",
        answer.output
    );
    for words in [
        "note: [mud] has no effect without",
        "note: `well.survey` has no effect without",
        "note: the hole of [well] has no effect without",
    ] {
        assert!(answer.errors.contains(words), "{words}: {}", answer.errors);
    }
    assert!(
        !answer.errors.contains("the rocks of this program"),
        "{}",
        answer.errors
    );
    let (_, reported) = sheet(&FROM_SURFACE.replace("12.25", "8.5"));
    assert!(reported.contains("bha.csv:5: the bit is 8.500 in wide, and the rocks of this program are for one of 11.8 in"), "{reported}");
    let heavy = BY_SHEET.replace("values = [50, 100]", "values = [50, 2000]");
    let answer = inspected(&heavy, &[("bha.csv", FROM_SURFACE.as_bytes())]);
    assert!(
        answer.errors.contains(
            "a weight on bit of 2000.0 kN is more than all of the string weighs along its well"
        ),
        "{}",
        answer.errors
    );
}

#[test]
fn workbooks_are_read_cell_by_cell_and_hostile_ones_are_refused() {
    let rows = [
        ["MD (m)", "Inc (deg)", "Azi (deg)"],
        ["0", "0", "0"],
        ["1000", "20", "0"],
        ["2500", "30", "90"],
    ];
    let (expected, _) = surveyed(
        "survey.csv",
        b"MD (m),Inc (deg),Azi (deg)\n0,0,0\n1000,20,0\n2500,30,90\n",
    );
    for (name, bytes) in [
        (
            "survey.xlsx",
            crate::workbook::xlsx(&rows.map(|row| row.to_vec())),
        ),
        (
            "survey.ods",
            crate::workbook::ods(&rows.map(|row| row.to_vec())),
        ),
    ] {
        let (found, _) = surveyed(name, &bytes);
        assert_eq!(found, expected, "{name}");
    }
    let cell = |place: &str| format!("<row><c r=\"{place}\"><v>1</v></c></row>");
    let many = format!("<row>{}</row>", "<c><v>1</v></c>".repeat(2000));
    let attributes = |count: usize| {
        (0..count)
            .map(|at| format!(" a{at}=\"1\""))
            .collect::<String>()
    };
    let ods_row =
        |cell: &str| crate::workbook::ods_of(&format!("<table:table-row>{cell}</table:table-row>"));
    for (name, bytes, words) in [
        (
            "s.xlsx",
            crate::workbook::xlsx_of(&cell("XFD1048576"), ""),
            "is beyond the 1048576 rows and 1000 columns that are read",
        ),
        (
            "s.xlsx",
            crate::workbook::xlsx_of(&cell("A99999999999"), ""),
            "cannot be read",
        ),
        (
            "s.xlsx",
            crate::workbook::xlsx_of("<row r=\"99999999999\"><c><v>1</v></c></row>", ""),
            "cannot be read",
        ),
        (
            "s.xlsx",
            crate::workbook::xlsx_of(&many, ""),
            "is beyond the",
        ),
        (
            "s.xlsx",
            crate::workbook::xlsx_of("", &"<si/>".repeat(11_000_000)),
            "it has more than 48 MiB once it is unpacked",
        ),
        (
            "s.xlsx",
            crate::workbook::xlsx_of(&format!("<row{}/>", attributes(50_000)), ""),
            "a tag of it has more than the 256 attributes that are read",
        ),
        (
            "s.ods",
            ods_row(&format!("<table:table-cell{}/>", attributes(50_000))),
            "a tag of it has more than the 256 attributes that are read",
        ),
        (
            "s.ods",
            ods_row(
                "<table:table-cell table:number-columns-repeated=\"4000000000\" office:value=\"1\"/>",
            ),
            "is beyond the",
        ),
        (
            "s.ods",
            ods_row("<table:table-cell table:number-columns-repeated=\"x\" office:value=\"1\"/>"),
            "cannot be read",
        ),
        (
            "s.xls",
            b"\xd0\xcf\x11\xe0".to_vec(),
            "save it as one of these, or as CSV",
        ),
        ("s.xlsb", Vec::new(), "save it as one of these, or as CSV"),
        ("s.xlsx", b"PK".to_vec(), "cannot be read"),
    ] {
        let answer = inspected(&RUBS.replace("survey.csv", name), &[(name, &bytes)]);
        assert_eq!(answer.code, 2, "{name}: {answer:?}");
        assert!(answer.errors.contains(words), "{words}: {}", answer.errors);
    }
}

/// What is to be left out of a base can be: the words that say so are taken.
#[test]
fn an_entry_of_a_list_of_a_base_is_left_out_by_the_words_of_its_refusal() {
    let place = Workplace::new();
    let base = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig09.toml");
    let axes = "[design]\nkind = \"grid\"\n[design.axes]\nweight_on_bit_kn = { values = [20, 30] }\n\
                torsional_damping_nms_rad_m = { values = [0.1, 0.2] }\n\
                [map]\nx = \"torsional_damping_nms_rad_m\"\ny = \"weight_on_bit_kn\"\n";
    let said = |without: &str| {
        place.write("small.toml", format!("base = {base:?}\n{without}\n{axes}"));
        place.answer(&["run", "small.toml", "--dry-run"])
    };
    let refused = said("");
    let words = "`map.marks[0]`: a mark has no place on a map over torsional_damping_nms_rad_m: leave it out";
    assert!(refused.errors.contains(words), "{}", refused.errors);
    let without = refused.errors.rsplit('`').nth(1).unwrap();
    assert_eq!(without, "without = [\"map.marks\"]");
    let taken = said(without);
    assert_eq!(taken.code, 0, "{}", taken.errors);
}

/// A key of a base is taken away by its name in any unit, a table as a whole; what is not there is refused.
#[test]
fn a_file_takes_keys_of_its_base_away() {
    let place = Workplace::new();
    let base = RUBS.replace("time_s = 20\n", "time_s = 20\ntitle = \"Other\"\n");
    place.write("other.toml", base);
    place.write(
        "survey.csv",
        "MD (m),Inc (deg),Azi (deg)\n0,0,0\n2000,40,0\n",
    );
    let said = |without: &str| {
        place.write(
            "small.toml",
            format!("base = \"other.toml\"\nwithout = {without}\n"),
        );
        place.answer(&["inspect", "small.toml", "--out", "looked"])
    };
    let all = said("[]");
    assert!(all.output.contains("Other"), "{all:?}");
    let less = said("[\"title\", \"string_friction.pieces\", \"string_friction\", \"well\"]");
    assert_eq!(less.code, 0, "{}", less.errors);
    assert!(!less.output.contains("Other"), "{}", less.output);
    assert!(
        less.output.contains("no [string_friction] is given"),
        "{}",
        less.output
    );
    for (without, words) in [
        (
            "[\"wall\"]",
            "small.toml:2: `without`: the base has no `wall`",
        ),
        (
            "[\"string.sections.repeat\"]",
            "the base has no `string.sections.repeat`",
        ),
        ("[\"\"]", "the base has no ``"),
        ("\"wall\"", "is a list of keys of the base"),
        ("[7]", "so they are strings"),
    ] {
        let refused = said(without);
        assert_eq!(refused.code, 2, "{without}");
        assert!(refused.errors.contains(words), "{}", refused.errors);
    }
}
