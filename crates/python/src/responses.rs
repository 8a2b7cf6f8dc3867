//! `Responses`: impulse responses as arrays, and motion by a law of one's own.

use linear::ChannelResponses;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;
use sim::{Lateral, Scene, Stepper, SurfaceProfile, System, Timing, Trajectory};

use crate::arrays::{rows, shaped, vector};
use crate::convert::{EccentricMass, Impulse};
use crate::errors::refused;
use crate::laws::{Bit, Raised, Wall};
use crate::motion::Motion;

/// Steps between two looks at signals.
const BETWEEN_LOOKS: usize = 256;

/// The impulse responses of a string by one method; sites from the surface down.
#[pyclass(frozen, module = "drillstring")]
pub struct Responses {
    responses: linear::Responses,
    torsion_margin: Option<f64>,
    bending_margin: Option<f64>,
}

impl Responses {
    /// Responses with their margins.
    ///
    /// # Errors
    /// Where they are not those of a string.
    pub fn new(responses: linear::Responses) -> PyResult<Self> {
        Ok(Self {
            torsion_margin: responses.torsion_margin().map_err(refused)?,
            bending_margin: responses.bending_margin().map_err(refused)?,
            responses,
        })
    }
}

#[pymethods]
#[expect(
    clippy::wrong_self_convention,
    reason = "arrays from something to something"
)]
impl Responses {
    /// Name of the method.
    #[getter]
    fn method(&self) -> &'static str {
        self.responses.method.name()
    }

    /// Sampling frequency, Hz.
    #[getter]
    fn sampling_frequency(&self) -> f64 {
        self.responses.sampling_frequency
    }

    /// The longest time that may be simulated with them, s.
    #[getter]
    fn longest_time(&self) -> f64 {
        self.responses.longest_time
    }

    /// Distances of the sites from the bit, m.
    #[getter]
    fn sites<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        vector(py, self.responses.sites.distances_from_bit().to_vec())
    }

    /// The sites, by number, on which a torque may act.
    #[getter]
    fn torques(&self) -> Vec<usize> {
        self.responses
            .torsion()
            .map_or_else(Vec::new, |torsion| torsion.loads.clone())
    }

    /// Taps from the speed of the surface to those of the sites, `[site, tap]`.
    #[getter]
    fn from_surface<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArrayDyn<f64>>>> {
        let torsion = self.responses.torsion();
        torsion
            .map(|torsion| rows(py, &torsion.from_surface))
            .transpose()
    }

    /// Taps from torques to speeds, rad/s per N m, `[site, torque, tap]`.
    #[getter]
    fn from_torques<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArrayDyn<f64>>>> {
        self.responses
            .torsion()
            .map(|torsion| from_loads(py, torsion))
            .transpose()
    }

    /// Taps from forces to displacements, m/N, `[site, force, tap]`; none without bending.
    #[getter]
    fn from_forces<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArrayDyn<f64>>>> {
        self.responses
            .bending()
            .map(|bending| from_loads(py, bending))
            .transpose()
    }

    /// Positive-real margin in torsion: below zero a stuck site chatters. None where no torque
    /// acts.
    #[getter]
    fn torsion_margin(&self) -> Option<f64> {
        self.torsion_margin
    }

    /// Positive-real margin in bending; none without bending.
    #[getter]
    fn bending_margin(&self) -> Option<f64> {
        self.bending_margin
    }

    /// The motion from rest of a surface that comes to a speed (rad/s) in a rise (s), under laws
    /// of the bit and of the walls.
    #[pyo3(signature = (
        surface_speed, duration, *, bit = None, walls = None, impulses = Vec::new(),
        eccentric_masses = Vec::new(), rise = 0.0
    ))]
    #[expect(clippy::too_many_arguments, reason = "keywords")]
    fn simulate(
        &self,
        py: Python<'_>,
        surface_speed: f64,
        duration: f64,
        bit: Option<Bound<'_, PyAny>>,
        walls: Option<Vec<Bound<'_, PyAny>>>,
        impulses: Vec<Impulse>,
        eccentric_masses: Vec<EccentricMass>,
        rise: f64,
    ) -> PyResult<Motion> {
        if walls.is_none() && !(impulses.is_empty() && eccentric_masses.is_empty()) {
            return Err(refused(
                "impulses and eccentric masses need walls: give one for each site",
            ));
        }
        let raised = Raised::default();
        let walls = walls.map(|walls| {
            let laws = walls.into_iter().map(|law| Wall::of(law, &raised));
            laws.collect::<PyResult<Vec<_>>>()
        });
        let lateral = walls.transpose()?.map(|walls| Lateral {
            walls,
            impulses: impulses.into_iter().map(Into::into).collect(),
            eccentric_masses: eccentric_masses.into_iter().map(Into::into).collect(),
        });
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed,
            bit: bit.map(|law| Bit::of(law, &raised)).transpose()?,
            friction: Vec::new(),
            lateral,
            timing: Timing {
                duration,
                closing_window: 0.0,
            },
        };
        let profile = SurfaceProfile::Rise(rise);
        let system = System::started(&self.responses, &profile).map_err(refused)?;
        Ok(Motion {
            sites: self.responses.sites.distances_from_bit().to_vec(),
            trajectory: self.step(py, &system, &scene, &raised)?,
        })
    }

    fn __repr__(&self) -> String {
        let (method, frequency) = (self.method(), self.sampling_frequency());
        format!("<Responses by {method} at {frequency} Hz>")
    }
}

