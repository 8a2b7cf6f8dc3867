//! How much memory a command may take: what is asked for by `--memory`, what Slurm
//! allots, or half of what the machine has for this process.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use thiserror::Error;

use crate::allotted::{IgnoredSetting, allotted};

/// Part of the machine's memory that is taken without being asked for.
const PART: f64 = 0.5;

/// The limit where the machine does not tell what it has, bytes.
const UNKNOWN_MACHINE: f64 = 4.0 * GIB;

const KIB: f64 = 1024.0;
const GIB: f64 = KIB * KIB * KIB;

/// An amount of memory, bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size(pub f64);

impl Size {
    /// Number of whole bytes in which it fits.
    pub fn whole_bytes(self) -> u64 {
        self.0.ceil() as u64
    }
}

/// Units by their first letters, each 1024 times the one before.
const UNITS: [char; 5] = ['B', 'K', 'M', 'G', 'T'];

/// `8G`, `8GiB`, `1.5 G`, `512M` or plain bytes: powers of 1024, as Slurm counts.
impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let unit_at = text.find(|c: char| c.is_ascii_alphabetic());
        let (number, unit) = text.split_at(unit_at.unwrap_or(text.len()));
        let unit = unit.to_ascii_uppercase();
        let letter = unit.chars().next().unwrap_or('B');
        let power = UNITS.iter().position(|unit| *unit == letter);
        let power = power.filter(|_| unit.len() < 2 || &unit[1..] == "IB");
        let bytes = (number.trim().parse::<f64>().ok().zip(power))
            .map(|(number, power)| number * KIB.powi(power as i32));
        (bytes
            .filter(|bytes| bytes.is_finite() && *bytes >= 1.0)
            .map(Self))
        .ok_or_else(|| format!("`{text}` is not an amount of memory such as 8G, 512M or bytes"))
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let gibibytes = self.0 / GIB;
        if gibibytes >= 1e6 {
            write!(f, "{gibibytes:.1e} GiB")
        } else if gibibytes >= 0.9995 {
            write!(f, "{gibibytes:.1} GiB")
        } else {
            write!(f, "{:.0} MiB", self.0 / (KIB * KIB))
        }
    }
}

/// The most a command may take, and who says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Bytes.
    pub bytes: f64,
    /// In words that follow the amount.
    source: &'static str,
}

impl Limit {
    /// The limit given on the command line, or that of where this runs.
    pub fn of(given: Option<Size>) -> Self {
        let (bytes, source) = if let Some(Size(bytes)) = given {
            (bytes, "given by --memory")
        } else if let Ok(Some(bytes)) = allotted_memory() {
            (bytes, "allotted by Slurm")
        } else if let Some(bytes) = available() {
            (PART * bytes, "half of what this machine gives")
        } else {
            (
                UNKNOWN_MACHINE,
                "for this machine does not tell what it has",
            )
        };
        Self { bytes, source }
    }

    /// An impossible value of Slurm, where it would be the limit.
    pub fn ignored(given: Option<Size>) -> Option<IgnoredSetting> {
        given.is_none().then(allotted_memory)?.err()
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", Size(self.bytes), self.source)
    }
}

/// Why an amount of memory cannot be meant.
#[derive(Debug, Error)]
#[error("it is not a number of MiB")]
struct NotMebibytes;

/// What Slurm allots to a job on this node, bytes; 0 MiB are all of it.
fn allotted_memory() -> Result<Option<f64>, IgnoredSetting> {
    let bytes = allotted("SLURM_MEM_PER_NODE", |text| {
        let bytes = text.parse::<f64>().ok().map(|amount| amount * KIB * KIB);
        let is_amount = |bytes: &f64| bytes.is_finite() && *bytes >= 0.0;
        bytes.filter(is_amount).ok_or(NotMebibytes)
    })?;
    Ok(bytes.filter(|bytes| *bytes >= KIB * KIB))
}

/// What the machine has for this process: its memory, or less by a control group or a
/// limit of address space.
fn available() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let of_machine = KIB * number_after(&text, "MemTotal:")?;
    let of_groups = control_groups();
    let of_process = std::fs::read_to_string("/proc/self/limits").ok();
    let of_process = of_process.and_then(|text| number_after(&text, "Max address space"));
    Some(of_groups.chain(of_process).fold(of_machine, f64::min))
}

/// The number that follows a word at the start of a line.
fn number_after(text: &str, word: &str) -> Option<f64> {
    let mut lines = text.lines().filter_map(|line| line.strip_prefix(word));
    lines.next()?.split_whitespace().next()?.parse().ok()
}

/// Limits of the control groups that hold this process, of the second version of that
/// interface and of the first.
fn control_groups() -> impl Iterator<Item = f64> {
    let text = std::fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    let paths: Vec<_> = text.lines().filter_map(group_of).collect();
    paths.into_iter().flat_map(|(root, file, group)| {
        let folders = Path::new(group.trim_start_matches('/')).ancestors();
        let limits = folders.filter_map(|folder| {
            let path = Path::new(root).join(folder).join(file);
            std::fs::read_to_string(path).ok()?.trim().parse().ok()
        });
        limits.collect::<Vec<f64>>()
    })
}

/// Root, file of the limit and path of a line `number:controllers:path`.
fn group_of(line: &str) -> Option<(&'static str, &'static str, String)> {
    let mut fields = line.splitn(3, ':').skip(1);
    let (controllers, path) = (fields.next()?, fields.next()?);
    let (root, file) = match controllers {
        "" => ("/sys/fs/cgroup", "memory.max"),
        _ if controllers.split(',').any(|name| name == "memory") => {
            ("/sys/fs/cgroup/memory", "memory.limit_in_bytes")
        }
        _ => return None,
    };
    Some((root, file, path.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_read_as_slurm_does() {
        for (text, bytes) in [
            ("8G", 8.0 * GIB),
            ("8GiB", 8.0 * GIB),
            ("1.5 g", 1.5 * GIB),
            ("512M", 0.5 * GIB),
            ("1000000", 1e6),
            ("1000000B", 1e6),
        ] {
            assert_eq!(text.parse(), Ok(Size(bytes)), "{text}");
        }
        let wrong = "/G/8X/8 parsecs/-1G/nan/infG/0/1e400/8GB";
        for text in wrong.split('/') {
            assert!(text.parse::<Size>().is_err(), "{text}");
        }
    }

    #[test]
    fn amounts_are_written_in_the_units_they_are_given_in() {
        let written = |text: &str| text.parse::<Size>().unwrap().to_string();
        assert_eq!(written("1.5G"), "1.5 GiB");
        assert_eq!(written("512M"), "512 MiB");
        assert_eq!(Size(1e20).to_string(), "9.3e10 GiB");
    }
}
