//! Orders of convergence in 1/f_s on the response to a smooth surface ramp,
//! against the exact frequency response inverted numerically.

use linear::deviation::ExactMotions;
use linear::filters::radau::{self, STAGES};
use linear::method::{FiniteElement, Transform};
use linear::waves::inversion::time_response;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{
    Axial, ChannelRequest, Hoist, Method, RaisedCosine, Request, Sites, SurfaceSupport, responses,
};
use problems::{academic, oracles};

/// Duration of the ramp, s: its spectrum is far below the lowest f_s.
const RAMP: f64 = 0.5;

/// Time compared, s.
const TIME: f64 = 3.0;

const LADDER: [f64; 4] = [160.0, 320.0, 640.0, 1280.0];

/// Errors at each f_s of [`LADDER`], relative to the surface's final speed.
fn errors(method: &Method) -> Vec<f64> {
    let string = academic::string();
    let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
    LADDER
        .iter()
        .map(|&sampling_frequency| {
            let steps = (TIME * sampling_frequency) as usize;
            let request = Request {
                sites: Sites::bit(),
                channels: vec![ChannelRequest::Torsion { torques: vec![] }],
                sampling_frequency,
                longest_time: TIME,
            };
            let responses = responses(&string, method, &request).unwrap();
            let taps = responses.torsion().unwrap();
            let time = |step: usize| step as f64 / sampling_frequency;
            let input: Vec<f64> = (0..steps)
                .map(|step| RaisedCosine { duration: RAMP }.integral(time(step)))
                .collect();
            let speed = oracles::convolve(&taps.from_surface[0], &input);
            let exact = time_response(
                |s| {
                    network.admittance(s).from_surface[0]
                        * RaisedCosine { duration: RAMP }.transform(s)
                        / s
                },
                1.0 / sampling_frequency,
                steps,
                2,
            );
            speed
                .iter()
                .zip(&exact)
                .fold(0.0, |most: f64, (found, exact)| {
                    most.max((found - exact).abs())
                })
        })
        .collect()
}

/// Observed orders between neighbouring steps of the ladder.
fn orders(method: &Method) -> Vec<f64> {
    let errors = errors(method);
    errors
        .windows(2)
        .map(|pair| (pair[0] / pair[1]).log2())
        .collect()
}

fn elements(gamma: f64) -> Method {
    Method::FiniteElement(FiniteElement {
        gamma,
        // So fine that the elements' own error stays out of sight.
        elements_per_cell: 40,
        beta: None,
    })
}

#[test]
fn val_quadrature_is_of_second_order() {
    for order in orders(&Method::Quadrature) {
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }
}

