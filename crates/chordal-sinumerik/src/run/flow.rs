//! Conditions, loops and jumps.

use std::collections::BTreeMap;

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_kernel::EndReason;

use super::interpreter::Interpreter;
use super::run_state::{BlockFlow, LoopKind, OpenLoop};
use crate::syntax::{
    Address, BinaryOperator, BlockReader, Expression, JumpDirection, JumpStatement, JumpTarget,
    ProgramBlock, StatementKind,
};
use crate::values::{SinumerikValue, binary_operation};

/// The structures whose ends are searched.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Structure {
    If,
    For,
    While,
    Repeat,
    Loop,
}

impl Interpreter<'_> {
    /// Carries out a block of flow statements; `None` for a block of words.
    pub(super) fn flow_statement(&mut self, block: &ProgramBlock) -> Option<BlockFlow> {
        let first = &block.statements.first()?.kind;
        match first {
            StatementKind::If(condition) => Some(self.branch(condition)),
            // The branch that was carried out ends here.
            StatementKind::Else => {
                let flow = self.close_branch(block);
                Some(flow.unwrap_or_else(|| self.skip(block.range, Structure::If, false)))
            }
            StatementKind::EndIf => Some(self.close_branch(block).unwrap_or(BlockFlow::Next)),
            StatementKind::For { variable, from, to } => {
                Some(self.begin_for(block, variable, from, to))
            }
            StatementKind::While(condition) => Some(self.begin_while(block, condition)),
            StatementKind::RepeatLoop => Some(self.open(LoopKind::Until)),
            StatementKind::Loop => Some(self.open(LoopKind::Endless)),
            StatementKind::EndFor => Some(self.end_loop(block, Structure::For)),
            StatementKind::EndWhile => Some(self.end_loop(block, Structure::While)),
            StatementKind::EndLoop => Some(self.end_loop(block, Structure::Loop)),
            StatementKind::Until(condition) => Some(self.until(block, condition)),
            StatementKind::Jump(_) | StatementKind::Case { .. } => Some(self.jumps(block)),
            StatementKind::RepeatPart(part) => Some(self.repeat_part(block, part)),
            StatementKind::Define(definition) => Some(self.define(definition)),
            StatementKind::Macro { name, text } => {
                self.define_macro(name, *text);
                Some(BlockFlow::Next)
            }
            StatementKind::Procedure(_) | StatementKind::External(_) => Some(BlockFlow::Next),
            _ => self.call_statement(block),
        }
    }

    /// Whether a condition is fulfilled; one that has no value counts as not fulfilled, and is reported.
    fn is_true(&mut self, condition: &Expression) -> bool {
        let Some(value) = self.value(condition) else { return false };
        match value.unknown_cause() {
            Some(cause) => self.assume(condition.range, &cause.clone()),
            None => value.to_boolean().unwrap_or(false),
        }
    }

    fn branch(&mut self, condition: &Expression) -> BlockFlow {
        if self.is_true(condition) {
            self.running().open_branches += 1;
            return BlockFlow::Next;
        }
        self.skip(condition.range, Structure::If, true)
    }

    /// The end of a branch that was carried out; the end of the run if none was begun.
    fn close_branch(&mut self, block: &ProgramBlock) -> Option<BlockFlow> {
        let running = self.running();
        if running.open_branches == 0 && !running.has_jumped {
            self.alarm(12640, Code::LoopMismatch, block.range, "no IF before this belongs to it");
            return Some(BlockFlow::End(EndReason::Alarm));
        }
        running.open_branches = running.open_branches.saturating_sub(1);
        None
    }

    /// Skips blocks up to the end of a structure, or to the `ELSE` of an `IF`.
    fn skip(&mut self, head: TextRange, structure: Structure, stops_at_else: bool) -> BlockFlow {
        let mut depth = 0_u32;
        while let Some(block) = self.running().reader.next() {
            let Some(first) = block.statements.first() else { continue };
            let (opens, closes) = structure_of(&first.kind);
            if opens == Some(structure) {
                depth += 1;
            } else if closes == Some(structure) {
                if depth == 0 {
                    return BlockFlow::Next;
                }
                depth -= 1;
            } else if stops_at_else && depth == 0 && matches!(first.kind, StatementKind::Else) {
                self.running().open_branches += 1;
                return BlockFlow::Next;
            }
        }
        self.alarm(12640, Code::LoopMismatch, head, "the end of this structure is missing");
        BlockFlow::End(EndReason::Alarm)
    }

    fn position(&mut self) -> (u32, u32) {
        let reader = &self.running().reader;
        (reader.offset(), reader.line())
    }

    fn open(&mut self, kind: LoopKind) -> BlockFlow {
        let body = self.position();
        self.running().loops.push(OpenLoop { body, kind });
        BlockFlow::Next
    }

    fn begin_for(
        &mut self,
        block: &ProgramBlock,
        variable: &Address,
        from: &Expression,
        to: &Expression,
    ) -> BlockFlow {
        let (Some(first), Some(last)) = (self.number(from), self.number(to)) else {
            return self.skip(block.range, Structure::For, false);
        };
        self.write(variable, SinumerikValue::Integer(first.round() as i32));
        if first > last {
            return self.skip(block.range, Structure::For, false);
        }
        self.open(LoopKind::Counted(variable.clone(), last))
    }

    fn begin_while(&mut self, block: &ProgramBlock, condition: &Expression) -> BlockFlow {
        if !self.is_true(condition) {
            return self.skip(block.range, Structure::While, false);
        }
        self.open(LoopKind::While(condition.clone()))
    }

    /// The end of a FOR, WHILE or LOOP: back to its body, or on.
    fn end_loop(&mut self, block: &ProgramBlock, structure: Structure) -> BlockFlow {
        let open = self.running().loops.last().cloned();
        let goes_on = match open.as_ref().map(|open| &open.kind) {
            Some(LoopKind::Counted(variable, last)) if structure == Structure::For => {
                let next = self.read(variable).map_or(f64::INFINITY, |value| value + 1.0);
                self.write(variable, SinumerikValue::Integer(next.min(f64::from(i32::MAX)) as i32));
                next <= *last
            }
            Some(LoopKind::While(condition)) if structure == Structure::While => {
                self.is_true(condition)
            }
            Some(LoopKind::Endless) if structure == Structure::Loop => true,
            // A jump into a loop: the control knows no head to go back to.
            _ => {
                self.alarm(
                    12640,
                    Code::LoopMismatch,
                    block.range,
                    "this end has no head before it",
                );
                return BlockFlow::End(EndReason::Alarm);
            }
        };
        self.close_or_repeat(open, goes_on)
    }

    fn until(&mut self, block: &ProgramBlock, condition: &Expression) -> BlockFlow {
        let open = self.running().loops.last().cloned();
        if !matches!(open.as_ref().map(|open| &open.kind), Some(LoopKind::Until)) {
            self.alarm(
                12640,
                Code::LoopMismatch,
                block.range,
                "this UNTIL has no REPEAT before it",
            );
            return BlockFlow::End(EndReason::Alarm);
        }
        let goes_on = match self.value(condition) {
            // A loop that waits for something unknown ends, as if it had come.
            Some(value) if value.unknown_cause().is_some() => {
                let cause = value.unknown_cause().cloned().unwrap_or_default();
                self.assume(condition.range, &cause);
                false
            }
            Some(value) => !value.to_boolean().unwrap_or(false),
            None => false,
        };
        self.close_or_repeat(open, goes_on)
    }

    fn close_or_repeat(&mut self, open: Option<OpenLoop>, goes_on: bool) -> BlockFlow {
        match open {
            Some(open) if goes_on => {
                self.modes.has_jumped_back = true;
                self.running().reader.seek(open.body.0, open.body.1);
            }
            _ => {
                self.running().loops.pop();
            }
        }
        BlockFlow::Next
    }

    /// The jumps of a block: the first whose condition is fulfilled.
    fn jumps(&mut self, block: &ProgramBlock) -> BlockFlow {
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Jump(jump) => {
                    let holds =
                        jump.condition.as_ref().is_none_or(|condition| self.is_true(condition));
                    if holds {
                        return self.jump(jump);
                    }
                }
                StatementKind::Case { selector, branches, default } => {
                    let Some(value) = self.value(selector) else { return BlockFlow::Next };
                    if let Some(cause) = value.unknown_cause() {
                        self.assume(selector.range, &cause.clone());
                    }
                    for (constant, jump) in branches {
                        let Some(other) = self.value(constant) else { continue };
                        let is_equal = binary_operation(BinaryOperator::Equal, &value, &other);
                        if matches!(is_equal, Ok(SinumerikValue::Boolean(true))) {
                            return self.jump(jump);
                        }
                    }
                    return default.as_ref().map_or(BlockFlow::Next, |jump| self.jump(jump));
                }
                _ => {}
            }
        }
        BlockFlow::Next
    }

    fn jump(&mut self, jump: &JumpStatement) -> BlockFlow {
        if jump.direction == JumpDirection::ProgramStart {
            self.modes.has_jumped_back = true;
            self.running().loops.clear();
            let start = self.start_of_program();
            self.running().reader.seek(start.0, start.1);
            return BlockFlow::Next;
        }
        let name = match &jump.target {
            // A name of a text variable stands for its value.
            Some(JumpTarget::Label(name)) => match self.text_of_variable(name) {
                Some(value) => value,
                None => name.clone(),
            },
            Some(JumpTarget::Number(number, is_main)) => {
                format!("{}{number}", if *is_main { ':' } else { 'N' })
            }
            Some(JumpTarget::Computed(expression)) => match self.value(expression) {
                Some(SinumerikValue::Unknown(cause)) => {
                    self.lose_path(jump.range, "the target of the jump", &cause);
                    return BlockFlow::End(EndReason::LostJump);
                }
                Some(value) => {
                    value.to_text().map_or_else(|_| String::new(), |text| text.to_ascii_uppercase())
                }
                None => return BlockFlow::End(EndReason::LostJump),
            },
            None => return BlockFlow::Next,
        };
        let Some(place) = self.find_target(&name, jump.direction) else {
            if jump.direction == JumpDirection::BothOrNone {
                return BlockFlow::Next;
            }
            let message = format!("no block has the label {name} in the direction of the search");
            let diagnostic = Diagnostic::new(Code::MissingLabel, self.span(jump.range), message);
            self.report_alarm(
                14080,
                diagnostic.help("GOTOF searches towards the end, GOTOB towards the start"),
            );
            return BlockFlow::End(EndReason::LostJump);
        };
        let here = self.here().start;
        if place.0 <= here {
            self.modes.has_jumped_back = true;
        }
        self.running().has_jumped = true;
        self.leave_loops(place.0);
        self.running().reader.seek(place.0, place.1);
        BlockFlow::Next
    }

    /// Ends the loops that a jump leaves; a jump within a loop does not end it.
    fn leave_loops(&mut self, target: u32) {
        while let Some(open) = self.running().loops.last().cloned() {
            let body = open.body.0;
            if target >= body && target <= self.loop_end(&open) {
                return;
            }
            self.running().loops.pop();
        }
    }

    /// The first byte of the block that ends a loop.
    fn loop_end(&mut self, open: &OpenLoop) -> u32 {
        if let Some(end) = self.running().loop_ends.get(&open.body.0) {
            return *end;
        }
        let structure = match &open.kind {
            LoopKind::Counted(..) => Structure::For,
            LoopKind::While(_) => Structure::While,
            LoopKind::Until => Structure::Repeat,
            LoopKind::Endless => Structure::Loop,
        };
        let mut reader = self.running().reader.clone();
        reader.seek(open.body.0, open.body.1);
        let mut depth = 0_u32;
        let mut end = u32::MAX;
        for block in reader {
            let Some(first) = block.statements.first() else { continue };
            match structure_of(&first.kind) {
                (Some(opened), _) if opened == structure => depth += 1,
                (_, Some(closed)) if closed == structure && depth == 0 => {
                    end = block.range.start;
                    break;
                }
                (_, Some(closed)) if closed == structure => depth -= 1,
                _ => {}
            }
        }
        self.running().loop_ends.insert(open.body.0, end);
        end
    }

    /// The text that a variable holds, in upper case; `None` if no text variable has the name.
    fn text_of_variable(&mut self, name: &str) -> Option<String> {
        match self.variables.named(name)?.values.first()? {
            SinumerikValue::Text(text) => Some(text.to_ascii_uppercase()),
            _ => None,
        }
    }

    /// The first byte and line of the running program.
    fn start_of_program(&mut self) -> (u32, u32) {
        let program = self.running().program;
        let unit = &self.programs.texts[program].unit;
        (unit.head.end, unit.first_line)
    }

    /// The block with a label or a number, searched from here in a direction.
    pub(super) fn find_target(
        &mut self,
        name: &str,
        direction: JumpDirection,
    ) -> Option<(u32, u32)> {
        let here = self.here();
        if self.running().targets.is_none() {
            let program = self.running().program;
            let found = targets(self.programs.reader(program));
            self.running().targets = Some(found);
        }
        let places = self.running().targets.as_ref()?.get(name)?.clone();
        let after = || places.iter().find(|place| place.0 > here.start).copied();
        let before = || places.iter().rev().find(|place| place.0 <= here.start).copied();
        match direction {
            JumpDirection::Forward => after(),
            JumpDirection::Backward => before(),
            _ => after().or_else(|| places.first().copied()),
        }
    }
}

