// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/measured/signed_noise.hpp"
#include "limitcurve/patch/point_sums.hpp"
#include "limitcurve/patch/polygon_edge.hpp"
#include "limitcurve/patch/shape.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace limitcurve::patch {

namespace {

/// ⟨|y|⟩, ⟨ŷ⟩ and ⟨x·ŷ⟩ of a uniform rectangle of sides hx, hy about 0 with its COR at c (formulae: polygon.cpp).
struct RectangleMeans {
  double distance = 0.0;
  PatchPoint direction;
  double moment = 0.0;
};

RectangleMeans rectangle_means(double hx, double hy, PatchPoint c) noexcept {
  const double right = 0.5 * hx - c.x;
  const double left = 0.5 * hx + c.x;
  const double top = 0.5 * hy - c.y;
  const double bottom = 0.5 * hy + c.y;
  const double right_top = std::hypot(right, top);
  const double left_top = std::hypot(left, top);
  const double right_bottom = std::hypot(right, bottom);
  const double left_bottom = std::hypot(left, bottom);
  const double j_right = edge_integral(right_bottom, right_top, hy, -2.0 * c.y, right);
  const double j_left = edge_integral(left_top, left_bottom, hy, 2.0 * c.y, left);
  const double j_top = edge_integral(right_top, left_top, hx, 2.0 * c.x, top);
  const double j_bottom = edge_integral(left_bottom, right_bottom, hx, -2.0 * c.x, bottom);
  const double area = hx * hy;
  const PatchPoint direction{(j_right - j_left) / area, (j_top - j_bottom) / area};
  const double distance = (right * j_right + left * j_left + top * j_top + bottom * j_bottom) / (3.0 * area);
  return {distance, direction, distance + c.x * direction.x + c.y * direction.y};
}

/// Σ w √(|u|² + ω²V) and its gradient. V = (h_x²u_x² + h_y²u_y²)/(12|u|²) is the second moment of a rectangle of sides
/// h_x, h_y across the direction of sliding. Not for a rectangle near the COR.
PatchFriction sum_rectangles(const double* xs, const double* ys, const double* weights, std::size_t count,
                             const PatchTwist& twist, double hx, double hy) noexcept {
  const double a = twist.omega * twist.omega * hx * hx / 12.0;
  const double b = twist.omega * twist.omega * hy * hy / 12.0;
  PatchFriction sum;
  for (std::size_t i = 0; i < count; ++i) {
    const double ux = twist.vx - twist.omega * ys[i];
    const double uy = twist.vy + twist.omega * xs[i];
    const double square = ux * ux + uy * uy;
    const double second = (a * ux * ux + b * uy * uy) / square;
    const double length = std::sqrt(square + second);
    const double fraction = weights[i] / length;
    const double fx = fraction * ux * (1.0 + (a - second) / square);
    const double fy = fraction * uy * (1.0 + (b - second) / square);
    sum.power += weights[i] * length;
    sum.wrench.fx += fx;
    sum.wrench.fy += fy;
    sum.wrench.moment += xs[i] * fy - ys[i] * fx + fraction * second / twist.omega;
  }
  return sum;
}

/// Pixels: squares of constant pressure, rectangles if stretched. Next to the COR they are integrated exactly. All
/// others are points with the square's second moment across the direction of sliding, w√(|u|² + ω²h²/12), whose error
/// is of fourth order in side/distance.
struct Image final : Shape {
  std::vector<double> loads;  ///< of all pixels, rows from the largest y, scaled to sum 1
  std::size_t columns;
  std::size_t rows;
  double side_x;
  double side_y;
  std::vector<double> xs;  ///< middles of the pixels under pressure, from the centre of pressure
  std::vector<double> ys;
  std::vector<double> weights;
  std::vector<std::size_t> before;  ///< how many of them precede each pixel
  PatchPoint corner;                ///< of the image: least x, largest y, from the centre of pressure
  std::vector<std::string> notes;

