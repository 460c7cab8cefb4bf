//! Fixed formats of CAM systems: records, lists of numbers, lines with keys.

use std::ops::RangeInclusive;

use chordal_machine::ToolShape;

use super::CommentedTool;

/// A mill is a ball mill where its diameter is twice its corner radius within this share: post processors write two
/// decimals.
const BALL_SHARE: f64 = 0.01;

/// The tool in a comment of a fixed format; its number is 0 where the comment does not give it.
pub(super) fn read_form(text: &str, inch: bool) -> Option<CommentedTool> {
    let upper = text.to_ascii_uppercase();
    let upper = upper.trim();
    record(upper, inch)
        .or_else(|| cut_viewer(upper, inch))
        .or_else(|| kiri(upper, inch))
        .or_else(|| predator(upper, inch))
        .or_else(|| pycam(upper, inch))
        .or_else(|| cam_bam(upper, inch))
}

/// The fields of `@FC|TOOL|number=1|…`; `None` for any other text.
pub(super) fn fields<'t>(text: &'t str, kind: &str) -> Option<Vec<(&'t str, &'t str)>> {
    let rest = text.trim_start_matches([';', ' ']).strip_prefix('@')?;
    let mut parts = rest.split('|');
    if !matches!(parts.next()?, "F360" | "FC" | "MKR") || parts.next()?.trim() != kind {
        return None;
    }
    Some(parts.filter_map(|part| part.split_once('=')).collect())
}

/// The value of a field; `None` without it.
pub(super) fn field<'t>(fields: &[(&'t str, &'t str)], key: &str) -> Option<&'t str> {
    fields.iter().find(|(own, _)| own.trim() == key).map(|(_, value)| value.trim())
}

/// The number in a text that holds nothing else.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let plain = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
    // No size has more digits; `inf`, `nan` and exponents are not allowed.
    if text.is_empty() || text.len() > 16 || !text.chars().all(plain) {
        return None;
    }
    text.parse().ok()
}

fn scale(inch: bool) -> f64 {
    if inch { 25.4 } else { 1.0 }
}

fn tool_number(text: &str) -> Option<u32> {
    const NUMBERS: RangeInclusive<u32> = 1..=999;
    text.trim().parse().ok().filter(|number| NUMBERS.contains(number))
}

/// `@F360|TOOL|…`, `@FC|TOOL|…`, `@MKR|TOOL|…`: Fusion, FreeCAD and Makera Studio for machines of Makera.
fn record(text: &str, inch: bool) -> Option<CommentedTool> {
    let fields = fields(text, "TOOL")?;
    let length = |key: &str| Some(number(field(&fields, key)?)? * scale(inch));
    let degrees = |key: &str| number(field(&fields, key)?).filter(|degrees| *degrees > 0.0);
    let kind = field(&fields, "TYPE").unwrap_or_default();
    let shape = record_shape(kind);
    let angle = match shape {
        Some(ToolShape::Drill) => degrees("TIPANGLE"),
        Some(ToolShape::Chamfer) => degrees("CUTTINGEDGEANGLE"),
        _ => None,
    };
    // Makera Studio writes half the angle.
    let half = || degrees("HALFANGLE").map(|half| 2.0 * half);
    let pointed = matches!(shape, Some(ToolShape::Drill | ToolShape::Chamfer));
    Some(CommentedTool {
        diameter_mm: length("DIAMETER").filter(|mm| *mm > 0.0),
        corner_radius_mm: length("CORNERRADIUS"),
        point_angle_rad: angle.or_else(half).filter(|_| pointed).map(f64::to_radians),
        tip_diameter_mm: length("TIPDIAMETER").filter(|_| shape == Some(ToolShape::Chamfer)),
        pitch_mm: length("PITCH").filter(|mm| *mm > 0.0),
        shape,
        ..CommentedTool::of(tool_number(field(&fields, "NUMBER")?)?)
    })
}

fn record_shape(kind: &str) -> Option<ToolShape> {
    let kind: String = kind.chars().filter(char::is_ascii_alphabetic).collect();
    Some(match kind.as_str() {
        "ENDMILL" | "FLATEND" | "FLATENDMILL" => ToolShape::Flat,
        "BALLEND" | "BALLENDMILL" | "BALLNOSE" => ToolShape::Ball,
        "BULLNOSE" | "BULLNOSEENDMILL" => ToolShape::Bull,
        "DRILL" | "SPOTDRILL" => ToolShape::Drill,
        "VBIT" | "CHAMFER" | "CHAMFERMILL" => ToolShape::Chamfer,
        "TAP" => ToolShape::Tap,
        _ => return None,
    })
}

/// Numbers separated by commas; `None` where one is not a number.
pub(super) fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(number).collect()
}

