//! Eq. 61, step by step: history, load line, law.

use linear::TorsionResponses;

use crate::error::SimulationError;
use crate::future::Future;
use crate::held::HeldTorque;
use crate::history::{History, Kernel, Kernels};
use crate::laws::bit::{BitMotion, BitTorque};
use crate::regime::{BitWatch, TorsionMeasures, TorsionRegime};
use crate::scene::{Scene, not_negative};
use crate::settling::{Ended, Stopping};
use crate::trajectory::Trajectory;
use crate::whirl::LateralMeasures;

/// The linear part as all cases share it: the responses ready for summing.
#[derive(Debug, Clone)]
pub struct System {
    step_length: f64,
    /// The longest case, s.
    longest_time: f64,
    /// Response of each site to a surface that starts to turn at 1 rad/s.
    surface_step: Vec<Vec<f64>>,
    /// Torque input and each site's response to it, where there is one.
    bit: Option<BitInput>,
}

#[derive(Debug, Clone)]
struct BitInput {
    site: usize,
    to_itself: Kernels,
    held: HeldTorque,
    future: Future,
    to_sites: Vec<Kernel>,
}

impl System {
    /// Prepares responses for simulations of at most `longest_time` (s). What
    /// does not depend on the case is computed here once: the response to the
    /// surface's step, and the torque of a bit that never slips; a case only
    /// scales them. Without a torque input at the bit it turns freely in every case.
    ///
    /// # Errors
    /// Where the responses are not those of a string, or end before that time.
    pub fn new(responses: &TorsionResponses, longest_time: f64) -> Result<Self, SimulationError> {
        responses.check()?;
        not_negative("longest time in s", longest_time)?;
        lasts_no_longer(longest_time, responses.longest_time())?;
        let surface_step = surface_steps(responses);
        let step_length = 1.0 / responses.sampling_frequency;
        let bit_site = responses.sites.bit_site();
        let bit = bit_site.zip(responses.from_bit()).map(|(site, taps)| {
            let future = Future::new(taps[site]);
            let to_itself = Kernels::new(&[vec![taps[site].to_vec()]]);
            let surface = |step: usize| settled(&surface_step[site], step);
            BitInput {
                site,
                held: HeldTorque::new(&to_itself, surface, steps_of(longest_time, step_length)),
                to_itself,
                future,
                to_sites: taps.into_iter().map(Kernel::new).collect(),
            }
        });
        Ok(Self {
            step_length,
            longest_time,
            surface_step,
            bit,
        })
    }

    /// The torque that holds the bit fast from the first step on, for as long as
    /// any case lasts, N m per rad/s of surface speed; `None` where no torque acts
    /// there.
    pub fn held_torque(&self) -> Option<&[f64]> {
        self.bit.as_ref().map(|bit| bit.held.torques())
    }

    /// Speeds of all sites, rad/s, in so many steps: what a surface that turns at
    /// `surface_speed` (rad/s) from the first of them on makes of them, and, but for
    /// the bit itself, the torques on the bit (N m, positive with the rotation). Sites
    /// that are only looked at follow from these: whoever has simulated a bit without
    /// them has their motion here.
    pub fn driven_speeds(
        &self,
        surface_speed: f64,
        bit_torque: &[f64],
        steps: usize,
    ) -> Vec<Vec<f64>> {
        let mut speeds = self.free_speeds(surface_speed, steps);
        if let Some(input) = &self.bit {
            input.drive_other_sites(&mut speeds, bit_torque);
        }
        speeds
    }

    /// Speeds of all sites with nothing but the surface turning them.
    fn free_speeds(&self, surface_speed: f64, steps: usize) -> Vec<Vec<f64>> {
        (0..self.surface_step.len())
            .map(|site| {
                (0..steps)
                    .map(|step| surface_speed * self.surface_response(site, step))
                    .collect()
            })
            .collect()
    }

    /// Speed of a site in a step, per unit surface speed, no torque acting.
    fn surface_response(&self, site: usize, step: usize) -> f64 {
        settled(&self.surface_step[site], step)
    }
}

