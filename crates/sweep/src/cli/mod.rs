//! The command line.

mod analyse;
mod check;
mod export;
mod inspect;
mod pictures;
mod reference;
mod run;
mod simulate;
mod studies;
mod values;
mod window;

pub use analyse::AnalyseArguments;
pub use check::{CheckArguments, CheckFormat};
pub use export::{ExportArguments, ExportFormat, ExportTable};
pub use inspect::InspectArguments;
pub use pictures::{PictureArguments, PictureFormat, PlotArguments, RangeArguments};
pub use reference::ReferenceArguments;
pub use run::{LogFormat, RunArguments};
pub use simulate::{FilmArguments, SimulateArguments};
pub use studies::{
    ContactsArguments, PromisesArguments, StabilityArguments, Study, TradeoffArguments,
};
pub use values::PictureFile;
pub use window::WindowArguments;

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;

use campaign::allotted::IgnoredSetting;
use campaign::memory::{Limit, Size};
use campaign::sweep_file::MethodName;
use values::sweep_file;

/// Parameter sweeps of drillstring dynamics: stick-slip and whirl regime maps.
#[derive(Debug, Parser)]
#[command(
    name = "sweep",
    version = env!("SWEEP_VERSION"),
    max_term_width = 80,
    after_help = "Examples: a map of your own in two commands\n  \
        sweep new my-sweep.toml\n  sweep run my-sweep.toml\n\n\
        `sweep help COMMAND` tells all options of a command, with examples.\n\
        Exit codes: 0 complete, 1 an error, 2 bad usage or a bad sweep file, 3 cases\n\
        without an answer, 4 shards missing, 5 labels differ, 130 and 143 stopped."
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

