use super::*;
use crate::picture::tests::assert_text_inside;
use crate::scale::Scale;
use crate::{Fraction, LineStyle, Look};

fn group(panels: Vec<MapPanel>) -> MapGroup {
    let texts = ["all", "none", "some"].map(String::from);
    MapGroup {
        heading: String::new(),
        scale: None,
        keys: [Symbol::Circle, Symbol::Cross, Symbol::Square]
            .map(CellFill::Symbol)
            .into_iter()
            .zip(texts)
            .collect(),
        notes: Vec::new(),
        panels,
        ..MapGroup::default()
    }
}

fn chart(groups: Vec<MapGroup>, logarithmic: bool) -> MapChart {
    let axis = |label: &str| Axis {
        label: label.to_string(),
        logarithmic,
    };
    MapChart {
        title: "Stick-slip regimes".to_string(),
        axes: ["Weight on bit W (kN)", "Surface speed Ωₛ (rpm)"].map(axis),
        marks: Vec::new(),
        groups,
    }
}

fn panel(places: &[(f64, f64)]) -> MapPanel {
    MapPanel {
        points: (places.iter())
            .map(|&at| MapPoint {
                at,
                symbol: Symbol::Circle,
            })
            .collect(),
        ..MapPanel::default()
    }
}

fn map(places: &[(f64, f64)], logarithmic: bool) -> MapChart {
    chart(vec![group(vec![panel(places)])], logarithmic)
}

fn only_panel(chart: &mut MapChart) -> &mut MapPanel {
    &mut chart.groups[0].panels[0]
}

fn scale(chart: &MapChart) -> Scale {
    panel::scales(chart, [None; 2])[0]
}

/// Circles in the map without the one in the legend.
fn circles(map: &MapChart) -> usize {
    let picture = map_chart(&Look::default(), map);
    picture.svg().matches("<circle").count() - 1
}

#[test]
fn every_point_gets_a_symbol_unless_it_cannot_be_shown() {
    let places = [
        (1.0, 2.0),
        (3.0, 4.0),
        (0.0, 1.0),
        (5.0, -1.0),
        (f64::NAN, 1.0),
    ];
    assert_eq!(circles(&map(&places, false)), 4);
    assert_eq!(circles(&map(&places, true)), 2);
}

#[test]
fn maps_without_range_are_drawn() {
    for places in [
        &[][..],
        &[(1.0, 1.0)],
        &[(2.0, 1.0), (2.0, 5.0)],
        &[(f64::INFINITY, 1.0)],
    ] {
        for logarithmic in [false, true] {
            let picture = map_chart(&Look::default(), &map(places, logarithmic));
            assert_text_inside(&picture);
        }
    }
}

#[test]
fn lines_do_not_widen_the_axes() {
    let mut map = map(&[(0.0, 0.0), (1.0, 1.0)], false);
    let before = scale(&map).fraction(1.0);
    only_panel(&mut map).lines.push(Series {
        name: "far".to_string(),
        style: LineStyle::default(),
        points: vec![(-1e6, 0.5), (1e6, 0.5)],
    });
    assert_eq!(scale(&map).fraction(1.0), before);
}

#[test]
fn cells_fill_the_map_and_its_legend() {
    let mut map = map(&[], false);
    only_panel(&mut map).cells = [Symbol::Circle, Symbol::Square]
        .into_iter()
        .enumerate()
        .map(|(index, symbol)| MapCell {
            ends: [[index as f64, index as f64 + 1.0], [0.0, 1.0]],
            fill: CellFill::Symbol(symbol),
        })
        .collect();
    let picture = map_chart(&Look::default(), &map);
    // Both cells, and a key for each of the three symbols.
    assert_eq!(picture.svg().matches("<polygon").count(), 5);
    assert_text_inside(&picture);
}

/// A chart with a text of every kind as long as it may be.
fn crowded(panels: usize, groups: usize) -> MapChart {
    let long = "a rather long text that would not fit on a single line ".repeat(4);
    let panel = || {
        let mut panel = panel(&[(1e-7, 1e7), (5e-7, 1e9)]);
        panel.title.clone_from(&long);
        panel.lines.extend((0..30).map(|index| Series {
            name: format!("{index} {long}"),
            style: LineStyle::default(),
            points: Vec::new(),
        }));
        panel.bands.push(Band {
            name: long.clone(),
            ends: [[1e-7, 5e-7], [1e7, 2e7]],
        });
        panel
    };
    let group = || MapGroup {
        heading: long.clone(),
        scale: Some(long.clone()),
        keys: vec![
            (CellFill::Fraction(Fraction::of(1.0)), long.clone()),
            (CellFill::Symbol(Symbol::Circle), long.clone()),
        ],
        notes: vec![long.clone(); 2],
        ..group((0..panels).map(|_| panel()).collect())
    };
    let mut chart = chart((0..groups).map(|_| group()).collect(), true);
    chart.title.clone_from(&long);
    for axis in &mut chart.axes {
        axis.label.clone_from(&long);
    }
    chart.marks.push(Mark {
        name: long,
        at: (5e-7, 1e9),
    });
    chart
}

#[test]
fn long_texts_and_many_lines_stay_inside_however_many_maps_there_are() {
    for (panels, groups) in [(1, 1), (1, 2), (4, 1), (6, 2)] {
        assert_text_inside(&map_chart(&Look::default(), &crowded(panels, groups)));
    }
}

#[test]
fn maps_of_a_chart_share_their_axes() {
    let wide = [(0.0, 0.0), (10.0, 10.0)];
    let narrow = [(4.0, 4.0), (6.0, 6.0)];
    let both = chart(vec![group(vec![panel(&wide), panel(&narrow)])], false);
    let alone = map(&wide, false);
    assert_eq!(scale(&both).fraction(5.0), scale(&alone).fraction(5.0));
    // All points, and one key.
    assert_eq!(circles(&both), 4);
}

#[test]
fn lines_of_a_name_look_alike_in_every_map_and_have_one_key() {
    let line = |name: &str| Series {
        name: name.to_string(),
        style: LineStyle::default(),
        points: vec![(0.0, 0.5), (1.0, 0.5)],
    };
    let with = |lines: &[&str]| MapPanel {
        lines: lines.iter().map(|name| line(name)).collect(),
        ..panel(&[(0.0, 0.0), (1.0, 1.0)])
    };
    let panels = vec![with(&["one", "other"]), with(&["other"])];
    let picture = map_chart(&Look::default(), &chart(vec![group(panels)], false));
    assert_eq!(picture.svg().matches(">other<").count(), 1);
    // The dashed line in both maps and its key.
    assert_eq!(picture.svg().matches("dasharray").count(), 3);
}

#[test]
fn a_range_is_cut_off_at_the_edge_of_the_map() {
    let mut map = map(&[(0.0, 0.0), (1.0, 1.0)], false);
    let hatched = |y: [f64; 2]| Band {
        name: "range".to_string(),
        ends: [[0.0, 1.0], y],
    };
    only_panel(&mut map).bands.push(hatched([0.2, 0.4]));
    let strokes = |map: &MapChart| {
        let picture = map_chart(&Look::default(), map);
        picture.svg().matches("<polyline").count()
    };
    let inside = strokes(&map);
    only_panel(&mut map).bands[0] = hatched([5.0, 9.0]);
    assert!(strokes(&map) < inside - 40);
    only_panel(&mut map).bands[0] = hatched([-1e9, 1e9]);
    assert!(strokes(&map) < 1000);
}
