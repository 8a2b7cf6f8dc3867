//! The page of the guide that lists every key, held to the program: keys, units,
//! ranges and defaults.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use linear::method::{FiniteElement, Transform};
use serde::de::DeserializeOwned;
use toml::{Table, Value};

use super::Sweep;
use crate::quantities::{Axis, TWINS, shown_as};
use crate::sweep_file::SweepFileError;
use crate::sweep_file::bit::{BitTable, LawTable};
use crate::sweep_file::compare::CompareTable;
use crate::sweep_file::design::{AxisRange, CorrelationTable, DesignTable};
use crate::sweep_file::file::FileContent;
use crate::sweep_file::lateral::*;
use crate::sweep_file::map::{MapTable, MarkTable};
use crate::sweep_file::methods::MethodTables;
use crate::sweep_file::string::{SectionTable, StringTable, TubeTable};
use crate::sweep_file::top_drive::TopDriveTable;
use crate::sweep_file::units::key_in_si;
use crate::sweep_file::well::{
    AxialForceTable, HoleTable, MudTable, StringFrictionTable, WellTable,
};
use crate::sweep_file::wording::keys_of;

const PAGE: &str = include_str!("../../../../docs/sweep-file.md");

/// A sweep file with every table.
const EXAMPLE: &str = r#"
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
bending = { youngs_modulus_gpa = 210, damping_ns_m2 = 2000 }
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }]
[top_drive]
inertia_kg_m2 = 2900
controller = "gains"
proportional_gain_knms_rad = 38
integral_gain_knm_rad = 100
[bit]
rock = "law"
[bit.law]
bit_radius_m = 0.15
specific_energy_mpa = 60
cutting_ratio = 0.6
friction = 0.5
contact_strength_mpa = 60
contact_growth = 5
wear_flat_mm = 5
poor_cleaning_from_kn = 200
poor_cleaning_nm_per_kn = 100
[wall]
clearance_mm = 15
friction = 0.5
[[sites]]
distance_from_bit_m = 0
[axial_force]
[well]
holes = [{ from_m = 0, to_m = 150, hole_radius_m = 0.2 }]
[mud]
density_kg_m3 = 1500
[[impulses]]
distance_from_bit_m = 0
[[eccentric_masses]]
distance_from_bit_m = 0
mass_kg = 1
offset_m = 0.1
[method]
hilbert = {}
finite-element = {}
[design]
kind = "grid"
[design.axes]
surface_speed_rpm = { from = 1, to = 2, count = 3 }
weight_on_bit_kn = { values = [1, 2] }
impulse_ratio = { values = [1, 2] }
[map]
marks = [{ name = "A", surface_speed_rpm = 1, weight_on_bit_kn = 1 }]
"#;

/// One with the tables of a string in its well, which has no wall.
const EXAMPLE_IN_WELL: &str = r#"
surface_speed_file = "recorded.csv"
time_s = 100
methods = ["quadrature"]
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }]
[well]
survey = "survey.csv"
[mud]
density_kg_m3 = 1500
[string_friction]
static_coefficient = 0.4
[[compare]]
trace = "bit_speed_rpm"
file = "recorded.csv"
column = "speed_rpm"
from_s = 1
to_s = 9
of = "greatest"
over_s = 0.5
[design]
kind = "monte-carlo"
cases = 2
[design.axes]
string_friction = { from = 0.1, to = 0.4 }
torsional_damping_nms_rad_m = { from = 1, to = 4 }
[[design.correlations]]
axes = ["string_friction", "torsional_damping_nms_rad_m"]
coefficient = 0.5
"#;

/// What its files have.
const TABLE_IN_WELL: &str = "\
time_s,speed_rpm,measured_depth_m,inclination_deg,azimuth_deg
0,0,0,0,0
50,30,60,10,0
100,60,120,20,0
";

/// The text of a file that an example names.
fn text_of(example: &str, path: &Path) -> String {
    let is_table = path.extension().is_some_and(|ending| ending == "csv");
    (if is_table { TABLE_IN_WELL } else { example }).to_owned()
}

/// Reads an example.
fn read(example: &str) -> Result<Sweep, SweepFileError> {
    Sweep::read_from(Path::new("sweep.toml"), &[], &|path, _| {
        Ok(text_of(example, path))
    })
}

/// A heading of the page, the table of an example it is about, and its keys.
struct Chapter {
    heading: &'static str,
    path: &'static str,
    keys: BTreeSet<String>,
    example: &'static str,
}

