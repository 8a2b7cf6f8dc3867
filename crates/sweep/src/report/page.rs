//! Sections as one HTML page that needs nothing else: no script, no file, no
//! network; light or dark as the reader's machine is, on a phone and in print.

use std::path::Path;

use anyhow::{Context, Result};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::document::{Block, Map, Section};
use super::html::{element, escaped, table};
use crate::files::is_absent;
use campaign::text_file::unreadable;

/// The mark of a page that this program made.
const MADE_BY: &str = "<footer><p>Made by ";

/// The mark is among the last bytes of a page, this many at most.
const FOOTER: usize = 400;

/// The page's looks.
const STYLE: &str = include_str!("page.css");

/// The sections as a page.
///
/// # Errors
/// Where a map cannot be read.
pub fn page(title: &str, sections: &[Section]) -> Result<String> {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <link rel=\"icon\" href=\"data:,\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header><h1>{title}</h1></header>\n<nav aria-label=\"Sections\">\n<ul>\n",
        title = escaped(title)
    );
    for (index, (title, _)) in sections.iter().enumerate() {
        html += &format!("<li><a href=\"#s{index}\">{}</a></li>\n", escaped(title));
    }
    html += "</ul>\n</nav>\n<main>\n";
    for (index, (title, content)) in sections.iter().enumerate() {
        html += &format!("<section id=\"s{index}\" aria-labelledby=\"h{index}\">\n");
        html += &format!("<h2 id=\"h{index}\">{}</h2>\n", escaped(title));
        html += &blocks(content)?;
        html += "</section>\n";
    }
    let program = escaped(crate::program::PROGRAM);
    html += &format!("</main>\n{MADE_BY}{program}.</p></footer>\n</body>\n</html>\n");
    Ok(html)
}

/// Whether a file is a page of this program, of any version.
///
/// # Errors
/// Where it is there and cannot be read.
pub fn is_page(path: &Path) -> std::io::Result<bool> {
    let content = match std::fs::read(path) {
        Err(error) if is_absent(&error) => return Ok(false),
        content => content?,
    };
    let mark = format!("{MADE_BY}sweep ");
    let end = &content[content.len().saturating_sub(FOOTER)..];
    Ok((end.windows(mark.len())).any(|window| window == mark.as_bytes()))
}

/// Maps that follow each other stand side by side where there is room.
fn blocks(blocks: &[Block]) -> Result<String> {
    let mut html = String::new();
    let mut maps = String::new();
    for block in blocks {
        if let Block::Map(map) = block {
            maps += &figure(map)?;
            continue;
        }
        html += &side_by_side(&std::mem::take(&mut maps));
        match block {
            Block::Text(paragraph) => html += &element("p", paragraph),
            Block::Table(content) => html += &table(content),
            Block::Folded { title, text } => {
                let (title, text) = (escaped(title), escaped(text));
                html += &format!(
                    "<details>\n<summary>{title}</summary>\n<pre tabindex=\"0\">{text}</pre>\n\
                     </details>\n"
                );
            }
            Block::Map(_) => {}
        }
    }
    Ok(html + &side_by_side(&maps))
}

fn side_by_side(maps: &str) -> String {
    if maps.is_empty() {
        return String::new();
    }
    format!("<div class=\"maps\">\n{maps}</div>\n")
}

/// The picture in the page itself. As an image it cannot clash with another one's
/// names or with the page's colours. Who cannot see it reads the characters, which
/// stand alone where there is no picture.
fn figure(map: &Map) -> Result<String> {
    let caption = format!("<figcaption>{}</figcaption>\n", escaped(&map.caption));
    let characters = format!("<pre tabindex=\"0\">{}</pre>\n", escaped(&map.characters));
    let Some(path) = &map.svg else {
        return Ok(format!("<figure>\n{characters}{caption}</figure>\n"));
    };
    let svg = std::fs::read(path).with_context(|| unreadable(path))?;
    Ok(format!(
        "<figure>\n<div class=\"scroll\" tabindex=\"0\"><img alt=\"Regime map: {}\" \
         src=\"data:image/svg+xml;base64,{}\"></div>\n{caption}<details>\n<summary>The map in characters</summary>\n{characters}</details>\n\
         </figure>\n",
        escaped(&map.caption),
        STANDARD.encode(svg),
    ))
}
