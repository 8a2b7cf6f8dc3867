//! How long a case is simulated where the file does not say.

use linear::bending_decay::friction_if_carried;
use linear::{Bending, Drillstring};
use sim::{BitTorque, Cutting, Start, Timing, torsion_timing};

use crate::plan::{Setting, Sweep};
use crate::sweep_file::AutoOr;

/// Times as long as by rule, one after the other, for which a case is followed while its motion fades.
pub(super) const TIMES: [f64; 2] = [3.0, 9.0];

/// Whether the time of cases is by rule, and that waits for motion to fade.
pub fn is_by_rule(sweep: &Sweep, setting: &Setting) -> bool {
    matches!(sweep.time, AutoOr::Auto) && setting.cutting.is_none()
}

/// A bit without torque has no regime to wait for: ten seconds as in the paper, the last two of which
/// decide.
const BY_DEFAULT: Timing = Timing {
    duration: 10.0,
    closing_window: 2.0,
};

/// A string that lies in its hole swings about once a second, and its swing fades within some ten.
const WHILE_IT_SWINGS: Timing = Timing {
    duration: 20.0,
    closing_window: 5.0,
};

/// Time constants of what damping and mud take at the surface speed, after which a whirl that
/// friction does not sustain has faded, and one that it sustains has grown.
const WHIRL_FADES: f64 = 3.0;

/// The most that is waited for that, s: nothing holds some strings back.
const LONGEST_WHIRL: f64 = 60.0;

/// The timing of a case at a surface speed (rad/s) that is long enough for its regimes to show, with
/// all that holds the string back in torsion, how it starts and what it cuts.
pub(super) fn timing_by_rule(
    setting: &Setting,
    surface_speed: f64,
    all: Option<&BitTorque>,
    start: &Start,
    cutting: Option<&Cutting>,
) -> Timing {
    let mut timing = all.map_or(BY_DEFAULT, |all| {
        torsion_timing(&setting.string, surface_speed, all, start)
    });
    if let Some(limit) = setting.drive_limit {
        timing = timing.below_limited(&setting.string, surface_speed, all, limit);
    }
    if let Some(lateral) = &setting.lateral {
        // Two regimes have to be decided.
        timing = longer(timing, BY_DEFAULT);
        // A later impulse is refused.
        let ends = (lateral.impulses.iter())
            .map(|impulse| impulse.start + impulse.duration)
            .filter(|end| *end < timing.duration);
        let fades = while_whirl_fades(&setting.string, &lateral.bending, surface_speed);
        let begins = ends.fold(0.0, f64::max);
        timing.duration = timing.duration.max(begins + fades);
    }
    if setting.lying.is_some() {
        timing = longer(timing, WHILE_IT_SWINGS);
    }
    if let Some(cutting) = cutting {
        timing = while_it_drills(cutting, surface_speed);
        if let Some(limit) = setting.drive_limit {
            timing = timing.below_limited(&setting.string, surface_speed, None, limit);
        }
    }
    if *start == Start::Rest {
        let fed = setting.cutting.as_ref().map_or(0.0, |it| it.profile.rise());
        timing.duration += setting.profile.rise().max(fed);
    }
    timing
}

/// Each of two timings as far as it goes.
fn longer(one: Timing, other: Timing) -> Timing {
    Timing {
        duration: one.duration.max(other.duration),
        closing_window: one.closing_window.max(other.closing_window),
    }
}

/// In what time whirl fades or grows, s.
fn while_whirl_fades(string: &Drillstring, bending: &Bending, surface_speed: f64) -> f64 {
    let rate = surface_speed.abs();
    let decay_rate = 0.5 * rate * friction_if_carried(string, bending, rate);
    (WHIRL_FADES / decay_rate).min(LONGEST_WHIRL)
}

/// What cuts is followed for a minute: slow growth shows, and means over a third of that are those of
/// motion that is often chaotic. A bit that turns slowly is followed until as many blades have passed
/// in that third as a regime of the axis has repetitions.
fn while_it_drills(cutting: &Cutting, surface_speed: f64) -> Timing {
    const LEAST: f64 = 20.0;
    const PASSES: f64 = 3.0;
    const THIRDS: f64 = 3.0;
    let pass = std::f64::consts::TAU / (cutting.blades() as f64 * surface_speed.abs());
    let closing_window = match pass.is_finite() {
        true => LEAST.max(PASSES * pass),
        false => LEAST,
    };
    Timing {
        duration: THIRDS * closing_window,
        closing_window,
    }
}
