//! A signal ends every command soon, in any phase: building, choosing for an
//! accuracy, a long case, a study.

use std::io::{BufRead, BufReader};
use std::process::Child;
use std::sync::mpsc::channel;
use std::thread::{sleep, spawn};
use std::time::Duration;

use crate::interruption::signals::signal;
use crate::soon::{ends_soon, start};
use crate::support::{SMALL, Workplace, with};

/// A file whose one method takes most of a minute to build on two cores: each of thousands of
/// parts is another one.
fn slow_to_build() -> String {
    let text = with(SMALL, "frequency_hz = 100", "frequency_hz = 100000");
    let part = |number: usize| {
        let outer = 0.1 + 1e-5 * number as f64;
        format!(
            "[[string.sections]]\nname = \"part {number}\"\nrepeat = 1\n\
             parts = [{{ length_m = 0.5, inner_radius_m = 0.05, outer_radius_m = {outer:.5} }}]\n\n"
        )
    };
    let parts: String = (0..4000).map(part).collect();
    with(&text, "[bit]", &format!("{parts}[bit]"))
}

/// A file that asks for more than a minute's choosing.
fn slow_to_choose() -> String {
    let sweeps = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps");
    format!("base = \"{sweeps}/fig17.toml\"\naccuracy = \"1 %\"\n")
}

#[track_caller]
fn was_stopped(child: Child, code: i32) -> String {
    let answer = ends_soon(child);
    assert_eq!(answer.code, code, "{answer:?}");
    assert_eq!(answer.output, "");
    let last = answer.errors.lines().last().unwrap_or_default();
    assert!(last.contains("stopped: "), "{answer:?}");
    answer.errors
}

#[test]
fn every_command_is_stopped_by_a_signal() {
    let place = Workplace::with_small(&slow_to_build());
    place.write(
        "labels.csv",
        "case,method,surface_speed_rpm,weight_on_bit_kn,torsion\n\
         0,quadrature,0.3,30,smooth\n",
    );
    place.write("asks.toml", slow_to_choose());
    let commands = [
        &["run", "small.toml"][..],
        &["simulate", "small.toml"],
        &["inspect", "small.toml"],
        &["check", "small.toml", "labels.csv"],
        &["run", "asks.toml", "--dry-run"],
        &["study", "tradeoff"],
        &["study", "stability"],
        &["study", "contacts"],
    ];
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let children = commands.map(|arguments| start(&place, arguments));
        // All of them listen by then, and none is nearly done.
        sleep(Duration::from_millis(1500));
        for child in &children {
            signal(child, name);
        }
        for child in children {
            was_stopped(child, code);
        }
    }
}

#[test]
fn a_long_case_holds_no_signal_up_and_is_run_again() {
    let place = Workplace::with_small(&with(SMALL, "time_s = 12", "time_s = 500000"));
    let run = [
        "run",
        "small.toml",
        "--full",
        "--out",
        "long",
        "--jobs",
        "1",
    ];
    let child = start(&place, &run);
    while !place.path("long/cases.log").exists() {
        sleep(Duration::from_millis(5));
    }
    // The first case is under way, and takes seconds.
    sleep(Duration::from_millis(500));
    signal(&child, "TERM");
    let errors = was_stopped(child, 143);
    let meant = "stopped: 0 of 6 simulations are done and kept in long: the same command continues";
    assert!(errors.contains(meant), "{errors}");
    let dry = place.sweep(&[&run[..], &["--dry-run"]].concat());
    assert!(dry.output.contains("6 of 6 simulations left"), "{dry:?}");
}

/// `timeout` sends a signal to the process and to its group.
#[test]
fn a_signal_that_comes_twice_at_once_is_one() {
    let place = Workplace::with_small(&slow_to_build());
    let child = start(&place, &["run", "small.toml"]);
    sleep(Duration::from_millis(1500));
    signal(&child, "TERM");
    signal(&child, "TERM");
    was_stopped(child, 143);
}

#[test]
fn choosing_for_an_accuracy_tells_what_it_tries_and_can_be_stopped() {
    let place = Workplace::new();
    place.write("asks.toml", slow_to_choose());
    let mut child = start(&place, &["run", "asks.toml", "--log", "json"]);
    let errors = BufReader::new(child.stderr.take().unwrap());
    let (send, events) = channel();
    let reader = spawn(move || {
        for line in errors.lines() {
            let event: serde_json::Value = serde_json::from_str(&line.unwrap()).unwrap();
            // The receiver takes only the first.
            let _ = send.send(event);
        }
    });
    let forecast = events.recv_timeout(Duration::from_secs(60));
    let event = events.recv_timeout(Duration::from_secs(60));
    signal(&child, "TERM");
    assert_eq!(ends_soon(child).code, 143);
    reader.join().unwrap();
    let (forecast, event) = (forecast.unwrap(), event.unwrap());
    assert_eq!(forecast["event"], "forecast");
    let expected = forecast["expected_seconds"].as_f64();
    assert!(expected > Some(0.0), "{forecast}");
    assert_eq!(event["event"], "choosing");
    assert!(event["candidate"]["method"].is_string(), "{event}");
    assert!(event["seconds"].as_f64() > Some(0.0), "{event}");
    if cfg!(target_os = "linux") {
        assert!(event["memory_bytes"].as_u64() > Some(0), "{event}");
    }
}
