//! What a linker must be told so that Python's own symbols may be missing until it loads us.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
