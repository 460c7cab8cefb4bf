//! What the machine builder chooses, and what the references leave open.

use chordal_machine::SettingValue;

use crate::geometry::FreeSolutionOrder;

/// Settings of a machine, each with the name that a machine file uses.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HeidenhainSettings {
    /// `MP7431`: largest difference of the two radii of an arc, mm.
    pub arc_tolerance_mm: f64,
    /// `label_nesting`: how deep subprograms may call each other.
    pub label_nesting: u32,
    /// `unset_parameter`: a parameter that was never set is an error; otherwise it is 0.
    pub unset_is_error: bool,
    /// `positive_depth`: a positive depth of a cycle is an error; otherwise the cycle works upwards.
    pub positive_depth_is_error: bool,
    /// `peck_stop_mm`: how far above the last depth the rapid of cycle 200 ends. Old controls use the set-up clearance.
    pub peck_stop_mm: Option<f64>,
    /// `free_contour_order`: in which order the solutions of free contours have their numbers.
    pub free_contour_order: FreeSolutionOrder,
    /// `projected_angle`: with a positive PROPR the plane of PLANE PROJECTED rises along X; otherwise it falls.
    pub projected_plane_rises: bool,
}

impl HeidenhainSettings {
    /// The defaults of a new control.
    pub const DEFAULT: HeidenhainSettings = HeidenhainSettings {
        arc_tolerance_mm: 0.016,
        label_nesting: 19,
        unset_is_error: true,
        positive_depth_is_error: true,
        peck_stop_mm: Some(0.2),
        free_contour_order: FreeSolutionOrder::Turning,
        projected_plane_rises: true,
    };

    /// Takes a setting of a machine file.
    ///
    /// # Errors
    /// What the setting takes, or that it is not known.
    pub fn take(&mut self, name: &str, value: &SettingValue) -> Result<(), String> {
        let number = match value {
            SettingValue::Integer(number) => Some(*number as f64),
            SettingValue::Float(number) => Some(*number),
            _ => None,
        };
        let word = match value {
            SettingValue::Text(text) => Some(text.as_str()),
            _ => None,
        };
        match (name, number, word) {
            ("MP7431", Some(mm), _) if mm > 0.0 && mm <= 1.0 => self.arc_tolerance_mm = mm,
            ("MP7431", ..) => return Err("MP7431 is a length up to 1 mm, as a number".into()),
            ("label_nesting", Some(depth), _) if (1.0..=100.0).contains(&depth) => {
                self.label_nesting = depth as u32;
            }
            ("label_nesting", ..) => return Err("label_nesting is a number, 1 to 100".into()),
            ("unset_parameter", _, Some("error")) => self.unset_is_error = true,
            ("unset_parameter", _, Some("zero")) => self.unset_is_error = false,
            ("unset_parameter", ..) => {
                return Err("unset_parameter is \"error\" or \"zero\"".into());
            }
            ("positive_depth", _, Some("error")) => self.positive_depth_is_error = true,
            ("positive_depth", _, Some("upwards")) => self.positive_depth_is_error = false,
            ("positive_depth", ..) => {
                return Err("positive_depth is \"error\" or \"upwards\"".into());
            }
            ("peck_stop_mm", Some(mm), _) if (0.0..=10.0).contains(&mm) => {
                self.peck_stop_mm = Some(mm);
            }
            ("peck_stop_mm", _, Some("clearance")) => self.peck_stop_mm = None,
            ("peck_stop_mm", ..) => {
                return Err("peck_stop_mm is a length up to 10, or \"clearance\"".into());
            }
            ("free_contour_order", _, Some("turning")) => {
                self.free_contour_order = FreeSolutionOrder::Turning;
            }
            ("free_contour_order", _, Some("along")) => {
                self.free_contour_order = FreeSolutionOrder::Along;
            }
            ("free_contour_order", ..) => {
                return Err("free_contour_order is \"turning\" or \"along\"".into());
            }
            ("projected_angle", _, Some("rising")) => self.projected_plane_rises = true,
            ("projected_angle", _, Some("falling")) => self.projected_plane_rises = false,
            ("projected_angle", ..) => {
                return Err("projected_angle is \"rising\" or \"falling\"".into());
            }
            _ => return Err(format!("this control has no setting {name} here")),
        }
        Ok(())
    }
}
