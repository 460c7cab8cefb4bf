//! Stock, fixtures and target of a setup as half sections in the frame of the run.

use chordal_geometry::{Vec2, Vec3};
use chordal_machine::{Axis, Body, BodyShape, ContourPoint, MeshUnit};
use chordal_stock::lathe::{
    DxfError, LatheStock, OutlineSegment, Region, RegionError, Tip, ToolOutline, read_dxf,
};

use super::super::setup::{NamedBody, SetupError, SetupFileReader};

impl NamedBody<'_> {
    /// The half section, shifted along Z by the Z component of `shift`.
    pub(super) fn section(
        &self,
        shift: Vec3,
        files: SetupFileReader<'_>,
    ) -> Result<Region, SetupError> {
        let name = self.name;
        let loops = match self.shape_word() {
            None => {
                let help = "write `shape = \"cylinder\"` with `diameter`, `from` and `to`";
                return Err(self.error(format!("`{name}` has no shape"), help));
            }
            Some(BodyShape::Cylinder | BodyShape::Tube) => return self.bar(shift.z),
            Some(BodyShape::Contour) => vec![self.outline()?],
            Some(BodyShape::Dxf) => self.drawing(files)?,
            Some(BodyShape::Box | BodyShape::Stl) => {
                let help = "a lathe needs a half section: `shape = \"cylinder\"`, `tube`, `contour` or `dxf`";
                return Err(self.error(format!("`{name}` is not a body that turns"), help));
            }
        };
        // `from` says where the zero of a contour or drawing is.
        let along = shift.z + self.body.from[2].unwrap_or(0.0);
        let moved: Vec<Vec<OutlineSegment>> = loops
            .iter()
            .map(|segments| segments.iter().map(|segment| along_z(segment, along)).collect())
            .collect();
        Region::contour(&moved).map_err(|error| self.no_region(&error))
    }

    fn no_region(&self, error: &RegionError) -> SetupError {
        let help = "check its dimensions: z is along the axis, and no point passes the axis";
        self.error(format!("`{}` has no half section: {error}", self.name), help)
    }

    fn bar(&self, shift: f64) -> Result<Region, SetupError> {
        let body: &Body = self.body;
        if body.axis.is_some_and(|axis| axis != Axis::Z) {
            let help = "a lathe turns about Z: write `axis = \"Z\"`, or leave it out";
            return Err(self.error(format!("`{}` does not lie along Z", self.name), help));
        }
        if body.from[0].is_some_and(|x| x != 0.0) || body.from[1].is_some_and(|y| y != 0.0) {
            let help = "a lathe turns about X0 Y0: leave X and Y of `from` out";
            return Err(self.error(format!("`{}` does not lie on the axis", self.name), help));
        }
        let missing = |key: &str| {
            let help = "a bar needs its diameter, and where it begins and ends along Z";
            self.error(format!("`{}` has no `{key}`", self.name), help)
        };
        let diameter = body.diameter_mm.ok_or_else(|| missing("diameter"))?;
        let from = body.from[2].ok_or_else(|| missing("from"))? + shift;
        let to = body.to[2].ok_or_else(|| missing("to"))? + shift;
        let bore = match body.shape {
            Some(BodyShape::Tube) => body.bore_mm.ok_or_else(|| missing("bore"))?,
            _ => 0.0,
        };
        let region = Region::tube(0.5 * bore, 0.5 * diameter, from, to);
        region.map_err(|error| self.no_region(&error))
    }

    /// The segments of `contour`, closed along the axis where it is open.
    fn outline(&self) -> Result<Vec<OutlineSegment>, SetupError> {
        let points = &self.body.contour;
        let place = |point: &ContourPoint| Vec2::new(point.z_mm, point.radius_mm);
        let (Some(first), Some(last)) = (points.first(), points.last()) else {
            let help = "write `contour = [[\"0 mm\", \"0 mm\"], [\"20 mm\", \"0 mm\"], …]`, X as a diameter";
            return Err(self.error(format!("`{}` has no `contour`", self.name), help));
        };
        let mut segments = Vec::new();
        for pair in points.windows(2) {
            let (start, end) = (place(&pair[0]), place(&pair[1]));
            segments.push(match pair[1].arc_mm {
                None => OutlineSegment::line(start, end),
                Some(radius) => self.arc(start, end, radius)?,
            });
        }
        let (begin, end) = (place(first), place(last));
        if begin != end {
            let on_axis = |p: Vec2| Vec2::new(p.a, 0.0);
            for (from, to) in
                [(end, on_axis(end)), (on_axis(end), on_axis(begin)), (on_axis(begin), begin)]
            {
                if from != to {
                    segments.push(OutlineSegment::line(from, to));
                }
            }
        }
        Ok(segments)
    }

    /// An arc of at most half a turn; a positive radius is counterclockwise.
    fn arc(&self, start: Vec2, end: Vec2, radius: f64) -> Result<OutlineSegment, SetupError> {
        let (chord, half) = (end - start, 0.5 * start.distance(end));
        let square = radius * radius - half * half;
        // The tolerance admits half circles whose ends were rounded.
        if half == 0.0 || square < -1e-3 * half {
            let message = format!(
                "the radius {} mm in `{}.contour` is too small for an arc over {:.3} mm",
                radius.abs(),
                self.name,
                2.0 * half
            );
            return Err(self.error(message, "the distance of its ends is at most twice the radius"));
        }
        let side = square.max(0.0).sqrt() / (2.0 * half);
        let left = chord.turned_left() * (side * radius.signum());
        Ok(OutlineSegment::arc(start, end, (start + end) * 0.5 + left, radius > 0.0))
    }

    fn drawing(&self, files: SetupFileReader<'_>) -> Result<Vec<Vec<OutlineSegment>>, SetupError> {
        let name = self.name;
        let Some(file) = self.body.file.as_deref() else {
            return Err(self.error(format!("`{name}` has no `file`"), "name the DXF file"));
        };
        let bytes = files(file).map_err(|why| {
            let help = "the file is looked for relative to the setup file";
            self.error(format!("cannot read {file} of `{name}`: {why}"), help)
        })?;
        let unit = self.body.unit.unwrap_or(MeshUnit::Millimetre).mm();
        read_dxf(&bytes, unit).map_err(|error| {
            let help = match error {
                DxfError::Open { .. } => {
                    "join the ends: an outline is closed, or begins and ends on the axis"
                }
                _ => {
                    "export the half section alone: X along the axis, Y the radius, lines and arcs"
                }
            };
            self.error(format!("{file} of `{name}` is not a usable half section: {error}"), help)
        })
    }
}

