//! Where the views lie on the sheet: third-angle projection, one scale, aligned.

use chordal::geometry::{Aabb, Vec3};

use super::view::{FACE, FRONT, ISOMETRIC, PixelRect, SIDE, TOP, TURNED, ViewDirection, ViewPanel};

/// Measures in units: a unit is a pixel on a sheet of 1600 by 1131.
pub(super) const MARGIN_UNITS: f64 = 30.0;
const HEADER: f64 = 72.0;
const TICKS_LEFT: f64 = 58.0;
const TICKS_BELOW: f64 = 26.0;
const TITLE: f64 = 26.0;
const BETWEEN: f64 = 18.0;
/// A path of a lathe that is wider across than this is also seen from its face, mm.
const PLANAR_MM: f64 = 1e-6;
/// The share of the width that the face gets.
const FACE_SHARE: f64 = 0.4;
/// Room within a view around what is drawn.
const INSIDE: f64 = 22.0;

/// The least share of the room that a column or row of views gets.
const MIN_SHARE: PanelShare = PanelShare { left: 0.3, right: 0.2, upper: 0.35, lower: 0.14 };

struct PanelShare {
    left: f64,
    right: f64,
    upper: f64,
    lower: f64,
}

/// The sheet.
#[derive(Debug)]
pub(super) struct SheetLayout {
    pub width: f64,
    pub height: f64,
    /// px for each unit.
    pub unit: f64,
    /// Top, front, right and isometric; of a lathe one, and the face where a path leaves the plane of Z and X.
    pub panels: Vec<ViewPanel>,
}

impl SheetLayout {
    /// px for each unit on a sheet.
    pub fn unit(width: f64, height: f64) -> f64 {
        (width * height / (1600.0 * 1131.0)).sqrt().min(width / 900.0).max(0.6)
    }

    /// Places the views of a box; `legend` is the height of the legend in units.
    pub fn new(width: f64, height: f64, bounds: &Aabb, legend: f64) -> SheetLayout {
        let unit = SheetLayout::unit(width, height);
        let size = drawable(bounds.size());
        let room = (
            width - (2.0 * MARGIN_UNITS + 2.0 * TICKS_LEFT + BETWEEN) * unit,
            height
                - (2.0 * MARGIN_UNITS + HEADER + 2.0 * (TITLE + TICKS_BELOW) + BETWEEN + legend)
                    * unit,
        );
        let inside = 2.0 * INSIDE * unit;
        let columns =
            LayoutTrack::new(room.0, (size.x, MIN_SHARE.left), (size.y, MIN_SHARE.right), inside);
        let rows =
            LayoutTrack::new(room.1, (size.y, MIN_SHARE.upper), (size.z, MIN_SHARE.lower), inside);
        let scale = columns.scale().min(rows.scale());
        let (left, right) = columns.sizes(scale);
        let (upper, lower) = rows.sizes(scale);

        let x = (MARGIN_UNITS + TICKS_LEFT) * unit;
        let x2 = x + left + (TICKS_LEFT + BETWEEN) * unit;
        let y = (MARGIN_UNITS + HEADER + TITLE) * unit;
        let y2 = y + upper + (TICKS_BELOW + TITLE + BETWEEN) * unit;
        let rect = |x, y, width, height| PixelRect { x, y, width, height };
        let panels = vec![
            panel(TOP, rect(x, y, left, upper), scale, bounds),
            panel(FRONT, rect(x, y2, left, lower), scale, bounds),
            panel(SIDE, rect(x2, y2, right, lower), scale, bounds),
            filling(ISOMETRIC, rect(x2, y, right, upper), bounds, inside),
        ];
        SheetLayout { width, height, unit, panels }
    }
}

