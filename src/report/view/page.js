// The page of `skycube view`: draws the cube from its centre, with the seams over it.
const map = JSON.parse(document.getElementById("map").textContent);
const FACES = ["posx", "negx", "posy", "negy", "posz", "negz"];
const SHORT = ["+x", "-x", "+y", "-y", "+z", "-z"];
const element = (id) => document.getElementById(id);
const plus = (a, b, factor) => a.map((value, axis) => value + factor * b[axis]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const normal = (face) => axisVector(SHORT[face]);
/** The two faces of an edge such as "+x-z". */
const sides = (edge) => [edge.slice(0, 2), edge.slice(2)].map((name) => SHORT.indexOf(name));

const state = { table: "before", yaw: 0, pitch: 0, field: 90, chosen: null };
const up = axisVector(map.world_up);
const [ahead, aside] = (() => {
  const first = axisVector(map.world_up[1] === "z" ? "+x" : "-z");
  return [first, cross(first, up)];
})();

/** Forward, right and up of the camera, with the lengths of half a picture. */
function camera() {
  const [yaw, pitch] = [state.yaw, state.pitch].map((degrees) => (degrees * Math.PI) / 180);
  const level = plus(ahead.map((value) => value * Math.cos(yaw)), aside, Math.sin(yaw));
  const forward = plus(level.map((value) => value * Math.cos(pitch)), up, Math.sin(pitch));
  const upwards = plus(up.map((value) => value * Math.cos(pitch)), level, -Math.sin(pitch));
  const right = cross(forward, upwards).map((value) => (element("mirror").checked ? -value : value));
  const { clientWidth: width, clientHeight: height } = element("view");
  const half = Math.tan((state.field * Math.PI) / 360);
  const scale = Math.max(width, height);
  return { forward, right, upwards, half: [(half * width) / scale, (half * height) / scale], width, height };
}

/** The direction through a place of the view, from its top left corner in CSS pixels. */
function directionAt(view, x, y) {
  const across = (2 * x) / view.width - 1;
  const down = (2 * y) / view.height - 1;
  return plus(plus(view.forward, view.right, across * view.half[0]), view.upwards, -down * view.half[1]);
}

/** Where a point is seen, in CSS pixels; null behind the camera. */
function project(view, point) {
  const depth = dot(point, view.forward);
  if (depth < 0.02) return null;
  const x = dot(point, view.right) / depth / view.half[0];
  const y = dot(point, view.upwards) / depth / view.half[1];
  return [((x + 1) / 2) * view.width, ((1 - y) / 2) * view.height];
}

function look(direction) {
  const length = Math.sqrt(dot(direction, direction));
  const height = dot(direction, up) / length;
  state.pitch = Math.max(-89, Math.min(89, (Math.asin(height) * 180) / Math.PI));
  const level = [dot(direction, ahead), dot(direction, aside)];
  if (Math.hypot(...level) > 1e-6) state.yaw = (Math.atan2(level[1], level[0]) * 180) / Math.PI;
}

// The picture: by WebGL 2, or point by point where there is none.

const VERTICES = `#version 300 es
in vec2 place; out vec2 at;
void main() { at = place; gl_Position = vec4(place, 0.0, 1.0); }`;
/** The lookup once more, for the graphics card: see lookup.js. */
const FRAGMENTS = `#version 300 es
precision highp float; precision highp int; precision highp sampler2DArray;
uniform sampler2DArray images; uniform ivec2 sizes[6];
uniform int image[6]; uniform vec3 u_axis[6]; uniform vec3 v_axis[6]; uniform bool from_top;
uniform vec3 forward, right, upwards; uniform vec2 half_size;
in vec2 at; out vec4 colour;
int face_towards(vec3 d) {
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0 : 1;
  if (a.y >= a.z) return d.y > 0.0 ? 2 : 3;
  return d.z > 0.0 ? 4 : 5;
}
vec3 light(ivec2 place, int layer) {
  place = clamp(place, ivec2(0), sizes[layer] - 1);
  vec3 code = texelFetch(images, ivec3(place, layer), 0).rgb;
  return mix(code / 12.92, pow((code + 0.055) / 1.055, vec3(2.4)), greaterThan(code, vec3(0.04045)));
}
void main() {
  vec3 d = forward + at.x * half_size.x * right + at.y * half_size.y * upwards;
  int face = face_towards(d);
  float largest = max(max(abs(d.x), abs(d.y)), abs(d.z));
  vec2 uv = (vec2(dot(d, u_axis[face]), dot(d, v_axis[face])) / largest + 1.0) / 2.0;
  if (!from_top) uv.y = 1.0 - uv.y;
  int layer = image[face];
  vec2 texel = uv * vec2(sizes[layer]) - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 part = texel - floor(texel);
  vec3 upper = mix(light(corner, layer), light(corner + ivec2(1, 0), layer), part.x);
  vec3 lower = mix(light(corner + ivec2(0, 1), layer), light(corner + ivec2(1, 1), layer), part.x);
  vec3 linear = mix(upper, lower, part.y);
  vec3 code = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
  colour = vec4(code, 1.0);
}`;

function webglPainter(canvas, images) {
  const gl = canvas.getContext("webgl2", { preserveDrawingBuffer: true });
  if (!gl) return null;
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, VERTICES], [gl.FRAGMENT_SHADER, FRAGMENTS]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return null;
  gl.useProgram(program);
  const uniform = (name) => gl.getUniformLocation(program, name);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
  const place = gl.getAttribLocation(program, "place");
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, 2, gl.FLOAT, false, 0, 0);
  const width = Math.max(...images.map((image) => image.width));
  const height = Math.max(...images.map((image) => image.height));
  if (Math.max(width, height) > gl.getParameter(gl.MAX_TEXTURE_SIZE)) return null;
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, gl.createTexture());
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA8, width, height, 6);
  gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  images.forEach((image, layer) => {
    const size = [image.width, image.height, 1];
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, layer, ...size, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(image.data.buffer));
  });
  gl.uniform2iv(uniform("sizes"), images.flatMap((image) => [image.width, image.height]));
  return (view, table) => {
    const scale = window.devicePixelRatio || 1;
    [canvas.width, canvas.height] = [Math.round(view.width * scale), Math.round(view.height * scale)];
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.uniform1iv(uniform("image"), table.rows.map((row) => row.image));
    gl.uniform3fv(uniform("u_axis"), table.rows.flatMap((row) => axisVector(row.u)));
    gl.uniform3fv(uniform("v_axis"), table.rows.flatMap((row) => axisVector(row.v)));
    gl.uniform1i(uniform("from_top"), table.v_origin === "top" ? 1 : 0);
    for (const name of ["forward", "right", "upwards"]) gl.uniform3fv(uniform(name), view[name]);
    gl.uniform2fv(uniform("half_size"), view.half);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
}

