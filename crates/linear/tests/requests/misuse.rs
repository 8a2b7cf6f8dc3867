//! What no string has, and no request may ask for, is refused by name: never a
//! panic, never an answer without a word.

use linear::deviation::ExactMotions;
use linear::elements::reconstruction::WholeString;
use linear::method::{FiniteElement, Transform};
use linear::passivity::{Ending, positive_real_margin};
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{
    Bending, BuildError, Channel, ChannelRequest, Drillstring, DrillstringError, Method, Request,
    ResponseError, Responses, Section, Sites, SurfaceSupport, responses,
};

use problems::academic::BENDING;
use problems::pipes::{STEEL, pipe, row};

/// A string of a number of pipes of ten metres.
fn string(pipes: usize) -> Drillstring {
    row(pipes, 10.0)
}

fn methods() -> [Method; 5] {
    [
        Method::Quadrature,
        Method::Trapezoidal,
        Method::Hilbert(Transform::default()),
        Method::DirectIdft(Transform::default()),
        Method::FiniteElement(FiniteElement::default()),
    ]
}

const TORSION: fn() -> ChannelRequest = || ChannelRequest::Torsion { torques: vec![0] };
const IN_BENDING: fn() -> ChannelRequest = || with(BENDING);

fn with(bending: Bending) -> ChannelRequest {
    ChannelRequest::Bending {
        bending,
        support: SurfaceSupport::Free,
    }
}

fn request(sites: Sites, channels: Vec<ChannelRequest>) -> Request {
    Request {
        sites,
        channels,
        sampling_frequency: 200.0,
        longest_time: 1.0,
    }
}

/// By every method, what changes a good request is refused, and names what is wrong.
#[test]
fn requests_out_of_range_are_refused_by_every_method() {
    let string = string(3);
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0];
    for method in methods() {
        for channel in [TORSION, IN_BENDING] {
            let good = request(Sites::bit(), vec![channel()]);
            assert!(responses(&string, &method, &good).is_ok());
            for value in bad.into_iter().chain([0.0]) {
                let request = Request {
                    sampling_frequency: value,
                    ..good.clone()
                };
                assert_names(responses(&string, &method, &request), "sampling_frequency");
            }
            for value in bad {
                let request = Request {
                    longest_time: value,
                    ..good.clone()
                };
                assert_names(responses(&string, &method, &request), "longest_time");
            }
            let twice = request(Sites::bit(), vec![channel(), channel()]);
            let channel = channel().channel();
            let found = responses(&string, &method, &twice);
            assert_eq!(found, Err(BuildError::ChannelTwice { channel }));
        }
        let torques = vec![0, 2];
        let request = request(Sites::bit(), vec![ChannelRequest::Torsion { torques }]);
        let found = responses(&string, &method, &request);
        assert_eq!(found, Err(BuildError::NoSuchSite { site: 2, sites: 1 }));
    }
}

#[track_caller]
fn assert_names<T>(found: Result<T, BuildError>, expected: &str) {
    match found {
        Err(BuildError::Parameter { name, .. }) => assert_eq!(name, expected),
        Err(other) => panic!("another error: {other}"),
        Ok(_) => panic!("{expected} is not refused"),
    }
}

#[test]
fn sites_of_a_longer_string_are_refused_on_a_shorter_one() {
    let (long, short) = (string(10), string(3));
    let sites = Sites::new(&long, &[0.0, 60.0]).unwrap();
    let off = DrillstringError::SiteOffString {
        distance: 60.0,
        length: short.length(),
    };
    assert_eq!(sites.check(&short), Err(off.clone()));
    for method in methods() {
        for channel in [TORSION, IN_BENDING] {
            let request = request(sites.clone(), vec![channel()]);
            let found = responses(&short, &method, &request);
            assert_eq!(found, Err(BuildError::Sites(off.clone())));
        }
    }
    let network = TorsionNetwork::new(&short, &sites);
    assert_eq!(network.map(|_| ()), Err(off.clone()));
    let network = BendingNetwork::new(&short, BENDING, SurfaceSupport::Free, &sites);
    assert_eq!(network.map(|_| ()), Err(off.clone()));
    let still = [vec![vec![0.0]; 2], vec![vec![0.0]; 2]];
    let found = whole(&short, &sites).reconstruct(&still, &[]);
    assert_eq!(found, Err(BuildError::Sites(off)));
}

