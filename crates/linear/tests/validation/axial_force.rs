//! Validation of the axial force in bending: closed forms of a hanging chain and of a column under
//! its own weight, waves compared with elements, and the promised tolerance of pieces.

use linear::bending_modes::BendingModes;
use linear::waves::lateral::BendingNetwork;
use linear::well::HangingString;
use linear::{
    AxialForce, Bending, ChannelRequest, Complex64, Drillstring, Hole, HoleSection, Method, Mud,
    Request, Section, Sites, SurfaceSupport, Tube,
};
use problems::academic::{self, BENDING};
use problems::pipes;
use proptest::prelude::*;

const GRAVITY: f64 = 9.806_65;

const MUD: Mud = Mud {
    density: 1500.0,
    viscosity: 0.0,
};

const UNDAMPED: Bending = Bending {
    damping: 0.0,
    ..BENDING
};

fn plain(length: f64, inner_radius: f64, outer_radius: f64) -> Drillstring {
    let tube = Tube {
        length: 10.0,
        inner_radius,
        outer_radius,
    };
    let sections = vec![Section {
        repeat: (length / 10.0).round() as usize,
        parts: vec![tube],
    }];
    Drillstring::new(academic::string().material(), sections, 0.0).unwrap()
}

/// A string that hangs in a vertical hole.
fn hanging(
    string: &Drillstring,
    bending: &Bending,
    weight_on_bit: f64,
    tolerance: f64,
) -> Drillstring {
    let hanging = HangingString::new(string, None, None);
    let force = hanging.axial_force(bending, weight_on_bit, tolerance);
    string.clone().under_axial_force(force).unwrap()
}

/// A chain swings at ω = j/2 √(g/L), j the zeros of Bessel's J₀; with buoyancy in mud.
#[test]
fn val_without_stiffness_it_swings_as_a_chain() {
    let string = plain(1000.0, 0.05, 0.07);
    let limp = Bending {
        youngs_modulus: 1e5,
        ..UNDAMPED
    };
    let mud = Mud {
        density: 1200.0,
        viscosity: 0.0,
    };
    let force = HangingString::new(&string, None, Some(mud)).axial_force(&limp, 0.0, 1e-3);
    let density = string.material().density;
    let buoyed = 1.0 - mud.density / density;
    let chain = string.clone().under_axial_force(force).unwrap();
    let modes = BendingModes::new(&chain, &limp, SurfaceSupport::Pinned).unwrap();
    for (index, zero) in [2.404_825_558, 5.520_078_110, 8.653_727_913]
        .into_iter()
        .enumerate()
    {
        let expected = 0.5 * zero * (buoyed * GRAVITY / 1000.0).sqrt();
        let found = modes.frequency(index).unwrap();
        assert!(
            (found / expected - 1.0).abs() < 2e-3,
            "{index}: {found} {expected}"
        );
    }
}

/// A long column, its lower end free, falls over at 1.018793 (E I w²)^⅓: with the slope θ it is
/// E I θ″ = (w z − F) θ, and no moment acts on the bit, so that Ai′(−F/(E I w²)^⅓) = 0.
#[test]
fn val_under_more_weight_than_airys_it_buckles() {
    for radius in [0.07, 0.12] {
        let string = plain(600.0, 0.05, radius);
        let tube = string.sections()[0].parts[0];
        let weight = string.material().density * tube.area() * GRAVITY;
        let rigidity = BENDING.youngs_modulus * tube.second_moment();
        let critical = 1.018_793 * libm::cbrt(rigidity * weight * weight);
        for support in [SurfaceSupport::Pinned, SurfaceSupport::Clamped] {
            // By elements that are counted, and by waves: at rest the bit pushes back or not.
            let buckled = |part: f64| {
                let string = hanging(&string, &UNDAMPED, part * critical, 1e-4);
                let modes = BendingModes::new(&string, &UNDAMPED, support).unwrap();
                let sites = Sites::bit();
                let network = BendingNetwork::new(&string, UNDAMPED, support, &sites).unwrap();
                let pushes_back = network.receptance(Complex64::new(1e-4, 0.0))[(0, 0)].re > 0.0;
                assert_eq!(modes.is_buckled(), !pushes_back, "{radius} {part}");
                modes.is_buckled()
            };
            assert!(!buckled(0.998) && buckled(1.002), "{radius}");
        }
    }
}

