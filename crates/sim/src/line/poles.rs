//! Poles that all sites share, stepped: what loads so far left in them is all that is remembered.
//!
//! Sums have one order, and do not depend on how many numbers a processor adds at once: over sites for a pole, over poles for a site.

use linear::budget::REAL;
use linear::{BendingPoles, Complex64};
use pulp::{Arch, Simd, WithSimd};

/// Rows have a multiple of this many numbers, which is [`AT_ONCE`] of what any processor adds at once.
const LANES: usize = 8;

/// Vectors of a row that are done together, so that none waits for its own sum.
const AT_ONCE: usize = 2;

/// What is left of a pole below this is left out, m: numbers that fade for ever become slow to add.
const NOTHING: f64 = 1e-150;

/// Two coordinates, as cases share them of poles: real and imaginary part of one that has a conjugate, or
/// two real ones.
#[derive(Debug, Clone)]
pub(crate) struct Poles {
    sites: usize,
    /// Pairs of coordinates, with some that nothing moves at the end.
    pairs: usize,
    /// What each of a pair keeps of itself in a step, and what the second takes of the first: the first
    /// gives that up.
    kept: [Vec<f64>; 2],
    taken: Vec<f64>,
    /// Displacement of a site by each, `[pair][site]`.
    shapes: [Vec<f64>; 2],
    /// What a load at a site adds to each, `[site][pair]`.
    inputs: [Vec<f64>; 2],
    arch: Arch,
}

/// The loads of a case so far, in a number of planes.
#[derive(Debug)]
pub(crate) struct PolesPast<'a, const PLANES: usize> {
    poles: &'a Poles,
    /// Of each plane, both coordinates of all pairs.
    states: [[Vec<f64>; 2]; PLANES],
    /// Displacements in the present step, of each plane.
    sums: [Vec<f64>; PLANES],
    /// Of each plane and site, all steps.
    loads: Vec<Vec<f64>>,
    /// The sites with a load in the step before.
    acting: Vec<usize>,
    /// Whether there was no load yet.
    is_quiet: bool,
}

/// A coordinate: what it keeps of itself in a step, and of each site its shape and what it is given.
struct Coordinate<'a> {
    kept: f64,
    shapes: Box<dyn Fn(usize) -> f64 + 'a>,
    inputs: Box<dyn Fn(usize) -> f64 + 'a>,
}

impl<'a> Coordinate<'a> {
    /// A part of a pole: what moves by a pole is the real part of its product with a shape.
    fn of(poles: &'a BendingPoles, pole: usize, part: fn(Complex64) -> f64, sign: f64) -> Self {
        Self {
            kept: poles.turns()[pole].re,
            shapes: Box::new(move |site| sign * part(poles.shapes(site)[pole])),
            inputs: Box::new(move |site| part(poles.inputs(site)[pole])),
        }
    }
}

impl Poles {
    pub(crate) fn new(poles: &BendingPoles) -> Self {
        let turns = poles.turns();
        let (real, complex): (Vec<usize>, Vec<usize>) =
            (0..turns.len()).partition(|pole| turns[*pole].im == 0.0);
        let first = |pole: usize| Some(Coordinate::of(poles, pole, |it| it.re, 1.0));
        let of_complex = complex.iter().map(|&pole| {
            let second = Some(Coordinate::of(poles, pole, |it| it.im, -1.0));
            (first(pole), second, turns[pole].im)
        });
        let of_real = real.chunks(2).map(|pair| {
            let second = pair.get(1).copied();
            (first(pair[0]), second.and_then(first), 0.0)
        });
        let mut found = Self::empty(poles.sites(), complex.len() + real.len().div_ceil(2));
        let row = found.shapes[0].len() / found.pairs;
        for (pair, (one, other, taken)) in of_complex.chain(of_real).enumerate() {
            found.taken[pair] = taken;
            for (part, coordinate) in [one, other].into_iter().enumerate() {
                let Some(coordinate) = coordinate else {
                    continue;
                };
                found.kept[part][pair] = coordinate.kept;
                for site in 0..found.sites {
                    found.shapes[part][pair * row + site] = (coordinate.shapes)(site);
                    found.inputs[part][site * found.pairs + pair] = (coordinate.inputs)(site);
                }
            }
        }
        found
    }

    /// Pairs that nothing moves.
    fn empty(sites: usize, pairs: usize) -> Self {
        let pairs = pairs.next_multiple_of(LANES);
        let zeros = |count: usize| [vec![0.0; count], vec![0.0; count]];
        Self {
            sites,
            pairs,
            kept: zeros(pairs),
            taken: vec![0.0; pairs],
            shapes: zeros(pairs * sites.next_multiple_of(LANES)),
            inputs: zeros(pairs * sites),
            arch: Arch::new(),
        }
    }

    /// Bytes of a number of poles of a number of sites.
    pub(crate) fn bytes(sites: usize, poles: f64) -> f64 {
        2.0 * REAL * (poles + LANES as f64) * ((2 * sites + LANES) as f64 + 1.5)
    }

    /// Bytes of the motion of a case in two planes, without its loads.
    pub(crate) fn motion_bytes(sites: usize, poles: f64) -> f64 {
        2.0 * REAL * (2.0 * poles + (sites + 3 * LANES) as f64)
    }