/// The blocks of a program by their labels and numbers.
fn targets(reader: BlockReader<'_>) -> BTreeMap<String, Vec<(u32, u32)>> {
    let mut found: BTreeMap<String, Vec<(u32, u32)>> = BTreeMap::new();
    for block in reader {
        let place = (block.range.start, block.line);
        if let Some(label) = block.label {
            found.entry(label.name).or_default().push(place);
        }
        if let Some(number) = block.number {
            let sign = if number.is_main { ':' } else { 'N' };
            found.entry(format!("{sign}{}", number.number)).or_default().push(place);
        }
    }
    found
}

/// The structure that a statement opens, and the one that it closes.
fn structure_of(kind: &StatementKind) -> (Option<Structure>, Option<Structure>) {
    match kind {
        StatementKind::If(_) => (Some(Structure::If), None),
        StatementKind::EndIf => (None, Some(Structure::If)),
        StatementKind::For { .. } => (Some(Structure::For), None),
        StatementKind::EndFor => (None, Some(Structure::For)),
        StatementKind::While(_) => (Some(Structure::While), None),
        StatementKind::EndWhile => (None, Some(Structure::While)),
        StatementKind::RepeatLoop => (Some(Structure::Repeat), None),
        StatementKind::Until(_) => (None, Some(Structure::Repeat)),
        StatementKind::Loop => (Some(Structure::Loop), None),
        StatementKind::EndLoop => (None, Some(Structure::Loop)),
        _ => (None, None),
    }
}
