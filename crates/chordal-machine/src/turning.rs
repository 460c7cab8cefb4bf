//! The data of turning tools: the insert, its mounting, and the outline of the holder.

use crate::designation::{HolderDesignation, InsertDesignation, InsertLetter, WrittenDesignation};

/// The shape of a turning tool. Angles are in rad, lengths in mm, distances along X are radii. `None`: not given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurningTool {
    /// The first letter of the ISO code of the insert, which determines its corner angle.
    pub insert: Option<InsertLetter>,
    /// The whole designation of the insert.
    pub insert_designation: Option<WrittenDesignation<InsertDesignation>>,
    /// The whole designation of the holder.
    pub holder_designation: Option<WrittenDesignation<HolderDesignation>>,
    /// The tip number is not given, but that of the usual mounting of the holder.
    pub has_usual_tip: bool,
    /// The corner angle if no letter is given.
    pub insert_angle_rad: Option<f64>,
    /// The angle between the main cutting edge and the feed along Z.
    pub approach_angle_rad: Option<f64>,
    /// The width of a grooving or parting tool.
    pub width_mm: Option<f64>,
    /// The slope of its front edge.
    pub lead_angle_rad: Option<f64>,
    /// Where it cuts, if its tip number does not determine it.
    pub facing: Option<ToolFacing>,
    /// The distance from the programmed point to the axis of the round shank, along X.
    pub bar_offset_mm: Option<f64>,
    /// The corners of the holder relative to the programmed point: X, Z.
    pub holder_outline: Vec<[f64; 2]>,
}

/// The tip number with X in the opposite direction.
pub const fn mirrored_tip(tip: u32) -> u32 {
    match tip {
        1 => 4,
        2 => 3,
        3 => 2,
        4 => 1,
        6 => 8,
        8 => 6,
        same => same,
    }
}

impl TurningTool {
    /// The corner angle of the insert, rad; `None` if it is not known or the insert is round.
    pub fn corner_rad(&self) -> Option<f64> {
        let of_letter = self.insert.and_then(InsertLetter::corner_degrees).map(f64::to_radians);
        self.insert_angle_rad.or(of_letter)
    }
}

/// Where a grooving tool cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ToolFacing {
    /// From outside towards the axis.
    Outside,
    /// In a bore, away from the axis.
    Inside,
    /// Into a face towards −Z.
    Face,
    /// Into a back face towards +Z.
    BackFace,
}

impl ToolFacing {
    /// All values.
    pub const ALL: [ToolFacing; 4] =
        [ToolFacing::Outside, ToolFacing::Inside, ToolFacing::Face, ToolFacing::BackFace];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            ToolFacing::Outside => "outside",
            ToolFacing::Inside => "inside",
            ToolFacing::Face => "face",
            ToolFacing::BackFace => "back face",
        }
    }
}
