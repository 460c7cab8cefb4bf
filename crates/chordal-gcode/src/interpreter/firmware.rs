//! Blocks that a firmware checks as a whole before any word acts.

use chordal_command::{AxisMask, FeedMode, WorkName};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::firmware::Firmware;
use chordal_dialect::{Action, CodeGroup, MotionCode, ToolChanger};
use chordal_kernel::EndReason;
use chordal_machine::Axis;
use chordal_syntax::{Block, BlockKind, Decimal, Word, WordValue};

use super::{BlockFlow, Interpreter};
use crate::firmware::{FirmwareAnswer, FirmwareChecker, LineFault};

impl Interpreter<'_> {
    /// Adds the checker of the control's firmware in its state at power-on, if it has one.
    pub(super) fn with_judge(mut self) -> Self {
        let Some(firmware) = self.control.table.firmware else { return self };
        let state = &self.kernel.state;
        let place = [0, 1, 2].map(|axis| state.machine_position(axis));
        let systems: Vec<[f64; 3]> = (0..firmware.largest[2] as u16)
            .map(|number| {
                let name =
                    if number < 6 { WorkName::G(54 + number) } else { WorkName::G59(number - 5) };
                let key = state.offsets.key(name);
                [0, 1, 2].map(|axis| state.offsets.work_value(&key, axis).unwrap_or(0.0))
            })
            .collect();
        self.judge = Some(FirmwareChecker::new(place, &systems));
        self
    }

    /// `$H`: moves to the limit switches, Z first.
    fn home_machine(&mut self) {
        let place = self.reference(1);
        let axes = self.control.axes();
        let z = AxisMask(1 << (Axis::Z as usize)).and(axes);
        for named in [z, axes.without(z)] {
            self.kernel.go_to_reference(named, &place);
        }
        let state = &self.kernel.state;
        let position = [0, 1, 2].map(|axis| state.machine_position(axis));
        if let Some(judge) = &mut self.judge {
            judge.set_position(position);
        }
    }

    /// Checks a block with the firmware. `None` when it acts, with the words the firmware has read; otherwise how to
    /// continue.
    pub(super) fn judged_by_firmware(&mut self, block: &mut Block) -> Option<BlockFlow> {
        let firmware = self.control.table.firmware?;
        let build = self.control.parameters.build;
        let resolved = build.expressions && block.expressions;
        if build.expressions {
            // Statements and comments with an effect contain no words to check.
            let speaks = block.words.is_empty() && !block.comments.is_empty();
            if matches!(block.kind, BlockKind::Macro(_)) || speaks {
                return None;
            }
            // The firmware cannot check a block of which words are unknown.
            if resolved && self.resolve_words(block) {
                return None;
            }
            if self.kernel.state.unknown.feed {
                self.judge.as_mut()?.assume_feed();
            }
        }
        if build.tool_table {
            let lengths = self.kernel.state.offsets.tool_in_force();
            self.judge.as_mut()?.set_length([0, 1, 2].map(|axis| lengths[axis]));
        }
        let deletes = self.machine.switches.block_delete[0];
        let text = self.reader.text();
        let verdict =
            self.judge.as_mut()?.take(block, text, self.control, firmware, deletes, resolved);
        match verdict {
            FirmwareAnswer::Words(dropped) => {
                self.check_change_by_sender(block);
                dropped.iter().for_each(|word| self.unused_word(word));
                return None;
            }
            FirmwareAnswer::Nothing => {}
            // Before the first block, the machine stands at the switches.
            FirmwareAnswer::Homing if !self.carried_out => {}
            FirmwareAnswer::Homing => self.home_machine(),
            FirmwareAnswer::Jog(words) => self.jog(block, words),
            FirmwareAnswer::Setting => self.report_setting_in_program(block),
            FirmwareAnswer::Refused(fault) => {
                self.report_refusal(firmware, fault);
                if !self.control.parameters.goes_on_after_refusal {
                    return Some(BlockFlow::End(EndReason::Alarm));
                }
            }
        }
        Some(BlockFlow::Next)
    }

    /// A jog moves straight at its own feed, units and distance mode, which do not stay active.
    fn jog(&mut self, block: &mut Block, words: Vec<Word>) {
        let state = &self.kernel.state;
        let (units, incremental, mode) = (state.units, state.incremental, state.feed_mode);
        let (motion, cycle) = (state.motion, state.cycle);
        let feed = (state.feed, state.feed_angular);
        let linear = Action::Motion(MotionCode::Linear);
        let rows = self.control.table.g_codes;
        let code = rows.iter().find(|row| row.action == linear).map_or(10, |row| row.code);
        let number = WordValue::Number(Decimal::integer(i64::from(code / 10)));
        let range = block.range;
        block.push(Word { letter: b'G', register: None, comma: false, value: number, range });
        words.into_iter().for_each(|word| block.push(word));
        self.kernel.set_feed_mode(FeedMode::PerTime);
        self.carried_out = true;
        self.carry_out(block);
        self.set_units(units);
        self.kernel.set_incremental(incremental);
        self.kernel.set_feed_mode(mode);
        let state = &mut self.kernel.state;
        (state.motion, state.cycle) = (motion, cycle);
        (state.feed, state.feed_angular) = feed;
    }

    /// Reports once that the sender has to make tool changes.
    fn check_change_by_sender(&mut self, block: &Block) {
        let by_sender = self.control.parameters.tool_change == ToolChanger::Sender;
        if !by_sender || self.reported.sender_changes_tools || !block.letters().has(b'M') {
            return;
        }
        let changes = |word: &&Word| {
            word.letter == b'M'
                && self.control.row_of(word).is_some_and(|row| row.group == CodeGroup::ToolChange)
        };
        let Some(word) = block.words.iter().find(changes) else { return };
        let span = self.span(word.range);
        self.reported.sender_changes_tools = true;
        let title = self.control.table.title;
        self.kernel.report(
            Diagnostic::new(
                Code::ToolChangeBySender,
                span,
                format!("{title} has no tool change: the sender has to keep M6 from it"),
            )
            .label("the first one in this program")
            .help("where the sender does not, set `M6` to `nobody` in the machine file: it is error:20 then"),
        );
    }

    #[cold]
    fn report_refusal(&mut self, firmware: &Firmware, fault: LineFault) {
        let Some(row) = firmware.row(fault.refusal) else { return };
        let title = self.control.table.title;
        let message = match fault.measured {
            Some(measured) => format!("{}: {measured}", row.message),
            None => row.message.to_string(),
        };
        let mut diagnostic = Diagnostic::new(Code::BlockRefused, self.span(fault.range), message)
            .alarm(format!("{title}: error:{}", row.number))
            .help(row.help);
        if !self.control.parameters.goes_on_after_refusal {
            diagnostic = diagnostic.note("the blocks after it are not run: senders stop here");
        }
        self.kernel.report(diagnostic);
    }

    #[cold]
    fn report_setting_in_program(&mut self, block: &Block) {
        self.kernel.report(
            Diagnostic::new(
                Code::NotSimulated,
                self.span(block.range),
                "a setting in a program changes the machine, and is not followed",
            )
            .help("set it once from the sender, and enter it in the machine file"),
        );
    }
}

