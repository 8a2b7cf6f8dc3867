//! Tables put into a results folder.

use sha2::{Digest, Sha256};

use super::support::Workplace;

/// Puts a table into a results folder as if the run had written it.
pub fn write_table(place: &Workplace, folder: &str, name: &str, content: impl AsRef<[u8]>) {
    let mut manifest: serde_json::Value = serde_json::from_slice(
        &std::fs::read(place.path(&format!("{folder}/manifest.json"))).unwrap(),
    )
    .unwrap();
    let digest = Sha256::digest(content.as_ref());
    let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    manifest["files"][name] =
        serde_json::json!({ "bytes": content.as_ref().len(), "sha256": digits });
    if name == "labels.csv" {
        // Rows that were not simulated have no records.
        let files = manifest["files"].as_object_mut().unwrap();
        files.remove("records.jsonl.gz");
        let _ = std::fs::remove_file(place.path(&format!("{folder}/records.jsonl.gz")));
    }
    let manifest = serde_json::to_vec_pretty(&manifest).unwrap();
    place.write(&format!("{folder}/manifest.json"), manifest);
    place.write(&format!("{folder}/{name}"), content);
}
