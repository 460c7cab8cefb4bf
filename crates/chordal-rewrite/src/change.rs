//! What was changed, and why.

/// A change of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Line of the old text, from 1.
    pub line: u32,
    /// The words as they were; empty where something is put in.
    pub before: String,
    /// The words as they are now; empty where something is left out. Lines are separated by `\n`.
    pub after: String,
    /// Why, for people: a clause without a capital and a full stop.
    pub reason: String,
}
