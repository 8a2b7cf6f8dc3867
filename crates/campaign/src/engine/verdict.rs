//! What a simulation says of a case, and what several of them make certain.

use serde::{Deserialize, Serialize};
use sim::watch::rules::Rules;
use sim::{LateralRegime, Outcome, TorsionRegime};

/// Labels are certified by simulations at the sampling frequency of the sweep and at this
/// many times that.
pub const FINER: f64 = 2.0;

/// The labels of a simulation, and the measures that tell how near each is to another.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Verdict {
    /// How the bit turned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torsion: Option<TorsionRegime>,
    /// How far above the analytic limit of stick-slip (Eq. 74) the surface turns, rad/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above_limit: Option<f64>,
    /// How the string moved laterally.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral: Option<LateralVerdict>,
}

/// The same of lateral motion, of the site that decides its label.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LateralVerdict {
    /// The label.
    pub regime: LateralRegime,
    /// Part of the closing window in contact.
    pub contact_fraction: f64,
    /// Rate at which the centre goes round in the closing window, rad/s.
    pub precession_rate: f64,
}

/// Labels that are certain; none of a motion whose label is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Certified {
    /// Of the bit's rotation.
    pub torsion: Option<TorsionRegime>,
    /// Of lateral motion.
    pub lateral: Option<LateralRegime>,
}

impl Verdict {
    /// That of what came out, `above_limit` (rad/s) the analytic limit of stick-slip.
    pub fn of(outcome: &Outcome, above_limit: Option<f64>) -> Self {
        Self {
            torsion: outcome.torsion.map(|torsion| torsion.regime),
            above_limit: above_limit.filter(|_| outcome.torsion.is_some()),
            lateral: outcome.lateral.map(|lateral| LateralVerdict {
                regime: lateral.regime,
                contact_fraction: lateral.contact_fraction,
                precession_rate: lateral.precession_rate,
            }),
        }
    }
}

impl Certified {
    /// What verdicts on one case make certain, by whatever methods and sampling frequencies:
    /// that all have the same label, and that each measure which decides it is further on
    /// its side of where the label changes than they differ in it.
    pub fn by(verdicts: &[Verdict]) -> Self {
        Self {
            torsion: torsion(verdicts),
            lateral: lateral(verdicts),
        }
    }
}

/// Stick-slip is certain below its limit, from one start or from any; smooth drilling above. A
/// case that was too short for the bit to turn is undetermined.
fn torsion(verdicts: &[Verdict]) -> Option<TorsionRegime> {
    let regime = the_same(verdicts.iter().map(|verdict| verdict.torsion))?;
    let side = match regime {
        TorsionRegime::StickSlip | TorsionRegime::Bistable => -1.0,
        TorsionRegime::Smooth => 1.0,
        TorsionRegime::Stuck => return None,
    };
    let distances = verdicts
        .iter()
        .map(|verdict| Some(side * verdict.above_limit?));
    is_beyond_spread(distances).then_some(regime)
}

/// Contact is that of whirl where it lasts for most of the closing window, and whirl goes
/// round one way.
fn lateral(verdicts: &[Verdict]) -> Option<LateralRegime> {
    let regime = the_same(verdicts.iter().map(|verdict| Some(verdict.lateral?.regime)))?;
    let distances = |of: fn(&LateralVerdict) -> f64| {
        let distances = verdicts
            .iter()
            .map(move |verdict| verdict.lateral.as_ref().map(of));
        is_beyond_spread(distances)
    };
    let (lasts, is_short) = (
        |it: &LateralVerdict| it.contact_fraction - Rules::USUAL.mostly,
        |it: &LateralVerdict| Rules::USUAL.mostly - it.contact_fraction,
    );
    let is_certain = match regime {
        // No site has anything to measure.
        LateralRegime::NoContact => true,
        LateralRegime::TransientContact => distances(is_short),
        LateralRegime::BackwardWhirl => distances(lasts) && distances(|it| -it.precession_rate),
        LateralRegime::ForwardWhirl => distances(lasts) && distances(|it| it.precession_rate),
    };
    is_certain.then_some(regime)
}

