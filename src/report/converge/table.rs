//! The measurements of `skycube converge`, as a table for spreadsheets.

use super::report::{ConvergeReport, ConvergedScene};
use crate::converge::{Curve, Step};

/// The names of the columns.
const HEADER: &str = "\
    scene,label,integrator,depth,strategy,caustics,sampler,pixel_filter,environment_filter,samples,seconds,rays,\
    rmse,relative_mse,trimmed_relative_mse,flip,bias_squared,bias_squared_error,mean_radiance,efficiency,\
    slope_against_samples,slope_against_seconds,reference,reference_samples,reference_rmse\n";

/// One line per step, under a line of names (RFC 4180, but for the ends of lines). Unknown values are empty.
pub fn converge_csv(report: &ConvergeReport) -> String {
    let mut text = HEADER.to_owned();
    for scene in &report.scenes {
        for curve in &scene.convergence.curves {
            for step in &curve.steps {
                let fields: Vec<String> = fields(scene, curve, step).iter().map(|field| quoted(field)).collect();
                text += &(fields.join(",") + "\n");
            }
        }
    }
    text
}

fn fields(scene: &ConvergedScene, curve: &Curve, step: &Step) -> Vec<String> {
    let reference = &scene.convergence.references[curve.reference];
    let slope = |slope: Option<f64>| slope.map_or_else(String::new, |slope| slope.to_string());
    let mut fields = vec![scene.name.clone(), curve.label.clone()];
    fields.extend(curve.configuration.named().map(|(_, value)| value));
    fields.extend([step.samples.to_string(), step.seconds.to_string(), step.rays.to_string()]);
    let errors = step.errors;
    let figures = [
        errors.rmse,
        errors.relative_mse,
        errors.trimmed_relative_mse,
        errors.flip,
        step.bias.squared,
        step.bias.squared_error,
        step.mean_radiance,
        step.efficiency(),
    ];
    fields.extend(figures.map(|figure| figure.to_string()));
    fields.extend([slope(curve.fit.against_samples), slope(curve.fit.against_seconds)]);
    fields.extend([reference.key.clone(), reference.samples.to_string(), reference.errors.rmse.to_string()]);
    debug_assert_eq!(fields.len(), HEADER.split(',').count());
    fields
}

fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
