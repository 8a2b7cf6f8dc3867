//! A Slurm cluster of two nodes on this machine, for one test: Slurm's own
//! daemons, for this machine only, with nothing outside their own folder and nothing left when the
//! value is dropped, also after a failed test.

use std::cell::RefCell;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{Read as _, Write as _};
use std::net::TcpListener;
use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU16, Ordering};
use std::time::{Duration, Instant};

use crate::support::Workplace;

/// For what takes a moment on an idle machine.
pub const SOON: Duration = Duration::from_secs(60);

/// Where the daemons are if not on the path of everybody.
const MORE_FOLDERS: &str = "/usr/local/sbin:/usr/sbin:/sbin";

/// Lines shown of each log.
const SHOWN: usize = 40;

/// A running cluster.
pub struct Cluster {
    pub place: Workplace,
    daemons: RefCell<Vec<(String, Child)>>,
}

impl Cluster {
    /// Starts one.
    ///
    /// # Panics
    /// Where Slurm is not installed, or does not start.
    pub fn start() -> Self {
        let needed = [
            "munged",
            "slurmctld",
            "slurmd",
            "sbatch",
            "scontrol",
            "sinfo",
        ];
        let missing: Vec<&str> = needed
            .into_iter()
            .filter(|name| find(name).is_none())
            .collect();
        assert!(missing.is_empty(), "Slurm is not installed: {missing:?}");
        let cluster = Self {
            place: Workplace::new(),
            daemons: RefCell::default(),
        };
        cluster.prepare();
        cluster.start_munge();
        cluster.daemon("slurmctld", "slurmctld", &["-D", "-c"]);
        cluster.daemon("slurmd-n1", "slurmd", &["-D", "-N", "n1"]);
        cluster.daemon("slurmd-n2", "slurmd", &["-D", "-N", "n2"]);
        cluster.wait_until("two idle nodes", SOON, || {
            let (_, nodes) = cluster.asks("sinfo", &["--noheader", "--Node", "--format=%T"]);
            (nodes == "idle\nidle\n").then_some(())
        });
        cluster
    }

    /// Writes the settings and the key.
    fn prepare(&self) {
        let folder = self.place.path("cluster");
        std::fs::create_dir_all(&folder).unwrap();
        // Munge wants a socket that everybody can reach, and a private key.
        for folder in [&folder, &self.place.path("")] {
            std::fs::set_permissions(folder, PermissionsExt::from_mode(0o755)).unwrap();
        }
        let mut random = [0; 64];
        File::open("/dev/urandom")
            .and_then(|mut source| source.read_exact(&mut random))
            .unwrap();
        let mut key = File::options();
        key.write(true).create_new(true).mode(0o600);
        key.open(self.path("munge.key"))
            .and_then(|mut key| key.write_all(&random))
            .unwrap();
        let word = |program: &str, option: &str| {
            let output = Command::new(program).arg(option).output().unwrap();
            String::from_utf8(output.stdout).unwrap().trim().to_owned()
        };
        let settings = include_str!("slurm.conf")
            .replace("USER", &word("id", "-un"))
            .replace("HERE", &word("uname", "-n"))
            .replace("PORT0", &free_port().to_string())
            .replace("PORT1", &free_port().to_string())
            .replace("PORT2", &free_port().to_string())
            .replace("FOLDER", folder.to_str().unwrap());
        std::fs::write(self.path("slurm.conf"), settings).unwrap();
    }

    fn start_munge(&self) {
        let option = |name: &str, file: &str| format!("--{name}={}", self.path(file).display());
        let options = [
            "--foreground".to_owned(),
            option("key-file", "munge.key"),
            option("socket", "munge.socket"),
            option("pid-file", "munged.pid"),
            option("seed-file", "munged.seed"),
        ];
        self.daemon("munged", "munged", &options.each_ref().map(String::as_str));
        self.wait_until("socket of munged", SOON, || {
            self.path("munge.socket").exists().then_some(())
        });
    }

    fn daemon(&self, name: &str, program: &str, arguments: &[&str]) {
        let words = File::create(self.path(&format!("{name}.words.log"))).unwrap();
        let daemon = self
            .command(program)
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(words.try_clone().unwrap())
            .stderr(words)
            .spawn()
            .unwrap();
        self.daemons.borrow_mut().push((name.to_owned(), daemon));
    }

    fn path(&self, name: &str) -> PathBuf {
        self.place.path("cluster").join(name)
    }

    /// A program that finds this cluster and no other one, to start in the
    /// workplace.
    pub fn command(&self, program: &str) -> Command {
        let found = find(program).unwrap_or_else(|| PathBuf::from(program));
        let mut command = Command::new(found);
        for (name, _) in std::env::vars_os() {
            let text = name.to_string_lossy();
            if ["SLURM", "SBATCH", "SQUEUE", "SCONTROL", "SINFO", "SCANCEL"]
                .iter()
                .any(|start| text.starts_with(start))
            {
                command.env_remove(&name);
            }
        }
        command
            .env("SLURM_CONF", self.path("slurm.conf"))
            .env("SWEEP", assert_cmd::cargo::cargo_bin!("sweep"))
            .env_remove("MARGIN_S")
            .current_dir(self.place.path(""));
        command
    }

