// SPDX-License-Identifier: MIT
#include "cli/io/table_reader.hpp"
#include "tests/fuzz/accepted_table.hpp"

using namespace limitcurve;

/// Tables in JSON: a complaint, or a table that can be used.
static const fuzz::Target table_json_target("table_json", [](std::string_view input) {
  fuzz::read_despite_checksum(std::string(input),
                              [](const std::string& text) { return cli::read_table_json(text, "source"); });
});
