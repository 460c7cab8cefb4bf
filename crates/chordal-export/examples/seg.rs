#![allow(clippy::disallowed_methods, missing_docs)]
use chordal::{Job, Machine, Source, SourceMap};
use chordal_export::CommandJsonLines;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let text = std::fs::read(&a[2]).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("x.nc", text));
    let job = Job::new(sources, Machine::from_builtin(&a[1]).unwrap()).unwrap();
    let mut w = CommandJsonLines::new(Vec::new(), &job).unwrap();
    job.report_with(|c, _| w.command(c).unwrap());
    print!("{}", String::from_utf8(w.finish().unwrap()).unwrap());
}
