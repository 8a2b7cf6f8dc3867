//! The studies of the program itself, under `study` and by their names without it.

use super::{succeeds, text};
use crate::support::Workplace;

const STUDIES: [&str; 4] = ["tradeoff", "stability", "promises", "contacts"];

#[test]
fn every_study_is_in_the_help_of_its_group_alone() {
    let place = Workplace::new();
    let [all, studies] =
        [&["--help"][..], &["study", "--help"]].map(|it| succeeds(&place, it).output);
    for study in STUDIES {
        let line = format!("\n  {study} ");
        assert!(studies.contains(&line) && !all.contains(&line), "{study}");
        let help = succeeds(&place, &["study", study, "--help"]).output;
        assert!(help.contains(&format!("\n  sweep study {study}")), "{help}");
    }
}

/// Scripts that ask for them by the names that they had.
#[test]
fn a_study_answers_to_its_name_without_the_group() {
    let place = Workplace::new();
    for study in STUDIES {
        let asked = [[study, "--help"], ["help", study], ["man", study]];
        for arguments in asked {
            let old = place.sweep(&arguments);
            let group = usize::from(arguments[0] != study);
            let mut words = arguments.to_vec();
            words.insert(group, "study");
            let new = place.sweep(&words);
            assert_eq!((old.code, old.output), (0, new.output), "{arguments:?}");
        }
        let wrong = ["--jobs", "many"];
        let old = place.sweep(&[&[study][..], &wrong].concat());
        let new = place.sweep(&[&["study", study][..], &wrong].concat());
        assert_eq!((old.code, old.errors), (2, new.errors), "{study}");
    }
    let part = ["--quiet", "--family", "formulas", "--out"];
    succeeds(&place, &[&["stability"][..], &part, &["old"]].concat());
    succeeds(
        &place,
        &[&["study", "stability"][..], &part, &["new"]].concat(),
    );
    let [old, new] = ["old", "new"].map(|folder| text(&place, &format!("{folder}/stability.csv")));
    assert_eq!(old, new);
}
