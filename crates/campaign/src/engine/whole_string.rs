//! The whole string as it is reconstructed between its sites.

use linear::elements::reconstruction::WholeString;

use crate::plan::{Setting, Sweep};

/// The whole string of a setting that bends, as it is reconstructed.
pub fn whole_string<'a>(sweep: &Sweep, setting: &'a Setting) -> Option<WholeString<'a>> {
    let lateral = setting.lateral.as_ref()?;
    Some(WholeString {
        string: &setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &setting.sites,
        sampling_frequency: setting.sampling_frequency,
        parameters: sweep.content.method.finite_element,
    })
}
