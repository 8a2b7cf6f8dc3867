//! `Drillstring`: a string, and what is known of it before anything is simulated.

use std::f64::consts::TAU;

use campaign::memory::{Limit, Size};
use linear::method::{FiniteElement, Transform};
use linear::modes::damped_modes;
use linear::natural_frequencies::NaturalFrequencies;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{Budget, BuildError, ChannelRequest, Request, ResponsePlan, Sites, estimates};
use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;

use crate::arrays::{Complex, numbers, rows, shaped, vector};
use crate::convert::{self, Bending, Material, Section, TopDrive};
use crate::errors::refused;
use crate::responses::Responses;
use crate::wait::wait_for;

/// A straight drillstring hanging from the surface.
#[pyclass(frozen, module = "drillstring")]
pub struct Drillstring {
    /// The string itself.
    pub string: linear::Drillstring,
}

/// Natural modes, from the slowest up.
#[pyclass(frozen, module = "drillstring")]
pub struct Modes {
    frequencies: Vec<f64>,
    damping_ratios: Option<Vec<f64>>,
    depths: Vec<f64>,
    shapes: Vec<Vec<f64>>,
}

#[pymethods]
impl Modes {
    /// Natural frequencies without damping, Hz.
    #[getter]
    fn frequencies<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        vector(py, self.frequencies.clone())
    }

    /// Damping ratios, not a number where a mode is so damped that it does not swing; none in
    /// bending.
    #[getter]
    fn damping_ratios<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        Some(vector(py, self.damping_ratios.clone()?))
    }

    /// Depths at which shapes are given, m.
    #[getter]
    fn depths<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        vector(py, self.depths.clone())
    }

    /// Amplitudes by mode and depth, in parts of the largest.
    #[getter]
    fn shapes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        rows(py, &self.shapes)
    }
}

#[pymethods]
impl Drillstring {
    #[new]
    #[pyo3(signature = (sections, *, material, torsional_damping, top_drive = None))]
    fn new(
        sections: Vec<Section>,
        material: Material,
        torsional_damping: f64,
        top_drive: Option<TopDrive>,
    ) -> PyResult<Self> {
        let sections = sections.into_iter().map(Into::into).collect();
        let string = linear::Drillstring::new(material.into(), sections, torsional_damping);
        let mut string = string.map_err(refused)?;
        if let Some(drive) = top_drive {
            string = string.with_top_drive(drive.into()).map_err(refused)?;
        }
        Ok(Self { string })
    }

    /// Length, m.
    #[getter]
    fn length(&self) -> f64 {
        self.string.length()
    }

    /// Distributed torsional damping, N m s/rad per metre.
    #[getter]
    fn torsional_damping(&self) -> f64 {
        self.string.torsional_damping()
    }

    /// Static torsional stiffness between surface and bit, N m/rad.
    #[getter]
    fn torsional_stiffness(&self) -> f64 {
        estimates::torsional_stiffness(&self.string)
    }

    /// Time that a torsional wave takes from the surface to the bit, s.
    #[getter]
    fn torsional_travel_time(&self) -> f64 {
        estimates::torsional_travel_time(&self.string)
    }

    /// The sampling frequency that torsion needs where a torque acts at the bit, Hz.
    #[getter]
    fn sampling_frequency(&self) -> PyResult<f64> {
        linear::sampling::frequency_for_fronts(&self.string).map_err(refused)
    }

