//! What the machine builder chooses.

use chordal_machine::SettingValue;

/// Choices of the machine builder that the references leave open or that differ between machines.
#[derive(Clone, Copy, Debug)]
pub struct SinumerikSettings {
    /// M6 changes the tool (MD22550 = 1); otherwise T does.
    pub tool_change_by_m6: bool,
    /// Number of R parameters (MD28050).
    pub r_parameters: u32,
    /// What a name is that no program and no file of definitions has.
    pub undefined_names: UndefinedNames,
}

/// What a name is that no program and no file of definitions has: the control may have its program or its variable in
/// a memory that is not given here.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UndefinedNames {
    /// Perhaps a program or user datum of the control: a warning, and the run is not verified from there on.
    Warning,
    /// There is nothing else on the control: its alarm.
    Alarm,
}

impl SinumerikSettings {
    /// The defaults of the machine data.
    pub const DEFAULT: SinumerikSettings = SinumerikSettings {
        tool_change_by_m6: true,
        r_parameters: 100,
        undefined_names: UndefinedNames::Warning,
    };

    /// The defaults of a lathe: T changes the tool.
    pub const LATHE: SinumerikSettings =
        SinumerikSettings { tool_change_by_m6: false, ..SinumerikSettings::DEFAULT };

    /// Takes a setting of a machine file by the name of its machine datum.
    ///
    /// # Errors
    /// What the datum takes, or that it is not known.
    pub fn take(&mut self, name: &str, value: &SettingValue) -> Result<(), String> {
        if name == "undefined_names" {
            self.undefined_names = match value {
                SettingValue::Text(text) if text == "warning" => UndefinedNames::Warning,
                SettingValue::Text(text) if text == "alarm" => UndefinedNames::Alarm,
                _ => return Err("undefined_names is \"warning\" or \"alarm\"".into()),
            };
            return Ok(());
        }
        let number = match value {
            SettingValue::Integer(number) => Some(*number),
            _ => None,
        };
        match (name, number) {
            ("MD22550", Some(number @ (0 | 1))) => self.tool_change_by_m6 = number == 1,
            ("MD22550", _) => return Err("MD22550 is 1 (M6 changes the tool) or 0 (T does)".into()),
            ("MD28050", Some(number @ 0..=32_535)) => self.r_parameters = number as u32,
            ("MD28050", _) => {
                return Err("MD28050 is the number of R parameters, 0 to 32535".into());
            }
            _ => return Err(format!("Sinumerik 840D has no setting {name} here")),
        }
        Ok(())
    }
}
