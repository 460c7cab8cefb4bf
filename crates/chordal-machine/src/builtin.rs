//! The machines that come with the program.

macro_rules! builtins {
    ($($name:literal),* $(,)?) => {
        const NAMES: &[&str] = &[$($name),*];
        const TEXTS: &[&str] = &[$(include_str!(concat!("../../../machines/", $name, ".toml"))),*];
    };
}

builtins![
    "fadal-4020",
    "fadal-400ipm",
    "haas-vf2",
    "fanuc-6m",
    "fanuc-30i",
    "mitsubishi-m700",
    "mitsubishi-m700-type2",
    "linuxcnc-mill",
    "textbook-absolute-center",
    "textbook-from-center",
];

/// The machine file of a built-in machine.
pub fn builtin(name: &str) -> Option<&'static str> {
    let at = NAMES.iter().position(|own| *own == name)?;
    Some(TEXTS[at])
}

/// The names of the built-in machines.
pub fn builtin_names() -> &'static [&'static str] {
    NAMES
}
