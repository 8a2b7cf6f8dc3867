//! The time history of one case, kept only where it is asked for.

use crate::laws::wall::Contact;

/// Samples at k / f_s, one entry a step; sites from the surface down.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trajectory {
    /// Rotation speed of each site, rad/s.
    pub speeds: Vec<Vec<f64>>,
    /// Torque on the bit, positive in the direction of rotation, N m; empty
    /// where the bit is free.
    pub bit_torque: Vec<f64>,
    /// Position of each site's centre, m; empty without lateral motion.
    pub positions: Vec<Vec<[f64; 2]>>,
    /// Force of the wall on each site, N; empty without lateral motion.
    pub wall_forces: Vec<Vec<[f64; 2]>>,
    /// All forces on each site, disturbances included, as
    /// `forces[axis][site][step]`, N; empty without lateral motion.
    pub forces: [Vec<Vec<f64>>; 2],
}

impl Trajectory {
    pub(crate) fn with_sites(sites: usize) -> Self {
        Self {
            speeds: vec![Vec::new(); sites],
            bit_torque: Vec::new(),
            positions: vec![Vec::new(); sites],
            wall_forces: vec![Vec::new(); sites],
            forces: Default::default(),
        }
    }

    pub(crate) fn push(&mut self, speeds: &[f64], contacts: &[Contact], bit_torque: Option<f64>) {
        for (site, contact) in contacts.iter().enumerate() {
            self.speeds[site].push(speeds[site]);
            self.positions[site].push(contact.position);
            self.wall_forces[site].push(contact.force);
        }
        self.bit_torque.extend(bit_torque);
    }
}
