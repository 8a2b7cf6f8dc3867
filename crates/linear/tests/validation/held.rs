//! Validation of `held`: closed forms, waves handed on in time without a transform, the
//! exact waves inverted numerically, and passivity on random strings.

use linear::deviation::{ExactMotions, exact_undershoot};
use linear::estimates::{
    largest_undershoot, torsional_impedance, torsional_stiffness, torsional_travel_time,
};
use linear::passivity::Ending;
use linear::waves::lattice::Lattice;
use linear::{
    Bending, Budget, BuildError, Channel, ChannelRequest, Drillstring, ImpulseTrains, Method,
    Request, ResponsePlan, Responses, Section, Sites, SurfaceSupport, Tube,
};
use problems::academic::{self, BENDING, tube};
use problems::oracles::{assert_close, relative_difference};
use problems::plain_lattice::PlainLattice;
use proptest::prelude::*;

fn string_of(sections: Vec<Section>, torsional_damping: f64) -> Drillstring {
    let material = academic::string().material();
    Drillstring::new(material, sections, torsional_damping).unwrap()
}

/// One tube of a kilometre.
fn uniform() -> Drillstring {
    let whole = Section {
        repeat: 1,
        parts: vec![tube(1000.0, 0.15)],
    };
    string_of(vec![whole], 10.0)
}

fn at_bit(string: &Drillstring, sampling_frequency: f64, longest_time: f64) -> Responses {
    let request = Request {
        sampling_frequency,
        ..academic::bit_request(longest_time)
    };
    linear::responses(string, &Method::Held, &request).unwrap()
}

/// The modified Bessel function I₀, by its series.
fn bessel_i0(x: f64) -> f64 {
    let terms = (1..60).scan(1.0, |term, k| {
        *term *= (0.5 * x / f64::from(k)).powi(2);
        Some(*term)
    });
    1.0 + terms.sum::<f64>()
}

/// After a step of torque a uniform tube turns as an endless one does, e^(−at/2) I₀(at/2)/Z₀
/// with a = c_t/(ρJ), until the front has been to the surface and back; that lowers it by
/// twice what damping leaves of it. Where f_s fits, no step has both.
#[test]
fn val_the_front_of_a_uniform_tube_comes_back_as_it_left() {
    let string = uniform();
    let pipe = &string.sections()[0].parts[0];
    let impedance = torsional_impedance(&string, pipe);
    let inertia = string.material().density * pipe.polar_moment();
    let rate = string.torsional_damping() / inertia;
    let travel = torsional_travel_time(&string);
    let undershoot = (-rate * travel).exp() * (2.0 - bessel_i0(rate * travel)) / impedance;
    assert_close(exact_undershoot(&string).unwrap(), undershoot, 3e-4);
    for steps_to_bit in [25.0, 200.0, 2000.0] {
        let sampling_frequency = steps_to_bit / travel;
        let responses = at_bit(&string, sampling_frequency, 60.0);
        let taps = responses.at_bit().unwrap();
        let mut speed = 0.0;
        for (step, tap) in taps.iter().take(2 * steps_to_bit as usize).enumerate() {
            speed += tap;
            let half = 0.5 * rate * (step as f64 + 0.5) / sampling_frequency;
            assert_close(speed, (-half).exp() * bessel_i0(half) / impedance, 2e-4);
        }
        // The lowest of the means over a step, half a step after the front.
        assert_close(
            largest_undershoot(taps),
            undershoot,
            0.3 / steps_to_bit + 3e-4,
        );
    }
}

/// Taps of impulses that are one step apart are the impulses.
#[test]
fn val_a_step_as_long_as_a_piece_gives_the_waves_handed_on_in_time() {
    let string = academic::string();
    let lattice = Lattice::new(&string, &Sites::bit()).unwrap();
    assert!(lattice.misfit < 1e-12);
    let piece = lattice.step * string.torsional_wave_speed();
    let responses = at_bit(&string, 1.0 / lattice.step, 3.0);
    let mut plain = PlainLattice::new(&string, piece);
    for (step, tap) in responses.at_bit().unwrap().iter().take(10_000).enumerate() {
        let torque = if step == 0 { 1.0 } else { 0.0 };
        let speed = plain.advance(0.0, |_| torque);
        assert!((speed - tap).abs() < 1e-9 * plain.compliance(), "{step}");
    }
    let mut plain = PlainLattice::new(&string, piece);
    let from_surface = &responses.torsion().unwrap().from_surface[0];
    for (step, tap) in from_surface.iter().take(10_000).enumerate() {
        let surface = if step == 0 { 1.0 } else { 0.0 };
        let speed = plain.advance(surface, |_| 0.0);
        assert!((speed - tap).abs() < 1e-9, "{step}");
    }
}

