//! Waves into the ports of a piece, over time, and what comes out of these.

use linear::budget::REAL;

use crate::convolution::{Convolution, Kernel, Kernels};

/// How the waves of a case so far are summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sums {
    /// Term by term, where responses last about as long as a wave takes through a piece.
    Direct,
    /// By blocks, where loss has a memory and responses last as long as a case.
    ByBlocks,
}

impl Sums {
    /// Those of a string whose loss has a memory or not.
    pub(crate) fn of(loss_has_memory: bool) -> Self {
        match loss_has_memory {
            true => Self::ByBlocks,
            false => Self::Direct,
        }
    }
}

/// Responses between the ports of a piece. From one to the other is as back, so that the sum of the
/// numbers of two ports is the number of the response: of two `[top, across, bottom]`.
#[derive(Debug, Clone)]
pub(super) enum Responses<const PORTS: usize> {
    Direct(Vec<Kernel>),
    ByBlocks(Box<Kernels>),
}

/// The waves of a case into the ports of a piece.
#[derive(Debug)]
pub(super) enum Waves<'a, const PORTS: usize> {
    Direct(&'a [Kernel], [Recent; PORTS]),
    ByBlocks(Box<Convolution<'a>>),
}

impl<const PORTS: usize> Responses<PORTS> {
    /// Number of different ones.
    const COUNT: usize = PORTS * (PORTS + 1) / 2;

    /// Of their taps.
    pub(super) fn new(taps: &[&[f64]], sums: Sums) -> Self {
        match sums {
            Sums::Direct => Self::Direct(taps.iter().map(|taps| Kernel::new(taps)).collect()),
            Sums::ByBlocks => {
                let to = |output: usize| (0..PORTS).map(|input| taps[output + input]).collect();
                let square: Vec<Vec<&[f64]>> = (0..PORTS).map(to).collect();
                Self::ByBlocks(Box::new(Kernels::of(&square)))
            }
        }
    }

    /// What one of them does within a step.
    pub(super) fn instant(&self, output: usize, input: usize) -> f64 {
        match self {
            Self::Direct(kernels) => kernels[output + input].instant(),
            Self::ByBlocks(kernels) => kernels.instant(output, input),
        }
    }

    /// No waves yet, of a case of a number of steps at most.
    pub(super) fn none(&self, steps: usize) -> Waves<'_, PORTS> {
        match self {
            Self::Direct(kernels) => {
                let reach = kernels.iter().map(Kernel::memory).max().unwrap_or(0);
                let none = std::array::from_fn(|_| Recent::none(reach));
                Waves::Direct(kernels, none)
            }
            Self::ByBlocks(kernels) => {
                Waves::ByBlocks(Box::new(Convolution::new(kernels, 1, steps)))
            }
        }
    }

    /// Bytes of responses of a number of taps.
    pub(super) fn bytes(taps: usize, sums: Sums) -> f64 {
        match sums {
            Sums::Direct => REAL * (Self::COUNT * taps) as f64,
            Sums::ByBlocks => Kernels::bytes(PORTS, taps, false),
        }
    }

    /// Bytes of the waves of a number of steps.
    pub(super) fn past_bytes(taps: usize, steps: f64, sums: Sums) -> f64 {
        match sums {
            Sums::Direct => REAL * (PORTS * Recent::room(taps)) as f64,
            Sums::ByBlocks => Convolution::bytes(PORTS, 1, taps, steps),
        }
    }
}

impl<const PORTS: usize> Waves<'_, PORTS> {
    /// What the waves so far make come out.
    pub(super) fn out(&self) -> [f64; PORTS] {
        match self {
            Self::Direct(kernels, into) => std::array::from_fn(|output| {
                let from = |input: usize| kernels[output + input].past_sum(&into[input].values);
                (0..PORTS).map(from).sum()
            }),
            Self::ByBlocks(convolution) => {
                let mut sums = [0.0; PORTS];
                convolution.write_past(&mut sums);
                sums
            }
        }
    }

    /// Ends a step with what goes in.
    pub(super) fn push(&mut self, waves: [f64; PORTS]) {
        match self {
            Self::Direct(_, into) => {
                for (into, wave) in into.iter_mut().zip(waves) {
                    into.push(wave);
                }
            }
            Self::ByBlocks(convolution) => convolution.add(&waves),
        }
    }

    /// What went in last at a port.
    pub(super) fn last(&self, port: usize) -> f64 {
        let values = match self {
            Self::Direct(_, into) => &into[port].values,
            Self::ByBlocks(convolution) => convolution.inputs(0, port),
        };
        values.last().copied().unwrap_or(0.0)
    }
}

