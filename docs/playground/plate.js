// The first scene: a finger on a plate, seen from above. The hand is where the user holds the device; the proxy stays behind.

const PLATE = {
  mu: 0.6, radius: 0.006, stiffness: 300, halfWidth: 0.03, halfHeight: 0.02,
  fastest: 0.4, fastestTwist: 12, keySpeed: 0.03, keyTwist: 1.5, driveSpeed: 0.012, driveTwist: 2,
};

class Plate {
  static how = `Drag the finger; turn it with the <kbd>wheel</kbd>, or with two fingers on a touch screen. Keys:
    <kbd>arrows</kbd> move, <kbd>Q</kbd> <kbd>E</kbd> turn, <kbd>+</kbd> <kbd>−</kbd> press harder or softer, <kbd>Space</kbd> lifts.`;
  static name = "Plate with a finger. Arrow keys move it, Q and E turn it, plus and minus change the load, space lifts it.";
  static load = { name: "Load P", min: 0, max: 3, step: 0.05, start: 1 };

  constructor(engine) {
    this.engine = engine;
    this.restart();
  }

  options(settings) {
    const { mu, radius, stiffness } = PLATE;
    this.engine.takeLaw(settings.law);
    const arm = this.engine.momentRatio * radius;
    const twistStiffness = stiffness * arm * arm * settings.ratio;
    return { law: settings.law, curve: settings.curve, projection: settings.projection, mu, radius, exponent: settings.exponent, stiffness, twistStiffness };
  }

  configure(settings) {
    const options = this.options(settings);
    this.engine.configure(options);
    this.exponent = settings.exponent;
    this.axes = { mu: PLATE.mu, loads: [1, 2, 3], radius: (load) => PLATE.radius * load ** settings.exponent };
    return options;
  }

  restart() {
    this.engine.newFinger();
    this.hand = { x: -0.006, y: 0, twist: 0 };
    this.target = { ...this.hand };
    this.way = 1;
    this.legTime = 0;
    this.truth = undefined;
    this.finger = undefined;
  }

  move(dx, dy, twist) {
    const clamp = (value, most) => Math.max(-most, Math.min(most, value));
    this.target.x = clamp(this.target.x + dx, PLATE.halfWidth);
    this.target.y = clamp(this.target.y + dy, PLATE.halfHeight);
    this.target.twist += twist;
  }

  drag(dx, dy, turn) {
    this.move(dx / this.scale, -dy / this.scale, turn);
  }

  wheel(notches) {
    this.move(0, 0, -0.2 * notches);
  }

  /** `count` steps of a millisecond; `keys` that are held down. `each` gets every step. */
  advance(count, settings, keys, each) {
    const seconds = count * 1e-3;
    const held = (plus, minus) => (keys.has(plus) ? 1 : 0) - (keys.has(minus) ? 1 : 0);
    const along = PLATE.keySpeed * seconds;
    this.move(held("arrowright", "arrowleft") * along, held("arrowup", "arrowdown") * along, held("q", "e") * PLATE.keyTwist * seconds);
    if (settings.drive) this.drive(seconds, settings.about);
    const before = { ...this.hand };
    const [dx, dy] = [this.target.x - before.x, this.target.y - before.y];
    const far = Math.hypot(dx, dy);
    const share = far > 0 ? Math.min(1, (PLATE.fastest * seconds) / far) : 0;
    const turn = this.target.twist - before.twist;
    const turnShare = turn !== 0 ? Math.min(1, (PLATE.fastestTwist * seconds) / Math.abs(turn)) : 0;
    for (let i = 1; i <= count; ++i) {
      const x = before.x + dx * share * (i / count);
      const y = before.y + dy * share * (i / count);
      const twist = before.twist + turn * turnShare * (i / count);
      this.finger = this.engine.stepFinger(x, y, twist, settings.load / PLATE.stiffness, 1e-3);
      this.hand = { x, y, twist };
      each(this.finger);
    }
    this.compare(far * share, Math.abs(turn * turnShare));
  }

