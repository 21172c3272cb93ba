// SPDX-License-Identifier: MIT
#include "limitcurve/patch/patch_table.hpp"

#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

// Notation. q = (v_x, v_y, m₀ω), the twist; G(q) = H(v_x, v_y, ω), the power, even and of degree one; g = ∇G, the
// wrench with its moment over m₀. Face f of the cube has q_f = 1 and coordinates (x, y) = (q_a, q_b), a = f + 1 and b =
// f + 2 modulo 3; the opposite face follows from G(−q) = G(q). A face is divided evenly into n × n cells, n even, so
// that its middle is a node. A node holds G, G_x, G_y and G_xy; a cell is bicubic.
//
// Where two faces meet, say q_p = 1 and q_r = s = ±1, both see the same G(τ), a cubic in each cell of τ = q_t. By
// Euler's identity G = q·g the slope across the edge that the one face has, g_r, gives that of the other, g_p = G − s
// g_r − τ G′: a cubic in each cell, too, but with a continuous derivative only if G″ is continuous. So G′ at the nodes
// of an edge is the slope of a cubic spline, G″ that of the spline, and the mixed derivatives are chosen with
//   m_p + s m_r + τ G″ = 0,  m = ∂g/∂τ:
// then both faces have the same gradient along the whole edge. In a corner three edges ask for three mixed derivatives.
namespace limitcurve {

namespace {

using Vector = std::array<double, 3>;
using Node = PatchTableContents::Node;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array<int, 11> cells_of_a_side{8, 12, 16, 24, 32, 48, 64, 80, 96, 128, 146};

constexpr std::size_t nodes_of_a_face(int n) {
  return static_cast<std::size_t>(n + 1) * static_cast<std::size_t>(n + 1);
}

/// The power and its gradient at q.
struct Support {
  const patch::Shape& shape;

  struct Value {
    double power;
    Vector slope;
  };
  Value operator()(const Vector& q) const noexcept {
    const PatchFriction exact = shape.evaluate({q[0], q[1], q[2] / shape.moment_ratio});
    return {exact.power, {exact.wrench.fx, exact.wrench.fy, exact.wrench.moment / shape.moment_ratio}};
  }
};

/// Slopes and second derivatives at evenly spaced nodes of the cubic spline with given slopes at both ends.
struct Spline {
  std::vector<double> slope;
  std::vector<double> second;

  Spline(const std::vector<double>& value, double first, double last, double step)
      : slope(value.size()), second(value.size()) {
    const std::size_t n = value.size() - 1;
    slope[0] = first;
    slope[n] = last;
    // s_{i−1} + 4 s_i + s_{i+1} = 3 (v_{i+1} − v_{i−1})/step, by elimination.
    std::vector<double> upper(n);
    for (std::size_t i = 1; i < n; ++i) {
      upper[i] = 1.0 / (4.0 - upper[i - 1]);
      const double right = 3.0 * (value[i + 1] - value[i - 1]) / step - (i == n - 1 ? last : 0.0);
      slope[i] = (right - slope[i - 1]) * upper[i];
    }
    for (std::size_t i = n - 1; i-- > 1;) slope[i] -= upper[i] * slope[i + 1];
    for (std::size_t i = 0; i < n; ++i) {
      const double chord = (value[i + 1] - value[i]) / step;
      second[i] = 2.0 / step * (3.0 * chord - 2.0 * slope[i] - slope[i + 1]);
      second[i + 1] = 2.0 / step * (2.0 * slope[i + 1] + slope[i] - 3.0 * chord);
    }
  }
};

/// The nodes of all faces while a table is made.
class Grid {
 public:
  Grid(const patch::Shape& shape, int cells) : n_(cells), nodes_(3 * nodes_of_a_face(cells)) {
    const Support support{shape};
    for (std::size_t f = 0; f < 3; ++f) {
      for (int i = 0; i <= n_; ++i) {
        let_interrupt();
        for (int j = 0; j <= n_; ++j) {
          Vector q{};
          q[f] = 1.0;
          q[(f + 1) % 3] = place(i);
          q[(f + 2) % 3] = place(j);
          const auto [power, slope] = support(q);
          node(f, i, j) = {power, slope[(f + 1) % 3], slope[(f + 2) % 3], 0.0};
          own_error_ = std::max(own_error_, shape.error({q[0], q[1], q[2] / shape.moment_ratio}));
        }
      }
      for (int i = 0; i <= n_; ++i) {
        for (int j = 0; j <= n_; ++j) {
          const double along_y = difference([&](int k) { return node(f, i, k)[1]; }, j);
          const double along_x = difference([&](int k) { return node(f, k, j)[2]; }, i);
          node(f, i, j)[3] = 0.5 * (along_x + along_y);
        }
      }
    }
    join();
  }

