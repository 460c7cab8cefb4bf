//! What a run remembers from block to block.

use std::collections::{BTreeMap, VecDeque};

use chordal_command::{CallPath, Position};
use chordal_diagnostics::{FileId, TextRange};
use chordal_geometry::{Plane, TurnDirection, Vec2};
use chordal_kernel::EndReason;
use chordal_kernel::frames::{FrameMap, InPlane};

use super::blank_record::BlankRecord;
use super::iso_modes::IsoModes;
use super::transformations::CoordinateChain;
use crate::geometry::{KnownElement, SolvedFreeElement};
use crate::syntax::{
    CycleValue, KlartextLabel, KlartextReader, ParameterName, PathFunction, PatternGroup,
};

/// How many elements back the words of free contours may refer to (TNC 320 34055x-06 p. 212).
pub const MAX_RECENT_ELEMENTS: usize = 64;

/// What comes after a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KlartextFlow {
    /// The next block.
    Next,
    /// The end of the run.
    End(EndReason),
}

/// Where a subprogram of the same program returns to.
#[derive(Clone, Copy, Debug)]
pub struct ReturnPlace {
    /// The block after the call: byte and line.
    pub place: (u32, u32),
    /// The chain of calls before the call.
    pub call: CallPath,
}

/// A program that runs: the main program, or a called one.
pub struct RunningKlartext<'a> {
    /// Its index among the programs.
    pub program: usize,
    /// Reads its blocks.
    pub reader: KlartextReader<'a>,
    /// The chain of calls that led here.
    pub call: CallPath,
    /// The open subprograms, the innermost last.
    pub returns: Vec<ReturnPlace>,
    /// How often each repeat (by the first byte of its block) still goes back.
    pub repeats: BTreeMap<u32, u32>,
    /// The labels: byte and line of the block after each.
    pub labels: BTreeMap<KlartextLabel, (u32, u32)>,
    /// The local parameters of the caller.
    pub callers_locals: BTreeMap<ParameterName, f64>,
    /// The caller's unit is inch.
    pub caller_is_inch: bool,
    /// The number of the last block that was read in order.
    pub last_number: Option<u32>,
}

/// A cycle that CYCL DEF has defined and a call runs.
#[derive(Clone, PartialEq, Debug)]
pub enum StoredCycle {
    /// One with parameters.
    Parameters {
        /// Its number.
        number: u32,
        /// Its values.
        values: BTreeMap<u32, CycleNumber>,
        /// Its definition.
        range: TextRange,
    },
    /// An old one.
    Lines {
        /// Its number.
        number: u32,
        /// The values of each line of its data, in the order of the text, with their letters.
        lines: BTreeMap<u32, Vec<DataValue>>,
        /// Its definition.
        range: TextRange,
    },
    /// A program (cycle 12).
    Program {
        /// Its name as written.
        name: String,
        /// Its definition.
        range: TextRange,
    },
}

/// A value of the data of an old cycle.
#[derive(Clone, PartialEq, Debug)]
pub struct DataValue {
    /// Its letters.
    pub label: String,
    /// Its value; `None` without one.
    pub value: Option<f64>,
    /// The sign of DR.
    pub direction: Option<TurnDirection>,
}

/// A value of a cycle's parameter, as written: lengths in the unit of the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CycleNumber {
    /// A number.
    Value(f64),
    /// MAX.
    Max,
    /// AUTO.
    OfTool,
}

impl CycleNumber {
    /// The value that a word gives; `None` for one that is not read.
    pub fn of(value: CycleValue, number: Option<f64>) -> Option<CycleNumber> {
        match value {
            CycleValue::Operand(_) => number.map(CycleNumber::Value),
            CycleValue::Max => Some(CycleNumber::Max),
            CycleValue::OfTool => Some(CycleNumber::OfTool),
            CycleValue::Other => None,
        }
    }
}

/// What the path functions remember.
#[derive(Clone, Debug)]
pub struct ContourMemory {
    /// CC on X, Y and Z, mm; `None` where it was not programmed.
    pub center: [Option<f64>; 3],
    /// The plane that the axes of CC have chosen; `None` for that of the tool.
    pub center_plane: Option<Plane>,
    /// The last polar radius, mm, and the last polar angle, degrees.
    pub polar: [Option<f64>; 2],
    /// The last path function, which bare axis words repeat.
    pub function: PathFunction,
    /// The direction in the plane of the tool with which the last element ended.
    pub direction: Option<Vec2>,
}

impl Default for ContourMemory {
    fn default() -> ContourMemory {
        ContourMemory {
            center: [None; 3],
            center_plane: None,
            polar: [None; 2],
            function: PathFunction::Line,
            direction: None,
        }
    }
}

/// The map from programmed coordinates to those of the preset, and back.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProgrammedFrame {
    map: FrameMap,
    inverse: FrameMap,
}

