#![allow(clippy::disallowed_methods, missing_docs)]
use chordal::{Job, Machine, Source, SourceMap};
use chordal_export::{Plot, PlotOptions};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let text = std::fs::read(&a[2]).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("x.nc", text));
    let job = Job::new(sources, Machine::from_builtin(&a[1]).unwrap()).unwrap();
    let mut plot = Plot::new(&job);
    let report = job.report_with(|_, s| for s in s { plot.segment(s) });
    plot.set_inch(report.summary.inch);
    for d in report.diagnostics.iter().take(3) { print!("{}", chordal_export::report::one(d, job.sources(), false)); }
    let n = |i: usize, d: u32| a.get(i).map_or(d, |s| s.parse().unwrap());
    let o = PlotOptions { title: a[2].rsplit('/').next().unwrap().into(), subtitle: format!("{} — {} — {:.1} min without acceleration", job.machine().title, if report.summary.inch {"in"} else {"mm"}, report.summary.total_time_s()/60.0), width_px: n(4,1600), height_px: n(5,1131), dark: a.len()>6 };
    let t = std::time::Instant::now();
    let svg = plot.svg(&o);
    println!("svg {} bytes {:?}", svg.len(), t.elapsed());
    std::fs::write(format!("{}.svg", a[3]), svg).unwrap();
    let png = plot.png(&o).unwrap();
    println!("png {} bytes {:?}", png.len(), t.elapsed());
    std::fs::write(format!("{}.png", a[3]), png).unwrap();
}
