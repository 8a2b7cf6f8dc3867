//! Programs that end soon, by themselves or by a signal.

use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::support::{Answer, Workplace};

/// Nothing that is waited for takes nearly as long, unless it hangs or is not
/// stopped.
const DEADLINE: Duration = Duration::from_secs(30);

/// The binary at work; what it says is kept.
pub fn start(place: &Workplace, arguments: &[&str]) -> Child {
    let mut command = place.command(arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

/// What a program answers that says little.
#[track_caller]
pub fn ends_soon(mut child: Child) -> Answer {
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > DEADLINE {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("it does not end");
        }
        sleep(Duration::from_millis(5));
    }
    let output = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Answer {
        code: output.status.code().expect("no signal ended it"),
        output: text(output.stdout),
        errors: text(output.stderr),
    }
}
