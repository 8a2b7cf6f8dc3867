//! Steady forward whirl against closed forms, dense scans of the speed, the paper and simulations.

use std::f64::consts::TAU;

use linear::bending_decay::BendingDecay;
use linear::method::{FiniteElement, Transform};
use linear::waves::lateral::BendingNetwork;
use linear::{
    Bending, ChannelRequest, Complex64, Drillstring, Material, Method, Request, Section, Sites,
    SurfaceSupport, Tube, responses,
};
use problems::academic::{self, BENDING};
use problems::oracles::assert_close;
use problems::wells::{self, Draw, Well};
use sim::steady_whirl::{EccentricString, ForwardContacts, LowestTouch};
use sim::{
    EccentricMass, Lateral, LateralMeasures, LateralRegime, Scene, SceneError, Simulator, Stopping,
    Timing, Trajectory, Wall,
};

fn wall(clearance: f64) -> Wall {
    Wall {
        clearance,
        stiffness: 1e9,
        friction: 0.5,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    }
}

fn mass(site: usize, mass: f64, offset: f64) -> EccentricMass {
    EccentricMass { site, mass, offset }
}

/// A mass on a spring with a damper: r = m_e d Ω²/(|K| − m_e Ω²), K = k − mΩ² + icΩ.
#[test]
fn val_a_rotor_follows_its_closed_form() {
    let (heavy, stiffness, damping) = (50.0, 2e5, 400.0);
    let dynamic = |rate: f64| Complex64::new(stiffness - heavy * rate * rate, damping * rate);
    let (eccentric, offset, clearance) = (8.0, 1e-3, 2e-3);
    let rotor = EccentricString {
        walls: vec![wall(clearance)],
        mass: mass(0, eccentric, offset),
        receptance: |rate: f64| vec![dynamic(rate).inv()],
        is_carried: false,
        decay: BendingDecay::constant(0.5 * damping / heavy),
    };
    let radius = |rate: f64| {
        let force = eccentric * rate * rate;
        force * offset / (dynamic(rate).norm() - force)
    };
    for rate in [10.0, 40.0, 55.0, 90.0, 200.0] {
        let [found] = rotor.free_radii(rate).unwrap()[..] else {
            panic!("one site");
        };
        assert_close(found, radius(rate), 1e-12);
    }
    // At resonance nothing but the wall limits it.
    let natural = f64::sqrt(stiffness / heavy);
    assert_eq!(rotor.free_radii(natural), None);
    let touch = rotor.first_touch([1.0, 500.0]).unwrap().unwrap();
    assert_close(radius(touch.surface_speed), clearance, 0.005);
    let beyond = rotor.first_touch([1.5 * natural, 500.0]).unwrap();
    assert_eq!(beyond, None);
    for (speeds, decay_rate) in [([0.0, 9.0], 1.0), ([1.0, 9.0], 1e-6)] {
        let refused = EccentricString {
            is_carried: false,
            decay: BendingDecay::constant(decay_rate),
            ..rotor.clone()
        }
        .first_touch(speeds);
        assert!(
            matches!(refused, Err(SceneError::OutOfRange { .. })),
            "{refused:?}"
        );
    }
    // In contact the forces along and across balance.
    let contact = rotor.in_contact_at(0, natural).unwrap();
    let (radius, force) = (contact.radii[0], contact.normal_force);
    assert_close(force, 1e9 * (radius - clearance).powf(1.5), 1e-6);
    let needed = dynamic(natural) * radius + force * Complex64::new(1.0, 0.5);
    let has = eccentric * (offset + radius) * natural * natural;
    assert_close(needed.norm(), has, 1e-9);
    assert_eq!(rotor.in_contact_at(0, 10.0), None);
}

