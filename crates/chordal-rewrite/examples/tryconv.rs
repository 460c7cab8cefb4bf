#![allow(clippy::disallowed_methods)]
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::convert::{ConversionOptions, convert};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let text = std::fs::read(&a[1]).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("p", text));
    let job = Job::new(sources, Machine::from_builtin(&a[2]).unwrap()).unwrap();
    let to = Machine::from_builtin(&a[3]).unwrap();
    let c = convert(&job, &to, &ConversionOptions::default());
    for r in &c.refusals {
        println!("REFUSED {} {} : {}", r.line, r.words, r.reason);
    }
    println!("{}", c.text);
    for x in &c.changes {
        println!("CHANGE {} {} -> {} : {}", x.line, x.before, x.after, x.reason);
    }
    if let Some(cert) = &c.certificate {
        println!(
            "verdict {:?} dist {:?}",
            cert.comparison.verdict, cert.comparison.max_distance_mm
        );
        for d in cert.comparison.differences.iter().take(15) {
            println!(
                "{:?} {:?} {:?}",
                d.category,
                d.blocks.map(|b| b.map(|b| b.lines())),
                d.values
            );
        }
    }
    println!("holds {}", c.holds());
}
