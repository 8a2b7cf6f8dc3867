use super::*;
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::Budget;
use crate::drillstring::{Drillstring, Material, Section, Tube};
use crate::method::Method;
use crate::responses::{ChannelRequest, PlacePlan, PlaceQuantity, Request, responses};
use crate::sites::Sites;
use crate::surroundings::{Hole, HoleSection, Mud};

const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

const FREQUENCY: f64 = 640.0;

fn string() -> Drillstring {
    let tube = |length: f64, outer_radius: f64| Tube {
        length,
        inner_radius: 0.05,
        outer_radius,
    };
    let pipe = Section {
        repeat: 5,
        parts: vec![tube(9.0, 0.0635), tube(1.0, 0.085)],
    };
    let collars = Section {
        repeat: 4,
        parts: vec![tube(10.0, 0.1)],
    };
    Drillstring::new(STEEL, vec![pipe, collars], 10.0).unwrap()
}

fn bending(compression: f64) -> Bending {
    Bending {
        youngs_modulus: 210e9,
        damping: 200.0,
        compression,
    }
}

/// Mud that is viscous, in a narrow hole.
fn in_mud(string: Drillstring) -> Drillstring {
    let section = HoleSection {
        length: 100.0,
        radius: 0.125,
    };
    let mud = Mud {
        density: 1300.0,
        viscosity: 0.03,
    };
    let hole = Hole {
        sections: vec![section],
        mud,
    };
    string.in_hole(hole).unwrap()
}

fn poles(
    string: &Drillstring,
    (bending, support): (&Bending, SurfaceSupport),
    sites: &Sites,
) -> Result<BendingPoles, BuildError> {
    PolePlan::new(string, (bending, support), sites, FREQUENCY)?.build(&Budget::unlimited())
}

/// Largest difference to taps by [`Method::Held`] of 3 s, as a part of the largest tap of the sites
/// themselves, and of A(0) in the same way.
fn difference(
    string: &Drillstring,
    (bending, support): (Bending, SurfaceSupport),
    sites: &Sites,
) -> [f64; 2] {
    let found = poles(string, (&bending, support), sites).unwrap();
    assert!(found.margin() > -1e-9, "{}", found.margin());
    let request = Request {
        sites: sites.clone(),
        channels: vec![ChannelRequest::Bending { bending, support }],
        sampling_frequency: FREQUENCY,
        longest_time: 3.0,
    };
    let held = responses(string, &Method::Held, &request).unwrap();
    let taps = |output, input| held.bending().unwrap().taps_between(input, output).unwrap();
    let largest = |site| {
        let own: &[f64] = taps(site, site);
        [own, &own[..1]].map(|taps| taps.iter().fold(0.0f64, |most, tap| most.max(tap.abs())))
    };
    let mut worst = [0.0f64; 2];
    for output in 0..sites.len() {
        for input in 0..sites.len() {
            let expected = taps(output, input);
            let both = found.taps(output, input, expected.len());
            let differences = both.iter().zip(expected).map(|(one, other)| one - other);
            let off = differences.fold(0.0f64, |most, it| most.max(it.abs()));
            let first = (both[0] - expected[0]).abs();
            for (it, off) in [off, first].into_iter().enumerate() {
                let scale = (largest(output)[it] * largest(input)[it]).sqrt();
                worst[it] = worst[it].max(off / scale);
            }
        }
    }
    worst
}

