// Buffers rows and hands them column by column to the history file.
#include "record/series.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "record/history_file.hpp"

namespace stiction::record {

namespace {
constexpr std::size_t rows_per_flush = 32;
constexpr std::chrono::seconds time_per_flush{1};
} // namespace

Series::Series(std::filesystem::path path) : file_(std::make_unique<HistoryFile>(std::move(path))) {
  file_->set_attribute("", "format", "stiction series 1");
  file_->add_column("time", 1, "s", "simulated time");
}

Series::Series() = default;

Series::~Series() {
  try {
    if (!failed_ && file_)
      flush();
  } catch (std::exception const&) { // NOLINT: a destructor has nobody to tell
  }
}

Column Series::add(std::string const& group, std::string const& name, std::string const& unit,
                   std::string const& meaning, int width) {
  core::expect(rows() == 0, "all columns of a series before its first row");
  core::expect(width > 0, "a column at least one value wide");
  names_.emplace_back(group.empty() ? name : group + "/" + name, width);
  if (file_)
    file_->add_column(names_.back().first, width, unit, meaning);
  columns_.push_back({width_, static_cast<std::size_t>(width)});
  width_ += columns_.back().width;
  return columns_.back();
}

void Series::set_attribute(std::string const& group, std::string const& name, std::string const& text) {
  if (file_)
    file_->set_attribute(group, name, text);
}

void Series::set_attribute(std::string const& group, std::string const& name, double value) {
  if (file_)
    file_->set_attribute(group, name, value);
}

void Series::append(double time, std::span<double const> row) {
  core::expect(row.size() == width_, "a row as wide as the columns added");
  core::expect(!std::isnan(time) && std::ranges::none_of(row, [](double v) { return std::isnan(v); }),
               "no NaN in a row of a series");
  times_.push_back(time);
  rows_.insert(rows_.end(), row.begin(), row.end());
  bool const due = std::chrono::steady_clock::now() - last_flush_ >= time_per_flush; // the first row is due
  if (due || times_.size() >= rows_per_flush)
    flush();
}

void Series::flush() {
  core::expect(!failed_, "no use of a series after it failed to write");
  failed_ = true; // unless all goes well
  write_buffer();
  file_->commit(times_.size());
  failed_ = false;
  flushed_ += times_.size();
  times_.clear();
  rows_.clear();
  last_flush_ = std::chrono::steady_clock::now();
}

void Series::write_buffer() {
  if (times_.empty())
    return;
  std::vector<double> values;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    auto const [offset, width] = columns_[c];
    values.clear();
    for (std::size_t row = 0; row < times_.size(); ++row) {
      double const* const first = rows_.data() + row * width_ + offset;
      values.insert(values.end(), first, first + width);
    }
    file_->write(c + 1, values);
  }
  file_->write(0, times_);
}

} // namespace stiction::record