impl Responses {
    /// Steps a scene to its end.
    fn step(
        &self,
        py: Python<'_>,
        system: &System,
        scene: &Scene<Bit, Wall>,
        raised: &Raised,
    ) -> PyResult<Trajectory> {
        let walls = scene
            .lateral
            .as_ref()
            .map_or(0, |lateral| lateral.walls.len());
        let loads = self.torques();
        let mut speeds = vec![Vec::new(); loads.len()];
        let mut motion = Trajectory {
            positions: vec![Vec::new(); walls],
            wall_forces: vec![Vec::new(); walls],
            touches: vec![Vec::new(); walls],
            normal_forces: vec![Vec::new(); walls],
            wall_torques: vec![Vec::new(); walls],
            ..Trajectory::default()
        };
        let mut stepper = Stepper::new(system, scene).map_err(refused)?;
        loop {
            if stepper.next_step().is_multiple_of(BETWEEN_LOOKS) {
                py.check_signals()?;
            }
            let stepped = stepper.step();
            // What a law raised is told rather than what became of the motion.
            if let Some(error) = raised.take() {
                return Err(error);
            }
            let Some(now) = stepped.map_err(refused)? else {
                break;
            };
            motion.times.push(now.time);
            (speeds.iter_mut().zip(&now.speeds)).for_each(|(own, speed)| own.push(*speed));
            motion
                .bit_torque
                .extend(now.bit.as_ref().map(|bit| bit.torque));
            for (site, contact) in now.contacts.iter().enumerate() {
                motion.positions[site].push(contact.position);
                motion.wall_forces[site].push(contact.force);
                motion.touches[site].push(contact.touch);
                motion.normal_forces[site].push(contact.normal_force);
                motion.wall_torques[site].push(contact.torque);
            }
        }
        let driven = system.driven_speeds(
            scene.surface_speed,
            &scene.start,
            &motion.bit_torque,
            motion.times.len(),
        );
        motion.speeds = driven.unwrap_or_default();
        for (site, own) in loads.into_iter().zip(speeds) {
            motion.speeds[site] = own;
        }
        Ok(motion)
    }
}

/// Taps from loads, by site, load and tap.
fn from_loads<'py>(
    py: Python<'py>,
    channel: &ChannelResponses,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let taps = channel.from_loads.iter().flatten().flatten().copied();
    let shape = [
        channel.from_loads.len(),
        channel.loads.len(),
        channel.taps(),
    ];
    shaped(py, taps.collect(), &shape)
}
