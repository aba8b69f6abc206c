//! Whether the world is seen mirrored: answered from the table alone, seams never show it.

use crate::envmap::{Face, Lookup};

/// The faces that show their pictures mirrored to an observer in a right-handed world.
pub fn mirrored_faces(lookup: &Lookup) -> Vec<Face> {
    Face::ALL.into_iter().filter(|&face| lookup.mirrors(face)).collect()
}
