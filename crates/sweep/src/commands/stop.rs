//! Ctrl-C and SIGTERM: every command ends within a second, in any phase.
//! Work in progress has a moment to finish: a run begins no
//! further case, and a file that is being written is finished. Then the program
//! ends. Nothing is lost by that, for a file is there whole or not at all, and a
//! case that is done is in the log. A second signal ends the program at once.

use std::process::exit;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock};
use std::thread::{self, sleep};
use std::time::Duration;

use anyhow::{Context, Result};
#[cfg(unix)]
use signal_hook::consts::SIGXFSZ;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::status::Status;
use super::terminal::Terminal;

/// How often it is looked whether a signal has come.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// Signals within this time of the first count as the same: `timeout`, for one,
/// sends them to the process and to its group.
const SAME_SIGNAL: Duration = Duration::from_millis(100);

/// Work in progress may continue for this long.
const GRACE: Duration = Duration::from_millis(300);

/// The last work and messages may take this long. They take longer only where the output is not
/// read, or a disk does not answer.
const FAREWELL: Duration = Duration::from_millis(400);

/// The exit code that a signal asked for; 0 before.
static ASKED: OnceLock<Arc<AtomicUsize>> = OnceLock::new();

/// What is done before the program ends.
type Farewell = Box<dyn Fn() + Send>;

static BEFORE_END: Mutex<Option<Farewell>> = Mutex::new(None);

/// Listens to signals from now on. A command that is stopped before it says otherwise
/// ([`before_end`]) has kept nothing.
///
/// # Errors
/// Where the system does not let it.
pub fn listen(terminal: Terminal) -> Result<()> {
    before_end(move || tell_unfinished(terminal));
    let code = ASKED.get_or_init(Arc::default);
    let is_second = Arc::new(AtomicBool::new(false));
    let listen = || -> std::io::Result<()> {
        // Where a file may not grow any more, writing it fails with a reason instead.
        #[cfg(unix)]
        flag::register(SIGXFSZ, Arc::default())?;
        for (signal, status) in [(SIGINT, Status::Interrupted), (SIGTERM, Status::Terminated)] {
            flag::register_conditional_shutdown(signal, status as i32, Arc::clone(&is_second))?;
            flag::register_usize(signal, Arc::clone(code), status as usize)?;
        }
        thread::Builder::new().spawn(move || {
            let status = loop {
                sleep(BETWEEN_LOOKS);
                if let Some(status) = asked() {
                    break status;
                }
            };
            sleep(SAME_SIGNAL);
            is_second.store(true, Ordering::Relaxed);
            sleep(GRACE);
            end(status);
        })?;
        Ok(())
    };
    listen().context("signals cannot be listened to")
}

/// How the program is to end, once it was asked to.
pub fn asked() -> Option<Status> {
    let code = ASKED.get()?.load(Ordering::Relaxed);
    [Status::Interrupted, Status::Terminated]
        .into_iter()
        .find(|status| *status as usize == code)
}

/// From now on, this is done before a signal ends the program: it tells what is
/// kept, or that nothing is ([`tell_unfinished`]).
pub fn before_end(farewell: impl Fn() + Send + 'static) {
    if let Ok(mut before_end) = BEFORE_END.lock() {
        *before_end = Some(Box::new(farewell));
    }
}

/// Says of a command that keeps nothing that it was stopped.
pub fn tell_unfinished(terminal: Terminal) {
    terminal.complain("stopped: not finished; give the same command again");
}

/// Ends the program as a signal asked for. The farewell is said once, by whichever thread is first.
pub fn end(status: Status) -> ! {
    // A separate thread, for it may never end.
    let _ = thread::Builder::new().spawn(move || {
        if let Ok(before_end) = BEFORE_END.lock() {
            before_end.as_deref().inspect(|farewell| farewell());
        }
        exit(status as i32);
    });
    sleep(FAREWELL);
    exit(status as i32)
}
