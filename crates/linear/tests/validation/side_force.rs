//! What presses a string on its wall, by an integral of another's making: rotated in a frame of
//! the arc from station to station, by the trapezoidal rule in steps of some millimetres.

use linear::well::{PressedBy, SideForce, Station, Survey};
use linear::{Drillstring, Material, Section, Tube};

const GRAVITY: f64 = 9.806_65;
const OUTER_RADIUS: f64 = 0.0635;

/// 2 km of 5-inch pipe.
fn pipe() -> Drillstring {
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let tube = Tube {
        length: 10.0,
        inner_radius: 0.5 * 4.276 * 0.0254,
        outer_radius: OUTER_RADIUS,
    };
    let section = Section {
        repeat: 200,
        parts: vec![tube],
    };
    Drillstring::new(steel, vec![section], 0.0).unwrap()
}

/// Torque per coefficient of friction, N m, of a string of a weight per metre (N/m).
fn exact(stations: &[[f64; 3]], weight: f64, steps: usize) -> f64 {
    let direction = |[_, inclination, azimuth]: [f64; 3]| {
        let (sin, cos) = inclination.to_radians().sin_cos();
        let (east, north) = azimuth.to_radians().sin_cos();
        [sin * north, sin * east, cos]
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (mut tension, mut torque) = (0.0, 0.0);
    for pair in stations.windows(2).rev() {
        let (from, to) = (direction(pair[0]), direction(pair[1]));
        let length = pair[1][0] - pair[0][0];
        let angle = dot(from, to).clamp(-1.0, 1.0).acos();
        // Orthonormal in the plane of the arc: its first direction, and towards its centre.
        let across = [0, 1, 2].map(|axis| to[axis] - dot(from, to) * from[axis]);
        let norm = dot(across, across).sqrt().max(1e-300);
        let across = across.map(|it| it / norm);
        let step = length / steps as f64;
        let at = |index: usize| {
            let turned = angle * index as f64 / steps as f64;
            let (sin, cos) = turned.sin_cos();
            let along = [0, 1, 2].map(|axis| cos * from[axis] + sin * across[axis]);
            let inwards = [0, 1, 2].map(|axis| cos * across[axis] - sin * from[axis]);
            (along, inwards)
        };
        let pressing = |index: usize, tension: f64| {
            let (along, inwards) = at(index);
            let bend = tension * angle / length;
            let force = [0, 1, 2].map(|axis| {
                let down = if axis == 2 { weight } else { 0.0 };
                down - weight * along[2] * along[axis] + bend * inwards[axis]
            });
            dot(force, force).sqrt()
        };
        for index in (0..steps).rev() {
            let (above, below) = (at(index).0[2], at(index + 1).0[2]);
            let at_bottom = pressing(index + 1, tension);
            tension += 0.5 * weight * (above + below) * step;
            torque += 0.5 * (at_bottom + pressing(index, tension)) * step * OUTER_RADIUS;
        }
    }
    torque
}

/// A tube of a length and an outer diameter, m.
fn tube(length: f64, diameter: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.035,
        outer_radius: 0.5 * diameter,
    }
}

/// Torque per coefficient of friction of sections in a level well, N m.
fn torque(sections: &[(usize, &[Tube])]) -> f64 {
    let sections = sections.iter().map(|&(repeat, parts)| Section {
        repeat,
        parts: parts.to_vec(),
    });
    let steel = pipe().material();
    let string = Drillstring::new(steel, sections.collect(), 0.0).unwrap();
    let force = SideForce::new(&string, &level(), None, PressedBy::Weight);
    force.friction_torques(1, 0.0)[0]
}

/// A well that is level from its mouth on.
fn level() -> Survey {
    let station = |measured_depth| Station {
        measured_depth,
        inclination: std::f64::consts::FRAC_PI_2,
        azimuth: 0.0,
    };
    Survey::new(vec![station(0.0), station(1e5)]).unwrap()
}

