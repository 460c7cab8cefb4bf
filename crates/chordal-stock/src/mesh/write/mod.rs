//! Writes meshes as binary STL, glTF (GLB) and 3MF.

mod glb;
mod stl;
mod threemf;
mod zip;

pub use glb::write_glb;
pub use stl::write_stl;
pub use threemf::write_threemf;

/// Why a mesh cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WriteError {
    /// A size does not fit the format.
    #[error("{what} would be {size}; the form holds {most} at most")]
    TooLarge {
        /// What is counted.
        what: &'static str,
        /// The count, or the size in bytes.
        size: u64,
        /// The most that the format allows.
        most: u64,
    },
    /// The number of colours is not that of the vertices.
    #[error("{colours} colours for {vertices} vertices")]
    Colours {
        /// How many colours were given.
        colours: usize,
        /// How many vertices there are.
        vertices: usize,
    },
}

/// A count as 32 bits.
fn count(what: &'static str, size: usize) -> Result<u32, WriteError> {
    u32::try_from(size).map_err(|_| WriteError::TooLarge {
        what,
        size: size as u64,
        most: u64::from(u32::MAX),
    })
}