/** The same without a graphics card, at a ninth of the pixels. */
function plainPainter(canvas, images) {
  const context = canvas.getContext("2d");
  return (view, table) => {
    const [width, height] = [Math.ceil(view.width / 3), Math.ceil(view.height / 3)];
    [canvas.width, canvas.height] = [width, height];
    const picture = context.createImageData(width, height);
    for (let at = 0; at < width * height; at++) {
      const x = (((at % width) + 0.5) / width) * view.width;
      const y = ((Math.floor(at / width) + 0.5) / height) * view.height;
      picture.data.set([...sample(images, table, directionAt(view, x, y)), 255], 4 * at);
    }
    context.putImageData(picture, 0, 0);
  };
}

// Seams, names and arrows over the picture.

const svg = (name, attributes, text) => {
  const node = document.createElementNS(element("marks").namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text) node.textContent = text;
  return node;
};

/** A line through points, broken where it passes behind the camera. */
function path(view, points) {
  let pen = "M";
  return points.map((point) => {
    const seen = project(view, point);
    const step = seen ? `${pen}${seen[0].toFixed(1)} ${seen[1].toFixed(1)}` : "";
    pen = seen ? "L" : "M";
    return step;
  }).join("");
}

const seams = () => (state.table === "after" ? map.seams_after : map.seams);
const marks = map.seams.map((seam, index) => {
  const group = svg("g", {});
  const label = () => `Seam ${seam.edge}, ${seams()[index].verdict}`;
  const hit = svg("path", { class: "hit", tabindex: 0, role: "button" });
  const line = svg("path", {});
  group.append(line, hit);
  element("marks").append(group);
  const choose = () => { state.chosen = { seam: index }; update(); };
  hit.addEventListener("click", choose);
  hit.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); choose(); } });
  hit.addEventListener("focus", () => { if (hit.matches(":focus-visible")) { look(middle(seam.edge)); draw(); } });
  return { group, hit, line, label };
});
const labels = svg("g", {});
element("marks").append(labels);

