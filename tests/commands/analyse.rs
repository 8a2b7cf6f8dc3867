//! `sweep analyse`: fractions, their intervals and what decides, of runs as they are.

use crate::support::{Workplace, small_with_design};

/// Random cases of the small sweep, a third of which may be had first.
fn random(cases: usize) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"monte-carlo\"\nseed = 2\ncases = {cases}\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.02, to = 0.6 }}\nweight_on_bit_kn = {{ from = 30, to = 70 }}\n\
         [map]\nmarks = [{{ name = \"here\", surface_speed_rpm = 0.3, weight_on_bit_kn = 50 }}]\n"
    ))
}

fn done(place: &Workplace, arguments: &[&str]) -> String {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.errors);
    answer.output
}

fn run(place: &Workplace, more: &[&str]) {
    let arguments = ["run", "small.toml", "--quiet"];
    done(place, &[&arguments, more].concat());
}

fn csv(place: &Workplace, name: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(place.path(name)).unwrap();
    let row = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(row).collect()
}

/// Every row of each table that `analyse` prints is on the page, and no grid is counted so.
#[test]
fn a_report_of_random_cases_tells_the_same() {
    let place = Workplace::with_small(&random(200));
    run(&place, &["--out", "out"]);
    let said = done(&place, &["analyse", "out"]);
    done(&place, &["report", "out"]);
    let page = std::fs::read_to_string(place.path("out/report.html")).unwrap();
    assert!(page.contains("How often, how surely, what decides"));
    let mut rows = 0;
    for line in said
        .lines()
        .filter(|line| line.contains('%') || line.contains("weight_on_bit"))
    {
        let cells: Vec<&str> = line
            .split("  ")
            .map(str::trim)
            .filter(|it| !it.is_empty())
            .collect();
        if !line.starts_with("  ") || cells.len() < 4 {
            continue;
        }
        let row: Vec<String> = cells.iter().map(|cell| format!(">{cell}</td>")).collect();
        let mut on_page = page.split("<tr>").map(|row| row.to_owned());
        assert!(
            on_page.any(|it| row.iter().all(|cell| it.contains(cell))),
            "{line}"
        );
        rows += 1;
    }
    assert!(rows > 15, "{said}");
    place.write("grid.toml", crate::support::SMALL);
    done(&place, &["run", "grid.toml", "--quiet"]);
    done(&place, &["report", "results/grid"]);
    let page = std::fs::read_to_string(place.path("results/grid/report.html")).unwrap();
    assert!(!page.contains("what decides"));
}

/// Counts of the table are those of the labels, in all and by cells; the cells of an axis have
/// every case once.
#[test]
fn counts_are_those_of_the_labels() {
    let place = Workplace::with_small(&random(300));
    run(&place, &["--out", "out"]);
    let by = "surface_speed_rpm,weight_on_bit_kn";
    let said = done(
        &place,
        &[
            "analyse", "out", "--out", "a.csv", "--by", by, "--bins", "4",
        ],
    );
    assert!(
        said.contains("300 simulations; every one has an answer"),
        "{said}"
    );
    let table = csv(&place, "a.csv");
    let labels = csv(&place, "out/labels.csv");
    let place_of = |name: &str| labels[0].iter().position(|known| known == name).unwrap();
    let (torsion, speed) = (place_of("torsion"), place_of("surface_speed_rpm"));
    let sticking = labels
        .iter()
        .filter(|row| row[torsion] == "stick_slip")
        .count();
    assert!(sticking > 20 && sticking < 280, "{sticking}");
    let rows = |axis: &str, second: &str| -> Vec<&Vec<String>> {
        let is_one =
            |row: &&Vec<String>| row[2] == "stick_slip" && row[3] == axis && row[6] == second;
        table.iter().filter(is_one).collect()
    };
    let sum = |rows: &[&Vec<String>], column: usize| -> usize {
        rows.iter()
            .map(|row| row[column].parse::<usize>().unwrap())
            .sum()
    };
    for (axis, second, cells) in [
        ("", "", 1),
        ("surface_speed_rpm", "", 4),
        ("weight_on_bit_kn", "", 4),
        ("surface_speed_rpm", "weight_on_bit_kn", 16),
    ] {
        let rows = rows(axis, second);
        assert_eq!(
            (rows.len(), sum(&rows, 9), sum(&rows, 10)),
            (cells, sticking, 300)
        );
    }
    // One range of one axis, from the labels themselves.
    let first = rows("surface_speed_rpm", "")[0];
    let end: f64 = first[5].parse().unwrap();
    let inside = labels[1..]
        .iter()
        .filter(|row| row[speed].parse::<f64>().unwrap() <= end);
    let (mut all, mut stick) = (0, 0);
    for row in inside {
        all += 1;
        stick += usize::from(row[torsion] == "stick_slip");
    }
    assert_eq!(
        [&first[9], &first[10]],
        [&stick.to_string(), &all.to_string()]
    );
}

