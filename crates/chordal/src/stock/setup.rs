//! The bodies of a setup as shapes in the frame of the run.

use chordal_geometry::{Aabb, Vec3};
use chordal_machine::{Axis as MachineAxis, Body, BodyShape, Machine, MeshUnit, ValueLocation};
use chordal_stock::mesh::{LengthUnit, StlOptions, read_stl};
use chordal_stock::shape::{ShapeAxis, ShapeError, SolidShape};

/// Corners of a mesh that are nearer to each other than this are merged, mm: about the last of six decimals.
const WELD: f64 = 1e-6;
/// Most triangles of a mesh.
const TRIANGLES: usize = 5_000_000;

/// Why a setup cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct SetupError {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
    /// Where the faulty value was written; `None` where that is not known.
    pub location: Option<ValueLocation>,
}

/// Reads the bytes of a file that a setup names; the error says why that failed.
pub type SetupFileReader<'f> = &'f dyn Fn(&str) -> Result<Vec<u8>, String>;

/// A body as it was written, with its name for messages.
#[derive(Clone, Copy)]
pub(super) struct NamedBody<'a> {
    pub name: &'a str,
    pub body: &'a Body,
}

impl NamedBody<'_> {
    pub(super) fn error(&self, message: String, help: &str) -> SetupError {
        SetupError { message, help: help.to_string(), location: self.body.location.clone() }
    }

    fn wrong(&self, error: &ShapeError) -> SetupError {
        let help = "check its dimensions: `from` is the lower end or corner, `to` the upper one";
        self.error(format!("`{}` has no shape: {error}", self.name), help)
    }

    /// The shape, shifted from its own coordinates to those of the run. An open mesh is taken as a surface where
    /// `may_be_open`.
    pub fn shape(
        &self,
        shift: Vec3,
        files: SetupFileReader<'_>,
        may_be_open: bool,
    ) -> Result<SolidShape, SetupError> {
        let name = self.name;
        match self.shape_word() {
            None => {
                let help = "write `shape = \"box\"` with `from` and `to`, or another shape";
                Err(self.error(format!("`{name}` has no shape"), help))
            }
            Some(BodyShape::Box) => self.cuboid(shift),
            Some(BodyShape::Cylinder | BodyShape::Tube) => self.round(shift),
            Some(BodyShape::Stl) => self.mesh(shift, files, may_be_open),
            Some(BodyShape::Contour | BodyShape::Dxf) => {
                let help = "write `shape = \"box\"`, `cylinder`, `tube` or `stl`";
                Err(self.error(format!("`{name}` is a half section, which only lathes have"), help))
            }
        }
    }

    /// The kind of shape, by the extension of its file where it has no `shape`; `None` where neither says it.
    pub fn shape_word(&self) -> Option<BodyShape> {
        let by_file = || {
            let (_, extension) = self.body.file.as_deref()?.rsplit_once('.')?;
            let of_files = [BodyShape::Stl, BodyShape::Dxf];
            of_files.into_iter().find(|shape| extension.eq_ignore_ascii_case(shape.as_str()))
        };
        self.body.shape.or_else(by_file)
    }

    fn cuboid(&self, shift: Vec3) -> Result<SolidShape, SetupError> {
        let corner = |key: &str, at: [Option<f64>; 3]| {
            let [x, y, z] = [0, 1, 2].map(|axis| {
                at[axis].ok_or_else(|| {
                    let letter = ["X", "Y", "Z"][axis];
                    let help = "a box needs X, Y and Z of `from` and `to`";
                    self.error(format!("`{}.{key}` has no {letter}", self.name), help)
                })
            });
            Ok::<Vec3, SetupError>(Vec3::new(x?, y?, z?) + shift)
        };
        let (from, to) = (corner("from", self.body.from)?, corner("to", self.body.to)?);
        SolidShape::cuboid(from, to).map_err(|error| self.wrong(&error))
    }

    fn round(&self, shift: Vec3) -> Result<SolidShape, SetupError> {
        let body = self.body;
        let number = body.axis.unwrap_or(MachineAxis::Z) as usize % 3;
        let missing = |key: &str| {
            let help = "a cylinder needs its diameter, and where it begins and ends on its axis";
            self.error(format!("`{}` has no `{key}`", self.name), help)
        };
        let diameter = body.diameter_mm.ok_or_else(|| missing("diameter"))?;
        let along = [shift.x, shift.y, shift.z][number];
        let from = body.from[number].ok_or_else(|| missing("from"))? + along;
        let to = body.to[number].ok_or_else(|| missing("to"))? + along;
        let [x, y, z] = body.from.map(|at| at.unwrap_or(0.0));
        let middle = Vec3::new(x, y, z) + shift;
        let axis = [ShapeAxis::X, ShapeAxis::Y, ShapeAxis::Z][number];
        let shape = if body.shape == Some(BodyShape::Tube) {
            let bore = body.bore_mm.ok_or_else(|| missing("bore"))?;
            SolidShape::tube(axis, middle, [diameter, bore], from, to)
        } else {
            SolidShape::cylinder(axis, middle, diameter, from, to)
        };
        shape.map_err(|error| self.wrong(&error))
    }

    fn mesh(
        &self,
        shift: Vec3,
        files: SetupFileReader<'_>,
        may_be_open: bool,
    ) -> Result<SolidShape, SetupError> {
        let name = self.name;
        let Some(file) = self.body.file.as_deref() else {
            return Err(self.error(format!("`{name}` has no `file`"), "name the STL file"));
        };
        let bytes = files(file).map_err(|why| {
            let help = "the file is looked for relative to the setup file";
            self.error(format!("cannot read {file} of `{name}`: {why}"), help)
        })?;
        let unit = match self.body.unit.unwrap_or(MeshUnit::Millimetre) {
            MeshUnit::Millimetre => LengthUnit::Millimetre,
            MeshUnit::Inch => LengthUnit::Inch,
        };
        let options = StlOptions { unit, weld: WELD, limit: TRIANGLES };
        let read = read_stl(&bytes, &options).map_err(|error| {
            self.error(
                format!("{file} of `{name}` is no usable STL file: {error}"),
                "export it again",
            )
        })?;
        // `from` says where the zero of the file is.
        let [x, y, z] = self.body.from.map(|at| at.unwrap_or(0.0));
        let mesh = match self.body.turned_over {
            Some(axis) => read.mesh.turned_over(axis as usize),
            None => read.mesh,
        };
        let mesh = mesh.moved(Vec3::new(x, y, z) + shift);
        let shape = if may_be_open { SolidShape::surface(mesh) } else { SolidShape::solid(mesh) };
        shape.map_err(|error| {
            let help =
                "repair the mesh: stock and target must be closed, each edge with two triangles";
            self.error(format!("{file} of `{name}`: {error}"), help)
        })
    }
}

