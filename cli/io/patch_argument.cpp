// SPDX-License-Identifier: MIT
#include "cli/io/patch_argument.hpp"

#include "cli/io/csv_reader.hpp"
#include "cli/io/key_values.hpp"
#include "cli/io/law_argument.hpp"
#include "cli/io/number_list.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

namespace {

constexpr std::string_view expected_kinds =
    "expected points:FILE.csv, polygon:FILE.csv, rectangle:x=…,y=…, ellipse:law=…,a=…,b=… or image:FILE.csv,pixel=…, each with "
    "[,mx=…,my=…]";

std::vector<KeyValue> with_factors(std::vector<KeyValue> keys, PatchArgument& patch) {
  keys.push_back(number_key("mx", patch.mx, positive, false));
  keys.push_back(number_key("my", patch.my, positive, false));
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

/// All numbers of a file with these columns.
void read_columns(PatchArgument& patch, const std::vector<std::string>& columns) {
  CsvReader reader(patch.file, columns);
  patch.columns = columns.size();
  while (reader.next()) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      patch.numbers.push_back(reader.number(i, columns[i] == "load" ? non_negative : finite));
  }
}

void read_pixels(PatchArgument& patch) {
  CsvReader reader(patch.file);
  while (reader.next()) {
    patch.columns = reader.field_count();
    for (std::size_t column = 0; column < patch.columns; ++column) {
      std::string_view text = reader.text(column);
      text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
      text = text.substr(0, text.find_last_not_of(" \t") + 1);
      const bool has_sensor = !text.empty() && text != "B" && text != "nan" && text != "NaN";
      patch.numbers.push_back(has_sensor ? reader.number(column, non_negative) : 0.0);
      if (!has_sensor) ++patch.without_sensor;
    }
  }
}

/// `0.0005`, or `0.004x0.005`: along x and along y.
void read_pixel(std::string_view text, PatchArgument& patch) {
  const std::size_t times = text.find('x');
  patch.x = read_number(text.substr(0, times), positive);
  patch.y = times == std::string_view::npos ? patch.x : read_number(text.substr(times + 1), positive);
}

PatchArgument parse(std::string_view kind, std::string_view rest) {
  PatchArgument patch{std::string(kind)};
  std::string_view items;
  if (kind == "points" || kind == "polygon") {
    patch.file = split_file(rest, items);
    read_items(items, with_factors({}, patch));
    read_columns(patch, kind == "points" ? std::vector<std::string>{"x", "y", "load"} : std::vector<std::string>{"x", "y"});
  } else if (kind == "image") {
    patch.file = split_file(rest, items);
    read_items(items, with_factors({{"pixel", [&](std::string_view text) { read_pixel(text, patch); }, true, "SIDE or XxY"}}, patch));
    read_pixels(patch);
  } else if (kind == "rectangle") {
    read_items(rest, with_factors({number_key("x", patch.x, positive), number_key("y", patch.y, positive)}, patch));
  } else if (kind == "ellipse") {
    const auto take_law = [&patch](std::string_view text) {
      patch.law = text;
      patch.profile.clear();
      read_law(patch.law, patch.profile);
    };
    read_items(rest, with_factors({{"law", take_law, true, "LAW"}, number_key("a", patch.x, positive), number_key("b", patch.y, positive)},
                                  patch));
  } else {
    refuse_kind(kind, ':' + std::string(rest));
  }
  return patch;
}

/// Calls `work`, whose errors get a prefix.
template <class Work>
auto with_prefix(const std::string& prefix, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(prefix + error.what());
  }
}

std::string in_quotes(const std::string& text) {
  return text.empty() ? text : "patch '" + text + "': ";
}

}  // namespace

Patch PatchArgument::patch() const {
  const auto row = [this](std::size_t i) { return numbers.data() + i * columns; };
  const std::size_t rows = columns == 0 ? 0 : numbers.size() / columns;
  const auto made = [&]() -> Patch {
    if (kind == "rectangle") return Patch::rectangle(x, y);
    if (kind == "ellipse") return Patch::ellipse(law_of(law, profile), x, y);
    if (kind == "image") return Patch::image(numbers, columns, x, y);
    if (kind == "polygon") {
      std::vector<PatchPoint> vertices;
      for (std::size_t i = 0; i < rows; ++i) vertices.push_back({row(i)[0], row(i)[1]});
      return Patch::polygon(vertices);
    }
    std::vector<PatchLoad> points;
    for (std::size_t i = 0; i < rows; ++i) points.push_back({row(i)[0], row(i)[1], row(i)[2]});
    return Patch::points(points);
  };
  return with_prefix(in_quotes(text), [&] {
    const Patch patch = with_prefix(file.empty() ? file : file + ": ", made);
    return patch.orthotropic(mx, my);
  });
}

std::string PatchArgument::note() const {
  if (without_sensor == 0) return {};
  return (file.empty() ? "pressures" : file) + ": " + std::to_string(without_sensor) + " of " + std::to_string(numbers.size()) +
         " pixels have no sensor, and count as without pressure";
}

PatchArgument parse_patch(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string_view all = text;
  return with_prefix(in_quotes(text), [&] {
    if (colon == std::string::npos) refuse_kind(all, {});
    PatchArgument patch = parse(all.substr(0, colon), all.substr(colon + 1));
    patch.text = text;
    return patch;
  });
}

Patch read_patch(const std::string& text, Messages* messages) {
  const PatchArgument argument = parse_patch(text);
  if (messages != nullptr && !argument.note().empty()) messages->say("limitcurve: note: " + argument.note());
  return argument.patch();
}

void read_twists(const std::string& file, const std::function<void(const PatchTwist&)>& take) {
  CsvReader reader(file, {"vx", "vy", "omega"});
  while (reader.next()) take({reader.number(0, finite), reader.number(1, finite), reader.number(2, finite)});
}

}  // namespace limitcurve::cli
