// The second scene: the paper's block (§6) between two fixed fingers. The user controls the grip.

const BLOCK = { mu: 1.67, momentCoefficient: 0.01011, stiffness: 1000, damping: 5, length: 0.12, height: 0.04, offset: 0.005, hasty: 4 };

class Block {
  static how = `Loosen and tighten the grip: drag up or down, turn the <kbd>wheel</kbd>, or use the keys <kbd>↓</kbd> <kbd>↑</kbd>.
    <kbd>R</kbd> takes the block again.`;
  static name = "Block between two fingers. The up and down arrow keys tighten and loosen the grip, R takes the block again.";
  static load = { name: "Grip P of each finger", min: 0, max: 1, step: 0.005, start: 0.5 };

  constructor(engine) {
    this.engine = engine;
  }

  options(settings) {
    const { mu, momentCoefficient, stiffness, damping } = BLOCK;
    this.engine.takeLaw(settings.law);
    const twistStiffness = stiffness * (momentCoefficient / mu) ** 2 * settings.ratio;
    return {
      law: settings.law, curve: settings.curve, projection: settings.projection, mu, radius: momentCoefficient / (mu * this.engine.momentRatio),
      stiffness, twistStiffness, damping, twistDamping: (damping * twistStiffness) / stiffness,
    };
  }

  configure(settings) {
    const options = this.options(settings);
    this.engine.configure(options);
    this.axes = { mu: BLOCK.mu, loads: [0.25, 0.5, 1], radius: () => options.radius };
    return options;
  }

  /** Holds the block level; call it after `configure`. */
  restart(load) {
    this.grip = Math.max(load, 0.3);
    this.engine.takeBlock(this.grip);
    const finger = this.engine.finger();
    this.start = [finger.px, finger.py];
    this.pose = { x: -BLOCK.offset, y: 0, angle: 0, spin: 0, finger };
    this.finger = finger;
    this.slid = 0;
    this.fell = false;
    this.regrips = false;
  }

  drag(dx, dy) {
    this.change(-dy / 400);
  }

  wheel(notches) {
    this.change(-0.02 * notches);
  }

  advance(count, settings, keys, each) {
    const held = (keys.has("arrowup") || keys.has("+") ? 1 : 0) - (keys.has("arrowdown") || keys.has("-") ? 1 : 0);
    if (held) this.change(held * 0.15 * count * 1e-3);
    for (let i = 0; i < count && !this.fell; ++i) {
      if (settings.operator) this.operate(settings);
      const most = BLOCK.hasty * 1e-3;
      this.grip += Math.max(-most, Math.min(most, settings.load - this.grip));
      this.pose = this.engine.stepBlock(this.grip, 1e-3);
      this.finger = this.pose.finger;
      if (this.finger.state !== "free") this.slid = Math.hypot(this.finger.px - this.start[0], this.finger.py - this.start[1]);
      this.fell = this.pose.y < -BLOCK.length;
      each(this.finger);
    }
  }

  /** As `limitcurve pivot --operator target=30deg`: eases the grip until the block turns, keeps it turning, grips again at the target or if it slides out. */
  operate(settings) {
    if (this.pose.angle >= Math.PI / 6 || (this.slid > 0.002 && this.slid > 0.02 * this.pose.angle)) this.regrips = true;
    const rate = this.regrips ? 5 : this.pose.spin > 0.3 ? 0.5 : -0.5;
    settings.load = Math.max(0, Math.min(Block.load.max, settings.load + rate * 1e-3));
  }

  draw(sheet, settings) {
    sheet.clear();
    const { pen, width, height } = sheet;
    this.scale = Math.min(width / 0.17, height / 0.135);
    const x = (metres) => width / 2 + (metres + 0.01) * this.scale;
    const y = (metres) => height * 0.42 - metres * this.scale;
    for (let i = -12; i <= 12; ++i) sheet.line([[x(i * 0.02), 0], [x(i * 0.02), height]], palette.grid, 1);
    for (let i = -8; i <= 8; ++i) sheet.line([[0, y(i * 0.02)], [width, y(i * 0.02)]], palette.grid, 1);
    sheet.line([[12, height - 12], [12 + 0.02 * this.scale, height - 12]], palette.muted, 2);
    sheet.text("20 mm", 12, height - 18, palette.muted, { size: 12 });
    if (!this.pose) return;
    const { pose, finger } = this;
    const [l, h] = [BLOCK.length * this.scale, BLOCK.height * this.scale];
    pen.save();
    pen.translate(x(pose.x), y(pose.y));
    pen.rotate(-pose.angle);
    pen.beginPath();
    pen.rect(-l / 2, -h / 2, l, h);
    pen.fillStyle = palette.wood;
    pen.fill();
    pen.lineWidth = 2;
    pen.strokeStyle = palette.text;
    pen.stroke();
    pen.restore();
    // The centre of mass, and the weight.
    const [mx, my] = [x(pose.x), y(pose.y)];
    const [gx, gy] = [x(0), y(0)];
    const c = Math.cos(pose.angle);
    const s = Math.sin(pose.angle);
    const world = (bx, by) => [pose.x + c * bx - s * by, pose.y + s * bx + c * by];
    if (finger.state !== "free") {
      const a = finger.radius * this.scale;
      sheet.dot(gx, gy, a, { fill: palette.pad, stroke: palette.proxy, width: 1 + 5 * this.grip });
      const slip = slipOf(finger);
      const turnedSlip = {
        ...slip, way: [c * slip.way[0] - s * slip.way[1], s * slip.way[0] + c * slip.way[1]],
        centre: [c * slip.centre[0] - s * slip.centre[1], s * slip.centre[0] + c * slip.centre[1]],
      };
      if (finger.state === "slip") drawSlipField(sheet, gx, gy, a, turnedSlip, this.scale);
      const hold = world(this.start[0], this.start[1]);
      sheet.line([[gx, gy], [x(hold[0]), y(hold[1])]], palette.finger, 2);
      sheet.dot(x(hold[0]), y(hold[1]), 4.5, { fill: palette.card, stroke: palette.finger });
      drawMoment(sheet, gx, gy, a + 9, -finger.moment / (finger.limitForce * finger.radius * this.engine.momentRatio));
      const [fx, fy] = [-(c * finger.fx - s * finger.fy), -(s * finger.fx + c * finger.fy)];
      sheet.arrow(gx, gy, fx * 0.06 * this.scale, -fy * 0.06 * this.scale, palette.finger, 4, 14);
      if (finger.state === "slip" && Number.isFinite(finger.cor)) {
        sheet.centre(gx, gy, turnedSlip.centre[0] * this.scale, -turnedSlip.centre[1] * this.scale, finger.cor);
      }
    } else {
      sheet.dot(gx, gy, 0.006 * this.scale, { stroke: palette.proxy });
    }
    sheet.arrow(mx, my, 0, 0.028 * this.scale, palette.text, 2.5, 11);
    sheet.dot(mx, my, 4, { fill: palette.text });
    sheet.text("weight", mx - 8, my + 0.028 * this.scale, palette.text, { size: 12, align: "right" });
    drawLegend(sheet, [["F, M of a finger on the block", palette.finger], ["finger pads, front and behind", palette.proxy]]);
    if (this.fell) {
      sheet.text("The block fell. Start again, or press R.", width / 2, height / 2, palette.slip, { align: "center", size: 16, weight: 600 });
    }
  }
}
