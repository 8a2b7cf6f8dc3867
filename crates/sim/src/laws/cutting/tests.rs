use proptest::prelude::*;

use super::*;
use crate::laws::rock::Rock;
use crate::laws::torque::LoadLine;

/// A bit on load lines that change at random from step to step.
#[derive(Debug, Clone)]
struct Ride {
    cutting: Cutting,
    compliances: [f64; 2],
    /// Free speeds, rad/s and m/s.
    free: Vec<[f64; 2]>,
    step: f64,
}

fn ride() -> impl Strategy<Value = Ride> {
    let blades = prop_oneof![
        (1usize..9).prop_map(Blades::Even),
        prop::collection::vec(0.2..1.0f64, 2..7).prop_map(|parts| {
            let sum: f64 = parts.iter().sum();
            let angles = parts.iter().map(|part| part / sum * std::f64::consts::TAU);
            Blades::Uneven(angles.collect())
        }),
    ];
    let contact = prop_oneof![Just(FlatContact::Grows), Just(FlatContact::AtOnce)];
    let rock = (
        1e6..1e8f64,
        0.3..1.2f64,
        0.0..0.9f64,
        0.0..8e-3f64,
        1.0..50.0f64,
    );
    let lines = (1e-4..1e-1f64, 1e-7..1e-4f64);
    let free = prop::collection::vec([-2.0..30.0f64, -0.02..0.05f64], 40..120);
    (blades, contact, rock, 0.01..0.5f64, lines, free).prop_map(
        |(blades, contact, (energy, ratio, friction, flat, growth), relief, lines, free)| Ride {
            cutting: Cutting {
                rock: CuttingLaw {
                    bit_radius: 0.12,
                    specific_energy: energy,
                    cutting_ratio: ratio,
                    friction,
                    contact_strength: 4e7,
                    contact_growth: growth,
                    wear_flat: flat,
                    poor_cleaning: None,
                },
                contact,
                blades,
                relief,
            },
            compliances: [lines.0, lines.1],
            free,
            step: 2e-3,
        },
    )
}

/// What is wrong with a step, in parts of what there is.
fn wrong(
    ride: &Ride,
    place: &BitPlace,
    face: &Face,
    free: [f64; 2],
    cut: &CutStep,
) -> Option<String> {
    let [per_torque, per_weight] = ride.compliances;
    let [torque_stiffness, weight_stiffness] = ride.cutting.stiffnesses();
    let [growth, most] = ride.cutting.flats();
    let within = 0.5 * ride.step;
    let near = |what: &str, one: f64, other: f64, size: f64| {
        let is_near = (one - other).abs() <= 1e-9 * size.abs().max(1e-12);
        (!is_near).then(|| format!("{what}: {one} {other} of {size}"))
    };
    let speeds = [free[0].abs() + per_torque, free[1].abs() + 1e-6];
    let lines = near(
        "torsion",
        cut.speed,
        free[0] - per_torque * cut.torque,
        speeds[0],
    )
    .or_else(|| {
        near(
            "axis",
            cut.rate,
            free[1] - per_weight * cut.weight,
            speeds[1],
        )
    });
    if lines.is_some() {
        return lines;
    }
    let angle = place.angle + within * cut.speed;
    let blades = ride.cutting.blade_angles().len();
    let depths: Vec<f64> = (0..blades)
        .map(|blade| place.depth + within * cut.rate - face.ahead(blade, angle).0)
        .collect();
    let mean =
        |of: &dyn Fn(f64) -> f64| depths.iter().map(|it| of(*it)).sum::<f64>() / blades as f64;
    let deep = mean(&|depth| depth.max(0.0));
    let carried = |depth: f64, touching: bool| match () {
        () if depth < 0.0 || (depth == 0.0 && !touching) => 0.0,
        () if growth.is_finite() => (growth * depth).min(most),
        () => most,
    };
    let [least_flat, most_flat] = [false, true].map(|touching| {
        // A blade that has just landed is as deep as rounding says; that matters to a jump alone.
        let slack = if growth.is_finite() { 0.0 } else { 1e-12 };
        mean(&|depth| carried(depth + if touching { slack } else { -slack }, touching))
    });
    let flat = cut.weight - weight_stiffness * deep;
    let size = cut.weight.abs() + weight_stiffness * deep + most + speeds[1] / per_weight;
    let nearest = (0..blades)
        .map(|blade| place.depth - face.ahead(blade, angle).0)
        .fold(f64::NEG_INFINITY, f64::max);
    let above = (place.deepest - place.depth).max(-nearest).max(0.0);
    let bound = ride.cutting.relief * 0.12 * cut.speed.max(0.0) + above / ride.step;
    let of_flats = if cut.rate >= bound * (1.0 - 1e-12) && cut.weight > 0.0 {
        // Relief holds it: with what it takes.
        None
    } else if cut.rate > 0.0 {
        (flat < least_flat - 1e-9 * size || flat > most_flat + 1e-9 * size)
            .then(|| format!("down: {flat} not in {least_flat} to {most_flat}"))
    } else if cut.rate == 0.0 {
        (flat < -1e-9 * size || flat > most_flat + 1e-9 * size)
            .then(|| format!("at rest: {flat} not in 0 to {most_flat}"))
    } else {
        near("up", flat, 0.0, size)
    };
    if of_flats.is_some() {
        return of_flats;
    }
    if cut.rate > bound + 1e-9 * speeds[1] {
        return Some(format!("relief: {} {bound}", cut.rate));
    }
    // Where flats land, anything up to all of it.
    let law = [least_flat, most_flat]
        .map(|most| torque_stiffness * deep + ride.cutting.flat_radius() * flat.clamp(0.0, most));
    let size = torque_stiffness * deep + ride.cutting.flat_radius() * most + speeds[0] / per_torque;
    if cut.speed < 0.0 {
        // Blades cut one way alone.
        return near("turning back", cut.torque, 0.0, size);
    }
    if cut.speed == 0.0 {
        let is_more = cut.torque > law[1] + 1e-9 * size;
        return is_more.then(|| format!("held: {} {law:?}", cut.torque));
    }
    // A bit that had turned back meets the ledge where its own cut ends.
    if (angle - face.furthest()).abs() < 1e-9 && cut.torque >= 0.0 {
        return None;
    }
    let is_within = (law[0] - 1e-9 * size..=law[1] + 1e-9 * size).contains(&cut.torque);
    (!is_within).then(|| format!("torque: {} {law:?}", cut.torque))
}

