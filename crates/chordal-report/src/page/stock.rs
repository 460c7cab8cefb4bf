//! What is left of the stock.

use chordal_export::numbers::duration;
use chordal_export::stock_volume;
use maud::{Markup, PreEscaped, html};

use super::{NumberDisplay, left_out, scrolling, tool_name, upper_first};
use crate::data::{Document, ReportedStock, VolumeBounds};

/// The picture of what is left, the volumes and the verdict; nothing without a stock.
pub fn stock(document: &Document, show: &NumberDisplay) -> Markup {
    let Some(stock) = &document.stock else { return html! {} };
    html! {
        section aria-labelledby="stock" {
            h2 #stock { "Stock" }
            div.pictures {
                @if let Some(picture) = &document.pictures.stock {
                    // A half section is drawn with its dimensions.
                    figure.wide[stock.resolution_mm.is_none()] {
                        (PreEscaped(&picture.svg))
                        figcaption { "What is left, " (picture.caption) }
                    }
                }
                div {
                    p { strong { (upper_first(stock.sentence)) "." } }
                    (volumes(stock, show))
                    (left_out(&stock.parts, stock.parts.rows.len(), "parts that were cut off"))
                    (left_out(&stock.tools, stock.tools.rows.len(), "tools"))
                }
            }
        }
    }
}

fn volumes(stock: &ReportedStock, show: &NumberDisplay) -> Markup {
    let volume = |of: VolumeBounds| stock_volume([of.least, of.most], show.is_inch());
    html! {
        (scrolling("Volumes", stock.tools.rows.len() + 3, html! { table {
            thead {
                tr {
                    th scope="col" { "" }
                    th.n scope="col" { "Volume" }
                    th.n scope="col" {
                        @if stock.resolution_mm.is_some() { "Lowest tip" } @else { "Lowest Z" }
                    }
                    th.n scope="col" { "Time" }
                }
            }
            tbody {
                tr { th scope="row" { "Left" } td.n { (volume(stock.left_mm3)) } td {} td {} }
                @for part in &stock.parts.rows {
                    tr {
                        th scope="row" { "of it cut off in line " (part.line) }
                        td.n { (volume(VolumeBounds { least: part.volume_mm3, most: part.volume_mm3 })) }
                        td {} td {}
                    }
                }
                tr { th scope="row" { "Removed" } td.n { (volume(stock.removed_mm3)) } td {} td {} }
                @for tool in &stock.tools.rows {
                    tr {
                        th scope="row" { "by " (tool_name(tool.number)) }
                        td.n { (volume(tool.removed_mm3)) }
                        td.n {
                            @if let Some(z) = tool.lowest_mm {
                                (show.units.coordinate(z)) " " (show.units.length_unit())
                            }
                        }
                        td.n { @if let Some(time) = tool.time_s { (duration(time)) } }
                    }
                }
            }
        } }))
        p.faint {
            @match stock.resolution_mm {
                Some(side) => {
                    "Volumes are between these bounds, with columns of "
                    (show.units.coordinate(side)) " " (show.units.length_unit()) "."
                }
                None => "The half section is exact; a thread counts as between nothing and its whole groove.",
            }
        }
    }
}
