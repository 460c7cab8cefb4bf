//! Cuts the moves of a run from the stock, one after the other.

use std::collections::BTreeMap;

use chordal_diagnostics::Code;
use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, PassError, Region, ToolOutline as Outline, TurnedPass};

use super::contour::FeedChain;
use super::gather::{TurnMove, TurnedMoveKind};
use super::grooves::GrooveRecord;
use super::helix::ThreadGrooves;
use super::problems::{MessageDetail, ProblemLocation, TurnedProblems};
use super::recorder::SectionRecorder;
use super::report::{CutOffPart, TurnedMove, TurnedThread, TurnedToolRemoved};
use super::target::TurnedTargetPart;
use super::threads::SpindleRevolutions;
use super::tools::{LatheTool, NoOutline, TurningToolKind};

/// A fixture: its name, clearance and half section, grown by the clearance.
pub(super) struct TurnedFixture<'a> {
    pub name: &'a str,
    pub clearance: f64,
    pub body: LatheStock,
}

/// The state of a run on stock.
pub(super) struct TurnedRun<'a> {
    pub tools: &'a BTreeMap<u32, Result<LatheTool, NoOutline>>,
    pub tolerance: f64,
    pub stock: LatheStock,
    pub fixtures: Vec<TurnedFixture<'a>>,
    pub target: Option<TurnedTargetPart>,
    pub found: TurnedProblems<'a>,
    pub grooves: GrooveRecord,
    pub loose: Vec<CutOffPart>,
    pub threads: Vec<TurnedThread>,
    /// The grooves of each thread, for the upper bound of what it removes, and the tool that began it.
    pub helices: Vec<(ThreadGrooves, u32)>,
    /// The box around the stock before the first cut.
    extent: (Vec2, Vec2),
    pub moves: Vec<TurnedMove>,
    pub bound: f64,
    /// Records the section after every pass; `None` where no replay is requested.
    pub recorder: Option<SectionRecorder>,
    sums: BTreeMap<u32, TurnedToolRemoved>,
    order: Vec<u32>,
    chain: FeedChain,
    /// The previous move cut a thread: the tool is in the groove.
    in_thread: bool,
    revolutions: SpindleRevolutions,
}

