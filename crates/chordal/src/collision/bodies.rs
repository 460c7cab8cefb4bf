//! The bodies of a machine, its setup and its tools, and which of them must not touch.

use chordal_collision::{LinkedSolid, MachineLinks};
use chordal_diagnostics::Span;
use chordal_geometry::{Aabb, ConvexSolid, SolidError, Transform, Vec3};
use chordal_kinematics::KinematicChain;
use chordal_machine::{Axis, Body, BodyShape, Machine, MachineSolid, MachineSolidShape, SolidLink};

use super::doubts::CollisionDoubts;
use crate::job::Job;
use crate::stock::{SetupError, SetupFileReader, ToolFrustums, ToolPart, body_bounds};

/// What a body is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BodyRole {
    Machine,
    Fixture,
    Stock,
    Target,
    Tool(ToolPart),
}

/// A body on the machine.
#[derive(Clone, Debug)]
pub(super) struct MachineBody {
    pub role: BodyRole,
    /// Its name in lists of what may be touched.
    pub name: String,
    /// What it is called in messages.
    pub title: String,
    pub linked: LinkedSolid,
    /// The real body is smaller: the hull of a mesh, the stock before the first cut.
    pub is_larger: bool,
    pub may_touch: Vec<String>,
}

/// What follows if two bodies touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ContactMeaning {
    /// They collide.
    Collision,
    /// They may collide: one of them is larger than the real body.
    Doubt,
}

/// What it means if two bodies touch; `None` if they may.
pub(super) fn meaning(
    links: &MachineLinks,
    one: &MachineBody,
    other: &MachineBody,
) -> Option<ContactMeaning> {
    use BodyRole::{Machine, Stock, Target, Tool};
    let [a, b] = [one.linked.link(), other.linked.link()];
    let allows = |body: &MachineBody, name: &String| body.may_touch.contains(name);
    if a == b || allows(one, &other.name) || allows(other, &one.name) {
        return None;
    }
    match (one.role, other.role) {
        // A table lies on its cradle, a slide on its base.
        (Machine, Machine) if links.are_neighbours(a, b) => return None,
        // What the tool cuts, and what is left for its holder, is the question of a run on stock.
        (Tool(_), Stock | Target) | (Stock | Target, Tool(_)) => return None,
        _ => {}
    }
    Some(match one.is_larger || other.is_larger {
        true => ContactMeaning::Doubt,
        false => ContactMeaning::Collision,
    })
}

/// The bodies of the machine file; for one whose place or shape is not known the reason.
pub(super) fn machine_bodies(
    machine: &Machine,
    links: &MachineLinks,
) -> Vec<Result<MachineBody, String>> {
    let sides_known = machine.linear.sides.iter().all(Option::is_some);
    let body = |(name, own): (&String, &MachineSolid)| {
        let link = match own.on {
            None => Err(format!("`solids.{name}.on` is not given")),
            Some(SolidLink::Spindle) => Ok(links.tool()),
            Some(SolidLink::Base) => Ok(links.base()),
            Some(SolidLink::Axis(axis)) => links.of_axis(axis as usize).ok_or_else(|| {
                format!("`solids.{name}.on` is {axis}, which the machine does not have")
            }),
        };
        let needs_sides = match own.on {
            Some(SolidLink::Base) => true,
            Some(SolidLink::Axis(axis)) => !axis.is_rotary(),
            Some(SolidLink::Spindle) | None => false,
        };
        let link = match link {
            Ok(_) if needs_sides && !sides_known => Err(format!(
                "where `{name}` is relative to the part and the tool is not known: `kinematics.X`, `Y` and `Z` are not all given"
            )),
            link => link,
        };
        Ok(MachineBody {
            role: BodyRole::Machine,
            name: name.clone(),
            title: format!("`{name}`"),
            linked: LinkedSolid::new(link?, machine_solid(name, own)?),
            is_larger: false,
            may_touch: own.may_touch.clone(),
        })
    };
    machine.solids.iter().map(body).collect()
}

fn machine_solid(name: &str, own: &MachineSolid) -> Result<ConvexSolid, String> {
    let wrong = |error: SolidError| format!("`solids.{name}` is no body: {error}");
    let point = |key: &str, at: [Option<f64>; 3], is_box: bool| {
        let along = |axis: usize| match at[axis] {
            Some(mm) => Ok(mm),
            None if is_box => {
                let letter = Axis::ALL[axis];
                Err(format!("`solids.{name}.{key}.{letter}` is not given"))
            }
            None => Ok(0.0),
        };
        Ok::<Vec3, String>(Vec3::new(along(0)?, along(1)?, along(2)?))
    };
    match own.shape {
        None => Err(format!("`solids.{name}.shape` is not given")),
        Some(MachineSolidShape::Box) => {
            ConvexSolid::cuboid(point("from", own.from, true)?, point("to", own.to, true)?)
                .map_err(wrong)
        }
        Some(MachineSolidShape::Cylinder) => {
            let Some(diameter) = own.diameter_mm else {
                return Err(format!("`solids.{name}.diameter` is not given"));
            };
            let ends = [point("from", own.from, false)?, point("to", own.to, false)?];
            let other = own.end_diameter_mm.unwrap_or(diameter);
            ConvexSolid::frustum(ends, [diameter / 2.0, other / 2.0]).map_err(wrong)
        }
    }
}

