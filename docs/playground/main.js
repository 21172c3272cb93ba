// The page: switches, input, and one frame after another.

const at = (id) => document.getElementById(id);
const settings = { scene: "plate", law: "hertz", ratio: 1, exponent: 0, load: 1, drive: false, about: 1, operator: false };
const scenes = { plate: new Plate(await Engine.make()), block: new Block(await Engine.make()) };
const kinds = { plate: Plate, block: Block };
const sheet = new Sheet(at("scene"));
const plane = new Plane(at("plane"));
const keys = new Set();
const frames = { count: 0, busy: 0 };
let scene = scenes.plate;
let clock = 0;

for (const law of Object.keys(TABLES)) at("law").add(new Option(law, law));

/** Reads the switches: the fingers' parameters change, their motion continues. */
function configure() {
  const coupled = at("coupled").checked;
  for (const id of ["curve", "projection"]) at(id).disabled = !coupled;
  settings.law = at("law").value;
  settings.curve = coupled ? at("curve").value : "box";
  settings.projection = coupled ? at("projection").value : "closest-point";
  settings.ratio = 10 ** Number(at("ratio").value);
  settings.exponent = settings.scene === "plate" ? Number(at("radius").value) : 0;
  const options = scene.configure(settings);
  at("ratio-value").textContent = `${(options.twistStiffness * 1e3).toPrecision(3)} N mm/rad, ${settings.ratio.toPrecision(2)} × kₗ(μᵣ/μₗ)²`;
  plane.take(scene.engine, !coupled);
  return options;
}

function readMotion() {
  settings.drive = at("drive").checked;
  settings.about = Number(at("about").value);
  settings.operator = at("operator").checked;
  at("about-value").textContent = settings.about > 2.99 ? "none: slides only" : `at ${settings.about.toFixed(2)} a`;
}

/** The slider shows the nearest of its steps; keys and time change the value by less. */
function setLoad(load) {
  settings.load = Math.max(0, Math.min(kinds[settings.scene].load.max, load));
  at("load").value = settings.load;
  at("load-value").textContent = `${settings.load.toFixed(settings.scene === "plate" ? 2 : 3)} N`;
}
Block.prototype.change = (by) => {
  at("operator").checked = settings.operator = false;
  setLoad(settings.load + by);
};

function restart() {
  at("drive").checked = at("operator").checked = false;
  readMotion();
  setLoad(kinds[settings.scene].load.start);
  configure();
  scene.restart(settings.load);
  plane.steps = [];
}

function show(name) {
  settings.scene = name;
  scene = scenes[name];
  const kind = kinds[name];
  document.querySelector(`input[name="scene"][value="${name}"]`).checked = true;
  for (const other of document.querySelectorAll(".plate-only")) other.hidden = name !== "plate";
  for (const other of document.querySelectorAll(".block-only")) other.hidden = name !== "block";
  at("how").innerHTML = kind.how;
  at("scene").style.touchAction = name === "plate" ? "none" : "pinch-zoom";  // two fingers turn the plate's finger
  at("scene").setAttribute("aria-label", kind.name);
  at("load-name").textContent = kind.load.name;
  at("grip-name").textContent = name === "plate" ? "Load P" : "Grip P";
  Object.assign(at("load"), { min: kind.load.min, max: kind.load.max, step: kind.load.step });
  restart();
}

/** The suggestions: switches by id, then the motion. */
const tries = {
  slide: { drive: true, about: 3 },
  spin: { drive: true, about: 0.45 },
  radial: { projection: "radial", drive: true, about: 1 },
  stiff: { projection: "radial", ratio: 1, drive: true, about: 1 },
  closest: { ratio: 1, drive: true, about: 1 },
  box: { coupled: false, drive: true, about: 1 },
  loosen: { curve: "ellipse", projection: "radial", release: true },
  operate: { curve: "ellipse", projection: "radial", operator: true },
  drop: { coupled: false, release: true },
  exactly: { release: true },
};

function suggest(name) {
  const wanted = { coupled: true, curve: "exact", projection: "closest-point", ratio: 0, drive: false, operator: false, ...tries[name] };
  restart();
  for (const id of ["coupled", "drive", "operator"]) at(id).checked = wanted[id];
  for (const id of ["curve", "projection", "ratio", "about"]) if (id in wanted) at(id).value = wanted[id];
  readMotion();
  configure();
  scene.restart(settings.load);
  releasing = Boolean(wanted.release);
  if (matchMedia("(max-width: 52rem)").matches) at("scene").scrollIntoView({ block: "center" });
}
let releasing = false;

