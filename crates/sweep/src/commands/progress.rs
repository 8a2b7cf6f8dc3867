//! How far a run is: a bar on a terminal, a line now and then elsewhere, or
//! events for programs. The time left counts only what this run does.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use super::stop;
use super::terminal::Terminal;

/// Time between lines where there is no terminal.
pub const BETWEEN_LINES: Duration = Duration::from_secs(10);

/// Time between events.
pub const BETWEEN_EVENTS: Duration = Duration::from_secs(1);

/// Time between pictures of a bar.
const BETWEEN_TICKS: Duration = Duration::from_millis(200);

/// Counts what is done and shows it on the error stream.
pub struct Progress {
    /// Simulations in all, as far as they are known, and those done before this run.
    total: AtomicUsize,
    before: usize,
    done: AtomicUsize,
    start: Instant,
    shown: Mutex<Instant>,
    is_over: AtomicBool,
    display: Display,
    terminal: Terminal,
}

/// How what is under way is shown.
pub enum Display {
    /// Not at all.
    Nothing,
    /// By what moves on a terminal.
    Bar(ProgressBar),
    /// By a line now and then.
    Lines,
    /// By events for programs.
    Events,
}

impl Display {
    /// For programs events; for people nothing if `quiet`, and a bar on a terminal.
    pub fn of(terminal: Terminal, quiet: bool, bar: impl FnOnce() -> ProgressBar) -> Self {
        if terminal.is_json() {
            Display::Events
        } else if quiet {
            Display::Nothing
        } else if std::io::stderr().is_terminal() {
            Display::Bar(bar())
        } else {
            Display::Lines
        }
    }
}

impl Progress {
    /// Of a number of simulations, some done before; not shown to people if `quiet`. A signal ends
    /// it.
    pub fn new(total: usize, before: usize, quiet: bool, terminal: Terminal) -> Arc<Self> {
        let display = Display::of(terminal, quiet, || bar(total, before));
        if let Display::Events = display {
            terminal.tell(&json!({ "event": "start", "total": total, "done": before }));
        }
        let now = Instant::now();
        let progress = Arc::new(Self {
            total: AtomicUsize::new(total),
            before,
            done: AtomicUsize::new(0),
            start: now,
            shown: Mutex::new(now),
            is_over: AtomicBool::new(false),
            display,
            terminal,
        });
        let shown = Arc::clone(&progress);
        stop::before_end(move || {
            shown.finish();
            stop::tell_unfinished(terminal);
        });
        progress
    }

    /// The number to be done in all, as far as is known now.
    pub fn expect(&self, total: usize) {
        self.total.store(total, Ordering::Relaxed);
        if let Display::Bar(bar) = &self.display {
            bar.set_length(total as u64);
        }
    }

    fn total(&self) -> usize {
        self.total.load(Ordering::Relaxed)
    }

    /// One more is done.
    pub fn tick(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        match &self.display {
            Display::Nothing => {}
            Display::Bar(bar) => bar.inc(1),
            Display::Lines => self.now_and_then(BETWEEN_LINES, |left| {
                self.terminal.complain(&format!(
                    "{} of {} simulations done, about {left:.0} s left",
                    self.before + done,
                    self.total()
                ));
            }),
            Display::Events => self.now_and_then(BETWEEN_EVENTS, |left| {
                self.terminal.tell(&json!({
                    "event": "progress",
                    "done": self.before + done,
                    "total": self.total(),
                    "seconds_left": left,
                }));
            }),
        }
    }

    /// Shows something if nothing was shown for a while, with the time left.
    fn now_and_then(&self, pause: Duration, show: impl Fn(f64)) {
        // A thread that finds another one writing has nothing to add.
        let Ok(mut shown) = self.shown.try_lock() else {
            return;
        };
        if shown.elapsed() >= pause {
            *shown = Instant::now();
            let done = self.done.load(Ordering::Relaxed).max(1);
            let left = self.total().saturating_sub(self.before + done);
            show(self.start.elapsed().as_secs_f64() / done as f64 * left as f64);
        }
    }

    /// The run is over: the bar goes.
    pub fn finish(&self) {
        if self.is_over.swap(true, Ordering::Relaxed) {
            return;
        }
        match &self.display {
            Display::Bar(bar) => bar.finish_and_clear(),
            Display::Events => self.terminal.tell(&json!({
                "event": "end",
                "done": self.before + self.done.load(Ordering::Relaxed),
                "total": self.total(),
                "seconds": self.start.elapsed().as_secs_f64(),
            })),
            Display::Nothing | Display::Lines => {}
        }
    }
}

fn bar(total: usize, before: usize) -> ProgressBar {
    let template = "{wide_bar} {pos}/{len} simulations, {eta} left";
    let bar = moving(ProgressBar::new(total as u64), template);
    bar.set_position(before as u64);
    bar.reset_eta();
    bar
}

/// A bar of this looks that moves by itself.
pub fn moving(bar: ProgressBar, template: &str) -> ProgressBar {
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(BETWEEN_TICKS);
    bar
}
