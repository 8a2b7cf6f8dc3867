//! A picture in pixels of a screen or a printer.

use tiny_skia::{
    Color, FillRule, LineJoin, Paint, Path, PathBuilder, PathSegment, Pixmap, Stroke, StrokeDash,
    Transform,
};

use super::colours::{BLACK, Fill};
use super::geometry::Pixel;
use super::shapes::{self, Drawing, Shape};

/// The pixels of a picture, drawn at `scale` times its size; none where that is too large.
pub(crate) fn rasterise(drawing: &Drawing, scale: f64) -> Option<Pixmap> {
    let [width, height] = drawing.size.map(|length| (scale * length).round() as u32);
    let mut pixels = Pixmap::new(width, height)?;
    pixels.fill(Color::WHITE);
    let mut raster = Raster {
        pixels,
        scale: Transform::from_scale(scale as f32, scale as f32),
    };
    for shape in &drawing.shapes {
        raster.draw(shape);
    }
    Some(raster.pixels)
}

struct Raster {
    pixels: Pixmap,
    scale: Transform,
}

impl Raster {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Line { points, stroke } => self.stroke(polyline(points).finish(), *stroke),
            Shape::Polygon { corners, fill } => {
                let mut path = polyline(corners);
                path.close();
                self.fill(path.finish(), *fill);
            }
            Shape::Ring {
                centre,
                radius,
                stroke,
            } => self.stroke(circle(*centre, *radius), *stroke),
            Shape::Disc {
                centre,
                radius,
                colour,
            } => self.fill(circle(*centre, *radius), (*colour).into()),
            Shape::Text(line) => self.fill(outlines(&line.outlines()), BLACK.into()),
        }
    }

    fn fill(&mut self, path: Option<Path>, fill: Fill) {
        // A path of no area has no inside.
        let path = path.filter(|path| path.bounds().width() > 0.0 && path.bounds().height() > 0.0);
        if let Some(path) = path {
            let rule = FillRule::Winding;
            (self.pixels).fill_path(&path, &paint(fill), rule, self.scale, None);
        }
    }

    fn stroke(&mut self, path: Option<Path>, stroke: shapes::Stroke) {
        let Some(path) = path.filter(|_| stroke.width > 0.0) else {
            return;
        };
        let dash = stroke.dash.iter().map(|&length| length as f32);
        let line = Stroke {
            width: stroke.width as f32,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(dash.collect(), 0.0),
            ..Stroke::default()
        };
        let paint = paint(stroke.colour.into());
        (self.pixels).stroke_path(&path, &paint, &line, self.scale, None);
    }
}

fn paint(fill: Fill) -> Paint<'static> {
    let mut paint = Paint {
        anti_alias: true,
        ..Paint::default()
    };
    let opacity = (255.0 * fill.opacity).round() as u8;
    paint.set_color_rgba8(fill.colour.0, fill.colour.1, fill.colour.2, opacity);
    paint
}

fn polyline(points: &[Pixel]) -> PathBuilder {
    let mut path = PathBuilder::new();
    for (place, &(x, y)) in points.iter().enumerate() {
        let (x, y) = (x as f32, y as f32);
        if place == 0 {
            path.move_to(x, y);
        } else {
            path.line_to(x, y);
        }
    }
    path
}

fn circle((x, y): Pixel, radius: f64) -> Option<Path> {
    PathBuilder::from_circle(x as f32, y as f32, radius as f32)
}

fn outlines(letters: &[PathSegment]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for segment in letters {
        match *segment {
            PathSegment::MoveTo(end) => path.move_to(end.x, end.y),
            PathSegment::LineTo(end) => path.line_to(end.x, end.y),
            PathSegment::QuadTo(by, end) => path.quad_to(by.x, by.y, end.x, end.y),
            PathSegment::CubicTo(one, two, end) => {
                path.cubic_to(one.x, one.y, two.x, two.y, end.x, end.y);
            }
            PathSegment::Close => path.close(),
        }
    }
    path.finish()
}
