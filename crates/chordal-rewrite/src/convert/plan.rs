//! Which blocks keep their words and which are written out, and the lines of each.

use chordal::control::{Action, CallCode, MotionCode, OnceCode};
use chordal::control::{StatementMark, marks};
use std::collections::{BTreeMap, BTreeSet};

use chordal::CommandKind;
use chordal::syntax::{Block, BlockKind, Word, WordValue};

use super::comments;
use super::context::ConvertContext;
use super::contours::CycleContour;
use super::draft::{BlockDraft, NeedsExpansion};
use super::emit::CommandEmitter;
use super::initial;
use super::rendering::RenderedPlan;
use super::trace::BlockExecution;
use super::turning;
use super::{ConversionOptions, ConvertRefusal};
use crate::Change;

/// What a block does depends on values: a statement, or a word that is computed.
fn is_by_value(block: &Block) -> bool {
    let is_computed =
        |word: &Word| matches!(word.value, WordValue::Expression(_) | WordValue::Register { .. });
    matches!(block.kind, BlockKind::Macro(_)) || block.words.iter().any(is_computed)
}

/// The decisions made so far.
pub(crate) struct ConvertPlan<'c, 'a> {
    context: &'c ConvertContext<'a>,
    options: &'c ConversionOptions,
    drafts: Vec<Result<BlockDraft<'a>, NeedsExpansion>>,
    /// Why a block is written out.
    expand: Vec<Option<String>>,
    /// Main programs that are written out as they run.
    flat: Vec<Option<String>>,
    /// The block that set up the cycle of each block with holes.
    cycle: Vec<Option<usize>>,
}

impl<'c, 'a> ConvertPlan<'c, 'a> {
    pub fn new(
        context: &'c ConvertContext<'a>,
        options: &'c ConversionOptions,
    ) -> ConvertPlan<'c, 'a> {
        let count = context.source.blocks.len();
        ConvertPlan {
            drafts: (0..count).map(|at| context.block(at)).collect(),
            expand: vec![None; count],
            flat: vec![None; context.source.mains.len()],
            cycle: cycles_of(context),
            context,
            options,
        }
    }

    /// Writes a block out; false where it is already, or does nothing.
    pub fn write_out(&mut self, at: usize, reason: &str) -> bool {
        let does = self.context.run(at).is_some_and(|run| {
            self.context.trace.commands_of(run).iter().any(|command| {
                !matches!(command.kind, CommandKind::Message(_) | CommandKind::FeedRate { .. })
            })
        });
        if self.expand[at].is_some() || !does || self.is_flat(at) {
            return false;
        }
        self.expand[at] = Some(reason.to_string());
        true
    }

    /// A cycle is kept with all of its holes or not at all.
    fn whole_cycles(&mut self) {
        let mut reasons: BTreeMap<usize, String> = BTreeMap::new();
        for (at, setup) in self.cycle.iter().enumerate() {
            if let (Some(setup), Some(reason)) = (setup, &self.expand[at]) {
                reasons.entry(*setup).or_insert_with(|| reason.clone());
            }
        }
        for (at, setup) in self.cycle.iter().enumerate() {
            if let Some(reason) = setup.and_then(|setup| reasons.get(&setup))
                && self.expand[at].is_none()
            {
                self.expand[at] = Some(reason.clone());
            }
        }
    }

    /// Writes a main program out as it runs; false where it is already.
    pub fn write_all(&mut self, reason: &str) -> bool {
        let mut any = false;
        for flat in self.flat.iter_mut().filter(|flat| flat.is_none()) {
            *flat = Some(reason.to_string());
            any = true;
        }
        any
    }

    /// A contour is run by itself where the cycle that skips it is written out: then all of its cycles are.
    fn whole_contours(&mut self) {
        for contour in &self.context.contours.list {
            let skipping = contour.cycles.iter().filter(|(_, skips)| *skips);
            let mut reasons = skipping.filter_map(|(at, _)| self.expand[*at].clone());
            let Some(reason) = reasons.next() else { continue };
            for (at, _) in &contour.cycles {
                self.expand[*at].get_or_insert_with(|| reason.clone());
            }
        }
    }

    /// The contour that a block is part of, where no cycle is left that takes it.
    fn contour_without_cycle(&self, at: usize) -> Option<&CycleContour> {
        let contours = &self.context.contours.list;
        let is_out = |block: usize| self.expand[block].is_some() || self.is_flat(block);
        contours.iter().find(|contour| {
            contour.blocks.contains(&at)
                && contour.cycles.iter().all(|(cycle, _)| is_out(*cycle))
                && contour.is_cycle_only(self.context.source, &self.context.trace.facts)
        })
    }

