//! Cases that no string survives: each ends, with an answer or with its reason.

use std::path::Path;
use std::time::Duration;

use assert_cmd::Command;

/// A case takes milliseconds; one that does not end is stopped after this.
const GUARD: Duration = Duration::from_secs(600);

/// An unbalanced mass that turns so fast throws the string beyond all numbers: the
/// further out it is, the harder it is thrown.
#[test]
fn a_mass_that_throws_the_string_beyond_all_numbers_is_a_failure_with_its_place_and_time() {
    let folder = tempfile::tempdir().unwrap();
    let figure = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps/fig10.toml");
    let file = folder.path().join("thrown.toml");
    let text = format!(
        "base = {figure:?}\ntime_s = 2\nmethods = [\"quadrature\"]\n\
         surface_speed_rpm = 10000\nimpulses = []\n\
         [[eccentric_masses]]\ndistance_from_bit_m = 0\nmass_kg = 1000000\noffset_m = 10\n"
    );
    std::fs::write(&file, text).unwrap();
    let out = folder.path().join("out");
    let run = Command::new(env!("CARGO_BIN_EXE_sweep"))
        .timeout(GUARD)
        .args(["run".as_ref(), file.as_os_str(), "--out".as_ref()])
        .arg(&out)
        .output()
        .unwrap();
    assert!(run.status.code().is_some(), "the case does not end");
    let mut reader = csv::Reader::from_path(out.join("failures.csv")).unwrap();
    let columns = reader.headers().unwrap().clone();
    let reason = columns.iter().position(|name| name == "reason").unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 1);
    let reason = &rows[0][reason];
    assert!(
        reason.starts_with("the motion of site 0 is not finite from "),
        "{reason}"
    );
    assert!(reason.ends_with(" s on (site 0 is the bit)"), "{reason}");
}
