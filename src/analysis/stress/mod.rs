//! The numerical kernels on extreme inputs: measures the range in which each stays accurate. Data only.
//!
//! Each case sweeps one magnitude over decades, takes the worst error of many inputs at each step against a reference
//! of higher precision or a closed form, and says in which range the error stays within its bound. The inputs and the
//! figures are the same on every machine.

mod case;
mod effort;
mod faces;
mod lights;
mod lobes;
mod lookup;
mod mesh_cases;
mod octasphere;
mod optics;
mod placed;
mod reference;
mod self_intersection;
mod shapes;
mod sums;
mod surfaces;
mod wide;
mod wide_vector;

pub use case::{Case, Group, Measurement, Subject, Verdict};
pub use effort::Effort;
pub use placed::{hit_error, placed, sphere_at};
pub use reference::ulp_f32;

pub use crate::random::Random;

/// All that can be swept, in the order of the report.
pub fn subjects() -> Vec<Subject> {
    [
        lookup::SUBJECTS,
        faces::SUBJECTS,
        shapes::SUBJECTS,
        mesh_cases::SUBJECTS,
        self_intersection::SUBJECTS,
        optics::SUBJECTS,
        surfaces::SUBJECTS,
        lobes::SUBJECTS,
        lights::SUBJECTS,
        sums::SUBJECTS,
    ]
    .concat()
}
