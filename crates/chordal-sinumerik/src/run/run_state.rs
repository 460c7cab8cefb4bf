//! What a run remembers from block to block.

use std::collections::BTreeMap;

use chordal_command::{CallPath, FeedMode, Units, WorkName};
use chordal_diagnostics::TextRange;
use chordal_geometry::{Plane, Transform, TurnDirection};
use chordal_kernel::frames::FrameMap;
use chordal_kernel::{EndReason, PathState};

use super::programmable_frame::ProgrammableFrame;
use crate::syntax::{Address, BlockReader, Expression};
use crate::values::SinumerikValue;

/// The number of the spindle that turns the part of a lathe.
pub const MAIN_SPINDLE: u32 = 1;

/// What comes after a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockFlow {
    /// The next block.
    Next,
    /// The end of the run.
    End(EndReason),
}

/// A program that runs: the main program, or a called one.
pub struct RunningProgram<'a> {
    /// Its index among the programs.
    pub program: usize,
    /// Reads its blocks.
    pub reader: BlockReader<'a>,
    /// The loops that are open, the innermost last.
    pub loops: Vec<OpenLoop>,
    /// The parts that are repeated, the innermost last.
    pub repeats: Vec<PartRepeat>,
    /// How often it is still run again (`P`).
    pub passes_left: u32,
    /// The chain of calls that led here.
    pub call: CallPath,
    /// The modes at the call, which `SAVE` restores.
    pub saved: Option<Box<SavedModes>>,
    /// The caller's variables that get the values of `VAR` parameters at the return: name here, name there.
    pub references: Vec<(String, String)>,
    /// Which of its parameters the call gives.
    pub passed_parameters: Vec<bool>,
    /// The calls stand in a modal call: it does not act on them.
    pub is_modal_call: bool,
    /// The branches that are open, as far as no jump was made.
    pub open_branches: u32,
    /// A jump was made, so that a structure may end that was not begun.
    pub has_jumped: bool,
    /// The ends of loops by the first byte of their body, as far as they were looked for.
    pub loop_ends: BTreeMap<u32, u32>,
    /// Labels and block numbers by their name, made at the first jump.
    pub targets: Option<BTreeMap<String, Vec<(u32, u32)>>>,
}

impl<'a> RunningProgram<'a> {
    /// A program at the reader's place, run once.
    pub fn new(program: usize, reader: BlockReader<'a>, call: CallPath) -> RunningProgram<'a> {
        RunningProgram {
            program,
            reader,
            loops: Vec::new(),
            repeats: Vec::new(),
            passes_left: 0,
            call,
            saved: None,
            references: Vec::new(),
            passed_parameters: Vec::new(),
            is_modal_call: false,
            open_branches: 0,
            has_jumped: false,
            loop_ends: BTreeMap::new(),
            targets: None,
        }
    }
}

/// A loop whose end has not been reached.
#[derive(Clone, Debug)]
pub struct OpenLoop {
    /// The first block after its head: byte and line.
    pub body: (u32, u32),
    /// What decides whether it goes on.
    pub kind: LoopKind,
}

/// What decides whether a loop goes on.
#[derive(Clone, Debug)]
pub enum LoopKind {
    /// `FOR`: the variable and its last value.
    Counted(Address, f64),
    /// `WHILE`: the condition.
    While(Expression),
    /// `REPEAT … UNTIL`.
    Until,
    /// `LOOP`.
    Endless,
}

/// The cycle or program that runs after each block with path motion (`MCALL`).
#[derive(Clone, Debug)]
pub struct ModalCycle {
    /// Its name in upper case.
    pub name: String,
    /// Its arguments, evaluated at the `MCALL`.
    pub arguments: Vec<Option<SinumerikValue>>,
}

/// A part of a program that is repeated (`REPEAT LABEL`).
#[derive(Clone, Debug)]
pub struct PartRepeat {
    /// Its first block: byte and line.
    pub start: (u32, u32),
    /// The block after which it ends, by its first byte.
    pub last: u32,
    /// How often it still runs.
    pub left: u32,
    /// Where the program goes on: byte and line.
    pub resume: (u32, u32),
}

/// The motion of blocks with axis words.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PathMotion {
    /// G0.
    Rapid,
    /// G1, which is active at power-on (MD20150).
    Linear,
    /// G2 and G3.
    Arc(TurnDirection),
    /// CIP.
    ThroughPoint,
    /// CT.
    Tangent,
    /// G33, G331 and G332.
    Thread,
    /// G34 and G35.
    ChangingThread {
        /// The lead becomes greater.
        grows: bool,
    },
    /// A motion that is not carried out; its ends are taken as straight cuts.
    NotFollowed,
}

/// Whether X is programmed as a diameter, on a lathe.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TransverseReading {
    /// DIAMOF: a radius.
    Radius,
    /// DIAMON: a diameter.
    Diameter,
    /// DIAM90: a diameter where it is a coordinate, a radius where it is a distance.
    DiameterOfCoordinates,
}