    /// Impulse responses by a method, between sites given by their distances from the bit (m), of a string
    /// that carries masses (kg) there in bending, one for each site from the surface down.
    #[pyo3(signature = (
        method = "held", *, longest_time, sites = None, torques = None, bending = None,
        sampling_frequency = None, transform = None, elements_per_cell = 20, gamma = 0.52,
        beta = None, masses = None
    ))]
    #[expect(clippy::too_many_arguments, reason = "keywords")]
    fn responses(
        &self,
        py: Python<'_>,
        method: &str,
        longest_time: f64,
        sites: Option<Vec<f64>>,
        torques: Option<Vec<usize>>,
        bending: Option<Bending>,
        sampling_frequency: Option<f64>,
        transform: Option<f64>,
        elements_per_cell: usize,
        gamma: f64,
        beta: Option<f64>,
        masses: Option<Vec<f64>>,
    ) -> PyResult<Responses> {
        let transform = Transform { seconds: transform };
        let elements = FiniteElement {
            elements_per_cell,
            gamma,
            beta,
        };
        let method = convert::method(method, transform, elements)?;
        elements.check().map_err(refused)?;
        let mut sites = self.sites(sites)?;
        check_number_of_sites(&sites)?;
        if let Some(masses) = masses {
            sites = sites.carrying(masses).map_err(refused)?;
        }
        // Friction turns the string wherever it may touch; without walls the bit alone.
        let torques = torques.unwrap_or_else(|| match bending {
            Some(_) => (0..sites.len()).collect(),
            None => sites.bit_site().into_iter().collect(),
        });
        let mut channels = vec![ChannelRequest::Torsion { torques }];
        if let Some(bending) = bending {
            let (bending, support) = bending.resolve()?;
            channels.push(ChannelRequest::Bending { bending, support });
        }
        let request = Request {
            sites,
            channels,
            sampling_frequency: match sampling_frequency {
                Some(given) => given,
                None => self.sampling_frequency()?,
            },
            longest_time,
        };
        let string = self.string.clone();
        let memory = ResponsePlan::new(&string, &method, &request).and_then(|plan| {
            let budget = Budget::unlimited();
            plan.ask(&budget)?;
            Ok(budget.need())
        });
        match memory {
            Err(
                BuildError::TooManyTaps { taps, .. }
                | BuildError::TooManyImpulses { impulses: taps, .. },
            ) => {
                return Err(refused(format_args!(
                    "these responses are too long: {taps:.3e} steps"
                )));
            }
            memory => fits(memory.map_err(refused)?.peak)?,
        }
        let built = wait_for(py, move || linear::responses(&string, &method, &request))?;
        Responses::new(built.map_err(refused)?)
    }

    /// The exact response in torsion at frequencies (Hz): speeds of the sites per speed of the
    /// surface, `[frequency, site]`, and per torque at each, rad/s per N m,
    /// `[frequency, site, site]`.
    #[pyo3(signature = (frequencies, *, sites = None))]
    #[expect(clippy::type_complexity, reason = "a pair of arrays")]
    fn torsion_response<'py>(
        &self,
        py: Python<'py>,
        frequencies: &Bound<'py, PyAny>,
        sites: Option<Vec<f64>>,
    ) -> PyResult<(
        Bound<'py, PyArrayDyn<Complex>>,
        Bound<'py, PyArrayDyn<Complex>>,
    )> {
        let sites = self.sites(sites)?;
        let frequencies = finite_frequencies(frequencies, |_| true)?;
        fits(RESPONSE * frequencies.len() as f64 * (sites.len() as f64).powi(2))?;
        let shape = [frequencies.len(), sites.len()];
        let string = self.string.clone();
        let found = wait_for(py, move || {
            let network = TorsionNetwork::new(&string, &sites)?;
            let (mut from_surface, mut from_torques) = (Vec::new(), Vec::new());
            for frequency in &frequencies {
                let response = network.at_frequency(*frequency);
                for site in 0..sites.len() {
                    from_surface.push(response.from_surface[site]);
                    let row = (0..sites.len()).map(|at| response.from_torque[(site, at)]);
                    from_torques.extend(row);
                }
            }
            Ok::<_, BuildError>((from_surface, from_torques))
        })?;
        let (from_surface, from_torques) = found.map_err(refused)?;
        let [frequencies, sites] = shape;
        Ok((
            shaped(py, from_surface, &[frequencies, sites])?,
            shaped(py, from_torques, &[frequencies, sites, sites])?,
        ))
    }

    /// The exact receptance in bending at frequencies (Hz, not zero): displacement of each site
    /// per force at each, m/N, `[frequency, site, site]`.
    #[pyo3(signature = (frequencies, *, bending, sites = None))]
    fn bending_response<'py>(
        &self,
        py: Python<'py>,
        frequencies: &Bound<'py, PyAny>,
        bending: Bending,
        sites: Option<Vec<f64>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<Complex>>> {
        let sites = self.sites(sites)?;
        let frequencies = finite_frequencies(frequencies, |frequency| frequency != 0.0)?;
        let (bending, support) = bending.resolve()?;
        fits(RESPONSE * frequencies.len() as f64 * (sites.len() as f64).powi(2))?;
        let shape = [frequencies.len(), sites.len()];
        let string = self.string.clone();
        let found = wait_for(py, move || {
            let network = BendingNetwork::new(&string, bending, support, &sites)?;
            let mut receptance = Vec::new();
            for frequency in &frequencies {
                let response = network.at_rate(TAU * frequency);
                for site in 0..sites.len() {
                    receptance.extend((0..sites.len()).map(|at| response[(site, at)]));
                }
            }
            Ok::<_, BuildError>(receptance)
        })?;
        let receptance = found.map_err(refused)?;
        let [frequencies, sites] = shape;
        shaped(py, receptance, &[frequencies, sites, sites])
    }

    /// The lowest modes in torsion, the bit free and the surface held.
    #[pyo3(signature = (count, *, depths = 201))]
    fn torsional_modes(&self, py: Python<'_>, count: usize, depths: usize) -> PyResult<Modes> {
        let string = self.string.clone();
        fits(SHAPE * count as f64 * depths as f64)?;
        let found = wait_for(py, move || {
            let natural = NaturalFrequencies::torsion(&string)?;
            let rates = natural.lowest(count)?;
            let damped = damped_modes(&string, &rates)?.into_iter();
            let ratios = damped.map(|mode| mode.map_or(f64::NAN, |mode| mode.damping_ratio()));
            let damping_ratios = Some(ratios.collect());
            Modes::of(&natural, &rates, depths, damping_ratios)
        })?;
        found.map_err(refused)
    }

    /// The lowest modes in bending, no site touching a wall.
    #[pyo3(signature = (count, *, bending, depths = 201))]
    fn bending_modes(
        &self,
        py: Python<'_>,
        count: usize,
        bending: Bending,
        depths: usize,
    ) -> PyResult<Modes> {
        let (bending, support) = bending.resolve()?;
        let string = self.string.clone();
        fits(SHAPE * count as f64 * depths as f64)?;
        let found = wait_for(py, move || {
            let natural = NaturalFrequencies::bending(&string, &bending, support)?;
            let rates = natural.lowest(count)?;
            Modes::of(&natural, &rates, depths, None)
        })?;
        found.map_err(refused)
    }

    fn __repr__(&self) -> String {
        let sections = self.string.sections().len();
        format!(
            "<Drillstring of {} m, {sections} sections>",
            self.string.length()
        )
    }
}

