//! A string in pieces between its ports ([`linear::cascade`]): at every port the waves that come
//! out of the pieces next to it leave a load line, and once the laws have met these, waves go in.

use linear::Cascade;
use linear::budget::REAL;

use super::chain::Chain;
pub(crate) use super::waves::Sums;
use super::waves::{EndKernel, LinkKernels, Responses, Waves};
use crate::error::SimulationError;
use crate::ranges::not_negative;
use crate::sampling::Sampling;
use crate::surface::{SurfaceProfile, convolved_with};

/// A string in pieces, and what its surface makes of it in every step per unit of the speed
/// that a scene names.
#[derive(Debug, Clone)]
pub(crate) struct Pieces {
    /// Every port by number, as all its sites are.
    pub(crate) ports: Vec<usize>,
    /// Within a step.
    pub(crate) chain: Chain,
    top: EndKernel,
    links: Vec<LinkKernels>,
    end: Option<EndKernel>,
    /// The wave that the surface sends down.
    sent: Vec<f64>,
    /// Torque that turns the surface, but for what waves from below add.
    torque: Vec<f64>,
    torque_by_wave: Responses<1>,
    /// The speed that the surface is set to.
    set: Vec<f64>,
    /// Speed of the surface, but for what waves from below add.
    speed: Vec<f64>,
    speed_by_wave: Option<Responses<1>>,
}

/// What turns the surface in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceStep {
    /// Its speed, rad/s.
    pub speed: f64,
    /// The torque that turns it, below a top drive that of its motor, N m.
    pub torque: f64,
}

/// The waves of a case.
#[derive(Debug)]
pub(crate) struct PiecesPast<'a> {
    pieces: &'a Pieces,
    /// Waves up from the uppermost port, that come back, make a torque at the surface and turn it.
    up: Waves<'a, 1>,
    makes_torque: Waves<'a, 1>,
    turns: Option<Waves<'a, 1>>,
    /// Into top and bottom of each link.
    into: Vec<Waves<'a, 2>>,
    /// Down from the lowest.
    down: Option<Waves<'a, 1>>,
    /// What comes out of each port in this step but for what goes in within it.
    out_of_top: f64,
    out_of: Vec<[f64; 2]>,
    out_of_end: f64,
    surface_speed: f64,
    pub(crate) surface: SurfaceStep,
}

/// Series of the surface for each step: set speed, wave, torque and speed, and what the sums that
/// they are made by hold at the same time.
const SERIES: f64 = 8.0;

/// Responses of waves into a single port: up from the uppermost, and down from the lowest.
const INTO_ONE: f64 = 4.0;

/// Numbers for each port that a case holds: speeds, torques, what drives it, its law and its motion.
const PORT: f64 = 32.0;

impl Pieces {
    /// Bytes of a number of ports, of responses of a number of taps, for a number of steps.
    pub(crate) fn bytes(ports: usize, taps: usize, steps: f64, sums: Sums) -> f64 {
        let of_links = ports as f64 * Responses::<2>::bytes(taps, sums);
        of_links + INTO_ONE * Responses::<1>::bytes(taps, sums) + REAL * SERIES * steps
    }

    /// Bytes of a case of a number of steps.
    pub(crate) fn past_bytes(ports: usize, taps: usize, steps: f64, sums: Sums) -> f64 {
        let of_port = Responses::<2>::past_bytes(taps, steps, sums) + REAL * PORT;
        ports as f64 * of_port + INTO_ONE * Responses::<1>::past_bytes(taps, steps, sums)
    }

    /// Prepares a string in pieces for a surface that turns by a profile; a motor that holds the
    /// speed at any torque has this inertia, kg m².
    pub(crate) fn new(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        profile.check()?;
        not_negative("inertia of the rotor in kg m²", rotor_inertia)?;
        let sampling = Sampling::new(cascade.sampling_frequency, 0.0);
        let steps = (cascade.longest_time * sampling.frequency).ceil() as usize + 1;
        let set: Vec<f64> = (0..steps)
            .map(|step| profile.at(sampling.time_of(step)))
            .collect();
        let sums = Sums::of(cascade.loss_has_memory);
        let top = EndKernel::new(cascade.top.impedance, &cascade.top.reflection, sums);
        let links = cascade.links.iter();
        let links: Vec<_> = links.map(|link| LinkKernels::new(link, sums)).collect();
        let end =
            (cascade.end.as_ref()).map(|end| EndKernel::new(end.impedance, &end.reflection, sums));
        let mut torque = convolved_with(&cascade.top.torque_by_set, &set);
        if rotor_inertia > 0.0 {
            for (step, torque) in torque.iter_mut().enumerate() {
                *torque += rotor_inertia * profile.acceleration(sampling.time_of(step));
            }
        }
        let (speed, speed_by_wave) = match &cascade.top.speed {
            None => (set.clone(), None),
            Some([by_set, by_wave]) => {
                let by_wave = Responses::new(&[by_wave], sums);
                (convolved_with(by_set, &set), Some(by_wave))
            }
        };
        Ok(Self {
            ports: (0..cascade.nodes.len()).collect(),
            chain: chain(&top, &links, end.as_ref()),
            sent: convolved_with(&cascade.top.sent, &set),
            torque,
            torque_by_wave: Responses::new(&[&cascade.top.torque_by_wave], sums),
            set,
            speed,
            speed_by_wave,
            top,
            links,
            end,
        })
    }

