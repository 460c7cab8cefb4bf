//! A drawing as plain data: who draws it chooses scale, colours and where texts stand.

use chordal_geometry::Vec2;

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineStyle {
    /// The contour of the part.
    Part,
    /// The way of the cutter's centre.
    Path,
    /// The cutter.
    Cutter,
    /// A line that helps to see.
    Helper,
}

/// One thing in a figure; coordinates in mm, X to the right and Y up, angles in rad.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureElement {
    /// A line.
    Line {
        /// Its start.
        from: Vec2,
        /// Its end.
        to: Vec2,
        /// How it is drawn.
        style: LineStyle,
    },
    /// A part of a circle.
    Arc {
        /// Its centre.
        center: Vec2,
        /// Its radius.
        radius: f64,
        /// Direction from the centre to its start.
        start: f64,
        /// Angle travelled, positive counter-clockwise.
        sweep: f64,
        /// How it is drawn.
        style: LineStyle,
    },
    /// A point with its name; without one it is only a dot.
    Point {
        /// Where.
        at: Vec2,
        /// Its name.
        label: String,
    },
    /// An arrow head on a path.
    Arrow {
        /// Where its tip is.
        at: Vec2,
        /// The direction it points in.
        direction: f64,
    },
    /// A measured distance: `from` and `to` are seen along `direction`, and the dimension line
    /// runs through `through`.
    Dimension {
        /// One end.
        from: Vec2,
        /// The other.
        to: Vec2,
        /// Direction of the dimension line.
        direction: f64,
        /// A point of the dimension line.
        through: Vec2,
        /// What it says.
        text: String,
    },
    /// A measured angle.
    Angle {
        /// Where the arms meet.
        vertex: Vec2,
        /// Radius of its arc.
        radius: f64,
        /// Direction of the first arm.
        start: f64,
        /// Angle to the second arm.
        sweep: f64,
        /// What it says.
        text: String,
    },
    /// A text for a place.
    Text {
        /// The place.
        at: Vec2,
        /// What it says.
        text: String,
    },
}

/// A drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// What is in it, in the order of drawing.
    pub marks: Vec<FigureElement>,
}

impl Figure {
    pub(crate) fn line(&mut self, from: Vec2, to: Vec2, style: LineStyle) {
        self.marks.push(FigureElement::Line { from, to, style });
    }

    pub(crate) fn circle(&mut self, center: Vec2, radius: f64, style: LineStyle) {
        self.arc(center, radius, 0.0, std::f64::consts::TAU, style);
    }

    pub(crate) fn arc(
        &mut self,
        center: Vec2,
        radius: f64,
        start: f64,
        sweep: f64,
        style: LineStyle,
    ) {
        self.marks.push(FigureElement::Arc { center, radius, start, sweep, style });
    }

    pub(crate) fn point(&mut self, at: Vec2, label: &str) {
        self.marks.push(FigureElement::Point { at, label: label.into() });
    }

    pub(crate) fn arrow(&mut self, at: Vec2, direction: f64) {
        self.marks.push(FigureElement::Arrow { at, direction });
    }

    pub(crate) fn text(&mut self, at: Vec2, text: impl Into<String>) {
        self.marks.push(FigureElement::Text { at, text: text.into() });
    }

    pub(crate) fn angle(
        &mut self,
        vertex: Vec2,
        radius: f64,
        start: f64,
        sweep: f64,
        text: impl Into<String>,
    ) {
        self.marks.push(FigureElement::Angle { vertex, radius, start, sweep, text: text.into() });
    }

    /// A dimension along X, at the height of `y`.
    pub(crate) fn width(&mut self, from: Vec2, to: Vec2, y: f64, text: impl Into<String>) {
        let through = Vec2::new(from.a, y);
        self.marks.push(FigureElement::Dimension {
            from,
            to,
            direction: 0.0,
            through,
            text: text.into(),
        });
    }

    /// A dimension along Y, at `x`.
    pub(crate) fn height(&mut self, from: Vec2, to: Vec2, x: f64, text: impl Into<String>) {
        let (through, direction) = (Vec2::new(x, from.b), std::f64::consts::FRAC_PI_2);
        self.marks.push(FigureElement::Dimension {
            from,
            to,
            direction,
            through,
            text: text.into(),
        });
    }
}
