//! What a control refuses of a rotation about an axis in space, G68 with I, J and K, and of an offset in
//! space, G41 with I, J and K.

/// The alarms of rotation and offset in space. Codes are ten times their number.
#[derive(Clone, Copy, Debug)]
pub struct SpatialRules {
    /// The codes that begin one, with I, J or K in their block.
    pub begins: &'static [u16],
    /// How many may be active at once, and the alarm of one more.
    pub most: Option<(u32, &'static str)>,
    /// A word of I, J, K and R is missing, or I, J and K are all 0.
    pub format: Option<&'static str>,
    /// Two axes that are parallel, such as X and U, in one block with it.
    pub parallel_axes: Option<&'static str>,
    /// It begins while cutter compensation is on.
    pub in_compensation: Option<&'static str>,
    /// A length offset that does not begin and end on the same side of it.
    pub length_not_nested: Option<&'static str>,
    /// Codes that may not be in its block.
    pub excluded_codes: Option<(&'static [u16], &'static str)>,
    /// Codes that may not come while it is active.
    pub inside: &'static [(&'static [u16], &'static str)],
    /// Codes that may not be active when it begins; G49 ends them.
    pub before: &'static [(u16, &'static str)],
    /// G41 or G42 with I, J and K is an offset in space, and scaling may not begin while it is on.
    pub scaling_in_offset: Option<&'static str>,
}

impl SpatialRules {
    /// The alarm of a code while it is active.
    pub fn refused_inside(&self, code: u16) -> Option<&'static str> {
        self.inside.iter().find(|(codes, _)| codes.contains(&code)).map(|(_, alarm)| *alarm)
    }

    /// The alarm where it begins while a code is active.
    pub fn refused_after(&self, code: u16) -> Option<&'static str> {
        self.before.iter().find(|(row, _)| *row == code).map(|(_, alarm)| *alarm)
    }
}
