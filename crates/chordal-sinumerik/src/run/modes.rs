//! G groups, M functions, feed and speed.

use chordal_command::{
    CommandKind, CompensationSide, FeedMode, PathMode, SpindleState, Units, WorkName,
};
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::EndReason;

use super::interpreter::Interpreter;
use super::run_state::{BlockFlow, LanguageModes, PathMotion, SavedModes, TransverseReading};
use super::transformations::TRANSFORMATIONS;
use super::words::{BlockWords, ValueWord};
use crate::syntax::ValueFunction;

/// The group of a G code (Fundamentals, list of G functions); `None` for codes that are not known.
fn group_of(code: u32) -> Option<u32> {
    Some(match code {
        0..=3 | 33..=35 | 331 | 332 | 335 | 336 => 1,
        25 | 26 => 3,
        4
        | 5
        | 7
        | 63
        | 74
        | 75
        | 751
        | 147
        | 148
        | 247
        | 248
        | 347
        | 348
        | 110..=112
        | 58
        | 59 => 2,
        17..=19 => 6,
        40..=42 => 7,
        54..=57 | 500 | 505..=599 => 8,
        53 | 153 => 9,
        60 | 64 | 641..=645 => 10,
        9 => 11,
        601..=603 => 12,
        70 | 71 | 700 | 710 => 13,
        90 | 91 => 14,
        93..=97 | 931 | 942 | 952 | 961 | 962 | 971..=973 => 15,
        450 | 451 => 18,
        140..=143 => 40,
        340 | 341 => 44,
        290 | 291 => 47,
        460..=462 => 48,
        62 | 621 => 57,
        810..=829 => 31,
        _ => return None,
    })
}

