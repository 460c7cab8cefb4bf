//! Checks the height of a thread and the depth of its passes against its lead and its diameter.

use chordal_command::telling_number;
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_dialect::table::TurnFault;
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// Every thread is higher than this fraction of its lead: with four starts a thread of 60° is 0.135 to 0.153.
const MIN_SHARE: f64 = 0.13;

/// Every thread is lower than this fraction of its lead: buttress threads are 0.87.
const MAX_SHARE: f64 = 1.5;

/// Height of a full external thread of 60°, as a fraction of its lead.
const USUAL_SHARE: f64 = 0.6134;

/// The sizes of a thread, mm.
pub(super) struct ThreadSizes {
    /// Its height on the radius.
    pub height: f64,
    /// The depth of the first pass.
    pub first: f64,
    pub lead: f64,
    /// The distance of its root from the axis; `None` when it is not known.
    pub root_radius: Option<f64>,
}

impl Interpreter<'_> {
    /// Warns of a height that no thread has; `letters` are those of height and first depth.
    pub(super) fn check_thread_height(
        &mut self,
        block: &Block,
        letters: [u8; 2],
        sizes: &ThreadSizes,
    ) {
        let names = letters.map(char::from);
        let length = |mm: f64| self.kernel.length_text(mm);
        let share = sizes.height / sizes.lead;
        let [height, first, lead] = [sizes.height, sizes.first, sizes.lead].map(length);
        let number = telling_number(share, 2);
        let usual = length(USUAL_SHARE * sizes.lead);
        let of_lead =
            format!("{} of this thread is {height}, {number} times its lead of {lead}", names[0]);
        let message = if !(MIN_SHARE..=MAX_SHARE).contains(&share) {
            of_lead
        } else if let Some(radius) = sizes.root_radius.filter(|radius| sizes.height > *radius) {
            let radius = length(radius);
            format!("{} of this thread is {height}, more than its radius of {radius}", names[0])
        } else if sizes.first > sizes.height {
            format!(
                "the first pass, {} {first}, is deeper than the thread, {} {height}",
                names[1], names[0]
            )
        } else {
            return;
        };
        let spans = letters.iter().fold(0, |set, letter| set | 1 << (letter - b'A'));
        let span = self.words_span(block, Letters(spans));
        self.kernel.report(
            Diagnostic::new(Code::ThreadHeight, span, message)
                .label(format!("a whole thread of 60° with this lead is about {usual} high"))
                .help(self.thread_help(names)),
        );
    }

    fn thread_help(&self, [height, first]: [char; 2]) -> String {
        if self.control.parameters.rules.turning.thread_words_take_point {
            return format!(
                "check {height}, {first} and the lead, and that G20 or G21 is the one they were written for"
            );
        }
        let unit = self.kernel.rules.least_increment(self.kernel.state.units);
        let unit = self.kernel.length_text(unit);
        format!("{height} and {first} count {unit} and have no decimal point")
    }

    /// Reports a decimal point in words of a thread that count in least increments.
    pub(super) fn check_thread_point(&mut self, block: &Block, letters: &[u8]) {
        if self.control.parameters.rules.turning.thread_words_take_point {
            return;
        }
        let with_point = |letter: u8| {
            let word = *block.last(letter)?;
            let number = self.literal(&word)?;
            number.has_point.then(|| (word, number.to_string()))
        };
        let Some((word, number)) = letters.iter().copied().find_map(with_point) else { return };
        let unit = self.kernel.rules.least_increment(self.kernel.state.units);
        let unit = self.kernel.length_text(unit);
        let letter = char::from(word.letter);
        let message =
            format!("{letter}{number} has a decimal point: {letter} of this thread counts {unit}");
        let span = self.span(word.range);
        self.kernel.report(
            Diagnostic::new(Code::ThreadHeight, span, message)
                .label("read as a length; some controls refuse it, some leave out the point")
                .help(format!("write {letter} without a point, in steps of {unit}")),
        );
    }

    /// Reports a minimum depth of a pass (from the first block) above the height of the thread; true in that case.
    pub(super) fn is_least_above_height(&mut self, span: Span, height: f64) -> bool {
        let least = self.kernel.state.turning.thread.least;
        if least <= height {
            return false;
        }
        let (least, height) = (self.kernel.length_text(least), self.kernel.length_text(height));
        let message = format!(
            "the least depth of a pass, {least}, is more than the height of the thread, {height}"
        );
        let help = "Q of the first block is the least depth, P of the second the height; both count least increments";
        self.refuse_cycle(span, message, help, TurnFault::ThreadLeast);
        true
    }
}
