//! What lies on the machine: the stock, what holds it, and what is to become of it.

use std::collections::BTreeMap;

use crate::axis::Axis;
use crate::error::ValueLocation;

/// A setup: the stock, the fixtures, the part that is wanted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Setup {
    /// What the program cuts from; `None`: not known.
    pub stock: Option<Body>,
    /// What must not be touched, by name.
    pub fixtures: BTreeMap<String, Body>,
    /// The part as it should be.
    pub target: Option<Body>,
    /// The cutting force of materials, by name.
    pub materials: BTreeMap<String, CuttingForce>,
}

/// The cutting force of a material by the rule of Kienzle, as far as it was given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CuttingForce {
    /// The force on a chip of 1 mm × 1 mm, N/mm².
    pub k_c1_n_per_mm2: Option<f64>,
    /// By which power of the thickness it falls.
    pub m_c: Option<f64>,
    /// Where the values are from.
    pub source: Option<String>,
}

impl Setup {
    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.stock.is_none()
            && self.fixtures.is_empty()
            && self.target.is_none()
            && self.materials.is_empty()
    }

    /// Its bodies with their names in a machine file.
    pub fn bodies(&self) -> impl Iterator<Item = (String, &Body)> {
        let stock = self.stock.iter().map(|body| ("stock".to_string(), body));
        let fixtures = self.fixtures.iter().map(|(name, body)| (format!("fixtures.{name}"), body));
        let target = self.target.iter().map(|body| ("target".to_string(), body));
        stock.chain(fixtures).chain(target)
    }
}

/// A body as it was written: which of the dimensions count depends on its shape.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// What it is.
    pub shape: Option<BodyShape>,
    /// The work offset in whose coordinates its places are.
    pub work_offset: Option<String>,
    /// The corner with the lowest coordinates, or the end of a cylinder, by X, Y, Z, mm.
    pub from: [Option<f64>; 3],
    /// The opposite corner or end, mm.
    pub to: [Option<f64>; 3],
    /// Along which axis a cylinder lies; Z if nothing is said.
    pub axis: Option<Axis>,
    /// The diameter of a cylinder, mm.
    pub diameter_mm: Option<f64>,
    /// The diameter of the bore of a tube, mm.
    pub bore_mm: Option<f64>,
    /// The file of a mesh, relative to the same place as the name of the file that says it.
    pub file: Option<String>,
    /// The unit of a mesh, which its file does not name.
    pub unit: Option<MeshUnit>,
    /// A mesh is turned by half a turn about this axis of its file before it is placed.
    pub turned_over: Option<Axis>,
    /// How far the tool must stay away from a fixture, mm.
    pub clearance_mm: Option<f64>,
    /// How much of the part may be missing, or too much, mm.
    pub tolerance_mm: Option<f64>,
    /// The outline of a half section.
    pub contour: Vec<ContourPoint>,
    /// What it is made of.
    pub material: Option<String>,
    /// Where it was written.
    pub location: Option<ValueLocation>,
}

impl PartialEq for Body {
    /// Bodies that are the same are equal, wherever they were written.
    fn eq(&self, other: &Self) -> bool {
        let what = |body: &Self| Body { location: None, ..body.clone() };
        let (one, other) = (what(self), what(other));
        (one.shape, one.work_offset, one.from, one.to, one.axis, one.diameter_mm, one.bore_mm)
            == (
                other.shape,
                other.work_offset,
                other.from,
                other.to,
                other.axis,
                other.diameter_mm,
                other.bore_mm,
            )
            && (one.file, one.unit, one.turned_over) == (other.file, other.unit, other.turned_over)
            && (one.clearance_mm, one.tolerance_mm, one.material, one.contour)
                == (other.clearance_mm, other.tolerance_mm, other.material, other.contour)
    }
}

/// What a body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BodyShape {
    /// Between two corners.
    Box,
    /// Between two ends, with a diameter.
    Cylinder,
    /// The same with a bore.
    Tube,
    /// A closed mesh of a file.
    Stl,
    /// What turns about Z, by the outline of its half section.
    Contour,
    /// The same by the lines and arcs of a drawing.
    Dxf,
}

/// A corner of a half section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContourPoint {
    /// Distance from the axis, mm.
    pub radius_mm: f64,
    /// Along the axis, mm.
    pub z_mm: f64,
    /// The radius of the arc that leads to it, mm: positive as G3, negative as G2. `None`: a line.
    pub arc_mm: Option<f64>,
}

impl BodyShape {
    /// Every shape.
    pub const ALL: [BodyShape; 6] = [
        BodyShape::Box,
        BodyShape::Cylinder,
        BodyShape::Tube,
        BodyShape::Stl,
        BodyShape::Contour,
        BodyShape::Dxf,
    ];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            BodyShape::Box => "box",
            BodyShape::Cylinder => "cylinder",
            BodyShape::Tube => "tube",
            BodyShape::Stl => "stl",
            BodyShape::Contour => "contour",
            BodyShape::Dxf => "dxf",
        }
    }
}

/// The unit of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshUnit {
    /// Millimetres.
    Millimetre,
    /// Inches.
    Inch,
}

impl MeshUnit {
    /// Both.
    pub const ALL: [MeshUnit; 2] = [MeshUnit::Millimetre, MeshUnit::Inch];

    /// The word of a machine file.
    pub const fn as_str(self) -> &'static str {
        match self {
            MeshUnit::Millimetre => "mm",
            MeshUnit::Inch => "in",
        }
    }

    /// In millimetres.
    pub const fn mm(self) -> f64 {
        match self {
            MeshUnit::Millimetre => 1.0,
            MeshUnit::Inch => 25.4,
        }
    }
}
