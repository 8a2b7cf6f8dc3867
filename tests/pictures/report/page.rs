//! The page: whole in itself, well-formed, and no more than text from what a user
//! wrote.

use std::process::Command;

use crate::report::{report, succeeds, text, with_results, write_table};
use crate::support::{SMALL, Workplace, with};

/// A page without what its scripts hold, which is no markup.
pub fn markup(html: &str) -> String {
    let mut pieces = html.split("<script");
    let mut markup = pieces.next().unwrap().to_owned();
    for piece in pieces {
        let (start, rest) = piece.split_once('>').unwrap();
        let (_, after) = rest.split_once("</script>").unwrap();
        markup += &format!("<script{start}></script>{after}");
    }
    markup
}

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
    const WITHOUT_END: [&str; 3] = ["!DOCTYPE", "meta", "link"];
    let html = &markup(html);
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
        // The name of SVG is no address that anything is fetched from.
        let page = page.replace("\"http://www.w3.org/2000/svg\"", "");
        for foreign in [
            "http:",
            "https:",
            "@import",
            "javascript:",
            "<iframe",
            "fetch(",
            "innerHTML",
        ] {
            assert!(!page.contains(foreign), "{foreign}");
        }
        // Patterns of the page itself.
        assert_eq!(page.matches("url(").count(), page.matches("url(#").count());
        assert!(values(&markup(&page), "src").is_empty());
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
    let page = markup(&page);
    let (tables, images) = (
        page.matches("<table>").count(),
        page.matches("role=\"img\"").count(),
    );
    assert_eq!(page.matches("<caption>").count(), tables);
    // The map of both methods, and one of each.
    assert!(tables > 5 && images == 3);
    let svgs = page.split("<svg ").skip(1);
    let mut starts = svgs.map(|svg| svg.split('>').next().unwrap());
    assert!(starts.all(|start| start.contains("aria-hidden=") || start.contains("aria-label=")));
}

#[test]
fn what_a_user_wrote_stays_text() {
    let title = "title = \"<script>alert('x')</script> & \\\"T_d\\\"\"";
    let place = Workplace::with_small(&with(SMALL, "title = \"A small sweep\"", title));
    succeeds(&place, &["run", "small.toml", "--out", "a&b<i>"]);
    let page = report(&place, &["a&b<i>", "a&b<i>"]);
    assert_well_formed(&page);
    // The cases of two folders, the engine and the page's own script.
    assert_eq!(page.matches("<script").count(), 4);
    assert!(!markup(&page).contains("alert('x')") && !page.contains("<i>"));
    assert!(page.contains("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;T_d&quot;"));
}

/// A mark, a heading of a failure, the path of a folder: what ends an element of data does not
/// end this one.
#[test]
fn data_of_a_page_cannot_end_their_element() {
    let name = "name = \"</script><b>\"";
    let place = Workplace::with_small(&with(SMALL, "name = \"A\"", name));
    succeeds(&place, &["run", "small.toml", "--out", "results"]);
    let page = report(&place, &["results"]);
    assert_well_formed(&page);
    assert_eq!(page.matches("</script>").count(), 3);
    assert!(!page.contains("<b>"));
    let cases = cases_of(&page);
    let marks = &cases["opening"]["sweep"]["map"]["marks"];
    assert_eq!(marks[0]["name"], "</script><b>");
}

/// The cases that a page holds of its first folder.
fn cases_of(page: &str) -> serde_json::Value {
    let start = "<script type=\"application/json\" id=\"cases-0\">";
    let (_, data) = page.split_once(start).expect("cases");
    serde_json::from_str(data.split("</script>").next().unwrap()).unwrap()
}