  Image(std::vector<double> pixel_loads, std::size_t width, double hx, double hy, std::vector<std::string> lines)
      : loads(std::move(pixel_loads)),
        columns(width),
        rows(loads.size() / width),
        side_x(hx),
        side_y(hy),
        notes(std::move(lines)) {
    Extended mean_column = 0;
    Extended mean_row = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const std::size_t row = i / columns;
      mean_column += Extended(loads[i]) * static_cast<Extended>(i % columns);
      mean_row += Extended(loads[i]) * static_cast<Extended>(row);
    }
    corner = {static_cast<double>(-(mean_column + 0.5L) * side_x), static_cast<double>((mean_row + 0.5L) * side_y)};
    for (std::size_t i = 0; i < loads.size(); ++i) {
      before.push_back(xs.size());
      if (loads[i] == 0.0) continue;
      const std::size_t row = i / columns;
      xs.push_back(static_cast<double>((static_cast<Extended>(i % columns) - mean_column) * side_x));
      ys.push_back(static_cast<double>((mean_row - static_cast<Extended>(row)) * side_y));
      weights.push_back(loads[i]);
      radius = std::max(radius, std::hypot(std::fabs(xs.back()) + 0.5 * side_x, std::fabs(ys.back()) + 0.5 * side_y));
    }
    before.push_back(xs.size());
    measure_moment_ratio();
  }

  /// ε² of a pixel: the square's second moment about its middle; for a stretched pixel the mean of both directions.
  [[nodiscard]] double softness() const noexcept { return (side_x * side_x + side_y * side_y) / 24.0; }

  /// The pixels from `first` to before `last` as points with a second moment.
  [[nodiscard]] PatchFriction sum_points(std::size_t first, std::size_t last, const PatchTwist& twist) const noexcept {
    const double* x = xs.data() + first;
    const double* y = ys.data() + first;
    const double* weight = weights.data() + first;
    if (side_x != side_y) return sum_rectangles(x, y, weight, last - first, twist, side_x, side_y);
    return sum_soft_points(x, y, weight, last - first, twist, softness() * twist.omega * twist.omega);
  }

  /// How many pixels on either side of the COR's count as near: those within the longer side.
  [[nodiscard]] double near_columns() const noexcept { return std::ceil(std::max(side_x, side_y) / side_x); }
  [[nodiscard]] double near_rows() const noexcept { return std::ceil(std::max(side_x, side_y) / side_y); }