impl<'a> TurnedRun<'a> {
    pub fn new(
        tools: &'a BTreeMap<u32, Result<LatheTool, NoOutline>>,
        tolerance: f64,
        stock: &Region,
        found: TurnedProblems<'a>,
    ) -> TurnedRun<'a> {
        TurnedRun {
            tools,
            tolerance,
            stock: LatheStock::new(stock),
            fixtures: Vec::new(),
            target: None,
            found,
            grooves: GrooveRecord::new(stock),
            loose: Vec::new(),
            threads: Vec::new(),
            helices: Vec::new(),
            extent: stock.bounds().unwrap_or((Vec2::ZERO, Vec2::ZERO)),
            moves: Vec::new(),
            bound: 0.0,
            recorder: None,
            sums: BTreeMap::new(),
            order: Vec::new(),
            chain: FeedChain::default(),
            in_thread: false,
            revolutions: SpindleRevolutions::default(),
        }
    }

    /// The results by tool, in the order of first cuts.
    pub fn tools_in_order(&mut self) -> Vec<TurnedToolRemoved> {
        for (thread, (helix, tool)) in self.threads.iter().zip(&self.helices) {
            if let Some(sum) = self.sums.get_mut(tool) {
                sum.removed_mm3.most += helix.volume(&thread.section);
            }
        }
        self.order.iter().filter_map(|number| self.sums.remove(number)).collect()
    }

    /// Carries out the move with this index.
    pub fn step(&mut self, number: usize, moves: &[TurnMove]) {
        let move_ = &moves[number];
        let Some(Ok(tool)) = self.tools.get(&move_.tool) else { return };
        if let Some(recorder) = &mut self.recorder {
            recorder.begin(move_, &self.stock);
        }
        match move_.kind {
            TurnedMoveKind::Rapid => {
                self.chain.clear();
                self.rapid(move_, tool);
                self.in_thread = false;
            }
            TurnedMoveKind::Thread => {
                self.chain.clear();
                self.thread(move_, tool);
                self.in_thread = true;
            }
            TurnedMoveKind::Cut | TurnedMoveKind::Still => {
                self.cut(number, move_, tool);
                self.in_thread = false;
                if self.grooves.cut(number, move_, tool) {
                    let in_chuck = self.grooves.part_off(
                        &self.stock,
                        moves,
                        self.tolerance,
                        &mut self.loose,
                        &mut self.found,
                    );
                    if let Some(in_chuck) = in_chuck {
                        self.stock = in_chuck;
                    }
                }
            }
        }
        self.fixtures(move_, tool);
        if let Some(recorder) = &mut self.recorder {
            recorder.end(move_, &self.stock, &self.loose);
        }
    }

    fn rapid(&mut self, move_: &TurnMove, tool: &LatheTool) {
        if !self.in_thread && self.touches(Code::RapidThroughStock, move_, &tool.edges, tool.body) {
            return;
        }
        self.bodies(move_, tool);
    }

    fn cut(&mut self, number: usize, move_: &TurnMove, tool: &LatheTool) {
        let tag = u32::try_from(number + 1).unwrap_or(u32::MAX);
        let path = move_.path.tagged(tag);
        let flank = self.chain.flank_leads(tool, move_);
        let cut = if flank {
            let cut = self.stock.cut_out(&tool.edges, &path);
            cut.map(|(pass, removed)| (pass, Some(removed)))
        } else {
            self.stock.cut(&tool.edges, &path).map(|pass| (pass, None))
        };
        let (pass, removed) = match cut {
            Ok(found) => found,
            Err(error) => return self.not_cut(move_, &error),
        };
        self.bound = self.bound.max(pass.bound);
        if let Some(recorder) = &mut self.recorder
            && pass.area > 0.0
        {
            recorder.cuts();
        }
        self.count(move_, tool, &pass);
        let is_deep = pass.touched && pass.depth() > self.tolerance;
        if is_deep && move_.kind == TurnedMoveKind::Still {
            self.say(Code::CutsWithoutSpindle, pass.depth(), move_, middle(&pass));
        }
        if is_deep
            && matches!(tool.kind, TurningToolKind::Insert { .. })
            && pass.across > tool.reach
        {
            let deeper = pass.across - tool.reach;
            self.say(Code::DeeperThanFlutes, deeper, move_, middle(&pass));
        }
        if let Some(removed) = removed
            && let Some((depth, place)) = self.chain.gouge(&removed, tool.reach)
            && depth > self.tolerance
        {
            self.say(Code::FlankGouge, depth, move_, place);
        }
        self.chain.add(move_);
        self.gouge(move_, tool);
        self.bodies(move_, tool);
    }

    /// A thread removes a groove and leaves the rest: the stock stays as it is, and the places of the grooves are
    /// recorded.
    fn thread(&mut self, move_: &TurnMove, tool: &LatheTool) {
        let (pass, taken) = match self.stock.touch(&tool.edges, &move_.path) {
            Ok(found) => found,
            Err(error) => return self.not_cut(move_, &error),
        };
        if !self.in_thread {
            self.revolutions.begin();
        }
        let mut helix = ThreadGrooves::default();
        if !taken.is_empty() {
            helix.add(&self.revolutions, self.extent, &tool.edges, move_);
        }
        self.count(move_, tool, &TurnedPass { volume: helix.volume(&taken), ..pass });
        let grooves = self.revolutions.grooves(&self.stock, &tool.edges, move_);
        if !taken.is_empty() {
            let line = move_.origin.line;
            match (self.threads.last_mut(), self.helices.last_mut()) {
                (Some(thread), Some((known, by)))
                    if *by == move_.tool
                        && (thread.line == line || meets(&thread.section, &taken)) =>
                {
                    thread.add(&taken, grooves, line);
                    known.join(helix);
                }
                _ => {
                    let (grooves, lead_mm) = grooves.unzip();
                    let lead_mm = lead_mm.flatten();
                    let row = move_.row;
                    self.threads.push(TurnedThread { section: taken, grooves, lead_mm, line, row });
                    self.helices.push((helix, move_.tool));
                }
            }
        }
        self.bodies(move_, tool);
    }

    /// Upper bound of what the threads remove from the sections that are left, mm³.
    pub fn most_of_threads(&self, sections: &[&Region]) -> f64 {
        let threads = self.threads.iter().zip(&self.helices);
        threads
            .map(|(thread, (helix, _))| {
                let left = sections.iter().filter_map(|one| thread.section.intersection(one).ok());
                left.map(|left| helix.volume(&left.region)).sum::<f64>()
            })
            .sum()
    }

    fn not_cut(&mut self, move_: &TurnMove, error: &PassError) {
        let at = ProblemLocation { origin: move_.origin, tool: move_.tool, place: move_.path.end };
        self.found.push(Code::NotProved, 0.0, &at, MessageDetail::Why(&error.to_string()));
    }

    /// Checks that what carries the edges touches nothing; only the first touch is reported.
    fn bodies(&mut self, move_: &TurnMove, tool: &LatheTool) {
        let bodies = [
            (Code::HolderInStock, &tool.holder),
            (Code::ShankInStock, &tool.shank),
            (Code::DeeperThanFlutes, &tool.above),
        ];
        for (code, body) in bodies {
            if let Some(body) = body
                && self.touches(code, move_, body, tool.body)
            {
                return;
            }
        }
    }

    /// Reports whether a body touches the stock along a move, and returns true if it does.
    fn touches(&mut self, code: Code, move_: &TurnMove, body: &Outline, tool_body: Vec2) -> bool {
        match self.stock.touch(body, &move_.path) {
            Ok((pass, _)) if pass.touched && pass.depth() > self.tolerance => {
                let depth = match code {
                    // For a blade, the depth of its block below the surface.
                    Code::DeeperThanFlutes => into(tool_body, move_, &pass),
                    _ => pass.depth(),
                };
                self.say(code, depth, move_, middle(&pass));
                true
            }
            Ok(_) => false,
            Err(error) => {
                self.not_cut(move_, &error);
                false
            }
        }
    }

    fn fixtures(&mut self, move_: &TurnMove, tool: &LatheTool) {
        let bodies =
            [Some(&tool.edges), tool.holder.as_ref(), tool.shank.as_ref(), tool.above.as_ref()];
        for fixture in &self.fixtures {
            let touches = bodies.iter().flatten().filter_map(|body| {
                let (pass, _) = fixture.body.touch(body, &move_.path).ok()?;
                (pass.touched && pass.depth() > self.tolerance).then_some(pass)
            });
            let deepest = touches.max_by(|x, y| x.depth().total_cmp(&y.depth()));
            let Some(pass) = deepest else { continue };
            let at =
                ProblemLocation { origin: move_.origin, tool: move_.tool, place: middle(&pass) };
            let more = MessageDetail::Fixture(fixture.name, fixture.clearance);
            self.found.push(Code::FixtureHit, pass.depth(), &at, more);
        }
    }

    fn gouge(&mut self, move_: &TurnMove, tool: &LatheTool) {
        let Some(target) = &mut self.target else { return };
        let Ok((pass, removed)) = target.core.cut_out(&tool.edges, &move_.path) else { return };
        if !pass.touched {
            return;
        }
        if let Some((depth, place)) = target.depth(&removed)
            && depth > target.tolerance
        {
            self.say(Code::Gouge, depth, move_, place);
        }
    }

    fn say(&mut self, code: Code, depth: f64, move_: &TurnMove, place: Vec2) {
        let at = ProblemLocation { origin: move_.origin, tool: move_.tool, place };
        self.found.push(code, depth, &at, MessageDetail::Nothing);
    }

    /// Adds up what a move removes.
    fn count(&mut self, move_: &TurnMove, tool: &LatheTool, pass: &TurnedPass) {
        let is_thread = move_.kind == TurnedMoveKind::Thread;
        let path = &move_.path;
        let length = match path.bend {
            None => path.start.distance(path.end),
            Some(bend) => path.sweep().abs() * bend.radius,
        };
        let by_turn = (move_.rev_per_s > 0.0).then(|| move_.feed / move_.rev_per_s);
        let mean_depth = if pass.along > 0.0 { pass.area / pass.along } else { 0.0 };
        let squarely = match tool.kind {
            TurningToolKind::Insert { approach: Some(angle), .. } => libm::sin(angle),
            TurningToolKind::Insert { .. }
            | TurningToolKind::Round
            | TurningToolKind::Blade { .. }
            | TurningToolKind::Drill => 1.0,
        };
        let in_cut = if move_.feed > 0.0 { pass.along.min(length) / move_.feed } else { 0.0 };
        let cut = TurnedMove {
            origin: move_.origin,
            row: move_.row,
            tool: move_.tool,
            is_thread,
            feed_mm_per_s: move_.feed,
            rpm: 60.0 * move_.rev_per_s,
            length_mm: length,
            engaged_mm: pass.along,
            depth_mm: pass.across,
            area_mm2: pass.area,
            removed_mm3: pass.volume,
            chip_mm2: by_turn.filter(|_| !is_thread).map(|feed| feed * mean_depth),
            chip_mm: by_turn.filter(|_| !is_thread).map(|feed| feed * squarely),
            rate_mm3_per_s: if in_cut > 0.0 && !is_thread { pass.volume / in_cut } else { 0.0 },
            power_kw: None,
            overload: None,
        };
        if !self.sums.contains_key(&move_.tool) {
            self.order.push(move_.tool);
        }
        let sum = self.sums.entry(move_.tool).or_insert_with(|| TurnedToolRemoved {
            number: move_.tool,
            moves: 0,
            removed_mm3: Default::default(),
            lowest: Vec2::new(f64::INFINITY, f64::INFINITY),
            deepest: (0.0, 0),
            largest_chip: (0.0, 0),
            power: None,
            time_s: None,
        });
        sum.moves += 1;
        // The passes of a thread deepen the same groove, which counts once, at the end.
        if !is_thread {
            sum.removed_mm3.most += pass.volume;
            sum.removed_mm3.least += pass.volume;
            if pass.touched && pass.across > sum.deepest.0 {
                sum.deepest = (pass.across, move_.origin.line);
            }
            if let Some(chip) = cut.chip_mm2.filter(|chip| *chip > sum.largest_chip.0) {
                sum.largest_chip = (chip, move_.origin.line);
            }
        }
        let ends = [path.start, path.end];
        for end in ends {
            sum.lowest = Vec2::new(sum.lowest.a.min(end.a), sum.lowest.b.min(end.b));
        }
        self.moves.push(cut);
    }
}

/// How far the touched material extends into the tool, mm.
fn into(body: Vec2, move_: &TurnMove, pass: &TurnedPass) -> f64 {
    let along = (move_.path.end - move_.path.start).normalized().unwrap_or(Vec2::new(1.0, 0.0));
    if along.dot(body).abs() > 0.7 { pass.along } else { pass.across }
}

/// The centre of the touched material.
fn middle(pass: &TurnedPass) -> Vec2 {
    pass.place.map_or(Vec2::ZERO, |(low, high)| (low + high) * 0.5)
}

/// Whether the bounding boxes of two regions meet.
fn meets(a: &Region, b: &Region) -> bool {
    let (Some((low, high)), Some((from, to))) = (a.bounds(), b.bounds()) else { return false };
    low.a <= to.a && from.a <= high.a && low.b <= to.b && from.b <= high.b
}
