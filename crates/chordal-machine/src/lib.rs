//! The data of a machine in a shop: axes and their limits, feeds, tools, work offsets and the settings of the control, as
//! plain data read from TOML.
//!
//! Internally, lengths are in millimetres, times in seconds and angles in radians. In a machine file every quantity is a
//! text with its unit (`"0.5 in"`, `"25 m/min"`), so no number is read in the wrong unit. Each conversion is correctly
//! rounded: there is only one rounding, at the end.
//!
//! One table of rows ([`schema_reference`] prints it) defines the keys of a machine file. Checks, suggestions for
//! misspelt keys, [`Machine::set`], [`Machine::to_toml`] and the reference use this table.
//!
//! ```
//! use chordal_machine::Machine;
//!
//! let text = "inherits = 'haas-vf2'\n[tools.5]\ndiameter = '0.5 in'";
//! let no_files = |name: &str| Err(format!("no file {name}"));
//! let mut machine = Machine::from_toml("mine.toml", text, &no_files).unwrap();
//! assert_eq!(machine.tools[&5].diameter_mm, Some(12.7));
//!
//! machine.set("feed.max = 300 in/min").unwrap();
//! assert_eq!(machine.feed.max_mm_per_s, Some(127.0));
//!
//! let error = machine.set("feed.max = 300").unwrap_err();
//! assert_eq!(error.message, "`feed.max` takes a velocity; `300` has no unit");
//! ```
//!
//! The crate does not access files: the caller passes the text, and a `loader` for the files that `inherits` names.
#![forbid(unsafe_code)]

mod assign;
mod axis;
mod axis_change;
mod builtin;
mod check;
mod controls;

mod control;
mod decimal;
mod designated_tool;
mod designation;
mod error;
mod files;
mod kinematics;
mod machine;
mod motion;
mod offset;
mod quantity;
mod read;
mod rotary;
mod schema;
mod setup;
mod solid;
mod suggest;
mod toml_text;
mod tool;
mod tool_tbl;
mod turning;
mod value;
mod variable_dump;
mod write;

pub use axis::{AXES, AXIS_LETTERS, AXIS_NAMES, Axis, PerAxis};
pub use builtin::{builtin, builtin_names};
pub use chordal_kinematics::{KinematicChain, RolloverRule};
pub use control::{ControlName, RegisteredControl, UnknownControl};
pub use designation::{
    DesignationError, HolderDesignation, HolderKind, InsertDesignation, InsertLetter, ToolHand,
    WrittenDesignation, clearance_degrees,
};
pub use error::{MachineError, ValueLocation};
pub use kinematics::KinematicsError;
pub use machine::{
    AxisLimits, CustomCodeSpec, DiameterProgramming, FeedLimits, LinearCarriers, Machine,
    MachineNotices, Macros, NonMotionTimes, Probe, ProbeHit, RapidShape, RotaryAxis, RotaryTarget,
    StartingKinematics, Switches, TcpFrame, Turret, WorkOffset,
};
pub use motion::MotionSettings;
pub use offset::work_offset_name;
pub use quantity::{QuantityDimension, QuantityError, parse_quantity};
pub use rotary::{ToolRotation, part_transform, tool_rotations};
pub use schema::{SchemaKey, schema_keys, schema_reference};
pub use setup::{Body, BodyShape, ContourPoint, CuttingForce, MeshUnit, Setup};
pub use solid::{LinearOrder, MachineSolid, MachineSolidShape, SolidLink};
pub use tool::{Cutter, HolderSegment, Tool, ToolShape};
pub use tool_tbl::read_tool_tbl;
pub use turning::{ToolFacing, TurningTool, mirrored_tip};
pub use value::{SettingEntry, SettingValue};
pub use variable_dump::{BadLine, VariableDump, read_variable_dump};
