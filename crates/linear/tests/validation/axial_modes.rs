//! Natural frequencies and damping of a string along its axis against closed forms of a uniform rod.

use std::f64::consts::{FRAC_PI_2, PI};

use linear::estimates::torsional_impedance;
use linear::modes::damped_modes_below_drive;
use linear::natural_frequencies::NaturalFrequencies;
use linear::{Axial, Drillstring, Hoist, Material, Section, Tube};

const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};
const YOUNGS_MODULUS: f64 = 210e9;
const LENGTH: f64 = 1500.0;
const PIPE: Tube = Tube {
    length: LENGTH / 3.0,
    inner_radius: 0.054,
    outer_radius: 0.0635,
};

fn rod(hoist: Option<Hoist>) -> Drillstring {
    let sections = vec![Section {
        repeat: 3,
        parts: vec![PIPE],
    }];
    let string = Drillstring::new(STEEL, sections, 0.0).unwrap();
    let axial = Axial {
        youngs_modulus: YOUNGS_MODULUS,
        damping: 0.0,
        hoist,
    };
    axial.rod(&string).unwrap()
}

fn hoist(mass: f64, damping: f64) -> Option<Hoist> {
    Some(Hoist {
        mass,
        damping,
        stiffness: 0.0,
    })
}

/// From one end to the other, s.
fn travel_time() -> f64 {
    LENGTH / (YOUNGS_MODULUS / STEEL.density).sqrt()
}

#[test]
fn val_a_rod_held_above_has_odd_quarter_waves() {
    let natural = NaturalFrequencies::axial(&rod(None)).unwrap();
    assert_eq!(natural.unrestored().unwrap(), 0);
    for (mode, found) in natural.lowest(8).unwrap().into_iter().enumerate() {
        let exact = (2 * mode + 1) as f64 * FRAC_PI_2 / travel_time();
        assert!(
            (found / exact - 1.0).abs() < 1e-9,
            "{mode}: {found} {exact}"
        );
    }
}

#[test]
fn val_a_rod_that_hangs_has_half_waves_and_moves_as_a_whole() {
    let natural = NaturalFrequencies::axial(&rod(hoist(0.0, 2e4))).unwrap();
    assert_eq!(natural.unrestored().unwrap(), 1);
    for (mode, found) in natural.lowest(8).unwrap().into_iter().enumerate() {
        let exact = (mode + 1) as f64 * PI / travel_time();
        assert!(
            (found / exact - 1.0).abs() < 1e-9,
            "{mode}: {found} {exact}"
        );
        let shape = natural.shape(found, 101).unwrap();
        let ends = [shape.amplitudes[0], shape.amplitudes[100]].map(f64::abs);
        assert!(ends.iter().all(|end| (end - 1.0).abs() < 1e-3), "{ends:?}");
    }
}

/// EA k sin kL + m ω² cos kL = 0; a light mass has about half waves, a heavy one quarter waves.
#[test]
fn val_a_mass_above_is_that_of_the_frequency_equation() {
    for mass in [100.0, 2e4, 1e7] {
        let natural = NaturalFrequencies::axial(&rod(hoist(mass, 2e4))).unwrap();
        assert_eq!(natural.unrestored().unwrap(), 1);
        let found = natural.lowest(6).unwrap();
        let left = |omega: f64| {
            let phase = omega * travel_time();
            let stiffness = omega * torsional_impedance(&rod(None), &PIPE);
            stiffness * phase.sin() + mass * omega * omega * phase.cos()
        };
        for omega in &found {
            let [below, above] = [1.0 - 1e-8, 1.0 + 1e-8].map(|part| left(omega * part));
            assert!(below * above < 0.0, "{mass} kg: {omega}");
        }
        let first = found[0] * travel_time();
        assert!(first < PI && first > FRAC_PI_2, "{mass} kg: {first}");
    }
}

/// A dashpot c below Z sends back (Z − c)/(Z + c) of each wave: Re s = ln of that by a round trip.
#[test]
fn val_a_hoist_takes_of_each_mode_what_it_does_not_send_back() {
    let impedance = torsional_impedance(&rod(None), &PIPE);
    for part in [0.05, 0.3, 0.8] {
        let rod = rod(hoist(0.0, part * impedance));
        let natural = NaturalFrequencies::axial(&rod).unwrap();
        let frequencies = natural.lowest(5).unwrap();
        let modes = damped_modes_below_drive(&rod, &frequencies).unwrap();
        let decay = ((1.0 - part) / (1.0 + part)).ln() / (2.0 * travel_time());
        for (mode, omega) in modes.iter().zip(frequencies) {
            let mode = mode.expect("it swings");
            assert!(
                (mode.pole.re / decay - 1.0).abs() < 1e-6,
                "{mode:?} {decay}"
            );
            assert!(
                (mode.pole.im / omega - 1.0).abs() < 1e-6,
                "{mode:?} {omega}"
            );
        }
    }
}
