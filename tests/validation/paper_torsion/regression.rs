//! Regression: earlier answers, which nothing but a reason may change. They follow from
//! Eqs. 16 and 59–61 with the taps of Eqs. 39–40 (`hilbert`), 66–68 (`finite-element`) and
//! of BDF2's convolution quadrature at 640 Hz, and were met to these tolerances by a
//! second program, in another language, when they were first written down.

use super::*;

#[test]
fn reg_undershoots() {
    for (method, expected) in [
        (hilbert(), 2.96e-5),
        (QUADRATURE, 2.87e-5),
        (elements(0.52), 2.86e-5),
    ] {
        let taps = responses(&method);
        assert_close(largest_undershoot(taps.at_bit().unwrap()), expected, 0.01);
    }
}

#[test]
fn reg_the_cycle_of_figure_8b() {
    for method in [QUADRATURE, hilbert(), elements(0.52)] {
        let found = simulate(&simulator(&method), 0.1, 4000.0, Some(40.0));
        assert_close(found.period.unwrap(), 3.778, 0.005);
        assert_close(found.slip_time.unwrap(), 0.763, 0.005);
        assert_eq!(found.sticks, 7);
    }
    let found = simulate(&simulator(&QUADRATURE), 0.1, 4000.0, Some(40.0));
    assert_close(found.peak_speed, 0.0719, 0.005);
}

#[test]
fn reg_limits_of_stick_slip() {
    for (method, limit) in [
        (QUADRATURE, 0.0576),
        (hilbert(), 0.0583),
        (elements(0.52), 0.0568),
    ] {
        assert_close(simulated_limit(&simulator(&method)), limit, 0.01);
    }
    for (method, limit) in [(QUADRATURE, 0.0549), (hilbert(), 0.0566)] {
        assert_close(limit_by_equation_74(&method), limit, 0.01);
    }
}
