//! Bending moments and displacements at places by forces: closed forms of beams, the curvature of
//! displacements, and what a site at the place has.

use std::f64::consts::PI;

use linear::method::FiniteElement;
use linear::{
    AxialForce, Bending, Budget, ChannelRequest, Drillstring, Hole, HoleSection, Material, Method,
    Mud, PlacePlan, PlaceQuantity, PlaceResponses, RaisedCosine, Request, Section, Sites,
    SurfaceSupport, Tube,
};
use problems::oracles::convolve;
use problems::wells::Draw;

const LENGTH: f64 = 20.0;

const COLLAR: Tube = Tube {
    length: LENGTH,
    inner_radius: 0.0357,
    outer_radius: 0.1016,
};

const BENDING: Bending = Bending {
    youngs_modulus: 206e9,
    damping: 500.0,
    compression: 0.0,
};

fn methods() -> [Method; 3] {
    let elements = FiniteElement {
        elements_per_cell: 40,
        ..FiniteElement::default()
    };
    [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(elements),
    ]
}

fn collar() -> Drillstring {
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let section = Section {
        repeat: 1,
        parts: vec![COLLAR],
    };
    Drillstring::new(steel, vec![section], 0.0).unwrap()
}

/// Of a collar that is pinned at its top and, by a stiff spring, at its other end, with a number of sites
/// between.
fn pinned(between: usize, sampling_frequency: f64, longest_time: f64) -> (Drillstring, Request) {
    let string = collar();
    let sites: Vec<f64> = (0..=between)
        .map(|site| LENGTH * site as f64 / (between + 1) as f64)
        .collect();
    let mut springs = vec![0.0; between + 1];
    springs[between] = 1e12;
    let sites = Sites::new(&string, &sites).unwrap();
    let request = Request {
        sites: sites.held_by(springs).unwrap(),
        channels: vec![ChannelRequest::Bending {
            bending: BENDING,
            support: SurfaceSupport::Pinned,
        }],
        sampling_frequency,
        longest_time,
    };
    (string, request)
}

fn moments(beam: &(Drillstring, Request), method: &Method, places: &[f64]) -> PlaceResponses {
    at_places(beam, method, (PlaceQuantity::Moment, places))
}

fn at_places(
    (string, request): &(Drillstring, Request),
    method: &Method,
    wanted: (PlaceQuantity, &[f64]),
) -> PlaceResponses {
    let plan = PlacePlan::new(string, method, request, wanted).unwrap();
    plan.build(&Budget::unlimited()).unwrap()
}

/// A force in the middle of a pinned beam that lasts: F L/4 there, half of it half-way to the ends.
#[test]
fn val_a_force_that_lasts_bends_a_pinned_beam_as_statics_have_it() {
    let beam = pinned(1, 200.0, 30.0);
    for method in methods() {
        let found = moments(&beam, &method, &[5.0, 10.0, 15.0, 2.5]);
        assert_eq!(found.places, [15.0, 10.0, 5.0, 2.5]);
        for (place, from_forces) in found.places.iter().zip(&found.from_forces) {
            let lasting: f64 = from_forces[0].iter().sum();
            let expected = 0.5 * place.min(LENGTH - place);
            // Pushed towards the wall at x > 0, it is bent back.
            let apart = (lasting / expected + 1.0).abs();
            assert!(apart < 1e-5, "{method:?} {place}: {lasting} {expected}");
            let held: f64 = from_forces[1].iter().sum();
            assert!(held.abs() < 1e-5, "{method:?} {place}: {held}");
        }
    }
}

/// The same force bends it by F L³/48EI in its middle, and by 11/16 of that half-way to the ends.
#[test]
fn val_a_force_that_lasts_moves_places_of_a_pinned_beam_as_statics_have_it() {
    let beam = pinned(1, 200.0, 30.0);
    let middle = LENGTH.powi(3) / (48.0 * BENDING.youngs_modulus * COLLAR.second_moment());
    for method in methods() {
        let wanted = (PlaceQuantity::Displacement, &[5.0, 10.0, 15.0][..]);
        let found = at_places(&beam, &method, wanted);
        assert_eq!(found.places, [15.0, 10.0, 5.0]);
        for (from_forces, part) in found
            .from_forces
            .iter()
            .zip([11.0 / 16.0, 1.0, 11.0 / 16.0])
        {
            let lasting: f64 = from_forces[0].iter().sum();
            let apart = (lasting / (part * middle) - 1.0).abs();
            assert!(apart < 1e-5, "{method:?}: {lasting}");
        }
    }
}

