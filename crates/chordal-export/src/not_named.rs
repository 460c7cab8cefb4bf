//! What pictures and drawings say of axes that a program does not name.

use chordal::control::AxisMask;
use chordal::path::NotNamed;

/// `Y is never named; drawn at Y0`, `Z is not known in any cut; drawn at Z0`.
pub(crate) fn not_named_texts(axes: NotNamed) -> Vec<String> {
    let said = |axes: AxisMask, why: &str| {
        let letters: Vec<String> = axes.iter().map(|axis| axis.letter().to_string()).collect();
        let zeros: Vec<String> = letters.iter().map(|letter| format!("{letter}0")).collect();
        let verb = if letters.len() == 1 { "is" } else { "are" };
        let text =
            || format!("{} {verb} {why}; drawn at {}", letters.join(" and "), zeros.join(" "));
        (!letters.is_empty()).then(text)
    };
    let both = [said(axes.never, "never named"), said(axes.in_no_cut, "not known in any cut")];
    both.into_iter().flatten().collect()
}
