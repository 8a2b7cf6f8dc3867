//! Sweeps with one thing changed.

use linear::Method;
use serde::{Deserialize, Serialize};

use crate::plan::{Setting, Starts, Sweep};
use crate::records::FINER;
use crate::sweep_file::StartName;
use crate::words::short;

/// What is changed of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// The linear method, to that of a name.
    Method(String),
    /// The sampling frequency, Hz, of the string as the file says it.
    SamplingFrequencyHz(f64),
    /// The start.
    Start(StartName),
}

impl Change {
    /// Words for what is done otherwise.
    pub fn words(&self) -> String {
        match self {
            Change::Method(method) => format!("by {method}"),
            Change::SamplingFrequencyHz(frequency) => format!("at {} Hz", short(*frequency)),
            Change::Start(StartName::Smooth) => "begun in smooth rotation".to_owned(),
            Change::Start(_) => "begun with the bit held".to_owned(),
        }
    }
}

/// A sweep with one thing changed.
pub(super) struct Variant {
    pub(super) change: Change,
    pub(super) method: Method,
    pub(super) starts: Starts,
}

impl Variant {
    /// The run itself: its own first method, as it stands in the place of another.
    pub(super) fn of_run(sweep: &Sweep) -> Self {
        let method = sweep.methods[0];
        Self {
            change: Change::Method(method.name().to_owned()),
            method,
            starts: sweep.starts,
        }
    }

    /// Whether a run simulates it anyhow, by another method of its list.
    pub(super) fn is_of_list(&self, sweep: &Sweep) -> bool {
        let mut methods = sweep.methods.iter();
        matches!(self.change, Change::Method(_))
            && methods.any(|it| it.name() == self.method.name())
    }

    /// A setting sampled as the variant is.
    pub(super) fn setting(&self, setting: &Setting) -> Setting {
        match self.change {
            Change::SamplingFrequencyHz(_) => {
                setting.sampled_at(FINER * setting.frequency_by(&self.method))
            }
            Change::Method(_) | Change::Start(_) => setting.clone(),
        }
    }
}

/// The variants of a sweep: by another method, at a higher sampling frequency, from another start.
pub(super) fn variants(sweep: &Sweep) -> Vec<Variant> {
    let (method, starts) = (sweep.methods[0], sweep.starts);
    let finer = FINER * sweep.setting.frequency_by(&method);
    let parameters = sweep.content.method.finite_element;
    let others = [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(parameters),
    ];
    // Where the string rubs it is in pieces, which waves held over a step are not.
    let is_in_pieces = sweep.setting.friction.is_some();
    let may_be =
        |other: &Method| other.name() != method.name() && !(is_in_pieces && *other == Method::Held);
    // One by which the run has simulated all cases, where there is one.
    let others = others.into_iter().filter(may_be);
    let is_in_list = |other: &Method| sweep.methods.iter().any(|it| it.name() == other.name());
    let other = (others.clone().find(is_in_list)).or_else(|| others.clone().next());
    let by_other = other.map(|other| Variant {
        change: Change::Method(other.name().to_owned()),
        method: other,
        starts,
    });
    let at_finer = Variant {
        change: Change::SamplingFrequencyHz(finer),
        method,
        starts,
    };
    let begun_otherwise = starts.otherwise(&sweep.content).map(|starts| Variant {
        change: Change::Start(starts.name),
        method,
        starts,
    });
    (by_other.into_iter())
        .chain([at_finer])
        .chain(begun_otherwise)
        .collect()
}