    /// A block that keeps its words.
    pub fn is_kept(&self, at: usize) -> bool {
        self.expand[at].is_none() && !self.is_flat(at)
    }

    fn main_of(&self, at: usize) -> Option<usize> {
        self.context.source.mains.iter().position(|main| main.contains(&at))
    }

    fn is_flat(&self, at: usize) -> bool {
        self.context.source.sub_of(at).is_none()
            && self.main_of(at).is_some_and(|main| self.flat[main].is_some())
    }

    /// The lines of all blocks. Decisions that follow from others are made on the way.
    pub fn render(&mut self) -> RenderedPlan {
        for at in 0..self.drafts.len() {
            if let Err(NeedsExpansion(reason)) = &self.drafts[at]
                && self.expand[at].is_none()
            {
                self.expand[at] = Some(reason.clone());
            }
        }
        // Each turn writes more out; when there is nothing more, what is left is refused.
        let mut at_the_end = false;
        loop {
            self.whole_cycles();
            self.whole_contours();
            let covered = self.covered();
            if !at_the_end && let Some((at, reason)) = self.moving_statement(&covered) {
                at_the_end = !self.escalate(at, &reason, &covered);
                continue;
            }
            let mut rendered =
                RenderedPlan { lines: vec![None; self.drafts.len()], ..RenderedPlan::default() };
            if let Some((at, reason)) = self.written_out(&covered, &mut rendered) {
                if self.escalate(at, &reason, &covered) {
                    continue;
                }
                let line = self.context.source.blocks[at].line;
                let words = self.context.source.words(at);
                rendered.refusals.push(ConvertRefusal { line, words, reason });
            }
            self.kept(&covered, &mut rendered);
            self.flattened(&mut rendered);
            let flat: Vec<bool> = self.flat.iter().map(Option::is_some).collect();
            initial::begin(self.context, &flat, &mut rendered);
            self.refuse_assumed(&mut rendered);
            rendered.changes.sort_by_key(|change| change.line);
            return rendered;
        }
    }

    /// A statement, a computed word or a call that is written out is what one run did. Where that run has assumed a
    /// value it is not what the program says.
    fn refuse_assumed(&self, rendered: &mut RenderedPlan) {
        let Some(assumed) = &self.context.trace.assumed else { return };
        let blocks = self.context.source.blocks.iter().enumerate();
        let written_out = blocks.filter(|(at, block)| !self.is_kept(*at) && is_by_value(block));
        rendered.refusals.extend(written_out.map(|(at, block)| ConvertRefusal {
            line: block.line,
            words: self.context.source.words(at),
            reason: format!(
                "it would have to be written out as one run does it, and nobody knows whether that run is right: {}",
                assumed.message
            ),
        }));
    }

    /// Runs that another block's lines already hold.
    fn covered(&self) -> Vec<bool> {
        let trace = self.context.trace;
        let mut covered = vec![false; trace.execs.len()];
        let mut at = 0;
        while at < covered.len() {
            let exec = &trace.execs[at];
            let main_is_flat = self.flat.iter().any(Option::is_some)
                && exec.block.is_none_or(|block| self.is_flat(block));
            let is_out = exec.block.is_some_and(|block| self.expand[block].is_some());
            if main_is_flat || is_out {
                let tree = trace.subtree(at);
                let from = if main_is_flat { at } else { at + 1 };
                covered[from..tree.end].fill(true);
                at = tree.end.max(at + 1);
            } else {
                at += 1;
            }
        }
        covered
    }

    /// A statement that steers the run, is not kept, and is not yet within what is written out.
    fn moving_statement(&self, covered: &[bool]) -> Option<(usize, String)> {
        let (source, trace) = (self.context.source, self.context.trace);
        for (index, exec) in trace.execs.iter().enumerate() {
            let Some(at) = exec.block.filter(|_| !covered[index]) else { continue };
            let Some(reason) = &self.expand[at] else { continue };
            if let BlockKind::Macro(range) = source.blocks[at].kind {
                let lexicon = &self.context.from.table.lexicon;
                let steers = marks(source.text, range, lexicon).any(|(mark, word)| {
                    mark == StatementMark::Word && steers(word.slice(source.text))
                });
                if steers {
                    return Some((at, reason.clone()));
                }
            }
            // A jump back carries out again what stands between.
            let jumps = source
                .has_action(at, self.context.from, |a| a == Action::Call(CallCode::Return))
                && source.blocks[at].letters().has(b'P');
            if jumps {
                return Some((at, reason.clone()));
            }
        }
        None
    }

