//! A sweep file to start from, and what a shell and `man` ask for.

use crate::command_line::{RESULTS, labels, manifest, names, names_in, run, succeeds, text};
use crate::refusals::refused;
use crate::support::{Workplace, with};

/// Every block of settings that is switched off, by its first line, and the pieces that it replaces
/// or needs.
const SWITCHED_OFF: [(&str, Change); 14] = [
    ("units = \"field\"", Change::Nothing),
    ("surface_torque = true", Change::Nothing),
    (
        "methods = [\"held\", \"finite-element\"]",
        Change::Instead("\nmethods = [\"held\"]"),
    ),
    ("start = \"both\"", Change::Instead("\nstart = \"stuck\"")),
    ("surface_speed_rpm = 60", Change::Nothing),
    ("time_s = 60", Change::Nothing),
    ("torsional_damping_nms_rad_m = 0.1", Change::Nothing),
    ("damping_ns_m2 = 500", Change::Nothing),
    (
        "rock = \"table\"",
        Change::Instead("\nrock = \"sandstone\""),
    ),
    ("rock = \"law\"", Change::Instead("\nrock = \"sandstone\"")),
    ("[wall]", Change::Nothing),
    ("[[impulses]]", Change::Needs("[wall]")),
    ("[[eccentric_masses]]", Change::Needs("[wall]")),
    ("[[tools]]", Change::Needs("[wall]")),
];

