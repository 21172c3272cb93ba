// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "tests/limitcurve/shared.hpp"

#include <sstream>

namespace limitcurve {
namespace {

using test::expect_mention;

std::string complaint_about_table(const std::string& text) {
  return test::complaint([&] { read_table_csv(text, "torn.csv"); });
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Column `i` of a row of the CSV, counted from x; the side is before it.
double column(const std::string& row, std::size_t i) {
  std::istringstream stream(row);
  std::string field;
  for (std::size_t at = 0; at <= i + 1; ++at) std::getline(stream, field, ',');
  return parse_number(field).value();
}

class TableFileSuite : public testing::TestWithParam<const char*> {};

// The first four columns are the curve itself, rim and both ends included, in its order.
TEST_P(TableFileSuite, PlotsAsItStands) {
  const Table table = Table::build(parse_law(GetParam()), 1e-4);
  std::vector<std::string> rows;
  for (const std::string& line : lines_of(to_csv(table))) {
    if (line.rfind("inside,", 0) == 0 || line.rfind("outside,", 0) == 0) rows.push_back(line);
  }
  ASSERT_EQ(rows.size(), table.cell_count() + 2);
  EXPECT_EQ(column(rows.front(), 1), 0.0);
  EXPECT_EQ(column(rows.front(), 2), table.moment_ratio());
  EXPECT_EQ(column(rows.back(), 1), 1.0);
  EXPECT_EQ(column(rows.back(), 2), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double x = column(rows[i], 0);
    const UnitWrench exact = table.wrench(rows[i][0] == 'i' ? SlipTwist{x, 1.0} : SlipTwist{1.0, x});
    EXPECT_LE(test::apart(UnitWrench{column(rows[i], 1), column(rows[i], 2)}, exact), 1e-14) << rows[i];
    if (i == 0) continue;
    // From the rim inside to the rim outside is no step but for rounding.
    EXPECT_GE(column(rows[i], 1), column(rows[i - 1], 1) - 1e-14) << rows[i];
    EXPECT_LE(column(rows[i], 2), column(rows[i - 1], 2) + 1e-14) << rows[i];
  }
}

// Like a program without polynomials.
TEST_P(TableFileSuite, StatesTheErrorOfLinesBetweenRows) {
  for (const double tolerance : {1e-2, 1e-6}) {
    const Law law = parse_law(GetParam());
    const std::string text = to_csv(Table::build(law, tolerance));
    double stated = 0.0;
    std::string before;
    double worst = 0.0;
    for (const std::string& line : lines_of(text)) {
      constexpr std::string_view name = "# linear_error: ";
      if (line.rfind(name, 0) == 0) stated = parse_number(line.substr(name.size())).value();
      const bool outside = line.rfind("outside,", 0) == 0;
      if (!outside && line.rfind("inside,", 0) != 0) continue;
      if (!before.empty() && before[0] == line[0]) {
        for (int i = 0; i <= 100; ++i) {
          const auto between = [&](std::size_t of) {
            return column(before, of) + i / 100.0 * (column(line, of) - column(before, of));
          };
          const double x = between(0);
          const UnitForces<double> exact = law->forces(!outside ? x : x > 0.0 ? 1.0 / x : test::inf);
          worst = std::max(worst, test::apart(UnitWrench{between(1), between(2)}, exact));
        }
      }
      before = line;
    }
    EXPECT_LE(worst, stated) << tolerance;
    EXPECT_GE(worst, 0.8 * stated - tolerance) << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, TableFileSuite,
                         testing::Values("hertz", "uniform", "flat-punch", "cone", "gaussian:sigma=2"),
                         [](const auto& tested) { return test::test_name(tested.param); });

TEST(TableFile, EveryTornPrefixIsRefusedByPlace) {
  const std::string text = to_csv(Table::build(hertz(), 1e-2));
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_EQ(complaint_about_table(text.substr(0, length)).rfind("torn.csv:", 0), 0U)
        << "first " << length << " bytes";
  }
}

TEST(TableFile, EveryEditedDigitIsNoticed) {
  const std::string text = to_csv(Table::build(uniform(), 1e-2));
  int noticed = 0;
  for (std::size_t i = text.find("inside,"); i < text.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) continue;
    std::string edited = text;
    edited[i] = edited[i] == '9' ? '0' : static_cast<char>(edited[i] + 1);
    // The last of seventeen digits may change and still denote the same double.
    if (complaint_about_table(edited) == "none") {
      EXPECT_EQ(to_csv(read_table_csv(edited, "edited.csv")), text) << "byte " << i;
    } else {
      ++noticed;
    }
  }
  EXPECT_GT(noticed, 100);
}

// A spreadsheet pads every line to the widest, editors put a mark before the first; a name keeps what it ends in.
TEST(TableFile, TakesAFileThatASpreadsheetSaved) {
  const std::string text = to_csv(Table::build(hertz(), 1e-3));
  for (const std::string padding : {"\r", ",,,,\r", "  ", "\t,"}) {
    std::string saved = "\xEF\xBB\xBF";
    for (const char c : text) saved += c == '\n' ? padding + "\n" : std::string(1, c);
    EXPECT_EQ(to_csv(read_table_csv(saved, "saved.csv")), text) << padding;
  }
  for (const char* const name : {"mine,", "mine "}) {
    const std::string named = to_csv(Table::build(ExactCurve(hertz()), 1e-3, {.name = name}));
    EXPECT_EQ(to_csv(read_table_csv(named, "named.csv")), named) << name;
  }
}

TEST(TableFile, EveryFactIsHeldByTheChecksum) {
  const std::string text = to_csv(Table::build(hertz(), 1e-3));
  for (const char* fact : {"law", "tolerance", "checked_error", "index_bits", "octaves", "linear_error"}) {
    const std::string prefix = "# " + std::string(fact) + ": ";
    std::string edited = text;
    const std::size_t value = edited.find(prefix) + prefix.size();
    edited.replace(value, edited.find('\n', value) - value, "7");
    expect_mention(complaint_about_table(edited), "edited or damaged");
  }
}

TEST(TableFile, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint_about_table("a,b\n1,2\n"),
            "torn.csv:1:1: not a table: expected the first line '# limitcurve table, format 2'");
  const std::string text = to_csv(Table::build(hertz(), 1e-3));
  expect_mention(complaint_about_table("# limitcurve table, format 21" + text.substr(text.find('\n'))),
                 "torn.csv:1:1: not a table");
  const std::size_t header = text.find("side,x");
  const std::string line =
      std::to_string(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(header), '\n') + 2);
  const auto with = [&](std::string_view from, std::string_view to) {
    std::string edited = text;
    return edited.replace(edited.find(from), from.size(), to);
  };
  EXPECT_EQ(complaint_about_table(with("inside,0,0,", "inside,0,x,")),
            "torn.csv:" + line + ":10: expected a number, got 'x'");
  EXPECT_EQ(complaint_about_table(with("inside,0,", "aside,0,")),
            "torn.csv:" + line + ":1: expected inside or outside, got 'aside'");
  EXPECT_EQ(complaint_about_table(with("# octaves: ", "# octaves: 1.5x"))
                .rfind("torn.csv:6:12: expected a whole number, got '1.5x", 0),
            0U);
  expect_mention(complaint_about_table(with("side,x,", "side,y,")), "expected the header side,x,force,moment,c0");
  expect_mention(complaint_about_table(with("# law: hertz", "# law: cone")),
                 "torn.csv: the table was edited or damaged: its checksum is fnv1a:");
}

