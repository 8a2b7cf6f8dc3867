//! A uniform tube in closed form: what its bit does after a step of torque, and after
//! one of the surface's speed. Nothing here is shared with the filters.
//!
//! With α = c_t/(2ρJ) the rate at which its waves decay and τ the time of a wave along
//! it, γL = τ√(s(s + 2α)). An echo that has travelled for a time T adds, by
//!
//! (1/s)√(s/(s + 2α)) e^(−T√(s(s + 2α))) ↔ e^(−αt) I₀(α√(t² − T²)) u(t − T),
//! e^(−T√(s(s + 2α))) ↔ e^(−αT) δ(t − T) + e^(−αt) αT I₁(α√(t² − T²))/√(t² − T²) u(t − T),
//!
//! and tanh(γL)/Z and 1/cosh(γL), what a torque at the bit and the surface do to its speed,
//! are sums over echoes of alternating sign: of T = 2nτ, and of T = (2n + 1)τ.

use linear::estimates::{torsional_decay_rate, torsional_impedance, torsional_travel_time};
use linear::passivity::Ending;
use linear::{Channel, ChannelResponses, Drillstring, Method, Responses, Sites, parallel};

/// Taps last until waves have decayed to e^(−26), 5e-12.
const DECAY_TIMES: f64 = 26.0;

/// Where in a step it is integrated, in parts of it, by Gauss with two points: to the
/// fourth power of αΔt, which is below 1e-3.
const POINTS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// A uniform tube.
#[derive(Debug, Clone, Copy)]
pub struct UniformTube {
    /// Impedance Z₀, N m s/rad.
    impedance: f64,
    /// α, 1/s.
    decay: f64,
    /// τ, s.
    pub travel: f64,
}

impl UniformTube {
    /// A string that is one tube, in however many sections.
    pub fn of(string: &Drillstring) -> Self {
        Self {
            impedance: torsional_impedance(string, &string.sections()[0].parts[0]),
            decay: torsional_decay_rate(string),
            travel: torsional_travel_time(string),
        }
    }

    /// Δ of Eq. 75, rad/s per N m: the speed is lowest when the first echo, twice what
    /// damping leaves of it, has come back.
    pub fn undershoot(&self) -> f64 {
        let round_trip = 2.0 * self.travel;
        let passed = bessel(0, 0.25 * (self.decay * round_trip).powi(2));
        (-self.decay * round_trip).exp() * (2.0 - passed) / self.impedance
    }

    /// Speed of the bit, rad/s per N m, at a time (s) after a step of torque; just after
    /// the front where there is one.
    pub fn speed_after_torque(&self, time: f64) -> f64 {
        let echoes = self.echoes(time, 0.0).enumerate();
        let sum: f64 = echoes
            .map(|(index, travelled)| {
                let weight = if index == 0 { 1.0 } else { 2.0 * sign(index) };
                weight * bessel(0, self.argument(time, travelled))
            })
            .sum();
        (-self.decay * time).exp() * sum / self.impedance
    }

    /// How fast that changes, 1/s, at a time after a step of the surface's speed, between
    /// fronts.
    fn change_after_surface(&self, time: f64) -> f64 {
        let echoes = self.echoes(time, 1.0).enumerate();
        let sum: f64 = echoes
            .map(|(index, travelled)| {
                sign(index) * travelled * bessel(1, self.argument(time, travelled))
            })
            .sum();
        // I₁(x)/x is half of the series, and there are two of each echo.
        (-self.decay * time).exp() * self.decay.powi(2) * sum
    }

    /// The times that echoes have travelled until a time, s, for the first travel times.
    fn echoes(&self, time: f64, first: f64) -> impl Iterator<Item = f64> {
        let all = (0..).map(move |index| (first + 2.0 * f64::from(index)) * self.travel);
        all.take_while(move |travelled| *travelled <= time)
    }

    /// (α/2)²(t² − T²).
    fn argument(&self, time: f64, travelled: f64) -> f64 {
        0.25 * self.decay.powi(2) * (time - travelled) * (time + travelled)
    }