  [[nodiscard]] std::vector<Node> nodes() && {
    // + 0: no -0, which JSON reads as a whole number without a sign.
    for (Node& node : nodes_)
      node = {node[0], node[1] * step() + 0.0, node[2] * step() + 0.0, node[3] * step() * step() + 0.0};
    return std::move(nodes_);
  }
  [[nodiscard]] double own_error() const noexcept { return own_error_; }

 private:
  [[nodiscard]] double step() const noexcept { return 2.0 / n_; }
  [[nodiscard]] double place(int i) const noexcept { return -1.0 + i * step(); }
  Node& node(std::size_t face, int i, int j) {
    return nodes_[face * nodes_of_a_face(n_) + static_cast<std::size_t>(i * (n_ + 1) + j)];
  }

  /// The derivative at node k of what has the values `get`, of fourth order but beside the edges.
  template <class Get>
  [[nodiscard]] double difference(const Get& get, int k) const {
    if (k >= 2 && k <= n_ - 2) return (8.0 * (get(k + 1) - get(k - 1)) - (get(k + 2) - get(k - 2))) / (12.0 * step());
    if (k >= 1 && k <= n_ - 1) return (get(k + 1) - get(k - 1)) / (2.0 * step());
    const int inward = k == 0 ? 1 : -1;
    return inward * (-3.0 * get(k) + 4.0 * get(k + inward) - get(k + 2 * inward)) / (2.0 * step());
  }

  /// What face f has at q, where |q_f| = 1. At −q slopes have the other sign; powers and second derivatives are equal.
  struct Seen {
    Node& at;
    std::size_t face;
    double sense;
    double& slope(std::size_t axis) const { return at[axis == (face + 1) % 3 ? 1 : 2]; }
    double& mixed() const { return at[3]; }
  };
  Seen seen(std::size_t f, const Vector& q) {
    const auto number = [&](std::size_t axis) {
      return static_cast<int>(std::lround((q[axis] / q[f] + 1.0) / step()));
    };
    return {node(f, number((f + 1) % 3), number((f + 2) % 3)), f, q[f]};
  }

  /// Makes the gradient continuous where faces meet.
  void join() {
    struct Corner {
      Vector q;
      Vector second;  ///< ∂²G/∂q_i² on the edge along q_i
    };
    std::array<Corner, 4> corners{{{{1, 1, 1}, {}}, {{1, 1, -1}, {}}, {{1, -1, 1}, {}}, {{1, -1, -1}, {}}}};
    for (std::size_t t = 0; t < 3; ++t) {
      const std::size_t p = (t + 1) % 3;
      const std::size_t r = (t + 2) % 3;
      for (const double s : {1.0, -1.0}) {
        const auto on_edge = [&](int k) {
          Vector q{};
          q[p] = 1.0;
          q[r] = s;
          q[t] = place(k);
          return q;
        };
        std::vector<double> power;
        for (int k = 0; k <= n_; ++k) power.push_back(seen(p, on_edge(k)).at[0]);
        const Spline spline(power, seen(p, on_edge(0)).slope(t), seen(p, on_edge(n_)).slope(t), step());
        for (Corner& corner : corners) {
          if (corner.q[p] * corner.q[r] == s)
            corner.second[t] = corner.q[p] * corner.q[t] < 0.0 ? spline.second.front() : spline.second.back();
        }
        for (int k = 1; k < n_; ++k) {
          const auto i = static_cast<std::size_t>(k);
          const double tau = place(k);
          const Seen one = seen(p, on_edge(k));
          const Seen other = seen(r, on_edge(k));
          // What Euler's identity, and its derivative along the edge, lack: half of it goes to either face.
          const double slope_p = other.sense * other.slope(p);
          const double lost = (power[i] - slope_p - s * one.slope(r) - tau * spline.slope[i]) / 2.0;
          const double left = (other.mixed() + s * one.mixed() + tau * spline.second[i]) / 2.0;
          one.slope(r) += s * lost;
          one.slope(t) = spline.slope[i];
          one.mixed() -= s * left;
          other.slope(p) = other.sense * (slope_p + lost);
          other.slope(t) = other.sense * spline.slope[i];
          other.mixed() -= left;
        }
      }
    }
    // With A = q_a q_b ∂²G/∂q_a∂q_b of the face f, Euler's identity for the three derivatives gives three equations.
    for (const Corner& corner : corners) {
      for (std::size_t f = 0; f < 3; ++f) {
        const std::size_t a = (f + 1) % 3;
        const std::size_t b = (f + 2) % 3;
        seen(f, corner.q).mixed() =
            corner.q[a] * corner.q[b] * (corner.second[f] - corner.second[a] - corner.second[b]) / 2.0;
      }
    }
  }

