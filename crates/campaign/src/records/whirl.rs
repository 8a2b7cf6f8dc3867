//! Rate and force of whirl, by which those who find it are compared: a method that damps whirl may
//! have its label and a fraction of its force.

use sim::{Label, LateralRegime, Outcome};

/// A part of the greater rate, by which two that are alike differ at most,
const RATE: f64 = 0.25;

/// and of the greater force. Whirl of several sites is chaotic, and repeats both to a tenth.
const FORCE: f64 = 0.5;

/// The rate of precession and the mean normal force of whirl, at the site that decides the label.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whirl {
    /// Rate at which the centre goes round, rad/s, positive with the rotation.
    pub precession_rate: f64,
    /// Mean normal force while in contact, N.
    pub mean_normal_force: f64,
}

impl Whirl {
    /// The whirl of an outcome; `None` where it does not whirl.
    pub fn of(outcome: &Outcome) -> Option<Self> {
        let lateral = outcome.lateral()?;
        is_whirl(lateral.regime).then_some(Self {
            precession_rate: lateral.precession_rate,
            mean_normal_force: lateral.mean_normal_force,
        })
    }

    /// Whether rate and force of two are alike.
    pub fn is_like(self, other: Self) -> bool {
        is_within(RATE, self.precession_rate, other.precession_rate)
            && is_within(FORCE, self.mean_normal_force, other.mean_normal_force)
    }
}

/// Whether a regime is whirl.
pub fn is_whirl(regime: LateralRegime) -> bool {
    Label::Lateral(regime).is_sustained() == Some(true)
}

/// Whether two numbers differ by no more than a part of the greater.
fn is_within(part: f64, one: f64, other: f64) -> bool {
    (one - other).abs() <= part * one.abs().max(other.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whirl_is_like_another_of_about_its_rate_and_force() {
        let whirl = |precession_rate, mean_normal_force| Whirl {
            precession_rate,
            mean_normal_force,
        };
        let one = whirl(-20.0, 8e4);
        for (other, is_like) in [
            (one, true),
            (whirl(-16.0, 4.1e4), true),
            (whirl(-14.0, 8e4), false),
            (whirl(-20.0, 3.9e4), false),
            (whirl(-20.0, 1.7e5), false),
            (whirl(20.0, 8e4), false),
        ] {
            assert_eq!(one.is_like(other), is_like, "{other:?}");
            assert_eq!(other.is_like(one), is_like, "{other:?}");
        }
    }
}
