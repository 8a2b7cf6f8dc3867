//! Torsional waves on a lattice: every piece of string takes the same time to travel,
//! so that a front stays a front and arrives when it does.
//!
//! Torsional waves of an undamped tube keep their shape. A string cut into pieces of one
//! travel time h hands whole waves from node to node: impedance steps scatter them, the
//! damping c_t of each piece is lumped, half at either end, and so is the drag of viscous mud. That is itself a passive
//! string, of the second order in the damping and without error in anything else but
//! the lengths that are no multiples of a piece. What is turned or held constant over
//! times of h leaves speeds that are constant over them, and the delay ζ of one such time
//! takes the place of e^(−sh).
//!
//! Equal cells whose travel time is no multiple of h have two lengths, one piece
//! apart, spread as evenly as can be, so that no place of the string is further off
//! than a piece.
//!
//! ```
//! use linear::waves::lattice::Lattice;
//! use linear::{Complex64, Drillstring, Material, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 9.5, inner_radius: 0.05, outer_radius: 0.06 };
//! let joint = Tube { length: 0.5, inner_radius: 0.05, outer_radius: 0.08 };
//! let section = Section { repeat: 100, parts: vec![pipe, joint] };
//! let string = Drillstring::new(steel, vec![section], 0.0)?;
//! // Lengths of 9.5 m and 0.5 m are whole numbers of pieces: no place is moved.
//! let lattice = Lattice::new(&string, &Sites::bit())?;
//! assert!(lattice.misfit < 1e-9);
//! let piece = lattice.step * string.torsional_wave_speed();
//! assert!((0.5 / piece - (0.5 / piece).round()).abs() < 1e-6);
//! // Where next to nothing changes, ζ ≈ 1, the bit turns as fast as the surface.
//! let slow = lattice.admittance(Complex64::new(1.0 - 1e-8, 0.0));
//! assert!((slow.from_surface[0] - 1.0).norm() < 1e-6);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use std::sync::Arc;

use crate::assembly::chain::{Stiffness, hung};
use crate::assembly::number::Number;
use crate::assembly::torsion::{
    AtSurface, Drive, Driven, DynamicStiffness, TorsionAdmittance, at_surface, late_in_steps,
    reduce, torque_at_surface,
};
use crate::distributed_loss::{Interpolated, LossAlong, LossAt};
use crate::drillstring::{Drillstring, Section, Tube};
use crate::error::DrillstringError;
use crate::estimates::{torsional_impedance, torsional_travel_time};
use crate::sites::Sites;
use crate::spans::SurroundedSpan;
use crate::top_drive::TopDrive;

/// The least number of pieces of a string.
const FEWEST_PIECES: f64 = 1000.0;

/// The same where loss depends on frequency: a front smeared by less than a piece is that of another
/// string. In 1000 pieces the limit of stick-slip of three random uniform strings that lose little is 2, 4
/// and 11 % off, in 4000 that of 8000 to 0.3 %.
const FEWEST_WITH_MEMORY: f64 = 4000.0;

/// The most pieces of a string, unless its damping or its shortest part requires more; and the most
/// for the sake of a part.
const USUAL_PIECES: f64 = 8000.0;
const MOST_PIECES: f64 = 50_000.0;

/// Damping takes at most this part of a wave within a piece.
const LARGEST_LOSS: f64 = 0.01;

/// What a piece costs, as a part of the string's travel time by which lengths fit worse:
/// five thousand more, if they fit better by a ten-thousandth.
const PRICE: f64 = 2e-8;

/// A string as a lattice, from the surface down.
#[derive(Debug, Clone, PartialEq)]
pub struct Lattice {
    /// Travel time h of a piece, s.
    pub step: f64,
    /// By how much the travel times of parts, and those from the surface to the ends of
    /// sections and to sites, are off, all together, s.
    pub misfit: f64,
    /// Cells in a row, of those that are alike one.
    runs: Vec<Run>,
    /// Which of them are between each node and the next.
    spans: Vec<Vec<usize>>,
    sites: usize,
    top_drive: Option<TopDrive>,
    loss: Arc<LossAlong<Interpolated>>,
}

/// Cells in a row.
#[derive(Debug, Clone, PartialEq)]
struct Run {
    cells: usize,
    /// How many of them are one piece longer.
    longer: usize,
    parts: Vec<Part>,
    /// The part that is.
    longest: usize,
}

/// A tube.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Part {
    pieces: usize,
    /// Its length that of all pieces together.
    tube: Tube,
    /// Radius of the hole around it, where mud in it is viscous, m.
    hole: Option<f64>,
    /// Impedance without damping, N m s/rad.
    impedance: f64,
    /// Damping of all pieces together, N m s/rad.
    damping: f64,
}

