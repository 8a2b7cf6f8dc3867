//! A string that is wound up by its surface: the number of pieces for a tolerance, against
//! closed forms and against winding it up in small steps.

use linear::well::{PressedBy, QuasiStaticTwist, SideForce, Station, Survey, least_pieces};
use linear::{Drillstring, Mud};
use problems::pipes;
use problems::wells::{Draw, Well};

/// Lying on its side all along.
fn horizontal(pipes: usize) -> (Drillstring, QuasiStaticTwist) {
    let string = pipes::row(pipes, 0.0);
    let station = |measured_depth| Station {
        measured_depth,
        inclination: std::f64::consts::FRAC_PI_2,
        azimuth: 0.0,
    };
    let survey = Survey::new(vec![station(0.0), station(string.length())]).unwrap();
    let force = SideForce::new(&string, &survey, None, PressedBy::Weight);
    let winding = force.wound_up(0.0);
    (string, winding)
}

/// f s against friction all along and C(d) = d/GJ: φ = f d²/(2 GJ). The worst is in the first
/// piece, which is as long as L/N and turns by f d²/(2 GJ) under f d² N/L instead of f d: off by
/// f L/(4N) at most.
#[test]
fn val_an_even_string_is_off_by_a_quarter_of_a_piece() {
    let (string, winding) = horizontal(100);
    let tube = string.sections()[0].parts[0];
    let rigidity = string.material().shear_modulus * tube.polar_moment();
    let total = winding.break_off_torque();
    for part in [0.1, 0.5, 0.9] {
        let angle = total * part * part * string.length() / (2.0 * rigidity);
        let off = winding.torque_at(angle) / (part * total) - 1.0;
        assert!(off.abs() < 1e-12, "{part}: {off}");
    }
    assert_eq!(winding.torque_at(1e9), total);
    for pieces in [1, 2, 7, 25, 333, 1999] {
        let torques = winding.friction_torques(pieces);
        for off in [
            winding.off_when_wound_up(&torques),
            winding.off_by(&torques),
        ] {
            let off = 4.0 * pieces as f64 * off - 1.0;
            assert!(off.abs() < 1e-9, "{pieces}: {off}");
        }
    }
    let windings = [winding];
    assert_eq!(least_pieces(&windings, 0.0501, 2000), Ok(5));
    assert_eq!(least_pieces(&windings, 0.0101, 2000), Ok(25));
    let error = least_pieces(&windings, 1e-4, 2000).unwrap_err();
    assert_eq!((error.most, error.pieces), (2000, 2000));
    assert!((error.off / 1.25e-4 - 1.0).abs() < 1e-9, "{error}");
}

/// Nothing presses, nothing is off.
#[test]
fn val_a_vertical_string_takes_one_piece() {
    let string = pipes::row(50, 0.0);
    let station = |measured_depth| Station {
        measured_depth,
        inclination: 0.0,
        azimuth: 0.0,
    };
    let survey = Survey::new(vec![station(0.0), station(500.0)]).unwrap();
    let force = SideForce::new(&string, &survey, None, PressedBy::WeightAndTension);
    let winding = force.wound_up(1e5);
    assert_eq!(winding.break_off_torque(), 0.0);
    assert_eq!(least_pieces(&[winding], 1e-4, 2000), Ok(1));
}

/// A chain of nodes at depths, each under its own friction, of which the first ones turn: the angle
/// of the surface at the torque at which the next one starts. Node by node, from the lowest that
/// turns up.
fn angles(depths: &[f64], torques: &[f64], compliance: &impl Fn(f64, f64) -> f64) -> Vec<[f64; 2]> {
    (0..depths.len())
        .map(|held| {
            let (mut torque, mut angle) = (torques[held], 0.0);
            for node in (0..=held).rev() {
                let above = if node == 0 { 0.0 } else { depths[node - 1] };
                angle += torque * compliance(above, depths[node]);
                if node > 0 {
                    torque += torques[node - 1];
                }
            }
            [angle, torque]
        })
        .collect()
}

/// The torque at an angle, along straight lines from the origin.
fn along(line: &[[f64; 2]], angle: f64) -> f64 {
    let next = line.partition_point(|point| point[0] < angle);
    let Some(&[end, to]) = line.get(next) else {
        return line[line.len() - 1][1];
    };
    let [start, from] = if next == 0 { [0.0; 2] } else { line[next - 1] };
    from + (to - from) * (angle - start) / (end - start)
}

/// Random strings in random wells: friction in the middles of a few pieces and of thousands of
/// short ones, wound up node by node, differ by the estimate, up to the error of the latter.
#[test]
fn val_friction_in_pieces_is_off_by_the_estimate() {
    for number in 0..18 {
        let mut draw = Draw::new(number);
        let Well { string, survey } = Well::draw(number, &mut draw);
        let mud = Some(Mud {
            density: 1200.0,
            viscosity: 0.0,
        });
        let force = SideForce::new(&string, &survey, mud, PressedBy::WeightAndTension);
        let weight = draw.uniform(0.0, 5e4);
        let (length, winding) = (string.length(), force.wound_up(weight));
        // Twist by a unit of torque down to a depth, tube by tube.
        let (mut joints, mut depth, mut twisted) = (Vec::new(), 0.0, 0.0);
        for section in string.sections() {
            for part in (0..section.repeat).flat_map(|_| &section.parts) {
                let rigidity = string.material().shear_modulus * part.polar_moment();
                depth += part.length;
                twisted += part.length / rigidity;
                joints.push([depth, twisted]);
            }
        }
        let twist = |above: f64, below: f64| along(&joints, below) - along(&joints, above);
        let middles = |pieces: usize| -> Vec<f64> {
            let middle = |index: usize| (index as f64 + 0.5) * length / pieces as f64;
            (0..pieces).map(middle).collect()
        };
        let fine = winding.friction_torques(4000);
        // Where nothing presses, it turns with what is below.
        let (places, fine): (Vec<f64>, Vec<f64>) = std::iter::zip(middles(4000), fine)
            .filter(|(_, torque)| *torque > 0.0)
            .unzip();
        let spread = angles(&places, &fine, &twist);
        let total = spread[spread.len() - 1][1];
        for pieces in [3, 20] {
            // As a file that gives their number has them.
            let all = force.friction_torques(pieces, weight);
            let (places, torques): (Vec<f64>, Vec<f64>) = std::iter::zip(middles(pieces), &all)
                .filter(|(_, torque)| **torque > 0.0)
                .unzip();
            let lumped = angles(&places, &torques, &twist);
            let most = spread.iter().fold(0.0, |most: f64, &[angle, torque]| {
                most.max((along(&lumped, angle) - torque).abs())
            });
            let (found, expected) = (winding.off_when_wound_up(&all), most / total);
            assert!(
                (found - expected).abs() < 0.01 * expected + 2e-4,
                "{number}, {pieces}: {found} {expected}"
            );
        }
    }
}
