//! Lines of CSV files that people write by hand: with empty lines and comments,
//! on which the reader's own positions would begin.

/// Lines that begin with it are passed over.
pub const COMMENT: u8 = b'#';

/// The line (from 1) of the first record at or after a byte, where the record
/// before it ended.
pub fn line_from(text: &str, byte: usize) -> usize {
    RecordLines::of(text).line_from(byte)
}

/// Lines of many records, asked for in their order.
pub struct RecordLines<'a> {
    text: &'a str,
    /// Line breaks are counted up to here.
    byte: usize,
    breaks: usize,
}

impl<'a> RecordLines<'a> {
    /// Of a whole file.
    pub fn of(text: &'a str) -> Self {
        Self {
            text,
            byte: 0,
            breaks: 0,
        }
    }

    /// As [`line_from`], of a byte at or after the one before.
    pub fn line_from(&mut self, byte: usize) -> usize {
        self.breaks += self.text[self.byte..byte].matches('\n').count();
        self.byte = byte;
        let passed_over = self.text[byte..]
            .lines()
            .take_while(|line| line.is_empty() || line.as_bytes()[0] == COMMENT)
            .count();
        self.breaks + passed_over + 1
    }
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
        let mut record_lines = RecordLines::of(text);
        let lines = reader.records().map(|record| {
            let byte = record.unwrap().position().unwrap().byte();
            let line = record_lines.line_from(byte as usize);
            assert_eq!(line, line_from(text, byte as usize));
            line
        });
        assert_eq!(lines.collect::<Vec<_>>(), [6, 8]);
        assert_eq!(line_from(text, 0), 3);
    }
}
