//! What friction whirl of several sites needs at least, on strings of the exact waves: against a
//! closed form, the paper, and simulations.

use std::f64::consts::TAU;

use linear::bending_decay::{BendingDecay, friction_if_carried};
use linear::method::FiniteElement;
use linear::waves::lateral::BendingNetwork;
use linear::{
    Bending, ChannelRequest, Complex64, Drillstring, Method, Request, Section, Sites,
    SurfaceSupport, Tube, responses,
};
use problems::academic;
use problems::pipes::STEEL;
use problems::wells::{self, Draw, Well};
use sim::excitation::least_impulse;
use sim::steady_whirl::{MOST_FRICTION, WhirlTogether};
use sim::watch::rules::Rules;
use sim::{
    Impulse, Lateral, LateralRegime, Sampling, Scene, Simulator, SitesWhirl, Stopping, Timing,
    Wall, WhirlingSite, WhirlingSites,
};

/// A string with places where it may touch.
struct Problem {
    string: Drillstring,
    bending: Bending,
    sites: Sites,
    walls: Vec<Wall>,
}

impl Problem {
    fn network(&self) -> BendingNetwork<'_> {
        let free = SurfaceSupport::Free;
        BendingNetwork::new(&self.string, self.bending, free, &self.sites).unwrap()
    }

    fn decay(&self) -> BendingDecay {
        BendingDecay::new(&self.string, &self.bending)
    }

    fn together(&self, surface_speed: f64) -> Option<WhirlTogether> {
        let network = self.network();
        let sites = WhirlingSites {
            walls: self.walls.clone(),
            receptance: |rate: f64| -> Vec<Complex64> { network.at_rate(rate).entries().to_vec() },
            decay: self.decay(),
        };
        sites.least_together(surface_speed)
    }

    fn whirl(&self, surface_speed: f64) -> Option<SitesWhirl> {
        let network = self.network();
        let sites = WhirlingSites {
            walls: self.walls.clone(),
            receptance: |rate: f64| -> Vec<Complex64> { network.at_rate(rate).entries().to_vec() },
            decay: self.decay(),
        };
        sites.least_friction([surface_speed; 2]).pop()
    }

    /// The least friction of any one site alone.
    fn of_one(&self, surface_speed: f64) -> f64 {
        let network = self.network();
        let frictions = (0..self.walls.len()).filter_map(|site| {
            let alone = WhirlingSite {
                wall: self.walls[site],
                dynamic_stiffness: |rate: f64| network.dynamic_stiffness(site, rate),
                decay: self.decay(),
            };
            Some(alone.least_friction(surface_speed)?.least_friction)
        });
        frictions.fold(f64::INFINITY, f64::min)
    }
}

fn wall(clearance: f64, radius: f64) -> Wall {
    Wall {
        clearance,
        stiffness: 1e9,
        friction: 0.0,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius,
    }
}

/// A uniform string that goes round as a whole along all of the wall needs friction against its
/// damping alone, c_b/(mω): the limit for ever more sites.
#[test]
fn val_a_string_that_touches_all_along_needs_friction_against_its_damping() {
    let tube = Tube {
        length: 10.0,
        inner_radius: 0.04,
        outer_radius: 0.0635,
    };
    let parts = vec![tube];
    let string = Drillstring::new(STEEL, vec![Section { repeat: 10, parts }], 1.0).unwrap();
    let bending = Bending {
        youngs_modulus: 210e9,
        damping: 150.0,
        compression: 0.0,
    };
    let surface_speed = TAU;
    let limit = friction_if_carried(&string, &bending, 10.0 * surface_speed);
    let mut last = f64::INFINITY;
    for halvings in 1..=6 {
        let pieces = 1 << halvings;
        // The uppermost is a little below the surface.
        let places: Vec<f64> = (0..=pieces)
            .map(|it| 99.9 * f64::from(it) / f64::from(pieces))
            .collect();
        let problem = Problem {
            string: string.clone(),
            bending,
            sites: Sites::new(&string, &places).unwrap(),
            walls: vec![wall(0.01, 0.1); places.len()],
        };
        let found = problem.whirl(surface_speed).unwrap().least_friction;
        // Each has the places of the one before.
        assert!(
            found <= 1.01 * last && found >= limit / 1.000_001,
            "{found} {last} {limit}"
        );
        last = found;
    }
    assert!(last < 1.02 * limit, "{last} {limit}");
}

