//! The macro language of Fadal CNC 88.

use crate::vocabulary::*;

/// Section 18. Macro lines hold nothing else; of comparisons no value is taken.
pub(super) static MACROS: MacroRules = MacroRules {
    form: MacroForm::Lines,
    fix: RoundingRule::TowardZero,
    modulo_positive: false,
    comparison_is_value: false,
    mixed_blocks: false,
    index_tolerance: 0.5,
    ..MacroRules::NONE
};
