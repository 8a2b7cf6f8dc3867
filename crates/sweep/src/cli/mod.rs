//! The command line.

mod check;
mod export;
mod reference;
mod studies;
mod values;

pub use check::{CheckArguments, CheckFormat};
pub use export::{ExportArguments, ExportFormat};
pub use reference::ReferenceArguments;
pub use studies::{
    ContactsArguments, PromisesArguments, StabilityArguments, Study, TradeoffArguments,
};
pub use values::{AxesOfCells, AxisRange, Length, PictureFile};

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use sim::Label;

use campaign::allotted::IgnoredSetting;
use campaign::engine::{RunOptions, Shard};
use campaign::memory::{Limit, Size};
use campaign::quantities::Axis;
use campaign::sweep_file::MethodName;
use values::{
    parse_axes, parse_length, parse_order, parse_part, parse_picture, parse_range, parse_regime,
    parse_setting, parse_width,
};

/// Parameter sweeps of drillstring dynamics: stick-slip and whirl regime maps.
#[derive(Debug, Parser)]
#[command(
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
    #[command(after_help = "Example:\n  sweep summary results/fig09")]
    Summary {
        /// A results folder, of an unfinished run too
        folder: PathBuf,
    },
    /// Write the labels of a results folder in another format
    #[command(
        after_help = "Example:\n  sweep export results/fig09 --format parquet\n\n\
        Needs a program that is built with it:\n  \
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

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// The sweep file
    pub file: PathBuf,
    /// Results folder [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub work: WorkArguments,
    /// Say what would run and why, and stop
    #[arg(long)]
    pub dry_run: bool,
    /// Run only part I (from 0) of N [default folder: results/NAME/shard-I-of-N]
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Begin anew, over the results of an earlier run or a part of it
    #[arg(long)]
    pub fresh: bool,
    /// Continue after a case without an answer, and list it in failures.csv (the default)
    #[arg(long, conflicts_with = "fail_fast")]
    pub keep_going: bool,
    /// Stop at the first case that gives no answer
    #[arg(long)]
    pub fail_fast: bool,
    /// Simulate every case to its end, even where the rest is certain or settled
    #[arg(long)]
    pub full: bool,
    /// Only warn of a method whose margin says that a stuck site chatters
    #[arg(long)]
    pub allow_unstable: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
    /// How to tell of progress on the error stream
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub log: LogFormat,
}

impl RunArguments {
    /// What of them the results depend on.
    pub fn options(&self) -> RunOptions {
        RunOptions {
            full: self.full,
            allow_unstable: self.allow_unstable,
        }
    }
}

/// How progress is reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LogFormat {
    /// For people: a bar on a terminal, lines elsewhere
    Text,
    /// One JSON object a line
    Json,
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

/// How pictures look.
#[derive(Debug, Args)]
pub struct PictureArguments {
    /// Width of pictures on paper, e.g. 90mm, 9cm, 3.5in, 255pt [default: as for a screen]
    #[arg(long, value_name = "LENGTH", value_parser = parse_length)]
    pub width: Option<Length>,
    /// With --width: the size of numbers and legends, e.g. 8pt
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = "8pt",
        requires = "width",
        value_parser = parse_length
    )]
    pub font_size: Length,
    /// Formats of pictures, separated by commas
    #[arg(
        long,
        value_name = "FORMATS",
        value_delimiter = ',',
        default_value = "svg,png"
    )]
    pub format: Vec<PictureFormat>,
    /// Title that replaces those of the pictures; `none` for no title
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
}

/// Which part of a picture is shown.
#[derive(Debug, Args)]
pub struct RangeArguments {
    /// Ends of the horizontal axis, in its unit, e.g. 0..60; of a history, of time
    #[arg(
        long,
        value_name = "FROM..TO",
        allow_hyphen_values = true,
        value_parser = parse_range
    )]
    pub x_range: Option<AxisRange>,
    /// Ends of the vertical axis, in its unit; of a history, of its first quantity
    #[arg(
        long,
        value_name = "FROM..TO",
        allow_hyphen_values = true,
        value_parser = parse_range
    )]
    pub y_range: Option<AxisRange>,
}

/// A format of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    /// In vectors, for a page
    Svg,
    /// In pixels, twice as many as on a screen; with --width, 600 to the inch
    Png,
    /// In vectors, for paper
    Pdf,
}

impl PictureFormat {
    /// The ending of its files.
    pub fn ending(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
        }
    }
}

/// Arguments of `plot`.
#[derive(Debug, Args)]
pub struct PlotArguments {
    /// A results folder, of an unfinished run too
    pub folder: PathBuf,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub ranges: RangeArguments,
}

/// Arguments of `simulate`.
#[derive(Debug, Args)]
pub struct SimulateArguments {
    /// The sweep file
    pub file: PathBuf,
    /// Which of the sweep's cases, from 0; several are drawn together
    #[arg(long, value_name = "CASES", value_delimiter = ',', default_value = "0")]
    pub case: Vec<usize>,
    /// Set a quantity, e.g. surface_speed_rpm=0.1; may be repeated
    #[arg(long, value_name = "AXIS=VALUE", value_parser = parse_setting)]
    pub set: Vec<(Axis, f64)>,
    #[command(flatten)]
    pub film: FilmArguments,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub ranges: RangeArguments,
    /// Folder for the files [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub work: WorkArguments,
    /// The case of a run with --full: its numbers are those at its end
    #[arg(long)]
    pub full: bool,
    /// The case of a run with --allow-unstable, where axes change the string
    #[arg(long)]
    pub allow_unstable: bool,
}

