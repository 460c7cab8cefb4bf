//! Every cycle of HEIDENHAIN controls against formulas of the manuals that are written here again: the data of each
//! cycle take random values, and strokes, levels, feeds, limits in the plane and the end are compared. Nothing here
//! calls what makes the steps.

#[path = "heidenhain_cycles/holes.rs"]
mod holes;
#[path = "heidenhain_cycles/shapes.rs"]
mod shapes;
#[path = "heidenhain_cycles/shop.rs"]
mod shop;
#[path = "heidenhain_cycles/surfaces.rs"]
mod surfaces;
#[path = "heidenhain_cycles/threads.rs"]
mod threads;
