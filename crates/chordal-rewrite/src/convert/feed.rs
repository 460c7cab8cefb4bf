//! F, where the new control measures it along something else: helices and lines with rotary axes.

use chordal::CommandKind;
use chordal::control::{ArcShape, Control, Feed, FeedAlong, FeedMode, Move, RotaryLength, Units};

use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers;

/// Ratios of two feeds that are nearer to 1 are rounding.
const RATIO_ROUNDING: f64 = 1e-9;

impl ConvertContext<'_> {
    /// F of the block as the new control measures it.
    pub(super) fn feed_along(
        &self,
        draft: &mut BlockDraft,
        at: usize,
    ) -> Result<(), NeedsExpansion> {
        let Some(run) = self.run(at) else { return Ok(()) };
        let mut cuts =
            self.trace.commands_of(run).iter().filter_map(|command| match &command.kind {
                CommandKind::Arc { motion, shape, feed } => Some((motion, Some(shape), feed)),
                CommandKind::Line { motion, feed } => Some((motion, None, feed)),
                _ => None,
            });
        let Some((motion, shape, feed)) = cuts.next() else { return Ok(()) };
        if feed.mode == FeedMode::InverseTime || !feed.value.is_finite() {
            return Ok(());
        }
        let units = run.after.units;
        let [old, new] =
            self.controls().map(|control| feed_word(motion, shape, feed, control, units));
        if (new / old - 1.0).abs() < RATIO_ROUNDING {
            return Ok(());
        }
        let what = match shape {
            None => "of a line with rotary axes in another way",
            Some(_) if self.to.parameters.rules.arc.helix_feed == FeedAlong::Plane => {
                "of a helix in the plane of its arc"
            }
            Some(_) => "of a helix along the helix",
        };
        let reason = format!("{} measures the feed {what}", self.to.table.title);
        let facts = &self.trace.facts[at];
        if facts.feed_varies || shape.is_none() && facts.runs > 1 {
            return Err(NeedsExpansion(reason));
        }
        let text = |value: f64| format!("F{}", numbers::feed(value, self.style()));
        match draft.place(b'F') {
            Some(own) => draft.replace(own, text(new), reason),
            None => draft.append(text(new), reason),
        }
        draft.after.push(text(old));
        Ok(())
    }
}

/// The number behind F that gives this feed on a control, per minute or per revolution.
pub(super) fn feed_word(
    motion: &Move,
    shape: Option<&ArcShape>,
    feed: &Feed,
    control: &Control,
    units: Units,
) -> f64 {
    let rules = &control.parameters.rules;
    let rotary = match shape {
        Some(_) => None,
        // Where the diameter is not given, the run of the new program says so.
        None => rules.rotary_feed.length_of(motion, units).unwrap_or(None),
    };
    let unit_mm = units.mm();
    if feed.mode == FeedMode::PerTime && motion.only_turns(shape) {
        return 60.0
            * match rotary {
                Some(rotary @ RotaryLength::ArcOnCylinder { .. }) => {
                    feed.value * rotary.vector_mm(0.0, motion) / motion.turn_rad() / unit_mm
                }
                _ => feed.value.to_degrees(),
            };
    }
    let scale = match shape {
        Some(shape) => helix_scale(motion, shape, feed, rules.arc.helix_feed),
        None => line_scale(motion, feed, rotary),
    };
    match feed.mode {
        FeedMode::PerTime => feed.value * 60.0 / unit_mm * scale,
        FeedMode::InverseTime => feed.value * 60.0,
        FeedMode::PerRevolution => feed.value / unit_mm * scale,
    }
}

/// What F of a line is multiplied by where the new control counts rotary axes so.
fn line_scale(motion: &Move, feed: &Feed, new: Option<RotaryLength>) -> f64 {
    let linear_mm =
        (0..3).map(|axis| (motion.to[axis] - motion.from[axis]).powi(2)).sum::<f64>().sqrt();
    let old = match feed.along {
        FeedAlong::AllAxes(rotary) => Some(rotary),
        FeedAlong::Path | FeedAlong::Plane => None,
    };
    if old == new || linear_mm == 0.0 {
        return 1.0;
    }
    let counted_mm = |rotary: Option<RotaryLength>| {
        rotary.map_or(linear_mm, |rotary| rotary.vector_mm(linear_mm, motion))
    };
    counted_mm(new) / counted_mm(old)
}

/// What F of a helix is multiplied by where the new control measures it along this.
pub(crate) fn helix_scale(motion: &Move, shape: &ArcShape, feed: &Feed, new: FeedAlong) -> f64 {
    let (_, _, c) = shape.plane.axes();
    let radius = (shape.radius_from + shape.radius_to) / 2.0;
    let flat = radius * shape.sweep.abs();
    let whole = flat.hypot(motion.to[c] - motion.from[c]);
    if flat == 0.0 {
        return 1.0;
    }
    match (feed.along, new) {
        (FeedAlong::Plane, FeedAlong::Path) => whole / flat,
        (FeedAlong::Path, FeedAlong::Plane) => flat / whole,
        _ => 1.0,
    }
}