/// A place moves as a site there would, whether springs hold the other sites or not.
#[test]
fn val_a_place_between_sites_moves_as_a_site_there() {
    for number in 0..6 {
        let (string, request, mut draw) = drawn(number);
        let sites = request.sites.distances_from_bit();
        let place = draw.uniform(sites[1] + 2.0, sites[0] - 2.0);
        let springs: Vec<f64> = sites.iter().map(|_| draw.uniform(1e4, 1e6)).collect();
        for springs in [Vec::new(), springs] {
            let held = |sites: Sites, springs: Vec<f64>| match springs.is_empty() {
                true => sites.without_springs(),
                false => sites.held_by(springs).unwrap(),
            };
            let with_it = [&sites[..1], &[place], &sites[1..]].concat();
            let mut springs_with_it = springs.clone();
            if !springs.is_empty() {
                springs_with_it.insert(1, 0.0);
            }
            let with_site = Request {
                sites: held(Sites::new(&string, &with_it).unwrap(), springs_with_it),
                ..request.clone()
            };
            let request = Request {
                sites: held(request.sites.clone(), springs),
                ..request.clone()
            };
            for method in methods() {
                let beam = (string.clone(), request.clone());
                let found = at_places(&beam, &method, (PlaceQuantity::Displacement, &[place]));
                let expected = linear::responses(&string, &method, &with_site).unwrap();
                let expected = &expected.bending().unwrap().from_loads[1];
                for (load, found) in [0, 2, 3].into_iter().zip(&found.from_forces[0]) {
                    let expected = &expected[load];
                    let largest = expected
                        .iter()
                        .fold(0.0, |most: f64, it| most.max(it.abs()));
                    for (found, expected) in found.iter().zip(expected) {
                        let apart = (found - expected).abs() / largest;
                        assert!(apart < 1e-9, "{number} {method:?} {load}: {apart:e}");
                    }
                }
            }
        }
    }
}

/// Poles have no site at a place, whose forces they would bend to: they are nearer to the string there than
/// those of a string with a site more are.
#[test]
fn val_by_poles_a_place_moves_nearer_to_the_string_than_a_site_there() {
    let largest =
        |taps: &mut dyn Iterator<Item = f64>| taps.fold(0.0, |most: f64, it| most.max(it.abs()));
    for number in 0..3 {
        let (string, request, mut draw) = drawn(number);
        let request = Request {
            sites: request.sites.without_springs(),
            ..request
        };
        let sites = request.sites.distances_from_bit();
        let place = draw.uniform(sites[1] + 2.0, sites[0] - 2.0);
        let with_it = [&sites[..1], &[place], &sites[1..]].concat();
        let with_site = Request {
            sites: Sites::new(&string, &with_it).unwrap(),
            ..request.clone()
        };
        let [held, poles] = [Method::Held, Method::Poles]
            .map(|method| linear::responses(&string, &method, &with_site).unwrap());
        let [held, poles] = [&held, &poles].map(|it| &it.bending().unwrap().from_loads);
        let wanted = (PlaceQuantity::Displacement, &[place][..]);
        let found = at_places(&(string, request), &Method::Poles, wanted);
        for (load, found) in [0, 2, 3].into_iter().zip(&found.from_forces[0]) {
            let own = |site: usize| largest(&mut held[site][site].iter().copied());
            let scale = (own(1) * own(load)).sqrt();
            let [by_place, by_site] = [found, &poles[1][load]].map(|taps| {
                let apart = taps.iter().zip(&held[1][load]);
                largest(&mut apart.map(|(one, other)| one - other)) / scale
            });
            assert!(
                by_place < by_site && by_site < 1e-2,
                "{number} {load}: {by_place:e} {by_site:e}"
            );
        }
    }
}