// A checksum keeps accidents out, not contents that are not a curve.
TEST(TableFile, RefusesRowsThatAreNoTableWhateverTheirChecksum) {
  const std::string text = to_csv(Table::build(hertz(), 1e-3));
  const auto with_its_checksum = [](std::string edited) {
    const std::string told = complaint_about_table(edited);
    constexpr std::string_view before_actual = "its contents have ";
    const std::size_t actual = told.find(before_actual);
    if (actual == std::string::npos) return told;
    const std::size_t sum = edited.find("fnv1a:");
    return complaint_about_table(edited.replace(sum, 22, told.substr(actual + before_actual.size())));
  };
  EXPECT_EQ(with_its_checksum(text), "none");
  const std::size_t rim = text.find("outside,1,");
  std::string without_rim = text;
  without_rim.erase(rim, text.find('\n', rim) + 1 - rim);
  expect_mention(with_its_checksum(without_rim), "torn.csv: the rows outside do not reach the rim");
  expect_mention(with_its_checksum(text.substr(0, text.find("inside,0,"))),
                 "torn.csv: the rows inside do not reach the rim");
  std::string law = text;
  law.replace(law.find("hertz"), 5, "he\x01tz");
  expect_mention(with_its_checksum(law), "torn.csv: ");
  std::string edge = text;
  const std::size_t second = edge.find("inside,", edge.find("inside,0,") + 1) + 7;
  edge.replace(second, edge.find(',', second) - second, "0.1234567");
  expect_mention(with_its_checksum(edge), "torn.csv: ");
}

TEST(TableFile, JsonCarriesTheTablesChecksum) {
  const Table table = Table::build(hertz(), 1e-4);
  expect_mention(to_json(table), "\"" + checksum(table) + "\"");
}

}  // namespace
}  // namespace limitcurve