/// Shards are counted together as the whole is, and so is a run that is not finished as far as it
/// is; the same cases are not counted twice.
#[test]
fn shards_are_counted_together_and_foreign_folders_are_not() {
    let place = Workplace::with_small(&random(60));
    run(&place, &["--out", "whole"]);
    run(&place, &["--shard", "0/2", "--out", "one"]);
    run(&place, &["--shard", "1/2", "--out", "two"]);
    let counts = |folders: &[&str]| {
        done(
            &place,
            &[&["analyse"], folders, &["--out", "a.csv"]].concat(),
        );
        std::fs::read_to_string(place.path("a.csv")).unwrap()
    };
    assert_eq!(counts(&["one", "two"]), counts(&["whole"]));
    for (folders, meant) in [
        (["one", "one"], "hold the same cases"),
        (["whole", "one"], "hold the same cases"),
    ] {
        let answer = place.sweep(&[&["analyse"], &folders[..]].concat());
        assert_eq!(answer.code, 2, "{}", answer.errors);
        assert!(answer.errors.contains(meant), "{}", answer.errors);
    }
    place.write("small.toml", random(60).replace("seed = 2", "seed = 3"));
    run(&place, &["--shard", "1/2", "--out", "foreign"]);
    let answer = place.sweep(&["analyse", "one", "foreign"]);
    assert!(
        answer.errors.contains("are not of one sweep"),
        "{}",
        answer.errors
    );
    let answer = place.sweep(&["analyse", "one", "--by", "friction"]);
    assert_eq!(answer.code, 2);
    assert!(
        answer.errors.contains("do not differ in friction"),
        "{}",
        answer.errors
    );
}

/// Over two axes cells, over one curves; slow bits stick and fast ones do not, so that the line of a
/// half is somewhere.
#[test]
fn how_likely_a_regime_is_can_be_drawn() {
    let place = Workplace::with_small(&random(300));
    run(&place, &["--out", "out"]);
    let drawn = |by: &str, file: &str, more: &[&str]| {
        let arguments = ["analyse", "out", "--by", by, "--picture", file];
        let said = done(&place, &[&arguments, more].concat());
        assert!(said.ends_with(&format!("{file}\n")), "{said}");
        std::fs::read(place.path(file)).unwrap()
    };
    let both = "surface_speed_rpm,weight_on_bit_kn";
    let svg = |by: &str, more: &[&str]| String::from_utf8(drawn(by, "p.svg", more)).unwrap();
    let map = svg(both, &["--bins", "3"]);
    for word in ["stick-slip", "50 % of the cases<", "300 simulations"] {
        assert!(map.contains(word), "{word}: {map}");
    }
    // As many have the one label as have not the other.
    let smooth = svg(both, &["--bins", "3", "--regime", "smooth"]);
    assert!(smooth.contains("50 % of the cases<") && smooth != map);
    // Three cases of 300 in a cell are too few.
    let fine = svg(both, &["--bins", "10"]);
    assert!(fine.contains("too few cases") && !map.contains("too few cases"));
    let curves = svg("surface_speed_rpm", &[]);
    assert!(curves.contains("part of the cases"), "{curves}");
    // What the sweep points out is pointed out, whichever axis is to the right.
    let turned = svg("weight_on_bit_kn,surface_speed_rpm", &["--bins", "3"]);
    assert!([&map, &turned].into_iter().all(|it| it.contains("here")) && !curves.contains("here"));
    let png = drawn(both, "p.png", &[]);
    assert_eq!(png[..4], *b"\x89PNG");
}

