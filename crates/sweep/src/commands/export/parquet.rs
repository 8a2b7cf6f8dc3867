//! A table by case and method as Apache Parquet: case numbers are integers, all other numbers doubles, words
//! strings with a dictionary; what a row does not have is null. The same table gives the same
//! bytes.

use std::io;
use std::path::Path;
use std::sync::Arc;

use ::parquet::basic::{LogicalType, Repetition, Type as Stored};
use ::parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{
    SerializedColumnWriter, SerializedFileWriter, SerializedRowGroupWriter,
};
use ::parquet::schema::types::{Type, TypePtr};
use anyhow::{Context, Result};
use csv::StringRecord;

use campaign::records::{COLUMNS, Kind as ResultKind};
use campaign::text_file::unreadable;
use results::files::AtomicFile;

/// Rows that are in memory at once.
const ROWS_OF_GROUP: usize = 1 << 16;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Case,
    Number,
    Word,
    Truth,
}

impl Kind {
    /// That of a column: of results as the table of these has it; axes, motion and misfits are
    /// numbers.
    fn of(column: &str) -> Self {
        let result = COLUMNS.iter().find(|known| known.name == column);
        match (column, result.map(|result| result.kind)) {
            ("case", _) => Kind::Case,
            ("method", _) | (_, Some(ResultKind::Text)) => Kind::Word,
            (_, Some(ResultKind::Flag)) => Kind::Truth,
            _ => Kind::Number,
        }
    }

    fn field(self, name: &str) -> Result<TypePtr> {
        let (stored, logical) = match self {
            Kind::Case => (Stored::INT64, None),
            Kind::Number => (Stored::DOUBLE, None),
            Kind::Word => (Stored::BYTE_ARRAY, Some(LogicalType::String)),
            Kind::Truth => (Stored::BOOLEAN, None),
        };
        let field = Type::primitive_type_builder(name, stored)
            .with_logical_type(logical)
            .with_repetition(Repetition::OPTIONAL);
        Ok(Arc::new(field.build()?))
    }
}

/// Writes a table into a file; its rows are named.
///
/// # Errors
/// Where the one cannot be read, or the other cannot be written.
pub fn write(table: &Path, name: &str, out: &Path) -> Result<()> {
    let mut reader = csv::Reader::from_path(table).with_context(|| unreadable(table))?;
    let header = reader.headers().with_context(|| unreadable(table))?.clone();
    let kinds: Vec<Kind> = header.iter().map(Kind::of).collect();
    let fields = header
        .iter()
        .zip(&kinds)
        .map(|(name, kind)| kind.field(name));
    let schema = Type::group_type_builder(name)
        .with_fields(fields.collect::<Result<_>>()?)
        .build()?;
    let properties = WriterProperties::builder().build();
    let file = Sink(AtomicFile::create(out)?);
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
    let mut rows = reader.into_records();
    loop {
        let group = rows.by_ref().take(ROWS_OF_GROUP);
        let group = group
            .collect::<Result<Vec<_>, _>>()
            .with_context(|| unreadable(table))?;
        if group.is_empty() {
            break;
        }
        write_group(writer.next_row_group()?, &kinds, &group).with_context(|| unreadable(table))?;
    }
    writer.into_inner()?.0.finish()?;
    Ok(())
}

fn write_group(
    mut group: SerializedRowGroupWriter<'_, Sink>,
    kinds: &[Kind],
    rows: &[StringRecord],
) -> Result<()> {
    for (column, kind) in kinds.iter().enumerate() {
        let cells = rows.iter().map(|row| row.get(column).unwrap_or_default());
        let writer = group.next_column()?.context("a column is missing")?;
        match kind {
            Kind::Case => write_column::<Int64Type>(writer, cells, |cell| Ok(cell.parse()?)),
            Kind::Number => write_column::<DoubleType>(writer, cells, |cell| Ok(cell.parse()?)),
            Kind::Word => {
                write_column::<ByteArrayType>(writer, cells, |cell| Ok(ByteArray::from(cell)))
            }
            Kind::Truth => write_column::<BoolType>(writer, cells, |cell| Ok(cell.parse()?)),
        }?;
    }
    group.close()?;
    Ok(())
}

/// Writes cells, of which empty ones are null.
fn write_column<'a, T: DataType>(
    mut writer: SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = &'a str> + Clone,
    value: impl Fn(&str) -> Result<T::T>,
) -> Result<()> {
    let levels: Vec<i16> = cells
        .clone()
        .map(|cell| i16::from(!cell.is_empty()))
        .collect();
    let values = cells
        .filter(|cell| !cell.is_empty())
        .map(|cell| value(cell).with_context(|| format!("`{cell}` is not what its column holds")))
        .collect::<Result<Vec<_>>>()?;
    writer
        .typed::<T>()
        .write_batch(&values, Some(&levels), None)?;
    writer.close()?;
    Ok(())
}

/// The file that is written.
struct Sink(AtomicFile);

impl io::Write for Sink {
    fn write(&mut self, content: &[u8]) -> io::Result<usize> {
        self.0.write(content).map_err(io::Error::other)?;
        Ok(content.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
