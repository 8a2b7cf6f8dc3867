//! Loss with a memory as elements have it that are stepped: a dashpot with a spring behind it at a
//! node for each relaxation of the drag of mud, and in every element for each of its material.

use numerics::sparse::Entry;

use super::mesh::Mesh;
use crate::channel::Channel;
use crate::distributed_loss::LossAlong;
use crate::drillstring::Drillstring;
use crate::loss::{Loss, MOST_OF_DRAG, Relaxation};

/// Forces that depend on earlier motion, and fade.
#[derive(Debug, Clone)]
pub(crate) struct Fading {
    /// On speeds, as the drag of mud.
    pub drag: Vec<FadingDrag>,
    /// Of the elastic stiffness.
    pub material: Vec<Relaxation>,
    /// What fades of it, of weight one.
    pub elastic: Vec<Entry>,
}

impl Fading {
    /// Of a string, of which drag at rest is added to the dashpots; `None` where nothing fades.
    pub fn new(
        string: &Drillstring,
        drag: NodalDrag,
        dashpots: &mut [f64],
        elastic: Vec<Entry>,
    ) -> Option<Self> {
        for (dashpot, drag) in dashpots.iter_mut().zip(drag.at_rest) {
            *dashpot += drag;
        }
        let fading = Self {
            drag: drag.fading,
            material: string.loss().relaxations().to_vec(),
            elastic,
        };
        let is_there = !(fading.drag.is_empty() && fading.material.is_empty());
        is_there.then_some(fading)
    }
}

/// One relaxation of drag.
#[derive(Debug, Clone)]
pub(crate) struct FadingDrag {
    /// Rate at which it forgets, 1/s.
    pub rate: f64,
    /// Force per speed of each degree of freedom far above that rate.
    pub dashpots: Vec<f64>,
}

/// The most relaxations of the drag of mud and of the material that a string has.
pub(crate) fn most(loss: &Loss) -> [usize; 2] {
    let drag = loss.viscous_mud().map_or(0, |_| MOST_OF_DRAG);
    [drag, loss.relaxations().len()]
}

/// The drag of mud on the nodes of a mesh.
#[derive(Debug)]
pub(crate) struct NodalDrag {
    /// What it is at rest, a dashpot a degree of freedom.
    pub at_rest: Vec<f64>,
    /// What fades.
    pub fading: Vec<FadingDrag>,
}

impl NodalDrag {
    /// Half of that of each element on either node, of which `place` gives the degree of freedom
    /// of a number of them, if it is free.
    pub fn new(
        string: &Drillstring,
        channel: Channel,
        mesh: &Mesh,
        freedoms: usize,
        place: impl Fn(usize) -> Option<usize>,
    ) -> Self {
        let mut drag = Self {
            at_rest: vec![0.0; freedoms],
            fading: Vec::new(),
        };
        let fitted = LossAlong::fitted(string, channel, mesh.elements_around());
        for (upper, (element, around)) in mesh.elements_around().enumerate() {
            let Some(fit) = fitted.drag_on(element, around.hole_radius) else {
                continue;
            };
            let half = 0.5 * element.length;
            for place in [upper, upper + 1].into_iter().filter_map(&place) {
                drag.at_rest[place] += half * fit.at_rest;
                for relaxation in &fit.relaxations {
                    drag.of_rate(relaxation.rate)[place] += half * relaxation.weight;
                }
            }
        }
        drag
    }

    /// The dashpots that forget at a rate: all fits have theirs of the same few.
    fn of_rate(&mut self, rate: f64) -> &mut [f64] {
        let known = self.fading.iter().position(|it| it.rate == rate);
        let index = known.unwrap_or_else(|| {
            let dashpots = vec![0.0; self.at_rest.len()];
            self.fading.push(FadingDrag { rate, dashpots });
            self.fading.len() - 1
        });
        &mut self.fading[index].dashpots
    }
}

/// One relaxation as the trapezoidal rule steps it.
///
/// A force b s/(s + p) v is b (v − w), w following v at the rate p. With a = hp/2 the rule gives
/// w = y + a v/(1 + a) in each step, where y, which does not depend on that step's v, is carried on
/// by y ← ρ y + 2a v/(1 + a)² with ρ = (1 − a)/(1 + a). The force is b v/(1 + a) − b y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Faded {
    /// The part of the weight that is a force at once, 1/(1 + a).
    pub at_once: f64,
    /// What is kept of y from step to step, ρ.
    pub kept: f64,
    /// What a unit of the motion adds to it.
    pub added: f64,
}

impl Faded {
    /// That of a rate (1/s) in steps of a length (s).
    pub fn new(rate: f64, step: f64) -> Self {
        let half = 0.5 * rate * step;
        let at_once = (1.0 + half).recip();
        Self {
            at_once,
            kept: (1.0 - half) * at_once,
            added: 2.0 * half * at_once * at_once,
        }
    }
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    /// From rest, what is stepped has the generating function of the relaxation at the rate of
    /// the trapezoidal rule.
    #[test]
    fn a_relaxation_that_is_stepped_is_that_of_the_trapezoidal_rule() {
        let (step, zeta) = (0.01, Complex64::from_polar(0.9, 0.7));
        for rate in [0.3, 50.0, 2000.0] {
            let faded = Faded::new(rate, step);
            let (mut carried, mut power, mut found) = (0.0, Complex64::ONE, Complex64::ZERO);
            for index in 0..600 {
                let motion = if index == 0 { 1.0 } else { 0.0 };
                found += power * (faded.at_once * motion - carried);
                carried = faded.kept * carried + faded.added * motion;
                power *= zeta;
            }
            let s = (1.0 - zeta) / (1.0 + zeta) * (2.0 / step);
            let exact = Relaxation { weight: 1.0, rate }.at(s);
            assert!((found - exact).norm() < 1e-12, "{rate}: {found} {exact}");
        }
    }
}
