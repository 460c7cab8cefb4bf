//! Names of work coordinate systems.

/// How a control names its work coordinate systems in tables and machine files.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorkNaming {
    /// The code of the extended systems: `G54.1`, `G154`; empty where each system after the fourth has a code of its own,
    /// G505 for the fifth (Sinumerik).
    pub extended: &'static str,
    /// The number of the first extended system: 1, or 7 where the code also selects G54 to G59, as 1 to 6 (Mach3); 507
    /// where each has a code of its own.
    pub first: u16,
    /// Whether a word E selects the system; G54 to G59 are other names of E1 to E6 then.
    pub by_e: bool,
}

impl WorkNaming {
    /// The name of an extended system in machine files; `number` counts extended systems from 1.
    pub fn extended_key(self, number: u16) -> String {
        let number = u32::from(number) + u32::from(self.first) - 1;
        match self.extended {
            "" => format!("G{number}"),
            code => format!("{code} P{number}"),
        }
    }

    /// The name in machine files of the system with this ordinal ([`WorkName::ordinal`]); `None` for 0.
    pub fn key_of_ordinal(self, ordinal: u16) -> Option<String> {
        let beyond = ordinal.saturating_sub(6);
        let has_points = self.extended == "G59" && self.first == 1;
        let is_own_code = self.extended.is_empty() && ordinal > 4;
        match ordinal {
            0 => None,
            _ if self.by_e => Some(format!("E{ordinal}")),
            _ if is_own_code => Some(format!("G{}", 500 + u32::from(ordinal))),
            1..=6 => Some(format!("G{}", 53 + ordinal)),
            _ if has_points => Some(WorkName::G59(beyond).key(self)),
            _ => Some(self.extended_key(beyond)),
        }
    }
}

/// The active work coordinate system.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum WorkName {
    /// G54 to G59; on a Sinumerik G54 to G57, G505 to G599, and G500 for none.
    G(u16),
    /// G54.1 P or G154 P.
    Extended(u16),
    /// LinuxCNC G59.1 to G59.3.
    G59(u16),
    /// Fadal E.
    E(u16),
    /// Machine coordinates (Fadal E0).
    Machine,
}

impl WorkName {
    /// Its number, which is the same on every control: 1 is G54 and E1, 7 is G54.1 P1, G154 P1, G59.1 and G507; machine
    /// coordinates and G500 are 0.
    pub fn ordinal(self) -> u32 {
        match self {
            WorkName::Machine => 0,
            WorkName::G(number @ 500..) => u32::from(number) - 500,
            WorkName::G(number) => u32::from(number).saturating_sub(53),
            WorkName::Extended(number) | WorkName::G59(number) => u32::from(number) + 6,
            WorkName::E(number) => u32::from(number),
        }
    }

    /// The system with this ordinal; `None` for 0.
    pub fn of_ordinal(number: u16) -> Option<WorkName> {
        match number {
            0 => None,
            1..=6 => Some(WorkName::G(number + 53)),
            _ => Some(WorkName::Extended(number - 6)),
        }
    }

    /// The name in a machine file; extended systems have the control's own code.
    pub fn key(self, naming: WorkNaming) -> String {
        match self {
            WorkName::G(number) => format!("G{number}"),
            WorkName::Extended(number) => naming.extended_key(number),
            WorkName::G59(number) => format!("G59.{number}"),
            WorkName::E(number) => format!("E{number}"),
            WorkName::Machine => "machine".into(),
        }
    }

    /// The name in the control's table of work offsets.
    pub fn table_key(self, naming: WorkNaming) -> String {
        match self {
            WorkName::G(number) if naming.by_e => format!("E{}", number.saturating_sub(53)),
            other => other.key(naming),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_system_has_one_number_on_all_controls() {
        let fanuc = WorkNaming { extended: "G54.1", first: 1, by_e: false };
        let sinumerik = WorkNaming { extended: "", first: 507, by_e: false };
        let linuxcnc = WorkNaming { extended: "G59", first: 1, by_e: false };
        let keys =
            |ordinal| [fanuc, sinumerik, linuxcnc].map(|names| names.key_of_ordinal(ordinal));
        let some = |names: [&str; 3]| names.map(|name| Some(name.to_string()));
        assert_eq!(keys(4), some(["G57", "G57", "G57"]));
        assert_eq!(keys(5), some(["G58", "G505", "G58"]));
        assert_eq!(keys(8), some(["G54.1 P2", "G508", "G59.2"]));
        assert_eq!(keys(0), [None, None, None]);
        assert_eq!(WorkName::G(508).ordinal(), WorkName::Extended(2).ordinal());
        assert_eq!(WorkName::G(505).ordinal(), WorkName::G(58).ordinal());
        assert_eq!(WorkName::G(500).ordinal(), WorkName::Machine.ordinal());
        assert_eq!(WorkName::Extended(2).key(sinumerik), "G508");
    }
}
