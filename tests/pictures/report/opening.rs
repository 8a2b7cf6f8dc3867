//! What a report opens with: sentences whose numbers are those of the tables.

use crate::report::page::markup;
use crate::report::{
    copy_with_labels, report, succeeds, text, unwrapped, with_results, write_table,
};
use crate::support::{SMALL, Workplace, small_with_design, with};

/// The opening of a summary, on one line.
fn opening(place: &Workplace, folder: &str) -> String {
    let summary = succeeds(place, &["summary", folder]).output;
    let (_, opening) = summary.split_once("In short\n").expect("an opening");
    let opening = opening.split("\n\n").next().unwrap();
    unwrapped(opening.split_once('\n').unwrap().1)
}

#[track_caller]
fn assert_says(text: &str, sentences: &[&str]) {
    for sentence in sentences {
        assert!(text.contains(sentence), "no {sentence:?} in\n{text}");
    }
}

/// Replaces the labels of both methods by those of a rule, of the speed and the weight on bit.
fn labelled(rule: impl Fn(&str, f64, f64) -> bool) -> Workplace {
    let place = with_results();
    let labels = text(&place, "results/labels.csv");
    let header = labels.lines().next().unwrap();
    let column = |name: &str| header.split(',').position(|other| other == name).unwrap();
    let places = ["method", "surface_speed_rpm", "weight_on_bit_kn", "torsion"].map(column);
    let relabel = |line: &str| {
        let mut fields: Vec<&str> = line.split(',').collect();
        let [method, speed, weight, torsion] = places;
        let number = |of: usize| fields[of].parse().unwrap();
        let is_slipping = rule(fields[method], number(speed), number(weight));
        fields[torsion] = if is_slipping { "stick_slip" } else { "smooth" };
        fields.join(",")
    };
    let rows = labels.lines().skip(1).map(relabel);
    let lines: Vec<String> = [header.to_owned()].into_iter().chain(rows).collect();
    write_table(&place, "results", "labels.csv", lines.join("\n") + "\n");
    place
}

/// Speeds of 0.02, 0.31 and 0.6 rpm: the limit is half-way between two of them.
#[test]
fn the_limit_is_said_where_labels_change() {
    let place = labelled(|_, speed, weight| weight > 50.0 && speed < 0.4);
    let opening = opening(&place, "results");
    assert_says(
        &opening,
        &[
            "Does the bit below 100 m of string stick and slip, with surface speed from 0.02 to \
             0.6 rpm and weight on bit from 30 to 70 kN?",
            "By every method the bit sticks and slips in 33 % of the cases and turns smoothly in \
             67 %.",
            "At 30 kN the bit turns smoothly at every speed; at 70 kN it sticks and slips below \
             about 0.5 rpm.",
            "The methods agree on 100 % of the cases.",
            "Every case has an answer.",
        ],
    );
}

/// By one method below 0.15 rpm and by the other up to 0.5 rpm.
#[test]
fn where_methods_differ_the_limit_is_partly() {
    let place = labelled(|method, speed, weight| {
        weight > 50.0 && speed < if method == "quadrature" { 0.1 } else { 0.4 }
    });
    assert_says(
        &opening(&place, "results"),
        &[
            "the methods differ in 17 %",
            "sticks and slips below about 0.2 rpm, and partly up to 0.5 rpm",
            "The methods agree on 83 % of the cases.",
        ],
    );
}

/// The mark of the small sweep is at 50 kN and 0.3 rpm, as near to either weight; cases are 0.29 rpm
/// apart.
#[test]
fn a_mark_has_a_verdict_from_the_cases_around_it() {
    for (rule, verdict) in [
        (0.0, "the bit turns smoothly at every speed here"),
        (
            0.1,
            "the bit is at the limit of about 0.2 rpm: it may do either",
        ),
        (
            0.4,
            "the bit sticks and slips, 0.2 rpm below the limit of about 0.5 rpm",
        ),
        (1.0, "the bit sticks and slips at every speed here"),
    ] {
        let place = labelled(|_, speed, _| speed < rule);
        assert_says(
            &opening(&place, "results"),
            &[&format!("Mark A: 50 kN, 0.3 rpm: {verdict}.")],
        );
    }
}

#[test]
fn what_turns_in_the_hole_has_a_line_each() {
    let place = Workplace::with_small(&format!("units = \"field\"\n{SMALL}"));
    succeeds(&place, &["run", "small.toml", "--out", "results"]);
    assert_says(
        &opening(&place, "results"),
        &[
            "String: 328 ft: 328 ft of pipe (9.843 to 11.81 in across).",
            "Bit: in representative sandstone, breaks loose at 1.2 times the torque at which it \
             turns.",
            "Drive: the surface turns at its set speed, at any torque.",
            "Mud: not modelled.",
            "Only one method was used: no other checks it.",
        ],
    );
}