const middle = (edge) => { const [one, other] = sides(edge); return plus(normal(one), normal(other), 1); };

function drawMarks(view) {
  marks.forEach(({ group, hit, line, label }, index) => {
    const seam = seams()[index];
    const [one, other] = sides(seam.edge);
    const direction = cross(normal(one), normal(other));
    const points = Array.from({ length: 33 }, (_, step) => plus(middle(seam.edge), direction, step / 16 - 1));
    const shape = path(view, points);
    group.style.display = element("seams").checked ? "" : "none";
    group.setAttribute("class", state.chosen?.seam === index ? "chosen" : "");
    hit.setAttribute("d", shape);
    hit.setAttribute("aria-label", label());
    line.setAttribute("d", shape);
    line.setAttribute("class", `seam ${seam.verdict}`);
  });
  labels.replaceChildren();
  if (!element("names").checked) return;
  map.tables[state.table].rows.forEach((row, face) => {
    const centre = normal(face);
    const write = (point, text) => {
      const seen = project(view, point);
      if (seen) labels.append(svg("text", { x: seen[0], y: seen[1] + 5 }, text));
    };
    write(plus(centre, up, Math.abs(dot(centre, up)) ? 0 : 0.15), `${FACES[face]}: ${map.files[row.image]}`);
    for (const [name, axis] of [["u", axisVector(row.u)], ["v", axisVector(row.v)]]) {
      labels.append(svg("path", { class: "arrow", d: path(view, [centre, plus(centre, axis, 0.4)]) }));
      write(plus(centre, axis, 0.47), name);
    }
  });
}

// What is said.

const hex = (code) => `#${code.map((value) => value.toString(16).padStart(2, "0")).join("")}`;

/** The lookup of a direction in words, as `skycube probe` does it. */
function explain(direction) {
  const table = map.tables[state.table];
  const point = locate(table, direction);
  const row = table.rows[point.face];
  const place = imagePoint(table, point);
  const { width, height } = images[place.image];
  const name = "xyz"[point.face >> 1];
  const formula = (axis) => `(${axis[0] === "-" ? "-" : ""}d.${axis[1]} / ${point.largest.toFixed(4)} + 1) / 2`;
  const column = Math.min(width - 1, Math.floor(place.right * width));
  const line = Math.min(height - 1, Math.floor(place.down * height));
  return [
    `d = (${direction.map((value) => value.toFixed(4).replace(/^-(0\.0+)$/, "$1")).join(", ")})`,
    `|d.${name}| = ${point.largest.toFixed(4)} is the largest: face ${FACES[point.face]}`,
    `u = ${formula(row.u)} = ${point.u.toFixed(4)}`,
    `v = ${formula(row.v)} = ${point.v.toFixed(4)}`,
    `v = 0 is the ${table.v_origin} row of the picture`,
    `${map.files[place.image]}: column ${column} of ${width}, row ${line} of ${height}`,
    `colour ${hex(sample(images, table, direction))}`,
  ].join("\n");
}

function tell() {
  const lines = [];
  const { seam, face } = state.chosen ?? {};
  if (seam !== undefined) {
    const [now, then] = [map.seams[seam], map.seams_after[seam]];
    const told = ({ verdict, step, score }) => `${verdict}, mean step ${step} of 255, score ${score}`;
    lines.push(`Seam ${now.edge}: ${told(now)}.`);
    if (map.changes) lines.push(`Repaired: ${told(then)}.`);
    for (const side of sides(now.edge)) lines.push(map.faces[side]);
  } else if (face !== undefined) lines.push(map.faces[face]);
  element("found").replaceChildren(...lines.map((text) => Object.assign(document.createElement("p"), { textContent: text })));
  if (!lines.length) element("found").textContent = "Select a seam or a face in the picture.";
}

