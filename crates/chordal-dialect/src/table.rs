//! A control as data: its codes, its words, its alarms, its settings.

use crate::action::{Action, AfterCode, LengthCode, ModeCode, OnceCode, TiltedPlaneCode};
use crate::block_order::{BUILDER_ORDER, BlockOrder};
use crate::command_line::CommandLine;
use crate::firmware::Firmware;
use crate::macros::MacroRules;
use crate::parameters::Parameters;
use crate::post::PostTemplate;
use crate::recognition::{MachineKind, RecognitionEvidence};
use crate::settings::Setting;
use crate::spatial::SpatialRules;
use crate::surface::SurfaceRules;
use crate::tilted_plane::TiltedPlaneRules;
use crate::word_rules::WordRule;
use chordal_command::WorkNaming;
use chordal_diagnostics::Code;
use chordal_geometry::{AXIS_LETTERS, TurnDirection};
use chordal_kernel::{Alarms, ControlProfile, ToolValue};
use chordal_syntax::{Block, Decimal, Letters, Lexicon};

/// A modal group: codes of one group exclude each other.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum CodeGroup {
    OneShot,
    Motion,
    Plane,
    Distance,
    ArcDistance,
    FeedMode,
    Units,
    Compensation,
    ToolLength,
    Cycle,
    ReturnLevel,
    Scaling,
    WorkOffset,
    PathMode,
    Rotation,
    Mirror,
    Polar,
    ModalCall,
    FeedRamp,
    SpindleMode,
    Diameter,
    // From here on M codes.
    Stopping,
    Spindle,
    Coolant,
    ToolChange,
    Calling,
    Auxiliary,
}

/// One G or M code of a control.
#[derive(Clone, Copy, Debug)]
pub struct CodeRow {
    /// The code in tenths: G54.1 is 541.
    pub code: u16,
    /// Its modal group.
    pub group: CodeGroup,
    /// What it does.
    pub action: Action,
    /// Letters that it takes, apart from the axes and F.
    pub words: Letters,
    /// One line for users.
    pub title: &'static str,
}

impl CodeRow {
    /// Whether it uses the axis words of its block itself. A code without effect or that is not simulated does so
    /// if its row names the axes; other axis words of its block are a move.
    pub const fn takes_axes(&self) -> bool {
        matches!(
            self.action,
            Action::Once(_) | Action::NotFollowed | Action::Length(LengthCode::FromAxes)
        ) || matches!(self.action, Action::NoEffect | Action::NotSimulated) && self.words.has(b'X')
    }

    /// Whether it ends the program.
    pub const fn ends_program(&self) -> bool {
        matches!(self.action, Action::After(AfterCode::ProgramEnd { .. }))
    }

    /// The index of the reference point that it sets to the present position, 0 or 1; `None` for other codes.
    pub const fn stored_reference(&self) -> Option<usize> {
        let Action::Mode(ModeCode::StoreReference { second }) = self.action else { return None };
        Some(second as usize)
    }

    /// Whether it defines a tilted plane, perhaps together with the blocks after it.
    pub const fn defines_plane(&self) -> bool {
        matches!(self.action, Action::Once(OnceCode::TiltedPlane(TiltedPlaneCode::Define { .. })))
    }

    /// Its name with its letter: `G54.1`.
    pub fn name(&self, letter: u8) -> String {
        code_name(letter, self.code)
    }
}

/// The name of a code in tenths: `G54.1`.
pub fn code_name(letter: u8, code: u16) -> String {
    let (letter, whole) = (char::from(letter), code / 10);
    if code.is_multiple_of(10) {
        format!("{letter}{whole}")
    } else {
        format!("{letter}{whole}.{}", code % 10)
    }
}

/// A number as a code in tenths: 541 for `54.1`. `None` if no code can have the number.
pub fn code_number(number: Decimal) -> Option<u16> {
    let tenths = match number.scale {
        0 => number.mantissa.checked_mul(10)?,
        1 => number.mantissa,
        scale => {
            let power = 10_i64.checked_pow(u32::from(scale) - 1)?;
            if number.mantissa % power != 0 {
                return None;
            }
            number.mantissa / power
        }
    };
    u16::try_from(tenths).ok()
}

/// The letters of a code whose words are not checked.
pub const ANY_WORDS: &str = "XYZABCIJKPQRLDHE";

/// A row of a code table; the code in tenths.
pub const fn row(
    code: u16,
    group: CodeGroup,
    action: Action,
    words: &'static str,
    title: &'static str,
) -> CodeRow {
    CodeRow { code, group, action, words: Letters::of(words), title }
}