/// Whether a symmetric matrix (row by row) is positive definite, by elimination.
fn is_positive(mut matrix: Vec<f64>) -> bool {
    let size = matrix.len().isqrt();
    (0..size).all(|pivot| {
        for row in pivot + 1..size {
            let factor = matrix[row * size + pivot] / matrix[pivot * size + pivot];
            for column in pivot..size {
                matrix[row * size + column] -= factor * matrix[pivot * size + column];
            }
        }
        matrix[pivot * size + pivot] > 0.0
    })
}

/// At no rate of a dense scan do forces press more than the reported friction allows: −Im H over
/// that friction, less 1 %, outweighs −Re H. Two to five sites, and as many as eighty; with constant
/// damping, and in viscous mud without. `STRINGS=400
/// cargo test --release -p drillstring-sim --test validation dense` looks at more strings.
#[test]
fn val_no_rate_of_a_dense_scan_needs_less_friction() {
    let strings = std::env::var("STRINGS").map_or(24, |count| count.parse().unwrap());
    let mut examined = 0;
    for number in 0..strings {
        let mut shaken = Shaken::draw(number);
        if number % 4 == 3 {
            shaken.crowd(number);
        }
        if number % 8 < 4 {
            shaken.lose_to_mud_alone(number);
        }
        let network = shaken.problem.network();
        let walls = &shaken.problem.walls;
        let ratios = walls.iter().map(|wall| wall.radius / wall.clearance);
        let fastest = shaken.surface_speed * ratios.fold(0.0, f64::max);
        let friction = shaken.problem.whirl(shaken.surface_speed);
        let friction = friction.map_or(MOST_FRICTION, |whirl| whirl.least_friction);
        // Less is not looked for.
        if friction < 0.02 {
            continue;
        }
        examined += 1;
        for step in 1..=2000 {
            let rate = fastest * f64::from(step) / 2000.0;
            let receptance = network.at_rate(rate);
            let unit = |site: usize| receptance[(site, site)].norm().sqrt().recip();
            let entry = |index: usize| {
                let (row, column) = (index / walls.len(), index % walls.len());
                let entry = receptance[(row, column)] * unit(row) * unit(column);
                // Rounding hides what neighbours lose.
                let hidden = if row == column { 1e-8 } else { 0.0 };
                entry.re - entry.im * 1.01 / friction + hidden
            };
            let matrix = (0..walls.len() * walls.len()).map(entry).collect();
            assert!(is_positive(matrix), "{number} {rate} {friction}");
        }
    }
    println!("{examined} strings");
    assert!(6 * examined >= 5 * strings, "{examined}");
}

/// Fig. 17: three sites of the paper's string whirl with friction down to 1.08.
#[test]
fn val_three_sites_of_the_paper_need_no_more_than_they_whirl_with() {
    let string = academic::string();
    let of = |places: &[f64]| Problem {
        string: string.clone(),
        bending: academic::BENDING,
        sites: Sites::new(&string, places).unwrap(),
        walls: vec![wall(0.015, 0.15); places.len()],
    };
    let found = of(&[100.0, 50.0, 0.0]).whirl(TAU).unwrap();
    assert!(found.least_friction < 1.08);
    assert!(found.least_friction <= 1.02 * of(&[50.0]).of_one(TAU));
    // All three slide together with little more.
    let together = of(&[100.0, 50.0, 0.0]).together(TAU).unwrap();
    assert_eq!(together.contacts.len(), 3);
    assert!(
        (together.friction / 0.351 - 1.0).abs() < 0.01,
        "{together:?}"
    );
}

