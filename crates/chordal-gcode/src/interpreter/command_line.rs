//! Lines that a firmware reads as one command with its words (Marlin).
//!
//! The line is read again as the firmware reads it, and the block gets the words of its command. The rest of the line has
//! no effect, which is reported.

use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_dialect::firmware::BuildOption;
use chordal_dialect::{Action, BeforeCode, CallCode, CodeRow, CommandLine};
use chordal_dialect::{ModeCode, OnceCode, code_number};
use chordal_geometry::Plane;
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, BlockKind, Decimal, Letters, Word, WordValue};

use super::{BlockFlow, Interpreter};

/// The characters of a line outside comments, each with its offset in the text.
struct CommandLineText {
    characters: Vec<(u8, u32)>,
    at: usize,
    lower_case: bool,
}

/// The words of a line by their effect.
#[derive(Default)]
struct CommandLineWords {
    /// The words of its command.
    words: Vec<Word>,
    /// Further commands, which have no effect.
    dropped: Vec<Word>,
    /// Words that the command does not use.
    unused: Vec<Word>,
    /// The command needs a number after every letter.
    are_numbers: bool,
    /// Letters without a number.
    bare: Vec<TextRange>,
    /// The first lower-case letter, which this build does not read.
    small: Option<TextRange>,
    /// The letter and number of a command that the firmware does not have.
    unknown: Option<(u8, Option<Decimal>)>,
}

impl CommandLineText {
    fn of(text: &[u8], from: u32, parentheses: bool, lower_case: bool) -> CommandLineText {
        let mut characters = Vec::with_capacity(text.len());
        let mut in_comment = false;
        for (byte, offset) in text.iter().zip(from..) {
            match byte {
                b')' if in_comment => in_comment = false,
                _ if in_comment => {}
                b'(' if parentheses => in_comment = true,
                b';' => break,
                _ => characters.push((*byte, offset)),
            }
        }
        CommandLineText { characters, at: 0, lower_case }
    }

    fn peek(&self) -> Option<u8> {
        self.characters.get(self.at).map(|(byte, _)| *byte)
    }

    /// The letter here, in upper case if the firmware reads lower-case letters.
    fn letter(&self) -> Option<u8> {
        let byte = self.peek()?;
        Some(if self.lower_case { byte.to_ascii_uppercase() } else { byte })
    }

    fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t')) {
            self.at += 1;
        }
    }

    fn offset(&self, at: usize) -> u32 {
        match self.characters.get(at) {
            Some((_, offset)) => *offset,
            None => self.characters.last().map_or(0, |(_, offset)| offset + 1),
        }
    }

    /// The range from a character to the one before the current one.
    fn range(&self, from: usize) -> TextRange {
        let end = self.at.max(from + 1);
        TextRange::new(self.offset(from), self.offset(end - 1) + 1)
    }

    /// Reads a sign, digits and a point; `None`, without advancing, when there is no digit.
    fn number(&mut self) -> Option<Decimal> {
        let is_of_number =
            |(byte, _): &&(u8, u32)| byte.is_ascii_digit() || matches!(byte, b'.' | b'+' | b'-');
        let rest = &self.characters[self.at..];
        let mut text: Vec<u8> = Vec::new();
        for (byte, _) in rest.iter().take_while(is_of_number) {
            let ends = match byte {
                b'+' | b'-' => !text.is_empty(),
                b'.' => text.contains(&b'.'),
                _ => false,
            };
            if ends {
                break;
            }
            text.push(*byte);
        }
        let number = Decimal::parse(&text)?;
        self.at += text.len();
        Some(number)
    }

    /// Reads the line number in front (N).
    fn line_number(&mut self) -> Option<Word> {
        let (from, next) = (self.at, self.characters.get(self.at + 1)?.0);
        if self.letter() != Some(b'N') || !(next.is_ascii_digit() || next == b'-') {
            return None;
        }
        self.at += 1;
        let number = self.number()?;
        let word = word(b'N', number, self.range(from));
        self.skip_blanks();
        Some(word)
    }

    fn ends(&self) -> bool {
        self.at >= self.characters.len()
    }
}

fn word(letter: u8, number: Decimal, range: TextRange) -> Word {
    Word { letter, register: None, comma: false, value: WordValue::Number(number), range }
}

