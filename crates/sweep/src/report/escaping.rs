//! Texts as they stand in HTML. Every text is escaped when it is put in, and only then.

use campaign::printable::steers;
use plot::split_at_indices;

/// A text as it stands in HTML, between tags or in a quoted attribute.
pub fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => html += "&amp;",
            '<' => html += "&lt;",
            '>' => html += "&gt;",
            '"' => html += "&quot;",
            '\'' => html += "&#39;",
            // What HTML forbids, a terminal's colours among it.
            letter if steers(letter) && letter != '\n' => html.push(' '),
            letter => html.push(letter),
        }
    }
    html
}

/// An escaped text with the indices of T_s and T_d below the line.
pub fn with_index(html: &str) -> String {
    let set = |(piece, index): (&str, &str)| match index {
        "" => piece.to_owned(),
        index => format!("{piece}<sub>{index}</sub>"),
    };
    split_at_indices(html).into_iter().map(set).collect()
}

/// A value as a script element of data holds it: nothing in it can end the element.
pub fn json(value: &serde_json::Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_user_wrote_is_text_and_nothing_else() {
        let text = escaped("<script>alert('\"&\u{1b}[31m')</script>");
        let expected = "&lt;script&gt;alert(&#39;&quot;&amp; [31m&#39;)&lt;/script&gt;";
        assert_eq!(text, expected);
    }
}