/// Bytes of a complex response between two sites, with a copy of it for Python.
const RESPONSE: f64 = 32.0;

/// Bytes for each depth of a mode, with what it is found from.
const SHAPE: f64 = 256.0;

/// Refuses what would take more memory than there is.
fn fits(bytes: f64) -> PyResult<()> {
    let limit = Limit::of(None);
    if bytes <= limit.bytes {
        return Ok(());
    }
    let takes = Size(bytes);
    Err(refused(format_args!(
        "it would take {takes}, more than the limit: {limit}"
    )))
}

/// Most sites between which responses are built, in minutes: the time grows faster than their number.
const MOST_SITES: usize = 500;

/// Refuses more sites than responses are built for.
///
/// # Errors
/// Where there are more.
pub fn check_number_of_sites(sites: &Sites) -> PyResult<()> {
    if sites.len() <= MOST_SITES {
        return Ok(());
    }
    Err(refused(format_args!(
        "{} sites are more than the {MOST_SITES} between which responses are built",
        sites.len()
    )))
}

/// The frequencies that an argument gives, Hz, all finite and of those that have a response.
fn finite_frequencies(
    argument: &Bound<'_, PyAny>,
    has_response: impl Fn(f64) -> bool,
) -> PyResult<Vec<f64>> {
    let frequencies = numbers(argument)?;
    let is_wrong = |frequency: &f64| !frequency.is_finite() || !has_response(*frequency);
    match frequencies.iter().position(is_wrong) {
        None => Ok(frequencies),
        Some(place) => Err(refused(format_args!(
            "`frequencies[{place}]` is {}, but must be a finite number of Hz{}",
            frequencies[place],
            if has_response(0.0) {
                ""
            } else {
                " other than zero"
            }
        ))),
    }
}

impl Drillstring {
    fn sites(&self, distances: Option<Vec<f64>>) -> PyResult<Sites> {
        match distances {
            None => Ok(Sites::bit()),
            Some(distances) => Sites::new(&self.string, &distances).map_err(refused),
        }
    }
}

impl Modes {
    /// Those of natural frequencies, rad/s.
    fn of(
        natural: &NaturalFrequencies,
        rates: &[f64],
        depths: usize,
        damping_ratios: Option<Vec<f64>>,
    ) -> Result<Self, BuildError> {
        let mut modes = Modes {
            frequencies: rates.iter().map(|rate| rate / TAU).collect(),
            damping_ratios,
            depths: Vec::new(),
            shapes: Vec::new(),
        };
        for rate in rates {
            let shape = natural.shape(*rate, depths)?;
            modes.depths = shape.depths;
            modes.shapes.push(shape.amplitudes);
        }
        Ok(modes)
    }
}