  int n_;
  std::vector<Node> nodes_;
  double own_error_ = 0.0;
};

}  // namespace

struct PatchTable::Cube final : patch::Shape {
  struct Basis;
  struct Cell;
  struct Value {
    double power;
    Vector slope;
  };

  PatchTableContents facts;  ///< without nodes
  int n;
  std::array<std::vector<Node>, 3> faces;

  explicit Cube(PatchTableContents contents);

  [[nodiscard]] double step() const noexcept { return 2.0 / n; }
  /// What friction factors do to an error of the force.
  [[nodiscard]] double stretch() const noexcept { return std::max({1.0, facts.factors.x, facts.factors.y}); }
  [[nodiscard]] Cell cell(const Vector& q) const noexcept;
  [[nodiscard]] Value at(const Vector& q) const noexcept;
  [[nodiscard]] bool is_convex(const Vector& q) const noexcept;
  [[nodiscard]] double largest_error(const Shape& shape, double enough) const;

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    const Value value = at({twist.vx, twist.vy, twist.omega * moment_ratio});
    return {value.power, {value.slope[0], value.slope[1], value.slope[2] * moment_ratio}, 0.0};
  }
  [[nodiscard]] double error(const PatchTwist&) const noexcept override {
    return facts.checked_error / stretch() + facts.own_error;
  }
  [[nodiscard]] std::shared_ptr<Shape> stretched(double, double) const override {
    throw std::invalid_argument("mx and my of a table are those of its patch: make a table of a patch that has them");
  }
  [[nodiscard]] double nanoseconds() const noexcept override { return 30.0; }
};

/// Hermite's cubics on [0, 1], or a derivative: of the value at 0, the slope at 0, the value at 1 and the slope at 1.
struct PatchTable::Cube::Basis {
  double v0, s0, v1, s1;

  static Basis cubic(double t) noexcept {
    const double r = 1.0 - t;
    return {(1.0 + 2.0 * t) * r * r, t * r * r, t * t * (3.0 - 2.0 * t), -t * t * r};
  }
  static Basis slope(double t) noexcept {
    const double r = 1.0 - t;
    return {-6.0 * t * r, r * (1.0 - 3.0 * t), 6.0 * t * r, t * (3.0 * t - 2.0)};
  }
  static Basis curvature(double t) noexcept { return {12.0 * t - 6.0, 6.0 * t - 4.0, 6.0 - 12.0 * t, 6.0 * t - 2.0}; }
};

/// The cell that q is in, and the place there.
struct PatchTable::Cube::Cell {
  std::size_t f, a, b;  ///< the face, and the axes of its coordinates
  double x, y;
  const Node* low;
  const Node* high;
  double u, v;

  [[nodiscard]] double operator()(const Basis& along_u, const Basis& along_v) const noexcept {
    const auto values = [&](const Node* at) {
      return along_v.v0 * at[0][0] + along_v.s0 * at[0][2] + along_v.v1 * at[1][0] + along_v.s1 * at[1][2];
    };
    const auto slopes = [&](const Node* at) {
      return along_v.v0 * at[0][1] + along_v.s0 * at[0][3] + along_v.v1 * at[1][1] + along_v.s1 * at[1][3];
    };
    return along_u.v0 * values(low) + along_u.s0 * slopes(low) + along_u.v1 * values(high) + along_u.s1 * slopes(high);
  }
};

PatchTable::Cube::Cell PatchTable::Cube::cell(const Vector& q) const noexcept {
  const Vector size{std::fabs(q[0]), std::fabs(q[1]), std::fabs(q[2])};
  // Without branches: which face is chance.
  const auto of_slides = static_cast<std::size_t>(size[1] > size[0]);
  const std::size_t f = size[2] > std::max(size[0], size[1]) ? 2 : of_slides;
  constexpr std::array<std::size_t, 5> next{0, 1, 2, 0, 1};
  const std::size_t a = next[f + 1];
  const std::size_t b = next[f + 2];
  const double inverse = 1.0 / q[f];
  const double x = q[a] * inverse;
  const double y = q[b] * inverse;
  const double px = (x + 1.0) * 0.5 * n;
  const double py = (y + 1.0) * 0.5 * n;
  const int i = std::min(static_cast<int>(px), n - 1);
  const int j = std::min(static_cast<int>(py), n - 1);
  const Node* low = faces[f].data() + static_cast<std::ptrdiff_t>(i) * (n + 1) + j;
  return {f, a, b, x, y, low, low + n + 1, px - i, py - j};
}

