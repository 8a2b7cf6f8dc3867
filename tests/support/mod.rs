//! Driving the binary from outside: a small sweep in its own folder.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A sweep of six cases that takes a moment: 100 m of pipe and one method.
pub const SMALL: &str = include_str!("small.toml");

/// A sweep of six cases with a bit that cuts what its blades leave, five of which chatter.
pub const CUTTING: &str = include_str!("cutting.toml");

/// [`SMALL`] with its `[design]` and `[map]` replaced.
pub fn small_with_design(design: &str) -> String {
    let setting = SMALL.split("[design]").next().unwrap();
    format!("{setting}{design}")
}

/// `text` with one piece of it, which must be there once, replaced.
#[track_caller]
pub fn with(text: &str, piece: &str, replacement: &str) -> String {
    assert_eq!(text.matches(piece).count(), 1, "{piece:?} in\n{text}");
    text.replace(piece, replacement)
}

/// What was complained of, but for what the coarse sampling of the small sweep smears, damps or does not
/// measure.
pub fn without_coarse_sampling(errors: &str) -> String {
    let coarse = [
        "fronts are smeared by ",
        "of the steps that a turn needs",
        "accelerations are measured within",
    ];
    let lines = errors.split_inclusive('\n');
    lines
        .filter(|line| !coarse.iter().any(|what| line.contains(what)))
        .collect()
}

/// What a command answered.
#[derive(Debug)]
pub struct Answer {
    pub code: i32,
    pub output: String,
    pub errors: String,
}

/// A folder to run the binary in.
pub struct Workplace(tempfile::TempDir);

impl Workplace {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// With `small.toml` in it.
    pub fn with_small(text: &str) -> Self {
        let place = Self::new();
        place.write("small.toml", text);
        place
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    /// The binary, ready to start here, without the cluster's settings of threads and memory.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("sweep"));
        command
            .args(arguments)
            .current_dir(self.0.path())
            .env_remove("SLURM_CPUS_PER_TASK")
            .env_remove("SLURM_CPUS_ON_NODE")
            .env_remove("SLURM_MEM_PER_NODE");
        command
    }

    /// What a command answers, but for a warning that the small sweep deserves: it is fast because
    /// it is sampled coarsely.
    pub fn sweep(&self, arguments: &[&str]) -> Answer {
        let mut answer = self.answer(arguments);
        answer.errors = without_coarse_sampling(&answer.errors);
        answer
    }

    /// All that a command answers.
    pub fn answer(&self, arguments: &[&str]) -> Answer {
        let output = self.command(arguments).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Answer {
            code: output.status.code().expect("no signal ended it"),
            output: text(output.stdout),
            errors: text(output.stderr),
        }
    }

    /// Every file below the folder, with its content; folders have none.
    pub fn files(&self) -> BTreeMap<String, Option<Vec<u8>>> {
        let mut found = BTreeMap::new();
        collect(self.0.path(), self.0.path(), &mut found);
        found
    }
}

fn collect(root: &Path, folder: &Path, found: &mut BTreeMap<String, Option<Vec<u8>>>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(root).unwrap().display().to_string();
        if path.is_dir() {
            found.insert(name, None);
            collect(root, &path, found);
        } else {
            found.insert(name, Some(std::fs::read(&path).unwrap()));
        }
    }
}
