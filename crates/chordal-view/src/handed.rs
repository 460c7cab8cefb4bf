//! A view that works for another one, where the two share no memory: workers of a browser.
//!
//! One view holds the text and answers; it says with [`View::hand_over`] what another one needs, which does the
//! work in [`View::take_over`] and sends the page what it finds. After a run it is told of it ([`View::ran_elsewhere`]).

use std::sync::Arc;
use std::sync::atomic::Ordering;

use chordal::control::initial_offset;
use chordal::path::ProgramFrame;
use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::modal::ModalTrack;
use crate::program::Refusal;
use crate::request::Other;
use crate::run::Ran;
use crate::view::{RanElsewhere, View, Want, Work};

/// What a view needs to do a piece of work for another one, apart from the text and the files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Handed {
    work: Work,
    /// The newest run, where there was one.
    ran: Option<RanElsewhere>,
    machine: Option<String>,
    other: Other,
    tolerance_mm: f64,
    columns: u32,
    /// The page may show another program already.
    #[serde(default)]
    is_told: bool,
}

impl View {
    /// What is needed to do a piece of work elsewhere, and the text; `None` where nobody wants it any more.
    pub fn hand_over(&self, work: Work) -> Option<(Handed, String)> {
        let newest = match work {
            Work::Run(_) | Work::Plan(_) => &self.newest,
            Work::Compare(_) => &self.compared,
            Work::Cut(_) => &self.stocked,
        };
        let held = self.held();
        let ran = held.elsewhere.filter(|ran| ran.number > 0);
        let is_due = matches!(work, Work::Run(_)) || ran.is_some();
        if newest.load(Ordering::Relaxed) != work.number() || !is_due {
            return None;
        }
        let handed = Handed {
            work,
            ran,
            machine: held.machine.clone(),
            other: held.other.clone(),
            tolerance_mm: held.tolerance_mm,
            columns: held.columns,
            is_told: false,
        };
        Some((handed, held.document.text().to_string()))
    }

    /// All work is done elsewhere from now on.
    pub fn works_elsewhere(&self) {
        self.held().elsewhere = Some(RanElsewhere::default());
    }

    /// A view elsewhere has run the program: `told` is what [`View::take_over`] gave there.
    ///
    /// # Errors
    /// What does not come from there.
    pub fn ran_elsewhere(&self, told: &str, want: Want<'_>) -> Result<(), serde_json::Error> {
        let ran: RanElsewhere = serde_json::from_str(told)?;
        if ran.number != self.newest.load(Ordering::Relaxed) {
            return Ok(());
        }
        {
            let mut held = self.held();
            held.elsewhere = Some(ran);
            // The text may say another machine than before.
            (held.opened, held.words) = (None, None);
        }
        self.ran(ran, want);
        Ok(())
    }

    /// Does the work of another view; after a run gives what that one is to be told.
    ///
    /// # Errors
    /// A program that cannot be opened.
    pub fn take_over(&self, handed: Handed, text: String) -> Result<Option<String>, Refusal> {
        let Handed { work, ran, machine, other, tolerance_mm, columns, is_told } = handed;
        let number = work.number();
        let run = ran.map_or(0, |ran| ran.number);
        let is_same = self.held().ran.as_ref().is_some_and(|own| own.number == run);
        {
            let mut held = self.held();
            held.document = Document::of(text);
            (held.machine, held.other) = (machine, other);
            (held.tolerance_mm, held.columns) = (tolerance_mm, columns);
        }
        match work {
            Work::Run(_) | Work::Plan(_) => self.newest.store(number, Ordering::Relaxed),
            Work::Compare(_) => {
                self.compared.store(number, Ordering::Relaxed);
                let comparing = self.comparing.lock();
                comparing.unwrap_or_else(std::sync::PoisonError::into_inner).is_told |= is_told;
            }
            Work::Cut(_) => self.stocked.store(number, Ordering::Relaxed),
        }
        if let (Some(ran), false) = (ran, is_same || matches!(work, Work::Run(_))) {
            self.open_ran(ran)?;
        }
        let mut done = None;
        self.work(work, &mut |next| done = Some(next));
        // Of a run that was given up or refused nothing follows.
        let held = self.held();
        let own = held.ran.as_ref().filter(|_| done.is_some()).map(|own| RanElsewhere::of(own));
        Ok(own.and_then(|own| serde_json::to_string(&own).ok()))
    }

