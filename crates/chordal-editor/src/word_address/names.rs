//! Programs, labels and variables: where each is made and used, and other names for variables.

use chordal::control::{Action, CallCode, CallTarget, OnceCode};
use std::collections::HashMap;

use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, BlockKind, Word, WordValue, find_programs};

use super::WordAddressText;
use chordal::control::{StatementMark, marks};

/// A thing with a name.
#[derive(Clone, PartialEq, Eq, Debug, Hash)]
pub enum SymbolName {
    /// A program by its number.
    Program(u32),
    /// A subroutine or structure of O words, by its label in lower case.
    Subroutine(String),
    /// An N number within a program.
    Label {
        /// Index of the program in its text.
        program: usize,
        /// The number.
        number: i64,
    },
    /// A label of macro lines (`:LOOP`), by its text in upper case.
    LineLabel(String),
    /// A variable or a register.
    Variable {
        /// Index of the program whose own it is; `None` for one of all programs.
        program: Option<usize>,
        /// `#101`, `#<depth>`, `V12`, `R3`.
        name: String,
    },
}

/// What a place does with a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NameRole {
    /// Makes it, or gives it a value.
    Definition,
    /// Uses it.
    Use,
}

/// A place of a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NameOccurrence {
    /// The name.
    pub name: SymbolName,
    /// The word.
    pub range: TextRange,
    /// What the place does.
    pub role: NameRole,
}

/// Another name for a variable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RenamedVariable {
    /// The name in the control's form (`#110`, `#<depth>`).
    pub name: String,
    /// Where it goes.
    pub places: Vec<TextRange>,
}

/// Why a variable cannot have another name.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum RenameError {
    /// There is nothing to rename.
    #[error("there is no variable here; programs and N numbers keep their numbers")]
    NoVariable,
    /// The new name is none.
    #[error("`{new}` cannot be a name here: write it as `{example}`")]
    NotAName {
        /// What was asked for.
        new: String,
        /// How names of its kind look.
        example: String,
    },
    /// Somebody has it already.
    #[error("`{new}` is already used, on line {line}")]
    Taken {
        /// What was asked for.
        new: String,
        /// Where it is.
        line: u32,
    },
    /// A variable is chosen by a value.
    #[error("line {line} computes the number of a variable (`{text}`); it may be this one")]
    Computed {
        /// Where.
        line: u32,
        /// The text.
        text: String,
    },
}

impl WordAddressText<'_> {
    /// All places of all names, in the order of the text.
    pub(crate) fn occurrences(&self) -> Vec<NameOccurrence> {
        let mut finder = NameFinder::new(*self);
        self.blocks(1, u32::MAX, |block| finder.block(block));
        finder.found
    }

    /// The name at a byte of the text.
    pub(crate) fn name_at(&self, offset: u32) -> Option<NameOccurrence> {
        let at = |found: &NameOccurrence| found.range.start <= offset && offset <= found.range.end;
        // A word that ends here and one that begins here may touch: the one that begins counts.
        self.occurrences().into_iter().filter(at).max_by_key(|found| found.range.start)
    }

    /// Everywhere that a name stands.
    pub(crate) fn places_of(&self, name: &SymbolName) -> Vec<NameOccurrence> {
        let mut places = self.occurrences();
        places.retain(|found| found.name == *name);
        places
    }

    /// The places to change so that the variable at a byte of the text is called `new`.
    ///
    /// # Errors
    /// No variable there, no name, one that is used, or variables chosen by their value.
    pub(crate) fn rename(&self, offset: u32, new: &str) -> Result<RenamedVariable, RenameError> {
        let at = self.name_at(offset).map(|found| found.name);
        let Some(SymbolName::Variable { program, name: old }) = at else {
            return Err(RenameError::NoVariable);
        };
        let kind = VariableScope { local: program.is_some(), locals: self.control().macros.locals };
        let renamed = kind.name_like(&old, new).ok_or_else(|| RenameError::NotAName {
            new: new.into(),
            example: kind.example_of(&old),
        })?;
        if renamed != old
            && let Some(taken) = self.occurrences().iter().find(|found| {
                matches!(&found.name, SymbolName::Variable { name, program: other }
                    if *name == renamed && *other == program)
            })
        {
            let line = self.source().line_of(taken.range.start);
            return Err(RenameError::Taken { new: renamed, line });
        }
        self.computed_variable(&old)?;
        let name = SymbolName::Variable { program, name: old };
        let places = self.places_of(&name).into_iter().map(|place| place.range).collect();
        Ok(RenamedVariable { name: renamed, places })
    }

    /// A number chosen by a value (`#[#1+2]`, `##3`) may be any numbered variable.
    fn computed_variable(&self, old: &str) -> Result<(), RenameError> {
        if !matches!(old.as_bytes(), [b'#', b'0'..=b'9', ..]) {
            return Ok(());
        }
        let text = self.text();
        let is_computed = |at: &usize| matches!(&text[*at..], [b'#', b'[' | b'#', ..]);
        for at in (0..text.len()).filter(is_computed) {
            let line = self.source().line_of(at as u32);
            let mut commented = false;
            self.blocks(line, line + 1, |block| {
                let holds = |range: &TextRange| (range.start..range.end).contains(&(at as u32));
                commented |= block.comments.iter().any(holds);
            });
            if !commented {
                let text = String::from_utf8_lossy(self.source().line_text(line)).trim().into();
                return Err(RenameError::Computed { line, text });
            }
        }
        Ok(())
    }
}

