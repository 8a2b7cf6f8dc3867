//! What this program calls itself.

/// Version and, where it is known, commit.
pub const PROGRAM: &str = concat!("sweep ", env!("SWEEP_VERSION"));
