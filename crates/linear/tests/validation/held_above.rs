//! A string that is held sideways above a place bends as one that ends there, by every method, and
//! turns as a whole.

use linear::bending_modes::BendingModes;
use linear::elements::reconstruction::WholeString;
use linear::method::{FiniteElement, Transform};
use linear::natural_frequencies::NaturalFrequencies;
use linear::{
    AxialForce, Bending, ChannelRequest, Drillstring, Hole, HoleSection, Material, Method, Mud,
    Request, Section, Sites, SteppedString, SurfaceSupport, Tube,
};

const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

const BENDING: Bending = Bending {
    youngs_modulus: 210e9,
    damping: 150.0,
    compression: 0.0,
};

/// Pipe of a length, m.
fn pipe(length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.05,
        outer_radius: 0.06,
    }
}

const JOINT: Tube = Tube {
    length: 0.5,
    inner_radius: 0.05,
    outer_radius: 0.08,
};

const COLLARS: Tube = Tube {
    length: 60.0,
    inner_radius: 0.04,
    outer_radius: 0.1,
};

/// Where it is held, m from the bit: 4 m above a joint.
const HELD: f64 = 60.0 + 5.0 * 9.5 + 4.5;

/// Some tubes, then pipe with joints and collars, in mud in a hole of two widths, pulled above and
/// pushed below.
fn above_collars(uppermost: Option<Tube>, cells: usize, hole: [f64; 2]) -> Drillstring {
    let of = |repeat: usize, parts: Vec<Tube>| Section { repeat, parts };
    let uppermost = uppermost.map(|tube| of(1, vec![tube, JOINT]));
    let rest = [of(cells, vec![pipe(9.0), JOINT]), of(1, vec![COLLARS])];
    let string = Drillstring::new(STEEL, uppermost.into_iter().chain(rest).collect(), 0.05);
    let string = string.unwrap().with_loss_factor(0.002).unwrap();
    let length = string.length();
    let hole = Hole {
        sections: vec![
            HoleSection {
                length: hole[0],
                radius: 0.2,
            },
            HoleSection {
                length: hole[1],
                radius: 0.15,
            },
        ],
        mud: Mud {
            density: 1300.0,
            viscosity: 0.02,
        },
    };
    let pieces = [(length - 80.0, 9e3), (80.0, -4e3)];
    let pieces = pieces.map(|(length, tension)| AxialForce { length, tension });
    let string = string.in_hole(hole).unwrap();
    string.under_axial_force(pieces.to_vec()).unwrap()
}

/// The whole string, 345 m, held there.
fn held() -> Drillstring {
    above_collars(None, 30, [245.0, 100.0])
        .held_above(HELD)
        .unwrap()
}

/// The same from there on.
fn cut() -> Drillstring {
    above_collars(Some(pipe(4.0)), 5, [HELD - 100.0, 100.0])
}

fn sites(string: &Drillstring) -> Sites {
    Sites::new(string, &[90.0, 61.3, 20.0, 0.0]).unwrap()
}

fn methods() -> [Method; 6] {
    [
        Method::Held,
        Method::Quadrature,
        Method::Trapezoidal,
        Method::FiniteElement(FiniteElement::default()),
        Method::Hilbert(Transform::default()),
        Method::DirectIdft(Transform::default()),
    ]
}

fn taps(string: &Drillstring, method: &Method, channel: ChannelRequest) -> Vec<Vec<f64>> {
    let request = Request {
        sites: sites(string),
        channels: vec![channel],
        sampling_frequency: 400.0,
        longest_time: 4.0,
    };
    let mut found = linear::responses(string, method, &request).unwrap();
    let channel = found.channels.remove(0);
    [channel.from_surface, channel.from_loads.concat()].concat()
}

#[test]
fn val_a_string_held_above_a_place_bends_as_one_that_ends_there() {
    let (held, cut) = (held(), cut());
    assert!((cut.length() - held.bending_length()).abs() < 1e-9);
    for support in [
        SurfaceSupport::Free,
        SurfaceSupport::Pinned,
        SurfaceSupport::Clamped,
    ] {
        for method in methods() {
            let bends = |string: &Drillstring| {
                let bending = BENDING;
                taps(
                    string,
                    &method,
                    ChannelRequest::Bending { bending, support },
                )
            };
            for (found, expected) in bends(&held).iter().zip(bends(&cut)) {
                assert_near(found, &expected, 1e-8, (method.name(), support));
            }
        }
        let frequencies = |string: &Drillstring| {
            let found = NaturalFrequencies::bending(string, &BENDING, support).unwrap();
            let lowest = found.lowest(6).unwrap();
            let shape = found.shape(lowest[4], 30).unwrap();
            let length = string.length();
            let from_bit: Vec<f64> = shape.depths.iter().map(|depth| length - depth).collect();
            let modes = BendingModes::new(string, &BENDING, support).unwrap();
            (lowest, from_bit, shape.amplitudes, modes.mass())
        };
        let (found, expected) = (frequencies(&held), frequencies(&cut));
        for (found, expected) in [
            (&found.0, &expected.0),
            (&found.1, &expected.1),
            (&found.2, &expected.2),
            (&vec![found.3], &vec![expected.3]),
        ] {
            assert_eq!(found.len(), expected.len());
            for (found, expected) in found.iter().zip(expected) {
                // Shapes are those next to a resonance; their greatest amplitude is 1.
                let size = expected.abs().max(1.0);
                assert!((found - expected).abs() < 1e-5 * size, "{found} {expected}");
            }
        }
    }
}

