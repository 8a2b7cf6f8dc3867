//! Sensitivity designs: blocks of cases, raised, in shards and with a string for each case, and
//! what `analyse` says of them.

use crate::support::{Answer, Workplace, small_with_design, with};

/// A number of blocks over the speed, from standstill to beyond the limit, and hardly any weight.
fn two_axes(blocks: usize) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"sensitivity\"\nseed = 4\ncases = {blocks}\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.02, to = 0.6 }}\n\
         weight_on_bit_kn = {{ from = 30, to = 70 }}\n"
    ))
}

/// The same at points of Sobol's sequence, and over an axis of the string, where a pipe with some
/// of its values is invalid.
fn with_tubes(blocks: usize) -> String {
    let text = with(
        &two_axes(blocks),
        "[design.axes]\n",
        "[design.axes]\nsection_0_part_0_inner_radius_m = { from = 0.04, to = 0.15 }\n",
    );
    with(&text, "seed = 4", "seed = 4\npoints = \"sobol\"")
}

fn run(place: &Workplace, text: String, folder: &str, more: &[&str]) -> Answer {
    place.write("small.toml", text);
    let answer = place.sweep(&[&["run", "small.toml", "--quiet", "--out", folder], more].concat());
    assert!([0, 3].contains(&answer.code), "{answer:?}");
    answer
}

fn read(place: &Workplace, name: &str) -> String {
    std::fs::read_to_string(place.path(name)).unwrap()
}