fn along_z(segment: &OutlineSegment, by: f64) -> OutlineSegment {
    let by = Vec2::new(by, 0.0);
    let (start, end) = (segment.start + by, segment.end + by);
    match segment.bend {
        None => OutlineSegment::line(start, end),
        Some(bend) => OutlineSegment::arc(start, end, bend.center + by, bend.counterclockwise),
    }
}

/// What is left of the stock after a circle of this radius (mm) has moved along an outline.
pub(super) fn without_skin(stock: &Region, outline: &Region, radius: f64) -> LatheStock {
    let mut left = LatheStock::new(stock);
    let Ok(circle) = Tip::new(0).and_then(|tip| ToolOutline::round(radius, tip)) else {
        return left;
    };
    for segment in outline.shape().iter().flatten() {
        // The axis is not a surface.
        if !is_on_axis(segment) {
            // Where a cut fails, material stays, and the skin is thinner there.
            let _ = left.cut(&circle, segment);
        }
    }
    left
}

pub(super) fn is_on_axis(segment: &OutlineSegment) -> bool {
    segment.bend.is_none() && segment.start.b == 0.0 && segment.end.b == 0.0
}

/// A half section grown by a clearance, mm.
pub(super) fn grown(region: &Region, clearance: f64) -> Region {
    let Some((low, high)) = region.bounds().filter(|_| clearance > 0.0) else {
        return region.clone();
    };
    let room = 2.0 * clearance;
    let far = || -> Option<Region> {
        let all = Region::bar(high.b + room, low.a - room, high.a + room).ok()?;
        let around = all.difference(region).ok()?.region;
        let far = without_skin(&around, region, clearance).region();
        Some(all.difference(&far).ok()?.region)
    };
    far().unwrap_or_else(|| region.clone())
}
