//! The reduced finite-element model against stepping its whole state, and
//! Newmark's scheme against what is known of it.

use super::academic::{self, SAMPLING_FREQUENCY};
use linear::elements::newmark::Weights;
use linear::elements::reduction::CondensedString;
use linear::method::FiniteElement;
use linear::{
    BuildError, ChannelRequest, ChannelResponses, Drillstring, Method, RaisedCosine, Request, Sites,
};

fn weights(parameters: &FiniteElement) -> Weights {
    Weights {
        gamma: parameters.gamma,
        beta: parameters.beta(),
        step: 1.0 / SAMPLING_FREQUENCY,
    }
}

fn responses(
    string: &Drillstring,
    method: &Method,
    request: &Request,
) -> Result<ChannelResponses, BuildError> {
    let responses = linear::responses(string, method, request)?;
    Ok(responses.torsion().unwrap().clone())
}

/// Eqs. 66–68: the taps are all that a simulation needs of the string. The
/// torques here depend on the speeds of the same step, as a contact law's do.
#[test]
fn val_taps_and_stepping_the_whole_state_give_the_same_motion() {
    let string = academic::string();
    let sites = Sites::new(&string, &[0.0, 250.0]).unwrap();
    let parameters = FiniteElement::default();
    let steps = 4000;
    let request = Request {
        sites: sites.clone(),
        channels: vec![ChannelRequest::Torsion {
            torques: vec![0, 1],
        }],
        sampling_frequency: SAMPLING_FREQUENCY,
        longest_time: steps as f64 / SAMPLING_FREQUENCY,
    };
    let taps = responses(&string, &Method::FiniteElement(parameters), &request).unwrap();
    let condensed = CondensedString::new(&string, &sites, 20, weights(&parameters)).unwrap();

    let surface = |step: usize| 1.0 + (step as f64 * 0.01).sin();
    let law = |free_speed: f64| 1e4 * (3.0 * free_speed).tanh();
    let mut state = condensed.rest();
    let mut torques = [vec![], vec![]];
    let mut full = [vec![], vec![]];
    for step in 0..steps {
        condensed.step_free(&mut state, surface(step));
        let free = [condensed.speed(&state, 0), condensed.speed(&state, 1)];
        for site in 0..2 {
            let torque = -law(free[site]);
            condensed.apply_torque(&mut state, site, torque);
            torques[site].push(torque);
        }
        for site in 0..2 {
            full[site].push(condensed.speed(&state, site));
        }
    }

    let surface: Vec<f64> = (0..steps).map(surface).collect();
    for site in 0..2 {
        let mut reduced = super::oracles::convolve(&taps.from_surface[site], &surface);
        for input in 0..2 {
            let from_torque =
                super::oracles::convolve(&taps.from_loads[site][input], &torques[input]);
            reduced
                .iter_mut()
                .zip(&from_torque)
                .for_each(|(sum, x)| *sum += x);
            let instant = condensed.instant_response(site, input);
            let tap = taps.from_loads[site][input][0];
            let driven = condensed.instant_response(site, site);
            assert!((tap - instant).abs() <= 1e-11 * driven);
        }
        let difference = super::oracles::relative_difference(&reduced, &full[site]);
        // Beyond the cut tail, 1e-10 of a response, nothing may differ.
        assert!(difference < 1e-9, "site {site}: {difference}");
    }
}

/// A mesh with ten times the elements changes little: twenty elements a cell
/// have converged over the band of the filters.
#[test]
fn val_twenty_elements_a_cell_have_converged() {
    let string = academic::string();
    let taps = |elements_per_cell| {
        let parameters = FiniteElement {
            elements_per_cell,
            ..Default::default()
        };
        let method = Method::FiniteElement(parameters);
        responses(&string, &method, &academic::bit_request(2.0)).unwrap()
    };
    let (usual, fine) = (taps(20), taps(80));
    let step = |taps: &[f64]| super::oracles::convolve(taps, &vec![1.0; 1280]);
    let difference = super::oracles::relative_difference(
        &step(&usual.from_surface[0]),
        &step(&fine.from_surface[0]),
    );
    assert!(difference < 0.01, "{difference}");
}

/// Waves and elements share no equation; on a smooth input they must agree.
#[test]
fn val_elements_and_waves_agree_on_a_smooth_input() {
    let string = academic::string();
    let request = Request {
        sampling_frequency: 2560.0,
        ..academic::bit_request(2.0)
    };
    let input: Vec<f64> = (0..5000)
        .map(|n| RaisedCosine { duration: 0.2 }.integral(n as f64 / 2560.0))
        .collect();
    let speed = |method| {
        let taps = responses(&string, &method, &request).unwrap();
        super::oracles::convolve(&taps.from_surface[0], &input)
    };
    let gamma_half = FiniteElement {
        gamma: 0.5,
        ..Default::default()
    };
    let difference = super::oracles::relative_difference(
        &speed(Method::FiniteElement(gamma_half)),
        &speed(Method::Quadrature),
    );
    assert!(difference < 1e-3, "{difference}");
}

#[test]
fn parameters_that_could_grow_without_bound_are_refused() {
    let string = academic::string();
    for parameters in [
        FiniteElement {
            gamma: 0.49,
            ..Default::default()
        },
        FiniteElement {
            beta: Some(0.2),
            ..Default::default()
        },
        FiniteElement {
            elements_per_cell: 0,
            ..Default::default()
        },
    ] {
        let method = Method::FiniteElement(parameters);
        assert!(responses(&string, &method, &academic::bit_request(1.0)).is_err());
    }
}
