//! Reads one line as a block: its head (skip, number, label) and its statements.

use chordal_diagnostics::TextRange;

use super::ast::{BlockNumber, BlockStatement, LabelName, ProgramBlock, StatementKind};
use super::pending_fault::PendingFault;
use super::precedence::ComparisonPrecedence;
use super::scanner::{LineScanner, begins_name};

/// How many statements most blocks have at most.
const USUAL_STATEMENTS: usize = 6;

/// Reads one block. A function that cannot read its part notes the fault and returns `None`; the statement is then left
/// out and reading goes on after the fault.
pub(super) struct BlockParser<'t> {
    pub scan: LineScanner<'t>,
    pub block: ProgramBlock,
    pub precedence: ComparisonPrecedence,
    /// The fault of the statement that is read.
    pub pending: Option<PendingFault>,
    /// How many expressions are open around the one that is read.
    pub depth: u32,
    /// The operators of the expression that is read, with those of its parts.
    pub operators: u32,
}

impl<'t> BlockParser<'t> {
    /// A parser of the line of `text` at `range`.
    pub fn new(
        text: &'t [u8],
        range: TextRange,
        line: u32,
        precedence: ComparisonPrecedence,
    ) -> BlockParser<'t> {
        BlockParser {
            scan: LineScanner::new(text, range.start as usize, range.end as usize),
            block: ProgramBlock {
                range,
                line,
                skip_level: None,
                number: None,
                label: None,
                statements: Vec::with_capacity(USUAL_STATEMENTS),
                comment: None,
                doubtful_comparisons: Vec::new(),
                faults: Vec::new(),
            },
            precedence,
            pending: None,
            depth: 0,
            operators: 0,
        }
    }

    /// Reads the line.
    pub fn read(mut self) -> ProgramBlock {
        self.read_head();
        while !self.scan.is_at_end() {
            let start = self.scan.at;
            match self.statement() {
                Some(kind) => {
                    let range = self.scan.range_from(start);
                    self.block.statements.push(BlockStatement { range, kind });
                }
                None => self.recover(start),
            }
        }
        if self.scan.peek() == b';' {
            let start = self.scan.at as u32;
            self.block.comment = Some(TextRange::new(start, self.block.range.end));
        }
        self.block
    }

    /// `/2 N10 LABEL:`, each optional. A label may also come before the number.
    fn read_head(&mut self) {
        self.block.skip_level = self.skip_level();
        self.block.number = self.block_number();
        self.block.label = self.label();
        if self.block.number.is_none() && self.block.label.is_some() {
            self.block.number = self.block_number();
        }
    }

    fn skip_level(&mut self) -> Option<u8> {
        if !self.scan.take(b'/') {
            return None;
        }
        let digit = self.scan.peek();
        if !digit.is_ascii_digit() {
            return Some(0);
        }
        self.scan.at += 1;
        Some(digit - b'0')
    }

    fn block_number(&mut self) -> Option<BlockNumber> {
        let is_main = match self.scan.next_byte() {
            b'N' | b'n' => false,
            b':' => true,
            _ => return None,
        };
        let begin = self.scan;
        self.scan.at += 1;
        self.scan.skip_blanks();
        let number = self.scan.read_digits();
        // `N1=5` is the address of an axis with an extension.
        let is_extension = number.is_some() && !is_main && {
            let after = self.scan;
            let is_extension = self.scan.take_equals();
            self.scan = after;
            is_extension
        };
        match number {
            Some(number) if !is_extension => {
                let range = self.scan.range_from(begin.at);
                Some(BlockNumber { number, is_main, range })
            }
            _ => {
                self.scan = begin;
                None
            }
        }
    }

    /// A name of two or more characters and a colon.
    fn label(&mut self) -> Option<LabelName> {
        self.scan.skip_blanks();
        let begin = self.scan;
        let name = self.scan.read_name();
        match name {
            Some(name) if name.len() > 1 && self.scan.take(b':') => {
                let range = self.scan.range_from(begin.at);
                Some(LabelName { name: self.scan.upper(name), range })
            }
            _ => {
                self.scan = begin;
                None
            }
        }
    }

    /// Reads a statement, which begins with a name.
    fn statement(&mut self) -> Option<StatementKind> {
        if !begins_name(self.scan.peek()) {
            return self.fail("this begins no word");
        }
        let range = self.scan.read_name()?;
        if range.len() == 1 && self.scan.slice(range) != b"_" {
            return self.letter_word(range);
        }
        let name = self.scan.upper(range);
        match self.keyword(&name, range) {
            Some(statement) => statement,
            None => self.named_statement(name, range),
        }
    }

    /// The statement that a keyword begins; `None` for any other name.
    fn keyword(&mut self, name: &str, range: TextRange) -> Option<Option<StatementKind>> {
        Some(match name {
            "IF" => self.condition(),
            "ELSE" => Some(StatementKind::Else),
            "ENDIF" => Some(StatementKind::EndIf),
            "FOR" => self.count_loop(),
            "ENDFOR" => Some(StatementKind::EndFor),
            "WHILE" => self.expression().map(StatementKind::While),
            "ENDWHILE" => Some(StatementKind::EndWhile),
            "REPEAT" => self.repeat(false),
            "REPEATB" => self.repeat(true),
            "UNTIL" => self.expression().map(StatementKind::Until),
            "LOOP" => Some(StatementKind::Loop),
            "ENDLOOP" => Some(StatementKind::EndLoop),
            "CASE" => self.case(),
            "GOTO" | "GOTOF" | "GOTOB" | "GOTOC" | "GOTOS" => {
                self.scan.at = range.start as usize;
                self.jump(None).map(StatementKind::Jump)
            }
            "MCALL" => self.modal_call(),
            "CALL" => self.indirect_call(),
            "EXTCALL" | "ISOCALL" => self.named_call(),
            "PCALL" => self.path_call(),
            "DEF" => self.definition(),
            "PROC" => self.procedure(),
            "EXTERN" => self.external(),
            "DEFINE" => self.macro_definition(),
            "WHEN" | "WHENEVER" | "EVERY" | "FROM" | "DO" if self.block.statements.is_empty() => {
                Some(self.synchronous_action())
            }
            "ID" | "IDS" if self.block.statements.is_empty() && self.scan.take_equals() => {
                Some(self.synchronous_action())
            }
            _ => return None,
        })
    }

    fn synchronous_action(&mut self) -> StatementKind {
        self.scan.skip_to_comment();
        StatementKind::SynchronousAction
    }
}