impl Cli {
    /// The command line as it was given. A study is found without its group, too, as before
    /// there was one: `sweep tradeoff` is `sweep study tradeoff`.
    pub fn of_program() -> Self {
        let mut words: Vec<OsString> = std::env::args_os().collect();
        let place = if words.get(1).is_some_and(|word| word == "help") {
            2
        } else {
            1
        };
        if words
            .get(place)
            .and_then(|word| word.to_str())
            .is_some_and(Study::has_subcommand)
        {
            words.insert(place, "study".into());
        }
        Self::parse_from(words)
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Write a commented sweep file to start from
    #[command(
        after_help = "Example:\n  sweep new my-sweep.toml\n  sweep run my-sweep.toml\n\n\
        The file runs as it is, in about a second. It needs no other file: string, bit,\n\
        rock and cases are in it, and a borehole wall, impulses and more to switch on."
    )]
    New {
        /// The file to write
        #[arg(default_value = "my-sweep.toml")]
        file: PathBuf,
        /// Write sweep.schema.json next to it, by which editors complete its keys
        #[arg(long)]
        schema: bool,
        /// Write over a file that is there
        #[arg(long)]
        force: bool,
    },
    /// Run every case of a sweep by every method, into a results folder
    #[command(
        after_help = "Examples:\n  sweep run sweeps/fig09.toml --out /tmp/fig09\n  \
        sweep run sweeps/fig09.toml --shard 0/4\n\n\
        A run that was stopped, in any way, continues where it stopped when the same

        command is given again."
    )]
    Run(RunArguments),
    /// Rerun the cases of a reference label file and compare the labels
    #[command(
        after_help = "Examples:\n  sweep check sweeps/fig09.toml results/reference/fig09.csv\n  \
        sweep check sweeps/fig09.toml results/reference/fig09.csv \\\n    \
        --format junit --output check.xml\n\n\
        Exit code 5 where a label differs; each that does is printed."
    )]
    Check(CheckArguments),
    /// Make a reference of the cases whose labels are far from changing
    #[command(
        after_help = "Examples:\n  sweep reference results/fig09 --margin 4% --out fig09.csv\n  \
        sweep check sweeps/fig09.toml fig09.csv\n\n\
        Each case is simulated again with each axis changed by the margin, up and down. It\n\
        is kept if no label of it changes by any method. The file states the margin."
    )]
    Reference(ReferenceArguments),
    /// Run a case in full: motion and contact, as CSV and as pictures
    #[command(after_help = "Examples:\n  sweep simulate sweeps/fig08b.toml\n  \
        sweep simulate sweeps/fig16b.toml --film --film-to 2.5\n  \
        sweep simulate sweeps/fig09.toml --case 17\n  \
        sweep simulate sweeps/fig13.toml --case 0,1\n  \
        sweep simulate sweeps/fig09.toml --set weight_on_bit_kn=60\n  \
        sweep simulate sweeps/fig12.toml --width 90mm --format pdf --x-range 0..5\n\n\
        A case of the sweep is the case that `run` runs: case.csv has its rows of\n\
        labels.csv. Exit code 3 where it has no answer, as in failures.csv.")]
    Simulate(SimulateArguments),
    /// Show the linear system: stiffness, responses, stability, cost
    #[command(after_help = "Examples:\n  sweep inspect sweeps/fig09.toml\n  \
        sweep inspect sweeps/well_12in.toml --modes --orders 1,3,6\n  \
        sweep inspect sweeps/fig10.toml --csv --out /tmp/fig10")]
    Inspect(InspectArguments),
    /// Draw the regime map of a results folder again
    #[command(after_help = "Examples:\n  sweep plot results/fig09\n  \
        sweep plot results/fig09 --width 90mm --format pdf --title none\n  \
        sweep plot results/fig09 --x-range 0..60 --y-range 0..0.3\n\n\
        A picture with --width is laid out for it, with text of --font-size.")]
    Plot(PlotArguments),
    /// Join the shards of a sweep into one results folder
    #[command(
        after_help = "Example:\n  sweep merge results/fig14/shard-* --out results/fig14\n\n\
        Exit code 4 where a shard is missing or not finished; its number is printed."
    )]
    Merge {
        /// The shards' results folders
        #[arg(required = true)]
        folders: Vec<PathBuf>,
        /// Results folder
        #[arg(long)]
        out: PathBuf,
    },
    /// Write a page about a results folder, or several side by side
    #[command(after_help = "Examples:\n  sweep report results/fig09\n  \
        sweep report results/fig14 results/fig17 --out whirl.html\n\n\
        The page is one file, and needs neither network nor scripts.")]
    Report(ReportArguments),
    /// Write a page whose sliders simulate a case anew as they move
    #[command(after_help = "Examples:\n  sweep explore sweeps/fig09.toml\n  \
        sweep explore sweeps/fig12.toml --out whirl.html\n\n\
        The page is one file with the engine in it: it needs no network. The command that\n\
        it shows repeats what is on it.")]
    Explore(ExploreArguments),
    /// Say in the terminal what a results folder holds
    #[command(after_help = "Examples:\n  sweep summary results/fig09\n  \
        sweep summary results/fig09 --json | jq .agreement")]
    Summary {
        /// A results folder, of an unfinished run too
        folder: PathBuf,
        #[command(flatten)]
        document: DocumentArguments,
    },
    /// Write labels or histories in another format, such as Parquet
    #[command(
        after_help = "Examples:\n  sweep export results/fig09 --format parquet\n  \
        sweep export results/fig10 --table history --format parquet\n\n\
        Needs a program that is built with it, as those of releases are:\n  \
        cargo install --locked --path crates/sweep --features parquet"
    )]
    Export(ExportArguments),
    /// Say how often each regime occurs, how surely, and what decides
    #[command(after_help = "Examples:\n  sweep analyse results/well\n  \
        sweep analyse results/well --by weight_on_bit_kn,surface_speed_rpm --width 0.02\n  \
        sweep analyse results/well --by weight_on_bit_kn,surface_speed_rpm --picture map.svg\n  \
        sweep analyse results/well/shard-* --out analysis.csv\n\n\
        Of unfinished runs as far as they are. Intervals are of 95 % (Wilson, and for\n\
        Sobol's indices of sensitivity designs a bootstrap).")]
    Analyse(AnalyseArguments),
    /// Draw where weight and speed are safe, and the best point there
    #[command(after_help = "Examples:\n  sweep run sweeps/well_12in_window.toml\n  \
        sweep window sweeps/well_12in_window.toml\n  \
        sweep window sweeps/well_12in_window.toml --held-at 0,9,18,32 --orders 1,2\n\n\
        The file tells the string, its walls and its friction; the folders hold simulated\n\
        cases of it over weight_on_bit_kn and surface_speed_rpm: a grid, a trace or random\n\
        cases, of unfinished runs too.")]
    Window(WindowArguments),
    /// Study the program itself: accuracy and speed, failures, promises
    #[command(
        subcommand,
        after_help = "Examples:\n  sweep study tradeoff\n  \
        sweep study stability --family newmark\n  sweep help study contacts\n\n\
        Each is also found without `study`, as it was called before."
    )]
    Study(Study),
    /// Print the JSON Schema of sweep files, for editors
    #[command(after_help = "Example:\n  sweep schema > sweep.schema.json\n\n\
        Editors that know TOML read it where the first line of a sweep file is\n  \
        #:schema ./sweep.schema.json")]
    Schema,
    /// Print a script that completes this command line in a shell
    #[command(after_help = "Example, for bash:\n  \
        sweep completions bash > ~/.local/share/bash-completion/completions/sweep")]
    Completions {
        /// Which shell
        shell: Shell,
    },
    /// Print the manual page of the program or of a command
    #[command(after_help = "Examples:\n  sweep man run | man -l -\n  \
        sweep man study tradeoff | man -l -\n  \
        sweep man > ~/.local/share/man/man1/sweep.1")]
    Man {
        /// Which command; without it, the program
        command: Vec<String>,
    },
}

