//! Answers from closed forms and from formulations the library does not use.

use linear::Complex64;
use linear::{Drillstring, Tube};

/// Bit speed of a uniform undamped string, its surface turning at `surface(t)`,
/// its bit free (d'Alembert).
pub fn free_bit_speed(time: f64, travel_time: f64, surface: impl Fn(f64) -> f64) -> f64 {
    let mut speed = 0.0;
    let mut sign = 2.0;
    let mut arrival = travel_time;
    while arrival < time {
        speed += sign * surface(time - arrival);
        sign = -sign;
        arrival += 2.0 * travel_time;
    }
    speed
}

/// A matrix of two rows of two.
pub type TwoByTwo = [[Complex64; 2]; 2];

/// The product of two of them.
pub fn times(one: &TwoByTwo, other: &TwoByTwo) -> TwoByTwo {
    one.map(|[left, right]| {
        std::array::from_fn(|column| left * other[0][column] + right * other[1][column])
    })
}

/// Transfer matrix of (rotation, internal torque) across one tube, from Eq. 3
/// with hyperbolic functions as they stand.
pub fn transfer_matrix(string: &Drillstring, tube: &Tube, s: Complex64) -> TwoByTwo {
    let material = string.material();
    let rigidity = material.shear_modulus * tube.polar_moment();
    let inertia = material.density * tube.polar_moment();
    let gamma = (s * (string.torsional_damping() + s * inertia) / rigidity).sqrt();
    let x = gamma * tube.length;
    [
        [x.cosh(), x.sinh() / (gamma * rigidity)],
        [x.sinh() * gamma * rigidity, x.cosh()],
    ]
}

/// Torque on a bit that swings by itself under the string's surface, up to a positive factor:
/// zero where it is a mode. An entire function of s, by transfer matrices one after another.
pub fn free_torque(string: &Drillstring, s: Complex64) -> Complex64 {
    let (mut rotation, mut torque) = match string.top_drive() {
        None => (Complex64::ZERO, Complex64::ONE),
        Some(drive) => (Complex64::ONE, s * drive.impedance(s)),
    };
    for section in string.sections() {
        let tubes = section.parts.iter();
        let tubes: Vec<_> = tubes.map(|tube| transfer_matrix(string, tube, s)).collect();
        for _ in 0..section.repeat {
            for m in &tubes {
                (rotation, torque) = (
                    m[0][0] * rotation + m[0][1] * torque,
                    m[1][0] * rotation + m[1][1] * torque,
                );
                let size = (rotation * torque).norm().sqrt();
                if size > 1e100 {
                    (rotation, torque) = (rotation / size, torque / size);
                }
            }
        }
    }
    torque
}

/// How far a function's argument turns between two points, radians, along the straight line.
pub fn turned(function: &impl Fn(Complex64) -> Complex64, from: Complex64, to: Complex64) -> f64 {
    const PIECES: usize = 1000;
    const SMALL: f64 = 0.3;
    let point = |index: usize| from + (to - from) * (index as f64 / PIECES as f64);
    let mut turned = 0.0;
    for index in 0..PIECES {
        let (near, far) = (point(index), point(index + 1));
        let turn = (function(far) / function(near)).arg();
        let halfway = (function((near + far) / 2.0) / function(near)).arg();
        turned += if turn.abs() < SMALL && halfway.abs() < SMALL {
            turn
        } else {
            self::turned(function, near, far)
        };
    }
    turned
}

/// Dynamic stiffness (top, cross, bottom) from a transfer matrix: rotations to
/// external torques −T at the top, +T at the bottom.
pub fn stiffness_of_transfer(m: &TwoByTwo) -> [Complex64; 3] {
    let flexibility = m[0][1].inv();
    [m[0][0] * flexibility, -flexibility, m[1][1] * flexibility]
}

/// The paper's chain of `count` cells by eigenvectors (Eqs. 6–10), with the
/// growing wave scaled at its far end.
pub fn eigenvector_chain(cell: &TwoByTwo, count: usize) -> [Complex64; 3] {
    let trace = cell[0][0] + cell[1][1];
    let determinant = cell[0][0] * cell[1][1] - cell[0][1] * cell[1][0];
    let root = (trace * trace / 4.0 - determinant).sqrt();
    let candidates = [trace / 2.0 + root, trace / 2.0 - root];
    let growing = if candidates[0].norm() >= candidates[1].norm() {
        0
    } else {
        1
    };
    let large = candidates[growing];
    let small = determinant / large;
    let vector = |lambda: Complex64| [cell[0][1], lambda - cell[0][0]];
    let (p, q) = (vector(large), vector(small));
    let scaled = large.powi(-(count as i32));
    let far = small.powi(count as i32);
    // Rotations at both ends and torques at both ends, Eq. 8 times Eq. 10.
    let rotations = [[p[0] * scaled, q[0]], [p[0], q[0] * far]];
    let torques = [[p[1] * scaled, q[1]], [p[1], q[1] * far]];
    let determinant = rotations[0][0] * rotations[1][1] - rotations[0][1] * rotations[1][0];
    let inverse = [
        [
            rotations[1][1] / determinant,
            -rotations[0][1] / determinant,
        ],
        [
            -rotations[1][0] / determinant,
            rotations[0][0] / determinant,
        ],
    ];
    let relation = times(&torques, &inverse);
    [-relation[0][0], -relation[0][1], relation[1][1]]
}

/// Fails unless one number is another, to a part of it.
#[track_caller]
pub fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found / expected - 1.0).abs() <= tolerance,
        "found {found}, expected {expected} to {tolerance}"
    );
}

/// Largest |a − b| over the largest |b|.
pub fn relative_difference(a: &[f64], b: &[f64]) -> f64 {
    let scale = b.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let difference = a
        .iter()
        .zip(b)
        .fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
    difference / scale
}

/// Response to an input sequence: Σ taps(k − n) input(n).
pub fn convolve(taps: &[f64], input: &[f64]) -> Vec<f64> {
    (0..input.len())
        .map(|step| {
            let reach = taps.len().min(step + 1);
            (0..reach).map(|lag| taps[lag] * input[step - lag]).sum()
        })
        .collect()
}