impl SheetLayout {
    /// One view for what turns, and one of the face where live tools mill.
    pub fn turned(width: f64, height: f64, bounds: &Aabb, legend: f64) -> SheetLayout {
        let unit = SheetLayout::unit(width, height);
        let (x, y) = ((MARGIN_UNITS + TICKS_LEFT) * unit, (MARGIN_UNITS + HEADER + TITLE) * unit);
        let rect = PixelRect {
            x,
            y,
            width: (width - x - MARGIN_UNITS * unit).max(20.0),
            height: (height - y - (MARGIN_UNITS + TICKS_BELOW + legend) * unit).max(20.0),
        };
        let inside = 2.0 * INSIDE * unit;
        if bounds.size().y <= PLANAR_MM {
            return SheetLayout {
                width,
                height,
                unit,
                panels: vec![filling(TURNED, rect, bounds, inside)],
            };
        }
        let between = (TICKS_LEFT + BETWEEN) * unit;
        let face = ((rect.width - between) * FACE_SHARE).max(10.0);
        let section = (rect.width - between - face).max(10.0);
        let left = PixelRect { width: section, ..rect };
        let right = PixelRect { x: x + section + between, width: face, ..rect };
        let panels =
            vec![filling(TURNED, left, bounds, inside), filling(FACE, right, bounds, inside)];
        SheetLayout { width, height, unit, panels }
    }
}

/// A view alone on its sheet.
pub(super) fn single(
    view: ViewDirection,
    width: f64,
    height: f64,
    bounds: &Aabb,
    unit: f64,
) -> ViewPanel {
    let (left, below) = if view.along_axes { (TICKS_LEFT, TICKS_BELOW) } else { (1.0, 1.0) };
    let (x, y) = (left * unit, TITLE * unit);
    let rect = PixelRect { x, y, width: width - x - unit, height: height - y - below * unit };
    filling(view, rect, bounds, 2.0 * INSIDE * unit)
}

fn panel(view: ViewDirection, rect: PixelRect, scale: f64, bounds: &Aabb) -> ViewPanel {
    ViewPanel { view, rect, scale, middle: view.extent(bounds).middle() }
}

/// A view with a scale of its own: it fills its place.
fn filling(view: ViewDirection, rect: PixelRect, bounds: &Aabb, inside: f64) -> ViewPanel {
    let middle = (bounds.min + bounds.max) * 0.5;
    let half = drawable(bounds.size()) * 0.5;
    let extent = view.extent(&Aabb { min: middle - half, max: middle + half });
    let scale =
        ((rect.width - inside) / extent.width()).min((rect.height - inside) / extent.height());
    panel(view, rect, scale, bounds)
}

/// The sides of what is drawn, none of them nothing: a point is drawn as if it were 10 mm,
/// and a flat path gets a thin edge.
fn drawable(size: Vec3) -> Vec3 {
    let largest = size.x.max(size.y).max(size.z);
    let least = if largest > 1e-9 { largest * 1e-3 } else { 10.0 };
    Vec3::new(size.x.max(least), size.y.max(least), size.z.max(least))
}

/// Two columns, or two rows.
struct LayoutTrack {
    room: f64,
    first: (f64, f64),
    second: (f64, f64),
    inside: f64,
}

impl LayoutTrack {
    /// `first` and `second`: the extent in mm, and the least share of the room.
    fn new(room: f64, first: (f64, f64), second: (f64, f64), inside: f64) -> LayoutTrack {
        LayoutTrack { room: room.max(20.0), first, second, inside }
    }

    fn needs(&self, scale: f64) -> (f64, f64) {
        let need = |(mm, share): (f64, f64)| (mm * scale + self.inside).max(share * self.room);
        (need(self.first), need(self.second))
    }

    /// The largest scale at which both fit.
    fn scale(&self) -> f64 {
        let fits = |scale: f64| {
            let (first, second) = self.needs(scale);
            first + second <= self.room
        };
        let (mut low, mut high) = (1e-15f64, 1e15f64);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if fits(middle) { low = middle } else { high = middle }
        }
        low
    }

    /// The sizes at a scale, with what is left over shared out.
    fn sizes(&self, scale: f64) -> (f64, f64) {
        let (first, second) = self.needs(scale);
        let range = self.room / (first + second);
        (first * range, second * range)
    }
}
