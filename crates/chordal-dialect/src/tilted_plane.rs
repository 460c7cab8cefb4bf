//! What a control refuses of tilted planes (G68.2, G268) and of the codes that turn the tool to them (G53.1).

/// The alarms about tilted planes. An alarm is `None` where its text is not known.
#[derive(Clone, Copy, Debug, Default)]
pub struct TiltedPlaneRules {
    /// A plane is defined while one is in force.
    pub twice: Option<&'static str>,
    /// The words do not define a plane.
    pub format: Option<&'static str>,
    /// The tool turns to a plane, and none is in force.
    pub without_plane: Option<&'static str>,
    /// The axes of the machine cannot bring the tool upright on it.
    pub unreachable: Option<&'static str>,
    /// A rotary axis is named while I, J and K give the direction of the tool (G43.5).
    pub rotary_with_vector: Option<&'static str>,
}
