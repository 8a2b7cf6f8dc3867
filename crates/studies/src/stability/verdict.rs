//! What a cell shows, and whether its margin predicted it.

use linear::passivity::STABLE_MARGIN;

use super::families::{Approach, Cell, Family};

/// Chatter above this part of the torque, or of the contact force, that the scene
/// is about. What a stable method leaves is below a few millionths.
const CHATTER: f64 = 1e-4;

/// Chatter that grows by more than this between two windows diverges.
const GROWTH: f64 = 10.0;

/// A rate of winding up, or a radius of whirl, that differs from the true one by
/// more than this is another motion.
const DRIFT: f64 = 0.1;

/// Recaptures of Fig. 8(b) within 40 s, of which there are seven: more than twice
/// as many are not stick-slip.
const MOST_RECAPTURES: usize = 14;

/// A displacement or frequency response that differs by more than this is wrong.
const ERROR: f64 = 0.1;

/// What a cell shows. `None` is what its scene does not have.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Findings {
    /// Positive-real margin in torsion.
    pub margin_torsion: Option<f64>,
    /// Positive-real margin in bending.
    pub margin_bending: Option<f64>,
    /// Margin in bending of the differences of positions that the wall meets.
    pub margin_wall: Option<f64>,
    /// What an oscillator tuned to the margin's place gains, in units of A(0);
    /// the larger of torsion and bending.
    pub energy_gained: Option<f64>,
    /// Roughness of a torque or force that should be smooth, relative to it.
    pub chatter: Option<f64>,
    /// How much rougher it becomes.
    pub growth: Option<f64>,
    /// Relative error of the rate of winding up, or of the radius of whirl.
    pub drift: Option<f64>,
    /// Times the bit was recaptured in Fig. 8(b), 40 s.
    pub recaptures: Option<usize>,
    /// Relative error of a response that no margin is about.
    pub error: Option<f64>,
    /// Why a simulation gave no answer.
    pub no_answer: Option<String>,
}

/// What is wrong with a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symptom {
    /// A tuned oscillator gains energy from the string.
    EnergyGained,
    /// What should be smooth chatters.
    Chatter,
    /// Chatter grows without end.
    Divergence,
    /// The static stiffness, or the steady radius, is another.
    Drift,
    /// The bit sticks far too often.
    Recaptures,
    /// The simulation gave up, or its numbers are not finite.
    NoAnswer,
    /// A response is inaccurate.
    Error,
}

impl Symptom {
    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Symptom::EnergyGained => "energy",
            Symptom::Chatter => "chatter",
            Symptom::Divergence => "divergence",
            Symptom::Drift => "drift",
            Symptom::Recaptures => "recaptures",
            Symptom::NoAnswer => "no-answer",
            Symptom::Error => "error",
        }
    }
}

impl Findings {
    /// Whether the margins predict that the cell is stable; `None` where there is no margin, or it
    /// does not cover what is examined.
    pub fn predicted_stable(&self) -> Option<bool> {
        let margins = [self.margin_torsion, self.margin_bending];
        let smallest = margins.into_iter().flatten().reduce(f64::min);
        smallest
            .filter(|_| self.error.is_none())
            .map(|margin| margin >= STABLE_MARGIN)
    }

    /// Everything that is wrong.
    pub fn symptoms(&self) -> Vec<Symptom> {
        // What is not a number is not below any threshold.
        let above = |value: Option<f64>, most: f64| {
            value.is_some_and(|value| value > most || value.is_nan())
        };
        let gains = above(self.energy_gained, -STABLE_MARGIN);
        let chatters = above(self.chatter, CHATTER);
        let drifts = above(self.drift.map(f64::abs), DRIFT);
        let recaptures = self.recaptures.is_some_and(|count| count > MOST_RECAPTURES);
        let signs = [
            (Symptom::EnergyGained, gains),
            (Symptom::Chatter, chatters),
            (Symptom::Divergence, chatters && above(self.growth, GROWTH)),
            (Symptom::Drift, drifts),
            (Symptom::Recaptures, recaptures),
            (Symptom::NoAnswer, self.no_answer.is_some()),
            (Symptom::Error, above(self.error, ERROR)),
        ];
        (signs.into_iter())
            .filter_map(|(symptom, shows)| shows.then_some(symptom))
            .collect()
    }

    /// Whether what was predicted came; `None` where nothing was predicted.
    pub fn is_right(&self) -> Option<bool> {
        self.predicted_stable()
            .map(|stable| stable == self.symptoms().is_empty())
    }
}

/// Why a cell is not what its margin says, or why its margin says nothing.
pub fn explanation(cell: &Cell, findings: &Findings) -> Option<String> {
    let symptoms = findings.symptoms();
    let margin_wall = findings.margin_wall;
    let meets_differences = margin_wall.is_some_and(|margin| margin < STABLE_MARGIN);
    let is_rigid = cell.stiffness == Some(f64::INFINITY);
    let decays = findings.growth.is_some_and(|growth| growth < 1.0);
    let is_wrong = symptoms.contains(&Symptom::Error);
    let why = if let Some(reason) = &findings.no_answer {
        reason
    } else if is_wrong && cell.approach == Approach::TransferProducts {
        "only the growing wave is left in the products"
    } else if is_wrong && cell.family == Family::Joints {
        "steps longer than a joint smear its echo, or fronts overshoot"
    } else if is_wrong && matches!(cell.approach, Approach::Method(_)) {
        "the response near zero frequency is narrower than the frequency step"
    } else if findings.is_right() == Some(false) && meets_differences && is_rigid {
        "a rigid wall meets differences of positions, in which Newmark's response \
         is not positive-real (margin_wall)"
    } else if findings.predicted_stable() == Some(true) && symptoms == [Symptom::Chatter] && decays
    {
        "positive-real, but hardly at the top of the band: chatter gains nothing \
         and decays slowly"
    } else {
        return None;
    };
    Some(why.to_owned())
}
