//! Pictures of plain data: maps over two parameters, curves, bands, orbits, tables of cells.
//!
//! A picture is drawn once, as a list of shapes, and each file is written from that list: SVG
//! with its text as text, PNG, and PDF with its text as paths. The font is embedded, in the SVG too: no font or library of
//! the machine is used, and the same data always gives the same bytes.
//!
//! [`map_chart`] draws symbols and cells over two parameters, [`panels()`] draws stacked
//! curves. Each kind takes plain data, words of its legend among them, and returns a
//! [`Picture`]; writing files is left to the caller.
//!
//! ```
//! use plot::{Axis, Look, Panel, Series, panels};
//!
//! let panel = Panel {
//!     axes: ["Time t (s)", "Speed (rpm)"].map(Axis::linear),
//!     series: vec![Series::new("measured", vec![(0.0, 0.0), (1.0, 60.0), (5.0, 62.0)])],
//!     references: Vec::new(),
//!     walls: Vec::new(),
//!     is_difference: false,
//! };
//! let picture = panels(&Look::default(), "A start", &[panel]);
//! assert!(picture.svg().contains("measured"));
//! assert!(picture.png()?.starts_with(b"\x89PNG"));
//! # Ok::<(), plot::PictureError>(())
//! ```

mod bands;
mod campbell;
mod canvas;
mod cells;
pub mod colours;
mod fills;
mod film;
mod font;
mod frame;
mod geometry;
mod hatching;
mod legend;
mod lettering;
mod levels;
mod line_styles;
mod look;
mod map;
mod method_styles;
mod multiples;
mod names;
mod numbers;
mod orbits;
mod overlaid;
mod panels;
mod pdf;
mod picture;
mod raster;
mod references;
mod scale;
mod scatter;
mod shapes;
mod svg;
mod symbols;
mod text;
mod truetype;

pub use bands::{BandChart, BandPanel, Bar, COLUMNS, band_chart};
pub use campbell::{CampbellPanel, campbell};
pub use cells::{CellPanel, CellWords, ChartCell, Seen, cell_chart};
pub use fills::{CellFill, Fraction, Safety};
pub use film::{Film, FilmDot, FilmFrame, FilmWords, film};
pub use lettering::split_at_indices;
pub use levels::{LevelClasses, LevelPanel, level_chart};
pub use line_styles::{LineStyle, Series};
pub use look::{Look, Paper};
pub use map::{
    Band, MapAxis, MapCell, MapChart, MapGroup, MapPanel, MapPoint, Mark, is_within, map_axes,
    map_chart,
};
pub use method_styles::method_style;
pub use multiples::{Multiple, multiples};
pub use orbits::{Orbit, orbits};
pub use panels::{Panel, Wall, panels};
pub use picture::{Picture, PictureError};
pub use references::{Across, Reference};
pub use scale::Axis;
pub use scatter::{ScatterPanel, scatter_grid};
pub use symbols::Symbol;
