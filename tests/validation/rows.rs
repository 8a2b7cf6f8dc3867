//! Rows of tables.

/// A row: the names of its columns, with their cells.
pub type Row = Vec<(String, String)>;

/// The rows of a CSV file.
pub fn rows(text: &str) -> Vec<Row> {
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
    let header: Vec<String> = lines.next().unwrap().collect();
    lines
        .map(|row| header.iter().cloned().zip(row).collect())
        .collect()
}

/// A cell of a row.
pub fn word<'a>(row: &'a [(String, String)], column: &str) -> &'a str {
    let cell = row.iter().find(|(name, _)| name == column);
    &cell.unwrap_or_else(|| panic!("no {column}")).1
}

/// A number of a row.
pub fn number(row: &[(String, String)], column: &str) -> f64 {
    word(row, column).parse().unwrap()
}
