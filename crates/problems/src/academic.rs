//! The drillstring of the paper's Table 2, built without the sweep file.

use linear::{
    Bending, ChannelRequest, Drillstring, Material, Request, Section, Sites, SurfaceSupport, Tube,
};

/// The sampling frequency the paper works with, Hz.
pub const SAMPLING_FREQUENCY: f64 = 640.0;

/// Its constants in bending.
pub const BENDING: Bending = Bending {
    youngs_modulus: 210e9,
    damping: 2000.0,
    compression: 0.0,
};

/// A tube of the string, of a length and an external radius (m).
pub fn tube(length: f64, outer_radius: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.05,
        outer_radius,
    }
}

/// The string.
pub fn string() -> Drillstring {
    damped_string(10.0)
}

/// The same with another damping, N m s/rad per metre.
pub fn damped_string(torsional_damping: f64) -> Drillstring {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };
    let drillpipe = Section {
        repeat: 90,
        parts: vec![tube(9.5, 0.125), tube(0.5, 0.15)],
    };
    let collars = Section {
        repeat: 10,
        parts: vec![tube(10.0, 0.15)],
    };
    Drillstring::new(steel, vec![drillpipe, collars], torsional_damping)
        .expect("Table 2 is a drillstring")
}

/// Surface and bit, with a torque at the bit.
pub fn bit_request(longest_time: f64) -> Request {
    Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: SAMPLING_FREQUENCY,
        longest_time,
    }
}

/// Displacements by a force at each site, nothing held at the surface.
pub fn free_in_bending() -> ChannelRequest {
    ChannelRequest::Bending {
        bending: BENDING,
        support: SurfaceSupport::Free,
    }
}

/// Sites of a string at these distances from the bit (m), in bending, with a torque at
/// each.
pub fn lateral_request(string: &Drillstring, distances: &[f64], longest_time: f64) -> Request {
    let torques = (0..distances.len()).collect();
    Request {
        sites: Sites::new(string, distances).expect("these are places of the string"),
        channels: vec![ChannelRequest::Torsion { torques }, free_in_bending()],
        sampling_frequency: SAMPLING_FREQUENCY,
        longest_time,
    }
}