#[cfg(test)]
mod tests {
    use chordal_command::{Command, CommandKind, Sink};
    use chordal_diagnostics::{Diagnostic, Severity, Source, SourceMap};
    use chordal_dialect::Control;
    use chordal_kernel::RunSink;
    use chordal_machine::{Machine, SettingEntry, SettingValue};

    use super::*;
    use crate::interpreter::RunOptions;
    use crate::library::Library;

    /// Keeps what is said and the last feed, and counts probe moves.
    #[derive(Default)]
    struct Said {
        said: Vec<Diagnostic>,
        probes: usize,
        feed_mm_s: f64,
    }

    impl Sink for Said {
        fn command(&mut self, command: &Command) {
            self.probes += usize::from(matches!(command.kind, CommandKind::Probed { .. }));
            if let CommandKind::Line { feed, .. } = &command.kind {
                self.feed_mm_s = feed.value;
            }
        }
        fn diagnostic(&mut self, diagnostic: Diagnostic) {
            self.said.push(diagnostic);
        }
    }

    impl RunSink for Said {}

    /// What became of a program whose sender goes on after errors.
    struct Ran {
        said: Vec<Diagnostic>,
        probes: usize,
        feed_mm_s: f64,
        /// Machine positions: the firmware's own, and that of the motion.
        firmware: [f32; 3],
        kernel: [f64; 3],
        end: EndReason,
    }

