// SPDX-License-Identifier: MIT
#include "limitcurve/export/header.hpp"
#include "limitcurve/internal/number.hpp"
#include "tests/limitcurve/shared.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace limitcurve::test {
namespace {

TEST(ExportedHeader, ItsNameIsACIdentifier) {
  const Table table = Table::build(hertz(), 1e-2);
  expect_mention(to_header(table, "thumb"), "thumb_wrench(double slide, double spin)");
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
  expect_mention(to_header(table), checksum(table));
}

#ifndef _WIN32  // where there is no compiler
TEST(ExportedHeader, OfManyTablesLiveInOneProgram) {
  const auto folder = std::filesystem::path(testing::TempDir()) / ("limitcurve_headers_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::vector<Table> tables{Table::build(hertz(), 1e-2), Table::build(hertz(), 1e-6),
                                  Table::build(power(0.5), 1e-2), Table::build(power(-0.5), 1e-2)};
  std::ofstream all(folder / "all.cpp");
  all << "#include <stdio.h>\n#define near\n#define far\n#define small char\n#define interface struct\n"
         "#define min(a, b)\n#define max(a, b)\n";  // as <windows.h> does
  std::string mains;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string number = std::to_string(i);
    const std::string header = to_header(tables[i]);
    std::ofstream(folder / ("table" + number + ".h")) << header;
    constexpr std::string_view begins = "typedef struct ";
    const std::size_t at = header.find(begins) + begins.size();
    const std::string name = header.substr(at, header.find("_friction", at) - at);
    expect_mention(name, "limitcurve_table_");
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
#endif

}  // namespace
}  // namespace limitcurve::test
