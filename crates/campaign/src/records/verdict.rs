//! What a simulation says of a case, and what several of them make certain.

use std::ops::Index;

use serde::{Deserialize, Serialize};
use sim::watch::rules::Rules;
use sim::{
    AxialRegime, Label, Labels, LateralMeasures, LateralRegime, Measures, Motion, Outcome,
    PerMotion, TorsionRegime,
};

use super::whirl::{Whirl, is_whirl};

/// Labels are certified by simulations at the sampling frequency of the sweep and at this
/// many times that.
pub const FINER: f64 = 2.0;

/// What a simulation says of each motion that is modelled.
pub type Verdict = PerMotion<Option<MotionVerdict>>;

/// The label of a motion, and the measures that show how near it is to another.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum MotionVerdict {
    /// How the bit turned.
    Torsion {
        /// The label.
        regime: TorsionRegime,
        /// How far above the one-slip estimate of stick-slip (Eq. 74) the surface turns, rad/s.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        above_limit: Option<f64>,
    },
    /// How the string moved laterally, at the site that decides the label.
    Lateral {
        /// The label.
        regime: LateralRegime,
        /// Part of the closing window in contact.
        contact_fraction: f64,
        /// Rate at which the centre goes round in the closing window, rad/s.
        precession_rate: f64,
        /// What whirl goes round at, at least, rad/s.
        #[serde(default)]
        least_precession_rate: f64,
        /// Mean normal force while in contact in the closing window, N; none in records of
        /// earlier versions.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        mean_normal_force: Option<f64>,
        /// Swing of a string that lies in its hole to either side, rad.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        swing_amplitude: Option<f64>,
    },
    /// How the bit moved along its axis.
    Axial {
        /// The label.
        regime: AxialRegime,
    },
}

/// That of an outcome, `above_limit` (rad/s) the speed above the one-slip estimate of stick-slip (Eq. 74).
pub fn verdict(outcome: &Outcome, above_limit: Option<f64>) -> Verdict {
    Verdict::from_fn(|motion| {
        let of = outcome.measures[motion].as_ref()?;
        Some(MotionVerdict::of(of, above_limit))
    })
}

/// Labels of a case that are certain, and whether its whirl is known by more than its label.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Certified {
    /// The labels that are certain.
    pub labels: Labels,
    /// The label of whirl that all verdicts have, and whether [its rate and force](Whirl) are alike by
    /// each two of them.
    pub whirl: Option<(Label, bool)>,
}

/// What verdicts on one case make certain, by any methods and sampling frequencies: that
/// all have the same label of a motion, and that each measure which decides it is further on its
/// side of where the label changes than they differ in it.
pub fn certified_by(verdicts: &[Verdict]) -> Certified {
    let of_motion = |motion: Motion| -> Option<Vec<MotionVerdict>> {
        verdicts.iter().map(|verdict| verdict[motion]).collect()
    };
    Certified {
        labels: Labels::from_fn(|motion| certain_label(&of_motion(motion)?)),
        whirl: of_motion(Motion::Lateral).and_then(|verdicts| whirl_of(&verdicts)),
    }
}

/// Whether the label of each motion is certain, and whirl is alike by all that certify: `None` of a
/// motion without a label, and where a run does not certify.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Certainty {
    /// Whether the label of each motion is certain.
    pub labels: PerMotion<Option<bool>>,
    /// Whether rate and force of the whirl of a row are alike by all that certify; `None` where not
    /// all of them have its label.
    pub whirl_agrees: Option<bool>,
}

impl Index<Motion> for Certainty {
    type Output = Option<bool>;

    fn index(&self, motion: Motion) -> &Option<bool> {
        &self.labels[motion]
    }
}

