//! The page of the guide that lists every key, held to the types of the sweep file; and these
//! to the reader: ranges and defaults.

mod page;
mod reader;
mod units;

use std::path::Path;

use super::Sweep;
use crate::sweep_file::SweepFileError;

const PAGE: &str = include_str!("../../../../../docs/sweep-file.md");

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
[[tools]]
distance_from_bit_m = 10
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
inclination_deg = 30
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

/// One with the tables of a bit that cuts, below a motor.
const EXAMPLE_CUTTING: &str = r#"
surface_speed_rpm = 120
[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 10
axial = { youngs_modulus_gpa = 210, damping_ns_m2 = 100 }
[[string.sections]]
repeat = 10
parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.15 }]
[bit]
rock = "sandstone"
[bit.cutting]
[feed]
kind = "speed"
feed_m_h = 20
[motor]
speed_rpm = 100
stall_torque_kn_m = 12
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

/// A heading of the page, and where the table that it is about stands in an example.
struct Chapter {
    heading: &'static str,
    path: &'static str,
    example: &'static str,
}

const fn chapter(heading: &'static str, path: &'static str) -> Chapter {
    Chapter {
        heading,
        path,
        example: EXAMPLE,
    }
}

const fn in_well(heading: &'static str, path: &'static str) -> Chapter {
    Chapter {
        example: EXAMPLE_IN_WELL,
        ..chapter(heading, path)
    }
}

const fn cutting(heading: &'static str, path: &'static str) -> Chapter {
    Chapter {
        example: EXAMPLE_CUTTING,
        ..chapter(heading, path)
    }
}

const CHAPTERS: [Chapter; 31] = [
    chapter("The file itself", ""),
    chapter("`[string]`", "string"),
    chapter("`[string.bending]`", "string.bending"),
    cutting("`[string.axial]`", "string.axial"),
    chapter("`[[string.sections]]`", "string.sections.0"),
    chapter("`parts`", "string.sections.0.parts.0"),
    chapter("`[top_drive]`", "top_drive"),
    in_well("`[well]`", "well"),
    chapter("`[[well.holes]]`", "well.holes.0"),
    in_well("`[mud]`", "mud"),
    chapter("`[axial_force]`", "axial_force"),
    in_well("`[string_friction]`", "string_friction"),
    in_well("`[[compare]]`", "compare.0"),
    chapter("`[bit]`", "bit"),
    chapter("`[bit.law]`", "bit.law"),
    cutting("`[bit.cutting]`", "bit.cutting"),
    cutting("`[feed]`", "feed"),
    cutting("`[motor]`", "motor"),
    chapter("`[wall]`", "wall"),
    chapter("`[[sites]]`", "sites.0"),
    chapter("`[[impulses]]`", "impulses.0"),
    chapter("`[[eccentric_masses]]`", "eccentric_masses.0"),
    chapter("`[[tools]]`", "tools.0"),
    chapter("`[method]`", "method"),
    chapter(
        "`[method.hilbert]` and `[method.direct-idft]`",
        "method.hilbert",
    ),
    chapter("`[method.finite-element]`", "method.finite-element"),
    chapter("`[design]`", "design"),
    chapter("An axis", "design.axes.surface_speed_rpm"),
    in_well("`[[design.correlations]]`", "design.correlations.0"),
    chapter("`[map]`", "map"),
    chapter("`marks`", "map.marks.0"),
];

/// Keys of a file that the types do not have.
const OF_BASES: [&str; 2] = ["base", "without"];

#[test]
fn the_examples_have_no_fault() {
    for example in [EXAMPLE, EXAMPLE_IN_WELL, EXAMPLE_CUTTING] {
        read(example).unwrap();
    }
}