/// A response at a step; it does not change after its last.
fn settled(response: &[f64], step: usize) -> f64 {
    response[step.min(response.len() - 1)]
}

/// A number of taps is known as a time to this part of it.
const SAME_TIME: f64 = 1e-9;

/// Refuses a case that lasts longer than the responses it is stepped against.
pub(crate) fn lasts_no_longer(duration: f64, prepared: f64) -> Result<(), SimulationError> {
    if duration <= prepared * (1.0 + SAME_TIME) {
        Ok(())
    } else {
        Err(SimulationError::LongerThanPrepared { duration, prepared })
    }
}

/// Steps of a case, that at its start included.
pub(crate) fn steps_of(duration: f64, step_length: f64) -> usize {
    (duration / step_length).ceil() as usize + 1
}

/// Response of each site to a surface that starts to turn at 1 rad/s.
pub(crate) fn surface_steps(responses: &TorsionResponses) -> Vec<Vec<f64>> {
    (responses.from_surface.iter())
        .map(|taps| running_sum(taps))
        .collect()
}

fn running_sum(taps: &[f64]) -> Vec<f64> {
    taps.iter()
        .scan(0.0, |sum, tap| {
            *sum += tap;
            Some(*sum)
        })
        .collect()
}

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Time stepped, s.
    pub simulated: f64,
    /// Why it ended.
    pub ended: Ended,
    /// The label that settled motion would have given, where it was followed to
    /// the end to see.
    pub foretold: Option<&'static str>,
    /// Regime and measures of the bit, where it meets rock.
    pub torsion: Option<TorsionMeasures>,
    /// Regime and measures of the lateral motion, where it is modelled.
    pub lateral: Option<LateralMeasures>,
}

impl Outcome {
    /// Itself, unless what was measured is no number: squares and sums of finite
    /// motion may be none.
    pub(crate) fn finite(self) -> Result<Self, SimulationError> {
        let of_torsion = self.torsion.iter().flat_map(TorsionMeasures::numbers);
        let of_bending = self.lateral.iter().flat_map(LateralMeasures::numbers);
        let mut all = of_torsion.chain(of_bending);
        match all.find(|(_, value)| !value.is_finite()) {
            Some((measure, _)) => Err(SimulationError::NotMeasured { measure }),
            None => Ok(self),
        }
    }
}

/// Simulates one case, writing its time history into `record` where asked;
/// nothing is left out of that.
///
/// # Errors
/// Where the scene is not one that can be, the responses do not fit it, or the
/// motion is not finite.
pub fn simulate(
    system: &System,
    scene: &Scene,
    stopping: Stopping,
    record: Option<&mut Trajectory>,
) -> Result<Outcome, SimulationError> {
    scene.check(system.surface_step.len())?;
    let (duration, prepared) = (scene.timing.duration, system.longest_time);
    if duration > prepared {
        return Err(SimulationError::LongerThanPrepared { duration, prepared });
    }
    let steps = steps_of(scene.timing.duration, system.step_length);
    match (scene.bit, &system.bit) {
        (None, _) => {
            if let Some(record) = record {
                record.speeds = system.free_speeds(scene.surface_speed, steps);
            }
            Ok(Outcome {
                simulated: (steps - 1) as f64 * system.step_length,
                ended: Ended::End,
                foretold: None,
                torsion: None,
                lateral: None,
            })
        }
        (Some(_), None) => Err(SimulationError::NoTorqueInput),
        (Some(law), Some(input)) => step_bit(system, input, scene, law, steps, stopping, record),
    }
}

/// A bit that turns for this part of what it remembers, in per cent, may turn for
/// ever: a wave has come and gone several times.
const TURNING_FOR: usize = 10;