    fn ran(text: &str) -> Ran {
        let mut machine = Machine::from_builtin("grbl").expect("a machine");
        let value = SettingValue::Text("nobody".into());
        machine.settings.insert("M6".into(), SettingEntry { value, location: None });
        ran_on(machine, text)
    }

    fn ran_on(mut machine: Machine, text: &str) -> Ran {
        let value = SettingValue::Text("continue".into());
        machine.settings.insert("on error".into(), SettingEntry { value, location: None });
        let (control, errors) = Control::of(&machine).expect("a word-address control");
        assert!(errors.is_empty(), "{errors:?}");
        let mut sources = SourceMap::new();
        sources.add(Source::new("job.nc", text.as_bytes()));
        let library = Library::new(&sources, &control.table.lexicon);
        let options = RunOptions::default();
        let mut said = Said::default();
        let mut interpreter =
            Interpreter::new(&library, 0, &machine, &control, &options, &mut said);
        let end = interpreter.run().expect("no checkpoint ends it");
        let firmware = interpreter.judge.as_ref().expect("a firmware").position();
        let kernel = [0, 1, 2].map(|axis| interpreter.kernel.state.machine_position(axis));
        drop(interpreter);
        Ran {
            said: said.said,
            probes: said.probes,
            feed_mm_s: said.feed_mm_s,
            firmware,
            kernel,
            end,
        }
    }

    /// The numbers of the errors, with the line of each.
    fn answers(ran: &Ran, text: &str) -> Vec<(usize, u32)> {
        let of = |each: &Diagnostic| {
            let number = each.alarm.as_ref()?.split_once("error:")?.1.parse().ok()?;
            let before = &text.as_bytes()[..each.primary.span.range.start as usize];
            Some((before.iter().filter(|byte| **byte == b'\n').count(), number))
        };
        ran.said.iter().filter_map(of).collect()
    }

    #[test]
    fn codes_count_in_hundredths() {
        for (text, expected) in [
            ("G0.999X1", vec![(0, 23)]),
            ("G1000.999X1", vec![(0, 20)]),
            ("G-1X1", vec![(0, 20)]),
            ("M3.5", vec![(0, 23)]),
            ("G0X99999999999999999999999999999999999999999999999999", vec![]),
            ("X1G-0.3", vec![(0, 23)]),
            ("G0X1G-1", vec![(0, 20)]),
            ("G49.5", vec![]),
            ("G10.1L2P1X1", vec![(0, 23)]),
        ] {
            assert_eq!(answers(&ran(text), text), expected, "{text}");
        }
    }

    #[test]
    fn motions_and_lengths_ask_for_the_axes_before_their_fraction() {
        for (text, expected) in [
            ("G0X1G1.5", 24),
            ("G0X1G38.9", 24),
            ("G0X1G43H1", 24),
            ("G28X1G2.997", 24),
            ("G1.5G0X1", 23),
            ("G0X1G28.2", 20),
            ("G0X1G10.5", 23),
        ] {
            assert_eq!(answers(&ran(text), text), [(0, expected)], "{text}");
        }
    }

