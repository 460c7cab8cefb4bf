//! How a control takes mirror, scaling and rotation of its coordinates.

/// The rules of frames.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrameRules {
    /// In G91 the angle of a rotation is added to the one in force.
    pub angle_adds: bool,
    /// The angle of a rotation whose block gives none, degrees.
    pub omitted_angle_deg: f64,
    /// The angle of a rotation is modal: one that is left out is the last.
    pub angle_is_kept: bool,
    /// A and B are the centre of a rotation, in X and Y of the XY plane (Mach3).
    pub rotation_center_by_ab: bool,
    /// The words of the axes are the factors of a scaling about the work zero, and only lines and arcs with
    /// I, J, K are known to be scaled (Mach3).
    pub factors_by_axes: bool,
    /// Polar end points are counted from where the tool stood when they came into force, and only straight
    /// moves of the XY plane in G90 are known to have them (Mach3).
    pub polar_about_start: bool,
    /// The centre of a scaling is counted from the present place in G91.
    pub center_by_mode: bool,
    /// Scaling without a centre on an axis leaves that axis alone; otherwise its centre is the present place.
    pub scales_named_axes: bool,
    /// Rotary axes are scaled with the others.
    pub scales_rotary: bool,
    /// The factors of X, Y and Z where the block gives none.
    pub omitted_factors: [f64; 3],
    /// I, J and K give a factor of an axis each.
    pub factors_by_vector: bool,
    /// The smallest and the largest factor, without sign.
    pub factor_range: [f64; 2],
    /// An arc while the axes of its plane have different factors.
    pub unequal_arcs: UnequalArcs,
    /// Spirals and cones are refused while coordinates are mirrored or scaled.
    pub refuses_spirals: bool,
    /// The plane may change while a rotation is in force.
    pub plane_change: bool,
    /// Another work coordinate system leaves the centre of a rotation where it is on the machine.
    pub rotation_stays: bool,
    /// G10 L2 R turns a work coordinate system, and arcs of the other planes turn with it.
    pub work_rotation: bool,
    /// A frame may come into force while compensation is on.
    pub in_compensation: bool,
    /// A rotation may end while compensation is on.
    pub rotation_ends_in_compensation: bool,
    /// A mirror may end while compensation is on.
    pub mirror_ends_in_compensation: bool,
    /// The control has the option of scaling.
    pub has_scaling: bool,
    /// The control has the option of rotation.
    pub has_rotation: bool,
    /// The largest angle of a rotation, without sign, degrees.
    pub largest_angle_deg: f64,
    /// The largest coordinate that a scaling may give, in least increments; 0 for no limit.
    pub largest_scaled_increments: f64,
    /// Cycles may drill along an axis that is mirrored or scaled.
    pub cycles_along_scaled: bool,
    /// Another work coordinate system may be chosen while a frame is active.
    pub work_change: bool,
}

/// What becomes of an arc whose plane is scaled unequally.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnequalArcs {
    /// Ends and centre go by their own factors, a radius by the larger one; the end is judged as always.
    Judged,
    /// The control refuses it.
    Refused,
}

impl FrameRules {
    /// What most controls share; a table names only what it has otherwise.
    pub const COMMON: FrameRules = FrameRules {
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