#[test]
fn an_impossible_picture_is_refused() {
    let place = Workplace::with_small(&random(30));
    run(&place, &["--out", "out"]);
    let speed = ["--by", "surface_speed_rpm"];
    let picture = ["--picture", "p.svg"];
    for (arguments, meant) in [
        (vec!["--picture", "p.svg"], "--by"),
        (
            [&speed[..], &["--picture", "p.pdf"]].concat(),
            ".svg or .png",
        ),
        ([&speed[..], &speed, &picture].concat(), "several"),
        ([&speed[..], &["--regime", "smooth"]].concat(), "--picture"),
        (
            [&speed[..], &picture, &["--regime", "stick"]].concat(),
            "stick_slip",
        ),
        (
            [&speed[..], &picture, &["--regime", "no_contact"]].concat(),
            "no case has a lateral label",
        ),
    ] {
        let answer = place.sweep(&[&["analyse", "out"], &arguments[..]].concat());
        assert_eq!(answer.code, 2, "{arguments:?}: {}", answer.errors);
        assert!(
            answer.errors.contains(meant),
            "{arguments:?}: {}",
            answer.errors
        );
        assert!(!place.path("p.svg").exists() && answer.output.is_empty());
    }
}

/// The number of further cases that it gives brings the interval to the width asked for.
#[test]
fn as_many_more_cases_as_it_says_are_enough() {
    let place = Workplace::with_small(&random(100));
    run(&place, &["--out", "out"]);
    let said = done(&place, &["analyse", "out", "--width", "0.12"]);
    let row = said
        .lines()
        .find(|line| line.contains("stick_slip"))
        .unwrap();
    let more: usize = row.split_whitespace().last().unwrap().parse().unwrap();
    assert!((50..400).contains(&more), "{row}");
    place.write("small.toml", random(100 + more));
    run(&place, &["--out", "out"]);
    done(&place, &["analyse", "out", "--out", "a.csv"]);
    let table = csv(&place, "a.csv");
    let row = table
        .iter()
        .find(|row| row[2] == "stick_slip" && row[3].is_empty())
        .unwrap();
    let [low, high] = [12, 13].map(|column: usize| row[column].parse::<f64>().unwrap());
    // The part itself moves a little.
    assert!(high - low < 0.125, "{low} {high}");
}

/// Of a speed drawn from standstill to beyond the limit, and a weight from hardly a range, the speed
/// decides.
#[test]
fn what_decides_comes_first() {
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 400\n[design.axes]\n\
                  surface_speed_rpm = { from = 0.02, to = 0.6 }\n\
                  weight_on_bit_kn = { from = 50, to = 50.1 }\n";
    let place = Workplace::with_small(&small_with_design(design));
    run(&place, &["--out", "out"]);
    let said = done(&place, &["analyse", "out"]);
    let rows: Vec<Vec<&str>> = (said.split("What decides").nth(1).unwrap().lines())
        .filter(|line| line.contains("torsional"))
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(
        [rows[0][2], rows[1][2]],
        ["surface_speed_rpm", "weight_on_bit_kn"]
    );
    let index = |row: &[&str]| row[3].parse::<f64>().unwrap();
    assert!(index(&rows[0]) > 0.6 && index(&rows[1]) < 0.05, "{rows:?}");
}