  /// Splits the pixels under pressure, once for all that is summed: calls `near(i)` for each near the COR, and
  /// `far(first, last)` for the runs of the others.
  template <class Near, class Far>
  void split(PatchPoint cor, const Near& near, const Far& far) const noexcept {
    const double column = std::floor((cor.x - corner.x) / side_x);
    const double row = std::floor((corner.y - cor.y) / side_y);
    const auto within = [](double index, std::size_t count) {
      return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count)));
    };
    const std::size_t left = within(column - near_columns(), columns);
    const std::size_t right = within(column + near_columns() + 1.0, columns);
    const std::size_t bottom = within(row + near_rows() + 1.0, rows);
    std::size_t run = 0;
    for (std::size_t r = within(row - near_rows(), rows); r < bottom; ++r) {
      const std::size_t first = before[r * columns + left];
      const std::size_t last = before[r * columns + right];
      far(run, first);
      for (std::size_t i = first; i < last; ++i) near(i);
      run = last;
    }
    far(run, xs.size());
  }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    if (only_slides(twist, radius)) return sliding(twist);
    const PatchPoint cor{-twist.vy / twist.omega, twist.vx / twist.omega};
    PatchFriction friction;
    const auto add = [&](double load, const PatchFriction& part) {
      friction.power += load * part.power;
      friction.wrench.fx += load * part.wrench.fx;
      friction.wrench.fy += load * part.wrench.fy;
      friction.wrench.moment += load * part.wrench.moment;
    };
    const auto add_near = [&](std::size_t i) {
      const RectangleMeans means = rectangle_means(side_x, side_y, {cor.x - xs[i], cor.y - ys[i]});
      PatchFriction pixel = from_distance(twist.omega, means.distance, means.direction, means.moment);
      pixel.wrench.moment += xs[i] * pixel.wrench.fy - ys[i] * pixel.wrench.fx;
      add(weights[i], pixel);
    };
    split(cor, add_near, [&](std::size_t first, std::size_t last) { add(1.0, sum_points(first, last, twist)); });
    return friction;
  }

  /// Sums the error of each pixel's force, from fourth moments, and of its moment, with the lever.
  [[nodiscard]] double error(const PatchTwist& twist) const noexcept override {
    // The closed form of a slim pixel near the COR loses digits in the ratio of its sides.
    const double slim = std::max(side_x, side_y) / std::min(side_x, side_y) - 1.0;
    const double terms = 8.0 + static_cast<double>(xs.size()) / 8.0 + 4.0 * slim;
    const double rounding = terms * epsilon * (1.0 + radius / moment_ratio);
    if (only_slides(twist, radius)) return rounding;
    const PatchPoint cor{-twist.vy / twist.omega, twist.vx / twist.omega};
    const double square = std::max(side_x, side_y) * std::max(side_x, side_y);
    double bound = 0.0;
    // Not hypot, which takes most of the time: lengths of a patch and of a COR that turns it have squares.
    const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
    const auto add_far = [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const double away = length(xs[i] - cor.x, ys[i] - cor.y);
        const double ratio = square / (away * away);
        bound += weights[i] * fourth_order * ratio * ratio * (1.0 + (length(xs[i], ys[i]) + away) / moment_ratio);
      }
    };
    split(
        cor, [](std::size_t) {}, add_far);
    return rounding + bound;
  }
  /// The largest error of a pixel's force times (distance/longer side)⁴, for distances of 1.5 sides or more.
  static constexpr double fourth_order = 0.02;

  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    return std::make_shared<Image>(loads, columns, sx * side_x, sy * side_y, notes);
  }
  [[nodiscard]] std::shared_ptr<Shape> smoothed(double) const override {
    std::vector<PatchLoad> points;
    for (std::size_t i = 0; i < xs.size(); ++i) points.push_back({xs[i], ys[i], weights[i]});
    return make_soft_points(std::move(points), std::sqrt(softness()));
  }
  [[nodiscard]] double area() const override { return static_cast<double>(xs.size()) * side_x * side_y; }
  [[nodiscard]] double nanoseconds() const noexcept override {
    const double near = std::min(2.0 * near_columns() + 1.0, static_cast<double>(columns)) *
                        std::min(2.0 * near_rows() + 1.0, static_cast<double>(rows));
    return 30.0 * near + (side_x == side_y ? 1.5 : 8.0) * static_cast<double>(xs.size());
  }
  [[nodiscard]] std::vector<PatchLoad> concentrations() const override {
    std::vector<PatchLoad> middles;
    for (std::size_t i = 0; i < xs.size(); ++i) middles.push_back({xs[i], ys[i], 0.0});
    return middles;
  }
  [[nodiscard]] std::vector<std::string> remarks() const override { return notes; }
};

/// Whether pixel i is in the outer ring, a tenth of each side. A small image has none.
bool in_ring(std::size_t i, std::size_t columns, std::size_t rows) {
  constexpr std::size_t fewest = 8;
  const auto is_outside = [](std::size_t place, std::size_t count) {
    return std::min(place, count - 1 - place) < std::max<std::size_t>(1, count / 10);
  };
  return rows >= fewest && columns >= fewest && (is_outside(i % columns, columns) || is_outside(i / columns, rows));
}

/// What is said if the outer ring is flat above 0, as by an offset of the sensor: its standard deviation is at most a
/// tenth of its level, and of what the highest pixel has more. A contact that the image cuts off varies more.
std::string remark_on_offset(const std::vector<double>& pressures, std::size_t columns) {
  constexpr double least = 0.01;
  constexpr double flat = 0.1;
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    if (!in_ring(i, columns, pressures.size() / columns)) continue;
    ++count;
    sum += pressures[i];
    squares += pressures[i] * pressures[i];
  }
  if (count == 0.0) return {};
  const double level = sum / count;
  const double above = *std::max_element(pressures.begin(), pressures.end()) - level;
  const double most = flat * std::min(level, above);
  if (!(level > least * above && above > least * level && squares / count - level * level <= most * most)) return {};
  return "the outer tenth of the image is flat at " + format_number(level, 5) +
         ": if that is an offset of the sensor, subtract it from all pixels, because floor=P does not";
}

