//! What a row of a sheet is, by what people call it.

/// What a row is, as far as its name says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToolKind {
    /// The bit.
    Bit,
    /// Pipe with tool joints.
    Drillpipe,
    /// Heavy-weight drillpipe.
    HeavyWeight,
    /// Drill collars.
    Collar,
    /// A tool, a sub, a stabiliser.
    Tool,
    /// Its name says nothing here.
    Unknown,
}

/// What `[motor]` models.
pub const MUD_MOTOR: &str = "a mud motor";

/// Tools that are more than a tube: their words, and their name in messages.
const NOT_MODELLED: [(&str, &str); 8] = [
    (" motor ", MUD_MOTOR),
    (" motors ", MUD_MOTOR),
    (" pdm ", MUD_MOTOR),
    (" turbine ", "a turbine"),
    (" turbodrill ", "a turbine"),
    (" agitator ", "an agitator"),
    (" rotary steerable ", "a rotary steerable tool"),
    (" rss ", "a rotary steerable tool"),
];

/// Behind these words a name is of something else: a jar below drillpipe, a sub for a motor.
const OF_OTHERS: [&str; 9] = [
    " below ",
    " above ",
    " under ",
    " over the ",
    " for ",
    " to ",
    " from ",
    " between ",
    " w o ",
];

const TOOLS: [&str; 31] = [
    " xo ",
    " xover ",
    " x over ",
    " crossover ",
    " cross over ",
    " sub ",
    " subs ",
    " jar ",
    " jars ",
    " saver ",
    " shock ",
    " reamer ",
    " underreamer ",
    " hole opener ",
    " stabilizer ",
    " stabiliser ",
    " stabilizers ",
    " stabilisers ",
    " stab ",
    " stb ",
    " mwd ",
    " lwd ",
    " float ",
    " bumper ",
    " hammer ",
    " accelerator ",
    " intensifier ",
    " circulating ",
    " valve ",
    " dart ",
    " wear band ",
];
const BITS: [&str; 3] = [" bit ", " pdc ", " tricone "];
const HEAVY_WEIGHT: [&str; 9] = [
    " hwdp ",
    " hw ",
    " hwt ",
    " heavy weight ",
    " heavyweight ",
    " heavy wt ",
    " hevi wate ",
    " heviwate ",
    " hwdps ",
];
const DRILLPIPE: [&str; 6] = [
    " drillpipe ",
    " drillpipes ",
    " drill pipe ",
    " drill pipes ",
    " dp ",
    " dps ",
];
const COLLARS: [&str; 7] = [
    " collar ",
    " collars ",
    " dc ",
    " dcs ",
    " nmdc ",
    " drillcollar ",
    " monel ",
];

impl ToolKind {
    /// Of what a sheet calls it; where that says nothing, of what else is said of it.
    pub fn of(element: &str, specification: &str) -> Self {
        match Self::of_name(element) {
            Self::Unknown => Self::of_name(specification),
            kind => kind,
        }
    }

    fn of_name(name: &str) -> Self {
        let words = words(name);
        let has = |names: &[&str]| names.iter().any(|name| words.contains(name));
        if has(&TOOLS) || not_modelled(name).is_some() {
            Self::Tool
        } else if has(&BITS) {
            Self::Bit
        } else if has(&HEAVY_WEIGHT) {
            Self::HeavyWeight
        } else if has(&DRILLPIPE) {
            Self::Drillpipe
        } else if has(&COLLARS) {
            Self::Collar
        } else {
            Self::Unknown
        }
    }

    /// Whether it has tool joints that its weight may tell.
    pub fn is_pipe(self) -> bool {
        matches!(self, Self::Drillpipe | Self::HeavyWeight)
    }

    /// How far up a string it is, among those of which that is known.
    fn height(self) -> Option<usize> {
        match self {
            Self::Bit => Some(0),
            Self::Collar => Some(1),
            Self::HeavyWeight => Some(2),
            Self::Drillpipe => Some(3),
            Self::Tool | Self::Unknown => None,
        }
    }
}

