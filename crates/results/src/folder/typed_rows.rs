//! The rows of a `labels.csv` with every column in it, each by what it holds.

use std::path::Path;

use anyhow::{Context, Result, anyhow};
use csv::StringRecord;

use campaign::quantities::Axis;
use campaign::records::{Field, Kind, MISFIT, ResultColumn, name_now};
use campaign::text_file::unreadable;

/// The columns of a table, each with what it holds.
pub type TypedColumns = Vec<(String, Kind)>;

/// A row: a field for each column.
pub type TypedRow = Vec<Field<'static>>;

/// All columns of a `labels.csv`, under the names that they have now, and its rows, of which only
/// one is in memory at a time.
///
/// # Errors
/// Where it cannot be read, or a field is not what its column holds; the message names file, line
/// and column.
pub fn typed_rows(path: &Path) -> Result<(TypedColumns, impl Iterator<Item = Result<TypedRow>>)> {
    let name = path.display().to_string();
    let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
    let header = reader.headers().with_context(|| unreadable(path))?;
    let columns: TypedColumns = header.iter().map(column).collect();
    let of_rows = columns.clone();
    let rows = reader.into_records().map(move |record| {
        let record = record.with_context(|| unreadable(Path::new(&name)))?;
        let line = record.position().map_or(0, csv::Position::line);
        row(&of_rows, &record).map_err(|reason| anyhow!("{name}:{line}: {reason}"))
    });
    Ok((columns, rows))
}

/// The name of a column, and what it holds; what is not known is text.
fn column(name: &str) -> (String, Kind) {
    let name = name_now(name);
    let kind = match (name, ResultColumn::named(name)) {
        (_, Some(column)) => column.kind,
        ("case", _) => Kind::Count,
        _ if name.starts_with(MISFIT) || Axis::from_name(name).is_some() => Kind::Number,
        _ => Kind::Text,
    };
    (name.to_owned(), kind)
}

fn row(columns: &[(String, Kind)], record: &StringRecord) -> Result<TypedRow, String> {
    let pairs = columns.iter().zip(record);
    pairs
        .map(|((name, kind), text)| {
            let field = field(*kind, text);
            field.ok_or_else(|| format!("{name}: `{text}` is no {}", word(*kind)))
        })
        .collect()
}

/// What a text says; none where it is not of the kind.
fn field(kind: Kind, text: &str) -> Option<Field<'static>> {
    if text.is_empty() {
        return Some(Field::Nothing);
    }
    match kind {
        Kind::Text => Some(text.to_owned().into()),
        Kind::Number => text.parse().ok().map(Field::Number),
        Kind::Count => text.parse().ok().map(Field::Count),
        Kind::Flag => text.parse().ok().map(Field::Flag),
    }
}

fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Text => "text",
        Kind::Number => "number",
        Kind::Count => "count",
        Kind::Flag => "`true` or `false`",
    }
}

#[cfg(test)]
mod tests {
    use campaign::records::RENAMED;

    use super::*;

    fn read(table: &str) -> Result<(TypedColumns, Vec<TypedRow>)> {
        let file = tempfile::NamedTempFile::new()?;
        std::fs::write(file.path(), table)?;
        let (columns, rows) = typed_rows(file.path())?;
        Ok((columns, rows.collect::<Result<_>>()?))
    }

    #[test]
    fn every_column_has_its_kind_and_its_present_name() {
        let [predicted, peak] = [RENAMED[0], RENAMED[1]].map(|(old, _)| old);
        let table = format!(
            "case,method,friction,torsion,sticks,period_s,misfit_a_rpm,torsion_certified,\
             {predicted},other,{peak}\n7,held,0.5,smooth,,1e-3,2,true,smooth,x,3\n"
        );
        let (columns, rows) = read(&table).expect("a table");
        let kinds: Vec<Kind> = columns.iter().map(|(_, kind)| *kind).collect();
        use Kind::{Count, Flag, Number, Text};
        let expected = [
            Count, Text, Number, Text, Count, Number, Number, Flag, Text, Text, Number,
        ];
        assert_eq!(kinds, expected);
        assert_eq!(columns[8].0, "predicted");
        assert_eq!(columns[10].0, "acceleration_step_peak_g");
        assert_eq!(rows[0][0], Field::Count(7));
        assert_eq!(rows[0][4], Field::Nothing);
        assert_eq!(rows[0][5], Field::Number(1e-3));
        assert_eq!(rows[0][7], Field::Flag(true));
    }

    #[test]
    fn a_wrong_field_is_refused_by_line_and_column() {
        let table = "case,method,period_s\n0,held,1\n1,held,long\n";
        let error = read(table).expect_err("no number").to_string();
        assert!(
            error.ends_with(":3: period_s: `long` is no number"),
            "{error}"
        );
    }
}