/// `TOOL/MILL,d,corner,height,taper`, `TOOL/DRILL,d,angle,h`: CutViewer, which CamBam, MeshCAM and others write.
fn cut_viewer(text: &str, inch: bool) -> Option<CommentedTool> {
    let (kind, rest) = text.strip_prefix("TOOL/")?.split_once(',')?;
    let values = numbers(rest)?;
    let mm = |at: usize| values.get(at).map(|value| value * scale(inch));
    let angle = |at: usize| {
        let degrees = values.get(at).filter(|degrees| (10.0..=180.0).contains(*degrees));
        degrees.copied().map(f64::to_radians)
    };
    let loose = CommentedTool::of(0);
    let diameter_mm = mm(0).filter(|mm| *mm > 0.0)?;
    Some(match kind.trim() {
        // For a tapered mill the diameter is that of its end, and there is no such shape.
        "MILL" if values.get(3).is_some_and(|taper| *taper != 0.0) => return None,
        "MILL" => {
            let corner = mm(1)?;
            let shape = match corner {
                corner if corner <= 0.0 => ToolShape::Flat,
                corner if (2.0 * corner / diameter_mm - 1.0).abs() < BALL_SHARE => ToolShape::Ball,
                corner if 2.0 * corner < diameter_mm => ToolShape::Bull,
                _ => return None,
            };
            CommentedTool {
                diameter_mm: Some(diameter_mm),
                corner_radius_mm: Some(corner),
                shape: Some(shape),
                ..loose
            }
        }
        "DRILL" | "CHAMFER" => CommentedTool {
            diameter_mm: Some(diameter_mm),
            point_angle_rad: angle(1),
            shape: Some(if kind.trim() == "DRILL" { ToolShape::Drill } else { ToolShape::Chamfer }),
            ..loose
        },
        // The values are the pilot, its angle and length, then the diameter of the body.
        "CDRILL" => CommentedTool {
            diameter_mm: Some(mm(3).filter(|mm| *mm > 0.0)?),
            shape: Some(ToolShape::Drill),
            ..loose
        },
        _ => return None,
    })
}

/// `tool#=3 flute=3.175 len=12.7 unit=metric`: Kiri:Moto.
fn kiri(text: &str, inch: bool) -> Option<CommentedTool> {
    let rest = text.strip_prefix("TOOL#=")?;
    let mut words = rest.split_ascii_whitespace();
    let tool = tool_number(words.next()?)?;
    let fields: Vec<(&str, &str)> = words.filter_map(|word| word.split_once('=')).collect();
    let inch = match field(&fields, "UNIT") {
        Some("METRIC") => false,
        Some("IMPERIAL") => true,
        _ => inch,
    };
    let diameter = number(field(&fields, "FLUTE")?)?;
    Some(CommentedTool {
        diameter_mm: Some(diameter * scale(inch)).filter(|mm| *mm > 0.0),
        ..CommentedTool::of(tool)
    })
}

/// `MTOOL T2 D12 H80`: Predator, BobCAD.
fn predator(text: &str, inch: bool) -> Option<CommentedTool> {
    let words: Vec<&str> = text.strip_prefix("MTOOL ")?.split_ascii_whitespace().collect();
    let of = |letter: char| words.iter().find_map(|word| word.strip_prefix(letter));
    let diameter = number(of('D')?)? * scale(inch);
    Some(CommentedTool {
        diameter_mm: Some(diameter).filter(|mm| *mm > 0.0),
        ..CommentedTool::of(tool_number(of('T')?)?)
    })
}

/// `tool_radius = 1.5`, one line for each value: PyCAM.
fn pycam(text: &str, inch: bool) -> Option<CommentedTool> {
    let (key, value) = text.split_once('=')?;
    let loose = CommentedTool::of(0);
    let mm = || number(value).map(|value| value * scale(inch)).filter(|mm| *mm > 0.0);
    Some(match key.trim() {
        "TOOL_RADIUS" => CommentedTool { diameter_mm: Some(2.0 * mm()?), ..loose },
        "TORUS_RADIUS" => CommentedTool { corner_radius_mm: Some(mm()?), ..loose },
        "SHAPE" => {
            let shape = match value.trim() {
                "CYLINDRICALCUTTER" => ToolShape::Flat,
                "SPHERICALCUTTER" => ToolShape::Ball,
                "TOROIDALCUTTER" => ToolShape::Bull,
                _ => return None,
            };
            CommentedTool { shape: Some(shape), ..loose }
        }
        _ => return None,
    })
}

/// `T2 : 6.35`: CamBam.
fn cam_bam(text: &str, inch: bool) -> Option<CommentedTool> {
    let (tool, value) = text.strip_prefix('T')?.split_once(':')?;
    let diameter = number(value).filter(|_| value.contains('.'))? * scale(inch);
    Some(CommentedTool {
        diameter_mm: Some(diameter).filter(|mm| *mm > 0.0),
        ..CommentedTool::of(tool_number(tool)?)
    })
}
