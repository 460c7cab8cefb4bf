//! Feeds by what the tool meets: only F words change, and no chip is thicker than asked.

use chordal::motion::MotionOptions;
use chordal::stock::{EngagementOptions, StockOptions};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::{ChipLimit, OptimizeError, OptimizeOptions, Optimized, optimize};

const SETUP: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '100 mm', Y = '60 mm', Z = '0 mm' }
material = 'aluminium'
[tools.1]
shape = 'flat'
diameter = '10 mm'
teeth = 3
flute_length = '25 mm'
length = '0 mm'
[tools.2]
shape = 'flat'
diameter = '6 mm'
flute_length = '15 mm'
length = '0 mm'
";

/// A pass 2 mm wide, then a slot with the same F.
const PASSES: &str = "O1 (PASSES)\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-8. Y-3.\nG43 H1 Z5.\n\
                      G1 Z-4. F2000. (down beside it)\nX110. F900.\nG0 Z5.\nG0 X-8. Y30.\nG1 Z-4. F2000.\n\
                      G1 X110. F900. (a slot)\nG0 Z5.\nM5\nM30\n";

fn job(text: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let machine = Machine::from_toml("setup.toml", SETUP, &|name| Err(name.to_string()));
    Job::new(sources, machine.unwrap()).unwrap()
}

fn options(limit: ChipLimit, faster: f64) -> OptimizeOptions {
    let stock = StockOptions { resolution_mm: Some(0.2), ..StockOptions::default() };
    OptimizeOptions {
        engagement: EngagementOptions { stock, ..EngagementOptions::default() },
        limit,
        faster,
        motion: MotionOptions::default(),
    }
}

fn run(text: &str, limit: ChipLimit, faster: f64) -> Result<Optimized, OptimizeError> {
    optimize(&job(text), &options(limit, faster), &|_| Err("no files".to_string()))
}

fn text(done: &Optimized) -> String {
    String::from_utf8(done.text.clone()).unwrap()
}

#[test]
fn a_slot_is_slowed_to_the_chip_that_is_asked() {
    // In the slot the chip is the feed of a tooth, 0.05 mm: 0.04 mm is at least 20 % less, in steps of 5 %.
    let done = run(PASSES, ChipLimit::Thickness(0.04), 1.0).unwrap();
    let new = text(&done);
    assert!(new.contains("G1 X110. F705. (a slot)"), "{new}");
    // The narrow pass has thinner chips: 0.8 of it, and what a column does not know.
    let [before, after] = done.chips[0].peak_mm;
    assert!((before - 0.05).abs() < 1e-9 && after <= 0.04 && after > 0.037, "{before} {after}");
    // Nothing but F is another one.
    let without = |text: &str| {
        let words = text.split_whitespace().filter(|word| !word.starts_with('F'));
        words.collect::<Vec<_>>().join(" ")
    };
    assert_eq!(without(&new), without(PASSES));
    assert!(done.seconds[1] > done.seconds[0] && done.proof.cells == 500 * 300);
}

#[test]
fn a_narrow_pass_goes_faster_only_when_that_is_asked() {
    let done = run(PASSES, ChipLimit::Best, 1.0).unwrap();
    assert_eq!(text(&done), PASSES);
    assert_eq!(done.blocks[0], 0);
    let done = run(PASSES, ChipLimit::Best, 2.0).unwrap();
    let new = text(&done);
    assert!(new.contains("G1 X110. F900. (a slot)"), "{new}");
    assert!(!new.contains("\nX110. F900."), "{new}");
    let [before, after] = done.chips[0].peak_mm;
    assert!(after <= before && done.seconds[1] < done.seconds[0]);
    // A plunge is never faster, beside the part or in it.
    assert!(new.contains("G1 Z-4. F2000. (down beside it)"), "{new}");
    // Twice at most.
    let most =
        new.lines().filter_map(|line| line.split('F').nth(1)?.split(' ').next()?.parse().ok());
    assert!(most.fold(0.0, f64::max) <= 4000.0);
}

#[test]
fn a_block_after_a_slower_one_gets_its_feed_back() {
    let program = PASSES
        .replace("G1 X110. F900. (a slot)\n", "G1 X110. F900. (a slot)\nY50. (air)\nX-8. Y51.\n");
    let done = run(&program, ChipLimit::Thickness(0.04), 1.0).unwrap();
    let new = text(&done);
    // The last pass cuts a slot again.
    assert!(new.contains("F705. (a slot)\nY50. F900. (air)\nX-8. Y51. F705.\n"), "{new}");
}

#[test]
fn a_subprogram_has_one_feed_for_all_its_runs() {
    let program = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-8. Y10.\nG43 H1 Z5.\nG1 Z-4. F900.\nM97 P100\n\
                   G0 Y12.\nM97 P100\nG0 Z5.\nM5\nM30\nN100 G1 X110.\nG0 X-8.\nM99\n";
    let done = run(program, ChipLimit::Thickness(0.03), 1.0).unwrap();
    let new = text(&done);
    assert_eq!(new.matches("N100 G1 X110. F").count(), 1, "{new}");
    assert!(done.chips[0].peak_mm[1] <= 0.03);
}

#[test]
fn what_is_not_known_is_refused() {
    let unknown = PASSES.replace("T1 M6", "T7 M6");
    assert!(matches!(run(&unknown, ChipLimit::Best, 1.0), Err(OptimizeError::NotKnown { .. })));
    let toothless = PASSES.replace("T1 M6", "T2 M6").replace("H1", "H2");
    let refused = run(&toothless, ChipLimit::Best, 1.0).unwrap_err();
    assert!(matches!(&refused, OptimizeError::NotKnown { help, .. } if help.contains("teeth")));
    let wrong = PASSES.replace("G54 G17", "G54 G17 G777");
    assert!(matches!(run(&wrong, ChipLimit::Best, 1.0), Err(OptimizeError::NotKnown { .. })));
    // A feed by turns after a changed F by time would count it.
    let turns = PASSES.replace("G0 Z5.\nM5", "G95\nX50.\nG94\nG0 Z5.\nM5");
    let refused = run(&turns, ChipLimit::Thickness(0.04), 1.0);
    assert!(
        matches!(refused, Err(OptimizeError::Refused(_) | OptimizeError::NotKnown { .. })),
        "{refused:?}"
    );
}
