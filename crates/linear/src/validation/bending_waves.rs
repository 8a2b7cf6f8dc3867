//! Validation of the bending waves: closed forms of beams, static deflection,
//! reciprocity, passivity, tension and compression.

use super::academic::{self, BENDING, tube};
use linear::assembly::bending::{Beam, reduce};
use linear::assembly::block::Block;
use linear::assembly::chain::Stiffness;
use linear::assembly::matrix::ResponseMatrix;
use linear::waves::bending::{Resistance, uniform};
use linear::waves::lateral::BendingNetwork;
use linear::waves::transfer::tip_receptance;
use linear::{Bending, Drillstring, Section, Sites, SurfaceSupport, Tube};
use num_complex::Complex64;
use proptest::prelude::*;

fn uniform_string(length: f64) -> Drillstring {
    let section = Section {
        repeat: 1,
        parts: vec![tube(length, 0.125)],
    };
    Drillstring::new(academic::string().material(), vec![section], 0.0).unwrap()
}

fn tip(string: &Drillstring, bending: Bending, support: SurfaceSupport, s: Complex64) -> Complex64 {
    BendingNetwork::new(string, bending, support, &Sites::bit())
        .unwrap()
        .receptance(s)[(0, 0)]
}

#[track_caller]
fn assert_close(found: Complex64, expected: Complex64, tolerance: f64) {
    let difference = (found - expected).norm() / expected.norm();
    assert!(
        difference <= tolerance,
        "{found} {expected}: {difference:e}"
    );
}

/// Receptance at the free end of a uniform beam (Bishop and Johnson, *The
/// Mechanics of Vibration*, 1960), continued to complex s.
fn bishop_and_johnson(length: f64, support: SurfaceSupport, s: Complex64) -> Complex64 {
    let part = tube(length, 0.125);
    let rigidity = BENDING.youngs_modulus * part.second_moment();
    let inertia = academic::string().material().density * part.area();
    let q = s * (BENDING.damping + s * inertia);
    let beta = (-q / rigidity).sqrt().sqrt();
    let x = beta * length;
    let (sin, cos, sinh, cosh) = (x.sin(), x.cos(), x.sinh(), x.cosh());
    let scale = rigidity * beta * beta * beta;
    match support {
        SurfaceSupport::Free => (sin * cosh - cos * sinh) / (scale * (cos * cosh - 1.0)),
        SurfaceSupport::Clamped => (sin * cosh - cos * sinh) / (scale * (cos * cosh + 1.0)),
        SurfaceSupport::Pinned => sin * sinh * 2.0 / (scale * (cos * sinh - sin * cosh)),
    }
}

#[test]
fn val_a_uniform_beam_has_the_receptance_of_the_textbook() {
    for support in [
        SurfaceSupport::Free,
        SurfaceSupport::Pinned,
        SurfaceSupport::Clamped,
    ] {
        for length in [0.5, 9.5, 60.0] {
            for s in [
                (0.5, 0.0),
                (1.0, 3.0),
                (0.1, 40.0),
                (20.0, 900.0),
                (900.0, 2000.0),
            ] {
                let s = Complex64::new(s.0, s.1);
                let found = tip(&uniform_string(length), BENDING, support, s);
                // A nearly rigid rod is its mass against huge stiffnesses.
                let tolerance = if length < 1.0 { 1e-8 } else { 1e-10 };
                assert_close(found, bishop_and_johnson(length, support, s), tolerance);
            }
        }
    }
}

#[test]
fn val_a_long_damped_beam_is_one_way_and_does_not_overflow() {
    let s = Complex64::new(10.0, 2000.0);
    let string = uniform_string(20_000.0);
    let part = tube(1.0, 0.125);
    let rigidity = BENDING.youngs_modulus * part.second_moment();
    let inertia = string.material().density * part.area();
    let q = s * (BENDING.damping + s * inertia);
    // Semi-infinite, free end: √2 k₀ with k₀⁴ = q/EI, decaying both ways.
    let k = (q / rigidity).sqrt().sqrt();
    let expected = 2f64.sqrt() / (rigidity * k * k * k);
    assert_close(
        tip(&string, BENDING, SurfaceSupport::Free, s),
        expected,
        1e-9,
    );
    // Plain hyperbolic functions cannot say so.
    let plain = bishop_and_johnson(20_000.0, SurfaceSupport::Free, s);
    assert!(!plain.is_finite(), "expected the closed form to overflow");
}

/// A number of cells of the academic string's drillpipe.
fn cells(repeat: usize) -> Drillstring {
    let academic = academic::string();
    let pipe = Section {
        repeat,
        ..academic.sections()[0].clone()
    };
    Drillstring::new(academic.material(), vec![pipe], 0.0).unwrap()
}

