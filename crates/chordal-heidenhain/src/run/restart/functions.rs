//! M functions and other functions of blocks before a line: those that a head says again, and those that it does not.

use std::collections::BTreeMap;

use chordal_kernel::UnrepeatedCode;

use crate::syntax::{KlartextStatement, MachineFunction};

/// M functions that stay in force until another one ends them: what begins, what ends it.
const LASTING: [(u32, u32); 6] =
    [(101, 102), (107, 108), (109, 111), (110, 111), (116, 117), (126, 127)];

/// M functions that act in their block, or whose effect is in the state.
const OF_STATE: [u32; 27] = [
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 13, 14, 19, 30, 89, 91, 92, 97, 98, 99, 128, 129, 136, 137, 140,
    115, 145,
];

/// Functions with an effect outside of the run: FN 17 SYSWRITE, 19 PLC, 20 WAIT FOR, 25 PRESET, 26 to 29 tables and PLC, 37 EXPORT.
const OUTSIDE: [u32; 8] = [17, 19, 20, 25, 26, 27, 29, 37];

/// What the functions before a line leave.
#[derive(Clone, Default, Debug)]
pub(super) struct LeftFunctions {
    /// The lasting functions in force, by their number, with their words.
    pub lasting: BTreeMap<u32, String>,
    /// The functions that a head does not say again.
    pub unrepeated: Vec<UnrepeatedCode>,
}

impl LeftFunctions {
    /// Takes the functions of a block.
    pub fn follow(&mut self, text: &[u8], statement: &KlartextStatement, line: u32) {
        for function in functions_of(statement) {
            let words = String::from_utf8_lossy(function.range.slice(text)).into_owned();
            self.follow_function(function.number, words, line);
        }
        if let KlartextStatement::OtherFunction { number, .. } = statement
            && OUTSIDE.contains(number)
        {
            self.leave_out(format!("FN {number}"), line);
        }
    }

    fn follow_function(&mut self, number: u32, words: String, line: u32) {
        if let Some((_, end)) = LASTING.iter().find(|(begin, _)| *begin == number) {
            let is_other =
                |begin: &u32| !LASTING.iter().any(|(own, ends)| own == begin && ends == end);
            self.lasting.retain(|begin, _| is_other(begin));
            self.lasting.insert(number, words);
        } else if LASTING.iter().any(|(_, end)| *end == number) {
            self.lasting.retain(|begin, _| !LASTING.contains(&(*begin, number)));
        } else if !OF_STATE.contains(&number) {
            self.leave_out(words, line);
        }
    }

    /// The last of the same words counts.
    fn leave_out(&mut self, words: String, line: u32) {
        self.unrepeated.retain(|other| other.words != words);
        self.unrepeated.push(UnrepeatedCode { words, line });
    }
}

/// The M functions of a block.
pub(super) fn functions_of(statement: &KlartextStatement) -> &[MachineFunction] {
    match statement {
        KlartextStatement::Path(_, words)
        | KlartextStatement::FreePole(words)
        | KlartextStatement::Center(words)
        | KlartextStatement::Approach(_, words)
        | KlartextStatement::Departure(_, words)
        | KlartextStatement::Functions(words)
        | KlartextStatement::Stop(words)
        | KlartextStatement::CycleCall(_, words) => &words.functions,
        KlartextStatement::FreeElement(words) => &words.words.functions,
        KlartextStatement::ToolCall(words) => &words.functions,
        _ => &[],
    }
}
