// SPDX-License-Identifier: MIT
#include "cli/io/materials.hpp"
#include "cli/report/report_files.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

constexpr std::array tolerances{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/// What tables of each tolerance cost. They are not kept.
void write_sizes(const std::filesystem::path& output) {
  AtomicFile file(output / "tables.csv");
  Rows rows({file.output()}, {"law", "tolerance", "certified_error", "nodes", "bytes"});
  for (const std::string_view name : law_examples()) {
    const Law law = parse_law(name);
    for (const double tolerance : tolerances) {
      const auto table = Table::build(law, tolerance);
      rows.row(name, tolerance, table.certified_error(), table.cell_count(), table.bytes());
    }
  }
  rows.finish();
  file.commit();
}

/// A table for each material, under the radius that its coefficients imply by each law: mu_r = m0 mu a.
void write_material_tables(const std::filesystem::path& output, const std::filesystem::path& data) {
  GatheredRows rows(output / "materials.csv");
  for (const Material& material : read_materials(data)) {
    for (const std::string law : {"hertz", "uniform"}) {
      const double radius = material.mu_r / (material.mu * parse_law(law)->moment_ratio());
      const std::string name = "table-" + material.name + '-' + law + ".csv";
      rows.add({"table", "--law", law, "--tolerance", "1e-6", "--output", (output / name).string()},
               {{"material", material.name},
                {"mu", format_number(material.mu)},
                {"mu_r", format_number(material.mu_r)},
                {"radius", format_number(radius)},
                {"file", name}});
    }
  }
  rows.finish();
}

}  // namespace

void write_table_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  write_sizes(output);
  write_material_tables(output, data);
}

void write_work_precision_files(const std::filesystem::path& output, const std::filesystem::path& data) {
  for (const std::string name : {"wrench", "step", "scaling"}) {
    const std::filesystem::path source = data / "work_precision" / (name + ".csv");
    std::ifstream file(source, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file || text.empty()) throw std::runtime_error("cannot read '" + source.string() + "'");
    AtomicFile copy(output / ("work_precision_" + name + ".csv"));
    copy.output().write(text);
    copy.output().flush();
    copy.commit();
  }
}

}  // namespace limitcurve::cli