/// Waves as far back as responses look.
#[derive(Debug)]
pub(super) struct Recent {
    values: Vec<f64>,
    reach: usize,
}

impl Recent {
    fn none(reach: usize) -> Self {
        Self {
            values: Vec::with_capacity(Self::room(reach)),
            reach,
        }
    }

    /// Values after which those that nothing looks at any more are forgotten.
    fn room(reach: usize) -> usize {
        4 * reach + 64
    }

    fn push(&mut self, value: f64) {
        if self.values.len() == Self::room(self.reach) {
            self.values.drain(..self.values.len() - self.reach);
        }
        self.values.push(value);
    }
}

/// A piece between two nodes: what comes out at its ends.
#[derive(Debug, Clone)]
pub(super) struct LinkKernels {
    pub(super) impedance: f64,
    pub(super) responses: Responses<2>,
    /// (1 + S(0))⁻¹, which is symmetric: `[top, across, bottom]`.
    inverse: [f64; 3],
}

impl LinkKernels {
    pub(super) fn new(link: &linear::cascade::Link, sums: Sums) -> Self {
        let responses = Responses::<2>::new(&[&link.top, &link.across, &link.bottom], sums);
        let [s, m, t] = [(0, 0), (0, 1), (1, 1)].map(|(to, from)| responses.instant(to, from));
        let determinant = (1.0 + s) * (1.0 + t) - m * m;
        Self {
            impedance: link.impedance,
            inverse: [
                (1.0 + t) / determinant,
                -m / determinant,
                (1.0 + s) / determinant,
            ],
            responses,
        }
    }

    /// Torques per speed within a step: at the top, between both ends, at the bottom. From
    /// f = Z v − 2 b and a + b = Z v they are Z (2 (1 + S(0))⁻¹ − 1).
    pub(super) fn stiffness(&self) -> [f64; 3] {
        let [top, across, bottom] = self.inverse;
        let z = self.impedance;
        [
            z * (2.0 * top - 1.0),
            z * 2.0 * across,
            z * (2.0 * bottom - 1.0),
        ]
    }

    /// (1 + S(0))⁻¹ of a pair.
    pub(super) fn solved(&self, [at_top, at_bottom]: [f64; 2]) -> [f64; 2] {
        let [top, across, bottom] = self.inverse;
        [
            top * at_top + across * at_bottom,
            across * at_top + bottom * at_bottom,
        ]
    }
}

/// What ends the string at a node.
#[derive(Debug, Clone)]
pub(super) struct EndKernel {
    pub(super) impedance: f64,
    pub(super) reflection: Responses<1>,
}

impl EndKernel {
    pub(super) fn new(impedance: f64, reflection: &[f64], sums: Sums) -> Self {
        Self {
            impedance,
            reflection: Responses::new(&[reflection], sums),
        }
    }

    /// (1 + S(0))⁻¹.
    pub(super) fn inverse(&self) -> f64 {
        1.0 / (1.0 + self.reflection.instant(0, 0))
    }

