//! Finds the one changed word that makes an arc with two different radii a true arc.
//!
//! After a typing mistake all other words are right: with the intended word the two radii agree to the least increment,
//! which hardly any other word achieves. With one changed digit there are so many candidates that one may agree by
//! chance; therefore the error of the arc must be larger for those, and they are only suggested if nothing simpler fits.

use chordal_command::Position;
use chordal_diagnostics::{Applicability, Fix, TextRange};
use chordal_geometry::{ArcSweep, Plane};
use chordal_kernel::{ArcWords, MisfitArc};
use chordal_syntax::{Block, BlockKind, BlockReader, Decimal, Word, WordValue};

use super::Interpreter;
use super::arc::center_letters;
use super::literals::AXIS_OF;

/// Largest number of suggestions.
const MAX_REPAIRS: usize = 3;

/// The previous block is searched within this many bytes.
const LOOK_BACK: usize = 400;
const MAX_LINES_BACK: usize = 3;

/// The kinds of typing mistakes, the simplest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum TypingError {
    /// An extra or a missing sign.
    Sign,
    /// I for J, X for Y.
    Letter,
    /// Two adjacent digits are exchanged.
    Swapped,
    /// The decimal point is one place off.
    Point,
    /// One digit is wrong.
    Digit,
    /// A number instead of zero.
    Number,
}

impl TypingError {
    /// Smallest radius error of the arc to try this kind, in least increments; larger for kinds with more candidates.
    fn least_error(self) -> f64 {
        match self {
            TypingError::Sign | TypingError::Letter | TypingError::Number => 5.0,
            TypingError::Swapped | TypingError::Point => 50.0,
            TypingError::Digit => 1000.0,
        }
    }

    /// Largest radius error of a true arc, in least increments: each of its six words is rounded.
    fn most_error(self) -> f64 {
        if self == TypingError::Digit { 1.0 } else { 1.5 }
    }

    /// True for a kind with so many candidates that one may fit by chance.
    fn is_last_resort(self) -> bool {
        self == TypingError::Digit
    }
}

/// A candidate for a mistyped word.
#[derive(Clone, Debug)]
struct WordVariant {
    mistake: TypingError,
    /// Its index among the words of its block.
    at: usize,
    letter: u8,
    /// The number as written.
    text: String,
}

/// A candidate that makes a true arc.
struct ArcRepair {
    mistake: TypingError,
    in_block_before: bool,
    error: f64,
    radius: f64,
    degrees: f64,
    word: Word,
    replacement: String,
}

