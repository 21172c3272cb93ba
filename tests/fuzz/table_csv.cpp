// SPDX-License-Identifier: MIT
#include "tests/fuzz/accepted_table.hpp"

using namespace limitcurve;

/// Tables in CSV: a complaint that begins with the source, or a table that can be used.
static const fuzz::Target table_csv_target("table_csv", [](std::string_view input) {
  fuzz::read_despite_checksum(std::string(input),
                              [](const std::string& text) { return read_table_csv(text, "source"); });
});
