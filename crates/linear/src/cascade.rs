//! The string as pieces in a row between nodes at which torques act, for scenes with many of
//! these, such as friction all along the string.
//!
//! Responses between all nodes grow with the square of their number, and each lasts as long as
//! the string rings. What a single piece does lasts only as long as a wave takes through it:
//! here are the taps of the waves that it reflects and transmits ([`Link`]), and the stepper passes
//! the waves from piece to piece. Where loss has a memory, what it remembers lasts longer, up to the
//! end of a case. By `quadrature`, and by `finite-element`, which replace the
//! Laplace variable by a function of the shift in time, joining pieces and making taps may change
//! places: the motion is that of the responses of the whole string, up to rounding and what decayed
//! taps are cut off.
//!
//! With the torque f that a port of a piece is met with, its speed v and the piece's reference
//! impedance Z, the wave a = (f + Z v)/2 goes in and b = (Z v − f)/2 comes out. (A. Fettweis,
//! "Wave digital filters: theory and practice", *Proceedings of the IEEE* 74, 1986, 270–327.)
//!
//! A wave passes a uniform piece whole, and takes the travel time for it:
//!
//! ```
//! use linear::{Cascade, Drillstring, Material, Method, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 100, parts: vec![pipe] }], 0.0)?;
//! let nodes = Sites::new(&string, &[400.0, 0.0])?;
//! let cascade = Cascade::new(&string, &Method::Quadrature, &nodes, 200.0, 10.0)?;
//! let across = &cascade.links[0].across;
//! let passed: f64 = across.iter().sum();
//! let steps: f64 = across.iter().enumerate().map(|(step, tap)| step as f64 * tap).sum();
//! assert!((passed - 1.0).abs() < 1e-6);
//! assert!((steps / 200.0 - 400.0 / string.torsional_wave_speed()).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::assembly::lanes::Lanes;
use crate::assembly::nodes::{Relation, StiffnessBetween as _};
use crate::assembly::number::Number;
use crate::assembly::scattering::{Scattered, Uppermost, reflection, uppermost};
use crate::assembly::torsion::{Drive, DynamicStiffness};
use crate::assembly::working_bytes;
use crate::budget::{Budget, Need, OutOfBudget, REAL, What};
use crate::drillstring::{Drillstring, Section};
use crate::elements::newmark::Weights;
use crate::elements::recurrence::ElementChain;
use crate::error::BuildError;
use crate::estimates::torsional_impedance;
use crate::filters::ResponseAt;
use crate::filters::quadrature::{Formula, Sampling, buffers, series};
use crate::method::Method;
use crate::responses::length::{MOST_TAPS, needed_taps, too_many, transformable};
use crate::sites::Sites;
use crate::spans::Span;
use crate::waves::network::TorsionNetwork;

/// Taps after which a response is no greater than this part of its largest are cut off: what
/// rounding leaves of them is a few times less.
const NEGLIGIBLE: f64 = 1e-10;

/// A response has decayed if this last part of what was computed is negligible.
const QUIET_PART: f64 = 0.25;

/// Taps beyond the passage of a wave that are computed at first.
const FIRST_BEYOND: f64 = 48.0;

/// A string in pieces, ready to be stepped.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Cascade {
    /// The nodes, from the surface down.
    pub nodes: Sites,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// The longest time that may be simulated with it, s.
    pub longest_time: f64,
    /// Whether its loss has a memory: then responses last about as long as a case.
    pub loss_has_memory: bool,
    /// From the surface to the uppermost node.
    pub top: Top,
    /// Between each node and the next.
    pub links: Vec<Link>,
    /// What hangs below the lowest node, where that is not the bit.
    pub end: Option<End>,
}

/// Taps of the string from the surface, or its drive, to the uppermost node.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Top {
    /// Reference impedance Z, N m s/rad.
    pub impedance: f64,
    /// The wave that comes back, per wave that goes up.
    pub reflection: Vec<f64>,
    /// The wave that comes down per speed that the surface is set to, N m s/rad.
    pub sent: Vec<f64>,
    /// Torque with which the surface is turned, below a top drive that of its motor, per set
    /// speed, N m s/rad.
    pub torque_by_set: Vec<f64>,
    /// The same per wave that goes up.
    pub torque_by_wave: Vec<f64>,
    /// Below a drive, the speed of the surface per set speed, and per wave that goes up,
    /// rad/s per N m; without one it turns as it is set to.
    pub speed: Option<[Vec<f64>; 2]>,
}