  /** To and fro along x with a steady twist, about a centre at `about` radii. */
  drive(seconds, about) {
    const a = PLATE.radius;
    const turn = PLATE.driveTwist * Math.min(1, 1 / Math.max(about, 1e-9));
    const step = Math.min(about * a * turn, PLATE.driveSpeed) * seconds;
    this.legTime += seconds;
    if ((this.hand.x * this.way > 0.017 && step > 0) || this.legTime > 5) {
      this.way = -this.way;
      this.legTime = 0;
    }
    this.target = { x: this.hand.x, y: this.hand.y, twist: this.hand.twist };
    this.move(this.way * step, 0, about > 2.99 ? 0 : this.way * turn * seconds);
  }

  /** The wrench of eq. (17) for the motion of the last frame, and the distance of the wrench from it. */
  compare(slid, turned) {
    this.truth = undefined;
    const f = this.finger;
    if (f.state === "free" || !(slid + f.radius * turned > 1e-6)) return;
    const unit = this.engine.wrench(slid, f.radius * turned, true);
    const [limit, momentLimit] = [f.limitForce, f.limitForce * f.radius];
    this.truth = { force: unit.force * limit, moment: unit.moment * momentLimit };
    const df = Math.hypot(f.fx, f.fy) / limit - unit.force;
    const dm = (Math.abs(f.moment) / momentLimit - unit.moment) / this.engine.momentRatio;
    this.truth.error = Math.hypot(df, dm);
  }

  draw(sheet, settings) {
    sheet.clear();
    const { pen, width, height } = sheet;
    const f = this.finger;
    this.scale = Math.min(width / 0.07, height / 0.05);
    const x = (metres) => width / 2 + metres * this.scale;
    const y = (metres) => height / 2 - metres * this.scale;
    for (let i = -6; i <= 6; ++i) sheet.line([[x(i * 0.01), 0], [x(i * 0.01), height]], palette.grid, 1);
    for (let i = -4; i <= 4; ++i) sheet.line([[0, y(i * 0.01)], [width, y(i * 0.01)]], palette.grid, 1);
    sheet.line([[12, height - 12], [12 + 0.01 * this.scale, height - 12]], palette.muted, 2);
    sheet.text("10 mm", 12, height - 18, palette.muted, { size: 12 });
    if (!f) return;
    const touches = f.state !== "free";
    const [hx, hy] = [x(this.hand.x), y(this.hand.y)];
    this.drawFinger(sheet, hx, hy, touches);
    if (!touches) {
      sheet.dot(hx, hy, 6, { fill: palette.finger });
      sheet.text("lifted", hx + 12, hy - 10, palette.muted);
      return;
    }
    const [px, py] = [x(f.px), y(f.py)];
    const a = f.radius * this.scale;
    sheet.dot(px, py, a, { fill: palette.pad, stroke: palette.proxy });
    const ahead = (angle, length) => [length * Math.sin(-angle), -length * Math.cos(angle)];
    const [ox, oy] = ahead(f.angle, a);
    sheet.line([[px, py], [px + ox, py + oy]], palette.proxy, 2.5);
    const slip = slipOf(f);
    if (f.state === "slip") drawSlipField(sheet, px, py, a, slip, this.scale);
    const [bx, by] = ahead(this.hand.twist, a);
    sheet.line([[hx, hy], [hx + bx, hy + by]], palette.finger, 2, [5, 4]);
    sheet.line([[px, py], [hx, hy]], palette.text, 2);
    sheet.dot(px, py, 5, { fill: palette.card, stroke: palette.proxy, width: 2.5 });
    sheet.dot(hx, hy, 5, { fill: palette.finger });
    drawMoment(sheet, px, py, a + 9, f.moment / (f.limitForce * f.radius * this.engine.momentRatio));
    sheet.arrow(px, py, f.fx * 0.025 * this.scale, -f.fy * 0.025 * this.scale, palette.finger, 4, 14);
    if (f.state === "slip" && Number.isFinite(f.cor)) {
      sheet.centre(px, py, slip.centre[0] * this.scale, -slip.centre[1] * this.scale, f.cor);
    }
    drawLegend(sheet, [["finger, with F and M on it", palette.finger], ["proxy: the skin in contact", palette.proxy]]);
  }

