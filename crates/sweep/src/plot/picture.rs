//! Makes a finished picture of the SVG of a plot.

use super::look::Paper;
use super::pdf::pdf_file;
use super::text::{FAMILY, FONT};
use anyhow::{Context, Result};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::{tiny_skia, usvg};

/// Raster pixels per SVG pixel, so that the PNG stays sharp in print.
const PNG_SCALE: f32 = 2.0;

/// Raster pixels to an inch of paper, and CSS pixels to it.
const PER_INCH: f32 = 600.0;
const CSS_PER_INCH: f32 = 96.0;

/// A finished plot.
pub struct Picture {
    /// The SVG document.
    pub svg: String,
    /// The same document without text, which files of other formats are made of.
    pub(super) outlines: String,
    paper: Option<Paper>,
}

impl Picture {
    /// A document, with the font it is written in, and the same in `outlines`, without text.
    pub(super) fn new(svg: &str, outlines: String, paper: Option<Paper>) -> Result<Picture> {
        Ok(Picture {
            svg: with_font(svg)?,
            outlines,
            paper,
        })
    }

    /// The same picture as a PNG file, at twice the size of the SVG; on paper at 600 pixels to
    /// the inch.
    ///
    /// # Errors
    /// Where it is too large.
    pub fn png(&self) -> Result<Vec<u8>> {
        let scale = match self.paper {
            None => PNG_SCALE,
            Some(_) => PER_INCH / CSS_PER_INCH,
        };
        let pixels = rasterise(&self.tree()?, scale)?;
        png_file(pixels, self.paper.is_some()).context("the plot cannot become a PNG")
    }

    /// The same picture as a PDF file with a page of its size, in vectors, its text as paths.
    ///
    /// # Errors
    /// Where it has what is no path.
    pub fn pdf(&self) -> Result<Vec<u8>> {
        pdf_file(&self.tree()?)
    }

    fn tree(&self) -> Result<usvg::Tree> {
        usvg::Tree::from_str(&self.outlines, &usvg::Options::default())
            .context("the plot is not valid SVG")
    }
}

/// The document with its font. A program that does not read fonts from there takes
/// another without serifs.
fn with_font(svg: &str) -> Result<String> {
    let (start, content) = svg.split_once('>').context("the plot has no content")?;
    let asked = format!("font-family=\"{FAMILY}\"");
    let with_others = format!("font-family=\"'{FAMILY}', sans-serif\"");
    Ok(format!(
        "{start}>\n<style>@font-face {{ font-family: '{FAMILY}'; \
         src: url(data:font/ttf;base64,{}) }}</style>{}",
        STANDARD.encode(FONT),
        content.replace(&asked, &with_others)
    ))
}

/// The pixels of a document.
fn rasterise(tree: &usvg::Tree, scale: f32) -> Result<tiny_skia::Pixmap> {
    let size = tree.size().to_int_size().scale_by(scale);
    let size = size.context("the plot has no size")?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height())
        .context("the plot is too large to rasterise")?;
    let transform = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(tree, transform, &mut pixels.as_mut());
    Ok(pixels)
}

/// Plots are areas of one colour: without filters, and with little search for repetitions, the
/// file is smaller than with what is usual for pictures, and takes half the time. On paper it
/// says how large it is.
fn png_file(pixels: tiny_skia::Pixmap, is_on_paper: bool) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(3));
    if is_on_paper {
        let per_metre = (PER_INCH / 0.0254).round() as u32;
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
mod tests {
    use super::*;

    #[test]
    fn a_broken_document_is_an_error() {
        let picture = Picture::new("<svg>", "<svg".to_owned(), None).expect("made");
        assert!(picture.png().is_err() && picture.pdf().is_err());
    }
}
