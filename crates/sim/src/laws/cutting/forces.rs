//! A step of a bit that cuts: the speeds that meet both load lines.

use super::advance::{self, Advance, AxialLine, Grip};
use super::face::{Face, MOST_PROFILES, Piece};
use super::step::{BitPlace, CutStep};
use crate::laws::torque::LoadLine;

/// The law with its constants at hand.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CuttingForces {
    /// k_t, N m/m.
    pub(super) torque: f64,
    /// β, m.
    pub(super) flat_radius: f64,
    /// λ, m/rad.
    pub(super) relief: f64,
    pub(super) grip: Grip,
    /// Angle from a blade to the one before, rad: of each, or the one of all.
    pub(super) angles: Vec<f64>,
}

/// Steps of a solver, far more than it takes.
const MOST_STEPS: usize = 160;

/// A speed is found where it leaves no more than this of the free speed: on a straight piece of the
/// law one step of Newton's method leaves a tenth of it, by rounding.
const FOUND: f64 = 1e-13;

/// A law is met where it leaves no more than this of the free speed.
const MET: f64 = 1e-12;

/// What is left of a speed is rounding, in parts of the free speed.
const ROUNDING: f64 = 4e-15;

/// What the law answers to a rotation speed.
#[derive(Debug, Clone, Copy)]
struct Trial {
    speed: f64,
    /// r(ω) = ω_h − A_t T(ω) − ω, and its slope.
    residual: f64,
    slope: f64,
    torque: f64,
    advance: Advance,
}

impl Trial {
    /// What the bit then does, from where it stands.
    fn step(self, place: &BitPlace, axial: &AxialLine) -> CutStep {
        let Advance {
            rate,
            weight,
            depth_of_cut,
            deepest_cut,
            touches,
            ..
        } = self.advance;
        CutStep {
            speed: self.speed,
            rate,
            torque: self.torque,
            weight,
            depth_of_cut,
            deepest_cut,
            touches,
            angle: place.angle + axial.within * self.speed,
            depth: place.depth + axial.within * rate,
        }
    }
}

impl CuttingForces {
    /// Meets both load lines of a step.
    pub(crate) fn meet(
        &self,
        place: &BitPlace,
        face: &Face,
        line: LoadLine,
        axial: &AxialLine,
    ) -> CutStep {
        // Even blades would gain a sixth, but where they chatter rounding decides labels that users
        // compare.
        let drills_on = match self.angles.len() {
            1 => None,
            _ => self.drill_on(place, face, line, axial),
        };
        drills_on.unwrap_or_else(|| self.search(place, face, line, axial))
    }

    /// The step of a bit that does anything.
    pub(super) fn search(
        &self,
        place: &BitPlace,
        face: &Face,
        line: LoadLine,
        axial: &AxialLine,
    ) -> CutStep {
        let at = |speed: f64| self.try_speed(speed, place, face, line, axial);
        let in_step = |trial: Trial| trial.step(place, axial);
        let stuck = |held: Trial| CutStep {
            speed: 0.0,
            torque: line.free_speed / line.compliance,
            ..in_step(held)
        };
        // Where flats land all at once, or a blade meets the ledge at the end of its own cut, torque
        // jumps: what it is follows from the load line.
        let step = |trial: Trial| {
            let is_met = trial.residual.abs() <= MET * line.free_speed.abs();
            let torque = match is_met {
                true => trial.torque,
                false => (line.free_speed - trial.speed) / line.compliance,
            };
            CutStep {
                torque,
                ..in_step(trial)
            }
        };
        if line.free_speed <= 0.0 {
            // Rock keeps a bit from turning back; in the air it does.
            let held = at(0.0);
            return match held.advance.touches {
                true => stuck(held),
                false => CutStep {
                    speed: line.free_speed,
                    torque: 0.0,
                    ..in_step(at(line.free_speed))
                },
            };
        }
        let is_steep = self.may_be_steep(place, face, line, axial);
        let found = match is_steep && place.speed > 0.0 {
            true => (self.fastest(place, face, (line, axial), &at)).unwrap_or_else(|| at(0.0)),
            false => {
                let guess = place.speed.clamp(0.0, line.free_speed);
                let [standing, free] = [0.0, line.free_speed].map(End::untried);
                solve([standing, free], guess, at)
            }
        };
        match found.speed > 0.0 {
            true => step(found),
            false => stuck(found),
        }
    }

