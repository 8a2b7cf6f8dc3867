//! The page: whole in itself, well-formed, and no more than text from what a user
//! wrote.

use std::process::Command;

use crate::support::{SMALL, Workplace, with};
use crate::{report, succeeds, text, with_results, write_table};

/// What stands between `<` and `>`, comments left out; the style holds none.
fn tags(html: &str) -> Vec<&str> {
    let pieces = html.split('<').skip(1);
    pieces
        .map(|piece| piece.split('>').next().unwrap())
        .collect()
}

/// The values of an attribute, wherever it is.
fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
    let before = format!(" {attribute}=\"");
    let of_tag = |tag: &'a str| Some(tag.split_once(&before)?.1.split('"').next().unwrap());
    tags(html).into_iter().filter_map(of_tag).collect()
}

/// Fails unless every element is closed where it should be and names are unique.
#[track_caller]
fn assert_well_formed(html: &str) {
    const WITHOUT_END: [&str; 4] = ["!DOCTYPE", "meta", "link", "img"];
    let mut open: Vec<&str> = Vec::new();
    for tag in tags(html) {
        let name = tag.split([' ', '\n']).next().unwrap();
        if let Some(end) = name.strip_prefix('/') {
            assert_eq!(open.pop(), Some(end), "</{end}>");
        } else if !WITHOUT_END.contains(&name) {
            open.push(name);
        }
        assert_eq!(tag.matches('"').count() % 2, 0, "<{tag}>");
    }
    assert!(open.is_empty(), "{open:?}");
    let mut ids = values(html, "id");
    let count = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), count);
    for link in values(html, "href") {
        let target = link.strip_prefix('#');
        assert!(
            link == "data:," || target.is_some_and(|id| ids.contains(&id)),
            "{link}"
        );
    }
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let place = with_results();
    for page in [
        report(&place, &["results"]),
        report(&place, &["results", "results"]),
    ] {
        assert_well_formed(&page);
        for foreign in [
            "http:",
            "https:",
            "<script",
            "@import",
            "url(",
            "javascript:",
            "<iframe",
        ] {
            assert!(!page.contains(foreign), "{foreign}");
        }
        let sources = values(&page, "src");
        assert!(!sources.is_empty());
        assert!(
            sources
                .iter()
                .all(|source| source.starts_with("data:image/svg+xml;base64,"))
        );
    }
}

#[test]
fn the_page_is_for_every_reader() {
    let place = with_results();
    let page = report(&place, &["results"]);
    for needed in [
        "<html lang=\"en\">",
        "width=device-width",
        "prefers-color-scheme: dark",
        "@media print",
        "<main>",
        "<nav aria-label",
        "<header>",
        "<footer>",
    ] {
        assert!(page.contains(needed), "{needed}");
    }
    let (tables, images) = (
        page.matches("<table>").count(),
        page.matches("<img").count(),
    );
    assert_eq!(page.matches("<caption>").count(), tables);
    assert_eq!(values(&page, "alt").len(), images);
    assert!(tables > 5 && images == 1);
}

#[test]
fn what_a_user_wrote_stays_text() {
    let title = "title = \"<script>alert('x')</script> & \\\"T_d\\\"\"";
    let place = Workplace::with_small(&with(SMALL, "title = \"A small sweep\"", title));
    succeeds(&place, &["run", "small.toml", "--out", "a&b<i>"]);
    let page = report(&place, &["a&b<i>", "a&b<i>"]);
    assert_well_formed(&page);
    assert!(!page.contains("<script") && !page.contains("<i>"));
    assert!(page.contains("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;T_d&quot;"));
}

#[test]
fn a_failed_case_is_there_with_its_reason_and_its_command() {
    let place = with_results();
    let labels = text(&place, "results/labels.csv");
    let row = labels.lines().nth(1).unwrap();
    let fields = row.split(',').count();
    // The case, the method and the axes, and no answer.
    let start: Vec<&str> = row.split(',').take(5).collect();
    let failed = format!("{}{}failed", start.join(","), ",".repeat(fields - 5));
    write_table(&place, "results", "labels.csv", with(&labels, row, &failed));
    write_table(
        &place,
        "results",
        "failures.csv",
        "case,method,reason,repeat_with\n\
         0,quadrature,\"the speed is <inf>, at once\",sweep simulate small.toml --case 0\n",
    );
    let manifest = text(&place, "results/manifest.json");
    let manifest = with(&manifest, "\"failed\": 0", "\"failed\": 1");
    place.write("results/manifest.json", manifest);
    let page = report(&place, &["results"]);
    assert_well_formed(&page);
    assert!(
        page.contains("<td>the speed is &lt;inf&gt;, at once</td>"),
        "{page}"
    );
    assert!(page.contains("<td>sweep simulate small.toml --case 0</td>"));
    let summary = succeeds(&place, &["summary", "results"]).output;
    assert!(summary.contains("Failed simulations, all 1"), "{summary}");
    assert!(summary.contains("sweep simulate small.toml --case 0"));
}

/// In a real browser, where there is one: nothing asked for, nothing on the console,
/// not wider than a phone.
#[test]
fn a_browser_finds_no_fault() {
    let place = with_results();
    report(&place, &["results", "results"]);
    let script = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scripts/look-at-report.mjs"
    );
    let (page, pictures) = (place.path("page.html"), place.path("pictures"));
    let looked = Command::new("node")
        .arg(script)
        .arg(page)
        .arg(pictures)
        .output();
    match looked {
        Err(error) => println!("skipped: node cannot be started ({error})"),
        Ok(output) if output.status.code() == Some(3) => {
            println!("{}", String::from_utf8_lossy(&output.stderr));
        }
        Ok(output) => assert!(output.status.success(), "{output:?}"),
    }
}
