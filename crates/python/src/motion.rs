//! `Motion`: the time history of a case.

use numpy::{PyArray1, PyArrayDyn};
use pyo3::prelude::*;
use sim::Trajectory;
use sim::laws::contact::Touch;
use sim::laws::cutting::CutStep;

use crate::arrays::{planes, rows, vector};

/// The time history of a case; sites from the surface down.
#[pyclass(frozen, module = "drillstring")]
pub struct Motion {
    /// Distances of the sites from the bit, m.
    pub sites: Vec<f64>,
    /// What they do.
    pub trajectory: Trajectory,
}

/// An array of something that need not be there.
type Optional<T> = PyResult<Option<T>>;

#[pymethods]
impl Motion {
    /// Distances of the sites from the bit, m.
    #[getter]
    fn sites<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        vector(py, self.sites.clone())
    }

    /// Time of each step, s.
    #[getter]
    fn time<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        vector(py, self.trajectory.times.clone())
    }

    /// Rotation speeds, rad/s, `[site, step]`.
    #[getter]
    fn speeds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        rows(py, &self.trajectory.speeds)
    }

    /// Rotation speed of the lowest site, rad/s.
    #[getter]
    fn bit_speed<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        optional(py, self.trajectory.speeds.last()?)
    }

    /// Torque on the bit, N m, positive with the rotation; none where the bit is free.
    #[getter]
    fn bit_torque<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        optional(py, &self.trajectory.bit_torque)
    }

    /// Torque with which the surface is turned, N m; none where it is not followed.
    #[getter]
    fn surface_torque<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        optional(py, &self.trajectory.surface_torque)
    }

    /// Speed of the surface, rad/s; none where it is not followed.
    #[getter]
    fn surface_speed<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        optional(py, &self.trajectory.surface_speed)
    }

    /// Weight on bit, N; none unless the bit cuts what its blades leave.
    #[getter]
    fn weight_on_bit<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, |cut| cut.weight)
    }

    /// Rate of penetration, m/s; none unless the bit cuts.
    #[getter]
    fn rate_of_penetration<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, |cut| cut.rate)
    }

    /// Depth of cut of a blade, the mean of all, m, negative off bottom; none unless the bit cuts.
    #[getter]
    fn depth_of_cut<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, |cut| cut.depth_of_cut)
    }

    /// How far the bit has turned, rad; none unless it cuts.
    #[getter]
    fn bit_angle<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, |cut| cut.angle)
    }

    /// How deep the bit is below where it began, m; none unless it cuts.
    #[getter]
    fn bit_depth<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, |cut| cut.depth)
    }

    /// How deep the rock is that the blades leave, m; none unless the bit cuts.
    #[getter]
    fn rock_depth<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        self.of_cut(py, CutStep::rock_left)
    }

    /// Positions, m, `[site, step, axis]`; none without a wall.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<f64>>> {
        let positions = &self.trajectory.positions;
        self.of_walls(|| planes(py, positions))
    }

    /// Forces of the wall, N, `[site, step, axis]`; none without one.
    #[getter]
    fn wall_forces<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<f64>>> {
        let forces = &self.trajectory.wall_forces;
        self.of_walls(|| planes(py, forces))
    }

    /// Normal forces of the wall, N, `[site, step]`; none without one.
    #[getter]
    fn normal_forces<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<f64>>> {
        let forces = &self.trajectory.normal_forces;
        self.of_walls(|| rows(py, forces))
    }

    /// Torques of friction at the wall, N m, `[site, step]`; none without one.
    #[getter]
    fn wall_torques<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<f64>>> {
        let torques = &self.trajectory.wall_torques;
        self.of_walls(|| rows(py, torques))
    }

    /// Whether sites touch the wall, `[site, step]`; none without one.
    #[getter]
    fn touches<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<bool>>> {
        self.of_walls(|| rows(py, &self.of_touches(|touch| touch != Touch::Free)))
    }

    /// Whether sites roll on the wall, `[site, step]`; none without one.
    #[getter]
    fn rolls<'py>(&self, py: Python<'py>) -> Optional<Bound<'py, PyArrayDyn<bool>>> {
        self.of_walls(|| rows(py, &self.of_touches(|touch| touch == Touch::Rolling)))
    }

    fn __len__(&self) -> usize {
        self.trajectory.times.len()
    }

    fn __repr__(&self) -> String {
        let steps = self.trajectory.times.len();
        format!("<Motion of {} sites in {steps} steps>", self.sites.len())
    }
}

impl Motion {
    /// What there is of motion between walls alone.
    fn of_walls<T>(&self, array: impl FnOnce() -> PyResult<T>) -> Optional<T> {
        let is_lateral = !self.trajectory.positions.is_empty();
        is_lateral.then(array).transpose()
    }

    /// What there is of a bit that cuts alone.
    fn of_cut<'py>(
        &self,
        py: Python<'py>,
        value: fn(&CutStep) -> f64,
    ) -> Option<Bound<'py, PyArray1<f64>>> {
        let values: Vec<f64> = self.trajectory.cut.iter().map(value).collect();
        optional(py, &values)
    }

    fn of_touches(&self, is_so: impl Fn(Touch) -> bool) -> Vec<Vec<bool>> {
        let sites = self.trajectory.touches.iter();
        sites
            .map(|site| site.iter().map(|touch| is_so(*touch)).collect())
            .collect()
    }
}

/// What is followed in some motions, and else empty.
fn optional<'py>(py: Python<'py>, values: &[f64]) -> Option<Bound<'py, PyArray1<f64>>> {
    (!values.is_empty()).then(|| vector(py, values.to_vec()))
}
