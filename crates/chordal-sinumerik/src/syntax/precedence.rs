//! The precedence of comparisons.

/// Which of comparisons and AND, OR, XOR binds more tightly.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ComparisonPrecedence {
    /// Comparisons bind least of all, as the manual says (Job Planning 07/2010, 1.7).
    #[default]
    Last,
    /// Comparisons bind more tightly than AND, OR and XOR, as some programs are written.
    BeforeLogic,
}
