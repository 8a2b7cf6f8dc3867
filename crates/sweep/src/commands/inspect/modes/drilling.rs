//! Steady drilling at the operating points of a sweep whose bit cuts: how many ways of vibration grow
//! about it.

use std::path::Path;

use anyhow::Result;
use serde::Serialize;

use crate::commands::csv_table::csv_table;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, RATE, Units};
use campaign::words::{counted, short, wrapped};
use limits::{DrillingPoint, drilling_points};
use results::files::write_atomically;

/// How many are described.
const DESCRIBED: usize = 12;

/// The operating points; none unless the bit cuts.
#[derive(Serialize)]
#[serde(transparent)]
pub struct InspectedDrilling(Vec<DrillingPoint>);

impl InspectedDrilling {
    /// Those of a sweep.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn find(sweep: &Sweep) -> Result<Self> {
        Ok(Self(drilling_points(sweep)?))
    }

    /// Writes the table of all, where there are some.
    ///
    /// # Errors
    /// Where the file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        if self.0.is_empty() {
            return Ok(());
        }
        let optional = |value: Option<f64>| value.map_or_else(String::new, |it| it.to_string());
        let rows = self.0.iter().map(|point| {
            let roots = point.growing_roots.map(|count| count.to_string());
            [
                ("case", point.case.to_string()),
                ("surface_speed_rpm", point.surface_speed_rpm.to_string()),
                ("weight_on_bit_kn", optional(point.weight_on_bit_kn)),
                ("feed_m_h", optional(point.feed_m_h)),
                (
                    "steady_rate_of_penetration_m_h",
                    point.rate_of_penetration_m_h.to_string(),
                ),
                ("steady_bit_speed_rpm", point.bit_speed_rpm.to_string()),
                ("steady_torque_nm", point.torque_nm.to_string()),
                ("steady_weight_kn", point.weight_kn.to_string()),
                ("growing_roots", roots.unwrap_or_default()),
            ]
        });
        write_atomically(&folder.join("steady_drilling.csv"), &csv_table(rows)?)
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let Some(first) = self.0.first() else {
            return String::new();
        };
        let counts = self.0.iter().filter_map(|point| point.growing_roots);
        let lasts = counts.clone().filter(|count| *count == 0).count();
        let unknown = self.0.len() - counts.clone().count();
        let most = counts.max().unwrap_or(0);
        let mut title = format!(
            "steady drilling, by the roots of D(s): it lasts at {lasts} of {}",
            counted(self.0.len(), "operating point")
        );
        if most > 0 {
            let roots = counted(most, "root");
            title += &format!("; elsewhere up to {roots} grow, two for each frequency");
        }
        if unknown > 0 {
            title += &format!(
                "; at {unknown} the roots cannot be counted: blades are not even, or resonances too \
                 sharp"
            );
        }
        let (force, rate) = (units.of(&FORCE), units.of(&RATE));
        let set = |point: &DrillingPoint| match (point.weight_on_bit_kn, point.feed_m_h) {
            (Some(weight), _) => short(force.number(weight)),
            (None, Some(feed)) => short(rate.number(feed)),
            (None, None) => String::new(),
        };
        let unit = match first.weight_on_bit_kn {
            Some(_) => &force.name,
            None => &rate.name,
        };
        let mut text = wrapped(&title, 2, 4);
        let line = |cells: [&str; 4]| {
            let [speed, set, rate, grow] = cells;
            format!("    {speed:<10}{set:<10}{rate:<14}{grow}\n")
        };
        let in_m_h = format!("{}, steady", rate.name);
        text += &line(["rpm", unit, &in_m_h, "growing roots"]);
        for point in spread(&self.0) {
            let roots = point.growing_roots.map(|count| count.to_string());
            text += &line([
                &short(point.surface_speed_rpm),
                &set(point),
                &short(rate.number(point.rate_of_penetration_m_h)),
                roots.as_deref().unwrap_or("–"),
            ]);
        }
        if self.0.len() > DESCRIBED {
            text += &format!("    all {} in steady_drilling.csv\n", self.0.len());
        }
        text
    }
}

/// A few of many, evenly from the first to the last.
fn spread(points: &[DrillingPoint]) -> impl Iterator<Item = &DrillingPoint> {
    let shown = points.len().min(DESCRIBED);
    (0..shown).map(move |place| &points[place * (points.len() - 1) / (shown - 1).max(1)])
}
