//! What a turning tool has that a mill has not: its insert, how it is held, and the outline of its holder.

use crate::designation::{HolderDesignation, InsertDesignation, InsertLetter, WrittenDesignation};

/// The shape of a turning tool. Angles are rad, lengths mm, distances along X are radii.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TurningTool {
    /// The first letter of the insert's ISO code: its corner angle.
    pub insert: Option<InsertLetter>,
    /// The whole designation of the insert.
    pub insert_designation: Option<WrittenDesignation<InsertDesignation>>,
    /// That of the holder.
    pub holder_designation: Option<WrittenDesignation<HolderDesignation>>,
    /// The tip number is that of the holder's usual mounting: nobody gave it.
    pub has_usual_tip: bool,
    /// The corner angle where no letter says it.
    pub insert_angle_rad: Option<f64>,
    /// Between the main cutting edge and the feed along Z.
    pub approach_angle_rad: Option<f64>,
    /// The width of a grooving or parting tool.
    pub width_mm: Option<f64>,
    /// The slope of its front edge.
    pub lead_angle_rad: Option<f64>,
    /// Where it cuts, if its tip number does not say it.
    pub facing: Option<ToolFacing>,
    /// From the programmed point to the middle of the round shank, along X.
    pub bar_offset_mm: Option<f64>,
    /// Corners of the holder as seen from the programmed point: X, Z.
    pub holder_outline: Vec<[f64; 2]>,
}

/// The number of a tip where X is counted the other way round.
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
    /// The corner angle of the insert, rad; `None` where it is not known, or round.
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
    /// All of them.
    pub const ALL: [ToolFacing; 4] =
        [ToolFacing::Outside, ToolFacing::Inside, ToolFacing::Face, ToolFacing::BackFace];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            ToolFacing::Outside => "outside",
            ToolFacing::Inside => "inside",
            ToolFacing::Face => "face",
            ToolFacing::BackFace => "back face",
        }
    }
}
