use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;

use sim::{Ended, TorsionRegime};

use std::cell::Cell;
use std::path::PathBuf;

use super::*;
use campaign::engine::Shard;
use campaign::records::Failure;

const CASES: usize = 40;
const METHODS: usize = 2;

fn record(pair: usize) -> Record {
    let (case, method) = (pair / METHODS, pair % METHODS);
    // Numbers whose last bits count.
    let number = f64::sqrt(pair as f64);
    if pair % 7 == 0 {
        let reason = Failure::new(format!("because\tof {pair}\n"));
        return Record::failed(case, method, vec![number], reason);
    }
    let mut outcome = serde_json::json!({
        "simulated": number,
        "ended": Ended::Settled,
        "predicted": TorsionRegime::Stuck,
        "torsion": {
            "regime": TorsionRegime::ALL[pair % 3],
            "first_slip": (pair % 2 == 0).then_some(number / 3.0),
            "sticks": pair,
            "peak_speed": number / 7e20,
            "closing_speed": -0.0,
            "severity": (pair % 5 == 0).then_some(number / 11.0),
        },
    });
    if pair % 6 == 0 {
        outcome["string_torque"] = serde_json::json!({
            "peak_torque": number / 23.0,
            "from_bit": number,
        });
    }
    if pair % 3 == 0 {
        outcome["surface"] = serde_json::json!({
            "peak_torque": number,
            "least_torque": -number / 9.0,
            "mean_torque": 0.0,
            "greatest_torque": number / 13.0,
        });
    }
    Record {
        torque_dynamic_nm: Some(1.0 / (1.0 + number)),
        above_limit: (pair % 4 == 0).then_some(number / 19.0),
        misfits: vec![Some(number / 17.0), None],
        outcome: Ok(serde_json::from_value(outcome).unwrap()),
        ..Record::failed(case, method, vec![1e300 * number], Failure::new(""))
    }
}

fn header() -> Header {
    Header::new(
        "sweep 0.1.0".to_owned(),
        Shard::WHOLE,
        serde_json::json!({ "time_s": 1.0 }),
    )
}

/// A log with records in its own order, and its bytes.
fn written(folder: &Path) -> (PathBuf, Vec<u8>) {
    let path = folder.join("log");
    Log::begin(&path, &header()).unwrap();
    let log = Log::open(&path, CASES, METHODS).unwrap();
    for index in 0..CASES * METHODS {
        log.append(&record(index * 37 % (CASES * METHODS))).unwrap();
    }
    drop(log);
    let bytes = std::fs::read(&path).unwrap();
    (path, bytes)
}

#[test]
fn what_was_appended_is_read_in_the_order_of_cases() {
    let folder = tempfile::tempdir().unwrap();
    let (path, _) = written(folder.path());
    assert_eq!(read_header(&path).unwrap(), Some(header()));
    let log = Log::open(&path, CASES, METHODS).unwrap();
    assert_eq!(log.counts().done, CASES * METHODS);
    assert_eq!(log.counts().failed, (CASES * METHODS).div_ceil(7));
    let mut pair = 0;
    log.in_order(|records| {
        for found in records {
            assert_eq!(*found, record(pair));
            pair += 1;
        }
        Ok(())
    })
    .unwrap();
    assert_eq!(pair, CASES * METHODS);
}

#[test]
fn only_a_log_or_the_beginning_of_its_own_header_may_be_in_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log");
    let place = || log_place(&path, &header());
    assert_eq!(place().unwrap(), Place::Free);
    Log::begin(&path, &header()).unwrap();
    let whole = std::fs::read(&path).unwrap();
    assert_eq!(place().unwrap(), Place::Log(Box::new(header())));
    for cut in [0, 1, 8, 9, 20, whole.len() - 1] {
        std::fs::write(&path, &whole[..cut]).unwrap();
        assert_eq!(place().unwrap(), Place::Torn, "{cut}");
    }
    let torn = &b"0badc0de\tsweep-log\t{\"format\":1"[..];
    for content in [&b"mine"[..], b"mine\n", b"\n", &[0; 700], torn] {
        std::fs::write(&path, content).unwrap();
        assert!(matches!(place(), Err(LogError::NotALog(_))), "{content:?}");
        let opened = Log::open(&path, CASES, METHODS);
        assert!(matches!(opened, Err(LogError::NotALog(_))), "{content:?}");
        assert_eq!(std::fs::read(&path).unwrap(), content);
    }
}

