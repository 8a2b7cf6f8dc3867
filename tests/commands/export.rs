//! `sweep export`: labels in another format.

use crate::support::{SMALL, Workplace};

#[cfg(not(feature = "parquet"))]
#[test]
fn a_program_without_parquet_says_how_to_get_one() {
    let place = Workplace::with_small(SMALL);
    let answer = place.sweep(&["export", "results", "--format", "parquet"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(answer.errors.contains("--features parquet"), "{answer:?}");
    assert_eq!(place.files().len(), 1);
}

/// Every cell of the table, read with the crate's own reader.
#[cfg(feature = "parquet")]
#[test]
fn parquet_has_every_cell_of_the_labels_and_null_for_empty_ones() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    let place = Workplace::with_small(SMALL);
    assert_eq!(
        place.sweep(&["run", "small.toml", "--out", "results"]).code,
        0
    );
    let export = ["export", "results", "--format", "parquet"];
    let answer = place.sweep(&export);
    assert_eq!(
        (answer.code, answer.output.as_str()),
        (0, "results/labels.parquet\n")
    );
    let file = std::fs::read(place.path("results/labels.parquet")).unwrap();
    assert_eq!(place.sweep(&export).code, 0);
    assert!(std::fs::read(place.path("results/labels.parquet")).unwrap() == file);

    let mut table = csv::Reader::from_path(place.path("results/labels.csv")).unwrap();
    let header = table.headers().unwrap().clone();
    let file = std::fs::File::open(place.path("results/labels.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    let (mut of_parquet, mut nulls) = (0, 0);
    for (row, expected) in rows.zip(table.records()) {
        let expected = expected.unwrap();
        of_parquet += 1;
        for ((name, field), (column, cell)) in
            row.get_column_iter().zip(header.iter().zip(&expected))
        {
            assert_eq!(name, column);
            match field {
                Field::Null => {
                    nulls += 1;
                    assert_eq!(cell, "", "{name}");
                }
                Field::Str(word) => assert_eq!(word, cell, "{name}"),
                Field::Long(number) => {
                    assert_eq!((name.as_str(), *number), ("case", cell.parse().unwrap()))
                }
                Field::Double(number) => {
                    assert_eq!(*number, cell.parse::<f64>().unwrap(), "{name}")
                }
                other => panic!("{name}: {other:?}"),
            }
        }
    }
    assert_eq!(of_parquet, 6);
    assert!(nulls > 0);
    let words = ["method", "torsion", "ended", "status"];
    let group = reader.metadata().row_group(0);
    for (column, name) in group.columns().iter().zip(&header) {
        let kind = format!("{:?}", column.column_type());
        let expected = match name {
            "case" => "INT64",
            name if words.contains(&name) || ["lateral", "predicted"].contains(&name) => {
                "BYTE_ARRAY"
            }
            _ => "DOUBLE",
        };
        assert_eq!(kind, expected, "{name}");
        if words.contains(&name) {
            assert!(column.dictionary_page_offset().is_some(), "{name}");
        }
    }
}

/// A row for each step, of every method, with the numbers of the CSV.
#[cfg(feature = "parquet")]
#[test]
fn a_history_is_exported_by_the_same_writer() {
    use parquet::file::reader::{FileReader, SerializedFileReader};

    let place = Workplace::with_small(SMALL);
    let export = ["export", "out", "--table", "history", "--format", "parquet"];
    std::fs::create_dir(place.path("out")).unwrap();
    let refused = place.sweep(&export);
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(refused.errors.contains("out holds no history.csv"));
    assert_eq!(
        place
            .sweep(&["simulate", "small.toml", "--out", "out"])
            .code,
        0
    );
    let answer = place.sweep(&export);
    assert_eq!(
        (answer.code, answer.output.as_str()),
        (0, "out/history.parquet\n")
    );
    let mut table = csv::Reader::from_path(place.path("out/history.csv")).unwrap();
    let header = table.headers().unwrap().clone();
    let file = std::fs::File::open(place.path("out/history.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    let mut steps = 0;
    for (row, expected) in rows.zip(table.records()) {
        let expected = expected.unwrap();
        steps += 1;
        for ((name, field), (column, cell)) in
            row.get_column_iter().zip(header.iter().zip(&expected))
        {
            assert_eq!(name, column);
            match field {
                parquet::record::Field::Str(word) => {
                    assert_eq!((word.as_str(), column), (cell, "method"))
                }
                parquet::record::Field::Long(number) => assert_eq!(number.to_string(), cell),
                parquet::record::Field::Double(number) => {
                    assert_eq!(*number, cell.parse::<f64>().unwrap())
                }
                other => panic!("{name}: {other:?}"),
            }
        }
    }
    assert_eq!(steps, 1201);
    // What a run has of its cases, by the same name.
    let case = ["export", "out", "--table", "case", "--format", "parquet"];
    assert_eq!(place.sweep(&case).output, "out/case.parquet\n");
}

/// Of a case that begins in both ways, the label of each is a column of words.
#[cfg(feature = "parquet")]
#[test]
fn labels_from_both_starts_are_words() {
    use crate::support::with;

    let both = with(SMALL, "time_s = 12\n", "start = \"both\"\n");
    let place = Workplace::with_small(&both);
    assert_eq!(
        place.sweep(&["run", "small.toml", "--out", "results"]).code,
        0
    );
    let answer = place.sweep(&["export", "results", "--format", "parquet"]);
    assert_eq!(answer.code, 0, "{answer:?}");
}
