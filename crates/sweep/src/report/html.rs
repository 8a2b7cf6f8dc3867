//! HTML elements. Every text is escaped when it is put in, and only then.

use super::document::Table;
use campaign::printable::steers;

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

/// An escaped text with the index of T_d, for which Unicode has no letter, below the line.
pub fn with_index(html: &str) -> String {
    html.replace("T_d", "T<sub>d</sub>")
}

/// A value as a script element of data holds it: nothing in it can end the element.
pub fn json(value: &serde_json::Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

/// A text between the tags of an element.
pub fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>\n", escaped(text))
}

/// A table that scrolls by itself where it is wider than the page; a reader of the
/// keyboard can reach it to scroll.
pub fn table(table: &Table) -> String {
    let caption = escaped(&table.caption);
    let mut html = format!(
        "<div class=\"scroll\" role=\"region\" aria-label=\"{caption}\" tabindex=\"0\">\n<table>\n\
         <caption><span>{caption}</span></caption>\n<thead><tr>"
    );
    let class = |column: usize| {
        if table.is_numeric(column) {
            " class=\"number\""
        } else if table.is_long(column) {
            " class=\"long\""
        } else {
            ""
        }
    };
    for (column, name) in table.header.iter().enumerate() {
        let class = class(column);
        html += &format!("<th scope=\"col\"{class}>{}</th>", escaped(name));
    }
    html += "</tr></thead>\n<tbody>\n";
    for row in &table.rows {
        html += "<tr>";
        for (column, cell) in row.iter().enumerate() {
            html += &format!("<td{}>{}</td>", class(column), escaped(cell));
        }
        html += "</tr>\n";
    }
    html + "</tbody>\n</table>\n</div>\n"
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