/// A place between two angles at which the rock rises more steeply than its face says.
fn steeper_than_said(cutting: &Cutting, face: &Face, from: f64, to: f64) -> Option<[f64; 3]> {
    let said = face.steepest(from, to);
    let places = (0..40).map(|part| from + (f64::from(part) + 0.5) / 40.0 * (to - from));
    let mut rises = places.flat_map(|angle| {
        let blades = 0..cutting.blade_angles().len();
        blades.map(move |blade| [angle, face.ahead(blade, angle).1, said])
    });
    rises.find(|[_, rise, _]| *rise > said && to > from)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..Default::default() })]

    /// Both load lines, torque, weight, flats and relief, in every step of bits that stick, turn back,
    /// rest, lift off and land.
    #[test]
    fn every_step_obeys_its_laws(ride in ride()) {
        let forces = ride.cutting.forces();
        let mut face = ride.cutting.face(0.0);
        let mut place = BitPlace::default();
        for &free in &ride.free {
            let [compliance, axial] = ride.compliances;
            let line = LoadLine { time: 0.0, free_speed: free[0], compliance };
            let along = AxialLine {
                free_speed: free[1],
                compliance: axial,
                within: 0.5 * ride.step,
                step: ride.step,
            };
            let cut = forces.meet(&place, &face, line, &along);
            let to = place.angle + along.within * free[0];
            let gap = steeper_than_said(&ride.cutting, &face, place.angle, to);
            prop_assert!(gap.is_none(), "{gap:?}");
            let found = wrong(&ride, &place, &face, free, &cut);
            prop_assert!(found.is_none(), "{:?} {cut:?} {place:?}", found);
            place.angle += ride.step * cut.speed;
            place.depth += ride.step * cut.rate;
            place.speed = cut.speed;
            face.leave(place.angle, place.depth);
            if cut.speed > 0.0 || place.depth > place.deepest {
                place.deepest = place.depth;
            }
        }
    }
}