/// What may happen to the bytes of a file, from a place on.
#[derive(Debug, Clone)]
enum Damage {
    /// A number of bytes are replaced by others.
    Replace(usize, Vec<u8>),
    /// A number of bytes are repeated.
    Repeat(usize),
}

fn damage() -> impl Strategy<Value = (Index, Damage)> {
    let bytes = |most: usize| vec(any::<u8>(), 0..most);
    let what = prop_oneof![
        vec(any::<u8>(), 1).prop_map(|byte| Damage::Replace(1, byte)),
        (0..200usize).prop_map(|count| Damage::Replace(count, Vec::new())),
        bytes(20).prop_map(|bytes| Damage::Replace(0, bytes)),
        (0..400usize).prop_map(Damage::Repeat),
    ];
    (any::<Index>(), what)
}

fn apply(bytes: &mut Vec<u8>, at: &Index, damage: &Damage) {
    let at = at.index(bytes.len() + 1);
    let (Damage::Replace(count, _) | Damage::Repeat(count)) = damage;
    let range = at..(at + count).min(bytes.len());
    match damage {
        Damage::Replace(_, new) => drop(bytes.splice(range, new.iter().copied())),
        Damage::Repeat(_) => {
            let again = bytes[range].to_vec();
            bytes.splice(at..at, again);
        }
    }
}

/// Thousands of damaged logs: never a panic, never a record that was not written, and
/// never fewer of them than whole lines.
#[test]
fn a_damaged_log_gives_only_what_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let (path, whole) = written(folder.path());
    let lines: std::collections::HashSet<&[u8]> =
        whole.split_inclusive(|&byte| byte == b'\n').collect();
    let config = ProptestConfig {
        cases: 5_000,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    // How many are whole, have all records in spite of damage, have lost some, have broken
    // lines, and have no header.
    let seen = [const { Cell::new(0) }; 5];
    let see = |kind: usize, is_so: bool| seen[kind].set(seen[kind].get() + usize::from(is_so));
    let damages = vec(damage(), 0..6);
    proptest!(config, |(damages in damages)| {
        let mut bytes = whole.clone();
        for (at, damage) in &damages {
            apply(&mut bytes, at, damage);
        }
        std::fs::write(&path, &bytes).unwrap();
        let has_header = read_header(&path).unwrap().is_some();
        match LogView::open(&path, CASES, METHODS) {
            Ok(content) => {
                let records: std::collections::HashSet<(usize, usize)> = bytes
                    .split_inclusive(|&byte| byte == b'\n')
                    .filter(|line| lines.contains(line))
                    .filter_map(line::parse_record)
                    .map(|record| (record.case, record.method))
                    .collect();
                let expected = if has_header { records.len() } else { 0 };
                prop_assert_eq!(content.counts.done, expected);
                prop_assert!(content.end <= bytes.len() as u64);
                let has_all = records.len() == CASES * METHODS;
                see(0, bytes == whole);
                see(1, bytes != whole && has_all);
                see(2, !has_all);
                see(3, content.counts.broken_lines > 0);
            }
            Err(error) => {
                see(4, true);
                prop_assert!(!has_header, "{}", error);
            }
        }
    });
    let seen = seen.map(Cell::into_inner);
    // The rarest is seen fifty times, give or take seven.
    assert!(seen.iter().all(|&count| count >= 10), "{seen:?}");
}

/// Motions by name are fields next to the rest of an outcome, as in earlier versions.
#[test]
fn a_record_of_an_earlier_version_is_read() {
    let json = r#"{"case":3,"method":0,"values":[1.5],"torque_dynamic_nm":900.0,"site_from_bit_m":50.0,
        "outcome":{"Ok":{"simulated":9.5,"ended":"end","torsion":{"regime":"smooth","first_slip":1.0,
        "period":null,"slip_time":null,"sticks":0,"peak_speed":9.0,"closing_speed":6.0},
        "lateral":{"regime":"backward_whirl","site":1,"first_contact":0.5,"peak_radius":0.02,
        "contact_fraction":1.0,"rolling_fraction":0.25,"precession_rate":-3.0,"mean_radius":0.01,
        "mean_normal_force":50.0,"ambiguous_steps":2}}}}"#;
    let record: Record = serde_json::from_str(json).unwrap();
    let outcome = record.outcome.as_ref().unwrap();
    assert_eq!(outcome.torsion().unwrap().peak_speed, 9.0);
    assert_eq!(outcome.lateral().unwrap().precession_rate, -3.0);
    let written = serde_json::to_value(&record).unwrap();
    assert_eq!(
        written,
        serde_json::from_str::<serde_json::Value>(json).unwrap()
    );
}
