//! Stopping when the answer is certain or settled changes no label of the
//! paper's maps, and no measure beyond the tolerance of settling.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// What the program promises of settled measures, and a step of rounding in times.
const TOLERANCE: f64 = 1e-2;

type Row = BTreeMap<String, String>;

fn run(figure: &str, folder: &Path, more: &[&str]) -> (Vec<Row>, serde_json::Value) {
    let file = format!("{}/../../sweeps/{figure}.toml", env!("CARGO_MANIFEST_DIR"));
    let status = Command::new(env!("CARGO_BIN_EXE_sweep"))
        .args(["run", &file, "--quiet", "--out"])
        .arg(folder)
        .args(more)
        .status()
        .unwrap();
    assert!(status.success());
    let mut reader = csv::Reader::from_path(folder.join("labels.csv")).unwrap();
    let rows = reader.deserialize().map(Result::unwrap).collect();
    let manifest = std::fs::read_to_string(folder.join("manifest.json")).unwrap();
    (rows, serde_json::from_str(&manifest).unwrap())
}

fn holds(figure: &str, measures: &[&str], more: &[&str]) {
    let place = tempfile::tempdir().unwrap();
    let (early, manifest) = run(figure, &place.path().join("early"), more);
    let (full, _) = run(
        figure,
        &place.path().join("full"),
        &[more, &["--full"]].concat(),
    );
    assert_eq!(early.len(), full.len());
    let mut stopped = 0;
    for (early, full) in early.iter().zip(&full) {
        assert_eq!(full["ended"], "end");
        for label in ["case", "method", "torsion", "lateral"] {
            assert_eq!(early[label], full[label], "{early:?}");
        }
        if early["ended"] == "end" {
            continue;
        }
        stopped += 1;
        for &measure in measures {
            let [one, other] = [early, full].map(|row| row[measure].parse::<f64>().unwrap());
            let difference = (one - other).abs();
            let holds = difference <= TOLERANCE * other.abs().max(1e-6);
            assert!(holds, "{figure} {measure}: {early:?} {full:?}");
        }
    }
    assert!(stopped > 0, "no case of {figure} stopped early");
    assert_eq!(manifest["settled_wrong"], 0);
}

#[test]
fn val_figure_9_stops_early_with_the_same_labels() {
    let measures = [
        "bit_speed_closing_rpm",
        "bit_speed_peak_rpm",
        "first_slip_s",
    ];
    holds("fig09", &measures, &[]);
}

const LATERAL: [&str; 4] = [
    "mean_radius_mm",
    "precession_turns_per_s",
    "normal_force_mean_kn",
    "contact_fraction",
];

#[test]
fn val_figure_14_stops_early_with_the_same_labels() {
    holds("fig14", &LATERAL, &[]);
}

#[test]
fn val_figure_17_stops_early_with_the_same_labels() {
    holds("fig17", &LATERAL, &["--methods", "quadrature"]);
}
