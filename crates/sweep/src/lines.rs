//! Lines of CSV files that people write by hand: with empty lines and comments,
//! on which the reader's own positions would begin.

/// Lines that begin with it are passed over.
pub const COMMENT: u8 = b'#';

/// The line (from 1) of the first record at or after a byte, where the record
/// before it ended.
pub fn line_from(text: &str, byte: usize) -> usize {
    let before = text[..byte].matches('\n').count();
    let passed_over = text[byte..]
        .lines()
        .take_while(|line| line.is_empty() || line.as_bytes()[0] == COMMENT)
        .count();
    before + passed_over + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_lines_and_comments_belong_to_no_record() {
        let text = "# cases\r\n\r\na,b\r\n\n# more\n1,\"2\n3\"\n4,5";
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(COMMENT))
            .from_reader(text.as_bytes());
        let lines = reader.records().map(|record| {
            let byte = record.unwrap().position().unwrap().byte();
            line_from(text, byte as usize)
        });
        assert_eq!(lines.collect::<Vec<_>>(), [6, 8]);
        assert_eq!(line_from(text, 0), 3);
    }
}
