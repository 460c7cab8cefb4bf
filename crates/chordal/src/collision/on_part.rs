//! The bodies of the machine as they stand relative to the part, for pictures in which the part is at rest.

use chordal_collision::LinkJoint;
use chordal_geometry::{ConvexSolid, Transform, Vec3};

use super::bodies::{machine_bodies, placed_by};
use crate::job::Job;

/// A body of the machine, and what moves it relative to the part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartRelativeBody {
    /// Its name in the machine file.
    pub name: String,
    /// Its shape, machine coordinates with all axes at zero, mm.
    pub solid: ConvexSolid,
    /// The motions from there to its place relative to the part, in the order in which they are applied.
    pub motions: Vec<LinkJoint>,
}

/// The bodies of a machine relative to the part.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineOnPart {
    /// Those whose place and shape are known.
    pub bodies: Vec<PartRelativeBody>,
    /// From machine coordinates, after the motions of a body, to the frame of the run on the part.
    pub to_part: Transform,
    /// The zero of the run on the machine: X, Y and Z, mm.
    pub run_zero: Vec3,
    /// Why other bodies are left out.
    pub left_out: Vec<String>,
}

impl Job<'_> {
    /// The bodies of the machine file relative to the part; `None` where there are none, and on a lathe.
    ///
    /// # Errors
    /// Why it is not known where they are.
    pub fn machine_on_part(&self) -> Option<Result<MachineOnPart, String>> {
        let machine = self.machine();
        (!machine.turns() && !machine.solids.is_empty()).then(|| self.placed_machine())
    }

    fn placed_machine(&self) -> Result<MachineOnPart, String> {
        let chain = self.machine().kinematic_chain().map_err(|error| error.to_string())?;
        let run_frame = self.run_frame();
        let offset = |axis: usize| run_frame.as_ref()?.offset(axis);
        let place = placed_by(&chain, offset).zip(offset(0).zip(offset(1)).zip(offset(2)));
        let Some((place, ((x, y), z))) = place else {
            return Err("X, Y and Z of the work offset are not all given".to_string());
        };
        let links = self.machine_links(&chain);
        let (mut bodies, mut left_out) = (Vec::new(), Vec::new());
        for body in machine_bodies(self.machine(), &links) {
            match body {
                Ok(body) => bodies.push(PartRelativeBody {
                    motions: links.motions_relative_to(links.part(), body.linked.link()),
                    solid: body.linked.solid().clone(),
                    name: body.name,
                }),
                Err(reason) => left_out.push(reason),
            }
        }
        let (to_part, run_zero) = (place.inverse(), Vec3::new(x, y, z));
        Ok(MachineOnPart { bodies, to_part, run_zero, left_out })
    }
}
