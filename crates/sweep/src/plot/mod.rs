//! Plots of regime maps and time histories.
//!
//! A plot is drawn once, as SVG, and the PNG is that SVG rasterised, so the
//! two never differ. The font is embedded, in the SVG too: no font or library of
//! the machine is used, and the same data always gives the same bytes.
//!
//! [`map_sheet`] draws regimes over two parameters, [`panels()`] draws stacked
//! curves. Both take plain data and return a [`Picture`]; writing files is left
//! to the caller.

mod bands;
mod campbell;
mod canvas;
mod cells;
mod colours;
mod film;
mod font;
mod frame;
mod geometry;
mod grounds;
mod hatching;
mod inks;
mod legend;
mod lettering;
mod look;
mod map;
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

pub use bands::{BandChart, BandPanel, Bar, COLUMNS, band_chart};
pub use campbell::{CampbellPanel, campbell};
pub use cells::{CellPanel, ChartCell, Seen, cell_chart};
pub use film::{Film, FilmFrame, FilmSite, film};
pub use grounds::{Ground, Part, Safety};
pub use inks::{Ink, Series};
pub use lettering::split_at_indices;
pub use look::{Look, Paper};
pub use map::{
    Band, MapAxis, MapCell, MapGroup, MapPanel, MapPoint, MapSheet, Mark, is_within, map_axes,
    map_sheet,
};
pub use multiples::{Multiple, multiples};
pub use orbits::{Orbit, orbits};
pub use panels::{Panel, Wall, panels};
pub use picture::Picture;
pub use references::{Across, Reference};
pub use scale::Axis;
pub use scatter::{ScatterPanel, scatter_grid};
pub use symbols::Symbol;
