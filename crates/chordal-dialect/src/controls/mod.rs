//! The controls, one folder each: whatever belongs to a control stands in its folder and nowhere else.

mod fadal;
mod fanuc;
mod haas;
mod linuxcnc;
mod mitsubishi;

use crate::table::ControlTable;

/// Every control. A new one is its folder and its line here.
pub const ALL: [&ControlTable; 5] =
    [&fadal::TABLE, &haas::TABLE, &fanuc::TABLE, &mitsubishi::TABLE, &linuxcnc::TABLE];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::action::Action;
    use crate::table::Group;

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
    fn the_group_of_motion_codes_holds_all_of_them_and_nothing_else() {
        for table in ALL {
            for row in table.g_codes {
                let moves = matches!(row.action, Action::Motion(_));
                assert_eq!(row.group == Group::Motion, moves, "{} {}", table.name, row.name(b'G'));
            }
        }
    }
}