/// Which variables a variable may be called like.
struct VariableScope {
    /// It belongs to one program.
    local: bool,
    /// Number of the last variable of a program's own.
    locals: u32,
}

impl VariableScope {
    /// The new name in the form that occurrences have, where it is one of the old one's kind.
    fn name_like(&self, old: &str, new: &str) -> Option<String> {
        let new = new.trim();
        if old.starts_with("#<") {
            let bare = new.strip_prefix("#<").and_then(|rest| rest.strip_suffix('>'));
            let bare = bare.unwrap_or(new);
            let plain = bare.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
            let fits = plain && !bare.is_empty() && bare.starts_with('_') != self.local;
            return fits.then(|| format!("#<{}>", bare.to_ascii_lowercase()));
        }
        let letter = old.chars().next()?;
        let digits = new.strip_prefix([letter, letter.to_ascii_lowercase()]).unwrap_or(new);
        let number: u32 = digits.parse().ok().filter(|_| digits.len() <= 5)?;
        let fits = match letter {
            '#' => (1..=self.locals).contains(&number) == self.local && number > 0,
            'V' => (1..=100).contains(&number),
            _ => number <= 9,
        };
        fits.then(|| format!("{letter}{number}"))
    }

    fn example_of(&self, old: &str) -> String {
        match (old.as_bytes(), self.local) {
            ([b'#', b'<', ..], true) => "#<name>".into(),
            ([b'#', b'<', ..], false) => "#<_name>".into(),
            ([b'#', ..], true) => format!("#1 to #{}, a program's own variables", self.locals),
            ([b'#', ..], false) => format!("a number above #{}", self.locals),
            ([b'V', ..], _) => "V1 to V100".into(),
            _ => "R0 to R9".into(),
        }
    }
}

/// Goes over the blocks and notes names.
struct NameFinder<'a> {
    program: WordAddressText<'a>,
    /// Index of the program of the text that the blocks belong to.
    index: usize,
    begun: bool,
    /// The blocks are data of the control, whose N is no block number.
    data: bool,
    found: Vec<NameOccurrence>,
    keys: HashMap<Vec<u8>, String>,
}

