//! A simulator before it is prepared: what all cases share of it, and what a case takes while it
//! is stepped. Both are asked for before they are taken ([`linear::budget`]).
//!
//! Of `responses` as in the example of the crate:
//!
//! ```
//! # use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//! # let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! # let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! # let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! # let request = Request {
//! #     sites: Sites::bit(),
//! #     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//! #     sampling_frequency: 640.0,
//! #     longest_time: 20.0,
//! # };
//! # let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! use linear::Budget;
//! use sim::SimulatorPlan;
//!
//! let plan = SimulatorPlan::of_responses(&responses);
//! let budget = Budget::unlimited();
//! plan.ask(&budget)?;
//! // The taps themselves, cut into blocks and transformed, are most of it.
//! let of_taps = 8.0 * responses.at_bit().unwrap_or_default().len() as f64;
//! assert!(budget.need().peak > of_taps);
//! assert!(plan.ask(&Budget::new(0.5 * budget.need().peak)).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use linear::budget::{Budget, Need, OutOfBudget, REAL, What};
use linear::{ChannelResponses, Method, PolePlan, Responses, SteppedPlan};

use crate::laws::cutting::{CutStep, Face, MOST_PROFILES};
use crate::limited_drive::LimitedDrive;
use crate::line::pieces::{Pieces, Sums};
use crate::line::poles::Poles;
use crate::line::{Bending, Torsion};
use crate::shortcuts::BitAlone;
use crate::surface::SurfaceResponse;
use crate::trajectory::Trajectory;
use crate::watch::swing::SwingWatch;
use crate::watch::torsion::BitWatch;

/// A simulator for cases of a number of steps at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimulatorPlan {
    line: Line,
    /// Sites that bend, and by what.
    bending: Option<(usize, Bends)>,
    /// Taps of axial motion, where the bit cuts.
    axial: Option<usize>,
    /// Whether its responses are known to be the same in both directions.
    is_reciprocal: bool,
    /// Whether it lies in its hole.
    lies: bool,
    /// Taps at the surface, where the torque of its drive is limited.
    limited: Option<usize>,
    steps: f64,
}

/// What torsion is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Line {
    /// Responses of a number of taps at a number of sites, to torques on some.
    Taps {
        sites: usize,
        loads: usize,
        taps: usize,
    },
    /// Elements that are stepped, with walls at all sites, whose responses to the surface have a
    /// number of taps.
    Mesh {
        sites: usize,
        taps: usize,
        mesh: f64,
        motion: f64,
    },
    /// Pieces between a number of nodes, of responses of a number of taps.
    Pieces {
        nodes: usize,
        taps: usize,
        sums: Sums,
    },
}

/// What sites bend by.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Bends {
    /// Responses of a number of taps.
    Taps(usize),
    /// A number of poles at most.
    Poles(f64),
}

/// Inputs and taps of a channel.
fn size_of(channel: Option<&ChannelResponses>) -> (usize, usize) {
    channel.map_or((0, 0), |channel| (channel.loads.len(), channel.taps()))
}

/// Steps of a case of a given duration (s).
pub fn steps(duration: f64, sampling_frequency: f64) -> f64 {
    (duration * sampling_frequency).ceil() + 1.0
}

impl SimulatorPlan {
    /// By responses of a number of taps at a number of sites, to torques on a number of these
    /// ([`crate::Simulator::started`]).
    pub fn by_responses(sites: usize, loads: usize, taps: usize, steps: f64) -> Self {
        let line = Line::Taps { sites, loads, taps };
        Self::of(line, steps)
    }

    /// That of responses that are there.
    pub fn of_responses(responses: &Responses) -> Self {
        let steps = steps(responses.longest_time, responses.sampling_frequency);
        let (loads, taps) = size_of(responses.torsion());
        let plan = Self {
            axial: responses.axial().map(ChannelResponses::taps),
            ..Self::by_responses(responses.sites.len(), loads, taps, steps)
        }
        .by_method(&responses.method);
        match responses.bending() {
            None => plan,
            bending => {
                let (sites, taps) = size_of(bending);
                plan.bending_by(sites, taps)
            }
        }
    }

    /// By elements with walls at a number of sites, whose responses to the surface have a number of
    /// taps ([`crate::Simulator::stepped`]).
    pub fn by_elements(plan: &SteppedPlan, sites: usize, taps: usize, steps: f64) -> Self {
        let line = Line::Mesh {
            sites,
            taps,
            mesh: plan.kept_bytes(),
            motion: plan.motion_bytes(),
        };
        Self::of(line, steps)
    }

    /// Of a string in pieces between a number of nodes, whose loss has a memory or not, by responses
    /// of a number of taps ([`crate::Simulator::in_pieces`]).
    pub fn in_pieces(nodes: usize, taps: usize, loss_has_memory: bool, steps: f64) -> Self {
        let sums = Sums::of(loss_has_memory);
        Self::of(Line::Pieces { nodes, taps, sums }, steps)
    }

    fn of(line: Line, steps: f64) -> Self {
        Self {
            line,
            bending: None,
            axial: None,
            is_reciprocal: false,
            lies: false,
            limited: None,
            steps,
        }
    }

    /// The same, which bends at a number of sites by responses of a number of taps.
    #[must_use]
    pub fn bending_by(self, sites: usize, taps: usize) -> Self {
        Self {
            bending: Some((sites, Bends::Taps(taps))),
            ..self
        }
    }

