// SPDX-License-Identifier: MIT
#include "limitcurve/table_file.hpp"

#include "limitcurve/number.hpp"
#include "limitcurve/version.hpp"

#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace limitcurve {

namespace {

constexpr std::string_view title = "# limitcurve table, format 1";
constexpr std::string_view columns = "side,coordinate,force,moment,slope";
constexpr std::array<std::string_view, 5> fact_names{"law", "tolerance", "certified_error", "version", "checksum"};

/// coordinate, force, moment, slope: inside the primary component is the force, outside the moment.
std::string row(const TableNode& node, bool inside, std::string_view separator) {
  const double force = inside ? node.primary : node.secondary;
  const double moment = inside ? node.secondary : node.primary;
  std::string text = format_number(node.coordinate);
  for (const double value : {force, moment, node.slope}) text.append(separator).append(format_number(value));
  return text;
}

std::string csv_rows(const Table& table) {
  std::string text;
  for (const TableNode& node : table.inside().nodes()) text += "inside," + row(node, true, ",") + "\n";
  for (const TableNode& node : table.outside().nodes()) text += "outside," + row(node, false, ",") + "\n";
  return text;
}

/// A text and where in it reading stands, for complaints that name the place.
class Reader {
 public:
  Reader(std::string_view text, std::string_view source) : rest_(text), source_(source) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  std::string_view line() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) fail(rest_.size() + 1, "the line is torn off: expected an end of line");
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
  }

  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw std::invalid_argument(std::string(source_) + ":" + std::to_string(std::max<std::size_t>(line_, 1)) + ":" +
                                std::to_string(column) + ": " + what);
  }

 private:
  std::string_view rest_;
  std::string_view source_;
  std::size_t line_ = 0;
};

double number(const Reader& reader, std::string_view text, std::size_t column) {
  const std::optional<double> value = parse_number(text);
  if (!value) reader.fail(column, "expected a number, got '" + std::string(text) + "'");
  return *value;
}

TableNode read_node(const Reader& reader, std::string_view line, bool inside) {
  std::array<double, 4> values{};
  std::size_t begin = line.find(',') + 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool last = i + 1 == values.size();
    const std::size_t end = last ? line.size() : line.find(',', begin);
    if (end == std::string_view::npos) reader.fail(line.size() + 1, "expected the columns " + std::string(columns));
    values[i] = number(reader, line.substr(begin, end - begin), begin + 1);
    begin = end + 1;
  }
  const auto [coordinate, force, moment, slope] = values;
  return inside ? TableNode{coordinate, force, moment, slope} : TableNode{coordinate, moment, force, slope};
}

std::string identifier(std::string_view law) {
  std::string text;
  for (const char c : law) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      text += c;
    } else if (text.empty() || text.back() != '_') {
      text += '_';
    }
  }
  return text;
}

}  // namespace

std::string checksum(const Table& table) {
  const std::string contents =
      table.law_name() + "\n" + format_number(table.tolerance()) + "\n" + format_number(table.certified_error()) + "\n" + csv_rows(table);
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : contents) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  std::string text = "fnv1a:";
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[(hash >> static_cast<unsigned>(shift)) & 15U];
  return text;
}

void verify_checksum(const Table& table, std::string_view expected, std::string_view source) {
  const std::string actual = checksum(table);
  if (actual == expected) return;
  throw std::invalid_argument(std::string(source) + ": the table was edited or damaged: its checksum is " + std::string(expected) +
                              ", its contents have " + actual);
}

std::string to_csv(const Table& table) {
  const std::array<std::string, 5> facts{table.law_name(), format_number(table.tolerance()), format_number(table.certified_error()),
                                         std::string(version), checksum(table)};
  std::string text(title);
  text += '\n';
  for (std::size_t i = 0; i < facts.size(); ++i) text += "# " + std::string(fact_names[i]) + ": " + facts[i] + "\n";
  return text + std::string(columns) + "\n" + csv_rows(table);
}

Table read_table_csv(std::string_view text, std::string_view source) {
  Reader reader(text, source);
  if (text.substr(0, title.size()) != title) reader.fail(1, "not a table: expected the first line '" + std::string(title) + "'");
  reader.line();
  std::array<std::string_view, 5> facts;
  std::array<double, 5> numbers{};
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const std::string prefix = "# " + std::string(fact_names[i]) + ": ";
    const std::string_view line = reader.line();
    if (line.substr(0, prefix.size()) != prefix) reader.fail(1, "expected '" + prefix + "…'");
    facts[i] = line.substr(prefix.size());
    if (i == 1 || i == 2) numbers[i] = number(reader, facts[i], prefix.size() + 1);
  }
  if (reader.line() != columns) reader.fail(1, "expected the header " + std::string(columns));
  std::array<std::vector<TableNode>, 2> sides;
  while (!reader.at_end()) {
    const std::string_view line = reader.line();
    const std::string_view side = line.substr(0, line.find(','));
    if (side != "inside" && side != "outside") reader.fail(1, "expected inside or outside, got '" + std::string(side) + "'");
    const bool inside = side == "inside";
    if (inside && !sides[1].empty()) reader.fail(1, "a node inside the rim after those outside");
    sides[inside ? 0 : 1].push_back(read_node(reader, line, inside));
  }
  try {
    Table table({std::string(facts[0]), numbers[1], numbers[2]}, TableSide(std::move(sides[0])), TableSide(std::move(sides[1])));
    verify_checksum(table, facts[4], source);
    return table;
  } catch (const std::invalid_argument& error) {
    const std::string_view what = error.what();
    if (what.substr(0, source.size()) == source) throw;
    throw std::invalid_argument(std::string(source) + ": " + error.what());
  }
}

