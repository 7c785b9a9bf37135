// Buffers rows and hands them column by column to the history file.
#include "record/series.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "record/checkpoint_file.hpp"
#include "record/history_file.hpp"

namespace stiction::record {

namespace {
constexpr std::size_t rows_per_flush = 32;
constexpr std::chrono::seconds time_per_flush{1};

std::uint32_t with_row(std::uint32_t checksum_before, double time, std::span<double const> row) {
  auto const bytes = [](std::span<double const> numbers) {
    return std::string_view(reinterpret_cast<char const*>(numbers.data()), numbers.size_bytes());
  };
  return checksum(bytes(row), checksum(bytes({&time, 1}), checksum_before));
}
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
  checksum_ = with_row(checksum_, time, row);
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

SeriesMark Series::mark() {
  flush();
  file_->sync();
  return {flushed_, checksum_};
}

void Series::take_up(SeriesData const& other, SeriesMark const& mark) {
  core::expect(rows() == 0, "a series to take up another one before its first row");
  if (other.time.size() < mark.rows)
    throw Unfit("has more rows than series.h5");
  std::vector<double const*> values;
  for (auto const& [name, width] : names_) {
    auto const found = other.columns.find(name);
    if (found == other.columns.end() || found->second.width != static_cast<std::size_t>(width))
      throw Unfit("has other columns than series.h5");
    values.push_back(found->second.values.data());
  }
  std::vector<double> row(width_);
  for (std::size_t k = 0; k < mark.rows; ++k) {
    for (std::size_t c = 0; c < columns_.size(); ++c)
      std::copy_n(values[c] + k * columns_[c].width, columns_[c].width,
                  row.begin() + static_cast<std::ptrdiff_t>(columns_[c].offset));
    checksum_ = with_row(checksum_, other.time[k], row);
  }
  if (checksum_ != mark.checksum)
    throw Unfit("is of another series.h5");
  for (std::size_t c = 0; c < columns_.size(); ++c)
    file_->write(c + 1, {values[c], mark.rows * columns_[c].width});
  file_->write(0, {other.time.data(), mark.rows});
  file_->commit(mark.rows);
  flushed_ = mark.rows;
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