    /// The same, which bends at the sites of poles ([`crate::Simulator::bending_by_poles`]).
    #[must_use]
    pub fn bending_by_poles(self, sites: usize, plan: &PolePlan) -> Self {
        Self {
            bending: Some((sites, Bends::Poles(plan.most_poles()))),
            ..self
        }
    }

    /// The same, whose bit moves along its axis by responses of a number of taps.
    #[must_use]
    pub fn moving_along_by(self, taps: usize) -> Self {
        Self {
            axial: Some(taps),
            ..self
        }
    }

    /// The same of responses by a method: by most there are half as many where they are the same in
    /// both directions.
    #[must_use]
    pub fn by_method(self, method: &Method) -> Self {
        Self {
            is_reciprocal: method.is_reciprocal(),
            ..self
        }
    }

    /// The same, which lies in its hole or does not.
    #[must_use]
    pub fn lying(self, lies: bool) -> Self {
        Self { lies, ..self }
    }

    /// The same below a drive whose torque is limited, by responses of a number of taps at the
    /// surface.
    #[must_use]
    pub fn below_limited(self, taps: usize) -> Self {
        Self {
            limited: Some(taps),
            ..self
        }
    }

    /// What preparing it takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(self.need(), What::Simulator)
    }

    fn need(&self) -> Need {
        let bending = self.bending.map_or(0.0, |(sites, by)| match by {
            Bends::Taps(taps) => Bending::bytes_of_taps(sites, taps, self.is_reciprocal),
            Bends::Poles(poles) => Bending::bytes_of_poles(sites, poles),
        });
        let line = match self.line {
            Line::Taps { sites, loads, taps } => {
                let others = REAL * (sites.saturating_sub(loads) * taps) as f64;
                sites as f64 * SurfaceResponse::bytes(taps)
                    + Torsion::bytes_of_taps(loads, taps, self.is_reciprocal)
                    + if loads > 0 { others } else { 0.0 }
            }
            Line::Mesh {
                sites, taps, mesh, ..
            } => {
                mesh + sites as f64 * SurfaceResponse::bytes(taps)
                    + Torsion::instant_bytes(sites)
                    + Bending::instant_bytes(sites)
            }
            Line::Pieces { nodes, taps, sums } => Pieces::bytes(nodes, taps, self.steps, sums),
        };
        let along = self
            .axial
            .map(|taps| Torsion::bytes_of_taps(1, taps, true) + SurfaceResponse::bytes(taps));
        let alone = self.alone().map(|taps| BitAlone::need(taps, self.steps));
        let limited = (self.limited).map_or(0.0, |taps| LimitedDrive::bytes(self.ports(), taps));
        Need::lasting(line + bending + along.unwrap_or(0.0) + limited)
            .then(alone.unwrap_or_default())
    }

    /// Places at which torques may act.
    fn ports(&self) -> usize {
        match self.line {
            Line::Taps { loads, .. } => loads,
            Line::Mesh { sites, .. } => sites,
            Line::Pieces { nodes, .. } => nodes,
        }
    }

    /// Taps of the bit, where nothing acts but the torque on it.
    fn alone(&self) -> Option<usize> {
        match self.line {
            _ if self.bending.is_some() || self.axial.is_some() || self.limited.is_some() => None,
            Line::Taps { loads: 1, taps, .. } => Some(taps),
            _ => None,
        }
    }

    /// Bytes that a case takes, stepped to its end.
    pub fn case_bytes(&self) -> f64 {
        let steps = self.steps;
        let line = match self.line {
            Line::Taps { loads, taps, .. } => {
                // Which port feels which within a step, thrice.
                let shares = 3.0 * Torsion::instant_bytes(loads);
                Torsion::past_bytes(loads.max(1), taps, steps) + shares
            }
            Line::Mesh { sites, motion, .. } => {
                let loads = Torsion::load_bytes(sites, steps) + Bending::load_bytes(sites, steps);
                motion + loads + 2.0 * Torsion::instant_bytes(sites)
            }
            Line::Pieces { nodes, taps, sums } => Pieces::past_bytes(nodes, taps, steps, sums),
        };
        let bending = self.bending.map(|(sites, by)| match by {
            Bends::Taps(taps) => Bending::past_bytes(sites, taps, steps),
            Bends::Poles(poles) => {
                Bending::load_bytes(sites, steps) + Poles::motion_bytes(sites, poles)
            }
        });
        let along = self
            .axial
            .map(|taps| Torsion::past_bytes(1, taps, steps) + Face::bytes(MOST_PROFILES, steps));
        let alone = self.alone().map(BitAlone::case_bytes);
        let walls = match (self.line, self.bending) {
            (Line::Mesh { sites, .. }, _) | (_, Some((sites, _))) => sites,
            _ => 0,
        };
        let swings = match self.lies {
            true => SwingWatch::bytes(walls),
            false => 0.0,
        };
        let limited = self.limited.map_or(0.0, |taps| {
            LimitedDrive::case_bytes(self.ports(), taps, steps)
        });
        swings
            + limited
            + line
            + along.unwrap_or(0.0)
            + bending.unwrap_or(0.0)
            + alone.unwrap_or(0.0)
            + BitWatch::bytes(steps)
    }

    /// Bytes of the motion of a case at a number of sites.
    pub fn recorded_bytes(&self, sites: usize) -> f64 {
        let is_lateral = self.bending.is_some() || matches!(self.line, Line::Mesh { .. });
        let cut = self
            .axial
            .map_or(0.0, |_| std::mem::size_of::<CutStep>() as f64);
        Trajectory::bytes(sites, is_lateral, self.steps) + cut * self.steps
    }
}
