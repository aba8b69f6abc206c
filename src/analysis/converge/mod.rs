//! Convergence: error against samples and run time.
//!
//! ```text
//!   scene x variants              for every variant, at 1, 4, 16, ... samples:
//!        |                          several renderings of different seeds
//!        v                                    |
//!   reference, of other seeds ------->  errors, bias  ------->  slope of log error against log samples, log time
//!   (two halves: its own error)
//! ```
//!
//! Data only. Times vary from run to run; everything else is the same on any machine and any number of threads.

mod bias;
mod cache;
mod configuration;
mod curve;
mod errors;
mod experiment;
mod fit;
mod protocol;
mod reference;
mod schedule;
mod variation;
mod watch;

pub use bias::Bias;
pub use configuration::Configuration;
pub use curve::{Curve, Fit, Step};
pub use errors::Errors;
pub use experiment::{Convergence, converge};
pub use fit::slope;
pub use protocol::Protocol;
pub use reference::ReferenceFacts;
pub use schedule::Schedule;
pub use variation::{Comparison, Variant, Variation, variants};
pub use watch::{Unwatched, Watch, Work};
