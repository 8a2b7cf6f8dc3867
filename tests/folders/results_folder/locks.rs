//! A file system without locks, played by a filter of system calls that the kernel applies.

use std::path::PathBuf;
use std::process::Command;

use crate::results_folder::{read, succeeds};
use crate::support::{SMALL, Workplace, without_coarse_sampling};

/// A program that starts another whose locks all fail, made by the compiler that links Rust's
/// programs.
fn launcher(place: &Workplace, error: &str) -> PathBuf {
    place.write(
        "launcher.c",
        format!(
            "#include <errno.h>
             #include <stddef.h>
             #include <unistd.h>
             #include <linux/filter.h>
             #include <linux/seccomp.h>
             #include <sys/prctl.h>
             #include <sys/syscall.h>
             int main(int count, char **arguments) {{
                 struct sock_filter steps[] = {{
                     BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
                     BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
                     BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | {error}),
                     BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
                 }};
                 struct sock_fprog filter = {{sizeof steps / sizeof *steps, steps}};
                 if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)) return 98;
                 if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter)) return 99;
                 return execv(arguments[1], arguments + 1);
             }}"
        ),
    );
    let launcher = place.path("launcher");
    let status = Command::new("cc")
        .args(["-w", "-o"])
        .args([&launcher, &place.path("launcher.c")])
        .status()
        .unwrap();
    assert!(status.success());
    launcher
}

#[test]
fn a_file_system_without_locks_is_warned_of_and_the_run_continues() {
    let place = Workplace::with_small(SMALL);
    succeeds(&place, &["run", "small.toml", "--out", "whole"]);
    // Of a kernel, of a network file system, of a file system.
    for error in ["ENOSYS", "ENOLCK", "EOPNOTSUPP"] {
        let launcher = launcher(&place, error);
        let sweep = |arguments: &[&str]| {
            let command = place.command(arguments);
            let output = Command::new(&launcher)
                .arg(command.get_program())
                .args(command.get_args())
                .current_dir(place.path("."))
                .output()
                .unwrap();
            let errors = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(0), "{errors}");
            errors
        };
        for arguments in [
            &["run", "small.toml", "--out", error][..],
            &["plot", error],
            &["report", error],
        ] {
            let errors = sweep(arguments);
            let warning = format!("warning: the file system of {error} has no locks (");
            assert!(errors.starts_with(&warning), "{errors}");
            let errors = without_coarse_sampling(&errors);
            assert_eq!(errors.lines().count(), 1, "{errors}");
        }
        // What is only read needs none.
        assert_eq!(sweep(&["summary", error]), "");
        let labels = |folder: &str| read(&place, &format!("{folder}/labels.csv"));
        assert!(labels("whole") == labels(error));
    }
}
