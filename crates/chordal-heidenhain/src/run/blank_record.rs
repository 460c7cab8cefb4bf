//! What is known of the blank of BLK FORM, and of what was cut of it.

/// Cuts that are remembered; a program with more is not checked further.
const MAX_CUTS: usize = 20_000;

/// How deep in the blank a point must be, mm.
const INSIDE_MM: f64 = 0.01;

/// By how much more than its radius a tool counts as having cut, mm.
const ROOM_MM: f64 = 0.5;

/// The blank, and what was cut of it; coordinates of the preset, mm.
#[derive(Clone, Debug, Default)]
pub struct BlankRecord {
    /// Its smallest and its largest corner; `None` where it is not known.
    pub corners: Option<[[f64; 3]; 2]>,
    /// What was cut.
    pub cuts: Vec<CutLine>,
    /// A rapid into it was reported.
    pub is_reported: bool,
    /// A cut far below it was reported.
    pub is_depth_reported: bool,
}

/// A straight piece of a cut.
#[derive(Clone, Copy, Debug)]
pub struct CutLine {
    /// Where it begins.
    pub from: [f64; 3],
    /// Where it ends.
    pub to: [f64; 3],
    /// The radius of the tool.
    pub radius: f64,
}

impl BlankRecord {
    /// Whether rapids are still checked.
    pub fn is_checked(&self) -> bool {
        self.corners.is_some() && !self.is_reported && self.cuts.len() < MAX_CUTS
    }

    /// Whether a point lies in it.
    pub fn contains(&self, point: [f64; 3]) -> bool {
        self.corners.is_some_and(|[least, largest]| {
            (0..3).all(|axis| {
                point[axis] > least[axis] + INSIDE_MM && point[axis] < largest[axis] - INSIDE_MM
            })
        })
    }

    /// Whether a cut has gone over a point, at its level or deeper along the axis of the tool.
    pub fn was_cut(&self, point: [f64; 3], tool_axis: usize) -> bool {
        self.cuts.iter().any(|cut| cut.reaches(point, tool_axis))
    }
}

impl CutLine {
    fn reaches(&self, point: [f64; 3], tool_axis: usize) -> bool {
        let (a, b) = ((tool_axis + 1) % 3, (tool_axis + 2) % 3);
        let along = [self.to[a] - self.from[a], self.to[b] - self.from[b]];
        let away = [point[a] - self.from[a], point[b] - self.from[b]];
        let squared = along[0] * along[0] + along[1] * along[1];
        let part = match squared > 0.0 {
            true => ((along[0] * away[0] + along[1] * away[1]) / squared).clamp(0.0, 1.0),
            false => 0.0,
        };
        let off = [away[0] - part * along[0], away[1] - part * along[1]];
        let deepest = self.from[tool_axis].min(self.to[tool_axis]);
        libm::hypot(off[0], off[1]) <= self.radius + ROOM_MM
            && deepest <= point[tool_axis] + INSIDE_MM
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cut_reaches_its_radius_and_what_lies_above() {
        let cut = CutLine { from: [0.0, 0.0, -5.0], to: [10.0, 0.0, -5.0], radius: 3.0 };
        assert!(cut.reaches([5.0, 3.0, -5.0], 2));
        assert!(cut.reaches([12.0, 0.0, -1.0], 2));
        assert!(!cut.reaches([5.0, 4.0, -5.0], 2));
        assert!(!cut.reaches([5.0, 0.0, -6.0], 2));
    }
}
