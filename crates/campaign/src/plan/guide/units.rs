//! The tables of axes and of field units on the page.

use std::collections::{BTreeMap, BTreeSet};

use super::page::Types;
use super::{CHAPTERS, PAGE};
use crate::quantities::{Axis, TWINS, Units, shown_as};
use crate::sweep_file::units::key_in_si;

/// The rows of the table of axes, by their first cell.
fn axes() -> BTreeMap<&'static str, Vec<&'static str>> {
    let chapter = PAGE.split("\n## Axes\n").nth(1).unwrap();
    let chapter = chapter.split("\n## ").next().unwrap();
    let cells = |line: &'static str| line.split('|').map(str::trim).collect::<Vec<_>>();
    let lines = chapter.lines().filter(|line| line.starts_with("| `"));
    let rows = lines.map(cells);
    rows.map(|cells| (cells[1].trim_matches('`'), cells))
        .collect()
}

#[test]
fn the_guide_lists_every_axis_with_its_range() {
    let rows = axes();
    assert_eq!(
        rows.keys().copied().collect::<BTreeSet<_>>(),
        Axis::NAMES.into()
    );
    for (name, cells) in rows {
        let axis = Axis::from_name(name).unwrap();
        let range = format!("{} to {}", axis.least(), axis.most());
        let unit = axis.unit(Units::Si).name;
        assert_eq!([cells[3], cells[2]], [range, unit], "{name}");
    }
}

/// The table of field units has every ending that is known, with its unit and factor.
#[test]
fn field_units_are_those_of_the_program() {
    let chapter = PAGE.split("\n## Field units\n").nth(1).unwrap();
    let chapter = chapter.split("\n## ").next().unwrap();
    let cells = |line: &'static str| line.split('|').map(|cell| cell.trim().trim_matches('`'));
    let mut listed: Vec<([&str; 3], f64)> = (chapter.lines())
        .filter(|line| line.starts_with("| `"))
        .map(|line| cells(line).collect::<Vec<_>>())
        .map(|cells| ([cells[1], cells[2], cells[5]], cells[3].parse().unwrap()))
        .collect();
    for twin in &TWINS {
        let row = [twin.twin, twin.units[1].trim_matches('`'), twin.si];
        let place = listed.iter().position(|&(cells, factor)| {
            let off = factor / twin.factors[0] - 1.0;
            cells == row && off.abs() < 1e-8
        });
        listed.remove(place.unwrap_or_else(|| panic!("{} of {}", twin.twin, twin.si)));
    }
    assert!(listed.is_empty(), "{listed:?}");
}

/// No key with such a unit is left out.
#[test]
fn every_key_with_a_unit_has_its_twins() {
    let types = Types::new();
    let names = CHAPTERS
        .iter()
        .flat_map(|chapter| types.keys(chapter).into_keys());
    let mut twins = 0;
    for name in names.chain(Axis::NAMES.map(str::to_owned)) {
        for twin in &TWINS {
            let Some(stem) = name.strip_suffix(twin.si) else {
                continue;
            };
            // A part of its unit is not a unit.
            if shown_as(&name).unwrap().units[0] != twin.units[0] {
                continue;
            }
            let (found, factors) = key_in_si(&format!("{stem}{}", twin.twin))
                .unwrap_or_else(|| panic!("{name} has no {}", twin.twin));
            assert_eq!((found, factors), (name.clone(), twin.factors));
            twins += 1;
        }
    }
    assert!(twins > 40, "{twins}");
}
