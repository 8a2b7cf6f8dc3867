//! The pictures and tables that `sweep simulate` adds where there is a wall: contact, and the
//! film of the string in its hole.

use crate::command_line::{columns, is_png, names, names_in, succeeds, table, text};
use crate::refusals::refused;
use crate::support::{SMALL, Workplace};

/// A string with a wall at its bit and at 30 m above it, struck at the bit.
fn whirl() -> Workplace {
    let sweep = format!(
        "base = \"{}/../../sweeps/academic.toml\"\nmethods = [\"finite-element\", \"quadrature\"]\n\
         time_s = 2.5\n[wall]\nclearance_mm = 15\nfriction = 2\n[[sites]]\ndistance_from_bit_m = 0\n\
         [[sites]]\ndistance_from_bit_m = 30\n[[impulses]]\ndistance_from_bit_m = 0\nratio = 3\n",
        env!("CARGO_MANIFEST_DIR")
    );
    Workplace::with_small(&sweep)
}

#[test]
fn contacts_are_those_of_the_history() {
    let place = whirl();
    let answer = succeeds(&place, &["simulate", "small.toml", "--out", "case"]);
    let reported = answer.output.replace("\n    ", " ");
    for method in ["finite-element", "quadrature"] {
        assert!(
            reported.contains(&format!("{method}: the string goes ")),
            "{answer:?}"
        );
    }
    let files = [
        "case.csv",
        "contacts.csv",
        "contacts.png",
        "contacts.svg",
        "history.csv",
        "history.png",
        "history.svg",
        "orbit.png",
        "orbit.svg",
        "string.csv",
        "string.png",
        "string.svg",
    ];
    assert_eq!(names_in(&place, "case"), names(files));
    is_png(&place, "case/contacts.png");
    let history = table(&text(&place, "case/history.csv"));
    let forces = [
        "method",
        "time_s",
        "bit_wall_force_x_n",
        "bit_wall_force_y_n",
    ];
    let history = columns(&history, forces);
    let contacts = table(&text(&place, "case/contacts.csv"));
    let wanted = [
        "method",
        "site_from_bit_m",
        "from_s",
        "to_s",
        "largest_normal_force_n",
    ];
    let contacts = columns(&contacts, wanted);
    let number = |text: &String| text.parse::<f64>().unwrap();
    for [method, time, x, y] in &history {
        let time = number(time);
        let own = contacts.iter().find(|[of, site, from, to, _]| {
            of == method && site == "0" && (number(from)..=number(to)).contains(&time)
        });
        let force = number(x).hypot(number(y));
        assert_eq!(own.is_some(), force > 0.0, "{method} at {time} s");
        // With friction the force is at most √(1 + μ²) times the normal one.
        let largest = own.map_or(0.0, |[.., largest]| number(largest));
        assert!(
            force <= 5_f64.sqrt() * largest * (1.0 + 1e-9),
            "{method} at {time} s"
        );
    }
    assert!(contacts.len() > 2, "{contacts:?}");
}

/// By finite elements the string passes through its simulated sites.
#[test]
fn the_table_of_the_string_has_the_peaks_of_the_history_and_the_clearance() {
    let place = whirl();
    succeeds(&place, &["simulate", "small.toml", "--out", "case"]);
    let number = |text: &String| text.parse::<f64>().unwrap();
    let history = table(&text(&place, "case/history.csv"));
    let history = columns(&history, ["method", "bit_x_mm", "bit_y_mm"]);
    let string = table(&text(&place, "case/string.csv"));
    let wanted = ["method", "depth_m", "peak_radius_mm", "clearance_mm"];
    let string = columns(&string, wanted);
    let own = |method: &String| method == "finite-element";
    let radii = history.iter().filter(|row| own(&row[0]));
    let peak = radii
        .map(|[_, x, y]| number(x).hypot(number(y)))
        .fold(0.0, f64::max);
    let nodes: Vec<_> = string.iter().filter(|row| own(&row[0])).collect();
    let [_, _, at_bit, clearance] = nodes.last().unwrap();
    assert!(
        (number(at_bit) / peak - 1.0).abs() < 1e-6,
        "{at_bit} {peak}"
    );
    assert_eq!(number(clearance), 15.0);
    assert!(nodes.is_sorted_by(|one, next| number(&one[1]) < number(&next[1])));
}

#[test]
fn a_film_is_drawn_of_the_first_method_and_is_the_same_again() {
    let place = whirl();
    let film = |out: &str, options: &[&str]| {
        let arguments = ["simulate", "small.toml", "--film", "--out", out];
        let answer = succeeds(&place, &[&arguments[..], options].concat());
        assert!(answer.output.contains("film (of"), "{answer:?}");
        is_png(&place, &format!("{out}/film.png"));
        text(&place, &format!("{out}/film.svg"))
    };
    let frames = |svg: &str| svg.matches(">t = ").count();
    let first = film("one", &[]);
    assert_eq!(frames(&first), 12);
    assert!(first.contains("finite-element") && first.contains("t = 2.50 s"));
    assert_eq!(film("two", &["--jobs", "1"]), first);
    let few = ["--film-frames", "3", "--film-from", "0", "--film-to", "1"];
    let few = film("three", &few);
    assert_eq!(frames(&few), 3);
    assert!(few.contains("t = 0.50 s"));
}

#[test]
fn an_impossible_film_is_refused() {
    let film = ["simulate", "small.toml", "--out", "case", "--film"];
    let with = |options: &[&'static str]| [&film[..], options].concat();
    let bends_not = Workplace::with_small(SMALL);
    refused(
        &bends_not,
        &film,
        &["--film: there is no wall", "nothing bends"],
    );
    let place = whirl();
    for (options, words) in [
        (
            &["--film-from", "2.6"][..],
            &["--film-from 2.6", "0 to 2.5 s"][..],
        ),
        (&["--film-to", "nan"], &["--film-to NaN", "0 to 2.5 s"]),
        (
            &["--film-from=2", "--film-to=1"],
            &["--film-from 2: it is later than --film-to 1"],
        ),
        (
            &["--film-to", "0.5"],
            &["0 steps to show from the first contact", "--film-from"],
        ),
    ] {
        refused(&place, &with(options), words);
    }
    // By the command line itself.
    for (arguments, word) in [
        (with(&["--film-frames", "0"]), "1..=60"),
        (vec!["simulate", "small.toml", "--film-to", "1"], "--film\n"),
    ] {
        let answer = place.sweep(&arguments);
        assert_eq!(answer.code, 2, "{answer:?}");
        assert!(answer.errors.contains(word), "{answer:?}");
    }
    assert_eq!(names_in(&place, "."), names(["small.toml"]));
}
