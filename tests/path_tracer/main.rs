//! The path tracer against closed forms and against itself: its strategies, its caustics, its samplers must agree.

mod agreement;
mod caustics;
mod light;
mod pictures;
mod support;
