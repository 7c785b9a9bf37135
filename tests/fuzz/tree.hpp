// HDF5 files from a text, so that bytes mutate the data and not the format, which is the library's own.
#pragma once
#include <string>
#include <string_view>

namespace stiction::fuzz {

/// Makes a file of the lines of `text`; its path. A line that cannot be followed is passed over:
///   group PATH
///   data PATH TYPE SHAPE VALUES
///   attribute PATH NAME TYPE SHAPE VALUES
/// TYPE is double, float, int, byte or text; SHAPE is 2x3, or - for a single one. VALUES of a text are the
/// rest of the line, every element being that text; else numbers, repeated where they are too few. What has
/// more than 4096 elements is announced without being written.
std::string tree_file(std::string const& name, std::string_view text);

} // namespace stiction::fuzz
