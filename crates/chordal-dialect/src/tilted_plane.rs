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
    /// The direction of the tool is given by a vector while the frame of the tip stays (G43.5 with WKP 1).
    pub vector_in_fixed_frame: Option<&'static str>,
    /// An arc in a frame of the tip that stays, while another axis turns than a table about the normal of its plane.
    pub arc_while_turning: Option<&'static str>,
}
