//! Strings drawn at random.

use linear::{Section, Tube};

use campaign::random::Stream;
use campaign::sweep_file::Spacing;

/// Kinds of strings.
#[derive(Debug, Clone, Copy)]
pub enum Shape {
    Uniform,
    PipeCollar,
    Jointed,
    ThreeSections,
}

/// All of them, in turn.
pub const SHAPES: [Shape; 4] = [
    Shape::Uniform,
    Shape::PipeCollar,
    Shape::Jointed,
    Shape::ThreeSections,
];

impl Shape {
    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Uniform => "uniform",
            Shape::PipeCollar => "pipe-collar",
            Shape::Jointed => "jointed",
            Shape::ThreeSections => "three-sections",
        }
    }
}

/// Random numbers, in the order in which they are drawn.
pub struct Draw(Stream);

impl Draw {
    /// The numbers of a stream.
    pub fn new(seed: u64, stream: u64) -> Self {
        Self(Stream::new(seed, stream))
    }

    /// Uniform between two.
    pub fn uniform(&mut self, from: f64, to: f64) -> f64 {
        self.0.between(from, to, Spacing::Linear)
    }

    /// With a uniform logarithm.
    pub fn log_uniform(&mut self, from: f64, to: f64) -> f64 {
        self.0.between(from, to, Spacing::Log)
    }
}

/// Sections of a string of some length (m), or little more.
pub fn sections(draw: &mut Draw, shape: Shape, length: f64) -> Vec<Section> {
    let plain = |tube: Tube| Section {
        repeat: 1,
        parts: vec![tube],
    };
    let collars = (draw.uniform(0.05, 0.3) * length).min(300.0);
    match shape {
        Shape::Uniform => vec![plain(pipe(draw, length))],
        Shape::PipeCollar => vec![
            plain(pipe(draw, length - collars)),
            plain(collar(draw, collars)),
        ],
        Shape::Jointed => vec![
            jointed(draw, length - collars),
            plain(collar(draw, collars)),
        ],
        Shape::ThreeSections => {
            let middle = draw.uniform(0.1, 0.4) * (length - collars);
            vec![
                plain(pipe(draw, length - collars - middle)),
                plain(pipe(draw, middle)),
                plain(collar(draw, collars)),
            ]
        }
    }
}

fn pipe(draw: &mut Draw, length: f64) -> Tube {
    let outer_radius = draw.uniform(0.06, 0.13);
    Tube {
        length,
        inner_radius: outer_radius * draw.uniform(0.3, 0.85),
        outer_radius,
    }
}

fn collar(draw: &mut Draw, length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.04,
        outer_radius: draw.uniform(0.09, 0.16),
    }
}

/// Pipes with joints, of some length or little more.
fn jointed(draw: &mut Draw, length: f64) -> Section {
    let cell = draw.uniform(8.0, 13.0);
    let joint = draw.uniform(0.3, 0.7);
    let pipe = pipe(draw, cell - joint);
    let joint = Tube {
        length: joint,
        outer_radius: pipe.outer_radius * draw.uniform(1.1, 1.4),
        ..pipe
    };
    Section {
        repeat: (length / cell).ceil() as usize,
        parts: vec![pipe, joint],
    }
}