/// Of a row with these labels: those that the case is certain to have.
pub fn certainty(labels: Labels, certified: Certified) -> Certainty {
    let is_certain = |motion| Some(certified.labels[motion] == Some(labels[motion]?));
    let own = labels[Motion::Lateral];
    let of_own = certified.whirl.filter(|(label, _)| own == Some(*label));
    Certainty {
        labels: PerMotion::from_fn(is_certain),
        whirl_agrees: of_own.map(|(_, agrees)| agrees),
    }
}

impl MotionVerdict {
    fn of(measures: &Measures, above_limit: Option<f64>) -> Self {
        match *measures {
            Measures::Torsion(torsion) => Self::Torsion {
                regime: torsion.regime,
                above_limit,
            },
            Measures::Lateral(LateralMeasures {
                regime,
                contact_fraction,
                precession_rate,
                least_precession_rate,
                mean_normal_force,
                lying,
                ..
            }) => Self::Lateral {
                regime,
                contact_fraction,
                precession_rate,
                least_precession_rate,
                mean_normal_force: Some(mean_normal_force),
                // Of one that fades, the amplitude of a longer case is another.
                swing_amplitude: (lying.filter(|it| !it.fades)).map(|it| it.swing_amplitude),
            },
            Measures::Axial(axial) => Self::Axial {
                regime: axial.regime,
            },
        }
    }

    /// The label.
    pub fn label(&self) -> Label {
        match *self {
            Self::Torsion { regime, .. } => regime.into(),
            Self::Lateral { regime, .. } => regime.into(),
            Self::Axial { regime } => regime.into(),
        }
    }

    /// The whirl, where it is one whose force is known.
    fn whirl(&self) -> Option<Whirl> {
        match *self {
            Self::Lateral {
                regime,
                precession_rate,
                mean_normal_force,
                ..
            } if is_whirl(regime) => Some(Whirl {
                precession_rate,
                mean_normal_force: mean_normal_force?,
            }),
            _ => None,
        }
    }

    /// How far each measure that decides the label is on its side of where the label changes;
    /// `None` where nothing makes it certain.
    ///
    /// Stick-slip is certain below its limit, from one start or from any; smooth drilling above. A
    /// case that was too short for the bit to turn is undetermined. Contact is that of whirl
    /// where it lasts for most of the closing window and goes round one way, fast enough; that it
    /// does not needs one of the two alone, each in parts of where it changes. What lies in its hole
    /// swings there by less than what snakes, or by more.
    fn distances(&self) -> Option<Vec<f64>> {
        match *self {
            // No limit is known that it could be far from.
            Self::Axial { .. } => None,
            Self::Torsion {
                regime,
                above_limit,
            } => match regime {
                TorsionRegime::StickSlip | TorsionRegime::Bistable => Some(vec![-above_limit?]),
                TorsionRegime::Smooth => Some(vec![above_limit?]),
                _ => None,
            },
            Self::Lateral {
                regime,
                contact_fraction,
                precession_rate,
                least_precession_rate: least,
                swing_amplitude,
                ..
            } => {
                let (mostly, snaking) = (Rules::USUAL.mostly, Rules::USUAL.snaking);
                let lasting = contact_fraction - mostly;
                Some(match regime {
                    // No site has anything to measure.
                    LateralRegime::NoContact => Vec::new(),
                    LateralRegime::TransientContact => {
                        let turns = precession_rate.abs() - least;
                        vec![-(lasting / mostly).min(turns / least)]
                    }
                    LateralRegime::BackwardWhirl => vec![lasting, -precession_rate - least],
                    LateralRegime::ForwardWhirl => vec![lasting, precession_rate - least],
                    LateralRegime::LowSide => vec![snaking - swing_amplitude?],
                    LateralRegime::Snaking => vec![swing_amplitude? - snaking],
                    _ => return None,
                })
            }
        }
    }
}

