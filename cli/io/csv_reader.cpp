// SPDX-License-Identifier: MIT
#include "cli/io/csv_reader.hpp"

#include "cli/io/descriptor.hpp"
#include "cli/io/number_list.hpp"
#include "cli/io/output_file.hpp"

#include "limitcurve/internal/interruption.hpp"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace limitcurve::cli {

namespace {

std::string joined(const std::vector<std::string>& names, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (text.empty() ? "" : ",") + names[i];
  return text;
}

int open_to_read(const std::string& file) {
  if (file == "-") return descriptor::standard_input;
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown))
    throw std::invalid_argument("cannot read '" + file + "': a directory, expected a CSV file");
  const int opened = descriptor::open_to_read(file);
  if (opened < 0) throw std::invalid_argument(system_complaint("read", file));
  return opened;
}

/// In bytes; 0 if unknown, as for standard input or a pipe.
std::uintmax_t size_of(const std::string& file) {
  std::error_code unknown;
  return file != "-" && std::filesystem::is_regular_file(file, unknown) ? std::filesystem::file_size(file, unknown) : 0;
}

/// The beginning of a text, made printable, for an error message.
std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string shown(text.substr(0, most));
  for (char& character : shown) {
    if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f) character = '?';
  }
  return text.size() <= most ? shown : shown + "…";
}

/// What the bytes at the beginning of a file say if they are no text in UTF-8; else empty.
std::string_view other_than_text(std::string_view line) {
  if (line.starts_with("\x93NUMPY")) return "a NumPy file, expected CSV: numpy.savetxt writes it";
  if (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff")) return "a text in UTF-16, expected UTF-8";
  if (line.starts_with("PK\x03\x04")) return "a spreadsheet or another zip file, expected CSV: export it";
  if (line.find('\0') != std::string_view::npos) return "a byte 0, expected a CSV text in UTF-8";
  return {};
}

/// The end of an error message if what should be one field is several, with another separator, or has a decimal comma.
std::string_view other_separator(std::string_view field) {
  if (field.find(';') != std::string_view::npos) return "; it is separated by semicolons, expected commas, and points in numbers";
  if (field.find('\t') != std::string_view::npos) return "; it is separated by tabs, expected commas";
  if (field.find(' ') != std::string_view::npos) return "; it is separated by spaces, expected commas";
  if (field.find(',') != std::string_view::npos) return "; it has a decimal comma, expected a point";
  return {};
}

}  // namespace

CsvReader::CsvReader(const std::string& file, std::vector<std::string> columns, std::vector<std::string> optional_columns)
    : name_(file == "-" ? "standard input" : file),
      columns_(std::move(columns)),
      required_(columns_.size()),
      descriptor_(open_to_read(file)),
      size_(size_of(file)),
      places_(columns_.size() + optional_columns.size(), missing) {
  for (std::string& column : optional_columns) columns_.push_back(std::move(column));
  try {
    if (!next_meaningful_line()) {
      line_number_ = 1;
      throw complaint_at(0, "an empty file, expected a header line with " + joined(columns_, required_ > 0 ? required_ : columns_.size()));
    }
    find_columns();
  } catch (...) {
    if (descriptor_ != descriptor::standard_input) descriptor::close(descriptor_);
    throw;
  }
}

CsvReader::CsvReader(const std::string& file)
    : name_(file == "-" ? "standard input" : file), required_(0), descriptor_(open_to_read(file)), has_header_(false) {}

CsvReader::~CsvReader() {
  if (descriptor_ != descriptor::standard_input) descriptor::close(descriptor_);
}

bool CsvReader::next_line() {
  line_.clear();
  for (;;) {
    const std::size_t end = chunk_.find('\n', position_);
    line_.append(chunk_, position_, end == std::string::npos ? end : end - position_);
    if (line_.size() > longest_line) {
      ++line_number_;
      throw complaint_at(longest_line, "a line of more than a million characters, expected CSV");
    }
    if (end != std::string::npos) {
      position_ = end + 1;
      break;
    }
    chunk_.resize(chunk_size);
    std::ptrdiff_t count = 0;
    do {
      count = descriptor::read(descriptor_, chunk_.data(), chunk_.size());
    } while (count < 0 && errno == EINTR);
    if (count < 0) throw std::runtime_error(system_complaint("read", name_));
    chunk_.resize(static_cast<std::size_t>(count));
    read_ += static_cast<std::uintmax_t>(count);
    position_ = 0;
    if (count == 0) {
      if (line_.empty()) return false;
      break;
    }
  }
  ++line_number_;
  if (line_number_ == 1 && !other_than_text(line_).empty()) throw complaint_at(0, std::string(other_than_text(line_)));
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  // Some spreadsheets write a byte order mark.
  if (line_number_ == 1 && line_.compare(0, 3, "\xef\xbb\xbf") == 0) line_.erase(0, 3);
  return true;
}

