//! A film of what stands upright between walls: frames of the same scale, in rows. In each its
//! displacements along x and y are curves, and its radius is shaded to both sides.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::{BLUE, BOUND, ORANGE_GROUND, SKY};
use super::frame::Frame;
use super::geometry::{Pixel, Rect, thin};
use super::legend::{Key, Legend};
use super::lettering::Align;
use super::look::Look;
use super::picture::Picture;
use super::scale::{Axis, Scale};
use super::shapes::{DASHES, Stroke};
use super::symbols::draw_dot;
use super::text::{Block, LABEL_SIZE};

const WIDTH: f64 = 1180.0;
const FRAME_HEIGHT: f64 = 350.0;
/// Frames of a row, and the least width of one.
const COLUMNS: usize = 6;
const LEAST_WIDTH: f64 = 140.0;
const MARGIN: f64 = 14.0;
/// Distance between frames, and between those side by side, whose numbers reach beyond
/// them.
const GAP: f64 = 14.0;
const COLUMN_GAP: f64 = 26.0;
const X: Stroke = Stroke::solid(BLUE, 1.6);
const Y: Stroke = Stroke {
    colour: ORANGE_GROUND,
    width: 1.4,
    dash: DASHES[2],
};
const WALL: Stroke = Stroke {
    colour: BOUND,
    width: 0.8,
    dash: DASHES[1],
};
/// The wall at a dot: a bar so far up and down where there is room.
const WALL_AT_DOT: Stroke = Stroke::solid(BOUND, 2.2);
const REACH: f64 = 6.0;
/// A dot where there is room.
const RADIUS: f64 = 4.0;
const LEAST_RADIUS: f64 = 2.2;

/// Shapes between walls, from time to time.
pub struct Film {
    /// Title above all.
    pub title: String,
    /// Horizontal axis, of displacements, and vertical axis.
    pub axes: [Axis; 2],
    /// Places along the vertical axis, in order.
    pub places: Vec<f64>,
    /// The walls: their distance from the middle at corners, each with its place on the vertical
    /// axis. What is farther out than shapes and dots is cut off.
    pub wall: Vec<(f64, f64)>,
    /// The same at dots; those that no shape is near are left out.
    pub wall_at_dots: Vec<(f64, f64)>,
    /// What is drawn, in the legend.
    pub words: FilmWords,
    /// What else is to be said, in the legend.
    pub notes: Vec<String>,
    /// The frames.
    pub frames: Vec<FilmFrame>,
}

