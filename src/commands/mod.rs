//! The commands: arguments in, results on stdout, errors on stderr, an exit code out.

mod bake;
mod check;
mod compare;
mod compare_folders;
mod config;
mod converge;
mod convert;
mod cross;
mod encoding_options;
mod engine_option;
mod fix;
mod grade;
mod help;
mod interrupt;
mod lessons;
mod library;
mod map_options;
mod options;
mod own_output;
mod probe;
mod progress_bar;
mod render;
mod report_options;
mod schema;
mod shell;
mod shots;
#[cfg(feature = "stress")]
mod stress;
mod terminal;
mod threads;
mod trace;
mod view;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use skycube_tracer::error::printable;
use skycube_tracer::memory::set_memory_budget;
use skycube_tracer::take_notes;

use crate::error::{Error, Result};
use crate::report::{Examined, ReportFormat, failure_json, listed};
pub use terminal::Outcome;
use terminal::{choose_colours, has_printed, lost_output, print, remark};

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
    /// When to colour reports; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value = "auto")]
    color: clap::ColorChoice,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Render a scene to a picture
    Render(render::RenderArguments),
    /// Render the surroundings of a point as the six faces of a map
    Bake(bake::BakeArguments),
    /// Check whether the six pictures of a skybox fit together
    Check(check::CheckArguments),
    /// Compare a picture with the expected one, and name the mistake
    Compare(compare::CompareArguments),
    /// Measure the error against samples and time, for several settings
    Converge(converge::ConvergeArguments),
    /// Write a map in another layout, size, format or lookup
    Convert(convert::ConvertArguments),
    /// Draw the map unfolded under the lookup, with its seams
    Cross(cross::CrossArguments),
    /// Find the fault in your own cube-map code from six of your renders
    Grade(grade::GradeArguments),
    /// List the lessons, show one, or copy one into a new folder
    Lessons(lessons::LessonsArguments),
    /// Follow the lookup of one direction step by step
    Probe(probe::ProbeArguments),
    /// Print the JSON Schema of a command's report
    Schema(schema::SchemaArguments),
    /// Render six pictures of a map along the axes, and a contact sheet
    Shots(shots::ShotsArguments),
    #[cfg(feature = "stress")]
    /// Measure the accuracy of the numerical kernels on extreme inputs
    Stress(stress::StressArguments),
    /// Follow one pixel of a scene: every ray, hit and lookup
    Trace(trace::TraceArguments),
    /// Write a page to look around in the map, repaired or not
    View(view::ViewArguments),
    /// Write six corrected files, or print the corrected lookup
    Fix(fix::FixArguments),
    /// Print the completions of a shell: what the Tab key knows
    Completions(shell::CompletionsArguments),
    /// Write a manual page for each command
    Man(shell::ManArguments),
}

/// Runs the command line of this process.
pub fn run() -> ExitCode {
    let matches = help::with_examples(CommandLine::command()).get_matches();
    let arguments = CommandLine::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    choose_colours(arguments.color);
    interrupt::handle(progress_bar::clear);
    if let Some(bytes) = arguments.memory {
        set_memory_budget(bytes);
    }
    let form = arguments.command.form();
    let result = catch_unwind(AssertUnwindSafe(|| threads::on_all(|| command(arguments.command))));
    for note in take_notes() {
        remark(format_args!("note: {}\n", printable(&note)));
    }
    let result = result.unwrap_or_else(|_| Err(Error::new("this is a bug in skycube, not your mistake").help(REPORT)));
    if let (Err(error), Some((command, format))) = (&result, form) {
        print_failure(command, format, error);
    }
    exit_code(result)
}

const REPORT: &str = "please report the message above together with the files";

impl Command {
    /// Its name and the form of its report, if that can be for other programs.
    fn form(&self) -> Option<(&'static str, ReportFormat)> {
        let json = |json: bool| if json { ReportFormat::Json } else { ReportFormat::Text };
        Some(match self {
            Self::Check(arguments) => ("check", arguments.report.format()),
            Self::Compare(arguments) => ("compare", arguments.report.format()),
            Self::Converge(arguments) => ("converge", json(arguments.json)),
            Self::Grade(arguments) => ("grade", arguments.report.format()),
            Self::Probe(arguments) => ("probe", json(arguments.json)),
            Self::Render(arguments) => ("render", json(arguments.json)),
            #[cfg(feature = "stress")]
            Self::Stress(arguments) => ("stress", json(arguments.json)),
            Self::Trace(arguments) => ("trace", json(arguments.json)),
            _ => return None,
        })
    }
}

/// What a program reads if a command could not run, unless the report itself says it.
fn print_failure(command: &str, format: ReportFormat, error: &Error) {
    if has_printed() {
        return;
    }
    match format {
        ReportFormat::Text => {}
        ReportFormat::Json => print(format_args!("{}\n", failure_json(command, error))),
        format => print(listed(format, command, &[Examined::failed(command.to_owned(), error)])),
    }
}

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
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Shots(arguments) => shots::run(&arguments),
        #[cfg(feature = "stress")]
        Command::Stress(arguments) => stress::run(&arguments),
        Command::Trace(arguments) => trace::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
        Command::Fix(arguments) => fix::run(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments, help::with_examples(CommandLine::command())),
        Command::Man(arguments) => shell::man(&arguments, help::with_examples(CommandLine::command())),
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
