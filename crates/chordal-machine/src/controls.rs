//! The one list of controls.

/// Every control: its name in Rust, its folder and its name in machine files. A new one is its folder in
/// `chordal-dialect/src/controls`, named as in machine files (`_` for `-`), and its line here. The enum
/// [`ControlName`](crate::ControlName) and the list of tables are generated from this list.
#[macro_export]
macro_rules! controls {
    ($each:ident) => {
        $each! {
            Fadal fadal "fadal",
            Haas haas "haas",
            Fanuc fanuc "fanuc",
            Mitsubishi mitsubishi "mitsubishi",
            Linuxcnc linuxcnc "linuxcnc",
            FanucLathe fanuc_lathe "fanuc-lathe",
            LinuxcncLathe linuxcnc_lathe "linuxcnc-lathe",
            HaasLathe haas_lathe "haas-lathe",
            MitsubishiLathe mitsubishi_lathe "mitsubishi-lathe",
            Grbl grbl "grbl",
            Grblhal grblhal "grblhal",
            Fluidnc fluidnc "fluidnc",
            Mach3 mach3 "mach3",
            Marlin marlin "marlin",
            ;
            // Controls whose programs are not made of word-address blocks: name in Rust, name in machine files. Each
            // is a control of a language crate.
            Sinumerik "sinumerik",
            SinumerikLathe "sinumerik-lathe",
            Heidenhain "heidenhain",
        }
    };
}
