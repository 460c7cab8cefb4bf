//! Names of labels.

use super::ast::LabelName;
use super::cursor::TokenCursor;
use super::tokens::{KlartextToken, KlartextTokenKind};

/// A number, a text or a parameter as the name of a label.
pub fn label_name(cursor: &mut TokenCursor<'_>) -> Option<LabelName> {
    if let Some(KlartextToken { kind: KlartextTokenKind::Text(text), .. }) = cursor.peek() {
        cursor.take();
        return Some(LabelName::Text(text.clone()));
    }
    if let Some(name) = cursor.take_parameter() {
        return Some(LabelName::Parameter(name));
    }
    cursor.take_whole().map(LabelName::Number)
}
