// The library's finger and block in a WebAssembly memory of their own. The build script embeds WASM and TABLES.

const STATES = ["free", "stick", "slip", "invalid"];
const CURVES = ["exact", "ellipse", "box"];
const PROJECTIONS = ["radial", "c-curve", "closest-point"];

const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

const compiled = WebAssembly.compile(bytesOf(WASM));

class Engine {
  static async make() {
    return new Engine(await WebAssembly.instantiate(await compiled));
  }

  constructor(instance) {
    this.call = instance.exports;
    this.call.__wasm_call_ctors();
    this.law = undefined;
  }

  // A view at each use: memory that grows leaves a view behind.
  get out() {
    return new Float64Array(this.call.memory.buffer, this.call.results(), 21);
  }

  /** Makes the curves of a law: the table of 1e-9, and ellipse and box through its intercepts. */
  takeLaw(law) {
    const table = TABLES[law];
    if (!table) throw new RangeError(`law '${law}': expected ${Object.keys(TABLES).join("|")}`);
    if (law === this.law) return;
    this.law = law;
    const cells = new Float64Array(bytesOf(table.cells).buffer);
    new Float64Array(this.call.memory.buffer, this.call.cell_numbers(), cells.length).set(cells);
    this.call.use_table(table.inside, table.outside);
    this.momentRatio = this.wrench(0, 1, true).moment;
  }

  /** `radius` [m] at 1 N grows with the load to the power `exponent`. */
  configure({ law, curve, projection, mu, radius, exponent = 0, stiffness, twistStiffness, damping = 0, twistDamping = 0 }) {
    if (!CURVES.includes(curve)) throw new RangeError(`curve '${curve}': expected ${CURVES.join("|")}`);
    if (!PROJECTIONS.includes(projection)) throw new RangeError(`projection '${projection}': expected ${PROJECTIONS.join("|")}`);
    if (curve === "box" && projection !== "closest-point") throw new RangeError("projection: a box goes with closest-point only");
    this.takeLaw(law);
    this.curve = CURVES.indexOf(curve);
    this.call.set_finger(this.curve, mu, radius, exponent, stiffness, twistStiffness, damping, twistDamping, PROJECTIONS.indexOf(projection));
  }

  /** The unit wrench of a slip |v| : a|ω| on the curve in use, or on that of the law. */
  wrench(slide, spin, ofLaw = false) {
    this.call.unit_wrench(ofLaw ? 0 : this.curve, slide, spin);
    const [force, moment] = this.out;
    return { force, moment };
  }

  newFinger() {
    this.call.new_finger();
  }

  /** Moves the finger to x, y [m], twist [rad], depth [m]; `timeStep` [s]. */
  stepFinger(x, y, twist, depth, timeStep) {
    this.call.step_finger(x, y, twist, depth, timeStep);
    return this.finger();
  }

  takeBlock(load) {
    this.call.take_block(load);
  }

  stepBlock(load, timeStep) {
    this.call.step_block(load, timeStep);
    const [x, y, angle, spin] = this.out.subarray(17);
    return { x, y, angle, spin, finger: this.finger() };
  }

  /** Result of the last step: metres, newtons, radians. */
  finger() {
    const o = this.out;
    return {
      state: STATES[o[0]], px: o[1], py: o[2], angle: o[3], depth: o[4], load: o[5], fx: o[6], fy: o[7], moment: o[8], cor: o[9],
      trialForce: o[10], trialMoment: o[11], limitForce: o[12], radius: o[13], x: o[14], y: o[15], twist: o[16],
    };
  }
}

/**
 * Runs a recorded motion like `limitcurve replay` on the plane z = 0: rows {time, x, y, z, twist} in s, m and rad; returns rows with
 * the columns of the command.
 */
async function replay(rows, options) {
  const engine = await Engine.make();
  engine.configure(options);
  let last;
  return rows.map((row, index) => {
    for (const column of ["time", "x", "y", "z", "twist"]) {
      if (!Number.isFinite(row[column])) throw new RangeError(`row ${index}: ${column} = ${row[column]}: expected a finite number`);
    }
    const f = engine.stepFinger(row.x, row.y, row.twist, -row.z, last === undefined ? 0 : row.time - last);
    last = row.time;
    return {
      time: row.time, state: f.state, px: f.px, py: f.py, angle: f.angle, depth: f.depth, load: f.load, fx: f.fx, fy: f.fy,
      moment: f.moment, cor: f.cor,
    };
  });
}

/** The block of §6 with one load of each finger for every millisecond: rows {time, x, y, angle, force, moment, state} of both fingers together. */
async function pivot(loads, options) {
  const engine = await Engine.make();
  engine.configure(options);
  engine.takeBlock(loads[0]);
  return loads.slice(1).map((load, index) => {
    const { x, y, angle, finger } = engine.stepBlock(load, 1e-3);
    return {
      time: (index + 1) * 1e-3, x, y, angle, force: 2 * Math.hypot(finger.fx, finger.fy), moment: 2 * Math.abs(finger.moment),
      state: finger.state,
    };
  });
}
