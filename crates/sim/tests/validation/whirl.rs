//! Validation of lateral motion against the balance of forces in steady whirl, with the
//! exact dynamic stiffness of the string, and against what the paper shows in Figs. 10
//! to 15.

use linear::elements::reconstruction::WholeString;
use linear::method::{FiniteElement, Transform};
use linear::waves::inversion::time_response;
use linear::waves::lateral::BendingNetwork;
use linear::{Complex64, Drillstring, Method, RaisedCosine, Sites, SurfaceSupport, responses};
use problems::academic::{self, BENDING};
use problems::oracles::assert_close;
use sim::excitation::least_impulse;
use sim::laws::contact::Touch;
use sim::{
    EccentricMass, Impulse, Lateral, LateralMeasures, LateralRegime, Sampling, Scene, Simulator,
    SteadyWhirl, Stopping, Timing, Trajectory, Wall, WhirlingSite,
};

const DURATION: f64 = 10.0;
const PULSE: f64 = 0.02;
const SPEED: f64 = std::f64::consts::TAU;
const CLEARANCE: f64 = 0.015;

fn wall(friction: f64) -> Wall {
    Wall {
        clearance: CLEARANCE,
        stiffness: 1e9,
        friction,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    }
}

struct Case {
    simulator: Simulator,
    /// I₀ at each site, N s.
    least_impulses: Vec<f64>,
}

impl Case {
    fn new(method: &Method, distances: &[f64]) -> Self {
        let string = academic::string();
        let request = academic::lateral_request(&string, distances, DURATION);
        let responses = responses(&string, method, &request).unwrap();
        let bending = responses.bending().unwrap();
        let least_impulses = (0..distances.len())
            .map(|site| {
                let taps = &bending.from_loads[site][site];
                least_impulse(
                    taps,
                    Sampling::new(academic::SAMPLING_FREQUENCY, 0.0),
                    PULSE,
                    CLEARANCE,
                )
            })
            .collect();
        Self {
            simulator: Simulator::new(&responses).unwrap(),
            least_impulses,
        }
    }

    fn run(&self, lateral: Lateral, record: Option<&mut Trajectory>) -> LateralMeasures {
        self.run_at(SPEED, lateral, record)
    }

    fn run_at(
        &self,
        surface_speed: f64,
        lateral: Lateral,
        record: Option<&mut Trajectory>,
    ) -> LateralMeasures {
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(lateral),
            timing: Timing {
                duration: DURATION,
                closing_window: 2.0,
            },
        };
        let outcome = self.simulator.simulate(&scene, Stopping::Full, record);
        outcome.unwrap().lateral().unwrap()
    }

    fn impulse(&self, site: usize, ratio: f64) -> Impulse {
        Impulse {
            site,
            amount: ratio * self.least_impulses[site],
            start: 1.0,
            duration: PULSE,
            direction: 0.0,
        }
    }

    /// One wall at the bit, an impulse there.
    fn at_bit(&self, ratio: f64, wall: Wall) -> Lateral {
        Lateral {
            walls: vec![wall],
            impulses: vec![self.impulse(0, ratio)],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        }
    }
}

fn network(string: &Drillstring) -> BendingNetwork<'_> {
    BendingNetwork::new(string, BENDING, SurfaceSupport::Free, &Sites::bit()).unwrap()
}

/// The one way in which the string rolls along a wall at the bit.
fn steady_whirl(string: &Drillstring, wall: Wall) -> SteadyWhirl {
    let network = network(string);
    let site = WhirlingSite {
        wall,
        dynamic_stiffness: |rate| network.dynamic_stiffness(0, rate),
        decay: linear::bending_decay::BendingDecay::new(string, &BENDING),
    };
    let [steady] = site.rolling_at(SPEED)[..] else {
        panic!("one steady whirl");
    };
    steady
}

