//! Shares as bars of a page, each with its numbers in words: readers of the screen and of colours
//! they cannot tell apart lose nothing.

use super::escaping::escaped;
use super::phrases::share;

/// A whole in its parts.
pub struct ShareBar {
    /// What it is of.
    pub name: String,
    /// Labels with their counts.
    pub parts: Vec<(&'static str, usize)>,
}

/// Bars that are one whole each.
pub fn share_bars(caption: &str, bars: &[ShareBar]) -> String {
    let of_bar = |bar: &ShareBar| {
        let all: usize = bar.parts.iter().map(|(_, count)| count).sum();
        let some = bar.parts.iter().filter(|(_, count)| *count > 0);
        let pieces: String = some
            .clone()
            .map(|(label, count)| {
                let width = 100.0 * *count as f64 / all.max(1) as f64;
                format!("<i class=\"r-{label}\" style=\"width:{width:.2}%\"></i>")
            })
            .collect();
        let words: String = some
            .map(|(label, count)| {
                let name = label.replace('_', " ");
                let part = share(*count, all);
                format!("<span><i class=\"r-{label}\"></i>{name} {part}</span> ")
            })
            .collect();
        row(&bar.name, &pieces, &words)
    };
    list(caption, bars.iter().map(of_bar))
}

/// Values between 0 and 1 with their intervals, each by its name.
pub fn interval_bars<'a>(
    caption: &str,
    values: impl Iterator<Item = (&'a str, [f64; 3])>,
) -> String {
    let rows = values.map(|(name, [value, low, high])| {
        let [value, low, high] = [value, low, high].map(|it| 100.0 * it.clamp(0.0, 1.0));
        let pieces = format!(
            "<i class=\"r-part\" style=\"width:{value:.2}%\"></i>\
             <b style=\"left:{low:.2}%;width:{:.2}%\"></b>",
            high - low
        );
        let words = format!("<span>{value:.0} % ({low:.0} to {high:.0} %)</span>");
        row(name, &pieces, &words)
    });
    list(caption, rows)
}

fn row(name: &str, pieces: &str, words: &str) -> String {
    format!(
        "<li><span class=\"share-name\">{}</span>\
         <span class=\"share-bar\" aria-hidden=\"true\">{pieces}</span>\
         <span class=\"share-words\">{words}</span></li>\n",
        escaped(name)
    )
}

fn list(caption: &str, rows: impl Iterator<Item = String>) -> String {
    let rows: String = rows.collect();
    let caption = escaped(caption);
    format!("<h4 class=\"left\">{caption}</h4>\n<ul class=\"shares\">\n{rows}</ul>\n")
}
