//! From a results folder to its regime map: a map for each motion that has labels, and
//! for each of a few values of a further axis; of many values, the fraction of the cases with the
//! regime.
//!
//! `extent` says what the cases span, `symbol`, `cells` and `fractions` what they are
//! drawn as, in the cells of a `mesh`, `traced` what a traced design is, `limits` where their limit is, `measures` a measure as
//! colour in the classes of a `scale`, `misfits` how near they are to the recording; `picture` puts
//! them together. `probability` draws counts over ranges of the axes, with lines by `contour`;
//! `window` an operating window.

mod cells;
mod content;
mod contour;
mod extent;
mod fractions;
mod limits;
mod measures;
mod mesh;
mod misfits;
mod picture;
mod probability;
mod scale;
mod shown;
mod symbol;
mod traced;
mod window;
mod words;

pub use cells::Cells;
pub use extent::Extent;
pub use fractions::Fractions;
pub use mesh::Mesh;
pub use picture::{MapDrawing, drawing};
pub use probability::{Probabilities, probability_picture};
pub use shown::plot_axis;
pub use symbol::symbol_of;
pub use window::{WindowView, window_picture};