impl Interpreter<'_> {
    /// Reports an arc with two radii, with the changed words that would make it a true arc.
    #[cold]
    pub(super) fn report_misfit(&mut self, block: &Block, misfit: MisfitArc) {
        let repairs = self.repairs(block, &misfit);
        let mut problem = misfit.problem;
        let text = self.reader.text();
        let mut fixes = repairs.iter().map(|repair| {
            let old = String::from_utf8_lossy(repair.word.range.slice(text));
            let place = if repair.in_block_before { " in the block before" } else { "" };
            let radius = self.kernel.length_text(repair.radius);
            let degrees = chordal_command::telling_number(repair.degrees, 1);
            let title = format!(
                "write `{}` for `{}`{place}: an arc of radius {radius} over {degrees}°",
                repair.replacement,
                old.trim()
            );
            Fix {
                title,
                span: self.span(repair.word.range),
                replacement: repair.replacement.clone(),
                applicability: Applicability::Unsafe,
            }
        });
        problem.fix = fixes.next();
        problem.other_fixes = fixes.collect();
        problem.notes.extend(problem.other_fixes.iter().map(|fix| format!("or {}", fix.title)));
        self.kernel.report(problem);
    }

    /// The changes that make a true arc, the simplest first.
    fn repairs(&mut self, block: &Block, misfit: &MisfitArc) -> Vec<ArcRepair> {
        let state = &self.kernel.state;
        let is_plain = state.frames.is_plain() && state.polar.is_none() && state.surface.is_none();
        let words = plain_words(block);
        if !is_plain || !self.is_read_from(&words, &misfit.start, misfit) {
            return Vec::new();
        }
        let text = self.reader.text();
        let before = self.block_before(block).map(|before| plain_words(&before));
        let increment = self.control.parameters.rules.least_increment(self.kernel.state.units);
        let error = radius_error(&self.sweep_of(&words, &misfit.start, misfit));
        let mut found: Vec<ArcRepair> = Vec::new();
        let mut keep = |trial: &WordVariant, word: Word, is_before: bool, sweep: ArcSweep| {
            let is_true = error >= trial.mistake.least_error() * increment
                && radius_error(&sweep) <= trial.mistake.most_error() * increment * (1.0 + 1e-6)
                && sweep.radius_start.min(sweep.radius_end) > 10.0 * increment;
            if is_true {
                found.push(ArcRepair {
                    mistake: trial.mistake,
                    in_block_before: is_before,
                    error: radius_error(&sweep),
                    radius: sweep.radius_start,
                    degrees: sweep.sweep.abs().to_degrees(),
                    word,
                    replacement: format!("{}{}", char::from(trial.letter), trial.text),
                });
            }
        };
        for trial in trials(&words, text, misfit.plane) {
            let Some(changed) = changed(&words, &trial) else { continue };
            if let Some(sweep) = self.fit_of(&changed, &misfit.start, misfit, increment) {
                keep(&trial, words[trial.at], false, sweep);
            }
        }
        for words_before in before.iter().filter(|_| !self.kernel.state.incremental) {
            for trial in trials(words_before, text, misfit.plane) {
                let Some(start) = self.start_after(words_before, &trial, misfit) else { continue };
                if let Some(sweep) = self.fit_of(&words, &start, misfit, increment) {
                    keep(&trial, words_before[trial.at], true, sweep);
                }
            }
        }
        if found.iter().any(|repair| !repair.mistake.is_last_resort()) {
            found.retain(|repair| !repair.mistake.is_last_resort());
        }
        found.sort_by(|a, b| {
            let simpler = (a.mistake, a.in_block_before).cmp(&(b.mistake, b.in_block_before));
            simpler.then(a.error.total_cmp(&b.error)).then(a.replacement.cmp(&b.replacement))
        });
        found.dedup_by(|a, b| a.word.range == b.word.range && a.replacement == b.replacement);
        found.truncate(MAX_REPAIRS);
        found
    }

    /// True when these words alone give the end and the centre of the arc.
    fn is_read_from(&self, words: &[Word], start: &Position, misfit: &MisfitArc) -> bool {
        let (a, b, _) = misfit.plane.axes();
        let (end, arc) = self.arc_of(words, start, misfit);
        let is_same = |one: f64, other: f64| (one - other).abs() < 1e-9;
        is_same(end[a], misfit.end[a])
            && is_same(end[b], misfit.end[b])
            && arc.center == misfit.arc.center
    }

    /// The end and the centre words given by these words.
    fn arc_of(&self, words: &[Word], start: &Position, misfit: &MisfitArc) -> (Position, ArcWords) {
        let (mut end, mut arc) = (*start, misfit.arc);
        arc.center = [None; 2];
        let (a_letter, b_letter, _) = center_letters(misfit.plane);
        for word in words {
            let Some(number) = word.number() else { continue };
            let number = self.control.parameters.kept(number, self.kernel.state.units);
            let length = self.scale.length(number);
            let axis = usize::from(AXIS_OF[usize::from(word.letter)]);
            let by_increment = self.increment_axis(word);
            if let Some(axis) = by_increment.or(Some(axis).filter(|axis| *axis < 3)) {
                let is_path = by_increment.is_some() || self.kernel.state.incremental;
                let value = length * self.per_word[axis];
                end[axis] = if is_path { start[axis] + value } else { value };
            } else if word.letter == a_letter {
                arc.center[0] = Some(length);
            } else if word.letter == b_letter {
                arc.center[1] = Some(length);
            }
        }
        (end, arc)
    }

    fn sweep_of(&self, words: &[Word], start: &Position, misfit: &MisfitArc) -> ArcSweep {
        let (end, arc) = self.arc_of(words, start, misfit);
        self.kernel.sweep_by_words(start, &end, &arc)
    }

    /// The arc of the words; `None` when start and end coincide, as any centre would fit.
    fn fit_of(
        &self,
        words: &[Word],
        start: &Position,
        misfit: &MisfitArc,
        increment: f64,
    ) -> Option<ArcSweep> {
        let (a, b, _) = misfit.plane.axes();
        let (end, arc) = self.arc_of(words, start, misfit);
        let separate = (end[a] - start[a]).abs().max((end[b] - start[b]).abs());
        let has_center = arc.center.iter().any(Option::is_some);
        (separate > 2.0 * increment && has_center)
            .then(|| self.kernel.sweep_by_words(start, &end, &arc))
    }

    /// The start of the arc with a changed word in the previous block; `None` when that word does not determine the
    /// start.
    fn start_after(
        &self,
        words: &[Word],
        trial: &WordVariant,
        misfit: &MisfitArc,
    ) -> Option<Position> {
        let word = words[trial.at];
        let axis = usize::from(AXIS_OF[usize::from(word.letter)]);
        let (a, b, _) = misfit.plane.axes();
        if trial.letter != word.letter || (axis != a && axis != b) {
            return None;
        }
        let value = |number: Decimal| {
            let kept = self.control.parameters.kept(number, self.kernel.state.units);
            self.scale.length(kept) * self.per_word[axis]
        };
        if (value(word.number()?) - misfit.start[axis]).abs() > 1e-9 {
            return None;
        }
        let mut start = misfit.start;
        start[axis] = value(Decimal::parse(trial.text.as_bytes())?);
        Some(start)
    }

    /// The previous block, if it moves straight.
    fn block_before(&self, block: &Block) -> Option<Block> {
        let text = self.reader.text();
        let end = block.range.start as usize;
        let mut lines = text[end.saturating_sub(LOOK_BACK)..end]
            .iter()
            .enumerate()
            .rev()
            .filter(|(_, byte)| matches!(byte, b'\n' | b'\r'))
            .map(|(at, _)| end.saturating_sub(LOOK_BACK) + at + 1);
        // The start of the block's line, then of the lines above.
        lines.next()?;
        for start in lines.take(MAX_LINES_BACK) {
            let mut reader = BlockReader::new(&text[..end], self.file, self.control.table.lexicon);
            let mut before = Block::new();
            reader.seek(chordal_syntax::BlockPosition { offset: start as u32, line: 1 });
            if !reader.read(&mut before) || before.range.start as usize >= end {
                continue;
            }
            if before.kind != BlockKind::Words || before.words.is_empty() {
                continue;
            }
            if self.file == chordal_diagnostics::FileId(0) {
                self.look_at_range(before.range);
            }
            let curved = before.words.iter().any(|word| b"IJKR".contains(&word.letter));
            return (!curved).then_some(before);
        }
        None
    }
}