PatchTable::Cube::Value PatchTable::Cube::at(const Vector& q) const noexcept {
  const Cell in = cell(q);
  const Basis cu = Basis::cubic(in.u);
  const Basis cv = Basis::cubic(in.v);
  const double h = in(cu, cv);
  const double hx = 0.5 * n * in(Basis::slope(in.u), cv);
  const double hy = 0.5 * n * in(cu, Basis::slope(in.v));
  const double sense = std::copysign(1.0, q[in.f]);
  Value result{std::fabs(q[in.f]) * h, {}};
  result.slope[in.a] = sense * hx;
  result.slope[in.b] = sense * hy;
  result.slope[in.f] = sense * (h - in.x * hx - in.y * hy);
  return result;
}

bool PatchTable::Cube::is_convex(const Vector& q) const noexcept {
  const Cell in = cell(q);
  const double xx = in(Basis::curvature(in.u), Basis::cubic(in.v));
  const double xy = in(Basis::slope(in.u), Basis::slope(in.v));
  const double yy = in(Basis::cubic(in.u), Basis::curvature(in.v));
  constexpr double rounding = 1e-14;
  return xx >= -rounding && yy >= -rounding && xx * yy - xy * xy >= -rounding * (xx + yy + rounding);
}

PatchTable::Cube::Cube(PatchTableContents contents) : facts(std::move(contents)), n(facts.cells) {
  centre = {facts.factors.y * facts.centre.x, facts.factors.x * facts.centre.y};  // of the stretched patch
  radius = facts.radius;
  moment_ratio = facts.moment_ratio;
  const std::size_t size = nodes_of_a_face(n);
  for (std::size_t f = 0; f < 3; ++f) {
    const Node* first = facts.nodes.data() + f * size;
    faces[f].assign(first, first + size);
  }
  facts.nodes.clear();
}

double PatchTable::Cube::largest_error(const Shape& shape, double enough) const {
  const Support support{shape};
  struct Peak {
    Vector q;
    double error;
  };
  const auto peak_at = [&](const Vector& q) -> Peak {
    const auto [power, slope] = support(q);
    const Vector mine = at(q).slope;
    return {q, std::max(std::hypot(slope[0] - mine[0], slope[1] - mine[1]), std::fabs(slope[2] - mine[2]))};
  };
  // Wide cells need more samples to meet a narrow peak.
  const int samples = std::max(5, 128 / n);
  const double pitch = step() / samples;
  std::vector<std::pair<std::size_t, Peak>> peaks;
  double worst = 0.0;
  for (std::size_t f = 0; f < 3; ++f) {
    const auto place = [f](double x, double y) {
      Vector q{};
      q[f] = 1.0;
      q[(f + 1) % 3] = x;
      q[(f + 2) % 3] = y;
      return q;
    };
    for (int cell = 0; cell < n * n; ++cell) {
      if (cell % n == 0) let_interrupt();
      const int row = cell / n;
      const double x = -1.0 + row * step();
      const double y = -1.0 + (cell % n) * step();
      Peak highest{{}, -1.0};
      for (int k = 0; k < samples * samples; ++k) {
        const int i = k / samples;
        const int j = k % samples;
        const Peak one = peak_at(place(x + (i + 0.5) * pitch, y + (j + 0.45) * pitch));
        if (one.error > highest.error) highest = one;
        // Where curvature is least is often a corner of the cell.
        const double wide = step() / (samples - 1) * (1.0 - 1e-9);
        if (!is_convex(place(x + i * wide, y + j * wide))) return infinity;
      }
      worst = std::max(worst, highest.error);
      if (!(worst <= enough)) return worst;
      peaks.emplace_back(f, highest);
    }
  }
  // Climbs from the highest sample of each cell that may have the largest error, across borders and edges, too.
  constexpr double promising = 0.5;
  std::erase_if(peaks, [&](const auto& peak) { return peak.second.error < promising * worst; });
  for (auto& [f, peak] : peaks) {
    let_interrupt();
    for (double reach = 0.5 * pitch; reach > 0.004 * step();) {
      Peak best = peak;
      for (const std::size_t axis : {(f + 1) % 3, (f + 2) % 3}) {
        for (const double way : {-reach, reach}) {
          Vector q = peak.q;
          q[axis] += way;
          if (const Peak next = peak_at(q); next.error > best.error) best = next;
        }
      }
      if (!(best.error > peak.error)) reach *= 0.5;
      peak = best;
    }
    worst = std::max(worst, peak.error);
    if (!(worst <= enough)) return worst;
  }
  return worst;
}

