//! How places of a string move along its axis, after a case.

use linear::method::FiniteElement;
use linear::{ChannelRequest, Method, RaisedCosine, Request, Sites};
use problems::dashpots::{self, BelowDashpots, STEEL, YOUNGS_MODULUS};
use sim::laws::cutting::CutStep;
use sim::{Axial, RatesAtPlaces, SurfaceProfile, Trajectory};

use super::scene::bit;

const LENGTH: f64 = 2000.0;
const FREQUENCY: f64 = 2000.0;
const PLACES: [f64; 3] = [700.0, 150.0, 0.0];

fn rates_at(below: &BelowDashpots, method: &Method, duration: f64) -> RatesAtPlaces {
    let request = Request {
        sites: Sites::new(&below.string, &PLACES).unwrap(),
        channels: vec![ChannelRequest::Axial {
            rod: Box::new(below.rod.clone()),
            forces: vec![2],
        }],
        sampling_frequency: FREQUENCY,
        longest_time: duration,
    };
    let responses = linear::responses(&below.string, method, &request).unwrap();
    RatesAtPlaces::new(&responses, PLACES.len(), &SurfaceProfile::Rise(0.0)).unwrap()
}

/// A push of the rock goes up a pipe as it is, W(t − x/c)/Z, and comes back from the surface later; what
/// its surface does comes down.
#[test]
fn val_a_push_of_the_rock_passes_all_places_of_a_pipe() {
    let pipe = dashpots::pipe(LENGTH);
    let below = BelowDashpots::new(&[pipe], [0.0; 2]);
    let speed = (YOUNGS_MODULUS / STEEL.density).sqrt();
    let impedance = STEEL.density * speed * pipe.area();
    let (weight, feed, pulse) = (1e4, 0.01, RaisedCosine { duration: 0.1 });
    let duration = 2.0 * LENGTH / speed;
    let steps = (duration * FREQUENCY) as usize;
    let push = |time: f64| weight * pulse.duration * pulse.at(time);
    let scene = |feed: f64| Axial {
        cutting: bit(60e6, 0.0),
        feed,
        start_rate: 0.0,
        kick: None,
    };
    let elements = FiniteElement {
        elements_per_cell: 2000,
        ..FiniteElement::default()
    };
    for (method, apart) in [
        (Method::Held, 2e-3),
        (Method::Quadrature, 2e-2),
        (Method::FiniteElement(elements), 2e-2),
    ] {
        let found = rates_at(&below, &method, duration);
        let offset = method.collocation_offset();
        let cut = (0..steps).map(|step| {
            let mut cut = CutStep::default();
            cut.weight = push((step as f64 + offset) / FREQUENCY);
            cut
        });
        let motion = Trajectory {
            cut: cut.collect(),
            ..Trajectory::default()
        };
        let peak = 2.0 * weight / impedance;
        for (place, distance) in PLACES.iter().enumerate() {
            let rates = found.rates(place, &scene(0.0), &motion);
            let fed = found.rates(place, &scene(feed), &motion);
            for (step, (rate, fed)) in rates.iter().zip(&fed).enumerate() {
                let time = (step as f64 + offset) / FREQUENCY;
                let expected = -push(time - distance / speed) / impedance;
                let off = (rate - expected).abs() / peak;
                assert!(
                    off < apart,
                    "{method:?} {distance} m, {time} s: {rate} {expected}"
                );
                // The surface is heard once its wave is there: half its speed, and all once the free
                // end has sent it back.
                let [comes, comes_back] =
                    [LENGTH - distance, LENGTH + distance].map(|it| it / speed);
                let part = match time {
                    _ if time < comes - 0.03 => 0.0,
                    _ if time > comes_back + 0.05 => 1.0,
                    _ if time > comes + 0.05 && time < comes_back - 0.03 => 0.5,
                    _ => continue,
                };
                let heard = (fed - rate) / feed;
                assert!(
                    (heard - part).abs() < 0.03,
                    "{method:?} {distance} m, {time} s: {heard}"
                );
            }
        }
        let strongest = found
            .acceleration(&scene(0.0), &motion, (&[1e3; 3], 0))
            .unwrap();
        let exact = peak * std::f64::consts::PI / pulse.duration;
        assert!(
            (strongest.step_peak / exact - 1.0).abs() < 0.03,
            "{method:?} {strongest:?} {exact}"
        );
    }
}
