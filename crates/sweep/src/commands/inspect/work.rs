//! What the cases of a run take, and what is left out of their scene.

use serde::Serialize;

use crate::commands::cost::{WallTime, cost_lines};
use campaign::design::Design;
use campaign::engine::{MethodSystem, Survey};
use campaign::memory::{Estimate, Limit, Size};
use campaign::plan::Sweep;
use campaign::sweep_file::AutoOr;
use campaign::words::{counted, short};

/// What a run takes.
#[derive(Serialize)]
pub struct InspectedCost {
    /// Cases; of a trace, about how many.
    cases: usize,
    is_trace: bool,
    methods: usize,
    longest_case_s: f64,
    /// Whether a case ends once its regime is decided.
    ends_when_decided: bool,
    /// Terms of the history sum, Eq. 17.
    history_terms: f64,
    memory_bytes: u64,
    memory_limit_bytes: u64,
    /// By a short probe, where it was long enough.
    wall_seconds: Option<f64>,
    #[serde(skip)]
    lines: String,
}

impl InspectedCost {
    /// That of a sweep whose systems are built.
    pub fn of(
        sweep: &Sweep,
        survey: &Survey,
        systems: &[MethodSystem],
        (memory, limit): (&Estimate, &Limit),
        time: &WallTime,
    ) -> Self {
        let terms = systems.iter();
        let terms = terms.map(|system| history_terms(sweep, survey, system));
        Self {
            cases: sweep.design.likely_cases(),
            is_trace: matches!(sweep.design, Design::Trace(_)),
            methods: systems.len(),
            longest_case_s: survey.longest,
            ends_when_decided: matches!(sweep.time, AutoOr::Auto),
            history_terms: terms.sum(),
            memory_bytes: Size(memory.bytes).whole_bytes(),
            memory_limit_bytes: Size(limit.bytes).whole_bytes(),
            wall_seconds: match time {
                WallTime::About(seconds) => Some(*seconds),
                WallTime::Unknown | WallTime::Refused(_) => None,
            },
            lines: cost_lines(memory, limit, time),
        }
    }

    /// In words and numbers.
    pub fn words(&self) -> String {
        let rule = if self.ends_when_decided {
            "until the regime is decided"
        } else {
            "given in the sweep file"
        };
        let cases = counted(self.cases, "case");
        let cases = match self.is_trace {
            true => format!("perhaps {cases} of a trace"),
            false => cases,
        };
        let mut text = format!(
            "\ncost\n  {cases} by {}, the longest {} s ({rule})\n",
            counted(self.methods, "method"),
            short(self.longest_case_s)
        );
        let terms = self.history_terms;
        if terms > 0.0 {
            text += &format!("  about {terms:.1e} terms of the history sum (Eq. 17)\n");
        }
        text.extend(self.lines.lines().map(|line| format!("  {line}\n")));
        text
    }
}

/// What is left out of the scene.
pub fn left_out(sweep: &Sweep) -> Vec<&'static str> {
    let setting = &sweep.setting;
    let is_flat = setting.lateral.is_none();
    [
        (
            is_flat,
            "bending and the borehole wall: no lateral contact is modelled",
        ),
        (
            is_flat && setting.sites.len() > 1,
            "sites other than the bit, in a run: labels are of the bit alone",
        ),
        (
            !is_flat && setting.hanging.is_none(),
            "weight and tension of the string, in bending: no [axial_force] is given",
        ),
        (
            setting.friction.is_none(),
            "friction along the string: no [string_friction] is given",
        ),
        (
            setting.friction.is_none(),
            "the torque at the surface, in a run: nothing depends on it",
        ),
        (sweep.bit.is_none(), "torque at the bit: the bit is free"),
    ]
    .into_iter()
    .filter_map(|(is_so, words)| is_so.then_some(words))
    .collect()
}

/// Terms of the history sums of cases of mean length: between all sites in
/// torsion and in two planes of bending, or from the torque at the bit to its
/// speed.
fn history_terms(sweep: &Sweep, survey: &Survey, system: &MethodSystem) -> f64 {
    let cases = sweep.design.likely_cases() as f64;
    let mean = survey.simulated / sweep.design.cases() as f64;
    let steps = mean * system.setting.sampling_frequency;
    let terms = |taps: usize| {
        let reach = steps.min(taps as f64);
        cases * reach * (steps - 0.5 * reach)
    };
    let torsion = terms(system.torsion_taps());
    let pairs = sweep.setting.sites.len().pow(2) as f64;
    match system.responses.bending() {
        Some(bending) => pairs * (torsion + 2.0 * terms(bending.taps())),
        None if sweep.bit.is_some() => torsion,
        None => 0.0,
    }
}
