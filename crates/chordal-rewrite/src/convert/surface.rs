//! Polar and cylindrical interpolation: the codes, and the length across by the letter that the new control has for it.

use chordal::CommandKind;
use chordal::control::{
    Action, ArcShape, CompensationSide, ModeCode, MotionCode, OnceCode, RotarySurface, SurfaceCode,
    SurfaceRules, SurfaceShape, SurfaceWord,
};
use chordal::geometry::Plane;
use chordal::machine::AXIS_LETTERS;

use super::codes;
use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers;
use super::trace::BlockExecution;
use crate::source::code_action;

/// Words of a block that begins or ends a surface, or lies on one.
pub(super) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let Some(run) = context.run(at) else { return Ok(()) };
    let code = (0..draft.block.words.len()).find_map(|word| {
        match code_action(&draft.block.words[word], context.from) {
            Some(Action::Once(OnceCode::Surface(code))) => Some((word, code)),
            _ => None,
        }
    });
    let surface = run.before.surface.or(run.after.surface);
    let Some(surface) = surface else {
        return match code {
            // It ends what is not active, or the control refuses it.
            Some((word, _)) if words_differ(context, code) => {
                draft.remove(word, "nothing is active that it ends");
                rest_of_code(draft, b"CYRQ");
                Ok(())
            }
            _ => Ok(()),
        };
    };
    let is_face = matches!(surface.shape, SurfaceShape::Face { .. });
    let Some([from, to]) = rules(context, is_face) else {
        let title = context.to.table.title;
        return Err(NeedsExpansion(format!("{title} has no {}", name(is_face))));
    };
    let across = SurfaceMove { context, surface, is_face, from, to, run };
    match code {
        Some((word, _)) if from.word != to.word => across.code(draft, word),
        Some(_) => Ok(()),
        None if run.before.surface.is_some() => across.words(draft, at),
        None => Ok(()),
    }
}

fn name(is_face: bool) -> &'static str {
    if is_face { "polar interpolation" } else { "cylindrical interpolation" }
}

/// How both controls do it.
fn rules(context: &ConvertContext, is_face: bool) -> Option<[&'static SurfaceRules; 2]> {
    let [from, to] = context
        .controls()
        .map(|control| if is_face { control.table.face } else { control.table.cylinder });
    Some([from?, to?])
}

fn words_differ(context: &ConvertContext, code: Option<(usize, SurfaceCode)>) -> bool {
    let is_face = !matches!(code, Some((_, SurfaceCode::Cylinder)));
    rules(context, is_face).is_some_and(|[from, to]| from.word != to.word)
}

/// Takes out the words that belong to a code, without a remark of their own.
fn rest_of_code(draft: &mut BlockDraft, letters: &[u8]) {
    for word in 0..draft.block.words.len() {
        if letters.contains(&draft.block.words[word].letter) {
            draft.set(word, "");
        }
    }
}

/// The plane of two linear axes.
fn plane_of(one: usize, other: usize) -> Plane {
    match one + other {
        1 => Plane::Xy,
        2 => Plane::Zx,
        _ => Plane::Yz,
    }
}

struct SurfaceMove<'c, 'a> {
    context: &'c ConvertContext<'a>,
    surface: RotarySurface,
    is_face: bool,
    from: &'static SurfaceRules,
    to: &'static SurfaceRules,
    run: &'c BlockExecution,
}

impl SurfaceMove<'_, '_> {
    /// The letter of an axis, and that of its increments on a control.
    fn letters(&self, rules: &SurfaceRules) -> [Option<u8>; 2] {
        let axis = match rules.word {
            SurfaceWord::Linear => self.surface.across,
            SurfaceWord::RotaryLength | SurfaceWord::RotaryAngle => self.surface.rotary,
        };
        let letter = AXIS_LETTERS.as_bytes()[axis];
        let increments = self.context.to.parameters.increments;
        let increment = increments.iter().find(|(_, of)| *of == letter).map(|(own, _)| *own);
        [Some(letter), increment]
    }

    fn own_plane(&self) -> Plane {
        match self.is_face {
            true => Plane::Xy,
            false => plane_of(self.surface.rotary - 3, self.surface.across),
        }
    }

    fn length(&self, mm: f64) -> String {
        let units = self.run.after.units;
        let digits = numbers::digits(self.context.to, units);
        numbers::length(mm, units, digits, self.context.style())
    }

    fn plane_code(&self, plane: Plane) -> Option<String> {
        codes::name(Action::from(plane), self.context.to, self.context.style())
    }

