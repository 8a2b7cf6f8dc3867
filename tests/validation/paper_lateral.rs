//! Validation of the map of Fig. 14 against the paper, through the binary.

use std::process::Command;

struct Case {
    impulse: f64,
    friction: f64,
    labels: Vec<String>,
}

/// Labels by quadrature, the digital filter and finite elements, in this order,
/// and the least friction of steady whirl.
fn figure_14() -> (Vec<Case>, f64) {
    let folder = tempfile::tempdir().unwrap();
    let sweep_file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig14.toml");
    let status = Command::new(env!("CARGO_BIN_EXE_sweep"))
        .args(["run", sweep_file, "--quiet", "--out"])
        .arg(folder.path())
        .status()
        .unwrap();
    assert!(status.success());
    let limit: f64 = {
        let mut reader = csv::Reader::from_path(folder.path().join("boundary.csv")).unwrap();
        let header = reader.headers().unwrap().clone();
        let friction = header.iter().position(|field| field == "friction").unwrap();
        let point = reader.records().next().unwrap().unwrap();
        point[friction].parse().unwrap()
    };
    let mut reader = csv::Reader::from_path(folder.path().join("labels.csv")).unwrap();
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|field| field == name).unwrap();
    let [impulse, friction, label] = ["impulse_ratio", "friction", "lateral"].map(column);
    let records: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let cases = records
        .chunks(3)
        .map(|rows| Case {
            impulse: rows[0][impulse].parse().unwrap(),
            friction: rows[0][friction].parse().unwrap(),
            labels: rows.iter().map(|row| row[label].to_owned()).collect(),
        })
        .collect();
    (cases, limit)
}

#[test]
fn val_figure_14_is_the_papers() {
    let (cases, limit) = figure_14();
    assert!((limit - 1.14).abs() < 0.01, "{limit}");
    assert!(cases.len() >= 300);
    let (mut elements_differ, mut filter_differs) = (0, 0);
    for Case {
        impulse,
        friction,
        labels,
    } in &cases
    {
        let at = format!("I = {impulse} I₀, μ₀ = {friction}: {labels:?}");
        // No contact below I₀, and contact above.
        assert_eq!(*impulse < 1.0, labels[0] == "no_contact", "{at}");
        // Whirl only above μ₀ ≈ 1.2, and surely where both are large.
        let whirls = labels[0] == "backward_whirl";
        assert!(!whirls || *friction > limit, "{at}");
        assert!(whirls || *friction < 1.35 || *impulse < 2.6, "{at}");
        elements_differ += usize::from(labels[2] != labels[0]);
        if labels[1] != labels[0] {
            filter_differs += 1;
            // The filter finds less whirl, and only near the limit.
            assert!(whirls, "{at}");
            assert!(*friction < 1.45 || *impulse < 2.0, "{at}");
        }
    }
    assert!(100 * elements_differ <= cases.len());
    assert!(10 * filter_differs <= cases.len());
}
