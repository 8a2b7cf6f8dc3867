//! Pictures for paper, and the tables that hold what pictures show.

use crate::support::{SMALL, Workplace};

fn done(place: &Workplace, arguments: &[&str]) {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.errors);
}

/// Resampled or shrunk, a picture would be of another width in points: 90 mm are 255.118.
#[test]
fn a_picture_for_paper_is_as_wide_as_is_asked_in_every_format() {
    let place = Workplace::new();
    std::fs::write(place.path("small.toml"), SMALL).unwrap();
    let paper = [
        "--width",
        "90mm",
        "--format",
        "svg,png,pdf",
        "--title",
        "none",
    ];
    let simulate = ["simulate", "small.toml", "--out", "out"];
    done(&place, &[&simulate[..], &paper[..]].concat());
    let svg = std::fs::read_to_string(place.path("out/history.svg")).unwrap();
    assert!(svg.starts_with("<svg width=\"90"), "{}", &svg[..80]);
    let pdf = std::fs::read(place.path("out/history.pdf")).unwrap();
    let pdf = String::from_utf8_lossy(&pdf);
    let (_, page) = pdf.split_once("/MediaBox [0 0 ").expect("a page");
    let (width, _) = page.split_once(' ').expect("two numbers");
    assert!(
        (width.parse::<f64>().unwrap() - 255.118).abs() < 0.2,
        "{width}"
    );
    // The width of a PNG is its fifth word: 600 to the inch.
    let png = std::fs::read(place.path("out/history.png")).unwrap();
    let pixels = u32::from_be_bytes(png[16..20].try_into().unwrap());
    assert!(pixels.abs_diff(2126) < 10, "{pixels}");
}

#[test]
fn only_the_formats_that_are_asked_for_are_written() {
    let place = Workplace::new();
    std::fs::write(place.path("small.toml"), SMALL).unwrap();
    done(
        &place,
        &["simulate", "small.toml", "--out", "out", "--format", "pdf"],
    );
    assert!(place.path("out/history.pdf").exists());
    assert!(!place.path("out/history.svg").exists() && !place.path("out/history.png").exists());
}

#[test]
fn what_makes_no_picture_is_refused_before_anything_is_written() {
    let place = Workplace::new();
    std::fs::write(place.path("small.toml"), SMALL).unwrap();
    for (option, message) in [
        (&["--width", "90"][..], "`90` is not a length"),
        (&["--width", "20mm"], "from 53 to"),
        (&["--font-size", "9pt"], "--width"),
        (&["--format", "gif"], "gif"),
        (&["--x-range", "60..0"], "`60..0` is not a range"),
        (&["--y-range", "5"], "`5` is not a range"),
    ] {
        let simulate = ["simulate", "small.toml", "--out", "out"];
        let answer = place.sweep(&[&simulate[..], option].concat());
        assert_eq!(answer.code, 2, "{option:?}: {}", answer.output);
        assert!(
            answer.errors.contains(message),
            "{option:?}: {}",
            answer.errors
        );
        assert!(!place.path("out").exists(), "{option:?}");
    }
}