/// Fig. 10: the site is pushed along the wall against the rotation, and comes back. The
/// wall is first met when the free motion, by the exact responses, reaches it.
#[test]
fn val_figure_10_touches_the_wall_and_comes_back() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let mut trajectory = Trajectory::default();
    let lateral = case.at_bit(3.0, wall(0.5));
    let amount = lateral.impulses[0].amount;
    let found = case.run(lateral, Some(&mut trajectory));
    assert_eq!(found.regime, LateralRegime::TransientContact);

    let (string, pulse, step) = (academic::string(), RaisedCosine { duration: PULSE }, 1e-4);
    let network = network(&string);
    let displaced = |s: Complex64| network.receptance(s)[(0, 0)] * pulse.transform(s) * amount;
    let free = time_response(displaced, step, 400, 16);
    let reached = free.iter().position(|x| *x >= CLEARANCE).unwrap();
    assert_close(
        found.first_contact.unwrap(),
        1.0 + reached as f64 * step,
        0.002,
    );

    let pushed = |force: &[f64; 2]| *force != [0.0; 2];
    let left = trajectory.wall_forces[0].iter().rposition(pushed).unwrap();
    assert!((left as f64) < 2.0 * academic::SAMPLING_FREQUENCY);
    let [x, y] = trajectory.positions[0][left];
    assert!(x > 0.0 && y < 0.0);
}

/// Fig. 12, with the paper's wall and with a rigid one. In steady backward whirl the wall
/// supplies the dynamic stiffness of the string at the rate of whirl: F_N = −Re K r and
/// friction = |Im K| r, and a string that rolls goes round at Ω R₀ / r.
#[test]
fn val_figure_12_whirls_backward_as_the_forces_balance() {
    let string = academic::string();
    let network = network(&string);
    let rigid = Wall {
        stiffness: f64::INFINITY,
        ..wall(2.0)
    };
    // On a rigid wall the speeds of Newmark's scheme jump to and fro: its differences
    // of displacements are not passive.
    let elements = Method::FiniteElement(FiniteElement::default());
    for (method, wall) in [
        (Method::Quadrature, wall(2.0)),
        (Method::Quadrature, rigid),
        (elements, wall(2.0)),
    ] {
        let case = Case::new(&method, &[0.0]);
        let steady = steady_whirl(&string, wall);
        let mut trajectory = Trajectory::default();
        let found = case.run(case.at_bit(3.0, wall), Some(&mut trajectory));
        assert_eq!(found.regime, LateralRegime::BackwardWhirl);
        assert_close(found.mean_radius, steady.radius, 0.01);
        assert_close(found.precession_rate, -steady.rate, 0.01);
        // At 64 steps a turn, schemes of second order miss the force by 1.3 %.
        assert_close(found.mean_normal_force, steady.normal_force, 0.015);
        assert_eq!((found.contact_fraction, found.rolling_fraction), (1.0, 1.0));
        assert_eq!(found.ambiguous_steps, 0);

        let ([x, y], [force_x, force_y]) = (
            *trajectory.positions[0].last().unwrap(),
            *trajectory.wall_forces[0].last().unwrap(),
        );
        let friction = (force_y * x - force_x * y) / x.hypot(y);
        let [_, imaginary] = network.dynamic_stiffness(0, steady.rate);
        assert_close(friction.abs(), imaginary.abs() * steady.radius, 0.015);
    }
}

