//! What is worth knowing before the work, though nothing is wrong with it.

use super::terminal::Terminal;
use crate::cli::MemoryArguments;
use campaign::engine::MethodSystem;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::snaking_above::SnakingAbove;
use campaign::static_string::BeyondWall;
use campaign::words::counted;
use limits::MOST_SITES;
use linear::bending_decay::BendingDecay;
use results::log::Log;

/// Warns of an amount of memory that the cluster allots and cannot mean.
pub fn warn_of_memory(memory: &MemoryArguments, terminal: Terminal) {
    if let Some(doubt) = memory.ignored() {
        terminal.complain(&format!("warning: {doubt}"));
    }
}

/// Warns of what is doubtful in the sweep, and says what its files were taken to say.
pub fn warn_of_sweep(sweep: &Sweep, terminal: Terminal) {
    for doubt in sweep.doubts() {
        terminal.complain(&format!("warning: {doubt}"));
    }
    for note in sweep.notes() {
        terminal.complain(&format!("note: {note}"));
    }
}

/// Says which limit of whirl is not computed.
pub fn warn_of_limits(sweep: &Sweep, terminal: Terminal) {
    let sites = sweep.setting.sites.len();
    let Some(lateral) = &sweep.setting.lateral else {
        return;
    };
    if !sweep.design.axes().contains(&Axis::FRICTION) {
        return;
    }
    if BendingDecay::new(&sweep.setting.string, &lateral.bending).least() == 0.0 {
        terminal.complain(
            "note: the friction that whirl needs is not computed: nothing holds the string back \
             where it moves sideways, as `damping_ns_m2` and `viscosity_cp` of `[mud]` do",
        );
    } else if sites > MOST_SITES {
        terminal.complain(&format!(
            "note: the friction that whirl of any sites together needs is not computed: there are \
             {sites} \
             sites, more than {MOST_SITES}"
        ));
    }
}

/// Warns of a string that lies in its hole on so few sites that it does not stay within its wall, or
/// that they end where it snakes.
pub fn warn_of_few_sites(sweep: &Sweep, terminal: Terminal) {
    let conditions = sweep.under_greatest_weight();
    if let Some(pushed) = SnakingAbove::of(&sweep.setting, &conditions) {
        terminal.complain(&format!("warning: {}", pushed.words(sweep.content.units)));
    }
    if let Some(beyond) = BeyondWall::far(&sweep.setting, &conditions) {
        let words = beyond.words(sweep.content.units);
        terminal.complain(&format!("warning: at rest the string goes {words}"));
    }
}

/// Warns of methods that chatter where a site sticks.
pub fn warn_of_unstable<'a>(
    systems: impl IntoIterator<Item = &'a MethodSystem>,
    terminal: Terminal,
) {
    for instability in systems.into_iter().filter_map(MethodSystem::instability) {
        terminal.complain(&format!("warning: {instability}"));
    }
}

/// Warns of methods that make too much or too little of fronts on the string as the file has it.
pub fn warn_of_fronts(sweep: &Sweep, systems: &[MethodSystem], terminal: Terminal) {
    let others = match sweep.design.varies_string() {
        true => "; axes change the string, and others may be farther off",
        false => "",
    };
    for front in systems.iter().filter_map(MethodSystem::wrong_front) {
        let words = front.words(sweep.content.units);
        terminal.complain(&format!("warning: {words}{others}"));
    }
}

/// Says what of a log is lost.
pub fn warn_of_broken_lines(log: &Log, terminal: Terminal) {
    let broken = log.counts().broken_lines;
    if broken > 0 {
        terminal.complain(&format!(
            "warning: {} of the log not whole; those cases are run again",
            counted(broken, "line")
        ));
    }
}
