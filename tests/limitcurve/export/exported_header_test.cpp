// SPDX-License-Identifier: MIT
#include "limitcurve/export/header.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/complaint.hpp"
#include "tests/limitcurve/probes.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace limitcurve::test {
namespace {

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(ExportedHeader, ItsNameIsACIdentifier) {
  const Table table = Table::build(hertz(), 1e-2);
  EXPECT_TRUE(contains(to_header(table, "thumb"), "thumb_wrench(double slide, double spin)"));
  for (const char* name : {"2nd", "a-b", "_a", "a__b", "a b", "d\xc3\xa9", "int", "class", "main"}) {
    expect_mention(complaint([&] { (void)to_header(table, name); }), std::string("'") + name + "'");
  }
}

// Two tables in one program: whatever one is called, no name of the other ends as one of its own.
TEST(ExportedHeader, NoNameIsTheEndOfAnother) {
  const std::string header = to_header(Table::build(hertz(), 1e-2), "thumb");
  const std::regex own("\\bthumb(_\\w+)");
  std::set<std::string> names;
  for (std::sregex_iterator found(header.begin(), header.end(), own); found != std::sregex_iterator(); ++found)
    names.insert((*found)[1]);
  EXPECT_GE(names.size(), 12U);
  for (const std::string& longer : names) {
    for (const std::string& name : names)
      EXPECT_FALSE(longer != name && longer.ends_with(name)) << longer << ' ' << name;
  }
}

TEST(ExportedHeader, CarriesTheTablesChecksum) {
  const Table table = Table::build(hertz(), 1e-4);
  EXPECT_TRUE(contains(to_header(table), checksum(table)));
}

#ifndef _WIN32  // where there is no compiler
/// The prefix of a header's names.
std::string name_in(const std::string& header) {
  constexpr std::string_view begins = "typedef struct ";
  const std::size_t at = header.find(begins) + begins.size();
  return header.substr(at, header.find("_friction", at) - at);
}

/// Compiles a program that prints the wrenches at some twists by the header of `table`, and compares them with the
/// table's.
void expect_compiles(const Table& table, const std::string& compiler, const std::string& extension) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("limitcurve_header_" + std::to_string(::getpid()) + extension);
  std::filesystem::create_directories(folder);
  const std::string header = to_header(table);
  std::ofstream(folder / "table.h") << header;
  const std::string name = name_in(header);
  const std::vector<SlipTwist> twists = probes();
  std::ofstream program(folder / ("use." + extension));
  program << "#include \"table.h\"\n#include \"table.h\"\n#include <stdio.h>\nstatic const double twists[][2] = {";
  for (const SlipTwist twist : twists)
    program << '{' << format_number(twist.slide) << ',' << format_number(twist.spin) << "},";
  program << "};\n";
  if (extension == "cpp") {
    program << "static_assert(" << name << "_wrench(1.0, 0.0).force == 1.0, \"\");\n"
            << "static_assert(" << name << "_wrench(0.0, 0.0).force == 0.0, \"\");\n"
            << "static_assert(" << name << "_wrench(0.0, 2.0).moment == " << name << "_moment_ratio, \"\");\n";
  }
  program << "int main(void) {\n  for (unsigned i = 0; i < sizeof twists / sizeof *twists; ++i) {\n    const " << name
          << "_friction found = " << name << "_wrench(twists[i][0], twists[i][1]);\n"
          << "    printf(\"%.17g %.17g\\n\", found.force, found.moment);\n  }\n  return 0;\n}\n";
  program.close();
  const std::string directory = "cd '" + folder.string() + "' && ";
  ASSERT_EQ(std::system((directory + compiler + " -Wall -Wextra -Wpedantic -Werror use." + extension +
                         " -o use && ./use > found")
                            .c_str()),
            0);
  std::ifstream found(folder / "found");
  for (const SlipTwist twist : twists) {
    UnitWrench read;
    ASSERT_TRUE(found >> read.force >> read.moment);
    const UnitWrench expected = table.wrench(twist);
    EXPECT_NEAR(read.force, expected.force, 1e-15);
    EXPECT_NEAR(read.moment, expected.moment, 1e-15);
  }
  std::filesystem::remove_all(folder);
}

TEST(ExportedHeader, OfManyTablesLiveInOneProgram) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("limitcurve_headers_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::vector<Table> tables{Table::build(hertz(), 1e-2), Table::build(hertz(), 1e-6),
                                  Table::build(power(0.5), 1e-2), Table::build(power(-0.5), 1e-2)};
  std::ofstream all(folder / "all.cpp");
  all << "#include <stdio.h>\n";
  std::string mains;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string number = std::to_string(i);
    const std::string header = to_header(tables[i]);
    std::ofstream(folder / ("table" + number + ".h")) << header;
    const std::string name = name_in(header);
    EXPECT_TRUE(contains(name, "limitcurve_table_")) << name;
    all << "#include \"table" << number << ".h\"\n";
    // Chosen names may even be equal, in files of their own.
    std::ofstream(folder / ("same" + number + ".h")) << to_header(tables[i], "finger");
    std::ofstream(folder / ("same" + number + ".cpp"))
        << "#include \"same" << number << ".h\"\ndouble same" << number
        << "() { return finger_wrench(1.0, 1.0).moment + finger_moment_ratio; }\n";
    all << "double same" << number << "();\n";
    mains += "  printf(\"%.17g %.17g\\n\", " + name + "_wrench(-1.0, 1.0).moment + " + name + "_moment_ratio, same" +
             number + "());\n";
  }
  all << "int main() {\n" << mains << "}\n";
  all.close();
  const std::string directory = "cd '" + folder.string() + "' && ";
  ASSERT_EQ(std::system((directory +
                         "c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror all.cpp same?.cpp -o use && ./use > found")
                            .c_str()),
            0);
  std::ifstream found(folder / "found");
  for (const Table& table : tables) {
    double own = 0.0;
    double same = 0.0;
    ASSERT_TRUE(found >> own >> same);
    EXPECT_NEAR(own, table.rim().moment + table.moment_ratio(), 1e-15);
    EXPECT_NEAR(same, table.rim().moment + table.moment_ratio(), 1e-15);
  }
  std::filesystem::remove_all(folder);
}

TEST(ExportedHeader, IsCpp17) {
  expect_compiles(Table::build(hertz(), 1e-6), "c++ -std=c++17", "cpp");
}

TEST(ExportedHeader, IsC99) {
  expect_compiles(Table::build(parse_law("power:n=-0.5"), 1e-6), "cc -std=c99", "c");
}
#endif

}  // namespace
}  // namespace limitcurve::test