impl Interpreter<'_> {
    /// Millimetres of a length of one.
    pub(super) fn unit_mm(&self) -> f64 {
        self.kernel.state.units.mm()
    }

    /// Millimetres of one in the word of an axis: half on the transverse axis of a lathe where it is a diameter.
    pub(super) fn unit_of_axis(&self, axis: usize, word: &ValueWord) -> f64 {
        let unit = self.unit_mm();
        if axis != 0 || !self.kernel.machine.turns() {
            return unit;
        }
        let is_distance = word.is_incremental(self.kernel.state.incremental);
        let is_diameter = match word.function {
            Some(ValueFunction::AbsoluteDiameter | ValueFunction::IncrementalDiameter) => true,
            Some(ValueFunction::AbsoluteRadius | ValueFunction::IncrementalRadius) => false,
            _ => match self.modes.transverse {
                TransverseReading::Radius => false,
                TransverseReading::Diameter => true,
                TransverseReading::DiameterOfCoordinates => !is_distance,
            },
        };
        if is_diameter { unit / 2.0 } else { unit }
    }

    /// Sets the G groups of a block.
    pub(super) fn set_modes(&mut self, words: &BlockWords) {
        self.modes.machine_block = words.has_name("SUPA");
        let mut seen: Vec<(u32, u32)> = Vec::new();
        for (code, range) in &words.g_codes {
            let Some(group) = group_of(*code) else {
                let message = format!("there is no G function G{code}");
                self.alarm(12470, Code::UnknownCode, *range, message);
                continue;
            };
            if let Some((other, _)) =
                seen.iter().find(|(other, own)| *own == group && other != code)
            {
                let message = format!("G{other} and G{code} are of one group and in one block");
                self.alarm(12060, Code::SameGroup, *range, message);
                continue;
            }
            seen.push((*code, group));
            self.set_mode(*code, *range, words);
        }
        self.check_groups_of_names(words, &seen);
        self.check_alone(words);
        for (name, range) in &words.names {
            self.set_named_mode(name, *range);
        }
        self.check_centers(words);
        if let Some(radius) = words.other("RNDM") {
            self.modes.modal_rounding_mm = radius.value * self.unit_mm();
        }
    }

    fn set_mode(&mut self, code: u32, range: TextRange, words: &BlockWords) {
        let span = self.span(range);
        match code {
            0 => self.modes.motion = PathMotion::Rapid,
            1 => self.modes.motion = PathMotion::Linear,
            2 => self.modes.motion = PathMotion::Arc(TurnDirection::Cw),
            3 => self.modes.motion = PathMotion::Arc(TurnDirection::Ccw),
            4 => self.dwell(range, words),
            9 => self.kernel.change_path_mode(|path| path.once = true),
            17 => self.kernel.set_plane(span, Plane::Xy),
            18 => self.kernel.set_plane(span, Plane::Zx),
            19 => self.kernel.set_plane(span, Plane::Yz),
            53 | 153 => self.modes.machine_block = true,
            54..=57 | 500 | 505..=599 => self.kernel.select_work(WorkName::G(code as u16)),
            60 => self.kernel.change_path_mode(|path| path.set_mode(PathMode::ExactStop)),
            64 => self.continuous(None),
            641..=645 => {
                let distance = words.other("ADIS").map(|word| word.value * self.unit_mm());
                self.continuous(distance);
            }
            70 | 700 => self.kernel.set_units(Units::Inch),
            71 | 710 => self.kernel.set_units(Units::Millimetre),
            90 => self.kernel.set_incremental(false),
            91 => self.kernel.set_incremental(true),
            93 => self.kernel.set_feed_mode(FeedMode::InverseTime),
            94 => self.kernel.set_feed_mode(FeedMode::PerTime),
            95 => self.kernel.set_feed_mode(FeedMode::PerRevolution),
            96 => {
                self.kernel.set_feed_mode(FeedMode::PerRevolution);
                self.kernel.keep_surface_speed();
            }
            97 => self.kernel.keep_spindle_speed(),
            450 | 451 => {
                let meets = code == 451;
                if std::mem::replace(&mut self.modes.intersects_corners, meets) != meets {
                    self.kernel.emit(CommandKind::CornerMode { meets, opens: false });
                }
            }
            33 | 331 | 332 => self.modes.motion = PathMotion::Thread,
            63 => {}
            34 | 35 => self.modes.motion = PathMotion::ChangingThread { grows: code == 34 },
            335 | 336 | 5 | 7 => {
                self.modes.motion = PathMotion::NotFollowed;
                self.not_followed(
                    range,
                    format!("G{code} is not followed: its ends are shown as straight cuts"),
                );
            }
            147 | 148 | 247 | 248 | 347 | 348 => {
                self.not_followed(range, format!("G{code} is not followed"));
            }
            291 => self.skip_iso_mode(range),
            // What they set acts in blocks of their own, or on nothing that is simulated.
            _ => {}
        }
        if matches!(code, 70 | 71 | 700 | 710) {
            self.modes.feed_in_units = matches!(code, 700 | 710);
        }
    }

    fn continuous(&mut self, tolerance_mm: Option<f64>) {
        let mode = PathMode::Continuous { tolerance_mm, joined: false };
        self.kernel.change_path_mode(|path| path.set_mode(mode));
    }

    fn set_named_mode(&mut self, name: &str, range: TextRange) {
        match name {
            "CIP" => self.modes.motion = PathMotion::ThroughPoint,
            "CT" => self.modes.motion = PathMotion::Tangent,
            "NORM" => self.modes.approaches_round = false,
            "KONT" => self.modes.approaches_round = true,
            "KONTC" | "KONTT" => self.not_followed(
                range,
                format!("{name} is not followed: compensation begins as with NORM"),
            ),
            "ASPLINE" | "BSPLINE" | "CSPLINE" | "POLY" | "INVCW" | "INVCCW" => {
                self.modes.motion = PathMotion::NotFollowed;
                self.not_followed(
                    range,
                    format!("{name} is not followed: its points are joined by straight cuts"),
                );
            }
            "ORIVECT" => self.modes.turns_in_plane = true,
            "ORIAXES" => self.modes.turns_in_plane = false,
            "DIAMON" | "DIAM90" if !self.kernel.machine.turns() => self
                .not_followed(range, format!("{name} is not followed: this machine is no lathe")),
            "DIAMON" => self.modes.transverse = TransverseReading::Diameter,
            "DIAM90" => self.modes.transverse = TransverseReading::DiameterOfCoordinates,
            "DIAMOF" => self.modes.transverse = TransverseReading::Radius,
            _ if TRANSFORMATIONS.contains(&name) => self.choose_transformation(name, &[], range),
            _ => {}
        }
    }

    /// G4 F seconds, G4 S revolutions.
    fn dwell(&mut self, range: TextRange, words: &BlockWords) {
        let seconds = match (words.other("F"), words.other("S")) {
            (Some(seconds), _) => seconds.value,
            (None, Some(turns)) if self.kernel.state.rpm > 0.0 => {
                turns.value * 60.0 / self.kernel.state.rpm
            }
            (None, Some(_)) if self.kernel.state.unknown.speed => 0.0,
            (None, Some(_)) => {
                return self.alarm(
                    10900,
                    Code::SpindleStopped,
                    range,
                    "a dwell in revolutions, and the spindle has no speed",
                );
            }
            (None, None) => return self.alarm(12110, Code::MissingWord, range, "G4 needs F or S"),
        };
        self.kernel.emit(CommandKind::Dwell { seconds: seconds.max(0.0), label: None });
    }

    /// F and S, which G4 uses itself.
    pub(super) fn set_feed_and_speed(&mut self, words: &BlockWords) {
        if words.g_codes.iter().any(|(code, _)| *code == 4) {
            return;
        }
        if let Some(limit) = words.other("LIMS") {
            self.kernel.limit_speed(limit.value);
        }
        if let Some(speed) = words.other("S") {
            let master = self.modes.master_spindle;
            if self.kernel.state.surface_speed.is_some() && !self.is_live(master) {
                self.kernel.set_surface_speed(speed.value * 1000.0 / 60.0);
            } else {
                self.set_spindle_speed(master, speed.value);
            }
        }
        let keeps_surface = words.g_codes.iter().any(|(code, _)| *code == 96);
        if keeps_surface
            && !self.modes.is_state_unknown
            && self.kernel.state.surface_speed.is_none_or(|speed| speed <= 0.0)
        {
            let message = "G96 needs S, the cutting speed";
            self.alarm(10900, Code::SpindleStopped, self.here(), message);
        }
        let is_of_thread = matches!(self.modes.motion, PathMotion::ChangingThread { .. });
        if let Some(feed) = words.other("F").filter(|_| !is_of_thread) {
            self.set_feed_word(feed.value, feed.range);
        }
    }

    /// F.
    pub(super) fn set_feed_word(&mut self, feed: f64, range: TextRange) {
        let unit = if self.modes.feed_in_units { self.unit_mm() } else { 1.0 };
        let value = match self.kernel.state.feed_mode {
            FeedMode::PerTime => feed * unit / 60.0,
            FeedMode::PerRevolution => feed * unit,
            FeedMode::InverseTime => feed / 60.0,
        };
        let angular = (feed / 60.0).to_radians();
        self.kernel.set_feed(self.span(range), value, angular);
    }

    /// The M functions that act before the motion.
    pub(super) fn functions_before(&mut self, words: &BlockWords) {
        self.spindles_before(words);
        let master = self.modes.master_spindle;
        for (code, range) in &words.m_codes {
            match code {
                3 => self.turn_spindle(master, SpindleState::Cw),
                4 => self.turn_spindle(master, SpindleState::Ccw),
                6 => self.change_tool(*range),
                7 => self.kernel.set_coolant(|coolant| coolant.mist = true),
                8 => self.kernel.set_coolant(|coolant| coolant.flood = true),
                19 => self.kernel.set_spindle(SpindleState::Oriented),
                _ => {}
            }
        }
    }

    /// The M functions that act after the motion, and `RET`.
    pub(super) fn functions_after(&mut self, words: &BlockWords) -> BlockFlow {
        self.spindles_after(words);
        let mut flow = BlockFlow::Next;
        for (code, _) in &words.m_codes {
            match code {
                0 | 1 => self.kernel.emit(CommandKind::Stop { optional: *code == 1 }),
                5 => self.turn_spindle(self.modes.master_spindle, SpindleState::Off),
                9 => self.kernel.set_coolant(|coolant| *coolant = Default::default()),
                2 | 17 | 30 => flow = self.end_of_program(),
                _ => {}
            }
        }
        if words.has_name("RET") {
            flow = self.end_of_program();
        }
        flow
    }

    /// M2, M17, M30, RET: in a subprogram a return.
    fn end_of_program(&mut self) -> BlockFlow {
        match self.program_ends() {
            BlockFlow::End(_) => {
                self.kernel.state.side = CompensationSide::Off;
                BlockFlow::End(EndReason::ProgramEnd)
            }
            next => next,
        }
    }

    /// Ends what acts in one block only.
    pub(super) fn end_block_modes(&mut self, words: &BlockWords) {
        self.modes.machine_block = false;
        if words.g_codes.iter().any(|(code, _)| *code == 9) {
            self.kernel.end_exact_stop_once();
        }
    }

    /// The modes that `SAVE` keeps.
    pub(super) fn saved_modes(&self) -> SavedModes {
        let state = &self.kernel.state;
        SavedModes {
            modes: self.modes.clone(),
            plane: state.plane,
            tilted_plane: self.kernel.tilted_plane(),
            units: state.units,
            incremental: state.incremental,
            feed_mode: state.feed_mode,
            work: state.offsets.active(),
            path: state.path,
        }
    }

    /// Restores the modes that `SAVE` keeps. The tool stays.
    pub(super) fn restore_modes(&mut self, saved: SavedModes) {
        let span = self.span(self.here());
        let LanguageModes { has_jumped_back, edge, unknown_tool, master_spindle, .. } = self.modes;
        self.modes =
            LanguageModes { has_jumped_back, edge, unknown_tool, master_spindle, ..saved.modes };
        let feed = self.kernel.state.feed;
        self.kernel.set_plane(span, saved.plane);
        if self.kernel.tilted_plane() != saved.tilted_plane {
            self.kernel.set_tilted_plane(saved.tilted_plane);
        }
        self.kernel.set_units(saved.units);
        self.kernel.set_incremental(saved.incremental);
        if self.kernel.state.feed_mode != saved.feed_mode {
            self.kernel.set_feed_mode(saved.feed_mode);
        } else {
            self.kernel.state.feed = feed;
        }
        self.kernel.select_work(saved.work);
        if self.kernel.state.path != saved.path {
            self.kernel.change_path_mode(|path| *path = saved.path);
        }
    }
}