/// The label of whirl that all verdicts have, and whether it is alike by each two of them.
fn whirl_of(verdicts: &[MotionVerdict]) -> Option<(Label, bool)> {
    let whirls: Option<Vec<Whirl>> = verdicts.iter().map(MotionVerdict::whirl).collect();
    let (whirls, label) = (whirls?, verdicts.first()?.label());
    let is_alike = |one: &Whirl| whirls.iter().all(|other| one.is_like(*other));
    let is_same = verdicts.iter().all(|verdict| verdict.label() == label);
    is_same.then(|| (label, whirls.iter().all(is_alike)))
}

/// The label of one motion that verdicts on it make certain.
fn certain_label(verdicts: &[MotionVerdict]) -> Option<Label> {
    let label = verdicts.first()?.label();
    if verdicts.iter().any(|verdict| verdict.label() != label) {
        return None;
    }
    let distances: Option<Vec<Vec<f64>>> = verdicts.iter().map(MotionVerdict::distances).collect();
    let distances = distances?;
    let is_certain = (0..distances[0].len())
        .all(|measure| is_beyond_spread(distances.iter().map(|of| of[measure])));
    is_certain.then_some(label)
}

/// Whether the least of some distances is greater than what they differ by, which is how
/// well they are known.
fn is_beyond_spread(distances: impl Iterator<Item = f64>) -> bool {
    let ends = distances.map(|distance| [distance; 2]);
    let ends = ends.reduce(|[least, most], [next, _]| [least.min(next), most.max(next)]);
    ends.is_some_and(|[least, most]| least > most - least)
}

#[cfg(test)]
mod tests {
    use sim::Motion;

    use super::*;

    fn turning(regime: TorsionRegime, above_limit: Option<f64>) -> Verdict {
        let of_bit = MotionVerdict::Torsion {
            regime,
            above_limit,
        };
        Verdict::only(Motion::Torsion, of_bit)
    }

    fn touching(regime: LateralRegime, contact_fraction: f64, precession_rate: f64) -> Verdict {
        let sideways = MotionVerdict::Lateral {
            regime,
            contact_fraction,
            precession_rate,
            least_precession_rate: 0.5,
            mean_normal_force: Some(1e4),
            swing_amplitude: None,
        };
        Verdict::only(Motion::Lateral, sideways)
    }

