//! The axes of a chart in numbers, for a page that draws its maps itself.

use super::MapChart;
use super::panel::scales;
use crate::scale::Scale;

/// An axis of all maps of a chart.
pub struct MapAxis {
    /// Its title, with the unit.
    pub title: String,
    scale: Scale,
    /// Marks at round numbers: the place between the ends, from 0 to 1, and the number.
    pub ticks: Vec<(f64, String)>,
}

impl MapAxis {
    /// The place of a value, from 0 to 1 between the ends; none where the axis has none for it.
    pub fn fraction(&self, value: f64) -> Option<f64> {
        self.scale.fraction(value)
    }

    /// The values at its ends.
    pub fn ends(&self) -> [f64; 2] {
        self.scale.ends()
    }

    /// Whether it is even in the logarithm.
    pub fn is_logarithmic(&self) -> bool {
        self.scale.logarithmic
    }
}

/// The axes of a chart, as its picture has them, each with about `most` numbers.
///
/// ```
/// use plot::{Axis, MapChart, MapGroup, MapPanel, MapPoint, Symbol, map_axes};
///
/// let points = [(40.0, 1.0), (80.0, 100.0)].map(|at| MapPoint { at, symbol: Symbol::Cross });
/// let panel = MapPanel { points: points.to_vec(), ..MapPanel::default() };
/// let chart = MapChart {
///     title: String::new(),
///     axes: [Axis::linear("Weight on bit (kN)"), Axis::logarithmic("Surface speed (rpm)")],
///     marks: Vec::new(),
///     groups: vec![MapGroup { panels: vec![panel], ..MapGroup::default() }],
/// };
/// let [weight, speed] = map_axes(&chart, 5);
/// assert!(weight.ends()[0] <= 40.0 && weight.ends()[1] >= 80.0);
/// // On a logarithmic axis 10 is as far from 1 as 100 is from 10.
/// let [one, ten, hundred] = [1.0, 10.0, 100.0].map(|it| speed.fraction(it).unwrap_or(f64::NAN));
/// assert!((2.0 * ten - one - hundred).abs() < 1e-9);
/// ```
pub fn map_axes(chart: &MapChart, most: usize) -> [MapAxis; 2] {
    let scales = scales(chart, [None; 2]);
    [0, 1].map(|axis| {
        let ticks = scales[axis].ticks(most).into_iter();
        MapAxis {
            title: chart.axes[axis].label.clone(),
            scale: scales[axis],
            ticks: ticks
                .filter_map(|tick| Some((tick.fraction, tick.label?)))
                .collect(),
        }
    })
}