#[test]
fn the_page_holds_what_labels_csv_says_to_the_last_digit() {
    let place = with_results();
    let cases = cases_of(&report(&place, &["results"]));
    let labels = text(&place, "results/labels.csv");
    let mut lines = labels
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let columns = cases["columns"].as_array().unwrap();
    let mut compared = 0;
    for (row, fields) in lines.enumerate() {
        let case = row / 2;
        assert_eq!(cases["cases"][case].to_string(), fields[0]);
        assert_eq!(cases["methods"][row % 2], fields[1]);
        for (name, field) in header.iter().zip(&fields).skip(2) {
            let axes = cases["axes"].as_array().unwrap();
            let axis = axes.iter().position(|axis| axis["name"] == *name);
            let column = columns.iter().find(|column| column["name"] == *name);
            let held = match (axis, column) {
                (Some(axis), _) => &cases["values"][axis][case],
                (None, Some(column)) => &column["rows"][row],
                (None, None) => &serde_json::Value::Null,
            };
            let texts = column.and_then(|column| column["texts"].as_array());
            match (held.as_f64(), texts) {
                (None, _) => assert_eq!(*field, "", "{name} of row {row}"),
                (Some(place), Some(texts)) => assert_eq!(texts[place as usize], *field),
                (Some(value), None) => {
                    // What reads JSON here may be off by the last bit.
                    let written: f64 = field.parse().unwrap();
                    let off = (value - written).abs();
                    assert!(
                        off <= 2.0 * f64::EPSILON * written.abs(),
                        "{name}: {value}, {field}"
                    );
                }
            }
            compared += usize::from(!held.is_null());
        }
    }
    assert!(compared > 12 * 8, "{compared}");
}

/// Without scripts the map is there all the same: a symbol for each case.
#[test]
fn the_map_is_in_the_page_without_its_script() {
    let place = with_results();
    let page = markup(&report(&place, &["results"]));
    let (_, area) = page.split_once("class=\"area\"").unwrap();
    let area = area.split("</svg>").next().unwrap();
    // Each symbol is one part of the path of its kind.
    let symbols = |class: &str| {
        let start = format!("<path class=\"symbol {class}\" d=\"");
        let path = area.split_once(&start).map_or("", |(_, rest)| rest);
        path.split('"').next().unwrap().matches('M').count()
    };
    let drawn: usize = ["circle", "cross", "square"].map(symbols).iter().sum();
    assert_eq!(drawn, 6, "{area}");
    for said in [
        "Weight on bit W (kN)",
        "Surface speed",
        "stick-slip by all methods",
    ] {
        assert!(page.contains(said), "{said}");
    }
}

/// A browser runs no script but the page's own, which it knows by its hash, and lets the page
/// fetch nothing.
#[test]
fn only_the_script_of_the_page_may_run() {
    let place = with_results();
    let page = report(&place, &["results"]);
    let (_, script) = page.split_once("<script type=\"module\">").unwrap();
    let script = script.split("</script>").next().unwrap();
    let digest = <sha2::Sha256 as sha2::Digest>::digest(script);
    let hash = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, digest);
    let policy = values(&markup(&page), "content")[0].to_owned();
    assert!(policy.starts_with("default-src 'none';"), "{policy}");
    assert!(
        policy.contains(&format!(
            "script-src 'sha256-{hash}' 'wasm-unsafe-eval' blob:;"
        )),
        "{policy}"
    );
    assert!(!policy.contains("script-src 'unsafe-inline'") && !policy.contains("http"));
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
        page.contains(" data-name=\"reason\">the speed is &lt;inf&gt;, at once</td>"),
        "{page}"
    );
    assert!(page.contains(">sweep simulate small.toml --case 0</td>"));
    assert!(page.contains("1 simulation of 12 failed and left no answer"));
    let reason = &cases_of(&page)["failures"]["0"]["quadrature"];
    assert_eq!(reason, "the speed is <inf>, at once");
    let summary = succeeds(&place, &["summary", "results"]).output;
    assert!(summary.contains("Failed simulations, all 1"), "{summary}");
    assert!(summary.contains("sweep simulate small.toml --case 0"));
}

/// In a real browser: nothing asked for, nothing on the console,
/// not wider than a phone; the values shown of a case are those of labels.csv, and its motion,
/// simulated in the page, is that of `sweep simulate` to 1e-9.
#[test]
#[ignore = "needs Node and Chromium"]
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
        .args([place.path("results"), place.path("results")])
        .env("SWEEP", assert_cmd::cargo::cargo_bin!("sweep"))
        .current_dir(place.path("."))
        .output()
        .expect("Node");
    assert!(looked.status.success(), "{looked:?}");
}