/// Between its sites, too: depths are those of the whole string.
#[test]
fn val_what_moves_between_sites_of_a_held_string_is_below_where_it_is_held() {
    let shape = |string: &Drillstring| {
        let whole = WholeString {
            string,
            bending: &BENDING,
            support: SurfaceSupport::Pinned,
            sites: &sites(string),
            sampling_frequency: 400.0,
            parameters: FiniteElement::default(),
        };
        let pushed = vec![vec![50.0; 200]; 4];
        let mut found = whole
            .reconstruct(&[pushed.clone(), pushed], &[199])
            .unwrap();
        let from_bit: Vec<f64> = (found.depths.iter())
            .map(|depth| string.length() - depth)
            .collect();
        let [along, _] = found.shapes.remove(0);
        (from_bit, along)
    };
    let (found, expected) = (shape(&held()), shape(&cut()));
    assert!((found.0[0] - HELD).abs() < 1e-9 && found.1[0] == 0.0);
    for (found, expected) in [(&found.0, &expected.0), (&found.1, &expected.1)] {
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}

#[test]
fn val_a_string_held_above_a_place_turns_as_a_whole() {
    let whole = above_collars(None, 30, [245.0, 100.0]);
    let held = held();
    assert_ne!(whole.id(), held.id());
    for method in methods() {
        let turns = |string: &Drillstring| {
            let torques = vec![0, 3];
            taps(string, &method, ChannelRequest::Torsion { torques })
        };
        assert_eq!(turns(&whole), turns(&held), "{}", method.name());
    }
}

/// Stepped elements of a string that is held there have the taps of the same elements: sites a
/// fraction of a millimetre off the ends of parts leave no element so short that rounding in its
/// stiffness outweighs what holds the string. Taps, which bear it, keep what is so short.
#[test]
fn val_stepped_elements_are_stable_next_to_the_ends_of_joints() {
    let (held, parameters) = (held(), FiniteElement::default());
    // The upper ends of joints, and that of the collars.
    let ends: Vec<f64> = (0..4).map(|it| 60.5 + 9.5 * f64::from(it)).collect();
    for off in [0.0, 4e-5, -4e-5, 7e-4, -7e-4] {
        let places = ends.iter().rev().map(|end| end + off);
        let distances: Vec<f64> = places.chain([60.0 - off, 0.0]).collect();
        let sites = Sites::new(&held, &distances).unwrap();
        let frequency = 640.0;
        let request = Request {
            sites: sites.clone(),
            channels: vec![ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Pinned,
            }],
            sampling_frequency: frequency,
            longest_time: 10.0,
        };
        let method = Method::FiniteElement(parameters);
        let expected = linear::responses(&held, &method, &request).unwrap();
        let bends = SurfaceSupport::Pinned;
        let mesh = SteppedString::new(&held, &BENDING, bends, &sites, &parameters, frequency);
        let stepped = mesh.unwrap().responses(&[0, 5], 10.0).unwrap();
        let rows = |found: &linear::ChannelResponses, loads: [usize; 2]| -> Vec<Vec<f64>> {
            let rows = found.from_loads.iter();
            rows.flat_map(|row| loads.map(|load| row[load].clone()))
                .collect()
        };
        let expected = rows(&expected.channels[0], [0, 5]);
        for (found, expected) in rows(&stepped.channels[1], [0, 1]).iter().zip(&expected) {
            // Joints of half a metre, of which up to 0.7 mm are another tube's.
            assert_near(found, expected, 1e-3, off);
        }
    }
}

fn assert_near(found: &[f64], expected: &[f64], part: f64, what: impl std::fmt::Debug) {
    let peak = expected
        .iter()
        .fold(0.0, |most: f64, it| most.max(it.abs()));
    let apart = (found.iter().zip(expected)).map(|(one, other)| (one - other).abs());
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < part * peak, "{what:?}: {apart:e} of {peak:e}");
}
