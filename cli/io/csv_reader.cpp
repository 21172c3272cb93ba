// SPDX-License-Identifier: MIT
#include "cli/io/csv_reader.hpp"

#include "cli/io/csv_text.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/output_file.hpp"
#include "limitcurve/internal/interruption.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <system_error>

namespace limitcurve::cli {

namespace {

int open_to_read(const std::string& file) {
  if (file == "-") return descriptor::standard_input;
  std::error_code unknown;
  if (std::filesystem::is_directory(descriptor::path_of(file), unknown))
    throw std::invalid_argument("cannot read '" + file + "': a directory, expected a CSV file");
  const int opened = descriptor::open_to_read(file);
  if (opened < 0) throw std::invalid_argument(system_complaint("read", file));
  return opened;
}

/// In bytes; 0 if unknown, as for standard input or a pipe.
std::uintmax_t size_of(const std::string& file) {
  std::error_code unknown;
  const std::filesystem::path path = descriptor::path_of(file);
  return file != "-" && std::filesystem::is_regular_file(path, unknown) ? std::filesystem::file_size(path, unknown) : 0;
}

}  // namespace

CsvReader::CsvReader(const std::string& file, std::vector<std::string> columns,
                     std::vector<std::string> optional_columns, const FileColumns& file_columns, std::string expected)
    : memory_(MemoryColumns::find(file)),
      name_(memory_ != nullptr ? memory_->name_
            : file == "-"      ? "standard input"
                               : file),
      columns_(std::move(columns)),
      required_(columns_.size()),
      expected_(std::move(expected)),
      descriptor_(memory_ != nullptr ? descriptor::standard_input : open_to_read(file)),
      size_(size_of(file)),
      places_(columns_.size() + optional_columns.size(), missing),
      file_columns_(file_columns) {
  for (std::string& column : optional_columns) columns_.push_back(std::move(column));
  try {
    take(file_columns);
    if (expected_.empty()) expected_ = joined_names(columns_, required_ > 0 ? required_ : columns_.size());
    if (memory_ != nullptr) {
      take_names_in_memory();
    } else if (!next_meaningful_line()) {
      line_number_ = 1;
      throw complaint_at(0, "an empty file, expected a header line with " + expected_);
    }
    find_header();
    check_moment();
    std::vector<std::string_view> quantities;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (places_[i] != missing) quantities.push_back(FileColumns::quantity_of(own_[i]));
    }
    file_columns.warn_idle_units(quantities, name_);
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

void CsvReader::take_names_in_memory() {
  for (const std::string& name : memory_->columns_) fields_.push_back({name});
  field_count_ = fields_.size();
  line_ = joined_names(memory_->columns_, field_count_);
}

bool CsvReader::next_line() {
  if (line_ahead_) {
    line_ = std::move(*line_ahead_);
    line_ahead_.reset();
    line_number_ = number_ahead_;
    return true;
  }
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
  if (memory_ != nullptr) return static_cast<double>(rows_) / static_cast<double>(memory_->rows_);
  if (size_ == 0) return std::nullopt;
  return static_cast<double>(read_) / static_cast<double>(size_);
}

bool CsvReader::next_meaningful_line() {
  if (!lines_.empty()) {
    if (next_line_ == lines_.size()) return false;
    line_ = lines_[next_line_].text;
    line_number_ = lines_[next_line_++].number;
    split();
    return true;
  }
  std::size_t blank = 0;
  while (next_line()) {
    const std::size_t first = line_.find_first_not_of(" \t");
    if (first == std::string::npos && rows_ > 0) ++blank;
    if (first == std::string::npos || line_[first] == '#') continue;
    blank_lines_ += blank;
    split();
    return true;
  }
  return false;
}

void CsvReader::restart() {
  rows_ = 0;
  columns_.clear();
  places_.clear();
}

std::size_t CsvReader::next_fields() {
  const std::string now = line_;
  const std::size_t number_now = line_number_;
  std::size_t fields = 0;
  if (next_meaningful_line()) {
    fields = field_count_;
    number_ahead_ = line_number_;
    line_ahead_ = std::move(line_);
  }
  line_ = now;
  line_number_ = number_now;
  split();
  return fields;
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

bool CsvReader::next() {
  if (file_columns_.zero && !zero_) learn_zero();
  while (next_row()) {
    if (file_columns_.is_log && has_blank()) {
      ++blanks_;
      continue;
    }
    if (zero_) ++zero_row_;
    const double least = file_columns_.least_load ? *file_columns_.least_load * file_columns_.scale("force") : 0.0;
    if (least > 0.0 && number(load_, finite) <= -least) ++other_sign_;
    const bool rests = (least > 0.0 && number(load_, finite) < least) || is_without_load();
    if (rests) {
      ++left_out_;
      ++resting_;
      continue;
    }
    if (resting_ >= SensorZero::shortest_pause) ++grip_;
    resting_ = 0;
    ++taken_;
    return true;
  }
  const std::string limit =
      file_columns_.least_load ? "a load below " + format_number(*file_columns_.least_load) : "no normal force";
  if (taken_ == 0) {
    throw complaint_at(
        0, left_out_ == rows_
               ? "all " + std::to_string(rows_) + " rows have " + limit + ", expected one row or more" +
                     (other_sign_ > 0 ? "; load=" + other_sign() + " keeps " + std::to_string(other_sign_) + " of them"
                                      : "")
               : "no row is left: " + std::to_string(left_out_) + " of " + std::to_string(rows_) + " have " + limit +
                     ", the others a blank");
  }
  const auto say_left_out = [&](std::size_t& count, const std::string& what) {
    if (count > 0)
      say(std::to_string(count) + " of " + std::to_string(rows_) + " rows have " + what + ", and are left out");
    count = 0;
  };
  say_left_out(blanks_, "a blank in a used column");
  say_left_out(left_out_, limit);
  return false;
}

bool CsvReader::has_blank() const {
  for (const Source& source : sources_) {
    for (const std::size_t place : source.places) {
      if (memory_ != nullptr ? std::isnan(memory_->numbers_[place][rows_ - 1]) : fields_[place].text.empty())
        return true;
    }
  }
  return false;
}

/// Whether the row has no normal force, by which its moment would be divided.
bool CsvReader::is_without_load() {
  for (std::size_t column = 0; column < sources_.size(); ++column) {
    const Source& source = sources_[column];
    if (source.places.size() != wrench_places || channel(column, source.places[2], finite) != 0.0) continue;
    if (load_ < columns_.size() && places_[load_] != missing && number(load_, finite) > 0.0)
      throw complaint(column, "got " + header_[source.places[2]] + " = 0 and a load of " +
                                  format_number(number(load_, finite)) + " N, expected that of the same contact");
    return true;
  }
  return false;
}

/// Reads all rows, and lets them be read again.
void CsvReader::learn_zero() {
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const std::string_view name = own_[column];
    if (name != "load" && name != "force" && name != "moment" && name != "fx" && name != "fy") continue;
    for (const std::size_t place : sources_[column].places) {
      if (std::find(channels_.begin(), channels_.end(), place) == channels_.end()) channels_.push_back(place);
    }
  }
  std::vector<std::vector<double>> values(channels_.size());
  std::vector<double> loads;
  std::vector<Line> lines;
  while (next_row()) {
    if (memory_ == nullptr) lines.push_back({line_, line_number_});
    if (has_blank()) continue;
    for (std::size_t i = 0; i < channels_.size(); ++i) values[i].push_back(raw_number(load_, channels_[i], finite));
    const double load = raw_number(load_, places_[load_], finite);
    loads.push_back(sources_[load_].turned ? 0.0 - load : load);
  }
  rows_ = 0;
  lines_ = std::move(lines);
  zero_.emplace(values, loads, *file_columns_.least_load);
  if (zero_->pauses() == 0)
    throw complaint_at(0, "--zero: no pause of " + std::to_string(SensorZero::shortest_pause) +
                              " rows without load, expected one or more; is --least-load too small, or the load's sign "
                              "wrong?");
  const auto place = std::find(channels_.begin(), channels_.end(), places_[load_]) - channels_.begin();
  const std::span<const double> levels = zero_->levels(static_cast<std::size_t>(place));
  const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
  const std::string& name = header_[places_[load_]];
  const double least = *file_columns_.least_load;
  const auto count = [](std::size_t pauses) { return std::to_string(pauses) + (pauses == 1 ? " pause" : " pauses"); };
  say("zero: " + count(zero_->pauses()) + ", " + name + " " + format_number(*low, 3) + " to " +
      format_number(*high, 3));
  if (zero_->noise() > 0.3 * least)
    return say("zero: " + name + " scatters by " + format_number(zero_->noise(), 2) +
                   ", so pauses are missed: add --least-load " + format_number(6.0 * zero_->noise(), 2),
               "warning");
  const auto range = [](std::span<const double> numbers) {
    const auto [smallest, largest] = std::minmax_element(numbers.begin(), numbers.end());
    return *largest - *smallest;
  };
  const double closed = sources_[load_].turned ? *high : -*low;  // if the sign is wrong
  std::string odd;
  if (closed > least && std::fabs(*std::max_element(loads.begin(), loads.end())) < 0.25 * closed)
    odd = name + " is near 0 in the grips, but not in the pauses";
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const double moved = range(zero_->levels(i));
    if (moved > least && moved > 0.5 * range(values[i]))
      odd = header_[channels_[i]] + " differs by " + format_number(moved, 3) + " between the pauses";
  }
  if (!odd.empty())
    return say("zero: " + odd + ". Is the load's sign right (or load=" + other_sign() +
                   "), or does the sensor carry a weight?",
               "warning");
  if (zero_->unsettled() > 0)
    say("zero: the load changes within " + std::to_string(zero_->unsettled()) + " of " + count(zero_->pauses()) +
            ", so the zero may be wrong: let the gripper rest for a second between contacts",
        "warning");
  std::size_t most = zero_->pauses();
  double larger = least;
  if (*high - *low > 0.5 * least) {
    for (std::size_t found = 0; (found = SensorZero({}, loads, 1.5 * larger).pauses()) > most; larger *= 1.5)
      most = found;
  }
  if (larger > least)
    say("zero: " + name + " drifts by " + format_number(*high - *low, 3) + ", so pauses may be missed: --least-load " +
            format_number(larger, 3) + " finds " + std::to_string(most),
        "warning");
}

/// What --columns says for the load of the other sign.
std::string CsvReader::other_sign() const {
  return (sources_[load_].turned ? "" : "-") + header_[places_[load_]];
}

double CsvReader::sigma(std::size_t column) const {
  const Source& source = sources_[column];
  const auto of = [&](std::size_t place) {
    const auto at = std::find(channels_.begin(), channels_.end(), place) - channels_.begin();
    const double sigma = zero_->sigma(static_cast<std::size_t>(at));
    if (sigma > 0.0) return sigma;
    throw complaint(column,
                    "the same number in all pauses, expected noise that tells its standard deviation; add a "
                    "column sigma_" +
                        own_[column]);
  };
  if (source.places.size() != wrench_places) {
    double sum = 0.0;
    for (const std::size_t place : source.places) sum += of(place) * of(place);
    return units_[column] * std::sqrt(sum / static_cast<double>(source.places.size()));
  }
  std::array<double, wrench_places> wrench{};
  std::array<double, wrench_places> sigmas{};
  for (std::size_t i = 0; i < wrench_places; ++i) {
    wrench.at(i) = channel(column, source.places[i], finite);
    sigmas.at(i) = of(source.places[i]);
  }
  const auto [fx, fy, fz, tx, ty, tz] = wrench;
  // The derivatives of Tz + (Fx Tx + Fy Ty)/Fz.
  const std::array<double, wrench_places> slopes{tx / fz, ty / fz, -(fx * tx + fy * ty) / (fz * fz),
                                                 fx / fz, fy / fz, 1.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < wrench_places; ++i) sum += std::pow(slopes.at(i) * sigmas.at(i), 2);
  return units_[column] * std::sqrt(sum);
}

bool CsvReader::next_row() {
  let_interrupt();
  if (memory_ != nullptr ? rows_ == memory_->rows_ : !next_meaningful_line()) {
    if (rows_ > 0) return false;
    ++line_number_;
    throw complaint_at(
        0, has_header_ ? "no rows after the header, expected at least one" : "an empty file, expected rows of numbers");
  }
  if (has_header_ && rows_ == 0 && file_columns_.is_log && lines_.empty() && is_units_line()) return next_row();
  if (!has_header_ && rows_ == 0) {
    header_fields_ = field_count_;
    for (std::size_t column = 0; column < field_count_; ++column) {
      columns_.push_back(std::to_string(column + 1));
      places_.push_back(column);
    }
  }
  ++rows_;
  if (field_count_ != header_fields_) {
    throw complaint_at(line_.size(), "a line of " + std::to_string(field_count_) +
                                         (field_count_ == 1 ? " field" : " fields") + ", got '" + excerpt(line_) +
                                         "', expected " + std::to_string(header_fields_) +
                                         (has_header_ ? " as in the header" : " as in the first row") +
                                         (field_count_ > header_fields_ && line_.find('.') == std::string::npos
                                              ? "; are there decimal commas instead of points?"
                                              : std::string(other_separator(fields_[0].text, field_count_ == 1))));
  }
  return true;
}

double CsvReader::number(std::size_t column, const Range& range) const {
  const double unit = units_.empty() ? 1.0 : units_[column];
  const Source* const source = sources_.empty() ? nullptr : &sources_[column];
  double value = channel(column, places_[column], range);
  const bool is_read = source == nullptr || (source->places.size() == 1 && !source->turned);
  if (!is_read && source->places.size() == wrench_places) {
    const auto part = [&](std::size_t i) { return channel(column, source->places[i], range); };
    value = part(5) + (value * part(3) + part(1) * part(4)) / part(2);
  } else if (!is_read) {
    if (source->turned) value = 0.0 - value;
    for (std::size_t i = 1; i < source->places.size(); ++i)
      value = std::hypot(value, channel(column, source->places[i], range));
  }
  if (range.contains(value)) return unit * value;
  std::string hint;
  if (column == load_ && file_columns_.messages != nullptr && std::isfinite(value))
    hint = std::string(is_read ? "; --columns load=-NAME turns the sign of all, " : "; ") +
           "--least-load 0.1 leaves out rows of less";
  const bool as_read = memory_ != nullptr || !is_read || zero_;
  throw complaint(column, "got '" + (as_read ? format_number(value) : excerpt(text(column))) + "', expected " +
                              std::string(range.text) + hint);
}

/// The number at a place of the row, without the sensor's zero.
double CsvReader::channel(std::size_t column, std::size_t place, const Range& range) const {
  const double raw = raw_number(column, place, range);
  if (!zero_) return raw;
  const auto at = std::find(channels_.begin(), channels_.end(), place);
  return at == channels_.end() ? raw : raw - zero_->at(static_cast<std::size_t>(at - channels_.begin()), zero_row_ - 1);
}

/// Whether the row is a second header, of units, which then must be those of --units.
bool CsvReader::is_units_line() const {
  if (memory_ != nullptr) return false;
  for (std::size_t column = 0; column < sources_.size(); ++column) {
    for (const std::size_t place : sources_[column].places) {
      if (!FileColumns::unit(fields_[place].text)) return false;
    }
  }
  for (std::size_t column = 0; column < sources_.size(); ++column) {
    if (sources_[column].places.empty()) continue;
    const std::string& unit = fields_[sources_[column].places.back()].text;
    if (std::fabs(*FileColumns::unit(unit) / units_[column] - 1.0) > 1e-9)
      throw complaint_at(fields_[sources_[column].places.back()].offset,
                         "a line of units, got '" + unit + "' for " + own_[column] + ", expected it in --units");
  }
  say("line " + std::to_string(line_number_) + " has units, and is skipped");
  return true;
}

/// The number at a place of the row; `column` is for the complaint.
double CsvReader::raw_number(std::size_t column, std::size_t place, const Range& range) const {
  if (memory_ != nullptr) {
    memory_->require_numbers(place);
    return memory_->numbers_[place][rows_ - 1];
  }
  const std::string& field = fields_[place].text;
  const auto value = parse_number(field);
  if (value && (std::isfinite(*value) || range.contains(*value))) return *value;
  throw complaint(column, "got '" + excerpt(field) + "', expected " + std::string(range.text) +
                              std::string(other_separator(field, field_count_ == 1)));
}

std::invalid_argument CsvReader::complaint(std::size_t column, const std::string& what) const {
  const std::string in_column = "column '" + columns_[column] + "': " + what;
  if (memory_ == nullptr) return complaint_at(fields_[places_[column]].offset, in_column);
  return std::invalid_argument(name_ + "['" + columns_[column] + "'][" + std::to_string(rows_ - 1) + "]: " + in_column);
}

std::invalid_argument CsvReader::complaint_at(std::size_t offset, const std::string& what) const {
  if (memory_ != nullptr) return std::invalid_argument(name_ + ": " + what);
  return std::invalid_argument(name_ + ':' + std::to_string(line_number_) + ':' + std::to_string(offset + 1) + ": " +
                               what);
}

std::string place_of(const std::string& file, const std::vector<std::string>& columns, std::string_view message) {
  if (size_of(file) == 0) return file + ": ";
  const std::size_t after_name = message.rfind(file);
  if (after_name != std::string_view::npos) message.remove_prefix(after_name + file.size());
  for (const std::string_view word : {"sample ", "vertex ", "point "}) {
    const std::size_t at = message.find(word);
    std::size_t row = 0;
    if (at == std::string_view::npos || MemoryColumns::find(file) != nullptr) continue;
    std::from_chars(message.data() + at + word.size(), message.data() + message.size(), row);
    if (row == 0) continue;
    try {
      CsvReader reader(file, columns);
      while (row > 0 && reader.next()) --row;
      return reader.complaint_at(0, "").what();
    } catch (const std::exception&) {
      break;  // the rows are from elsewhere
    }
  }
  return file + ": ";
}

}  // namespace limitcurve::cli
