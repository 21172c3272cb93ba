// SPDX-License-Identifier: MIT
#include "limitcurve/table.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/output_file.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/table_writer.hpp"

#include "limitcurve/export/header.hpp"
#include "limitcurve/export/single_precision.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

namespace {

class Table final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"table", "Write a lookup table of the limit curve, with a checked error",
            R"(Formats: .csv, .json, .h (C99) or .hpp (constexpr C++17). Headers need no library.
Columns: law, tolerance, checked_error (an upper bound on the absolute error of force and moment in unit wrenches),
nodes (the number of cells), bytes (that look-ups may read), and profile_error (add it to checked_error, because a
measured pressure is known only at samples; it is 0 for a law given by a formula).
With --patch the contact is not round, but its wrench costs the same whatever its shape. You can pass the file as
--patch table:FILE.csv or .json. Columns: patch, tolerance, checked_error (an upper bound on the error of the force in
units of mu P, and of the moment in units of the largest moment), and bytes.)",
            "limitcurve table --law hertz --tolerance 1e-6 -o hertz.csv"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.text("--patch", patch_, "PATCH", "A contact that is not round, instead of --law (see 'limitcurve patch')");
    options.number("--tolerance", tolerance_, positive,
                   "Largest error of force and moment, in unit wrenches, or times m0 if m0 > 1 (default 1e-8, with "
                   "--real float 1e-6, with --patch 1e-3)");
    options.text("-o,--output", file_, "FILE", "File to write, whose ending sets the format", Presence::required);
    options.count("--preferred-bytes", bytes_, 0, limitcurve::Table::max_bytes,
                  "Bytes that a look-up should touch; the table gets the lowest (fastest) degree, 3 to 5, that fits, "
                  "otherwise 6");
    static constexpr std::array<std::string_view, 2> reals{"double", "float"};
    options.choice("--real", is_single_, reals, "Number type of a header: {}");
    options.text("--name", name_, "NAME",
                 "Name in a .h or .hpp file, as in NAME_wrench(slide, spin) (default: law and checksum)");
  }

  void run(const Results& results) override {
    if ((law_ == nullptr) == patch_.empty()) throw std::invalid_argument(what_contact(!patch_.empty()));
    if (!patch_.empty()) return of_patch(results);
    results.messages->say(law_->remarks());
    const double tolerance =
        tolerance_.value_or(is_single_ ? FloatTable::default_tolerance : limitcurve::Table::default_tolerance);
    const TableWriter text_of = table_writer(file_, "--output", name_, is_single_);
    // Rounding of float takes most of the finest tolerance.
    const double finest = FloatTable::finest_tolerance;
    if (is_single_ && !(tolerance >= finest))
      throw out_of_range("--tolerance", tolerance, "1", format_number(finest) + " or more with --real float");
    const double of_table = is_single_ ? std::max(0.1 * tolerance, tolerance - 0.9 * finest) : tolerance;
    const auto table =
        limitcurve::Table::build(law_, of_table, {.preferred_bytes = bytes_.value_or(TableOptions{}.preferred_bytes)});
    const double error = is_single_ ? single_precision_error(table) : table.checked_error();
    if (const double least = error / std::max(1.0, table.moment_ratio()); is_single_ && least > tolerance) {
      throw std::runtime_error("table of " + table.law_name() + " in single precision: choose a --tolerance of " +
                               format_number(least) + " or more");
    }
    const limitcurve::Table asked({table.law_name(), tolerance, table.checked_error(), table.profile_error()},
                                  table.cells());
    AtomicFile::write(file_, text_of(asked));
    Rows rows(results, {"law", "tolerance", "checked_error", "nodes", "bytes", "profile_error"});
    const TableCells cells = is_single_ ? limitcurve::table::in_single_precision(table.cells()) : table.cells();
    const std::size_t nodes = cells.inside.size() + cells.outside.size();
    // A header's cells are rows of numbers, without an index.
    const std::size_t bytes = nodes * (static_cast<std::size_t>(table.degree()) + 2) * (is_single_ ? 4 : 8);
    const bool is_header = file_.ends_with(".h") || file_.ends_with(".hpp");
    rows.row(table.law_name(), tolerance, error, nodes, is_header ? bytes : table.bytes(), table.profile_error());
    rows.finish();
  }

 private:
  void of_patch(const Results& results) const {
    const Patch patch = read_patch(patch_, *results.messages);
    if (bytes_ || !name_.empty() || is_single_)
      throw std::invalid_argument(
          "--preferred-bytes, --name, --real have no effect with --patch, whose tables have one form: leave them out");
    const PatchTableWriter text_of = patch_table_writer(file_, "--output");
    const auto table = PatchTable::build(patch, tolerance_.value_or(PatchTable::default_tolerance), patch_);
    AtomicFile::write(file_, text_of(table));
    Rows rows(results, {"patch", "tolerance", "checked_error", "bytes"});
    rows.row(patch_, table.tolerance(), table.checked_error(), table.bytes());
    rows.finish();
  }

  Law law_;
  std::string patch_;
  std::optional<double> tolerance_;
  std::optional<std::size_t> bytes_;
  std::string file_;
  std::string name_;
  bool is_single_ = false;
};

}  // namespace

std::unique_ptr<Subcommand> make_table() {
  return std::make_unique<Table>();
}

}  // namespace limitcurve::cli