impl<'a> NameFinder<'a> {
    fn new(program: WordAddressText<'a>) -> NameFinder<'a> {
        NameFinder {
            program,
            index: 0,
            begun: false,
            data: false,
            found: Vec::new(),
            keys: HashMap::new(),
        }
    }

    fn block(&mut self, block: &Block) {
        match block.kind {
            BlockKind::Macro(range) => self.statement(range),
            BlockKind::Words => {}
            BlockKind::Percent | BlockKind::Folder => return,
        }
        if let Some(head) = block.word(b'O') {
            self.head(head);
        }
        self.begun |= !block.words.is_empty();
        self.words(block);
    }

    /// The number of a program; later blocks belong to it.
    fn head(&mut self, word: &Word) {
        if self.begun {
            self.index += 1;
        }
        if let Some(number) = whole(word).and_then(|number| u32::try_from(number).ok()) {
            self.note(SymbolName::Program(number), word.range, NameRole::Definition);
        }
    }

    fn words(&mut self, block: &Block) {
        let call = self.call_of(block);
        self.data &= block.word(b'G').is_none() && block.word(b'M').is_none();
        for word in &block.words {
            if let Some(register) = word.register {
                let name = SymbolName::Variable { program: None, name: format!("R{register}") };
                let range = TextRange::new(word.range.start, word.range.start + 2);
                self.note(name, range, NameRole::Definition);
            }
            match word.value {
                WordValue::Register { index, .. } => {
                    let name = SymbolName::Variable { program: None, name: format!("R{index}") };
                    let range = TextRange::new(word.range.end.saturating_sub(2), word.range.end);
                    self.note(name, range, NameRole::Use);
                }
                WordValue::Expression(range) => self.variables(range, false),
                _ => {}
            }
            match (word.letter, call, whole(word)) {
                (b'N', _, Some(number)) if !self.data => {
                    let name = SymbolName::Label { program: self.index, number };
                    self.note(name, word.range, NameRole::Definition);
                }
                (b'P', Some(CallName::Program), Some(number)) => {
                    if let Ok(number) = u32::try_from(number) {
                        self.note(SymbolName::Program(number), word.range, NameRole::Use);
                    }
                }
                (b'P', Some(CallName::Label), Some(number)) => {
                    let name = SymbolName::Label { program: self.index, number };
                    self.note(name, word.range, NameRole::Use);
                }
                (letter, Some(CallName::Program), Some(number)) => {
                    self.start_label(block, letter, number, word.range);
                }
                _ => {}
            }
        }
        self.data |= self.program.control().table.begins_data(block);
    }

    /// The block at which a call begins (Fanuc `M98 P1 Q100`, Mitsubishi H).
    fn start_label(&mut self, block: &Block, letter: u8, number: i64, range: TextRange) {
        let table = self.program.control().table;
        let calls = |word: &Word| {
            let row = self.program.control().row_of(word);
            row.is_some_and(|row| row.action == Action::Call(CallCode::CallProgram))
        };
        if table.call_start_label != Some(letter) || !block.words.iter().any(calls) {
            return;
        }
        let called = block.last(b'P').and_then(whole).and_then(|number| u32::try_from(number).ok());
        let heads = find_programs(self.program.text(), self.program.lexicon());
        let place = called.map(|called| heads.iter().position(|head| head.number == Some(called)));
        if let Some(program) = place.unwrap_or(Some(self.index)) {
            self.note(SymbolName::Label { program, number }, range, NameRole::Use);
        }
    }

    /// What P means in a block, where it names something.
    fn call_of(&self, block: &Block) -> Option<CallName> {
        let control = self.program.control();
        let rows = block.words.iter().filter_map(|word| control.row_of(word));
        rows.into_iter().find_map(|row| {
            if row.action == Action::Once(OnceCode::GeneralPocket) {
                return Some(CallName::Program);
            }
            let Action::Call(code) = row.action else { return None };
            Some(match code.called()? {
                CallTarget::Program => CallName::Program,
                CallTarget::Label => CallName::Label,
            })
        })
    }

    /// Variables, jumps and O words of a macro statement.
    fn statement(&mut self, range: TextRange) {
        let text = self.program.text();
        let lexicon = self.program.lexicon();
        let words: Vec<(StatementMark, TextRange)> = marks(text, range, lexicon).collect();
        if lexicon.o_words && range.slice(text).first().is_some_and(|b| matches!(b, b'o' | b'O')) {
            self.o_word(range, &words);
        }
        self.variables(range, true);
        for pair in words.windows(2) {
            let [(StatementMark::Word, jump), (mark, target)] = pair else { continue };
            let word = jump.slice(text).to_ascii_uppercase();
            let number =
                (*mark == StatementMark::Number).then(|| number_of(target.slice(text))).flatten();
            let jumps = matches!(word.as_slice(), b"GOTO" | b"GO" | b"N");
            if let Some(number) = number.filter(|_| jumps) {
                self.note(
                    SymbolName::Label { program: self.index, number },
                    *target,
                    NameRole::Use,
                );
            }
        }
        self.line_labels(range);
    }

    /// `o100 sub`, `o<part> call`: a subroutine is made by `sub`.
    fn o_word(&mut self, range: TextRange, words: &[(StatementMark, TextRange)]) {
        let text = range.slice(self.program.text());
        let rest = &text[1..];
        let blanks = rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
        let label = &rest[blanks..];
        let size = match label.first() {
            Some(b'<') => label.iter().position(|byte| *byte == b'>').map(|end| end + 1),
            Some(b'0'..=b'9') => Some(label.iter().take_while(|b| b.is_ascii_digit()).count()),
            _ => None,
        };
        let Some(size) = size else { return };
        let name = String::from_utf8_lossy(&label[..size]).to_ascii_lowercase();
        let end = range.start + (1 + blanks + size) as u32;
        let after =
            words.iter().find(|(mark, word)| *mark == StatementMark::Word && word.start >= end);
        let is = |flow: &[u8]| {
            after
                .is_some_and(|(_, word)| word.slice(self.program.text()).eq_ignore_ascii_case(flow))
        };
        let role = if is(b"CALL") || is(b"ENDSUB") || is(b"RETURN") {
            NameRole::Use
        } else {
            NameRole::Definition
        };
        let (begins, ends) = (is(b"SUB"), is(b"ENDSUB"));
        if begins {
            self.index += 1;
        }
        self.note(SymbolName::Subroutine(name), TextRange::new(range.start, end), role);
        if ends {
            self.index += 1;
        }
    }

    /// `:LOOP` makes a label of macro lines, `GOTO :LOOP` uses it.
    fn line_labels(&mut self, range: TextRange) {
        if !self.program.lexicon().macro_lines {
            return;
        }
        let text = range.slice(self.program.text());
        let Some(colon) = text.iter().position(|byte| *byte == b':') else { return };
        let size = text[colon + 1..].iter().take_while(|byte| byte.is_ascii_alphanumeric()).count();
        if size == 0 {
            return;
        }
        let name = String::from_utf8_lossy(&text[colon + 1..colon + 1 + size]).to_ascii_uppercase();
        let start = range.start + colon as u32;
        let alone = text[1..colon].iter().all(u8::is_ascii_whitespace);
        let role = if alone { NameRole::Definition } else { NameRole::Use };
        self.note(
            SymbolName::LineLabel(name),
            TextRange::new(start, start + 1 + size as u32),
            role,
        );
    }

    /// The variables of a range; one before `=` at the level of the statement gets a value.
    fn variables(&mut self, range: TextRange, assigns: bool) {
        let text = self.program.text();
        let lexicon = self.program.lexicon();
        for (mark, place) in marks(text, range, lexicon) {
            if mark != StatementMark::Variable {
                continue;
            }
            let after = &text[place.end as usize..(range.end as usize).min(text.len())];
            let next = after.iter().find(|byte| !byte.is_ascii_whitespace());
            let role =
                if assigns && next == Some(&b'=') { NameRole::Definition } else { NameRole::Use };
            let name = self.variable(place.slice(text));
            self.note(name, place, role);
        }
    }

    fn variable(&mut self, text: &[u8]) -> SymbolName {
        let name = self.keys.entry(text.to_vec()).or_insert_with(|| key_of(text)).clone();
        let local = match name.strip_prefix("#<") {
            Some(rest) => !rest.starts_with('_'),
            None => name
                .strip_prefix('#')
                .and_then(|digits| digits.parse::<u32>().ok())
                .is_some_and(|number| (1..=self.program.control().macros.locals).contains(&number)),
        };
        SymbolName::Variable { program: local.then_some(self.index), name }
    }

    fn note(&mut self, name: SymbolName, range: TextRange, role: NameRole) {
        self.found.push(NameOccurrence { name, range, role });
    }
}

#[derive(Clone, Copy)]
enum CallName {
    Program,
    Label,
}

/// The same variable has the same key, however it is written.
fn key_of(text: &[u8]) -> String {
    let plain: String = text
        .iter()
        .filter(|byte| !byte.is_ascii_whitespace())
        .map(|byte| char::from(*byte))
        .collect();
    if plain.starts_with("#<") {
        return plain.to_ascii_lowercase();
    }
    let (letter, digits) = plain.split_at(1.min(plain.len()));
    let number: u32 = digits.parse().unwrap_or(0);
    format!("{}{number}", letter.to_ascii_uppercase())
}

fn number_of(text: &[u8]) -> Option<i64> {
    std::str::from_utf8(text).ok()?.parse().ok()
}

fn whole(word: &Word) -> Option<i64> {
    word.number()?.to_integer()
}