#[test]
fn val_no_force_changes_nothing_and_none_matters_in_torsion() {
    let string = academic::string();
    let none = vec![AxialForce {
        length: string.length(),
        tension: 0.0,
    }];
    let with = string.clone().under_axial_force(none).unwrap();
    let request = Request {
        sites: Sites::new(&string, &[33.0, 0.0]).unwrap(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Pinned,
            },
        ],
        sampling_frequency: 100.0,
        longest_time: 5.0,
    };
    for method in [Method::Held, Method::FiniteElement(Default::default())] {
        let one = linear::responses(&string, &method, &request).unwrap();
        let other = linear::responses(&with, &method, &request).unwrap();
        assert_eq!(one.torsion(), other.torsion());
        assert_eq!(one.bending(), other.bending());
        // In torsion no axial force matters, to the last bit.
        let hangs = hanging(&string, &BENDING, 2e4, 1e-2);
        let under = linear::responses(&hangs, &method, &request).unwrap();
        assert_eq!(
            one.torsion().unwrap().from_loads,
            under.torsion().unwrap().from_loads
        );
        assert_ne!(
            one.bending().unwrap().from_loads,
            under.bending().unwrap().from_loads
        );
    }
}

/// A push swings a hanging string, and tension brings it back: by filters of waves as by elements.
#[test]
fn val_a_hanging_string_comes_back() {
    let string = plain(200.0, 0.05, 0.07);
    let bending = Bending {
        damping: 30.0,
        ..BENDING
    };
    let string = hanging(&string, &bending, 0.0, 1e-3);
    for (support, rests) in [(SurfaceSupport::Pinned, 0.0), (SurfaceSupport::Free, 1.0)] {
        let request = Request {
            sites: Sites::new(&string, &[40.0]).unwrap(),
            channels: vec![ChannelRequest::Bending { bending, support }],
            sampling_frequency: 100.0,
            longest_time: 60.0,
        };
        let taps = |method: Method| {
            let responses = linear::responses(&string, &method, &request).unwrap();
            responses.bending().unwrap().from_loads[0][0].clone()
        };
        let elements = taps(Method::FiniteElement(Default::default()));
        let last = elements.len() - 1;
        // What a unit impulse leaves of motion: it is spread over all dashpots.
        let left = rests / (bending.damping * string.length() * 100.0);
        let largest = elements
            .iter()
            .fold(0.0, |most: f64, tap| most.max(tap.abs()));
        for method in [
            Method::Held,
            Method::Quadrature,
            Method::Hilbert(Default::default()),
        ] {
            let found = taps(method);
            let off = (found[last] - left).abs() / largest;
            assert!(off < 5e-3, "{} {support:?}: {off:e}", method.name());
            let apart = (found[last / 4] - elements[last / 4]).abs() / largest;
            assert!(apart < 5e-3, "{} {support:?}: {apart:e}", method.name());
        }
    }
}

/// However near to the end of a tube the hole changes.
#[test]
fn val_a_cut_next_to_a_joint_changes_no_frequency() {
    let string = hanging(&plain(2000.0, 0.05, 0.07), &UNDAMPED, 0.0, 1e-2);
    let frequency = |above: f64| {
        let section = |length| HoleSection {
            length,
            radius: 0.2,
        };
        let sections = vec![section(above), section(2000.0 - above)];
        let string = string.clone().in_hole(Hole { sections, mud: MUD }).unwrap();
        let modes = BendingModes::new(&string, &UNDAMPED, SurfaceSupport::Pinned).unwrap();
        assert!(!modes.is_buckled());
        modes.frequency(0).unwrap()
    };
    let whole = frequency(1000.0);
    for offset in [1e-5, 1e-3, 0.1, 1.0] {
        let found = frequency(1000.0 + offset);
        assert!(
            (found / whole - 1.0).abs() < 1e-4,
            "{offset}: {found} {whole}"
        );
    }
}

#[test]
fn val_elements_have_this_number_of_frequencies_and_no_more() {
    let string = plain(10.0, 0.05, 0.07);
    let modes = BendingModes::new(&string, &UNDAMPED, SurfaceSupport::Free).unwrap();
    // Two at each of five nodes, the first two of them as a rigid rod.
    assert_eq!([0, 1].map(|index| modes.frequency(index)), [Some(0.0); 2]);
    assert!((2..10).all(|index| modes.frequency(index).is_some_and(|it| it > 0.0)));
    assert_eq!(modes.frequency(10), None);
}

#[test]
fn what_no_axial_force_can_be_is_refused() {
    let string = pipes::row(10, 0.0);
    let under = |pieces: &[(f64, f64)]| {
        let piece = |&(length, tension): &(f64, f64)| AxialForce { length, tension };
        string
            .clone()
            .under_axial_force(pieces.iter().map(piece).collect())
            .is_ok()
    };
    assert!(under(&[(40.0, 1e5), (60.0, -1e4)]));
    assert!(!under(&[(40.0, 1e5), (70.0, -1e4)]));
    assert!(!under(&[(40.0, 1e5), (60.0, f64::NAN)]));
    assert!(!under(&[(-40.0, 1e5), (140.0, 0.0)]));
}