/// Taps of a piece between two nodes.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Link {
    /// Reference impedance Z, N m s/rad.
    pub impedance: f64,
    /// The wave that comes back at the top.
    pub top: Vec<f64>,
    /// The wave that comes out at the other end.
    pub across: Vec<f64>,
    /// The wave that comes back at the bottom.
    pub bottom: Vec<f64>,
}

/// Taps of what hangs below the lowest node.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct End {
    /// Reference impedance Z, N m s/rad.
    pub impedance: f64,
    /// The wave that comes back.
    pub reflection: Vec<f64>,
}

/// Without loss that remembers, the waves of a string take at most this many times as long to fade as is
/// tried first: up to 37 times on random strings in cases of a minute.
const LASTS: f64 = 64.0;

/// What elements send back and forth among themselves, too fast for the waves of the string, takes at most
/// this many times as long to fade as their stiffest shapes do: coarse elements lose less.
const RINGS: f64 = 8.0;

/// Taps of all responses together that are planned for anyhow, if a case lasts so long: a string in few
/// pieces, of different pipes, rings within a piece for longer.
const LITTLE: f64 = 1e6;

/// Responses of the uppermost piece.
const AT_TOP: usize = 6;

/// Responses of a link.
const AT_LINK: usize = 3;

impl Cascade {
    /// Cuts a string at its nodes, however much memory that takes ([`CascadePlan`] asks for it).
    ///
    /// # Errors
    /// As [`CascadePlan::new`] and [`CascadePlan::build`].
    pub fn new(
        string: &Drillstring,
        method: &Method,
        nodes: &Sites,
        sampling_frequency: f64,
        longest_time: f64,
    ) -> Result<Self, BuildError> {
        CascadePlan::new(string, method, nodes, sampling_frequency, longest_time)?
            .build(&Budget::unlimited())
    }

    /// Taps of the longest response.
    pub fn longest_response(&self) -> usize {
        let links = self.links.iter();
        let of_links = links.flat_map(|link| [&link.top, &link.across, &link.bottom]);
        let top = &self.top;
        let of_top = [
            &top.reflection,
            &top.sent,
            &top.torque_by_set,
            &top.torque_by_wave,
        ];
        let of_ends = self.end.iter().map(|end| &end.reflection);
        let all = (of_links.chain(of_top))
            .chain(top.speed.iter().flatten())
            .chain(of_ends);
        all.map(Vec::len).max().unwrap_or(0)
    }
}

/// A string in pieces before it is cut.
#[derive(Debug)]
pub struct CascadePlan<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    nodes: &'a Sites,
    sampling_frequency: f64,
    longest_time: f64,
    pieces: Pieces,
    lengths: Lengths,
}

impl<'a> CascadePlan<'a> {
    /// Of a string that is cut at nodes.
    ///
    /// # Errors
    /// Where pieces cannot be stepped one by one by this method, these are not places of
    /// the string, or responses would be too long.
    pub fn new(
        string: &'a Drillstring,
        method: &'a Method,
        nodes: &'a Sites,
        sampling_frequency: f64,
        longest_time: f64,
    ) -> Result<Self, BuildError> {
        let rings = match method {
            Method::Quadrature => 0.0,
            Method::FiniteElement(parameters) => {
                let weights = Weights::new(parameters, sampling_frequency)?;
                RINGS * NEGLIGIBLE.ln().abs() / weights.loss_of_the_stiffest()
            }
            _ => {
                let method = method.name();
                return Err(BuildError::NotInPieces { method });
            }
        };
        let first = first_taps(string, nodes, sampling_frequency);
        let most = needed_taps(longest_time, sampling_frequency);
        let pieces = Pieces {
            impedances: (string.spans(nodes)?.iter())
                .map(|span| impedance(string, span))
                .collect(),
            has_drive: string.top_drive().is_some(),
            loss_has_memory: string.loss().has_memory(),
            nodes: nodes.len(),
        };
        let channels = pieces.scales().len();
        // What mud and material remember fades far more slowly than echoes do.
        let longest = match pieces.loss_has_memory {
            true => most,
            false => most.min((LASTS * first + rings).max(LITTLE / channels as f64)),
        };
        if longest > MOST_TAPS as f64 {
            return Err(too_many(longest));
        }
        Ok(Self {
            string,
            method,
            nodes,
            sampling_frequency,
            longest_time,
            lengths: Lengths {
                first: first.min(most),
                most,
                longest: transformable(longest.ceil() as usize),
                channels,
                on_thread: working_bytes::<Lanes>(nodes.len(), 1),
            },
            pieces,
        })
    }

