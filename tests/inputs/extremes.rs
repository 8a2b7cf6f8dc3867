//! Whole sweeps at the ends of every range, run in little memory: each is answered,
//! refused, or kept aside case by case with a reason; or it takes long, and stops when it
//! is asked to. None panics, is aborted, or hangs.
//!
//! `EXTREME_FILES=10000 cargo test --release -p drillstring --test inputs extremes -- --nocapture` runs
//! more of them, `EXTREME_FIRST=5000` others, `EXTREME_SECONDS=3` gives each less time.

#![cfg(unix)]

mod files;

use std::collections::BTreeMap;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::support::Workplace;
use files::{Random, sweep_file};

/// Files in a run of all tests.
const FILES: u64 = 120;

/// One of them whose attempts for its accuracy took more memory than estimated.
const HARD: u64 = 385;

/// What the program may use by its own estimate, and what the system gives it: the
/// code, the threads and what estimates leave out have their place between.
const MEMORY: &str = "128M";
const ADDRESS_SPACE_KB: usize = 2_000_000;

/// What takes longer is asked to stop, s.
const LONG: u64 = 30;

/// What was asked to stop has done so long before.
const GUARD: Duration = Duration::from_secs(60);

/// A number from the environment.
fn asked(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| text.parse().expect("a number"))
}

/// Runs one file; what was wrong with its end, or the word for it.
fn end_of(number: u64) -> Result<&'static str, String> {
    let mut random = Random::of(number);
    let text = sweep_file(&mut random);
    let place = Workplace::with_small(&text);
    let mut arguments = vec!["run", "small.toml", "--jobs", "1", "--memory", MEMORY];
    if random.happens(0.8) {
        arguments.push("--allow-unstable");
    }
    if random.happens(0.2) {
        arguments.push("--full");
    }
    let (status, errors) = limited(&place.command(&arguments));
    let wrong = |what: String| Err(format!("file {number}: {what}\n{errors}\n{text}"));
    let Some(status) = status else {
        return wrong("continues though it was asked to stop".to_owned());
    };
    if errors.contains("panicked") {
        return wrong("a panic".to_owned());
    }
    match status.code() {
        Some(0) => Ok("answered"),
        Some(143) => {
            println!("file {number} took long");
            Ok("stopped when asked")
        }
        Some(2) if errors.contains("memory") => Ok("refused for its memory"),
        Some(2) => Ok("refused"),
        Some(3) => {
            let failures = std::fs::read_to_string(place.path("results/small/failures.csv"));
            match failures {
                Ok(failures) if !failures.contains("panicked") => Ok("cases kept aside"),
                Ok(failures) => wrong(failures),
                Err(error) => wrong(format!("failures.csv: {error}")),
            }
        }
        code => wrong(format!("exit code {code:?}, signal {:?}", status.signal())),
    }
}

/// Runs a command in little memory. Its status, unless it had to be killed, and what it
/// said.
fn limited(command: &Command) -> (Option<ExitStatus>, String) {
    let script = format!("ulimit -c 0; ulimit -v {ADDRESS_SPACE_KB}; exec \"$0\" \"$@\"");
    let mut shell = Command::new("sh");
    shell
        .arg("-c")
        .arg(script)
        .arg(command.get_program())
        .args(command.get_args());
    if let Some(folder) = command.get_current_dir() {
        shell.current_dir(folder);
    }
    let errors = tempfile::NamedTempFile::new().unwrap();
    let child = shell
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(errors.reopen().unwrap())
        .spawn()
        .unwrap();
    let status = ended(child);
    (status, std::fs::read_to_string(errors.path()).unwrap())
}

fn ended(mut child: Child) -> Option<ExitStatus> {
    let within = |time: Duration, child: &mut Child| {
        let start = Instant::now();
        while start.elapsed() < time {
            if let Some(status) = child.try_wait().unwrap() {
                return Some(status);
            }
            std::thread::sleep(Duration::from_millis(2));
        }
        None
    };
    let long = Duration::from_secs(asked("EXTREME_SECONDS", LONG));
    if let Some(status) = within(long, &mut child) {
        return Some(status);
    }
    let terminate = ["-TERM", &child.id().to_string()];
    let killed = Command::new("kill").args(terminate).status().unwrap();
    assert!(killed.success());
    if let Some(status) = within(GUARD, &mut child) {
        return Some(status);
    }
    child.kill().unwrap();
    child.wait().unwrap();
    None
}

#[test]
fn extreme_sweeps_are_answered_or_refused() {
    let (first, files) = (asked("EXTREME_FIRST", 0), asked("EXTREME_FILES", FILES));
    let numbers: Vec<u64> = (first..first + files).chain([HARD]).collect();
    let next = AtomicUsize::new(0);
    let found = Mutex::new((BTreeMap::<&str, usize>::new(), Vec::new()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(&number) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let end = end_of(number);
                    let mut found = found.lock().unwrap();
                    match end {
                        Ok(word) => *found.0.entry(word).or_default() += 1,
                        Err(what) => found.1.push(what),
                    }
                }
            });
        }
    });
    let (ends, wrong) = found.into_inner().unwrap();
    println!("{ends:?}");
    assert!(
        wrong.is_empty(),
        "{} of {files}:\n{}",
        wrong.len(),
        wrong.join("\n\n")
    );
    // Were nearly all refused at once, this would see little more than the reader: of 120 files some 9 to 17
    // are built, which every new key draws anew.
    let built = ["answered", "cases kept aside", "stopped when asked"];
    let built: usize = built.iter().filter_map(|word| ends.get(word)).sum();
    assert!(20 * built as u64 >= files, "{ends:?}");
}

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
    let run = assert_cmd::Command::new(env!("CARGO_BIN_EXE_sweep"))
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
