//! Sweeps of many cases: their maps stay small files.

use std::fmt::Write;

use crate::report::{succeeds, text, with_results, write_table};
use crate::support::{Workplace, with};

/// The largest picture that is still easy to mail and to show.
const MEGABYTE: u64 = 1_000_000;

/// Replaces the labels of `results` by those of made-up cases; the speed goes
/// upwards on its map.
fn with_cases(cases: impl Iterator<Item = ([f64; 2], [&'static str; 2])>) -> Workplace {
    let place = with_results();
    let columns = "case,method,surface_speed_rpm,weight_on_bit_kn,torsion,lateral\n";
    let mut labels = columns.to_owned();
    for (case, ([speed, weight], regimes)) in cases.enumerate() {
        for (method, regime) in ["quadrature", "finite-element"].iter().zip(regimes) {
            writeln!(labels, "{case},{method},{speed},{weight},{regime},").unwrap();
        }
    }
    write_table(&place, "results", "labels.csv", labels);
    place
}

/// Points that fill the map evenly and are never in line.
fn scattered(count: usize) -> impl Iterator<Item = [f64; 2]> {
    let part = |index: usize, ratio: f64| (index as f64 * ratio).fract();
    (0..count).map(move |index| {
        let (x, y) = (part(index, 0.754_877_666), part(index, 0.569_840_290));
        [0.02 + 0.58 * x, 30.0 + 40.0 * y]
    })
}

/// Draws the map; the size of its file.
fn drawn(place: &Workplace) -> u64 {
    succeeds(place, &["plot", "results"]);
    std::fs::metadata(place.path("results/map.svg"))
        .unwrap()
        .len()
}

const SMOOTH: &str = "smooth";
const STICK_SLIP: &str = "stick_slip";

#[test]
fn a_map_of_many_symbols_stays_below_a_megabyte() {
    // Squares are the longest to write.
    let place = with_cases(scattered(4000).map(|place| (place, [SMOOTH, STICK_SLIP])));
    let size = drawn(&place);
    assert!(size < MEGABYTE, "{size}");
    assert!(text(&place, "results/map.svg").matches("<polyline").count() > 4000);
}

#[test]
fn a_map_whose_cells_are_all_unlike_stays_below_a_megabyte() {
    let cases = (0..104).flat_map(|column| {
        (0..78).map(move |row| {
            let regime = if (column + row) % 2 == 0 {
                SMOOTH
            } else {
                STICK_SLIP
            };
            ([f64::from(row), f64::from(column)], [regime, regime])
        })
    });
    let place = with_cases(cases);
    let size = drawn(&place);
    assert!(size < MEGABYTE, "{size}");
    assert!(text(&place, "results/map.svg").matches("<polygon").count() > 104 * 78);
}

#[test]
fn a_map_of_many_cases_is_made_of_few_cells() {
    let regime = |place: [f64; 2]| if place[1] < 50.3 { STICK_SLIP } else { SMOOTH };
    let place = with_cases(scattered(50_000).map(|place| (place, [regime(place); 2])));
    let size = drawn(&place);
    assert!(size < MEGABYTE / 5, "{size}");
    // No cell is left empty: two runs in each of 78 rows; keys and a mark.
    let polygons = text(&place, "results/map.svg").matches("<polygon").count();
    assert!((156..=170).contains(&polygons), "{polygons}");
}

/// 60 000 simulations: the map is there, and the page says that it does not answer.
#[test]
fn a_page_of_too_many_cases_holds_none_and_says_so() {
    let place = with_cases(scattered(30_000).map(|place| (place, [SMOOTH; 2])));
    let manifest = text(&place, "results/manifest.json");
    let manifest = with(&manifest, "\"rows\": 12", "\"rows\": 60000");
    place.write("results/manifest.json", manifest);
    let page = crate::report::report(&place, &["results"]);
    let said = "60000 simulations are more than this page has room for";
    assert!(page.contains(said));
    assert!(page.contains("class=\"area\"") && !page.contains("<script"));
    assert!((page.len() as u64) < MEGABYTE);
}

#[test]
fn a_page_of_many_cases_stays_below_three_megabytes() {
    let place = with_cases(scattered(10_000).map(|place| (place, [SMOOTH, STICK_SLIP])));
    let manifest = text(&place, "results/manifest.json");
    let manifest = with(&manifest, "\"rows\": 12", "\"rows\": 20000");
    place.write("results/manifest.json", manifest);
    let page = crate::report::report(&place, &["results"]);
    assert!(page.contains("id=\"cases-0\""));
    assert!((page.len() as u64) < 3 * MEGABYTE, "{}", page.len());
}
