//! Cost of single cases of a sweep file, each to its end, on one thread: numbers of cases after the file
//! and the method, least of some repetitions.
//!
//! ```text
//! cargo bench -p drillstring-campaign --bench cases_of -- sweeps/fig17.toml held 0 100 200
//! ```
#![allow(missing_docs, reason = "benchmarks are no interface")]

use std::path::Path;
use std::time::{Duration, Instant};

use campaign::Campaign;
use campaign::engine::{Case, Recipe};
use campaign::sweep_file::MethodName;
use campaign::text_file::read_text;
use sim::Stopping;

const REPETITIONS: usize = 10;

fn main() -> anyhow::Result<()> {
    let given: Vec<String> = std::env::args()
        .skip(1)
        .filter(|it| it != "--bench")
        .collect();
    let [file, method, cases @ ..] = given.as_slice() else {
        return Ok(());
    };
    let method: MethodName = serde_json::from_value(method.as_str().into())?;
    // Where `cargo bench` was called.
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(file);
    let campaign = Campaign::open(&file, &[method], &|path, most| read_text(path, most))?;
    let longest = campaign.survey()?.longest;
    let sweep = &campaign.sweep;
    let started = Instant::now();
    let recipe = Recipe::of(sweep, &sweep.setting, sweep.methods[0], longest);
    let system = recipe.build()?;
    println!("built in {:.2?}", started.elapsed());
    for case in cases {
        let case = Case::of(sweep, &sweep.setting, case.parse()?)?;
        let mut least = Duration::MAX;
        for _ in 0..REPETITIONS {
            let started = Instant::now();
            system.simulate(&case, Stopping::Full, None)?;
            least = least.min(started.elapsed());
        }
        println!("{:?} {:.3?}", case.values, least);
    }
    Ok(())
}
