//! The shipped assembly on bottom in an inclined well: what its bit does decides what it does on the low side.

use super::rows::{number, rows, word};
use crate::support::Workplace;

/// Its file, by both of its methods, at two weights: below its limit of stick-slip, and above.
#[test]
fn val_an_assembly_snakes_where_its_bit_sticks_and_slips() {
    let place = Workplace::new();
    let base = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../sweeps/well_12in_on_bottom.toml"
    );
    let text = format!(
        "base = \"{base}\"\n[design]\nkind = \"grid\"\n[design.axes]\n\
         weight_on_bit_kn = {{ values = [100, 150] }}\nsurface_speed_rpm = {{ values = [80] }}\n"
    );
    std::fs::write(place.path("sweep.toml"), text).unwrap();
    let answer = place.answer(&["run", "sweep.toml", "--out", "out"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let labels = std::fs::read_to_string(place.path("out/labels.csv")).unwrap();
    let rows = rows(&labels);
    assert_eq!(rows.len(), 4);
    for row in rows {
        let (expected, swings) = match number(&row, "weight_on_bit_kn") {
            100.0 => (["smooth", "low_side"], 0.0..0.01),
            _ => (["stick_slip", "snaking"], 5.0..30.0),
        };
        let found = ["torsion", "lateral"].map(|column| word(&row, column));
        assert_eq!(found, expected, "{labels}");
        assert!(swings.contains(&number(&row, "swing_deg")), "{labels}");
    }
}