#[test]
fn sites_where_a_string_is_held_and_places_off_it_are_refused() {
    let string = string(10);
    let length = string.length();
    for distance in [0.0, -1.0, length, 2.0 * length, f64::NAN] {
        let found = string.clone().held_above(distance);
        assert!(
            matches!(found, Err(DrillstringError::HeldOffString { .. })),
            "{distance}"
        );
    }
    let bends = 0.5 * length;
    let held = string.held_above(bends).unwrap();
    for distance in [bends, bends + 1.0, 0.99 * length] {
        let sites = Sites::new(&held, &[distance, 0.0]).unwrap();
        let network = BendingNetwork::new(&held, BENDING, SurfaceSupport::Pinned, &sites);
        let refused = DrillstringError::SiteHeld { distance, bends };
        assert_eq!(network.map(|_| ()), Err(refused.clone()));
        for method in methods() {
            let found = responses(&held, &method, &request(sites.clone(), vec![IN_BENDING()]));
            assert_eq!(found, Err(BuildError::Sites(refused.clone())));
        }
    }
}

fn whole<'a>(string: &'a Drillstring, sites: &'a Sites) -> WholeString<'a> {
    WholeString {
        string,
        bending: &BENDING,
        support: SurfaceSupport::Free,
        sites,
        sampling_frequency: 200.0,
        parameters: FiniteElement::default(),
    }
}

#[test]
fn bending_that_no_string_has_is_refused_by_every_method() {
    let string = string(3);
    let changes: [fn(&mut Bending); 6] = [
        |bending| bending.youngs_modulus = 0.0,
        |bending| bending.youngs_modulus = -210e9,
        |bending| bending.youngs_modulus = f64::NAN,
        |bending| bending.damping = -1.0,
        |bending| bending.damping = f64::INFINITY,
        |bending| bending.compression = f64::NAN,
    ];
    for change in changes {
        let mut bending = BENDING;
        change(&mut bending);
        for method in methods() {
            let request = request(Sites::bit(), vec![with(bending)]);
            let found = responses(&string, &method, &request);
            assert!(matches!(found, Err(BuildError::Sites(_))), "{bending:?}");
        }
    }
}

/// Short waves are halved until they are long: those whose square is beyond all numbers never are.
#[test]
fn damping_whose_square_is_no_number_is_refused_by_every_method() {
    let string = string(3);
    let bending = Bending {
        damping: 1e300,
        ..BENDING
    };
    let request = request(Sites::bit(), vec![with(bending)]);
    for method in methods() {
        let refused = responses(&string, &method, &request);
        assert!(
            matches!(refused, Err(BuildError::NotFinite { .. })),
            "{}: {refused:?}",
            method.name()
        );
    }
}

/// Lengths that each are numbers, but no string together.
#[test]
fn a_string_longer_than_all_numbers_has_no_responses() {
    let section = Section {
        repeat: 2,
        parts: vec![pipe(1e308)],
    };
    let string = Drillstring::new(STEEL, vec![section], 10.0).unwrap();
    let off = DrillstringError::SiteOffString {
        distance: 0.0,
        length: f64::INFINITY,
    };
    for method in methods() {
        let found = responses(&string, &method, &request(Sites::bit(), vec![TORSION()]));
        assert_eq!(found, Err(BuildError::Sites(off.clone())));
    }
}

/// A collar of a million kilometres next to a drillpipe of centimetres: 10¹² elements.
#[test]
fn more_elements_than_are_made_are_refused() {
    let sections = [(2, 0.01), (1, 1e9)].map(|(repeat, length)| Section {
        repeat,
        parts: vec![pipe(length)],
    });
    let string = Drillstring::new(STEEL, sections.to_vec(), 10.0).unwrap();
    let method = Method::FiniteElement(FiniteElement::default());
    let found = responses(&string, &method, &request(Sites::bit(), vec![IN_BENDING()]));
    assert!(matches!(found, Err(BuildError::TooManyElements { .. })));
}