fn strings() -> impl Strategy<Value = Drillstring> {
    (
        (3usize..300, 1usize..25),
        (0.05..0.08f64, 0.08..0.13f64),
        prop::bool::ANY,
    )
        .prop_map(|((pipes, collars), (radius, collar), jointed)| {
            let tube = |length, outer_radius| Tube {
                length,
                inner_radius: 0.04,
                outer_radius,
            };
            let mut parts = vec![tube(9.5, radius)];
            if jointed {
                parts.push(tube(0.5, 1.3 * radius));
            }
            let pipes = Section {
                repeat: pipes,
                parts,
            };
            let collars = Section {
                repeat: 1,
                parts: vec![tube(9.0 * collars as f64, collar)],
            };
            let sections = vec![pipes, collars];
            Drillstring::new(academic::string().material(), sections, 0.0).unwrap()
        })
}

fn supports() -> impl Strategy<Value = SurfaceSupport> {
    prop_oneof![Just(SurfaceSupport::Pinned), Just(SurfaceSupport::Clamped)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..Default::default() })]

    /// Natural frequencies keep the tolerance that pieces were asked for, up to four fifths of
    /// the weight under which the string buckles.
    #[test]
    fn val_pieces_keep_the_tolerance(
        (string, support) in (strings(), supports()),
        weight_on_bit in 0.0..2e4f64,
        tolerance in prop_oneof![Just(1e-2), Just(1e-3)],
    ) {
        let modes = |tolerance| {
            let string = hanging(&string, &UNDAMPED, weight_on_bit, tolerance);
            BendingModes::new(&string, &UNDAMPED, support).unwrap()
        };
        let (found, exact) = (modes(tolerance), modes(1e-7));
        let heavier = hanging(&string, &UNDAMPED, 1.25 * weight_on_bit, 1e-2);
        let heavier = BendingModes::new(&heavier, &UNDAMPED, support).unwrap();
        prop_assume!(!heavier.is_buckled() && !exact.is_buckled());
        for index in [0, 1, 2, 5, 10, 20, 40] {
            // Shorter waves are not those of the string but of elements that pieces cut.
            if index as f64 * 20.0 > string.length() {
                break;
            }
            let (found, exact) = (found.frequency(index).unwrap(), exact.frequency(index).unwrap());
            prop_assert!((found / exact - 1.0).abs() <= tolerance, "{index}: {found} {exact}");
        }
    }

    /// The waves' receptance at the bit changes its sign through infinity where elements have a
    /// natural frequency, and further sites change nothing.
    #[test]
    fn val_waves_and_elements_have_the_same_natural_frequencies(
        (string, support) in (strings(), supports()),
        weight_on_bit in 0.0..2e4f64,
        place in 0.1..0.9f64,
        hole in prop::option::of((0.01..0.99f64, 0.2..0.4f64, 0.2..0.4f64)),
    ) {
        let mut string = hanging(&string, &UNDAMPED, weight_on_bit, 1e-2);
        let dry = BendingModes::new(&string, &UNDAMPED, support).unwrap();
        prop_assume!(!dry.is_buckled());
        if let Some((part, above, below)) = hole {
            let section = |part: f64, radius| HoleSection { length: part * string.length(), radius };
            let sections = vec![section(part, above), section(1.0 - part, below)];
            let modes = |radius| {
                let sections = vec![section(1.0, radius)];
                let string = string.clone().in_hole(Hole { sections, mud: MUD }).unwrap();
                BendingModes::new(&string, &UNDAMPED, support).unwrap().frequency(3).unwrap()
            };
            let (wide, narrow) = (modes(above.max(below)), modes(above.min(below)));
            string = string.in_hole(Hole { sections, mud: MUD }).unwrap();
            // Mud slows it, and more in a narrow hole.
            let found = BendingModes::new(&string, &UNDAMPED, support).unwrap().frequency(3).unwrap();
            let between = narrow * (1.0 - 1e-4)..=wide * (1.0 + 1e-4);
            prop_assert!(between.contains(&found) && wide <= dry.frequency(3).unwrap(), "{between:?} {found}");
        }
        let modes = BendingModes::new(&string, &UNDAMPED, support).unwrap();
        let sites = Sites::bit();
        let network = BendingNetwork::new(&string, UNDAMPED, support, &sites).unwrap();
        for index in [0, 1, 4] {
            let frequency = modes.frequency(index).unwrap();
            let at = |part: f64| network.at_rate(part * frequency)[(0, 0)].re;
            let (below, above) = (at(1.0 - 1e-4), at(1.0 + 1e-4));
            prop_assert!(below > 0.0 && above < 0.0, "{index} {frequency}: {below} {above}");
        }
        let distances = [place * string.length(), 0.0];
        let two = Sites::new(&string, &distances).unwrap();
        let further = BendingNetwork::new(&string, UNDAMPED, support, &two).unwrap();
        let s = Complex64::new(0.3, 2.0);
        let (one, other) = (network.receptance(s)[(0, 0)], further.receptance(s)[(1, 1)]);
        prop_assert!((one / other - 1.0).norm() < 1e-7, "{one} {other}");
    }
}
