//! A scene: the complete input of a rendering, read from TOML.

mod aggregate;
mod boxed_shapes;
mod camera;
mod environment;
mod light;
mod load;
mod material;
mod mesh_materials;
mod plan;
mod settings;
mod shape;
mod stop_switch;

pub use aggregate::Aggregate;
pub use environment::read_lookup_file;
pub use load::Scene;
pub use plan::{Plan, Wing};
pub use settings::{Caustics, HierarchyChoice, IntegratorKind, IntegratorSettings, Mistake, OutputSettings, Strategy};
pub use stop_switch::{StopSwitch, finished, give_up};