/// What is drawn of a film, in words.
#[derive(Clone, Copy)]
pub struct FilmWords {
    /// The displacements along x and along y.
    pub curves: [&'static str; 2],
    /// The distance from the middle.
    pub radius: &'static str,
    /// A filled dot and an open one.
    pub dots: [&'static str; 2],
    /// The walls at a dot, and between dots.
    pub walls: [&'static str; 2],
}

/// A shape at a time.
pub struct FilmFrame {
    /// Title above it.
    pub title: String,
    /// Displacement x and y of each place.
    pub shape: Vec<[f64; 2]>,
    /// Dots on it.
    pub dots: Vec<FilmDot>,
}

/// A place of a shape that is pointed out.
pub struct FilmDot {
    /// Its place on the vertical axis.
    pub place: f64,
    /// How far it is from the middle.
    pub radius: f64,
    /// Whether it is filled.
    pub filled: bool,
}

/// Draws a film.
pub fn film(look: &Look, film: &Film) -> Picture {
    let title = Title::new(look, &film.title, WIDTH, MARGIN);
    let legend = legend(film).in_rows(title.width - 2.0 * MARGIN);
    let columns = columns(title.width);
    let top = title.bottom();
    let rows = film.frames.len().div_ceil(columns);
    let legend_top = top + rows as f64 * FRAME_HEIGHT;
    let frames = frames(film, top, (title.width, columns));
    draw_titled(&title, legend_top + legend.height() + MARGIN, |canvas| {
        for (shown, frame) in film.frames.iter().zip(&frames) {
            draw_frame(canvas, film, shown, frame);
        }
        legend.draw(canvas, MARGIN, legend_top)
    })
}

fn legend(film: &Film) -> Legend {
    let FilmWords {
        curves: [x, y],
        radius,
        dots: [filled, open],
        walls: [at_dot, between],
    } = film.words;
    let shown = [
        (Key::Line(X), x),
        (Key::Line(Y), y),
        (Key::Bar(SKY, 1.0), radius),
        (Key::Dot(true), filled),
        (Key::Dot(false), open),
    ];
    let walls = [(Key::Line(WALL_AT_DOT), at_dot), (Key::Line(WALL), between)];
    let is_near = [&film.wall_at_dots, &film.wall].map(|wall| !wall.is_empty());
    let walls = walls.into_iter().zip(is_near);
    let walls = walls.filter_map(|(entry, is_near)| is_near.then_some(entry));
    let notes = film.notes.iter().map(|note| (Key::Nothing, note.as_str()));
    Legend::new(shown.into_iter().chain(walls).chain(notes))
}

/// Frames side by side.
fn columns(width: f64) -> usize {
    ((width / LEAST_WIDTH) as usize).clamp(1, COLUMNS)
}

/// The frames in rows; the vertical axis has its title at the first of each row.
fn frames(film: &Film, top: f64, (full, columns): (f64, usize)) -> Vec<Frame> {
    let shapes = film.frames.iter().flat_map(|frame| &frame.shape);
    let radii = shapes.map(|[x, y]| x.hypot(*y));
    let reach = (radii.chain(film.wall_at_dots.iter().map(|(distance, _)| *distance)))
        .filter(|radius| radius.is_finite())
        .fold(0.0, f64::max);
    let scales = [
        Scale::new(false, [-reach, reach].into_iter()),
        Scale::new(false, film.places.iter().copied()),
    ];
    let at = |index: usize, left: f64, width: f64| {
        let top = top + (index / columns) as f64 * FRAME_HEIGHT;
        Rect {
            left,
            top: top + LABEL_SIZE + 0.5 * GAP,
            right: left + width,
            bottom: top + FRAME_HEIGHT - GAP,
        }
    };
    let all = full - 2.0 * MARGIN;
    // The room that titles and numbers of the vertical axis take at the first of each row.
    let room = Frame::new(at(0, 0.0, all), &film.axes, scales).area.left;
    let width = (all - room + COLUMN_GAP) / columns as f64;
    let of_index = |index: usize| {
        let left = MARGIN + room + (index % columns) as f64 * width;
        let mut frame = match index % columns {
            0 => Frame::new(
                at(index, MARGIN, room + width - COLUMN_GAP),
                &film.axes,
                scales,
            ),
            _ => Frame::next_to(at(index, left, width - COLUMN_GAP), &film.axes[0], scales),
        };
        frame.area.left = left;
        frame
    };
    (0..film.frames.len()).map(of_index).collect()
}

fn draw_frame(canvas: &mut Canvas, film: &Film, shown: &FilmFrame, frame: &Frame) {
    frame.draw(canvas);
    let title = Block::new(&shown.title, LABEL_SIZE, frame.area.width());
    let above = frame.area.top - 0.5 * GAP - 2.0;
    canvas.text(&title, frame.area.centre().0, above, Align::Centre);
    let curve = |along: &dyn Fn(&[f64; 2]) -> f64| {
        let points = shown
            .shape
            .iter()
            .map(along)
            .zip(film.places.iter().copied());
        thin_upright(frame.curve(&points.collect::<Vec<_>>()).concat())
    };
    let mut shaded = curve(&|[x, y]| x.hypot(*y));
    shaded.extend(curve(&|[x, y]| -x.hypot(*y)).iter().rev());
    canvas.polygon(&shaded, SKY);
    draw_wall(canvas, film, frame);
    canvas.line(&curve(&|[x, _]| *x), X);
    canvas.line(&curve(&|[_, y]| *y), Y);
    let radius = RADIUS
        .min(0.5 * closest(&shown.dots, frame))
        .max(LEAST_RADIUS);
    for dot in &shown.dots {
        if let Some(centre) = frame.pixel((dot.radius, dot.place)) {
            draw_dot(canvas, dot.filled, centre, radius);
        }
    }
}

fn draw_wall(canvas: &mut Canvas, film: &Film, frame: &Frame) {
    for side in [-1.0, 1.0] {
        let on_side = |wall: &[(f64, f64)]| -> Vec<Vec<Pixel>> {
            let points: Vec<_> = wall.iter().map(|(at, place)| (side * at, *place)).collect();
            frame.curve(&points)
        };
        for piece in on_side(&film.wall) {
            for part in frame.area.clip(&piece) {
                canvas.line(&part, WALL);
            }
        }
        for (x, y) in on_side(&film.wall_at_dots).concat() {
            let bar = [(x, y - REACH), (x, y + REACH)];
            for part in frame.area.clip(&bar) {
                canvas.line(&part, WALL_AT_DOT);
            }
        }
    }
}

/// The least distance between neighbouring dots, pixels.
fn closest(dots: &[FilmDot], frame: &Frame) -> f64 {
    let heights: Vec<f64> = (dots.iter())
        .filter_map(|dot| frame.pixel_y(dot.place))
        .collect();
    let pairs = heights.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    pairs.fold(f64::INFINITY, f64::min)
}

/// [`thin`] of a curve that runs up and down.
fn thin_upright(curve: Vec<Pixel>) -> Vec<Pixel> {
    let across: Vec<Pixel> = curve.into_iter().map(|(x, y)| (y, x)).collect();
    thin(&across).into_iter().map(|(y, x)| (x, y)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    fn with_dots(count: usize, wall: bool) -> Film {
        let places: Vec<f64> = (0..5000).map(f64::from).collect();
        let at = |dot: usize| 4999.0 * dot as f64 / count as f64;
        let frame = |index: usize| FilmFrame {
            title: format!("t = {index}.25 s"),
            shape: (places.iter())
                .map(|place| [20.0 * (0.01 * place).sin(), -3.0])
                .collect(),
            dots: (0..count)
                .map(|dot| FilmDot {
                    place: at(dot),
                    radius: 15.0,
                    filled: dot % 2 == 0,
                })
                .collect(),
        };
        Film {
            title: "A rope in its shaft".to_owned(),
            axes: ["x, y, r (mm)", "Above the bit (m)"].map(Axis::linear),
            wall: if wall {
                vec![(15.0, 0.0), (15.0, 2500.0), (40.0, 2500.0), (40.0, 4999.0)]
            } else {
                Vec::new()
            },
            wall_at_dots: (0..count)
                .filter(|_| wall)
                .map(|dot| (15.0, at(dot)))
                .collect(),
            words: FilmWords {
                curves: ["x", "y"],
                radius: "radius r, to both sides",
                dots: ["dot that touches the wall", "dot that does not"],
                walls: ["wall at a dot", "between dots"],
            },
            notes: vec!["above 5000 m the rope moves less".to_owned()],
            frames: (0..8).map(frame).collect(),
            places,
        }
    }

    /// Of two dots in eight frames, one of them filled: a black disc each, and a white one
    /// in that which does not; the same once in the legend.
    #[test]
    fn every_frame_has_its_dots() {
        let picture = film(&Look::default(), &with_dots(2, true));
        assert_text_inside(&picture);
        assert_eq!(picture.svg().matches("<circle").count(), 8 * 3 + 3);
        assert!(picture.svg().contains("t = 7.25 s"));
    }

    /// The two dashed lines of the wall, and the dashed line of y.
    #[test]
    fn a_wall_that_is_far_away_is_not_drawn() {
        let dashed = |wall| {
            let picture = film(&Look::default(), &with_dots(3, wall));
            picture.svg().matches("dasharray").count()
        };
        assert_eq!(dashed(true), 8 * 3 + 2);
        assert_eq!(dashed(false), 8 + 1);
    }

    #[test]
    fn a_fine_mesh_makes_no_large_file() {
        let picture = film(&Look::default(), &with_dots(100, true));
        // Of which the font is 60 kB.
        assert!(picture.svg().len() < 1_000_000, "{}", picture.svg().len());
        let again = film(&Look::default(), &with_dots(100, true));
        assert!(picture == again && picture.png().ok() == again.png().ok());
    }
}