/// What the outer ring says if it carries more than a hundredth of the moment: clean images of a contact carry nothing
/// there, but noise without negative values has a long lever.
std::string remark_on_ring(const std::vector<double>& pressures, std::size_t columns, double width, double height) {
  constexpr double most = 0.01;
  constexpr double cut_off = 0.2;
  const std::size_t rows = pressures.size() / columns;
  const auto x_of = [&](std::size_t i) { return static_cast<double>(i % columns) * width; };
  const auto y_of = [&](std::size_t i) {
    const std::size_t row = i / columns;
    return static_cast<double>(row) * height;
  };
  double load = 0.0;
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    load += pressures[i];
    mean_x += pressures[i] * x_of(i);
    mean_y += pressures[i] * y_of(i);
  }
  double all = 0.0;
  double outside = 0.0;
  double highest = 0.0;
  double at_rim = 0.0;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const double moment = pressures[i] * std::hypot(x_of(i) - mean_x / load, y_of(i) - mean_y / load);
    all += moment;
    if (!in_ring(i, columns, rows)) continue;
    outside += moment;
    highest = std::max(highest, pressures[i]);
    const std::size_t row = i / columns;
    const std::size_t column = i % columns;
    if (row == 0 || row + 1 == rows || column == 0 || column + 1 == columns) at_rim = std::max(at_rim, pressures[i]);
  }
  if (!(outside > most * all)) return {};
  const std::string share = format_number(100.0 * outside / all, 2) + " % of the moment";
  const double least = cut_off * *std::max_element(pressures.begin(), pressures.end());
  if (at_rim > least) return "the pressure reaches the rim, which carries " + share + ": is the contact cut off?";
  if (highest > least) return {};  // a contact that ends just before the rim
  return "the outer tenth of the image carries " + share +
         ": if that is noise or an offset, the moment is too large and "
         "the load that holds too small; set floor=" +
         format_number(1.2 * highest, 2);
}

}  // namespace

std::shared_ptr<Shape> make_image(std::vector<double> pressures, std::size_t columns, double width, double height,
                                  std::optional<double> floor) {
  if (floor && !(*floor >= 0.0)) throw out_of_range("floor", *floor, "1", ">= 0");
  if (columns == 0 || pressures.empty() || pressures.size() % columns != 0) {
    throw std::invalid_argument("an image of " + std::to_string(pressures.size()) + " pixels in rows of " +
                                std::to_string(columns) + ", expected whole rows");
  }
  const auto place = [columns](std::size_t i) {
    return "row " + std::to_string(i / columns + 1) + ", column " + std::to_string(i % columns + 1);
  };
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    if (!std::isfinite(pressures[i]))
      throw std::invalid_argument(place(i) + ": " +
                                  out_of_range("pressure", pressures[i], "1", "a finite number").what());
  }
  std::string ring = remark_on_offset(pressures, columns);
  const SignedNoise noise = remove_noise(pressures, std::vector<double>(pressures.size(), 1.0), place, floor);
  const double highest = *std::max_element(pressures.begin(), pressures.end());
  if (highest == 0.0) {
    throw std::invalid_argument("all " + std::to_string(pressures.size()) +
                                " pixels have pressure 0, expected one of pressure > 0");
  }
  Extended total = 0;
  for (const double pressure : pressures) total += Extended(pressure) / highest;
  std::vector<double> loads;
  for (const double pressure : pressures) loads.push_back(static_cast<double>(Extended(pressure) / highest / total));
  std::vector<std::string> notes;
  if (noise.zeroed > 0) notes.push_back("note: " + noise.text());
  if (ring.empty()) ring = remark_on_ring(pressures, columns, width, height);
  if (!ring.empty()) notes.push_back("warning: " + ring);
  return std::make_shared<Image>(std::move(loads), columns, width, height, std::move(notes));
}

}  // namespace limitcurve::patch
