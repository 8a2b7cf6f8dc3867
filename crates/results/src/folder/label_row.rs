//! What is read back of a row of `labels.csv`.

use sim::{Label, Labels};

use campaign::records::{Certainty, WallPush};

/// What is read back of a row: enough to draw it or to run it again.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelRow {
    /// Line of the file.
    pub line: usize,
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// Values along the given axes.
    pub values: Vec<f64>,
    /// The labels.
    pub labels: Labels,
    /// The label predicted when motion settled, where it was followed to the end.
    pub predicted: Option<Label>,
    /// How far it is from each recording.
    pub misfits: Vec<Option<f64>>,
    /// Each of the measures asked for, where it has it.
    pub measures: Vec<Option<f64>>,
    /// Speed above the one-slip estimate of stick-slip (Eq. 74), rpm, where the table has it.
    pub stick_slip_margin: Option<f64>,
    /// Which of the labels are certain, where the table has it.
    pub certainty: Certainty,
    /// How many sites were found and in how many rounds, where they were looked for.
    pub found: Option<[usize; 2]>,
    /// Whether the mud motor above the bit stalls, where there is one.
    pub motor_stalled: Option<bool>,
    /// The hardest push into a wall, where there was one.
    pub wall_push: Option<WallPush>,
    /// Whether the case failed.
    pub failed: bool,
}

impl LabelRow {
    /// A row that holds no more than the label of a case in torsion, as tests have; without a
    /// `regime` it has no answer.
    pub fn example(method: &str, regime: &str) -> Self {
        Self {
            line: 0,
            case: 0,
            method: method.to_owned(),
            values: Vec::new(),
            labels: Labels::from_fn(|_| Label::of_name(regime)),
            predicted: None,
            misfits: Vec::new(),
            measures: Vec::new(),
            stick_slip_margin: None,
            certainty: Certainty::default(),
            found: None,
            motor_stalled: None,
            wall_push: None,
            failed: false,
        }
    }
}
