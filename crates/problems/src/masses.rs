//! A row of pipes as masses and springs in small steps: torsion by nothing but Newton and Hooke,
//! without a wave, a response or a scheme of the library.

use crate::pipes;

/// A string of `pipes::pipe`, clamped to a surface that turns, its lower end free.
pub struct MassesAndSprings {
    /// Inertia of a mass, kg m².
    pub inertia: f64,
    /// Length of string that is one mass, m.
    pub piece: f64,
    /// Stiffness between two masses, N m/rad.
    spring: f64,
    /// Time of a step, s.
    step: f64,
    /// Angles of the masses from the surface down, rad.
    angles: Vec<f64>,
    /// Their speeds, rad/s.
    speeds: Vec<f64>,
}

impl MassesAndSprings {
    /// At rest: a length (m) as masses, in steps of a time (s).
    pub fn new(length: f64, masses: usize, step: f64) -> Self {
        let tube = pipes::pipe(length / masses as f64);
        Self {
            inertia: pipes::STEEL.density * tube.polar_moment() * tube.length,
            piece: tube.length,
            spring: pipes::STEEL.shear_modulus * tube.polar_moment() / tube.length,
            step,
            angles: vec![0.0; masses],
            speeds: vec![0.0; masses],
        }
    }

    /// Torques in the springs, N m, with the surface at an angle (rad): that of the surface first,
    /// and last the none below the lowest mass.
    pub fn torques(&self, surface: f64) -> Vec<f64> {
        // A mass is in the middle of its piece: half a piece is twice as stiff.
        let first = 2.0 * self.spring * (surface - self.angles[0]);
        let others = (self.angles.windows(2)).map(|ends| self.spring * (ends[0] - ends[1]));
        std::iter::once(first).chain(others).chain([0.0]).collect()
    }

    /// One step with these torques in the springs: `speed_after(mass, speed, torque)` is the speed
    /// of a mass after it, from its speed before and the torque of the springs on it.
    pub fn step(&mut self, torques: &[f64], mut speed_after: impl FnMut(usize, f64, f64) -> f64) {
        for mass in 0..self.angles.len() {
            let torque = torques[mass] - torques[mass + 1];
            self.speeds[mass] = speed_after(mass, self.speeds[mass], torque);
            self.angles[mass] += self.step * self.speeds[mass];
        }
    }
}
