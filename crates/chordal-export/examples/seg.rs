#![allow(clippy::disallowed_methods, missing_docs)]
use chordal::{Job, Machine, Source, SourceMap};
use chordal_export::*;
fn main() {
    let text = std::fs::read("/tmp/million.nc").unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("x.nc", text));
    let job = Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
    let mut c = Vec::new();
    job.report_with(|x, _| c.push(x.clone()));
    let arc = Job::new({let mut s = SourceMap::new(); s.add(Source::new("a", b"G20 G90 G17 G0 X0 Y0 Z0\nG1 X0 F10.\nG3 X2.1234 Y1.3412 R3.\nM30\n".as_slice())); s}, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
    let mut arcs = Vec::new();
    arc.report_with(|x, _| if x.kind.shape().is_some() { arcs.push(x.clone()) });
    for (name, c) in [("lines", c), ("arcs", vec![arcs[0].clone(); 1_000_000])] {
        for k in 0..3 {
            let t = std::time::Instant::now();
            let n = match k {
                0 => { let mut w = CommandJsonLines::new(Vec::with_capacity(1<<29), &job).unwrap(); for x in &c { w.command(x).unwrap(); } w.finish().unwrap().len() }
                1 => { let mut w = CommandCsv::new(Vec::with_capacity(1<<29), &job).unwrap(); for x in &c { w.command(x).unwrap(); } w.finish().unwrap().len() }
                _ => { let mut w = Canon::new(Vec::with_capacity(1<<29), &job).unwrap(); for x in &c { w.command(x).unwrap(); } w.finish().unwrap().len() }
            };
            let e = t.elapsed();
            println!("{name} {k}: {} commands {n} bytes {e:?} {:.0}/s", c.len(), c.len() as f64 / e.as_secs_f64());
        }
    }
}
