use std::cell::Cell;

use linear::Complex64;
use linear::bending_decay::BendingDecay;
use numerics::products::{norm, product_complex};
use numerics::{Mat, eigenvalues};
use proptest::prelude::*;

use super::pencil::Pencil;
use super::*;
use crate::excitation::EccentricMass;

/// Masses in a row, each held by its own spring and damper and joined to the
/// next; the wall touches the first.
#[derive(Debug, Clone)]
struct Masses {
    masses: Vec<f64>,
    grounds: Vec<f64>,
    joints: Vec<f64>,
    decay_rate: f64,
}

impl Masses {
    /// The dynamic stiffness of the first mass by eliminating the others from the last
    /// on.
    fn stiffness(&self, rate: f64) -> [f64; 2] {
        let mut below = [0.0, 0.0];
        for index in (0..self.masses.len()).rev() {
            let mass = self.masses[index];
            let own = self.grounds[index] - mass * rate * rate;
            let [real, imaginary] = [
                own + below[0],
                2.0 * self.decay_rate * mass * rate + below[1],
            ];
            if index == 0 {
                return [real, imaginary];
            }
            // A joint k in series with z: kz/(k + z) = k − k²/(k + z).
            let joint = self.joints[index - 1];
            let (sum, size) = (joint + real, (joint + real).powi(2) + imaginary.powi(2));
            below = [
                joint - joint * joint * sum / size,
                joint * joint * imaginary / size,
            ];
        }
        below
    }

    /// The dynamic stiffness at all masses, row by row.
    fn stiffnesses(&self, rate: f64) -> Vec<Vec<Complex64>> {
        let count = self.masses.len();
        let mut whole = vec![vec![Complex64::ZERO; count]; count];
        for (index, mass) in self.masses.iter().enumerate() {
            let damping = 2.0 * self.decay_rate * mass * rate;
            whole[index][index] +=
                Complex64::new(self.grounds[index] - mass * rate * rate, damping);
        }
        for index in 1..count {
            let joint = self.joints[index - 1];
            for (row, column, sign) in [(0, 0, 1.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 1.0)] {
                whole[index - row][index - column] += sign * joint;
            }
        }
        whole
    }

    /// The receptance at the first masses, row by row: the others feel no force.
    fn receptance(&self, sites: usize, rate: f64) -> Vec<Complex64> {
        let whole = self.stiffnesses(rate);
        let unit = |place| {
            let mut force = vec![Complex64::ZERO; whole.len()];
            force[place] = Complex64::ONE;
            force
        };
        (0..sites)
            .flat_map(|site| solved(whole.clone(), unit(site)).into_iter().take(sites))
            .collect()
    }

    fn all_on(&self, walls: &[Wall]) -> WhirlingSites<impl Fn(f64) -> Vec<Complex64>> {
        WhirlingSites {
            walls: walls.to_vec(),
            receptance: |rate| self.receptance(walls.len(), rate),
            decay: BendingDecay::constant(self.decay_rate),
        }
    }

    /// The hardest that the first masses press at a rate.
    fn hardest(&self, sites: usize, rate: f64) -> Pencil {
        let most = 0.5 * rate / self.decay_rate;
        Pencil::new(&self.receptance(sites, rate), most)
    }

    fn on(&self, wall: Wall) -> WhirlingSite<impl Fn(f64) -> [f64; 2]> {
        WhirlingSite {
            wall,
            dynamic_stiffness: |rate| self.stiffness(rate),
            decay: BendingDecay::constant(self.decay_rate),
        }
    }
}