    /// Steps until the speed that the surface is set to stays within a part of its last.
    pub(crate) fn steady_from(&self, part: f64) -> usize {
        let last = self.set.last().copied().unwrap_or(0.0);
        let is_off = |speed: &f64| (speed - last).abs() > part * last.abs();
        self.set.iter().rposition(is_off).map_or(0, |step| step + 1)
    }
}

fn chain(top: &EndKernel, links: &[LinkKernels], end: Option<&EndKernel>) -> Chain {
    let mut own = vec![0.0; links.len() + 1];
    let mut next = vec![0.0; links.len()];
    own[0] = top.stiffness();
    for (port, link) in links.iter().enumerate() {
        let [above, between, below] = link.stiffness();
        own[port] += above;
        own[port + 1] += below;
        next[port] = between;
    }
    if let Some(last) = own.last_mut() {
        *last += end.map_or(0.0, EndKernel::stiffness);
    }
    Chain { own, next }
}

impl<'a> PiecesPast<'a> {
    /// At rest, before a number of steps at most.
    pub(crate) fn empty(pieces: &'a Pieces, steps: usize) -> Self {
        let (by_wave, end) = (pieces.speed_by_wave.as_ref(), pieces.end.as_ref());
        let links = pieces.links.iter();
        Self {
            pieces,
            up: pieces.top.reflection.none(steps),
            makes_torque: pieces.torque_by_wave.none(steps),
            turns: by_wave.map(|by_wave| by_wave.none(steps)),
            into: links.map(|link| link.responses.none(steps)).collect(),
            down: end.map(|end| end.reflection.none(steps)),
            out_of_top: 0.0,
            out_of: vec![[0.0; 2]; pieces.links.len()],
            out_of_end: 0.0,
            surface_speed: 0.0,
            surface: SurfaceStep {
                speed: 0.0,
                torque: 0.0,
            },
        }
    }

    /// What comes out of the pieces, and with which torques that drives the ports: at each
    /// f = (stiffness) v − 2 (1 + S(0))⁻¹ b.
    pub(crate) fn write_driving(
        &mut self,
        step: usize,
        surface_speed: Option<f64>,
        driving: &mut [f64],
    ) {
        let pieces = self.pieces;
        self.surface_speed = surface_speed.unwrap_or(0.0);
        driving.fill(0.0);
        let sent = self.surface_speed * pieces.sent[step];
        self.out_of_top = sent + self.up.out()[0];
        driving[0] = 2.0 * pieces.top.inverse() * self.out_of_top;
        for (port, (link, into)) in pieces.links.iter().zip(&self.into).enumerate() {
            let out = into.out();
            let drives = link.solved(out);
            driving[port] += 2.0 * drives[0];
            driving[port + 1] += 2.0 * drives[1];
            self.out_of[port] = out;
        }
        let end = pieces.end.as_ref().zip(self.down.as_ref());
        if let (Some((end, down)), Some(last)) = (end, driving.last_mut()) {
            [self.out_of_end] = down.out();
            *last += 2.0 * end.inverse() * self.out_of_end;
        }
    }

    /// The waves that go into the pieces, (1 + S(0))⁻¹ (Z v − b), and what they do at the surface.
    pub(crate) fn send_waves(&mut self, step: usize, speed: impl Fn(usize) -> f64) {
        let pieces = self.pieces;
        let top = &pieces.top;
        let up = top.inverse() * (top.impedance * speed(0) - self.out_of_top);
        let scale = self.surface_speed;
        let by_wave = |responses: &Responses<1>, waves: &mut Waves<'_, 1>| {
            let [past] = waves.out();
            waves.push([up]);
            past + responses.instant(0, 0) * up
        };
        let turns = pieces.speed_by_wave.as_ref().zip(self.turns.as_mut());
        self.surface = SurfaceStep {
            torque: scale * pieces.torque[step]
                + by_wave(&pieces.torque_by_wave, &mut self.makes_torque),
            speed: scale * pieces.speed[step]
                + turns.map_or(0.0, |(responses, waves)| by_wave(responses, waves)),
        };
        self.up.push([up]);
        let ports = self.into.iter_mut().zip(&self.out_of);
        for (port, (link, (into, out))) in pieces.links.iter().zip(ports).enumerate() {
            let wave = |end: usize| link.impedance * speed(port + end) - out[end];
            into.push(link.solved([wave(0), wave(1)]));
        }
        if let Some((end, down)) = pieces.end.as_ref().zip(self.down.as_mut()) {
            let speed = speed(pieces.links.len());
            down.push([end.inverse() * (end.impedance * speed - self.out_of_end)]);
        }
    }

    /// Torques in the string in the last step just above and just below each port, N m, positive
    /// where what is above turns what is below, with its speeds and torques. A piece turns its lower
    /// end with −f, and f = a − b and a + b = Z v leave Z v − 2 a of that.
    pub(crate) fn string_torques(
        &self,
        speeds: &[f64],
        torques: impl Iterator<Item = f64>,
    ) -> impl Iterator<Item = [f64; 2]> {
        let top = (self.pieces.top.impedance, self.up.last(0));
        let links = std::iter::zip(&self.pieces.links, &self.into);
        let links = links.map(|(link, into)| (link.impedance, into.last(1)));
        let ports = std::iter::once(top).chain(links);
        let loaded = std::iter::zip(speeds, torques);
        std::iter::zip(ports, loaded).map(|((impedance, wave), (speed, torque))| {
            let above = impedance * speed - 2.0 * wave;
            [above, above + torque]
        })
    }
}
