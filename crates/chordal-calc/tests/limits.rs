//! Limits of the classes of fit, against the tables of ASME B1.1 and ISO 965-2.

use chordal_calc::{AnswerUnit, ThreadDesignation, WorkedCalculation, named_thread};

fn thread(name: &str) -> WorkedCalculation {
    let read = ThreadDesignation::read(name).unwrap_or_else(|error| panic!("{name}: {error}"));
    named_thread(&read, 1, read.units).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Each symbol has this value, to the last digit of the table.
#[track_caller]
fn has(name: &str, unit: AnswerUnit, limits: &[(&str, f64)]) {
    let worked = thread(name);
    for (symbol, expected) in limits {
        let value = worked.value(symbol).unwrap_or_else(|| panic!("{name} has no {symbol}"));
        let value = value / unit.mm();
        assert!((value - expected).abs() < 1e-9, "{name}: {symbol} = {value}, not {expected}");
    }
}

/// Major and pitch diameter outside, most and least of each.
#[track_caller]
fn outside(name: &str, [dmax, dmin, d2max, d2min]: [f64; 4]) {
    let limits = [("dmax", dmax), ("dmin", dmin), ("d2max", d2max), ("d2min", d2min)];
    has(name, AnswerUnit::Inch, &limits);
}

/// Minor and pitch diameter inside, least and most of each.
#[track_caller]
fn inside(name: &str, [least, most, pitch_least, pitch_most]: [f64; 4]) {
    let limits = [("D1min", least), ("D1max", most), ("D2min", pitch_least), ("D2max", pitch_most)];
    has(name, AnswerUnit::Inch, &limits);
}

/// The table of ASME B1.1, outside threads.
#[test]
fn unified_outside() {
    outside("0-80 UNF-2A", [0.0595, 0.0563, 0.0514, 0.0496]);
    outside("1-64 UNC-2A", [0.0724, 0.0686, 0.0623, 0.0603]);
    outside("1-72 UNF-3A", [0.0730, 0.0695, 0.0640, 0.0626]);
    outside("2-56 UNC-2A", [0.0854, 0.0813, 0.0738, 0.0717]);
    has("4-40 UNC-2A", AnswerUnit::Inch, &[("es", 0.0008), ("dmax", 0.1112), ("dmin", 0.1061)]);
    has("5-44 UNF-2A", AnswerUnit::Inch, &[("es", 0.0007), ("dmax", 0.1243), ("dmin", 0.1195)]);
    has("8-32 UNC-2A", AnswerUnit::Inch, &[("es", 0.0009), ("dmax", 0.1631), ("dmin", 0.1571)]);
    has("12-28 UNF-2A", AnswerUnit::Inch, &[("es", 0.0010), ("dmax", 0.2150), ("dmin", 0.2085)]);
    outside("10-24 UNC-2A", [0.1890, 0.1818, 0.1619, 0.1586]);
    outside("1/4-20 UNC-1A", [0.2489, 0.2367, 0.2164, 0.2108]);
    outside("1/4-20 UNC-2A", [0.2489, 0.2408, 0.2164, 0.2127]);
    outside("1/4-20 UNC-3A", [0.2500, 0.2419, 0.2175, 0.2147]);
    outside("3/8-16 UNC-2A", [0.3737, 0.3643, 0.3331, 0.3287]);
    outside("1/2-13 UNC-2A", [0.4985, 0.4876, 0.4485, 0.4435]);
    outside("5/8-11 UNC-1A", [0.6234, 0.6052, 0.5644, 0.5561]);
    outside("5/8-11 UNC-3A", [0.6250, 0.6129, 0.5660, 0.5619]);
    outside("5/8-18 UNF-2A", [0.6236, 0.6149, 0.5875, 0.5828]);
    outside("15/16-16 UN-2A", [0.9360, 0.9266, 0.8954, 0.8904]);
    outside("15/16-16 UN-3A", [0.9375, 0.9281, 0.8969, 0.8932]);
    outside("15/16-20 UNEF-2A", [0.9361, 0.9280, 0.9036, 0.8991]);
    outside("15/16-20 UNEF-3A", [0.9375, 0.9294, 0.9050, 0.9016]);
    outside("1-8 UNC-2A", [0.9980, 0.9830, 0.9168, 0.9100]);
    outside("1 1/2-8 UN-2A", [1.4978, 1.4828, 1.4166, 1.4093]);
    outside("1 1/16-28 UN-2A", [1.0613, 1.0548, 1.0381, 1.0341]);
    outside("1 1/16-28 UN-3A", [1.0625, 1.0560, 1.0393, 1.0363]);
    // Round root of UNR threads, the column of its own in the table.
    has("0-80 UNF-2A", AnswerUnit::Inch, &[("d3max", 0.0446)]);
    has("15/16-12 UN-2A", AnswerUnit::Inch, &[("d3max", 0.8366)]);
    has("15/16-12 UN-3A", AnswerUnit::Inch, &[("d3max", 0.8383)]);
}

/// The table of ASME B1.1, inside threads.
#[test]
fn unified_inside() {
    inside("0-80 UNF-2B", [0.0465, 0.0514, 0.0519, 0.0542]);
    inside("1-64 UNC-2B", [0.0561, 0.0623, 0.0629, 0.0655]);
    inside("1-72 UNF-3B", [0.0580, 0.0635, 0.0640, 0.0659]);
    inside("2-56 UNC-3B", [0.0667, 0.0737, 0.0744, 0.0765]);
    inside("6-32 UNC-2B", [0.104, 0.114, 0.1177, 0.1214]);
    inside("10-24 UNC-2B", [0.145, 0.156, 0.1629, 0.1672]);
    inside("10-24 UNC-3B", [0.1450, 0.1555, 0.1629, 0.1661]);
    inside("1/4-20 UNC-1B", [0.196, 0.207, 0.2175, 0.2248]);
    inside("1/4-20 UNC-2B", [0.196, 0.207, 0.2175, 0.2224]);
    inside("1/4-20 UNC-3B", [0.1960, 0.2067, 0.2175, 0.2211]);
    inside("3/8-16 UNC-2B", [0.307, 0.321, 0.3344, 0.3401]);
    inside("1/2-13 UNC-2B", [0.417, 0.434, 0.4500, 0.4565]);
    inside("1/2-13 UNC-3B", [0.4170, 0.4284, 0.4500, 0.4548]);
    inside("5/8-11 UNC-2B", [0.527, 0.546, 0.5660, 0.5732]);
    inside("15/16-20 UNEF-2B", [0.883, 0.895, 0.9050, 0.9109]);
    inside("1-8 UNC-2B", [0.865, 0.890, 0.9188, 0.9276]);
    inside("1-8 UNC-3B", [0.8650, 0.8797, 0.9188, 0.9254]);
    inside("5/8-28 UN-2B", [0.586, 0.595, 0.6018, 0.6067]);
    inside("5/8-28 UN-3B", [0.5860, 0.5926, 0.6018, 0.6055]);
    inside("1 1/16-28 UN-3B", [1.0240, 1.0301, 1.0393, 1.0432]);
}

/// The coarse series, class 2B, from number 1 to four inches.
#[test]
fn coarse_holes() {
    for (name, limits) in [
        ("#1-64", [0.0561, 0.0623, 0.0629, 0.0655]),
        ("#2-56", [0.0667, 0.0737, 0.0744, 0.0772]),
        ("#3-48", [0.0764, 0.0845, 0.0855, 0.0885]),
        ("#4-40", [0.0849, 0.0939, 0.0958, 0.0991]),
        ("#5-40", [0.0979, 0.1062, 0.1088, 0.1121]),
        ("#6-32", [0.104, 0.114, 0.1177, 0.1214]),
        ("#8-32", [0.130, 0.139, 0.1437, 0.1475]),
        ("#10-24", [0.145, 0.156, 0.1629, 0.1672]),
        ("#12-24", [0.171, 0.181, 0.1889, 0.1933]),
        ("1/4-20", [0.196, 0.207, 0.2175, 0.2224]),
        ("5/16-18", [0.252, 0.265, 0.2764, 0.2817]),
        ("3/8-16", [0.307, 0.321, 0.3344, 0.3401]),
        ("7/16-14", [0.360, 0.376, 0.3911, 0.3972]),
        ("1/2-13", [0.417, 0.434, 0.4500, 0.4565]),
        ("9/16-12", [0.472, 0.490, 0.5084, 0.5152]),
        ("5/8-11", [0.527, 0.546, 0.5660, 0.5732]),
        ("3/4-10", [0.642, 0.663, 0.6850, 0.6927]),
        ("7/8-9", [0.755, 0.778, 0.8028, 0.8110]),
        ("1-8", [0.865, 0.890, 0.9188, 0.9276]),
        ("1 1/8-7", [0.970, 0.998, 1.0322, 1.0416]),
        ("1 1/4-7", [1.095, 1.123, 1.1572, 1.1668]),
        ("1 3/8-6", [1.195, 1.225, 1.2667, 1.2771]),
        ("1 1/2-6", [1.320, 1.350, 1.3917, 1.4022]),
        ("1 3/4-5", [1.534, 1.568, 1.6201, 1.6317]),
        ("2-4.5", [1.759, 1.795, 1.8557, 1.8681]),
        ("2 1/4-4.5", [2.009, 2.045, 2.1057, 2.1183]),
        ("2 1/2-4", [2.229, 2.267, 2.3376, 2.3511]),
        ("2 3/4-4", [2.479, 2.517, 2.5876, 2.6013]),
        ("3-4", [2.729, 2.767, 2.8376, 2.8515]),
        ("3 1/4-4", [2.979, 3.017, 3.0876, 3.1017]),
        ("3 1/2-4", [3.229, 3.267, 3.3376, 3.3519]),
        ("3 3/4-4", [3.479, 3.517, 3.5876, 3.6021]),
        ("4-4", [3.729, 3.767, 3.8376, 3.8523]),
    ] {
        inside(&format!("{name} UNC-2B"), limits);
    }
}

/// By hand: 9·P = 0.32143 and not D is the length of engagement of 28-UN, so T2 is 0.0015·1.02041 +
/// 0.0015·0.56695 + 0.015·0.10845 = 0.004008.
#[test]
fn fine_series_engage_nine_pitches() {
    let worked = thread("1 1/16-28 UN-2A/2B");
    let t2 = worked.value("T2").unwrap() / 25.4;
    assert!((t2 - 0.004_008).abs() < 1e-9, "{t2}");
    assert_eq!(worked.step("Le").unwrap().formula, "9·P");
    assert_eq!(thread("1-8 UNC-2A").step("Le").unwrap().formula, "D");
    // A pair shows both sides, and what they share once.
    assert!(worked.step("dmax").is_some() && worked.step("D1max").is_some());
    assert_eq!(worked.steps.iter().filter(|step| step.quantity.symbol == "T2").count(), 1);
}

/// Without a class the answer is that of the basic sizes.
#[test]
fn no_class_no_limits() {
    for name in ["1/4-20 UNC", "M10x1.5"] {
        let worked = thread(name);
        assert!(worked.step("dmax").is_none() && worked.step("D1max").is_none());
        assert!(worked.notes.iter().any(|note| note.contains("Basic sizes")), "{name}");
    }
}

/// ISO 965-2 and ASME B1.13M, outside threads: major and pitch diameter, then the root.
#[test]
fn metric_outside() {
    let outside = |name: &str, [dmax, dmin, d2max, d2min]: [f64; 4]| {
        let limits = [("dmax", dmax), ("dmin", dmin), ("d2max", d2max), ("d2min", d2min)];
        has(name, AnswerUnit::Millimetre, &limits);
    };
    outside("M1.6-6g", [1.581, 1.496, 1.354, 1.291]);
    outside("M3x0.5-6g", [2.980, 2.874, 2.655, 2.580]);
    outside("M3x0.5-6h", [3.000, 2.894, 2.675, 2.600]);
    outside("M3x0.5-4g6g", [2.980, 2.874, 2.655, 2.607]);
    outside("M4-4g6g", [3.978, 3.838, 3.523, 3.467]);
    outside("M5-6g", [4.976, 4.826, 4.456, 4.361]);
    outside("M6x1-6g", [5.974, 5.794, 5.324, 5.212]);
    outside("M8x1.25-6g", [7.972, 7.760, 7.160, 7.042]);
    outside("M8x1-4g6g", [7.974, 7.794, 7.324, 7.253]);
    outside("M10x1.5-6g", [9.968, 9.732, 8.994, 8.862]);
    outside("M10x0.75-6g", [9.978, 9.838, 9.491, 9.391]);
    outside("M20x2.5-6g", [19.958, 19.623, 18.334, 18.164]);
    has("M10x1.5-6g", AnswerUnit::Millimetre, &[("d3min", 7.938)]);
    has("M8x1-4g6g", AnswerUnit::Millimetre, &[("d3min", 6.637)]);
}

/// ISO 965-2, inside threads of 6H; and 6G, that lies higher by the deviation of table 1.
#[test]
fn metric_inside() {
    let inside = |name: &str, [least, most, pitch_least, pitch_most]: [f64; 4]| {
        let limits =
            [("D1min", least), ("D1max", most), ("D2min", pitch_least), ("D2max", pitch_most)];
        has(name, AnswerUnit::Millimetre, &limits);
    };
    inside("M3-6H", [2.459, 2.599, 2.675, 2.775]);
    inside("M6x1-6H", [4.917, 5.153, 5.350, 5.500]);
    inside("M8-6H", [6.647, 6.912, 7.188, 7.348]);
    inside("M10x1.5-6H", [8.376, 8.676, 9.026, 9.206]);
    inside("M20x2.5-6H", [17.294, 17.744, 18.376, 18.600]);
    inside("M10x1.5-6G", [8.408, 8.708, 9.058, 9.238]);
    // Grade 5 of 1.5: 140 µm for the pitch diameter, 236 µm for the minor.
    inside("M10x1.5-5H", [8.376, 8.612, 9.026, 9.166]);
}

#[test]
fn metric_limits_that_the_standard_lacks() {
    let refused = |name: &str, texts: &[&str]| {
        let read = ThreadDesignation::read(name).unwrap();
        let error = named_thread(&read, 1, read.units).unwrap_err();
        for text in texts {
            assert!(error.message.contains(text), "{name}: {error}");
        }
    };
    refused("M12x1.1-6g", &["pitch of 1.1 mm"]);
    refused("M6x0.5-6H", &["0.5 mm", "6 mm"]);
    refused("M3-8g", &["grade 8", "0.5 mm"]);
    refused("M2-6e", &["position e", "0.4 mm"]);
}
