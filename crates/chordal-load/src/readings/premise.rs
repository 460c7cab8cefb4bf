//! What was assumed about a text, and where another reading would move differently.

use chordal::control::control_title;
use chordal::diagnostics::{FileId, Span};
use chordal::machine::{AXIS_LETTERS, ControlName};
use chordal::{AssumedSetting, ChoiceDifference, Code, Diagnostic, ReadingChoice, ReadingChoices};

use super::difference::{MotionAspect, first_difference};
use super::excerpt::TrialExcerpt;
use super::trace::{BlockMotion, MotionTrace};
use super::{PossibleReading, machine_of};

/// The most controls of a reading that are named; the others are counted.
const NAMED_CONTROLS: usize = 4;

/// Controls on which a text has the same motions.
#[derive(Clone, Debug)]
pub struct ReadingGroup {
    /// The controls, the most likely one first.
    pub controls: Vec<ControlName>,
    /// The name of the built-in machine of the first control.
    pub machine: &'static str,
    /// The settings of the machine that the text leaves open.
    pub settings: Vec<&'static AssumedSetting>,
    /// The bounding box of all cuts, mm; `None` when only an excerpt was run or nothing is cut.
    pub cut_box: Option<([f64; 3], [f64; 3])>,
    /// What the differing block does in this reading, such as `Z 0.006 mm`; empty when there is no difference.
    pub motion: String,
}

impl ReadingGroup {
    /// The command-line options that select this reading.
    pub fn option(&self) -> String {
        let machine = format!("--machine {}", self.machine);
        self.settings.iter().fold(machine, |option, setting| {
            // No value of these settings has a blank, so that a shell needs no quotes.
            format!("{option} --set {}", setting.assignment.replace('"', ""))
        })
    }

    /// The titles of the controls in a phrase, such as `GRBL, LinuxCNC and Mach3`, with the settings that are a
    /// guess.
    pub fn title(&self) -> String {
        let titles: Vec<&str> =
            self.controls.iter().map(|control| control_title(*control)).collect();
        let named = match titles.as_slice() {
            [] => String::new(),
            [one] => (*one).to_string(),
            [first @ .., last] if titles.len() <= NAMED_CONTROLS => {
                format!("{} and {last}", first.join(", "))
            }
            _ => {
                let more = titles.len() - NAMED_CONTROLS;
                format!("{} and {more} more", titles[..NAMED_CONTROLS].join(", "))
            }
        };
        AssumedSetting::after(&named, &self.settings)
    }

    /// The titles of all controls but the first.
    pub fn other_titles(&self) -> Vec<&'static str> {
        self.controls.iter().skip(1).map(|control| control_title(*control)).collect()
    }

    /// The size of the box of all cuts, mm; `None` without a box, and for an axis that no cut determines.
    pub fn size_mm(&self) -> Option<[Option<f64>; 3]> {
        let (low, high) = self.cut_box?;
        Some([0, 1, 2].map(|axis| (low[axis] <= high[axis]).then(|| high[axis] - low[axis])))
    }

    /// [`ReadingGroup::size_mm`] in words, such as `36 x 20 x 6 mm`.
    pub fn size(&self) -> Option<String> {
        let sides: Vec<String> = self.size_mm()?.into_iter().flatten().map(millimetres).collect();
        Some(format!("{} mm", sides.join(" x ")))
    }

    /// The reading as front ends show it.
    fn choice(&self) -> ReadingChoice {
        ReadingChoice {
            controls: self.controls.iter().map(|control| control.as_str()).collect(),
            machine: self.machine,
            settings: self.settings.clone(),
            size_mm: self.size_mm(),
            motion: self.motion.clone(),
            option: self.option(),
            title: self.title(),
            size: self.size(),
        }
    }
}

/// Where the motions of two readings differ.
#[derive(Clone, Debug)]
pub struct ReadingDifference {
    /// The first block that differs.
    pub span: Span,
    /// Only feeds differ, and therefore the time; the path is the same.
    pub only_feed: bool,
}