/// A beam pushed in the shape of its first mode swings in that: M = EI (π/L)² a at its middle, by its
/// displacement a there.
#[test]
fn val_a_beam_in_its_first_mode_is_bent_by_its_amplitude() {
    let (frequency, steps) = (2000.0, 4000);
    let beam = pinned(9, frequency, 2.0);
    let (string, request) = &beam;
    let shape = |site: usize| (PI * (site + 1) as f64 / 10.0).sin();
    let pulse = RaisedCosine { duration: 0.2 };
    for method in methods() {
        let offset = method.collocation_offset();
        let forces: Vec<f64> = (0..steps)
            .map(|step| pulse.at((step as f64 + offset) / frequency))
            .collect();
        let sum = |taps: &dyn Fn(usize) -> Vec<f64>| {
            let pushed = (0..9).map(|site| (shape(site), convolve(&taps(site), &forces)));
            pushed.fold(vec![0.0; steps], |mut sum, (by, moved)| {
                let added = sum.iter_mut().zip(moved);
                added.for_each(|(sum, moved)| *sum += by * moved);
                sum
            })
        };
        let displaced = linear::responses(string, &method, request).unwrap();
        let displaced = &displaced.bending().unwrap().from_loads;
        let displaced = sum(&|site| displaced[4][site].clone());
        let bent = moments(&beam, &method, &[0.5 * LENGTH]);
        let bent = sum(&|site| bent.from_forces[0][site].clone());
        let rigidity = BENDING.youngs_modulus * COLLAR.second_moment();
        let per_displacement = -rigidity * (PI / LENGTH).powi(2);
        let largest = displaced
            .iter()
            .fold(0.0, |most: f64, it| most.max(it.abs()));
        // Once the force is over.
        let after = displaced
            .iter()
            .zip(&bent)
            .skip((0.25 * frequency) as usize);
        for (displacement, moment) in after {
            let apart = (moment / per_displacement - displacement).abs();
            assert!(apart < 1e-3 * largest, "{method:?}: {apart} {largest}");
        }
    }
}

/// A jointed string, drawn at random, in viscous mud or without, under an axial force in pieces, with
/// three sites, which springs hold or none.
fn drawn(number: usize) -> (Drillstring, Request, Draw) {
    let mut draw = Draw::new(number);
    let outer_radius = draw.uniform(0.05, 0.09);
    let pipe = Tube {
        length: 9.0,
        inner_radius: outer_radius - draw.uniform(0.01, 0.03),
        outer_radius,
    };
    let joint = Tube {
        length: 0.5,
        outer_radius: 1.2 * outer_radius,
        ..pipe
    };
    let section = Section {
        repeat: 30,
        parts: vec![pipe, joint],
    };
    let steel = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };
    let string = Drillstring::new(steel, vec![section], 0.0).unwrap();
    let hole = Hole {
        sections: vec![HoleSection {
            length: string.length(),
            radius: 0.13,
        }],
        mud: Mud {
            density: draw.uniform(1000.0, 2000.0),
            viscosity: draw.log_uniform(1e-3, 0.1),
        },
    };
    let string = match number % 2 {
        0 => string.in_hole(hole).unwrap(),
        _ => string,
    };
    let pieces = [120.0, 165.0].map(|length| AxialForce {
        length,
        tension: draw.uniform(0.0, 3e5),
    });
    let string = string.under_axial_force(pieces.to_vec()).unwrap();
    let sites = [0.0, draw.uniform(10.0, 20.0), draw.uniform(30.0, 60.0)];
    let sites = Sites::new(&string, &sites).unwrap();
    let sites = match number % 3 {
        0 => sites.held_by(vec![2e4, 0.0, 5e4]).unwrap(),
        _ => sites,
    };
    let bending = Bending {
        compression: draw.uniform(-1e5, 1e4),
        ..BENDING
    };
    let request = Request {
        sites,
        channels: vec![ChannelRequest::Bending {
            bending,
            support: SurfaceSupport::Pinned,
        }],
        sampling_frequency: 400.0,
        longest_time: 1.5,
    };
    (string, request, draw)
}

