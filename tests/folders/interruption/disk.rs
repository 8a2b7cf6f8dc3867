//! Disks that fill and folders of other people.

use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::process::Command;

use crate::interruption::{finishes, logged, long, same_tables};
use crate::support::Workplace;

/// The binary under a limit of the size of files, which the system reports
/// where a full disk would be reported.
fn run_with_room(place: &Workplace, kilobytes: usize) -> (Option<i32>, String) {
    let binary = place.command(&[]).get_program().to_owned();
    let output = Command::new("sh")
        .arg("-c")
        // POSIX counts blocks of 512 bytes; the signal is to be an error.
        .arg(format!(
            "trap '' XFSZ; ulimit -f {}; exec \"$0\" run small.toml --full --quiet --out results",
            2 * kilobytes
        ))
        .arg(binary)
        .current_dir(place.path(""))
        .output()
        .unwrap();
    (
        output.status.code(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

#[test]
fn a_full_disk_loses_nothing() {
    let place = Workplace::with_small(&long());
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "whole"],
    );
    let mut before = 0;
    for kilobytes in [8, 32, 48] {
        let (code, errors) = run_with_room(&place, kilobytes);
        assert_eq!(code, Some(1), "{errors}");
        assert!(
            errors.contains("results/cases.log cannot be written"),
            "{errors}"
        );
        assert!(errors.contains("the same command continues"), "{errors}");
        let done = logged(&place, "results");
        assert!(done > before, "{done} after {before}");
        assert!(errors.contains(&format!("{done} of 600")), "{errors}");
        before = done;
    }
    finishes(
        &place,
        &["run", "small.toml", "--full", "--quiet", "--out", "results"],
    );
    same_tables(&place, "whole", "results");
}

/// The folder is not writable for any user who runs this.
#[test]
fn the_folder_of_someone_else_is_an_error() {
    let place = Workplace::with_small(&long());
    let allow = |path: &str, mode: u32| {
        let permissions = std::fs::Permissions::from_mode(mode);
        std::fs::set_permissions(place.path(path), permissions).unwrap();
    };
    std::fs::create_dir(place.path("theirs")).unwrap();
    // Another user has to get at the binary.
    std::fs::copy(place.command(&[]).get_program(), place.path("sweep")).unwrap();
    allow("", 0o755);
    allow("sweep", 0o755);
    allow("small.toml", 0o644);
    allow("theirs", 0o555);
    let mut command = Command::new(place.path("sweep"));
    command
        .args(["run", "small.toml", "--full", "--quiet", "--out", "theirs"])
        .current_dir(place.path(""));
    let is_root = std::fs::metadata("/proc/self").is_ok_and(|own| {
        use std::os::unix::fs::MetadataExt;
        own.uid() == 0
    });
    if is_root {
        command.uid(65534).gid(65534);
    }
    let output = command.output().unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(
        errors.contains("theirs/cases.log cannot be written"),
        "{errors}"
    );
    assert!(errors.contains("Permission denied"), "{errors}");
    allow("theirs", 0o755);
    assert_eq!(std::fs::read_dir(place.path("theirs")).unwrap().count(), 0);
}
