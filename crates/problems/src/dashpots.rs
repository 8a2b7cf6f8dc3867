//! Strings whose upper end sends back a part of each wave, in torsion and along the axis: what a
//! bit that cuts does below them, independent programs know.

use linear::estimates::torsional_impedance;
use linear::{Axial, Drillstring, Hoist, Material, Section, TopDrive, Tube};

/// What they are made of.
pub const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

/// Young's modulus of that, Pa.
pub const YOUNGS_MODULUS: f64 = 210e9;

/// Drillpipe of a length, m.
pub fn pipe(length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.054,
        outer_radius: 0.0635,
    }
}

/// Drill collar of a length, m.
pub fn collar(length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.0286,
        outer_radius: 0.0762,
    }
}

/// A string below a dashpot in torsion and one along the axis.
#[derive(Debug, Clone)]
pub struct BelowDashpots {
    /// As it twists.
    pub string: Drillstring,
    /// As it stretches.
    pub rod: Drillstring,
    /// Damping of both dashpots, N m s/rad and N s/m.
    pub dampings: [f64; 2],
}

impl BelowDashpots {
    /// Of these tubes from the surface down, without loss, whose upper end sends back −η of a wave in
    /// torsion and along the axis.
    ///
    /// # Panics
    /// Where there is no such string.
    pub fn new(tubes: &[Tube], [eta_t, eta_a]: [f64; 2]) -> Self {
        Self::of_stiffness(tubes, YOUNGS_MODULUS, [eta_t, eta_a])
    }

    /// The same with another Young's modulus, Pa.
    ///
    /// # Panics
    /// Where there is no such string.
    pub fn of_stiffness(tubes: &[Tube], youngs_modulus: f64, [eta_t, eta_a]: [f64; 2]) -> Self {
        let section = |tube: &Tube| Section {
            repeat: 1,
            parts: vec![*tube],
        };
        let sections = tubes.iter().map(section).collect();
        let string = Drillstring::new(STEEL, sections, 0.0).expect("such tubes are a string");
        let dashpot = |rod: &Drillstring, eta: f64| {
            torsional_impedance(rod, &tubes[0]) * (1.0 + eta) / (1.0 - eta)
        };
        let rod = |hoist| {
            let axial = Axial {
                youngs_modulus,
                damping: 0.0,
                hoist,
            };
            axial.rod(&string).expect("such a string is a rod")
        };
        let dampings = [dashpot(&string, eta_t), dashpot(&rod(None), eta_a)];
        let hoist = Hoist {
            mass: 0.0,
            damping: dampings[1],
            stiffness: 0.0,
        };
        let rod = rod(Some(hoist));
        let drive = TopDrive {
            inertia: 0.0,
            proportional_gain: dampings[0],
            integral_gain: 0.0,
            delay: 0.0,
            late_inertia: 0.0,
        };
        let string = string.with_top_drive(drive).expect("such a drive turns it");
        Self {
            string,
            rod,
            dampings,
        }
    }
}