    /// The step of a bit that drills on: all blades cut straight pieces of rock, and their flats carry
    /// all they can, from the beginning of the step to where the law is met. Torque and weight are
    /// straight in both speeds then. `None` where it is otherwise.
    pub(super) fn drill_on(
        &self,
        place: &BitPlace,
        face: &Face,
        line: LoadLine,
        axial: &AxialLine,
    ) -> Option<CutStep> {
        if line.free_speed <= 0.0 || self.may_be_steep(place, face, line, axial) {
            return None;
        }
        let (grip, within) = (&self.grip, axial.within);
        let share = 1.0 / self.angles.len() as f64;
        // At the speed of the step before.
        let angle = place.angle + within * place.speed;
        let mut several = [Piece::default(); MOST_PROFILES];
        let pieces = &mut several[..self.angles.len()];
        let (mut rock, mut rise) = (0.0, 0.0);
        let [mut first, mut last] = [f64::NEG_INFINITY, f64::INFINITY];
        for (blade, piece) in pieces.iter_mut().enumerate() {
            *piece = face.piece_ahead(blade, angle)?;
            rock += share * piece.depth;
            rise += share * piece.rise;
            first = first.max(piece.angles[0]);
            last = last.min(piece.angles[1]);
        }
        // Part of a depth that is left of it as the string yields.
        let stays = 1.0 / (1.0 + axial.compliance * grip.weight * within);
        let sunk_in = within * (axial.free_speed - axial.compliance * grip.most);
        let cut = stays * (place.depth - rock + sunk_in);
        let torque_at = |cut: f64| self.torque * cut + self.flat_radius * grip.most;
        let missing = line.free_speed - line.compliance * torque_at(cut) - place.speed;
        let faster = missing / (1.0 - line.compliance * self.torque * stays * rise * within);

        let turned = within * faster;
        let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
        for piece in &*pieces {
            let rock = piece.depth + piece.rise * turned;
            (highest, lowest) = (highest.max(rock), lowest.min(rock));
        }
        let (speed, angle) = (place.speed + faster, angle + turned);
        let cut = cut - stays * rise * turned;
        let weight = grip.weight * cut + grip.most;
        let rate = axial.free_speed - axial.compliance * weight;
        let depth = place.depth + within * rate;
        let is_drilling = first < angle
            && angle <= last
            && speed > 0.0
            && (0.0..=self.relief * speed).contains(&rate)
            && place.depth - highest >= grip.most / grip.growth;
        is_drilling.then(|| CutStep {
            speed,
            rate,
            torque: torque_at(cut),
            weight,
            depth_of_cut: cut,
            deepest_cut: depth - lowest,
            touches: true,
            angle,
            depth,
        })
    }

    /// Whether the torque may fall with speed as steeply as the load line, as the rock before the bit
    /// rises, which relief bounds: then more than one speed may meet both.
    fn may_be_steep(
        &self,
        place: &BitPlace,
        face: &Face,
        line: LoadLine,
        axial: &AxialLine,
    ) -> bool {
        let growth = Some(self.grip.growth).filter(|growth| growth.is_finite());
        let per_depth = self.torque + self.flat_radius * growth.unwrap_or(0.0);
        let per_rise = line.compliance * per_depth * axial.within;
        let reach = || place.angle + axial.within * line.free_speed;
        per_rise * self.relief >= 1.0 && per_rise * face.steepest(place.angle, reach()) >= 1.0
    }

    /// The fastest speed that meets both lines, from the ends of straight pieces of the face.
    fn fastest(
        &self,
        place: &BitPlace,
        face: &Face,
        (line, axial): (LoadLine, &AxialLine),
        at: &impl Fn(f64) -> Trial,
    ) -> Option<Trial> {
        let reach = place.angle + axial.within * line.free_speed;
        let mut above = line.free_speed;
        for angle in face.corners_between(place.angle, reach) {
            let trial = at((angle - place.angle) / axial.within);
            if trial.residual > 0.0 {
                return Some(solve([trial.speed, above].map(End::tried), above, at));
            }
            above = trial.speed;
        }
        None
    }