/// The same of parts that lie at these diameters each, m.
fn lying_at(parts: &[(Tube, f64)]) -> f64 {
    let torque = |(tube, diameter): &(Tube, f64)| {
        7850.0 * GRAVITY * tube.area() * tube.length * 0.5 * diameter
    };
    parts.iter().map(torque).sum()
}

#[track_caller]
fn assert_alike(found: f64, expected: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off < 1e-9, "{found} instead of {expected}");
}

/// Whether cells repeat or are written out.
#[test]
fn val_pipe_lies_on_its_joints() {
    let cell = [tube(9.1, 0.127), tube(0.5, 0.168)];
    let lying = lying_at(&cell.map(|part| (part, 0.168)));
    assert_alike(torque(&[(100, &cell)]), 100.0 * lying);
    assert_alike(torque(&[(1, &cell.repeat(100))]), 100.0 * lying);
}

/// Parts of an assembly, each too long to be carried by another.
#[test]
fn val_long_parts_lie_on_themselves() {
    let cell = [tube(9.1, 0.127), tube(0.5, 0.168)];
    let assembly = [
        tube(50.0, 0.15),
        tube(115.0, 0.187),
        tube(57.0, 0.21),
        tube(39.0, 0.247),
    ];
    let own = assembly.map(|part| (part, 2.0 * part.outer_radius));
    let pipe = 100.0 * lying_at(&cell.map(|part| (part, 0.168)));
    assert_alike(
        torque(&[(100, &cell), (1, &assembly)]),
        pipe + lying_at(&own),
    );
}

/// A collar between two stabilisers lies on these until it sags to the wall: the sag of a clamped
/// beam under its weight, w L⁴/384EI.
#[test]
fn val_a_collar_lies_on_its_stabilisers_until_it_sags() {
    let [upper, lower] = [tube(1.0, 0.3), tube(1.0, 0.28)];
    let collar = tube(1.0, 0.203);
    let weight = 7850.0 * GRAVITY * collar.area();
    let rigidity = 2.6 * 79.3e9 * collar.second_moment();
    let touches = (384.0 * rigidity * 0.5 * (0.28 - 0.203) / weight).powf(0.25);
    assert!((15.0..30.0).contains(&touches), "{touches}");
    for (length, is_carried) in [(0.99 * touches, true), (1.01 * touches, false)] {
        let between = Tube { length, ..collar };
        // Each half on the nearer.
        let mean = if is_carried { 0.29 } else { 0.203 };
        let lying = lying_at(&[(upper, 0.3), (between, mean), (lower, 0.28)]);
        let string = [upper, between, lower];
        assert_alike(torque(&[(1, &string)]), lying);
    }
}

/// Blades, narrow in body: the collars next to them lie on them.
#[test]
fn val_collars_lie_on_blades() {
    let parts = [tube(8.0, 0.203), tube(1.0, 0.203), tube(60.0, 0.203)];
    let steel = pipe().material();
    let section = Section {
        repeat: 1,
        parts: parts.to_vec(),
    };
    let string = Drillstring::new(steel, vec![section], 0.0).unwrap();
    let force = SideForce::touching(
        &string,
        &[vec![0.1015, 0.155, 0.1015]],
        &level(),
        None,
        PressedBy::Weight,
    );
    let lying = lying_at(&[(parts[0], 0.31), (parts[1], 0.31), (parts[2], 0.203)]);
    assert_alike(force.friction_torques(1, 0.0)[0], lying);
}

/// What carries may be carried: pipe on joints, these on two stabilisers near each other.
#[test]
fn val_what_carries_is_carried() {
    let parts = [
        tube(1.0, 0.3),
        tube(4.0, 0.127),
        tube(0.5, 0.168),
        tube(4.0, 0.127),
        tube(1.0, 0.3),
    ];
    assert_alike(
        torque(&[(1, &parts)]),
        lying_at(&parts.map(|part| (part, 0.3))),
    );
}