/// Bits of four blades, by their spacing and contact, on load lines that sway: at times they stick, rest or
/// rise. Of steps by `drill_on` and by `search`, which share no more than the face: how many there were, how many
/// drilled on, and how far they were apart at most.
fn ways_of_a_step(blades: &Blades, contact: FlatContact) -> (usize, usize, f64) {
    let Rock::Law(rock) = Rock::sandstone() else {
        unreachable!()
    };
    let cutting = Cutting {
        rock,
        contact,
        blades: blades.clone(),
        relief: 0.3,
    };
    let forces = cutting.forces();
    let mut face = cutting.face(0.0);
    let mut place = BitPlace {
        speed: 10.0,
        ..BitPlace::default()
    };
    let (steps, step) = (4000, 2e-3);
    let (mut drilled_on, mut most_apart) = (0, 0f64);
    for index in 0..steps {
        let time = step * f64::from(index);
        let line = LoadLine {
            time,
            free_speed: 16.0 + 9.0 * (3.0 * time).sin(),
            compliance: 1e-3,
        };
        let along = AxialLine {
            free_speed: 0.09 + 0.07 * (7.0 * time).sin(),
            compliance: 1e-6,
            within: 0.5 * step,
            step,
        };
        let searched = forces.search(&place, &face, line, &along);
        if let Some(drilled) = forces.drill_on(&place, &face, line, &along) {
            drilled_on += 1;
            for (one, other, size) in [
                (drilled.speed, searched.speed, 10.0),
                (drilled.rate, searched.rate, 0.01),
                (drilled.torque, searched.torque, 1e4),
                (drilled.weight, searched.weight, 1e5),
                (drilled.depth_of_cut, searched.depth_of_cut, 1e-3),
                (drilled.deepest_cut, searched.deepest_cut, 1e-3),
                (drilled.angle, searched.angle, 1.0),
                (drilled.depth, searched.depth, 1e-3),
            ] {
                most_apart = most_apart.max((one - other).abs() / size);
            }
            assert_eq!(drilled.touches, searched.touches);
        }
        place.angle += step * searched.speed;
        place.depth += step * searched.rate;
        place.speed = searched.speed;
        face.leave(place.angle, place.depth);
        place.deepest = place.deepest.max(place.depth);
    }
    (steps as usize, drilled_on, most_apart)
}

#[test]
fn a_bit_that_drills_on_does_what_is_found_by_search() {
    let uneven = [1.4, 1.7, 1.5];
    let last = std::f64::consts::TAU - uneven.iter().sum::<f64>();
    let uneven = Blades::Uneven(uneven.into_iter().chain([last]).collect());
    for blades in [uneven, Blades::Even(4)] {
        for contact in [FlatContact::Grows, FlatContact::AtOnce] {
            let (steps, drilled_on, apart) = ways_of_a_step(&blades, contact);
            println!("{blades:?} {contact:?}: {drilled_on} of {steps}, {apart:.1e} apart");
            assert!(4 * drilled_on > steps && drilled_on < steps, "{drilled_on}");
            assert!(apart < 1e-11, "{apart}");
        }
    }
}

/// What the blade before has left is found where it was left, at joints and between.
#[test]
fn a_face_is_what_the_blade_before_has_left() {
    let mut face = Face::new(vec![1.0], 0.0);
    for (angle, depth) in [(0.5, 1.0), (1.0, 2.0), (1.5, 1.0), (2.0, 5.0)] {
        face.leave(angle, depth);
    }
    // At 1.5 rad the rock was 1 deep already, at 2 rad 2; the bit went deeper there.
    for (angle, depth) in [(2.25, 1.5), (2.5, 1.0), (2.75, 3.0), (3.0, 5.0)] {
        // The deepest that was ever there: 1 at 1.5 rad, from the blade at 0.5.
        let (found, _) = face.ahead(0, angle);
        assert!(
            (found - depth).abs() < 1e-12 || angle == 2.25,
            "{angle}: {found} {depth}"
        );
    }
    // Behind the blade is its own cut.
    assert_eq!(face.ahead(0, 1.75).0, 3.0);
    // The rock before the blade falls, and then rises by four in half a radian. What ends where one
    // begins counts.
    assert_eq!(face.steepest(2.0, 2.2), 2.0);
    assert_eq!(face.steepest(2.01, 2.2), 0.0);
    assert_eq!(face.steepest(2.1, 2.9), 8.0);
    // A bit that bounces leaves what it found.
    face.leave(2.5, 0.0);
    assert_eq!(face.ahead(0, 2.5).0, 1.0);
}