/// Fig. 15: forward whirl at the rate of rotation has the same kind of balance. The
/// eccentric force, at an angle, is the dynamic stiffness times r, the normal force of a
/// wall that yields by k_c (r − c)^(3/2), and the friction of sliding: one radius.
#[test]
fn val_figure_15_whirls_forward_as_the_forces_balance() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let (mass, offset, friction) = (1000.0, 0.1, 0.5);
    let wall = wall(friction);
    let found = case.run(
        Lateral {
            walls: vec![wall],
            impulses: vec![],
            eccentric_masses: vec![EccentricMass {
                site: 0,
                mass,
                offset,
            }],
            lying: None,
            shocks: None,
        },
        None,
    );
    assert_eq!(found.regime, LateralRegime::ForwardWhirl);
    assert_eq!(found.rolling_fraction, 0.0);
    assert_close(found.precession_rate, SPEED, 0.01);

    let string = academic::string();
    let stiffness = network(&string).at_rate(SPEED)[(0, 0)].inv();
    let normal_force = |radius: f64| wall.stiffness * (radius - CLEARANCE).powf(1.5);
    let lacks = |radius: f64| {
        let along = stiffness.re * radius + normal_force(radius);
        let across = stiffness.im * radius + friction * normal_force(radius);
        along.hypot(across) - mass * (offset + radius) * SPEED.powi(2)
    };
    let [mut inside, mut outside] = [CLEARANCE, 2.0 * CLEARANCE];
    while outside - inside > 1e-9 {
        let middle = 0.5 * (inside + outside);
        *(if lacks(middle) < 0.0 {
            &mut inside
        } else {
            &mut outside
        }) = middle;
    }
    assert_close(found.mean_radius, inside, 0.01);
    assert_close(found.mean_normal_force, normal_force(inside), 0.01);
}

#[test]
fn val_below_the_least_impulse_nothing_touches() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let label = |ratio| case.run(case.at_bit(ratio, wall(2.0)), None).regime;
    assert_eq!(label(0.999), LateralRegime::NoContact);
    assert_ne!(label(1.01), LateralRegime::NoContact);
}

/// Fig. 14: the friction above which an impulse starts backward whirl falls with the
/// impulse, to a little above the least that sustains it when it rolls.
#[test]
fn val_the_limit_of_whirl_falls_with_the_impulse() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let limit = |ratio: f64| {
        let (mut low, mut high) = (1.0, 3.0);
        while high - low > 0.005 {
            let middle = 0.5 * (low + high);
            match case.run(case.at_bit(ratio, wall(middle)), None).regime {
                LateralRegime::BackwardWhirl => high = middle,
                _ => low = middle,
            }
        }
        0.5 * (low + high)
    };
    let limits = [1.5, 2.0, 3.0, 5.0].map(limit);
    let falls = limits.windows(2).all(|pair| pair[1] <= pair[0]);
    assert!(falls && limits[0] > 1.2 * limits[3], "{limits:?}");
    let least = steady_whirl(&academic::string(), wall(0.0)).least_friction;
    let above = |limit: &f64| (1.0..1.1).contains(&(limit / least));
    assert!(limits[2..].iter().all(above), "{limits:?} {least}");
}

#[test]
fn val_rotating_the_impulse_rotates_the_motion() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let motion = |direction: f64| {
        let mut lateral = case.at_bit(3.0, wall(0.5));
        lateral.impulses[0].direction = direction;
        let mut trajectory = Trajectory::default();
        case.run(lateral, Some(&mut trajectory));
        trajectory.positions.remove(0)
    };
    let (straight, turned) = (motion(0.0), motion(0.8));
    let (sin, cos) = 0.8f64.sin_cos();
    for ([x, y], [u, v]) in straight.iter().zip(&turned) {
        let difference = (x * cos - y * sin - u).hypot(x * sin + y * cos - v);
        assert!(difference < 1e-9 * CLEARANCE, "{difference}");
    }
}

#[test]
fn val_turning_the_other_way_whirls_the_other_way() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let one = case.run_at(SPEED, case.at_bit(3.0, wall(2.0)), None);
    let other = case.run_at(-SPEED, case.at_bit(3.0, wall(2.0)), None);
    assert_close(other.precession_rate, -one.precession_rate, 1e-9);
    assert_close(other.mean_normal_force, one.mean_normal_force, 1e-9);
}

