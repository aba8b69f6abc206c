//! The commands: arguments in, results on stdout, errors on stderr, an exit code out.

mod bake;
mod check;
mod compare;
mod converge;
mod convert;
mod cross;
mod encoding_options;
mod fix;
mod grade;
mod interrupt;
mod lessons;
mod map_options;
mod options;
mod own_output;
mod probe;
mod progress_bar;
mod render;
mod shots;
#[cfg(feature = "stress")]
mod stress;
mod terminal;
mod trace;
mod view;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use skycube_tracer::error::printable;
use skycube_tracer::memory::set_memory_budget;
use skycube_tracer::take_notes;

use crate::error::{Error, Result};
pub use terminal::Outcome;
use terminal::{lost_output, remark};

/// A small, complete ray tracer for teaching, and a validator that says how to repair a skybox.
#[derive(Debug, Parser)]
#[command(name = "skycube", version, about, long_about = None, arg_required_else_help = true)]
#[command(after_help = "Exit codes: 0 clean, 1 faults found, 2 could not run, 130 interrupted.")]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
    /// The memory limit, for instance 4G or 500M [default: three quarters of the free memory]
    #[arg(long, global = true, value_name = "BYTES", value_parser = options::parse_bytes)]
    memory: Option<u64>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a picture
    Render(render::RenderArguments),
    /// Render the surroundings of a point to the six faces of a cube map
    Bake(bake::BakeArguments),
    /// Check whether the six pictures of a skybox fit together
    Check(check::CheckArguments),
    /// Compare a picture with the expected one, and name what it does differently
    Compare(compare::CompareArguments),
    /// Measure error against samples and run time; compare integrators, strategies, samplers, ...
    Converge(converge::ConvergeArguments),
    /// Write a map in another layout, for another lookup, in another size or format
    Convert(convert::ConvertArguments),
    /// Draw the map unfolded under the lookup, with its seams
    Cross(cross::CrossArguments),
    /// Find the fault in your own cube-map code from six of your renders
    Grade(grade::GradeArguments),
    /// List the lessons, show one, or copy one into a new folder
    Lessons(lessons::LessonsArguments),
    /// Follow the lookup of one direction step by step
    Probe(probe::ProbeArguments),
    /// Render six pictures of a map along the axes, and a contact sheet
    Shots(shots::ShotsArguments),
    #[cfg(feature = "stress")]
    /// Measure the accuracy of the numerical kernels on extreme inputs
    Stress(stress::StressArguments),
    /// Follow one pixel of a scene: every ray, hit, shadow test and lookup, and how its colour adds up
    Trace(trace::TraceArguments),
    /// Write a page to look around in the map, before and after the repair
    View(view::ViewArguments),
    /// Write six corrected files, or print the corrected lookup
    Fix(fix::FixArguments),
}

/// Runs the command line of this process.
pub fn run() -> ExitCode {
    let arguments = CommandLine::parse();
    interrupt::handle();
    if let Some(bytes) = arguments.memory {
        set_memory_budget(bytes);
    }
    // Where the system starts no threads, the calling one does the work.
    if rayon::ThreadPoolBuilder::new().build_global().is_err() {
        let _ = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    }
    let result = catch_unwind(AssertUnwindSafe(|| command(arguments.command)));
    for note in take_notes() {
        remark(format_args!("note: {}\n", printable(&note)));
    }
    exit_code(result.unwrap_or_else(|_| Err(Error::new("this is a bug in skycube, not your mistake").help(REPORT))))
}

const REPORT: &str = "please report the message above together with the files";

fn command(command: Command) -> Result<Outcome> {
    match command {
        Command::Render(arguments) => render::run(&arguments),
        Command::Bake(arguments) => bake::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Converge(arguments) => converge::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Cross(arguments) => cross::run(&arguments),
        Command::Grade(arguments) => grade::run(&arguments),
        Command::Lessons(arguments) => lessons::run(&arguments),
        Command::Probe(arguments) => probe::run(&arguments),
        Command::Shots(arguments) => shots::run(&arguments),
        #[cfg(feature = "stress")]
        Command::Stress(arguments) => stress::run(&arguments),
        Command::Trace(arguments) => trace::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
        Command::Fix(arguments) => fix::run(&arguments),
    }
}

fn exit_code(result: Result<Outcome>) -> ExitCode {
    if let Some(error) = lost_output() {
        remark(format_args!("error: the report is lost: cannot write to standard output: {error}\n"));
        return ExitCode::from(2);
    }
    match result {
        Ok(Outcome::Clean) => ExitCode::SUCCESS,
        Ok(Outcome::Faults) => ExitCode::from(1),
        Ok(Outcome::Interrupted) => ExitCode::from(130),
        Err(error) => {
            remark(format_args!("error: {error}\n"));
            ExitCode::from(if interrupt::requested() { 130 } else { 2 })
        }
    }
}
