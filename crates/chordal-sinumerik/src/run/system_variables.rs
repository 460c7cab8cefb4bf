//! The system variables whose value follows from the program and the machine file. All others depend on the machine.

use chordal_command::{CompensationSide, FeedMode, Units, WorkName};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::State;
use chordal_machine::{AXIS_NAMES, Tool};

use super::run_state::{LanguageModes, PathMotion};
use super::tool_edges::edge_offset_number;
use crate::syntax::{Address, ExpressionKind};
use crate::values::{NAMED_INDEX, SinumerikValue};

/// The state that system variables tell of.
pub struct SystemState<'s> {
    /// What the kernel remembers.
    pub state: &'s State,
    /// What the language remembers.
    pub modes: &'s LanguageModes,
    /// The programmed position of X, Y and Z in the unit of the program; `None` where it is not known.
    pub position: [Option<f64>; 3],
    /// The machine is a lathe.
    pub turns: bool,
    /// A modal call is active.
    pub has_modal_call: bool,
    /// The level of the running program: 0 for the main program.
    pub level: usize,
    /// Which parameters the call of the running program gives.
    pub passed_parameters: &'s [bool],
}

/// The indices of an address as texts: numbers, and names of axes and parts of frames in upper case.
pub fn index_keys(address: &Address, indices: &[i64]) -> Vec<String> {
    let name_of = |place: usize| match &address.indices.get(place)?.kind {
        ExpressionKind::Variable(name) => Some(name.name.to_string()),
        _ => None,
    };
    let key = |(place, index): (usize, &i64)| match *index {
        NAMED_INDEX => name_of(place).unwrap_or_default(),
        index => index.to_string(),
    };
    indices.iter().enumerate().map(key).collect()
}

/// The value of a system variable; `None` when it depends on the machine.
pub fn system_value(
    system: &SystemState<'_>,
    name: &str,
    keys: &[String],
) -> Option<SinumerikValue> {
    let state = system.state;
    let number = |place: usize| keys.get(place)?.parse::<u32>().ok();
    let whole = |value: u32| SinumerikValue::Integer(value as i32);
    Some(match name {
        "$P_EP" => SinumerikValue::Real(system.position[linear_axis(keys.first()?)?]?),
        "$P_GG" => whole(group_index(system, number(0)?)?),
        "$P_F" => SinumerikValue::Real(feed(state)?),
        "$P_S" => SinumerikValue::Real(Some(state.rpm).filter(|_| !state.unknown.speed)?),
        "$P_TOOLNO" => whole(Some(state.tool).filter(|_| !state.unknown.tool)?),
        "$P_TOOLP" => whole(state.selected_tool?),
        "$P_TOOL" => whole(system.modes.edge),
        "$P_TOOLR" => {
            let number = edge_offset_number(state.tool, system.modes.edge)?;
            SinumerikValue::Real(state.offsets.radius_mm(number)?)
        }
        "$P_MC" => SinumerikValue::Boolean(system.has_modal_call),
        "$P_AXN1" | "$P_AXN2" | "$P_AXN3" => {
            let (a, b, normal) = state.plane.axes();
            let place = usize::from(name.as_bytes()[6] - b'1');
            SinumerikValue::Axis(AXIS_NAMES[[a, b, normal][place]].to_string())
        }
        "$P_SIM" => SinumerikValue::Boolean(true),
        "$P_SEARCH" | "$P_ISTEST" | "$P_DRYRUN" => SinumerikValue::Boolean(false),
        "$P_STACK" | "$P_PROGLEVEL" => SinumerikValue::Integer(system.level as i32),
        "$P_SUBPAR" => {
            let place = (number(0)? as usize).checked_sub(1)?;
            SinumerikValue::Boolean(system.passed_parameters.get(place).copied().unwrap_or(false))
        }
        "$P_UIFRNUM" => whole(offset_index(state.offsets.active())?),
        "$P_UIFR" => SinumerikValue::Real(settable_value(system, keys)?),
        "$MN_SCALING_SYSTEM_IS_METRIC" => SinumerikValue::Boolean(true),
        _ => return tool_value(state, name, number(0)?, number(1)?, system.turns),
    })
}

/// The index of one of the linear axes.
pub fn linear_axis(name: &str) -> Option<usize> {
    AXIS_NAMES[..3].iter().position(|axis| *axis == name)
}

/// The feed in the unit of F: per minute, or per revolution.
fn feed(state: &State) -> Option<f64> {
    let feed = state.feed?;
    Some(match state.feed_mode {
        FeedMode::PerTime | FeedMode::InverseTime => feed * 60.0,
        FeedMode::PerRevolution => feed,
    })
}

/// The settable frame of an index: 1 for G54, 5 for G505; `None` for G500 and others.
pub fn settable_name(index: u32) -> Option<WorkName> {
    match index {
        0 => Some(WorkName::G(500)),
        1..=4 => Some(WorkName::G(53 + index as u16)),
        5..=99 => Some(WorkName::G(500 + index as u16)),
        _ => None,
    }
}

fn offset_index(name: WorkName) -> Option<u32> {
    Some(name.ordinal()).filter(|index| settable_name(*index) == Some(name))
}