/// The bit's torque and the wall act on one site in one step. A wall without
/// friction leaves torsion alone; one with friction obeys both laws.
#[test]
fn val_the_bit_cuts_and_touches_the_wall_at_once() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let bit = sim::BitTorque {
        torque_static: 2400.0,
        torque_dynamic: 2000.0,
        decay_speed: 0.0,
    };
    let run = |friction: f64, ratio: f64| {
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: SPEED,
            bit: Some(bit),
            friction: Vec::new(),
            axial: None,
            lateral: Some(case.at_bit(ratio, wall(friction))),
            timing: Timing {
                duration: DURATION,
                closing_window: 2.0,
            },
        };
        let mut trajectory = Trajectory::default();
        let outcome = (case.simulator).simulate(&scene, Stopping::Full, Some(&mut trajectory));
        (outcome.unwrap(), trajectory)
    };
    let (smooth, frictionless) = run(0.0, 3.0);
    let (undisturbed, quiet) = run(2.0, 0.0);
    assert_eq!(frictionless.speeds, quiet.speeds);
    assert_eq!(smooth.torsion(), undisturbed.torsion());
    assert_eq!(
        undisturbed.lateral().unwrap().regime,
        LateralRegime::NoContact
    );

    let (both, trajectory) = run(2.0, 3.0);
    assert_eq!(both.lateral().unwrap().regime, LateralRegime::BackwardWhirl);
    assert_eq!(both.torsion().unwrap().regime, sim::TorsionRegime::Smooth);
    for (speed, torque) in trajectory.speeds[0].iter().zip(&trajectory.bit_torque) {
        let slides = *speed > 0.0 && *torque == -2000.0 || *speed < 0.0 && *torque == 2000.0;
        let sticks = *speed == 0.0 && torque.abs() <= 2400.0;
        assert!(slides || sticks, "{speed} {torque}");
    }
}

#[test]
fn val_three_sites_whirl_together() {
    for method in [
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
        Method::Hilbert(Transform {
            seconds: Some(20.0),
        }),
    ] {
        let case = Case::new(&method, &[100.0, 50.0, 0.0]);
        let lateral = |friction| Lateral {
            walls: vec![wall(friction); 3],
            impulses: vec![case.impulse(1, 3.0)],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        };
        let low = case.run(lateral(0.5), None).regime;
        assert_eq!(low, LateralRegime::TransientContact, "{}", method.name());
        let high = case.run(lateral(2.0), None);
        assert_eq!(
            high.regime,
            LateralRegime::BackwardWhirl,
            "{} {high:?}",
            method.name()
        );
    }
}

/// Fig. 13: the reconstructed string passes through the simulated sites, and is
/// displaced most where the wall is.
#[test]
fn val_the_reconstructed_string_passes_through_its_site() {
    let parameters = FiniteElement::default();
    let case = Case::new(&Method::FiniteElement(parameters), &[0.0]);
    let lateral = case.at_bit(3.0, wall(2.0));
    let mut trajectory = Trajectory::default();
    let found = case.run(lateral, Some(&mut trajectory));
    let string = academic::string();
    let whole = WholeString {
        string: &string,
        bending: &BENDING,
        support: SurfaceSupport::Free,
        sites: &Sites::bit(),
        sampling_frequency: academic::SAMPLING_FREQUENCY,
        parameters,
    };
    let whole = whole.reconstruct(&trajectory.forces, &[2000]).unwrap();
    let bit = whole.depths.len() - 1;
    assert_close(whole.depths[bit], 1000.0, 1e-9);
    assert_close(whole.peaks[bit], found.peak_radius, 1e-9);
    let [x, y] = trajectory.positions[0][2000];
    let [shape_x, shape_y] = &whole.shapes[0];
    assert!((shape_x[bit] - x).hypot(shape_y[bit] - y) < 1e-9 * CLEARANCE);
    assert!(whole.peaks.iter().all(|peak| *peak <= whole.peaks[bit]));
}

