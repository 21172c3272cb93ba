// SPDX-License-Identifier: MIT
// The columns of a CSV file: its header, and what --columns makes of it.
#include "cli/io/csv_reader.hpp"
#include "cli/io/csv_text.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

namespace limitcurve::cli {

std::vector<std::string> CsvReader::others() const {
  std::vector<std::string> names;
  for (std::size_t place = 0; place < header_.size(); ++place) {
    const bool is_read = std::any_of(sources_.begin(), sources_.end(), [&](const Source& source) {
      return std::find(source.places.begin(), source.places.end(), place) != source.places.end();
    });
    if (!is_read) names.push_back(header_[place]);
  }
  return names;
}

void CsvReader::take(const FileColumns& file_columns) {
  for (const std::string& column : columns_) units_.push_back(file_columns.scale(FileColumns::quantity_of(column)));
  own_ = columns_;
  const std::vector<std::string>& own = own_;
  load_ = static_cast<std::size_t>(std::find(own.begin(), own.end(), "load") - own.begin());
  for (const auto& [name, in_file] : file_columns.names) {
    const auto place = std::find(own.begin(), own.end(), name);
    if (place == own.end())
      throw std::invalid_argument("--columns: got '" + name + "', expected one of " + joined_names(own, own.size()));
    columns_[static_cast<std::size_t>(place - own.begin())] = in_file;
    renamed_.push_back(static_cast<std::size_t>(place - own.begin()));
  }
}

void CsvReader::say(const std::string& text, const std::string& kind) const {
  if (file_columns_.messages != nullptr)
    file_columns_.messages->say("limitcurve: " + kind + ": " + name_ + ": " + text);
}

/// The first of some lines that has the columns. If none has, the complaint is that of the first.
void CsvReader::find_header() {
  constexpr std::size_t most_lines = 20;
  if (memory_ != nullptr || file_columns_.messages == nullptr) return find_columns();
  const std::string first = line_;
  const std::size_t first_number = line_number_;
  for (std::size_t i = 0; i < most_lines; ++i) {
    try {
      if (i > 0 && !next_meaningful_line()) break;
      find_columns();
      if (i > 0) say("the header is line " + std::to_string(line_number_) + "; what precedes it is skipped");
      return;
    } catch (const std::invalid_argument&) {
      std::fill(places_.begin(), places_.end(), missing);
    }
  }
  line_ = first;
  line_number_ = first_number;
  split();
  find_columns();
}

std::size_t CsvReader::place_in_header(const std::string& name) const {
  std::size_t place = missing;
  for (std::size_t i = 0; i < field_count_; ++i) {
    if (fields_[i].text != name) continue;
    if (place != missing) throw complaint_at(fields_[i].offset, "column '" + name + "' twice, expected once");
    place = i;
  }
  return place;
}

/// Where each column's numbers are. A name in --columns with a sign, or of several, is one column if the file has a
/// column of just that name.
void CsvReader::find_sources() {
  sources_.assign(columns_.size(), {});
  for (std::size_t i = 0; i < renamed_.size(); ++i) {
    const auto& [own, in_file] = file_columns_.names[i];
    const std::size_t column = renamed_[i];
    if (places_[column] != missing) {
      const char last = in_file.back();
      const std::string stem = in_file.substr(0, in_file.size() - 1);
      const std::string other = stem + static_cast<char>(last + 1);
      if (own == "force" && (last == 'x' || last == 'X') && std::count(header_.begin(), header_.end(), other) > 0)
        say("force=" + in_file + " leaves out " + other + "; force=" + in_file + ":" + other + " is their length");
      continue;
    }
    const FileColumns::Parts parts = FileColumns::parts_of(in_file);
    const std::string got = "--columns: got '" + own + "=" + in_file + "', expected ";
    const bool is_wrench = own == "moment" && parts.names.size() == wrench_places;
    if (parts.names.size() > 1 && parts.turned)
      throw std::invalid_argument(got + "no sign: neither a length nor F.T/Fz depends on it");
    if (parts.names.size() > 1 && own == "moment" && !is_wrench)
      throw std::invalid_argument(got + "one column, or six, Fx:Fy:Fz:Tx:Ty:Tz");
    if (parts.names.size() > 1 && own != "force" && !is_wrench)
      throw std::invalid_argument(got + "one column, because only a force is the length of several");
    if (parts.is_plain) continue;
    Source source{{}, parts.turned};
    for (const std::string& name : parts.names) {
      const std::size_t place = place_in_header(name);
      if (place == missing) throw no_named_column(name);
      if (std::find(source.places.begin(), source.places.end(), place) != source.places.end())
        throw std::invalid_argument(got + "each column once");
      source.places.push_back(place);
      if (memory_ != nullptr) memory_->require_numbers(place);
    }
    places_[column] = source.places.front();
    sources_[column] = std::move(source);
  }
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (places_[column] != missing && sources_[column].places.empty()) sources_[column].places = {places_[column]};
  }
}