#[test]
fn val_plain_products_of_transfer_matrices_agree_with_joined_stiffnesses_on_short_strings_only() {
    let s = Complex64::new(0.0, std::f64::consts::TAU * 100.0);
    let joined = |string: &Drillstring| tip(string, BENDING, SurfaceSupport::Free, s);
    let products = |string: &Drillstring| tip_receptance(string, &BENDING, s.im);
    assert_close(products(&cells(1)), joined(&cells(1)), 1e-6);
    let lost = (products(&cells(20)) / joined(&cells(20)) - 1.0).norm();
    assert!(lost > 0.1, "{lost}");
    assert!(!products(&cells(2000)).is_finite());
    // A string that long is one way: its length no longer matters.
    assert_close(joined(&cells(2000)), joined(&cells(1000)), 1e-9);
}

/// A slow force meets the inertia and the damping of a whole string: forces as small,
/// against the stiffness of a sliver, as rounding. Where a tube is cut is nothing to them.
#[test]
fn val_a_sliver_takes_nothing_from_the_accuracy() {
    let whole = cells(60);
    let [pipe, joint] = whole.sections()[0].parts[..] else {
        unreachable!("a cell is a pipe and a joint");
    };
    let of = |part: Tube, length: f64| Tube { length, ..part };
    for sliver in [1e-4, 1e-2, 0.3] {
        let sections = [
            (20, vec![pipe, joint]),
            (1, vec![of(pipe, sliver)]),
            (1, vec![of(pipe, pipe.length - sliver), joint]),
            (38, vec![pipe, joint]),
            (
                1,
                vec![pipe, of(joint, joint.length - sliver), of(joint, sliver)],
            ),
        ];
        let sections = sections.map(|(repeat, parts)| Section { repeat, parts });
        let cut = Drillstring::new(whole.material(), sections.to_vec(), 0.0).unwrap();
        for s in [(0.5, 0.0), (0.1, 25.0), (1.0, 200.0), (1.0, 2000.0)] {
            let s = Complex64::new(s.0, s.1);
            for support in [SurfaceSupport::Free, SurfaceSupport::Clamped] {
                let [cut, whole] = [&cut, &whole].map(|string| tip(string, BENDING, support, s));
                assert_close(cut, whole, 1e-9);
            }
        }
    }
}

#[test]
fn val_a_clamped_string_bends_statically() {
    let (length, bending) = (
        30.0,
        Bending {
            damping: 0.0,
            ..BENDING
        },
    );
    let part = tube(length, 0.125);
    let rigidity = bending.youngs_modulus * part.second_moment();
    let found = tip(
        &uniform_string(length),
        bending,
        SurfaceSupport::Clamped,
        Complex64::new(1e-6, 0.0),
    );
    let expected = Complex64::new(length.powi(3) / (3.0 * rigidity), 0.0);
    assert_close(found, expected, 1e-9);
}

#[test]
fn val_a_slow_free_string_moves_as_a_rigid_mass() {
    let (length, bending) = (
        2.0,
        Bending {
            damping: 0.0,
            ..BENDING
        },
    );
    let part = tube(length, 0.125);
    let mass = academic::string().material().density * part.area() * length;
    let s = Complex64::new(5.0, 0.0);
    let found = tip(&uniform_string(length), bending, SurfaceSupport::Free, s);
    // A rod pushed at its end: 4/m of its acceleration there.
    assert_close(found, 4.0 / (mass * s * s), 1e-4);
}

