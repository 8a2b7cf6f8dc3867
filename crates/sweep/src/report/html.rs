//! HTML elements.

use super::document::Table;
use super::escaping::{escaped, with_index};

/// A text between the tags of an element.
pub fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>\n", escaped(text))
}

/// Tables with more columns than this become cards on a phone, a card for each row.
const MOST_COLUMNS: usize = 3;

/// Names with what is said of each.
pub fn facts(facts: &[(String, String)]) -> String {
    let fact = |(name, text): &(String, String)| {
        let (name, text) = (escaped(name), with_index(&escaped(text)));
        format!("<div><dt>{name}</dt>\n<dd>{text}</dd></div>\n")
    };
    let facts: String = facts.iter().map(fact).collect();
    format!("<dl class=\"facts\">\n{facts}</dl>\n")
}

/// What is folded below a title.
pub fn details(title: &str, content: &str) -> String {
    let title = escaped(title);
    format!("<details>\n<summary>{title}</summary>\n{content}</details>\n")
}

/// A table that scrolls by itself where it is wider than the page; a reader of the
/// keyboard can reach it to scroll. On a phone, the rows of a wide one are cards.
pub fn table(table: &Table) -> String {
    let caption = escaped(&table.caption);
    let cards = match table.header.len() > MOST_COLUMNS {
        true => " cards",
        false => "",
    };
    let mut html = format!(
        "<div class=\"scroll{cards}\" role=\"region\" aria-label=\"{caption}\" tabindex=\"0\">\n<table>\n\
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
            let name = escaped(&table.header[column]);
            let class = class(column);
            html += &format!("<td{class} data-name=\"{name}\">{}</td>", escaped(cell));
        }
        html += "</tr>\n";
    }
    html + "</tbody>\n</table>\n</div>\n"
}
