//! Pictures flipped and turned.

use crate::envmap::ImageOperation;
use crate::math::Vec3;
use crate::picture::Raster;

/// The eight orientations of a picture, the simplest first.
pub(super) const OPERATIONS: [ImageOperation; 8] = [
    ImageOperation::None,
    ImageOperation::FlipLeftRight,
    ImageOperation::FlipTopBottom,
    ImageOperation::Turn180,
    ImageOperation::TurnClockwise,
    ImageOperation::TurnCounterclockwise,
    ImageOperation::Transpose,
    ImageOperation::Transverse,
];

/// True if the operation exchanges width and height.
pub(super) fn exchanges_sides(operation: ImageOperation) -> bool {
    use ImageOperation::{Transpose, Transverse, TurnClockwise, TurnCounterclockwise};
    matches!(operation, TurnClockwise | TurnCounterclockwise | Transpose | Transverse)
}

/// The operation that undoes this one.
pub(super) fn inverse(operation: ImageOperation) -> ImageOperation {
    match operation {
        ImageOperation::TurnClockwise => ImageOperation::TurnCounterclockwise,
        ImageOperation::TurnCounterclockwise => ImageOperation::TurnClockwise,
        other => other,
    }
}

/// The picture after an operation.
pub(super) fn placed(raster: &Raster, operation: ImageOperation) -> Raster {
    let (width, height) = (raster.width(), raster.height());
    let (new_width, new_height) = if exchanges_sides(operation) { (height, width) } else { (width, height) };
    Raster::from_function(new_width, new_height, |x, y| pixel(raster, operation, x, y))
}

/// What the new picture shows in column `x` and row `y`.
fn pixel(raster: &Raster, operation: ImageOperation, x: usize, y: usize) -> Vec3 {
    let column = |index: usize| raster.width() - 1 - index;
    let row = |index: usize| raster.height() - 1 - index;
    match operation {
        ImageOperation::None => raster.pixel(x, y),
        ImageOperation::FlipLeftRight => raster.pixel(column(x), y),
        ImageOperation::FlipTopBottom => raster.pixel(x, row(y)),
        ImageOperation::Turn180 => raster.pixel(column(x), row(y)),
        ImageOperation::TurnClockwise => raster.pixel(y, row(x)),
        ImageOperation::TurnCounterclockwise => raster.pixel(column(y), x),
        ImageOperation::Transpose => raster.pixel(y, x),
        ImageOperation::Transverse => raster.pixel(column(y), row(x)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_operations_on_squares_and_is_undone_by_the_inverse() {
        let picture = |width, height| Raster::from_function(width, height, |x, y| Vec3::new(x as f32, y as f32, 0.0));
        for operation in OPERATIONS {
            let square = placed(&picture(5, 5), operation);
            for (x, y) in (0..5).flat_map(|x| (0..5).map(move |y| (x, y))) {
                let (column, row) = operation.source(x, y, 5);
                assert_eq!(square.pixel(x, y), Vec3::new(column as f32, row as f32, 0.0), "{operation:?}");
            }
            let oblong = picture(5, 3);
            assert_eq!(placed(&placed(&oblong, operation), inverse(operation)), oblong, "{operation:?}");
        }
    }
}
