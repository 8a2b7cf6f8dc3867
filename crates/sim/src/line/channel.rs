//! The linear part in one channel, between the sites that loads act on: what they do within
//! their step, and how what they did before is remembered.

use linear::BendingPoles;
use linear::budget::REAL;
use linear::elements::stepped::{SteppedChannel, SteppedMotion};

use super::poles::{Poles, PolesPast};
use crate::convolution::{Convolution, Kernels};
use crate::surface::SurfaceResponse;

/// Torsion: from torques to speeds.
pub(crate) type Torsion = Channel<1, 1>;

/// Bending in two planes: from forces to displacements.
pub(crate) type Bending = Channel<2, 2>;

/// Axial motion: from forces at the bit to its speed, and from the surface.
#[derive(Debug, Clone)]
pub(crate) struct AxialLines {
    pub(crate) from_forces: Channel<1, 1>,
    /// Response of the bit to a surface whose final speed is 1 m/s.
    pub(crate) surface: SurfaceResponse,
}

/// A channel as all cases share it. A mesh has `FREEDOMS` degrees of freedom at a node, and moves
/// in `PLANES` planes.
#[derive(Debug, Clone)]
pub(crate) struct Channel<const FREEDOMS: usize, const PLANES: usize> {
    sites: usize,
    memory: Memory<FREEDOMS, PLANES>,
    /// A(0), `[output × sites + input]`.
    instants: Vec<f64>,
}

/// What the past is remembered by.
#[derive(Debug, Clone)]
enum Memory<const FREEDOMS: usize, const PLANES: usize> {
    /// Responses, which are summed over all loads so far (Eq. 17).
    Taps(Kernels),
    /// Finite elements, whose motion goes from step to step.
    Mesh(SteppedChannel<FREEDOMS, PLANES>),
    /// Poles that all sites share.
    Poles(Poles),
}

/// The loads of a case so far.
#[derive(Debug)]
pub(crate) enum Past<'a, const FREEDOMS: usize, const PLANES: usize> {
    Taps(Convolution<'a>),
    Mesh(MeshPast<'a, FREEDOMS, PLANES>),
    Poles(PolesPast<'a, PLANES>),
}

/// The same of a mesh.
#[derive(Debug)]
pub(crate) struct MeshPast<'a, const FREEDOMS: usize, const PLANES: usize> {
    mesh: &'a SteppedChannel<FREEDOMS, PLANES>,
    motion: SteppedMotion<FREEDOMS, PLANES>,
    /// Of each plane and site, all steps.
    loads: Vec<Vec<f64>>,
}

impl<const FREEDOMS: usize, const PLANES: usize> Channel<FREEDOMS, PLANES> {
    /// Bytes of responses of a number of taps between a number of sites, the same in both directions
    /// or not.
    pub(crate) fn bytes_of_taps(sites: usize, taps: usize, is_reciprocal: bool) -> f64 {
        Kernels::bytes(sites, taps, is_reciprocal) + Self::instant_bytes(sites)
    }

    /// Bytes without those of a mesh.
    pub(crate) fn instant_bytes(sites: usize) -> f64 {
        REAL * (sites * sites) as f64
    }

    /// Bytes of a number of poles.
    pub(crate) fn bytes_of_poles(sites: usize, poles: f64) -> f64 {
        Poles::bytes(sites, poles) + Self::instant_bytes(sites)
    }

    /// Bytes of the past of a number of steps, with responses of a number of taps.
    pub(crate) fn past_bytes(sites: usize, taps: usize, steps: f64) -> f64 {
        Convolution::bytes(sites, PLANES, taps, steps)
    }

    /// Bytes of the loads of a number of steps, without the motion of a mesh.
    pub(crate) fn load_bytes(sites: usize, steps: f64) -> f64 {
        REAL * (PLANES * sites) as f64 * steps
    }

    /// Of responses `[output][input]`, known to be a square.
    pub(crate) fn of_taps(taps: &[Vec<impl AsRef<[f64]>>]) -> Self {
        let kernels = Kernels::of(taps);
        Self {
            sites: taps.len(),
            instants: of_pairs(taps.len(), |output, input| kernels.instant(output, input)),
            memory: Memory::Taps(kernels),
        }
    }

    /// Of a mesh.
    pub(crate) fn of_mesh(mesh: &SteppedChannel<FREEDOMS, PLANES>) -> Self {
        Self {
            sites: mesh.sites(),
            instants: of_pairs(mesh.sites(), |output, input| mesh.instant(output, input)),
            memory: Memory::Mesh(mesh.clone()),
        }
    }

    /// Of poles.
    pub(crate) fn of_poles(poles: &BendingPoles) -> Self {
        Self {
            sites: poles.sites(),
            instants: of_pairs(poles.sites(), |output, input| poles.instant(output, input)),
            memory: Memory::Poles(Poles::new(poles)),
        }
    }

    /// Its responses, where it is remembered by these.
    pub(crate) fn kernels(&self) -> Option<&Kernels> {
        match &self.memory {
            Memory::Taps(kernels) => Some(kernels),
            Memory::Mesh(_) | Memory::Poles(_) => None,
        }
    }

    /// Number of sites.
    pub(crate) fn sites(&self) -> usize {
        self.sites
    }

    /// A(0): the response of a site within the step of an input at another.
    #[inline]
    pub(crate) fn instant(&self, output: usize, input: usize) -> f64 {
        self.instants[output * self.sites + input]
    }

    /// How far an input at another site moves this one within the step, as a part of what its
    /// own does.
    pub(crate) fn share(&self, output: usize, input: usize) -> f64 {
        match self.instant(output, input) {
            0.0 => 0.0,
            moved => (moved / self.instant(output, output)).abs(),
        }
    }

    /// The empty past of a case of at most `steps` steps.
    pub(crate) fn past(&self, steps: usize) -> Past<'_, FREEDOMS, PLANES> {
        match &self.memory {
            Memory::Taps(kernels) => Past::Taps(Convolution::new(kernels, PLANES, steps)),
            Memory::Mesh(mesh) => Past::Mesh(MeshPast {
                mesh,
                motion: mesh.rest(),
                loads: vec![Vec::with_capacity(steps); PLANES * self.sites],
            }),
            Memory::Poles(poles) => Past::Poles(poles.past(steps)),
        }
    }
}

