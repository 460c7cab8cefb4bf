//! The setup on the machine: the stock, the fixtures, and the target part.

use std::collections::BTreeMap;

use crate::axis::Axis;
use crate::error::ValueLocation;

/// A setup: the stock, the fixtures, the target part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Setup {
    /// The stock that the program cuts; `None`: not known.
    pub stock: Option<Body>,
    /// The bodies that must not be touched, by name.
    pub fixtures: BTreeMap<String, Body>,
    /// The part to be made; `None`: not known.
    pub target: Option<Body>,
    /// The cutting forces of materials, by name.
    pub materials: BTreeMap<String, CuttingForce>,
}

/// The cutting force of a material in the model of Kienzle; `None`: not given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CuttingForce {
    /// The force on a chip of 1 mm × 1 mm, N/mm².
    pub k_c1_n_per_mm2: Option<f64>,
    /// The exponent of the decrease with the chip thickness.
    pub m_c: Option<f64>,
    /// The source of the values.
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

    /// Its bodies, each with its name in a machine file.
    pub fn bodies(&self) -> impl Iterator<Item = (String, &Body)> {
        let stock = self.stock.iter().map(|body| ("stock".to_string(), body));
        let fixtures = self.fixtures.iter().map(|(name, body)| (format!("fixtures.{name}"), body));
        let target = self.target.iter().map(|body| ("target".to_string(), body));
        stock.chain(fixtures).chain(target)
    }
}

/// A body as written in the file; the shape determines which of the dimensions are used. `None`: not given.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// Its shape.
    pub shape: Option<BodyShape>,
    /// The work offset of its coordinates.
    pub work_offset: Option<String>,
    /// The corner with the lowest coordinates, or one end of a cylinder: X, Y, Z, mm.
    pub from: [Option<f64>; 3],
    /// The opposite corner or end: X, Y, Z, mm.
    pub to: [Option<f64>; 3],
    /// The axis of a cylinder; `None`: Z.
    pub axis: Option<Axis>,
    /// The diameter of a cylinder, mm.
    pub diameter_mm: Option<f64>,
    /// The diameter of the bore of a tube, mm.
    pub bore_mm: Option<f64>,
    /// The file of a mesh, relative to the same folder as the name of the file with the key.
    pub file: Option<String>,
    /// The unit of a mesh, which is not in its file.
    pub unit: Option<MeshUnit>,
    /// The axis of its file about which a mesh is rotated by half a turn before it is positioned.
    pub turned_over: Option<Axis>,
    /// The smallest allowed distance of the tool from a fixture, mm.
    pub clearance_mm: Option<f64>,
    /// How much material may be missing or left on the target, mm.
    pub tolerance_mm: Option<f64>,
    /// The outline of a half section.
    pub contour: Vec<ContourPoint>,
    /// The name of its material.
    pub material: Option<String>,
    /// Its position in the file.
    pub location: Option<ValueLocation>,
}

impl PartialEq for Body {
    /// The position does not matter for equality.
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

/// The shape of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BodyShape {
    /// Between two corners.
    Box,
    /// Between two ends, with a diameter.
    Cylinder,
    /// A cylinder with a bore.
    Tube,
    /// A closed mesh from a file.
    Stl,
    /// A body of revolution about Z, from the outline of its half section.
    Contour,
    /// The same, from the lines and arcs of a drawing.
    Dxf,
}

/// A corner of a half section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContourPoint {
    /// Distance from the axis, mm.
    pub radius_mm: f64,
    /// Position along the axis, mm.
    pub z_mm: f64,
    /// The radius of the arc to this corner, mm: positive like G3, negative like G2. `None`: a line.
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

    /// The word for it in machine files.
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
    /// Both values.
    pub const ALL: [MeshUnit; 2] = [MeshUnit::Millimetre, MeshUnit::Inch];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            MeshUnit::Millimetre => "mm",
            MeshUnit::Inch => "in",
        }
    }

    /// The unit in millimetres.
    pub const fn mm(self) -> f64 {
        match self {
            MeshUnit::Millimetre => 1.0,
            MeshUnit::Inch => 25.4,
        }
    }
}
