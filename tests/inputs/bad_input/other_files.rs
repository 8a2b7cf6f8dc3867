//! Sweep files, bases and lists that cannot be read, or make a mistake that
//! shows in another file.

use crate::refusals::{RUN, refused, refused_at};
use crate::support::{SMALL, Workplace, small_with_design, with};

#[test]
fn a_sweep_file_that_cannot_be_read_is_named() {
    let place = Workplace::new();
    place.write("binary.toml", [0xff, 0xfe, 0x00]);
    let runs = |file| ["run", file, "--out", "results"];
    refused(
        &place,
        &runs("none.toml"),
        &["none.toml: cannot be read", "No such file"],
    );
    refused(&place, &runs("."), &[".: cannot be read"]);
    refused(
        &place,
        &runs("binary.toml"),
        &["binary.toml: cannot be read", "UTF-8"],
    );
    place.write("empty.toml", "");
    refused(
        &place,
        &runs("empty.toml"),
        &["empty.toml: `string`: is missing"],
    );
}

#[test]
fn every_command_refuses_a_bad_sweep_file_alike() {
    let place = Workplace::with_small(&with(SMALL, "time_s = 12", "time_s = -12"));
    place.write("labels.csv", "case,method,torsion\n0,quadrature,smooth\n");
    for arguments in [
        &["run", "small.toml", "--dry-run"][..],
        &["simulate", "small.toml"],
        &["inspect", "small.toml"],
        &["check", "small.toml", "labels.csv"],
    ] {
        refused(&place, arguments, &["error: small.toml:4: `time_s`: -12 s"]);
    }
}

/// The list of cases `cases.csv` and the sweep that names it.
pub fn with_list(cases: impl AsRef<[u8]>) -> Workplace {
    let design = "[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";
    let place = Workplace::with_small(&small_with_design(design));
    place.write("cases.csv", cases);
    place
}

#[test]
fn a_mistake_in_a_list_names_the_list_and_its_line() {
    let header = "surface_speed_rpm,weight_on_bit_kn\n";
    for (rows, line, meant) in [
        (
            "0.1,50\n0,50\n",
            3,
            "surface_speed_rpm: 0 rpm: the surface must turn",
        ),
        (
            "0.1,50\n0.1,-1\n",
            3,
            "weight_on_bit_kn: -1 kN is not between",
        ),
        (
            "0.1,50\n0.1,nan\n",
            3,
            "weight_on_bit_kn: NaN kN is not between",
        ),
        (
            "0.1,50e3\n",
            2,
            "weight_on_bit_kn: 50000 kN is not between 0 and 2000 kN; is it",
        ),
        (
            "0.1,fifty\n",
            2,
            "weight_on_bit_kn: `fifty` is not a number",
        ),
        ("0.1,\n", 2, "weight_on_bit_kn: `` is not a number"),
        ("0.1,50\n0.2\n", 3, "1 value, but 2 columns"),
        ("0.1,50,3\n", 2, "3 values, but 2 columns"),
        (
            "# slow\n\n0.1,50\n# fast\n\n0.2,x\n",
            7,
            "`x` is not a number",
        ),
        ("0.1,50\r\n0.2,x\r\n", 3, "`x` is not a number"),
    ] {
        let place = with_list(format!("{header}{rows}"));
        let at = format!("small.toml:29: `design.file`: cases.csv:{line}: ");
        refused(&place, &RUN, &[&at, meant]);
    }
    for (text, line, meant) in [
        (
            "speed,weight_on_bit_kn\n1,2\n",
            1,
            "unknown column `speed`; known: surface_speed_rpm",
        ),
        ("# cases\nspeed\n1\n", 2, "unknown column `speed`"),
        (
            "weight_on_bit_kn,weight_on_bit_kn\n1,2\n",
            1,
            "the column `weight_on_bit_kn` is there twice",
        ),
    ] {
        let at = format!("small.toml:29: `design.file`: cases.csv:{line}: ");
        refused(&with_list(text), &RUN, &[&at, meant]);
    }
}

#[test]
fn a_list_that_cannot_be_used_is_named() {
    let at = "error: small.toml:29: `design.file`: cases.csv ";
    for empty in ["", "surface_speed_rpm,weight_on_bit_kn\n", "# nothing\n"] {
        refused(&with_list(empty), &RUN, &[at, "lists no case"]);
    }
    refused(
        &with_list([0xff, b'\n']),
        &RUN,
        &[at, "cannot be read", "UTF-8"],
    );
    let place = with_list("");
    std::fs::remove_file(place.path("cases.csv")).unwrap();
    refused(&place, &RUN, &[at, "cannot be read", "No such file"]);
    let text = small_with_design("[design]\nkind = \"list\"\n");
    refused_at(&text, "[design]", "design", "a list needs `file`");
}

#[test]
fn a_base_that_cannot_be_used_is_refused() {
    refused_at(
        "base = \"none.toml\"",
        "base",
        "base",
        "none.toml: cannot be read",
    );
    refused_at(
        "title = \"x\"\nbase = 3",
        "base",
        "base",
        "names a file, so it is a string",
    );
    refused_at("base = \"small.toml\"", "base", "base", "go in a circle");
    let place = Workplace::with_small("base = \"other.toml\"\n");
    place.write("other.toml", "title = \"x\"\nbase = \"small.toml\"\n");
    refused(
        &place,
        &RUN,
        &["toml:", ": `base`: the bases go in a circle"],
    );
    place.write("other.toml", "title = \"x\"\ntitle = \"y\"\n");
    refused(&place, &RUN, &["error: other.toml:2: ", "duplicate key"]);
}

#[test]
fn a_mistake_is_shown_in_the_file_that_makes_it() {
    let place = Workplace::new();
    let runs = ["run", "child.toml", "--out", "results"];
    place.write("base.toml", with(SMALL, "time_s = 12", "time_s = -12"));
    place.write(
        "child.toml",
        "base = \"base.toml\"\n\n[bit]\nrock = \"shale\"\n",
    );
    refused(&place, &runs, &["error: base.toml:4: `time_s`: -12 s"]);
    place.write("base.toml", SMALL);
    place.write("child.toml", "base = \"base.toml\"\n\ntime_s = -9\n");
    refused(&place, &runs, &["error: child.toml:3: `time_s`: -9 s"]);
    place.write(
        "child.toml",
        "base = \"base.toml\"\n[bit]\nrok = \"shale\"\n",
    );
    refused(
        &place,
        &runs,
        &["error: child.toml:3: `bit.rok`", "did you mean `rock`?"],
    );
    place.write(
        "child.toml",
        "base = \"base.toml\"\n[design]\nkind = \"grid\"\n",
    );
    refused(&place, &runs, &["error: child.toml:2: `design.axes`"]);
    place.write(
        "child.toml",
        "base = \"base.toml\"\n[bit]\ntorque_static_ratio = 2\n",
    );
    place.write("base.toml", with(SMALL, "\"sandstone\"", "\"granite\""));
    refused(&place, &runs, &["error: base.toml:22: `bit.rock`"]);
}
