//! The state after a line as text.

use chordal::control::{FeedMode, Modal, SpindleState, Units, number_text};
use chordal::machine::AXIS_NAMES;

use crate::EditorProgram;

/// The index of the first rotary axis: A, B and C come after X, Y and Z.
const FIRST_ROTARY_AXIS: usize = 3;

impl EditorProgram {
    /// The state after a line as a control's screen shows it, in the program's units.
    pub fn modal_text(&self, modal: &Modal) -> String {
        let mut lines = vec![modal.codes.join(" ")];
        let coordinate_text = |axis: usize| {
            let letter = AXIS_NAMES[axis];
            if !modal.known.has(axis) {
                return format!("{letter}?");
            }
            let value = modal.position[axis];
            let shown = match (axis, modal.units) {
                (FIRST_ROTARY_AXIS.., _) => number_text(value.to_degrees(), 3),
                (_, Units::Inch) => number_text(value / modal.units.mm(), 4),
                (_, Units::Millimetre) => number_text(value, 3),
            };
            format!("{letter}{shown}")
        };
        let axes = self.machine().axes.iter().enumerate().filter(|(_, axis)| axis.is_some());
        let coordinates: Vec<String> = axes.map(|(axis, _)| coordinate_text(axis)).collect();
        lines.push(format!("{} in {}", coordinates.join(" "), modal.work_name));
        let mut details = Vec::new();
        details.extend(modal.feed.map(|feed| feed_text(feed, modal)));
        if let Some(live) = modal.live {
            let direction =
                if live.turns == SpindleState::Ccw { "counter-clockwise" } else { "clockwise" };
            details.push(format!("live tool {} rpm {direction}", number_text(live.rpm, 1)));
        }
        match modal.spindle {
            SpindleState::Off => {}
            SpindleState::Cw => details.push(format!("S{} clockwise", number_text(modal.rpm, 1))),
            SpindleState::Ccw => {
                details.push(format!("S{} counter-clockwise", number_text(modal.rpm, 1)));
            }
            SpindleState::Oriented => details.push("spindle oriented".into()),
        }
        if modal.tool > 0 {
            details.push(format!("T{}", modal.tool));
        }
        details.extend(modal.length_offset.map(|number| format!("H{number}")));
        details.extend(modal.radius_offset.map(|number| format!("D{number}")));
        if !details.is_empty() {
            lines.push(details.join(", "));
        }
        lines.join("\n")
    }
}

/// The text of a feed, which is in mm/s, in 1/s (inverse time: one divided by the time of the move) or in mm per
/// revolution, by the feed mode.
fn feed_text(feed: f64, modal: &Modal) -> String {
    match (modal.feed_mode, modal.units) {
        (FeedMode::PerTime, Units::Inch) => {
            format!("F {} in/min", number_text(feed / modal.units.mm() * 60.0, 2))
        }
        (FeedMode::PerTime, Units::Millimetre) => {
            format!("F {} mm/min", number_text(feed * 60.0, 1))
        }
        (FeedMode::InverseTime, _) => format!("F {} 1/min", number_text(feed * 60.0, 3)),
        (FeedMode::PerRevolution, Units::Inch) => {
            format!("F {} in/rev", number_text(feed / modal.units.mm(), 4))
        }
        (FeedMode::PerRevolution, Units::Millimetre) => {
            format!("F {} mm/rev", number_text(feed, 3))
        }
    }
}