    /// The lines of a block are not the same in all of its runs: its callers are written out, or the
    /// whole program. False where that is done already.
    fn escalate(&mut self, at: usize, reason: &str, covered: &[bool]) -> bool {
        let trace = self.context.trace;
        let mut callers = BTreeSet::new();
        for (index, exec) in trace.execs.iter().enumerate() {
            if exec.block == Some(at) && !covered[index] {
                let chain = &trace.paths[exec.path as usize];
                callers.insert(chain.iter().find_map(|span| self.context.source.block_at(*span)));
            }
        }
        let mut any = false;
        for caller in callers.iter().flatten() {
            if self.expand[*caller].is_none() {
                self.expand[*caller] = Some(reason.to_string());
                any = true;
            }
        }
        if callers.contains(&None) || !any {
            any |= match self.main_of(at) {
                Some(main) if self.flat[main].is_none() => {
                    self.flat[main] = Some(reason.to_string());
                    true
                }
                _ => self.write_all(reason),
            };
        }
        any
    }

    /// The lines of blocks that are written out; a block whose runs differ is handed back.
    fn written_out(
        &self,
        covered: &[bool],
        rendered: &mut RenderedPlan,
    ) -> Option<(usize, String)> {
        let trace = self.context.trace;
        let mut known: Vec<Option<Vec<String>>> = vec![None; self.drafts.len()];
        for (index, exec) in trace.execs.iter().enumerate() {
            let Some(at) = exec.block.filter(|_| !covered[index]) else { continue };
            let Some(reason) = &self.expand[at] else { continue };
            let lines = match self.emit(index) {
                Ok(emitter) => {
                    rendered.printed |= emitter.printed;
                    rendered.unwritten.extend(emitter.unwritten);
                    emitter.lines
                }
                Err(refusal) => {
                    rendered.refusals.push(refusal);
                    Vec::new()
                }
            };
            match &known[at] {
                None => known[at] = Some(lines),
                Some(before) if *before == lines => {}
                Some(_) => return Some((at, reason.clone())),
            }
        }
        for (at, lines) in known.into_iter().enumerate() {
            let Some(lines) = lines else { continue };
            let line = self.context.source.blocks[at].line;
            let before = self.context.source.words(at);
            let reason = format!("{}: written out", self.expand[at].clone().unwrap_or_default());
            let lines = self.headed(at, lines);
            rendered.changes.push(Change { line, before, after: lines.join("\n"), reason });
            rendered.lines[at] = Some(lines);
        }
        None
    }

    /// The lines with the block's number, its words as a remark, and its comments.
    fn headed(&self, at: usize, mut lines: Vec<String>) -> Vec<String> {
        let source = self.context.source;
        let block = &source.blocks[at];
        let gap = source.style.gap();
        let mut head = Vec::new();
        if lines.len() > 1 || !block.comments.is_empty() {
            let words = source.words(at).replace(['(', ')'], "");
            let text = words.trim_start_matches(['\'', '#', '*', ';', ' ']).trim_end();
            let text = within_line(text, self.context.to.parameters.longest_line);
            let text = if text.is_empty() { String::new() } else { format!("({text})") };
            head.extend((!text.is_empty()).then_some(text));
        }
        if block.delete.is_some() {
            lines = lines.into_iter().map(|line| format!("/{line}")).collect();
        }
        let number = block.words.iter().find(|word| word.letter == b'N');
        if let (Some(number), Some(first)) = (number, lines.first_mut()) {
            let number = String::from_utf8_lossy(number.range.slice(source.text)).into_owned();
            *first = format!("{number}{gap}{first}");
        }
        head.extend(lines);
        head
    }

