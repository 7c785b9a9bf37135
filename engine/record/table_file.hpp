// One HDF5 file that holds a table, as other programs open it in one line.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace stiction::record {

/// Numbers (float64, NaN where there is none) or texts (UTF-8), one a row; the other list is empty.
struct TableColumn {
  std::string name, unit, meaning;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// Writes dataset `name`, [rows] of a compound type with a member per column and an attribute "unit_<column>"
/// each, and beside it "columns/<column>", [rows] each, with attributes "unit" and "meaning". All columns
/// have `rows` entries. The file appears whole or not at all. Throws core::RunError with the system's reason.
void write_table(std::filesystem::path const& path, std::string const& name, std::size_t rows,
                 std::vector<TableColumn> const& columns);

} // namespace stiction::record