/// What was assumed about a text that does not name its control or a setting of it.
#[derive(Clone, Debug)]
pub struct ReadingPremise {
    /// The readings that remain possible; the first one is run.
    pub groups: Vec<ReadingGroup>,
    /// The first block whose motion differs between them; `None` when all motions are equal.
    pub difference: Option<ReadingDifference>,
}

impl ReadingPremise {
    /// Compares the readings of a text (at least one), each run on the excerpt.
    pub(super) fn of(
        readings: &[PossibleReading],
        text: &[u8],
        excerpt: &TrialExcerpt,
    ) -> ReadingPremise {
        // Groups of readings with equal motions, as indices in `readings`.
        let mut alike: Vec<Vec<usize>> = Vec::new();
        let mut difference: Option<FirstDifference> = None;
        for (index, reading) in readings.iter().enumerate() {
            let mut found = false;
            for group in &mut alike {
                let first = &readings[group[0]];
                match first_difference(&first.trace, &reading.trace) {
                    None if first.units() == reading.units() => {
                        group.push(index);
                        found = true;
                        break;
                    }
                    None => {}
                    Some((aspect, one, other)) => {
                        let next =
                            FirstDifference::new(aspect, &first.trace, one, &reading.trace, other);
                        if difference.as_ref().is_none_or(|known| next.comes_before(known)) {
                            difference = Some(next);
                        }
                    }
                }
            }
            if !found {
                alike.push(vec![index]);
            }
        }
        // Without a difference in motion, the settings do not matter.
        if difference.is_none() {
            alike = vec![(0..readings.len()).collect()];
        }
        let difference = difference.filter(|_| alike.len() > 1);
        let group = |members: &Vec<usize>| {
            let first = &readings[members[0]];
            let mut controls: Vec<ControlName> =
                members.iter().map(|index| readings[*index].control).collect();
            controls.dedup();
            ReadingGroup {
                controls,
                machine: first.machine,
                settings: first.settings.clone(),
                cut_box: cut_box(first, difference.is_some(), text, excerpt),
                motion: difference
                    .as_ref()
                    .map_or_else(String::new, |at| at.motion_of(&first.trace)),
            }
        };
        let groups = alike.iter().map(group).collect();
        let difference = difference.map(|at| at.place(excerpt));
        ReadingPremise { groups, difference }
    }

    /// The settings that are assumed.
    pub(crate) fn settings(&self) -> &[&'static AssumedSetting] {
        self.groups.first().map_or(&[], |group| &group.settings)
    }

    /// The readings as front ends show them.
    pub fn choices(&self) -> ReadingChoices {
        let difference = self.difference.as_ref().map(|at| ChoiceDifference {
            span: at.span,
            only_feed: at.only_feed,
            message: self.message(at),
        });
        let readings = self.groups.iter().map(ReadingGroup::choice).collect();
        ReadingChoices { readings, difference }
    }

    /// The sentence that states what is not known.
    fn message(&self, at: &ReadingDifference) -> String {
        let what = match at.only_feed {
            true => "how fast this program cuts",
            false => "what this program moves",
        };
        let mut settings = self.groups.iter().flat_map(|group| &group.settings);
        let has_units = settings.clone().any(|setting| setting.units().is_some());
        let units = if has_units { " and its units" } else { "" };
        if settings.any(|setting| setting.units().is_none()) {
            return format!(
                "{what} depends on what its control takes a number without a decimal point for{units}, and nothing in the text says it"
            );
        }
        format!(
            "{what} depends on its control, and nothing in the text names it{units} for certain"
        )
    }

