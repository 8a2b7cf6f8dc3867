//! Ctrl-C and SIGTERM: no further case is begun, what is done is kept. A second
//! one ends the program at once.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::Status;

/// Whether the program was asked to stop.
pub struct Stop {
    interrupted: Arc<AtomicBool>,
    terminated: Arc<AtomicBool>,
}

impl Stop {
    /// Listens from now on.
    ///
    /// # Errors
    /// Where the system does not let it.
    pub fn listen() -> Result<Self> {
        let listen = |signal, status: Status| -> std::io::Result<Arc<AtomicBool>> {
            let asked = Arc::new(AtomicBool::new(false));
            // In this order: the first signal finds the flag still down.
            flag::register_conditional_shutdown(signal, status as i32, Arc::clone(&asked))?;
            flag::register(signal, Arc::clone(&asked))?;
            Ok(asked)
        };
        let failed = "signals cannot be listened to";
        Ok(Self {
            interrupted: listen(SIGINT, Status::Interrupted).context(failed)?,
            terminated: listen(SIGTERM, Status::Terminated).context(failed)?,
        })
    }

    /// How the program is to end, once it was asked to.
    pub fn status(&self) -> Option<Status> {
        if self.terminated.load(Ordering::Relaxed) {
            Some(Status::Terminated)
        } else if self.interrupted.load(Ordering::Relaxed) {
            Some(Status::Interrupted)
        } else {
            None
        }
    }
}