/// Stock, fixtures and target of the setup.
///
/// # Errors
/// When a body is incomplete, or its file cannot be used.
pub(super) fn setup_bodies(
    job: &Job<'_>,
    links: &MachineLinks,
    chain: &KinematicChain,
    files: SetupFileReader<'_>,
    doubts: &mut CollisionDoubts,
) -> Result<Vec<MachineBody>, SetupError> {
    let setup = &job.machine().setup;
    let stock = setup.stock.iter().map(|body| (BodyRole::Stock, "stock".to_string(), body));
    let target = setup.target.iter().map(|body| (BodyRole::Target, "target".to_string(), body));
    let fixtures = setup.fixtures.iter();
    let fixtures = fixtures.map(|(name, body)| (BodyRole::Fixture, name.clone(), body));
    let mut bodies = Vec::new();
    for (role, name, body) in stock.chain(target).chain(fixtures) {
        let key = if role == BodyRole::Fixture { format!("fixtures.{name}") } else { name.clone() };
        let title = match role {
            BodyRole::Fixture => format!("the fixture `{name}`"),
            _ => format!("the {name}"),
        };
        let bounds = body_bounds(&key, body, files)?;
        let Some(place) = place_of(job, chain, body) else {
            doubts.add(
                Span::default(),
                format!("where `{key}` is on the machine is not known, so it is not checked"),
                "give X, Y and Z of its work offset in `[work_offsets]`",
            );
            continue;
        };
        let Some((solid, is_exact)) = setup_solid(body, bounds) else { continue };
        bodies.push(MachineBody {
            role,
            name,
            title,
            linked: LinkedSolid::new(links.part(), solid.transformed(&place)),
            is_larger: !is_exact || role == BodyRole::Stock,
            may_touch: Vec::new(),
        });
    }
    Ok(bodies)
}

/// A body of the setup in its own coordinates, and whether it is exact: of a bore, a mesh or a contour only a box or a
/// cylinder around it is taken. `None` without an extent.
fn setup_solid(body: &Body, bounds: Aabb) -> Option<(ConvexSolid, bool)> {
    let cuboid = ConvexSolid::cuboid(bounds.min, bounds.max);
    match body.shape {
        Some(BodyShape::Cylinder | BodyShape::Tube) => {
            let axis = body.axis.unwrap_or(Axis::Z) as usize % 3;
            let end = |at: f64| {
                let mut point = bounds.center().to_array();
                point[axis] = at;
                Vec3::from_array(point)
            };
            let ends = [bounds.min, bounds.max].map(|corner| end(corner.component(axis)));
            let radius = body.diameter_mm? / 2.0;
            let solid = ConvexSolid::frustum(ends, [radius; 2]).ok()?;
            Some((solid, body.shape == Some(BodyShape::Cylinder)))
        }
        Some(BodyShape::Box) => Some((cuboid.ok()?, true)),
        // A surface may be flat.
        _ => {
            let corners = [bounds.min, bounds.max];
            let corner = |index: usize| {
                let at = |axis: usize| corners[index >> axis & 1].component(axis);
                Vec3::new(at(0), at(1), at(2))
            };
            Some((ConvexSolid::hull((0..8).map(corner).collect()).ok()?, false))
        }
    }
}

/// From the coordinates of a body of the setup to machine coordinates with every axis at zero; `None` where its work offset
/// is not known.
fn place_of(job: &Job<'_>, chain: &KinematicChain, body: &Body) -> Option<Transform> {
    let machine = job.machine();
    let run_frame = job.run_frame();
    placed_by(chain, |axis| match body.work_offset.as_deref() {
        None => run_frame.as_ref()?.offset(axis),
        Some(name) => {
            let own = machine.work_offsets.get(name)?.values[axis]?;
            let shared = machine.work_offsets.get("EXT").and_then(|all| all.values[axis]);
            Some(own + shared.unwrap_or(0.0))
        }
    })
}

/// From the coordinates of a work offset to machine coordinates with every axis at zero; `None` where X, Y or Z of it is not
/// known.
pub(super) fn placed_by(
    chain: &KinematicChain,
    offset: impl Fn(usize) -> Option<f64>,
) -> Option<Transform> {
    let shift = Vec3::new(offset(0)?, offset(1)?, offset(2)?);
    // The body lies as the work offset says, with the tables at the angles of the work offset.
    let angles = [3, 4, 5].map(|axis| offset(axis).unwrap_or(0.0));
    Some(Transform::translation(shift).then(&chain.part_transform(&angles)))
}

/// The parts of a tool, from its tip up to the gauge point.
pub(super) fn tool_bodies(
    number: u32,
    outline: &ToolFrustums,
    length_mm: f64,
    links: &MachineLinks,
    chain: &KinematicChain,
) -> Vec<MachineBody> {
    let (up, tip) = (chain.tool_direction(), chain.tool_vector(length_mm));
    let mut bodies = Vec::new();
    for (part, frustum) in &outline.parts {
        // What is above the gauge point is in the spindle.
        let to = frustum.to.min(length_mm);
        let height = frustum.to - frustum.from;
        let share = if height > 0.0 { (to - frustum.from) / height } else { 0.0 };
        let upper = frustum.lower + (frustum.upper - frustum.lower) * share;
        let ends = [tip + up * frustum.from, tip + up * to];
        if to <= frustum.from {
            continue;
        }
        let Ok(solid) = ConvexSolid::frustum(ends, [frustum.lower, upper]) else { continue };
        let word = match part {
            ToolPart::Cutter => "the cutter",
            ToolPart::Shank => "the shank",
            ToolPart::Holder => "the holder",
        };
        bodies.push(MachineBody {
            role: BodyRole::Tool(*part),
            name: "tool".to_string(),
            title: format!("{word} of tool {number}"),
            linked: LinkedSolid::new(links.tool(), solid),
            is_larger: false,
            may_touch: Vec::new(),
        });
    }
    bodies
}
