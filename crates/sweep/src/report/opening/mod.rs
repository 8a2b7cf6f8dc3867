//! What a report opens with, for the person who decides: what was asked, what was found and how
//! sure that is, a verdict for each mark, and what turns in the hole.

mod asked;
mod equipment;
mod found;
mod marks;
mod sureness;

use super::document::{Block, fact};
use super::results::Results;

/// The opening, folder by folder.
pub fn opening(all: &[Results]) -> Vec<Block> {
    let of_folder = |results: &Results| {
        let mut blocks = Vec::new();
        if all.len() > 1 {
            let heading = format!("{}: {}", results.name, results.manifest.title);
            blocks.push(Block::Heading(heading));
        }
        blocks.push(Block::Facts(vec![
            fact("What was asked", asked::asked(results)),
            fact("What was found", found::found(results)),
            fact("How sure that is", sureness::sureness(results)),
        ]));
        let marks = marks::verdicts(results);
        if !marks.is_empty() {
            blocks.push(Block::Facts(marks));
        }
        blocks
    };
    let mut blocks: Vec<Block> = all.iter().flat_map(of_folder).collect();
    blocks.push(Block::Facts(in_the_hole(all)));
    blocks
}

/// What turns in the hole. Folders are often of one well: what they share is said once.
fn in_the_hole(all: &[Results]) -> Vec<(String, String)> {
    let each: Vec<Vec<(String, String)>> = all.iter().map(equipment::equipment).collect();
    let mut facts: Vec<(String, String)> = Vec::new();
    for (results, own) in all.iter().zip(&each) {
        for (name, text) in own {
            let is_shared = each
                .iter()
                .all(|other| other.contains(&(name.clone(), text.clone())));
            let name = match is_shared {
                true => name.clone(),
                false => format!("{name}, {}", results.name),
            };
            if !facts.iter().any(|(known, _)| *known == name) {
                facts.push((name, text.clone()));
            }
        }
    }
    facts
}
