//! A string in pieces between its ports ([`linear::cascade`]): at every port the waves that come
//! out of the pieces next to it leave a load line, and once the laws have met these, waves go in.

use linear::Cascade;
use linear::budget::REAL;

use super::chain::Chain;
use super::waves::{EndKernel, LinkKernels, Waves};
use crate::convolution::Kernel;
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
    torque_by_wave: Kernel,
    /// The speed that the surface is set to.
    set: Vec<f64>,
    /// Speed of the surface, but for what waves from below add.
    speed: Vec<f64>,
    speed_by_wave: Option<Kernel>,
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
    /// Waves that have gone into the ports: up from the uppermost, into top and bottom of each
    /// link, and down from the lowest.
    up: Waves,
    into: Vec<[Waves; 2]>,
    down: Waves,
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

/// Numbers for each port that a case holds: speeds, torques, what drives it, its law and its motion.
const PORT: f64 = 32.0;

impl Pieces {
    /// Bytes of a number of ports, of responses of a number of taps, for a number of steps.
    pub(crate) fn bytes(ports: usize, taps: usize, steps: f64) -> f64 {
        let kernels = LinkKernels::RESPONSES * (ports + 2);
        REAL * ((kernels * taps) as f64 + SERIES * steps)
    }

    /// Bytes of a case.
    pub(crate) fn past_bytes(ports: usize, taps: usize) -> f64 {
        let waves = 2 * Waves::room(taps);
        REAL * ports as f64 * (PORT + waves as f64)
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
        let top = EndKernel::new(cascade.top.impedance, &cascade.top.reflection);
        let links: Vec<LinkKernels> = cascade.links.iter().map(LinkKernels::new).collect();
        let end = (cascade.end.as_ref()).map(|end| EndKernel::new(end.impedance, &end.reflection));
        let mut torque = convolved_with(&cascade.top.torque_by_set, &set);
        if rotor_inertia > 0.0 {
            for (step, torque) in torque.iter_mut().enumerate() {
                *torque += rotor_inertia * profile.acceleration(sampling.time_of(step));
            }
        }
        let (speed, speed_by_wave) = match &cascade.top.speed {
            None => (set.clone(), None),
            Some([by_set, by_wave]) => (convolved_with(by_set, &set), Some(Kernel::new(by_wave))),
        };
        Ok(Self {
            ports: (0..cascade.nodes.len()).collect(),
            chain: chain(&top, &links, end.as_ref()),
            sent: convolved_with(&cascade.top.sent, &set),
            torque,
            torque_by_wave: Kernel::new(&cascade.top.torque_by_wave),
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
    /// At rest.
    pub(crate) fn empty(pieces: &'a Pieces) -> Self {
        let mut at_top = vec![&pieces.top.reflection, &pieces.torque_by_wave];
        at_top.extend(&pieces.speed_by_wave);
        let end: Vec<_> = pieces.end.iter().map(|end| &end.reflection).collect();
        let of_link = |link: &LinkKernels| {
            [
                Waves::none(&[&link.top, &link.across]),
                Waves::none(&[&link.across, &link.bottom]),
            ]
        };
        Self {
            pieces,
            up: Waves::none(&at_top),
            into: pieces.links.iter().map(of_link).collect(),
            down: Waves::none(&end),
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
        self.out_of_top = sent + self.up.sum(&pieces.top.reflection);
        driving[0] = 2.0 * pieces.top.inverse() * self.out_of_top;
        for (port, (link, [at_top, at_bottom])) in pieces.links.iter().zip(&self.into).enumerate() {
            let out = [
                at_top.sum(&link.top) + at_bottom.sum(&link.across),
                at_top.sum(&link.across) + at_bottom.sum(&link.bottom),
            ];
            let drives = link.solved(out);
            driving[port] += 2.0 * drives[0];
            driving[port + 1] += 2.0 * drives[1];
            self.out_of[port] = out;
        }
        if let (Some(end), Some(last)) = (&pieces.end, driving.last_mut()) {
            self.out_of_end = self.down.sum(&end.reflection);
            *last += 2.0 * end.inverse() * self.out_of_end;
        }
    }

    /// The waves that go into the pieces, (1 + S(0))⁻¹ (Z v − b), and what they do at the surface.
    pub(crate) fn send_waves(&mut self, step: usize, speed: impl Fn(usize) -> f64) {
        let pieces = self.pieces;
        let top = &pieces.top;
        let up = top.inverse() * (top.impedance * speed(0) - self.out_of_top);
        let scale = self.surface_speed;
        let by_wave = |kernel: &Kernel| self.up.sum(kernel) + kernel.instant() * up;
        self.surface = SurfaceStep {
            torque: scale * pieces.torque[step] + by_wave(&pieces.torque_by_wave),
            speed: scale * pieces.speed[step] + pieces.speed_by_wave.as_ref().map_or(0.0, by_wave),
        };
        self.up.push(up);
        let ports = self.into.iter_mut().zip(&self.out_of);
        for (port, (link, (into, out))) in pieces.links.iter().zip(ports).enumerate() {
            let wave = |end: usize| link.impedance * speed(port + end) - out[end];
            let [at_top, at_bottom] = link.solved([wave(0), wave(1)]);
            into[0].push(at_top);
            into[1].push(at_bottom);
        }
        if let Some(end) = &pieces.end {
            let speed = speed(pieces.links.len());
            self.down
                .push(end.inverse() * (end.impedance * speed - self.out_of_end));
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
        let top = (self.pieces.top.impedance, self.up.last());
        let links = std::iter::zip(&self.pieces.links, &self.into);
        let links = links.map(|(link, [_, at_bottom])| (link.impedance, at_bottom.last()));
        let ports = std::iter::once(top).chain(links);
        let loaded = std::iter::zip(speeds, torques);
        std::iter::zip(ports, loaded).map(|((impedance, wave), (speed, torque))| {
            let above = impedance * speed - 2.0 * wave;
            [above, above + torque]
        })
    }
}
