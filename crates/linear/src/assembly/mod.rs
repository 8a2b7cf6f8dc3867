//! Dynamic stiffnesses of pieces of string, joined at the nodes they share: cells to
//! sections, sections to the string, and this reduced to the surface and the sites. What a
//! piece is made of, waves or elements, is not known here.

pub mod beam_stiffness;
pub mod bending;
pub mod block;
pub mod chain;
pub mod lanes;
pub mod matrix;
pub mod nodes;
pub mod number;
pub mod scattering;
pub mod stiff_beam;
pub mod torsion;

/// Bytes that a thread works with at the frequencies that it looks at together: pieces between
/// nodes of a number of sites, with a number of entries each, what they are joined to, and the
/// responses.
pub(crate) fn working_bytes<T: number::Number>(sites: usize, entries: usize) -> f64 {
    let numbers = 7 * (sites + 1) * entries + 3 * sites * sites;
    (size_of::<T>() * numbers) as f64
}
