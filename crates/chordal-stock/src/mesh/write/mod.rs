//! Meshes as the bytes of files: binary STL, glTF (GLB) and 3MF.

mod glb;
mod stl;
mod threemf;
mod zip;

pub use glb::write_glb;
pub use stl::write_stl;
pub use threemf::write_threemf;

/// Why a mesh does not fit a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WriteError {
    /// The form counts in 32 bits.
    #[error("{what} would be {size}; the form holds {most} at most")]
    TooLarge {
        /// What is counted.
        what: &'static str,
        /// How many, or bytes.
        size: u64,
        /// The most.
        most: u64,
    },
    /// Colours that are not one for each vertex.
    #[error("{colours} colours for {vertices} vertices")]
    Colours {
        /// How many colours were given.
        colours: usize,
        /// How many vertices there are.
        vertices: usize,
    },
}

/// A count of a form of 32 bits.
fn count(what: &'static str, size: usize) -> Result<u32, WriteError> {
    u32::try_from(size).map_err(|_| WriteError::TooLarge {
        what,
        size: size as u64,
        most: u64::from(u32::MAX),
    })
}