fn chapters() -> Vec<Chapter> {
    fn chapter<T: DeserializeOwned>(heading: &'static str, path: &'static str) -> Chapter {
        let keys = keys_of::<T>().into_iter().collect();
        Chapter {
            heading,
            path,
            keys,
            example: EXAMPLE,
        }
    }
    fn in_well<T: DeserializeOwned>(heading: &'static str, path: &'static str) -> Chapter {
        Chapter {
            example: EXAMPLE_IN_WELL,
            ..chapter::<T>(heading, path)
        }
    }
    let mut chapters = vec![
        chapter::<FileContent>("The file itself", ""),
        chapter::<StringTable>("`[string]`", "string"),
        chapter::<BendingTable>("`[string.bending]`", "string.bending"),
        chapter::<SectionTable>("`[[string.sections]]`", "string.sections.0"),
        chapter::<TubeTable>("`parts`", "string.sections.0.parts.0"),
        chapter::<TopDriveTable>("`[top_drive]`", "top_drive"),
        in_well::<WellTable>("`[well]`", "well"),
        chapter::<HoleTable>("`[[well.holes]]`", "well.holes.0"),
        in_well::<MudTable>("`[mud]`", "mud"),
        chapter::<AxialForceTable>("`[axial_force]`", "axial_force"),
        in_well::<StringFrictionTable>("`[string_friction]`", "string_friction"),
        in_well::<CompareTable>("`[[compare]]`", "compare.0"),
        chapter::<BitTable>("`[bit]`", "bit"),
        chapter::<LawTable>("`[bit.law]`", "bit.law"),
        chapter::<WallTable>("`[wall]`", "wall"),
        chapter::<SiteTable>("`[[sites]]`", "sites.0"),
        chapter::<ImpulseTable>("`[[impulses]]`", "impulses.0"),
        chapter::<EccentricMassTable>("`[[eccentric_masses]]`", "eccentric_masses.0"),
        chapter::<MethodTables>("`[method]`", "method"),
        chapter::<Transform>(
            "`[method.hilbert]` and `[method.direct-idft]`",
            "method.hilbert",
        ),
        chapter::<FiniteElement>("`[method.finite-element]`", "method.finite-element"),
        chapter::<DesignTable>("`[design]`", "design"),
        chapter::<AxisRange>("An axis", "design.axes.surface_speed_rpm"),
        in_well::<CorrelationTable>("`[[design.correlations]]`", "design.correlations.0"),
        chapter::<MapTable>("`[map]`", "map"),
        chapter::<MarkTable>("`marks`", "map.marks.0"),
    ];
    // Not a key of the merged file.
    chapters[0].keys.insert("base".to_owned());
    chapters
}

/// The rows of the table below a heading, by their first cell.
fn rows(heading: &str) -> BTreeMap<String, Vec<&'static str>> {
    let start = PAGE
        .find(&format!("\n## {heading}\n"))
        .unwrap_or_else(|| panic!("no chapter {heading}"));
    let chapter = PAGE[start + 1..].split("\n## ").next().unwrap();
    let cells = |line: &'static str| line.split('|').map(str::trim).collect::<Vec<_>>();
    let lines = chapter.lines().filter(|line| line.starts_with("| `"));
    lines
        .map(cells)
        .map(|cells| (cells[1].trim_matches('`').to_owned(), cells))
        .collect()
}

/// The table at a path of an example.
fn table_at<'a>(example: &'a mut Value, path: &str) -> &'a mut Table {
    let steps = path.split('.').filter(|step| !step.is_empty());
    let found = steps.fold(example, |value, step| match step.parse::<usize>() {
        Ok(index) => &mut value[index],
        Err(_) => &mut value[step],
    });
    found.as_table_mut().unwrap()
}

/// The example with one key changed, or without it.
fn example_with(chapter: &Chapter, key: &str, value: Option<Value>) -> Table {
    let mut example = Value::Table(toml::from_str(chapter.example).unwrap());
    let table = table_at(&mut example, chapter.path);
    match value {
        Some(value) => table.insert(key.to_owned(), value),
        None => table.remove(key),
    };
    example.as_table().unwrap().clone()
}

/// What a value far too large is told.
fn refusals(chapter: &Chapter, key: &str) -> [String; 2] {
    [Value::Float(1e300), Value::Integer(i64::MAX)].map(|value| {
        let text = toml::to_string(&example_with(chapter, key, Some(value))).unwrap();
        read(&text)
            .err()
            .map_or_else(String::new, |error| error.message().to_owned())
    })
}

/// Holds the cells of a range and a unit to what a value too large is told.
fn check_range(at: &str, range: &str, unit: &str, refusals: &[String]) {
    let is_number = |text: &&str| text.parse::<f64>().is_ok();
    let ends = range
        .split_once(" to ")
        .filter(|(from, to)| is_number(from) && is_number(to));
    let is_checked = |refusal: &String| refusal.contains("is not between");
    let Some((from, to)) = ends else {
        let by_words = range == "the axis's" || !refusals.iter().any(is_checked);
        assert!(by_words, "{at} has a range: {refusals:?}");
        return;
    };
    let space = if unit.is_empty() { "" } else { " " };
    let told = [
        format!("is not between {from} and {to}{space}{unit}"),
        format!("is out of range: {from} to {to}"),
        format!("more than {to}"),
    ];
    let is_told = |refusal: &String| told.iter().any(|told| refusal.contains(told));
    assert!(
        refusals.iter().any(is_told),
        "{at}: {range} {unit}, but {refusals:?}"
    );
}

