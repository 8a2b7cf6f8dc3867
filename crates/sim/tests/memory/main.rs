//! Validation of what builders ask a budget for, against what an allocator counts: a separate
//! program, for the allocator counts all threads.

use linear::budget::{Budget, Need};
use linear::method::{FiniteElement, Transform};
use linear::{ChannelRequest, Method, Request, ResponsePlan, Sites, SurfaceSupport};
use peak_alloc::PeakAlloc;
use problems::academic::BENDING;
use problems::wells::{Draw, Well};
use sim::{Simulator, SimulatorPlan};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Work that takes less than this, bytes, is not compared: plans of transforms that a thread keeps
/// for the next, a few megabytes, count for the work that made them.
const LEAST: f64 = 8.0 * 1024.0 * 1024.0;

/// Plans of transforms that a thread keeps for the next, bytes: more than was asked for may be taken
/// by as much, and less by a thread that has them already, and which thread does what is left to the machine.
const KEPT_BY_THREADS: f64 = 2.0 * 1024.0 * 1024.0;

/// What is asked for, at most, as a multiple of what is taken. It is asked for transforms of lengths
/// that do not factorise: up to 60 bytes a sample, where others take 8 for their output, and a thread
/// may have the plan already. Of C responses each sample takes 8C bytes for spectra, 8 for one of
/// them, and a quarter of responses that continue is kept: (8C + 68 + 2C)/(8C + 16 + 2C), 1.93 with C = 4. Of the
/// margin of two sites it takes 4 for each of three pairs, 8 for an input and 8 for an output, where it is asked for what
/// another transform left and a plan as well: (12 + 40)/(12 + 16).
/// Simulators have more series to each transform than either.
const MOST_ASKED: f64 = 2.0;

/// The same of all work together: simulators, which take half as much where responses are the same in both
/// directions, are asked for nearly to the byte.
const ASKED_IN_ALL: std::ops::Range<f64> = 1.0..1.6;

/// Bytes asked for and taken by all work that is compared.
#[derive(Default)]
struct Sums {
    asked: f64,
    taken: f64,
}

impl Sums {
    /// Does a piece of work, and compares what it asked for with the most that it took.
    fn compare<T>(&mut self, what: &str, work: impl FnOnce(&Budget) -> T) -> (T, Need) {
        let (budget, before) = (Budget::unlimited(), ALLOCATOR.current_usage());
        ALLOCATOR.reset_peak_usage();
        let done = work(&budget);
        let taken = ALLOCATOR.peak_usage().saturating_sub(before) as f64;
        let asked = budget.need();
        if taken > LEAST {
            let asked = asked.peak;
            assert!(asked >= taken - KEPT_BY_THREADS, "{what}: {asked} {taken}");
            let most = MOST_ASKED * taken + KEPT_BY_THREADS;
            assert!(asked <= most, "{what}: {asked} {taken}");
            self.asked += asked;
            self.taken += taken;
        }
        (done, asked)
    }
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

/// A string in a well with a number of sites, whose torques act on all.
fn request(number: usize, bends: bool) -> (linear::Drillstring, Request) {
    let mut draw = Draw::new(number);
    let string = Well::draw(number, &mut draw).string;
    let count = draw.log_uniform(1.0, 6.0) as usize;
    let length = string.length() / count as f64;
    let middles = (0..count).map(|piece| (piece as f64 + 0.5) * length);
    let places: Vec<f64> = middles.rev().chain([0.0]).collect();
    let sites = Sites::new(&string, &places).unwrap();
    let torsion = ChannelRequest::Torsion {
        torques: (0..sites.len()).collect(),
    };
    let bending = bends.then_some(ChannelRequest::Bending {
        bending: BENDING,
        support: SurfaceSupport::Free,
    });
    let request = Request {
        sites,
        channels: std::iter::once(torsion).chain(bending).collect(),
        sampling_frequency: draw.log_uniform(50.0, 400.0),
        longest_time: draw.log_uniform(10.0, 60.0),
    };
    (string, request)
}

#[test]
fn builders_ask_for_what_they_take() {
    let mut sums = Sums::default();
    for (number, bends) in (0..5).flat_map(|number| [(number, false), (number, true)]) {
        let (string, request) = request(number, bends);
        for method in methods() {
            let name = format!("{number} {}", method.name());
            let plan = ResponsePlan::new(&string, &method, &request).unwrap();
            let dry = Budget::unlimited();
            plan.ask(&dry).unwrap();
            let what = format!("{name} responses");
            let (responses, asked) = sums.compare(&what, |budget| plan.build(budget).unwrap());
            assert!(asked.peak <= dry.need().peak, "{name}");
            let what = format!("{name} margins");
            sums.compare(&what, |budget| responses.margins(budget).unwrap());
            let what = format!("{name} simulator");
            sums.compare(&what, |budget| {
                SimulatorPlan::of_responses(&responses).ask(budget).unwrap();
                Simulator::new(&responses).unwrap()
            });
        }
    }
    let ratio = sums.asked / sums.taken;
    assert!(ASKED_IN_ALL.contains(&ratio), "{ratio}");
}