    fn try_speed(
        &self,
        speed: f64,
        place: &BitPlace,
        face: &Face,
        line: LoadLine,
        axial: &AxialLine,
    ) -> Trial {
        let angle = place.angle + axial.within * speed;
        let gap = |blade: usize| {
            let (rock, rise) = face.ahead(blade, angle);
            advance::Gap {
                depth: place.depth - rock,
                change: -axial.within * rise,
            }
        };
        // Even blades are one to the rock.
        let (one, mut several);
        let gaps: &[advance::Gap] = match self.angles.len() {
            1 => {
                one = [gap(0)];
                &one
            }
            blades => {
                several = [advance::Gap::default(); MOST_PROFILES];
                let several = &mut several[..blades];
                for (blade, it) in several.iter_mut().enumerate() {
                    *it = gap(blade);
                }
                several
            }
        };
        let nearest = gaps
            .iter()
            .fold(f64::NEG_INFINITY, |near, gap| near.max(gap.depth));
        let free = (place.deepest - place.depth).max(-nearest).max(0.0);
        let bound = advance::Bound {
            rate: match speed > 0.0 {
                true => self.relief * speed,
                false => 0.0,
            } + free / axial.step,
            change: self.relief,
        };
        let advance = self.grip.meet(axial, gaps, bound);
        let flat = advance.weight - self.grip.weight * advance.cut;
        let (flat, flat_change) = if flat < 0.0 {
            (0.0, 0.0)
        } else if flat > advance.most_on_flats {
            (advance.most_on_flats, advance.most_change)
        } else {
            let change = advance.weight_change - self.grip.weight * advance.cut_change;
            (flat, change)
        };
        let torque = self.torque * advance.cut + self.flat_radius * flat;
        let change = self.torque * advance.cut_change + self.flat_radius * flat_change;
        Trial {
            speed,
            residual: line.free_speed - line.compliance * torque - speed,
            slope: -1.0 - line.compliance * change,
            torque,
            advance,
        }
    }
}

/// An end of the speeds between which one is looked for, rad/s.
#[derive(Clone, Copy)]
struct End {
    speed: f64,
    /// Whether the sign of the residual is known there.
    is_tried: bool,
}

impl End {
    fn tried(speed: f64) -> Self {
        Self {
            speed,
            is_tried: true,
        }
    }

    fn untried(speed: f64) -> Self {
        Self {
            speed,
            is_tried: false,
        }
    }
}

/// The speed between two at which the residual changes its sign, from positive to negative, by
/// Newton's method from a guess, kept between both; the lower one where it is negative there, too.
/// Ends that were not tried are tried where Newton's method leads to them.
fn solve([mut low, mut high]: [End; 2], guess: f64, at: impl Fn(f64) -> Trial) -> Trial {
    let scale = high.speed.abs().max(f64::MIN_POSITIVE);
    let mut found = at(guess);
    let mut before = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let is_at_low = found.speed == low.speed && found.residual <= 0.0;
        if found.residual.abs() <= FOUND * scale || is_at_low {
            return found;
        }
        match found.residual > 0.0 {
            true => low = End::tried(found.speed),
            false => high = End::tried(found.speed),
        }
        let newton = found.speed - found.residual / found.slope;
        // A corner may make it creep.
        let creeps = found.residual.abs() > 0.5 * before;
        let is_between = newton > low.speed && newton < high.speed;
        let is_narrow = high.speed - low.speed <= ROUNDING * scale;
        let next = if !low.is_tried && (newton <= low.speed || is_narrow) {
            low.speed
        } else if !high.is_tried && newton >= high.speed {
            high.speed
        } else if is_narrow {
            break;
        } else if is_between && !creeps {
            newton
        } else {
            0.5 * (low.speed + high.speed)
        };
        before = found.residual.abs();
        found = at(next);
    }
    found
}
