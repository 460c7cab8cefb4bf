//! The views: how space comes onto the sheet.

use chordal::geometry::{Aabb, Vec3};

/// A direction to look in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ViewDirection {
    pub title: &'static str,
    /// What goes to the right on the sheet.
    pub right: Vec3,
    /// What goes up on the sheet.
    pub up: Vec3,
    /// The view is along an axis, so that the other two can be read from a grid.
    pub along_axes: bool,
    /// What goes up is programmed as a diameter, and its numbers are diameters.
    pub doubled: bool,
}

/// From above.
pub(super) const TOP: ViewDirection =
    ViewDirection { title: "Top", right: Vec3::X, up: Vec3::Y, along_axes: true, doubled: false };
/// From the operator's place.
pub(super) const FRONT: ViewDirection =
    ViewDirection { title: "Front", right: Vec3::X, up: Vec3::Z, along_axes: true, doubled: false };
/// From the right.
pub(super) const SIDE: ViewDirection =
    ViewDirection { title: "Right", right: Vec3::Y, up: Vec3::Z, along_axes: true, doubled: false };
/// Of a lathe: the axis of the part to the right, away from it up.
pub(super) const TURNED: ViewDirection = ViewDirection {
    title: "Z and X, diameters",
    right: Vec3::Z,
    up: Vec3::X,
    along_axes: true,
    doubled: true,
};

/// Of a lathe with live tools: the face from the tailstock, and the shell of a cylinder rolled out flat.
pub(super) const FACE: ViewDirection = ViewDirection {
    title: "X and Y, radii: face, shell rolled out",
    right: Vec3::X,
    up: Vec3::Y,
    along_axes: true,
    doubled: false,
};

/// Square root of a half, a sixth and two thirds: from the front right above.
const SQRT_HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;
const SIXTH: f64 = 0.408_248_290_463_863;
const TWO_THIRDS: f64 = 0.816_496_580_927_726;

/// From the front, the right and above, all alike.
pub(super) const ISOMETRIC: ViewDirection = ViewDirection {
    title: "Isometric",
    right: Vec3::new(SQRT_HALF, SQRT_HALF, 0.0),
    up: Vec3::new(-SIXTH, SIXTH, TWO_THIRDS),
    along_axes: false,
    doubled: false,
};

impl ViewDirection {
    /// Where a point comes to lie, mm to the right and up.
    #[inline]
    pub fn project(&self, p: Vec3) -> (f64, f64) {
        (self.right.dot(p), self.up.dot(p))
    }

    /// The direction towards the eye.
    pub fn eye(&self) -> Vec3 {
        self.right.cross(self.up)
    }

    /// The extent of a box: left, right, bottom, top.
    pub fn extent(&self, bounds: &Aabb) -> ViewExtent {
        let mut extent = ViewExtent::EMPTY_EXTENT;
        for corner in corners(bounds) {
            let (x, y) = self.project(corner);
            extent.left = extent.left.min(x);
            extent.right = extent.right.max(x);
            extent.bottom = extent.bottom.min(y);
            extent.top = extent.top.max(y);
        }
        extent
    }
}

/// A rectangle in mm, as the views see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ViewExtent {
    pub left: f64,
    pub right: f64,
    pub bottom: f64,
    pub top: f64,
}

impl ViewExtent {
    const EMPTY_EXTENT: ViewExtent = ViewExtent {
        left: f64::INFINITY,
        right: f64::NEG_INFINITY,
        bottom: f64::INFINITY,
        top: f64::NEG_INFINITY,
    };

    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }

    pub fn middle(&self) -> (f64, f64) {
        (0.5 * (self.left + self.right), 0.5 * (self.bottom + self.top))
    }
}

fn corners(bounds: &Aabb) -> impl Iterator<Item = Vec3> {
    let (low, high) = (bounds.min, bounds.max);
    (0..8).map(move |index| {
        let pick = |bit: u32, low: f64, high: f64| if index & bit == 0 { low } else { high };
        Vec3::new(pick(1, low.x, high.x), pick(2, low.y, high.y), pick(4, low.z, high.z))
    })
}

/// A rectangle on the sheet, px; y goes down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PixelRect {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
}

impl PixelRect {
    pub fn right(&self) -> f64 {
        self.x + self.width
    }

    pub fn bottom(&self) -> f64 {
        self.y + self.height
    }

    /// True within the rectangle or as far outside as `reach`.
    pub fn holds(&self, (x, y): (f64, f64), reach: f64) -> bool {
        (self.x - reach..=self.right() + reach).contains(&x)
            && (self.y - reach..=self.bottom() + reach).contains(&y)
    }

    /// The part of a line inside, as its two ends; `None` when it passes by.
    pub fn clip(&self, a: (f64, f64), b: (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
        if self.holds(a, 0.0) && self.holds(b, 0.0) {
            return Some((a, b));
        }
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0f64, 1.0f64);
        let sides = [
            (-dx, a.0 - self.x),
            (dx, self.right() - a.0),
            (-dy, a.1 - self.y),
            (dy, self.bottom() - a.1),
        ];
        for (path, room) in sides {
            if path == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if path < 0.0 {
                from = from.max(room / path);
            } else {
                to = to.min(room / path);
            }
        }
        let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
        (from < to)
            .then(|| (if from > 0.0 { at(from) } else { a }, if to < 1.0 { at(to) } else { b }))
    }
}

/// A view in its place on the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ViewPanel {
    pub view: ViewDirection,
    pub rect: PixelRect,
    /// px for each mm.
    pub scale: f64,
    /// What lies in the middle of the rectangle, mm.
    pub middle: (f64, f64),
}

impl ViewPanel {
    /// Where a point comes to lie, px.
    #[inline]
    pub fn place(&self, p: Vec3) -> (f64, f64) {
        let (x, y) = self.view.project(p);
        (self.across(x), self.down(y))
    }

    /// px of mm to the right.
    #[inline]
    pub fn across(&self, x: f64) -> f64 {
        self.rect.x + 0.5 * self.rect.width + (x - self.middle.0) * self.scale
    }

    /// px of mm up.
    #[inline]
    pub fn down(&self, y: f64) -> f64 {
        self.rect.y + 0.5 * self.rect.height - (y - self.middle.1) * self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_isometric_eye_is_in_front_right_above() {
        let eye = ISOMETRIC.eye() * 3.0f64.sqrt();
        assert!((eye - Vec3::new(1.0, -1.0, 1.0)).length() < 1e-12);
    }

    #[test]
    fn lines_are_clipped() {
        let rect = PixelRect { x: 0.0, y: 0.0, width: 10.0, height: 10.0 };
        assert_eq!(rect.clip((-5.0, 5.0), (20.0, 5.0)), Some(((0.0, 5.0), (10.0, 5.0))));
        assert_eq!(rect.clip((-5.0, 5.0), (-1.0, 5.0)), None);
        assert_eq!(rect.clip((5.0, -5.0), (5.0, -1.0)), None);
        assert_eq!(rect.clip((1.0, 1.0), (2.0, 2.0)), Some(((1.0, 1.0), (2.0, 2.0))));
    }
}
