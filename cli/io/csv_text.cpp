// SPDX-License-Identifier: MIT
#include "cli/io/csv_text.hpp"

namespace limitcurve::cli {

std::string joined_names(const std::vector<std::string>& names, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (text.empty() ? "" : ",") + names[i];
  return text;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string shown;
  for (const char character : text.substr(0, most)) {
    const bool is_control = static_cast<unsigned char>(character) < 0x20 || character == 0x7f;
    shown += character == '\t' ? "\\t" : std::string(1, is_control ? '?' : character);
  }
  return text.size() <= most ? shown : shown + "…";
}

std::string_view other_than_text(std::string_view line) {
  if (line.starts_with("\x93NUMPY")) return "a NumPy file, expected CSV: numpy.savetxt writes it";
  if (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff"))
    return "a text in UTF-16, expected UTF-8: save it so";
  if (line.starts_with("#ROSBAG"))
    return "a rosbag, expected CSV: 'rostopic echo -b FILE.bag -p /TOPIC > FILE.csv' writes it";
  if (line.starts_with("PK\x03\x04")) return "a spreadsheet or another zip file, expected CSV: export it";
  if (line.find('\0') != std::string_view::npos) return "a byte 0, expected a CSV text in UTF-8";
  return {};
}

std::string_view other_separator(std::string_view field, bool is_line) {
  if (field.find(';') != std::string_view::npos)
    return "; it is separated by semicolons: use commas, and points in numbers";
  if (field.find('\t') != std::string_view::npos) return "; it is separated by tabs: use commas, and points in numbers";
  if (is_line && field.find(' ') != std::string_view::npos) return "; it is separated by spaces: use commas";
  if (field.find(',') != std::string_view::npos) return "; it has a decimal comma: use a point";
  return {};
}

}  // namespace limitcurve::cli
