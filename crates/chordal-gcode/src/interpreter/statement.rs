//! A block as a statement of the kernel: the meaning of its letters.

use chordal_diagnostics::{FileId, Span, TextRange};
use chordal_geometry::Plane;
use chordal_kernel::{Statement, WordMeaning};
use chordal_machine::Axis;
use chordal_syntax::{Block, Letters};

/// A block of a file.
#[derive(Clone, Copy)]
pub(super) struct BlockStatement<'b> {
    pub block: &'b Block,
    pub file: FileId,
}

/// Names of the letters, by their position in the alphabet.
const NAMES: [&str; 26] = [
    "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S",
    "T", "U", "V", "W", "X", "Y", "Z",
];

fn letter_of_axis(axis: usize) -> u8 {
    Axis::ALL[axis].letter() as u8
}

/// The letters with a meaning; the first is its name in messages.
fn letters(what: WordMeaning) -> Vec<u8> {
    match what {
        WordMeaning::Axes(axes) => axes.iter().map(|axis| axis.letter() as u8).collect(),
        WordMeaning::Center => b"IJK".to_vec(),
        WordMeaning::CenterOrRadius => b"IJKR".to_vec(),
        WordMeaning::EndAndCenter(plane) => {
            let (a, b, _) = plane.axes();
            [letter_of_axis(a), letter_of_axis(b), b'I', b'J', b'K'].to_vec()
        }
        WordMeaning::Height(plane) => vec![b"IJK"[plane.axes().2]],
        WordMeaning::Increment => vec![b'Q'],
        WordMeaning::Count => vec![b'L'],
        WordMeaning::Angle => vec![b'R'],
        WordMeaning::Pitches => vec![b'P'],
        WordMeaning::LengthOffset => vec![b'H'],
        WordMeaning::FirstCircle => vec![b'I'],
        WordMeaning::LastCircle => vec![b'K'],
        WordMeaning::Stepover => b"IJ".to_vec(),
        WordMeaning::Steps => b"IJQ".to_vec(),
    }
}

fn set_of(what: WordMeaning) -> Letters {
    let mut set = Letters::NONE;
    letters(what).into_iter().for_each(|letter| set.insert(letter));
    set
}

impl BlockStatement<'_> {
    /// The span of the words with some letters, or of the whole block without any.
    pub fn span_of(&self, letters: Letters) -> Span {
        let words = self.block.words.iter().filter(|word| letters.has(word.letter));
        let range = words.map(|word| word.range).reduce(TextRange::cover);
        range.unwrap_or(self.block.range).in_file(self.file)
    }
}

impl Statement for BlockStatement<'_> {
    fn span(&self) -> Span {
        self.block.range.in_file(self.file)
    }

    #[cold]
    fn words(&self, what: WordMeaning) -> Span {
        self.span_of(set_of(what))
    }

    fn name(&self, what: WordMeaning) -> &'static str {
        letters(what).first().map_or("", |letter| NAMES[usize::from(letter - b'A')])
    }

    fn center_names(&self, plane: Plane) -> [&'static str; 2] {
        let (a, b, _) = plane.axes();
        [a, b].map(|axis| ["I", "J", "K"][axis])
    }

    fn number(&self, what: WordMeaning) -> Option<String> {
        let letter = *letters(what).first()?;
        Some(self.block.last(letter)?.number()?.to_string())
    }

    fn has(&self, what: WordMeaning) -> bool {
        self.block.letters().meets(set_of(what))
    }

    #[inline]
    fn has_feed(&self) -> bool {
        self.block.letters().has(b'F')
    }
}