mod random_strings {
    use proptest::prelude::*;

    use super::*;

    fn parts() -> impl Strategy<Value = Vec<Tube>> {
        let part = (0.2..60.0, 0.1..0.4).prop_map(|(length, diameter)| tube(length, diameter));
        prop::collection::vec(part, 1..25)
    }

    proptest! {
        /// It lies at no less than each part's own radius and no more than the widest; upside down
        /// as upright; and in parts that are cut in two as in whole ones.
        #[test]
        fn val_what_carries_a_part_does_not_depend_on_how_it_is_written(parts in parts()) {
            let found = torque(&[(1, &parts)]);
            let widest = parts.iter().map(|it| 2.0 * it.outer_radius).fold(0.0, f64::max);
            let lying = |diameter: &dyn Fn(&Tube) -> f64| -> f64 {
                lying_at(&parts.iter().map(|it| (*it, diameter(it))).collect::<Vec<_>>())
            };
            let least = lying(&|it| 2.0 * it.outer_radius);
            prop_assert!(found >= least * (1.0 - 1e-12) && found <= lying(&|_| widest) * (1.0 + 1e-12));
            let upside_down: Vec<Tube> = parts.iter().rev().copied().collect();
            let other = torque(&[(1, &upside_down)]);
            prop_assert!((found / other - 1.0).abs() < 1e-9, "{} {}", found, other);
            let half = |it: &Tube| Tube { length: 0.5 * it.length, ..*it };
            let halves: Vec<Tube> = parts.iter().flat_map(|it| [half(it); 2]).collect();
            let cut = torque(&[(1, &halves)]);
            prop_assert!((found / cut - 1.0).abs() < 1e-9, "{} {}", found, cut);
        }
    }
}

/// Bends between stations far closer than any length of pipe, where the string is cut as it is
/// where it does not bend, and bends in three dimensions.
#[test]
fn val_short_bends_press_as_much_as_they_turn() {
    let wells: [&[[f64; 3]]; 5] = [
        &[
            [0.0, 0.0, 0.0],
            [1000.0, 0.0, 0.0],
            [1000.3, 30.0, 0.0],
            [2000.0, 30.0, 0.0],
        ],
        &[
            [0.0, 0.0, 0.0],
            [1000.7, 0.0, 0.0],
            [1001.7, 3.0, 0.0],
            [1002.7, 0.0, 0.0],
            [2000.0, 0.0, 0.0],
        ],
        &[
            [0.0, 0.0, 0.0],
            [300.0, 2.0, 120.0],
            [800.0, 12.0, 120.0],
            [800.5, 13.2, 120.0],
            [2000.0, 55.0, 121.0],
        ],
        &[
            [0.0, 10.0, 350.0],
            [999.9, 40.0, 10.0],
            [1000.0, 40.0, 12.0],
            [2000.0, 90.0, 200.0],
        ],
        &[[0.0, 0.0, 0.0], [2000.0, 60.0, 0.0]],
    ];
    let string = pipe();
    let weight = 7850.0 * GRAVITY * string.sections()[0].parts[0].area();
    for stations in wells {
        let place = |&[measured_depth, inclination, azimuth]: &[f64; 3]| Station {
            measured_depth,
            inclination: inclination.to_radians(),
            azimuth: azimuth.to_radians(),
        };
        let survey = Survey::new(stations.iter().map(place).collect()).unwrap();
        let force = SideForce::new(&string, &survey, None, PressedBy::WeightAndTension);
        let expected = exact(stations, weight, 50_000);
        for (found, rule) in [
            (force.friction_torques(20, 0.0), "added up"),
            (force.wound_up(0.0).friction_torques(20), "divided"),
        ] {
            let found: f64 = found.iter().sum();
            let off = found / expected - 1.0;
            assert!(
                off.abs() < 1e-4,
                "{rule}: {found} instead of {expected}: {stations:?}"
            );
        }
    }
}