  drawFinger(sheet, x, y, touches) {
    const { pen } = sheet;
    const [half, length] = [0.0085 * this.scale, 0.09 * this.scale];
    pen.save();
    pen.translate(x, y);
    pen.rotate(-this.hand.twist);
    pen.beginPath();
    pen.arc(0, 0, half, Math.PI, 0);
    pen.lineTo(half * 1.1, length);
    pen.lineTo(-half * 1.1, length);
    pen.closePath();
    pen.globalAlpha = touches ? 0.45 : 0.25;
    pen.fillStyle = palette.pad;
    pen.fill();
    pen.globalAlpha = 1;
    pen.restore();
  }
}

/** Of a slip in this step: direction, sense of rotation, and the centre of rotation from the proxy [m]. */
function slipOf(f) {
  const [dx, dy] = [f.x - f.px, f.y - f.py];
  const length = Math.hypot(dx, dy);
  const way = length > 0 ? [dx / length, dy / length] : [0, 0];
  const sense = Math.sign(f.twist - f.angle);
  const c = Number.isFinite(f.cor) ? f.cor : 0;
  return { way, sense, centre: [-way[1] * sense * c, way[0] * sense * c], pure: !Number.isFinite(f.cor) || sense === 0 };
}

/** Slip velocity of the points of the skin (eq. 15). */
function drawSlipField(sheet, px, py, a, slip, scale) {
  const pitch = Math.max(a / 3, 14);
  for (let i = -4; i <= 4; ++i) {
    for (let j = -4; j <= 4; ++j) {
      const [qx, qy] = [i * pitch + (j % 2 ? pitch / 2 : 0), j * pitch * 0.87];
      if (Math.hypot(qx, qy) > a * 0.92) continue;
      const [rx, ry] = [qx / scale - slip.centre[0], -qy / scale - slip.centre[1]];
      const v = slip.pure ? slip.way : [-ry * slip.sense, rx * slip.sense];
      const speed = Math.hypot(v[0], v[1]);
      if (!(speed > 0)) continue;
      const length = pitch * 0.62;
      const [dx, dy] = [(v[0] / speed) * length, (-v[1] / speed) * length];
      sheet.arrow(px + qx - dx / 2, py + qy - dy / 2, dx, dy, palette.muted, 1.2, 5);
    }
  }
}

/** An arc proportional to the moment: the limit is 120°; counter-clockwise is positive. */
function drawMoment(sheet, x, y, radius, share) {
  if (!(Math.abs(share) > 0.02)) return;
  const { pen } = sheet;
  const turn = Math.max(-1, Math.min(1, share)) * ((2 * Math.PI) / 3);
  const [from, to] = [-Math.PI / 2, -Math.PI / 2 - turn];
  pen.beginPath();
  pen.arc(x, y, radius, from, to, turn > 0);
  pen.lineWidth = 4;
  pen.strokeStyle = palette.finger;
  pen.stroke();
  const sense = Math.sign(turn);
  const [ux, uy] = [Math.sin(to) * sense, -Math.cos(to) * sense];
  sheet.tip(x + radius * Math.cos(to) + ux * 7, y + radius * Math.sin(to) + uy * 7, ux, uy, 13, palette.finger);
}

function drawLegend(sheet, rows) {
  rows.forEach(([words, colour], i) => {
    sheet.dot(16, 18 + i * 18, 4.5, { fill: colour });
    sheet.text(words, 27, 18 + i * 18, palette.text, { size: 12, base: "middle" });
  });
}
