// An HDF5 file of equally long columns that stays readable when the process is killed at any moment.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "record/hdf5.hpp"

namespace stiction::record {

/// Columns are chunked and uncompressed: a compressed chunk that is half full is lost by a kill. The file
/// appears under its name with the first commit. Every method throws core::RunError with the system's reason
/// when the file cannot be written, and leaves on disk what was committed before.
class HistoryFile {
public:
  explicit HistoryFile(std::filesystem::path path);
  HistoryFile(HistoryFile const&) = delete;
  HistoryFile& operator=(HistoryFile const&) = delete;
  ~HistoryFile();

  /// New column at "group/name", [rows] for width 1, else [rows, width], float64.
  void add_column(std::string const& name, int width, std::string const& unit, std::string const& meaning);
  /// Attribute of a group ("" is the file itself), made if missing.
  void set_attribute(std::string const& group, std::string const& name, std::string const& text);
  void set_attribute(std::string const& group, std::string const& name, double value);
  /// Writes `values` [rows, width] of a column behind the rows committed so far.
  void write(std::size_t column, std::span<double const> values);
  /// Makes the `rows` rows just written part of the file.
  void commit(std::size_t rows);
  /// Waits until what is committed survives a power cut.
  void sync();

private:
  struct Dataset {
    hdf5::Handle handle;
    std::size_t width;
  };
  void require(bool held);
  [[noreturn]] void give_up(std::string const& reason);
  void abandon();
  void reserve();
  [[nodiscard]] int descriptor() const;
  void publish();
  [[nodiscard]] hdf5::Handle open_group(std::string const& group);

  std::filesystem::path path_, part_;
  hdf5::Handle file_;
  std::vector<Dataset> columns_;
  std::size_t committed_ = 0; ///< rows
  std::size_t pending_ = 0;   ///< bytes written but not committed
  bool published_ = false;
};

} // namespace stiction::record