    /// The message that the path or the time depends on a guess; `None` when no reading differs.
    pub fn diagnostic(&self) -> Option<Diagnostic> {
        let at = self.difference.as_ref()?;
        let code = if at.only_feed { Code::FeedNotKnown } else { Code::ReadingNotKnown };
        let choices = self.choices();
        let shown = choices.shown();
        let motions: Vec<String> =
            shown.iter().map(|each| format!("{} on {}", each.motion, each.title)).collect();
        let mut diagnostic =
            Diagnostic::new(code, at.span, self.message(at)).label(motions.join("; "));
        for ReadingChoice { title, size, option, .. } in shown {
            let size = size.as_ref().map_or_else(String::new, |size| format!("cuts {size}: "));
            diagnostic = diagnostic.note(format!("{title}: {size}{option}"));
        }
        let first = self.groups.first().map_or_else(String::new, ReadingGroup::title);
        let help = format!(
            "name the machine, or keep it in a chordal.toml next to the program; until then it is read as for {first}, and nothing of it is proved"
        );
        Some(diagnostic.help(help))
    }
}

/// The box of the cuts of the whole text. A long text is run whole only when the readings differ.
fn cut_box(
    reading: &PossibleReading,
    differs: bool,
    text: &[u8],
    excerpt: &TrialExcerpt,
) -> Option<([f64; 3], [f64; 3])> {
    if excerpt.is_whole() {
        return reading.trace.cut_box();
    }
    differs
        .then(|| MotionTrace::of(machine_of(reading), &TrialExcerpt::whole(text)).cut_box())
        .flatten()
}

/// The first difference, with the block as it is in one of the two readings.
struct FirstDifference {
    aspect: MotionAspect,
    block: BlockMotion,
}

impl FirstDifference {
    fn new(
        aspect: MotionAspect,
        a: &MotionTrace,
        one: Option<usize>,
        b: &MotionTrace,
        other: Option<usize>,
    ) -> FirstDifference {
        let of = |trace: &MotionTrace, index: Option<usize>| {
            index.and_then(|index| trace.blocks.get(index)).cloned()
        };
        let block = of(a, one).or_else(|| of(b, other));
        FirstDifference { aspect, block: block.unwrap_or_else(BlockMotion::nowhere) }
    }

    /// A difference in path precedes one in feed, and an earlier one precedes a later one.
    fn comes_before(&self, other: &FirstDifference) -> bool {
        let key = |each: &FirstDifference| (each.aspect == MotionAspect::Feed, each.block.range.0);
        key(self) < key(other)
    }

    /// What this block does in a reading, in words.
    fn motion_of(&self, trace: &MotionTrace) -> String {
        let block = &self.block;
        let own =
            trace.blocks.iter().find(|own| (own.file, own.range) == (block.file, block.range));
        let Some(own) = own else { return "no move".to_string() };
        let letter = |axis: usize| char::from(AXIS_LETTERS.as_bytes()[axis]);
        match self.aspect {
            MotionAspect::End(axis) if axis < 3 => {
                format!("{} {} mm", letter(axis), millimetres(own.end[axis]))
            }
            MotionAspect::End(axis) => {
                format!("{} {} deg", letter(axis), millimetres(own.end[axis].to_degrees()))
            }
            MotionAspect::Reach(axis) => {
                let (low, high) = (millimetres(own.low[axis]), millimetres(own.high[axis]));
                format!("{} from {low} to {high} mm", letter(axis))
            }
            MotionAspect::Kind if own.cuts => "a cut".to_string(),
            MotionAspect::Kind => "a rapid".to_string(),
            MotionAspect::Feed => match own.feed {
                Some(feed) => format!("{} mm/min", millimetres(feed * 60.0)),
                None => "no feed".to_string(),
            },
        }
    }

    fn place(&self, excerpt: &TrialExcerpt) -> ReadingDifference {
        let (start, end) = self.block.range;
        let (start, end) = (excerpt.offset_in_text(start), excerpt.offset_in_text(end));
        ReadingDifference {
            span: Span::new(FileId(0), start, end),
            only_feed: self.aspect == MotionAspect::Feed,
        }
    }
}

/// A number with at most four decimals.
fn millimetres(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}