impl Lattice {
    /// The lattice of a string cut at sites.
    ///
    /// # Errors
    /// Where these are not places of this string.
    pub fn new(string: &Drillstring, sites: &Sites) -> Result<Self, DrillstringError> {
        Self::of_pieces(string, sites, f64::INFINITY)
    }

    /// The lattice of a string cut at sites, of pieces that take no longer than a time to travel, s.
    ///
    /// # Errors
    /// Where these are not places of this string.
    pub fn of_pieces(
        string: &Drillstring,
        sites: &Sites,
        longest_piece: f64,
    ) -> Result<Self, DrillstringError> {
        let spans = string.surrounded_spans(string.channel(), sites)?;
        let loss = Arc::new(LossAlong::exact(string, string.channel(), &spans));
        let travel = torsional_travel_time(string);
        let fewest = match string.loss().has_memory() {
            true => FEWEST_WITH_MEMORY,
            false => FEWEST_PIECES,
        };
        let longest = longest_piece
            .min(travel / fewest)
            .min(longest_damped(string));
        let parts = string.tubes().map(|(_, tube)| tube.length);
        let part = parts.fold(f64::INFINITY, f64::min) / string.torsional_wave_speed();
        let shortest = part.clamp(travel / MOST_PIECES, travel / USUAL_PIECES);
        let shortest = longest.min(shortest);
        let price = |lattice: &Self| lattice.misfit / travel + PRICE * travel / lattice.step;
        let lattices = (steps(string, &spans, [shortest, longest]).into_iter())
            .map(|step| Self::of_steps(string, (&spans, &loss), sites.len(), step));
        let best = lattices.min_by(|one, other| price(one).total_cmp(&price(other)));
        Ok(best.unwrap_or_else(|| Self::of_steps(string, (&spans, &loss), sites.len(), longest)))
    }

    /// Cuts a string into pieces of one travel time, s.
    fn of_steps(
        string: &Drillstring,
        (spans, loss): (&[SurroundedSpan], &Arc<LossAlong<Interpolated>>),
        sites: usize,
        step: f64,
    ) -> Self {
        let mut cutter = Cutter {
            string,
            step,
            place: 0.0,
            pieces: 0,
            misfit: 0.0,
        };
        let mut distinct: Vec<Run> = Vec::new();
        let mut number_of = |run: Run| {
            let known = distinct.iter().position(|other| *other == run);
            known.unwrap_or_else(|| {
                distinct.push(run);
                distinct.len() - 1
            })
        };
        let spans = (spans.iter())
            .map(|span| {
                let runs: Vec<_> = (span.iter())
                    .flat_map(|part| part.runs.iter().map(|run| (part.around.hole_radius, run)))
                    .collect();
                let (before, last) = (cutter.pieces, runs.len().saturating_sub(1));
                let runs = runs.into_iter().enumerate();
                runs.map(|(index, (hole, run))| {
                    let is_all = index == last && cutter.pieces == before;
                    number_of(cutter.cut(run, hole, is_all))
                })
                .collect()
            })
            .collect();
        Self {
            step,
            misfit: cutter.misfit,
            spans,
            runs: distinct,
            sites,
            top_drive: string.top_drive(),
            loss: Arc::clone(loss),
        }
    }

    fn waves<T: Number>(&self, zeta: T) -> Waves<'_, T> {
        Waves::at(zeta, self.step, &self.loss)
    }

    /// The pieces between nodes, torques per speed.
    fn pieces<T: Number>(
        &self,
        waves: &Waves<'_, T>,
    ) -> impl Iterator<Item = Option<DynamicStiffness<T>>> {
        let runs = self.runs.iter().map(|run| run.stiffness(waves));
        let runs: Vec<Option<DynamicStiffness<T>>> = runs.collect();
        self.spans
            .iter()
            .map(move |span| hung(span.iter().filter_map(|run| runs[*run])))
    }

    /// By the trapezoidal rule, which keeps energy as the pieces do.
    fn drive<T: Number>(&self, waves: &Waves<'_, T>, zeta: T) -> Option<Drive<T>> {
        self.top_drive.map(|drive| {
            // Of the drive, which loses nothing to the string's material.
            let rotation = waves.integral * (0.5 * self.step);
            let acceleration = waves.alike * (2.0 / self.step);
            let late = late_in_steps(&drive, zeta, self.step);
            Drive::of(&drive, [acceleration, T::real(1.0), rotation], late)
        })
    }

    /// The response to what is held over each time h, as speeds in them, at the delay ζ
    /// of h, |ζ| < 1.
    pub fn admittance<T: Number>(&self, zeta: T) -> TorsionAdmittance<T> {
        let waves = self.waves(zeta);
        let drive = self.drive(&waves, zeta);
        reduce(self.pieces(&waves), self.sites, T::real(1.0), drive)
    }

    /// Nodes at the delay ζ, which answer one by one as in [`Lattice::admittance`].
    pub(crate) fn driven<T: Number>(&self, zeta: T) -> Driven<T> {
        let waves = self.waves(zeta);
        let drive = self.drive(&waves, zeta);
        Driven::new(self.pieces(&waves), self.sites, T::real(1.0), drive)
    }

    /// How the surface moves below its drive; `None` without one.
    pub(crate) fn at_surface<T: Number>(&self, zeta: T) -> Option<AtSurface<T>> {
        let waves = self.waves(zeta);
        let drive = self.drive(&waves, zeta)?;
        Some(at_surface(
            self.pieces(&waves),
            self.sites,
            T::real(1.0),
            drive,
        ))
    }

    /// Torque with which the surface has to be turned per unit of the speed that it is set to,
    /// no torque acting below, N m s/rad.
    pub fn surface_torque<T: Number>(&self, zeta: T) -> T {
        let waves = self.waves(zeta);
        torque_at_surface(self.pieces(&waves), self.drive(&waves, zeta))
    }
}

