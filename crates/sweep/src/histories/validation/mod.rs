//! What is computed of histories, held to closed forms.

mod spectrum;
mod twist;