/// The whole string passes through each of several sites, at any step: by finite elements to
/// rounding, whose mesh it is; by another method about as well as both agree on the response to
/// the same forces.
#[test]
fn val_the_whole_string_passes_through_every_site_at_every_time() {
    let parameters = FiniteElement::default();
    let distances = [100.0, 50.0, 0.0];
    let snapshots = [0, 655, 700, 900, 1300, 2000];
    for (method, close) in [
        (Method::FiniteElement(parameters), 1e-8),
        (Method::Quadrature, 0.1),
    ] {
        let case = Case::new(&method, &distances);
        let lateral = Lateral {
            walls: vec![wall(2.0); 3],
            impulses: vec![case.impulse(1, 3.0)],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        };
        let mut trajectory = Trajectory::default();
        case.run(lateral, Some(&mut trajectory));
        let string = academic::string();
        let whole = WholeString {
            string: &string,
            bending: &BENDING,
            support: SurfaceSupport::Free,
            sites: &Sites::new(&string, &distances).unwrap(),
            sampling_frequency: academic::SAMPLING_FREQUENCY,
            parameters,
        };
        let whole = whole.reconstruct(&trajectory.forces, &snapshots).unwrap();
        assert_eq!(whole.shapes.len(), snapshots.len());
        let mut furthest = 0.0_f64;
        for (site, distance) in distances.iter().enumerate() {
            let node = |depth: &f64| (depth - (string.length() - distance)).abs() < 1e-6;
            let node = whole.depths.iter().position(node).unwrap();
            for (step, [x, y]) in snapshots.iter().zip(&whole.shapes) {
                let [at_x, at_y] = trajectory.positions[site][*step];
                furthest = furthest.max((x[node] - at_x).hypot(y[node] - at_y));
            }
        }
        assert!(
            furthest < close * CLEARANCE,
            "{} {furthest:e}",
            method.name()
        );
        // One that it does pass by: the forces are those of another method.
        assert!(method == Method::FiniteElement(parameters) || furthest > 0.01 * CLEARANCE);
    }
}

