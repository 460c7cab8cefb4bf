//! Effects of a block other than moves and modes.

/// Something without motion that a program does to its control or to the machine. It is no part of the path, but counts
/// when two programs are compared.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// A code that acts on something which is not simulated (a clamp, an output, a pallet, limits), with its words
    /// in a normalized form: `M62 P1`.
    Code(String),
    /// The program writes a variable of the control that is an output or a setting, or that keeps its value after the
    /// program.
    Variable {
        /// Its number.
        number: u32,
        /// Its value; `None` if it is empty or not known.
        value: Option<f64>,
    },
    /// The program writes values that the control stores: of a work offset, a tool, a reference point.
    Written {
        /// What is written: `work offset 2 Z`, `tool 3`.
        name: String,
        /// Its values, in mm or rad where they are lengths or angles; `None` where a value is not known.
        values: Vec<Option<f64>>,
    },
    /// The program stops itself with an alarm.
    Alarm {
        /// Its number as the program writes it.
        number: f64,
        /// What the control shows.
        text: String,
    },
    /// A switch of the panel may delete the block.
    Deletable {
        /// The number of the switch.
        switch: u8,
        /// Whether only the words after the slash are deleted.
        partly: bool,
    },
}