/// Between sites of a string that is pinned, or hangs from a clamp, or rests on springs, poles answer as
/// the whole string does; so they do where nothing holds it, and it drifts.
#[test]
fn poles_answer_as_the_string() {
    let sites = |distances: &[f64]| Sites::new(&string(), distances).unwrap();
    let four = sites(&[60.0, 33.0, 12.0, 0.0]);
    let on_springs = four.clone().held_by(vec![3e5; 4]).unwrap();
    for (compression, support, sites, most) in [
        (-5e4, SurfaceSupport::Pinned, &four, 4e-3),
        (-1e4, SurfaceSupport::Clamped, &four, 4e-3),
        (1.5e4, SurfaceSupport::Pinned, &on_springs, 8e-3),
        (0.0, SurfaceSupport::Pinned, &four, 4e-3),
        (0.0, SurfaceSupport::Free, &four, 4e-3),
        (-5e4, SurfaceSupport::Free, &four, 4e-3),
    ] {
        let found = difference(&string(), (bending(compression), support), sites);
        assert!(found[0] < most && found[1] < 1e-8, "{found:?}");
    }
}

/// Places that bear no force move as those of the whole string do, down to the bit and where nothing holds it.
#[test]
fn places_of_poles_move_as_those_of_the_string() {
    let string = string();
    let places = [61.0, 20.25, 5.0, 0.0];
    for support in [
        SurfaceSupport::Pinned,
        SurfaceSupport::Clamped,
        SurfaceSupport::Free,
    ] {
        let bending = bending(-5e4);
        let channel = ChannelRequest::Bending { bending, support };
        let request = Request {
            sites: Sites::new(&string, &[60.0, 33.0, 12.0]).unwrap(),
            channels: vec![channel],
            sampling_frequency: FREQUENCY,
            longest_time: 3.0,
        };
        let [poles, held] = [Method::Poles, Method::Held].map(|method| {
            let wanted = (PlaceQuantity::Displacement, &places[..]);
            let plan = PlacePlan::new(&string, &method, &request, wanted).unwrap();
            plan.build(&Budget::unlimited()).unwrap().from_forces
        });
        for (place, (poles, held)) in poles.iter().zip(&held).enumerate() {
            for (poles, held) in poles.iter().zip(held) {
                let largest = held.iter().fold(0.0f64, |most, tap| most.max(tap.abs()));
                let apart = poles.iter().zip(held).map(|(one, other)| one - other);
                let off = apart.fold(0.0f64, |most, it| most.max(it.abs())) / largest;
                assert!(off < 1e-2, "{support:?} {place}: {off:e}");
            }
        }
    }
}

/// In viscous mud, and of steel that loses: what these remember fades by fits, which leave A(0) other than it
/// is, too.
#[test]
fn poles_answer_as_a_string_whose_loss_remembers() {
    let lossy = || string().with_loss_factor(0.02).unwrap();
    let sites = Sites::new(&string(), &[33.0, 12.0, 0.0]).unwrap();
    let bends = (bending(-5e4), SurfaceSupport::Pinned);
    for (string, most) in [
        (in_mud(string()), [8e-3, 1e-4]),
        (lossy(), [6e-3, 1e-5]),
        (in_mud(lossy()), [1.5e-2, 1e-4]),
    ] {
        let found = difference(&string, bends, &sites);
        assert!(found[0] < most[0] && found[1] < most[1], "{found:?}");
    }
}

/// The finer the elements, the more rounding leaves of the modes that nothing holds: they do not buckle.
#[test]
fn a_free_string_of_fine_elements_has_poles() {
    let sites = Sites::new(&string(), &[60.0, 0.0]).unwrap();
    for frequency in [2.0, 4.0, 6.0].map(|times| times * FREQUENCY) {
        let bending = bending(0.0);
        let bends = (&bending, SurfaceSupport::Free);
        let string = string();
        let plan = PolePlan::new(&string, bends, &sites, frequency).unwrap();
        let found = plan.build(&Budget::unlimited());
        assert!(found.is_ok(), "{frequency} Hz: {found:?}");
    }
}

#[test]
fn a_string_that_buckles_has_no_poles() {
    let sites = Sites::new(&string(), &[60.0, 0.0]).unwrap();
    let found = poles(&string(), (&bending(1.5e4), SurfaceSupport::Pinned), &sites);
    assert!(matches!(found, Err(BuildError::Buckles)), "{found:?}");
}
