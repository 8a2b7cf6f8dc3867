//! Makes a finished picture of the SVG of a plot.

use super::text::{FAMILY, FONT};
use anyhow::{Context, Result};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use resvg::{tiny_skia, usvg};
use std::sync::Arc;

/// Raster pixels per SVG pixel, so that the PNG stays sharp in print.
const PNG_SCALE: f32 = 2.0;

/// A finished plot in both formats.
pub struct Picture {
    /// The SVG document.
    pub svg: String,
    /// The same picture as a PNG file, at twice the size of the SVG.
    pub png: Vec<u8>,
}

impl Picture {
    /// Rasterises `svg` and keeps both.
    pub(super) fn from_svg(svg: String) -> Result<Picture> {
        let png = rasterise(&svg)?;
        let svg = with_font(&svg)?;
        Ok(Picture { svg, png })
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
    let options = usvg::Options {
        fontdb: Arc::new(fonts()),
        ..usvg::Options::default()
    };
    let tree = usvg::Tree::from_str(svg, &options).context("the plot is not valid SVG")?;
    let size = tree.size().to_int_size().scale_by(PNG_SCALE);
    let size = size.context("the plot has no size")?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height())
        .context("the plot is too large to rasterise")?;
    let transform = tiny_skia::Transform::from_scale(PNG_SCALE, PNG_SCALE);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels.encode_png().context("the plot cannot become a PNG")
}

/// A font database that holds the embedded font alone, as sans-serif.
pub(super) fn fonts() -> usvg::fontdb::Database {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family(FAMILY);
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dark_pixels(svg: &str) -> usize {
        let png = rasterise(svg).expect("valid SVG");
        let pixels = tiny_skia::Pixmap::decode_png(&png).expect("valid PNG");
        pixels.pixels().iter().filter(|p| p.alpha() > 128).count()
    }

    #[test]
    fn the_embedded_font_draws_greek_and_subscripts() {
        for letter in ["ω", "Ω", "₀", "ₛ", "−", "×", "⁻"] {
            let svg = format!(
                "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>\
                 <text x='5' y='30' font-size='30' font-family='sans-serif'>{letter}</text></svg>"
            );
            assert!(dark_pixels(&svg) > 0, "{letter} left no ink");
        }
    }

    #[test]
    fn a_broken_document_is_an_error() {
        assert!(rasterise("<svg").is_err());
    }
}