    /// Taps of each response, at most.
    pub fn taps(&self) -> usize {
        self.lengths.longest
    }

    /// What cutting takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(self.lengths.need_of(self.lengths.longest), What::Pieces)
    }

    /// Cuts the string.
    ///
    /// # Errors
    /// Where a parameter is out of range, responses are not finite or too long, or they ask for
    /// more memory than is left.
    pub fn build(&self, budget: &Budget) -> Result<Cascade, BuildError> {
        let (string, nodes, pieces) = (self.string, self.nodes, &self.pieces);
        let frequency = self.sampling_frequency;
        let scales = pieces.scales();
        let taps = if let Method::FiniteElement(parameters) = self.method {
            let weights = Weights::new(parameters, frequency)?;
            let chain = ElementChain::new(
                string,
                string.channel(),
                nodes,
                parameters.elements_per_cell,
                weights,
            )?;
            let response = |zeta: Lanes, waves: &mut [Lanes]| {
                let (rows, drive) = chain.rows_and_drive(zeta);
                pieces.write(rows, drive, Lanes::real(1.0), waves);
            };
            self.lengths.taps(&scales, budget, &response)?
        } else {
            let network = TorsionNetwork::new(string, nodes)?;
            let response = |zeta: Lanes, waves: &mut [Lanes]| {
                let s = Formula::BackwardDifferences.generating_function(zeta) * frequency;
                pieces.write(network.pieces(s), network.drive(s), s, waves);
            };
            self.lengths.taps(&scales, budget, &response)?
        };
        if !taps.iter().flatten().all(|tap| tap.is_finite()) {
            let method = self.method.name();
            return Err(BuildError::NotFinite { method });
        }
        Ok(pieces.cascade(taps, nodes, frequency, self.longest_time))
    }
}

/// What is known of the pieces before their taps.
#[derive(Debug)]
struct Pieces {
    /// Reference impedances, N m s/rad.
    impedances: Vec<f64>,
    has_drive: bool,
    loss_has_memory: bool,
    nodes: usize,
}

impl Pieces {
    /// What each response of all pieces is of the size of, at least: waves that a matched piece
    /// does not send back are nothing but rounding.
    fn scales(&self) -> Vec<f64> {
        let top = self.impedances[0];
        let mut scales = vec![1.0; AT_TOP + self.impedances.len() - self.nodes];
        scales[1..3].fill(top);
        scales[5] = 1.0 / top;
        scales.extend([1.0; AT_LINK].repeat(self.nodes - 1));
        scales
    }

    /// Writes the waves of all pieces, whose torques are per motion.
    fn write(
        &self,
        pieces: impl Iterator<Item = Option<DynamicStiffness<Lanes>>>,
        drive: Option<Drive<Lanes>>,
        rate: Lanes,
        waves: &mut [Lanes],
    ) {
        let per_rate = rate.inverse();
        let drive = drive.map(|drive| Drive {
            holds: drive.holds * per_rate,
            opposes: drive.opposes * per_rate,
            motor: drive.motor * per_rate,
        });
        let (at_top, mut waves) = waves.split_at_mut(AT_TOP);
        for (index, (piece, &impedance)) in pieces.zip(&self.impedances).enumerate() {
            // Nodes are apart: there is a piece between any two.
            let Some(piece) = piece.map(|piece| piece.per_speed(rate)) else {
                continue;
            };
            if index == 0 {
                let Uppermost {
                    reflection,
                    sent,
                    torque_by_set,
                    torque_by_wave,
                    speed_by_set,
                    speed_by_wave,
                } = uppermost(piece, drive, impedance);
                at_top.copy_from_slice(&[
                    reflection,
                    sent,
                    torque_by_set,
                    torque_by_wave,
                    speed_by_set,
                    speed_by_wave,
                ]);
            } else if index < self.nodes {
                let Scattered {
                    top,
                    across,
                    bottom,
                } = piece.scattered(impedance);
                let (of_link, rest) = waves.split_at_mut(AT_LINK);
                of_link.copy_from_slice(&[top, across, bottom]);
                waves = rest;
            } else {
                waves[0] = reflection(piece.above(Lanes::zero()), impedance);
            }
        }
    }