    /// The code that begins or ends the surface.
    fn code(&self, draft: &mut BlockDraft, word: usize) -> Result<(), NeedsExpansion> {
        let begins = self.run.before.surface.is_none();
        let code = match (self.is_face, begins) {
            (true, true) => SurfaceCode::Face,
            (true, false) => SurfaceCode::FaceOff,
            (false, _) => SurfaceCode::Cylinder,
        };
        let title = self.context.to.table.title;
        let own = codes::name(
            Action::Once(OnceCode::Surface(code)),
            self.context.to,
            self.context.style(),
        );
        let own = own.ok_or_else(|| {
            NeedsExpansion(format!("{title} has no code for {}", name(self.is_face)))
        })?;
        let mut words = vec![own];
        if !self.is_face {
            rest_of_code(
                draft,
                &[
                    AXIS_LETTERS.as_bytes()[self.surface.rotary],
                    AXIS_LETTERS.as_bytes()[self.surface.across],
                    b'R',
                    b'Q',
                ],
            );
            words.extend(self.cylinder_words(begins));
        }
        let before = draft.written(word);
        let gap = self.context.style().gap();
        let new = words.join(gap);
        draft.set(word, new.clone());
        draft.note(before, new, format!("{} on {title}", name(self.is_face)));
        self.planes_about(draft, begins);
        Ok(())
    }

    /// What stands next to the code of a cylinder.
    fn cylinder_words(&self, begins: bool) -> Vec<String> {
        let SurfaceShape::Cylinder { radius_mm } = self.surface.shape else { return Vec::new() };
        let letter = |axis: usize| char::from(AXIS_LETTERS.as_bytes()[axis]);
        let (rotary, across) = (letter(self.surface.rotary), letter(self.surface.across));
        match (self.to.word, begins) {
            (SurfaceWord::Linear, true) => {
                let radius = format!("R{}", self.length(radius_mm));
                vec![format!("{rotary}0"), format!("{across}0"), radius]
            }
            (SurfaceWord::Linear, false) => Vec::new(),
            (_, true) => vec![format!("{rotary}{}", self.length(radius_mm))],
            (_, false) => vec![format!("{rotary}0")],
        }
    }

    /// Where the length has the letter of a linear axis, arcs need the plane of that axis.
    fn planes_about(&self, draft: &mut BlockDraft, begins: bool) {
        if self.to.word != SurfaceWord::Linear {
            return;
        }
        let own = self.own_plane();
        let outside = if begins { self.run.before.plane } else { self.run.after.plane };
        if outside == own {
            return;
        }
        let plane = if begins { own } else { outside };
        let Some(code) = self.plane_code(plane) else { return };
        let reason = format!("{} reads arcs on it in this plane", self.context.to.table.title);
        draft.note(String::new(), code.clone(), reason);
        match (begins, self.is_face) {
            (true, false) => draft.before.push(code),
            (true, true) | (false, _) => draft.after.push(code),
        }
    }

    /// The words of a block on the surface.
    fn words(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        if self.context.waits(at) {
            return Ok(());
        }
        let title = self.context.to.table.title;
        let commands = self.context.trace.commands_of(self.run);
        let is_rapid = |kind: &CommandKind| matches!(kind, CommandKind::Rapid { .. });
        if !self.to.rapid && commands.iter().any(|command| is_rapid(&command.kind)) {
            return Err(NeedsExpansion(format!(
                "{title} makes no rapids in {}: write G1 with a feed",
                name(self.is_face)
            )));
        }
        self.radius_of_x(draft)?;
        if self.from.word == self.to.word {
            return Ok(());
        }
        self.planes_on(draft);
        self.lengths(draft, at)?;
        let shape = commands.iter().find_map(|command| command.kind.shape());
        if let Some(shape) = shape {
            self.direction(draft, shape);
            self.center(draft, shape)?;
        }
        let side = commands.iter().find_map(|command| match command.kind {
            CommandKind::Compensation { side, .. } => Some(side),
            _ => None,
        });
        self.side(draft, side);
        Ok(())
    }

    /// X of a face, where it is a diameter on one control and a radius on the other.
    fn radius_of_x(&self, draft: &mut BlockDraft) -> Result<(), NeedsExpansion> {
        let [one, other] = self.context.controls().map(|control| control.parameters.face_x_radius);
        if !self.is_face || one == other {
            return Ok(());
        }
        let (factor, what) = if one { (2.0, "diameter") } else { (0.5, "radius") };
        let title = self.context.to.table.title;
        for word in 0..draft.block.words.len() {
            let own = draft.block.words[word];
            if !matches!(own.letter, b'X' | b'U') || own.comma {
                continue;
            }
            let Some(number) = own.number() else {
                return Err(NeedsExpansion(format!("X is computed, and is a {what} on {title}")));
            };
            let digits = usize::from(number.scale) + 1;
            let text = numbers::plain(number.to_f64() * factor, digits, self.context.style());
            let reason = format!("X is a {what} in polar interpolation on {title}");
            draft.replace(word, format!("{}{text}", char::from(own.letter)), reason);
        }
        Ok(())
    }

    /// Codes of planes: a control whose length is a rotary word takes none on a face, and another one has a single plane for
    /// a cylinder.
    fn planes_on(&self, draft: &mut BlockDraft) {
        let title = self.context.to.table.title;
        if self.to.planes && self.to.word != SurfaceWord::Linear {
            return;
        }
        for word in 0..draft.block.words.len() {
            let action = code_action(&draft.block.words[word], self.context.from);
            let is_plane = matches!(
                action,
                Some(Action::Mode(ModeCode::PlaneXy | ModeCode::PlaneZx | ModeCode::PlaneYz))
            );
            if is_plane {
                draft.remove(word, format!("the surface has its plane on {title}"));
            }
        }
    }