impl ProgrammedFrame {
    /// The frame that changes nothing.
    pub const IDENTITY: ProgrammedFrame =
        ProgrammedFrame { map: FrameMap::IDENTITY, inverse: FrameMap::IDENTITY };

    /// The frame with a map.
    pub fn new(map: FrameMap) -> ProgrammedFrame {
        ProgrammedFrame { map, inverse: map.inverse() }
    }

    /// The map.
    pub fn map(&self) -> &FrameMap {
        &self.map
    }

    /// The programmed coordinates of a position.
    pub fn programmed(&self, place: &Position) -> Position {
        self.inverse.point(place)
    }

    /// What it does to the circles of a plane.
    pub fn in_plane(&self, plane: Plane) -> InPlane {
        self.map.in_plane(plane)
    }

    /// The factor by which lengths in a plane become larger.
    pub fn factor(&self, plane: Plane) -> f64 {
        match self.in_plane(plane) {
            InPlane::Similar { factor, .. } => factor,
            InPlane::Unequal { largest, .. } => largest,
            InPlane::Tilted => 1.0,
        }
    }
}

/// What the language remembers from block to block in addition to the kernel.
#[derive(Clone, Debug)]
pub struct KlartextModes {
    /// The transformations in their order.
    pub chain: CoordinateChain,
    /// What they do together.
    pub frame: ProgrammedFrame,
    /// The transformations outside of a tilted plane, which are in force again when it ends; `None` without a plane.
    pub outside_plane: Option<CoordinateChain>,
    /// What the path functions remember.
    pub contour: ContourMemory,
    /// F of TOOL CALL, as programmed; `None` without one.
    pub tool_feed: Option<f64>,
    /// M136: F counts millimetres per revolution.
    pub per_revolution: bool,
    /// The program is in inches.
    pub is_inch: bool,
    /// M89: the cycle runs after each block that moves.
    pub calls_each_block: bool,
    /// The defined cycle.
    pub cycle: Option<StoredCycle>,
    /// The old cycle whose data are being read.
    pub open_cycle: Option<StoredCycle>,
    /// The positions of PATTERN DEF.
    pub pattern: Vec<PatternGroup>,
    /// The labels of the contours of cycle 14.
    pub contour_labels: Vec<KlartextLabel>,
    /// The data of cycle 20.
    pub contour_data: BTreeMap<u32, CycleNumber>,
    /// The datum table of SEL TABLE; `None` without one.
    pub datum_table: Option<String>,
    /// M97 stands in the block before: the next corner is passed without an arc.
    pub meets_corner: bool,
    /// M98 stands in the block before: the next corner is open.
    pub opens_corner: bool,
    /// RND or CHF comes next, and was requested at the end of the move before it.
    pub has_corner: bool,
    /// A jump, a call or a repeat has gone back: from here on blocks count against the budget.
    pub has_jumped_back: bool,
    /// How often each condition was met whose values are not known, by its file and its first byte.
    pub assumed_conditions: BTreeMap<(FileId, u32), u32>,
    /// The first corner of BLK FORM.
    pub blank: Option<[Option<f64>; 3]>,
    /// The blank, and what was cut of it.
    pub blank_record: BlankRecord,
    /// A tool was called.
    pub has_tool: bool,
    /// What the G codes of a DIN/ISO program leave.
    pub iso: IsoModes,
    /// FPOL on the axes of the plane, mm; `None` where it was not programmed.
    pub free_pole: Option<[f64; 2]>,
    /// The elements of a free contour that are still to be made: the first byte of the block of each, and the element;
    /// `None` where it was not solved.
    pub free_elements: VecDeque<(u32, Option<SolvedFreeElement>)>,
    /// The number of the block that is carried out; `None` without one.
    pub block_number: Option<u32>,
    /// The last elements with the numbers of their blocks, for free contours that refer to them.
    pub recent_elements: VecDeque<(u32, KnownElement)>,
}

impl Default for KlartextModes {
    fn default() -> KlartextModes {
        KlartextModes {
            chain: CoordinateChain::default(),
            frame: ProgrammedFrame::IDENTITY,
            outside_plane: None,
            contour: ContourMemory::default(),
            tool_feed: None,
            per_revolution: false,
            is_inch: false,
            calls_each_block: false,
            cycle: None,
            open_cycle: None,
            pattern: Vec::new(),
            contour_labels: Vec::new(),
            contour_data: BTreeMap::new(),
            datum_table: None,
            meets_corner: false,
            opens_corner: false,
            has_corner: false,
            has_jumped_back: false,
            assumed_conditions: BTreeMap::new(),
            blank: None,
            blank_record: BlankRecord::default(),
            has_tool: false,
            iso: IsoModes::default(),
            free_pole: None,
            free_elements: VecDeque::new(),
            block_number: None,
            recent_elements: VecDeque::new(),
        }
    }
}
