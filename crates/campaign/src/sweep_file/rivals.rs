//! Keys that say the same in two ways.

/// Keys that say the same in another way: a file gives one of each pair, and it
/// replaces the other of its base.
pub const RIVALS: [Rivals; 12] = [
    Rivals("", "accuracy", "methods"),
    Rivals("", "accuracy", "method"),
    Rivals("", "accuracy", "certify"),
    Rivals("", "accuracy", "sampling_frequency_hz"),
    Rivals("string", "file", "sections"),
    Rivals("well", "hole_radius_m", "holes"),
    Rivals("well", "survey", "inclination_deg"),
    Rivals("wall", "clearance", "clearance_mm"),
    Rivals("string_friction", "tolerance", "pieces"),
    Rivals("", "surface_speed_file", "surface_speed_rpm"),
    Rivals("", "surface_speed_file", "surface_speed_rise_s"),
    Rivals("", "surface_speed_column", "surface_speed_rpm"),
];

/// The table that both are in, or none, and their names.
pub struct Rivals(pub &'static str, pub &'static str, pub &'static str);