    /// Mean speeds over steps of τ/`steps_to_bit` under loads held over them. Fronts come
    /// at ends of steps.
    pub fn responses(
        &self,
        string: &Drillstring,
        steps_to_bit: usize,
        longest_time: f64,
    ) -> Responses {
        let step = self.travel / steps_to_bit as f64;
        let count = (DECAY_TIMES / (self.decay * step)).ceil() as usize;
        Responses {
            string: string.id(),
            method: Method::Held,
            sites: Sites::bit(),
            sampling_frequency: 1.0 / step,
            longest_time,
            channels: vec![ChannelResponses {
                channel: Channel::Torsion,
                loads: vec![0],
                from_surface: vec![changes(&self.means_after_surface(steps_to_bit, count))],
                from_loads: vec![vec![changes(&self.means_after_torque(step, count))]],
                ending: Ending::Whole,
            }],
        }
    }

    fn means_after_torque(&self, step: f64, count: usize) -> Vec<f64> {
        let speed = |place: f64| self.speed_after_torque(place * step);
        parallel::map(count, 1, |index| {
            let at = POINTS.map(|point| speed(index as f64 + point));
            0.5 * (at[0] + at[1])
        })
    }

    fn means_after_surface(&self, steps_to_bit: usize, count: usize) -> Vec<f64> {
        let step = self.travel / steps_to_bit as f64;
        // By how much the speed grows in a step, and the mean of how much it has grown.
        let grown: Vec<[f64; 2]> = parallel::map(count, 1, |index| {
            let at = POINTS.map(|point| {
                let change = self.change_after_surface((index as f64 + point) * step);
                0.5 * step * change
            });
            let mean = at[0] * (1.0 - POINTS[0]) + at[1] * (1.0 - POINTS[1]);
            [at[0] + at[1], mean]
        });
        let mut speed = 0.0;
        (grown.iter().enumerate())
            .map(|(index, [whole, mean])| {
                speed += self.front_after_surface(index, steps_to_bit);
                let mean = speed + mean;
                speed += whole;
                mean
            })
            .collect()
    }

    /// The front with which a step begins, of those that come every other travel time.
    fn front_after_surface(&self, index: usize, steps_to_bit: usize) -> f64 {
        let travels = index / steps_to_bit;
        if index % steps_to_bit != 0 || travels % 2 == 0 {
            return 0.0;
        }
        2.0 * sign(travels / 2) * (-self.decay * travels as f64 * self.travel).exp()
    }
}

/// Echoes alternate.
fn sign(index: usize) -> f64 {
    if index % 2 == 0 { 1.0 } else { -1.0 }
}

/// Differences from one to the next, from rest.
fn changes(means: &[f64]) -> Vec<f64> {
    let before = std::iter::once(&0.0).chain(means);
    means
        .iter()
        .zip(before)
        .map(|(mean, before)| mean - before)
        .collect()
}

