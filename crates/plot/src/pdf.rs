//! A picture as a PDF file: its shapes, one after another, on a page of its size.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::LineJoinStyle;
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref};
use std::io::{self, Write};
use tiny_skia::{PathSegment, Point};

use super::colours::{BLACK, Colour, Fill, WHITE};
use super::geometry::Pixel;
use super::shapes::{Drawing, Shape, Stroke};

/// Points to a pixel of a screen, and to a millimetre.
const PER_PIXEL: f64 = 0.75;
const PER_MM: f64 = 72.0 / 25.4;

/// How far the inner points of a cubic curve are from its ends that is a quarter of a circle, in
/// radii.
const QUARTER: f32 = 0.552_284_8;

/// The page of a picture.
pub(crate) fn pdf_file(drawing: &Drawing) -> io::Result<Vec<u8>> {
    let points = (drawing.paper).map_or(PER_PIXEL, |paper| PER_MM * paper.pixel_mm());
    let [width, height] = drawing.size.map(|length| (points * length) as f32);
    let mut page = Page {
        content: Content::new(),
        opacities: Vec::new(),
    };
    let content = &mut page.content;
    set_fill(content, WHITE);
    content.rect(0.0, 0.0, width, height).fill_nonzero();
    // From the lower left corner upwards, as PDF counts.
    let points = points as f32;
    content.transform([points, 0.0, 0.0, -points, 0.0, height]);
    content.set_line_join(LineJoinStyle::RoundJoin);
    for shape in &drawing.shapes {
        page.draw(shape);
    }
    page.file([width, height])
}

/// What is drawn, and the opacities that it needs.
struct Page {
    content: Content,
    opacities: Vec<f64>,
}

impl Page {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { points, stroke } => self.stroke(*stroke, |content| {
                add_points(content, points);
            }),
            Shape::Polygon { corners, fill } => self.fill(*fill, |content| {
                add_points(content, corners);
                content.close_path();
            }),
            Shape::Ring {
                centre,
                radius,
                stroke,
            } => self.stroke(*stroke, |content| add_circle(content, *centre, *radius)),
            Shape::Disc {
                centre,
                radius,
                colour,
            } => self.fill((*colour).into(), |content| {
                add_circle(content, *centre, *radius);
            }),
            Shape::Text(line) => self.fill(BLACK.into(), |content| {
                add_outlines(content, &line.outlines());
            }),
        }
    }

    fn fill(&mut self, fill: Fill, path: impl FnOnce(&mut Content)) {
        let name = self.opacity(fill.opacity);
        self.content.set_parameters(Name(name.as_bytes()));
        set_fill(&mut self.content, fill.colour);
        path(&mut self.content);
        self.content.fill_nonzero();
    }

    fn stroke(&mut self, stroke: Stroke, path: impl FnOnce(&mut Content)) {
        let [red, green, blue] = parts(stroke.colour);
        let dash = stroke.dash.iter().map(|&length| length as f32);
        (self.content)
            .set_stroke_rgb(red, green, blue)
            .set_line_width(stroke.width as f32)
            .set_dash_pattern(dash, 0.0);
        path(&mut self.content);
        self.content.stroke();
    }

    /// The name of an opacity.
    fn opacity(&mut self, opacity: f64) -> String {
        let known = self.opacities.iter().position(|other| *other == opacity);
        name(known.unwrap_or_else(|| {
            self.opacities.push(opacity);
            self.opacities.len() - 1
        }))
    }

    fn file(self, [width, height]: [f32; 2]) -> io::Result<Vec<u8>> {
        let [catalog, pages, page, content] = [1, 2, 3, 4].map(Ref::new);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let mut shown = pdf.page(page);
        shown.media_box(Rect::new(0.0, 0.0, width, height));
        shown.parent(pages).contents(content);
        let mut resources = shown.resources();
        let mut states = resources.ext_g_states();
        for (place, opacity) in self.opacities.into_iter().enumerate() {
            let mut state = states.insert(Name(name(place).as_bytes())).start();
            set_opacity(&mut state, opacity as f32);
        }
        states.finish();
        resources.finish();
        shown.finish();
        let mut packed = ZlibEncoder::new(Vec::new(), Compression::default());
        packed.write_all(&self.content.finish())?;
        pdf.stream(content, &packed.finish()?)
            .filter(Filter::FlateDecode);
        Ok(pdf.finish())
    }
}

