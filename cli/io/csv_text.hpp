// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What an error message shows of the text of a CSV file.
namespace limitcurve::cli {

/// The first names, with commas between them.
std::string joined_names(const std::vector<std::string>& names, std::size_t count);
/// The beginning of a text, made printable.
std::string excerpt(std::string_view text);
/// What the bytes at the beginning of a file say if they are no text in UTF-8; else empty.
std::string_view other_than_text(std::string_view line);
/// The end of an error message if what should be one field is several, with another separator (spaces only if the field
/// is the whole line), or has a decimal comma.
std::string_view other_separator(std::string_view field, bool is_line);

}  // namespace limitcurve::cli
