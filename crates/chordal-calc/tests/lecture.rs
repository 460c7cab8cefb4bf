//! The numbers of the Patras lecture (chapter 10, after Seams) and of the manuals.

use std::f64::consts::FRAC_PI_4;

use chordal_calc::{
    AnswerUnit, CornerSide, LineArc, LineAxis, PlaneAxis, TangentTransition, ThreadDesignation,
    ThreadSize, TravelSide, TwoLines, WorkedCalculation, corner_of_lines, corner_with_axis,
    line_with_arc, tangent_point, thread_data,
};

const INCH: f64 = 25.4;
const CR: f64 = 0.25 * INCH;

/// The step of this symbol has this value, to half of the last digit printed, and this text.
#[track_caller]
fn gives(
    worked: &WorkedCalculation,
    symbol: &str,
    inches: f64,
    digits: i32,
    formula: &str,
    filled: &str,
) {
    let step = worked.step(symbol).unwrap_or_else(|| panic!("no {symbol} in {worked:?}"));
    let value = step.quantity.value / INCH;
    assert!((value - inches).abs() <= 0.5 * 10f64.powi(-digits), "{symbol} = {value}");
    assert_eq!(step.formula, formula);
    assert_eq!(step.filled, filled);
}

fn axis(angle: f64, axis: PlaneAxis, rise: Option<f64>) -> WorkedCalculation {
    let ask = LineAxis {
        cutter_radius: CR,
        angle: angle.to_radians(),
        axis,
        bend: CornerSide::Outside,
        rise: rise.map(|rise| rise * INCH),
    };
    corner_with_axis(&ask, AnswerUnit::Inch).unwrap()
}

#[test]
fn a_line_with_an_axis() {
    gives(&axis(60.0, PlaneAxis::Y, None), "ΔY", 0.144, 3, "CR·tan(θ/2)", "0.25·tan(60°/2)");
    let slope = axis(30.0, PlaneAxis::X, Some(1.0));
    gives(&slope, "ΔX", 0.067, 3, "CR·tan(θ/2)", "0.25·tan(30°/2)");
    gives(&slope, "b", 1.732, 3, "h/tan(θ)", "1/tan(30°)");
    gives(&slope, "X", 1.665, 3, "b − ΔX", "1.73205 − 0.06699");
    gives(&axis(75.0, PlaneAxis::Y, None), "ΔY", 0.1918, 4, "CR·tan(θ/2)", "0.25·tan(75°/2)");
    gives(&axis(45.0, PlaneAxis::X, None), "ΔX", 0.1036, 4, "CR·tan(θ/2)", "0.25·tan(45°/2)");
    gives(&axis(45.0, PlaneAxis::X, None), "ΔY", 0.25, 4, "CR", "0.25");
}

#[test]
fn two_lines() {
    let ask = TwoLines {
        cutter_radius: CR,
        a: 45f64.to_radians(),
        b: 15f64.to_radians(),
        side: TravelSide::Left,
    };
    let worked = corner_of_lines(&ask, AnswerUnit::Inch).unwrap();
    let (a, b) =
        ("0.25·sin((45°+15°)/2)/cos((45°−15°)/2)", "0.25·cos((45°+15°)/2)/cos((45°−15°)/2)");
    gives(&worked, "ΔX", 0.1294, 4, "CR·sin((a+b)/2)/cos((a−b)/2)", a);
    gives(&worked, "ΔY", 0.2241, 4, "CR·cos((a+b)/2)/cos((a−b)/2)", b);
}

/// The lecture puts 1.125 into the formula for a radius of 1.25, and rounds √1.3125 = 1.14564 to
/// 1.1454. Its result 0.17715 is that of 1.25 with the rounded Δi.
#[test]
fn a_line_with_an_arc_of_one_and_a_quarter() {
    let ask = LineArc {
        cutter_radius: CR,
        radius: 1.25 * INCH,
        height: 0.5 * INCH,
        inside: true,
        toward: true,
        corner: Some(1.1454 * INCH),
    };
    let formula = "Δi − √((R − CR)² − (Δj − CR)²)";
    let printed = line_with_arc(&ask, AnswerUnit::Inch).unwrap();
    let filled = "1.1454 − √((1.25 − 0.25)² − (0.5 − 0.25)²)";
    gives(&printed, "ΔX", 0.17715, 5, formula, filled);

    let exact = line_with_arc(&LineArc { corner: None, ..ask }, AnswerUnit::Inch).unwrap();
    gives(&exact, "Δi", 1.14564, 5, "√(R² − Δj²)", "√(1.25² − 0.5²)");
    let filled = "1.14564 − √((1.25 − 0.25)² − (0.5 − 0.25)²)";
    gives(&exact, "ΔX", 0.17740, 5, formula, filled);

    let misprint = LineArc { radius: 1.125 * INCH, ..ask };
    let value = line_with_arc(&misprint, AnswerUnit::Inch).unwrap().value("ΔX").unwrap() / INCH;
    assert!((value - 0.30687).abs() < 5e-6, "{value}");
}

#[test]
fn a_tangent_point() {
    let ask = TangentTransition { cutter_radius: CR, angle: FRAC_PI_4, side: TravelSide::Left };
    let worked = tangent_point(&ask, AnswerUnit::Inch).unwrap();
    gives(&worked, "ΔX", 0.1768, 4, "CR·sin(θ)", "0.25·sin(45°)");
    gives(&worked, "ΔX", 0.17678, 5, "CR·sin(θ)", "0.25·sin(45°)");
    gives(&worked, "ΔY", 0.17678, 5, "CR·cos(θ)", "0.25·cos(45°)");
}

/// Fadal manual, section 13: 1 1/16 - 28 has a lead of .0357, a minor diameter of 1.0187 outside
/// (3A) and of 1.0240 at least inside (2B). ISO 724 for M30x2: D2 28.701, D1 27.835.
#[test]
fn threads() {
    let data = |name: &str, starts| {
        let ThreadDesignation { major, pitch, units, .. } = ThreadDesignation::read(name).unwrap();
        thread_data(&ThreadSize { major, pitch, starts }, units).unwrap()
    };
    let fadal = data("1 1/16-28", 1);
    gives(&fadal, "L", 0.0357, 4, "n·P", "1·0.03571");
    gives(&fadal, "d3", 1.0187, 4, "D − 1.226869·P", "1.0625 − 1.226869·0.03571");
    let inside = fadal.value("D1").unwrap() / INCH;
    assert!((inside - 1.0240).abs() < 2e-4, "{inside}");

    let iso = data("M30x2", 1);
    let near = |symbol: &str, mm: f64| {
        let value = iso.value(symbol).unwrap();
        assert!((value - mm).abs() < 6e-4, "{symbol} = {value}");
    };
    near("D2", 28.701);
    near("D1", 27.835);
    near("d3", 27.546);
    assert!((data("M30x2", 3).value("L").unwrap() - 6.0).abs() < 1e-12);
}
