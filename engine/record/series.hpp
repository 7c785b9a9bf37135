// Histories of a run: rows over time in named, unit-carrying columns, in one HDF5 file.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stiction::record {

class HistoryFile;

/// Where a column's values stand in a row.
struct Column {
  std::size_t offset = 0;
  std::size_t width = 1;
};

struct SeriesData;

/// Rows that are on the disk, and their checksum.
struct SeriesMark {
  std::size_t rows = 0;
  std::uint32_t checksum = 0;
  template<class Archive> void visit(Archive& archive) { archive(rows, checksum); }
};

/// Writes "/time" and the columns added. Rows reach the disk every 32 rows or every second, and are readable
/// from then on whatever happens to this process. Write errors are core::RunError; a NaN is a core::Bug.
class Series {
public:
  explicit Series(std::filesystem::path path);
  Series();  ///< without a file: takes columns for their names alone
  ~Series(); ///< flushes and closes; a failure here is silent, call flush() first to hear of it
  Series(Series const&) = delete;
  Series& operator=(Series const&) = delete;

  /// New column "group/name" (group may be "" or nested "a/b"), [rows] or [rows, width]. Before the first
  /// row.
  Column add(std::string const& group, std::string const& name, std::string const& unit,
             std::string const& meaning, int width = 1);
  /// Attribute of a group; group "" is the file itself.
  void set_attribute(std::string const& group, std::string const& name, std::string const& text);
  void set_attribute(std::string const& group, std::string const& name, double value);

  /// One row: all columns behind each other in the order of `add`, `row_width()` values.
  void append(double time, std::span<double const> row);
  void flush();
  /// What stands now, once it is on the disk to stay.
  [[nodiscard]] SeriesMark mark();
  /// Begins with those rows of another series with these columns, instead of the first row. Throws
  /// Unfit if it has not these rows.
  void take_up(SeriesData const& other, SeriesMark const& mark);

  [[nodiscard]] std::vector<std::pair<std::string, int>> const& names() const {
    return names_;
  } ///< and widths
  [[nodiscard]] std::size_t row_width() const { return width_; }
  [[nodiscard]] std::size_t rows() const { return flushed_ + times_.size(); }

private:
  void write_buffer();

  std::unique_ptr<HistoryFile> file_;
  std::vector<Column> columns_;
  std::vector<std::pair<std::string, int>> names_;
  std::size_t width_ = 0;
  std::vector<double> times_, rows_; ///< not yet on disk: [buffered], [buffered, width_]
  std::size_t flushed_ = 0;
  std::uint32_t checksum_ = 0; ///< of all rows
  bool failed_ = false;
  std::chrono::steady_clock::time_point last_flush_{};
};

/// One column as read: values [rows, width].
struct SeriesColumn {
  std::string unit, meaning;
  std::size_t width = 1;
  std::vector<double> values;
};

struct SeriesData {
  std::vector<double> time;                    ///< s
  std::map<std::string, SeriesColumn> columns; ///< by "group/name"
};

/// Reads a series, also while it is being written or after its writer was killed: all columns then have the
/// rows that are complete. Throws core::InputError for a missing, truncated or foreign file.
[[nodiscard]] SeriesData read_series(std::filesystem::path const& path);

} // namespace stiction::record
