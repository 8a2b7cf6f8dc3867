//! A waveguide in the middle of a steady winding: the bit is held, the surface turns, and the
//! torque grows everywhere at one rate. The speed falls from the surface to the bit as the
//! flexibility above grows; dampers between take their part of the torque. The same motion as a
//! sweep begins with, from the pieces of the waveguide alone.

/// Pieces of one impedance between two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Reach {
    /// Steps of travel.
    pub pieces: usize,
    /// N m s/rad.
    pub impedance: f64,
    /// Damping of half of it, at either end, N m s/rad.
    pub damping: f64,
}

/// The winding.
pub struct Wound {
    /// Waves in speed on their way down and up, in the order in which they arrive, reach by reach.
    pub down: Vec<f64>,
    pub up: Vec<f64>,
    /// Speed of the surface, rad/s.
    pub surface_speed: f64,
    /// Torque that turns it in the first step, N m, and what is added to it in every step.
    pub surface_torque: f64,
    pub torque_per_step: f64,
}

impl Wound {
    /// Reaches from the surface down, in steps of `step` (s), the surface set to a speed (rad/s) and
    /// the bit held by `torque` (N m) in the first step; `integral_gain` is that of a drive, N m/rad.
    pub fn new(
        reaches: &[Reach],
        step: f64,
        set_speed: f64,
        torque: f64,
        integral_gain: Option<f64>,
    ) -> Self {
        let flexibility = |reach: &Reach| reach.pieces as f64 * step / reach.impedance;
        let whole: f64 = reaches.iter().map(flexibility).sum();
        let rate = set_speed / (whole + integral_gain.map_or(0.0, |gain| 1.0 / gain));
        // Speeds and torques at the lower ends, from the bit upwards.
        let (mut speed, mut carried) = (0.0, torque);
        let mut waves = Vec::new();
        for (place, reach) in reaches.iter().enumerate().rev() {
            let above = speed + rate * flexibility(reach);
            let of_reach = (0..reach.pieces).map(|arrives| {
                let left = (arrives as f64 - reach.pieces as f64) * step;
                let share = (carried + rate * left) / reach.impedance;
                [0.5 * (above + share), 0.5 * (speed - share)]
            });
            waves.push(of_reach.collect::<Vec<_>>());
            let next = place
                .checked_sub(1)
                .map_or(0.0, |next| reaches[next].damping);
            speed = above;
            carried += (reach.damping + next) * speed;
        }
        let waves: Vec<[f64; 2]> = waves.into_iter().rev().flatten().collect();
        Self {
            down: waves.iter().map(|[down, _]| *down).collect(),
            up: waves.iter().map(|[_, up]| *up).collect(),
            surface_speed: speed,
            surface_torque: carried,
            torque_per_step: rate * step,
        }
    }
}