fn set_opacity(state: &mut pdf_writer::writers::ExtGraphicsState, opacity: f32) {
    state.non_stroking_alpha(opacity);
}

fn name(place: usize) -> String {
    format!("o{place}")
}

fn parts(Colour(red, green, blue): Colour) -> [f32; 3] {
    [red, green, blue].map(|part| f32::from(part) / 255.0)
}

fn set_fill(content: &mut Content, colour: Colour) {
    let [red, green, blue] = parts(colour);
    content.set_fill_rgb(red, green, blue);
}

fn add_points(content: &mut Content, points: &[Pixel]) {
    for (place, &(x, y)) in points.iter().enumerate() {
        let (x, y) = (x as f32, y as f32);
        if place == 0 {
            content.move_to(x, y);
        } else {
            content.line_to(x, y);
        }
    }
}

/// Four quarters, from the right one on.
fn add_circle(content: &mut Content, (x, y): Pixel, radius: f64) {
    let (x, y, radius) = (x as f32, y as f32, radius as f32);
    content.move_to(x + radius, y);
    for [right, down] in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
        // From here a quarter on, where right is what down was, and down what left was.
        let at = |along: f32, on: f32| {
            (
                x + radius * (along * right - on * down),
                y + radius * (along * down + on * right),
            )
        };
        let (one, two, end) = (at(1.0, QUARTER), at(QUARTER, 1.0), at(0.0, 1.0));
        content.cubic_to(one.0, one.1, two.0, two.1, end.0, end.1);
    }
    content.close_path();
}

/// A quadratic curve is the cubic one whose inner points are two thirds of the way to its own.
fn add_outlines(content: &mut Content, letters: &[PathSegment]) {
    let mut at = Point::zero();
    for segment in letters {
        match *segment {
            PathSegment::MoveTo(end) => {
                content.move_to(end.x, end.y);
                at = end;
            }
            PathSegment::LineTo(end) => {
                content.line_to(end.x, end.y);
                at = end;
            }
            PathSegment::QuadTo(by, end) => {
                let inner = |from: f32, by: f32| from + 2.0 / 3.0 * (by - from);
                let [one, two] = [at, end].map(|from| (inner(from.x, by.x), inner(from.y, by.y)));
                content.cubic_to(one.0, one.1, two.0, two.1, end.x, end.y);
                at = end;
            }
            PathSegment::CubicTo(one, two, end) => {
                content.cubic_to(one.x, one.y, two.x, two.y, end.x, end.y);
                at = end;
            }
            PathSegment::Close => {
                content.close_path();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::look::Paper;
    use super::*;

    fn drawing(paper: Option<Paper>) -> Drawing {
        Drawing {
            size: [446.5, 300.0],
            paper,
            shapes: vec![Shape::Disc {
                centre: (100.0, 50.0),
                radius: 10.0,
                colour: BLACK,
            }],
        }
    }

    /// 90 mm are 255.118 points.
    #[test]
    fn a_page_is_as_large_as_its_picture() {
        let page = |paper| {
            let file = pdf_file(&drawing(paper)).expect("written");
            String::from_utf8_lossy(&file).into_owned()
        };
        let paper = Paper::new(90.0, 8.0).expect("room");
        let on_paper = page(Some(paper));
        assert!(on_paper.contains("/MediaBox [0 0 255.14"), "{on_paper}");
        let on_screen = page(None);
        assert!(
            on_screen.contains("/MediaBox [0 0 334.875 225]"),
            "{on_screen}"
        );
    }

    /// Each quarter begins where the one before ends, and a circle ends where it begins.
    #[test]
    fn a_circle_goes_round_its_centre() {
        let mut content = Content::new();
        add_circle(&mut content, (100.0, 50.0), 10.0);
        let written = content.finish();
        let written = String::from_utf8_lossy(&written);
        let ends: Vec<&str> = (written.lines())
            .filter_map(|line| line.strip_suffix(" c"))
            .filter_map(|curve| {
                curve
                    .match_indices(' ')
                    .nth(3)
                    .map(|(at, _)| &curve[at + 1..])
            })
            .collect();
        assert_eq!(ends, ["100 60", "90 50", "100 40", "110 50"], "{written}");
    }
}
