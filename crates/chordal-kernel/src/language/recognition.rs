//! The result of recognizing the control that a text was written for.

use chordal_machine::ControlName;

/// The control that is assumed without any sign: most others read programs as it does.
const ASSUMED_CONTROL: ControlName = ControlName::Fanuc;

/// From this weight on the control with the most is likely.
pub const MIN_LIKELY_WEIGHT: i32 = 3;

/// The weight by which the first control must lead the second to be chosen for certain.
const MIN_LEAD: i32 = 2;

/// A sign that was found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FoundSign {
    /// The sign in words: `G154 chooses an extended work offset`.
    pub sign: &'static str,
    /// The first line that shows it.
    pub line: u32,
    /// Offset of that line.
    pub offset: u32,
    /// Its weight; negative when it is evidence against.
    pub weight: i32,
    /// The built-in machine of programs with this sign; `None` for the usual one of the control.
    pub machine: Option<&'static str>,
}

impl ControlCandidate {
    /// The built-in machine named by its signs; `None` for the usual one of the control.
    pub fn machine(&self) -> Option<&'static str> {
        self.signs.iter().find_map(|sign| sign.machine)
    }
}

/// A control or a language with its evidence.
#[derive(Clone, PartialEq, Debug)]
pub struct ControlCandidate {
    /// Its name: that of a control, or `fanuc-lathe`, `heidenhain`.
    pub name: &'static str,
    /// Its name in messages.
    pub title: &'static str,
    /// The control that reads the program, or that shows its text.
    pub control: ControlName,
    /// It is a language that is not read.
    pub not_read: bool,
    /// The sum of the weights of its signs.
    pub weight: i32,
    /// Its signs, the strongest first.
    pub signs: Vec<FoundSign>,
    /// Number of errors of a run on this control; `None` when it was not tried.
    pub errors: Option<u64>,
}

/// How certain the recognition is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EvidenceStrength {
    /// A name or forms that no other control has, and no other candidate is near.
    Sure,
    /// It leads clearly.
    Likely,
    /// It leads by little, or because the others have errors.
    Weak,
    /// There is no evidence: the usual default.
    Assumed,
}

impl EvidenceStrength {
    /// As a word.
    pub fn as_str(self) -> &'static str {
        match self {
            EvidenceStrength::Sure => "sure",
            EvidenceStrength::Likely => "likely",
            EvidenceStrength::Weak => "weak",
            EvidenceStrength::Assumed => "assumed",
        }
    }
}

/// The result of a recognition.
#[derive(Clone, PartialEq, Debug)]
pub struct Recognition {
    /// All candidates, the chosen one first. Controls that are read are always included.
    pub ranking: Vec<ControlCandidate>,
}

/// The weight of a control for another kind of machine (mill or lathe) than the program's.
pub const ANOTHER_KIND: i32 = -1000;

/// With at least this weight and lead the recognition is certain.
const SURE_WEIGHT: i32 = 6;

impl Recognition {
    /// Ranks candidates by their weight. `turns` tells whether a control is that of a lathe.
    pub fn of(
        mut ranking: Vec<ControlCandidate>,
        turns: impl Fn(ControlName) -> bool,
    ) -> Recognition {
        // The sort is stable for equal weights. Among these a lathe control that is read comes first, then the
        // assumed control.
        ranking.sort_by_key(|each| {
            let is_read_lathe = !each.not_read && turns(each.control);
            (-each.weight, !is_read_lathe, !each.not_read, each.control != ASSUMED_CONTROL)
        });
        let mut recognition = Recognition { ranking };
        if recognition.strength() == EvidenceStrength::Assumed {
            recognition.choose(ASSUMED_CONTROL.as_str());
        }
        recognition
    }

    /// The chosen candidate.
    pub fn chosen(&self) -> &ControlCandidate {
        &self.ranking[0]
    }

    /// The control that reads the program, or shows its text.
    pub fn control(&self) -> ControlName {
        self.chosen().control
    }

    /// The second candidate, if it has evidence or was tried by a run; `None` otherwise.
    pub fn runner_up(&self) -> Option<&ControlCandidate> {
        let speaks = |other: &&ControlCandidate| other.weight > 0 || other.errors.is_some();
        self.ranking.get(1).filter(speaks)
    }

    /// The evidence for the chosen one, the strongest first; empty when it is assumed.
    pub fn evidence(&self) -> impl Iterator<Item = &FoundSign> {
        let assumed = self.strength() == EvidenceStrength::Assumed;
        self.chosen().signs.iter().filter(move |sign| !assumed && sign.weight > 0)
    }

    /// How certain the recognition is.
    pub fn strength(&self) -> EvidenceStrength {
        let chosen = self.chosen();
        match chosen.weight {
            weight if weight >= SURE_WEIGHT && self.lead() >= SURE_WEIGHT => EvidenceStrength::Sure,
            _ if chosen.not_read => EvidenceStrength::Likely,
            weight if weight >= MIN_LIKELY_WEIGHT && self.lead() >= MIN_LEAD => {
                EvidenceStrength::Likely
            }
            weight if weight >= MIN_LIKELY_WEIGHT => EvidenceStrength::Weak,
            _ => EvidenceStrength::Assumed,
        }
    }

    /// True when a name or a form that no other control has is evidence for it, and no other is near. Several weak
    /// signs of writing style are not enough: they indicate the author more than the control.
    pub fn is_certain(&self) -> bool {
        let strongest = self.chosen().signs.first();
        self.strength() == EvidenceStrength::Sure
            && strongest.is_some_and(|sign| sign.weight >= SURE_WEIGHT)
    }

    /// True when the signs decide; otherwise test runs may.
    pub fn is_decided(&self) -> bool {
        self.chosen().not_read
            || matches!(self.strength(), EvidenceStrength::Sure | EvidenceStrength::Likely)
    }

    /// The weight by which the chosen one leads.
    pub fn lead(&self) -> i32 {
        let next = self.ranking.iter().skip(1).map(|other| other.weight).max().unwrap_or(0);
        self.chosen().weight - next.max(0)
    }

    /// Moves the candidate with a name to the first position.
    pub fn choose(&mut self, name: &str) {
        if let Some(place) = self.ranking.iter().position(|each| each.name == name) {
            let chosen = self.ranking.remove(place);
            self.ranking.insert(0, chosen);
        }
    }
}
