//! Doubts about whirl, as its methods are sampled.

use linear::Method;

use super::sweep::Sweep;
use super::whirl::steps_of_turn;
use crate::sweep_file::AutoOr;
use crate::words::short;

impl Sweep {
    /// Methods that damp the fastest whirl to expect.
    pub(super) fn doubts_about_whirl(&self) -> Option<String> {
        let setting = &self.setting;
        let too_coarse = |method: &Method| {
            let (steps, needed) = (
                setting.steps_of_whirl(method)?,
                steps_of_turn(method.name()),
            );
            (steps < needed * (1.0 - 1e-9)).then(|| {
                let frequency = short(setting.frequency_by(method));
                format!(
                    "{} at {frequency} Hz has {steps:.1} of {needed}",
                    method.name()
                )
            })
        };
        let methods: Vec<String> = self.methods.iter().filter_map(too_coarse).collect();
        let remedy = match (self.content.accuracy, self.content.sampling_frequency_hz) {
            (Some(_), _) => "give `methods` in place of `accuracy`",
            (None, AutoOr::Given(_)) => "leave `sampling_frequency_hz` out, or raise it",
            (None, AutoOr::Auto) => "give the wall the stiffness of rock, or more clearance",
        };
        (!methods.is_empty()).then(|| {
            format!(
                "whirl at up to {:.0} turns/s is to be expected at the walls, and of the steps that a turn needs {}: \
                 whirl that lasts may be missed, and its force is too small; {remedy}",
                setting.whirl_rate.unwrap_or_default(),
                methods.join(", "),
            )
        })
    }
}