/// Uniform, plain pipe and collar, jointed, three sections: 100 m to 5 km, lightly and
/// heavily damped.
fn any_string() -> impl Strategy<Value = Drillstring> {
    let tubes = (0.03..0.06f64, 1.2..2.0f64, 1.05..1.5f64, 0.3..0.8f64);
    let kind = (0..4usize, 100.0..5000.0f64, 0.05..0.3f64, 8.0..14.0f64);
    (tubes, kind, 0.1..4.0f64).prop_map(|((inner, ratio, wider, joint), kind, loss)| {
        let (kind, length, collars, pipe) = kind;
        let of = |length: f64, outer_radius: f64| Tube {
            length,
            inner_radius: inner,
            outer_radius,
        };
        let outer = inner * ratio;
        let plain = |length: f64, outer: f64| Section {
            repeat: 1,
            parts: vec![of(length, outer)],
        };
        let jointed = |length: f64, pipe: f64, outer: f64| Section {
            repeat: ((length / pipe) as usize).max(1),
            parts: vec![of(pipe - joint, outer), of(joint, outer * wider)],
        };
        let sections = match kind {
            0 => vec![plain(length, outer)],
            1 => vec![
                plain(length * (1.0 - collars), outer),
                plain(length * collars, outer * 1.4),
            ],
            2 => vec![jointed(length, pipe, outer)],
            _ => vec![
                jointed(length * (0.9 - collars), pipe, outer),
                jointed(length * 0.1, 0.97 * pipe, 1.1 * outer),
                plain(length * collars, outer * 1.6),
            ],
        };
        // What is left of a wave after its way to the bit is e^(−loss).
        let undamped = string_of(sections.clone(), 0.0);
        let damped = 2.0 * loss / torsional_travel_time(&undamped);
        let moment = of(1.0, outer).polar_moment();
        string_of(sections, damped * undamped.material().density * moment)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10, failure_persistence: None, ..Default::default() })]

    /// Taps run until they have decayed to 1e-8 of their sum are as passive as that; where heavy
    /// damping lets torque only seep, what was never computed is some times as much.
    #[test]
    fn val_held_taps_of_any_string_are_passive_at_any_sampling_frequency(
        string in any_string(),
        steps_to_bit in 3.0..300.0f64,
    ) {
        let travel = torsional_travel_time(&string);
        let responses = at_bit(&string, steps_to_bit / travel, 100.0 * travel);
        let taps = responses.at_bit().unwrap();
        let tail = 1e-8 * taps.iter().map(|tap| tap.abs()).sum::<f64>() / taps[0];
        let margin = responses.torsion_margin().unwrap().unwrap();
        prop_assert!(margin >= -1e-9 - 16.0 * tail, "{margin} {tail}");
    }

    /// The lattice is the string that the exact waves are of, but for its misfit.
    #[test]
    fn val_held_taps_of_any_string_are_those_of_the_exact_waves(string in any_string()) {
        let travel = torsional_travel_time(&string);
        let responses = at_bit(&string, 160.0 / travel, 20.0 * travel);
        let frequency = responses.sampling_frequency;
        let motions = ExactMotions::in_torsion(&string, &Sites::bit(), frequency).unwrap();
        let error = motions.error_of(&responses).unwrap();
        let lattice = Lattice::new(&string, &Sites::bit()).unwrap();
        let misfit = lattice.misfit / travel;
        prop_assert!(error <= 1e-3 + 20.0 * misfit, "{error} {misfit}");
        prop_assert!(misfit <= 2e-3, "{misfit}");
        // No mean over a step is lower than the lowest, which comes early unless it is small.
        let lowest = exact_undershoot(&string).unwrap();
        let found = largest_undershoot(responses.at_bit().unwrap());
        let at_once = responses.at_bit().unwrap()[0];
        prop_assert!(found <= lowest.max(0.0) * (1.0 + 1e-6) + 1e-2 * at_once, "{found} {lowest}");
        // A torque held for ever winds the bit up by its static flexibility.
        let mut speed = 0.0;
        let mut wound_up = 0.0;
        for tap in responses.at_bit().unwrap() {
            speed += tap;
            wound_up += speed / responses.sampling_frequency;
        }
        if responses.torsion().unwrap().ending == Ending::Whole {
            let stiffness = torsional_stiffness(&string);
            prop_assert!((wound_up * stiffness - 1.0).abs() < 5e-4 + 4.0 * misfit);
        }
    }
}

