//! A statement of a program as the kernel sees it: where its words stand and what they are called.

use chordal_command::AxisMask;
use chordal_diagnostics::Span;
use chordal_geometry::Plane;

/// What a word of a statement says, whatever the language writes for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WordMeaning {
    /// The place on these axes.
    Axes(AxisMask),
    /// The centre of an arc.
    Center,
    /// The centre of an arc or its radius.
    CenterOrRadius,
    /// The end of an arc in this plane, and its centre.
    EndAndCenter(Plane),
    /// The height of a turn, of a spiral whose axis is the third of the plane.
    Height(Plane),
    /// The change of a spiral's radius in a turn; a step of a cycle or a pocket.
    Increment,
    /// How many turns, holes or passes.
    Count,
    /// The angle of a rotation.
    Angle,
    /// Further turns of a spiral.
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

/// A statement of a program: a block, a line, whatever the language is made of.
pub trait Statement {
    /// The whole statement.
    fn span(&self) -> Span;
    /// The words that say something; the whole statement where it has none of them.
    fn words(&self, what: WordMeaning) -> Span;
    /// How the language calls such a word: `Q`.
    fn name(&self, what: WordMeaning) -> &'static str;
    /// How it calls the centre words of the two axes of a plane: `I` and `J`.
    fn center_names(&self, plane: Plane) -> [&'static str; 2];
    /// The number of such a word as written, where the statement has one.
    fn number(&self, what: WordMeaning) -> Option<String>;
    /// The statement has a word that says it.
    fn has(&self, what: WordMeaning) -> bool;
    /// The statement gives a feed.
    fn has_feed(&self) -> bool;
}
