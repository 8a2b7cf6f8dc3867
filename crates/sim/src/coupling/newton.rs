//! Newton's method on the loads of all ports that bear one or may: where each would be if the
//! others bore theirs follows from the first taps, and what its laws then answer is
//! differentiated numerically. Between sticking and sliding, touching and not, the answer has
//! kinks; a step that leaves the ports further apart is shortened, or not taken.

use numerics::{Mat, equations};

use super::loads::Load;
use super::ports::{Coupling, Free, Solved, Unloaded};
use crate::line::Torsion;

/// The components of a load: two of force, and torque.
const COMPONENTS: usize = 3;

/// Answers are differentiated over this part of the largest load.
const DIFFERENCE: f64 = 1e-6;

/// A step is halved so often before it is not taken.
const HALVINGS: usize = 6;

/// Components of a load.
type Components = [f64; COMPONENTS];

fn components(load: Load) -> Components {
    [load.force[0], load.force[1], load.torque]
}

fn load_of([x, y, torque]: Components) -> Load {
    Load {
        force: [x, y],
        torque,
    }
}

fn difference(one: Components, other: Components) -> Components {
    std::array::from_fn(|component| one[component] - other[component])
}

/// A step on the loads of a coupling, after which all ports have to be solved again; none where
/// it does not bring them closer. Gives whether it did. A port without an answer is left to the turn
/// that follows.
pub(super) fn step<E>(
    coupling: &mut Coupling,
    torsion: &Torsion,
    free: Free,
    solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
) -> bool {
    let open = |port: &usize| coupling.pending[*port] > coupling.slack[*port];
    let bears = |port: &usize| coupling.loads[*port] != Load::default();
    let ports: Vec<usize> = (0..coupling.pending.len())
        .filter(|port| open(port) || bears(port))
        .collect();
    coupling.pending.fill(f64::INFINITY);
    let before: Vec<Components> = (ports.iter())
        .map(|&port| components(coupling.loads[port]))
        .collect();
    let Some(scales) = scales(&before) else {
        return false;
    };
    let Some((answers, slopes)) = differentiate(coupling, torsion, (&ports, scales), free, solve)
    else {
        return false;
    };
    let misses: Vec<Components> = (answers.iter().zip(&before))
        .map(|(answer, load)| difference(*answer, *load))
        .collect();
    let change = newton_change(coupling, torsion, &ports, (&slopes, &misses));
    let least = size(&misses, scales);
    for halvings in 0..HALVINGS {
        let part = 0.5f64.powi(halvings as i32);
        for ((&port, before), change) in ports.iter().zip(&before).zip(&change) {
            let load = std::array::from_fn(|it| before[it] + part * change[it]);
            coupling.set_load(port, load_of(load));
        }
        let misses = ports.iter().map(|&port| {
            let answer = solve(port, coupling.unloaded(port, free)).ok()?;
            Some(difference(
                components(answer.load),
                components(coupling.loads[port]),
            ))
        });
        let misses: Option<Vec<Components>> = misses.collect();
        if misses.is_some_and(|misses| size(&misses, scales) < least) {
            return true;
        }
    }
    for (&port, before) in ports.iter().zip(before) {
        coupling.set_load(port, load_of(before));
    }
    false
}

/// The largest force and the largest torque; none where nothing acts.
fn scales(loads: &[Components]) -> Option<[f64; 2]> {
    let force = loads.iter().map(|[x, y, _]| x.hypot(*y));
    let force = force.fold(0.0, f64::max);
    let torque = loads.iter().map(|load| load[2].abs()).fold(0.0, f64::max);
    let is_there = force > 0.0 || torque > 0.0;
    // Where only one of both acts, a unit of the other stands for it.
    let or_unit = |scale: f64| if scale > 0.0 { scale } else { 1.0 };
    is_there.then(|| [force, torque].map(or_unit))
}

/// How far loads are from what the laws answer them, in parts of the largest.
fn size(misses: &[Components], [force, torque]: [f64; 2]) -> f64 {
    let of_port = |[x, y, miss]: &Components| (x.hypot(*y) / force).max(miss.abs() / torque);
    // No number is no small miss.
    let sizes = misses.iter().map(of_port);
    sizes.fold(0.0, |most, size| {
        if size > most || size.is_nan() {
            size
        } else {
            most
        }
    })
}

/// What the laws of each port answer, and by how much more to a unit of displacement along x
/// and y, and of speed, `[component][input]`.
fn differentiate<E>(
    coupling: &Coupling,
    torsion: &Torsion,
    (ports, [force, torque]): (&[usize], [f64; 2]),
    free: Free,
    solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
) -> Option<(Vec<Components>, Vec<[Components; COMPONENTS]>)> {
    let mut slopes = Vec::with_capacity(ports.len());
    let mut answers = Vec::with_capacity(ports.len());
    for &port in ports {
        let at = coupling.unloaded(port, free);
        let mut answer = |at| Some(components(solve(port, at).ok()?.load));
        let here = answer(at)?;
        let moved = DIFFERENCE * force * coupling.bends(port, port);
        let turned = DIFFERENCE * torque * torsion.instant(port, port);
        let mut by_input = [[0.0; COMPONENTS]; COMPONENTS];
        for (input, by_input) in by_input.iter_mut().enumerate() {
            let (mut there, step) = (at, if input < 2 { moved } else { turned });
            if step == 0.0 {
                // It does not bend.
                continue;
            }
            match input {
                2 => there.speed += step,
                axis => there.position[axis] += step,
            }
            *by_input = difference(answer(there)?, here).map(|change| change / step);
        }
        slopes.push(std::array::from_fn(|component| {
            by_input.map(|input| input[component])
        }));
        answers.push(here);
    }
    Some((answers, slopes))
}

/// The change of all loads after which the laws would answer them, were they straight.
fn newton_change(
    coupling: &Coupling,
    torsion: &Torsion,
    ports: &[usize],
    (slopes, misses): (&[[Components; COMPONENTS]], &[Components]),
) -> Vec<Components> {
    let size = COMPONENTS * ports.len();
    let compliance = |output: usize, input: usize, component: usize| match component {
        2 => torsion.instant(output, input),
        _ => coupling.bends(output, input),
    };
    let matrix = Mat::from_fn(size, size, |row, column| {
        let (here, component) = (row / COMPONENTS, row % COMPONENTS);
        let (there, input) = (column / COMPONENTS, column % COMPONENTS);
        let own = if row == column { 1.0 } else { 0.0 };
        let felt = match here == there {
            true => 0.0,
            false => compliance(ports[here], ports[there], input),
        };
        own - slopes[here][component][input] * felt
    });
    let right = Mat::from_fn(size, 1, |row, _| misses[row / COMPONENTS][row % COMPONENTS]);
    let change = equations::solve(&matrix, &right);
    let of_port = |port: usize| std::array::from_fn(|it| change[(COMPONENTS * port + it, 0)]);
    (0..ports.len()).map(of_port).collect()
}