#[test]
fn forces_that_do_not_fit_the_sites_are_refused() {
    let (string, sites) = (string(3), Sites::bit());
    let row = |steps: usize| vec![0.0; steps];
    for forces in [
        [vec![row(3)], vec![]],
        [vec![row(3)], vec![row(2)]],
        [vec![row(3), row(3)], vec![row(3), row(3)]],
    ] {
        let found = whole(&string, &sites).reconstruct(&forces, &[0]);
        assert_eq!(found, Err(BuildError::Forces));
    }
}

#[test]
fn responses_put_together_by_hand_are_checked() {
    let string = string(3);
    let sites = Sites::new(&string, &[0.0, 10.0]).unwrap();
    let asked = request(sites, vec![TORSION()]);
    let good = responses(&string, &Method::Quadrature, &asked).unwrap();
    assert_eq!((good.sites.bit_site(), good.check()), (Some(1), Ok(())));
    let motions = |string: &Drillstring, frequency: f64| {
        ExactMotions::in_torsion(string, &good.sites, frequency).unwrap()
    };
    let own = motions(&string, good.sampling_frequency);
    assert!(own.error_of(&good).is_ok());
    type Change = fn(&mut Responses);
    let changes: [(Change, ResponseError); 8] = [
        (
            |it| it.sampling_frequency = 0.0,
            ResponseError::SamplingFrequency { value: 0.0 },
        ),
        (
            |it| it.channels[0].loads[0] = 2,
            ResponseError::NoSuchSite { site: 2, sites: 2 },
        ),
        (|it| it.sites = Sites::bit(), ResponseError::Shape),
        (
            |it| it.channels[0].from_surface[1].clear(),
            ResponseError::Shape,
        ),
        (
            |it| it.channels[0].from_loads[1].clear(),
            ResponseError::Shape,
        ),
        (
            |it| it.channels.push(it.channels[0].clone()),
            ResponseError::Shape,
        ),
        (
            |it| it.channels[0].from_loads[1][0][5] = f64::NAN,
            ResponseError::NotFinite,
        ),
        (
            |it| it.channels[0].from_loads[0][0][0] = 0.0,
            ResponseError::Instant {
                site: 0,
                value: 0.0,
            },
        ),
    ];
    for (change, expected) in changes {
        let mut bad = good.clone();
        change(&mut bad);
        assert_eq!(bad.check(), Err(expected));
        assert_eq!(bad.torsion_margin(), Err(expected.into()));
        assert_eq!(own.error_of(&bad), Err(expected.into()));
    }
    let other = motions(&self::string(4), good.sampling_frequency);
    let other_string = Err(ResponseError::OtherString.into());
    assert_eq!(other.error_of(&good), other_string);
    let other = motions(&string, 0.5 * good.sampling_frequency);
    let other_steps = Err(ResponseError::OtherSites.into());
    assert_eq!(other.error_of(&good), other_steps);
    let channel = Channel::Bending;
    let in_bending = |responses: &Responses, duration: f64| {
        let (sites, frequency) = (&responses.sites, responses.sampling_frequency);
        let support = SurfaceSupport::Free;
        ExactMotions::in_bending(&string, &BENDING, support, sites, duration, frequency)?
            .error_of(responses)
    };
    let none = in_bending(&good, 0.1);
    assert_eq!(none, Err(ResponseError::NoChannel { channel }.into()));

    let request = request(Sites::bit(), vec![IN_BENDING()]);
    let bending = responses(&string, &Method::Quadrature, &request).unwrap();
    let error = |duration: f64| in_bending(&bending, duration);
    assert!(error(0.1).is_ok());
    for duration in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_names(error(duration), "duration");
    }
    let mut short = bending.clone();
    short.longest_time *= 2.0;
    assert!(matches!(short.check(), Err(ResponseError::TooShort { .. })));
}

#[test]
fn a_margin_of_nothing_is_refused() {
    let margin = |inputs: usize, taps: [&[f64]; 4]| {
        positive_real_margin(inputs, Ending::Whole, |output, input| {
            taps[2 * output + input]
        })
    };
    let one: &[f64] = &[1.0];
    for (inputs, taps) in [
        (0, [one; 4]),
        (1, [&[]; 4]),
        (2, [one, one, one, &[1.0, 0.5]]),
    ] {
        assert_eq!(margin(inputs, taps), Err(ResponseError::Shape.into()));
    }
    let none = [one, one, one, &[f64::NAN]];
    assert_eq!(margin(2, none), Err(ResponseError::NotFinite.into()));
}