    /// Torque per speed within a step.
    pub(super) fn stiffness(&self) -> f64 {
        self.impedance * (2.0 * self.inverse() - 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use linear::{Cascade, Drillstring, Method, Sites, TopDrive};
    use problems::pipes::STEEL;
    use problems::wells::{Draw, Well, with_loss};

    const TIME: f64 = 20.0;
    const STRINGS: usize = 12;

    /// A string that loses energy to mud and in its joints, below a drive or none, in pieces.
    fn cascade(number: usize, draw: &mut Draw) -> Cascade {
        let sections = Well::draw(number, draw).string.sections().to_vec();
        let string = with_loss(&Drillstring::new(STEEL, sections, 0.0).unwrap(), draw);
        let drive = TopDrive {
            inertia: draw.log_uniform(500.0, 5000.0),
            proportional_gain: draw.log_uniform(100.0, 1e4),
            integral_gain: draw.log_uniform(100.0, 1e4),
            delay: 0.0,
            late_inertia: 0.0,
        };
        let string = match number % 2 {
            0 => string,
            _ => string.with_top_drive(drive).unwrap(),
        };
        let method = match number % 4 {
            0 | 1 => Method::Quadrature,
            _ => Method::FiniteElement(Default::default()),
        };
        let places = [0.9, 0.5, 0.45, 0.2].map(|part| part * string.length());
        let nodes = Sites::new(&string, &places).unwrap();
        let frequency = draw.log_uniform(20.0, 150.0);
        Cascade::new(&string, &method, &nodes, frequency, TIME).unwrap()
    }

    /// Waves in of many kinds: without pattern, steady, slow, a start, or at one port alone.
    fn waves<const PORTS: usize>(kind: usize, steps: usize, draw: &mut Draw) -> Vec<[f64; PORTS]> {
        let period = draw.log_uniform(4.0, 2.0 * steps as f64);
        let mut wave = |step: usize, port: usize| match kind {
            0 => draw.uniform(-1.0, 1.0),
            1 => 1.0,
            2 => (std::f64::consts::TAU * step as f64 / period).sin(),
            3 => (step as f64 / period).min(1.0),
            _ => [1.0, 0.0][port],
        };
        (0..steps)
            .map(|step| std::array::from_fn(|port| wave(step, port)))
            .collect()
    }

    const KINDS: usize = 5;

    /// The waves that come out in every step.
    fn out<const PORTS: usize>(
        taps: &[&[f64]],
        sums: Sums,
        waves: &[[f64; PORTS]],
    ) -> Vec<[f64; PORTS]> {
        let responses = Responses::<PORTS>::new(taps, sums);
        let mut past = responses.none(waves.len());
        let each = waves.iter().map(|into| {
            let mut out = past.out();
            for (port, out) in out.iter_mut().enumerate() {
                let within = |from: usize| responses.instant(port, from) * into[from];
                *out += (0..PORTS).map(within).sum::<f64>();
            }
            past.push(*into);
            assert_eq!(past.last(PORTS - 1), into[PORTS - 1]);
            out
        });
        each.collect()
    }

    fn energy<const PORTS: usize>(waves: &[f64; PORTS]) -> f64 {
        waves.iter().map(|wave| wave * wave).sum()
    }

    /// Waves of all kinds through a piece: by blocks the same come out as term by term, and with no
    /// more energy than went in until then. The most that was left of it.
    fn most_left<const PORTS: usize>(taps: &[&[f64]], steps: usize, draw: &mut Draw) -> f64 {
        let mut most: f64 = 0.0;
        for kind in 0..KINDS {
            let waves = waves::<PORTS>(kind, steps, draw);
            let [direct, by_blocks] =
                [Sums::Direct, Sums::ByBlocks].map(|sums| out(taps, sums, &waves));
            let mut energies = [0.0; 2];
            for (step, into) in waves.iter().enumerate() {
                for port in 0..PORTS {
                    let (found, expected) = (by_blocks[step][port], direct[step][port]);
                    let off = (found - expected).abs();
                    assert!(off < 1e-12, "{kind} {step}: {found} {expected}");
                }
                energies[0] += energy(into);
                energies[1] += energy(&by_blocks[step]);
                let [went_in, came_out] = energies;
                assert!(
                    came_out <= went_in * (1.0 + CUT_OFF),
                    "{kind} {step}: {came_out} {went_in}"
                );
            }
            most = most.max(energies[1] / energies[0]);
        }
        most
    }

    /// What taps that are cut off may leave, as a part of the energy.
    const CUT_OFF: f64 = 1e-8;

    /// Every piece of random strings in mud, with what ends them: summed by blocks, a memory of
    /// thousands of steps is the direct sum, and gives back no energy that it did not take.
    #[test]
    fn a_long_memory_by_blocks_is_the_direct_sum_and_makes_no_energy() {
        let (mut most, mut longest): (f64, usize) = (0.0, 0);
        for number in 0..STRINGS {
            let mut draw = Draw::new(number);
            let cascade = cascade(number, &mut draw);
            assert!(cascade.loss_has_memory);
            longest = longest.max(cascade.longest_response());
            let steps = (cascade.sampling_frequency * TIME) as usize;
            for link in &cascade.links {
                let taps = [&link.top, &link.across, &link.bottom].map(Vec::as_slice);
                most = most.max(most_left::<2>(&taps, steps, &mut draw));
            }
            let ends = cascade.end.iter().map(|end| &end.reflection);
            for taps in ends.chain([&cascade.top.reflection]) {
                most = most.max(most_left::<1>(&[taps], steps, &mut draw));
            }
        }
        assert!(longest > 1000, "{longest}");
        // Some lose so little that any more would be seen.
        assert!(most > 0.99, "{most}");
    }
}
