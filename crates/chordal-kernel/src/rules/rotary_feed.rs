//! What F measures when rotary axes move, as data.

use chordal_command::{Move, RotaryLength, Units};

/// What F measures on a straight cut with rotary axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RotaryFeed {
    /// X, Y and Z only; the rotary axes arrive with them. Degrees per minute when only rotary axes move (LinuxCNC).
    LinearAxes,
    /// The vector of all axes, a degree counted as one unit of length, mm or inch (Fanuc B-63174EN 4.2).
    DegreesAsUnits,
    /// The vector of all axes, a degree counted as 1 mm in inches too (Grbl, which computes in mm).
    DegreesAsMillimetres,
    /// The vector of all axes, angles counted as the arc on a diameter that a setting gives (Haas Settings 34 and 79).
    OnDiameter,
}

/// The rules of feeds with rotary axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RotaryFeedRules {
    /// What F measures.
    pub measure: RotaryFeed,
    /// The diameters of the 4th and 5th axis for [`RotaryFeed::OnDiameter`], mm; `None` when the machine file gives none.
    pub diameters_mm: [Option<f64>; 2],
    /// B is the 5th axis, because the machine has an A.
    pub has_a: bool,
    /// The names of the settings of these diameters in a machine file.
    pub diameter_names: [&'static str; 2],
}

impl RotaryFeedRules {
    /// The rules of a control whose manual says nothing about it.
    pub const COMMON: RotaryFeedRules = RotaryFeedRules {
        measure: RotaryFeed::LinearAxes,
        diameters_mm: [None; 2],
        has_a: false,
        diameter_names: ["rotary_diameter_4th", "rotary_diameter_5th"],
    };

    /// How the angles of a move become lengths in a program of these units; `None` when they do not count. The error
    /// is the axis without a diameter: 0 for the 4th, 1 for the 5th.
    pub fn length_of(&self, motion: &Move, units: Units) -> Result<Option<RotaryLength>, usize> {
        let by_degrees = |units| Ok(Some(RotaryLength::DegreeAsUnit(units)));
        match self.measure {
            RotaryFeed::LinearAxes => return Ok(None),
            RotaryFeed::DegreesAsUnits => return by_degrees(units),
            RotaryFeed::DegreesAsMillimetres => return by_degrees(Units::Millimetre),
            RotaryFeed::OnDiameter => {}
        }
        let mut diameters_nm = [0; 3];
        for (axis, diameter_nm) in diameters_nm.iter_mut().enumerate() {
            if motion.from[axis + 3] == motion.to[axis + 3] {
                continue;
            }
            // The first rotary axis of the machine is the 4th: A, or B where there is no A.
            let ordinal = usize::from(axis == 2 || axis == 1 && self.has_a);
            let diameter_mm = self.diameters_mm[ordinal].ok_or(ordinal)?;
            *diameter_nm = (diameter_mm * 1e6).round() as u32;
        }
        Ok(Some(RotaryLength::ArcOnCylinder { diameters_nm }))
    }

    /// The common rules with another measure.
    pub const fn measured(measure: RotaryFeed) -> RotaryFeedRules {
        RotaryFeedRules { measure, ..RotaryFeedRules::COMMON }
    }
}
