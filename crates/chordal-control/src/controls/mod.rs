//! The five controls, each a table in its own file.

mod compensation;
mod fadal;
mod fanuc;
mod haas;
mod linuxcnc;
mod macro_b;
mod mitsubishi;

use chordal_machine::ControlName;

use crate::table::ControlTable;

/// All tables.
pub const ALL: [&ControlTable; 5] =
    [&fadal::FADAL, &haas::HAAS, &fanuc::FANUC, &mitsubishi::MITSUBISHI, &linuxcnc::LINUXCNC];

/// The table of a control. The one place where a name becomes a table.
pub fn table(name: ControlName) -> &'static ControlTable {
    match name {
        ControlName::Fadal => &fadal::FADAL,
        ControlName::Haas => &haas::HAAS,
        ControlName::Fanuc => &fanuc::FANUC,
        ControlName::Mitsubishi => &mitsubishi::MITSUBISHI,
        ControlName::Linuxcnc => &linuxcnc::LINUXCNC,
    }
}

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
