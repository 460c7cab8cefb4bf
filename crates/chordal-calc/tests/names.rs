//! Names of threads as people write them.

use chordal_calc::{
    FitClass, ThreadDesignation, ThreadForm, ThreadHand, ThreadLocation, named_thread,
};

fn read(name: &str) -> ThreadDesignation {
    ThreadDesignation::read(name).unwrap_or_else(|error| panic!("{name}: {error}; {}", error.help))
}

#[track_caller]
fn refused(name: &str, texts: &[&str]) {
    let error = ThreadDesignation::read(name).expect_err(name);
    let whole = format!("{}; {}", error.message, error.help);
    for text in texts {
        assert!(whole.contains(text), "{name}: {whole}");
    }
}

/// Inches and threads per inch.
#[test]
fn inch_threads() {
    for (name, diameter, tpi) in [
        ("1-1/16-28", 1.0625, 28.0),
        ("1 1/16-28", 1.0625, 28.0),
        ("1 1/16 - 28", 1.0625, 28.0),
        ("1-1/2-6 UNC", 1.5, 6.0),
        ("1.5-8", 1.5, 8.0),
        ("1/4-20 UNC-2B", 0.25, 20.0),
        ("1/4-20unc-2b", 0.25, 20.0),
        ("1/4-20UNC2B", 0.25, 20.0),
        ("1/4\"-20", 0.25, 20.0),
        ("1/4 x 20", 0.25, 20.0),
        (".250-20", 0.25, 20.0),
        ("0.5-13 UNC 2A LH", 0.5, 13.0),
        ("#10-24", 0.19, 24.0),
        ("# 10 - 24", 0.19, 24.0),
        ("10-24", 0.19, 24.0),
        ("10-32 UNF", 0.19, 32.0),
        ("NO. 8-32", 0.164, 32.0),
        ("no 8-32", 0.164, 32.0),
        ("0-80", 0.06, 80.0),
        ("4-40", 0.112, 40.0),
        // On whole inches there are no such fine threads, on screws no such coarse ones.
        ("2-4.5 UNC", 2.0, 4.5),
        ("2-16", 2.0, 16.0),
        ("1-8", 1.0, 8.0),
        ("4-4", 4.0, 4.0),
        ("1.5-8 8-UN", 1.5, 8.0),
        ("1 1/2 - 8UN - 2A", 1.5, 8.0),
        ("1-14 TPI", 1.0, 14.0),
    ] {
        let thread = read(name);
        assert_eq!(thread.form, ThreadForm::Unified, "{name}");
        assert!((thread.major / 25.4 - diameter).abs() < 1e-12, "{name}: {}", thread.major / 25.4);
        assert!((25.4 / thread.pitch - tpi).abs() < 1e-9, "{name}: {}", 25.4 / thread.pitch);
    }
}

/// Millimetres.
#[test]
fn metric_threads() {
    for (name, diameter, pitch) in [
        ("M20x2.5", 20.0, 2.5),
        ("M 20 x 2", 20.0, 2.0),
        ("M20X2", 20.0, 2.0),
        ("M20*2", 20.0, 2.0),
        ("M20×2", 20.0, 2.0),
        ("m10-1.5", 10.0, 1.5),
        ("M8x1,25", 8.0, 1.25),
        ("M20", 20.0, 2.5),
        ("M30", 30.0, 3.5),
        ("m6-6H", 6.0, 1.0),
        ("M10x1.5-6g LH", 10.0, 1.5),
        ("M10 x 1.5 - 6H/6g", 10.0, 1.5),
    ] {
        let thread = read(name);
        assert_eq!(
            (thread.form, thread.major, thread.pitch),
            (ThreadForm::Metric, diameter, pitch),
            "{name}"
        );
    }
    assert!(read("M20").notes[0].contains("M20x2.5"));
    refused("M21", &["no pitch", "M21", "ISO 261"]);
}

