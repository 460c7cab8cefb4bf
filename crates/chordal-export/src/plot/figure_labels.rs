//! Where the texts of a figure stand: near what they name, on nothing else.

/// A place on the sheet, px.
pub(super) type PixelPoint = (f64, f64);

/// A rectangle on the sheet, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LabelBox {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl LabelBox {
    fn around(middle: PixelPoint, width: f64, height: f64) -> LabelBox {
        LabelBox { left: middle.0 - width / 2.0, top: middle.1 - height / 2.0, width, height }
    }

    pub fn middle(&self) -> PixelPoint {
        (self.left + self.width / 2.0, self.top + self.height / 2.0)
    }

    fn holds(&self, (x, y): PixelPoint, margin: f64) -> bool {
        x > self.left - margin
            && x < self.left + self.width + margin
            && y > self.top - margin
            && y < self.top + self.height + margin
    }

    /// How much of it lies in another, px².
    fn shares(&self, other: &LabelBox, margin: f64) -> f64 {
        let overlap = |a: f64, a_size: f64, b: f64, b_size: f64| {
            ((a + a_size).min(b + b_size) - a.max(b) + margin).max(0.0)
        };
        overlap(self.left, self.width, other.left, other.width)
            * overlap(self.top, self.height, other.top, other.height)
    }

    /// How far it reaches out of another, px.
    fn outside(&self, room: &LabelBox) -> f64 {
        (room.left - self.left).max(0.0)
            + (room.top - self.top).max(0.0)
            + (self.left + self.width - room.left - room.width).max(0.0)
            + (self.top + self.height - room.top - room.height).max(0.0)
    }
}

/// A text on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlacedLabel {
    pub text: String,
    /// What it names.
    pub anchor: PixelPoint,
    /// Where it stands.
    pub block: LabelBox,
}

impl PlacedLabel {
    /// A line from the text to what it names helps when they are apart.
    pub fn leader(&self) -> Option<PixelPoint> {
        let block = &self.block;
        let (x, y) = self.anchor;
        let near = (
            x.clamp(block.left, block.left + block.width),
            y.clamp(block.top, block.top + block.height),
        );
        ((near.0 - x).hypot(near.1 - y) > 22.0).then_some(near)
    }
}

/// Directions that are tried around a place, and distances, px.
const DIRECTIONS: u32 = 24;
const DISTANCES: [f64; 8] = [5.0, 9.0, 15.0, 24.0, 36.0, 54.0, 80.0, 120.0];
/// Width of a letter over its size.
const LETTER: f64 = 0.56;

/// The room a text takes, px.
pub(super) fn extent(text: &str, size: f64) -> PixelPoint {
    (text.chars().count() as f64 * size * LETTER, size * 1.15)
}

/// Places texts one after the other, each where it covers the least.
///
/// `strokes` are points of all lines, a few px apart.
pub(super) fn place(
    names: &[(String, PixelPoint)],
    strokes: &[PixelPoint],
    room: &LabelBox,
    size: f64,
) -> Vec<PlacedLabel> {
    let mut labels: Vec<PlacedLabel> = Vec::new();
    for (text, anchor) in names {
        let (width, height) = extent(text, size);
        let mut best: Option<(f64, LabelBox)> = None;
        for distance in DISTANCES {
            for direction in 0..DIRECTIONS {
                let angle = f64::from(direction) * std::f64::consts::TAU / f64::from(DIRECTIONS);
                let (sin, cos) = angle.sin_cos();
                // The text's own half extent in this direction, so that its edge is so far away.
                let middle = (
                    anchor.0 + cos * (width / 2.0 + distance),
                    anchor.1 - sin * (height / 2.0 + distance),
                );
                let block = LabelBox::around(middle, width, height);
                let cost = cost(&block, distance, strokes, &labels, room);
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, block));
                }
            }
        }
        if let Some((_, block)) = best {
            labels.push(PlacedLabel { text: text.clone(), anchor: *anchor, block });
        }
    }
    labels
}

fn cost(
    block: &LabelBox,
    distance: f64,
    strokes: &[PixelPoint],
    labels: &[PlacedLabel],
    room: &LabelBox,
) -> f64 {
    let crossed = strokes.iter().filter(|point| block.holds(**point, 2.0)).count();
    let texts: f64 = labels.iter().map(|label| label.block.shares(&block.clone(), 4.0)).sum();
    // What a later text names stays visible as well: its anchor is one of the strokes.
    distance * 0.12 + crossed as f64 * 1.5 + texts * 10.0 + block.outside(room) * 50.0
}
