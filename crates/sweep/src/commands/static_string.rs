//! The string at rest in its hole, as a picture and as tables.

use std::path::Path;

use anyhow::Result;
use statics::{ContactState, Place};

use super::csv_table::csv_table;
use super::drawing::Drawing;
use campaign::quantities::{FORCE, LENGTH, TORQUE, Unit, Units, WIDTH};
use campaign::static_string::{NamedFields, StaticString};
use plot::{Axis, LineStyle, Look, Panel, Picture, Series, Wall, panels};
use results::files::write_atomically;

/// The part of the string that is drawn, from the bit up, m: above it the same returns at every joint.
const REACH_SHOWN: f64 = 120.0;

/// What its files are called.
pub const NAME: &str = "static_string";

/// A string, and how it is shown.
pub struct ShownString<'a> {
    /// The string.
    pub string: &'a StaticString,
    /// Title of its sweep.
    pub title: &'a str,
    /// The units of that.
    pub units: Units,
}

impl ShownString<'_> {
    /// Writes its picture and its tables.
    ///
    /// # Errors
    /// Where a file cannot be written.
    pub fn write(&self, folder: &Path, drawing: &Drawing) -> Result<()> {
        drawing.save(folder, NAME, &self.picture(&drawing.look.with_own_ranges()))?;
        write_atomically(
            &folder.join("static_string.csv"),
            &csv(&self.string.along())?,
        )?;
        write_atomically(
            &folder.join("static_contacts.csv"),
            &csv(&self.string.sites())?,
        )
    }

    /// Its deflection, its contact forces and its moment, next to the bit.
    fn picture(&self, look: &Look) -> Picture {
        let title = format!("{}: at rest in its hole", self.title);
        panels(look, &title, &self.panels())
    }

    fn panels(&self) -> [Panel; 3] {
        let units = self.units;
        let [length, width, force] = [&LENGTH, &WIDTH, &FORCE].map(|twin| units.of(twin));
        let torque = units.of(&TORQUE).kilo();
        let contacts = || {
            let near = |it: &&ContactState| it.contact.distance_from_bit <= REACH_SHOWN;
            self.string.state.contacts().iter().rev().filter(near)
        };
        let places = || {
            let mut places: Vec<Place> = self.string.state.along().collect();
            places.reverse();
            places.retain(|it| it.distance_from_bit <= REACH_SHOWN);
            places
        };
        let along = |name: &str, unit: &Unit, value: &dyn Fn(&Place) -> f64| {
            let point = |it: &Place| (length.number(it.distance_from_bit), unit.number(value(it)));
            Series::new(name, places().iter().map(point).collect())
        };
        let panel = |label: String, series: Vec<Series>, walls: Vec<Wall>| Panel {
            axes: [format!("Distance from the bit ({})", length.name), label].map(Axis::linear),
            series,
            references: Vec::new(),
            walls,
            is_difference: false,
        };
        let wall = |sign: f64| {
            let points = contacts().map(|it| {
                let clearance = sign * 1e3 * it.contact.clearance;
                let distance = it.contact.distance_from_bit;
                (length.number(distance), width.number(clearance))
            });
            let points: Vec<(f64, f64)> = points.collect();
            Wall {
                name: "clearance, sites as rings".to_owned(),
                line: points.clone(),
                known: points,
            }
        };
        let stems = contacts().filter(|it| it.touches).flat_map(|it| {
            let distance = length.number(it.contact.distance_from_bit);
            let pressed = force.number(1e-3 * it.normal());
            [(distance, 0.0), (distance, pressed), (f64::NAN, f64::NAN)]
        });
        let soft = contacts()
            .zip(self.string.soft.iter().rev())
            .filter_map(|(it, soft)| {
                let distance = length.number(it.contact.distance_from_bit);
                soft.map(|pressed| (distance, force.number(1e-3 * pressed)))
            });
        [
            panel(
                format!("Displacement ({})", width.name),
                vec![
                    along("to the high side", &width, &|it| {
                        1e3 * it.by_high_side(it.displacement)[0]
                    }),
                    along("to the right, looking down", &width, &|it| {
                        1e3 * it.by_high_side(it.displacement)[1]
                    }),
                ],
                vec![wall(1.0), wall(-1.0)],
            ),
            panel(
                format!("Contact force ({})", force.name),
                vec![
                    Series::new("contact force", stems.collect()).styled(LineStyle::numbered(2, 0)),
                    Series::new("string without stiffness", soft.collect())
                        .styled(LineStyle::grey(1)),
                ],
                Vec::new(),
            ),
            panel(
                format!("Bending moment ({})", torque.name),
                vec![along("bending moment", &torque, &|it| {
                    1e-3 * it.moment[0].hypot(it.moment[1])
                })],
                Vec::new(),
            ),
        ]
    }
}

fn csv<const COLUMNS: usize>(rows: &[NamedFields<COLUMNS>]) -> Result<Vec<u8>> {
    let text = |value: Option<f64>| value.map_or_else(String::new, |it| it.to_string());
    csv_table(
        rows.iter()
            .map(|row| row.map(|(name, value)| (name, text(value)))),
    )
}
