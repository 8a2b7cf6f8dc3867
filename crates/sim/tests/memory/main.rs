//! What builders ask a budget for, against what an allocator counts: a program of its own, for the
//! allocator counts all threads.

use linear::budget::{Budget, Need};
use linear::method::{FiniteElement, Transform};
use linear::{
    CascadePlan, ChannelRequest, Drillstring, Method, Request, ResponsePlan, Responses, Sites,
    SurfaceSupport, SurfaceTorquePlan, TopDrive,
};
use peak_alloc::PeakAlloc;
use problems::academic::BENDING;
use problems::wells::{Draw, Well};
use sim::{Simulator, SimulatorPlan, SurfaceProfile};

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

const MIB: f64 = 1024.0 * 1024.0;

/// What is asked for is at most this much more than what is taken,
const MOST: f64 = 1.3;

/// in work that takes more than this, bytes: plans of transforms that a thread keeps, and its
/// stack of short vectors, are some of less.
const LEAST: f64 = 4.0 * MIB;

/// What a piece of work gives, with the most that it takes and what is left of it, bytes.
fn counted<T>(work: impl FnOnce() -> T) -> (T, Need) {
    let before = ALLOCATOR.current_usage() as f64;
    ALLOCATOR.reset_peak_usage();
    let done = work();
    let need = Need {
        peak: ALLOCATOR.peak_usage() as f64 - before,
        kept: ALLOCATOR.current_usage() as f64 - before,
    };
    (done, need)
}

fn compare(what: &str, number: usize, asked: Need, taken: Need) {
    for (name, asked, taken) in [
        ("peak", asked.peak, taken.peak),
        ("kept", asked.kept, taken.kept),
    ] {
        if taken > 1.0 * MIB {
            println!(
                "{what:28} {number:3} {name} asked {:8.2} taken {:8.2} MiB  {:.3}",
                asked / MIB,
                taken / MIB,
                asked / taken
            );
        }
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

#[test]
fn builders_ask_for_what_they_take() {
    for number in 0..12 {
        let mut draw = Draw::new(number);
        let string = Well::draw(number, &mut draw).string;
        let count = draw.log_uniform(1.0, 8.0) as usize;
        let length = string.length() / count as f64;
        let middles = (0..count).map(|piece| (piece as f64 + 0.5) * length);
        let places: Vec<f64> = middles.rev().chain([0.0]).collect();
        let sites = Sites::new(&string, &places).unwrap();
        for bends in [false, true] {
            let mut channels = vec![ChannelRequest::Torsion {
                torques: (0..sites.len()).collect(),
            }];
            if bends {
                channels.push(ChannelRequest::Bending {
                    bending: BENDING,
                    support: SurfaceSupport::Free,
                });
            }
            let request = Request {
                sites: sites.clone(),
                channels,
                sampling_frequency: draw.log_uniform(50.0, 400.0),
                longest_time: draw.log_uniform(10.0, 60.0),
            };
            for method in methods() {
                let Ok(plan) = ResponsePlan::new(&string, &method, &request) else {
                    continue;
                };
                let dry = Budget::unlimited();
                plan.ask(&dry).unwrap();
                let budget = Budget::unlimited();
                let (responses, taken) = counted(|| plan.build(&budget).unwrap());
                let name = format!("{} {bends}", method.name());
                compare(&name, number, budget.need(), taken);
                assert!(dry.need().peak >= budget.need().peak, "{name} {number}");
                let budget = Budget::unlimited();
                let (_, taken) = counted(|| responses.margins(&budget).unwrap());
                compare(&format!("{name} margin"), number, budget.need(), taken);
                let budget = Budget::unlimited();
                let plan = SimulatorPlan::of_responses(&responses);
                plan.ask(&budget).unwrap();
                let profile = SurfaceProfile::default();
                let (_simulator, taken) =
                    counted(|| Simulator::started(&responses, &profile).unwrap());
                compare(&format!("{name} simulator"), number, budget.need(), taken);
            }
        }
        for method in [Method::Quadrature] {
            let plan = CascadePlan::new(&string, &method, &sites, 100.0, 60.0).unwrap();
            let budget = Budget::unlimited();
            let (cascade, taken) = counted(|| plan.build(&budget).unwrap());
            compare("cascade", number, budget.need(), taken);
            let budget = Budget::unlimited();
            let steps = sim::plan::steps(60.0, 100.0);
            SimulatorPlan::in_pieces(sites.len(), cascade.longest_response(), steps)
                .ask(&budget)
                .unwrap();
            let (_s, taken) = counted(|| {
                Simulator::in_pieces(&cascade, &SurfaceProfile::default(), 0.0).unwrap()
            });
            compare("pieces", number, budget.need(), taken);
        }
    }
}
