// Drawing: a canvas in CSS pixels and in the page's colours.

let palette = {};

function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["card", "line", "grid", "text", "muted", "finger", "proxy", "truth", "slip", "pad", "wood"]) {
    palette[name] = style.getPropertyValue(`--${name}`).trim();
  }
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readColours);
readColours();

class Sheet {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    const fit = () => {
      const ratio = Math.min(devicePixelRatio || 1, 2);
      this.width = canvas.clientWidth;
      this.height = canvas.clientHeight;
      this.ratio = ratio;
      canvas.width = Math.round(this.width * ratio);
      canvas.height = Math.round(this.height * ratio);
    };
    new ResizeObserver(fit).observe(canvas);
    fit();
  }

  clear() {
    this.pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.pen.fillStyle = palette.card;
    this.pen.fillRect(0, 0, this.width, this.height);
    this.pen.lineJoin = this.pen.lineCap = "round";
  }

  line(points, colour, width = 2, dash = []) {
    const { pen } = this;
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(x, y);
    pen.setLineDash(dash);
    pen.lineWidth = width;
    pen.strokeStyle = colour;
    pen.stroke();
    pen.setLineDash([]);
  }

  arrow(x, y, dx, dy, colour, width = 2, head = 9) {
    const length = Math.hypot(dx, dy);
    if (length < 1) return;
    const size = Math.min(head, length);
    const [ux, uy] = [dx / length, dy / length];
    const [tx, ty] = [x + dx, y + dy];
    this.line([[x, y], [tx - ux * size * 0.5, ty - uy * size * 0.5]], colour, width);
    this.tip(tx, ty, ux, uy, size, colour);
  }

  /** The head of an arrow at its end, pointing along a unit vector. */
  tip(x, y, ux, uy, size, colour) {
    const { pen } = this;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x - ux * size - uy * size * 0.45, y - uy * size + ux * size * 0.45);
    pen.lineTo(x - ux * size + uy * size * 0.45, y - uy * size - ux * size * 0.45);
    pen.closePath();
    pen.fillStyle = colour;
    pen.fill();
  }

  dot(x, y, radius, { fill, stroke, width = 2 }) {
    const { pen } = this;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    if (fill) {
      pen.fillStyle = fill;
      pen.fill();
    }
    if (stroke) {
      pen.lineWidth = width;
      pen.strokeStyle = stroke;
      pen.stroke();
    }
  }

  /** The centre of rotation of a slip. */
  cross(x, y, colour) {
    this.line([[x - 7, y - 7], [x + 7, y + 7]], colour, 3);
    this.line([[x - 7, y + 7], [x + 7, y - 7]], colour, 3);
  }

  text(words, x, y, colour, { size = 13, align = "left", base = "alphabetic", weight = 400, halo = true } = {}) {
    const { pen } = this;
    pen.font = `${weight} ${size}px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
    pen.textAlign = align;
    pen.textBaseline = base;
    if (halo) {
      pen.strokeStyle = palette.card;
      pen.lineWidth = 4;
      pen.strokeText(words, x, y);
    }
    pen.fillStyle = colour;
    pen.fillText(words, x, y);
  }

  /** The centre of rotation, `x`, `y` from the contact's centre; if it is out of sight, the direction to it. */
  centre(cx, cy, x, y, c) {
    const length = Math.hypot(x, y);
    const reach = [
      x > 0 ? (this.width - 24 - cx) / x : x < 0 ? (24 - cx) / x : Infinity,
      y > 0 ? (this.height - 40 - cy) / y : y < 0 ? (24 - cy) / y : Infinity,
    ];
    const share = Math.min(1, ...reach);
    if (!(length > 0) && !Number.isFinite(c)) return;
    const [ex, ey] = [cx + x * share, cy + y * share];
    this.line([[cx, cy], [ex, ey]], palette.slip, 1.5, [4, 4]);
    if (share < 1) {
      this.tip(ex, ey, x / length, y / length, 11, palette.slip);
    } else {
      this.cross(ex, ey, palette.slip);
    }
    const words = share < 1 ? `COR, ${(c * 1e3).toFixed(0)} mm away` : "COR";
    const right = ex > this.width - 90;
    this.text(words, ex + (right ? -12 : 12), Math.max(ey - 10, 16), palette.slip, { align: right ? "right" : "left", weight: 600 });
  }
}

/** A round number near `value`: 1, 2 or 5 times a power of ten. */
function nice(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}