#[test]
fn the_examples_have_no_fault() {
    for example in [EXAMPLE, EXAMPLE_IN_WELL] {
        read(example).unwrap();
    }
}

#[test]
fn the_guide_lists_every_key_and_no_other() {
    for chapter in chapters() {
        let listed: BTreeSet<String> = rows(chapter.heading).into_keys().collect();
        assert_eq!(listed, chapter.keys, "{}", chapter.heading);
    }
}

/// A table that is new has a chapter of its own.
#[test]
fn every_table_of_the_reader_has_a_chapter() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/sweep_file");
    let files = std::fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path());
    let files = files.filter(|path| path.is_file());
    let sources = files.map(|path| std::fs::read_to_string(path).unwrap());
    let methods = include_str!("../../../linear/src/method.rs").to_owned();
    let tables = sources.chain([methods]);
    let is_table = |line: &&str| line.starts_with("#[serde(deny_unknown_fields");
    let tables = tables.map(|source| source.lines().filter(is_table).count());
    assert_eq!(tables.sum::<usize>(), chapters().len());
}

#[test]
fn the_guide_has_the_ranges_and_units_of_the_reader() {
    for chapter in chapters() {
        for (key, cells) in rows(chapter.heading) {
            if key != "base" {
                let at = format!("{}: {key}", chapter.heading);
                check_range(&at, cells[4], cells[2], &refusals(&chapter, &key));
            }
        }
    }
}

#[test]
fn the_guide_has_the_defaults_of_the_reader() {
    for chapter in chapters() {
        for (key, cells) in rows(chapter.heading) {
            let at = format!("{}: {key}", chapter.heading);
            let content = |value| -> Result<FileContent, _> {
                example_with(&chapter, &key, value).try_into()
            };
            let without = content(None);
            let default = cells[3];
            if default == "required" {
                assert!(without.is_err(), "{at} has a default");
            } else if let Some(value) = default.strip_prefix('`') {
                let assignment = format!("value = {}", value.trim_end_matches('`'));
                let value = toml::from_str::<Table>(&assignment).unwrap()["value"].clone();
                assert_eq!(content(Some(value)), without, "{at}");
            } else {
                assert!(without.is_ok(), "{at} is required");
            }
        }
    }
}

#[test]
fn the_guide_lists_every_axis_with_its_range() {
    let rows = rows("Axes");
    let listed: BTreeSet<&str> = rows.keys().map(String::as_str).collect();
    assert_eq!(listed, Axis::NAMES.into());
    for (name, cells) in &rows {
        let axis = Axis::from_name(name).unwrap();
        let refusal = axis.check(1e300).unwrap_err().to_string();
        check_range(name, cells[3], cells[2], &[refusal]);
    }
}

/// The table of field units has every ending that is known, with its unit and factor.
#[test]
fn field_units_are_those_of_the_program() {
    let chapter = PAGE.split("\n## Field units\n").nth(1).unwrap();
    let chapter = chapter.split("\n## ").next().unwrap();
    let cells = |line: &'static str| line.split('|').map(|cell| cell.trim().trim_matches('`'));
    let mut told: Vec<([&str; 3], f64)> = (chapter.lines())
        .filter(|line| line.starts_with("| `"))
        .map(|line| cells(line).collect::<Vec<_>>())
        .map(|cells| ([cells[1], cells[2], cells[5]], cells[3].parse().unwrap()))
        .collect();
    for twin in &TWINS {
        let row = [twin.twin, twin.units[1].trim_matches('`'), twin.si];
        let place = told.iter().position(|&(cells, factor)| {
            let off = factor / twin.factors[0] - 1.0;
            cells == row && off.abs() < 1e-8
        });
        told.remove(place.unwrap_or_else(|| panic!("{} of {}", twin.twin, twin.si)));
    }
    assert!(told.is_empty(), "{told:?}");
}

/// No key with such a unit is left out.
#[test]
fn every_key_with_a_unit_has_its_twins() {
    let names = chapters().into_iter().flat_map(|chapter| chapter.keys);
    let mut twins = 0;
    for name in names.chain(Axis::NAMES.map(str::to_owned)) {
        for twin in &TWINS {
            let Some(stem) = name.strip_suffix(twin.si) else {
                continue;
            };
            // A part of its unit is none.
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
