//! A picture as a PDF file: the paths of its outlines, one after another, on a page of its size.

use anyhow::{Context, Result, bail};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref};
use resvg::tiny_skia::PathSegment;
use resvg::usvg;
use std::io::Write;
use usvg::{FillRule, Group, LineCap, LineJoin, Node, Paint, Path};

/// Points to a CSS pixel.
const POINT: f32 = 0.75;

/// The page of a document of paths.
pub(super) fn pdf_file(tree: &usvg::Tree) -> Result<Vec<u8>> {
    let [width, height] = [tree.size().width(), tree.size().height()].map(|size| POINT * size);
    let mut page = Page {
        content: Content::new(),
        opacities: Vec::new(),
    };
    // From the lower left corner upwards, as PDF counts.
    page.content
        .transform([POINT, 0.0, 0.0, -POINT, 0.0, height]);
    page.group(tree.root(), 1.0)?;
    page.file([width, height])
}

/// What is drawn, and the opacities that it needs.
struct Page {
    content: Content,
    opacities: Vec<[f32; 2]>,
}

impl Page {
    fn group(&mut self, group: &Group, opacity: f32) -> Result<()> {
        if group.clip_path().is_some() || group.mask().is_some() || !group.filters().is_empty() {
            bail!("the plot has what a PDF is not written with");
        }
        let opacity = opacity * group.opacity().get();
        for node in group.children() {
            match node {
                Node::Group(inner) => self.group(inner, opacity)?,
                Node::Path(path) => self.path(path, opacity)?,
                Node::Image(_) | Node::Text(_) => {
                    bail!("the plot has what a PDF is not written with")
                }
            }
        }
        Ok(())
    }

    fn path(&mut self, path: &Path, opacity: f32) -> Result<()> {
        let [fill, stroke] = [
            path.fill().map(|fill| fill.opacity().get()),
            path.stroke().map(|stroke| stroke.opacity().get()),
        ];
        let opacities = [fill, stroke].map(|own| opacity * own.unwrap_or(1.0));
        let name = self.opacity(opacities);
        let content = &mut self.content;
        content.save_state();
        content.set_parameters(Name(name.as_bytes()));
        let at = path.abs_transform();
        content.transform([at.sx, at.ky, at.kx, at.sy, at.tx, at.ty]);
        if let Some(fill) = path.fill() {
            let [red, green, blue] = colour(fill.paint())?;
            content.set_fill_rgb(red, green, blue);
        }
        if let Some(stroke) = path.stroke() {
            let [red, green, blue] = colour(stroke.paint())?;
            content.set_stroke_rgb(red, green, blue);
            set_stroke(content, stroke);
        }
        add_segments(content, path);
        match (path.fill().map(usvg::Fill::rule), path.stroke()) {
            (Some(FillRule::NonZero), Some(_)) => content.fill_nonzero_and_stroke(),
            (Some(FillRule::EvenOdd), Some(_)) => content.fill_even_odd_and_stroke(),
            (Some(FillRule::NonZero), None) => content.fill_nonzero(),
            (Some(FillRule::EvenOdd), None) => content.fill_even_odd(),
            (None, Some(_)) => content.stroke(),
            (None, None) => content.end_path(),
        };
        content.restore_state();
        Ok(())
    }

    /// The name of the opacities of fill and stroke.
    fn opacity(&mut self, opacities: [f32; 2]) -> String {
        let known = self.opacities.iter().position(|other| *other == opacities);
        let place = known.unwrap_or_else(|| {
            self.opacities.push(opacities);
            self.opacities.len() - 1
        });
        name(place)
    }

    fn file(self, [width, height]: [f32; 2]) -> Result<Vec<u8>> {
        let [catalog, pages, page, content] = [1, 2, 3, 4].map(Ref::new);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let mut shown = pdf.page(page);
        shown.media_box(Rect::new(0.0, 0.0, width, height));
        shown.parent(pages).contents(content);
        let mut resources = shown.resources();
        let mut states = resources.ext_g_states();
        for (place, [fill, stroke]) in self.opacities.into_iter().enumerate() {
            let mut state = states.insert(Name(name(place).as_bytes())).start();
            set_opacities(&mut state, fill, stroke);
        }
        states.finish();
        resources.finish();
        shown.finish();
        let mut packed = ZlibEncoder::new(Vec::new(), Compression::default());
        let packed = (packed.write_all(&self.content.finish()))
            .and_then(|()| packed.finish())
            .context("the plot cannot become a PDF")?;
        pdf.stream(content, &packed).filter(Filter::FlateDecode);
        Ok(pdf.finish())
    }
}

