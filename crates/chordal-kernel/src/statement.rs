//! A statement of a program as the kernel sees it: the spans of its words and their names.

use chordal_command::AxisMask;
use chordal_diagnostics::Span;
use chordal_geometry::Plane;

/// The meaning of a word of a statement, independent of its spelling in the language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WordMeaning {
    /// Coordinates of these axes.
    Axes(AxisMask),
    /// The centre of an arc.
    Center,
    /// The centre of an arc or its radius.
    CenterOrRadius,
    /// The end of an arc in this plane, and its centre.
    EndAndCenter(Plane),
    /// The height of a turn of a spiral, normal to the plane.
    Height(Plane),
    /// The change of a spiral's radius per turn; a step of a cycle or a pocket.
    Increment,
    /// The number of turns, holes or passes.
    Count,
    /// The angle of a rotation.
    Angle,
    /// Additional turns of a spiral.
    Pitches,
    /// Number of the tool length offset.
    LengthOffset,
    /// The first circle of a pocket.
    FirstCircle,
    /// The last circle of a pocket.
    LastCircle,
    /// The distance between two rows of a pocket.
    Stepover,
    /// The distance between two rows of a pocket, or the depth of a pass.
    Steps,
}

/// A statement of a program: a block, or a line of a conversational language.
pub trait Statement {
    /// The whole statement.
    fn span(&self) -> Span;
    /// The words with this meaning; the whole statement when it has none.
    fn words(&self, what: WordMeaning) -> Span;
    /// The spelling of such a word in the language: `Q`.
    fn name(&self, what: WordMeaning) -> &'static str;
    /// The spelling of the centre words of the two axes of a plane: `I` and `J`.
    fn center_names(&self, plane: Plane) -> [&'static str; 2];
    /// The number of such a word as written; `None` when the statement has none.
    fn number(&self, what: WordMeaning) -> Option<String>;
    /// True when the statement has a word with this meaning.
    fn has(&self, what: WordMeaning) -> bool;
    /// True when the statement gives a feed.
    fn has_feed(&self) -> bool;
}
