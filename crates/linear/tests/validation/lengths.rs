//! How long responses in torsion are, and what is known of it before they are built.

use linear::method::FiniteElement;
use linear::passivity::Ending;
use linear::{
    Bending, Budget, BuildError, CascadePlan, ChannelRequest, Drillstring, Method, Request,
    ResponsePlan, Section, Sites, SurfaceSupport, TopDrive, Tube, responses,
};
use problems::academic;
use problems::wells::{Draw, Well, with_loss};
use proptest::prelude::*;

/// Elements without numerical damping, too: what is infinitely stiff rings for ever by these.
fn methods() -> [Method; 5] {
    let undamped = FiniteElement {
        gamma: 0.5,
        ..FiniteElement::default()
    };
    [
        Method::FiniteElement(undamped),
        Method::Held,
        Method::Quadrature,
        Method::Trapezoidal,
        Method::FiniteElement(Default::default()),
    ]
}

fn string(pipe: f64, collars: f64, damping: f64) -> Drillstring {
    let tube = |length, outer_radius| Tube {
        length,
        inner_radius: 0.04,
        outer_radius,
    };
    let sections = [tube(pipe, 0.06), tube(collars, 0.1)].map(|tube| Section {
        repeat: 1,
        parts: vec![tube],
    });
    Drillstring::new(academic::string().material(), sections.to_vec(), damping).unwrap()
}

fn request(string: &Drillstring, longest_time: f64, sampling_frequency: f64) -> Request {
    Request {
        sites: Sites::new(string, &[0.0]).unwrap(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency,
        longest_time,
    }
}

/// From none to what lets nothing come back.
fn any_damping() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        (-2.0..2.5f64).prop_map(|power| 10f64.powf(power))
    ]
}

fn any_string() -> impl Strategy<Value = Drillstring> {
    (100.0..5000.0f64, 20.0..200.0f64, any_damping())
        .prop_map(|(pipe, collars, damping)| string(pipe, collars, damping))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20, failure_persistence: None, ..Default::default() })]

    /// As long as the longest case or as they last, and no longer than was planned.
    #[test]
    fn val_responses_last_to_the_end_of_the_longest_case_and_no_longer_than_planned(
        string in any_string(),
        longest_time in 0.5..40.0f64,
        sampling_frequency in 50.0..700.0f64,
    ) {
        let request = request(&string, longest_time, sampling_frequency);
        let needed = (longest_time * sampling_frequency).ceil() as usize + 1;
        for method in methods() {
            let plan = ResponsePlan::new(&string, &method, &request).unwrap();
            let planned = plan.torsion_taps();
            let found = plan.build(&Budget::unlimited()).unwrap();
            let found = found.torsion().unwrap();
            let name = method.name();
            prop_assert!(found.taps() <= planned, "{name}: {} {planned}", found.taps());
            let is_enough = found.ending == Ending::Whole || found.taps() >= needed;
            prop_assert!(is_enough, "{}: {} {needed}", method.name(), found.taps());
        }
    }

    /// The last tap that a case can use is a whole one, whether the response ends with the case
    /// or has decayed by then.
    #[test]
    fn val_no_tap_of_the_longest_case_depends_on_its_length(
        pipe in 500.0..5000.0f64,
        longest_time in 0.5..20.0f64,
        sampling_frequency in 50.0..700.0f64,
        damping in any_damping(),
    ) {
        let string = string(pipe, 100.0, damping);
        let bending = Bending { damping: 100.0 * damping, ..academic::BENDING };
        let mut request = request(&string, longest_time, sampling_frequency);
        request.channels.push(ChannelRequest::Bending { bending, support: SurfaceSupport::Free });
        let longer = Request { longest_time: longest_time + 20.0, ..request.clone() };
        let needed = (longest_time * sampling_frequency).ceil() as usize + 1;
        for method in methods() {
            let [found, longer] = [&request, &longer].map(|request| {
                let found = responses(&string, &method, request).unwrap();
                let channels = [found.torsion().unwrap(), found.bending().unwrap()];
                channels.map(|channel| channel.from_loads[0][0].clone())
            });
            for (found, longer) in found.iter().zip(&longer) {
                let largest = longer.iter().fold(0.0f64, |most, tap| most.max(tap.abs()));
                let tap = |taps: &[f64], index| taps.get(index).copied().unwrap_or(0.0);
                for index in 0..needed {
                    let off = (tap(found, index) - tap(longer, index)).abs() / largest;
                    prop_assert!(off < 3e-8, "{}: {off}", method.name());
                }
            }
        }
    }
}

/// A string in a well, below a drive where its number is odd, what is asked of it.
fn drawn(number: usize) -> (Drillstring, Request) {
    let mut draw = Draw::new(number);
    let string = Well::draw(number, &mut draw).string;
    let drive = TopDrive {
        inertia: draw.log_uniform(200.0, 5000.0),
        proportional_gain: draw.log_uniform(50.0, 20_000.0),
        integral_gain: draw.log_uniform(10.0, 20_000.0),
        delay: 0.0,
        late_inertia: 0.0,
    };
    let string = match number % 2 {
        0 => string,
        _ => string.with_top_drive(drive).unwrap(),
    };
    let (frequency, time) = (draw.log_uniform(20.0, 300.0), draw.log_uniform(1.0, 100.0));
    let mut request = request(&string, time, frequency);
    if number % 4 > 1 {
        // Responses between two sites, too.
        let above = draw.uniform(0.01, 0.99) * string.length();
        request.sites = Sites::new(&string, &[above, 0.0]).unwrap();
        request.channels = vec![ChannelRequest::Torsion {
            torques: vec![0, 1],
        }];
    }
    if number % 5 == 4 {
        return (with_loss(&string, &mut draw), request);
    }
    (string, request)
}

