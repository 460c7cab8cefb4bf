use super::edge::edge_of_circle;
use super::letters::InsertLetter;
use super::{HolderDesignation, InsertDesignation};

fn near(value: f64, expected: f64) -> bool {
    (value - expected).abs() < 0.006
}

/// Corner, edge and nose of designations, as catalogues list them.
#[test]
fn inserts_of_catalogues() {
    let cases = [
        ("CNMG120408", Some(80.0), Some(12.896), 0.8),
        ("cnmg 12 04 08", Some(80.0), Some(12.896), 0.8),
        ("CNMG120408-PM 4325", Some(80.0), Some(12.896), 0.8),
        ("DNMG 150604", Some(55.0), Some(15.504), 0.4),
        ("DCMT11T304", Some(55.0), Some(11.628), 0.4),
        ("VBMT160404", Some(35.0), Some(16.606), 0.4),
        ("VCGT110302FN", Some(35.0), Some(11.071), 0.2),
        ("TNMG160408", Some(60.0), Some(16.498), 0.8),
        ("TCMT110204", Some(60.0), Some(10.999), 0.4),
        ("WNMG080408", Some(80.0), Some(8.687), 0.8),
        ("WNMG060404", Some(80.0), Some(6.515), 0.4),
        ("SNMG120412", Some(90.0), Some(12.7), 1.2),
        ("CCMT060204", Some(80.0), Some(6.448), 0.4),
        ("CNMG432", Some(80.0), Some(12.896), 0.794),
        ("CCMT 32.51", Some(80.0), Some(9.672), 0.397),
        ("CCMT21.50.5", Some(80.0), Some(6.448), 0.198),
        ("DNMG442", Some(55.0), Some(15.504), 0.794),
        ("VNMG331", Some(35.0), Some(16.606), 0.397),
        // The size of a parallelogram says nothing of an inscribed circle.
        ("KNUX160405R11", Some(55.0), None, 0.5),
        ("RCMT1204M0", None, Some(12.0), 6.0),
        ("RNMG120400", None, Some(12.7), 6.35),
    ];
    for (text, corner, edge, nose) in cases {
        let read = InsertDesignation::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(read.letter.corner_degrees(), corner, "{text}");
        match (read.edge_mm, edge) {
            (Some(read), Some(edge)) => assert!(near(read, edge), "{text}: {read}"),
            (read, edge) => assert_eq!(read, edge, "{text}"),
        }
        assert!(near(read.nose_mm, nose), "{text}: {}", read.nose_mm);
    }
}

#[test]
fn what_is_no_insert_says_why() {
    let cases = [
        ("XNMG120408", "`X` is no shape of an insert", "X"),
        ("CXMG120408", "`X` is no clearance of an insert", "X"),
        ("CNZG120408", "`Z` is no tolerance class of an insert", "Z"),
        ("CNMZ120408", "`Z` is no kind of hole and chip breaker", "Z"),
        ("CN", "the letter of its tolerance class is missing", ""),
        ("CNMG", "it has no size", ""),
        ("CNMG129908", "`99` is no thickness of an insert", "99"),
        ("CNMG120409", "`09` is no nose radius of an insert", "09"),
        ("CNMG12040", "`12040` is no size of an insert", "12040"),
        ("CNMG1204080", "it has more digits", "0"),
        ("16ER AG60", "this is a threading insert, whose designations are not read", "16ER"),
        ("16 IR 1.50 ISO", "this is a threading insert", "16 IR"),
        // A grooving insert, whose letters mean something else.
        ("MGMN300", "`300` is no size of an insert", "300"),
        ("", "the letter of its shape is missing", ""),
    ];
    for (text, message, part) in cases {
        let error = InsertDesignation::parse(text).expect_err(text);
        assert!(error.message.starts_with(message), "{text}: {error}");
        if !part.is_empty() {
            assert_eq!(&text[error.part.clone()], part, "{text}");
        }
    }
}

