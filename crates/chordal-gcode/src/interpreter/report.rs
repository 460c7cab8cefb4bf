//! Diagnostics that need the state of the run.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic, Severity, Span, TextRange};
use chordal_dialect::{Action, MotionCode, OnceCode};
use chordal_dialect::{CodeRow, SettingField, ToolWord, code_name, code_number};
use chordal_syntax::{Block, BlockKind, Letters, Word};

use super::Interpreter;
use crate::macro_alone::MissingCall;

impl Interpreter<'_> {
    /// The span of the words with some letters, or of the whole block without any.
    pub(super) fn words_span(&self, block: &Block, letters: Letters) -> Span {
        self.at(block).span_of(letters)
    }

    pub(super) fn unknown_code(&mut self, word: &Word) {
        let letter = word.letter as char;
        let Some(number) = self.literal(word) else { return };
        let own = self.control.table;
        let title = own.title;
        let code = code_number(number);
        let others: Vec<&str> = chordal_dialect::CONTROLS
            .iter()
            .filter(|table| table.name != own.name)
            .filter(|table| {
                code.is_some_and(|code| match word.letter {
                    b'G' => table.g_code(code).is_some(),
                    _ => table.m_code(code).is_some(),
                })
            })
            .map(|table| table.title)
            .collect();
        let mut diagnostic = Diagnostic::new(
            Code::UnknownCode,
            self.span(word.range),
            format!("{title} has no {letter}{number}"),
        )
        .label("unknown code");
        diagnostic = diagnostic.help(match &others[..] {
            [] => "check the number".to_string(),
            [one] => format!("{letter}{number} exists on {one}: is the machine right?"),
            [most @ .., last] => {
                let most = most.join(", ");
                format!("{letter}{number} exists on {most} and {last}: is the machine right?")
            }
        });
        self.kernel.report(diagnostic);
    }

    /// Reports a code of another G code system (Fanuc lathes: A, B and C).
    #[cold]
    pub(super) fn report_other_system(&mut self, word: &Word, row: &CodeRow, system: &str) {
        if !self.reported.other_system.insert(row.code) {
            return;
        }
        let name = row.name(b'G');
        let setting =
            self.control.table.settings.iter().find(|row| row.field == SettingField::CODE_SYSTEM);
        let setting = setting.map_or("the system of G codes", |setting| setting.name);
        self.kernel.report(
            Diagnostic::new(
                Code::UnknownCode,
                self.span(word.range),
                format!(
                    "{name} ({}) is a code of system {system}, and this machine has another",
                    row.title
                ),
            )
            .severity(Severity::Warning)
            .label(format!("carried out as in system {system}"))
            .help(format!("set `{setting}` to \"{system}\" if the machine has that system")),
        );
    }

    pub(super) fn same_group(
        &mut self,
        block: &Block,
        (first, first_at): (&CodeRow, usize),
        (second, second_at): (&CodeRow, usize),
    ) {
        let (a, b) = (&block.words[first_at], &block.words[second_at]);
        let name =
            |word: &Word, row: &CodeRow| format!("{} ({})", row.name(word.letter), row.title);
        let (one, two) = (name(a, first), name(b, second));
        let title = self.control.table.title;
        let (message, severity) = match self.control.table.last_of_group_counts {
            true if first.code == second.code => (
                format!(
                    "{one} appears twice: {title} executes only the last one, with the words of both"
                ),
                Severity::Warning,
            ),
            true => (
                format!("{one} and {two} exclude each other; {title} uses the last one"),
                Severity::Warning,
            ),
            false => (format!("{one} and {two} exclude each other"), Severity::Error),
        };
        self.kernel.report(
            Diagnostic::new(Code::SameGroup, self.span(b.range), message)
                .severity(severity)
                .label("the second of its group")
                .also(self.span(a.range), "the first")
                .help("keep one of them, or write two blocks"),
        );
    }

    pub(super) fn unused_word(&mut self, word: &Word) {
        if self.control.parameters.strict_words {
            return self.refused_word(word);
        }
        let letter = word.letter as char;
        let help = self
            .spiral_word_help(word.letter)
            .or_else(|| self.repeat_word_help(word.letter))
            .unwrap_or_else(|| "remove it, or check for which code it was meant".to_string());
        self.kernel.report(
            Diagnostic::new(
                Code::UnusedWord,
                self.span(word.range),
                format!("`{letter}` has no effect in this block"),
            )
            .label("nothing in this block uses it")
            .help(help),
        );
    }

    /// The help for L on controls where cycles count with another letter; `None` otherwise.
    fn repeat_word_help(&self, letter: u8) -> Option<String> {
        let own = self.control.parameters.rules.cycles.repeat_letter;
        let field = SettingField::CYCLE_REPEAT_LETTER;
        let setting = self.control.table.settings.iter().find(|row| row.field == field)?;
        let (own, name) = (own as char, setting.name);
        (letter == b'L' && own != 'L').then(|| {
            format!(
                "a cycle counts its holes with {own}, or with L where the setting `{name}` says so"
            )
        })
    }

    #[cold]
    pub(super) fn report_long_line(&mut self, block: &Block, longest: u32) {
        let title = self.control.table.title;
        let length = block.range.len();
        let message = format!("this line has {length} characters, and the control reads {longest}");
        self.kernel.report(
            Diagnostic::new(Code::LineTooLong, self.span(block.range), message)
                .alarm(format!("{title}: Command too long"))
                .help("write it on several lines, or shorten its comment"),
        );
    }

    /// Reports a slash that the control does not read as block delete.
    pub(super) fn check_block_delete(&mut self, block: &Block) {
        let Some(delete) = block.delete.filter(|delete| delete.numbered || !delete.first) else {
            return;
        };
        let span = self.span(block.range);
        let (message, help, bad) = match delete.first {
            true => (
                format!("block delete has no number on this control: `/{}`", delete.switch),
                "write the slash alone",
                char::from(b'0' + delete.switch),
            ),
            false => (
                "a slash for block delete is not at the begin of its line".to_string(),
                "write the words after it on a line of their own, which begins with the slash",
                '/',
            ),
        };
        self.report_refused(
            Diagnostic::new(Code::BlockDeleteForm, span, message).help(help),
            &format!("Bad character '{bad}' used"),
        );
    }

    /// Reports the first deletable block that changes a mode or value of later blocks.
    #[cold]
    pub(super) fn note_deletable(&mut self, block: &Block) {
        if self.reported.deletable {
            return;
        }
        let Some(delete) = block.delete else { return };
        let mut words = block.words.iter().skip(delete.from_word);
        let is_statement = matches!(block.kind, BlockKind::Macro(_));
        if !is_statement && !words.any(|word| self.changes_modes(word)) {
            return;
        }
        self.reported.deletable = true;
        let message =
            "block delete decides about a mode or a value that the blocks after this one use";
        self.kernel.report(
            Diagnostic::new(Code::BlockDeleteDecides, self.span(block.range), message)
                .label("the first such block")
                .help("say both times what the blocks after it need, or leave out the `/`"),
        );
    }

    fn changes_modes(&self, word: &Word) -> bool {
        let code = word.number().and_then(code_number).filter(|_| word.letter == b'G');
        let row = code.and_then(|code| self.control.g_code(code));
        row.is_some_and(|row| {
            matches!(
                row.action,
                Action::Reading(_)
                    | Action::Mode(_)
                    | Action::Length(_)
                    | Action::NotFollowed
                    | Action::Once(
                        OnceCode::SetData
                            | OnceCode::LocalShift
                            | OnceCode::PresetPosition
                            | OnceCode::ClearPreset { .. }
                            | OnceCode::RestorePreset
                            | OnceCode::Rotation
                            | OnceCode::Scaling
                            | OnceCode::Mirror { .. }
                            | OnceCode::MirrorOff
                            | OnceCode::Surface(_)
                            | OnceCode::TiltedPlane(_)
                    )
            )
        })
    }

    /// Checks the words of codes by the rules of the control.
    #[inline]
    pub(super) fn check_word_rules(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        if !self.control.table.word_rules.is_empty() {
            self.check_words_of_codes(block, codes);
        }
    }

    fn check_words_of_codes(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        for (row, at) in codes {
            let code = (block.words[*at].letter, row.code);
            let rules = self.control.table.word_rules.iter().filter(|rule| rule.code == code);
            let value =
                |letter: u8| block.last(letter).and_then(|w| self.literal(w)).map(|n| n.to_f64());
            // The control stops at the first violated rule.
            let Some(broken) = rules.into_iter().find(|rule| !rule.test.holds(value)) else {
                continue;
            };
            let span = self.span(block.range);
            let message = format!("{} {}", row.name(code.0), broken.message);
            if broken.loses_path {
                self.lose_path(block.range, message);
                continue;
            }
            let diagnostic = Diagnostic::new(Code::BadWordValue, span, message).help(broken.help);
            match broken.alarm {
                Some(alarm) => self.report_refused(diagnostic, alarm),
                None => self.kernel.report(diagnostic.severity(Severity::Warning)),
            }
        }
    }

    /// Reports a word that no code uses, on controls where that stops the program.
    fn refused_word(&mut self, word: &Word) {
        let letter = word.letter as char;
        let title = self.control.table.title;
        let is_axis = matches!(letter, 'U' | 'V' | 'W');
        let alarm = match is_axis {
            true => format!("{title}: Bad character '{}' used", letter.to_ascii_lowercase()),
            false => format!("{title}: {letter} word with no g code that uses it"),
        };
        let message = format!("`{letter}` without a code that uses it stops the program");
        self.kernel.report(
            Diagnostic::new(Code::UnusedWord, self.span(word.range), message)
                .severity(Severity::Error)
                .label("nothing in this block uses it")
                .alarm(alarm)
                .help(match is_axis {
                    true => "this machine has no such axis: remove the word",
                    false => "remove it, or check for which code it was meant",
                }),
        );
    }

    /// The help for a word that would make a spiral with another setting; `None` for other words.
    fn spiral_word_help(&self, letter: u8) -> Option<String> {
        let table = self.control.table;
        let arc = table.g_code(20).filter(|row| row.words.has(letter))?;
        if self.words_of(arc).has(letter) {
            return None;
        }
        let setting =
            table.settings.iter().find(|setting| setting.field == SettingField::SPIRAL)?;
        let here = match table.g_code(21).map(|row| row.action) {
            Some(Action::Motion(MotionCode::SpiralCw)) => "a spiral is G2.1 or G3.1 with P here; ",
            _ => "",
        };
        let (letter, name) = (letter as char, setting.name);
        Some(format!("{here}`{letter}` makes a spiral of G2 and G3 where `{name}` chooses type 2"))
    }

    /// Reports `G2.0` on controls whose spirals have a code with a decimal: it is an arc, but probably meant as a spiral.
    #[cold]
    pub(super) fn check_written_with_zero(&mut self, word: &Word, row: &CodeRow) {
        let spiral = self.control.table.g_code(row.code + 1);
        let spiral = spiral
            .filter(|row| {
                matches!(
                    row.action,
                    Action::Motion(MotionCode::SpiralCw) | Action::Motion(MotionCode::SpiralCcw)
                )
            })
            .filter(|_| {
                matches!(
                    row.action,
                    Action::Motion(MotionCode::ArcCw) | Action::Motion(MotionCode::ArcCcw)
                )
            });
        let (Some(spiral), Some(number)) = (spiral, self.literal(word)) else { return };
        let (arc, spiral) = (row.name(b'G'), spiral.name(b'G'));
        self.kernel.report(
            Diagnostic::new(
                Code::NoSpirals,
                self.span(word.range),
                format!("`G{number}` is {arc}, an arc; a spiral is {spiral}"),
            )
            .severity(Severity::Warning)
            .label("read as an arc")
            .help(format!("write {spiral} for a spiral, {arc} for an arc")),
        );
    }

    pub(super) fn not_simulated(&mut self, word: &Word, row: &CodeRow) {
        let name = row.name(word.letter);
        self.kernel.report(Diagnostic::new(
            Code::NotSimulated,
            self.span(word.range),
            format!("{name} ({}) is not simulated", row.title),
        ));
    }

    /// Reports a code or a word that changes the path and is not carried out.
    pub(super) fn not_followed(&mut self, word: &Word, what: &str) {
        if self.is_of_second_spindle(word) {
            return;
        }
        let name = self.word_name(word);
        self.lose_path(word.range, format!("{name} ({what}) is not followed"));
    }

    /// Reports that the path is not known from here on.
    pub(super) fn lose_path(&mut self, range: TextRange, message: String) {
        self.kernel.report(
            Diagnostic::new(Code::NotFollowed, self.span(range), message)
                .label("from here on the path is not known")
                .help(
                    "check this program from here on by other means; see `chordal explain CH312`",
                ),
        );
    }

    fn word_name(&self, word: &Word) -> String {
        let code = self.literal(word).and_then(code_number);
        code.map_or_else(
            || char::from(word.letter).to_string(),
            |code| code_name(word.letter, code),
        )
    }

    /// A code as usually written.
    pub(super) fn word_text(&self, word: &Word) -> String {
        self.word_name(word)
    }

    /// The code of a word of the block as usually written.
    pub(super) fn code_text(&self, block: &Block, at: usize) -> String {
        self.word_name(&block.words[at])
    }

    /// Reports a macro that is run without its caller.
    pub(super) fn report_macro_alone(&mut self, missing: &MissingCall) {
        let MissingCall { head, arguments } = missing;
        let with = match arguments.as_str() {
            "" => String::new(),
            some => format!(" with {some}"),
        };
        self.kernel.report(
            Diagnostic::new(
                Code::MacroAlone,
                self.span(*head),
                format!("this is a macro: it is called{with}; run alone it does nothing"),
            )
            .label("not run, and nothing of it is verified")
            .help("check a program that calls it: it runs the macro with its arguments"),
        );
    }

    pub(super) fn report_macro(&mut self, range: TextRange) {
        self.lose_path(
            range,
            "this control has no macro statements: this one is not followed".into(),
        );
    }

    /// Reports `%` in a text that does not begin with it.
    #[cold]
    pub(super) fn report_lone_percent(&mut self, block: &Block) {
        let span = self.span(block.range);
        self.report_refused(
            Diagnostic::new(
                Code::UnexpectedCharacter,
                span,
                "`%` in a text that does not begin with it",
            )
            .help("remove it, or write another one on the first line"),
            "Bad character '%' used",
        );
    }

    pub(super) fn report_missing_end(&mut self) {
        let refused = self.control.parameters.end_required;
        let optional = self.control.parameters.end_optional;
        if !self.carried_out || optional || refused && self.ended_by_percent {
            return;
        }
        // If the last block is in a called program, the call is reported.
        let last = self.kernel.origin;
        let end = self.kernel.calls.resolve(last.call).last().copied().unwrap_or(last.span);
        let title = self.control.table.title;
        self.kernel.report(
            Diagnostic::new(Code::ProgramWithoutEnd, end, "the program ends without M30 or M2")
                .label("the last block")
                .help("put `M30` at the end")
                .severity(if refused { Severity::Error } else { Severity::Warning })
                .note(format!("{title} needs an end code to stop spindle and coolant")),
        );
    }

    /// Reports G41 or G42 without an offset number.
    pub(super) fn report_no_offset_number(&mut self, span: Span, refused: bool) {
        let code = Code::CompensationWithoutOffset;
        let by_tool =
            matches!(self.control.parameters.tool_word, ToolWord::StationAndOffset { .. });
        let (severity, message) = match (refused, by_tool) {
            (true, _) => (Severity::Error, "compensation is turned on without an offset number"),
            (false, false) => (
                code.info().severity,
                "no D before this: the offset is 0, and compensation has no effect",
            ),
            (false, true) => (
                code.info().severity,
                "no tool offset is active: the nose radius is 0, and compensation has no effect",
            ),
        };
        self.kernel.report(
            Diagnostic::new(code, span, message)
                .severity(severity)
                .label("no offset number for this")
                .help(match by_tool {
                    true => "write T with the number of the offset before it",
                    false => "put the D word into this block or before it",
                }),
        );
    }

    pub(super) fn report_compensation_at_end(&mut self) {
        if self.kernel.state.side == CompensationSide::Off {
            return;
        }
        self.kernel.report(
            Diagnostic::new(
                Code::CompensationAtEnd,
                self.kernel.origin.span,
                "cutter compensation is still on at the end of the program",
            )
            .help("put G40 on the move away from the contour"),
        );
    }
}