/// In bending nothing is a front; means at both ends of a step are of second order.
#[test]
fn val_the_middle_of_a_step_is_of_second_order_in_bending() {
    let string = academic::string();
    let error = |sampling_frequency: f64| {
        let request = Request {
            sampling_frequency,
            channels: vec![ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Free,
            }],
            ..academic::bit_request(4.0)
        };
        let responses = linear::responses(&string, &Method::Held, &request).unwrap();
        assert!(responses.bending_margin().unwrap().unwrap() > 0.0);
        let (support, sites) = (SurfaceSupport::Free, &responses.sites);
        let frequency = sampling_frequency;
        ExactMotions::in_bending(&string, &BENDING, support, sites, 0.02, frequency)
            .and_then(|motions| motions.error_of(&responses))
            .unwrap()
    };
    let (coarse, fine) = (error(320.0), error(640.0));
    assert!(fine < 2e-3 && coarse / fine > 3.5, "{coarse} {fine}");
}

/// Trains of impulses serve any sampling frequency, and are not taken for those of another
/// string or a shorter time. What is held over two steps is held over each of them: a step
/// of twice the length has the taps (A(2n + 1) + 2 A(2n) + A(2n − 1))/2.
#[test]
fn val_trains_serve_all_sampling_frequencies_of_their_own_request() {
    let string = academic::string();
    let request = academic::bit_request(10.0);
    let trains = ImpulseTrains::new(&string, &request).unwrap().unwrap();
    let with_trains = |string: &Drillstring, request: &Request| -> Result<Responses, BuildError> {
        let plan = ResponsePlan::with_trains(string, &Method::Held, request, &trains)?;
        plan.build(&Budget::unlimited())
    };
    let taps = |sampling_frequency: f64| {
        let request = Request {
            sampling_frequency,
            ..request.clone()
        };
        let found = with_trains(&string, &request).unwrap();
        found.at_bit().unwrap().to_vec()
    };
    for frequency in [77.7, 640.0] {
        let (coarse, fine) = (taps(frequency), taps(2.0 * frequency));
        let at = |index: usize| fine.get(index).copied().unwrap_or(0.0);
        let joined: Vec<f64> = (0..coarse.len())
            .map(|n| {
                let before = n.checked_sub(1).map_or(0.0, |_| at(2 * n - 1));
                0.5 * (at(2 * n + 1) + 2.0 * at(2 * n) + before)
            })
            .collect();
        assert!(relative_difference(&joined, &coarse) < 1e-9);
    }
    let longer = academic::bit_request(20.0);
    assert!(with_trains(&string, &longer).is_err());
    let other = academic::damped_string(11.0);
    assert!(with_trains(&other, &request).is_err());
    let none = Request {
        channels: Vec::new(),
        ..request
    };
    assert_eq!(ImpulseTrains::new(&string, &none), Ok(None));
}

/// A heavy collar rings on for longer than is simulated, with all its fronts: what is left
/// out of the responses is no loss of passivity.
#[test]
fn val_what_rings_on_is_passive_too() {
    let part = |length: f64, outer_radius: f64| Tube {
        length,
        inner_radius: 0.04,
        outer_radius,
    };
    let pipe = Section {
        repeat: 300,
        parts: vec![part(9.6, 0.06), part(0.4, 0.08)],
    };
    let collar = Section {
        repeat: 1,
        parts: vec![part(250.0, 0.16)],
    };
    let string = string_of(vec![pipe, collar], 0.3);
    let responses = at_bit(&string, academic::SAMPLING_FREQUENCY, 10.0);
    assert_eq!(responses.torsion().unwrap().ending, Ending::Ringing);
    let margin = responses.torsion_margin().unwrap().unwrap();
    assert!(margin > -1e-9, "{margin}");
}