#[test]
fn the_mud_is_named_by_density_and_viscosity() {
    for (mud, units, words) in [
        (
            "density_kg_m3 = 1200\nviscosity_cp = 20",
            "si",
            "Mud: 1200 kg/m³, 20 cP.",
        ),
        (
            "density_ppg = 10.5\nviscosity_cp = 20",
            "field",
            "Mud: 10.5 ppg, 20 cP.",
        ),
    ] {
        let mud = format!("[mud]\n{mud}\n[well]\nhole_diameter_mm = 700\n\n[design]");
        let text = with(SMALL, "[design]", &mud);
        let place = Workplace::with_small(&format!("units = \"{units}\"\n{text}"));
        succeeds(&place, &["run", "small.toml", "--out", "results"]);
        assert_says(&opening(&place, "results"), &[words]);
    }
}

/// Before any map; what is for who repeats it is folded.
#[test]
fn the_page_opens_in_words_and_folds_its_details() {
    let place = with_results();
    copy_with_labels(&place, "other", |labels| labels);
    let page = markup(&report(&place, &["results", "other"]));
    let place_of = |words: &str| page.find(words).unwrap_or_else(|| panic!("no {words}"));
    assert!(place_of("What was asked</dt>") < place_of("class=\"area\""));
    assert_eq!(page.matches("What was found</dt>").count(), 2);
    // Of one string in both.
    assert_eq!(page.matches("<dt>String</dt>").count(), 1);
    let folded: usize = page
        .split("<details>")
        .skip(1)
        .filter(|it| it.contains("hash of the sweep"))
        .count();
    assert!(folded > 0, "{page}");
    let before = &page[..place_of("hash of the sweep")];
    assert!(before.matches("<details>").count() > before.matches("</details>").count());
}

/// Of random cases, a chart for each axis with the share of its ranges, and bars of what decides;
/// their tables are folded.
#[test]
fn shares_of_random_cases_are_charts_with_their_numbers_folded() {
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 60\nseed = 3\n[design.axes]\n\
                  surface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                  weight_on_bit_kn = { from = 30, to = 70 }\n";
    let place = Workplace::with_small(&small_with_design(design));
    succeeds(&place, &["run", "small.toml", "--out", "results"]);
    let page = markup(&report(&place, &["results"]));
    // The map, and a chart for each axis.
    assert_eq!(page.matches("class=\"area\"").count(), 3);
    assert_eq!(page.matches("Cases with stick-slip (%)</span>").count(), 2);
    assert!(page.contains("(95 % interval)") && page.contains(" decides most, alone "));
    let mut depth = 0;
    for tag in page.split('<') {
        depth += usize::from(tag.starts_with("details>"));
        depth -= usize::from(tag.starts_with("/details>"));
        assert!(
            !tag.starts_with("table>") || depth > 0,
            "a table is not folded"
        );
    }
}

/// The misfit of two cases, of which the second is nearer to the recording.
#[test]
fn the_case_nearest_to_a_recording_is_named() {
    let place = Workplace::with_small(&with(
        SMALL,
        "[design]\n",
        "[[compare]]\nname = \"run\"\ntrace = \"bit_speed_rpm\"\nfile = \"bit.csv\"\n\
         column = \"rpm\"\nfrom_s = 0\nto_s = 10\n\n[design]\n",
    ));
    let rows: String = (0..=110)
        .map(|step| format!("{},0.6\n", 0.1 * f64::from(step)))
        .collect();
    place.write("bit.csv", format!("time_s,rpm\n{rows}"));
    succeeds(&place, &["run", "small.toml", "--out", "results"]);
    let labels = text(&place, "results/labels.csv");
    let header: Vec<&str> = labels.lines().next().unwrap().split(',').collect();
    let column = header
        .iter()
        .position(|name| name.starts_with("misfit_"))
        .expect("a misfit");
    let misfit = |row: &&str| -> f64 { row.split(',').nth(column).unwrap().parse().unwrap() };
    let best = labels
        .lines()
        .skip(1)
        .min_by(|one, other| misfit(one).total_cmp(&misfit(other)));
    let case = best.unwrap().split(',').next().unwrap();
    let said = format!("Nearest to the recording “run” is case {case} by quadrature");
    assert_says(
        &opening(&place, "results"),
        &[&said, "nearest to what was recorded"],
    );
}