/// Builds within what the plan asks for.
fn build_as_planned(number: usize, method: &Method) {
    let (string, request) = drawn(number);
    let plan = ResponsePlan::new(&string, method, &request).unwrap();
    let dry = Budget::unlimited();
    plan.ask(&dry).unwrap();
    let budget = Budget::new(dry.need().peak);
    let name = method.name();
    let built = plan.build(&budget);
    let built = built.unwrap_or_else(|error| panic!("{number} {name}: {error}"));
    let taps = built.torsion().unwrap().taps();
    assert!(taps <= plan.torsion_taps(), "{number} {name}: {taps}");
    assert!(budget.need().kept <= dry.need().kept, "{number} {name}");
    // Half of what was taken is refused, and nothing of it stays taken.
    let half = Budget::new(0.5 * budget.need().peak);
    let refused = plan.build(&half);
    let is_refused = matches!(refused, Err(BuildError::OutOfBudget(_)));
    assert!(is_refused && half.need().kept == 0.0, "{number} {name}");
}

/// No response of any string in a well, below a drive or none, takes more than its plan asks for
/// (nor did any of 3600 strings by any method when the bound was derived).
#[test]
fn val_no_response_outlasts_its_plan() {
    for number in 0..160 {
        // Those by `held` take longer to build.
        let is_tried = |method: &Method| number < 32 || *method != Method::Held;
        for method in methods().iter().filter(|method| is_tried(method)) {
            build_as_planned(number, method);
        }
    }
}

/// Of any string in any number of pieces, elements that hardly damp included (nor did any of 3000 strings
/// in a minute, and 8 of 6000 in five, when the bound was set).
#[test]
fn val_pieces_ring_no_longer_than_planned() {
    let mut longest: f64 = 0.0;
    for number in 0..60 {
        let mut draw = Draw::new(number);
        let mut string = Well::draw(number, &mut draw).string;
        let pieces = draw.log_uniform(1.0, 60.0) as usize;
        if number % 5 == 4 {
            string = with_loss(&string, &mut draw);
        }
        let length = string.length() / pieces as f64;
        let middles = (0..pieces).map(|piece| (piece as f64 + 0.5) * length);
        let places: Vec<f64> = middles.chain([0.0]).collect();
        let nodes = Sites::new(&string, &places).unwrap();
        let (frequency, time) = (draw.log_uniform(20.0, 400.0), 30.0);
        let elements = |gamma: f64| {
            let elements_per_cell = 1 + number % 20;
            Method::FiniteElement(FiniteElement {
                gamma,
                elements_per_cell,
                beta: None,
            })
        };
        for method in [Method::Quadrature, elements(0.52), elements(0.502)] {
            let plan = CascadePlan::new(&string, &method, &nodes, frequency, time).unwrap();
            let cascade = plan.build(&Budget::unlimited()).unwrap();
            let (most, planned) = (cascade.longest_response(), plan.taps());
            assert!(
                most <= planned,
                "{number} {}: {most} {planned}",
                method.name()
            );
            longest = longest.max(most as f64 / planned as f64);
        }
    }
    // Nor is more planned than it takes in every case.
    assert!(longest > 0.5, "{longest}");
}

#[test]
fn what_never_decays_is_refused_at_once_where_it_is_simulated_for_too_long() {
    let string = string(1000.0, 100.0, 0.0);
    let request = request(&string, 1e7, 640.0);
    for method in methods() {
        let refused = responses(&string, &method, &request).unwrap_err();
        let name = method.name();
        match method {
            // A sampling frequency does not change the steps of a lattice.
            Method::Held => {
                let is_of_lattice = matches!(refused, BuildError::TooManyImpulses { .. });
                assert!(is_of_lattice, "{name}");
                let words = refused.to_string();
                assert!(words.contains("give a shorter `time_s`, or another method"));
            }
            _ => assert!(matches!(refused, BuildError::TooManyTaps { .. }), "{name}"),
        }
    }
}

/// What rounding leaves does not cut what has not decayed: one pipe and its joint, on a lattice so
/// fine that its response takes millions of steps, held, winds up by its static stiffness.
#[test]
fn val_a_string_of_one_pipe_is_as_stiff_as_it_is() {
    let string = academic::string();
    let sections = vec![Section {
        repeat: 1,
        ..string.sections()[0].clone()
    }];
    let damping = string.torsional_damping();
    let string = Drillstring::new(string.material(), sections, damping).unwrap();
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: academic::SAMPLING_FREQUENCY,
        longest_time: 20.0,
    };
    let responses = linear::responses(&string, &Method::Held, &request).unwrap();
    let torsion = responses.torsion().unwrap();
    let (taps, from_surface) = (&torsion.from_loads[0][0], &torsion.from_surface[0]);
    // The torque that holds the bit while the surface turns by 1 rad/s.
    let (mut free, mut torques) = (0.0, Vec::new());
    for step in 0..(20.0 * academic::SAMPLING_FREQUENCY) as usize {
        free += from_surface.get(step).copied().unwrap_or(0.0);
        let held: f64 = (taps.iter().skip(1).zip(torques.iter().rev()))
            .map(|(tap, torque): (&f64, &f64)| tap * torque)
            .sum();
        torques.push((free - held) / taps[0]);
    }
    // Over many periods of what rings on.
    let half = torques.len() / 2;
    let mean = |torques: &[f64]| torques.iter().sum::<f64>() / torques.len() as f64;
    let rise = mean(&torques[half..]) - mean(&torques[..half]);
    let stiffness = rise / (half as f64 / academic::SAMPLING_FREQUENCY);
    let expected = linear::estimates::torsional_stiffness(&string);
    assert!(
        (stiffness / expected - 1.0).abs() < 1e-2,
        "{stiffness} {expected}"
    );
}
