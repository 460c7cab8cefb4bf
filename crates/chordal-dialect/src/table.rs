//! A control as data: its codes, its words, its alarms, its settings.

use crate::action::{Action, AfterCode, LengthCode, ModeCode, OnceCode};
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
use crate::word_rules::WordRule;
use chordal_command::WorkNaming;
use chordal_diagnostics::Code;
use chordal_geometry::{AXIS_LETTERS, TurnDirection};
use chordal_kernel::{Alarms, ToolValue};
use chordal_syntax::{Block, Decimal, Letters, Lexicon};

/// Codes of one group exclude each other. The numbers are Fanuc's and Haas's.
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
    /// M codes.
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
    /// Ten times the number: G54.1 is 541.
    pub code: u16,
    /// Codes of one group exclude each other.
    pub group: CodeGroup,
    /// What it does.
    pub action: Action,
    /// Letters beside the axes and F that it takes.
    pub words: Letters,
    /// One line for people.
    pub title: &'static str,
}

impl CodeRow {
    /// It takes the axis words of its block for itself. A code without effect or that is not simulated does
    /// so where its row names the axes; other axis words of its block move.
    pub const fn takes_axes(&self) -> bool {
        matches!(
            self.action,
            Action::Once(_) | Action::NotFollowed | Action::Length(LengthCode::FromAxes)
        ) || matches!(self.action, Action::NoEffect | Action::NotSimulated) && self.words.has(b'X')
    }

    /// It ends the program.
    pub const fn ends_program(&self) -> bool {
        matches!(self.action, Action::After(AfterCode::ProgramEnd { .. }))
    }

    /// Which reference point it stores the present position as: 0 or 1.
    pub const fn stored_reference(&self) -> Option<usize> {
        let Action::Mode(ModeCode::StoreReference { second }) = self.action else { return None };
        Some(second as usize)
    }

    /// Its name under its letter: `G54.1`.
    pub fn name(&self, letter: u8) -> String {
        code_name(letter, self.code)
    }
}

/// A code by ten times its number: `G54.1`.
pub fn code_name(letter: u8, code: u16) -> String {
    let (letter, whole) = (char::from(letter), code / 10);
    if code.is_multiple_of(10) {
        format!("{letter}{whole}")
    } else {
        format!("{letter}{whole}.{}", code % 10)
    }
}

/// Ten times a code's number, as the tables count it: 541 of `54.1`. Nothing for numbers that no code has.
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

/// The letters of a code whose words are not looked at.
pub const ANY_WORDS: &str = "XYZABCIJKPQRLDHE";

/// Writes a row of a code table.
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

/// How subroutines are written beside M98.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SubroutineForm {
    /// There are none.
    None,
    /// Sections `L100`, `L200`, … before the main program, ended by M17, the whole by M30;
    /// called by `L201` (subroutine, two digits of repeats).
    LetterL,
}

/// A fixed routine that a word L calls by its number, the last two digits for itself (Fadal).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FixedRoutine {
    /// Probing: judged, not shown.
    Probe,
    /// Engraving: judged, not shown.
    Engrave,
    /// The cycle in force on a circle.
    BoltCircle,
    /// Bore milling.
    Bore(TurnDirection),
    /// A rectangular pocket.
    Rectangle(TurnDirection),
    /// A circular pocket.
    Circle(TurnDirection),
}

/// How motion codes are modal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MotionModality {
    /// Each cancels the others.
    Exclusive,
    /// G0 and G1 cancel each other; G2 and G3 arm a direction, which a block takes when it
    /// has a centre or a radius.
    Armed,
}

/// What `G10 L…` writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DataTarget {
    /// Work offset P (0 the external one).
    WorkOffset,
    /// Work offset P, so that the present position gets the given coordinates.
    WorkOffsetFromPosition,
    /// Extended work offset P.
    ExtendedWorkOffset,
    /// A value of tool P.
    Tool(ToolValue),
    /// Length and radius by the letters Z and R (LinuxCNC).
    ToolTable,
    /// Geometry or wear of a turning tool, by the letters of the axes, R and Q (Haas lathes).
    TurningTool {
        /// Its wear.
        wear: bool,
    },
    /// Offsets of a tool, so that the present position gets these work coordinates.
    ToolFromPosition,
    /// The same in the ninth work offset, that of the fixture.
    ToolFromFixture,
    /// The tool table is read again.
    Reload,
    /// A register R0 … R9 (Fadal L100–L109).
    Register,
    /// Something that is not simulated, and changes neither path nor position.
    Other,
    /// A value of the control is read into a register that words may name (Fadal L13 to L15).
    IntoRegister,
    /// The lines up to the code that ends it are data for the control: parameters and the like.
    Lines,
}

