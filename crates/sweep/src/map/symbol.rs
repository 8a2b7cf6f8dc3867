//! The symbol of a case.

use sim::Motion;

use plot::Symbol;
use results::folder::CaseRows;

/// The symbol of what the methods find of a motion. None where a method has no answer, or one
/// that tells nothing.
pub fn symbol_of(case: &CaseRows, motion: Motion) -> Option<Symbol> {
    let found = case.found(motion)?;
    Some(Symbol::of_methods(
        [found.sustained, found.bistable, found.snaking],
        found.methods,
    ))
}

/// The same as a map has it: filled where the case is certain.
pub fn drawn_symbol_of(case: &CaseRows, motion: Motion) -> Option<Symbol> {
    let symbol = symbol_of(case, motion)?;
    let mut rows = case.rows.iter();
    let is_certain = rows.any(|row| row.certainty[motion] == Some(true));
    Some(if is_certain { symbol.filled() } else { symbol })
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::folder::read_cases;

    #[test]
    fn a_case_has_a_symbol_where_every_method_tells() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let table = "case,method,torsion,lateral\n\
                     3,a,stuck,backward_whirl\n3,b,stuck,no_contact\n\
                     4,a,,\n4,b,,no_contact\n5,a,smooth,\n5,b,smooth,\n";
        std::fs::write(file.path(), table).expect("written");
        let cases = read_cases(file.path(), &[]).expect("a table");
        let cases: Vec<CaseRows> = cases.map(|case| case.expect("read")).collect();
        let symbols =
            |motion| -> Vec<_> { cases.iter().map(|case| symbol_of(case, motion)).collect() };
        assert_eq!(
            symbols(Motion::Lateral),
            [Some(Symbol::Square), None, None],
            "no answer of one method, no lateral motion"
        );
        assert_eq!(symbols(Motion::Torsion), [None, None, Some(Symbol::Cross)]);
    }

    /// Snaking is less than whirl and more than nothing.
    #[test]
    fn snaking_has_a_symbol_where_all_methods_find_it() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let table = "case,method,torsion,lateral\n\
                     0,a,,snaking\n0,b,,snaking\n1,a,,snaking\n1,b,,low_side\n\
                     2,a,,backward_whirl\n2,b,,snaking\n3,a,,low_side\n3,b,,low_side\n";
        std::fs::write(file.path(), table).expect("written");
        let cases = read_cases(file.path(), &[]).expect("a table");
        let symbols: Vec<_> = cases
            .map(|case| symbol_of(&case.expect("read"), Motion::Lateral))
            .collect();
        let expected = [
            Symbol::Triangle,
            Symbol::Square,
            Symbol::Square,
            Symbol::Cross,
        ];
        assert_eq!(symbols, expected.map(Some));
    }

    /// A case is drawn as certain where a method that certifies it has its label; a square
    /// stays one.
    #[test]
    fn what_is_certain_is_drawn_filled() {
        let file = tempfile::NamedTempFile::new().expect("a file");
        let table = "case,method,torsion,torsion_certified,lateral_certified\n\
                     3,a,smooth,true,\n3,b,smooth,true,\n4,a,smooth,false,\n4,b,smooth,false,\n\
                     5,a,stick_slip,true,\n5,b,stick_slip,true,\n6,a,smooth,true,\n6,b,stick_slip,false,\n";
        std::fs::write(file.path(), table).expect("written");
        let cases = read_cases(file.path(), &[]).expect("a table");
        let symbols: Vec<_> = cases
            .map(|case| drawn_symbol_of(&case.expect("read"), Motion::Torsion))
            .collect();
        let expected = [
            Symbol::HeavyCross,
            Symbol::Cross,
            Symbol::Disc,
            Symbol::Square,
        ];
        assert_eq!(symbols, expected.map(Some));
    }
}
