//! Work in threads of Rust, while the thread that asked for it looks for Ctrl-C; calls of functions
//! of Python, in which that thread may end.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors::refused;

/// Time between two looks at signals and progress.
const BETWEEN_LOOKS: Duration = Duration::from_millis(100);

/// Does some work with the interpreter free for others, and calls `look` ten times a second. Where
/// that or a signal raises, the result of the work is dropped: its thread ends when the work does.
///
/// # Errors
/// What a look or a signal raises.
pub fn watch<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
    look: &dyn Fn() -> PyResult<()>,
) -> PyResult<T> {
    let (done, mut result) = channel();
    thread::Builder::new()
        .name("drillstring".to_owned())
        .spawn(move || done.send(work()))?;
    loop {
        let received;
        // A channel's end is not to be shared, but moves to and fro.
        (received, result) = py.detach(move || (result.recv_timeout(BETWEEN_LOOKS), result));
        match received {
            Ok(made) => {
                look()?;
                return Ok(made);
            }
            Err(RecvTimeoutError::Disconnected) => return Err(refused("the work panicked")),
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals()?;
                look()?;
            }
        }
    }
}

/// The same of work without `look`.
///
/// # Errors
/// What a signal raises.
pub fn wait_for<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    watch(py, work, &|| Ok(()))
}

/// Calls a function of Python. Before 3.14 an interpreter that exits ends its daemon threads where
/// they are, in such a function, too, by an unwinding that no Rust may catch (glibc then aborts). It
/// ends here: the thread sleeps until the process has ended, as PyO3 has it where a thread waits
/// for the interpreter.
pub fn call_python<T>(function: impl FnOnce() -> T) -> T {
    let guard = SleepsForEver;
    let answer = function();
    std::mem::forget(guard);
    answer
}

/// Sleeps where it is dropped, but for a panic, which is caught further on.
struct SleepsForEver;

impl Drop for SleepsForEver {
    fn drop(&mut self) {
        while !thread::panicking() {
            thread::park();
        }
    }
}
