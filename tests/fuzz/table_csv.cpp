// SPDX-License-Identifier: MIT
#include "tests/fuzz/accepted_table.hpp"

using namespace limitcurve;

/// Tables in CSV: a complaint that begins with the source, or a table that can be used.
static const fuzz::Target table_csv_target("table_csv", [](const std::uint8_t* data, std::size_t size) {
  fuzz::read_despite_checksum(std::string(fuzz::as_text(data, size)),
                              [](const std::string& text) { return read_table_csv(text, "source"); });
});
