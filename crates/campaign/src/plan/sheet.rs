//! The string as on a BHA sheet, and parts such as none are made: their radii are
//! more likely diameters.

use linear::Tube;

use super::sweep::Sweep;
use crate::quantities::{FOOT, INCH, POUND};
use crate::sweep_file::ToolKind;

/// One pound per foot, kg/m.
pub const POUND_PER_FOOT: f64 = POUND / FOOT;

/// A drill collar of 14 in with a bore of 3 in, of steel, is the heaviest in makers'
/// tables, and has about this mass, lb/ft.
const HEAVIEST_LB_FT: f64 = 500.0;

/// The largest drill pipe of API Spec 5DP is so wide, in.
const WIDEST_PIPE_IN: f64 = 6.625;

/// The bore of drill pipe is more than this part of its diameter, that of collars less.
const THIN_WALLED: f64 = 0.7;

/// A joint is no longer than this fraction of the body next to it; a tool joint on a single
/// of pipe is a twentieth.
const JOINT: f64 = 0.2;

impl Sweep {
    /// Mass of a part, kg/m.
    pub fn mass_per_length(&self, part: &Tube) -> f64 {
        self.setting.string.material().density * part.area()
    }

    /// What is doubtful of the string, with line and key of the file that says it.
    pub(super) fn doubts_about_string(&self) -> Vec<String> {
        let mut doubts = Vec::new();
        for (index, section) in self.setting.string.sections().iter().enumerate() {
            let row = (self.sheet.as_ref()).and_then(|sheet| Some((sheet, sheet.rows.get(index)?)));
            for (place, part) in section.parts.iter().enumerate() {
                // Tools on a sheet may be wider than pipe.
                let is_tool = row.is_some_and(|(_, row)| row.kind == ToolKind::Tool);
                let Some(doubt) = self.doubt(part, &section.parts, is_tool) else {
                    continue;
                };
                doubts.push(match row {
                    Some((sheet, row)) => {
                        let (file, line, name) = (&sheet.file, row.line, &row.name);
                        format!("{file}:{line}: {name}: {doubt}; is a diameter in another unit?")
                    }
                    None => {
                        let key = format!("string.sections[{index}].parts[{place}].outer_radius_m");
                        let doubt = format!("{doubt}; are its radii diameters?");
                        self.source.error(&key, doubt).to_string()
                    }
                });
            }
        }
        doubts
    }

    /// What is doubtful of a part of a cell.
    fn doubt(&self, part: &Tube, cell: &[Tube], is_tool: bool) -> Option<String> {
        let diameter = 2.0 * part.outer_radius;
        let mass = self.mass_per_length(part);
        if mass > HEAVIEST_LB_FT * POUND_PER_FOOT {
            return Some(format!(
                "the part has {mass:.0} kg/m ({:.0} lb/ft), and the heaviest collars made \
                 {HEAVIEST_LB_FT} lb/ft",
                mass / POUND_PER_FOOT
            ));
        }
        let is_pipe = !is_tool && part.inner_radius > THIN_WALLED * part.outer_radius;
        if is_pipe && diameter > WIDEST_PIPE_IN * INCH {
            return Some(format!(
                "the part is {} wide with a thin wall, and the widest drill pipe made \
                 {WIDEST_PIPE_IN} in",
                width(diameter)
            ));
        }
        let joints = (cell.iter()).filter(|joint| joint.length <= JOINT * part.length);
        let widest = joints
            .map(|joint| 2.0 * joint.outer_radius)
            .reduce(f64::max)?;
        (diameter > widest).then(|| {
            format!(
                "the part is {} wide, wider than its joint of {}",
                width(diameter),
                width(widest)
            )
        })
    }
}

/// A width (m) in millimetres and inches.
fn width(width: f64) -> String {
    format!("{:.1} mm ({:.3} in)", 1e3 * width, width / INCH)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// Steel, in cells of a body and perhaps a joint: length, inner and outer diameter.
    fn doubts(parts: &[[f64; 3]]) -> String {
        let parts = parts.iter().map(|[length, inner, outer]| {
            let [inner, outer] = [inner, outer].map(|diameter| 0.5 * diameter);
            format!("{{ length_m = {length}, inner_radius_m = {inner}, outer_radius_m = {outer} }}")
        });
        let parts: Vec<String> = parts.collect();
        let text = format!(
            "surface_speed_rpm = 60\n[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 1\n[[string.sections]]\nrepeat = 3\nparts = [{}]\n",
            parts.join(", ")
        );
        let sweep = Sweep::read_from(Path::new("a.toml"), &[], &|_, _| Ok(text.clone())).unwrap();
        sweep.doubts_about_string().concat()
    }

    fn inches(parts: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let metres = |[length, inner, outer]: &[f64; 3]| [*length, inner * INCH, outer * INCH];
        parts.iter().map(metres).collect()
    }

    /// Sizes of makers' tables.
    #[test]
    fn what_is_made_is_not_doubted() {
        for made in [
            // Drill pipe of 5, 6 5/8 and 2 3/8 in with its joint; heavy-weight pipe of 5 in
            // with upset and joint; collars of 3 1/8, 8 and 14 in.
            &[[9.05, 4.276, 5.0], [0.45, 3.25, 6.625]][..],
            &[[9.05, 5.965, 6.625], [0.45, 5.0, 8.25]],
            &[[9.05, 1.815, 2.375], [0.4, 1.75, 3.375]],
            &[[7.0, 3.0, 5.0], [0.6, 3.0, 5.5], [1.2, 3.0, 6.5]],
            &[[9.3, 1.25, 3.125]],
            &[[9.3, 2.8125, 8.0]],
            &[[9.3, 3.0, 14.0]],
        ] {
            assert_eq!(doubts(&inches(made)), "");
        }
        // The paper's string.
        assert_eq!(doubts(&[[9.5, 0.1, 0.25], [0.5, 0.1, 0.3]]), "");
        assert_eq!(doubts(&[[10.0, 0.1, 0.3]]), "");
    }

    #[test]
    fn diameters_for_radii_are_doubted_with_line_and_key() {
        let twice = |parts: &[[f64; 3]]| {
            let wide = |[length, inner, outer]: &[f64; 3]| [*length, 2.0 * inner, 2.0 * outer];
            inches(&parts.iter().map(wide).collect::<Vec<_>>())
        };
        let pipe = doubts(&twice(&[[9.05, 4.276, 5.0], [0.45, 3.25, 6.625]]));
        let place = "a.toml:8: `string.sections[0].parts[0].outer_radius_m`: ";
        assert!(
            pipe.starts_with(place) && pipe.contains("254.0 mm (10.000 in)"),
            "{pipe}"
        );
        let collar = doubts(&twice(&[[9.3, 2.8125, 8.0]]));
        assert!(collar.contains("(600 lb/ft)"), "{collar}");
        // The pipe alone typed as diameters, and so wider than its joint.
        let thick = [[7.0, 6.0, 10.0], [0.6, 3.0, 6.5]];
        let mixed = doubts(&inches(&thick));
        assert!(
            mixed.contains("wider than its joint of 165.1 mm (6.500 in)"),
            "{mixed}"
        );
    }
}