/// Time words of a dwell.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DwellWord {
    /// The letter.
    pub letter: u8,
    /// Seconds in one unit without a decimal point.
    pub integer_s: f64,
    /// Seconds in one unit with a decimal point.
    pub point_s: f64,
    /// A decimal point may be written; otherwise it is an alarm.
    pub takes_point: bool,
}

impl DwellWord {
    /// Seconds in one unit of a number that has a decimal point or none.
    pub fn unit_s(self, has_point: bool) -> f64 {
        if has_point { self.point_s } else { self.integer_s }
    }
}

/// Everything that makes a control.
#[derive(Debug)]
pub struct ControlTable {
    /// Name in machine files.
    pub name: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// Where its facts come from.
    pub source: &'static str,
    /// How its text is written.
    pub lexicon: Lexicon,
    /// Its G codes in order.
    pub g_codes: &'static [CodeRow],
    /// Its M codes in order.
    pub m_codes: &'static [CodeRow],
    /// Its numbers and habits.
    pub parameters: Parameters,
    /// The settings that a machine file may name.
    pub settings: &'static [Setting],
    /// What it shows for a diagnostic; `{n}` is the block's N number, `{move}` the kind of
    /// move; of two texts with ` / ` between the first is for arcs.
    pub alarms: &'static [(Code, &'static str)],
    /// What one is in a scale factor without a decimal point.
    pub scale_unit: f64,
    /// How motion codes are modal.
    pub motion: MotionModality,
    /// G90 and G91 act from left to right within the block.
    pub distance_left_to_right: bool,
    /// G90 and G91 may stand in one block.
    pub line_repeat: LineRepeat,
    /// Subroutines beside M98.
    pub subroutines: SubroutineForm,
    /// Fixed routines by the hundreds of the L word that calls them.
    pub fixed_routines: &'static [(u32, FixedRoutine)],
    /// Letters of axes that words may name.
    pub axis_letters: &'static str,
    /// P on an arc: further full turns (`extra`) or all turns.
    pub arc_turns: ArcTurns,
    /// Centre words outside the plane are an alarm, not passed over.
    pub strict_center_words: bool,
    /// G10's targets by L.
    pub set_data: &'static [(u16, DataTarget)],
    /// Time words of G4.
    pub dwell: &'static [DwellWord],
    /// G4 without a time is an exact stop, not an alarm.
    pub dwell_alone_stops: bool,
    /// M codes that the table does not have are those of the machine builder or the shop, not an alarm.
    pub open_m_codes: bool,
    /// Of several codes of a group in a block the last one counts, without an alarm.
    pub last_of_group_counts: bool,
    /// In which order it carries out what a block says.
    pub order: BlockOrder,
    /// Codes that must be the only G code of their block.
    pub alone: &'static [u16],
    /// How its firmware judges a block as a whole before anything of it acts; nothing where words act one by one.
    pub firmware: Option<&'static Firmware>,
    /// How it takes a line as one command with its words; nothing where a block may have several codes.
    pub command_line: Option<&'static CommandLine>,
    /// What it asks of the words of a code.
    pub word_rules: &'static [WordRule],
    /// What it refuses of a rotation about an axis in space; nothing where it has none.
    pub spatial: Option<&'static SpatialRules>,
    /// Polar interpolation; nothing where it has none.
    pub face: Option<&'static SurfaceRules>,
    /// Cylindrical interpolation; nothing where it has none.
    pub cylinder: Option<&'static SurfaceRules>,
    /// How its work offsets are named; with `by_e` a word E chooses one.
    pub work_names: WorkNaming,
    /// How its programs are numbered.
    pub program_numbers: ProgramNumbers,
    /// Start label word of M98 (Mitsubishi H).
    pub call_start_label: Option<u8>,
    /// Its macro language.
    pub macros: &'static MacroRules,
    /// What it shows where a cycle of a lathe is refused.
    pub turning_alarms: &'static [(TurnFault, &'static str)],
    /// Its other systems of G codes by name, each as what it has otherwise.
    pub systems: &'static [CodeSystem],
    /// Cycles that drill along X, ten times the number.
    pub radial_cycles: &'static [u16],
    /// Codes of the second spindle, which is not followed: the letter and ten times the number.
    pub second_spindle: &'static [(u8, u16)],
    /// Taps that turn a live tool, ten times the number.
    pub live_taps: &'static [u16],
    /// How its programs are distinguished from those of other machines, where signs must show that first: lathes, GRBL.
    pub kind: Option<&'static MachineKind>,
    /// Signs by which its programs are recognized.
    pub evidence: &'static [RecognitionEvidence],
    /// How it wants a program begun and ended.
    pub post: &'static PostTemplate,
    /// The built-in machine that a program is run on when only its control is known.
    pub default_machine: &'static str,
}

