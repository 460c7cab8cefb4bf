//! Lets a view work for another one with which it shares no memory: workers of a browser.
//!
//! One view has the text and answers requests. Its [`ProgramView::dispatch`] makes a work order for another view,
//! which does the work in [`ProgramView::execute`] and sends the results to the page. After a run it reports back
//! ([`ProgramView::remote_run_finished`]).

use std::sync::Arc;
use std::sync::atomic::Ordering;

use chordal::path::ProgramFrame;
use serde::{Deserialize, Serialize};

use crate::document::EditedText;
use crate::modal::ModalTrack;
use crate::program::ProgramRefusal;
use crate::request::ComparedWith;
use crate::run::FinishedRun;
use crate::view::{ProgramView, RemoteRun, WorkItem, WorkSink};

/// What a view needs to do a work item for another one, except the text and the files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkOrder {
    work: WorkItem,
    /// The newest run; `None` when there was none.
    remote_run: Option<RemoteRun>,
    machine: Option<String>,
    other: ComparedWith,
    tolerance_mm: f64,
    columns: u32,
    /// Whether the page may already show another program.
    #[serde(default)]
    is_shown: bool,
}

impl ProgramView {
    /// The work order for a work item, and the text; `None` when the item is outdated.
    pub fn dispatch(&self, work: WorkItem) -> Option<(WorkOrder, String)> {
        let newest = match work {
            WorkItem::Run(_) | WorkItem::Plan(_) => &self.newest_run,
            WorkItem::Compare(_) => &self.newest_comparison,
            WorkItem::Cut(_) => &self.newest_stock,
        };
        let state = self.state();
        let remote = state.remote_run.filter(|remote| remote.number > 0);
        let is_due = matches!(work, WorkItem::Run(_)) || remote.is_some();
        if newest.load(Ordering::Relaxed) != work.number() || !is_due {
            return None;
        }
        let order = WorkOrder {
            work,
            remote_run: remote,
            machine: state.machine.clone(),
            other: state.other.clone(),
            tolerance_mm: state.tolerance_mm,
            columns: state.columns,
            is_shown: false,
        };
        Some((order, state.document.text().to_string()))
    }

    /// From now on views in other workers do all work.
    pub fn delegate_work(&self) {
        self.state().remote_run = Some(RemoteRun::default());
    }

    /// Takes the report of a run in another worker, as returned by [`ProgramView::execute`] there.
    ///
    /// # Errors The text is not such a report.
    pub fn remote_run_finished(
        &self,
        report: &str,
        want: WorkSink<'_>,
    ) -> Result<(), serde_json::Error> {
        let remote: RemoteRun = serde_json::from_str(report)?;
        if remote.number != self.newest_run.load(Ordering::Relaxed) {
            return Ok(());
        }
        {
            let mut state = self.state();
            state.remote_run = Some(remote);
            // The text may name another machine than before, so programs opened earlier are outdated.
            (state.opened, state.text_program) = (None, None);
        }
        self.run_finished(remote, want);
        Ok(())
    }

    /// Does the work of another view. Returns the report of a run for that view; `None` for other work, and for a run
    /// that was canceled or refused.
    ///
    /// # Errors The program cannot be opened.
    pub fn execute(
        &self,
        order: WorkOrder,
        text: String,
    ) -> Result<Option<String>, ProgramRefusal> {
        let WorkOrder { work, remote_run: remote, machine, other, tolerance_mm, columns, is_shown } =
            order;
        let number = work.number();
        let run = remote.map_or(0, |remote| remote.number);
        let is_same = self.state().finished_run.as_ref().is_some_and(|own| own.number == run);
        {
            let mut state = self.state();
            state.document = EditedText::of(text);
            (state.machine, state.other) = (machine, other);
            (state.tolerance_mm, state.columns) = (tolerance_mm, columns);
        }
        match work {
            WorkItem::Run(_) | WorkItem::Plan(_) => {
                self.newest_run.store(number, Ordering::Relaxed)
            }
            WorkItem::Compare(_) => {
                self.newest_comparison.store(number, Ordering::Relaxed);
                let comparing = self.comparison.lock();
                comparing.unwrap_or_else(std::sync::PoisonError::into_inner).is_shown |= is_shown;
            }
            WorkItem::Cut(_) => self.newest_stock.store(number, Ordering::Relaxed),
        }
        if let (Some(remote), false) = (remote, is_same || matches!(work, WorkItem::Run(_))) {
            self.open_remote_run(remote)?;
        }
        let mut done = None;
        self.work(work, &mut |next| done = Some(next));
        // A run that was canceled or refused has no report.
        let state = self.state();
        let own =
            state.finished_run.as_ref().filter(|_| done.is_some()).map(|own| RemoteRun::of(own));
        Ok(own.and_then(|own| serde_json::to_string(&own).ok()))
    }

