//! Lines of a description: a title and a value.

/// A title and a value, which stand below those of other depths.
pub fn row(depth: usize, title: &str, value: &str) -> String {
    let width = 28 - depth;
    format!("{:depth$}{title:<width$} {value}\n", "")
}
