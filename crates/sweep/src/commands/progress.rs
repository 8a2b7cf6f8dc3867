//! How far a run is: a bar on a terminal, a line now and then elsewhere.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Time between lines where there is no terminal.
const BETWEEN_LINES: Duration = Duration::from_secs(10);

/// Counts what is done and shows it on the error stream.
pub enum Progress {
    /// Shows nothing.
    Quiet,
    /// A bar.
    Bar(ProgressBar),
    /// Lines.
    Lines(Lines),
}

/// Progress in lines.
pub struct Lines {
    total: usize,
    done: AtomicUsize,
    start: Instant,
    last: Mutex<Instant>,
}

impl Progress {
    /// Progress towards `total` simulations.
    pub fn new(total: usize, quiet: bool) -> Self {
        if quiet {
            Progress::Quiet
        } else if std::io::stderr().is_terminal() {
            Progress::Bar(bar(total))
        } else {
            let now = Instant::now();
            Progress::Lines(Lines {
                total,
                done: AtomicUsize::new(0),
                start: now,
                last: Mutex::new(now),
            })
        }
    }

    /// One more is done.
    pub fn tick(&self) {
        match self {
            Progress::Quiet => {}
            Progress::Bar(bar) => bar.inc(1),
            Progress::Lines(lines) => lines.tick(),
        }
    }

    /// All is done: the bar goes.
    pub fn finish(&self) {
        if let Progress::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

impl Lines {
    fn tick(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        // A thread that finds another one writing has nothing to add.
        let Ok(mut last) = self.last.try_lock() else {
            return;
        };
        if last.elapsed() >= BETWEEN_LINES {
            *last = Instant::now();
            let seconds = self.start.elapsed().as_secs_f64();
            let left = seconds / done as f64 * (self.total - done) as f64;
            super::complain(&format!(
                "{done} of {} simulations done, about {left:.0} s left",
                self.total
            ));
        }
    }
}

fn bar(total: usize) -> ProgressBar {
    let bar = ProgressBar::new(total as u64);
    let template = "{wide_bar} {pos}/{len} simulations, {eta} left";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