fn step_bit(
    system: &System,
    input: &BitInput,
    scene: &Scene,
    law: BitTorque,
    steps: usize,
    stopping: Stopping,
    mut record: Option<&mut Trajectory>,
) -> Result<Outcome, SimulationError> {
    let stopping = if record.is_some() {
        Stopping::Full
    } else {
        stopping
    };
    let speed = scene.surface_speed;
    let held = |step: usize| speed * input.held.at(step);
    let slip = input.held.first_slip(speed, law.torque_static).min(steps);
    if let Some(record) = record.as_deref_mut() {
        *record = Trajectory {
            speeds: system.free_speeds(scene.surface_speed, steps),
            bit_torque: (0..slip).map(held).collect(),
            ..Trajectory::default()
        };
        record.speeds[input.site][..slip].fill(0.0);
    }
    let compliance = input.to_itself.instant(0, 0);
    // Torque beyond that of a bit held fast.
    let mut beyond = History::new(&input.to_itself, 1, steps - slip);
    let mut watch = BitWatch::new(system.step_length, steps, scene.timing.closing_window);
    watch.skip_stuck(slip);
    // The first instant is stuck.
    let mut motion = BitMotion::Stuck;
    let memory = input.future.memory();
    let (mut ended, mut foretold, mut simulated) = (Ended::End, None, steps.max(1) - 1);
    for step in slip..steps {
        let mut past = [0.0];
        beyond.past(&mut past);
        let now = law.meet(motion, past[0] - compliance * held(step), compliance);
        if !(now.torque.is_finite() && now.speed.is_finite()) {
            return Err(SimulationError::NotFinite {
                site: input.site,
                time: step as f64 * system.step_length,
            });
        }
        motion = now.motion;
        beyond.push(&[now.torque - held(step)]);
        watch.see(motion, now.speed);
        if let Some(record) = record.as_deref_mut() {
            record.speeds[input.site][step] = now.speed;
            record.bit_torque.push(now.torque);
        }
        if stopping == Stopping::Full {
            continue;
        }
        // A look ahead costs about as much as stepping half of what it sees.
        let looks_ahead =
            watch.turning_for() == TURNING_FOR * memory / 100 && steps - step > memory / 2;
        if looks_ahead {
            let first = (step + 1).saturating_sub(memory);
            let before = (first..slip.max(first)).map(held);
            let since = slip.max(first)..step + 1;
            let torques = since.map(|n| beyond.inputs(0, 0)[n - slip] + held(n));
            let mut speeds = input.future.speeds(before.chain(torques), now.torque);
            for (ahead, value) in speeds.iter_mut().enumerate() {
                *value += speed * system.surface_response(input.site, step + 1 + ahead);
            }
            // The surface, too, has settled by then.
            let is_last = step + memory >= system.surface_step[input.site].len();
            if is_last && turns_on(&speeds, now.speed) {
                watch.turn_on(motion, &speeds);
                (ended, simulated) = (Ended::Certain, step);
                break;
            }
        }
        if foretold.is_none() && watch.is_settled() {
            if stopping == Stopping::Early {
                watch.repeat_last_cycle();
                (ended, simulated) = (Ended::Settled, step);
                break;
            }
            foretold = Some(TorsionRegime::StickSlip.name());
        }
    }
    if let Some(record) = record {
        input.drive_other_sites(&mut record.speeds, &record.bit_torque);
    }
    Outcome {
        simulated: simulated as f64 * system.step_length,
        ended,
        foretold,
        torsion: Some(watch.measures()),
        lateral: None,
    }
    .finite()
}

/// Whether a bit at `speed` has the same direction at all `speeds` to come.
fn turns_on(speeds: &[f64], speed: f64) -> bool {
    let mut speeds = speeds.iter();
    speeds.all(|next| next.is_finite() && next * speed > 0.0)
}

impl BitInput {
    /// Adds what the torques on the bit make of the speeds of the other sites.
    fn drive_other_sites(&self, speeds: &mut [Vec<f64>], bit_torque: &[f64]) {
        for (site, (kernel, speeds)) in self.to_sites.iter().zip(speeds).enumerate() {
            if site == self.site {
                continue;
            }
            for (step, (speed, torque)) in speeds.iter_mut().zip(bit_torque).enumerate() {
                *speed += kernel.past_sum(&bit_torque[..step]) + kernel.instant() * torque;
            }
        }
    }
}