/// Of all outputs and inputs, row by row.
fn of_pairs(sites: usize, instant: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let pairs = 0..sites * sites;
    pairs
        .map(|pair| instant(pair / sites, pair % sites))
        .collect()
}

impl<const FREEDOMS: usize, const PLANES: usize> Past<'_, FREEDOMS, PLANES> {
    /// Writes what the loads of earlier steps add to the present one, by planes and in each by
    /// sites.
    #[inline]
    pub(crate) fn write_past(&self, sums: &mut [f64]) {
        match self {
            Self::Taps(convolution) => convolution.write_past(sums),
            stepped => stepped.write_motion(sums),
        }
    }

    /// Ends the present step with the loads of every plane and site.
    #[inline]
    pub(crate) fn add(&mut self, loads: &[f64]) {
        match self {
            Self::Taps(convolution) => convolution.add(loads),
            stepped => stepped.step(loads),
        }
    }

    /// The same where the past is a motion: apart, so that sums ask once what they are.
    #[inline(never)]
    fn write_motion(&self, sums: &mut [f64]) {
        match self {
            Self::Taps(_) => {}
            Self::Mesh(past) => past.mesh.write_free(&past.motion, sums),
            Self::Poles(past) => past.write_past(sums),
        }
    }

    #[inline(never)]
    fn step(&mut self, loads: &[f64]) {
        match self {
            Self::Taps(_) => {}
            Self::Mesh(past) => past.add(loads),
            Self::Poles(past) => past.add(loads),
        }
    }

    /// All loads on a site so far in a plane.
    pub(crate) fn loads(&self, plane: usize, site: usize) -> &[f64] {
        match self {
            Self::Taps(convolution) => convolution.inputs(plane, site),
            Self::Mesh(past) => &past.loads[plane * past.mesh.sites() + site],
            Self::Poles(past) => past.loads(plane, site),
        }
    }

    /// At the beginning of a block, what all earlier loads add to its steps, where that is
    /// known before it is stepped.
    pub(crate) fn next_block(&self) -> Option<&[f64]> {
        match self {
            Self::Taps(convolution) => convolution.next_block(),
            Self::Mesh(_) | Self::Poles(_) => None,
        }
    }

    /// Ends a whole block without loads, which [`Self::next_block`] gave.
    pub(crate) fn push_quiet_block(&mut self) {
        match self {
            Self::Taps(convolution) => convolution.push_quiet_block(),
            Self::Mesh(_) | Self::Poles(_) => {}
        }
    }
}

impl<const FREEDOMS: usize, const PLANES: usize> MeshPast<'_, FREEDOMS, PLANES> {
    fn add(&mut self, loads: &[f64]) {
        for (past, load) in self.loads.iter_mut().zip(loads) {
            past.push(*load);
        }
        self.mesh.end_step(&mut self.motion, loads);
    }
}