fn analysed(place: &Workplace, folders: &[&str]) -> String {
    let answer = place.sweep(&[&["analyse"], folders].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    answer.output
}

/// The rows of a run: which case, its values along two axes from the third column on, whether it
/// sticks and slips, and whether it has an answer.
fn rows(labels: &str) -> Vec<(usize, [f64; 2], bool, bool)> {
    let mut lines = labels
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let torsion = header.iter().position(|name| *name == "torsion").unwrap();
    lines
        .map(|cells| {
            let values = [2, 3].map(|column: usize| cells[column].parse().unwrap());
            let label = cells[torsion];
            let case = cells[0].parse().unwrap();
            (case, values, label == "stick_slip", !label.is_empty())
        })
        .collect()
}

/// The numbers of a row of the table below a caption.
fn numbers(said: &str, caption: &str, axis: &str) -> Vec<f64> {
    let table = said
        .split(caption)
        .nth(1)
        .unwrap_or_else(|| panic!("{said}"));
    let row = table
        .lines()
        .find(|line| line.trim_start().starts_with(axis));
    let cells = row.unwrap().split_whitespace().skip(1);
    cells.map(|cell| cell.parse().unwrap()).collect()
}

/// The indices that are said are those of the definitions, summed here from the labels; only
/// independent cases are counted.
#[test]
fn indices_are_those_of_the_labels() {
    let place = Workplace::new();
    let blocks = 150;
    run(&place, two_axes(blocks), "out", &[]);
    let rows = rows(&read(&place, "out/labels.csv"));
    assert_eq!(rows.len(), 4 * blocks);
    let said = analysed(&place, &["out"]);
    let caption = "stick_slip by quadrature:";
    assert!(
        said.contains("150 whole blocks of cases by quadrature."),
        "{said}"
    );
    let value = |block: usize, place: usize| f64::from(u8::from(rows[4 * block + place].2));
    let sum = |of: &dyn Fn(usize) -> f64| (0..blocks).map(of).sum::<f64>();
    let count = blocks as f64;
    let mean = sum(&|block| value(block, 0) + value(block, 1)) / (2.0 * count);
    let variance = mean * (1.0 - mean);
    for (axis, name) in ["surface_speed_rpm", "weight_on_bit_kn"].iter().enumerate() {
        let change = |block: usize| value(block, 2 + axis) - value(block, 0);
        let first = sum(&|block| (value(block, 1) - mean) * change(block)) / count / variance;
        let total = sum(&|block| change(block).powi(2)) / (2.0 * count) / variance;
        let found = numbers(&said, caption, name);
        for (found, expected) in [(&found[..3], first), (&found[3..], total)] {
            assert!(
                (found[0] - expected.clamp(0.0, 1.0)).abs() < 6e-4,
                "{found:?} {expected}"
            );
            assert!(found[1] <= found[0] && found[0] <= found[2] && found[1] < found[2]);
        }
    }
    // So does the file, to the last digit of what is said, but for every regime.
    let arguments = ["analyse", "out", "--indices", "indices.csv"];
    assert_eq!(place.sweep(&arguments).code, 0);
    let table = read(&place, "indices.csv");
    for line in table.lines().filter(|line| line.contains(",stick_slip,")) {
        let cells: Vec<&str> = line.split(',').collect();
        let written = cells[4..].iter().map(|cell| cell.parse::<f64>().unwrap());
        let said = numbers(&said, caption, cells[2]);
        assert!(
            written
                .zip(&said)
                .all(|(one, other)| (one - other).abs() < 6e-4)
        );
    }
    assert!(table.contains(",smooth,weight_on_bit_kn,150,"), "{table}");
    // The complement of a regime has the same indices.
    assert!(!said.contains("smooth by quadrature:"), "{said}");
    // What decides comes first, and does so in severity, too.
    for caption in [caption, "stick_slip_severity by quadrature:"] {
        let total = |axis: &str| numbers(&said, caption, axis)[3];
        assert!(total("surface_speed_rpm") > 0.5, "{said}");
        assert!(
            total("surface_speed_rpm") > total("weight_on_bit_kn"),
            "{said}"
        );
    }
    let counted = rows
        .iter()
        .filter(|(case, _, sticks, _)| case % 4 < 2 && *sticks)
        .count();
    let row = said
        .lines()
        .find(|line| line.contains("stick_slip"))
        .unwrap();
    assert_eq!(
        row.split_whitespace().nth(2),
        Some(&counted.to_string()[..]),
        "{said}"
    );
    assert!(
        said.contains("300 simulations; every one has an answer"),
        "{said}"
    );
}

/// Runs that are raised, stopped or dealt to machines have the bytes of one; strings are built
/// once for the cases of a block that share them.
#[test]
fn blocks_are_raised_and_dealt_as_random_cases_are() {
    for text in [two_axes, with_tubes] {
        let place = Workplace::new();
        run(&place, text(24), "fresh", &[]);
        run(&place, text(3), "raised", &[]);
        run(&place, text(24), "raised", &["--jobs", "1"]);
        let fresh = read(&place, "fresh/labels.csv");
        assert_eq!(fresh, read(&place, "raised/labels.csv"));
        let mut merge = vec!["merge".to_owned(), "--out".to_owned(), "merged".to_owned()];
        for shard in 0..4 {
            let (folder, part) = (format!("part{shard}"), format!("{shard}/4"));
            for blocks in [1, 24] {
                run(&place, text(blocks), &folder, &["--shard", &part]);
            }
            merge.push(folder);
        }
        let merge: Vec<&str> = merge.iter().map(String::as_str).collect();
        assert!([0, 3].contains(&place.sweep(&merge).code));
        assert_eq!(fresh, read(&place, "merged/labels.csv"));
        // Of other cases the blocks are not known, and parts are as good as the whole.
        assert_eq!(
            analysed(&place, &["part2", "part0", "part3", "part1"]),
            analysed(&place, &["fresh"])
        );
        place.write("small.toml", text(5));
        let answer = place.sweep(&["run", "small.toml", "--out", "raised"]);
        assert_eq!(answer.code, 2);
        assert!(
            answer
                .errors
                .contains("24 blocks of cases of this sweep, and 5 are fewer")
        );
    }
    let place = Workplace::with_small(&with_tubes(24));
    let dry = place.sweep(&["run", "small.toml", "--dry-run"]);
    // Of the five cases of a block two have the tube of B, and three that of A.
    assert!(dry.output.contains("would run 120 cases"), "{dry:?}");
    assert!(
        dry.output.contains("48 distinct strings, each built once"),
        "{dry:?}"
    );
}

/// A block with a case that has no answer is left out and counted, as is one that is not there
/// whole.
#[test]
fn broken_blocks_are_left_out_and_reported() {
    let place = Workplace::new();
    run(&place, with_tubes(64), "out", &[]);
    let rows = rows(&read(&place, "out/labels.csv"));
    let broken = rows
        .chunks(5)
        .filter(|block| block.iter().any(|row| !row.3));
    let broken = broken.count();
    assert!((10..60).contains(&broken), "{broken}");
    let said = analysed(&place, &["out"]);
    let meant = format!(
        "{} whole blocks of cases by quadrature; {broken} left out",
        64 - broken
    );
    assert!(said.contains(&meant), "{said}");
    // A part of a run has parts of its blocks.
    run(&place, two_axes(40), "part", &["--shard", "0/2"]);
    let said = analysed(&place, &["part"]);
    assert!(
        said.contains("0 whole blocks of cases by quadrature; 40 not finished"),
        "{said}"
    );
    assert!(said.contains("fewer than 20 blocks"), "{said}");
}

/// Intervals that hold for independent cases are said to be too wide for Sobol points, and only
/// for these.
#[test]
fn intervals_of_sobol_points_are_explained() {
    let place = Workplace::new();
    let random = with(&two_axes(40), "sensitivity", "monte-carlo");
    let sobol = with(&random, "seed = 4", "seed = 4\npoints = \"sobol\"");
    for (text, is_reported) in [(random, false), (sobol, true)] {
        run(&place, text, "out", &["--fresh"]);
        let said = analysed(&place, &["out"]);
        assert_eq!(
            said.contains("usually wider than need be"),
            is_reported,
            "{said}"
        );
        let answer = place.sweep(&["analyse", "out", "--indices", "indices.csv"]);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains("need cases in blocks"), "{answer:?}");
    }
}
