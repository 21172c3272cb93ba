// The [r, ρ] plane (Figs. 5 and 9): spring force k_l r and moment k_r ρ, the limit curve, and the projection of each trial onto it.

class Plane {
  constructor(canvas) {
    this.sheet = new Sheet(canvas);
    this.steps = [];
    this.loadOfAxes = 1;
  }

  /** The curves of an engine in units of μP and μPa; call it when the settings change. */
  take(engine, isBox) {
    const along = (ofLaw) => {
      const points = [];
      for (let i = 0; i <= 90; ++i) {
        const angle = (i * Math.PI) / 180;
        const { force, moment } = engine.wrench(i === 90 ? 1 : Math.sin(angle), i === 0 || i === 90 ? 1 - i / 90 : Math.cos(angle), ofLaw);
        points.push([force, moment]);
      }
      return points;
    };
    this.exact = along(true);
    const [corner, top] = [this.exact.at(-1)[0], this.exact[0][1]];
    this.used = isBox ? [[0, top], [corner, top], [corner, 0]] : along(false);
    this.momentRatio = top;
    this.steps = [];
  }

  add(finger, time) {
    if (finger.state === "free") return;
    this.steps.push({
      time, slips: finger.state === "slip", trial: [finger.trialForce, finger.trialMoment],
      felt: [Math.hypot(finger.fx, finger.fy), Math.abs(finger.moment)],
    });
    if (this.steps.length > 240) this.steps.splice(0, 60);
  }

  /** `truth`: the wrench of eq. (17) for the finger's motion, if it moves. */
  draw(finger, axes, truth, time) {
    const { sheet } = this;
    const { pen, width, height } = sheet;
    sheet.clear();
    const [left, bottom, top, right] = [54, 46, 16, 18];
    const load = finger.state === "free" ? 0 : finger.load;
    this.loadOfAxes = axes.loads.find((one) => one >= load - 1e-9) ?? axes.loads.at(-1);
    const furthest = [1.32 * axes.mu * this.loadOfAxes, 1.32 * axes.mu * this.loadOfAxes * axes.radius(this.loadOfAxes) * this.momentRatio];
    const x = (force) => left + (Math.min(force / furthest[0], 1.02) * (width - left - right));
    const y = (moment) => height - bottom - Math.min(moment / furthest[1], 1.02) * (height - bottom - top);
    this.axis(furthest, x, y, { left, bottom, top, right });

    if (load > 0) {
      const curve = (points) => points.map(([f, m]) => [x(f * finger.limitForce), y(m * finger.limitForce * finger.radius)]);
      const used = curve(this.used);
      pen.beginPath();
      pen.moveTo(x(0), y(0));
      for (const [px, py] of used) pen.lineTo(px, py);
      pen.closePath();
      pen.fillStyle = palette.grid;
      pen.globalAlpha = 0.6;
      pen.fill();
      pen.globalAlpha = 1;
      sheet.line(curve(this.exact), palette.truth, 2, [5, 5]);
      sheet.line(used, palette.text, 3);
    }
    if (truth) {
      const [tx, ty] = [x(truth.force), y(truth.moment)];
      pen.beginPath();
      for (const [dx, dy] of [[0, -9], [9, 0], [0, 9], [-9, 0]]) pen.lineTo(tx + dx, ty + dy);
      pen.closePath();
      pen.fillStyle = palette.truth;
      pen.fill();
    }
    if (load === 0) this.steps = [];
    for (const step of this.steps) {
      const age = (time - step.time) / 0.25;
      if (age > 1 || age < 0) continue;
      pen.globalAlpha = 0.5 * (1 - age);
      const felt = [x(step.felt[0]), y(step.felt[1])];
      if (step.slips) sheet.line([[x(step.trial[0]), y(step.trial[1])], felt], palette.proxy, 1);
      sheet.dot(felt[0], felt[1], 2, { fill: palette.finger });
    }
    pen.globalAlpha = 1;
    const last = this.steps.at(-1);
    if (last && load > 0) {
      const felt = [x(last.felt[0]), y(last.felt[1])];
      if (last.slips) {
        const trial = [x(last.trial[0]), y(last.trial[1])];
        sheet.line([trial, felt], palette.proxy, 2);
        sheet.dot(trial[0], trial[1], 5, { fill: palette.card, stroke: palette.proxy });
      }
      sheet.dot(felt[0], felt[1], 5.5, { fill: palette.finger, stroke: palette.card, width: 1.5 });
    }
    if (load === 0) sheet.text("no contact, no friction", (left + width - right) / 2, height / 2, palette.muted, { align: "center" });
  }

  axis(furthest, x, y, { left, bottom, top, right }) {
    const { sheet } = this;
    const { width, height } = sheet;
    const [nx, ny] = [nice(furthest[0] / 3.5), nice((furthest[1] * 1e3) / 3.5)];
    for (let i = 1; i * nx < furthest[0]; ++i) {
      sheet.line([[x(i * nx), y(0)], [x(i * nx), top]], palette.grid, 1);
      sheet.text(String(+(i * nx).toPrecision(6)), x(i * nx), height - bottom + 17, palette.muted, { align: "center", size: 12, halo: false });
    }
    for (let i = 1; i * ny < furthest[1] * 1e3; ++i) {
      sheet.line([[x(0), y(i * ny * 1e-3)], [width - right, y(i * ny * 1e-3)]], palette.grid, 1);
      sheet.text(String(+(i * ny).toPrecision(6)), left - 7, y(i * ny * 1e-3), palette.muted, { align: "right", base: "middle", size: 12, halo: false });
    }
    sheet.line([[left, top], [left, height - bottom], [width - right, height - bottom]], palette.muted, 1.5);
    sheet.text("0", left - 7, height - bottom + 12, palette.muted, { align: "right", size: 12, halo: false });
    sheet.text("force of the spring, k r [N]", (left + width - right) / 2, height - 9, palette.text, { align: "center", halo: false });
    sheet.pen.save();
    sheet.pen.translate(15, (top + height - bottom) / 2);
    sheet.pen.rotate(-Math.PI / 2);
    sheet.text("moment, kᵣ ρ [N mm]", 0, 0, palette.text, { align: "center", halo: false });
    sheet.pen.restore();
  }
}