/// Σ q^k/(k! (k + n)!), of which I_n(x) is (x/2)^n times that at q = x²/4. All terms are
/// positive, so that nothing cancels.
fn bessel(order: u32, q: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 1.0);
    let mut index = 1.0;
    while term > f64::EPSILON * sum {
        term *= q / (index * (index + f64::from(order)));
        sum += term;
        index += 1.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use linear::deviation::exact_undershoot;
    use linear::estimates::largest_undershoot;
    use linear::waves::inversion::time_response;
    use linear::waves::network::TorsionNetwork;
    use linear::{Complex64, RaisedCosine};

    use super::*;
    use crate::scenes::shipped;

    fn string() -> Drillstring {
        shipped("uniform_tube.toml").unwrap().setting.string
    }

    /// By the tables.
    #[test]
    fn the_series_is_that_of_bessels_functions() {
        for (x, first, second) in [
            (0.0, 1.0, 0.0),
            (1.0, 1.266_065_877_752_008_4, 0.565_159_103_992_485),
            (5.0, 27.239_871_823_604_44, 24.335_642_142_450_53),
            (20.0, 43_558_282.559_553_53, 42_454_973.385_127_78),
        ] {
            let q = 0.25 * x * x;
            assert!((bessel(0, q) - first).abs() <= 1e-14 * first, "{x}");
            let found = 0.5 * x * bessel(1, q);
            assert!((found - second).abs() <= 1e-14 * second.max(1.0), "{x}");
        }
    }

    /// The exact waves, inverted: both responses seen through a window of 20 ms, steps
    /// apart and off the fronts.
    #[test]
    fn the_closed_form_is_the_inverse_of_the_exact_waves() {
        let (string, window) = (string(), RaisedCosine { duration: 0.02 });
        let tube = UniformTube::of(&string);
        let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
        let (steps_to_bit, count) = (400, 4000);
        let responses = tube.responses(&string, steps_to_bit, 1.0);
        let torsion = responses.torsion().unwrap();
        let step = 1.0 / responses.sampling_frequency;
        type Response<'a> = (&'a [f64], &'a (dyn Fn(Complex64) -> Complex64 + Sync), f64);
        let from_torque = |s| network.admittance(s).from_torque[(0, 0)];
        let from_surface = |s| network.admittance(s).from_surface[0];
        let both: [Response; 2] = [
            (
                &torsion.from_loads[0][0],
                &from_torque,
                1.0 / tube.impedance,
            ),
            (&torsion.from_surface[0], &from_surface, 2.0),
        ];
        for (taps, response, scale) in both {
            let exact = |s: Complex64| response(s) * window.transform(s) / s;
            let exact = time_response(exact, step, count, 8);
            // In the middle of a step, as its loads are.
            let input = |lag: usize| window.integral((lag as f64 + 0.5) * step);
            let middle = |now: usize| 0.5 * (exact[now] + exact[now + 1]);
            for now in (50..count - 1).step_by(37) {
                let sum: f64 = (0..=now).map(|lag| taps[lag] * input(now - lag)).sum();
                assert!((sum - middle(now)).abs() < 1e-3 * scale, "{now}: {sum}");
            }
        }
    }

    #[test]
    fn the_bit_swings_back_furthest_with_the_first_echo() {
        let string = string();
        let tube = UniformTube::of(&string);
        let undershoot = tube.undershoot();
        assert!((undershoot / 2.8568e-5 - 1.0).abs() < 1e-4, "{undershoot}");
        let after = tube.speed_after_torque(2.0 * tube.travel * (1.0 + 1e-9));
        assert!((after / -undershoot - 1.0).abs() < 1e-6, "{after}");
        let later = (1..40_000).map(|index| tube.speed_after_torque(1e-3 * f64::from(index)));
        assert!(later.fold(0.0, f64::min) >= -undershoot);
        let on_a_lattice = exact_undershoot(&string).unwrap();
        assert!((on_a_lattice / undershoot - 1.0).abs() < 1e-3);
        let responses = tube.responses(&string, 1000, 1.0);
        let in_steps = largest_undershoot(responses.at_bit().unwrap());
        assert!((in_steps / undershoot - 1.0).abs() < 1e-3);
    }

    /// In the end the bit turns as fast as the surface, and torque winds the string up.
    #[test]
    fn taps_sum_to_what_is_static() {
        let string = string();
        let responses = UniformTube::of(&string).responses(&string, 50, 1.0);
        let torsion = responses.torsion().unwrap();
        let speed: f64 = torsion.from_surface[0].iter().sum();
        assert!((speed - 1.0).abs() < 1e-8, "{speed}");
        let turned = torsion.from_loads[0][0].iter().scan(0.0, |speed, tap| {
            *speed += tap;
            Some(*speed / responses.sampling_frequency)
        });
        let stiffness = linear::estimates::torsional_stiffness(&string);
        let turned = stiffness * turned.sum::<f64>();
        assert!((turned - 1.0).abs() < 1e-6, "{turned}");
    }
}