    /// Everything with its taps.
    fn cascade(
        &self,
        taps: Vec<Vec<f64>>,
        nodes: &Sites,
        sampling_frequency: f64,
        longest_time: f64,
    ) -> Cascade {
        let mut taps = taps.into_iter();
        let mut next = || taps.next().unwrap_or_default();
        let top = Top {
            impedance: self.impedances[0],
            reflection: next(),
            sent: next(),
            torque_by_set: next(),
            torque_by_wave: next(),
            speed: Some([next(), next()]).filter(|_| self.has_drive),
        };
        let links = (1..self.nodes).map(|index| Link {
            impedance: self.impedances[index],
            top: next(),
            across: next(),
            bottom: next(),
        });
        let links = links.collect();
        Cascade {
            nodes: nodes.clone(),
            sampling_frequency,
            longest_time,
            loss_has_memory: self.loss_has_memory,
            top,
            links,
            end: (self.impedances.get(self.nodes)).map(|&impedance| End {
                impedance,
                reflection: next(),
            }),
        }
    }
}

/// The mean impedance along a span: waves are answered within it the least.
fn impedance(string: &Drillstring, span: &Span) -> f64 {
    let tubes = || {
        let parts = |run: &Section| {
            run.parts
                .iter()
                .map(|part| (run.repeat as f64, *part))
                .collect::<Vec<_>>()
        };
        span.runs.iter().flat_map(parts)
    };
    let length: f64 = tubes().map(|(count, tube)| count * tube.length).sum();
    let sum: f64 = tubes()
        .map(|(count, tube)| count * tube.length * torsional_impedance(string, &tube))
        .sum();
    sum / length
}

/// Taps in which a wave passes twice through the longest piece, and some.
fn first_taps(string: &Drillstring, nodes: &Sites, sampling_frequency: f64) -> f64 {
    let from_bit = nodes.distances_from_bit();
    let ends = std::iter::once(string.length())
        .chain(from_bit.iter().copied())
        .chain(std::iter::once(0.0));
    let places: Vec<f64> = ends.collect();
    let longest =
        (places.windows(2)).fold(0.0, |longest: f64, ends| longest.max(ends[0] - ends[1]));
    2.0 * longest / string.torsional_wave_speed() * sampling_frequency + FIRST_BEYOND
}

/// How many taps are built.
#[derive(Debug)]
struct Lengths {
    first: f64,
    /// Nothing looks further.
    most: f64,
    /// They last no longer.
    longest: usize,
    /// Responses that are made side by side.
    channels: usize,
    /// Bytes on each thread while they are sampled.
    on_thread: f64,
}

impl Lengths {
    /// What a number of taps of each response takes.
    fn need_of(&self, taps: usize) -> Need {
        buffers(taps, self.channels, Sampling::Close).need(self.on_thread)
    }

    /// Taps until they have decayed, or nothing looks at them.
    fn taps(
        &self,
        scales: &[f64],
        budget: &Budget,
        response: &ResponseAt<'_>,
    ) -> Result<Vec<Vec<f64>>, BuildError> {
        let mut length = self.first;
        loop {
            if length > MOST_TAPS as f64 {
                return Err(too_many(length));
            }
            let count = transformable(length.ceil() as usize);
            let working = budget.begin(self.need_of(count), What::Pieces)?;
            let mut taps = series(count, scales.len(), Sampling::Close, response);
            let lengths: Vec<usize> = std::iter::zip(&taps, scales)
                .map(|(taps, &scale)| decayed(taps, scale))
                .collect();
            let most = lengths.iter().copied().max().unwrap_or(0);
            if most as f64 <= (1.0 - QUIET_PART) * count as f64 || length >= self.most {
                let kept: usize = lengths.iter().sum();
                for (taps, length) in taps.iter_mut().zip(lengths) {
                    taps.truncate(length);
                    taps.shrink_to_fit();
                }
                working.kept(REAL * kept as f64).keep();
                return Ok(taps);
            }
            length = (2.0 * length).min(self.most);
        }
    }
}

/// Taps before all that are negligible to a response at least of a size.
fn decayed(taps: &[f64], scale: f64) -> usize {
    let largest = taps
        .iter()
        .fold(scale, |largest, tap| largest.max(tap.abs()));
    let is_felt = |tap: &f64| tap.abs() > NEGLIGIBLE * largest;
    taps.iter().rposition(is_felt).map_or(1, |last| last + 1)
}