fn set_opacities(state: &mut pdf_writer::writers::ExtGraphicsState, fill: f32, stroke: f32) {
    state.non_stroking_alpha(fill).stroking_alpha(stroke);
}

fn name(place: usize) -> String {
    format!("o{place}")
}

fn colour(paint: &Paint) -> Result<[f32; 3]> {
    match paint {
        Paint::Color(colour) => {
            Ok([colour.red, colour.green, colour.blue].map(|part| f32::from(part) / 255.0))
        }
        _ => bail!("the plot has what a PDF is not written with"),
    }
}

fn set_stroke(content: &mut Content, stroke: &usvg::Stroke) {
    content.set_line_width(stroke.width().get());
    content.set_line_cap(match stroke.linecap() {
        LineCap::Butt => LineCapStyle::ButtCap,
        LineCap::Round => LineCapStyle::RoundCap,
        LineCap::Square => LineCapStyle::ProjectingSquareCap,
    });
    content.set_line_join(match stroke.linejoin() {
        LineJoin::Miter | LineJoin::MiterClip => LineJoinStyle::MiterJoin,
        LineJoin::Round => LineJoinStyle::RoundJoin,
        LineJoin::Bevel => LineJoinStyle::BevelJoin,
    });
    let dashes = stroke.dasharray().unwrap_or_default();
    content.set_dash_pattern(dashes.iter().copied(), stroke.dashoffset());
}

/// A quadratic curve is the cubic one whose inner points are two thirds of the way to its own.
fn add_segments(content: &mut Content, path: &Path) {
    let mut at = [0.0; 2];
    for segment in path.data().segments() {
        match segment {
            PathSegment::MoveTo(to) => {
                content.move_to(to.x, to.y);
                at = [to.x, to.y];
            }
            PathSegment::LineTo(to) => {
                content.line_to(to.x, to.y);
                at = [to.x, to.y];
            }
            PathSegment::QuadTo(by, to) => {
                let inner = |from: f32, by: f32| from + 2.0 / 3.0 * (by - from);
                let [first, last] = [at, [to.x, to.y]];
                content.cubic_to(
                    inner(first[0], by.x),
                    inner(first[1], by.y),
                    inner(last[0], by.x),
                    inner(last[1], by.y),
                    to.x,
                    to.y,
                );
                at = last;
            }
            PathSegment::CubicTo(one, two, to) => {
                content.cubic_to(one.x, one.y, two.x, two.y, to.x, to.y);
                at = [to.x, to.y];
            }
            PathSegment::Close => {
                content.close_path();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pdf_of(body: &str) -> Result<Vec<u8>> {
        let svg = format!(
            "<svg width=\"90mm\" height=\"60mm\" viewBox=\"0 0 900 600\" \
             xmlns=\"http://www.w3.org/2000/svg\">{body}</svg>"
        );
        let tree = usvg::Tree::from_str(&svg, &usvg::Options::default()).expect("valid");
        pdf_file(&tree)
    }

    /// 90 mm are 255.118 points.
    #[test]
    fn a_page_is_as_large_as_its_picture() {
        let file = pdf_of("<path d=\"M0 0Q9 9 20 0\" stroke=\"#123456\" fill=\"none\"/>");
        let file = String::from_utf8_lossy(&file.expect("written")).into_owned();
        assert!(file.contains("/MediaBox [0 0 255.1181 170.0787"), "{file}");
    }

    #[test]
    fn what_is_no_path_is_refused() {
        let clipped = "<clipPath id=\"c\"><path d=\"M0 0H9V9z\"/></clipPath>\
                       <path clip-path=\"url(#c)\" d=\"M0 0H20V20z\"/>";
        assert!(pdf_of(clipped).is_err());
    }
}
