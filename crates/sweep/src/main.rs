//! The program. All of it is in the library of this name, which is compiled once for the program
//! and for the static one of `scripts/release.sh`.

use std::process::ExitCode;

fn main() -> ExitCode {
    sweep::main()
}