    /// The length across.
    fn lengths(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let title = self.context.to.table.title;
        let [old, new] = [self.letters(self.from), self.letters(self.to)];
        let reason = match self.to.word {
            SurfaceWord::Linear => {
                format!("the length across is written with this letter on {title}")
            }
            SurfaceWord::RotaryLength => {
                format!("the length across has the letter of the rotary axis on {title}")
            }
            SurfaceWord::RotaryAngle => format!("{title} reads degrees"),
        };
        for word in 0..draft.block.words.len() {
            let own = draft.block.words[word];
            let Some(kind) = old.iter().position(|letter| *letter == Some(own.letter)) else {
                continue;
            };
            if own.comma {
                continue;
            }
            let text = match self.is_face {
                // A length stays as it is written.
                true => match new[kind] {
                    Some(letter) => format!("{}{}", char::from(letter), &draft.now(word)[1..]),
                    None => {
                        return Err(NeedsExpansion(format!("{title} has no letter for distances")));
                    }
                },
                false => self.end_across(at, new[0])?,
            };
            draft.replace(word, text, reason.clone());
        }
        Ok(())
    }

    /// Where the block ends on a cylinder.
    fn end_across(&self, at: usize, letter: Option<u8>) -> Result<String, NeedsExpansion> {
        if self.context.trace.facts[at].runs > 1 {
            return Err(NeedsExpansion(
                "the length on the cylinder is not the same in all runs".into(),
            ));
        }
        let SurfaceShape::Cylinder { radius_mm } = self.surface.shape else {
            return Err(NeedsExpansion("no cylinder is active".into()));
        };
        let mm = self.run.after.position[self.surface.across];
        let text = match self.to.word {
            SurfaceWord::RotaryAngle => {
                numbers::plain((mm / radius_mm).to_degrees(), 3, self.context.style())
            }
            SurfaceWord::RotaryLength | SurfaceWord::Linear => self.length(mm),
        };
        Ok(format!("{}{text}", char::from(letter.unwrap_or(b'C'))))
    }

    /// G2 for G3 where the planes have their axes in the other order.
    fn direction(&self, draft: &mut BlockDraft, shape: &ArcShape) {
        if self.is_face || self.to.word != SurfaceWord::Linear {
            return;
        }
        let turned = match shape.sweep < 0.0 {
            true => MotionCode::ArcCw,
            false => MotionCode::ArcCcw,
        };
        let is_arc =
            |action| matches!(action, Some(Action::Motion(MotionCode::ArcCw | MotionCode::ArcCcw)));
        self.replace_code(draft, is_arc, Action::Motion(turned));
    }

    /// G41 for G42 likewise.
    fn side(&self, draft: &mut BlockDraft, side: Option<CompensationSide>) {
        if self.is_face || self.to.word != SurfaceWord::Linear {
            return;
        }
        let code = match side {
            Some(CompensationSide::Left) => ModeCode::CompensationLeft,
            Some(CompensationSide::Right) => ModeCode::CompensationRight,
            Some(CompensationSide::Off) | None => return,
        };
        let is_side = |action| {
            matches!(
                action,
                Some(Action::Mode(ModeCode::CompensationLeft | ModeCode::CompensationRight))
            )
        };
        self.replace_code(draft, is_side, Action::Mode(code));
    }

    fn replace_code(
        &self,
        draft: &mut BlockDraft,
        is: impl Fn(Option<Action>) -> bool,
        new: Action,
    ) {
        let Some(text) = codes::name(new, self.context.to, self.context.style()) else { return };
        let title = self.context.to.table.title;
        for word in 0..draft.block.words.len() {
            let action = code_action(&draft.block.words[word], self.context.from);
            if is(action) && action != Some(new) {
                let reason = format!("the plane on {title} has its axes in the other order");
                draft.replace(word, text.clone(), reason);
            }
        }
    }

    /// R in place of a centre, where the new control takes no other.
    fn center(&self, draft: &mut BlockDraft, shape: &ArcShape) -> Result<(), NeedsExpansion> {
        let centers: Vec<usize> = (0..draft.block.words.len())
            .filter(|word| matches!(draft.block.words[*word].letter, b'I' | b'J' | b'K'))
            .collect();
        if self.to.centers || centers.is_empty() {
            return Ok(());
        }
        let title = self.context.to.table.title;
        let reason = format!("{title} reads only R of an arc in {}", name(self.is_face));
        let turn = shape.sweep.abs();
        if turn > std::f64::consts::TAU - 1e-6 {
            return Err(NeedsExpansion(format!("{reason}, and a full circle has none")));
        }
        for word in centers {
            draft.set(word, "");
        }
        let radius =
            if turn > std::f64::consts::PI { -shape.radius_from } else { shape.radius_from };
        draft.append(format!("R{}", self.length(radius)), reason);
        Ok(())
    }
}
