//! The page of a control whose language has no tables of codes.

use chordal::control::{ControlProfile, VocabularyGroup};

use super::{HEAD, cell, diagnostics, table_row};

/// The words of its language, and its messages.
pub fn page(profile: &ControlProfile, groups: &[VocabularyGroup]) -> String {
    let mut text = format!("# {}\n\n{HEAD}\nFrom {}.\n", profile.title, profile.source);
    for group in groups {
        text += &format!("\n## {}\n\n| word | |\n|---|---|\n", group.title);
        for word in &group.words {
            text += &table_row(&[format!("`{}`", word.word), cell(&word.meaning)]);
        }
    }
    if !profile.alarms.is_empty() {
        text += "\n## Messages of the control\n\n| message | problem |\n|---|---|\n";
        for (code, alarm) in profile.alarms {
            let info = code.info();
            let problem = format!(
                "[{}](../diagnostics.md#{}) {}",
                info.id,
                diagnostics::anchor(info),
                cell(info.summary)
            );
            text += &table_row(&[cell(alarm), problem]);
        }
    }
    text
}
