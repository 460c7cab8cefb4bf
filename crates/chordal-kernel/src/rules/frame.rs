//! The rules of a control for mirror, scaling and rotation of coordinates, as data.

/// The rules of frames.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrameRules {
    /// Which of several positions of the rotary axes is taken where a plane gives their direction alone.
    pub rotary_choice: RotaryChoice,
    /// Under tool centre point control the axes of the program stay those of the machine, and end points are where the tip
    /// is after the tables have turned; otherwise they ride on the table (Fanuc No. 19696#5, WKP).
    pub tip_frame_stays: bool,
    /// In G91 the angle of a rotation is added to the active one.
    pub angle_adds: bool,
    /// The angle of a rotation without an angle word, degrees.
    pub omitted_angle_deg: f64,
    /// The angle of a rotation is modal: an omitted one is the last one.
    pub angle_is_kept: bool,
    /// A and B are the centre of a rotation, in X and Y of the XY plane (Mach3).
    pub rotation_center_by_ab: bool,
    /// The axis words are the factors of a scaling about the work zero; only for lines and arcs with I, J, K is
    /// it known that they are scaled (Mach3).
    pub factors_by_axes: bool,
    /// Polar end points are measured from the position at which they came into force, and only straight
    /// moves of the XY plane in G90 are known to use them (Mach3).
    pub polar_about_start: bool,
    /// In G91 the centre of a scaling is relative to the present position.
    pub center_by_mode: bool,
    /// Scaling does not act on an axis without a centre; otherwise its centre is the present position.
    pub scales_named_axes: bool,
    /// Rotary axes are scaled with the others.
    pub scales_rotary: bool,
    /// The factors of X, Y and Z when the block gives none.
    pub omitted_factors: [f64; 3],
    /// I, J and K give the factors of X, Y and Z.
    pub factors_by_vector: bool,
    /// The limits of the absolute value of a factor; the limits themselves are refused.
    pub factor_range: [f64; 2],
    /// What happens to an arc when the axes of its plane have different factors.
    pub unequal_arcs: UnequalArcs,
    /// Spirals and cones are refused while coordinates are mirrored or scaled.
    pub refuses_spirals: bool,
    /// The plane may change while a rotation is active.
    pub plane_change: bool,
    /// A change of the work coordinate system leaves the centre of a rotation at its machine position.
    pub rotation_stays: bool,
    /// G10 L2 R rotates a work coordinate system, and arcs of the other planes with it.
    pub work_rotation: bool,
    /// A frame may become active while compensation is on.
    pub in_compensation: bool,
    /// A rotation may end while compensation is on.
    pub rotation_ends_in_compensation: bool,
    /// A mirror may end while compensation is on.
    pub mirror_ends_in_compensation: bool,
    /// The control has the option of scaling.
    pub has_scaling: bool,
    /// The control has the option of rotation.
    pub has_rotation: bool,
    /// The largest absolute angle of a rotation, degrees.
    pub largest_angle_deg: f64,
    /// The largest coordinate that a scaling may give, in least increments; 0 for no limit.
    pub largest_scaled_increments: f64,
    /// Cycles may drill along an axis that is mirrored or scaled.
    pub cycles_along_scaled: bool,
    /// Another work coordinate system may be chosen while a frame is active.
    pub work_change: bool,
}

/// What happens to an arc when the axes of its plane have different factors.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnequalArcs {
    /// Ends and centre are scaled by their own factors, a radius by the larger one; the radii are checked as usual.
    Judged,
    /// The control refuses it.
    Refused,
}

/// Which of several positions of the rotary axes a control takes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RotaryChoice {
    /// The smallest movement of the master, then of the other axis; then the one nearest to 0 (Fanuc A-79348E p.28).
    Master,
    /// Near the pole the side on which the second axis is (Mitsubishi M700 programming manual p.485).
    PoleSide {
        /// How near to the pole, rad (#7907).
        near_rad: f64,
    },
    /// The smallest sum of movements.
    LeastMovement,
}

impl FrameRules {
    /// The rules most controls share; a table names only its differences.
    pub const COMMON: FrameRules = FrameRules {
        rotary_choice: RotaryChoice::LeastMovement,
        tip_frame_stays: false,
        angle_adds: false,
        omitted_angle_deg: 0.0,
        angle_is_kept: false,
        rotation_center_by_ab: false,
        factors_by_axes: false,
        polar_about_start: false,
        center_by_mode: false,
        scales_named_axes: false,
        scales_rotary: false,
        omitted_factors: [1.0; 3],
        factors_by_vector: true,
        factor_range: [0.0, 10_000.0],
        unequal_arcs: UnequalArcs::Judged,
        refuses_spirals: false,
        plane_change: false,
        rotation_stays: false,
        work_rotation: false,
        in_compensation: false,
        rotation_ends_in_compensation: true,
        mirror_ends_in_compensation: true,
        has_scaling: true,
        has_rotation: true,
        largest_angle_deg: f64::INFINITY,
        largest_scaled_increments: 0.0,
        cycles_along_scaled: true,
        work_change: false,
    };
}