/// In bending too, on the paper's band-limited impulse, once that is resolved.
#[test]
fn val_quadrature_is_of_second_order_in_bending() {
    let string = academic::string();
    let sites = Sites::bit();
    let network =
        BendingNetwork::new(&string, academic::BENDING, SurfaceSupport::Free, &sites).unwrap();
    let pulse = RaisedCosine { duration: 0.02 };
    let errors = [1280.0, 2560.0, 5120.0].map(|sampling_frequency| {
        let steps = (2.0 * sampling_frequency) as usize;
        let request = Request {
            sites: sites.clone(),
            channels: vec![academic::free_in_bending()],
            sampling_frequency,
            longest_time: 2.0,
        };
        let responses = responses(&string, &Method::Quadrature, &request).unwrap();
        let taps = &responses.bending().unwrap().from_loads[0][0];
        let time = |step: usize| step as f64 / sampling_frequency;
        let force: Vec<f64> = (0..steps).map(|step| pulse.at(time(step))).collect();
        let exact = time_response(
            |s| network.receptance(s)[(0, 0)] * pulse.transform(s),
            1.0 / sampling_frequency,
            steps,
            4,
        );
        oracles::relative_difference(&oracles::convolve(taps, &force), &exact)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{order}: {errors:?}");
    }
}

/// With two stages a step. Its order shows late, where the shortest joints of the
/// string are resolved.
#[test]
fn val_radau_quadrature_is_of_third_order() {
    let string = academic::string();
    let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
    let ramp = RaisedCosine { duration: 0.1 };
    let speed = |s| network.admittance(s).from_surface[0];
    let errors = [2560.0, 5120.0, 10_240.0].map(|sampling_frequency: f64| {
        let steps = (1.5 * sampling_frequency) as usize;
        let taps = radau::taps(sampling_frequency, steps, &speed);
        let time = |step: usize, stage: f64| (step as f64 + stage) / sampling_frequency;
        let inputs = STAGES.map(|stage| -> Vec<f64> {
            let times = (0..steps).map(|step| time(step, stage));
            times.map(|time| ramp.integral(time)).collect()
        });
        let found: Vec<f64> = (oracles::convolve(&taps[2], &inputs[0]).iter())
            .zip(oracles::convolve(&taps[3], &inputs[1]))
            .map(|(one, other)| one + other)
            .collect();
        let exact = time_response(
            |s| speed(s) * ramp.transform(s) / s,
            1.0 / sampling_frequency,
            steps + 1,
            2,
        );
        let differences = found.iter().zip(&exact[1..]);
        differences.fold(0.0, |most: f64, (found, exact)| {
            most.max((found - exact).abs())
        })
    });
    let orders = errors.map(f64::log2);
    for pair in orders.windows(2) {
        let order = pair[0] - pair[1];
        assert!((order - 3.0).abs() < 0.2, "{order}: {errors:?}");
    }
}

#[test]
fn val_newmark_without_numerical_damping_is_of_second_order() {
    for order in orders(&elements(0.5)) {
        assert!((order - 2.0).abs() < 0.1, "{order}");
    }
}

/// γ = ½ + ε damps every wave with a rate proportional to ε times the step, an
/// error of first order that the paper's choice of γ pays for its stability.
#[test]
fn val_newmark_with_numerical_damping_is_of_first_order() {
    let orders = orders(&elements(0.52));
    assert!(
        orders.windows(2).all(|pair| pair[1] < pair[0]),
        "{orders:?}"
    );
    let last = orders[orders.len() - 1];
    assert!((last - 1.0).abs() < 0.1, "{orders:?}");
}

/// The digital filter has no order: on an input within its band the error
/// falls faster than any power of 1/f_s, down to what its finite transform
/// folds back. (On a step, whose band is not limited, it rings as Fig. 7 shows.)
#[test]
fn val_the_digital_filter_is_exact_within_its_band() {
    let errors = errors(&Method::Hilbert(Transform {
        seconds: Some(60.0),
    }));
    assert!(errors[0] / errors[1] > 100.0, "{errors:?}");
    assert!(errors[1..].iter().all(|&error| error < 1e-6), "{errors:?}");
}

/// Along the axis, too, responses tend to the exact motions; those of a stiffer rod do not.
#[test]
fn val_motions_along_the_axis_tend_to_the_exact_ones() {
    let string = academic::string();
    let rod = |youngs_modulus: f64| {
        let hoist = Hoist {
            mass: 2e4,
            damping: 2.5e4,
            stiffness: 0.0,
        };
        let axial = Axial {
            youngs_modulus,
            damping: 30.0,
            hoist: Some(hoist),
        };
        axial.rod(&string).unwrap()
    };
    let error = |method: Method, youngs_modulus: f64, sampling_frequency: f64| {
        let request = Request {
            sites: Sites::bit(),
            channels: vec![ChannelRequest::Axial {
                rod: Box::new(rod(youngs_modulus)),
                forces: vec![0],
            }],
            sampling_frequency,
            longest_time: TIME,
        };
        let responses = responses(&string, &method, &request).unwrap();
        let sites = Sites::bit();
        let exact = ExactMotions::along_axis(&string, &rod(210e9), &sites, sampling_frequency);
        exact.unwrap().error_of(&responses).unwrap()
    };
    let [coarse, fine] = [5120.0, 10_240.0].map(|hz| error(Method::Quadrature, 210e9, hz));
    let order = (coarse / fine).log2();
    assert!((1.8..2.3).contains(&order), "{coarse} {fine}");
    let held = error(Method::Held, 210e9, 10_240.0);
    assert!(held < 0.5 * fine, "{held} {fine}");
    let stiffer = error(Method::Held, 1.02 * 210e9, 10_240.0);
    assert!(stiffer > 5.0 * held, "{stiffer} {held}");
}