/// What is kept of contact is what its laws say: the normal force is the part of the force
/// against the radius, there is none without contact, and rolling takes no more friction than
/// there is.
#[test]
fn val_a_history_tells_how_a_site_touches() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let mut seen = [0; 3];
    for most in [0.5, 2.0] {
        let mut trajectory = Trajectory::default();
        case.run(case.at_bit(3.0, wall(most)), Some(&mut trajectory));
        for (step, &touch) in trajectory.touches[0].iter().enumerate() {
            seen[touch as usize] += 1;
            let [x, y] = trajectory.positions[0][step];
            let [force_x, force_y] = trajectory.wall_forces[0][step];
            let normal = trajectory.normal_forces[0][step];
            if touch == Touch::Free {
                assert_eq!((normal, force_x, force_y), (0.0, 0.0, 0.0));
                continue;
            }
            let radius = x.hypot(y);
            assert!(normal > 0.0 && radius > CLEARANCE);
            let against = -(force_x * x + force_y * y) / radius;
            assert_close(against, normal, 1e-9);
            let friction = (force_x * y - force_y * x).abs() / radius / normal;
            match touch {
                Touch::Sliding => assert_close(friction, most, 1e-9),
                _ => assert!(friction <= most * (1.0 + 1e-9), "{step}: {friction}"),
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// A smooth wall, against which a force presses for nearly all of the time.
#[test]
fn val_a_site_that_leans_on_the_wall_does_not_whirl() {
    let case = Case::new(&Method::Quadrature, &[0.0]);
    let force = Impulse {
        amount: 100.0 * case.least_impulses[0],
        duration: 1.8 * DURATION,
        ..case.impulse(0, 1.0)
    };
    let lateral = Lateral {
        walls: vec![wall(0.0)],
        impulses: vec![force],
        eccentric_masses: vec![],
        lying: None,
        shocks: None,
    };
    let lateral = case.run(lateral, None);
    assert!(lateral.contact_fraction > 0.9, "{lateral:?}");
    assert_eq!(lateral.precession_rate, 0.0);
    assert_eq!(lateral.regime, LateralRegime::TransientContact);
}

/// A site on a spring, alone: what its centre does is known in closed form.
mod oscillator {
    use std::f64::consts::TAU;

    use linear::passivity::Ending;
    use linear::{Channel, ChannelResponses, Responses};

    use super::*;

    const SAMPLING_FREQUENCY: f64 = 640.0;
    /// Oscillations a second, and their decay, 1/s.
    const FREQUENCY: f64 = 4.0;
    const DECAY: f64 = 0.05;

    /// Impulses (N s) with their starts (s) and directions (rad); the precession rate,
    /// turns/s.
    fn precession(impulses: &[(f64, f64, f64)]) -> f64 {
        let steps = (DURATION * SAMPLING_FREQUENCY) as usize + 2;
        let displacement = |step: usize| {
            let time = step as f64 / SAMPLING_FREQUENCY;
            let rate = TAU * FREQUENCY;
            (-DECAY * time).exp() * (rate * time).sin() / rate / SAMPLING_FREQUENCY
        };
        // The first may not be zero.
        let bending = (0..steps)
            .map(|step| displacement(step).max(if step == 0 { 1e-9 } else { -1.0 }))
            .collect();
        let channel = |channel, from_surface, taps, ending| ChannelResponses {
            channel,
            loads: vec![0],
            from_surface,
            from_loads: vec![vec![taps]],
            ending,
        };
        let torsion = channel(Channel::Torsion, vec![vec![1.0]], vec![1e-5], Ending::Whole);
        let bending = channel(Channel::Bending, vec![], bending, Ending::Cut);
        let responses = Responses {
            string: academic::string().id(),
            method: Method::Quadrature,
            sites: Sites::bit(),
            sampling_frequency: SAMPLING_FREQUENCY,
            longest_time: DURATION,
            channels: vec![torsion, bending],
        };
        let impulse = |&(amount, start, direction): &(f64, f64, f64)| Impulse {
            site: 0,
            amount,
            start,
            duration: PULSE,
            direction,
        };
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: SPEED,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall(0.5)],
                impulses: impulses.iter().map(impulse).collect(),
                eccentric_masses: vec![],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: DURATION,
                closing_window: 2.0,
            },
        };
        let simulator = Simulator::new(&responses).unwrap();
        let outcome = simulator.simulate(&scene, Stopping::Full, None);
        let lateral = outcome.unwrap().lateral().unwrap();
        assert_eq!(lateral.regime, LateralRegime::NoContact);
        assert!(lateral.peak_radius > 0.1 * CLEARANCE);
        lateral.precession_rate / TAU
    }

    #[test]
    fn val_motion_in_a_plane_goes_round_neither_way() {
        for degrees in [0.0, 30.0, 77.0, 90.0, 200.0, 315.0_f64] {
            for start in [1.0, 1.1, 6.3] {
                let rate = precession(&[(0.1, start, degrees.to_radians())]);
                assert_eq!(rate, 0.0, "{degrees}° at {start} s");
            }
        }
    }

    /// Two impulses across each other, a quarter of an oscillation apart, make an
    /// ellipse, however flat: it goes round once an oscillation, with the second of
    /// them.
    #[test]
    fn val_an_ellipse_goes_round_once_an_oscillation() {
        let quarter = 0.25 / FREQUENCY;
        for flatness in [1.0, 0.1, 1e-3, 1e-6] {
            for sign in [1.0, -1.0] {
                let across = sign * TAU / 4.0;
                let first = (0.1, 1.0, 0.4);
                let second = (0.1 * flatness, 1.0 + quarter, 0.4 + across);
                let rate = precession(&[first, second]);
                assert_close(rate, sign * FREQUENCY, 0.03);
            }
        }
    }
}
