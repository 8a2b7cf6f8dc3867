//! Tables that were computed by another program.

/// The numbers of a comma-separated table below its header, from a column on.
pub(super) fn numbers(table: &str, from: usize) -> impl Iterator<Item = Vec<f64>> {
    let lines = table.lines().skip(1);
    lines.map(move |line| {
        let fields = line.split(',').skip(from);
        fields.map(|field| field.parse().unwrap()).collect()
    })
}
