//! `Outcome`: the regimes of a case and what is measured of it.

use pyo3::prelude::*;
use pyo3::types::PyDict;

/// How a case ended: its regimes, and measures in SI units.
#[pyclass(frozen, module = "drillstring")]
pub struct Outcome(pub sim::Outcome);

#[pymethods]
impl Outcome {
    /// `stuck`, `smooth` or `stick_slip`; none where no law acts on the bit.
    #[getter]
    fn torsion(&self) -> Option<&'static str> {
        self.0.torsion().map(|torsion| torsion.regime.name())
    }

    /// `no_contact`, `transient_contact`, `backward_whirl` or `forward_whirl`; none without a wall.
    #[getter]
    fn lateral(&self) -> Option<&'static str> {
        self.0.lateral().map(|lateral| lateral.regime.name())
    }

    /// Why the simulation ended: `end` of the time, `certain` or `settled`.
    #[getter]
    fn ended(&self) -> &'static str {
        self.0.ended.name()
    }

    /// Time stepped, s.
    #[getter]
    fn simulated(&self) -> f64 {
        self.0.simulated
    }

    /// Measures by name, those that the case has.
    #[getter]
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let measures = PyDict::new(py);
        if let Some(torsion) = self.0.torsion() {
            let optional = [
                ("first_slip_s", torsion.first_slip),
                ("period_s", torsion.period),
                ("slip_time_s", torsion.slip_time),
                ("severity", torsion.severity),
                ("motor_stalled_fraction", torsion.motor_stalled_fraction),
            ];
            for (name, value) in optional {
                if let Some(value) = value {
                    measures.set_item(name, value)?;
                }
            }
            measures.set_item("sticks", torsion.sticks)?;
            measures.set_item("peak_speed_rad_s", torsion.peak_speed)?;
            measures.set_item("closing_speed_rad_s", torsion.closing_speed)?;
        }
        if let Some(lateral) = self.0.lateral() {
            if let Some(time) = lateral.first_contact {
                measures.set_item("first_contact_s", time)?;
            }
            measures.set_item("site", lateral.site)?;
            measures.set_item("peak_radius_m", lateral.peak_radius)?;
            measures.set_item("contact_fraction", lateral.contact_fraction)?;
            measures.set_item("rolling_fraction", lateral.rolling_fraction)?;
            measures.set_item("precession_rate_rad_s", lateral.precession_rate)?;
            measures.set_item("mean_radius_m", lateral.mean_radius)?;
            measures.set_item("mean_normal_force_n", lateral.mean_normal_force)?;
            if let Some(lying) = lateral.lying {
                measures.set_item("climb_rad", lying.climb)?;
                measures.set_item("swing_rad", lying.swing_amplitude)?;
                measures.set_item("swing_frequency_hz", lying.swing_frequency)?;
                measures.set_item("greatest_angle_rad", lying.greatest_angle)?;
            }
            if let Some(shocks) = lateral.shocks {
                measures.set_item("shock_site", shocks.site)?;
                for (direction, in_band) in
                    [("", shocks.sideways), ("tangential_", shocks.tangential)]
                {
                    let Some(in_band) = in_band else { continue };
                    for (name, value) in [
                        ("band_hz", in_band.band),
                        ("band_peak_m_s2", in_band.peak),
                        ("band_rms_m_s2", in_band.rms),
                    ] {
                        measures.set_item(format!("{direction}acceleration_{name}"), value)?;
                    }
                }
                measures.set_item("acceleration_step_peak_m_s2", shocks.step_peak)?;
                measures.set_item("acceleration_step_rms_m_s2", shocks.step_rms)?;
                let tangential = shocks.tangential_step_peak;
                measures.set_item("tangential_acceleration_step_peak_m_s2", tangential)?;
                measures.set_item("shocks_per_s", shocks.shocks_per_second)?;
            }
        }
        if let Some(stress) = self.0.stress {
            for (name, place, peak) in [
                (
                    "bending_moment_peak_nm",
                    Some("bending_moment_from_bit_m"),
                    stress.moment,
                ),
                (
                    "bending_stress_peak_pa",
                    Some("bending_stress_from_bit_m"),
                    stress.bending,
                ),
                ("bending_stress_amplitude_pa", None, stress.amplitude),
                (
                    "von_mises_peak_pa",
                    Some("von_mises_from_bit_m"),
                    stress.von_mises,
                ),
            ] {
                measures.set_item(name, peak.value)?;
                if let Some(place) = place {
                    measures.set_item(place, peak.from_bit)?;
                }
            }
        }
        Ok(measures)
    }

    fn __repr__(&self) -> String {
        let labels: Vec<&str> = self.torsion().into_iter().chain(self.lateral()).collect();
        format!("<Outcome {}>", labels.join(", "))
    }
}
