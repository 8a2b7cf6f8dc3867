//! `Responses`: impulse responses as arrays, and motion by a user-defined law.

use linear::ChannelResponses;
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;
use sim::{Lateral, Scene, Simulator, Stopping, SurfaceProfile, Timing, Trajectory};

use crate::arrays::{rows, shaped, vector};
use crate::convert::{EccentricMass, Impulse};
use crate::errors::refused;
use crate::laws::{Bit, Interruption, Wall};
use crate::motion::Motion;
use crate::outcome::Outcome;

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

    /// The motion from rest of a surface that reaches a speed (rad/s) in a rise (s), under laws
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
        let asked = Asked {
            surface_speed,
            timing: Timing {
                duration,
                closing_window: 0.0,
            },
            bit,
            walls,
            impulses: impulses.into_iter().map(Into::into).collect(),
            eccentric_masses: eccentric_masses.into_iter().map(Into::into).collect(),
            rise,
        };
        let mut trajectory = Trajectory::default();
        self.outcome(py, asked, Some(&mut trajectory))?;
        Ok(Motion {
            sites: self.responses.sites.distances_from_bit().to_vec(),
            trajectory,
        })
    }

    /// The regimes of the same, as those of a sweep's case: a simulation that ends as soon as they
    /// are certain or settled. They show in a closing window (s), no shorter than a cycle of
    /// stick-slip.
    #[pyo3(signature = (
        surface_speed, duration, *, closing_window, bit = None, walls = None,
        impulses = Vec::new(), eccentric_masses = Vec::new(), rise = 0.0
    ))]
    #[expect(clippy::too_many_arguments, reason = "keywords")]
    fn regimes(
        &self,
        py: Python<'_>,
        surface_speed: f64,
        duration: f64,
        closing_window: f64,
        bit: Option<Bound<'_, PyAny>>,
        walls: Option<Vec<Bound<'_, PyAny>>>,
        impulses: Vec<Impulse>,
        eccentric_masses: Vec<EccentricMass>,
        rise: f64,
    ) -> PyResult<Outcome> {
        let asked = Asked {
            surface_speed,
            timing: Timing {
                duration,
                closing_window,
            },
            bit,
            walls,
            impulses: impulses.into_iter().map(Into::into).collect(),
            eccentric_masses: eccentric_masses.into_iter().map(Into::into).collect(),
            rise,
        };
        self.outcome(py, asked, None).map(Outcome)
    }

    fn __repr__(&self) -> String {
        let (method, frequency) = (self.method(), self.sampling_frequency());
        format!("<Responses by {method} at {frequency} Hz>")
    }
}

/// A case that is asked for, from rest.
struct Asked<'py> {
    surface_speed: f64,
    timing: Timing,
    bit: Option<Bound<'py, PyAny>>,
    walls: Option<Vec<Bound<'py, PyAny>>>,
    impulses: Vec<sim::Impulse>,
    eccentric_masses: Vec<sim::EccentricMass>,
    rise: f64,
}

impl Responses {
    /// Simulates a case: to its end where its motion is to be recorded.
    fn outcome(
        &self,
        py: Python<'_>,
        asked: Asked<'_>,
        record: Option<&mut Trajectory>,
    ) -> PyResult<sim::Outcome> {
        let is_disturbed = !(asked.impulses.is_empty() && asked.eccentric_masses.is_empty());
        if asked.walls.is_none() && is_disturbed {
            return Err(refused(
                "impulses and eccentric masses need walls: give one for each site",
            ));
        }
        let interruption = Interruption::none(py);
        let walls = asked.walls.map(|walls| {
            let laws = walls.into_iter().map(|law| Wall::of(law, &interruption));
            laws.collect::<PyResult<Vec<_>>>()
        });
        let lateral = walls.transpose()?.map(|walls| Lateral {
            walls,
            impulses: asked.impulses,
            eccentric_masses: asked.eccentric_masses,
            lying: None,
            shocks: None,
        });
        let bit = asked.bit.map(|law| Bit::of(law, &interruption));
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: asked.surface_speed,
            bit: bit.transpose()?,
            friction: Vec::new(),
            axial: None,
            lateral,
            timing: asked.timing,
        };
        let profile = SurfaceProfile::Rise(asked.rise);
        let simulator = Simulator::started(&self.responses, &profile).map_err(refused)?;
        let simulated = simulator.simulate_laws(&scene, Stopping::Early, record);
        // What a law raised, rather than what became of the motion.
        match interruption.take() {
            Some(error) => Err(error),
            None => simulated.map_err(refused),
        }
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
