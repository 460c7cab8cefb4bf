//! What a control refuses of a rotation about an axis in space, G68 with I, J and K, and of an offset in
//! space, G41 with I, J and K.

/// The alarms about rotation and offset in space; codes are in tenths. An alarm is `None` where the control does
/// not refuse that.
#[derive(Clone, Copy, Debug)]
pub struct SpatialRules {
    /// The codes that begin one if I, J or K is in their block.
    pub begins: &'static [u16],
    /// How many may be active at once, and the alarm of one more; `None` for any number.
    pub max_active: Option<(u32, &'static str)>,
    /// I, J, K or R is missing, or I, J and K are all 0.
    pub format: Option<&'static str>,
    /// Words of two parallel axes, such as X and U, are in its block.
    pub parallel_axes: Option<&'static str>,
    /// It begins while cutter compensation is on.
    pub in_compensation: Option<&'static str>,
    /// A length offset is on at its begin and off at its end, or the other way round.
    pub length_not_nested: Option<&'static str>,
    /// Codes that may not be in its block, and their alarm.
    pub excluded_codes: Option<(&'static [u16], &'static str)>,
    /// Codes that may not come while it is active, and their alarms.
    pub inside: &'static [(&'static [u16], &'static str)],
    /// Codes that may not be active when it begins, and their alarms; G49 ends them.
    pub before: &'static [(u16, &'static str)],
    /// Scaling begins while G41 or G42 with I, J and K, an offset in space, is active.
    pub scaling_in_offset: Option<&'static str>,
}

impl SpatialRules {
    /// The alarm of a code that comes while it is active; `None` if the code is allowed.
    pub fn refused_inside(&self, code: u16) -> Option<&'static str> {
        self.inside.iter().find(|(codes, _)| codes.contains(&code)).map(|(_, alarm)| *alarm)
    }

    /// The alarm where it begins while a code is active; `None` if the code is allowed.
    pub fn refused_after(&self, code: u16) -> Option<&'static str> {
        self.before.iter().find(|(row, _)| *row == code).map(|(_, alarm)| *alarm)
    }
}
