//! What a step of a plain scene costs: no allocation, and, where valgrind counts them, as many instructions
//! as it did. A separate program, for its allocator counts all threads.

mod scenes;

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use peak_alloc::PeakAlloc;
use scenes::SCENES;
use sim::Stepper;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Steps of a case, beyond which what it has does not grow.
const STEPS: [usize; 2] = [512, 1536];

/// Instructions of a step of each scene, and of what they were counted with.
const COUNTED: &str = "tests/steps/instructions.csv";

/// How much they may differ by, as a part.
const TOLERANCE: f64 = 0.03;

/// Names the scene that is stepped, and the number of steps, where valgrind counts.
const SCENE: &str = "STEPS_OF_SCENE";

/// One step in this number may: buffers that grow, and scratch that a thread keeps.
const MAY_ALLOCATE: usize = 100;

#[test]
fn a_step_allocates_nothing() {
    let mut report = String::new();
    for (name, make) in SCENES {
        let (system, scene) = make();
        let mut stepper = Stepper::new(&system, &scene).unwrap();
        let mut allocating = 0;
        while stepper.next_step() < stepper.steps() {
            ALLOCATOR.reset_peak_usage();
            let before = ALLOCATOR.current_usage();
            stepper.step().unwrap();
            allocating += usize::from(ALLOCATOR.peak_usage() != before);
        }
        if allocating * MAY_ALLOCATE > stepper.steps() {
            writeln!(report, "{name}: {allocating} of {}", stepper.steps()).unwrap();
        }
    }
    assert!(report.is_empty(), "steps that allocate:\n{report}");
}

/// Steps a scene for valgrind, which runs this test of this program alone.
#[test]
#[ignore = "needs valgrind"]
fn steps_of_one_scene() {
    let Ok(asked) = std::env::var(SCENE) else {
        return;
    };
    let (name, steps) = asked.split_once(' ').unwrap();
    let (_, make) = SCENES.iter().find(|(scene, _)| *scene == name).unwrap();
    let (system, scene) = make();
    let mut stepper = Stepper::new(&system, &scene).unwrap();
    for _ in 0..steps.parse().unwrap() {
        stepper.step().unwrap().unwrap();
    }
}

/// Instructions of this program that steps a scene.
fn instructions(scene: &str, steps: usize) -> f64 {
    let counted = Command::new("valgrind")
        .args([
            "--tool=cachegrind",
            "--cache-sim=no",
            "--cachegrind-out-file=/dev/null",
        ])
        .arg(std::env::current_exe().unwrap())
        .args([
            "--ignored",
            "--exact",
            "steps_of_one_scene",
            "--test-threads=1",
        ])
        .env(SCENE, format!("{scene} {steps}"))
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&counted.stderr);
    assert!(counted.status.success(), "{text}");
    let line = text.lines().find(|line| line.contains("refs:")).unwrap();
    let number = line.rsplit(' ').next().unwrap().replace(',', "");
    number.parse().unwrap()
}

/// The compiler and the processor, on which instructions depend.
fn counted_with() -> String {
    let version = Command::new("rustc").arg("--version").output().unwrap();
    let version = String::from_utf8(version.stdout).unwrap();
    #[cfg(target_arch = "x86_64")]
    let wide = std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    let wide = false;
    let processor = if wide {
        "x86-64 with AVX2"
    } else {
        "another processor"
    };
    format!("{} {processor}", version.trim())
}

/// `UPDATE_INSTRUCTIONS=1` writes what is counted, where a step is to cost what it now does.
#[test]
#[ignore = "needs valgrind"]
fn a_step_takes_as_many_instructions_as_it_did() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(COUNTED);
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    let (with, rows) = known.split_once('\n').unwrap_or_default();
    let (here, mut found, mut report) = (counted_with(), String::new(), String::new());
    for (name, _) in SCENES {
        let [few, many] = STEPS.map(|steps| instructions(name, steps));
        let per_step = (many - few) / (STEPS[1] - STEPS[0]) as f64;
        writeln!(found, "{name},{per_step:.0}").unwrap();
        let row = rows
            .lines()
            .find_map(|row| row.strip_prefix(name)?.strip_prefix(','));
        let Some(before) = row.and_then(|row| row.parse::<f64>().ok()) else {
            writeln!(report, "{name}: {per_step:.0}, not counted before").unwrap();
            continue;
        };
        println!("{name}: {per_step:.0}, {before} before");
        if (per_step / before - 1.0).abs() > TOLERANCE {
            writeln!(report, "{name}: {per_step:.0} instead of {before}").unwrap();
        }
    }
    if std::env::var_os("UPDATE_INSTRUCTIONS").is_some() {
        std::fs::write(&path, format!("{here}\n{found}")).unwrap();
    } else if with == here {
        assert!(report.is_empty(), "instructions of a step:\n{report}");
    } else {
        println!("NOT COMPARED: {with:?} counted them, and this is {here:?}\n{report}");
    }
}
