// SPDX-License-Identifier: MIT
#include "cli/io/patch_argument.hpp"

#include "cli/io/csv_reader.hpp"
#include "cli/io/key_values.hpp"
#include "cli/io/law_argument.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/pressure_law.hpp"

#include <stdexcept>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

namespace {

constexpr std::string_view expected_kinds =
    "expected points:FILE.csv, polygon:FILE.csv, rectangle:x=…,y=…, ellipse:law=…,a=…,b=… or image:FILE.csv,pixel=…, each with "
    "[,mx=…,my=…]";

struct Factors {
  double x = 1.0;
  double y = 1.0;
};

std::vector<KeyValue> with_factors(std::vector<KeyValue> keys, Factors& factors) {
  keys.push_back(number_key("mx", factors.x, positive, false));
  keys.push_back(number_key("my", factors.y, positive, false));
  return keys;
}

/// Throws for a patch of an unknown kind, or without a colon; `after` follows the word that was meant.
[[noreturn]] void refuse_kind(std::string_view kind, std::string_view after) {
  throw std::invalid_argument(std::string(expected_kinds) +
                              did_you_mean(kind, {"points", "polygon", "rectangle", "ellipse", "image"}, after));
}

/// Splits a text into a file name and the key=value items after it.
std::string split_file(std::string_view text, std::string_view& items) {
  // Starts at the end because the name may contain commas.
  std::size_t end = text.size();
  for (;;) {
    const std::size_t comma = text.substr(0, end).rfind(',');
    if (comma == std::string_view::npos || text.substr(comma, end - comma).find('=') == std::string_view::npos) break;
    end = comma;
  }
  items = end == text.size() ? std::string_view{} : text.substr(end + 1);
  if (end == 0) throw std::invalid_argument("no file name, " + std::string(expected_kinds));
  return std::string(text.substr(0, end));
}

void read_items(std::string_view items, const std::vector<KeyValue>& keys) {
  bool required = false;
  for (const KeyValue& key : keys) required = required || key.required;
  if (!items.empty() || required) read_key_values(items, keys);
}

/// Adds the file's name to an error of the library.
template <class Make>
Patch from_file(const std::string& file, const Make& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(file + ": " + error.what());
  }
}

Patch read_points(const std::string& file) {
  std::vector<PatchLoad> loads;
  CsvReader reader(file, {"x", "y", "load"});
  while (reader.next()) loads.push_back({reader.number(0, finite), reader.number(1, finite), reader.number(2, non_negative)});
  return from_file(file, [&] { return Patch::points(loads); });
}

Patch read_polygon(const std::string& file) {
  std::vector<PatchPoint> vertices;
  CsvReader reader(file, {"x", "y"});
  while (reader.next()) vertices.push_back({reader.number(0, finite), reader.number(1, finite)});
  return from_file(file, [&] { return Patch::polygon(vertices); });
}

Patch read_image(const std::string& file, double pixel) {
  std::vector<double> pressures;
  CsvReader reader(file);
  while (reader.next()) {
    for (std::size_t column = 0; column < reader.field_count(); ++column) pressures.push_back(reader.number(column, non_negative));
  }
  return from_file(file, [&] { return Patch::image(pressures, reader.field_count(), pixel); });
}

Patch read_plain(std::string_view kind, std::string_view rest, Factors& factors) {
  std::string_view items;
  if (kind == "points" || kind == "polygon") {
    const std::string file = split_file(rest, items);
    read_items(items, with_factors({}, factors));
    return kind == "points" ? read_points(file) : read_polygon(file);
  }
  if (kind == "image") {
    double pixel = 0.0;
    const std::string file = split_file(rest, items);
    read_items(items, with_factors({number_key("pixel", pixel, positive)}, factors));
    return read_image(file, pixel);
  }
  if (kind == "rectangle") {
    double x = 0.0;
    double y = 0.0;
    read_items(rest, with_factors({number_key("x", x, positive), number_key("y", y, positive)}, factors));
    return Patch::rectangle(x, y);
  }
  if (kind == "ellipse") {
    Law law;
    double a = 0.0;
    double b = 0.0;
    const KeyValue law_key{"law", [&law](std::string_view text) { law = read_law(std::string(text)); }, true, "LAW"};
    read_items(rest, with_factors({law_key, number_key("a", a, positive), number_key("b", b, positive)}, factors));
    return Patch::ellipse(law, a, b);
  }
  refuse_kind(kind, ':' + std::string(rest));
}

}  // namespace

Patch read_patch(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string_view all = text;
  try {
    if (colon == std::string::npos) refuse_kind(all, {});
    Factors factors;
    const Patch patch = read_plain(all.substr(0, colon), all.substr(colon + 1), factors);
    return patch.orthotropic(factors.x, factors.y);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("patch '" + text + "': " + error.what());
  }
}

void read_twists(const std::string& file, const std::function<void(const PatchTwist&)>& take) {
  CsvReader reader(file, {"vx", "vy", "omega"});
  while (reader.next()) take({reader.number(0, finite), reader.number(1, finite), reader.number(2, finite)});
}

}  // namespace limitcurve::cli