PatchTable::PatchTable(std::shared_ptr<const Cube> cube)
    : Patch(cube, cube->facts.factors.x, cube->facts.factors.y, cube->facts.centre, cube->radius),
      cube_(std::move(cube)) {}

PatchTable::PatchTable(PatchTableContents contents)
    : PatchTable([&] {
        const int n = contents.cells;
        if (n < 2 || n % 2 != 0 || contents.nodes.size() != 3 * nodes_of_a_face(n))
          throw std::invalid_argument("got " + std::to_string(contents.nodes.size()) + " nodes for " +
                                      std::to_string(n) + " cells along a side, expected 3 (n + 1)^2, n even");
        for (const auto& [name, number] : numbers_of(contents)) {
          const bool is_size = number == &contents.radius || number == &contents.moment_ratio ||
                               number == &contents.factors.x || number == &contents.factors.y;
          const bool is_place = number == &contents.centre.x || number == &contents.centre.y;
          if (!std::isfinite(*number) || !(is_place || *number > 0.0 || (*number == 0.0 && !is_size)))
            throw out_of_range(name, *number, "1",
                               is_place  ? "finite"
                               : is_size ? "> 0 and finite"
                                         : ">= 0 and finite");
        }
        for (const Node& node : contents.nodes) {
          for (const double number : node) {
            if (!std::isfinite(number) || !(node[0] > 0.0))
              throw std::invalid_argument("a node with the power " + format_number(node[0]) +
                                          ", expected finite numbers and a power > 0");
          }
        }
        return std::make_shared<const Cube>(std::move(contents));
      }()) {}

PatchTable PatchTable::build(const Patch& patch, double tolerance, std::string_view name) {
  constexpr double least = 1e-5;
  constexpr double most = 0.1;
  if (!(tolerance >= least && tolerance <= most))
    throw out_of_range("tolerance", tolerance, "1", "1e-5 <= tolerance <= 0.1");
  const patch::Shape& shape = *patch.shape_;
  PatchTableContents contents;
  contents.name = name;
  contents.tolerance = tolerance;
  contents.centre = patch.centre();
  contents.radius = patch.radius();
  contents.moment_ratio = shape.moment_ratio;
  contents.factors = patch.factors();
  constexpr double margin = 1.05;
  const auto made = [&](int n, double enough) {
    Grid grid(shape, n);
    contents.cells = n;
    contents.own_error = grid.own_error();
    contents.nodes = std::move(grid).nodes();
    auto cube = std::make_shared<Cube>(contents);
    const double factor = margin * cube->stretch();
    cube->facts.checked_error = factor * cube->largest_error(shape, enough / factor);
    return cube;
  };
  double finest = infinity;
  int cells = 0;
  if (shape.moment_ratio > 0.0) {
    for (const int n : cells_of_a_side) {
      if (auto cube = made(n, tolerance); cube->facts.checked_error <= tolerance) return PatchTable(std::move(cube));
    }
    for (auto n = cells_of_a_side.rbegin(); n != cells_of_a_side.rend(); ++n) {
      const double found = made(*n, finest)->facts.checked_error;
      if (found < finest) finest = found, cells = *n;
    }
  }
  constexpr double rounding = 1.006;  // to three digits
  throw out_of_range(
      "tolerance", tolerance, "1",
      finest <= most
          ? format_number(rounding * finest, 3) + " or more for " + contents.name +
                (cells == cells_of_a_side.back() ? " in 2 MiB" : ", whose kinks or coarse pixels allow no less") +
                ", or use the patch itself"
          : "a patch without kinks. Use " + contents.name + " itself, not a table");
}

const std::string& PatchTable::name() const noexcept {
  return cube_->facts.name;
}
double PatchTable::tolerance() const noexcept {
  return cube_->facts.tolerance;
}
double PatchTable::checked_error() const noexcept {
  return cube_->facts.checked_error;
}
std::size_t PatchTable::bytes() const noexcept {
  return 3 * cube_->faces[0].size() * sizeof(Node);
}

PatchTableContents PatchTable::contents() const {
  PatchTableContents contents = cube_->facts;
  for (const std::vector<Node>& face : cube_->faces)
    contents.nodes.insert(contents.nodes.end(), face.begin(), face.end());
  return contents;
}

}  // namespace limitcurve