/// What all have, where they do and it is the same.
fn the_same<Regime: Copy + PartialEq>(
    mut regimes: impl Iterator<Item = Option<Regime>>,
) -> Option<Regime> {
    let first = regimes.next()??;
    regimes.all(|other| other == Some(first)).then_some(first)
}

/// Whether the least of some distances is greater than what they differ by, which is how
/// well they are known.
fn is_beyond_spread(distances: impl Iterator<Item = Option<f64>>) -> bool {
    let ends = distances.map(|distance| distance.map(|distance| [distance; 2]));
    let ends = ends.reduce(|one, other| {
        let ([least, most], [next, _]) = (one?, other?);
        Some([least.min(next), most.max(next)])
    });
    ends.flatten()
        .is_some_and(|[least, most]| least > most - least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turning(regime: TorsionRegime, above_limit: Option<f64>) -> Verdict {
        Verdict {
            torsion: Some(regime),
            above_limit,
            lateral: None,
        }
    }

    fn touching(regime: LateralRegime, contact_fraction: f64, precession_rate: f64) -> Verdict {
        Verdict {
            lateral: Some(LateralVerdict {
                regime,
                contact_fraction,
                precession_rate,
            }),
            ..Verdict::default()
        }
    }

    /// At limits 1 ± 0.1 rad/s: as far from the nearest of them as they are apart.
    #[test]
    fn torsion_is_certain_further_from_the_limit_than_it_is_known() {
        let limits = [0.9, 1.1, 1.0, 1.05];
        let certified = |regime, speed: f64| {
            let verdicts = limits.map(|limit| turning(regime, Some(speed - limit)));
            Certified::by(&verdicts).torsion
        };
        let (smooth, stick_slip) = (TorsionRegime::Smooth, TorsionRegime::StickSlip);
        assert_eq!(certified(smooth, 1.31), Some(smooth));
        assert_eq!(certified(smooth, 1.29), None);
        assert_eq!(certified(stick_slip, 0.69), Some(stick_slip));
        assert_eq!(certified(stick_slip, 0.71), None);
        // On the wrong side of the limit, and too short to tell.
        assert_eq!(certified(smooth, 0.1), None);
        assert_eq!(certified(stick_slip, 9.0), None);
        assert_eq!(certified(TorsionRegime::Stuck, 0.1), None);
    }

    #[test]
    fn one_that_differs_or_has_no_answer_leaves_nothing_certain() {
        let smooth = turning(TorsionRegime::Smooth, Some(5.0));
        let others = [
            turning(TorsionRegime::StickSlip, Some(5.0)),
            turning(TorsionRegime::Smooth, None),
            Verdict::default(),
        ];
        assert!(Certified::by(&[smooth; 4]).torsion.is_some());
        for other in others {
            for place in 0..4 {
                let mut verdicts = [smooth; 4];
                verdicts[place] = other;
                assert_eq!(Certified::by(&verdicts), Certified::default());
            }
        }
        assert_eq!(Certified::by(&[]), Certified::default());
    }

    #[test]
    fn whirl_is_certain_where_contact_and_precession_are() {
        let backward = LateralRegime::BackwardWhirl;
        let certified = |regime, others: [f64; 2]| {
            let [fraction, rate] = others;
            let verdicts = [
                touching(regime, 1.0, -9.0),
                touching(regime, fraction, rate),
            ];
            Certified::by(&verdicts).lateral
        };
        assert_eq!(certified(backward, [0.8, -8.0]), Some(backward));
        assert_eq!(certified(backward, [0.74, -8.0]), None, "contact");
        assert_eq!(certified(backward, [0.8, -4.0]), None, "precession");
        assert_eq!(certified(LateralRegime::ForwardWhirl, [0.8, -8.0]), None);
        let transient = LateralRegime::TransientContact;
        let short = [
            touching(transient, 0.0, 1.0),
            touching(transient, 0.2, -1.0),
        ];
        assert_eq!(Certified::by(&short).lateral, Some(transient));
        let free = touching(LateralRegime::NoContact, 0.0, 0.3);
        assert_eq!(
            Certified::by(&[free; 4]).lateral,
            Some(LateralRegime::NoContact)
        );
    }
}