/// The solution of linear equations by elimination.
fn solved(mut matrix: Vec<Vec<Complex64>>, mut right: Vec<Complex64>) -> Vec<Complex64> {
    let count = right.len();
    for pivot in 0..count {
        let size = |row: &usize| matrix[*row][pivot].norm();
        let best = (pivot..count).max_by(|one, other| size(one).total_cmp(&size(other)));
        let best = best.expect("there are rows left");
        matrix.swap(pivot, best);
        right.swap(pivot, best);
        for row in pivot + 1..count {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            for column in pivot..count {
                let above = matrix[pivot][column];
                matrix[row][column] -= factor * above;
            }
            let above = right[pivot];
            right[row] -= factor * above;
        }
    }
    for row in (0..count).rev() {
        let known: Complex64 = (row + 1..count).map(|it| matrix[row][it] * right[it]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right
}

fn wall(stiffness: f64) -> Wall {
    Wall {
        clearance: 0.01,
        stiffness,
        friction: 0.0,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.1,
    }
}

/// The surface speed at which the fastest whirl has a rate.
fn speed_of(rate: f64) -> f64 {
    rate * 0.01 / 0.1
}

/// A Jeffcott rotor has μ* = 2ζs/(s² − 1) at s = ω/ω_n > 1, and no whirl
/// below its resonance.
#[test]
fn a_jeffcott_rotor_follows_its_closed_form() {
    let (mass, stiffness, ratio) = (50.0, 2e5, 0.1);
    let natural = f64::sqrt(stiffness / mass);
    let rotor = Masses {
        masses: vec![mass],
        grounds: vec![stiffness],
        joints: vec![],
        decay_rate: ratio * natural,
    };
    for s in [1.5, 2.0, 5.0] {
        let speed = speed_of(s * natural);
        let [found] = rotor.on(wall(f64::INFINITY)).rolling_at(speed)[..] else {
            panic!("one whirl");
        };
        assert!((found.rate - s * natural).abs() < 1e-9 * natural);
        assert!((found.surface_speed - speed).abs() < 1e-9 * speed);
        let expected = 2.0 * ratio * s / (s * s - 1.0);
        assert!((found.least_friction - expected).abs() < 1e-9);
        // A softer wall gives way: the radius grows, the rate falls.
        let [soft] = rotor.on(wall(1e7)).rolling_at(speed)[..] else {
            panic!("one whirl");
        };
        assert!(soft.radius > found.radius && soft.rate < found.rate);
        assert!((soft.surface_speed / speed - 1.0).abs() < 1e-9);
        let depth: f64 = soft.radius - 0.01;
        assert!((1e7 * depth.powf(1.5) / soft.normal_force - 1.0).abs() < 1e-6);
    }
    let slow = speed_of(0.5 * natural);
    assert_eq!(rotor.on(wall(1e7)).rolling_at(slow), []);
    assert_eq!(rotor.on(wall(1e7)).rolling_at(0.0), []);
}

/// Without damping the stiffness falls from +∞ to −∞ between neighbouring
/// antiresonances (Foster's theorem), and the wall's answer falls with the rate: so
/// one whirl between each pair, and one below the first. Light damping moves them
/// little, and adds some in the antiresonances themselves, which need much friction.
#[test]
fn there_is_one_whirl_between_neighbouring_antiresonances() {
    let (mass, stiffness) = (10.0, 1e5);
    for others in 1..=6 {
        let masses = Masses {
            masses: vec![mass; others + 1],
            grounds: vec![0.0; others + 1],
            joints: vec![stiffness; others],
            decay_rate: 1e-3,
        };
        // The others with the first held still: a row of springs and masses, held at
        // one end and free at the other.
        let antiresonances: Vec<f64> = (1..=others)
            .map(|n| {
                let angle = std::f64::consts::PI * (2.0 * n as f64 - 1.0);
                2.0 * (stiffness / mass).sqrt() * (angle / (4.0 * others as f64 + 2.0)).sin()
            })
            .collect();
        let speed = speed_of(400.0);
        let mut found = masses.on(wall(1e8)).rolling_at(speed);
        found.retain(|whirl| whirl.least_friction < 1.0);
        assert_eq!(found.len(), others + 1, "{found:?}");
        for (index, limit) in antiresonances.iter().enumerate() {
            assert!(found[index].rate < *limit && found[index + 1].rate > *limit);
        }
    }
}

/// What the rates between two samples bring stays within the bounds.
#[test]
fn nothing_varies_faster_than_its_bound() {
    let strategy = (some_masses(), 1.0..400.0f64, 1.0..400.0f64);
    proptest!(ProptestConfig::with_cases(300), |((masses, one, other) in strategy)| {
        let site = masses.on(wall(1e8));
        let variation = Variation::above(&BendingDecay::constant(masses.decay_rate), 1.0);
        let (low, high) = (site.sample(one.min(other)), site.sample(one.max(other)));
        let [least, greatest] = variation.real_range([&low, &high]);
        let places = [low, high].map(|end| (end.rate, end.pressing()));
        let [lax, hard] = variation.pressing_range(places);
        let curvature = variation.curvature([&low, &high]);
        let (width, slack) = (high.rate - low.rate, 1e-7 * low.real.hypot(high.real));
        for step in 0..=64 {
            let sample = site.sample(low.rate + width * f64::from(step) / 64.0);
            prop_assert!((least - slack..=greatest + slack).contains(&sample.real));
            let apart = variation.distance(low.rate, sample.rate);
            let moved = sample.pressing() - low.pressing();
            prop_assert!(moved.abs() <= apart + 1e-7);
            prop_assert!((lax - 1e-7..=hard + 1e-7).contains(&sample.pressing()));
            let h = 1e-3 * sample.rate.min(masses.decay_rate);
            let [before, after] = [-h, h].map(|h| site.sample(sample.rate + h).real);
            let second = (before + after - 2.0 * sample.real) / (h * h);
            let noise = 1e-9 * sample.real.abs() / (h * h);
            prop_assert!(second.abs() <= 1.01 * curvature + noise);
        }
    });
}

/// One to five masses of any proportions.
fn some_masses() -> impl Strategy<Value = Masses> {
    (1..=5usize, -1.0..2.0f64).prop_flat_map(|(count, decay)| {
        let some = |range: std::ops::Range<f64>| {
            prop::collection::vec(range.prop_map(|exponent| 10f64.powf(exponent)), count)
        };
        (some(0.0..2.5), some(2.0..6.0), some(3.0..6.0)).prop_map(
            move |(masses, grounds, joints)| Masses {
                masses,
                grounds,
                joints,
                decay_rate: 10f64.powf(decay),
            },
        )
    })
}

/// A dense scan of the radius, which knows nothing of bounds, finds no whirl that the
/// search has not.
#[test]
fn no_whirl_of_a_dense_scan_is_missed() {
    let strategy = (some_masses(), 20.0..400.0f64, 6.0..10.0f64);
    proptest!(ProptestConfig::with_cases(200), |((masses, fastest, stiffness) in strategy)| {
        let site = masses.on(wall(10f64.powf(stiffness)));
        let speed = speed_of(fastest);
        let found = site.rolling_at(speed);
        let scanned = scan(&site, speed);
        prop_assert_eq!(found.len(), scanned.len(), "{:?} {:?}", found, scanned);
        for (whirl, [near, far]) in found.iter().rev().zip(scanned) {
            prop_assert!((near..=far).contains(&whirl.radius));
        }
    });
}

/// Brackets of the radii at which the wall's answer changes sides, from the clearance
/// outwards.
fn scan(site: &WhirlingSite<impl Fn(f64) -> [f64; 2]>, speed: f64) -> Vec<[f64; 2]> {
    let wall = &site.wall;
    let excess = |radius: f64| {
        let outward = -(site.dynamic_stiffness)(speed * wall.radius / radius)[0] * radius;
        outward - wall.stiffness * (radius - wall.clearance).powf(1.5)
    };
    let radius = |step: u32| wall.clearance * 1e3f64.powf(f64::from(step) / 40_000.0);
    let mut found = Vec::new();
    let mut last = excess(radius(0));
    for step in 1..=40_000 {
        let next = excess(radius(step));
        if (last > 0.0) != (next > 0.0) {
            found.push([radius(step - 1), radius(step)]);
        }
        last = next;
    }
    found
}

/// Every whirl at a speed lies on a branch.
#[test]
fn branches_pass_through_the_whirls_of_each_speed() {
    let strategy = (some_masses(), 0.05..1.0f64);
    proptest!(ProptestConfig::with_cases(100), |((masses, part) in strategy)| {
        let site = masses.on(wall(1e8));
        let speed = speed_of(400.0);
        let branches = site.branches([0.05 * speed, speed]);
        for whirl in site.rolling_at(part * speed) {
            // Where friction is near its most a branch may have ended.
            if whirl.least_friction > 0.5 * MOST_FRICTION {
                continue;
            }
            let on = branches.iter().flat_map(|branch| branch.windows(2)).any(|ends| {
                let part = (whirl.rate - ends[0].rate) / (ends[1].rate - ends[0].rate);
                let between = |of: fn(&SteadyWhirl) -> f64| {
                    of(&ends[0]) + part * (of(&ends[1]) - of(&ends[0]))
                };
                let pressing = |it: &SteadyWhirl| it.least_friction.recip().asinh();
                (0.0..=1.0).contains(&part)
                    && (between(|it| it.surface_speed) / whirl.surface_speed - 1.0).abs() < 0.02
                    && (between(pressing) - pressing(&whirl)).abs() < 0.02
            });
            prop_assert!(on, "{:?}", whirl);
        }
    });
}

/// The least friction of all whirls, rolling or sliding, against a dense scan of the
/// rate.
#[test]
fn no_whirl_needs_less_friction_than_the_least() {
    let strategy = (some_masses(), 20.0..400.0f64);
    proptest!(ProptestConfig::with_cases(100), |((masses, fastest) in strategy)| {
        let site = masses.on(wall(1e8));
        let speed = speed_of(fastest);
        let found = site.least_friction(speed).map_or(MOST_FRICTION, |whirl| whirl.least_friction);
        let mut scanned = MOST_FRICTION;
        for step in 40..=40_000 {
            let rate = fastest * f64::from(step) / 40_000.0;
            let [real, imaginary] = (site.dynamic_stiffness)(rate);
            // Pressed further in than where it rolls, the wall pushes too hard.
            let rolling = speed * site.wall.radius / rate;
            let depth = rolling - site.wall.clearance;
            if real < 0.0 && site.wall.stiffness * depth.powf(1.5) >= -real * rolling {
                scanned = scanned.min(-imaginary / real);
            }
        }
        prop_assert!(found <= 1.02 * scanned, "{found} {scanned}");
    });
}

/// Between two resonances a string may press so little that it rolls at one rate only,
/// with more friction than any wall has: no friction is then the least.
#[test]
fn whirl_that_needs_more_friction_than_any_wall_has_is_left_out() {
    let masses = Masses {
        masses: vec![1.3611630054943462, 7.11179948369521],
        grounds: vec![100.0; 2],
        joints: vec![55_996.662086308934],
        decay_rate: 51.84688600723825,
    };
    let (site, speed) = (masses.on(wall(1e8)), speed_of(223.6958723211913));
    let [rolling] = site.rolling_at(speed)[..] else {
        panic!("one whirl");
    };
    assert!(rolling.least_friction > MOST_FRICTION, "{rolling:?}");
    assert_eq!(site.least_friction(speed), None);
}

/// By how much more forces press than lose: −Re f*Hf over −Im f*Hf.
fn ratio(receptance: &[Complex64], forces: &[Complex64]) -> f64 {
    let rows = receptance.chunks(forces.len());
    let works = rows.zip(forces).map(|(row, force)| {
        let displacement: Complex64 = row.iter().zip(forces).map(|(h, f)| h * f).sum();
        force.conj() * displacement
    });
    let work: Complex64 = works.sum();
    work.re / work.im
}

/// Whether a symmetric matrix is positive definite, by elimination.
fn is_positive(mut matrix: Vec<Vec<f64>>) -> bool {
    let count = matrix.len();
    for pivot in 0..count {
        if matrix[pivot][pivot] <= 0.0 {
            return false;
        }
        for row in pivot + 1..count {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            for column in pivot..count {
                matrix[row][column] -= factor * matrix[pivot][column];
            }
        }
    }
    true
}

/// No forces of any phases press harder than the hardest; and where all masses are sites, what
/// they need is a matter of their stiffness: λ Im K + Re K is positive definite for a λ that is
/// a little greater, and not for one a little less.
#[test]
fn no_forces_press_harder_than_the_hardest() {
    let force = (-1.0..1.0f64, -1.0..1.0f64).prop_map(|(re, im)| Complex64::new(re, im));
    let forces = prop::collection::vec(prop::collection::vec(force, 5), 50);
    let strategy = (some_masses(), 1..=5usize, 1.0..400.0f64, forces);
    proptest!(ProptestConfig::with_cases(300), |((masses, sites, rate, forces) in strategy)| {
        let sites = sites.min(masses.masses.len());
        let receptance = masses.receptance(sites, rate);
        let found = masses.hardest(sites, rate);
        let most = 0.5 * rate / masses.decay_rate;
        prop_assert!(found.ratio() <= most);
        for forces in forces {
            let ratio = ratio(&receptance, &forces[..sites]);
            prop_assert!(ratio <= found.ratio() + 1e-6 * most, "{ratio} {found:?}");
        }
        let whole = masses.stiffnesses(rate);
        let is_enough = |ratio: f64| {
            let entry = |entry: &Complex64| ratio * entry.im + entry.re;
            is_positive(whole.iter().map(|row| row.iter().map(entry).collect()).collect())
        };
        let all = masses.hardest(whole.len(), rate).ratio();
        let off = 1e-6 * all.abs().max(most);
        prop_assert!(is_enough(all + off) && !is_enough(all - off), "{all} {most}");
        // More sites can do what fewer can.
        prop_assert!(found.ratio() <= all + off);
    });
}

/// Equal masses that are free and all touch go round as one, against their damping alone.
#[test]
fn masses_that_all_touch_need_friction_against_their_damping() {
    let masses = Masses {
        masses: vec![3.0; 5],
        grounds: vec![0.0; 5],
        joints: vec![1e4; 5],
        decay_rate: 2.0,
    };
    let found = masses.hardest(5, 30.0);
    assert!((found.ratio() / 7.5 - 1.0).abs() < 1e-9, "{found:?}");
    assert!(
        found
            .shares()
            .iter()
            .all(|share| (share - 0.2).abs() < 1e-6),
        "{found:?}"
    );
    // At each surface speed, c/mω at the fastest rate.
    let whirls = masses
        .all_on(&[wall(1e8); 5])
        .least_friction([0.0, speed_of(30.0)]);
    for whirl in &whirls {
        assert!(
            (whirl.rate * whirl.least_friction / 4.0 - 1.0).abs() < 1e-9,
            "{whirl:?}"
        );
        assert!((speed_of(whirl.rate) / whirl.surface_speed - 1.0).abs() < 1e-9);
    }
    let last = whirls.last().expect("whirl at the fastest rate").rate;
    assert!((29.7..=30.0).contains(&last), "{last}");
}

/// The friction that several sites need, arccot λ, is nowhere nearer to that for damping alone than
/// the bound from two rates next to it.
#[test]
fn the_hardest_is_bounded_between_two_rates() {
    let strategy = (
        some_masses(),
        1..=5usize,
        1.0..400.0f64,
        0.01..3.0f64,
        0.0..1.0f64,
    );
    let near = Cell::new(0);
    proptest!(ProptestConfig::with_cases(500), |(
        (masses, sites, low, apart, part) in strategy,
    )| {
        let sites = sites.min(masses.masses.len());
        let variation = Variation::above(&BendingDecay::constant(masses.decay_rate), 1.0);
        let excess = |rate: f64| {
            let least = (2.0 * masses.decay_rate / rate).atan();
            1.0_f64.atan2(masses.hardest(sites, rate).ratio()) - least
        };
        let high = low + apart * masses.decay_rate;
        let ends = [low, high].map(|rate| (rate, excess(rate)));
        let bound = variation.least_harmonic(ends);
        let found = excess(low + part * (high - low));
        prop_assert!(found >= bound - 1e-9, "{found} {bound}");
        near.set(near.get() + usize::from(found < 1.1 * bound));
    });
    assert!(near.get() > 100, "{near:?}");
}

/// Two resonances are bent midway between them as much as the bound allows, where each is √(5/3) σ
/// away and both far above σ; and no two are more.
#[test]
fn nothing_harmonic_is_bent_more_than_two_resonances() {
    let (variation, half) = (Variation::above(&BendingDecay::constant(1.0), 1.0), 0.05);
    let kernel = |resonance: f64, rate: f64| {
        let place = Complex64::new(1.0, rate).powi(2) + resonance * resonance;
        place.im / place.norm_sqr()
    };
    // The bound over what it bounds.
    let part = |rate: f64, away: f64| {
        let both = |at: f64| kernel(rate - away, at) + kernel(rate + away, at);
        let ends = [-half, half].map(|by| (rate + by, both(rate + by)));
        variation.least_harmonic(ends) / both(rate)
    };
    let strategy = (-1.0..4.0f64, 0.0..5.0f64);
    proptest!(ProptestConfig::with_cases(1000), |((exponent, away) in strategy)| {
        prop_assert!(part(10f64.powf(exponent), away) <= 1.0 + 1e-9);
    });
    let tightest = part(1e4, f64::sqrt(5.0 / 3.0));
    let dip = 1.125 * half * half / 2.0;
    assert!(1.0 - tightest < 0.02 * dip, "{tightest} {dip}");
}

/// The greatest ratio and its forces, against eigenvectors of the losses and of what is pressed
/// for a loss of one: of masses, and of places on the paper's string that are neighbours.
#[test]
fn the_hardest_forces_are_those_of_an_eigendecomposition() {
    let string = problems::academic::string();
    let places: Vec<f64> = (0..40).map(f64::from).collect();
    let bending = problems::academic::BENDING;
    let network = linear::waves::lateral::BendingNetwork::new(
        &string,
        bending,
        linear::SurfaceSupport::Free,
        &linear::Sites::new(&string, &places).unwrap(),
    )
    .unwrap();
    let decay_rate = BendingDecay::new(&string, &bending).least();
    for rate in [0.5, 3.0, 20.0, 60.0, 300.0] {
        let (receptance, most) = (network.at_rate(rate), 0.5 * rate / decay_rate);
        let pencil = Pencil::new(receptance.entries(), most);
        let expected = by_eigenvectors(receptance.entries(), most);
        assert!((pencil.ratio() / expected - 1.0).abs() < 1e-6, "{rate}");
        let shares = pencil.shares();
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9);
        let forces = pencil.forces().expect("they are found");
        let forces: Vec<Complex64> = (0..places.len())
            // In units in which each driving-point receptance is one.
            .map(|site| forces[(site, 0)] / receptance[(site, site)].norm().sqrt())
            .map(Complex64::from)
            .collect();
        let pressed = ratio(receptance.entries(), &forces);
        assert!(
            (pressed / expected - 1.0).abs() < 1e-3,
            "{rate} {pressed} {expected}"
        );
    }
}

/// The greatest ratio by a receptance, with P and Q raised as [`Pencil`] does.
fn by_eigenvectors(receptance: &[Complex64], most: f64) -> f64 {
    let size = receptance.len().isqrt();
    let unit = |site: usize| receptance[site * (size + 1)].norm().sqrt().recip();
    let part = |part: fn(Complex64) -> f64| {
        Mat::from_fn(size, size, |row, column| {
            -part(receptance[row * size + column]) * unit(row) * unit(column)
        })
    };
    let (mut pressing, losing) = (part(|it| it.re), part(|it| it.im));
    let off = 3e-11 * norm(&pressing).hypot(norm(&losing));
    let complex = |real: &Mat<f64>| {
        Mat::from_fn(size, size, |row, column| {
            Complex64::from(real[(row, column)])
        })
    };
    let (losses, directions) = eigenvalues::with_vectors(&complex(&losing)).unwrap();
    let basis = Mat::from_fn(size, size, |row, column| {
        directions[(row, column)] / (losses[column].max(0.0) + off).sqrt()
    });
    for site in 0..size {
        pressing[(site, site)] += (2.0 * most + 1.0) * off;
    }
    let pressed = product_complex(complex(&pressing).as_ref(), basis.as_ref());
    let basis = basis.adjoint().to_owned();
    let ratios = eigenvalues::of_hermitian(&product_complex(basis.as_ref(), pressed.as_ref()));
    ratios.unwrap()[size - 1].min(most)
}

/// The least friction of one site against a rigid wall, by its dynamic stiffness.
#[test]
fn several_sites_of_which_there_is_one_need_what_it_needs() {
    let strategy = (some_masses(), 20.0..400.0f64);
    proptest!(ProptestConfig::with_cases(200), |((masses, fastest) in strategy)| {
        let (wall, speed) = (wall(f64::INFINITY), speed_of(fastest));
        let alone = masses.on(wall).least_friction(speed).map(|whirl| whirl.least_friction);
        let all = masses.all_on(&[wall]).least_friction([speed; 2]);
        let all = all.last().map(|whirl| whirl.least_friction);
        match (alone, all) {
            // Friction below that of any wall is not resolved.
            (Some(alone), Some(all)) => {
                let near = (alone / all - 1.0).abs() < 0.02;
                prop_assert!(near || alone.max(all) < 0.0202, "{alone} {all}");
            }
            // Nearly the most that is looked for.
            (Some(one), None) | (None, Some(one)) => prop_assert!(one > 0.98 * MOST_FRICTION),
            (None, None) => {}
        }
    });
}

/// The least friction of several sites against a dense scan of the rate, at every speed.
#[test]
fn no_rate_needs_less_friction_than_the_least_of_several_sites() {
    let strategy = (some_masses(), 1..=5usize, 20.0..400.0f64);
    proptest!(ProptestConfig::with_cases(40), |((masses, sites, fastest) in strategy)| {
        let sites = sites.min(masses.masses.len());
        let speed = speed_of(fastest);
        let found = masses.all_on(&vec![wall(1e8); sites]).least_friction([0.0, speed]);
        prop_assert!(found.is_sorted_by(|one, other| one.surface_speed < other.surface_speed));
        for step in 1..=4000 {
            let rate = fastest * f64::from(step) / 4000.0;
            let reported = found.iter().rev().find(|whirl| whirl.rate <= rate);
            let reported = reported.map_or(MOST_FRICTION, |whirl| whirl.least_friction);
            let ratio = masses.hardest(sites, rate).ratio();
            prop_assert!(reported < 0.0202 || ratio * reported < 1.0101, "{rate} {ratio} \
                {reported}");
        }
        for whirl in &found {
            let ratio = masses.hardest(sites, whirl.rate).ratio();
            prop_assert!((ratio * whirl.least_friction - 1.0).abs() < 1e-9);
        }
    });
}

/// A whirl that is found does balance: the reported forces cause the reported displacements, and
/// obey the laws of the walls; and it needs no less friction than the bound.
#[test]
fn whirl_that_is_found_together_balances_every_force() {
    let found_with = |masses: &Masses, walls: &[Wall], speed: f64| {
        let sites = masses.all_on(walls);
        let found = sites.least_together(speed)?;
        let touching = |site: usize| found.contacts.iter().find(|contact| contact.site == site);
        let forces: Vec<Complex64> = (0..walls.len())
            .map(|site| {
                touching(site).map_or(Complex64::ZERO, |contact| {
                    let force = contact.normal_force * Complex64::new(-1.0, found.friction);
                    force * Complex64::cis(contact.phase)
                })
            })
            .collect();
        let receptance = masses.receptance(walls.len(), found.rate);
        for (site, row) in receptance.chunks(walls.len()).enumerate() {
            let displacement: Complex64 = row.iter().zip(&forces).map(|(h, f)| h * f).sum();
            let wall = walls[site];
            let Some(contact) = touching(site) else {
                assert!(
                    displacement.norm() <= wall.clearance * (1.0 + 1e-6),
                    "{found:?}"
                );
                continue;
            };
            let reported = Complex64::from_polar(contact.radius, contact.phase);
            assert!(
                (displacement - reported).norm() < 1e-6 * wall.clearance,
                "{found:?}"
            );
            let depth = (contact.normal_force / wall.stiffness).powf(2.0 / 3.0);
            assert!((wall.clearance + depth - contact.radius).abs() < 1e-6 * wall.clearance);
            let excess = speed * wall.radius - found.rate * contact.radius;
            assert!(contact.normal_force > 0.0 && excess > -1e-6 * speed * wall.radius);
        }
        let bound = sites.least_friction([speed; 2]).pop();
        let bound = bound.map_or(MOST_FRICTION, |whirl| whirl.least_friction);
        assert!(
            found.friction >= bound / 1.0101 || found.friction < 0.0202,
            "{bound} {found:?}"
        );
        Some(found)
    };
    let stiffness = prop_oneof![
        Just(f64::INFINITY),
        (6.0..10.0f64).prop_map(|it| 10f64.powf(it))
    ];
    let clearances = prop::collection::vec(0.005..0.02f64, 5);
    let strategy = (
        some_masses(),
        1..=4usize,
        20.0..400.0f64,
        stiffness,
        clearances,
    );
    let [several, rigid] = [0; 2].map(Cell::new);
    let add = |count: &Cell<usize>, one: bool| count.set(count.get() + usize::from(one));
    proptest!(ProptestConfig::with_cases(60), |(
        (mut masses, sites, fastest, stiffness, clearances) in strategy,
    )| {
        let sites = sites.min(masses.masses.len());
        // Nearly free, as a string is, so that they take each other along.
        masses.grounds.fill(100.0);
        let wall = |clearance: &f64| Wall {
            clearance: *clearance,
            ..wall(stiffness)
        };
        let walls: Vec<Wall> = clearances[..sites].iter().map(wall).collect();
        if let Some(found) = found_with(&masses, &walls, speed_of(fastest)) {
            add(&several, found.contacts.len() > 1);
            add(&rigid, stiffness.is_infinite());
        }
    });
    let counts = [several, rigid].map(Cell::into_inner);
    assert!(counts.iter().all(|count| *count > 5), "{counts:?}");
}

/// One site whirls with no less friction than it needs, and nearly with that where resonances
/// are wide.
#[test]
fn one_site_together_with_none_whirls_with_what_it_needs() {
    let near = Cell::new(0);
    let strategy = (some_masses(), 20.0..400.0f64);
    proptest!(ProptestConfig::with_cases(100), |((masses, fastest) in strategy)| {
        let (wall, speed) = (wall(1e8), speed_of(fastest));
        let alone = masses.on(wall).least_friction(speed).map(|whirl| whirl.least_friction);
        let found = masses.all_on(&[wall]).least_together(speed).map(|whirl| whirl.friction);
        if let Some(found) = found {
            let alone = alone.unwrap_or(MOST_FRICTION);
            prop_assert!(found > alone / 1.02, "{alone} {found}");
            near.set(near.get() + usize::from(found < 1.02 * alone));
        }
    });
    assert!(near.get() > 40, "{near:?}");
}

/// What is found of forward whirl in contact balances: the forces of the walls and of the mass bring
/// about the displacements by the stiffness of the masses, and obey their laws; and one site alone
/// is as it is by itself.
#[test]
fn forward_whirl_against_several_walls_balances_every_force() {
    let stiffness = prop_oneof![
        Just(f64::INFINITY),
        (6.0..10.0f64).prop_map(|it| 10f64.powf(it))
    ];
    let parts = prop::collection::vec(0.2..1.5f64, 5);
    let [touching, found, several] = [0; 3].map(Cell::new);
    let add = |count: &Cell<usize>, one: bool| count.set(count.get() + usize::from(one));
    let strategy = (some_masses(), 1.0..60.0f64, stiffness, parts, 0.0..1.0f64);
    proptest!(ProptestConfig::with_cases(300), |(
        (masses, speed, stiffness, parts, friction) in strategy,
    )| {
        let count = masses.masses.len();
        let mass = EccentricMass { site: 0, mass: 0.1 * masses.masses[0], offset: 0.1 };
        // In parts of where its force would take them.
        let force = mass.mass * mass.offset * speed * speed;
        let clearances: Vec<f64> = std::iter::zip(masses.receptance(count, speed), parts)
            .take(count)
            .map(|(receptance, part)| part * receptance.norm() * force)
            .collect();
        let wall = |clearance: &f64| Wall { clearance: *clearance, friction, ..wall(stiffness) };
        let string = EccentricString {
            walls: clearances.iter().map(wall).collect(),
            mass,
            is_carried: false,
            receptance: |rate| masses.receptance(count, rate),
            decay: BendingDecay::constant(masses.decay_rate),
        };
        let free = string.free_radii(speed);
        let is_clear = |radii: &Vec<f64>| radii.iter().zip(&clearances).all(|(r, c)| r < c);
        let whirl = string.in_contact(speed);
        if free.as_ref().is_some_and(is_clear) {
            prop_assert_eq!(whirl, None);
            return Ok(());
        }
        add(&touching, true);
        let Some(whirl) = whirl else {
            return Ok(());
        };
        add(&found, true);
        let displacements: Vec<Complex64> = std::iter::zip(&whirl.radii, &whirl.phases)
            .map(|(radius, phase)| Complex64::from_polar(*radius, *phase))
            .collect();
        let of_mass = string.mass.mass * speed * speed * (0.1 + whirl.radii[0]);
        for (site, row) in masses.stiffnesses(speed).iter().enumerate() {
            let needed: Complex64 = row.iter().zip(&displacements).map(|(k, r)| k * r).sum();
            let (force, phase) = (whirl.normal_forces[site], whirl.phases[site]);
            let by_wall = -force * Complex64::new(1.0, friction) * Complex64::cis(phase);
            let by_mass = if site == 0 { of_mass } else { 0.0 };
            prop_assert!((needed - by_wall - by_mass).norm() < 1e-6 * of_mass, "{:?}", whirl);
            let excess = whirl.radii[site] - clearances[site];
            let depth = (force / stiffness).powf(2.0 / 3.0);
            let rounding = 1e-7 * clearances[site];
            prop_assert!(force >= 0.0 && excess < depth + rounding);
            prop_assert!(force == 0.0 || excess > depth - rounding);
        }
        let in_contact: Vec<usize> =
            (0..count).filter(|site| whirl.normal_forces[*site] > 0.0).collect();
        add(&several, in_contact.len() > 1);
        if let [site] = in_contact[..] {
            let alone = string.in_contact_at(site, speed).expect("it touches");
            let force = whirl.normal_forces[site];
            prop_assert!(alone.normal_force <= force * (1.0 + 1e-6));
        }
    });
    let [touching, found, several] = [touching, found, several].map(Cell::into_inner);
    println!("{touching} touch, {found} found, {several} at several sites");
    assert!(
        10 * found > 9 * touching && several > 20,
        "{touching} {found} {several}"
    );
}
