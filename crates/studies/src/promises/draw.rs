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
    JointedCollar,
    ThreeSections,
}

/// Those of which accuracies are asked, in turn.
pub const SHAPES: [Shape; 4] = [
    Shape::Uniform,
    Shape::PipeCollar,
    Shape::JointedCollar,
    Shape::ThreeSections,
];

/// Those of which limits and labels are tested, in turn.
pub const FAMILIES: [Shape; 5] = [
    Shape::Uniform,
    Shape::PipeCollar,
    Shape::Jointed,
    Shape::JointedCollar,
    Shape::ThreeSections,
];

/// Dimensions that tubes are drawn from, m or parts, each from the least to the most.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    pipe_outer_radius: [f64; 2],
    /// Inner radius in parts of the outer.
    pipe_bore: [f64; 2],
    /// Outer radius in parts of the pipe's.
    joint: [f64; 2],
    collar_outer_radius: [f64; 2],
    collar_inner_radius: f64,
}

/// What turns the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surface {
    Prescribed,
    Stiff,
    SoftTorque,
}

/// Half of the strings have a prescribed speed.
pub const SURFACES: [Surface; 4] = [
    Surface::Prescribed,
    Surface::Stiff,
    Surface::Prescribed,
    Surface::SoftTorque,
];

impl Surface {
    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Surface::Prescribed => "prescribed",
            Surface::Stiff => "stiff",
            Surface::SoftTorque => "soft-torque",
        }
    }
}

/// As wide a range as the paper's tubes and those of wells are in.
pub const WIDE: Sizes = Sizes {
    pipe_outer_radius: [0.06, 0.13],
    pipe_bore: [0.3, 0.85],
    joint: [1.1, 1.4],
    collar_outer_radius: [0.09, 0.16],
    collar_inner_radius: 0.04,
};

/// Of wells: drillpipe of 4 to 5⅞ inches and its joints, collars of 6¼ to 9½ inches.
pub const FIELD: Sizes = Sizes {
    pipe_outer_radius: [0.0508, 0.0746],
    pipe_bore: [0.8, 0.88],
    joint: [1.2, 1.35],
    collar_outer_radius: [0.079, 0.121],
    collar_inner_radius: 0.036,
};

impl Shape {
    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Uniform => "uniform",
            Shape::PipeCollar => "pipe-collar",
            Shape::Jointed => "jointed",
            Shape::JointedCollar => "jointed-collar",
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
        Spacing::Linear.between(from, to, self.0.part())
    }

    /// Uniform from the least to the most.
    fn within(&mut self, [least, most]: [f64; 2]) -> f64 {
        self.uniform(least, most)
    }

    /// With a uniform logarithm.
    pub fn log_uniform(&mut self, from: f64, to: f64) -> f64 {
        Spacing::Log.between(from, to, self.0.part())
    }
}

/// Sections of a string of some length (m), or little more.
pub fn sections(draw: &mut Draw, shape: Shape, sizes: &Sizes, length: f64) -> Vec<Section> {
    let plain = |tube: Tube| Section {
        repeat: 1,
        parts: vec![tube],
    };
    let collars = (draw.uniform(0.05, 0.3) * length).min(300.0);
    match shape {
        Shape::Uniform => vec![plain(pipe(draw, sizes, length))],
        Shape::PipeCollar => vec![
            plain(pipe(draw, sizes, length - collars)),
            plain(collar(draw, sizes, collars)),
        ],
        Shape::Jointed => vec![jointed(draw, sizes, length)],
        Shape::JointedCollar => vec![
            jointed(draw, sizes, length - collars),
            plain(collar(draw, sizes, collars)),
        ],
        Shape::ThreeSections => {
            let middle = draw.uniform(0.1, 0.4) * (length - collars);
            vec![
                plain(pipe(draw, sizes, length - collars - middle)),
                plain(pipe(draw, sizes, middle)),
                plain(collar(draw, sizes, collars)),
            ]
        }
    }
}

fn pipe(draw: &mut Draw, sizes: &Sizes, length: f64) -> Tube {
    let outer_radius = draw.within(sizes.pipe_outer_radius);
    Tube {
        length,
        inner_radius: outer_radius * draw.within(sizes.pipe_bore),
        outer_radius,
    }
}

fn collar(draw: &mut Draw, sizes: &Sizes, length: f64) -> Tube {
    Tube {
        length,
        inner_radius: sizes.collar_inner_radius,
        outer_radius: draw.within(sizes.collar_outer_radius),
    }
}

/// Pipes with joints, of some length or little more.
fn jointed(draw: &mut Draw, sizes: &Sizes, length: f64) -> Section {
    let cell = draw.uniform(8.0, 13.0);
    let joint = draw.uniform(0.3, 0.7);
    let pipe = pipe(draw, sizes, cell - joint);
    let joint = Tube {
        length: joint,
        outer_radius: pipe.outer_radius * draw.within(sizes.joint),
        ..pipe
    };
    Section {
        repeat: (length / cell).ceil() as usize,
        parts: vec![pipe, joint],
    }
}