fn radius_error(sweep: &ArcSweep) -> f64 {
    (sweep.radius_start - sweep.radius_end).abs()
}

/// The end and centre words that are written as numbers.
fn plain_words(block: &Block) -> Vec<Word> {
    let is_plain = |word: &&Word| !word.comma && word.number().is_some();
    let letters = b"XYZUVWIJK";
    block
        .words
        .iter()
        .filter(is_plain)
        .filter(|word| letters.contains(&word.letter))
        .copied()
        .collect()
}

/// The words with one of them changed; `None` when the text is not a number.
fn changed(words: &[Word], trial: &WordVariant) -> Option<Vec<Word>> {
    let mut words = words.to_vec();
    let number = Decimal::parse(trial.text.as_bytes())?;
    words[trial.at].letter = trial.letter;
    words[trial.at].value = WordValue::Number(number);
    Some(words)
}

/// All candidates for all words.
fn trials(words: &[Word], text: &[u8], plane: Plane) -> Vec<WordVariant> {
    let mut trials = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let Some(number) = number_text(word, text) else { continue };
        let mut put = |mistake, letter, text: String| {
            trials.push(WordVariant { mistake, at, letter, text });
        };
        for letter in other_letters(word.letter, plane) {
            if words.iter().all(|other| other.letter != letter) {
                put(TypingError::Letter, letter, number.clone());
            }
        }
        if word.number().is_some_and(Decimal::is_zero) {
            continue;
        }
        let (sign, digits) = match number.strip_prefix(['-', '+']) {
            Some(digits) => (&number[..1], digits),
            None => ("", number.as_str()),
        };
        let other_sign = if sign == "-" { digits.to_string() } else { format!("-{digits}") };
        put(TypingError::Sign, word.letter, other_sign);
        for (mistake, digits) in digit_variants(digits) {
            put(mistake, word.letter, format!("{sign}{digits}"));
        }
        put(TypingError::Number, word.letter, "0".into());
    }
    trials
}

/// Variants of a number: exchanged digits, a moved point, another digit.
fn digit_variants(digits: &str) -> Vec<(TypingError, String)> {
    let bytes = digits.as_bytes();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap_or_default();
    let places: Vec<usize> = (0..bytes.len()).filter(|at| bytes[*at].is_ascii_digit()).collect();
    let mut found = Vec::new();
    for pair in places.windows(2).filter(|pair| bytes[pair[0]] != bytes[pair[1]]) {
        let mut swapped = bytes.to_vec();
        swapped.swap(pair[0], pair[1]);
        found.push((TypingError::Swapped, text(swapped)));
    }
    if let Some(point) = bytes.iter().position(|byte| *byte == b'.') {
        for other in [point.checked_sub(1), Some(point + 1)].into_iter().flatten() {
            if other < bytes.len() {
                let mut moved = bytes.to_vec();
                moved.swap(point, other);
                found.push((TypingError::Point, text(moved)));
            }
        }
    }
    for place in places {
        for digit in (b'0'..=b'9').filter(|digit| *digit != bytes[place]) {
            let mut other = bytes.to_vec();
            other[place] = digit;
            found.push((TypingError::Digit, text(other)));
        }
    }
    found
}

/// The letters of the plane that a letter may be mistyped for.
fn other_letters(letter: u8, plane: Plane) -> Vec<u8> {
    let (a, b, _) = plane.axes();
    let of_plane = |letters: &[u8; 3]| vec![letters[a], letters[b]];
    let others = [b"XYZ", b"IJK"].into_iter().find(|letters| letters.contains(&letter));
    others.map(of_plane).unwrap_or_default().into_iter().filter(|other| *other != letter).collect()
}

/// The number of a word as written; `None` when it contains blanks or other characters.
fn number_text(word: &Word, text: &[u8]) -> Option<String> {
    let range = TextRange::new(word.range.start + 1, word.range.end);
    let number = std::str::from_utf8(range.slice(text)).ok()?;
    (Decimal::parse(number.as_bytes()) == word.number()).then(|| number.to_string())
}
