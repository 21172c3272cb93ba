// SPDX-License-Identifier: MIT
#include "cli/io/patch_argument.hpp"

#include "cli/io/argument_parts.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/law_argument.hpp"
#include "cli/io/table_reader.hpp"
#include "cli/io/unit_checks.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/disc_models.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace limitcurve::cli {

namespace {

constexpr std::string_view expected_kinds =
    "expected points:FILE.csv, polygon:FILE.csv, rectangle:x=…,y=…, ellipse:law=…,a=…,b=… or image:FILE.csv,pixel=…, "
    "each with [,mx=…,my=…], or table:FILE";

std::vector<KeyValue> with_factors(std::vector<KeyValue> keys, PatchArgument& patch) {
  keys.push_back(number_key("mx", patch.mx, positive, false));
  keys.push_back(number_key("my", patch.my, positive, false));
  return keys;
}

/// Throws for a patch of an unknown kind, or without a colon; `after` follows the word that was meant.
[[noreturn]] void refuse_kind(std::string_view kind, std::string_view after) {
  throw std::invalid_argument(
      std::string(expected_kinds) +
      did_you_mean(kind, {"points", "polygon", "rectangle", "ellipse", "image", "table"}, after));
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

/// All numbers of a file with these columns.
void read_columns(PatchArgument& patch, const std::vector<std::string>& columns) {
  CsvReader reader(patch.file, columns);
  patch.columns = columns.size();
  while (reader.next()) {
    if (patch.kind == "polygon" && reader.blank_lines() > 0)
      throw reader.complaint_at(
          0, "a vertex after a blank line, expected one ring; for holes or several parts use image:");
    for (std::size_t i = 0; i < columns.size(); ++i)
      patch.numbers.push_back(reader.number(i, columns[i] == "load" ? non_negative : finite));
  }
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

/// Adds a pixel; `number` reads what is one.
template <class Number>
void add_pixel(PatchArgument& patch, std::string_view text, const Number& number) {
  text = trimmed(text);
  const bool has_sensor = !text.empty() && text != "B" && text != "nan" && text != "NaN";
  patch.numbers.push_back(has_sensor ? number() : 0.0);
  if (!has_sensor) ++patch.without_sensor;
}

/// Tekscan's ASCII files: lines KEY VALUE up to ASCII_DATA, then frames, each a line `Frame N` and its rows, up to
/// `@@`. Takes the sides of a pixel from the header unless they are known, and one frame, which must be named if there
/// are several. False if the file is none.
bool read_tekscan(PatchArgument& patch, std::optional<double> frame) {
  const std::filesystem::path path = descriptor::path_of(patch.file);
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  std::ifstream file(path);
  std::string line;
  std::size_t number = 0;
  const auto next = [&] { return ++number, static_cast<bool>(std::getline(file, line)); };
  if (!next() || !line.starts_with("DATA_TYPE")) return false;
  const auto in_place = [&](const auto& work) {
    return with_prefix(patch.file + ":" + std::to_string(number) + ":1: ", work);
  };
  double row_spacing = patch.y;
  double column_spacing = patch.x;
  const auto spacing = [&](std::string_view value) {
    const std::size_t blank = value.find(' ');
    if (blank == std::string_view::npos || trimmed(value.substr(blank)) != "mm")
      throw std::invalid_argument("got '" + std::string(value) + "', expected a length in mm");
    return 1e-3 * read_number(value.substr(0, blank), positive);
  };
  while (next() && !line.starts_with("ASCII_DATA")) {
    const std::string_view all = trimmed(line);
    const std::string_view value = trimmed(all.substr(std::min(all.find(' '), all.size())));
    if (all.starts_with("ROW_SPACING ") && patch.y == 0.0) row_spacing = in_place([&] { return spacing(value); });
    if (all.starts_with("COL_SPACING ") && patch.x == 0.0) column_spacing = in_place([&] { return spacing(value); });
  }
  patch.x = column_spacing;
  patch.y = row_spacing;
  std::size_t frames = 0;
  bool wanted = false;
  while (next() && !line.starts_with("@@")) {
    const std::string_view all = trimmed(line);
    if (all.starts_with("Frame")) {
      const double index = in_place([&] { return read_number(trimmed(all.substr(5)), finite); });
      wanted = !frame || index == *frame;
      if (wanted && ++frames > 1)
        in_place([] { throw std::invalid_argument("a second frame, expected frame=N, which says the one"); });
    } else if (wanted && !all.empty()) {
      const std::size_t before = patch.numbers.size();
      for (std::size_t begin = 0; begin <= all.size();) {
        const std::size_t end = std::min(all.find(',', begin), all.size());
        const std::string_view text = all.substr(begin, end - begin);
        add_pixel(patch, text, [&] { return in_place([&] { return read_number(trimmed(text), finite); }); });
        begin = end + 1;
      }
      const std::size_t columns = patch.numbers.size() - before;
      if (before > 0 && columns != patch.columns) {
        in_place([&] {
          throw std::invalid_argument(std::to_string(columns) + " pixels, expected " + std::to_string(patch.columns) +
                                      " as in the first row");
        });
      }
      patch.columns = columns;
    }
  }
  if (frames == 0) throw std::invalid_argument(patch.file + ": no frame" + (frame ? " " + format_number(*frame) : ""));
  return true;
}

/// What the file of an image has, beside pixels.
struct ImageFile {
  std::optional<double> frame = {};
  std::optional<double> columns = {};
  double skip = 0.0;  ///< fields of each row before the pixels
};

/// Whether the row that was read is a text such as a header: no number, and no pixel without sensor. Numbers between
/// other separators are no text.
bool is_text(const CsvReader& reader) {
  constexpr std::string_view numeric = "+-.0123456789";
  for (std::size_t column = 0; column < reader.field_count(); ++column) {
    const std::string_view text = reader.text(column);
    if (text.empty() || text == "B" || numeric.find(text.front()) != std::string_view::npos || parse_number(text))
      return false;
  }
  return true;
}

/// The size ROWS,COLUMNS that a first row of two whole numbers may state.
std::optional<std::pair<double, double>> size_in(const CsvReader& reader) {
  constexpr Range whole{1.0, 1e6, "a whole number", true};
  if (reader.field_count() != 2) return std::nullopt;
  const auto rows = parse_number(reader.text(0));
  const auto columns = parse_number(reader.text(1));
  if (!rows || !columns || !whole.contains(*rows) || !whole.contains(*columns) || *rows * *columns == 2.0)
    return std::nullopt;
  return std::pair(*rows, *columns);
}

/// With `columns`, or a first row with the size, each row of the file is a frame, flattened, of which `frame` selects
/// one, counted from 1.
void read_pixels(PatchArgument& patch, ImageFile of) {
  if (!of.columns && read_tekscan(patch, of.frame)) return;
  CsvReader reader(patch.file);
  std::size_t row = 0;
  std::size_t texts = 0;
  const auto skip = static_cast<std::size_t>(of.skip);
  std::optional<std::pair<double, double>> size;
  while (reader.next()) {
    if (row == 0 && is_text(reader)) {
      ++texts;
      reader.restart();
      continue;
    }
    if (row == 0 && !size && (size = size_in(reader))) {
      if (size->second != 2.0 && reader.next_fields() == static_cast<std::size_t>(size->second) + skip) {
        patch.notes.emplace_back("the first row, the image's size, is no row of pixels");
        reader.restart();
        continue;
      }
      const double pixels = size->first * size->second;
      if (reader.next_fields() == static_cast<std::size_t>(pixels) + skip) {
        if (of.columns.value_or(size->second) != size->second)
          throw reader.complaint(0, "the size is " + format_number(size->first) + "," + format_number(size->second) +
                                        ", got columns=" + format_number(*of.columns));
        of.columns = size->second;
        patch.notes.emplace_back("the first row, " + format_number(size->first) + "," + format_number(size->second) +
                                 ", is the size of a frame");
        reader.restart();
        continue;
      }
    }
    ++row;
    if (of.frame && !of.columns)
      throw std::invalid_argument(
          "frame: only with columns=N, or for a file of Tekscan's, which begins with DATA_TYPE");
    if (of.columns && of.frame && static_cast<double>(row) != *of.frame) continue;
    if (skip >= reader.field_count())
      throw reader.complaint(0, "a row of " + std::to_string(reader.field_count()) + " fields, skip leaves none");
    const std::size_t pixels = reader.field_count() - skip;
    patch.columns = of.columns ? static_cast<std::size_t>(*of.columns) : pixels;
    if (of.columns && (pixels % patch.columns != 0 || pixels == patch.columns)) {
      throw reader.complaint(0, "a row of " + std::to_string(pixels) + " pixels, expected a frame of several rows of " +
                                    std::to_string(patch.columns) +
                                    (pixels % patch.columns == 1 ? "; is the first a time? skip=1 leaves it out" : ""));
    }
    if (of.columns && !patch.numbers.empty())
      throw reader.complaint(0, "a second frame, expected frame=N, which says the one, counted from 1");
    for (std::size_t column = skip; column < reader.field_count(); ++column)
      add_pixel(patch, reader.text(column), [&] { return reader.number(column, finite); });
    patch.frames_in_blocks = !of.columns && reader.blank_lines() > 0;
  }
  if (texts > 0) patch.notes.push_back(std::to_string(texts) + (texts == 1 ? " row" : " rows") + " of text skipped");
  if (patch.numbers.empty())
    throw std::invalid_argument(patch.file + ": no frame " + format_number(of.frame.value_or(1.0)) + " of " +
                                std::to_string(row) + ", counted from 1");
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
    patch.file = split_file(kind, rest, items);
    read_key_values(items, with_factors({}, patch));
    read_columns(patch,
                 kind == "points" ? std::vector<std::string>{"x", "y", "load"} : std::vector<std::string>{"x", "y"});
  } else if (kind == "image") {
    patch.file = split_file(kind, rest, items);
    ImageFile of;
    const auto take_frame = [&](std::string_view text) { of.frame = read_number(text, finite); };
    const auto take_columns = [&](std::string_view text) {
      of.columns = read_number(text, Range{1.0, 1e6, "a whole number from 1", true});
    };
    const auto take_floor = [&](std::string_view text) { patch.floor = read_number(text, non_negative); };
    read_key_values(
        items, with_factors({{"pixel", [&](std::string_view text) { read_pixel(text, patch); }, false, "SIDE or XxY"},
                             {"columns", take_columns, false, "N"},
                             {"frame", take_frame, false, "N"},
                             number_key("skip", of.skip, Range{0.0, 1e6, "a whole number", true}, false),
                             {"floor", take_floor, false, "P"}},
                            patch));
    read_pixels(patch, of);
    if (patch.x == 0.0 || patch.y == 0.0) throw std::invalid_argument("no pixel=…, expected the sides of a pixel [m]");
  } else if (kind == "rectangle") {
    read_key_values(rest,
                    with_factors({number_key("x", patch.x, positive), number_key("y", patch.y, positive)}, patch));
  } else if (kind == "ellipse") {
    double rim = 0.0;
    const auto take_law = [&patch](std::string_view text) { patch.law = text; };
    read_key_values(rest, with_factors({{"law", take_law, true, "LAW"},
                                        number_key("a", patch.x, positive),
                                        number_key("b", patch.y, positive),
                                        number_key("rim", rim, positive, false)},
                                       patch));
    if (rim > 0.0) patch.law += ",rim=" + format_number(rim);
    with_prefix("'law' in '" + std::string(rest) + "': ", [&] { return read_law(patch.law, patch.profile); });
  } else if (kind == "table") {
    patch.file = split_file(kind, rest, items);
    read_key_values(items, with_factors({}, patch));
    patch.table = read_patch_table(patch.file);
  } else {
    refuse_kind(kind, ':' + std::string(rest));
  }
  return patch;
}

std::string in_quotes(const std::string& text) {
  return text.empty() ? text : "patch '" + text + "': ";
}

}  // namespace

Patch PatchArgument::patch() const {
  const auto row = [this](std::size_t i) { return numbers.data() + i * columns; };
  const std::size_t rows = columns == 0 ? 0 : numbers.size() / columns;
  const auto made = [&]() -> Patch {
    if (table) return *table;
    if (kind == "rectangle") return Patch::rectangle(x, y);
    if (kind == "ellipse") return Patch::ellipse(law_of(law, profile), x, y);
    if (kind == "image") return Patch::image(numbers, columns, x, y, floor);
    if (kind == "polygon") {
      std::vector<PatchPoint> vertices;
      for (std::size_t i = 0; i < rows; ++i) vertices.push_back({row(i)[0], row(i)[1]});
      return Patch::polygon(vertices);
    }
    std::vector<PatchLoad> points;
    for (std::size_t i = 0; i < rows; ++i) points.push_back({row(i)[0], row(i)[1], row(i)[2]});
    return Patch::points(points);
  };
  const auto made_of_file = [&] {
    try {
      return made();
    } catch (const std::invalid_argument& error) {
      if (file.empty()) throw;
      const bool has_rows = kind == "points" || kind == "polygon";
      throw std::invalid_argument((has_rows ? place_of(file, {"x", "y"}, error.what()) : file + ": ") + error.what());
    }
  };
  return with_prefix(in_quotes(text), [&] { return made_of_file().orthotropic(mx, my); });
}

std::vector<std::string> PatchArgument::remarks(const Patch& made) const {
  std::vector<std::string> lines = made.remarks();
  const std::string about = (file.empty() ? "pressures" : file) + ": ";
  if (law.empty()) {
    for (std::string& line : lines) line.insert(line.find(": ") + 2, about);  // after "note: "
  }
  for (const std::string& note : notes) lines.push_back("note: " + about + note);
  if (without_sensor > 0) {
    lines.push_back("note: " + about + std::to_string(without_sensor) + " of " + std::to_string(numbers.size()) +
                    " pixels have no sensor, and count as without pressure");
  }
  const std::size_t rows = columns == 0 ? 0 : numbers.size() / columns;
  constexpr std::size_t slender = 20;
  if (kind == "image" && (columns > slender * rows || frames_in_blocks)) {
    lines.push_back("warning: " + about + "a picture of " + std::to_string(rows) + " rows of " +
                    std::to_string(columns) + " pixels" + (frames_in_blocks ? " in blocks" : "") +
                    ": is it one frame? columns=N[,frame=K] reads a frame a row");
  }
  UnitChecks questions;
  questions.length(text.empty() ? "patch" : "patch '" + text + "'", across());
  const std::vector<std::string> asked = questions.lines();
  lines.insert(lines.end(), asked.begin(), asked.end());
  return lines;
}

double PatchArgument::across() const {
  if (table) return 2.0 * table->radius();
  if (kind == "rectangle") return std::max(x, y);
  if (kind == "ellipse") return 2.0 * std::max(x, y);
  const std::size_t rows = columns == 0 ? 0 : numbers.size() / columns;
  if (kind == "image") return std::max(x * static_cast<double>(columns), y * static_cast<double>(rows));
  double longest = 0.0;
  for (const std::size_t axis : {0U, 1U}) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < rows; ++i) {
      least = std::min(least, numbers[i * columns + axis]);
      most = std::max(most, numbers[i * columns + axis]);
    }
    longest = std::max(longest, most - least);
  }
  return longest;
}

PatchArgument parse_patch(const std::string& text) {
  if (const auto* const memory = dynamic_cast<const MemoryPatch*>(MemoryColumns::find(text))) return memory->patch();
  const auto [kind, rest] = split_description(text);
  return with_prefix("patch '" + text + "': ", [&, kind = kind, rest = rest] {
    if (!rest) refuse_kind(kind, {});
    PatchArgument patch = parse(kind, *rest);
    patch.text = text;
    return patch;
  });
}

Patch read_patch(const std::string& text, Messages& messages) {
  const PatchArgument argument = parse_patch(text);
  Patch patch = argument.patch();
  messages.say(argument.remarks(patch));
  return patch;
}

void note_factor(Messages& messages, const Patch& patch) {
  const auto [mx, my] = patch.factors();
  if (mx == 1.0 && my == 1.0) return;
  messages.say("limitcurve: note: friction factors mx = " + format_number(mx) + ", my = " + format_number(my) +
               ": a disc has " + format_number(disc_factor(patch)) + " times mu");
}

}  // namespace limitcurve::cli