/// Strings of up to 3 km, with two to five places to touch, and what sets them going.
struct Shaken {
    problem: Problem,
    surface_speed: f64,
    /// Of the least that brings a site to the wall.
    ratios: Vec<f64>,
    method: Method,
}

impl Shaken {
    fn draw(number: usize) -> Self {
        let mut draw = Draw::new(number);
        let string = loop {
            let Well { string, .. } = Well::draw(number, &mut draw);
            if string.length() < 3000.0 {
                break string;
            }
        };
        let bending = Bending {
            youngs_modulus: 210e9,
            damping: 1.0,
            compression: 0.0,
        };
        let decay_rate = draw.log_uniform(0.2, 10.0);
        let bending = Bending {
            damping: decay_rate / BendingDecay::new(&string, &bending).least(),
            ..bending
        };
        let count = 2 + number % 4;
        let span = draw.log_uniform(10.0, 0.8 * string.length());
        let places: Vec<f64> = (0..count)
            .map(|it| span * (it as f64 + draw.uniform(0.0, 0.8)) / count as f64)
            .collect();
        let radius = 0.1;
        // A rate of whirl that elements and steps follow well.
        let surface_speed = draw.uniform(0.5, 2.0) * TAU;
        let clearance = surface_speed * radius / (TAU * draw.uniform(3.0, 12.0));
        let walls = (0..count)
            .map(|_| wall(clearance * draw.uniform(1.0, 2.0), radius))
            .collect();
        Self {
            surface_speed,
            ratios: (0..count).map(|_| draw.uniform(0.5, 5.0)).collect(),
            method: match number % 2 {
                0 => Method::Quadrature,
                _ => Method::FiniteElement(FiniteElement::default()),
            },
            problem: Problem {
                sites: Sites::new(&string, &places).unwrap(),
                walls,
                string,
                bending,
            },
        }
    }

    /// The same string with up to eighty places, 2 to 30 m apart.
    fn crowd(&mut self, number: usize) {
        let mut draw = Draw::new(1000 + number);
        let problem = &mut self.problem;
        let mut places = vec![0.0];
        while places.len() < 80 {
            let next = places[places.len() - 1] + draw.log_uniform(2.0, 30.0);
            if next >= problem.string.length() {
                break;
            }
            places.push(next);
        }
        problem.sites = Sites::new(&problem.string, &places).unwrap();
        problem.walls = vec![problem.walls[0]; places.len()];
    }

    /// The same string in viscous mud, in place of its constant damping.
    fn lose_to_mud_alone(&mut self, number: usize) {
        let problem = &mut self.problem;
        problem.string = wells::with_loss(&problem.string, &mut Draw::new(2000 + number));
        problem.bending.damping = 0.0;
    }

    /// Which of these frictions whirl lasts with.
    fn whirls_with(&self, frictions: &[f64]) -> Vec<bool> {
        const FREQUENCY: f64 = 320.0;
        const PULSE: f64 = 0.02;
        const CLOSING_WINDOW: f64 = 2.0;
        let problem = &self.problem;
        let count = problem.walls.len();
        // Motion that was started without friction has long died away.
        let duration = 10.0 + 6.0 / problem.decay().least();
        let request = Request {
            sites: problem.sites.clone(),
            channels: vec![
                ChannelRequest::Torsion {
                    torques: (0..count).collect(),
                },
                ChannelRequest::Bending {
                    bending: problem.bending,
                    support: SurfaceSupport::Free,
                },
            ],
            sampling_frequency: FREQUENCY,
            longest_time: duration,
        };
        let responses = responses(&problem.string, &self.method, &request).unwrap();
        let bending = responses.bending().unwrap();
        let impulse = |site: usize| {
            let taps = &bending.from_loads[site][site];
            let clearance = problem.walls[site].clearance;
            let sampling = Sampling::new(FREQUENCY, 0.0);
            Impulse {
                site,
                amount: self.ratios[site] * least_impulse(taps, sampling, PULSE, clearance),
                start: 0.5 + 0.3 * site as f64,
                duration: PULSE,
                direction: site as f64,
            }
        };
        let impulses: Vec<Impulse> = (0..count).map(impulse).collect();
        let simulator = Simulator::new(&responses).unwrap();
        let whirls = frictions.iter().map(|friction| {
            let walls = problem.walls.iter().map(|wall| Wall {
                friction: *friction,
                ..*wall
            });
            let scene = Scene {
                start: sim::Start::Rest,
                surface_speed: self.surface_speed,
                bit: None,
                friction: Vec::new(),
                axial: None,
                lateral: Some(Lateral {
                    walls: walls.collect(),
                    impulses: impulses.clone(),
                    eccentric_masses: vec![],
                    lying: None,
                    shocks: None,
                }),
                timing: Timing {
                    duration,
                    closing_window: CLOSING_WINDOW,
                },
            };
            let outcome = simulator.simulate(&scene, Stopping::Full, None).unwrap();
            let found = outcome.lateral().unwrap();
            // Some lean on their walls while they straighten, for minutes, and friction takes them
            // round a little, which is no whirl.
            if found.contact_fraction > Rules::USUAL.mostly {
                let turns = (found.precession_rate / self.surface_speed).abs();
                assert!(!(0.005..1.0).contains(&turns), "{turns} turns in one");
            }
            found.regime == LateralRegime::BackwardWhirl
        });
        whirls.collect()
    }
}

