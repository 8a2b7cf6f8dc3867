//! The shorter steps by which a method certifies labels.

use linear::Method;
use linear::waves::lattice::Lattice;

use crate::plan::Setting;
use crate::records::FINER;

/// The sampling frequency, Hz, at which a method says once more what a case is, to certify its
/// labels: [`FINER`] times that of the sweep. Where torsion alone is modelled `held` takes steps of
/// one piece of the string's lattice if those are shorter still: fronts are then exact, with any
/// tool joints and collars, where all longer steps smear them alike.
pub fn finer_frequency(setting: &Setting, method: &Method) -> f64 {
    let finer = FINER * setting.sampling_frequency;
    if *method != Method::Held || setting.lateral.is_some() {
        return finer;
    }
    // A string without a lattice is refused when it is built.
    let lattice = Lattice::new(&setting.string, &setting.sites);
    lattice.map_or(finer, |lattice| finer.max(lattice.step.recip()))
}