/// Where an L word repeats its block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LineRepeat {
    /// Nowhere.
    None,
    /// In the main program only.
    MainProgram,
    /// Everywhere.
    Anywhere,
}

/// How subroutines are written, apart from M98.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SubroutineForm {
    /// There are none.
    None,
    /// Sections `L100`, `L200`, … before the main program, each ended by M17, all of them by M30. `L201` calls
    /// subroutine 2; its last two digits are the repeats.
    LetterL,
}

/// A fixed subroutine that an L word calls by its number; the last two digits are a parameter of it (Fadal).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FixedRoutine {
    /// Probing: checked, not simulated.
    Probe,
    /// Engraving: checked, not simulated.
    Engrave,
    /// The active cycle at the holes of a bolt circle.
    BoltCircle,
    /// Bore milling.
    Bore(TurnDirection),
    /// A rectangular pocket.
    Rectangle(TurnDirection),
    /// A circular pocket.
    Circle(TurnDirection),
}

/// How motion codes cancel each other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MotionModality {
    /// Each cancels the others.
    Exclusive,
    /// G0 and G1 cancel each other; G2 and G3 only set a direction, which a block uses if it has a centre or a
    /// radius.
    Armed,
}

/// What `G10 L…` writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DataTarget {
    /// Work offset P; 0 is the external one.
    WorkOffset,
    /// Work offset P, set so that the present position has the given coordinates.
    WorkOffsetFromPosition,
    /// Extended work offset P.
    ExtendedWorkOffset,
    /// A value of tool P.
    Tool(ToolValue),
    /// Length and radius of tool P, by the letters Z and R (LinuxCNC).
    ToolTable,
    /// Geometry or wear of a turning tool, by the letters of the axes, R and Q (Haas lathes).
    TurningTool {
        /// Wear, otherwise geometry.
        wear: bool,
    },
    /// Offsets of tool P, set so that the present position has the given work coordinates.
    ToolFromPosition,
    /// The same, with coordinates in the ninth work coordinate system, that of the fixture.
    ToolFromFixture,
    /// Nothing: the tool table is read again.
    Reload,
    /// A register R0 to R9 (Fadal L100 to L109).
    Register,
    /// Something that is not simulated and changes neither path nor position.
    Other,
    /// A register that words may name, with a value of the control (Fadal L13 to L15).
    IntoRegister,
    /// The lines that follow, up to the code that ends them, are data for the control such as parameters.
    Lines,
}

/// A word that may hold the time of a dwell.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DwellWord {
    /// The letter.
    pub letter: u8,
    /// Seconds of one unit written without a decimal point.
    pub integer_s: f64,
    /// Seconds of one unit written with a decimal point.
    pub point_s: f64,
    /// A decimal point may be written; otherwise it is an alarm.
    pub takes_point: bool,
}

impl DwellWord {
    /// Seconds of one unit of a number with or without a decimal point.
    pub fn unit_s(self, has_point: bool) -> f64 {
        if has_point { self.point_s } else { self.integer_s }
    }
}