std::string to_json(const Table& table) {
  const auto side = [](std::span<const TableNode> nodes, bool inside) {
    std::string text;
    for (const TableNode& node : nodes) text += (text.empty() ? "\n    [" : ",\n    [") + row(node, inside, ", ") + "]";
    return text + "\n  ]";
  };
  // A law name holds no character that JSON escapes, but for the file name of samples.
  std::string law;
  for (const char c : table.law_name()) {
    if (c == '"' || c == '\\') law += '\\';
    law += c;
  }
  return "{\n  \"format\": \"limitcurve table 1\",\n  \"law\": \"" + law + "\",\n  \"tolerance\": " + format_number(table.tolerance()) +
         ",\n  \"certified_error\": " + format_number(table.certified_error()) + ",\n  \"version\": \"" + std::string(version) +
         "\",\n  \"checksum\": \"" + checksum(table) + "\",\n  \"inside\": [" + side(table.inside().nodes(), true) + ",\n  \"outside\": [" +
         side(table.outside().nodes(), false) + "\n}\n";
}

std::string to_header(const Table& table) {
  const auto literal = [](double value) {
    const std::string text = format_number(value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  };
  const auto side = [&](std::string_view name, std::span<const TableNode> nodes) {
    std::string text = "inline constexpr node " + std::string(name) + "[] = {\n";
    for (const TableNode& node : nodes) {
      text += "    {" + literal(node.coordinate) + ", " + literal(node.primary) + ", " + literal(node.secondary) + ", " +
              literal(node.slope) + "},\n";
    }
    return text + "};\n";
  };
  const std::string name = "limitcurve_table_" + identifier(table.law_name());
  const std::string guard = name + "_" + checksum(table).substr(6);
  return "// Friction limit curve of the pressure law " + table.law_name() + ", written by limitcurve " + std::string(version) +
         ".\n// |error| of force and moment <= certified_error, compared with the exact curve. Checksum " + checksum(table) + "\n#ifndef " +
         guard + "\n#define " + guard + "\n\nnamespace " + name +
         R"( {

/// force = F/(mu P), moment = M/(mu P a): friction force and moment over what the contact could bear.
struct unit_wrench {
  double force;
  double moment;
};

/// Inside the rim: coordinate c/a, primary = force. Outside: coordinate a/c, primary = moment. The slope is the
/// primary component's; the secondary component's is -coordinate * slope.
struct node {
  double coordinate;
  double primary;
  double secondary;
  double slope;
};

inline constexpr double tolerance = )" +
         literal(table.tolerance()) + ";\ninline constexpr double certified_error = " + literal(table.certified_error()) +
         ";\n/// Moment of a pure twist, mu_r / (mu a).\ninline constexpr double moment_ratio = " + literal(table.moment_ratio()) +
         ";\n\n" + side("inside", table.inside().nodes()) + side("outside", table.outside().nodes()) +
         R"(
/// Cubic Hermite interpolation between the nodes around `coordinate`, found by bisection.
template <int count>
constexpr unit_wrench interpolate(const node (&nodes)[count], double coordinate) {
  int low = 0;
  int high = count - 1;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (nodes[middle].coordinate <= coordinate) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const node& left = nodes[low];
  const node& right = nodes[high];
  const double width = right.coordinate - left.coordinate;
  const double t = (coordinate - left.coordinate) / width;
  const double from[2] = {left.primary, left.secondary};
  const double rise[2] = {right.primary - left.primary, right.secondary - left.secondary};
  const double slope_left[2] = {width * left.slope, -width * left.coordinate * left.slope};
  const double slope_right[2] = {width * right.slope, -width * right.coordinate * right.slope};
  double value[2] = {0.0, 0.0};
  for (int i = 0; i < 2; ++i) {
    const double square = 3.0 * rise[i] - 2.0 * slope_left[i] - slope_right[i];
    const double cube = slope_left[i] + slope_right[i] - 2.0 * rise[i];
    value[i] = from[i] + t * (slope_left[i] + t * (square + t * cube));
  }
  return {value[0], value[1]};
}

/// The unit wrench of a contact that slides with speed `slide` while its rim turns with speed `spin` (a times the
/// angular speed); both >= 0 and not both zero, and only their ratio matters. slide/spin = c/a.
constexpr unit_wrench wrench(double slide, double spin) {
  if (slide <= spin) return interpolate(inside, slide / spin);
  const unit_wrench swapped = interpolate(outside, spin / slide);
  return {swapped.moment, swapped.force};
}

}  // namespace )" +
         name + "\n\n#endif\n";
}

}  // namespace limitcurve