    /// At limits 1 ± 0.1 rad/s: as far from the nearest of them as they are apart.
    #[test]
    fn torsion_is_certain_further_from_the_limit_than_it_is_known() {
        let limits = [0.9, 1.1, 1.0, 1.05];
        let certified = |regime, speed: f64| {
            let verdicts = limits.map(|limit| turning(regime, Some(speed - limit)));
            certified_by(&verdicts).labels[Motion::Torsion]
        };
        let (smooth, stick_slip) = (TorsionRegime::Smooth, TorsionRegime::StickSlip);
        assert_eq!(certified(smooth, 1.31), Some(smooth.into()));
        assert_eq!(certified(smooth, 1.29), None);
        assert_eq!(certified(stick_slip, 0.69), Some(stick_slip.into()));
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
        assert!(certified_by(&[smooth; 4]).labels.is_answer());
        for other in others {
            for place in 0..4 {
                let mut verdicts = [smooth; 4];
                verdicts[place] = other;
                assert_eq!(certified_by(&verdicts), Certified::default());
            }
        }
        assert_eq!(certified_by(&[]), Certified::default());
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
            certified_by(&verdicts).labels[Motion::Lateral]
        };
        assert_eq!(certified(backward, [0.8, -8.0]), Some(backward.into()));
        assert_eq!(certified(backward, [0.74, -8.0]), None, "contact");
        assert_eq!(certified(backward, [0.8, -4.0]), None, "precession");
        assert_eq!(certified(LateralRegime::ForwardWhirl, [0.8, -8.0]), None);
        let transient = LateralRegime::TransientContact;
        let short = [
            touching(transient, 0.0, 1.0),
            touching(transient, 0.2, -1.0),
        ];
        assert_eq!(
            certified_by(&short).labels[Motion::Lateral],
            Some(transient.into())
        );
        // Contact lasts by one of them alone, and neither goes round.
        let lying =
            [[1.0, 0.1], [0.4, -0.05]].map(|[fraction, rate]| touching(transient, fraction, rate));
        assert_eq!(
            certified_by(&lying).labels[Motion::Lateral],
            Some(transient.into())
        );
        let hardly =
            [[1.0, 0.1], [1.0, 0.4]].map(|[fraction, rate]| touching(transient, fraction, rate));
        assert_eq!(certified_by(&hardly), Certified::default());
        let free = touching(LateralRegime::NoContact, 0.0, 0.3);
        assert_eq!(
            certified_by(&[free; 4]).labels[Motion::Lateral],
            Some(LateralRegime::NoContact.into())
        );
    }

    /// The label changes at a swing of 1°.
    #[test]
    fn what_lies_is_certain_where_its_swing_is() {
        let certified = |regime: LateralRegime, swings: [Option<f64>; 2]| {
            let verdicts = swings.map(|degrees| {
                let sideways = MotionVerdict::Lateral {
                    regime,
                    contact_fraction: 1.0,
                    precession_rate: 0.0,
                    least_precession_rate: 0.5,
                    mean_normal_force: Some(1e4),
                    swing_amplitude: degrees.map(f64::to_radians),
                };
                Verdict::only(Motion::Lateral, sideways)
            });
            certified_by(&verdicts).labels[Motion::Lateral].is_some()
        };
        let (low_side, snaking) = (LateralRegime::LowSide, LateralRegime::Snaking);
        assert!(certified(low_side, [Some(0.1), Some(0.5)]));
        assert!(!certified(low_side, [Some(0.1), Some(0.6)]));
        assert!(certified(snaking, [Some(20.0), Some(11.0)]));
        assert!(!certified(snaking, [Some(20.0), Some(10.0)]));
        assert!(!certified(low_side, [Some(0.1), None]));
        assert!(!certified(LateralRegime::FadingSwing, [Some(20.0); 2]));
    }

    /// Labels that are certain stay so where one of four has a third of the force; what differs is said.
    #[test]
    fn whirl_agrees_where_rate_and_force_do() {
        let backward = LateralRegime::BackwardWhirl;
        let by = |forces: [Option<f64>; 3]| {
            let verdicts = forces.map(|mean_normal_force| {
                let sideways = MotionVerdict::Lateral {
                    regime: backward,
                    contact_fraction: 1.0,
                    precession_rate: -9.0,
                    least_precession_rate: 0.5,
                    mean_normal_force,
                    swing_amplitude: None,
                };
                Verdict::only(Motion::Lateral, sideways)
            });
            certified_by(&verdicts)
        };
        let label = Label::from(backward);
        let [alike, weak] = [6e4, 3e4].map(|force| by([Some(1e5), Some(force), Some(8e4)]));
        assert_eq!(alike.whirl, Some((label, true)));
        assert_eq!(weak.whirl, Some((label, false)));
        assert_eq!(weak.labels[Motion::Lateral], Some(label));
        assert_eq!(by([Some(1e5), None, Some(1e5)]).whirl, None);
        let row = |regime: LateralRegime| {
            certainty(Labels::only(Motion::Lateral, regime.into()), weak).whirl_agrees
        };
        assert_eq!(row(backward), Some(false));
        assert_eq!(row(LateralRegime::ForwardWhirl), None);
    }

    #[test]
    fn a_row_is_certain_where_its_own_label_is() {
        let labels = |regime: TorsionRegime| Labels::only(Motion::Torsion, regime.into());
        let certified = Certified {
            labels: labels(TorsionRegime::Smooth),
            whirl: None,
        };
        let of = |labels| certainty(labels, certified)[Motion::Torsion];
        assert_eq!(of(labels(TorsionRegime::Smooth)), Some(true));
        assert_eq!(of(labels(TorsionRegime::StickSlip)), Some(false));
        assert_eq!(of(Labels::default()), None);
    }
}