/// Pipe threads, by inches and millimetres of their standards.
#[test]
fn pipe_threads() {
    for (name, form, diameter_mm, tpi) in [
        ("1/8-27 NPT", ThreadForm::Npt, 0.405 * 25.4, 27.0),
        ("1/8 NPT", ThreadForm::Npt, 0.405 * 25.4, 27.0),
        ("npt 1/2", ThreadForm::Npt, 0.84 * 25.4, 14.0),
        ("1-11 1/2 NPT", ThreadForm::Npt, 1.315 * 25.4, 11.5),
        ("1 1/2-11.5 NPT", ThreadForm::Npt, 1.9 * 25.4, 11.5),
        ("3/4\" NPTF", ThreadForm::Nptf, 1.05 * 25.4, 14.0),
        ("G 1/2", ThreadForm::G, 20.955, 14.0),
        ("g1/2", ThreadForm::G, 20.955, 14.0),
        ("G1/2A", ThreadForm::G, 20.955, 14.0),
        ("G 1 1/4 B", ThreadForm::G, 41.91, 11.0),
        ("1/2 BSPP", ThreadForm::G, 20.955, 14.0),
        ("R 1/2", ThreadForm::R, 20.955, 14.0),
        ("1/2-14 BSPT", ThreadForm::R, 20.955, 14.0),
        ("Rc 3/8", ThreadForm::R, 16.662, 19.0),
    ] {
        let thread = read(name);
        assert_eq!(thread.form, form, "{name}");
        assert!((thread.major - diameter_mm).abs() < 1e-9, "{name}: {}", thread.major);
        assert!((25.4 / thread.pitch - tpi).abs() < 1e-9, "{name}");
    }
    refused("1/8-20 NPT", &["27 threads per inch", "not 20"]);
    refused("5/16 NPT", &["no NPT", "1/4, 3/8"]);
    refused("R 5/8", &["no R thread"]);
    refused("1/2 NPT 2A", &["`2A`", "pipe"]);
    assert!(read("G1/2").thread(1).is_err() && read("1/2 NPT").thread(1).is_err());
}

#[test]
fn classes_are_read_or_refused() {
    let unified = |grade, place| FitClass::Unified { grade, place };
    assert_eq!(read("1/4-20 2a").classes, [unified(2, ThreadLocation::Outside)]);
    assert_eq!(
        read("1/4-20 UNC-3B/3A").classes,
        [unified(3, ThreadLocation::Outside), unified(3, ThreadLocation::Inside)]
    );
    assert_eq!(read("M10-6H/6g").classes.len(), 2);
    for name in ["M10-6g", "M10-6H", "M10-4h", "M10-5H", "M10-7H", "M10-6e", "M10-8g", "M10-4g6g"] {
        assert_eq!(read(name).classes[0].to_string(), name[4..], "{name}");
    }
    let all = ["1A 2A 3A", "1B 2B 3B", "6g 6H"];
    refused("1 1/16-28 9Q", &[&["`9Q` is not a class of a unified thread"], &all[..]].concat());
    refused("1/4-20 4A", &all);
    refused("1/4-20 UNC-6g", &all);
    refused(
        "M10x1.5-2A",
        &["`2A` is not a class of a metric thread", "6g 8g 6e 4h or 4g6g", "6H 5H"],
    );
    // The major diameter has the grades 4, 6 and 8 only; a field is not outside and inside at once.
    refused("M10-5g", &["`5g`", "4, 6 or 8"]);
    refused("M10-4g6H", &["`4g6H`"]);
    refused("1/4-20 2A 3A", &["2A", "3A", "outside"]);
    refused("1/4-20 FOO", &["`FOO`", "UNC, UNF"]);
    refused("1/4-20 UNJC-3A", &["UNJ", "B1.15"]);
    refused("MJ6x1", &["MJ", "ISO 5855"]);
    refused("#11.5-24", &["11.5", "0 to 12"]);
}

/// The case of a metric class says where the thread is; a name in one case may have lost it.
#[test]
fn a_lost_case_is_said() {
    assert!(read("M10X1.5-6G").notes[0].contains("6G is for inside threads; outside is 6g"));
    assert!(read("m10x1.5-6h").notes[0].contains("6h is for outside threads; inside is 6H"));
    for clear in ["M10x1.5-6g", "M10X1.5-6H", "M10x1.5-6G", "M10x1.5-6h", "m10x1.5-6g"] {
        assert!(read(clear).notes.is_empty(), "{clear}");
    }
}

#[test]
fn hands() {
    assert_eq!(read("0.5-13 UNC 2A LH").hand, Some(ThreadHand::Left));
    assert_eq!(read("M10 lh").hand, Some(ThreadHand::Left));
    assert_eq!(read("M10 RH").hand, Some(ThreadHand::Right));
    assert_eq!(read("M10").hand, None);
    refused("M10 LH RH", &["left and right"]);
}

