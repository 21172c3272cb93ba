// SPDX-License-Identifier: MIT
// The charts of the report that answer: point at a curve, switch laws, slide the load. Their numbers are those of the CSV files beside the page.
"use strict";
(() => {
const numbers = JSON.parse(document.getElementById("numbers").textContent);
const infinite = (values) => values.map((value) => value === null ? Infinity : value);  // JSON has none
const short = (value, digits = 4) => value === Infinity ? "∞" : value === 0 ? "0" : value.toPrecision(digits);

function element(name, parent, attributes = {}, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  parent.append(made);
  return made;
}

/// Axes and curves in an SVG whose unit is the pixel, whatever the width of the page.
class Plot {
  constructor(svg, labels) {
    this.svg = svg;
    this.labels = labels;
  }

  /// Empties the plot and draws its axes from `from` to `to`, each a pair.
  begin(from, to) {
    const [left, right, top, bottom] = [52, 10, 10, 44];
    const width = Math.max(260, this.svg.clientWidth), height = Math.round(Math.min(0.82 * width, 460));
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.style.height = `${height}px`;
    this.svg.replaceChildren(...this.svg.querySelectorAll("title"));
    this.x = (value) => left + (value - from[0]) / (to[0] - from[0]) * (width - left - right);
    this.y = (value) => height - bottom - (value - from[1]) / (to[1] - from[1]) * (height - top - bottom);
    this.box = [left, top, width - left - right, height - top - bottom];
    for (const axis of [0, 1]) {
      const step = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2].find((step) => (to[axis] - from[axis]) / step <= (width < 420 ? 5 : 8));
      for (let i = Math.ceil(from[axis] / step - 1e-9); i * step <= to[axis] + 1e-9; ++i) {
        const value = i * step, text = value.toFixed(step < 0.1 ? 2 : step < 1 ? 1 : 0);
        const [x, y] = [this.x(value), this.y(value)];
        const line = axis ? {x1: left, x2: width - right, y1: y, y2: y} : {x1: x, x2: x, y1: top, y2: height - bottom};
        element("line", this.svg, {...line, class: "grid"});
        element("text", this.svg, axis ? {x: left - 6, y: y + 4, "text-anchor": "end"} : {x, y: height - bottom + 17, "text-anchor": "middle"}, text);
      }
    }
    element("text", this.svg, {x: left + this.box[2] / 2, y: height - 6, "text-anchor": "middle"}, this.labels()[0]);
    element("text", this.svg, {transform: `translate(13 ${top + this.box[3] / 2}) rotate(-90)`, "text-anchor": "middle"}, this.labels()[1]);
    const clip = element("clipPath", element("defs", this.svg), {id: `${this.svg.id}-clip`});
    element("rect", clip, {x: left, y: top - 4, width: this.box[2] + 4, height: this.box[3] + 8});
    this.curves = element("g", this.svg, {"clip-path": `url(#${this.svg.id}-clip)`});
    this.marks = element("g", this.svg, {"clip-path": `url(#${this.svg.id}-clip)`});
  }

  curve(xs, ys, style) {
    const path = xs.map((x, i) => `${i ? "L" : "M"}${this.x(x).toFixed(1)} ${this.y(ys[i]).toFixed(1)}`).join("");
    element("path", this.curves, {d: path, fill: "none", "stroke-width": 2, ...style});
  }

  dot(x, y, colour, radius) {
    element("circle", this.marks, {cx: this.x(x), cy: this.y(y), r: radius, fill: colour, class: "dot"});
  }

  /// Calls `take` with the place of a pointer in the unit of the SVG.
  point(take) {
    const moved = (event) => {
      const frame = this.svg.getBoundingClientRect();
      take(event.clientX - frame.left, event.clientY - frame.top);
    };
    this.svg.addEventListener("pointermove", moved);
    this.svg.addEventListener("pointerdown", moved);
  }

  /// The index of the nearest of the points, and how far it is.
  nearest(xs, ys, x, y) {
    let best = 0, least = Infinity;
    xs.forEach((value, i) => {
      const distance = Math.hypot(this.x(value) - x, this.y(ys[i]) - y);
      if (distance < least) [best, least] = [i, distance];
    });
    return [best, least];
  }

  onResize(draw) {
    let width = 0;
    new ResizeObserver(() => {
      if (this.svg.clientWidth !== width) draw(width = this.svg.clientWidth);
    }).observe(this.svg);
  }
}

/// Calls `take` with the value of a group of radio buttons: now and whenever it changes.
function choice(name, take) {
  const buttons = [...document.querySelectorAll(`input[name=${name}]`)];
  for (const button of buttons) button.addEventListener("change", () => take(button.value));
  take(buttons.find((button) => button.checked).value);
}

function lawsChart() {
  const near = 60;
  const curves = numbers.laws.curves, c = infinite(numbers.laws.c);
  const top = Math.max(...curves.flatMap((curve) => curve.moment));
  const rows = [...document.querySelectorAll("#laws-table tbody tr")], slider = document.getElementById("laws-place");
  let view = "units", law = 0;
  const plot = new Plot(document.getElementById("laws-plot"),
    () => view === "units" ? ["force F/(μP)", "moment M/(μPa)"] : ["force F/F_max", "moment M/M_max"]);
  const shown = (i) => rows[i].querySelector("input").checked;
  const heights = (curve) => view === "units" ? curve.moment : curve.moment.map((moment) => moment / curve.moment[0]);

  function draw() {
    const lens = view === "lens";
    plot.begin(lens ? [0.6, 0.6] : [0, 0], lens ? [0.78, 0.78] : [1.05, view === "units" ? 1.05 * top : 1.05]);
    if (view !== "units") {
      const quarter = Array.from({length: 91}, (_, i) => i * Math.PI / 180);
      plot.curve(quarter.map(Math.cos), quarter.map(Math.sin), {stroke: "#222222", "stroke-dasharray": "7 4", "stroke-width": 1.4});
    }
    curves.forEach((curve, i) => shown(i) && plot.curve(curve.force, heights(curve), {stroke: curve.colour, "stroke-dasharray": curve.dashes}));
    read();
  }

  function read() {
    const at = Number(slider.value);
    plot.marks.replaceChildren();
    curves.forEach((curve, i) => {
      rows[i].classList.toggle("pointed", i === law && shown(i));
      rows[i].querySelector(".force").textContent = shown(i) ? curve.force[at].toFixed(5) : "";
      rows[i].querySelector(".moment").textContent = shown(i) ? curve.moment[at].toFixed(5) : "";
      if (shown(i)) plot.dot(curve.force[at], heights(curve)[at], curve.colour, i === law ? 6 : 3.5);
    });
    const text = c[at] === Infinity ? "c = ∞: it slides and does not turn" : c[at] === 0 ? "c = 0: it turns on the spot" : `c = ${short(c[at], 5)} a`;
    document.getElementById("laws-c").textContent = text;
    slider.setAttribute("aria-valuetext", text);
  }

  plot.point((x, y) => {
    const found = curves.map((curve, i) => [i, ...(shown(i) ? plot.nearest(curve.force, heights(curve), x, y) : [0, Infinity])]);
    const [i, at, distance] = found.reduce((best, one) => one[2] < best[2] ? one : best);
    if (distance > near) return;
    law = i;
    slider.value = at;
    read();
  });
  slider.max = c.length - 1;
  slider.addEventListener("input", read);
  rows.forEach((row, i) => row.querySelector("input").addEventListener("change", () => { law = i; draw(); }));
  for (const [name, on] of [["laws-all", true], ["laws-none", false]]) {
    document.getElementById(name).addEventListener("click", () => {
      for (const row of rows) row.querySelector("input").checked = on;
      draw();
    });
  }
  choice("laws-view", (value) => { view = value; draw(); });
  plot.onResize(draw);
}

function loadsChart() {
  const near = 60, milli = 1e3, orange = "#c27c00";
  const load = document.getElementById("loads-load"), place = document.getElementById("loads-place");
  const output = document.getElementById("loads-read"), cells = [...document.querySelectorAll("#loads-table tbody tr")];
  let one = numbers.loads[0];
  const plot = new Plot(document.getElementById("loads-plot"), () => ["friction force F [N]", "friction moment M [N mm]"]);
  const last = (values) => values[values.length - 1];
  const force = Math.max(...numbers.loads.map((each) => last(last(each.cors).force)));
  const moment = Math.max(...numbers.loads.map((each) => last(each.cors[0].moment)));
  load.max = one.loads.length - 1;
  place.max = one.p_curve.c.length - 1;

  /// The p-curve of another load: the force grows as the load, the moment as the moment of a pure turn, and c with the ratio of the two.
  function pCurve(at) {
    const base = one.p_curve, forces = one.loads[at] / base.load, moments = one.cors[0].moment[at] / base.moment[0];
    return {c: infinite(base.c).map((c) => c * moments / forces), force: base.force.map((value) => value * forces),
            moment: base.moment.map((value) => value * moments)};
  }

  function draw() {
    plot.begin([0, 0], [1.06 * force, 1.02 * milli * moment]);
    for (const cor of one.cors) plot.curve(cor.force, cor.moment.map((value) => milli * value), {stroke: orange, "stroke-width": 1.4});
    one.cors.forEach((cor, i) => {
      const [x, y] = [last(cor.force), milli * last(cor.moment)];
      if (x && y) element("text", plot.curves, {x: plot.x(x) + 4, y: plot.y(y) + 4}, `${cells[i].cells[0].textContent} mm`);
    });
    const at = Number(load.value), curve = pCurve(at);
    plot.curve(curve.force, curve.moment.map((value) => milli * value), {stroke: "#0072B2", "stroke-width": 2.5});
    one.cors.forEach((cor, i) => {
      cells[i].querySelector(".force").textContent = cor.force[at].toFixed(4);
      cells[i].querySelector(".moment").textContent = (milli * cor.moment[at]).toFixed(4);
      plot.dot(cor.force[at], milli * cor.moment[at], orange, 3.5);
    });
    const newtons = `${one.loads[at].toFixed(2)} N`;
    document.getElementById("loads-load-read").textContent = newtons;
    load.setAttribute("aria-valuetext", newtons);
    const index = Number(place.value), c = curve.c[index];
    plot.dot(curve.force[index], milli * curve.moment[index], "#0072B2", 6);
    const text = `c = ${short(milli * c, 5)} mm, F = ${curve.force[index].toFixed(4)} N, M = ${(milli * curve.moment[index]).toFixed(4)} N mm`;
    output.textContent = text;
    place.setAttribute("aria-valuetext", text);
  }

  plot.point((x, y) => {
    const curve = pCurve(Number(load.value));
    const [at, distance] = plot.nearest(curve.force, curve.moment.map((value) => milli * value), x, y);
    if (distance > near) return;
    place.value = at;
    draw();
  });
  for (const slider of [load, place]) slider.addEventListener("input", draw);
  choice("loads-radius", (value) => { one = numbers.loads[Number(value)]; draw(); });
  plot.onResize(draw);
}

document.documentElement.classList.add("scripted");
lawsChart();
loadsChart();
})();
