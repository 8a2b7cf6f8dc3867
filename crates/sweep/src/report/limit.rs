//! Where the simulated boundary lies against the analytic line: the one-slip estimate of stick-slip,
//! or the least friction of steady whirl.

use serde::Serialize;
use sim::{Label, LateralRegime, Motion};

use campaign::quantities::Axis;
use limits::{Boundary, Envelope, StickSlipPoint, TorsionLimit, rolling_envelope};
use results::folder::{CaseRows, LabelRow};

/// Cases on one side of a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct SideCounts {
    /// Those that vibrate.
    pub vibrating: usize,
    /// Those that do not.
    pub quiet: usize,
}

/// How one method's labels lie about its limit. A case's place is its value in
/// multiples of the limit: the surface speed for stick-slip, which Eq. 74 expects
/// below one, though it may be on either side; the friction for backward whirl, which rolls steadily
/// only above one.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct LimitCheck {
    /// The method.
    pub method: String,
    /// Cases below the limit.
    pub below: SideCounts,
    /// Those above it.
    pub above: SideCounts,
    /// The place of the vibrating case furthest to the quiet side.
    pub last_vibrating: Option<f64>,
    /// The place of the quiet case furthest to the vibrating side.
    pub last_quiet: Option<f64>,
}

/// What is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Limited {
    /// The surface speed below which one slip from even rotation stops the bit again (Eq. 74).
    StickSlip,
    /// The friction at which backward whirl rolls steadily.
    Whirl,
}

/// The limit, and what lies on its two sides.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LimitChecks {
    /// What is limited.
    pub limited: Limited,
    /// What the limit means.
    pub meaning: &'static str,
    /// A check for every method.
    pub checks: Vec<LimitCheck>,
    /// The limit for every method, over the value that it depends on.
    #[serde(skip)]
    lines: Vec<Envelope>,
    /// Places among the values of a case: of what is limited, and of what that
    /// depends on.
    #[serde(skip)]
    value: usize,
    #[serde(skip)]
    along: Option<usize>,
}

impl LimitChecks {
    /// Of these methods, without a case; none where there is no limit, or it is of a
    /// quantity that is the same in all cases.
    pub fn new(boundary: &Boundary, axes: &[Axis], methods: &[&str]) -> Option<Self> {
        let place = |axis| axes.iter().position(|&other| other == axis);
        let (limited, value, along, lines) = match boundary {
            Boundary::StickSlip(points) if points.iter().any(is_stick_slip) => {
                let torque = [Axis::TorqueDynamicNm, Axis::WeightOnBitKn];
                let torque = torque.into_iter().find(|&axis| place(axis).is_some())?;
                let of = |method: &&str| stick_slip_curve(points, method, torque);
                let lines = methods.iter().map(of).collect();
                let speed = place(Axis::SurfaceSpeedRpm)?;
                (Limited::StickSlip, speed, place(torque), lines)
            }
            Boundary::Whirl(points) if !points.is_empty() => {
                let lines = vec![rolling_envelope(points); methods.len()];
                let along = place(Axis::SurfaceSpeedRpm);
                (Limited::Whirl, place(Axis::FRICTION)?, along, lines)
            }
            _ => return None,
        };
        let checks = methods.iter().map(|method| LimitCheck {
            method: (*method).to_owned(),
            ..LimitCheck::default()
        });
        Some(Self {
            limited,
            meaning: limited.meaning(),
            checks: checks.collect(),
            lines,
            value,
            along,
        })
    }

    /// Adds a case.
    pub fn add(&mut self, case: &CaseRows) {
        for (check, line) in self.checks.iter_mut().zip(&self.lines) {
            let Some(row) = case.rows.iter().find(|row| row.method == check.method) else {
                continue;
            };
            let limit = match self.along {
                Some(along) => line.at(case.values[along]),
                None => line.least(),
            };
            if let (Some(vibrates), Some(limit)) = (self.limited.vibrates(row), limit) {
                let place = case.values[self.value] / limit;
                check.add(place, vibrates, self.limited == Limited::StickSlip);
            }
        }
    }
}

impl Limited {
    /// What a limit says of the cases below and above it.
    fn meaning(self) -> &'static str {
        match self {
            Limited::StickSlip => {
                "one-slip estimate (Eq. 74): below it a bit that turns evenly sticks again after one \
                 slip; stick-slip may last above it, and smooth rotation below it"
            }
            Limited::Whirl => {
                "least friction of steady rolling whirl at one site: necessary at that site alone"
            }
        }
    }

    /// Whether a row has the vibration that is limited.
    fn vibrates(self, row: &LabelRow) -> Option<bool> {
        match self {
            Limited::StickSlip => row.labels.is_sustained(Motion::Torsion),
            Limited::Whirl => {
                let whirl = Label::from(LateralRegime::BackwardWhirl);
                Some(row.labels[Motion::Lateral]? == whirl)
            }
        }
    }
}

fn is_stick_slip(point: &StickSlipPoint) -> bool {
    point.limit == TorsionLimit::StickSlip
}

/// The limiting speed of one method over the torque or the weight on bit.
fn stick_slip_curve(points: &[StickSlipPoint], method: &str, torque: Axis) -> Envelope {
    let own = points.iter().filter(|point| point.method == method);
    let line = own.filter_map(|point| Some((point.along(torque)?, point.surface_speed_rpm)));
    Envelope::new(&[line.collect()])
}

impl LimitCheck {
    fn add(&mut self, place: f64, vibrates: bool, allows_below: bool) {
        let side = if place < 1.0 {
            &mut self.below
        } else {
            &mut self.above
        };
        let count = if vibrates {
            &mut side.vibrating
        } else {
            &mut side.quiet
        };
        *count += 1;
        let (last, is_greatest) = if vibrates {
            (&mut self.last_vibrating, allows_below)
        } else {
            (&mut self.last_quiet, !allows_below)
        };
        let further = if is_greatest { f64::max } else { f64::min };
        *last = Some(last.map_or(place, |last| further(last, place)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_counted_on_the_sides_of_the_limit() {
        let points = [10.0, 20.0].map(|weight| StickSlipPoint {
            weight_on_bit_kn: Some(weight),
            torque_dynamic_nm: 0.0,
            limit: Default::default(),
            surface_speed_rpm: 0.1 * weight,
            method: "a".to_owned(),
        });
        let axes = [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn];
        let boundary = Boundary::StickSlip(points.to_vec());
        let mut limits = LimitChecks::new(&boundary, &axes, &["a"]).expect("a limit");
        for (speed, label) in [
            (0.75, "stick_slip"),
            (1.65, "stick_slip"),
            (1.2, "smooth"),
            (3.0, "smooth"),
            (0.1, "stuck"),
        ] {
            limits.add(&CaseRows {
                case: 0,
                values: vec![speed, 15.0],
                rows: vec![LabelRow::example("a", label)],
            });
        }
        let check = &limits.checks[0];
        let one_each = SideCounts {
            vibrating: 1,
            quiet: 1,
        };
        assert_eq!((check.below, check.above), (one_each, one_each));
        assert!((check.last_vibrating.expect("one") - 1.1).abs() < 1e-12);
        assert!((check.last_quiet.expect("one") - 0.8).abs() < 1e-12);
    }
}
