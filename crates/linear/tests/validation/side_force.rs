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