/// The longest piece in which no wave loses more than it may, s.
fn longest_damped(string: &Drillstring) -> f64 {
    let rates = string.tubes().map(|(_, tube)| {
        string.torsional_damping()
            / (2.0 * string.material().density * string.section_constant(tube))
    });
    LARGEST_LOSS / rates.fold(0.0, f64::max)
}

/// Lengths of pieces to try, from the longest: those of which some part is a multiple.
fn steps(
    string: &Drillstring,
    spans: &[SurroundedSpan],
    [shortest, longest]: [f64; 2],
) -> Vec<f64> {
    let speed = string.torsional_wave_speed();
    let lengths = |run: &Section| -> Vec<f64> {
        let parts = run.parts.iter().map(|part| part.length);
        parts.chain([run.length()]).collect()
    };
    let mut steps: Vec<f64> = (spans.iter().flatten().flat_map(|part| &part.runs))
        .flat_map(lengths)
        .flat_map(|length| {
            let time = length / speed;
            let fewest = (time / longest * (1.0 - 1e-9)).ceil().max(1.0);
            (0..TRIED).map(move |more| time / (fewest + f64::from(more)))
        })
        .filter(|step| (shortest..=longest * (1.0 + 1e-9)).contains(step))
        .collect();
    steps.sort_by(|one, other| other.total_cmp(one));
    steps.dedup_by(|one, other| (*one / *other - 1.0).abs() < 1e-9);
    let stride = steps.len().div_ceil(MOST_TRIED).max(1);
    steps.into_iter().step_by(stride).collect()
}

/// The numbers of pieces that are tried for each length.
const TRIED: u32 = 64;

/// The most that are tried in all, spread over a string of very many parts.
const MOST_TRIED: usize = 2000;

/// Cuts run after run.
struct Cutter<'a> {
    string: &'a Drillstring,
    /// s.
    step: f64,
    /// Travel time from the surface, s, and in pieces.
    place: f64,
    pieces: usize,
    misfit: f64,
}

impl Cutter<'_> {
    /// The next run; one that is all there is between two nodes has at least a piece.
    fn cut(&mut self, run: &Section, hole: Option<f64>, is_all: bool) -> Run {
        let speed = self.string.torsional_wave_speed();
        let in_pieces = |length: f64| length / speed / self.step;
        let mut parts: Vec<Part> = (run.parts.iter())
            .map(|tube| Part {
                pieces: in_pieces(tube.length).round() as usize,
                tube: *tube,
                hole,
                impedance: torsional_impedance(self.string, tube),
                damping: self.string.torsional_damping() * tube.length,
            })
            .collect();
        let longest = (0..parts.len())
            .max_by(|&one, &other| run.parts[one].length.total_cmp(&run.parts[other].length))
            .unwrap_or(0);
        let mut others = 0;
        for (index, (part, tube)) in parts.iter().zip(&run.parts).enumerate() {
            if index != longest {
                others += part.pieces;
                let misfit = (part.pieces as f64 - in_pieces(tube.length)).abs();
                self.misfit += run.repeat as f64 * misfit * self.step;
            }
        }
        self.place += run.length() / speed;
        let end = (self.place / self.step).round() as usize;
        let least = usize::from(is_all);
        let left = end
            .saturating_sub(self.pieces + run.repeat * others)
            .max(least);
        parts[longest].pieces = left / run.repeat;
        self.pieces += run.repeat * others + left;
        self.misfit += (self.pieces as f64 * self.step - self.place).abs();
        let (mut cells, longer) = (run.repeat, left % run.repeat);
        if longer > 0 {
            // Within, places are off by up to a piece, to either side.
            self.misfit += 0.5 * self.step;
        }
        if let ([part], 0) = (&mut parts[..], longer) {
            // Equal cells of one tube are one of a longer tube.
            part.pieces = left;
            part.damping *= cells as f64;
            part.tube.length *= cells as f64;
            cells = 1;
        }
        Run {
            cells,
            longer,
            parts,
            longest,
        }
    }
}