/// `$P_UIFR[1,X,TR]`: the translation of a settable frame in mm. The rotation and the fine translation are 0, the scale
/// is 1, as long as the program writes no other.
fn settable_value(system: &SystemState<'_>, keys: &[String]) -> Option<f64> {
    let [index, axis, part] = keys else { return None };
    let axis = linear_axis(axis)?;
    match part.as_str() {
        "TR" => {
            let offsets = &system.state.offsets;
            let name = settable_name(index.parse().ok()?)?;
            let is_none = name == WorkName::G(500);
            offsets.work_value(&offsets.key(name), axis).or(is_none.then_some(0.0))
        }
        "RT" | "FI" | "MI" => Some(0.0),
        "SC" => Some(1.0),
        _ => None,
    }
}

/// The place in which a G function stands in its group (NC Programming 12/2019, list of G functions).
fn group_index(system: &SystemState<'_>, group: u32) -> Option<u32> {
    let state = system.state;
    Some(match group {
        1 => match system.modes.motion {
            PathMotion::Rapid => 1,
            PathMotion::Linear => 2,
            PathMotion::Arc(TurnDirection::Cw) => 3,
            PathMotion::Arc(TurnDirection::Ccw) => 4,
            PathMotion::ThroughPoint => 5,
            PathMotion::Tangent => 15,
            _ => return None,
        },
        6 => match state.plane {
            Plane::Xy => 1,
            Plane::Zx => 2,
            Plane::Yz => 3,
        },
        7 => match state.side {
            CompensationSide::Off => 1,
            CompensationSide::Left => 2,
            CompensationSide::Right => 3,
        },
        8 => offset_index(state.offsets.active())? + 1,
        13 => match (state.units, system.modes.feed_in_units) {
            (Units::Inch, false) => 1,
            (Units::Millimetre, false) => 2,
            (Units::Inch, true) => 3,
            (Units::Millimetre, true) => 4,
        },
        14 => 1 + u32::from(state.incremental),
        15 => match state.feed_mode {
            FeedMode::InverseTime => 1,
            FeedMode::PerTime => 2,
            FeedMode::PerRevolution if state.surface_speed.is_some() => 4,
            FeedMode::PerRevolution => 3,
        },
        18 => 1 + u32::from(system.modes.intersects_corners),
        _ => return None,
    })
}

/// `$TC_DP3[tool,edge]` and its like: the data of a tool that the machine file or the program gives, mm.
fn tool_value(
    state: &State,
    name: &str,
    tool: u32,
    edge: u32,
    turns: bool,
) -> Option<SinumerikValue> {
    let tool = state.offsets.tool(edge_offset_number(tool, edge)?)?;
    let field = ToolDatum::named(name)?;
    Some(SinumerikValue::Real(field.read(tool, turns)?))
}

/// A datum of a cutting edge that acts here.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolDatum {
    /// `$TC_DP3` to `$TC_DP5`: the lengths L1, L2 and L3, by their place.
    Length(usize),
    /// `$TC_DP2`: the position of the edge of a turning tool.
    EdgePosition,
    /// `$TC_DP6`.
    Radius,
    /// `$TC_DP12` to `$TC_DP14`: the wear of the lengths.
    LengthWear(usize),
    /// `$TC_DP15`.
    RadiusWear,
}

impl ToolDatum {
    /// The datum of a system variable; `None` for those that do not act here.
    pub fn named(name: &str) -> Option<ToolDatum> {
        let number: usize = name.strip_prefix("$TC_DP")?.parse().ok()?;
        Some(match number {
            2 => ToolDatum::EdgePosition,
            3..=5 => ToolDatum::Length(number - 3),
            6 => ToolDatum::Radius,
            12..=14 => ToolDatum::LengthWear(number - 12),
            15 => ToolDatum::RadiusWear,
            _ => return None,
        })
    }

    /// The axis of a length: L1 of a mill is that of Z, L1 and L2 of a turning tool those of X and Z (Fundamentals
    /// 11/2006, 8.3).
    pub const fn axis_of_length(place: usize, turns: bool) -> usize {
        if turns { [0, 2, 1][place] } else { [2, 1, 0][place] }
    }

    fn read(self, tool: &Tool, turns: bool) -> Option<f64> {
        match self {
            ToolDatum::Length(place) => {
                let value = tool.offset[ToolDatum::axis_of_length(place, turns)];
                if place == 0 { value } else { Some(value.unwrap_or(0.0)) }
            }
            ToolDatum::EdgePosition => tool.tip.map(f64::from),
            ToolDatum::Radius if turns => tool.nose_radius_mm,
            ToolDatum::Radius => tool.diameter_mm.map(|diameter| diameter / 2.0),
            ToolDatum::LengthWear(place) => {
                Some(tool.offset_wear[ToolDatum::axis_of_length(place, turns)].unwrap_or(0.0))
            }
            ToolDatum::RadiusWear => Some(tool.diameter_wear_mm.unwrap_or(0.0) / 2.0),
        }
    }

    /// Writes the datum, mm.
    pub fn write(self, tool: &mut Tool, mm: f64, turns: bool) {
        match self {
            ToolDatum::Length(place) => {
                tool.offset[ToolDatum::axis_of_length(place, turns)] = Some(mm);
            }
            ToolDatum::EdgePosition => tool.tip = (1.0..=9.0).contains(&mm).then_some(mm as u32),
            ToolDatum::Radius if turns => tool.nose_radius_mm = Some(mm),
            ToolDatum::Radius => tool.diameter_mm = Some(2.0 * mm),
            ToolDatum::LengthWear(place) => {
                tool.offset_wear[ToolDatum::axis_of_length(place, turns)] = Some(mm);
            }
            ToolDatum::RadiusWear => tool.diameter_wear_mm = Some(2.0 * mm),
        }
    }
}