/// Everything that defines a control.
#[derive(Debug)]
pub struct ControlTable {
    /// Its name in machine files.
    pub name: &'static str,
    /// Its name for users.
    pub title: &'static str,
    /// Where its facts come from.
    pub source: &'static str,
    /// How its text is divided into words and comments.
    pub lexicon: Lexicon,
    /// Its G codes in ascending order.
    pub g_codes: &'static [CodeRow],
    /// Its M codes in ascending order.
    pub m_codes: &'static [CodeRow],
    /// Its parameters before the settings of a machine file.
    pub parameters: Parameters,
    /// The settings that a machine file may have for this control alone.
    pub settings: &'static [Setting],
    /// The alarm that it shows for a diagnostic. `{n}` is the block's N number, `{move}` the kind of move; of two
    /// texts separated by ` / ` the first is for arcs.
    pub alarms: &'static [(Code, &'static str)],
    /// The scale factor that `1` without a decimal point means.
    pub scale_unit: f64,
    /// How motion codes cancel each other.
    pub motion: MotionModality,
    /// G90 and G91 act on the words after them, and both may be in one block; otherwise each acts on its whole
    /// block.
    pub distance_left_to_right: bool,
    /// Where an L word repeats its block.
    pub line_repeat: LineRepeat,
    /// How subroutines are written, apart from M98.
    pub subroutines: SubroutineForm,
    /// Fixed subroutines by the hundreds of the L word that calls them.
    pub fixed_routines: &'static [(u32, FixedRoutine)],
    /// Letters of axes that words may name.
    pub axis_letters: &'static str,
    /// What P means on an arc.
    pub arc_turns: ArcTurns,
    /// Centre words outside the plane are an alarm; otherwise they are ignored.
    pub strict_center_words: bool,
    /// What G10 writes, by its L.
    pub set_data: &'static [(u16, DataTarget)],
    /// The words that may hold the time of G4.
    pub dwell: &'static [DwellWord],
    /// G4 without a time is an exact stop; otherwise an alarm.
    pub dwell_alone_stops: bool,
    /// M codes that are not in the table are taken for those of the machine builder or the shop; otherwise they are
    /// an alarm.
    pub open_m_codes: bool,
    /// Of several codes of one group in a block the last one counts; otherwise they are an alarm.
    pub last_of_group_counts: bool,
    /// The order in which it carries out what a block says.
    pub order: BlockOrder,
    /// Codes in tenths that must be the only G code of their block.
    pub alone: &'static [u16],
    /// How its firmware checks a whole block before anything of it acts; `None` where words act one by one.
    pub firmware: Option<&'static Firmware>,
    /// How it reads a line as one command with its words; `None` where a block may have several codes.
    pub command_line: Option<&'static CommandLine>,
    /// What it requires of the words of a code.
    pub word_rules: &'static [WordRule],
    /// What it refuses of a rotation about an axis in space; `None` where it has no such rotation.
    pub spatial: Option<&'static SpatialRules>,
    /// The alarms about tilted planes.
    pub tilted_plane: TiltedPlaneRules,
    /// The alarm of an absolute angle of a whole turn or more on an axis that rolls over by sign, with `{value}` and
    /// `{axis}`; `None` where such angles are taken as those within the turn.
    pub rollover_beyond_turn: Option<&'static str>,
    /// Polar interpolation; `None` where it has none.
    pub face: Option<&'static SurfaceRules>,
    /// Cylindrical interpolation; `None` where it has none.
    pub cylinder: Option<&'static SurfaceRules>,
    /// How its work offsets are named.
    pub work_names: WorkNaming,
    /// How its programs are numbered.
    pub program_numbers: ProgramNumbers,
    /// The word of M98 that gives the label to start at (H on a Mitsubishi); `None` where there is none.
    pub call_start_label: Option<u8>,
    /// How it carries out macros.
    pub macros: &'static MacroRules,
    /// The alarms that it shows for refused turning cycles.
    pub turning_alarms: &'static [(TurnFault, &'static str)],
    /// Its G code systems other than that of the table.
    pub systems: &'static [CodeSystem],
    /// Cycles that drill along X, in tenths.
    pub radial_cycles: &'static [u16],
    /// Codes of the second spindle, which is not simulated: the letter, and the code in tenths.
    pub second_spindle: &'static [(u8, u16)],
    /// Codes of tapping with a live tool, in tenths.
    pub live_taps: &'static [u16],
    /// What distinguishes programs of its kind of machine (lathes, GRBL) from others; `None` where nothing has to
    /// be shown before its own signs count.
    pub kind: Option<&'static MachineKind>,
    /// Signs by which its programs are recognized.
    pub evidence: &'static [RecognitionEvidence],
    /// The lines that it needs around a program.
    pub post: &'static PostTemplate,
    /// The built-in machine for programs of which only the control is known.
    pub default_machine: &'static str,
}

/// A G code system other than that of the table, as its differences (Fanuc lathes B and C).
#[derive(Clone, Copy, Debug)]
pub struct CodeSystem {
    /// Its name.
    pub name: &'static str,
    /// The codes that differ from those of the table.
    pub codes: &'static [CodeRow],
    /// The codes of the table that it does not have, in tenths.
    pub without: &'static [u16],
}

/// Why a turning cycle is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TurnFault {
    /// The depth of a pass is missing.
    Depth,
    /// P or Q is missing.
    NoContour,
    /// The block that P or Q names does not exist.
    NoLabel,
    /// The contour turns back along Z, or along X in G72.
    TurnsBack,
    /// X turns back in a contour of type I.
    NotMonotone,
    /// The contour has no moves, or its first block has none.
    FirstBlock,
    /// The contour has a code that is not allowed in it.
    CodeInContour,
    /// The number of passes of a repeated contour is out of range.
    Passes,
    /// The distance of the plunges is missing.
    Step,
    /// The height or the first depth of a thread is missing or not positive, or the thread has no length.
    ThreadDepth,
    /// The smallest depth of a thread pass is more than its height.
    ThreadLeast,
    /// The angle of a thread is out of range.
    ThreadAngle,
    /// The lead falls to zero before the end of the thread (G34).
    Lead,
    /// A cycle of one pass has a word of an axis that it does not move.
    PassAxis,
}