    /// The empty past of a case of at most `steps` steps.
    pub(crate) fn past<const PLANES: usize>(&self, steps: usize) -> PolesPast<'_, PLANES> {
        let state = || vec![0.0; self.pairs];
        PolesPast {
            poles: self,
            states: std::array::from_fn(|_| [state(), state()]),
            sums: std::array::from_fn(|_| vec![0.0; self.sites.next_multiple_of(LANES)]),
            loads: vec![Vec::with_capacity(steps); PLANES * self.sites],
            acting: Vec::with_capacity(self.sites),
            is_quiet: true,
        }
    }
}

impl<const PLANES: usize> PolesPast<'_, PLANES> {
    pub(crate) fn write_past(&self, sums: &mut [f64]) {
        let planes = sums.chunks_exact_mut(self.poles.sites);
        for (sums, found) in planes.zip(&self.sums) {
            sums.copy_from_slice(&found[..self.poles.sites]);
        }
    }

    pub(crate) fn loads(&self, plane: usize, site: usize) -> &[f64] {
        &self.loads[plane * self.poles.sites + site]
    }

    pub(crate) fn add(&mut self, loads: &[f64]) {
        for (past, load) in self.loads.iter_mut().zip(loads) {
            past.push(*load);
        }
        let sites = self.poles.sites;
        let acts = |site: &usize| (0..PLANES).any(|plane| loads[plane * sites + site] != 0.0);
        self.acting.clear();
        self.acting.extend((0..sites).filter(acts));
        self.is_quiet &= self.acting.is_empty();
        if !self.is_quiet {
            self.poles.arch.dispatch(Step { past: self, loads });
        }
    }
}

/// Turns the poles by a step with its loads, and finds what they make of the next.
struct Step<'a, 'b, const PLANES: usize> {
    past: &'a mut PolesPast<'b, PLANES>,
    loads: &'a [f64],
}

impl<const PLANES: usize> WithSimd for Step<'_, '_, PLANES> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        self.turn(simd);
        self.displace(simd);
    }
}

impl<const PLANES: usize> Step<'_, '_, PLANES> {
    #[inline(always)]
    fn turn<S: Simd>(&mut self, simd: S) {
        let past = &mut *self.past;
        let poles = past.poles;
        let vectors = |numbers| S::as_simd_f64s(numbers).0;
        let [one_kept, other_kept] = [0, 1].map(|part: usize| vectors(&poles.kept[part]));
        let taken = vectors(&poles.taken);
        let inputs = [0, 1].map(|part: usize| vectors(&poles.inputs[part]));
        let row = one_kept.len();
        for first in (0..row).step_by(AT_ONCE) {
            let mut added = [[[simd.splat_f64s(0.0); AT_ONCE]; 2]; PLANES];
            for &site in &past.acting {
                let input = inputs.map(|inputs| &inputs[site * row + first..][..AT_ONCE]);
                for (plane, added) in added.iter_mut().enumerate() {
                    let load = simd.splat_f64s(self.loads[plane * poles.sites + site]);
                    for (added, input) in added.iter_mut().zip(input) {
                        for at in 0..AT_ONCE {
                            added[at] = simd.add_f64s(added[at], simd.mul_f64s(input[at], load));
                        }
                    }
                }
            }
            for (state, added) in past.states.iter_mut().zip(added) {
                let [one, other] = state;
                let one = &mut S::as_mut_simd_f64s(one).0[first..][..AT_ONCE];
                let other = &mut S::as_mut_simd_f64s(other).0[first..][..AT_ONCE];
                for at in 0..AT_ONCE {
                    let (a, b, turn) = (one[at], other[at], taken[first + at]);
                    let here = simd.mul_f64s(a, one_kept[first + at]);
                    let there = simd.mul_f64s(b, other_kept[first + at]);
                    let here = simd.sub_f64s(here, simd.mul_f64s(b, turn));
                    let there = simd.add_f64s(there, simd.mul_f64s(a, turn));
                    one[at] = noticed(simd, simd.add_f64s(here, added[0][at]));
                    other[at] = noticed(simd, simd.add_f64s(there, added[1][at]));
                }
            }
        }
    }

    #[inline(always)]
    fn displace<S: Simd>(&mut self, simd: S) {
        let past = &mut *self.past;
        let poles = past.poles;
        let shapes = [0, 1].map(|part: usize| S::as_simd_f64s(&poles.shapes[part]).0);
        let row = shapes[0].len() / poles.pairs;
        for first in (0..row).step_by(AT_ONCE) {
            let mut sums = [[simd.splat_f64s(0.0); AT_ONCE]; PLANES];
            for pair in 0..poles.pairs {
                let [one, other] = shapes.map(|shapes| &shapes[pair * row + first..][..AT_ONCE]);
                for (sum, state) in sums.iter_mut().zip(&past.states) {
                    let [a, b] = [0, 1].map(|part: usize| simd.splat_f64s(state[part][pair]));
                    for at in 0..AT_ONCE {
                        let here = simd.mul_f64s(one[at], a);
                        let moved = simd.add_f64s(here, simd.mul_f64s(other[at], b));
                        sum[at] = simd.add_f64s(sum[at], moved);
                    }
                }
            }
            for (found, sums) in past.sums.iter_mut().zip(sums) {
                S::as_mut_simd_f64s(found).0[first..][..AT_ONCE].copy_from_slice(&sums);
            }
        }
    }
}

/// Numbers, without those that are next to none.
#[inline(always)]
fn noticed<S: Simd>(simd: S, numbers: S::f64s) -> S::f64s {
    let is_none = simd.less_than_f64s(simd.abs_f64s(numbers), simd.splat_f64s(NOTHING));
    simd.select_f64s(is_none, simd.splat_f64s(0.0), numbers)
}
