//! Labels of strings that lie, by the poles of the string, held to those of `held` at twice the sampling
//! frequency, on random strings.

use std::path::Path;

use campaign::engine::{Case, Recipe, RunOptions, answer};
use campaign::plan::Sweep;
use linear::Method;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use sim::{Label, Motion};

/// The seed, or `SEED`: one that no rule was made with.
fn seed() -> u64 {
    std::env::var("SEED").map_or(2026, |text| text.parse().unwrap())
}

fn strings(by_default: usize) -> usize {
    let asked = std::env::var("STRINGS").ok();
    asked.map_or(by_default, |count| count.parse().unwrap())
}

prop_compose! {
    /// Jointed pipe above jointed collars that lie in an inclined hole in mud, turned from rest or hit at the
    /// bit: from 12 sites on.
    fn lying()(
        collars in 3_usize..7,
        pipes in 3_usize..5,
        radius in 0.07..0.11,
        clearance in 0.008..0.03,
        inclination in 25.0..90.0,
        friction in 0.1..1.5,
        speed in 40.0..200.0,
        impulse in prop_oneof![Just(0.0), 100.0..6000.0],
        viscosity in 1.0..40.0,
    ) -> String {
        let joint = radius + 0.008;
        let hole = joint + clearance;
        let hit = match impulse {
            0.0 => String::new(),
            amount => format!("[[impulses]]\ndistance_from_bit_m = 0\namount_ns = {amount}\nduration_s = 0.02\n"),
        };
        format!(
            "surface_speed_rpm = {speed}\ntime_s = 5\n[string]\n\
             shear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\ntorsional_damping_nms_rad_m = 1\n\
             bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = 20 }}\nloss_factor = 0.001\n\
             [[string.sections]]\nrepeat = {pipes}\nparts = [\n\
             {{ length_m = 9, inner_radius_m = 0.05, outer_radius_m = 0.0635 }},\n\
             {{ length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.084 }},\n]\n\
             [[string.sections]]\nrepeat = {collars}\nparts = [\n\
             {{ length_m = 9, inner_radius_m = 0.036, outer_radius_m = {radius} }},\n\
             {{ length_m = 0.6, inner_radius_m = 0.036, outer_radius_m = {joint} }},\n]\n\
             [mud]\ndensity_kg_m3 = 1200\nviscosity_cp = {viscosity}\n\
             [well]\nhole_radius_m = {hole}\ninclination_deg = {inclination}\n\
             [wall]\nclearance = \"hole\"\nfriction = {friction}\nsites = \"ends\"\n{hit}"
        )
    }
}

fn sweep(text: &str) -> Sweep {
    let name = Path::new("case.toml");
    let read = Sweep::read_from(name, &[], &|_, _| Ok(text.to_owned()));
    read.and_then(Sweep::for_run)
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// `STRINGS=30` of the seed 7701 and 33 of 7702 for what the guide says; here is one.
#[test]
fn val_labels_by_poles_are_those_of_held_at_twice_the_frequency() {
    let bytes: Vec<u8> = seed().to_le_bytes().repeat(4);
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let (mut wrong, mut failed, mut lasting, mut count) = ([0; 2], [0; 3], 0, 0);
    for number in 0..strings(1) {
        let text = lying().new_tree(&mut runner).unwrap().current();
        let sweep = sweep(&text);
        let frequency = sweep.setting.frequency_by(&Method::Held);
        let label = |method: Method, frequency: f64| -> Result<Label, String> {
            let setting = sweep.setting.sampled_at(frequency);
            let case = Case::of(&sweep, &setting, 0).unwrap();
            let time = case.scene.timing.duration;
            let recipe = Recipe::of(&sweep, &setting, method, time).for_labels();
            let system = recipe.build().map_err(|error| format!("{error:#}"))?;
            let record = answer(&system, &case, 0, RunOptions::default(), &sweep);
            let outcome = record.outcome.map_err(|error| error.to_string())?;
            Ok(outcome.labels()[Motion::Lateral].unwrap())
        };
        let truth = label(Method::Held, 2.0 * frequency);
        let both = [
            label(Method::Poles, frequency),
            label(Method::Held, frequency),
        ];
        if both.iter().any(|it| *it != truth) {
            let sites = sweep.setting.sites.len();
            println!("string {number} of {sites} sites: {both:?}, {truth:?}\n{text}");
        }
        for (failed, label) in failed.iter_mut().zip(both.iter().chain([&truth])) {
            *failed += usize::from(label.is_err());
        }
        let ([Ok(poles), Ok(held)], Ok(truth)) = (both, truth) else {
            continue;
        };
        count += 1;
        lasting += usize::from(truth.is_sustained() == Some(true));
        for (wrong, label) in wrong.iter_mut().zip([poles, held]) {
            *wrong += usize::from(label != truth);
        }
        let [by_poles, by_held] = wrong;
        println!(
            "{count} strings, {lasting} whirl: other labels by poles {by_poles}, by held {by_held}; \
             no label by poles, held, held at twice the frequency: {failed:?}"
        );
    }
    assert!(count > 0 && 10 * wrong[0] <= count, "{wrong:?} of {count}");
    assert!(failed[0] <= failed[1], "{failed:?}");
}
