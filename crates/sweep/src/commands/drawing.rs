//! Pictures in a folder: the map of its results and all other drawings, in the formats and the size
//! that are asked for.

use std::path::Path;

use anyhow::{Result, bail, ensure};

use super::status::UsageError;
use crate::cli::{PictureArguments, PictureFormat, RangeArguments};
use crate::map;
use plot::{Look, Panel, Paper, Picture, map_chart};
use results::files::write_atomically;
use results::folder::{Manifest, ResultTables};

/// How pictures look, and the formats that they are written in.
pub struct Drawing {
    /// How they look.
    pub look: Look,
    formats: Vec<PictureFormat>,
}

impl Default for Drawing {
    fn default() -> Self {
        Self {
            look: Look::default(),
            formats: vec![PictureFormat::Svg, PictureFormat::Png],
        }
    }
}

impl Drawing {
    /// What is asked for.
    ///
    /// # Errors
    /// Where text of that size has no room in that width.
    pub fn of(arguments: &PictureArguments) -> Result<Self> {
        let font = arguments.font_size;
        let paper = match arguments
            .width
            .map(|width| Paper::new(width.mm(), font.points()))
        {
            None => None,
            Some(Ok(paper)) => Some(paper),
            Some(Err([least, greatest])) => bail!(UsageError(format!(
                "--width: with --font-size {} pt a picture is from {:.0} to {:.0} mm wide",
                (100.0 * font.points()).round() / 100.0,
                least.ceil(),
                greatest.floor()
            ))),
        };
        Ok(Self {
            look: Look {
                paper,
                title: (arguments.title.clone()).map(|title| match title.as_str() {
                    "none" => String::new(),
                    _ => title,
                }),
                ranges: [None; 2],
            },
            formats: arguments.format.clone(),
        })
    }

    /// The same with ranges of its axes.
    pub fn over(mut self, ranges: &RangeArguments) -> Self {
        self.look.ranges = [ranges.x_range, ranges.y_range].map(|range| range.map(|it| it.0));
        self
    }

    /// Writes a picture in every format.
    ///
    /// # Errors
    /// Where a file cannot be made.
    pub fn save(&self, folder: &Path, name: &str, picture: &Picture) -> Result<()> {
        for (format, file) in self.formats.iter().zip(self.files(name)) {
            let content = match format {
                PictureFormat::Svg => picture.svg().into_bytes(),
                PictureFormat::Png => picture.png()?,
                PictureFormat::Pdf => picture.pdf()?,
            };
            write_atomically(&folder.join(file), &content)?;
        }
        Ok(())
    }

    /// The files of a picture.
    pub fn files(&self, name: &str) -> Vec<String> {
        let files = self.formats.iter();
        files
            .map(|format| format!("{name}.{}", format.ending()))
            .collect()
    }

    /// Of the files of a picture the one to look at.
    pub fn shown(&self, name: &str) -> String {
        let is_png = self.formats.contains(&PictureFormat::Png);
        let shown = if is_png {
            Some(&PictureFormat::Png)
        } else {
            self.formats.first()
        };
        format!("{name}.{}", shown.map_or("", |format| format.ending()))
    }

    /// The formats, in words.
    pub fn words(&self) -> String {
        let endings: Vec<&str> = self.formats.iter().map(|format| format.ending()).collect();
        match endings.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
            _ => endings.concat(),
        }
    }
}

/// Draws the map of a finished run in a folder that is held, and notes its checksums.
pub fn draw_and_note(folder: &Path, manifest: &mut Manifest, drawing: &Drawing) -> Result<bool> {
    let drawn = draw_map(&ResultTables::finished(folder)?, folder, drawing)?;
    if drawn && manifest.has_checksums() {
        let files = drawing.files("map");
        let files: Vec<&str> = files.iter().map(String::as_str).collect();
        manifest.note(folder, &files)?;
        manifest.write(folder)?;
    }
    Ok(drawn)
}

/// Draws the map of a results folder's tables into a folder; false where its design has no two
/// axes.
pub fn draw_map(tables: &ResultTables, folder: &Path, drawing: &Drawing) -> Result<bool> {
    let Some(map) = map::drawing(tables)? else {
        return Ok(false);
    };
    let options = ["--x-range", "--y-range"];
    for ((axis, ends), option) in map.chart.axes.iter().zip(drawing.look.ranges).zip(options) {
        let has_place = ends.is_none_or(|[from, _]| !axis.logarithmic || from > 0.0);
        let message = format!("{option}: a logarithmic axis begins above zero");
        ensure!(has_place, UsageError(message));
    }
    drawing.save(folder, "map", &map_chart(&drawing.look, &map.chart))?;
    Ok(true)
}

/// Writes a picture as on a screen, in its two formats.
pub fn save_picture(folder: &Path, name: &str, picture: &Picture) -> Result<()> {
    Drawing::default().save(folder, name, picture)
}

/// The numbers that panels show: a row a point, with the titles of its axes and the name of its
/// curve.
///
/// # Errors
/// Where they make no table.
pub fn panels_csv(panels: &[Panel]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["curve", "x_axis", "y_axis", "x", "y"])?;
    for panel in panels {
        let [x_axis, y_axis] = [0, 1].map(|axis| panel.axes[axis].label.as_str());
        for series in &panel.series {
            for (x, y) in &series.points {
                let [x, y] = [x, y].map(f64::to_string);
                writer.write_record([series.name.as_str(), x_axis, y_axis, &x, &y])?;
            }
        }
    }
    Ok(writer.into_inner()?)
}