    /// The program of a run that was done elsewhere.
    fn open_ran(&self, ran: RanElsewhere) -> Result<(), Refusal> {
        let (text, machine) = {
            let held = self.held();
            (held.document.text().as_bytes().to_vec(), held.machine.clone())
        };
        let program = Arc::new(self.programs.open(text, machine.as_deref())?);
        let (offset, known) = initial_offset(program.machine(), program.control());
        let modal = ModalTrack::new(program.control(), ProgramFrame::new(offset, known));
        let (RanElsewhere { number, rows, about_s, .. }, mut held) = (ran, self.held());
        held.opened = Some(program.clone());
        let about_s = about_s.unwrap_or(f64::INFINITY);
        held.ran = Some(Arc::new(Ran { program, modal, number, rows, about_s }));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use chordal::Machine;
    use chordal_editor::EditorProgram;
    use serde_json::Value;

    use super::*;
    use crate::outbox::{Outbox, Port};
    use crate::program::{MachineChoice, Programs};

    const TEXT: &str =
        "%\nO1\nG21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG1 Z0. F100.\nG2 X10. Y10. R10.\nM30\n%\n";

    struct One;

    impl Programs for One {
        fn name(&self) -> String {
            "part.nc".into()
        }

        fn read(&self) -> Result<Vec<u8>, Refusal> {
            Ok(TEXT.into())
        }

        fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, Refusal> {
            let machine = Machine::from_builtin(machine.unwrap_or("haas-vf2"));
            let machine = machine
                .map_err(|errors| Refusal { message: errors[0].message.clone(), help: None })?;
            Ok(EditorProgram::new("part.nc", text, machine)
                .expect("settings that the control knows"))
        }

        fn machines(&self) -> Vec<MachineChoice> {
            Vec::new()
        }
    }

    /// What went to the page: objects, and frames with all their bytes.
    #[derive(Clone, Default)]
    struct Sent(Arc<Mutex<Vec<Vec<u8>>>>);

    impl Port for Sent {
        fn text(&self, text: String) {
            self.0.lock().unwrap().push(text.into_bytes());
        }

        fn binary(&self, frame: Vec<u8>) {
            self.0.lock().unwrap().push(frame);
        }

        fn binary_later(&self, frame: Vec<u8>) {
            self.binary(frame);
        }
    }

    impl Sent {
        fn view(&self) -> View {
            View::new(Arc::new(One), Outbox::new(self.clone()))
        }

        fn take(&self) -> Vec<Vec<u8>> {
            let mut sent = std::mem::take(&mut *self.0.lock().unwrap());
            sent.sort();
            sent
        }
    }

    fn ask(view: &View, request: &str) -> Vec<Work> {
        let mut wants = Vec::new();
        view.answer(serde_json::from_str(request).unwrap(), &mut |work| wants.push(work));
        wants
    }

    /// A piece of work as it goes to another worker: as text.
    fn over(view: &View, work: Work) -> Option<(Handed, String)> {
        let (handed, text) = view.hand_over(work)?;
        let handed = serde_json::to_string(&handed).unwrap();
        Some((serde_json::from_str(&handed).unwrap(), text))
    }

    #[test]
    fn views_elsewhere_send_what_the_view_itself_would() {
        let sent = Sent::default();
        let alone = sent.view();
        let mut wants = Vec::new();
        assert!(alone.begin(&mut |work| wants.push(work)));
        alone.send_text();
        wants.extend(ask(&alone, r#"{"ask":"against","other":{"machine":"fanuc-30i"}}"#));
        while !wants.is_empty() {
            let work = wants.remove(0);
            alone.work(work, &mut |work| wants.push(work));
        }
        let expected = sent.take();
        assert!(expected.len() > 8, "{}", expected.len());

        let (view, paths, times, others) = (sent.view(), sent.view(), sent.view(), sent.view());
        view.works_elsewhere();
        view.begin(&mut |work| wants.push(work));
        view.send_text();
        ask(&view, r#"{"ask":"against","other":{"machine":"fanuc-30i"}}"#);
        let (handed, text) = over(&view, wants.remove(0)).unwrap();
        let told = paths.take_over(handed, text).unwrap().unwrap();
        view.ran_elsewhere(&told, &mut |work| wants.push(work)).unwrap();
        for work in wants {
            let (handed, text) = over(&view, work).unwrap();
            let to = if matches!(work, Work::Compare(_)) { &others } else { &times };
            assert_eq!(to.take_over(handed, text).unwrap(), None);
        }
        assert_eq!(sent.take(), expected);
        // What words mean is asked of the view that has the text.
        ask(&view, r#"{"id":1,"ask":"outline"}"#);
        let told: Value = serde_json::from_slice(&sent.take()[0]).unwrap();
        assert_eq!(told["type"], "outline");
    }

    #[test]
    fn work_of_an_older_text_is_not_handed_over() {
        let sent = Sent::default();
        let (view, paths) = (sent.view(), sent.view());
        view.works_elsewhere();
        let mut wants = Vec::new();
        view.begin(&mut |work| wants.push(work));
        let (handed, text) = over(&view, wants[0]).unwrap();
        let next = ask(&view, r#"{"ask":"edit","changes":[{"from":0,"to":0,"insert":"(NEW)\n"}]}"#);
        assert_eq!(next, [Work::Run(2)]);
        assert_eq!(over(&view, wants[0]), None);
        let told = paths.take_over(handed, text).unwrap().unwrap();
        view.ran_elsewhere(&told, &mut |work| panic!("{work:?} of an older text")).unwrap();
        let (_, text) = over(&view, next[0]).unwrap();
        assert!(text.starts_with("(NEW)\n"));
    }
}
