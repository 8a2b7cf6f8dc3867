//! HTML elements.

use super::document::Table;
use super::escaping::escaped;

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
