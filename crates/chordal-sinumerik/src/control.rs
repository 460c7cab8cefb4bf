//! The controls of the language, and the language itself.

use std::any::Any;
use std::sync::Arc;

use chordal_command::{AxisMask, RapidPath, Units, WorkNaming};
use chordal_diagnostics::{Code, SourceMap};
use chordal_geometry::Plane;
use chordal_kernel::rules::{
    ArcRules, CompensationEntry, CompensationRules, CornerAngles, CornerMoves, LengthRules,
    OutsideCorner, RoundingRules, Rules, SideChange,
};
use chordal_kernel::{
    ConfiguredControl, ControlCandidate, ControlProfile, ProgramName, ProgramSet, ProgramWriter,
    ProgrammingLanguage, RunOptions, SettingError, VocabularyGroup, WordCompletion,
};
use chordal_machine::{AXES, ControlName, Machine, RapidShape};

use crate::alarms::listed_text;
use crate::cycles::{CYCLES, CycleSignature};
use crate::machine_tables::take_table;
use crate::run::SinumerikPrograms;
use crate::settings::SinumerikSettings;
use crate::syntax::{BlockReader, StatementKind, is_table_text, units};
use crate::vocabulary::{meaning_of, words};
use crate::writer::PartProgramWriter;

/// The facts of the control.
pub const PROFILE: ControlProfile = ControlProfile {
    name: "sinumerik",
    title: "Sinumerik 840D",
    source: "NC Programming 12/2019, Job Planning 07/2010, Fundamentals and Cycles 11/2006, Diagnostics 03/2013",
    default_machine: "sinumerik-mill",
    alarms: &[
        (Code::MissingFeed, listed_text(10860)),
        (Code::RadiusMismatch, listed_text(14040)),
        (Code::TravelExceeded, listed_text(10720)),
        (Code::InsideArcTooSmall, listed_text(10751)),
        (Code::CompensationInterference, listed_text(10751)),
        (Code::TooManyIdleBlocks, listed_text(10762)),
        (Code::NoOffsetIntersection, listed_text(10751)),
    ],
    work_names: WorkNaming { extended: "", first: 507, by_e: false },
    turns: false,
};

/// The facts of the control of a lathe.
pub const LATHE_PROFILE: ControlProfile = ControlProfile {
    name: "sinumerik-lathe",
    title: "Sinumerik 840D, lathe",
    default_machine: "sinumerik-lathe",
    turns: true,
    ..PROFILE
};

/// The rules of the control of a lathe.
const LATHE_RULES: Rules = Rules { starts_in: Plane::Zx, ..RULES };

/// The rules of the control: MD20150 at its defaults.
const RULES: Rules = Rules {
    units: Units::Millimetre,
    starts_linear: true,
    rapid: RapidPath::Straight,
    outside_corner: OutsideCorner::Arc,
    compensation_entry: CompensationEntry::A,
    compensation: CompensationRules {
        corner_of_next: true,
        // Infeeds between the blocks of a corner are carried out at the start of its arc (Fundamentals 11/2006, 8.10).
        moves_before_corner: true,
        offset_of_tool: true,
        side_change: SideChange::Along,
        // MD20230 and MD20210 at their defaults.
        corner_angles: Some(CornerAngles {
            always_meets_rad: 10.0_f64.to_radians(),
            meets_rad: 100.0_f64.to_radians(),
        }),
        ..CompensationRules::COMMON
    },
    arc: ArcRules {
        arc_center: chordal_kernel::rules::ArcCenter::Absolute,
        // The radii were compared before, and the centre is on the bisector.
        judged_before: true,
        ..ArcRules::COMMON
    },
    corner: RoundingRules {
        moves: CornerMoves::LinesAndArcs,
        shortens: true,
        ..RoundingRules::COMMON
    },
    length: LengthRules::COMMON,
    ..Rules::COMMON
};

/// The control of a machine.
#[derive(Debug)]
pub struct SinumerikControl {
    profile: ControlProfile,
    rules: Rules,
    axes: AxisMask,
    /// Choices of the machine builder.
    pub settings: SinumerikSettings,
}

impl ConfiguredControl for SinumerikControl {
    fn profile(&self) -> ControlProfile {
        self.profile
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
        Box::new(SinumerikPrograms::new(self, self.settings, sources, machine, options))
    }

    fn program_names(&self, text: &[u8]) -> Vec<ProgramName> {
        units(text).into_iter().filter_map(|unit| unit.name).map(ProgramName::from).collect()
    }

