// Tells what the page did, as lines in an element that `--dump-dom` prints.
(async () => {
  await ready;
  const lines = [];
  const state_of = (direction, colour) => lines.push([...direction, ...colour].join(" "));
  // Directions on a spiral around the sphere.
  for (const table of ["before", "after"]) {
    for (let at = 0; at < 1000; at++) {
      const height = 1 - (2 * at + 1) / 1000, angle = at * 2.399963;
      const direction = [Math.cos(angle) * Math.sqrt(1 - height * height), height, Math.sin(angle) * Math.sqrt(1 - height * height)].map(Math.fround);
      state_of(direction, sample(images, map.tables[table], direction));
    }
  }
  // What is on the canvas against the same lookup in the script, in both tables and a few views.
  let worst = 0;
  for (const [table, yaw, pitch] of [["before", 10, 5], ["after", 100, -30], ["after", 200, 80], ["before", 280, -60]]) {
    Object.assign(state, { table, yaw, pitch });
    draw();
    const canvas = element("cube"), gl = canvas.getContext("webgl2");
    if (!gl) continue;
    const view = camera(), pixel = new Uint8Array(4);
    for (let at = 0; at < 200; at++) {
      const [x, y] = [(at * 37) % canvas.width, (at * 53) % canvas.height];
      gl.readPixels(x, canvas.height - 1 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      const place = [((x + 0.5) / canvas.width) * view.width, ((y + 0.5) / canvas.height) * view.height];
      const wanted = sample(images, map.tables[table], directionAt(view, ...place));
      worst = Math.max(worst, ...wanted.map((value, channel) => Math.abs(value - pixel[channel])));
    }
    lines.push(`canvas ${worst}`);
  }
  const broken = map.seams.findIndex((seam) => seam.verdict === "broken");
  document.querySelectorAll("#marks .hit")[broken].dispatchEvent(new MouseEvent("click", { bubbles: true }));
  lines.push(`found ${element("found").textContent}`);
  document.querySelector("[value=after]").click();
  lines.push(`table ${state.table}`);
  element("cube").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  lines.push(`probe ${element("probe").textContent.split("\n")[1]}`);
  lines.push(`faults ${faults.join("; ")}`);
  const pre = Object.assign(document.createElement("pre"), { id: "report", textContent: lines.join("\n") });
  document.body.replaceChildren(pre);
})();