/// On random strings a dense scan of the speed finds no site beyond its clearance below the
/// first touch, and at that a little more mass makes one touch.
#[test]
fn val_no_touch_of_a_dense_scan_is_missed() {
    let (mut touches, mut scanned) = (0, 0);
    for (number, is_carried) in (0..40).flat_map(|it| [(it, false), (it, true)]) {
        let mut draw = Draw::new(number);
        let Well { mut string, .. } = Well::draw(number, &mut draw);
        let mut damping = draw.log_uniform(5.0, 500.0);
        // Every other one in viscous mud alone.
        if number % 2 == 1 {
            string = wells::with_loss(&string, &mut Draw::new(100 + number));
            damping = 0.0;
        }
        let bending = Bending { damping, ..BENDING };
        let count = 1 + number % 4;
        let span = draw.log_uniform(5.0, 0.8 * string.length());
        let place = |it: usize| span * (it as f64 + 0.3) / count as f64;
        let sites = Sites::new(&string, &(0..count).map(place).collect::<Vec<_>>()).unwrap();
        let clearances: Vec<f64> = (0..count).map(|_| draw.log_uniform(2e-3, 5e-2)).collect();
        let (load, offset) = (draw.log_uniform(20.0, 1000.0), draw.log_uniform(1e-4, 0.02));
        let mut masses = vec![0.0; count];
        // Sites are numbered from the surface down.
        masses[number % count] = if is_carried { load } else { 0.0 };
        let sites = sites.carrying(masses).unwrap();
        let network = network(&string, bending, &sites);
        let eccentric = EccentricString {
            walls: clearances
                .iter()
                .map(|clearance| wall(*clearance))
                .collect(),
            mass: mass(number % count, load, offset),
            receptance: |rate: f64| -> Vec<Complex64> { network.at_rate(rate).entries().to_vec() },
            is_carried,
            decay: BendingDecay::with_masses(&string, &bending, &sites),
        };
        let [slowest, fastest] = [0.2, 25.0];
        let touch = eccentric.first_touch([slowest, fastest]).unwrap();
        let touches_at = |speed: f64, eccentric: &EccentricString<_>| {
            let radii = eccentric.free_radii(speed);
            radii.is_none_or(|radii| std::iter::zip(radii, &clearances).any(|(r, c)| r >= *c))
        };
        let until = touch.map_or(fastest, |touch| touch.surface_speed);
        for step in 0..3000 {
            let speed = slowest + (until - slowest) * f64::from(step) / 3000.0;
            // At the slowest there may be a touch already.
            let is_clear = speed == until || !touches_at(speed, &eccentric);
            assert!(is_clear, "{number} {is_carried} {speed} {touch:?}");
        }
        if let Some(LowestTouch { surface_speed, .. }) = touch {
            touches += 1;
            scanned += usize::from(surface_speed > slowest);
            let mut heavier = eccentric.clone();
            heavier.mass.mass *= 1.002;
            assert!(touches_at(surface_speed, &heavier), "{number} {touch:?}");
        }
    }
    assert!(scanned >= 20 && touches < 80, "{touches} {scanned}");
}

fn network<'a>(string: &'a Drillstring, bending: Bending, sites: &Sites) -> BendingNetwork<'a> {
    BendingNetwork::new(string, bending, SurfaceSupport::Free, sites).unwrap()
}

/// The academic string with walls at places, in contact by the balance of forces and by
/// simulation, where it whirls.
fn academic_whirl(
    places: &[f64],
    walls: Vec<Wall>,
    mass: EccentricMass,
) -> (ForwardContacts, LateralMeasures) {
    const SPEED: f64 = TAU;
    let string = academic::string();
    let sites = Sites::new(&string, places).unwrap();
    let network = network(&string, BENDING, &sites);
    let eccentric = EccentricString {
        walls: walls.clone(),
        mass,
        receptance: |rate: f64| -> Vec<Complex64> { network.at_rate(rate).entries().to_vec() },
        is_carried: false,
        decay: BendingDecay::new(&string, &BENDING),
    };
    let found = eccentric.in_contact(SPEED).unwrap();
    let request = academic::lateral_request(&string, places, 20.0);
    let responses = responses(&string, &Method::Quadrature, &request).unwrap();
    let scene = Scene {
        start: sim::Start::Rest,
        surface_speed: SPEED,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls,
            impulses: vec![],
            eccentric_masses: vec![mass],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: 20.0,
            closing_window: 2.0,
        },
    };
    let simulator = Simulator::new(&responses).unwrap();
    let outcome = simulator.simulate(&scene, Stopping::Full, None).unwrap();
    (found, outcome.lateral().unwrap())
}

