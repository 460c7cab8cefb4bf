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

    #[test]
    fn codes_are_in_order_and_unique() {
        for table in ALL {
            for codes in [table.g_codes, table.m_codes] {
                let ordered = codes.windows(2).all(|pair| pair[0].code < pair[1].code);
                assert!(ordered, "{}", table.name);
            }
        }
    }
}