    /// Runs a program: whether it succeeded, and what it said.
    fn asks(&self, program: &str, arguments: &[&str]) -> (bool, String) {
        let output = self.command(program).args(arguments).output().unwrap();
        let text = [output.stdout, output.stderr].concat();
        (
            output.status.success(),
            String::from_utf8_lossy(&text).into_owned(),
        )
    }

    /// Runs a program that must succeed, and returns what it said.
    #[track_caller]
    pub fn does(&self, program: &str, arguments: &[&str]) -> String {
        let (succeeded, text) = self.asks(program, arguments);
        assert!(
            succeeded,
            "{program} {arguments:?}: {text}\n{}",
            self.report()
        );
        text
    }

    /// Asks until there is an answer.
    #[track_caller]
    pub fn wait_until<T>(&self, what: &str, limit: Duration, answer: impl Fn() -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(answer) = answer() {
                return answer;
            }
            if let Some(name) = self.ended_daemon() {
                panic!("{name} has ended; no {what}\n{}", self.report());
            }
            if start.elapsed() > limit {
                panic!("no {what} within {limit:?}\n{}", self.report());
            }
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// A daemon that did not stay.
    fn ended_daemon(&self) -> Option<String> {
        let mut daemons = self.daemons.borrow_mut();
        daemons
            .iter_mut()
            .find_map(|(name, daemon)| match daemon.try_wait() {
                Ok(None) => None,
                _ => Some(name.clone()),
            })
    }

    /// What Slurm knows of a job, one that is no array.
    pub fn job(&self, job: &str) -> String {
        self.does("scontrol", &["show", "job", "--oneliner", job])
    }

    /// Waits for a job to end, and returns how.
    #[track_caller]
    pub fn end_of(&self, job: &str, limit: Duration) -> String {
        self.wait_until(&format!("end of job {job}"), limit, || {
            let state = field(&self.job(job), "JobState");
            let continues = ["PENDING", "RUNNING", "COMPLETING", "REQUEUED"];
            (!continues.contains(&state.as_str())).then_some(state)
        })
    }

    /// All there is to know when something went wrong.
    pub fn report(&self) -> String {
        let mut report = self.asks("squeue", &[]).1;
        let mut logs = Vec::new();
        find_logs(&self.place.path(""), &mut logs);
        for log in logs {
            let text = std::fs::read(&log).unwrap_or_default();
            let text = String::from_utf8_lossy(&text);
            let lines: Vec<&str> = text.lines().collect();
            let last = &lines[lines.len().saturating_sub(SHOWN)..];
            writeln!(report, "== {}\n{}", log.display(), last.join("\n")).unwrap();
        }
        report
    }

    /// The processes that know of this cluster: its daemons, their helpers, and
    /// the jobs.
    fn processes(&self) -> Vec<String> {
        let mark = self.path("slurm.conf");
        let mark = mark.as_os_str().as_encoded_bytes();
        let Ok(all) = std::fs::read_dir("/proc") else {
            return Vec::new();
        };
        all.flatten()
            .filter(|process| {
                let environment = std::fs::read(process.path().join("environ"));
                environment.is_ok_and(|found| found.windows(mark.len()).any(|part| part == mark))
            })
            .filter_map(|process| process.file_name().into_string().ok())
            .filter(|name| name.bytes().all(|byte| byte.is_ascii_digit()))
            .collect()
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        for (_, daemon) in self.daemons.get_mut() {
            let _ = daemon.kill();
            let _ = daemon.wait();
        }
        // Jobs and their helpers are no children of ours. More than once, as they
        // may be starting others.
        for _ in 0..100 {
            let left = self.processes();
            if left.is_empty() {
                return;
            }
            let _ = Command::new("kill")
                .arg("-KILL")
                .args(left)
                .stderr(Stdio::null())
                .status();
            std::thread::sleep(Duration::from_millis(20));
        }
        tell(&format!("still there: processes {:?}", self.processes()));
    }
}

/// Not by `eprintln`, whose words the test runner keeps to itself.
fn tell(text: &str) {
    let mut errors = std::io::stderr();
    let _ = writeln!(errors, "{text}");
}

/// The logs of daemons and jobs below a folder, in which files come and go.
fn find_logs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            find_logs(&path, found);
        } else if path.extension().is_some_and(|end| end == "log") && !path.ends_with("cases.log") {
            found.push(path);
        }
    }
}

/// Where a program is.
fn find(program: &str) -> Option<PathBuf> {
    if Path::new(program).is_absolute() {
        return Some(PathBuf::from(program));
    }
    let path = std::env::var("PATH").unwrap_or_default();
    std::env::split_paths(&format!("{path}:{MORE_FOLDERS}"))
        .map(|folder| folder.join(program))
        .find(|file| file.is_file())
}

/// A port without a listener. Below those that the system gives to
/// connections, or one of them might take it before its daemon does.
fn free_port() -> u16 {
    static TRIED: AtomicU16 = AtomicU16::new(0);
    let start = (std::process::id() % 1000) as u16 * 10;
    (0..1000)
        .map(|_| 20_000 + (start + TRIED.fetch_add(1, Ordering::Relaxed)) % 10_000)
        .find(|port| TcpListener::bind(("127.0.0.1", *port)).is_ok())
        .expect("a free port")
}

/// A value in a line of `name=value`.
pub fn field(line: &str, name: &str) -> String {
    line.split_whitespace()
        .find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
        .unwrap_or_else(|| panic!("no {name} in {line}"))
        .to_owned()
}