/// What every command that simulates understands.
#[derive(Debug, Args)]
pub struct WorkArguments {
    /// Methods to use instead of those the file names
    #[arg(long, value_delimiter = ',')]
    pub methods: Vec<MethodName>,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    #[command(flatten)]
    pub memory: MemoryArguments,
}

/// How much memory a command may take.
#[derive(Debug, Args)]
pub struct MemoryArguments {
    /// Refuse what would take more memory, e.g. 8G [default: $SLURM_MEM_PER_NODE, half of all]
    #[arg(long, value_name = "SIZE")]
    memory: Option<Size>,
}

impl MemoryArguments {
    /// The limit they set.
    pub fn limit(&self) -> Limit {
        Limit::of(self.memory)
    }

    /// What was given as a limit but is not a valid one.
    pub fn ignored(&self) -> Option<IgnoredSetting> {
        Limit::ignored(self.memory)
    }
}

/// Arguments of `explore`.
#[derive(Debug, Args)]
pub struct ExploreArguments {
    /// The sweep file, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// The page
    #[arg(long, default_value = "explore.html")]
    pub out: PathBuf,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
    /// The case that it begins with, from 0
    #[arg(long, default_value_t = 0)]
    pub case: usize,
    #[command(flatten)]
    pub memory: MemoryArguments,
}

/// Who reads what a command says.
#[derive(Debug, Clone, Copy, Args)]
pub struct DocumentArguments {
    /// Print one JSON document, for programs, instead of lines for people
    #[arg(long)]
    pub json: bool,
}

/// Whether a file may be lost.
#[derive(Debug, Clone, Copy, Args)]
pub struct OverwriteArguments {
    /// Write over a file that this command did not write
    #[arg(long)]
    pub force: bool,
}

/// Arguments of `report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Results folders, of unfinished runs too
    #[arg(required = true)]
    pub folders: Vec<PathBuf>,
    /// The page [default: report.html, in the folder if there is one, else here]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
}