    /// What a run does, and what it calls, as blocks.
    fn emit(&self, index: usize) -> Result<CommandEmitter<'c>, ConvertRefusal> {
        let trace = self.context.trace;
        let tree = trace.subtree(index);
        let mut emitter = self.emitter(&trace.execs[index]);
        for exec in &trace.execs[tree.clone()] {
            self.emit_one(exec, &mut emitter)?;
        }
        emitter.restore(&trace.execs[tree.end - 1].after);
        Ok(emitter)
    }

    fn emitter(&self, exec: &BlockExecution) -> CommandEmitter<'c> {
        let tolerance = self.options.tolerance_mm;
        CommandEmitter::new(self.context, tolerance, self.options.digits, &exec.before)
    }

    fn emit_one(
        &self,
        exec: &BlockExecution,
        emitter: &mut CommandEmitter<'c>,
    ) -> Result<(), ConvertRefusal> {
        let commands = self.context.trace.commands_of(exec);
        let has = |action: Action| {
            exec.block.is_some_and(|at| {
                self.context.source.has_action(at, self.context.from, |own| own == action)
            })
        };
        // What no command shows would be lost.
        let writes = has(Action::Once(OnceCode::SetData));
        let is_hidden = writes
            || has(Action::NotSimulated)
            || has(Action::NotFollowed)
            || has(Action::Once(OnceCode::Engraving))
            || exec.block.is_some_and(|at| turning::is_hidden(self.context, at));
        if commands.is_empty() && !is_hidden {
            return Ok(());
        }
        let mut tried = emitter.clone();
        let is_live = exec.block.is_some_and(|at| self.context.live.is_about(at));
        tried.enter(&exec.before, &exec.after, is_live);
        let reason = match tried.block(commands) {
            Ok(()) if !is_hidden => {
                *emitter = tried;
                return Ok(());
            }
            Ok(()) if writes => "data that the program sets".to_string(),
            Ok(()) if self.context.turns() => "what no move shows".to_string(),
            Ok(()) => "a code that Chordal does not carry out".to_string(),
            Err(reason) => reason,
        };
        // Words that mean the same on both controls may do what no command shows.
        let source = self.context.source;
        let draft = exec.block.map(|at| (at, self.drafts[at].clone()));
        match draft {
            Some((at, Ok(mut draft))) => {
                let (line, words) = (source.blocks[at].line, source.words(at));
                emitter.unwritten.push(ConvertRefusal { line, words, reason });
                for word in 0..draft.block.words.len() {
                    if draft.block.words[word].letter == b'N' {
                        draft.set(word, "");
                    }
                }
                emitter.restore(&exec.before);
                emitter.foreign(draft.lines(), &exec.after);
                Ok(())
            }
            Some((at, Err(NeedsExpansion(why)))) => Err(ConvertRefusal {
                line: source.blocks[at].line,
                words: source.words(at),
                reason: format!("{why}; and it cannot be written out: {reason}"),
            }),
            None => Err(ConvertRefusal {
                line: 0,
                words: String::new(),
                reason: format!("a block of another file cannot be written out: {reason}"),
            }),
        }
    }

    /// The lines of blocks that keep their words.
    fn kept(&self, covered: &[bool], rendered: &mut RenderedPlan) {
        let (source, trace) = (self.context.source, self.context.trace);
        let mut sub_runs = vec![(0usize, 0usize); source.subs.len()];
        for (index, exec) in trace.execs.iter().enumerate() {
            let Some(at) = exec.block else { continue };
            if let Some(sub) = source.sub_of(at) {
                sub_runs[sub].0 += 1;
                sub_runs[sub].1 += usize::from(covered[index]);
            }
        }
        for (sub, (runs, within)) in source.subs.iter().zip(&sub_runs) {
            if *runs > 0 && runs == within {
                let line = source.blocks[sub.blocks.start].line;
                rendered.changes.push(Change {
                    line,
                    before: source.words(sub.blocks.start),
                    after: String::new(),
                    reason: "the subprogram is written out where it was called".into(),
                });
            }
        }
        let drops: Vec<bool> =
            sub_runs.iter().map(|(runs, within)| *runs > 0 && runs == within).collect();
        for at in 0..self.drafts.len() {
            let gone = source.sub_of(at).is_some_and(|sub| drops[sub]);
            if rendered.lines[at].is_some() || gone || self.is_flat_body(at) {
                continue;
            }
            if let Some(contour) = self.contour_without_cycle(at) {
                if at == contour.blocks.start {
                    rendered.changes.push(Change {
                        line: source.blocks[at].line,
                        before: source.words(at),
                        after: String::new(),
                        reason: "the contour is written out where cycles took it".into(),
                    });
                }
                continue;
            }
            match &self.drafts[at] {
                Ok(draft) if self.expand[at].is_none() => {
                    let lines = draft.lines();
                    let is_bare = lines.is_empty() && draft.block.words.is_empty();
                    rendered.changes.extend(draft.changes.iter().cloned());
                    rendered.lines[at] = (!lines.is_empty() || is_bare).then_some(lines);
                }
                // What never runs cannot be written out: it stays as a remark.
                _ if trace.facts[at].runs == 0 => {
                    let words = source.words(at).replace(['(', ')'], "");
                    let line = source.blocks[at].line;
                    let after = format!("({words})");
                    rendered.changes.push(Change {
                        line,
                        before: source.words(at),
                        after: after.clone(),
                        reason: "it never runs, and the new control has no form for it".into(),
                    });
                    rendered.lines[at] = Some(vec![after]);
                }
                _ => {}
            }
        }
    }

    fn is_flat_body(&self, at: usize) -> bool {
        let source = self.context.source;
        self.is_flat(at)
            && self.main_of(at).is_some_and(|main| at >= source.first_words(&source.mains[main]))
            && source.blocks[at].kind != BlockKind::Percent
            && source.section_end != Some(at)
    }

    /// Main programs that are written out as they run.
    fn flattened(&self, rendered: &mut RenderedPlan) {
        let (source, trace) = (self.context.source, self.context.trace);
        for (main, reason) in source.mains.iter().zip(&self.flat) {
            let Some(reason) = reason else { continue };
            let runs: Vec<usize> = (0..trace.execs.len())
                .filter(|index| {
                    let exec = &trace.execs[*index];
                    let chain = &trace.paths[exec.path as usize];
                    let root = chain.last().map_or(exec.block, |span| source.block_at(*span));
                    root.is_some_and(|at| main.contains(&at))
                })
                .collect();
            let Some(first) = runs.first() else { continue };
            for at in main.clone().filter(|at| source.blocks[*at].delete.is_some()) {
                rendered.refusals.push(ConvertRefusal {
                    line: source.blocks[at].line,
                    words: source.words(at),
                    reason: format!(
                        "{reason}, so the program must be written out as it runs; but this block runs \
                         only where block delete is off"
                    ),
                });
            }
            let mut emitter = self.emitter(&trace.execs[*first]);
            let mut seen = BTreeSet::new();
            for index in runs {
                let exec = &trace.execs[index];
                if let Some(at) = exec.block
                    && seen.insert(at)
                {
                    emitter.remarks(self.remarks(at));
                }
                if let Err(refusal) = self.emit_one(exec, &mut emitter) {
                    rendered.refusals.push(refusal);
                }
            }
            emitter.finish();
            rendered.printed |= emitter.printed;
            rendered.unwritten.append(&mut emitter.unwritten);
            let body = main.clone().find(|at| self.is_flat_body(*at)).unwrap_or(main.start);
            let line = source.blocks[body].line;
            rendered.changes.push(Change {
                line,
                before: source.words(body),
                after: emitter.lines.join("\n"),
                reason: format!("{reason}: the program is written out as it runs"),
            });
            rendered.lines[body] = Some(emitter.lines);
        }
    }

    /// The comments of a block in the marks of the new control.
    fn remarks(&self, at: usize) -> Vec<String> {
        let source = self.context.source;
        if !self.is_flat_body(at) {
            return Vec::new();
        }
        let lexicons = self.context.controls().map(|control| control.table.lexicon);
        let block = &source.blocks[at];
        let texts = block.comments.iter().map(|range| {
            let text = String::from_utf8_lossy(range.slice(source.text)).into_owned();
            comments::comment(&text, &lexicons[0], &lexicons[1])
        });
        texts.filter(|text| !text.is_empty()).collect()
    }
}

