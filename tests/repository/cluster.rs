//! The recipes of docs/cluster.md: their commands, as a shell runs them for each index that the
//! scheduler sets, give shards whose merge is the whole.

use std::path::PathBuf;
use std::process::Command;

use crate::root;
use crate::support::{SMALL, Workplace};

/// Shards of the recipes.
const SHARDS: usize = 40;

fn page() -> String {
    std::fs::read_to_string(root().join("docs/cluster.md")).unwrap()
}

/// The block of a language that alone has a piece.
#[track_caller]
fn block(language: &str, piece: &str) -> String {
    let page = page();
    let start = format!("```{language}\n");
    let blocks = page.split(&start).skip(1);
    let blocks = blocks.map(|rest| rest.split("```").next().unwrap());
    let found: Vec<&str> = blocks.filter(|block| block.contains(piece)).collect();
    assert_eq!(found.len(), 1, "{piece}: {found:?}");
    found[0].to_owned()
}

/// The value of a key of an HTCondor submit file.
#[track_caller]
fn submitted(file: &str, key: &str) -> String {
    let value = file.lines().find_map(|line| {
        let (name, value) = line.split_once(" = ")?;
        (name == key).then(|| value.to_owned())
    });
    value.unwrap_or_else(|| panic!("no {key} in\n{file}"))
}

/// A folder with the small sweep by the name of that of the recipes, and all of it as one run.
fn workplace() -> Workplace {
    let place = Workplace::new();
    std::fs::create_dir(place.path("sweeps")).unwrap();
    place.write("sweeps/fig17.toml", SMALL);
    let run = ["run", "sweeps/fig17.toml", "--quiet", "--out", "whole"];
    assert_eq!(place.sweep(&run).code, 0);
    place
}

/// Runs a script as a shell does that finds the program on its path, with some variables.
#[track_caller]
fn shell(place: &Workplace, script: &str, variables: &[(&str, &str)]) {
    let program = PathBuf::from(place.command(&[]).get_program());
    let path = format!(
        "{}:{}",
        program.parent().unwrap().display(),
        std::env::var("PATH").unwrap()
    );
    let mut command = Command::new("sh");
    command.args(["-c", script]).current_dir(place.path(""));
    command.env("PATH", path).envs(variables.iter().copied());
    let output = command.output().unwrap();
    assert!(output.status.success(), "{script}\n{output:?}");
}

/// Merges as a block of the page says, and compares with the whole.
#[track_caller]
fn merge_is_whole(place: &Workplace, script: &str, variables: &[(&str, &str)]) {
    shell(place, script, variables);
    for table in ["labels.csv", "boundary.csv", "failures.csv"] {
        let read = |folder: &str| {
            let path = place.path(folder).join(table);
            std::fs::read_to_string(path).unwrap()
        };
        assert_eq!(read("results/fig17"), read("whole"), "{table}");
    }
}

#[test]
fn arrays_of_pbs_and_torque_make_the_whole() {
    let (shard, merge) = (block("sh", "# shards.pbs"), block("sh", "# merge.pbs"));
    assert!(shard.contains(&format!("qsub -J 0-{}", SHARDS - 1)));
    for variable in ["PBS_ARRAY_INDEX", "PBS_ARRAYID"] {
        let place = workplace();
        let folder = place.path("").display().to_string();
        // From where a job starts.
        let (shard, merge) = (format!("cd /\n{shard}"), format!("cd /\n{merge}"));
        for index in 0..SHARDS {
            let index = index.to_string();
            shell(
                &place,
                &shard,
                &[(variable, &index), ("PBS_O_WORKDIR", &folder)],
            );
        }
        merge_is_whole(&place, &merge, &[("PBS_O_WORKDIR", &folder)]);
    }
}

#[test]
fn a_cluster_of_htcondor_makes_the_whole() {
    let file = block("ini", "condor_submit");
    assert!(file.ends_with(&format!("\nqueue {SHARDS}\n")), "{file}");
    let [program, arguments] = ["executable", "arguments"].map(|key| submitted(&file, key));
    let place = workplace();
    for process in 0..SHARDS {
        let arguments = arguments.replace("$(Process)", &process.to_string());
        shell(&place, &format!("{program} {arguments}"), &[]);
    }
    let merge = block("sh", "condor_wait");
    let (wait, merge) = merge.split_once(" && ").unwrap();
    assert_eq!(wait, format!("condor_wait {}", submitted(&file, "log")));
    merge_is_whole(&place, merge, &[]);
}

/// The arguments of the container are a folded text of YAML: its lines with spaces between them.
#[test]
fn an_indexed_job_of_kubernetes_makes_the_whole() {
    let file = block("yaml", "kind: Job");
    assert!(file.contains(&format!("completions: {SHARDS}\n")), "{file}");
    assert!(file.contains("completionMode: Indexed") && file.contains("command: [sh, -c]"));
    let (_, arguments) = file.split_once("args:\n            - ").unwrap();
    let lines: Vec<&str> = arguments.lines().map(str::trim).collect();
    let script = lines.join(" ");
    // What YAML would take for a comment, or for a key.
    assert!(!script.contains(" #") && !script.contains(": "), "{script}");
    let place = workplace();
    for index in 0..SHARDS {
        let index = index.to_string();
        shell(&place, &script, &[("JOB_COMPLETION_INDEX", &index)]);
    }
    let page = page();
    let after = page.split("### Kubernetes").nth(1).unwrap();
    let merge = after.split("```sh\n").nth(1).unwrap();
    merge_is_whole(&place, merge.split("```").next().unwrap(), &[]);
}