enum Change {
    Nothing,
    Instead(&'static str),
    Needs(&'static str),
}

/// The file as it is written.
fn new_file() -> String {
    let place = Workplace::new();
    let answer = succeeds(&place, &["new"]);
    assert!(
        answer.output.contains("sweep run my-sweep.toml"),
        "{answer:?}"
    );
    text(&place, "my-sweep.toml")
}

/// A # alone parts the tables of a block.
fn is_switched_off(line: &str) -> bool {
    let is_words = line.starts_with("# ") || line.starts_with("#:") || line == "#";
    line.starts_with('#') && !is_words
}

/// The file with the # taken from the block that begins with `first`.
#[track_caller]
fn switch_on(file: &str, first: &str) -> String {
    let start = file.find(&format!("\n#{first}\n")).expect(first) + 1;
    let end = start
        + file[start..]
            .find("\n\n")
            .map_or(file.len() - start, |end| end);
    let block = file[start..end].lines().map(|line| match line {
        line if is_switched_off(line) => &line[1..],
        "#" => "",
        line => line,
    });
    let block: Vec<&str> = block.collect();
    format!("{}{}{}", &file[..start], block.join("\n"), &file[end..])
}

/// Reads a file and says what would run.
#[track_caller]
fn is_valid(file: &str) {
    let place = Workplace::new();
    place.write("sweep.toml", file);
    succeeds(&place, &["run", "sweep.toml", "--dry-run"]);
}

#[test]
fn a_new_file_runs_as_it_is_and_shows_both_regimes() {
    let place = Workplace::new();
    place.write("my-sweep.toml", new_file());
    run(&place, "my-sweep.toml", "results");
    assert_eq!(names_in(&place, "results"), names(RESULTS));
    let labels = labels(&place, "results", ["torsion"]);
    for regime in ["smooth", "stick_slip"] {
        let share = labels.iter().filter(|[label]| label == regime).count();
        assert!(
            share > labels.len() / 10,
            "{share} of {} {regime}",
            labels.len()
        );
    }
}

/// Next to the file and by the name in its first line, of a folder too.
#[test]
fn the_schema_is_where_the_first_line_says() {
    let place = Workplace::new();
    std::fs::create_dir(place.path("wells")).unwrap();
    let answer = succeeds(&place, &["new", "wells/a.toml"]);
    let command = "sweep schema > wells/sweep.schema.json";
    assert!(answer.output.contains(command), "{answer:?}");
    assert!(!place.path("wells/sweep.schema.json").exists());
    let first = text(&place, "wells/a.toml");
    assert_eq!(first.lines().next(), Some("#:schema ./sweep.schema.json"));
    let answer = succeeds(&place, &["new", "wells/b.toml", "--schema"]);
    assert!(answer.output.contains("wells/sweep.schema.json is written"));
    let printed = succeeds(&place, &["schema"]).output;
    assert_eq!(text(&place, "wells/sweep.schema.json"), printed);
    // One of an earlier version is replaced, and nothing else.
    place.write("wells/sweep.schema.json", &printed[..1000]);
    succeeds(&place, &["new", "wells/c.toml", "--schema"]);
    assert_eq!(text(&place, "wells/sweep.schema.json"), printed);
    place.write("wells/sweep.schema.json", "{}");
    let arguments = ["new", "wells/d.toml", "--schema"];
    refused(&place, &arguments, &["sweep.schema.json is there already"]);
}

#[test]
fn every_setting_that_is_switched_off_can_be_used() {
    let file = new_file();
    for (first, change) in SWITCHED_OFF {
        is_valid(&match change {
            Change::Nothing => switch_on(&file, first),
            Change::Instead(piece) => with(&switch_on(&file, first), &format!("{piece}\n"), "\n"),
            Change::Needs(other) => switch_on(&switch_on(&file, other), first),
        });
    }
    let (start, end) = (
        file.find("\n[design]").unwrap(),
        file.find("\n# The map").unwrap(),
    );
    let random = switch_on(&file, "[design]").replace(&file[start..end], "");
    is_valid(&random);
    let blocks = file
        .split("\n\n")
        .filter(|block| block.lines().any(is_switched_off));
    // And the random points.
    assert_eq!(blocks.count(), SWITCHED_OFF.len() + 1);
}

#[test]
fn with_a_wall_and_an_impulse_a_new_file_tells_whirl() {
    let file = switch_on(&switch_on(&new_file(), "[wall]"), "[[impulses]]");
    let file = with(&file, "to = 60, count = 12", "to = 60, count = 2");
    let file = with(&file, "to = 120, count = 12", "to = 120, count = 2");
    // The impulse acts at the start, and whirl has a label of its own within seconds.
    let file = with(
        &switch_on(&file, "time_s = 60"),
        "time_s = 60",
        "time_s = 5",
    );
    let place = Workplace::with_small(&file);
    run(&place, "small.toml", "results");
    let labels = labels(&place, "results", ["lateral"]);
    assert_eq!(labels.len(), 4);
    assert!(
        labels
            .iter()
            .all(|[label]| !label.is_empty() && label != "no_contact"),
        "{labels:?}"
    );
    assert_eq!(manifest(&place, "results")["failed"], 0);
}

/// Mud alone damps whirl so lightly that ten seconds do not show which lasts; the time by rule does.
#[test]
fn the_time_by_rule_shows_which_whirl_lasts() {
    let file = switch_on(&switch_on(&new_file(), "[wall]"), "[[impulses]]");
    let file = with(&file, "\nfriction = 0.5\n", "\n");
    let (setting, _) = file.split_once("[bit]").unwrap();
    let (_, walls) = file.split_once("[wall]").unwrap();
    let (walls, _) = walls.split_once("[design]").unwrap();
    let file = format!(
        "{setting}[wall]{walls}[design]\nkind = \"grid\"\n[design.axes]\n\
         friction = {{ values = [0.3, 0.7, 1.1] }}\nsurface_speed_rpm = {{ values = [80, 160] }}\n"
    );
    let file = with(&file, "\nstart = \"stuck\"\n", "\n");
    let file = with(&file, "methods = [\"held\"]", "methods = [\"quadrature\"]");
    let labels_after = |time: &str| {
        let place = Workplace::with_small(&with(&file, "\n#time_s = 60\n", time));
        run(&place, "small.toml", "results");
        labels(&place, "results", ["lateral"]).concat()
    };
    let by_rule = labels_after("\n");
    assert_eq!(by_rule, labels_after("\ntime_s = 120\n"));
    let in_ten_seconds = labels_after("\ntime_s = 10\n");
    let pairs = by_rule.iter().zip(&in_ten_seconds);
    let differ = pairs.filter(|(one, other)| one != other).count();
    assert!(differ >= 2, "{by_rule:?} {in_ten_seconds:?}");
}

#[test]
fn a_file_that_is_there_is_kept_unless_forced() {
    let place = Workplace::new();
    place.write("mine.toml", "mine");
    refused(&place, &["new", "mine.toml"], &["--force"]);
    assert_eq!(text(&place, "mine.toml"), "mine");
    succeeds(&place, &["new", "mine.toml", "--force"]);
    assert_eq!(text(&place, "mine.toml"), new_file());
}

#[test]
fn the_commands_for_a_new_file_can_be_given_as_they_are() {
    let place = Workplace::new();
    let reported = succeeds(&place, &["new", "my sweep.toml"]).output;
    for command in ["inspect", "run"] {
        let line = format!("\n  sweep {command} 'my sweep.toml'\n");
        assert!(reported.contains(&line), "{reported}");
    }
}

#[test]
fn every_shell_and_man_get_every_command() {
    let place = Workplace::new();
    let help = succeeds(&place, &["--help"]).output;
    let commands = help.split("Commands:\n").nth(1).unwrap().lines();
    let commands: Vec<&str> = commands
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .filter(|&command| command != "help")
        .collect();
    assert!(commands.len() >= 9, "{commands:?}");
    let page = succeeds(&place, &["man"]).output;
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = succeeds(&place, &["completions", shell]).output;
        assert!(
            commands.iter().all(|command| script.contains(command)),
            "{shell}"
        );
    }
    for command in commands {
        assert!(
            page.contains(&format!("sweep\\-{command}")),
            "{command} in {page}"
        );
        let page = succeeds(&place, &["man", command]).output;
        assert!(page.contains(&format!("  sweep {command}")), "{page}");
    }
    refused(&place, &["man", "rum"], &["`rum`"]);
}