/// EI u″ by the displacements of three places next to each other, without forces there.
fn by_curvature(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    (place, rigidity): (f64, f64),
) -> Vec<Vec<f64>> {
    const APART: f64 = 0.05;
    let around = [place + APART, place, place - APART];
    let own = request.sites.distances_from_bit();
    let all: Vec<f64> = own.iter().chain(&around).copied().collect();
    let sites = Sites::new(string, &all).unwrap();
    let numbers = |places: &[f64]| -> Vec<usize> {
        let number = |it: &f64| sites.distances_from_bit().iter().position(|at| at == it);
        places.iter().map(|place| number(place).unwrap()).collect()
    };
    let (loads, around) = (numbers(own), numbers(&around));
    let sites = match request.sites.springs() {
        [] => sites.clone(),
        springs => {
            let mut all = vec![0.0; sites.len()];
            loads
                .iter()
                .zip(springs)
                .for_each(|(site, spring)| all[*site] = *spring);
            sites.clone().held_by(all).unwrap()
        }
    };
    let request = Request {
        sites,
        ..request.clone()
    };
    let responses = linear::responses(string, method, &request).unwrap();
    let displaced = &responses.bending().unwrap().from_loads;
    let curvature = |load: &usize| {
        let [above, at, below] = [0, 1, 2].map(|it: usize| &displaced[around[it]][*load]);
        let differences = above.iter().zip(at).zip(below);
        differences
            .map(|((above, at), below)| rigidity * (above - 2.0 * at + below) / APART.powi(2))
            .collect()
    };
    loads.iter().map(curvature).collect()
}

/// Between two sites, and whether it is asked for alone or with others.
#[test]
fn val_a_moment_between_sites_is_the_curvature_of_the_string_there() {
    for number in 0..12 {
        let (string, request, mut draw) = drawn(number);
        let sites = request.sites.distances_from_bit();
        let between = draw.uniform(sites[1] + 2.0, sites[0] - 2.0);
        // In the middle of a pipe, whose joint is 0.5 m long at its lower end.
        let place = (between / 9.5).floor() * 9.5 + 0.5 + draw.uniform(1.0, 8.0);
        let rigidity = {
            let pipe = string.sections()[0].parts[0];
            206e9 * pipe.second_moment()
        };
        for method in [Method::Held, Method::Quadrature] {
            let beam = (string.clone(), request.clone());
            let alone = moments(&beam, &method, &[place]);
            let with_others = moments(&beam, &method, &[place + 3.0, place, sites[1], 1.0]);
            let expected = by_curvature(&string, &method, &request, (place, rigidity));
            let at = |it: &PlaceResponses| it.places.iter().position(|at| *at == place).unwrap();
            let of_both = [
                &alone.from_forces[at(&alone)],
                &with_others.from_forces[at(&with_others)],
            ];
            for load in 0..3 {
                let largest = expected[load]
                    .iter()
                    .fold(0.0, |most: f64, it| most.max(it.abs()));
                for found in of_both {
                    for (found, expected) in found[load].iter().zip(&expected[load]) {
                        let apart = (found - expected).abs() / largest;
                        assert!(
                            apart < 5e-3,
                            "{number} {method:?} {load}: {found} {expected}"
                        );
                    }
                }
                let [one, other] = of_both.map(|it| &it[load]);
                for (one, other) in one.iter().zip(other) {
                    assert!((one - other).abs() < 1e-7 * largest, "{number} {method:?}");
                }
            }
        }
    }
}

#[test]
fn val_invalid_places_and_strings_that_do_not_bend_are_refused() {
    let (string, request) = pinned(1, 200.0, 1.0);
    let refused = |request: &Request, places: &[f64]| {
        PlacePlan::new(
            &string,
            &Method::Held,
            request,
            (PlaceQuantity::Moment, places),
        )
        .is_err()
    };
    assert!(!refused(&request, &[3.0]));
    for places in [&[][..], &[-1.0], &[20.5], &[3.0, 3.0]] {
        assert!(refused(&request, places), "{places:?}");
    }
    let unbent = Request {
        channels: Vec::new(),
        ..request
    };
    assert!(refused(&unbent, &[3.0]));
}