/// A short string with little damping, at three of its sites in torsion and bending, for a time (s).
fn lively(longest_time: f64) -> Responses {
    let part = |length: f64, inner_radius: f64, outer_radius: f64| Tube {
        length,
        inner_radius,
        outer_radius,
    };
    let pipe = Section {
        repeat: 4,
        parts: vec![part(9.0, 0.0543, 0.0635), part(1.0, 0.04, 0.085)],
    };
    let collar = Section {
        repeat: 1,
        parts: vec![part(47.0, 0.0357, 0.0826)],
    };
    let string = string_of(vec![pipe, collar], 0.5);
    let bending = Bending {
        youngs_modulus: 206e9,
        damping: 250.0,
        compression: 0.0,
    };
    let support = SurfaceSupport::Pinned;
    let request = Request {
        sites: Sites::new(&string, &[30.0, 7.0, 0.0]).unwrap(),
        channels: vec![
            ChannelRequest::Torsion {
                torques: vec![0, 1, 2],
            },
            ChannelRequest::Bending { bending, support },
        ],
        sampling_frequency: 320.0,
        longest_time,
    };
    linear::responses(&string, &Method::Held, &request).unwrap()
}

/// What is simulated ends long before the string is still, at its highest frequencies, too: the margin
/// does not depend on where.
#[test]
fn val_a_string_that_rings_on_is_passive_however_short_its_case() {
    for longest_time in [0.1, 0.3, 0.5, 1.0, 2.0, 5.0] {
        let responses = lively(longest_time);
        let margins = responses.margins(&Budget::unlimited()).unwrap();
        for margin in margins.map(Option::unwrap) {
            assert!((0.0..0.1).contains(&margin), "{longest_time}: {margin}");
        }
        assert_eq!(responses.margin_of_differences().unwrap(), margins[1]);
    }
}

/// A site that gives back a little of a frequency, low or high, or takes part of a step to answer, is not
/// passive, though its string rings on.
#[test]
fn val_a_string_that_rings_on_is_not_taken_for_passive_where_it_is_not() {
    let margin = |change: &dyn Fn(usize, f64) -> f64| {
        let mut responses = lively(1.0);
        let bending = (responses.channels.iter_mut()).find(|it| it.channel == Channel::Bending);
        let taps = &mut bending.unwrap().from_loads[2][2];
        let at_once = taps[0];
        for (index, tap) in taps.iter_mut().enumerate() {
            *tap += at_once * change(index, *tap / at_once);
        }
        responses.bending_margin().unwrap().unwrap()
    };
    assert!(margin(&|_, _| 0.0) > 0.0);
    for angle in [0.3f64, 1.2, 2.0, 2.9] {
        let gives_back = |index: usize, _| -0.05 * (angle * (index as f64 + 0.5)).sin();
        assert!(margin(&gives_back) < -0.01, "{angle}");
    }
    let is_late = |index: usize, tap: f64| if index == 0 { -0.9 * tap } else { 0.0 };
    assert!(margin(&is_late) < -0.01);
}

/// Between two sites at either side of the uppermost collar there are two tubes, both shorter
/// than any piece; they still hang together.
#[test]
fn val_sites_closer_than_a_piece_turn_together() {
    let string = academic::string();
    let request = Request {
        sites: Sites::new(&string, &[100.0001, 99.9999, 0.0]).unwrap(),
        channels: vec![ChannelRequest::Torsion {
            torques: vec![0, 1, 2],
        }],
        ..academic::bit_request(2.0)
    };
    let found = linear::responses(&string, &Method::Held, &request).unwrap();
    let taps = |from: usize, to: usize| found.torsion().unwrap().taps_between(from, to).unwrap();
    assert!(relative_difference(taps(2, 0), taps(2, 1)) < 0.05);
    assert!(
        taps(2, 0)
            .iter()
            .any(|tap| tap.abs() > 1e-3 * taps(2, 2)[0])
    );
}
