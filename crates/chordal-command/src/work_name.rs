//! Names of work coordinate systems.

/// How a control names its work coordinate systems in tables and machine files.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WorkNaming {
    /// The code of the extended systems: `G54.1`, `G154`.
    pub extended: &'static str,
    /// The number of the first extended system: 1, or 7 where the code also selects G54 to G59, as 1 to 6 (Mach3).
    pub first: u16,
    /// Whether a word E selects the system; G54 to G59 are other names of E1 to E6 then.
    pub by_e: bool,
}

impl WorkNaming {
    /// The name of an extended system in machine files; `number` counts extended systems from 1.
    pub fn extended_key(self, number: u16) -> String {
        format!("{} P{}", self.extended, u32::from(number) + u32::from(self.first) - 1)
    }
}

/// The active work coordinate system.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum WorkName {
    /// G54 to G59.
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
    /// Its number, which is the same on every control: 1 is G54 and E1, 7 is G54.1 P1, G154 P1 and G59.1; machine
    /// coordinates are 0.
    pub fn ordinal(self) -> u32 {
        match self {
            WorkName::Machine => 0,
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