impl Interpreter<'_> {
    /// Gives the block the words of the command of its line. Returns how to continue when there is nothing to carry out;
    /// `None` to carry out the block.
    pub(super) fn take_command_line(&mut self, block: &mut Block) -> Option<BlockFlow> {
        let rules = self.control.table.command_line?;
        let build = self.control.parameters.build;
        let text = self.reader.text();
        // The reader may divide the line into several blocks; only the first one counts here.
        let start = block.range.start as usize;
        let goes_on = start > 0 && !matches!(text[start - 1], b'\n' | b'\r');
        let rest = &text[start..];
        let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        let whole = TextRange::new(block.range.start, (start + length) as u32);
        let (parentheses, lower_case) = (build.parentheses, build.lower_case);
        let mut line = CommandLineText::of(whole.slice(text), whole.start, parentheses, lower_case);
        // Typing mistakes that the reader found are reported even if the firmware accepts them.
        let slips = std::mem::take(&mut block.problems);
        block.delete = None;
        block.expressions = false;
        block.kind = BlockKind::Words;
        block.truncate(0);
        if goes_on {
            return Some(BlockFlow::Next);
        }
        line.skip_blanks();
        let number = line.line_number();
        // After an asterisk comes the checksum.
        if let Some(end) = line.characters.iter().position(|(byte, _)| *byte == b'*') {
            line.characters.truncate(end);
        }
        while matches!(line.characters.last(), Some((b' ' | b'\t', _))) {
            line.characters.pop();
        }
        if line.ends() {
            return Some(BlockFlow::Next);
        }
        let from = line.at;
        let mut read = CommandLineWords::default();
        self.read_command(&mut line, rules, &mut read);
        if let Some((letter, number)) = read.unknown {
            line.at = line.characters.len();
            let range = line.range(from);
            self.report_unknown_command(rules, range, letter, number);
            return Some(BlockFlow::Next);
        }
        if read.are_numbers {
            // Not in a comment or checksum, where no numbers are required.
            let end = line.offset(line.characters.len());
            let is_slip = |problem: &Diagnostic| {
                let in_words = problem.primary.span.range.start < end;
                let of_remark = matches!(
                    problem.code,
                    Code::UnclosedComment | Code::NestedComment | Code::LooksLikeRemark
                );
                in_words && !of_remark
            };
            block.problems = slips.into_iter().filter(is_slip).collect();
        }
        if !block.problems.is_empty() {
            read.bare.clear();
        }
        number.into_iter().chain(read.words).for_each(|word| block.push(word));
        self.report_what_does_nothing(rules, block, &read.dropped, &read.bare, read.small);
        // If there is a second command, its words are reported with it.
        if read.dropped.is_empty() {
            read.unused.iter().for_each(|word| self.unused_word(word));
        }
        None
    }

    /// Reads one command with its words.
    fn read_command(
        &self,
        line: &mut CommandLineText,
        rules: &CommandLine,
        read: &mut CommandLineWords,
    ) {
        let from = line.at;
        let letter = line.letter().unwrap_or(0);
        let goes_on = self.control.parameters.build.has(BuildOption::MotionModes)
            && letter.is_ascii_uppercase()
            && rules.motion_words.has(letter);
        if goes_on {
            return self.read_words(line, rules, None, read);
        }
        if !letter.is_ascii_uppercase() || !rules.commands.has(letter) {
            line.at += 1;
            line.skip_blanks();
            read.unknown = Some((letter, line.number()));
            return;
        }
        line.at += 1;
        line.skip_blanks();
        let is_number = line.peek().is_some_and(|byte| byte.is_ascii_digit());
        let Some(number) = line.number().filter(|_| is_number) else {
            read.unknown = Some((letter, None));
            return;
        };
        let code = word(letter, number, line.range(from));
        let tenths = code_number(number);
        let own = number.to_integer().and_then(|code| u16::try_from(code).ok());
        let of_shop =
            letter == b'M' && own.is_some_and(|own| self.machine.shop_codes.contains_key(&own));
        let is_known = match letter {
            b'G' => tenths.is_some_and(|code| self.control.g_code(code).is_some()),
            b'M' => tenths.is_some_and(|code| self.control.m_code(code).is_some()),
            _ => true,
        };
        if !is_known && !of_shop && !self.asks_the_shop() {
            read.unknown = Some((letter, Some(number)));
            return;
        }
        read.words.push(code);
        line.skip_blanks();
        let is_text = letter == b'M' && own.is_some_and(|own| rules.texts.contains(&own));
        if is_text || letter == b'T' {
            return;
        }
        let is_prefix = letter == b'G' && tenths.is_some_and(|code| rules.prefixes.contains(&code));
        if is_prefix {
            if !line.ends() {
                self.read_command(line, rules, read);
            }
            return;
        }
        self.read_words(line, rules, Some((letter, tenths.unwrap_or(0))), read);
    }

    /// True when the caller may answer M codes that no table contains.
    fn asks_the_shop(&self) -> bool {
        self.options.shop_codes.is_some()
    }

    fn read_words(
        &self,
        line: &mut CommandLineText,
        rules: &CommandLine,
        code: Option<(u8, u16)>,
        read: &mut CommandLineWords,
    ) {
        let takes = self.letters_of_command(rules, code);
        // The words of a code that is not carried out have no effect and need no report.
        let row = code.and_then(|(letter, code)| match letter {
            b'G' => self.control.g_code(code),
            _ => self.control.m_code(code),
        });
        let is_ignored =
            row.is_some_and(|row| matches!(row.action, Action::NoEffect | Action::NotSimulated));
        let has_remark = code
            .is_some_and(|(letter, code)| letter == b'M' && rules.remarks.contains(&(code / 10)));
        let bare_axes =
            code.is_some_and(|(letter, code)| letter == b'G' && rules.bare_axes.contains(&code));
        read.are_numbers = !(is_ignored || bare_axes || has_remark);
        while let Some(letter) = line.letter() {
            let from = line.at;
            line.at += 1;
            if !letter.is_ascii_uppercase() {
                if letter.is_ascii_lowercase() && !has_remark {
                    read.small.get_or_insert(line.range(from));
                }
                continue;
            }
            line.skip_blanks();
            let number = line.number();
            let is_axis = AXIS_LETTERS.as_bytes()[..3].contains(&letter);
            match number {
                Some(number) if rules.commands.has(letter) && letter != b'T' => {
                    read.dropped.push(word(letter, number, line.range(from)));
                }
                Some(_) if takes.has(letter) && is_ignored => {}
                Some(number) if takes.has(letter) => {
                    read.words.push(word(letter, number, line.range(from)));
                }
                Some(number) => read.unused.push(word(letter, number, line.range(from))),
                None if has_remark => return,
                None if bare_axes && is_axis => {
                    let range = TextRange::new(line.offset(from), line.offset(from) + 1);
                    read.words.push(word(letter, Decimal::integer(0), range));
                }
                None if !is_ignored => {
                    read.bare.push(TextRange::new(line.offset(from), line.offset(from) + 1));
                }
                None => {}
            }
        }
    }

    /// The letters that a command uses; without a code, those of the active motion.
    fn letters_of_command(&self, rules: &CommandLine, code: Option<(u8, u16)>) -> Letters {
        const AXES_AND_FEED: Letters = Letters::of("XYZF");
        let Some((letter, code)) = code else {
            return rules.motion_words.union(Letters::of("KS")).without(Letters::of("E"));
        };
        let row = match letter {
            b'G' => self.control.g_code(code),
            _ => self.control.m_code(code),
        };
        // The words of a custom code are not known.
        let Some(row) = row else { return Letters(u32::MAX) };
        let axes = match row.action.once() {
            None if row.action.motion().is_some() => AXES_AND_FEED,
            Some(OnceCode::Probe { .. }) => AXES_AND_FEED,
            Some(OnceCode::Dwell | OnceCode::ClearPreset { .. }) | None => Letters::NONE,
            Some(_) => Letters::of("XYZ"),
        };
        row.words.union(axes)
    }

    fn report_what_does_nothing(
        &mut self,
        rules: &CommandLine,
        block: &Block,
        dropped: &[Word],
        bare: &[TextRange],
        small: Option<TextRange>,
    ) {
        let title = self.control.table.title;
        if let Some(first) = dropped.first() {
            let names: Vec<String> = dropped
                .iter()
                .filter_map(|word| Some(format!("{}{}", char::from(word.letter), word.number()?)))
                .collect();
            let is_missed = dropped.iter().any(|word| !self.is_already_active(rules, block, word));
            let severity = if is_missed { Severity::Error } else { Severity::Note };
            let verb = if names.len() == 1 { "does" } else { "do" };
            self.kernel.report(
                Diagnostic::new(
                    Code::NotAlone,
                    self.span(first.range),
                    format!(
                        "{title} carries out one command a line, the first: {} {verb} nothing here",
                        names.join(" and ")
                    ),
                )
                .severity(severity)
                .label("not carried out; its words belong to the first command")
                .help("write each command on a line of its own"),
            );
        }
        for range in bare {
            self.kernel.report(
                Diagnostic::new(
                    Code::UnusedWord,
                    self.span(*range),
                    "a letter without a number does nothing here",
                )
                .help("write the number after it"),
            );
        }
        if let Some(range) = small {
            self.kernel.report(
                Diagnostic::new(
                    Code::UnusedWord,
                    self.span(range),
                    "this build does not read lower-case letters: the word does nothing",
                )
                .severity(Severity::Error)
                .help("write capital letters, or set GCODE_CASE_INSENSITIVE to `on` in the machine file if the build has it"),
            );
        }
    }

    /// True for a dropped code that would have changed nothing.
    fn is_already_active(&self, rules: &CommandLine, block: &Block, word: &Word) -> bool {
        let Some(code) = word.number().and_then(code_number) else { return false };
        let row = self.control.row_of(word);
        let Some(row) = row else { return rules.ignored_codes.contains(&(word.letter, code)) };
        // The command of the line may change the same mode.
        let also = block.words.iter().filter_map(|word| self.control.row_of(word));
        if also.clone().any(|own| own.group == row.group) {
            return false;
        }
        let state = &self.kernel.state;
        let action = row.action;
        action == Action::NoEffect
            || action.incremental() == Some(state.incremental)
            || action.units() == Some(state.units)
            || action == Action::Mode(ModeCode::PlaneXy) && state.plane == Plane::Xy
    }

    /// Reports a line whose command the firmware does not have: it replies with an error and continues.
    #[cold]
    fn report_unknown_command(
        &mut self,
        rules: &CommandLine,
        range: TextRange,
        letter: u8,
        number: Option<Decimal>,
    ) {
        let title = self.control.table.title;
        let shown = String::from_utf8_lossy(range.slice(self.reader.text())).into_owned();
        let [before, after] = rules.unknown;
        let severity = self.severity_of_unknown(rules, letter, number);
        let message = match number {
            Some(number) if matches!(letter, b'G' | b'M') => {
                format!("{title} has no {}{number}: it passes over this line", char::from(letter))
            }
            _ => format!("this line begins with no command: {title} passes over it"),
        };
        let help = match severity {
            Severity::Error => {
                "write it with the commands of this control; an option of the build may bring it: see the reference page"
            }
            Severity::Warning | Severity::Note => "remove it, or leave it: nothing depends on it",
        };
        self.kernel.report(
            Diagnostic::new(Code::UnknownCode, self.span(range), message)
                .severity(severity)
                .label("nothing of it is carried out")
                .alarm(format!("{title}: {before}{shown}{after}"))
                .help(help),
        );
    }

    /// The severity of an unknown command, by what it does on other controls.
    fn severity_of_unknown(
        &self,
        rules: &CommandLine,
        letter: u8,
        number: Option<Decimal>,
    ) -> Severity {
        let motion = letter.is_ascii_uppercase() && rules.motion_words.has(letter);
        let Some(code) = number.and_then(code_number) else {
            return if motion || matches!(letter, b'g' | b'm') {
                Severity::Error
            } else {
                Severity::Warning
            };
        };
        if rules.ignored_codes.contains(&(letter, code)) {
            return Severity::Note;
        }
        let matters = |row: &CodeRow| {
            row.action == Action::Before(BeforeCode::ToolChange)
                || matches!(row.action, Action::Call(code) if code != CallCode::SubroutineEnd)
        };
        match letter {
            b'M' => {
                let rows = chordal_dialect::CONTROLS.iter().filter_map(|table| table.m_code(code));
                if rows.into_iter().any(matters) { Severity::Error } else { Severity::Note }
            }
            b'G' | b'g' | b'm' => Severity::Error,
            _ if motion
                || Letters::of("XYZ").has(letter.to_ascii_uppercase().clamp(b'A', b'Z')) =>
            {
                Severity::Error
            }
            _ => Severity::Warning,
        }
    }
}
