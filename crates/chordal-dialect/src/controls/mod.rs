//! The controls, one folder each: whatever belongs to one control alone is in its folder. They are listed in
//! `chordal_machine::controls`.

use chordal_machine::ControlName;

use crate::table::ControlTable;

macro_rules! tables {
    ($($name:ident $folder:ident $word:literal,)* ; $($other:ident $other_word:literal,)*) => {
        $(pub(crate) mod $folder;)*

        /// Every control with word-address blocks, in the order of the list.
        pub const ALL: &[&ControlTable] = &[$(&$folder::TABLE),*];

        /// The table of a control; `None` if it is not programmed in word-address blocks.
        pub fn table(name: ControlName) -> Option<&'static ControlTable> {
            match name {
                $(ControlName::$name => Some(&$folder::TABLE),)*
                $(ControlName::$other => None,)*
                ControlName::Registered(_) => None,
            }
        }
    };
}

chordal_machine::controls!(tables);

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_kernel::rules::TurnCycle;

    use crate::action::{Action, OnceCode};
    use crate::table::CodeGroup;

    #[test]
    fn each_control_has_what_is_its_own() {
        for table in ALL {
            let texts = [table.name, table.title, table.source, table.default_machine];
            assert!(texts.iter().all(|text| !text.is_empty()), "{texts:?}");
            assert!(!table.g_codes.is_empty() && !table.m_codes.is_empty(), "{}", table.name);
            assert!(!table.dwell.is_empty() && !table.alarms.is_empty(), "{}", table.name);
            assert!(!table.settings.is_empty() && !table.post.end.is_empty(), "{}", table.name);
            let has_own_name = |other: &&&ControlTable| other.name == table.name;
            assert_eq!(ALL.iter().filter(has_own_name).count(), 1, "{}", table.name);
        }
    }

    #[test]
    fn codes_are_in_order_and_unique() {
        for table in ALL {
            for codes in [table.g_codes, table.m_codes] {
                let ordered = codes.windows(2).all(|pair| pair[0].code < pair[1].code);
                assert!(ordered, "{}", table.name);
            }
        }
    }

    #[test]
    fn the_group_of_motion_codes_holds_all_of_them_and_what_stays_in_force_like_them() {
        for table in ALL {
            for row in table.g_codes {
                let is_motion = row.group == CodeGroup::Motion;
                let moves = matches!(
                    row.action,
                    Action::Motion(_) | Action::Once(OnceCode::Turning(TurnCycle::LineThread))
                );
                // Probe moves are modal on some controls, one-shot on others.
                let is_free = matches!(row.action, Action::Once(OnceCode::Probe { .. }));
                assert!(is_free || is_motion == moves, "{} {}", table.name, row.name(b'G'));
            }
        }
    }
}