/// A box around a body in its own coordinates, mm.
///
/// # Errors
/// When the body is incomplete, or its file cannot be used.
pub(crate) fn body_bounds(
    name: &str,
    body: &Body,
    files: SetupFileReader<'_>,
) -> Result<Aabb, SetupError> {
    Ok(NamedBody { name, body }.shape(Vec3::ZERO, files, true)?.bounds())
}

/// The shift from coordinates in the body's work offset to those of the run, whose first cut is in the work offset
/// `run`.
pub(super) fn shift_between(
    machine: &Machine,
    named: &NamedBody<'_>,
    run: Option<&str>,
) -> Result<Vec3, SetupError> {
    let Some(own) = named.body.work_offset.as_deref() else { return Ok(Vec3::ZERO) };
    let Some(run) = run.filter(|run| !run.eq_ignore_ascii_case(own)) else { return Ok(Vec3::ZERO) };
    let place = |name: &str| {
        let offset = machine.work_offsets.get(name)?;
        let [x, y, z] = [0, 1, 2].map(|axis| offset.values[axis]);
        Some(Vec3::new(x?, y?, z?))
    };
    match (place(own), place(run)) {
        (Some(own), Some(run)) => Ok(own - run),
        _ => Err(named.error(
            format!(
                "`{}` is given in {own}, the first cut is in {run}, and where both are is not known",
                named.name
            ),
            "give `[work_offsets]` of both in the setup or machine file, or the body in the work offset of \
             the first cut",
        )),
    }
}
