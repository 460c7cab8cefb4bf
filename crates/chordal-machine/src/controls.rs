//! The one list of controls.

/// Every control: its name in Rust and in machine files. A new one is its folder in
/// `chordal-dialect/src/controls`, named as in machine files, and its line here; the enum
/// [`ControlName`](crate::ControlName) and the list of tables are made from it.
#[macro_export]
macro_rules! controls {
    ($each:ident) => {
        $each! {
            Fadal fadal,
            Haas haas,
            Fanuc fanuc,
            Mitsubishi mitsubishi,
            Linuxcnc linuxcnc,
        }
    };
}