// Pointers: one drags, two also turn.
const pointers = new Map();
const grasp = () => {
  const points = [...pointers.values()];
  const middle = points.reduce((sum, [px, py]) => [sum[0] + px / points.length, sum[1] + py / points.length], [0, 0]);
  const turn = points.length > 1 ? Math.atan2(points[1][1] - points[0][1], points[1][0] - points[0][0]) : 0;
  return { middle, turn };
};
function point(event) {
  const before = grasp();
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  const after = grasp();
  if (event.type !== "pointermove") return;
  const turn = -(after.turn - before.turn);
  at("drive").checked = false;
  readMotion();
  scene.drag(after.middle[0] - before.middle[0], after.middle[1] - before.middle[1], turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
}
at("scene").addEventListener("pointerdown", (event) => {
  at("scene").setPointerCapture(event.pointerId);
  at("scene").focus({ preventScroll: true });
  releasing = false;
  point(event);
});
at("scene").addEventListener("pointermove", (event) => pointers.has(event.pointerId) && point(event));
for (const end of ["pointerup", "pointercancel"]) at("scene").addEventListener(end, (event) => pointers.delete(event.pointerId));
at("scene").addEventListener("wheel", (event) => {
  if (event.ctrlKey) return;  // which zooms the page, as a pinch of a touchpad does
  event.preventDefault();
  releasing = false;
  scene.wheel(Math.max(-3, Math.min(3, event.deltaY / (event.deltaMode ? 3 : 100))));
}, { passive: false });

const keyOf = (event) => ({ "=": "+", "−": "-", _: "-" })[event.key] ?? event.key.toLowerCase();
const held = new Set(["arrowleft", "arrowright", "arrowup", "arrowdown", "q", "e", "+", "-"]);
at("scene").addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = keyOf(event);
  if (held.has(key)) {
    keys.add(key);
    releasing = false;
    if (key !== "+" && key !== "-") at("drive").checked = false;
    readMotion();
  } else if (key === " " && settings.scene === "plate") {
    setLoad(settings.load > 0 ? 0 : Plate.load.start);
  } else if (key === "r") {
    restart();
  } else {
    return;
  }
  event.preventDefault();
});
at("scene").addEventListener("keyup", (event) => keys.delete(keyOf(event)));
at("scene").addEventListener("blur", () => keys.clear());

for (const id of ["law", "curve", "projection", "radius", "coupled"]) at(id).addEventListener("change", configure);
at("ratio").addEventListener("input", configure);
at("load").addEventListener("input", () => { releasing = false; setLoad(Number(at("load").value)); });
for (const id of ["about", "drive", "operator"]) at(id).addEventListener("input", () => { releasing = false; readMotion(); });
at("operator").addEventListener("input", () => { scene.regrips = false; });
at("restart").addEventListener("click", () => { releasing = false; restart(); });
for (const radio of document.querySelectorAll('input[name="scene"]')) radio.addEventListener("change", () => show(radio.value));
for (const button of document.querySelectorAll("[data-try]")) button.addEventListener("click", () => suggest(button.dataset.try));

function write(id, words) {
  if (at(id).textContent !== words) at(id).textContent = words;
}

function report() {
  const f = scene.finger;
  if (!f) return;
  write("state", f.state);
  at("state").dataset.state = f.state;
  write("force", Math.hypot(f.fx, f.fy).toFixed(3));
  write("moment", (f.moment * 1e3).toFixed(2));
  write("cor", f.state !== "slip" ? "–" : f.cor < 10 ? (f.cor * 1e3).toFixed(1) : "∞");
  write("grip", f.load.toFixed(3));
  if (settings.scene === "plate") {
    const known = f.state === "slip" && scene.truth;
    write("error", known ? (scene.truth.error * 100).toFixed(1) : f.state === "stick" ? "no slip" : "–");
    at("error-unit").hidden = !known;
  }
  if (settings.scene === "block") {
    write("turned", ((scene.pose.angle * 180) / Math.PI).toFixed(1));
    write("slid", (scene.slid * 1e3).toFixed(1));
  }
}

/** Steps of a millisecond for the elapsed time, at most a twentieth of a second: what the page did not see did not pass. */
function advance(elapsed) {
  const count = Math.min(50, Math.round(elapsed * 1e3));
  const seconds = count * 1e-3;
  const pressed = (keys.has("+") ? 1 : 0) - (keys.has("-") ? 1 : 0);
  if (settings.scene === "plate" && pressed) setLoad(settings.load + pressed * seconds);
  if (releasing) {
    setLoad(settings.load - 0.1 * seconds);
    // Once the block turns or slides, the user takes over.
    if (scene.slid > 0.004 || scene.pose.angle > 0.6) releasing = false;
  }
  if (count > 0) scene.advance(count, settings, keys, (finger) => plane.add(finger, (clock += 1e-3)));
  if (settings.operator) setLoad(settings.load);
}

let before;
function frame(now) {
  const began = performance.now();
  const elapsed = before === undefined ? 0.016 : (now - before) / 1e3;
  before = now;
  advance(elapsed);
  scene.draw(sheet, settings);
  plane.draw(scene.finger ?? scene.engine.finger(), scene.axes, settings.scene === "plate" ? scene.truth : undefined, clock);
  report();
  frames.count += 1;
  frames.busy = performance.now() - began;
  requestAnimationFrame(frame);
}

show("plate");
/** For programs: the same numbers without the picture. `options()` are those of the switches. */
window.limitcurve = { replay: (rows, options = configure()) => replay(rows, options), pivot: (given, options = configure()) => pivot(given, options), options: configure, frames };
requestAnimationFrame(frame);