/// As much of a remark as a line of the control holds with its parentheses; 0 for any length.
fn within_line(text: &str, longest: u32) -> &str {
    let most = (longest as usize).saturating_sub(2);
    if longest == 0 || text.len() <= most {
        return text;
    }
    let end = (0..=most).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    text[..end].trim_end()
}

/// The block that set up the active cycle, for each block that belongs to it.
fn cycles_of(context: &ConvertContext) -> Vec<Option<usize>> {
    let mut cycles = vec![None; context.source.blocks.len()];
    let mut setup = None;
    for exec in &context.trace.execs {
        let Some(at) = exec.block else { continue };
        let is_cycle = |action: Action| {
            matches!(action, Action::Cycle(_) | Action::Motion(MotionCode::Turn(_)))
        };
        let is = exec.after.motion.is_some_and(is_cycle);
        let own = context.source.has_action(at, context.from, is_cycle);
        if own {
            setup = Some(at);
        }
        if !is && !own {
            setup = None;
        }
        if own || context.in_cycle(exec) {
            cycles[at] = cycles[at].or(setup);
        }
    }
    cycles
}

/// A word of a macro language that decides which block comes next.
fn steers(word: &[u8]) -> bool {
    const STEERING: [&[u8]; 10] =
        [b"GOTO", b"WHILE", b"IF", b"ELSE", b"END", b"DO", b"CALL", b"SUB", b"REPEAT", b"WAIT"];
    let word = word.to_ascii_uppercase();
    STEERING.iter().any(|own| word.starts_with(own))
}
