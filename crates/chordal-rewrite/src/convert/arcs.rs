//! Arcs: centres and turns as the new control reads them, and the feed of a helix.

use chordal::control::{ArcShape, Control};
use chordal::syntax::Letters;

use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers;
use super::trace::{BlockExecution, moves};

/// An arc must name an axis of its plane, also where it ends at its start.
pub(super) fn needs_axes(to: &Control) -> bool {
    to.table.firmware.is_some_and(|firmware| !firmware.block.bare_circles)
}

impl ConvertContext<'_> {
    /// Centres and radii as the new control reads them, and forms that it does not have.
    pub(super) fn arc(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let Some(run) = self.run(at) else { return Ok(()) };
        let shapes = self.trace.commands_of(run).iter().filter(|command| !command.origin.cycle);
        let Some(shape) = shapes.filter_map(|command| command.kind.shape()).next() else {
            return Ok(());
        };
        let letters = draft.block.letters();
        let spiral = (shape.radius_to - shape.radius_from).abs();
        let parameters = &self.to.parameters;
        if spiral > parameters.rules.arc.radius_error_tolerance_mm {
            return Err(NeedsExpansion(format!(
                "the radius changes by {} on the arc",
                run.after.units.length_text(spiral)
            )));
        }
        let turns = Letters::of("PQL");
        let same_turns = self.from.table.arc_turns == self.to.table.arc_turns
            && self.from.parameters.rules.arc.spiral == parameters.rules.arc.spiral;
        let repeats = self.line_repeat(draft, at).is_some();
        if letters.without(Letters::of(if repeats { "L" } else { "" })).meets(turns) && !same_turns
        {
            return Err(NeedsExpansion(format!(
                "{} counts turns in another way",
                self.to.table.title
            )));
        }
        if self.from.parameters.rules.arc.arc_center != parameters.rules.arc.arc_center
            && letters.meets(Letters::of("IJK"))
        {
            return Err(NeedsExpansion(format!(
                "{} reads centres in another way",
                self.to.table.title
            )));
        }
        self.named_axes(draft, at, run, shape)?;
        let (a, b, _) = shape.plane.axes();
        if self.to.table.strict_center_words {
            for word in 0..draft.block.words.len() {
                let letter = draft.block.words[word].letter;
                let outside = matches!(letter, b'I' | b'J' | b'K')
                    && letter != b"IJK"[a]
                    && letter != b"IJK"[b];
                if outside {
                    draft.remove(word, "a centre word outside the plane");
                }
            }
        }
        Ok(())
    }

    /// The end of a full circle, where the new control must have it.
    fn named_axes(
        &self,
        draft: &mut BlockDraft,
        at: usize,
        run: &BlockExecution,
        shape: &ArcShape,
    ) -> Result<(), NeedsExpansion> {
        let (a, b, _) = shape.plane.axes();
        let [first, second] = [a, b].map(|axis| b"XYZ"[axis]);
        let letters = draft.block.letters();
        if !needs_axes(self.to) || letters.has(first) || letters.has(second) {
            return Ok(());
        }
        let reason = format!("{} needs the end point of a full circle", self.to.table.title);
        if self.trace.facts[at].runs > 1 {
            return Err(NeedsExpansion(reason));
        }
        let moves = moves(self.trace.commands_of(run)).last();
        let Some(to) = moves.and_then(|command| command.kind.motion()).map(|motion| motion.to)
        else {
            return Ok(());
        };
        let place = if run.after.incremental { 0.0 } else { to[a] };
        let units = run.after.units;
        let text = numbers::length(place, units, numbers::digits(self.to, units), self.style());
        draft.append(format!("{}{text}", char::from(first)), reason);
        Ok(())
    }
}