/// What `SAVE` keeps: the modal G functions and the frames.
#[derive(Clone, Debug)]
pub struct SavedModes {
    /// The modes of the language.
    pub modes: LanguageModes,
    /// G17, G18, G19.
    pub plane: Plane,
    /// The plane that CYCLE800 has tilted on a machine with rotary axes.
    pub tilted_plane: Option<Transform>,
    /// G70, G71.
    pub units: Units,
    /// G90, G91.
    pub incremental: bool,
    /// G93, G94, G95.
    pub feed_mode: FeedMode,
    /// G54 and its like.
    pub work: WorkName,
    /// G60, G64 and their like.
    pub path: PathState,
}

/// What the language remembers from block to block in addition to the kernel.
#[derive(Clone, Debug)]
pub struct LanguageModes {
    /// The motion.
    pub motion: PathMotion,
    /// What all frames after the settable one do together: the swivelled plane, and in it the programmable frame.
    pub frame: ProgrammableFrame,
    /// `frame` changes nothing.
    pub is_plain_frame: bool,
    /// The programmable frame: TRANS, ROT and their like.
    pub programmable: FrameMap,
    /// The frame of a swivelled plane (CYCLE800).
    pub swivel: FrameMap,
    /// KONT: compensation begins and ends round the start and the end of the contour.
    pub approaches_round: bool,
    /// Where compensation with KONT began, as long as the direction of the contour is not known.
    pub open_approach: Option<OpenApproach>,
    /// The pole of polar coordinates, mm, programmed coordinates.
    pub pole: [f64; 3],
    /// The polar angle in force, degrees; `None` before one.
    pub polar_angle: Option<f64>,
    /// The polar radius in force, mm; `None` before one.
    pub polar_radius: Option<f64>,
    /// The radius of modal roundings, mm; 0 for none.
    pub modal_rounding_mm: f64,
    /// The axis and the lead of the last thread, mm; `None` before one.
    pub lead: Option<(usize, f64)>,
    /// The additive part of the programmable frame's shift (G59), mm.
    pub additive_shift: [f64; 3],
    /// DIAMON, DIAMOF and DIAM90.
    pub transverse: TransverseReading,
    /// G700 and G710: the unit acts on feeds, too.
    pub feed_in_units: bool,
    /// This block is without settable and programmable frame (G53, G153, SUPA).
    pub machine_block: bool,
    /// The direction in which the last move ended, programmed coordinates of the plane, for CT.
    pub last_direction: Option<[f64; 3]>,
    /// G451: outside corners of compensation end at the intersection.
    pub intersects_corners: bool,
    /// A loop, a jump or a repeat has gone back: from here on blocks count against the budget.
    pub has_jumped_back: bool,
    /// What the caller, or a program that is not given, has set is not known: tool, edge, feed, speed, modal cycle.
    pub is_state_unknown: bool,
    /// ORIVECT: the tool turns in the plane of its two directions; otherwise the rotary axes turn evenly (ORIAXES).
    pub turns_in_plane: bool,
    /// The edge that is active; 0 for none.
    pub edge: u32,
    /// The tool in the spindle has a name that no tool of the machine file has.
    pub unknown_tool: bool,
    /// The spindle to which S and M3, M4, M5 belong (SETMS).
    pub master_spindle: u32,
}

/// A move on which compensation begins with KONT.
#[derive(Clone, Copy, Debug)]
pub struct OpenApproach {
    /// Where it starts in the plane, mm.
    pub from: [f64; 2],
    /// The side of the tool: 1 for left, -1 for right.
    pub side: f64,
    /// The text of the code.
    pub range: TextRange,
}

impl LanguageModes {
    /// Sets the programmable frame and the frame of the swivelled plane.
    pub fn set_frames(&mut self, programmable: FrameMap, swivel: FrameMap) {
        (self.programmable, self.swivel) = (programmable, swivel);
        self.frame = ProgrammableFrame::new(programmable.then(&swivel));
        self.is_plain_frame = self.frame == ProgrammableFrame::IDENTITY;
    }
}

impl Default for LanguageModes {
    fn default() -> LanguageModes {
        LanguageModes {
            motion: PathMotion::Linear,
            frame: ProgrammableFrame::IDENTITY,
            is_plain_frame: true,
            programmable: FrameMap::IDENTITY,
            swivel: FrameMap::IDENTITY,
            approaches_round: false,
            open_approach: None,
            pole: [0.0; 3],
            polar_angle: None,
            polar_radius: None,
            modal_rounding_mm: 0.0,
            lead: None,
            additive_shift: [0.0; 3],
            transverse: TransverseReading::Radius,
            feed_in_units: false,
            machine_block: false,
            last_direction: None,
            intersects_corners: false,
            has_jumped_back: false,
            is_state_unknown: false,
            turns_in_plane: false,
            edge: 0,
            unknown_tool: false,
            master_spindle: MAIN_SPINDLE,
        }
    }
}