/// The same rotor with a mass that it carries: r = m_e d Ω²/|k − (m + m_e)Ω² + icΩ|, at resonance, too.
#[test]
fn val_a_rotor_that_carries_the_mass_follows_its_closed_form() {
    let (heavy, stiffness, damping) = (50.0, 2e5, 400.0);
    let (eccentric, offset, clearance) = (8.0, 1e-3, 1e-3);
    let moved = heavy + eccentric;
    let dynamic = |rate: f64| Complex64::new(stiffness - moved * rate * rate, damping * rate);
    let rotor = EccentricString {
        walls: vec![wall(clearance)],
        mass: mass(0, eccentric, offset),
        is_carried: true,
        receptance: |rate: f64| vec![dynamic(rate).inv()],
        decay: BendingDecay::constant(0.5 * damping / moved),
    };
    let radius = |rate: f64| eccentric * rate * rate * offset / dynamic(rate).norm();
    let natural = f64::sqrt(stiffness / moved);
    for rate in [10.0, 40.0, natural, 90.0, 200.0] {
        let [found] = rotor.free_radii(rate).unwrap()[..] else {
            panic!("one site");
        };
        assert_close(found, radius(rate), 1e-12);
    }
    let touch = rotor.first_touch([1.0, 500.0]).unwrap().unwrap();
    assert_close(radius(touch.surface_speed), clearance, 0.005);
}

/// A collar that hangs clamped, below and above its first critical speeds, with a mass at its end and one
/// further up: it goes round as the waves of the string without them say, whose receptances D leave
/// r = (1 − D m Ω²)⁻¹ D m d Ω². The form of the paper is a third more than that above the first critical speed.
#[test]
fn val_a_string_carries_its_eccentric_masses_by_every_method() {
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let collar = Tube {
        length: 19.0,
        inner_radius: 0.0357,
        outer_radius: 0.1016,
    };
    let section = Section {
        repeat: 1,
        parts: vec![collar],
    };
    let string = Drillstring::new(steel, vec![section], 0.5).unwrap();
    let bending = Bending {
        youngs_modulus: 206.8e9,
        damping: 500.0,
        compression: 0.0,
    };
    let support = SurfaceSupport::Clamped;
    let bare = Sites::new(&string, &[6.0, 0.0]).unwrap();
    let masses = [mass(0, 150.0, 0.01), mass(1, 100.0, 0.02)];
    let loads = masses.map(|it| it.mass);
    let carrying = bare.clone().carrying(loads.to_vec()).unwrap();
    let network = BendingNetwork::new(&string, bending, support, &bare).unwrap();
    let exact = |speed: f64| -> [f64; 2] {
        let receptance = network.at_rate(speed);
        let [a, b, c, d] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|it| receptance[it]);
        let square = speed * speed;
        let [m, n] = loads.map(|load| square * load);
        let by =
            |row: [Complex64; 2]| row[0] * m * masses[0].offset + row[1] * n * masses[1].offset;
        let [p, q] = [by([a, b]), by([c, d])];
        // (1 − D m Ω²) r = p by Cramer's rule.
        let (one, other) = (1.0 - a * m, 1.0 - d * n);
        let determinant = one * other - b * n * c * m;
        let r = [
            (p * other + b * n * q) / determinant,
            (q * one + c * m * p) / determinant,
        ];
        r.map(|it| it.norm())
    };
    let simulated = |method: &Method, rpm: f64, sites: &Sites| -> [f64; 2] {
        let request = Request {
            sites: sites.clone(),
            channels: vec![
                ChannelRequest::Torsion {
                    torques: vec![0, 1],
                },
                ChannelRequest::Bending { bending, support },
            ],
            sampling_frequency: 1000.0,
            longest_time: 25.0,
        };
        let responses = responses(&string, method, &request).unwrap();
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: rpm * TAU / 60.0,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall(0.5); 2],
                impulses: vec![],
                eccentric_masses: masses.to_vec(),
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: 25.0,
                closing_window: 2.0,
            },
        };
        let mut motion = Trajectory::default();
        let simulator = Simulator::new(&responses).unwrap();
        simulator
            .simulate(&scene, Stopping::Full, Some(&mut motion))
            .unwrap();
        [0, 1].map(|site| {
            let [x, y] = *motion.positions[site].last().unwrap();
            x.hypot(y)
        })
    };
    let elements = Method::FiniteElement(FiniteElement::default());
    let by_all = [
        Method::Held,
        Method::Quadrature,
        elements,
        Method::Hilbert(Transform::default()),
    ];
    for rpm in [15.0, 40.0, 60.0, 170.0] {
        let expected = exact(rpm * TAU / 60.0);
        for method in &by_all {
            let found = simulated(method, rpm, &carrying);
            for (found, expected) in found.into_iter().zip(expected) {
                assert_close(found, expected, 0.01);
            }
        }
    }
    let [_, at_end] = simulated(&Method::Quadrature, 40.0, &bare);
    assert!(at_end > 1.3 * exact(40.0 * TAU / 60.0)[1], "{at_end}");
}