/// Frequency (rad/s) of the first mode of a tube pinned at both ends, where the
/// stiffness between its two slopes is singular.
fn pinned_frequency(length: f64, compression: f64) -> f64 {
    let string = uniform_string(length);
    let bending = Bending {
        damping: 0.0,
        compression,
        ..BENDING
    };
    let determinant = |omega: f64| {
        let s = Complex64::new(0.0, omega);
        let part = &string.sections()[0].parts[0];
        let mass = string.mass_sideways(part, None);
        let beam = uniform(&bending, part, Resistance::constant(&bending, mass, s)).between_ends();
        let slope = |Block(entries): Block| entries[1][1];
        (slope(beam.top) * slope(beam.bottom) - slope(beam.cross) * slope(beam.cross)).re
    };
    let (mut low, mut high) = (1e-3, 1e-3);
    while determinant(high) * determinant(low) > 0.0 {
        high *= 1.02;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if determinant(middle) * determinant(low) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[test]
fn val_tension_raises_and_compression_lowers_the_frequencies_as_the_closed_form_says() {
    let length = 20.0;
    let part = tube(length, 0.125);
    let rigidity = BENDING.youngs_modulus * part.second_moment();
    let inertia = academic::string().material().density * part.area();
    let wavenumber = std::f64::consts::PI / length;
    let buckling = rigidity * wavenumber * wavenumber;
    for fraction in [-3.0, -0.5, 0.0, 0.3, 0.9] {
        let compression = fraction * buckling;
        let expected = (wavenumber.powi(2) * (buckling - compression) / inertia).sqrt();
        let found = pinned_frequency(length, compression);
        assert!(
            (found / expected - 1.0).abs() < 1e-8,
            "{fraction}: {found} {expected}"
        );
    }
}

#[test]
fn val_further_sites_change_nothing_between_two() {
    let string = academic::string();
    let bending = Bending {
        compression: -2e5,
        ..BENDING
    };
    let receptance = |distances: &[f64], s| {
        let sites = Sites::new(&string, distances).unwrap();
        BendingNetwork::new(&string, bending, SurfaceSupport::Pinned, &sites)
            .unwrap()
            .receptance(s)
    };
    for s in [Complex64::new(0.5, 2.0), Complex64::new(3.0, 500.0)] {
        let three = receptance(&[100.0, 53.2, 0.0], s);
        for (upper, lower) in [(0, 1), (0, 2), (1, 2)] {
            let distances = [100.0, 53.2, 0.0];
            let two = receptance(&[distances[upper], distances[lower]], s);
            let off = two[(1, 0)] - three[(lower, upper)];
            assert!(off.norm() < 1e-9 * three[(2, 2)].norm());
        }
        assert_close(receptance(&[53.2], s)[(0, 0)], three[(1, 1)], 1e-9);
        assert_close(receptance(&[0.0], s)[(0, 0)], three[(2, 2)], 1e-9);
    }
}

fn any_string() -> impl Strategy<Value = Drillstring> {
    let part = (0.1..30.0f64, 0.01..0.1f64, 1.05..4.0f64).prop_map(|(length, inner, ratio)| Tube {
        length,
        inner_radius: inner,
        outer_radius: inner * ratio,
    });
    let section = (1..1000usize, prop::collection::vec(part, 1..4))
        .prop_map(|(repeat, parts)| Section { repeat, parts });
    prop::collection::vec(section, 1..4).prop_map(|sections| {
        Drillstring::new(academic::string().material(), sections, 0.0).unwrap()
    })
}

/// The receptance of a string at two sites, the lower of them the bit, from every tube joined to
/// the next.
fn tube_by_tube(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    depth: f64,
    s: Complex64,
) -> ResponseMatrix {
    let mut spans: [Option<Beam>; 2] = [None; 2];
    let mut left = depth;
    let cells = |section: &Section| vec![section.parts.clone(); section.repeat].concat();
    for tube in string.sections().iter().flat_map(cells) {
        let above = left.clamp(0.0, tube.length);
        for (span, length) in spans.iter_mut().zip([above, tube.length - above]) {
            if length > 0.0 {
                let part = Tube { length, ..tube };
                let mass = string.mass_sideways(&part, None);
                let part = uniform(bending, &part, Resistance::constant(bending, mass, s));
                *span = Some(span.map_or(part, |upper| upper.join(&part)));
            }
        }
        left -= above;
    }
    reduce(spans.into_iter(), &[0.0.into(); 2], support)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..Default::default() })]

    /// s H(s), the velocity response to a force, of any string in tension.
    #[test]
    fn val_the_velocity_response_of_any_string_is_positive_real(
        string in any_string(),
        damping in 1.0..1e4f64,
        tension in 0.0..1e6f64,
        real in 0.0..10.0f64,
        omega in 1e-2..3e3f64,
        place in 0.0..1.0f64,
    ) {
        let bending = Bending { damping, compression: -tension, ..BENDING };
        let sites = Sites::new(&string, &[0.99 * place * string.length()]).unwrap();
        let network = BendingNetwork::new(&string, bending, SurfaceSupport::Free, &sites).unwrap();
        let s = Complex64::new(real, omega);
        let velocity = s * network.receptance(s)[(0, 0)];
        prop_assert!(velocity.re >= -1e-6 * velocity.norm(), "{}", velocity);
    }

    /// What is not joined, for no wave comes from there, is not missed.
    #[test]
    fn val_what_no_wave_comes_from_is_not_felt(
        string in any_string(),
        damping in 1.0..1e4f64,
        compression in -1e6..1e4f64,
        rate in 0.0..5.0f64,
        angle in 0.0..1.5f64,
        place in 0.01..0.99f64,
    ) {
        let bending = Bending { damping, compression, ..BENDING };
        let depth = place * string.length();
        let sites = Sites::new(&string, &[string.length() - depth, 0.0]).unwrap();
        let s = Complex64::from_polar(10f64.powf(rate), angle);
        for support in [SurfaceSupport::Free, SurfaceSupport::Pinned, SurfaceSupport::Clamped] {
            let network = BendingNetwork::new(&string, bending, support, &sites).unwrap();
            let found = network.receptance(s);
            let joined = tube_by_tube(&string, &bending, support, depth, s);
            for (row, column) in [(0, 0), (1, 0), (1, 1)] {
                let size = (joined[(row, row)].norm() * joined[(column, column)].norm()).sqrt();
                let off = (found[(row, column)] - joined[(row, column)]).norm() / size;
                prop_assert!(off < 1e-8, "{support:?} {row} {column}: {off}");
            }
        }
    }
}