    fn called_programs(&self, text: &[u8]) -> Vec<ProgramName> {
        let mut names: Vec<ProgramName> = Vec::new();
        let mut reader = BlockReader::new(text);
        loop {
            reader.skip_lines_without_calls();
            let Some(block) = reader.next() else { break };
            for statement in block.statements {
                let name = match statement.kind {
                    StatementKind::Call(call) | StatementKind::ModalCall(Some(call)) => call.name,
                    StatementKind::Name(name) => name,
                    StatementKind::Word(word) if word.address.name == "L" => {
                        String::from_utf8_lossy(statement.range.slice(text)).to_ascii_uppercase()
                    }
                    _ => continue,
                };
                if !crate::vocabulary::is_known_name(&name)
                    && crate::cycles::cycle_signature(&name).is_none()
                {
                    names.push(ProgramName::from(name));
                }
            }
        }
        names.sort();
        names.dedup();
        names
    }

    fn names_units(&self, _: &[u8]) -> bool {
        // G71 is in force at power-on (MD20150).
        true
    }

    fn subprogram_extensions(&self) -> &'static [&'static str] {
        &["spf", "mpf"]
    }

    fn table_extensions(&self) -> &'static [&'static str] {
        &["def", "gud", "ini", "toa", "uif", "rpa"]
    }

    fn is_table(&self, text: &[u8]) -> bool {
        is_table_text(text)
    }

    fn take_table(&self, text: &[u8], machine: &mut Machine) {
        take_table(text, self.profile.work_names, machine);
    }

    fn program_writer(&self) -> Option<Box<dyn ProgramWriter + '_>> {
        Some(Box::new(PartProgramWriter::new(self.settings)))
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// The language of Sinumerik part programs.
#[derive(Debug)]
pub struct SinumerikLanguage;

impl ProgrammingLanguage for SinumerikLanguage {
    fn title(&self) -> &'static str {
        "Sinumerik"
    }

    fn profile(&self, control: ControlName) -> Option<ControlProfile> {
        [PROFILE, LATHE_PROFILE].into_iter().find(|profile| control.as_str() == profile.name)
    }

    fn configure(
        &self,
        machine: &Machine,
    ) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)> {
        let profile = self.profile(machine.control)?;
        let mut axes = AxisMask::NONE;
        (0..AXES).filter(|axis| machine.axes[*axis].is_some()).for_each(|axis| axes.insert(axis));
        let mut settings =
            if profile.turns { SinumerikSettings::LATHE } else { SinumerikSettings::DEFAULT };
        let mut rules = if profile.turns { LATHE_RULES } else { RULES };
        let mut refused = Vec::new();
        for (name, entry) in &machine.settings {
            if let Err(message) = settings.take(name, &entry.value) {
                let help = Some("it has MD22550, MD28050 and undefined_names".to_string());
                refused.push(SettingError { name: name.clone(), message, help });
            }
        }
        // MD20730: G0 is a straight line (1), or each axis moves on its own (0).
        rules.rapid = match machine.rapid {
            Some(RapidShape::DogLeg) => RapidPath::DogLeg,
            Some(RapidShape::Straight) | None => rules.rapid,
        };
        let control = SinumerikControl { profile, rules, axes, settings };
        Some((Arc::new(control), refused))
    }

    fn word_meaning(&self, word: &str) -> Option<String> {
        meaning_of(&word.trim().to_ascii_uppercase())
    }

    fn vocabulary_groups(&self) -> Vec<VocabularyGroup> {
        let row = |word: &str, meaning: String| WordCompletion { word: word.into(), meaning };
        let cycle = |cycle: &CycleSignature| {
            let names: Vec<&str> = cycle.parameters.iter().map(|own| own.name).collect();
            row(cycle.name, format!("{}: {}", cycle.title, names.join(", ")))
        };
        vec![
            VocabularyGroup {
                title: "Words",
                words: words().map(|(word, meaning)| row(word, meaning.to_string())).collect(),
            },
            VocabularyGroup {
                title: "Cycles, with their parameters in order",
                words: CYCLES.iter().map(cycle).collect(),
            },
        ]
    }

    fn has_program_line(&self, text: &[u8]) -> bool {
        const BEGINNINGS: [&[u8]; 6] = [b"%_N_", b"MCALL", b"CYCLE", b"TRANS", b"DEF ", b"PROC "];
        text.split(|byte| matches!(byte, b'\n' | b'\r')).any(|line| {
            let line = line.trim_ascii_start();
            BEGINNINGS.iter().any(|beginning| {
                line.get(..beginning.len())
                    .is_some_and(|start| start.eq_ignore_ascii_case(beginning))
            })
        })
    }

    fn recognize(&self, _: &[u8]) -> Vec<ControlCandidate> {
        // The signs are searched with those of all other languages, in one pass over the text.
        Vec::new()
    }
}