/// A moment of six columns has the normal force third; one of one column is about the sensor's axis.
void CsvReader::check_moment() const {
  std::vector<std::string> moment;
  std::vector<std::string> forces;
  std::string load;
  for (std::size_t column = 0; column < sources_.size(); ++column) {
    for (const std::size_t place : sources_[column].places) {
      if (column == load_) load = header_[place];
      const bool is_force = own_[column].starts_with("force") || own_[column] == "fx" || own_[column] == "fy";
      if (is_force) forces.push_back(header_[place]);
      if (own_[column] == "moment") moment.push_back(header_[place]);
    }
  }
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const auto listed = [](const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
      const char* const quote = name.find_first_of(":,") == std::string::npos ? "" : "\"";
      text.append(text.empty() ? "moment=" : ":").append(quote).append(name).append(quote);
    }
    return text;
  };
  if (moment.size() == wrench_places) {
    const auto end = moment.begin() + 3;
    auto normal = std::find(moment.begin(), end, load);
    if (normal == end && has(forces, moment[2]))
      normal = std::find_if(moment.begin(), end, [&](const std::string& name) { return !has(forces, name); });
    if (normal == end || normal + 1 == end) return;
    const std::string got = listed(moment);
    for (const auto first : {moment.begin(), end}) std::rotate(first, first + (normal - moment.begin()) + 1, first + 3);
    throw std::invalid_argument("--columns: got '" + got + "', expected the load's column third: " + listed(moment));
  }
  if (moment.size() != 1 || forces.size() != 2 || forces[0].size() != forces[1].size()) return;
  // The columns of three axes differ in one character, as Fx, Fy, Fz.
  const auto with = [](std::string name, std::size_t at, char axis) {
    name[at] = axis;
    return name;
  };
  const auto at = static_cast<std::size_t>(std::mismatch(forces[0].begin(), forces[0].end(), forces[1].begin()).first -
                                           forces[0].begin());
  for (const std::string& normal : header_) {
    if (has(forces, normal) || normal.size() <= at || with(normal, at, forces[0][at]) != forces[0]) continue;
    for (std::size_t i = 0; i < moment[0].size(); ++i) {
      std::vector<std::string> six{forces[0], forces[1], normal};
      for (std::size_t axis = 0; axis < 3; ++axis) six.push_back(with(moment[0], i, six[axis][at]));
      const std::set<std::string> names(six.begin(), six.end());
      if (names.size() == six.size() && names.contains(moment[0]) &&
          std::all_of(six.begin(), six.end(), [&](const std::string& name) { return has(header_, name); }))
        return say(listed(moment) +
                   " is about the sensor's axis; if the contact is elsewhere, name all six: " + listed(six));
    }
  }
}

void CsvReader::find_columns() {
  header_fields_ = field_count_;
  header_.clear();
  for (std::size_t i = 0; i < field_count_; ++i) header_.push_back(fields_[i].text);
  for (std::size_t column = 0; column < columns_.size(); ++column) places_[column] = place_in_header(columns_[column]);
  find_sources();
  if (file_columns_.least_load && (load_ == columns_.size() || places_[load_] == missing))
    throw no_column(load_ == columns_.size() ? "'load'" : "'" + columns_[load_] + "' for --least-load");
  const bool has_none = std::all_of(places_.begin(), places_.end(), [](std::size_t place) { return place == missing; });
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    const bool is_renamed = std::find(renamed_.begin(), renamed_.end(), column) != renamed_.end();
    const bool wanted = has_none || column < required_ || is_renamed;
    if (wanted && places_[column] == missing)
      throw is_renamed ? no_named_column(columns_[column]) : no_column("'" + columns_[column] + "'");
    if (wanted && memory_ != nullptr) memory_->require_numbers(places_[column]);
  }
}

std::invalid_argument CsvReader::no_named_column(const std::string& column) const {
  return complaint_at(0, "no column '" + column + "', which --columns names; the header is '" + excerpt(line_) + "'" +
                             (field_count_ > 1 && line_.find_first_of(";\t") == std::string::npos
                                  ? ""
                                  : std::string(other_separator(line_, field_count_ == 1))));
}

std::invalid_argument CsvReader::no_column(const std::string& column) const {
  std::string hint = field_count_ == 1 ? std::string(other_separator(fields_[0].text, true)) : "";
  const auto end = fields_.begin() + static_cast<std::ptrdiff_t>(field_count_);
  if (memory_ == nullptr &&
      std::all_of(fields_.begin(), end, [](const Field& one) { return !!parse_number(one.text); }))
    hint = "; it has no header: put a line with the columns' names before the first";
  for (const std::string& name : columns_) {
    for (std::size_t i = 0; i < field_count_; ++i) {
      const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
      const std::string& field = fields_[i].text;
      if (field != name && std::equal(field.begin(), field.end(), name.begin(), name.end(), same))
        hint = "; capital letters count";
    }
  }
  if (hint.empty() && file_columns_.is_offered) hint = "; or name the file's columns by --columns, as load=NAME";
  return complaint_at(
      0, "no column " + column + ", got '" + excerpt(line_) + "', expected a header line with " + expected_ + hint);
}

}  // namespace limitcurve::cli