let paint = () => {};
let images = [];
function draw() {
  const view = camera();
  paint(view, map.tables[state.table]);
  drawMarks(view);
}
function update() { draw(); tell(); }

function listen() {
  const view = element("view");
  const place = (event) => {
    const box = view.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const zoom = (factor) => { state.field = Math.max(20, Math.min(140, state.field * factor)); draw(); };
  const turn = (right, upwards) => {
    state.yaw += element("mirror").checked ? -right : right;
    state.pitch = Math.max(-89, Math.min(89, state.pitch + upwards));
    draw();
  };
  // One pointer turns, two zoom.
  const pointers = new Map();
  let moved = 0;
  view.addEventListener("pointerdown", (event) => {
    if (pointers.size === 0) moved = 0;
    pointers.set(event.pointerId, place(event));
  });
  view.addEventListener("pointermove", (event) => {
    const now = place(event);
    const before = pointers.get(event.pointerId);
    element("probe").textContent = explain(directionAt(camera(), ...now));
    if (!before) return;
    if (moved > 4) view.setPointerCapture(event.pointerId);
    const apart = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
    const wide = pointers.size === 2 ? apart() : 0;
    pointers.set(event.pointerId, now);
    moved += Math.abs(now[0] - before[0]) + Math.abs(now[1] - before[1]);
    if (pointers.size === 2) zoom(wide / Math.max(1, apart()));
    else turn(((before[0] - now[0]) * state.field) / view.clientWidth, ((now[1] - before[1]) * state.field) / view.clientWidth);
  });
  for (const kind of ["pointerup", "pointercancel"]) view.addEventListener(kind, (event) => pointers.delete(event.pointerId));
  element("cube").addEventListener("click", (event) => {
    if (moved > 4) return;
    state.chosen = { face: faceTowards(directionAt(camera(), ...place(event))) };
    update();
  });
  view.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(event.deltaY / 1000)); }, { passive: false });
  element("cube").addEventListener("keydown", (event) => {
    const keys = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
    if (keys[event.key]) turn(...keys[event.key]);
    else if (event.key === "+" || event.key === "=") zoom(0.9);
    else if (event.key === "-") zoom(1.1);
    else if (event.key === "Enter") { state.chosen = { face: faceTowards(camera().forward) }; update(); }
    else return;
    element("probe").textContent = explain(camera().forward);
    event.preventDefault();
  });
  for (const input of document.querySelectorAll("#controls input")) {
    input.addEventListener("change", () => {
      state.table = document.querySelector("[name=table]:checked").value;
      update();
    });
  }
  SHORT.forEach((name, face) => {
    const button = Object.assign(document.createElement("button"), { textContent: name, title: `Look along ${name}` });
    button.addEventListener("click", () => { look(normal(face)); state.chosen = { face }; update(); });
    element("axes").append(button);
  });
  window.addEventListener("resize", draw);
}

for (const button of document.querySelectorAll(".copy")) {
  button.hidden = false;
  button.addEventListener("click", async () => {
    const text = button.parentElement.querySelector("pre").textContent;
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      // A page opened from disk may not use the clipboard interface.
      const area = Object.assign(document.createElement("textarea"), { value: text });
      document.body.append(area);
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    button.textContent = "copied";
    setTimeout(() => { button.textContent = "copy"; }, 1500);
  });
}

async function texels(source) {
  const image = new Image();
  image.src = source;
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

const ready = (async () => {
  images = await Promise.all(map.images.map(texels));
  element("stage").hidden = false;
  element("mirror").checked = map.mirrored;
  element("tables").hidden = !map.changes;
  // Towards what is broken, or level where nothing is or all around.
  const broken = map.seams.filter((seam) => seam.verdict === "broken");
  const towards = broken.reduce((sum, seam) => plus(sum, middle(seam.edge), 1), [0, 0, 0]);
  if (dot(towards, towards) > 0) look(towards);
  paint = webglPainter(element("cube"), images);
  if (!paint) {
    // A canvas that was asked for WebGL gives no other context.
    const canvas = element("cube").cloneNode();
    element("cube").replaceWith(canvas);
    paint = plainPainter(canvas, images);
  }
  listen();
  element("probe").textContent = explain(camera().forward);
  update();
})();