/// Which snapshots `simulate` draws of the string in its hole.
#[derive(Debug, Args)]
pub struct FilmArguments {
    /// Draw the string in its hole from time to time, of the first case and method
    #[arg(long)]
    pub film: bool,
    /// With --film: how many frames, up to 60
    #[arg(
        long = "film-frames",
        value_name = "N",
        default_value = "12",
        requires = "film",
        value_parser = clap::value_parser!(u8).range(1..=60)
    )]
    pub frames: u8,
    /// With --film: time of its first frame, s [default: at the first contact]
    #[arg(long = "film-from", value_name = "TIME", requires = "film")]
    pub from: Option<f64>,
    /// With --film: time of its last frame, s [default: at the end]
    #[arg(long = "film-to", value_name = "TIME", requires = "film")]
    pub to: Option<f64>,
}

impl FilmArguments {
    /// How many frames are asked for.
    pub fn frames_asked(&self) -> usize {
        if self.film { self.frames.into() } else { 0 }
    }
}

/// Arguments of `inspect`.
#[derive(Debug, Args)]
pub struct InspectArguments {
    /// The sweep file
    pub file: PathBuf,
    /// Folder for pictures and tables [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Show natural frequencies, critical speeds and shapes of the N lowest modes [default N: 6]
    #[arg(
        long,
        value_name = "N",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "6",
        value_parser = clap::value_parser!(u8).range(1..=30)
    )]
    pub modes: Option<u8>,
    /// With --modes: what shakes the string, in multiples of its surface speed
    #[arg(
        long,
        value_name = "ORDERS",
        value_delimiter = ',',
        default_value = "1,2,3",
        requires = "modes",
        value_parser = parse_order
    )]
    pub orders: Vec<f64>,
    /// Write impulse and frequency responses and modes as CSV into the folder
    #[arg(long)]
    pub csv: bool,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub work: WorkArguments,
}

/// Arguments of `explore`.
#[derive(Debug, Args)]
pub struct ExploreArguments {
    /// The sweep file
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

/// Arguments of `analyse`.
#[derive(Debug, Args)]
pub struct AnalyseArguments {
    /// A results folder, or shards of one sweep
    #[arg(required = true)]
    pub folders: Vec<PathBuf>,
    /// Count over ranges of an axis, or of two: X or X,Y; may be repeated [default: each axis]
    #[arg(long, value_name = "AXES", value_parser = parse_axes)]
    pub by: Vec<AxesOfCells>,
    /// Ranges of an axis that has more than a few values
    #[arg(long, default_value = "10", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub bins: u16,
    /// Say how many more cases an interval no wider than this takes, e.g. 0.02
    #[arg(long, value_parser = parse_width)]
    pub width: Option<f64>,
    /// Write all counts and intervals to a CSV file
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write Sobol's indices of a sensitivity design to a CSV file
    #[arg(long, value_name = "FILE")]
    pub indices: Option<PathBuf>,
    /// Draw how likely a regime is over the axes of --by, as .svg or .png
    #[arg(long, value_name = "FILE", value_parser = parse_picture, requires = "by")]
    pub picture: Option<PictureFile>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
    /// Which regime to draw, by its label [default: stick-slip, sustained whirl]
    #[arg(long, value_name = "LABEL", value_parser = parse_regime, requires = "picture")]
    pub regime: Option<Label>,
}

/// Arguments of `window`.
#[derive(Debug, Args)]
pub struct WindowArguments {
    /// The sweep file
    pub file: PathBuf,
    /// Results folders of its string [default: results/NAME, by the name of the sweep file]
    pub folders: Vec<PathBuf>,
    /// Folder for window.svg, window.png and window.csv [default: the first results folder]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// What shakes the string sideways, in multiples of its surface speed
    #[arg(long, value_name = "ORDERS", value_delimiter = ',', default_value = "1", value_parser = parse_order)]
    pub orders: Vec<f64>,
    /// Places that hold the string sideways, from the bit, in m or, with `units = "field"`, ft [default: the sites of the file]
    #[arg(long, value_name = "PLACES", value_delimiter = ',')]
    pub held_at: Option<Vec<f64>>,
    /// The part by which a critical speed and the wall's friction may be off
    #[arg(long, default_value_t = 0.1, value_parser = parse_part)]
    pub margin: f64,
    /// Of random cases, the part with vibration up to which a cell is safe
    #[arg(long, default_value_t = 0.1, value_parser = parse_part)]
    pub risk: f64,
    /// Ranges of either axis that random cases are counted in
    #[arg(long, default_value = "10", value_parser = clap::value_parser!(u16).range(2..=100))]
    pub bins: u16,
    /// The part of either axis that the best point keeps from every limit
    #[arg(long, default_value_t = 0.05, value_parser = parse_part)]
    pub clearance: f64,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
}