/// Whether rows are from the bit up, where their kinds say that or the opposite.
pub fn is_from_bit(kinds: &[ToolKind]) -> Option<bool> {
    let mut heights = kinds.iter().filter_map(|kind| kind.height());
    let first = heights.next()?;
    match heights.next_back() {
        Some(last) if last != first => Some(first < last),
        Some(_) => None,
        // One row that says where it is, at an end.
        None => {
            let is_low = first == 0;
            let is_first = kinds.first().is_some_and(|kind| kind.height().is_some());
            let is_last = kinds.last().is_some_and(|kind| kind.height().is_some());
            let says = first == 0 || first == 3;
            (says && is_first != is_last).then_some(is_low == is_first)
        }
    }
}

/// What a row is more than a tube, if it is.
pub fn not_modelled(name: &str) -> Option<&'static str> {
    let words = words(name);
    let found = NOT_MODELLED.iter().find(|(word, _)| words.contains(word));
    found.map(|(_, name)| *name)
}

/// Words in small letters with blanks around, up to those that are of something else.
fn words(name: &str) -> String {
    let letters = name.to_lowercase();
    let words = letters.split(|letter: char| !letter.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let text = format!(" {} ", words.join(" "));
    let end = OF_OTHERS.iter().filter_map(|word| text.find(word)).min();
    match end {
        Some(end) => format!("{} ", &text[..end]),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_what_people_call_them() {
        for (name, kind) in [
            ("DP", ToolKind::Drillpipe),
            ("DP 5\" 19.5# S-135 NC50", ToolKind::Drillpipe),
            ("drill-pipe", ToolKind::Drillpipe),
            ("5in Drill Pipe", ToolKind::Drillpipe),
            ("HW", ToolKind::HeavyWeight),
            ("Hevi-Wate", ToolKind::HeavyWeight),
            ("HWDP 5\" 49.3#", ToolKind::HeavyWeight),
            ("Heavy weight drill pipe", ToolKind::HeavyWeight),
            ("8\" DC", ToolKind::Collar),
            ("Drill collar 8 in", ToolKind::Collar),
            ("X-over DP to HWDP", ToolKind::Tool),
            ("Jar below drillpipe", ToolKind::Tool),
            ("Near bit stabilizer", ToolKind::Tool),
            ("Bit sub", ToolKind::Tool),
            ("MWD collar", ToolKind::Tool),
            ("12 1/4 in PDC bit", ToolKind::Bit),
            ("Mud motor", ToolKind::Tool),
            ("Adapter", ToolKind::Unknown),
        ] {
            assert_eq!(ToolKind::of(name, ""), kind, "{name}");
        }
        assert_eq!(ToolKind::of("Adapter", "for 5 in DP"), ToolKind::Unknown);
        assert_eq!(ToolKind::of("Item 1", "DP 5 in"), ToolKind::Drillpipe);
    }

    #[test]
    fn tools_that_are_more_than_tubes_are_known_and_their_neighbours_not() {
        for (name, expected) in [
            ("Mud Motor 6 3/4", Some("a mud motor")),
            (
                "Stabilizer: Rotary steerable with 12 1/8 in stabilizers",
                Some("a rotary steerable tool"),
            ),
            ("X-over below motor", None),
            ("Sub for RSS", None),
            ("Drill collar", None),
        ] {
            assert_eq!(not_modelled(name), expected, "{name}");
        }
    }

    #[test]
    fn rows_say_which_end_is_the_bits() {
        use ToolKind::{Bit, Collar, Drillpipe, HeavyWeight, Tool, Unknown};
        for (kinds, is_from_bit) in [
            (&[Bit, Tool, Collar, Drillpipe][..], Some(true)),
            (&[Drillpipe, HeavyWeight, Collar, Tool, Bit], Some(false)),
            (&[Drillpipe, Collar], Some(false)),
            (&[Collar, HeavyWeight], Some(true)),
            (&[Unknown, Unknown, Bit], Some(false)),
            (&[Bit, Unknown], Some(true)),
            (&[Drillpipe, Unknown], Some(false)),
            (&[Unknown, Drillpipe], Some(true)),
            (&[Unknown, Unknown], None),
            (&[Collar, Unknown], None),
            (&[Drillpipe, Tool, Drillpipe], None),
            (&[Unknown, Bit, Unknown], None),
            (&[Bit], None),
        ] {
            assert_eq!(super::is_from_bit(kinds), is_from_bit, "{kinds:?}");
        }
    }
}
