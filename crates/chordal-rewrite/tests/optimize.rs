//! Feeds by what the tool meets: only F words change, and no chip is thicker than asked.

use chordal::motion::MotionOptions;
use chordal::stock::{EngagementOptions, StockOptions};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::{ChipLimit, OptimizeError, OptimizeOptions, OptimizedProgram, optimize};

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
        split: false,
        motion: MotionOptions::default(),
    }
}

fn run(text: &str, limit: ChipLimit, faster: f64) -> Result<OptimizedProgram, OptimizeError> {
    optimize(&job(text), &options(limit, faster), &|_| Err("no files".to_string()))
}

fn run_split(text: &str, limit: ChipLimit, faster: f64) -> OptimizedProgram {
    let options = OptimizeOptions { split: true, ..options(limit, faster) };
    optimize(&job(text), &options, &|_| Err("no files".to_string())).unwrap()
}

/// The points of X and Y that blocks after a line name, as whole thousandths, up to a block that names neither.
fn points(text: &str, after: &str, [mut x, mut y]: [i64; 2]) -> Vec<[i64; 2]> {
    let blocks = text.lines().skip_while(|line| !line.starts_with(after)).skip(1);
    let mut points = Vec::new();
    for block in blocks.take_while(|block| block.contains(['X', 'Y'])) {
        for word in block.split(' ') {
            let number = |word: &str| (word[1..].parse::<f64>().unwrap() * 1000.0).round() as i64;
            match word.as_bytes()[0] {
                b'X' => x = number(word),
                b'Y' => y = number(word),
                _ => {}
            }
        }
        points.push([x, y]);
    }
    points
}

/// Along a slanted edge, of which more and more is left.
const SLANTED: &str = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-8. Y-4.\nG43 H1 Z5.\nG1 Z-4. F2000.\n\
                       N9 G1 X110. Y6. F900. (an edge)\nG0 Z5.\nM5\nM30\n";

fn text(done: &OptimizedProgram) -> String {
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

#[test]
fn a_long_line_is_written_in_parts_on_it() {
    let whole = run(SLANTED, ChipLimit::Best, 3.0).unwrap();
    let done = run_split(SLANTED, ChipLimit::Best, 3.0);
    let new = text(&done);
    let splits = done.splits.unwrap();
    assert_eq!(splits.blocks, 1);
    assert!(splits.parts > 2 && splits.off_mm < 1e-9, "{splits:?}\n{new}");
    assert!(done.seconds[1] < whole.seconds[1], "{:?} {:?}", done.seconds, whole.seconds);
    let [before, after] = done.chips[0].peak_mm;
    assert!(after <= before);
    // The number stays with the first part, and the comment after it.
    assert_eq!(new.matches("N9 G1 X").count(), 1);
    assert_eq!(new.matches("(an edge)").count(), 1);
    let points = points(&new, "G1 Z-4.", [-8000, -4000]);
    assert_eq!((points.len(), points.last()), (splits.parts, Some(&[110_000, 6000])), "{new}");
    let mut last = -8000;
    for [x, y] in points {
        assert_eq!(10 * (x + 8000), 118 * (y + 4000), "{new}");
        assert!(x - last >= 1990, "shorter than 2 mm\n{new}");
        last = x;
    }
    // What is said of the change is the block with its parts.
    let change = done.changes.iter().find(|change| change.line == 8).unwrap();
    assert_eq!(change.before, "N9 G1 X110. Y6. F900. (an edge)");
    assert_eq!(change.after.lines().count(), splits.parts);
    // In the other unit, and by distances.
    let inch = SLANTED
        .replace("G21", "G20")
        .replace("G0 X-8. Y-4.", "G0 X-.3 Y-.2")
        .replace("Z5.", "Z.2")
        .replace("Z-4. F2000.", "Z-.16 F80.")
        .replace("G1 X110. Y6. F900.", "G91 G1 X4.6 Y.4 F35.4");
    let done = run_split(&inch.replace("(an edge)\n", "(an edge)\nG90\n"), ChipLimit::Best, 3.0);
    assert!(done.splits.is_none_or(|splits| splits.off_mm < 1e-9));
}

#[test]
fn an_arc_is_written_in_parts_at_its_whole_points() {
    // Half a circle of 40 that comes from air, cuts along the edge and goes back into air, and a helix of the same.
    let program = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X10. Y-38.\nG43 H1 Z5.\nG1 Z-4. F2000.\n\
                   G2 X90. I40. F900.\nG0 Z5.\nG0 X10.\nG1 Z-4. F2000.\nG2 X90. Z-2. I40. F900.\nG0 Z5.\nM5\nM30\n";
    let done = run_split(program, ChipLimit::Best, 3.0);
    let new = text(&done);
    let splits = done.splits.unwrap();
    assert!(splits.blocks == 1 && splits.parts > 2 && splits.off_mm < 1e-9, "{splits:?}\n{new}");
    let points = points(&new, "G1 Z-4.", [10_000, -38_000]);
    assert_eq!((points.len(), points.last()), (splits.parts, Some(&[90_000, -38_000])), "{new}");
    for [x, y] in points {
        let [a, b] = [x - 50_000, y + 38_000];
        assert_eq!(a * a + b * b, 40_000 * 40_000, "{new}");
    }
    let helix = done.not_split.iter().find(|each| each.line == 12).unwrap();
    assert!(helix.why.contains("a helix"), "{helix:?}");
}

#[test]
fn what_cannot_be_split_exactly_stays_whole_and_is_said() {
    let why = |program: &str| {
        let done = run_split(program, ChipLimit::Best, 3.0);
        assert!(done.splits.is_none(), "{}", text(&done));
        done.not_split.first().map(|each| (each.line, each.why))
    };
    // No thousandth between the ends is on this line.
    let uneven = SLANTED.replace("X110. Y6.", "X109.999 Y6.");
    let (line, reason) = why(&uneven).unwrap();
    assert!(line == 8 && reason.contains("no exact point"), "{reason}");
    let by_radius = SLANTED.replace("G1 X110. Y6. F900.", "G3 X110. Y6. R400. F900.");
    assert!(why(&by_radius).unwrap().1.contains("by R"));
    // Nothing to save where the whole pass is alike: a slot that begins next to the block and ends in it.
    let slot = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-6. Y30.\nG43 H1 Z5.\nG1 Z-4. F2000.\nX92. F900.\n\
                G0 Z5.\nM5\nM30\n";
    assert_eq!(why(slot), None);
    let twice = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-8. Y-4.\nG43 H1 Z5.\nM97 P100\nM97 P100\n\
                 G0 Z5.\nM5\nM30\nN100 G0 X-8. Y-4.\nG1 Z-4. F2000.\nG1 X110. Y6. F900.\nG0 Z5.\nM99\n";
    assert!(why(twice).is_none_or(|(_, why)| why.contains("several times")));
}
