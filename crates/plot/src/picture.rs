//! A finished picture, and the files that it becomes.

use thiserror::Error;
use tiny_skia::Pixmap;

use super::pdf::pdf_file;
use super::raster::rasterise;
use super::shapes::Drawing;
use super::svg::document;

/// Raster pixels per pixel of a picture, so that the PNG stays sharp in print.
const PNG_SCALE: f64 = 2.0;

/// Raster pixels to an inch of paper, and millimetres to it.
const PER_INCH: f64 = 600.0;
const MM_PER_INCH: f64 = 25.4;

/// A finished plot.
///
/// The same picture as SVG, PNG and PDF:
///
/// ```
/// use plot::{Axis, Look, Paper, Panel, Series, panels};
///
/// let panel = Panel {
///     axes: ["Time t (s)", "Speed (rpm)"].map(Axis::linear),
///     series: vec![Series::new("the bit", vec![(0.0, 0.0), (1.0, 60.0)])],
///     references: Vec::new(),
///     walls: Vec::new(),
///     is_difference: false,
/// };
/// let paper = Paper::new(90.0, 8.0).map_err(|[least, _]| format!("at least {least} mm"))?;
/// let look = Look { paper: Some(paper), ..Look::default() };
/// let picture = panels(&look, "A start", &[panel]);
/// assert!(picture.svg().starts_with("<svg"));
/// assert!(picture.png()?.starts_with(b"\x89PNG"));
/// assert!(picture.pdf()?.starts_with(b"%PDF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, PartialEq)]
pub struct Picture {
    drawing: Drawing,
}

/// Why a picture cannot become a file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// It has more pixels than an image may have, or none.
    #[error("the plot of {0} by {1} pixels cannot become a PNG")]
    Size(f64, f64),
    /// The PNG cannot be written.
    #[error("the plot cannot become a PNG")]
    Png(#[from] png::EncodingError),
    /// The PDF cannot be written.
    #[error("the plot cannot become a PDF")]
    Pdf(#[from] std::io::Error),
}

impl Picture {
    pub(crate) fn of(drawing: Drawing) -> Self {
        Self { drawing }
    }

    /// The picture as an SVG document, in vectors, its text as text.
    pub fn svg(&self) -> String {
        document(&self.drawing)
    }

    /// The same picture as a PNG file, at twice the size of the SVG; on paper at 600 pixels to
    /// the inch.
    ///
    /// # Errors
    /// Where it is too large.
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        let paper = self.drawing.paper;
        let scale = paper.map_or(PNG_SCALE, |paper| paper.pixel_mm() / MM_PER_INCH * PER_INCH);
        let [width, height] = self.drawing.size;
        let pixels = rasterise(&self.drawing, scale).ok_or(PictureError::Size(width, height))?;
        Ok(png_file(pixels, paper.is_some())?)
    }

    /// The same picture as a PDF file with a page of its size, in vectors, its text as paths.
    ///
    /// # Errors
    /// Where its content cannot be compressed.
    pub fn pdf(&self) -> Result<Vec<u8>, PictureError> {
        Ok(pdf_file(&self.drawing)?)
    }
}

/// Plots are areas of one colour: without filters, and with little search for repetitions, the
/// file is smaller than with what is usual for pictures, and takes half the time. On paper it
/// says how large it is.
fn png_file(pixels: Pixmap, is_on_paper: bool) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(3));
    if is_on_paper {
        let per_metre = (1e3 * PER_INCH / MM_PER_INCH).round() as u32;
        encoder.set_pixel_dims(Some(png::PixelDimensions {
            xppu: per_metre,
            yppu: per_metre,
            unit: png::Unit::Meter,
        }));
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels.take_demultiplied())?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::super::colours::BLACK;
    use super::super::geometry::Pixel;
    use super::super::shapes::{Shape, Stroke};
    use super::*;
    use tiny_skia::PathSegment;

    /// Fails unless all that is filled, text among it, lies inside the picture.
    pub fn assert_text_inside(picture: &Picture) {
        let [width, height] = picture.drawing.size;
        for shape in &picture.drawing.shapes {
            for (x, y) in filled(shape) {
                let is_inside = (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
                assert!(
                    is_inside,
                    "({x}, {y}) is not in the picture of {width} by {height}: {shape:?}"
                );
            }
        }
    }

    /// Places between which all of a filled shape lies.
    fn filled(shape: &Shape) -> Vec<Pixel> {
        match shape {
            Shape::Line { .. } | Shape::Ring { .. } => Vec::new(),
            Shape::Polygon { corners, .. } => corners.clone(),
            Shape::Disc { centre, radius, .. } => [-radius, *radius]
                .map(|far| (centre.0 + far, centre.1 + far))
                .to_vec(),
            Shape::Text(line) => {
                let outlines = line.outlines();
                let is_blank = line.text.trim().is_empty();
                assert!(is_blank || !outlines.is_empty(), "{line:?}");
                let ends = outlines.into_iter().filter_map(|segment| match segment {
                    PathSegment::MoveTo(end)
                    | PathSegment::LineTo(end)
                    | PathSegment::QuadTo(_, end)
                    | PathSegment::CubicTo(_, _, end) => Some((end.x.into(), end.y.into())),
                    PathSegment::Close => None,
                });
                ends.collect()
            }
        }
    }

    fn picture(size: [f64; 2], shapes: Vec<Shape>) -> Picture {
        Picture::of(Drawing {
            size,
            paper: None,
            shapes,
        })
    }

    /// Width, height and the pixels of a PNG, four bytes each.
    fn read(png: &[u8]) -> ([u32; 2], Vec<u8>) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(png))
            .read_info()
            .expect("a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut pixels).expect("pixels");
        ([info.width, info.height], pixels)
    }

    #[test]
    fn the_png_has_twice_the_size_of_the_svg() {
        let disc = Shape::Disc {
            centre: (60.0, 20.0),
            radius: 5.0,
            colour: BLACK,
        };
        let picture = picture([90.0, 62.0], vec![disc]);
        assert!(picture.svg().starts_with("<svg width=\"90\" height=\"62\""));
        let (size, pixels) = read(&picture.png().expect("a PNG"));
        assert_eq!(size, [180, 124]);
        let at = |x: usize, y: usize| pixels[4 * (180 * y + x)..][..4].to_vec();
        assert_eq!(at(120, 40), [0, 0, 0, 255]);
        assert_eq!(at(120, 60), [255; 4]);
    }

    #[test]
    fn what_is_too_large_for_pixels_is_refused() {
        assert!(picture([1e9, 1e9], Vec::new()).png().is_err());
        assert!(picture([0.0, 10.0], Vec::new()).png().is_err());
    }

    #[test]
    fn each_line_has_its_own_dashes_in_every_format() {
        let line = |dash| Shape::Line {
            points: vec![(0.0, 5.0), (50.0, 5.0)],
            stroke: Stroke {
                dash,
                ..Stroke::solid(BLACK, 2.0)
            },
        };
        let of = |dash| picture([50.0, 10.0], vec![line(dash)]);
        let [solid, dashed] = [&[][..], &[9.0, 5.0]].map(of);
        assert!(!solid.svg().contains("dasharray"));
        assert!(dashed.svg().contains("stroke-dasharray=\"9,5\""));
        let [solid, dashed] = [solid, dashed].map(|it| read(&it.png().expect("a PNG")).1);
        // In the middle of the first gap.
        let gap = 4 * (100 * 10 + 23);
        assert_eq!((solid[gap], dashed[gap]), (0, 255));
    }
}