/// Angle to Z, edge and usual tip.
#[test]
fn holders_of_catalogues() {
    let cases = [
        ("PCLNR2525M12", Some(95.0), Some(12.896), Some(3)),
        ("PCLNR 2525 M 12", Some(95.0), Some(12.896), Some(3)),
        // A left-hand holder is as usual towards the chuck as away from it.
        ("PCLNL2525M12", Some(95.0), Some(12.896), None),
        ("MDJNL 2020K15", Some(93.0), Some(15.504), None),
        ("SVJBR", Some(93.0), None, Some(3)),
        ("SVVBN2525M16", Some(72.5), Some(16.606), Some(8)),
        ("SDNCN1616H11", Some(63.0), Some(11.628), Some(8)),
        ("MTGNR2525M16", Some(90.0), Some(16.498), Some(3)),
        ("PDQNR2525M15", Some(107.5), Some(15.504), Some(3)),
        ("MVQNR2525M16", None, Some(16.606), Some(3)),
        ("PSSNR2525M12", Some(45.0), Some(12.7), Some(3)),
        ("MWLNR2525M08", Some(95.0), Some(8.687), Some(3)),
        ("MCLNR-164D", Some(95.0), Some(12.896), Some(3)),
        ("MCLNR 16-4D", Some(95.0), Some(12.896), Some(3)),
        // A main edge at the end that is square to the feed along X: 100° of the other edge of a rhombus of 80°.
        ("PCFNR2525M12", Some(100.0), Some(12.896), Some(3)),
        // Beyond square the other edge does not lead: nothing is said.
        ("PSKNR2525M12", None, Some(12.7), Some(3)),
        ("S20R-SCLCR09", Some(95.0), Some(9.672), Some(2)),
        ("A25T-PDUNL11", Some(93.0), Some(11.628), Some(2)),
        ("S16Q SDUCR 07", Some(93.0), Some(7.752), Some(2)),
        ("S32U-PCLNR12", Some(95.0), Some(12.896), Some(2)),
    ];
    for (text, approach, edge, tip) in cases {
        let read = HolderDesignation::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(read.approach_degrees(), approach, "{text}");
        match (read.edge_mm, edge) {
            (Some(read), Some(edge)) => assert!(near(read, edge), "{text}: {read}"),
            (read, edge) => assert_eq!(read, edge, "{text}"),
        }
        assert_eq!(read.usual_tip(), tip, "{text}");
    }
}

#[test]
fn what_is_no_holder_says_why() {
    let cases = [
        ("QCLNR2525M12", "`Q` is no clamping of a holder"),
        ("PXLNR2525M12", "`X` is no shape of an insert"),
        ("PCINR2525M12", "`I` is no style of a holder"),
        ("PCLXR2525M12", "`X` is no clearance of an insert"),
        ("PCLNX2525M12", "`X` is no hand"),
        ("PCLN", "the letter of its hand is missing"),
        ("PCLNR25251M12", "`25251` is no height and width of a shank"),
        ("PCLNR2525M120", "`120` is no size of an insert"),
        ("S2R-SCLCR09", "`2` is no diameter of a boring bar"),
        ("S20-SCLCR09", "the letter of the bar's length is missing"),
        ("CNMG120408", "`N` is no shape of an insert"),
    ];
    for (text, message) in cases {
        let error = HolderDesignation::parse(text).expect_err(text);
        assert!(error.message.starts_with(message), "{text}: {error}");
    }
}

/// The symbols of size of the tables of ISO 1832, by inscribed circle: 6.35, 9.525, 12.7, 15.875, 19.05, 25.4 mm.
#[test]
fn edges_begin_with_their_symbols() {
    let circles = [6.35, 9.525, 12.7, 15.875, 19.05, 25.4];
    let rows = [
        (InsertLetter::C, [6, 9, 12, 16, 19, 25]),
        (InsertLetter::D, [7, 11, 15, 19, 23, 31]),
        (InsertLetter::S, [6, 9, 12, 15, 19, 25]),
        (InsertLetter::T, [11, 16, 22, 27, 33, 44]),
        (InsertLetter::V, [11, 16, 22, 27, 33, 44]),
        (InsertLetter::W, [4, 6, 8, 10, 13, 17]),
    ];
    for (letter, symbols) in rows {
        for (circle, symbol) in circles.into_iter().zip(symbols) {
            let edge = edge_of_circle(letter, circle).expect("an edge");
            assert_eq!((edge + 0.01).floor(), f64::from(symbol), "{letter:?} {circle}: {edge}");
        }
    }
}

proptest::proptest! {
    #[test]
    fn no_text_ends_the_reading(text in "\\PC*", letters in "[A-Z]{0,6}[0-9]{0,6}.*") {
        for text in [text, letters] {
            let read = InsertDesignation::parse(&text);
            let part = read.err().map(|error| error.part);
            let holder_part = HolderDesignation::parse(&text).err().map(|error| error.part);
            for part in part.into_iter().chain(holder_part) {
                assert!(text.get(part).is_some(), "{text}");
            }
        }
    }
}