/// What a piece of unit impedance without damping takes at one delay ζ.
struct Waves<'a, T> {
    /// Where both ends turn alike, (1 − ζ)/(1 + ζ).
    alike: T,
    /// (1 + ζ)/(1 − ζ).
    integral: T,
    /// Where they turn against one another, the same, in a material with loss m times that.
    opposite: T,
    /// By the trapezoidal rule in steps of a piece, which keeps what is passive so.
    loss: LossAt<'a, T>,
}

impl<'a, T: Number> Waves<'a, T> {
    /// At ζ, where pieces take the time `step` (s).
    fn at(zeta: T, step: f64, loss: &'a LossAlong<Interpolated>) -> Self {
        let (sum, difference) = (zeta + 1.0, -zeta + 1.0);
        let alike = difference * sum.inverse();
        let integral = sum * difference.inverse();
        let loss = loss.at(|| alike * (2.0 / step));
        Self {
            alike,
            integral,
            opposite: match loss.stiffening() {
                None => integral,
                Some(stiffening) => integral * stiffening,
            },
            loss,
        }
    }
}

impl Run {
    fn stiffness<T: Number>(&self, waves: &Waves<'_, T>) -> Option<DynamicStiffness<T>> {
        T::wide(
            #[inline(always)]
            || self.stiffness_of(waves),
        )
    }

    #[inline(always)]
    fn stiffness_of<T: Number>(&self, waves: &Waves<'_, T>) -> Option<DynamicStiffness<T>> {
        let plain = self.cell(0, waves);
        if self.longer == 0 {
            return plain.map(|cell| cell.repeated(self.cells));
        }
        let longer = self.cell(1, waves)?;
        Some(match plain {
            // Cells without a piece are no longer than rounding.
            None => longer.repeated(self.longer),
            Some(plain) => evenly((plain, self.cells - self.longer), (longer, self.longer)),
        })
    }

    /// A cell with `more` further pieces; `None` where it has no pieces.
    #[inline(always)]
    fn cell<T: Number>(&self, more: usize, waves: &Waves<'_, T>) -> Option<DynamicStiffness<T>> {
        let pieces_of = |(index, part): (usize, &'_ Part)| match index == self.longest {
            true => part.pieces + more,
            false => part.pieces,
        };
        let parts = self.parts.iter().enumerate();
        let mut parts = parts.map(|it| (it.1, pieces_of(it))).filter(|it| it.1 > 0);
        let (uppermost, pieces) = parts.next()?;
        let mut cell = uppermost.stiffness(pieces, waves);
        for (part, pieces) in parts {
            cell = cell.join(&part.stiffness(pieces, waves));
        }
        Some(cell)
    }
}

impl Part {
    /// Torques per speed of a number of pieces in a row. A piece has Z(1 + ζ²)/(1 − ζ²) +
    /// D/2 at either end and −2Zζ/(1 − ζ²) across.
    #[inline(always)]
    fn stiffness<T: Number>(&self, pieces: usize, waves: &Waves<'_, T>) -> DynamicStiffness<T> {
        let dashpot = 0.5 * self.damping / pieces as f64;
        let mut alike = waves.alike * self.impedance + dashpot;
        let mut opposite = waves.opposite * self.impedance + dashpot;
        if let Some(mud) = waves.loss.drag_on(&self.tube, self.hole) {
            let mud = mud * (0.5 * self.tube.length / pieces as f64);
            (alike, opposite) = (alike + mud, opposite + mud);
        }
        DynamicStiffness::row(alike, opposite, pieces)
    }
}

/// Two kinds of cells in a row, each in its number, spread as evenly as can be: by
/// Euclid's algorithm, whose groups become the cells of the next step. The one that is
/// rarer is in the middle of its group, so that places are off to either side alike.
#[inline(always)]
fn evenly<S: Stiffness>((mut many, mut count): (S, usize), (mut few, mut others): (S, usize)) -> S {
    while others > 0 {
        if count < others {
            (many, few) = (few, many);
            (count, others) = (others, count);
        }
        let each = count / others;
        let group = match each / 2 {
            0 => many.join(&few),
            half => {
                let below = many.repeated(half);
                let is_odd = each % 2 == 1;
                let above = if is_odd { many.join(&below) } else { below };
                above.join(&few).join(&below)
            }
        };
        (many, few) = (group, many);
        (count, others) = (others, count % others);
    }
    many.repeated(count)
}
