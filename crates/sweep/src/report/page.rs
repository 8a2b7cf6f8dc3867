//! Sections as one HTML page that needs nothing else: no file, no network; light or dark as
//! the reader's machine is, on a phone and in print. Its script only makes maps answer; no
//! other can run in it.

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

use super::document::{Block, Map, Section, Table};
use super::escaping::{escaped, json};
use super::html::{details, element, facts, table};
use super::live_map::{DEFINITIONS, ENGINE, SCRIPT, STYLE as MAP_STYLE};
use super::results::Results;
use results::files::is_absent;

/// The mark of a page that this program made.
const MADE_BY: &str = "<footer><p>Made by ";

/// The page's looks.
const STYLE: &str = include_str!("page.css");

/// The sections as a page, with the cases of the maps among them.
pub fn page(title: &str, sections: &[Section], all: &[Results]) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <link rel=\"icon\" href=\"data:,\">\n\
         <title>{title}</title>\n<style>\n{STYLE}{MAP_STYLE}</style>\n</head>\n<body>\n\
         {DEFINITIONS}\
         <header><h1>{title}</h1></header>\n<nav aria-label=\"Sections\">\n<ul>\n",
        policy(SCRIPT),
        title = escaped(title)
    );
    for (index, (title, _)) in sections.iter().enumerate() {
        html += &format!("<li><a href=\"#s{index}\">{}</a></li>\n", escaped(title));
    }
    html += "</ul>\n</nav>\n<main>\n";
    for (index, (title, content)) in sections.iter().enumerate() {
        html += &format!("<section id=\"s{index}\" aria-labelledby=\"h{index}\">\n");
        html += &format!("<h2 id=\"h{index}\">{}</h2>\n", escaped(title));
        html += &blocks(content);
        html += "</section>\n";
    }
    html += "</main>\n";
    html += &scripts(all);
    let program = escaped(crate::program::PROGRAM);
    html + &format!("{MADE_BY}{program}.</p></footer>\n</body>\n</html>\n")
}

/// Content-Security-Policy of a page: a browser runs its own script, and the engine in a worker made
/// of it, and fetches nothing.
pub fn policy(script: &str) -> String {
    let hash = STANDARD.encode(Sha256::digest(script));
    format!(
        "default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; \
         style-src 'unsafe-inline'; script-src 'sha256-{hash}' \
         'wasm-unsafe-eval' blob:; worker-src blob:"
    )
}

/// The cases of maps, the engine, and the script that tells of them; nothing where there are none.
fn scripts(all: &[Results]) -> String {
    let lives = all
        .iter()
        .map(|results| results.live.as_ref()?.data.as_ref());
    let data = lives.enumerate().filter_map(|(place, data)| {
        let id = cases_id(place);
        let data = json(data?);
        Some(format!(
            "<script type=\"application/json\" id=\"{id}\">{data}</script>\n"
        ))
    });
    let data: String = data.collect();
    if data.is_empty() {
        return data;
    }
    let engine = STANDARD.encode(ENGINE);
    format!(
        "{data}<script type=\"application/octet-stream\" id=\"engine\">{engine}</script>\n\
         <script type=\"module\">{SCRIPT}</script>\n"
    )
}

/// The name of the element with the cases of a folder.
fn cases_id(place: usize) -> String {
    format!("cases-{place}")
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
    Ok((content.windows(mark.len())).any(|window| window == mark.as_bytes()))
}

/// Maps and pictures that follow each other stand side by side where there is room.
fn blocks(content: &[Block]) -> String {
    let mut html = String::new();
    let mut maps = String::new();
    for block in content {
        match block {
            Block::Map(map) => {
                maps += &figure(map);
                continue;
            }
            Block::Picture { html, table } => {
                maps += &picture(html, table);
                continue;
            }
            _ => {}
        }
        html += &side_by_side(&std::mem::take(&mut maps));
        html += &match block {
            Block::Text(paragraph) => element("p", paragraph),
            Block::Heading(heading) => element("h3", heading),
            Block::Facts(content) => facts(content),
            Block::Table(content) => table(content),
            Block::Folded { title, text } => {
                let text = escaped(text);
                details(title, &format!("<pre tabindex=\"0\">{text}</pre>\n"))
            }
            Block::Details { title, blocks: of } => details(title, &blocks(of)),
            Block::Map(_) | Block::Picture { .. } => String::new(),
        };
    }
    html + &side_by_side(&maps)
}

fn side_by_side(maps: &str) -> String {
    if maps.is_empty() {
        return String::new();
    }
    format!("<div class=\"maps\">\n{maps}</div>\n")
}

/// A picture with its numbers folded below.
fn picture(html: &str, numbers: &Table) -> String {
    let numbers = details("Numbers", &table(numbers));
    format!("<figure>\n{html}{numbers}</figure>\n")
}

/// The map as the page draws it, and in characters, which stand alone where it draws none.
fn figure(map: &Map) -> String {
    let caption = format!("<figcaption>{}</figcaption>\n", escaped(&map.caption));
    let characters = format!("<pre tabindex=\"0\">{}</pre>\n", escaped(&map.characters));
    let Some(html) = &map.html else {
        return format!("<figure>\n{characters}{caption}</figure>\n");
    };
    let cases = map.cases.map_or_else(String::new, |place| {
        format!(" data-cases=\"{}\"", cases_id(place))
    });
    let characters = details("The map in characters", &characters);
    format!("<figure{cases}>\n{caption}{html}{characters}</figure>\n")
}
