//! What a block does beside moves and the modes that they are made in.

/// Something that a program does to its control or to the machine, and that moves nothing: who compares two programs
/// must see it, and a path does not show it.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// A code that acts on something which is not simulated (a clamp, an output, a pallet, limits), with its words
    /// in a form of their own: `M62 P1`.
    Code(String),
    /// A variable of the control is written that is an output, a setting, or outlives the program.
    Variable {
        /// Its number.
        number: u32,
        /// Its value; nothing where that is empty or not known.
        value: Option<f64>,
    },
    /// A value that the control keeps is written: of a work offset, a tool, a reference point.
    Written {
        /// What is written: `work offset 2 Z`, `tool 3`.
        name: String,
        /// What it holds now, mm, rad or the number itself; nothing where that is not known.
        values: Vec<Option<f64>>,
    },
    /// The program stops itself with an alarm.
    Alarm {
        /// Its number as the program writes it.
        number: f64,
        /// What the control shows.
        text: String,
    },
    /// The block may be left out by a switch of the panel.
    Deletable {
        /// The number of the switch.
        switch: u8,
        /// Only the words behind the mark are.
        partly: bool,
    },
}
