//! Probing (L91) and engraving (L92) of Fadal: their words are checked, their motion is not shown.

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_syntax::{Block, Word};

use crate::interpreter::Interpreter;

/// Largest depth of engraving below R0 and largest height of letters (section 6): 2.5 in, mm.
const ENGRAVING_LIMIT_MM: f64 = 63.5;

impl Interpreter<'_> {
    /// L9101: R1 is the function, 1 to 10.
    pub(super) fn probe_routine(&mut self, block: &Block, word: &Word) {
        self.routine_allowed(word);
        let (target, named) = self.target(block);
        if named != AxisMask::NONE {
            self.kernel.straight(&self.at(block), target, named);
        }
        let what = match self.whole_register(block, 1) {
            None => {
                let help = "R1+1. to R1+10. chooses what is measured";
                self.improper(word, "probing without R1".into(), help);
                "the probe".to_string()
            }
            Some(function @ 1..=10) => format!("probe function {function}"),
            Some(other) => {
                self.bad_register(
                    block,
                    1,
                    format!("there is no probe function {other}"),
                    "1 to 10",
                );
                "the probe".to_string()
            }
        };
        self.motion_missing(word, &format!("{what} moves and measures"));
    }

    /// L9201: Z is the depth, R0 the clearance plane, R1 the kind of letters, R2 their height, R3 the angle, R4 the
    /// step of a serial number; the text follows a parenthesis.
    pub(super) fn engrave_routine(&mut self, block: &Block, word: &Word) {
        self.routine_allowed(word);
        if self.active_radius_offset().is_none_or(|number| number == 0) {
            let message = "engraving without an active tool offset".to_string();
            self.improper(word, message, "call the offset with H or D before it");
        }
        let mut missing: Vec<String> = (0..4)
            .filter(|register| self.register_word(block, *register).is_none())
            .map(|register| format!("R{register}"))
            .collect();
        if !block.letters().has(b'Z') {
            missing.insert(0, "Z".to_string());
        }
        if !missing.is_empty() {
            let message = format!("engraving without {}", missing.join(", "));
            self.improper(word, message, "it takes Z, R0, R1, R2, R3 and F");
        }
        let serial = match self.whole_register(block, 1) {
            Some(mode @ 0..=3) => mode >= 2,
            Some(other) => {
                self.bad_register(
                    block,
                    1,
                    format!("there is no kind of letters {other}"),
                    "0 to 3",
                );
                false
            }
            None => false,
        };
        if let Some(step) = self.whole_register(block, 4)
            && (!serial || !(1..=9).contains(&step))
        {
            let message = format!("a serial step of {step} with R1 of this block");
            self.bad_register(block, 4, message, "1 to 9, together with R1+2. or R1+3.");
        }
        self.check_engraving_sizes(block);
        let text = self.reader.text();
        let comment = block.comments.first().map(|comment| {
            let bytes = comment.slice(text);
            let shown = String::from_utf8_lossy(bytes);
            shown.trim().trim_matches(|c| c == '(' || c == ')').trim().to_string()
        });
        let what = match comment.filter(|text| !text.is_empty()) {
            Some(text) => format!("`{text}` is engraved"),
            None => {
                self.improper(
                    word,
                    "no text to engrave".into(),
                    "write it after `(` in this block",
                );
                "nothing is engraved".to_string()
            }
        };
        self.motion_missing(word, &what);
    }

    fn check_engraving_sizes(&mut self, block: &Block) {
        let limit = self.kernel.length_text(ENGRAVING_LIMIT_MM);
        let height = self.register_length(block, 2);
        if let Some(height) = height.filter(|height| *height > ENGRAVING_LIMIT_MM) {
            let message = format!("letters of {}", self.kernel.length_text(height));
            self.bad_register(block, 2, message, &format!("at most {limit}"));
        }
        let (plane, depth) = (self.register_length(block, 0), self.length_of(block, b'Z'));
        if let (Some(plane), Some(depth)) = (plane, depth)
            && plane - depth > ENGRAVING_LIMIT_MM
        {
            let message = format!("Z lies {} below R0", self.kernel.length_text(plane - depth));
            self.bad_register(block, 0, message, &format!("at most {limit}"));
        }
    }

    fn whole_register(&self, block: &Block, register: u8) -> Option<i64> {
        let word = self.register_word(block, register)?;
        let number = self.literal(&word)?;
        Some(number.to_integer().unwrap_or(-1))
    }

    fn bad_register(&mut self, block: &Block, register: u8, message: String, allowed: &str) {
        let span = self.register_span(block, register);
        self.kernel.report(
            Diagnostic::new(Code::BadWordValue, span, message)
                .label(format!("R{register} takes {allowed}"))
                .help(format!("write R{register} with {allowed}")),
        );
    }

    /// Warns that the motion is missing.
    fn motion_missing(&mut self, word: &Word, what: &str) {
        let value = self.literal(word).map_or(String::new(), |number| number.to_string());
        self.kernel.report(
            Diagnostic::new(
                Code::NotFollowed,
                self.span(word.range),
                format!("the motion of L{value} is not followed: {what} on the machine, not here"),
            )
            .label("its motion is missing from the path, the time and the checks")
            .help("keep the space around this position free, and check the graphics of the machine itself"),
        );
    }
}
