// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/file_columns.hpp"
#include "cli/io/memory_columns.hpp"
#include "cli/io/sensor_zero.hpp"
#include "limitcurve/internal/range.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve::cli {

using namespace ranges;

/// Reads a CSV file of named columns row by row, in constant memory.
///
/// The reader finds columns by their names in the header line, in any order, and ignores others. It skips blank lines
/// and lines that begin with `#`. Line ends may be LF or CRLF; fields may be quoted. "-" is standard input. A bad file
/// throws std::invalid_argument with `FILE:LINE:COLUMN: …` (COLUMN counts bytes from 1); a disk that fails throws
/// std::runtime_error.
class CsvReader {
 public:
  /// Opens `file`, or MemoryColumns of that path, and reads its header, which must have all of `columns`; `expected`:
  /// what a message says it must have, if that is more. With `file_columns.messages` the header is the first of 20
  /// lines that has them.
  CsvReader(const std::string& file, std::vector<std::string> columns, std::vector<std::string> optional_columns = {},
            const FileColumns& file_columns = {}, std::string expected = {});
  /// Opens a file of numbers without header. Its columns are 0, 1, …, one for each field of the first row.
  explicit CsvReader(const std::string& file);
  ~CsvReader();
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Moves to the next row; false after the last. A row with fewer or more fields than the header (such as a truncated
  /// line) is an error, and so is a file without rows. A log's rows below --least-load, and those with a blank in a
  /// used column, are left out and counted in notes. With --zero the first call reads the whole log.
  bool next();

  /// Of a file without header: forgets the rows that were read, as if the file began with the next.
  void restart();
  /// Number of fields of the row that `next` will find, 0 after the last; that row is read in advance.
  [[nodiscard]] std::size_t next_fields();

  /// Number of fields in the header, or in the first row if there is no header.
  [[nodiscard]] std::size_t field_count() const { return header_fields_; }
  /// Of those between the rows that were read.
  [[nodiscard]] std::size_t blank_lines() const { return blank_lines_; }
  /// Whether the file has the i-th column, in the order of the constructor's lists, optional columns last.
  [[nodiscard]] bool has(std::size_t column) const { return places_[column] != missing; }
  /// Names in the header of which no column is read.
  [[nodiscard]] std::vector<std::string> others() const;
  /// The field of the current row in the i-th column; of a file only.
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[places_[column]].text; }
  /// The same as a number within `range`, in SI units.
  [[nodiscard]] double number(std::size_t column, const Range& range) const;

  /// The number of the current row: of a file its line, else from 1.
  [[nodiscard]] std::size_t row() const { return memory_ != nullptr ? rows_ : line_number_; }
  /// The number of the current contact of a log, which ends where five consecutive rows or more are below --least-load;
  /// 0 without that option.
  [[nodiscard]] std::size_t grip() const { return file_columns_.least_load ? grip_ : 0; }
  /// Whether --zero gives the standard deviation of measured columns; that of the current row's i-th column, in SI
  /// units, from the scatter in the pauses. Of a length that of one component on average; of a moment
  /// Fx:Fy:Fz:Tx:Ty:Tz by error propagation.
  [[nodiscard]] bool has_sigmas() const { return zero_.has_value(); }
  [[nodiscard]] double sigma(std::size_t column) const;

  /// The fraction of the file that has been read, 0 to 1, if its size is known.
  [[nodiscard]] std::optional<double> share() const;

  /// The error that the header lacks `column`; only before the first row is read.
  [[nodiscard]] std::invalid_argument no_column(const std::string& column) const;
  /// An error at the field of the current row in the i-th column.
  [[nodiscard]] std::invalid_argument complaint(std::size_t column, const std::string& what) const;
  /// One of the present line.
  [[nodiscard]] std::invalid_argument complaint_at(std::size_t offset, const std::string& what) const;

 private:
  struct Field {
    std::string text;
    std::size_t offset = 0;  ///< of its first byte in the line
  };