/// The largest number after O.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramNumbers {
    /// The largest number after O.
    pub largest: u32,
    /// Digits of the number in the list of the control, with leading zeros.
    pub digits: usize,
    /// A program needs a number; otherwise a file without one is a program, too.
    pub required: bool,
}

/// What P means on an arc.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArcTurns {
    /// Nothing.
    None,
    /// Full turns in addition to the arc's own.
    Extra,
    /// Full turns in addition to the angle from start to end. Where start and end coincide the angle is zero: they
    /// are all turns (Mitsubishi M700V 6.6 (3), p. 53).
    BeyondAngle,
    /// All turns, the arc's own counted as one.
    Total,
}

impl ControlTable {
    /// What most controls share. The name, the codes, the signs and whatever else each control has of its own are
    /// empty.
    pub const COMMON: ControlTable = ControlTable {
        name: "",
        title: "",
        source: "",
        lexicon: Lexicon::COMMON,
        g_codes: &[],
        m_codes: &[],
        parameters: Parameters::COMMON,
        settings: &[],
        alarms: &[],
        scale_unit: 1.0,
        motion: MotionModality::Exclusive,
        distance_left_to_right: false,
        line_repeat: LineRepeat::None,
        subroutines: SubroutineForm::None,
        fixed_routines: &[],
        axis_letters: AXIS_LETTERS,
        arc_turns: ArcTurns::None,
        strict_center_words: false,
        set_data: &[],
        dwell: &[],
        dwell_alone_stops: false,
        open_m_codes: false,
        last_of_group_counts: false,
        order: BUILDER_ORDER,
        alone: &[],
        firmware: None,
        command_line: None,
        word_rules: &[],
        spatial: None,
        tilted_plane: TiltedPlaneRules {
            twice: None,
            format: None,
            without_plane: None,
            unreachable: None,
            rotary_with_vector: None,
            vector_in_fixed_frame: None,
            arc_while_turning: None,
        },
        rollover_beyond_turn: None,
        face: None,
        cylinder: None,
        work_names: WorkNaming { extended: "G54.1", first: 1, by_e: false },
        program_numbers: ProgramNumbers { largest: 9999, digits: 4, required: true },
        call_start_label: None,
        macros: &MacroRules::NONE,
        turning_alarms: &[],
        systems: &[],
        radial_cycles: &[],
        second_spindle: &[],
        live_taps: &[],
        kind: None,
        evidence: &[],
        post: &PostTemplate::EMPTY,
        default_machine: "",
    };

    /// The words that may hold the time of a dwell, in the units that the parameters set.
    pub fn dwell_words(&self, parameters: &Parameters) -> impl Iterator<Item = DwellWord> {
        let factor = parameters.dwell_factor;
        self.dwell.iter().map(move |word| DwellWord {
            integer_s: word.integer_s * factor,
            point_s: word.point_s * factor,
            ..*word
        })
    }

    /// The row of a G code in tenths; `None` if the table does not have it.
    pub fn g_code(&self, code: u16) -> Option<&'static CodeRow> {
        let index = self.g_codes.binary_search_by_key(&code, |row| row.code).ok()?;
        Some(&self.g_codes[index])
    }

    /// The row of an M code in tenths; `None` if the table does not have it.
    pub fn m_code(&self, code: u16) -> Option<&'static CodeRow> {
        let index = self.m_codes.binary_search_by_key(&code, |row| row.code).ok()?;
        Some(&self.m_codes[index])
    }

    /// Whether a block is `G10 L50`: the lines after it are data.
    pub fn begins_data(&self, block: &Block) -> bool {
        let l = block.word(b'L').and_then(|word| word.number()?.to_integer());
        let lines = |(number, target): &(u16, DataTarget)| {
            Some(i64::from(*number)) == l && *target == DataTarget::Lines
        };
        self.set_data.iter().any(lines)
            && block.all(b'G').any(|word| {
                let row = word.number().and_then(code_number).and_then(|code| self.g_code(code));
                row.is_some_and(|row| row.action == Action::Once(OnceCode::SetData))
            })
    }

    /// What the stages after the language know of it.
    pub fn profile(&self) -> ControlProfile {
        ControlProfile {
            name: self.name,
            title: self.title,
            source: self.source,
            default_machine: self.default_machine,
            alarms: self.alarms,
            work_names: self.work_names,
            turns: self.turns(),
        }
    }

    /// Whether it is the control of a lathe.
    pub fn turns(&self) -> bool {
        self.kind.is_some_and(|kind| kind.turns)
    }

    /// The alarm that the control shows for a diagnostic; `None` if it is not known.
    pub fn alarm(&self, code: Code) -> Option<&'static str> {
        Alarms { title: self.title, texts: self.alarms }.text(code)
    }
}