    /// Opens the program of a run that another worker has done, for requests about it.
    fn open_remote_run(&self, remote: RemoteRun) -> Result<(), ProgramRefusal> {
        let (text, machine) = {
            let state = self.state();
            (state.document.text().as_bytes().to_vec(), state.machine.clone())
        };
        let program = Arc::new(self.programs.open(text, machine.as_deref())?);
        let control = program.configured_control();
        let (offset, known) = control.initial_offset(program.machine());
        let modal = ModalTrack::new(control, ProgramFrame::new(offset, known));
        let (RemoteRun { number, rows, about_s, .. }, mut state) = (remote, self.state());
        state.opened = Some(program.clone());
        let about_s = about_s.unwrap_or(f64::INFINITY);
        state.finished_run = Some(Arc::new(FinishedRun { program, modal, number, rows, about_s }));
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
    use crate::outbox::{PageOutbox, PagePort};
    use crate::program::{ListedMachine, ProgramSource};

    const TEXT: &str =
        "%\nO1\nG21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG1 Z0. F100.\nG2 X10. Y10. R10.\nM30\n%\n";

    struct One;

    impl ProgramSource for One {
        fn name(&self) -> String {
            "part.nc".into()
        }

        fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
            Ok(TEXT.into())
        }

        fn open(
            &self,
            text: Vec<u8>,
            machine: Option<&str>,
        ) -> Result<EditorProgram, ProgramRefusal> {
            let machine = Machine::from_builtin(machine.unwrap_or("haas-vf2"));
            let machine = machine.map_err(|errors| ProgramRefusal {
                message: errors[0].message.clone(),
                help: None,
            })?;
            Ok(EditorProgram::new("part.nc", text, machine)
                .expect("settings that the control knows"))
        }

        fn machines(&self) -> Vec<ListedMachine> {
            Vec::new()
        }
    }

    /// What went to the page: objects, and frames with all their bytes.
    #[derive(Clone, Default)]
    struct Sent(Arc<Mutex<Vec<Vec<u8>>>>);

    impl PagePort for Sent {
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
        fn view(&self) -> ProgramView {
            ProgramView::new(Arc::new(One), PageOutbox::new(self.clone()))
        }

        fn take(&self) -> Vec<Vec<u8>> {
            let mut sent = std::mem::take(&mut *self.0.lock().unwrap());
            sent.sort();
            sent
        }
    }

    fn request(view: &ProgramView, request: &str) -> Vec<WorkItem> {
        let mut wants = Vec::new();
        view.answer(serde_json::from_str(request).unwrap(), &mut |work| wants.push(work));
        wants
    }

    /// A piece of work as it goes to another worker: as text.
    fn over(view: &ProgramView, work: WorkItem) -> Option<(WorkOrder, String)> {
        let (order, text) = view.dispatch(work)?;
        let order = serde_json::to_string(&order).unwrap();
        Some((serde_json::from_str(&order).unwrap(), text))
    }

    #[test]
    fn remote_views_send_what_the_view_itself_would() {
        let sent = Sent::default();
        let alone = sent.view();
        let mut wants = Vec::new();
        assert!(alone.begin(&mut |work| wants.push(work)));
        alone.send_text();
        wants.extend(request(
            &alone,
            r#"{"request":"compare_with","other":{"machine":"fanuc-30i"}}"#,
        ));
        while !wants.is_empty() {
            let work = wants.remove(0);
            alone.work(work, &mut |work| wants.push(work));
        }
        let expected = sent.take();
        assert!(expected.len() > 8, "{}", expected.len());

        let (view, paths, times, others) = (sent.view(), sent.view(), sent.view(), sent.view());
        view.delegate_work();
        view.begin(&mut |work| wants.push(work));
        view.send_text();
        request(&view, r#"{"request":"compare_with","other":{"machine":"fanuc-30i"}}"#);
        let (order, text) = over(&view, wants.remove(0)).unwrap();
        let report = paths.execute(order, text).unwrap().unwrap();
        view.remote_run_finished(&report, &mut |work| wants.push(work)).unwrap();
        for work in wants {
            let (order, text) = over(&view, work).unwrap();
            let to = if matches!(work, WorkItem::Compare(_)) { &others } else { &times };
            assert_eq!(to.execute(order, text).unwrap(), None);
        }
        assert_eq!(sent.take(), expected);
        // The view that has the text answers questions about words.
        request(&view, r#"{"id":1,"request":"outline"}"#);
        let report: Value = serde_json::from_slice(&sent.take()[0]).unwrap();
        assert_eq!(report["type"], "outline");
    }

    #[test]
    fn work_of_an_older_text_is_not_dispatched() {
        let sent = Sent::default();
        let (view, paths) = (sent.view(), sent.view());
        view.delegate_work();
        let mut wants = Vec::new();
        view.begin(&mut |work| wants.push(work));
        let (order, text) = over(&view, wants[0]).unwrap();
        let next = request(
            &view,
            r#"{"request":"edit","changes":[{"from":0,"to":0,"insert":"(NEW)\n"}]}"#,
        );
        assert_eq!(next, [WorkItem::Run(2)]);
        assert_eq!(over(&view, wants[0]), None);
        let report = paths.execute(order, text).unwrap().unwrap();
        view.remote_run_finished(&report, &mut |work| panic!("{work:?} of an older text")).unwrap();
        let (_, text) = over(&view, next[0]).unwrap();
        assert!(text.starts_with("(NEW)\n"));
    }
}