/// `STRINGS=400 cargo test --release -p drillstring-sim --test validation simulated -- --nocapture` prints
/// the figures of the guide; here are fewer strings.
#[test]
fn val_no_simulated_whirl_has_less_friction_than_it_needs() {
    let strings = std::env::var("STRINGS").map_or(12, |count| count.parse().unwrap());
    let parts = [0.5, 0.7, 0.85, 0.95, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0, 8.0];
    let (mut cases, mut below) = (0, 0);
    let (mut whirls, mut least) = (0, Vec::new());
    let (mut needs, mut together, mut exists) = (Vec::new(), 0, Vec::new());
    for number in 0..strings {
        let shaken = Shaken::draw(number);
        let Some(bound) = shaken.problem.whirl(shaken.surface_speed) else {
            continue;
        };
        let frictions: Vec<f64> = (parts.iter())
            .map(|part| part * bound.least_friction)
            .filter(|friction| *friction < 4.0)
            .collect();
        let whirl = shaken.whirls_with(&frictions);
        let with: Vec<f64> = (frictions.iter().zip(&whirl))
            .filter_map(|(friction, whirls)| whirls.then_some(*friction))
            .collect();
        let of_one = shaken.problem.of_one(shaken.surface_speed);
        cases += frictions.len();
        whirls += with.len();
        below += (with.iter())
            .filter(|friction| **friction < bound.least_friction / 1.01)
            .count();
        together += with.iter().filter(|friction| **friction < of_one).count();
        needs.push(bound.least_friction / of_one);
        if let Some(found) = shaken.problem.together(shaken.surface_speed) {
            let part = found.friction / bound.least_friction;
            assert!(part > 1.0 / 1.0101, "{number} {part}");
            exists.push(part);
        }
        least.extend(with.first().map(|friction| friction / bound.least_friction));
    }
    for parts in [&mut least, &mut needs, &mut exists] {
        parts.sort_by(f64::total_cmp);
    }
    let strings = needs.len();
    let middle = |parts: &[f64]| parts[parts.len() / 2];
    println!(
        "{cases} cases on {strings} strings: {whirls} whirl, {below} of them with less friction than \
         all sites need, {together} with less than any one needs. All need {:.2} of what one needs \
         (the middle string). On {} strings whirl is steady with {:.2} of what all need (the middle \
         one), {:.2} (nine in ten); {} whirl, with {:.2} (the least), {:.2} (the middle one)",
        middle(&needs),
        exists.len(),
        middle(&exists),
        exists[exists.len() * 9 / 10],
        least.len(),
        least[0],
        middle(&least),
    );
    assert!(
        2 * whirls > strings && exists.len() == strings,
        "{whirls} {}",
        exists.len()
    );
    assert!(middle(&exists) < 2.0);
    assert_eq!(below, 0);
}
