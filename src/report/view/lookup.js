// The lookup, step by step as in tracer/envmap/lookup.rs and cube_map.rs, from the same table. Directions are [x, y, z].
"use strict";

/** The face that a direction meets: its largest component; on a tie x wins over y, y over z. */
function faceTowards([x, y, z]) {
  const [alongX, alongY, alongZ] = [x, y, z].map(Math.abs);
  if (alongX >= alongY && alongX >= alongZ) return x > 0 ? 0 : 1;
  if (alongY >= alongZ) return y > 0 ? 2 : 3;
  return z > 0 ? 4 : 5;
}

/** A signed axis, "+x" or "-z", as a vector. */
function axisVector(axis) {
  const vector = [0, 0, 0];
  vector["xyz".indexOf(axis[1])] = axis[0] === "-" ? -1 : 1;
  return vector;
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The component of a direction along a signed axis. */
const along = (direction, axis) => dot(direction, axisVector(axis));

/** Which face a direction meets, and where: u and v from 0 to 1. */
function locate(table, direction) {
  const face = faceTowards(direction);
  const row = table.rows[face];
  const largest = Math.abs(direction[face >> 1]);
  const u = (along(direction, row.u) / largest + 1) / 2;
  const v = (along(direction, row.v) / largest + 1) / 2;
  return { face, largest, u, v };
}

/** Where that is in which picture: from its left and top border, 0 to 1. */
function imagePoint(table, point) {
  const down = table.v_origin === "top" ? point.v : 1 - point.v;
  return { image: table.rows[point.face].image, right: point.u, down };
}

/** A display code, 0 to 255, as light, 0 to 1. */
function decode(code) {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** Light as a display code. */
function encode(light) {
  const value = light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.min(1, Math.max(0, value)));
}

/** The display code that a direction sees: bilinear in light, clamped at the border of the picture. */
function sample(images, table, direction) {
  const place = imagePoint(table, locate(table, direction));
  const { width, height, data } = images[place.image];
  const [x, y] = [place.right * width - 0.5, place.down * height - 0.5];
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const [acrossX, acrossY] = [x - left, y - top];
  const clamp = (index, count) => Math.min(count - 1, Math.max(0, index));
  const texel = (column, row) => 4 * (clamp(row, height) * width + clamp(column, width));
  return [0, 1, 2].map((channel) => {
    const light = (column, row) => decode(data[texel(column, row) + channel]);
    const upper = light(left, top) * (1 - acrossX) + light(left + 1, top) * acrossX;
    const lower = light(left, top + 1) * (1 - acrossX) + light(left + 1, top + 1) * acrossX;
    return encode(upper * (1 - acrossY) + lower * acrossY);
  });
}