/// A series that the sizes do not have is said, and the right one named.
#[test]
fn misnamed_series() {
    for (name, texts) in [
        ("1.5-8 UNC", &["UNC of 1.5 in has 6 threads", "1.5-8 is 8-UN"][..]),
        ("2-16 UNC", &["UNC of 2 in has 4.5 threads", "2-16 is 16-UN"]),
        ("1/2-20 UNC", &["has 13 threads", "0.5-20 is UNF"]),
        ("1/4-32 UNF", &["has 28 threads", "0.25-32 is UNEF"]),
        ("1 1/16-28 UNF", &["no diameter of 1.0625 in", "28-UN"]),
        ("1/2-13 UN", &["0.5-13 is UNC"]),
        ("1/2-12 UN", &["UNS"]),
    ] {
        let notes = read(name).notes.join(" ");
        for text in texts {
            assert!(notes.contains(text), "{name}: {notes}");
        }
    }
    for right in ["1.5-6 UNC", "2-16 UN", "1-14 UNS", "1-12 UNF", "1/4-32 UNEF", "1.5-8 8-UN"] {
        assert!(read(right).notes.is_empty(), "{right}: {:?}", read(right).notes);
    }
    // A number without its sign is said, too.
    assert!(read("10-24").notes[0].contains("number 10: 0.19 in"));
    assert!(read("#10-24").notes.is_empty());
}

/// ASME B1.20.1, table 2: E0, E1 and L2; ISO 228-1: D2, D1 and limits; in the tables' digits.
#[test]
fn pipe_sizes() {
    let near = |name: &str, unit: f64, sizes: &[(&str, f64)], digits: f64| {
        let thread = read(name);
        let worked = named_thread(&thread, 1, thread.units).unwrap();
        for (symbol, expected) in sizes {
            let value = worked.value(symbol).unwrap_or_else(|| panic!("{name} has no {symbol}"));
            let value = value / unit;
            assert!((value - expected).abs() <= 0.6 * digits, "{name}: {symbol} = {value}");
        }
    };
    let inch = |name: &str, sizes: &[(&str, f64)]| near(name, 25.4, sizes, 1e-5);
    inch("1/8 NPT", &[("E0", 0.36351), ("E1", 0.37360), ("L2", 0.26385), ("h", 0.02963)]);
    inch("1/4 NPT", &[("E0", 0.47739), ("E1", 0.49163), ("L2", 0.40178)]);
    inch("1/2 NPT", &[("E0", 0.75843), ("E1", 0.77843), ("L2", 0.53371), ("h", 0.05714)]);
    inch("1 NPT", &[("E0", 1.21363), ("E1", 1.23863), ("L2", 0.68278)]);
    inch("2 NPT", &[("E0", 2.26902), ("E1", 2.29627), ("L2", 0.75652)]);
    // A taper of 1:16 on the diameter is 1°47' to the axis.
    let thread = read("1/2 NPT");
    let angle = named_thread(&thread, 1, thread.units).unwrap().value("α").unwrap();
    assert!((angle.to_degrees() - (1.0 + 47.0 / 60.0)).abs() < 0.5 / 60.0);

    let mm = |name: &str, sizes: &[(&str, f64)]| near(name, 1.0, sizes, 1e-3);
    mm("G 1/8", &[("D2", 9.147), ("D1", 8.566), ("h", 0.581), ("D1max", 8.848)]);
    mm("G 1/4", &[("D2", 12.301), ("D1", 11.445), ("D1max", 11.890)]);
    mm("G 1/2 A", &[("D2", 19.793), ("D1", 18.631), ("D1max", 19.172), ("D2max", 19.935)]);
    mm("G 1/2 A", &[("dmin", 20.671), ("d2min", 19.651)]);
    mm("G 1/2 B", &[("d2min", 19.509)]);
    mm("G 1", &[("D2", 31.770), ("D1", 30.291), ("D1max", 30.931)]);
    // ISO 7-1: 8.2 mm before the gauge plane the diameters are smaller by 8.2/16.
    mm("R 1/2", &[("D2", 19.793), ("D1", 18.631), ("L", 8.2), ("D20", 19.281)]);
}