  static constexpr std::size_t missing = static_cast<std::size_t>(-1);
  static constexpr std::size_t chunk_size = 1 << 16;
  /// A longer line is an error; this bounds the memory.
  static constexpr std::size_t longest_line = 1 << 20;

  /// A column of the file, or several whose length counts, or one with the other sign, or a wrench's moment.
  struct Source {
    std::vector<std::size_t> places;
    bool turned = false;
  };
  /// Places of a wrench: M = F·T/Fz is the moment about the sensor's z through the contact, wherever that is, because
  /// T = r × F + M z.
  static constexpr std::size_t wrench_places = 6;
  struct Line {
    std::string text;
    std::size_t number;
  };

  [[nodiscard]] std::invalid_argument no_named_column(const std::string& column) const;
  void take_names_in_memory();
  void find_header();
  void say(const std::string& text, const std::string& kind = "note") const;
  void check_moment() const;
  [[nodiscard]] std::string other_sign() const;
  bool next_row();
  bool next_line();
  bool next_meaningful_line();
  void split();
  [[nodiscard]] std::size_t place_in_header(const std::string& name) const;
  void find_columns();
  void find_sources();
  [[nodiscard]] bool is_units_line() const;
  void learn_zero();
  [[nodiscard]] bool has_blank() const;
  [[nodiscard]] bool is_without_load();
  [[nodiscard]] double channel(std::size_t column, std::size_t place, const Range& range) const;
  [[nodiscard]] double raw_number(std::size_t column, std::size_t place, const Range& range) const;
  void take(const FileColumns& file_columns);

  const MemoryColumns* memory_ = nullptr;
  std::size_t rows_ = 0;  ///< that have been read
  std::size_t blank_lines_ = 0;
  std::string name_;
  std::vector<std::string> columns_;  ///< names in the file
  std::vector<std::string> own_;      ///< names of the reader
  std::vector<std::string> header_;   ///< all names of the file
  std::vector<double> units_;         ///< of the columns, in SI units
  std::vector<std::size_t> renamed_;  ///< columns that --columns names: the file must have them
  std::size_t required_;
  std::string expected_;
  int descriptor_;
  std::uintmax_t size_ = 0;  ///< of the file in bytes, 0 if not known
  std::uintmax_t read_ = 0;
  std::string chunk_;
  std::size_t position_ = 0;
  std::string line_;
  std::size_t line_number_ = 0;
  std::vector<Field> fields_;
  std::size_t field_count_ = 0;
  std::vector<std::size_t> places_;
  std::vector<Source> sources_;  ///< of all columns that the file has; the others are without places
  FileColumns file_columns_;
  std::size_t load_ = missing;  ///< the column of loads, if it is asked for
  std::size_t left_out_ = 0;    ///< rows below the least load
  std::size_t other_sign_ = 0;  ///< rows whose load is enough with the other sign
  std::size_t blanks_ = 0;      ///< rows left out for a blank
  std::size_t taken_ = 0;       ///< rows that `next` returned
  std::size_t resting_ = 0;     ///< consecutive rows below the least load
  std::size_t grip_ = 1;
  std::optional<SensorZero> zero_;
  std::vector<std::size_t> channels_;  ///< places that have a zero
  std::vector<Line> lines_;            ///< with a zero: all that were read, from next_line_ on to be read again
  std::size_t next_line_ = 0;
  std::size_t zero_row_ = 0;               ///< of the rows without a blank, from 1
  std::optional<std::string> line_ahead_;  ///< what next_fields read
  std::size_t number_ahead_ = 0;
  std::size_t header_fields_ = 0;
  bool has_header_ = true;
};

/// Where the sample, vertex or point stands whose number (from 1) a message tells: "FILE:LINE:1: ". It reads the file
/// again; "FILE: " if the message tells none, or for a pipe or standard input, which are read once.
std::string place_of(const std::string& file, const std::vector<std::string>& columns, std::string_view message);

}  // namespace limitcurve::cli
