// SPDX-License-Identifier: MIT
#include "cli/io/table_writer.hpp"

#include "limitcurve/export/header.hpp"
#include "limitcurve/table_file.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

/// The table's JSON; `what` has the name in it.
template <class AnyTable>
std::string checked_json(const AnyTable& table, const std::string& option, const std::string& what) {
  std::string text = to_json(table);
  if (!nlohmann::json::accept(text))
    throw std::invalid_argument(option + ": the " + what +
                                "'s name is not UTF-8, as JSON must be, expected a file that ends in .csv");
  return text;
}

}  // namespace

PatchTableWriter patch_table_writer(const std::string& file, const std::string& option) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".csv") return [](const PatchTable& table) { return to_csv(table); };
  if (extension == ".json") return [option](const PatchTable& table) { return checked_json(table, option, "patch"); };
  throw std::invalid_argument(option + ": got '" + file + "', expected a name that ends in .csv or .json");
}

TableWriter table_writer(const std::string& file, const std::string& option, const std::string& name, bool is_single) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".hpp" || extension == ".h") {
    return [name, is_single](const limitcurve::Table& table) { return to_header(table, name, is_single); };
  }
  if (!name.empty()) {
    throw std::invalid_argument("name '" + name + "' for the file '" + file +
                                "': expected one that ends in .h or .hpp, only headers have names");
  }
  if (is_single)
    throw std::invalid_argument("--real float: got the file '" + file + "', expected one that ends in .h or .hpp");
  if (extension == ".csv") return [](const limitcurve::Table& table) { return to_csv(table); };
  if (extension == ".json")
    return [option](const limitcurve::Table& table) { return checked_json(table, option, "law"); };
  throw std::invalid_argument(option + ": got '" + file + "', expected a name that ends in .csv, .json, .h or .hpp");
}

}  // namespace limitcurve::cli
