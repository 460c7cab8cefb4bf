//! The moves of a head: the tool axis to where the program has been clear, the other axes over the place, then down.

use super::head::KlartextHeadWriter;
use super::places::{ANGLE_DIGITS, HeadFault, LENGTH_DIGITS, PlaceWriter};
use super::values::exact_number;
use super::watch::StateAtBlock;
use crate::syntax::AXIS_WORDS;

/// How far above a place the tool goes down to it, mm.
const MIN_DESCENT_MM: f64 = 1e-6;

impl KlartextHeadWriter<'_> {
    /// The head does not go to the height of the tool.
    pub fn approaches(&self) -> bool {
        let is_lost = (0..6).any(|axis| self.is_lost(axis));
        self.calls_tool || is_lost || !(0..6).any(|axis| self.takes_part(axis))
    }

    /// An axis stands where only the machine knows.
    fn is_lost(&self, axis: usize) -> bool {
        let modal = &self.state.modal;
        let is_there = axis < 3 || modal.machine_known.has(axis);
        let is_open = !modal.known.has(axis) && !modal.unmoved.has(axis);
        is_there && is_open && self.machine_function(axis).is_none()
    }

    /// M91 or M92, where it has brought an axis to its place.
    fn machine_function(&self, axis: usize) -> Option<u32> {
        let StateAtBlock { modal, noted, .. } = self.state;
        noted.to_machine[axis].filter(|_| modal.machine_known.has(axis))
    }

    /// The value of a coordinate in program units, with its text where a block takes all its digits.
    fn place(
        &self,
        axis: usize,
        value: f64,
        places: &mut PlaceWriter,
    ) -> Result<String, HeadFault> {
        if axis < 3 {
            let unit = if self.state.modes.is_inch { 25.4 } else { 1.0 };
            return places.word(axis, self.length(value), value / unit);
        }
        let degrees = value.to_degrees();
        places.word(axis, exact_number(degrees, ANGLE_DIGITS), degrees)
    }

    /// Whether the head brings an axis to its place: the program has moved it.
    fn takes_part(&self, axis: usize) -> bool {
        let StateAtBlock { modal, noted, .. } = self.state;
        let (a, b, _) = self.tool_plane().axes();
        let moved = |axis: usize| {
            let has_moved = noted.moved[axis] || !modal.unmoved.has(axis);
            modal.known.has(axis) && has_moved || self.machine_function(axis).is_some()
        };
        // In a turned plane both axes move together.
        let is_plain = self.state.modes.chain.list().is_empty();
        moved(axis) || !is_plain && [a, b].contains(&axis) && (moved(a) || moved(b))
    }

    /// The tool axis to where the program has been clear, the other axes over the place, then down by feed; with the spindle
    /// and the coolant. Where a place is not known, as that of the tool axis after a TOOL CALL of an unknown length, the axes
    /// whose place is known go there at the height that the machine has.
    pub(super) fn approach(&self, places: &mut PlaceWriter) -> Result<Vec<String>, HeadFault> {
        let mut lines = Vec::new();
        let normal = self.tool_plane().axes().2;
        let has_height = !self.approaches() && self.takes_part(normal);
        let above = self.height_above();
        if has_height {
            lines.push(self.to_height(normal, above, places)?);
        }
        lines.extend(self.over_place(places)?);
        let [spindle, flood, mist] = self.running();
        add_word(&mut lines, 0, spindle);
        let last = lines.len().saturating_sub(1);
        add_word(&mut lines, last, flood);
        add_word(&mut lines, last, mist);
        let feed = self.feed();
        let goes_down = has_height && self.machine_function(normal).is_none();
        match (above, feed) {
            (Some(_), feed) if goes_down => {
                let place = self.state.modes.frame.programmed(&self.state.modal.position);
                let word = self.place(normal, place[normal], places)?;
                lines.push(format!("L {word} R0 {}", feed.as_deref().unwrap_or("FMAX")));
            }
            (_, Some(feed)) => lines.push(format!("L R0 {feed}")),
            (_, None) => {}
        }
        Ok(lines)
    }

    /// The height, mm, from which the tool goes down to its place; nothing where it stands there.
    fn height_above(&self) -> Option<f64> {
        let StateAtBlock { modal, modes, noted, .. } = self.state;
        let normal = self.tool_plane().axes().2;
        let mut above = modal.position;
        above[normal] = noted.highest.max(modal.position[normal]);
        let [above, place] =
            [above, modal.position].map(|place| modes.frame.programmed(&place)[normal]);
        ((above - place).abs() > MIN_DESCENT_MM).then_some(above)
    }

    /// The move of the tool axis to its height.
    fn to_height(
        &self,
        axis: usize,
        above: Option<f64>,
        places: &mut PlaceWriter,
    ) -> Result<String, HeadFault> {
        if self.machine_function(axis).is_some() {
            return self.machine_line(&[axis], places);
        }
        let word = match above {
            Some(above) => self.height(axis, above),
            None => {
                let place = self.state.modes.frame.programmed(&self.state.modal.position);
                self.place(axis, place[axis], places)?
            }
        };
        Ok(format!("L {word} R0 FMAX"))
    }

    /// The rotary axes to their angles, then the axes of the plane over the place.
    fn over_place(&self, places: &mut PlaceWriter) -> Result<Vec<String>, HeadFault> {
        let place = self.state.modes.frame.programmed(&self.state.modal.position);
        let (a, b, _) = self.tool_plane().axes();
        let mut lines = Vec::new();
        for axes in [&[3, 4, 5][..], &[a, b]] {
            let own = axes.iter().copied().filter(|axis| self.takes_part(*axis));
            let (by_machine, others): (Vec<usize>, Vec<usize>) =
                own.partition(|axis| self.machine_function(*axis).is_some());
            if !by_machine.is_empty() {
                lines.push(self.machine_line(&by_machine, places)?);
            }
            let words: Result<Vec<String>, HeadFault> =
                others.iter().map(|axis| self.place(*axis, place[*axis], places)).collect();
            let words = words?;
            if !words.is_empty() {
                lines.push(format!("L {} R0 FMAX", words.join(" ")));
            }
        }
        Ok(lines)
    }

    /// A height above the place; what the block takes is near enough.
    fn height(&self, axis: usize, mm: f64) -> String {
        let unit = if self.state.modes.is_inch { 25.4 } else { 1.0 };
        let text = chordal_kernel::plain_number(mm / unit, LENGTH_DIGITS[0]);
        let sign = if text.starts_with('-') { "" } else { "+" };
        format!("{}{sign}{text}", AXIS_WORDS[axis])
    }

    /// A rapid to places of the machine.
    fn machine_line(&self, axes: &[usize], places: &mut PlaceWriter) -> Result<String, HeadFault> {
        let modal = &self.state.modal;
        let words: Result<Vec<String>, HeadFault> = axes
            .iter()
            .map(|axis| self.place(*axis, modal.machine_position[*axis], places))
            .collect();
        let function = axes.iter().find_map(|axis| self.machine_function(*axis)).unwrap_or(91);
        Ok(format!("L {} R0 FMAX M{function}", words?.join(" ")))
    }

    /// CC and FPOL. One that cannot be written is left out: the proof fails where the rest needs it.
    pub(super) fn poles(&self, places: &mut PlaceWriter) -> Vec<String> {
        let contour = &self.state.modes.contour;
        let (a, b, _) = contour.center_plane.unwrap_or(self.tool_plane()).axes();
        let mut words = |name: &str, values: [(usize, Option<f64>); 2]| {
            let named = values.iter().filter_map(|(axis, value)| Some((*axis, (*value)?)));
            let words: Result<Vec<String>, HeadFault> =
                named.map(|(axis, value)| self.place(axis, value, places)).collect();
            let words = words.ok().filter(|words| !words.is_empty())?;
            Some(format!("{name} {}", words.join(" ")))
        };
        let center = words("CC", [(a, contour.center[a]), (b, contour.center[b])]);
        let (a, b, _) = self.tool_plane().axes();
        let pole = self.state.modes.free_pole;
        let pole =
            pole.and_then(|[first, second]| words("FPOL", [(a, Some(first)), (b, Some(second))]));
        center.into_iter().chain(pole).collect()
    }
}

/// Adds a word to a line, or as a line of its own where there is none.
fn add_word(lines: &mut Vec<String>, at: usize, word: Option<&str>) {
    let Some(word) = word else { return };
    match lines.get_mut(at) {
        Some(line) => *line += &format!(" {word}"),
        None => lines.push(word.to_string()),
    }
}