    /// What the firmware lets pass is run as it runs it: no other rule refuses it.
    #[test]
    fn blocks_that_pass_are_run() {
        for (text, expected, probes) in [
            // Numbers of offsets are cut to whole ones, and L to a byte.
            ("G10L2.7P1.5X1\nG0X0", [1.0, 0.0, 0.0], 0),
            ("G10L258P1X1\nG0X0", [1.0, 0.0, 0.0], 0),
            ("G10L20P1.9X1\nG0X0", [-1.0, 0.0, 0.0], 0),
            // A probe code stays active.
            ("G38.2X-1F50\nX-3\nG92.1Y2", [-3.0, 2.0, 0.0], 3),
            ("G38.3X1F50G4P0.1", [1.0, 0.0, 0.0], 1),
            ("G38.4X-1F50G92.1\nG0X-3", [-3.0, 0.0, 0.0], 1),
            // The axis words next to G92.1 count from the offset that it clears.
            ("G92X5\nG92.1X0", [-5.0, 0.0, 0.0], 0),
            ("G92X5\nG92.1X0\nX1", [1.0, 0.0, 0.0], 0),
            ("G92X5\nG92.1\nX1", [1.0, 0.0, 0.0], 0),
            // A centre word outside the plane.
            ("G2X2K5I1F100", [2.0, 0.0, 0.0], 0),
            ("G19G3I5Y2J1F100", [0.0, 2.0, 0.0], 0),
            // Arcs at a limit, which only counts in 24 bits.
            ("F606J73.561373Y76.392535I4.0805468G3X77.626862", [77.626_862, 76.392_535, 0.0], 0),
            // A tool length moves nothing.
            ("G43.1Z2G53\nZ0", [0.0, 0.0, 2.0], 0),
            ("G49Z2G53\nG53Z1", [0.0, 0.0, 1.0], 0),
            // A radius of zero is a straight move.
            ("G2X0.004I0F100", [0.004, 0.0, 0.0], 0),
            // O begins no program.
            ("G0X1\nO10Y5\n:10\nY1", [1.0, 1.0, 0.0], 0),
        ] {
            let ran = ran(text);
            let others = ran.said.iter().filter(|each| each.code != Code::BlockRefused);
            let errors: Vec<&Diagnostic> =
                others.filter(|each| each.severity == Severity::Error).collect();
            assert!(errors.is_empty(), "{text}: {errors:?}");
            for (axis, expected) in expected.into_iter().enumerate() {
                assert!((ran.kernel[axis] - expected).abs() < 1e-9, "{text}: {:?}", ran.kernel);
            }
            assert_eq!(ran.probes, probes, "{text}");
        }
    }

    #[test]
    fn the_feed_that_leaves_g93_is_of_millimetres() {
        for (text, expected) in [
            ("G20\nG94F10\nG1X1", 254.0),
            ("G20\nG93\nG94F10\nG1X1", 10.0),
            ("G20\nG93\nG94F10\nF10G1X1", 254.0),
            ("G93\nG94F10\nG1X1", 10.0),
        ] {
            let feed = 60.0 * ran(text).feed_mm_s;
            assert!((feed - expected).abs() < 1e-6, "{text}: {feed}");
        }
    }

    #[test]
    fn a_jog_moves_and_leaves_the_modes() {
        for (text, expected) in [
            ("$J=X10F100", [10.0, 0.0, 0.0]),
            ("G91\n$J=G90X10Y2F600\nX1", [11.0, 2.0, 0.0]),
            ("$J=G91G20X1F100\nG0X5\nY1", [5.0, 1.0, 0.0]),
            ("G1F50X1\n$J=X9F900\nX2", [2.0, 0.0, 0.0]),
        ] {
            let ran = ran(text);
            for (axis, expected) in expected.into_iter().enumerate() {
                assert!((ran.kernel[axis] - expected).abs() < 1e-9, "{text}: {:?}", ran.kernel);
                assert!((f64::from(ran.firmware[axis]) - expected).abs() < 1e-5, "{text}");
            }
        }
        let fed = ran("G1F50X1\n$J=X9F900\nX2");
        assert!((60.0 * fed.feed_mm_s - 50.0).abs() < 1e-9, "{}", fed.feed_mm_s);
    }