/// A system of G codes beside that of the table (Fanuc lathes B and C).
#[derive(Clone, Copy, Debug)]
pub struct CodeSystem {
    /// Its name.
    pub name: &'static str,
    /// The codes that it has otherwise.
    pub codes: &'static [CodeRow],
    /// The codes of the table that it does not have, ten times the number.
    pub without: &'static [u16],
}

/// Why a cycle of a lathe is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TurnFault {
    /// No depth of a pass.
    Depth,
    /// P or Q is missing.
    NoContour,
    /// A label of P or Q is not there.
    NoLabel,
    /// The contour turns back along Z, or along X in G72.
    TurnsBack,
    /// X turns back in a contour of type I.
    NotMonotone,
    /// The contour has no moves, or its first block is none.
    FirstBlock,
    /// A code that may not be in a contour.
    CodeInContour,
    /// The passes of a repeated contour.
    Passes,
    /// The distance of the plunges.
    Step,
    /// Depth or height of a thread.
    ThreadDepth,
    /// The least depth of a thread pass is more than its height.
    ThreadLeast,
    /// The angle of a thread.
    ThreadAngle,
    /// A lead that falls to nothing before the end of a thread (G34).
    Lead,
    /// An axis that the pass of one block does not have.
    PassAxis,
}

/// How programs are numbered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramNumbers {
    /// The largest number behind O.
    pub largest: u32,
    /// Digits of the number as the control lists it, with zeros in front.
    pub digits: usize,
    /// A program has a number; without, it may be a text alone.
    pub required: bool,
}

/// What P means on an arc.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArcTurns {
    /// Nothing.
    None,
    /// Further full turns beside the arc's own.
    Extra,
    /// Full turns beside the angle from start to end, which is zero where both are one point: then they are all turns
    /// (Mitsubishi M700V 6.6 (3), p. 53).
    BeyondAngle,
    /// All turns, the arc's own counted as one.
    Total,
}

impl ControlTable {
    /// What most controls share. The name, the codes, the signs and what else belongs to one control
    /// alone are empty: each control gives its own.
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

    /// The time words of a dwell, in the units that the parameters give them.
    pub fn dwell_words(&self, parameters: &Parameters) -> impl Iterator<Item = DwellWord> {
        let factor = parameters.dwell_factor;
        self.dwell.iter().map(move |word| DwellWord {
            integer_s: word.integer_s * factor,
            point_s: word.point_s * factor,
            ..*word
        })
    }

    /// The row of a G code (ten times its number).
    pub fn g_code(&self, code: u16) -> Option<&'static CodeRow> {
        let index = self.g_codes.binary_search_by_key(&code, |row| row.code).ok()?;
        Some(&self.g_codes[index])
    }

    /// The row of an M code (ten times its number).
    pub fn m_code(&self, code: u16) -> Option<&'static CodeRow> {
        let index = self.m_codes.binary_search_by_key(&code, |row| row.code).ok()?;
        Some(&self.m_codes[index])
    }

    /// `G10 L50`: the lines after this block are data.
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

    /// It is the control of a lathe.
    pub fn turns(&self) -> bool {
        self.kind.is_some_and(|kind| kind.turns)
    }

    /// What the control shows for a diagnostic.
    pub fn alarm(&self, code: Code) -> Option<&'static str> {
        Alarms { title: self.title, texts: self.alarms }.text(code)
    }
}
