//! Choosing for an accuracy, which may take minutes: reports what is tried, and at the end what it
//! took.

use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::Result;
use indicatif::ProgressBar;
use serde_json::json;

use super::cost::in_words;
use super::progress::{BETWEEN_EVENTS, BETWEEN_LINES, Display, moving};
use super::stop;
use super::terminal::Terminal;
use campaign::Campaign;
use campaign::accuracy::{Attempt, Expected, SearchProgress};
use campaign::memory::Limit;
use campaign::plan::Candidate;
use campaign::words::short;

/// An attempt that is expected to take longer than this, s, is announced.
const LONG: f64 = 5.0;

/// The campaign or, where its sweep asks for an accuracy, that with what is chosen for it; tells
/// of that unless `quiet`.
///
/// # Errors
/// As [`Campaign::choose`].
pub fn choose(
    campaign: Campaign,
    full: bool,
    limit: &Limit,
    quiet: bool,
    terminal: Terminal,
) -> Result<Campaign> {
    if campaign.sweep.content.accuracy.is_none() {
        return Ok(campaign);
    }
    let choosing = Choosing::new(quiet, terminal);
    let (under_way, over) = channel::<()>();
    let chosen = thread::scope(|scope| {
        let shown = &choosing;
        scope.spawn(move || {
            while over.recv_timeout(shown.pause()) == Err(RecvTimeoutError::Timeout) {
                shown.tell();
            }
        });
        let chosen = campaign.choose(full, limit, &|progress| match progress {
            SearchProgress::Expected(expected) => choosing.expect(&expected),
            SearchProgress::Attempt(attempt) => choosing.begin(attempt),
        });
        drop(under_way);
        chosen
    });
    let choice = (chosen.as_ref().ok()).and_then(|chosen| chosen.sweep.choice.as_ref());
    choosing.finish(choice.map(|choice| &choice.chosen));
    Ok(chosen?)
}

/// A choice under way.
struct Choosing {
    start: Instant,
    attempt: Mutex<Option<Attempt>>,
    display: Display,
    terminal: Terminal,
}

impl Choosing {
    fn new(quiet: bool, terminal: Terminal) -> Self {
        Self {
            start: Instant::now(),
            attempt: Mutex::new(None),
            display: Display::of(terminal, quiet, || spinner(terminal)),
            terminal,
        }
    }

    /// Says how long it will take.
    fn expect(&self, expected: &Expected) {
        let frequency = short(expected.reference_hz);
        let line = format!(
            "accuracy: choosing takes {} from here on, if the reference at {frequency} Hz \
             is certain enough",
            in_words(expected.seconds)
        );
        match &self.display {
            Display::Nothing => {}
            Display::Bar(spinner) => spinner.suspend(|| self.terminal.complain(&line)),
            Display::Lines => self.terminal.complain(&line),
            Display::Events => self.terminal.tell(&json!({
                "event": "forecast",
                "expected_seconds": expected.seconds,
                "reference_hz": expected.reference_hz,
                "seconds": self.start.elapsed().as_secs_f64(),
            })),
        }
    }

    fn begin(&self, attempt: Attempt) {
        let is_long = attempt.seconds.is_some_and(|seconds| seconds > LONG);
        if let Ok(mut current) = self.attempt.lock() {
            *current = Some(attempt);
        }
        if is_long || matches!(self.display, Display::Bar(_)) {
            self.tell();
        }
    }

    /// Time between two words.
    fn pause(&self) -> Duration {
        match self.display {
            Display::Events | Display::Bar(_) => BETWEEN_EVENTS,
            Display::Lines | Display::Nothing => BETWEEN_LINES,
        }
    }

    /// Says what is being tried, and what it took so far.
    fn tell(&self) {
        let attempt = self.attempt.lock().ok().and_then(|current| current.clone());
        let Some(attempt) = attempt else {
            return;
        };
        let line = || {
            let by = if attempt.is_reference {
                "reference by "
            } else {
                ""
            };
            let long = attempt.seconds.filter(|seconds| *seconds > 1.0);
            let long = long.map_or_else(String::new, |seconds| format!(" (about {seconds:.0} s)"));
            format!(
                "accuracy: {} so far; {by}{}{long}",
                self.cost(", "),
                attempt.candidate
            )
        };
        match &self.display {
            Display::Nothing => {}
            Display::Bar(spinner) => spinner.set_message(line()),
            Display::Lines => self.terminal.complain(&line()),
            Display::Events => self.terminal.tell(&json!({
                "event": "choosing",
                "candidate": attempt.candidate,
                "is_reference": attempt.is_reference,
                "expected_seconds": attempt.seconds,
                "seconds": self.start.elapsed().as_secs_f64(),
                "memory_bytes": peak_memory(),
            })),
        }
    }

    /// The choice is made, or there is none.
    fn finish(&self, chosen: Option<&Candidate>) {
        if let Display::Bar(spinner) = &self.display {
            spinner.finish_and_clear();
        }
        let Some(chosen) = chosen else {
            return;
        };
        match self.display {
            Display::Nothing => {}
            Display::Bar(_) | Display::Lines => self.terminal.complain(&format!(
                "accuracy: {chosen}, chosen in {}",
                self.cost(" with ")
            )),
            Display::Events => self.terminal.tell(&json!({
                "event": "chosen",
                "candidate": chosen,
                "seconds": self.start.elapsed().as_secs_f64(),
                "memory_bytes": peak_memory(),
            })),
        }
    }

    /// What it took so far.
    fn cost(&self, and: &str) -> String {
        let seconds = self.start.elapsed().as_secs_f64();
        let memory = peak_memory().map_or_else(String::new, |bytes| {
            let megabytes = bytes as f64 / 1e6;
            if megabytes < 1e3 {
                format!("{and}{megabytes:.0} MB")
            } else {
                format!("{and}{:.1} GB", megabytes / 1e3)
            }
        });
        format!("{seconds:.1} s{memory}")
    }
}

fn spinner(terminal: Terminal) -> ProgressBar {
    let spinner = moving(ProgressBar::new_spinner(), "{spinner} {wide_msg}");
    let shown = spinner.clone();
    stop::before_end(move || {
        shown.finish_and_clear();
        stop::tell_unfinished(terminal);
    });
    spinner
}

/// The most memory that this program has had so far, in bytes, where the system
/// says it.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = (status.lines()).find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kilobytes)
}
