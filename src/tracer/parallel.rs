//! Parallel work on all cores, in pieces large enough to hide the cost of scheduling.
//!
//! The loop over the pieces is compiled once for the whole program. A parallel iterator of rayon is compiled for every
//! closure, a few thousand lines each: only loops with many small pieces use one.

use std::sync::Mutex;

use rayon::prelude::*;

/// What `value` makes of every item, in the order of the items.
pub fn map<Item: Send, Value: Send>(
    items: impl IntoIterator<Item = Item>,
    value: impl Fn(Item) -> Value + Sync,
) -> Vec<Value> {
    let items: Vec<_> = items.into_iter().map(|item| Mutex::new(Some(item))).collect();
    let values: Vec<_> = items.iter().map(|_| Mutex::new(None)).collect();
    for_each_number(items.len(), &|number| {
        if let Some(item) = taken(&items[number]) {
            let made = value(item);
            *values[number].lock().expect(UNSHARED) = Some(made);
        }
    });
    values.iter().filter_map(taken).collect()
}

/// Calls `work` with every item, in any order.
pub fn for_each<Item: Send>(items: impl IntoIterator<Item = Item>, work: impl Fn(Item) + Sync) {
    map(items, work);
}

/// No place is ever locked while a piece of work runs, which alone could panic.
const UNSHARED: &str = "nobody panics with the lock";

fn taken<T>(place: &Mutex<Option<T>>) -> Option<T> {
    place.lock().expect(UNSHARED).take()
}

/// Calls `work` with every number below `count`, in any order.
fn for_each_number(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_in_the_order_of_the_items() {
        assert_eq!(map(0..1000, |number| 2 * number), (0..1000).map(|number| 2 * number).collect::<Vec<_>>());
        assert_eq!(map(["a", "bc"], str::len), [1, 2]);
        assert!(map([0; 0], |number: i32| number).is_empty());
    }

    #[test]
    fn chunks_are_written_in_place() {
        let mut values = [0; 10];
        for_each(values.chunks_mut(4).enumerate(), |(chunk, values)| values.fill(chunk + 1));
        assert_eq!(values, [1, 1, 1, 1, 2, 2, 2, 2, 3, 3]);
    }
}