    /// What the firmware counts and where the motion is, after random blocks with cycles, splines, offsets and lengths.
    #[test]
    fn firmware_and_motion_agree_on_the_position() {
        const BLOCKS: [&str; 26] = [
            "G0 X1 Y2",
            "G1 X3.5 F200",
            "G91",
            "G90",
            "G20",
            "G21",
            "Y-1",
            "Z4",
            "G81 X5 Z-3 R2",
            "G98 G83 Y3 Z-4 R1 Q1.5",
            "G99 X2",
            "G82 X1 Z-2 R1 P0.1 L2",
            "G80",
            "G0 Z9",
            "G19 G2 Y0 Z0 J2 F90",
            "G17 G0 X0",
            "G2 I3 F100",
            "G2 X4 Y1 R8",
            "G5 X6 Y2 I1 J1 P-1 Q1",
            "G92 X1 Y1",
            "G92.2",
            "G92.3",
            "G43.1 X1 Z2",
            "G49",
            "G59.2 G10 L2 P8 X2",
            "G10 L20 P0 Y3",
        ];
        let mut seed = 3_u64;
        for machine in ["grblhal", "fluidnc"] {
            let mut moved = 0;
            for _ in 0..300 {
                let mut text = String::from("F100\n");
                for _ in 0..12 {
                    seed ^= seed << 13;
                    seed ^= seed >> 7;
                    seed ^= seed << 17;
                    text.push_str(BLOCKS[seed as usize % BLOCKS.len()]);
                    text.push('\n');
                }
                let ran = ran_on(Machine::from_builtin(machine).expect("a machine"), &text);
                for axis in 0..3 {
                    let (one, other) = (f64::from(ran.firmware[axis]), ran.kernel[axis]);
                    let near = 1e-4 + 1e-5 * other.abs();
                    assert!(
                        (one - other).abs() < near,
                        "{machine} {axis}: {one}, {other}\n{text}{:?}",
                        ran.said
                    );
                    moved += usize::from(other != 0.0);
                }
            }
            assert!(moved > 500, "{moved}");
        }
    }

    #[test]
    fn no_line_is_too_odd() {
        let pieces = [
            "G", "M", "X", "Z", "I", "R", "F", "P", "L", "T", "N", "$", "J=", "(", ")", ";", "/",
            "%", "-", ".", "0", "1", "2", "38.2", "92", "10", "20", "1e9", "99999999", "\n", " ",
            "é", "\0",
        ];
        let mut seed = 1_u64;
        for _ in 0..300 {
            let mut text = String::new();
            for _ in 0..60 {
                seed ^= seed << 13;
                seed ^= seed >> 7;
                seed ^= seed << 17;
                text.push_str(pieces[seed as usize % pieces.len()]);
            }
            // Each is answered, or runs.
            ran(&text);
        }
    }

    #[test]
    fn every_block_is_answered_as_the_firmware_does() {
        let rows = include_str!("../../../../tests/grbl/vectors.txt");
        let mut wrong = Vec::new();
        let mut count = 0;
        for row in rows.lines().filter(|row| !row.starts_with('#')) {
            count += 1;
            let mut fields = row.split('\t');
            let text = fields.next().unwrap_or_default().replace('|', "\n");
            let expected: Vec<(usize, u32)> = fields
                .next()
                .unwrap_or_default()
                .split(' ')
                .enumerate()
                .map(|(line, number)| (line, number.parse().expect("a number")))
                .filter(|(_, number)| *number > 0)
                .collect();
            let mut end = [0.0_f64; 3];
            for (axis, value) in fields.next().unwrap_or_default().split(',').enumerate() {
                if !value.is_empty() {
                    end[axis] = value.parse().expect("a coordinate");
                }
            }
            let ran = ran(&text);
            // What comes after M2 and M30 Chordal does not run.
            let ended = ran.end == EndReason::ProgramEnd;
            let found = answers(&ran, &text);
            if !ended && found != expected {
                wrong.push(format!("{row}: answered {found:?}"));
            }
            for (axis, end) in end.into_iter().enumerate() {
                let near = 1e-6 * end.abs().max(1.0);
                if !ended && (f64::from(ran.firmware[axis]) - end).abs() > near {
                    wrong.push(format!("{row}: the firmware is at {:?}", ran.firmware));
                }
                if !ended && (ran.kernel[axis] - end).abs() > near {
                    wrong.push(format!("{row}: the machine is at {:?}", ran.kernel));
                }
            }
        }
        assert!(count > 120, "{count} rows");
        assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
    }
}
