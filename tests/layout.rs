//! The workspace has no package at its root, so Cargo does not find the files
//! of this folder by itself: each must be declared, or it would never run.

use std::path::Path;

#[test]
fn every_test_file_is_declared() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = std::fs::read_to_string(package.join("Cargo.toml")).unwrap();
    let files = std::fs::read_dir(package.join("../../tests")).unwrap();
    let mut seen = 0;
    for file in files {
        let name = file.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".rs") {
            let declaration = format!("path = \"../../tests/{name}\"");
            assert!(manifest.contains(&declaration), "{name} is not declared");
            seen += 1;
        }
    }
    assert!(seen > 0);
}
