//! What `sweep check` says to programs: annotations and JUnit XML.

use crate::command_line::check::with_reference;
use crate::command_line::text;
use crate::support::{Workplace, with};

/// The small sweep with a reference, under a name that has to be escaped, in which case 3 has
/// another label; and the line it is on.
fn with_a_difference(name: &str) -> (Workplace, usize) {
    let place = with_reference();
    let reference = format!("# A comment.\n{}", text(&place, "reference.csv"));
    let (before, row) = (reference.lines().enumerate())
        .find(|(_, row)| row.starts_with("3,"))
        .unwrap();
    let other = match row.contains(",smooth,") {
        true => row.replace(",smooth,", ",stick_slip,"),
        false => row.replace(",stick_slip,", ",smooth,"),
    };
    place.write(name, with(&reference, row, &other));
    (place, before + 1)
}

/// What GitHub makes of an escaped text.
fn as_github_reads(text: &str) -> String {
    [
        ("%2C", ","),
        ("%3A", ":"),
        ("%0A", "\n"),
        ("%0D", "\r"),
        ("%25", "%"),
    ]
    .into_iter()
    .fold(text.to_owned(), |text, (code, letter)| {
        text.replace(code, letter)
    })
}

#[test]
fn an_annotation_is_at_the_line_of_the_label_that_differs() {
    let name = "100%, of: all.csv";
    let (place, line) = with_a_difference(name);
    let answer = place.sweep(&["check", "small.toml", name, "--format", "github"]);
    assert_eq!(answer.code, 5, "{answer:?}");
    let lines: Vec<&str> = answer.output.lines().collect();
    assert_eq!(lines.len(), 2, "{answer:?}");
    let command = lines[0].strip_prefix("::error ").unwrap();
    let (properties, message) = command.split_once("::").unwrap();
    let properties: Vec<(&str, String)> = (properties.split(','))
        .map(|property| property.split_once('=').unwrap())
        .map(|(key, value)| (key, as_github_reads(value)))
        .collect();
    assert_eq!(properties[0], ("file", name.to_owned()));
    assert_eq!(properties[1], ("line", line.to_string()));
    assert_eq!(properties[2].0, "title");
    let message = as_github_reads(message);
    assert!(message.starts_with("case 3 by quadrature: "), "{message}");
    assert!(message.contains(": expected "), "{message}");
    assert_eq!(lines[1], format!("{name}: 5 of 6 labels as expected"));
}

/// GitHub follows a command on any line of the output, a terminal what follows an escape.
#[test]
#[cfg(unix)]
fn the_name_of_a_reference_is_no_command() {
    let name = "a\n::error::\u{1b}[31m.csv";
    let (place, _) = with_a_difference(name);
    for reference in [name, "none\n ::error::\u{1b}[31m.csv"] {
        for format in ["human", "github", "junit", "json"] {
            let check = ["check", "small.toml", reference, "--format", format];
            for more in [&[][..], &["--output", "out.txt"]] {
                let answer = place.sweep(&[&check[..], more].concat());
                for text in [&answer.output, &answer.errors] {
                    let mut lines = text.lines().map(str::trim_start);
                    let is_at_file = |line: &str| line.starts_with("::error file=");
                    assert!(
                        lines.all(|line| !line.starts_with("::") || is_at_file(line)),
                        "{text}"
                    );
                    assert!(!text.contains('\u{1b}'), "{text}");
                }
            }
            assert!(!text(&place, "out.txt").contains('\u{1b}'));
            std::fs::remove_file(place.path("out.txt")).unwrap();
        }
    }
}

#[test]
fn no_annotation_where_nothing_differs() {
    let place = with_reference();
    let answer = place.sweep(&["check", "small.toml", "reference.csv", "--format", "github"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert_eq!(answer.output, "reference.csv: 6 of 6 labels as expected\n");
}

#[test]
fn junit_has_a_test_for_each_label_and_a_failure_for_each_that_differs() {
    let name = "<a> & \"b\".csv";
    let (place, line) = with_a_difference(name);
    let check = ["check", "small.toml", name, "--format", "junit"];
    let answer = place.sweep(&check);
    assert_eq!((answer.code, answer.errors.as_str()), (5, ""), "{answer:?}");
    let document = roxmltree::Document::parse(&answer.output).unwrap();
    let suites = document.root_element();
    assert!(suites.has_tag_name("testsuites"));
    let suite = suites.first_element_child().unwrap();
    assert!(suite.has_tag_name("testsuite"));
    assert_eq!(suite.attribute("name"), Some(name));
    for counts in [suites, suite] {
        let counts = ["tests", "failures", "errors"].map(|key| counts.attribute(key).unwrap());
        assert_eq!(counts, ["6", "1", "0"]);
    }
    let tests: Vec<_> = suite
        .children()
        .filter(roxmltree::Node::is_element)
        .collect();
    assert_eq!(tests.len(), 6);
    let failures: Vec<_> = (tests.iter())
        .filter_map(|test| Some((test, test.first_element_child()?)))
        .collect();
    let [(test, failure)] = &failures[..] else {
        panic!("{failures:?}");
    };
    assert!(failure.has_tag_name("failure"));
    let case = test.attribute("name").unwrap();
    assert!(
        case.starts_with("case 3 by quadrature, torsion: "),
        "{case}"
    );
    assert_eq!(test.attribute("file"), Some(name));
    assert_eq!(test.attribute("line"), Some(&*line.to_string()));
    let message = failure.attribute("message").unwrap();
    assert!(message.starts_with("expected "), "{message}");
    assert!(failure.text().unwrap().ends_with(message));

    let to_file = place.sweep(&[&check[..], &["--output", "check.xml"]].concat());
    assert_eq!(to_file.code, 5);
    assert_eq!(text(&place, "check.xml"), answer.output);
    let human = place.sweep(&check[..3]);
    assert_eq!(to_file.output, human.output);
    assert!(
        human.output.starts_with("case 3 by quadrature: "),
        "{human:?}"
    );
}