/// Fig. 15: 3.5 kN at 15.23 mm.
#[test]
fn val_the_string_of_the_paper_goes_round_along_its_wall() {
    let mass = mass(0, 1000.0, 0.1);
    let (found, simulated) = academic_whirl(&[0.0], vec![wall(0.015)], mass);
    let (radii, force) = (found.radii, found.normal_forces[0]);
    assert_close(radii[0], 0.01523, 0.001);
    assert_close(force, 3500.0, 0.01);
    assert_eq!(simulated.regime, LateralRegime::ForwardWhirl);
    assert_close(simulated.mean_radius, radii[0], 0.01);
    assert_close(simulated.mean_normal_force, force, 0.01);
}

/// A mass 50 m above the bit, which touches, while the string is clear of the wall there.
#[test]
fn val_a_mass_elsewhere_takes_the_bit_round() {
    let walls = vec![wall(1.0), wall(0.015)];
    let (found, simulated) = academic_whirl(&[50.0, 0.0], walls, mass(0, 1000.0, 0.4));
    assert_eq!(found.normal_forces[0], 0.0);
    assert_eq!(simulated.regime, LateralRegime::ForwardWhirl);
    assert_close(simulated.mean_radius, found.radii[1], 0.01);
    assert_close(simulated.mean_normal_force, found.normal_forces[1], 0.02);
}

/// Three sites, of which several touch.
#[test]
fn val_a_mass_presses_the_string_against_several_walls() {
    for (clearances, mass, touching) in [
        ([0.0025, 0.01, 0.012], mass(1, 1000.0, 0.3), vec![0, 1, 2]),
        ([0.0018, 0.01, 0.012], mass(2, 1000.0, 0.3), vec![0, 2]),
    ] {
        let walls = clearances.map(wall).to_vec();
        let (found, simulated) = academic_whirl(&[60.0, 30.0, 0.0], walls, mass);
        let in_contact = (0..3).filter(|site| found.normal_forces[*site] > 0.0);
        assert_eq!(in_contact.collect::<Vec<_>>(), touching);
        assert_eq!(simulated.regime, LateralRegime::ForwardWhirl);
        let site = simulated.site;
        assert_close(simulated.mean_radius, found.radii[site], 0.01);
        assert_close(simulated.mean_normal_force, found.normal_forces[site], 0.02);
    }
}
