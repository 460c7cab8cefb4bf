//! Names of labels.

use super::ast::KlartextLabel;
use super::cursor::TokenCursor;
use super::tokens::{KlartextToken, KlartextTokenKind};

/// A number, a text or a parameter as the name of a label.
pub fn label_name(cursor: &mut TokenCursor<'_>) -> Option<KlartextLabel> {
    if let Some(KlartextToken { kind: KlartextTokenKind::Text(text), .. }) = cursor.peek() {
        cursor.take();
        return Some(KlartextLabel::Text(text.clone()));
    }
    if let Some(name) = cursor.take_parameter() {
        return Some(KlartextLabel::Parameter(name));
    }
    cursor.take_whole().map(KlartextLabel::Number)
}
