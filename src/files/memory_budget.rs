//! The memory budget of a command.
//!
//! Requests are counted before allocation, from the header of a file: a file of some hundred bytes may claim gigabytes.
//! The system reports the memory in use; claims of other threads are remembered.

use std::fmt::Display;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::{Error, Result};

/// The budget of the command in bytes; 0 until it is first needed.
static BUDGET: AtomicU64 = AtomicU64::new(0);

/// Bytes that were promised and are about to be taken.
static PROMISED: AtomicU64 = AtomicU64::new(0);

/// Where the system does not say how much is free.
const UNKNOWN: u64 = 8 << 30;

/// Sets the budget, in bytes.
pub fn set_memory_budget(bytes: u64) {
    BUDGET.store(bytes.max(1), Ordering::Relaxed);
}

/// A promise of memory, until what it is for was taken.
#[derive(Debug)]
pub struct Claim(u64);

impl Drop for Claim {
    fn drop(&mut self) {
        PROMISED.fetch_sub(self.0, Ordering::Relaxed);
    }
}

/// Promises bytes for `what`; an error if they are not left.
pub fn claim_memory(bytes: u64, what: impl Display) -> Result<Claim> {
    let others = PROMISED.fetch_add(bytes, Ordering::Relaxed);
    let claim = Claim(bytes);
    let budget = budget();
    let left = budget.saturating_sub(others).saturating_sub(taken());
    if bytes <= left {
        return Ok(claim);
    }
    let size = |bytes: u64| match bytes as f64 / f64::from(1 << 20) {
        megabytes if megabytes >= 1024.0 => format!("{:.1} GiB", megabytes / 1024.0),
        megabytes => format!("{megabytes:.0} MiB"),
    };
    Err(Error::new(format!("{what} would take {} of memory", size(bytes)))
        .expected(format!("at most {}, what is left of {}", size(left), size(budget)))
        .help("make it smaller, or allow more with --memory"))
}

/// An error if bytes for `what` are not left.
pub fn check_memory(bytes: u64, what: impl Display) -> Result<()> {
    claim_memory(bytes, what).map(drop)
}

/// The budget: what the user allows, or three quarters of what is free when the first asks.
fn budget() -> u64 {
    match BUDGET.load(Ordering::Relaxed) {
        0 => {
            let budget = taken() + free().unwrap_or(UNKNOWN) / 4 * 3;
            BUDGET.store(budget, Ordering::Relaxed);
            budget
        }
        budget => budget,
    }
}

/// Bytes of memory that this process holds; 0 where the system does not say it.
fn taken() -> u64 {
    field("/proc/self/status", "VmRSS:").unwrap_or(0)
}

/// Bytes that are free, within the limits of the process and its group.
fn free() -> Option<u64> {
    let number = |file: &str| std::fs::read_to_string(file).ok()?.trim().parse::<u64>().ok();
    let group = || Some(number("/sys/fs/cgroup/memory.max")?.saturating_sub(number("/sys/fs/cgroup/memory.current")?));
    let space = || {
        let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
        let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
        let limit: u64 = line.split_ascii_whitespace().next()?.parse().ok()?;
        Some(limit.saturating_sub(field("/proc/self/status", "VmSize:")?))
    };
    [field("/proc/meminfo", "MemAvailable:"), group(), space()].into_iter().flatten().min()
}

/// A line `name 1234 kB` of a file, in bytes.
fn field(file: &str, name: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_ascii_whitespace().next()?.parse::<u64>().ok().map(|kilobytes| kilobytes << 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_promised_is_not_promised_twice() {
        set_memory_budget(taken() + (1 << 40));
        let half = claim_memory(6 << 37, "half").unwrap();
        let error = claim_memory(6 << 37, "the other half").unwrap_err();
        assert!(error.problem().starts_with("the other half would take 768.0 GiB"), "{error}");
        drop(half);
        assert!(claim_memory(6 << 37, "the other half").is_ok());
        assert_eq!(PROMISED.load(Ordering::Relaxed), 0);
    }
}
