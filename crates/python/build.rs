//! On macOS the linker has to accept what only Python has.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
