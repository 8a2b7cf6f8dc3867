//! Makes a finished picture of the SVG of a plot.

use super::text::{FAMILY, FONT};
use anyhow::{Context, Result};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::{tiny_skia, usvg};

/// Raster pixels per SVG pixel, so that the PNG stays sharp in print.
const PNG_SCALE: f32 = 2.0;

/// A finished plot in both formats.
pub struct Picture {
    /// The SVG document.
    pub svg: String,
    /// The same picture as a PNG file, at twice the size of the SVG.
    pub png: Vec<u8>,
    /// The document that the PNG is drawn from.
    #[cfg(test)]
    pub outlines: String,
}

impl Picture {
    /// A document, with the font it is written in, and the same in `outlines`, without text,
    /// rasterised.
    pub(super) fn new(svg: &str, outlines: &str) -> Result<Picture> {
        Ok(Picture {
            svg: with_font(svg)?,
            png: rasterise(outlines)?,
            #[cfg(test)]
            outlines: outlines.to_owned(),
        })
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

/// Renders an SVG document as a PNG file.
fn rasterise(svg: &str) -> Result<Vec<u8>> {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default())
        .context("the plot is not valid SVG")?;
    let size = tree.size().to_int_size().scale_by(PNG_SCALE);
    let size = size.context("the plot has no size")?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height())
        .context("the plot is too large to rasterise")?;
    let transform = tiny_skia::Transform::from_scale(PNG_SCALE, PNG_SCALE);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    png_file(pixels).context("the plot cannot become a PNG")
}

/// Plots are areas of one colour: without filters, and with little search for repetitions, the
/// file is smaller than with what is usual for pictures, and takes half the time.
fn png_file(pixels: tiny_skia::Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.set_deflate_compression(png::DeflateCompression::Level(3));
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
        assert!(rasterise("<svg").is_err());
    }
}