std::optional<double> CsvReader::share() const {
  if (size_ == 0) return std::nullopt;
  return static_cast<double>(read_) / static_cast<double>(size_);
}

bool CsvReader::next_meaningful_line() {
  while (next_line()) {
    const std::size_t first = line_.find_first_not_of(" \t");
    if (first == std::string::npos || line_[first] == '#') continue;
    split();
    return true;
  }
  return false;
}

void CsvReader::split() {
  field_count_ = 0;
  std::size_t begin = 0;
  while (begin <= line_.size()) {
    if (field_count_ == fields_.size()) fields_.emplace_back();
    Field& field = fields_[field_count_++];
    field.text.clear();
    std::size_t i = begin;
    while (i < line_.size() && (line_[i] == ' ' || line_[i] == '\t')) ++i;
    field.offset = i;
    if (i < line_.size() && line_[i] == '"') {
      for (++i; i < line_.size(); ++i) {
        if (line_[i] == '"') {
          // A doubled quote is a quote inside the text; a single one ends it.
          if (i + 1 >= line_.size() || line_[i + 1] != '"') break;
          ++i;
        }
        field.text += line_[i];
      }
      if (i == line_.size()) throw complaint_at(field.offset, "a quote that is not closed");
      ++i;
    }
    const std::size_t end = std::min(line_.find(',', i), line_.size());
    field.text.append(line_, i, end - i);
    while (!field.text.empty() && (field.text.back() == ' ' || field.text.back() == '\t')) field.text.pop_back();
    begin = end + 1;
  }
}

void CsvReader::find_columns() {
  header_fields_ = field_count_;
  for (std::size_t i = 0; i < field_count_; ++i) {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (fields_[i].text != columns_[column]) continue;
      if (places_[column] != missing) throw complaint_at(fields_[i].offset, "column '" + columns_[column] + "' twice, expected once");
      places_[column] = i;
    }
  }
  for (std::size_t column = 0; column < required_; ++column) {
    if (places_[column] == missing) throw no_column("'" + columns_[column] + "'");
  }
}

bool CsvReader::next() {
  let_interrupt();
  if (!next_meaningful_line()) {
    if (any_row_) return false;
    ++line_number_;
    throw complaint_at(0, has_header_ ? "no rows after the header, expected at least one" : "an empty file, expected rows of numbers");
  }
  if (!has_header_ && !any_row_) {
    header_fields_ = field_count_;
    for (std::size_t column = 0; column < field_count_; ++column) {
      columns_.push_back(std::to_string(column + 1));
      places_.push_back(column);
    }
  }
  any_row_ = true;
  if (field_count_ != header_fields_) {
    throw complaint_at(line_.size(), "a line of " + std::to_string(field_count_) + (field_count_ == 1 ? " field" : " fields") + ", got '" +
                                         excerpt(line_) + "', expected " + std::to_string(header_fields_) +
                                         (has_header_ ? " as in the header" : " as in the first row") +
                                         (field_count_ == 2 * header_fields_ ? "; are there decimal commas in place of points?"
                                                                             : std::string(other_separator(fields_[0].text))));
  }
  return true;
}

double CsvReader::number(std::size_t column, const Range& range) const {
  try {
    return read_number(text(column), range);
  } catch (const std::invalid_argument&) {
    throw complaint(
        column, "got '" + excerpt(text(column)) + "', expected " + std::string(range.text) + std::string(other_separator(text(column))));
  }
}

std::invalid_argument CsvReader::no_column(const std::string& column) const {
  return complaint_at(0, "no column " + column + ", got '" + excerpt(line_) + "', expected a header line with " +
                             joined(columns_, required_ > 0 ? required_ : columns_.size()) +
                             std::string(field_count_ == 1 ? other_separator(fields_[0].text) : ""));
}

std::invalid_argument CsvReader::complaint(std::size_t column, const std::string& what) const {
  return complaint_at(fields_[places_[column]].offset, "column '" + columns_[column] + "': " + what);
}

std::invalid_argument CsvReader::complaint_at(std::size_t offset, const std::string& what) const {
  return std::invalid_argument(name_ + ':' + std::to_string(line_number_) + ':' + std::to_string(offset + 1) + ": " + what);
}

}  // namespace limitcurve::cli
