//! The control of the language, and the language itself.

use std::any::Any;
use std::sync::Arc;

use chordal_command::{AxisMask, RapidPath, Units, WorkNaming};
use chordal_diagnostics::{SourceMap, TextRange};
use chordal_kernel::rules::{
    ArcCenter, ArcRules, CompensationEntry, CompensationRules, CornerAngles, CornerMoves,
    OutsideCorner, RoundingRules, Rules, SideChange,
};
use chordal_kernel::{
    ConfiguredControl, ControlCandidate, ControlProfile, DefinedTool, ProgramName, ProgramSet,
    ProgramWriter, ProgrammingLanguage, RunOptions, SettingError, VocabularyGroup,
};
use chordal_machine::{AXES, Body, ControlName, Machine, RapidShape};

use crate::alarms::TEXTS_OF_CODES;
use crate::blank_form::blank_form;
use crate::datum_table::{is_datum_table, is_preset_table, take_preset_table};
use crate::defined_tools::defined_tools;
use crate::editing::{vocabulary_groups, word_meaning};
use crate::recognition::begins_like_klartext;
use crate::run::{KlartextPrograms, called_program_names, program_head};
use crate::settings::HeidenhainSettings;
use crate::tool_table::{is_tool_table, take_tool_table};
use crate::writer::KlartextWriter;

/// The facts of the control.
pub const HEIDENHAIN_PROFILE: ControlProfile = ControlProfile {
    name: "heidenhain",
    title: "HEIDENHAIN TNC",
    source: "iTNC 530 user's manual 340 49x, TNC 640 user's manual 34059x, TNC 426/430 user's manual 280 476",
    default_machine: "heidenhain-mill",
    alarms: TEXTS_OF_CODES,
    work_names: WorkNaming { extended: "", first: 507, by_e: false },
    turns: false,
};

/// The rules of the control.
const HEIDENHAIN_RULES: Rules = Rules {
    units: Units::Millimetre,
    starts_linear: true,
    rapid: RapidPath::Straight,
    spindle_stops_at_tool_change: true,
    outside_corner: OutsideCorner::Arc,
    compensation_entry: CompensationEntry::A,
    compensation: CompensationRules {
        offset_of_tool: true,
        side_change: SideChange::Refused,
        // M97: the offset paths meet, whatever the angle.
        corner_angles: Some(CornerAngles {
            always_meets_rad: 0.0,
            meets_rad: std::f64::consts::PI,
        }),
        ..CompensationRules::COMMON
    },
    arc: ArcRules {
        arc_center: ArcCenter::Absolute,
        // The radii were compared before, and the centre is on the bisector.
        judged_before: true,
        ..ArcRules::COMMON
    },
    corner: RoundingRules { moves: CornerMoves::LinesAndArcs, ..RoundingRules::COMMON },
    ..Rules::COMMON
};

/// The control of a machine.
#[derive(Debug)]
pub struct HeidenhainControl {
    rules: Rules,
    axes: AxisMask,
    /// Choices of the machine builder.
    pub settings: HeidenhainSettings,
}

impl ConfiguredControl for HeidenhainControl {
    fn profile(&self) -> ControlProfile {
        HEIDENHAIN_PROFILE
    }

    fn rules(&self) -> &Rules {
        &self.rules
    }

    fn axes(&self) -> AxisMask {
        self.axes
    }

    fn open<'a>(
        &'a self,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> Box<dyn ProgramSet + 'a> {
        Box::new(KlartextPrograms::new(self, self.settings, sources, machine, options))
    }

    fn program_names(&self, text: &[u8]) -> Vec<ProgramName> {
        program_head(text).map(|head| ProgramName::from(head.name)).into_iter().collect()
    }

    fn called_programs(&self, text: &[u8]) -> Vec<ProgramName> {
        called_program_names(text).into_iter().map(ProgramName::from).collect()
    }

    fn names_units(&self, text: &[u8]) -> bool {
        program_head(text).is_some()
    }

    fn subprogram_extensions(&self) -> &'static [&'static str] {
        &["h", "i"]
    }

    fn table_extensions(&self) -> &'static [&'static str] {
        &["t", "d", "pr"]
    }

    fn is_table(&self, text: &[u8]) -> bool {
        is_tool_table(text) || is_preset_table(text) || is_datum_table(text)
    }

    fn take_table(&self, text: &[u8], machine: &mut Machine) {
        match () {
            () if is_tool_table(text) => take_tool_table(text, machine),
            // Datum tables are read by the program that names one.
            () => take_preset_table(text, machine, HEIDENHAIN_PROFILE.work_names),
        }
    }

    fn defined_stock(&self, text: &[u8]) -> Option<(Body, TextRange)> {
        blank_form(text)
    }

    fn defined_tools(&self, text: &[u8]) -> Vec<DefinedTool> {
        defined_tools(text)
    }

    fn program_writer(&self) -> Option<Box<dyn ProgramWriter + '_>> {
        Some(Box::new(KlartextWriter::new(self.settings)))
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// The conversational language of HEIDENHAIN controls.
#[derive(Debug)]
pub struct HeidenhainLanguage;

impl ProgrammingLanguage for HeidenhainLanguage {
    fn title(&self) -> &'static str {
        "HEIDENHAIN conversational"
    }

    fn profile(&self, control: ControlName) -> Option<ControlProfile> {
        (control.as_str() == HEIDENHAIN_PROFILE.name).then_some(HEIDENHAIN_PROFILE)
    }

    fn configure(
        &self,
        machine: &Machine,
    ) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)> {
        self.profile(machine.control)?;
        let mut axes = AxisMask::NONE;
        (0..AXES).filter(|axis| machine.axes[*axis].is_some()).for_each(|axis| axes.insert(axis));
        let mut settings = HeidenhainSettings::DEFAULT;
        let mut refused = Vec::new();
        for (name, entry) in &machine.settings {
            if let Err(message) = settings.take(name, &entry.value) {
                let help = "it has MP7431, label_nesting, unset_parameter, positive_depth, peck_stop_mm, free_contour_order and projected_angle";
                refused.push(SettingError { name: name.clone(), message, help: Some(help.into()) });
            }
        }
        let mut rules = HEIDENHAIN_RULES;
        rules.rapid = match machine.rapid {
            Some(RapidShape::DogLeg) => RapidPath::DogLeg,
            Some(RapidShape::Straight) | None => rules.rapid,
        };
        Some((Arc::new(HeidenhainControl { rules, axes, settings }), refused))
    }

    fn word_meaning(&self, word: &str) -> Option<String> {
        word_meaning(word)
    }

    fn vocabulary_groups(&self) -> Vec<VocabularyGroup> {
        vocabulary_groups()
    }

    fn has_program_line(&self, text: &[u8]) -> bool {
        begins_like_klartext(text)
    }

    fn recognize(&self, _: &[u8]) -> Vec<ControlCandidate> {
        // The signs are searched with those of all other languages, in one pass over the text.
        Vec::new()
    }
}
