// HDF5 layout of a saved contact problem: /W, /free, /points [n, columns], /friction [n], /dim, /shift [n, 3]
// (where there is none, 0), and the laws as text in an attribute. Older files hold RCC laws alone, in
// /adhesions [laws, columns] and /C_t2 [laws].
#include "record/problem_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "record/file.hpp"
#include "record/hdf5.hpp"
#include "record/law_text.hpp"

namespace stiction::record {

namespace {

constexpr hsize_t point_columns = 8;    // area, mu, law, beta, stretch 1, stretch 2, dt, closed
constexpr hsize_t most_packed = 200;    // numbers that a byte of a compressed dataset may stand for
constexpr hsize_t adhesion_columns = 8; // w, C_n, C_t, b, beta0, bonding, friction, damage_power

constexpr hsize_t least_compressed = 512;  // numbers
constexpr hsize_t chunk_numbers = 1 << 17; // 1 MiB

/// Row by row in chunks, bytes shuffled and deflated, if there are enough of them.
hdf5::Handle compression(std::vector<hsize_t> shape, std::size_t count) {
  auto list = hdf5::timeless(H5P_DATASET_CREATE);
  if (count < least_compressed || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0)
    return list;
  shape[0] = std::clamp<hsize_t>(chunk_numbers * shape[0] / count, 1, shape[0]);
  H5Pset_chunk(list, static_cast<int>(shape.size()), shape.data());
  H5Pset_shuffle(list);
  H5Pset_deflate(list, 6);
  return list;
}

bool write(hid_t file, char const* name, std::vector<hsize_t> const& shape,
           std::vector<double> const& values) {
  hdf5::Handle const space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  hdf5::Handle const set(H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                    compression(shape, values.size()), H5P_DEFAULT),
                         H5Dclose);
  return set.valid() && (values.empty() ||
                         H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

std::vector<double> flatten(std::vector<contact::ProblemPoint> const& points) {
  std::vector<double> rows;
  for (auto const& p : points)
    rows.insert(rows.end(),
                {p.area, p.mu, static_cast<double>(p.adhesion), p.bond.old.beta, p.bond.old.stretch[0],
                 p.bond.old.stretch[1], p.bond.dt, p.bond.closed ? 1.0 : 0.0});
  return rows;
}

std::vector<double> frictions_of(std::vector<contact::ProblemPoint> const& points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (auto const& point : points)
    values.push_back(point.friction);
  return values;
}

/// Empty where no point has one.
std::vector<double> shifts(std::vector<contact::ProblemPoint> const& points) {
  std::vector<double> rows;
  bool any = false;
  for (auto const& p : points) {
    rows.insert(rows.end(), {p.shift[0], p.shift[1], p.shift[2]});
    any = any || !p.shift.isZero(0);
  }
  return any ? rows : std::vector<double>{};
}

/// Reads named datasets and checks their sizes and numbers.
class ProblemReader {
public:
  explicit ProblemReader(std::filesystem::path const& path) : path_(path) {
    hdf5::keep_reasons();
    file_ = hdf5::Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, hdf5::file_access()), H5Fclose);
    if (!file_.valid()) {
      auto const reason = hdf5::last_reason();
      bool const foreign = std::filesystem::is_regular_file(path) && H5Fis_hdf5(path.c_str()) == 0;
      refuse("cannot be read as a contact problem (" + (foreign ? "not an HDF5 file" : reason) + ")");
    }
  }
  [[nodiscard]] bool has(char const* name) const { return H5Lexists(file_, name, H5P_DEFAULT) > 0; }
  [[nodiscard]] std::vector<double> read(char const* name) const {
    if (!has(name))
      refuse(fmt::format("has no dataset \"{}\"", name));
    hdf5::Handle const set(H5Dopen2(file_, name, H5P_DEFAULT), H5Dclose);
    hdf5::Handle const space(set.valid() ? H5Dget_space(set) : H5I_INVALID_HID, H5Sclose);
    auto const count = space.valid() ? H5Sget_simple_extent_npoints(space) : -1;
    if (count < 0 || count > 400'000'000 ||
        static_cast<hsize_t>(count) > most_packed * H5Dget_storage_size(set))
      refuse(fmt::format("dataset \"{}\" has no usable size", name));
    std::vector<double> values(static_cast<std::size_t>(count));
    if (count > 0 && H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      refuse(fmt::format("dataset \"{}\" is truncated or not numeric", name));
    for (double const value : values)
      if (!std::isfinite(value))
        refuse(fmt::format("dataset \"{}\" holds a number that is not finite", name));
    return values;
  }
  /// The root's attribute, "" where there is none.
  [[nodiscard]] std::string attribute(char const* name) const { return hdf5::read_attribute(file_, name); }
  [[noreturn]] void refuse(std::string const& why) const {
    throw core::InputError({{path_.string(), "", why + "; give a file saved by output{problems_every = n}"}});
  }
  void require(bool held, char const* what) const {
    if (!held)
      refuse(fmt::format("does not fit together: {}", what));
  }

  /// The number of one of `count` laws, or -1 for none.
  [[nodiscard]] int index(double value, std::size_t count) const {
    require(value >= -1 && value < static_cast<double>(count) && value == std::floor(value),
            "a point's law is out of range");
    return static_cast<int>(value);
  }

private:
  std::filesystem::path path_;
  hdf5::Handle file_;
};

contact::ProblemPoint point_of(double const* row, ProblemReader const& reader, std::size_t laws) {
  contact::ProblemPoint point;
  point.area = row[0];
  point.mu = row[1];
  point.adhesion = reader.index(row[2], laws);
  point.bond = {{row[3], {row[4], row[5]}}, row[6], row[7] != 0};
  reader.require(point.area > 0 && interface::coefficients.contains(point.mu) && point.bond.old.beta >= 0 &&
                     point.bond.old.beta <= 1 && point.bond.dt >= 0,
                 "a point's area, mu, law or bond is out of range");
  return point;
}

/// A row of /adhesions, and of /C_t2, as the text of laws has it.
nlohmann::json law_of(double const* row, double across, ProblemReader const& reader) {
  static constexpr std::array bondings{"contact", "proximity", "never"};
  static constexpr std::array frictions{"full", "damage"};
  reader.require(row[5] >= 0 && row[5] <= 2 && row[6] >= 0 && row[6] <= 1, "an adhesion setting is unknown");
  return {{"kind", "rcc"},
          {"w", row[0]},
          {"C_n", row[1]},
          {"C_t", row[2]},
          {"C_t2", across},
          {"b", row[3]},
          {"beta0", row[4]},
          {"bonding", bondings.at(static_cast<std::size_t>(row[5]))},
          {"friction", frictions.at(static_cast<std::size_t>(row[6]))},
          {"damage_power", row[7]}};
}

/// The laws of an older file.
std::string older_laws(ProblemReader const& reader) {
  auto const adhesions = reader.read("adhesions");
  reader.require(adhesions.size() % adhesion_columns == 0, "size of adhesions");
  auto const across = reader.has("C_t2") ? reader.read("C_t2") : std::vector<double>{};
  reader.require(across.empty() || across.size() == adhesions.size() / adhesion_columns,
                 "sizes of C_t2 and adhesions");
  auto laws = nlohmann::json::array();
  for (std::size_t k = 0; k < adhesions.size(); k += adhesion_columns)
    laws.push_back(
        law_of(&adhesions[k], across.empty() ? adhesions[k + 2] : across[k / adhesion_columns], reader));
  return nlohmann::json{{"adhesions", laws}, {"frictions", nlohmann::json::array()}}.dump();
}

void load_laws(ProblemReader const& reader, contact::Problem& problem) {
  auto const text = reader.attribute("laws");
  if (auto const why = read_laws(text.empty() ? older_laws(reader) : text, problem); !why.empty())
    reader.refuse(why);
}

void load_frictions(ProblemReader const& reader, contact::Problem& problem) {
  if (!reader.has("friction"))
    return;
  auto const values = reader.read("friction");
  reader.require(values.size() == problem.points.size(), "sizes of friction and points");
  for (std::size_t k = 0; k < values.size(); ++k) {
    problem.points[k].friction = reader.index(values[k], problem.frictions.size());
    reader.require(values[k] < 0 || problem.points[k].bond.dt > 0,
                   "a point's friction law needs a time step");
  }
}

/// The layout of friction problem collections: symmetric W packed row by row, q, mu; three components.
contact::Problem load_packed(ProblemReader const& reader) {
  contact::Problem problem;
  problem.dim = 3;
  auto const packed = reader.read("W_upper_packed"), q = reader.read("q"), mu = reader.read("mu");
  auto const n = q.size();
  reader.require(n == 3 * mu.size() && n > 0 && packed.size() == n * (n + 1) / 2,
                 "sizes of W_upper_packed, q and mu");
  problem.free = Eigen::Map<Vector const>(q.data(), static_cast<Eigen::Index>(n));
  Dense& W = problem.W.entries();
  W.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  std::size_t k = 0;
  for (Eigen::Index i = 0; i < W.rows(); ++i)
    for (Eigen::Index j = i; j < W.rows(); ++j)
      W(i, j) = W(j, i) = packed[k++];
  for (double const coefficient : mu) {
    reader.require(interface::coefficients.contains(coefficient),
                   "a friction coefficient is negative, or beyond all");
    problem.points.push_back({1.0, coefficient, -1, {}});
  }
  return problem;
}

} // namespace

void save_problem(std::filesystem::path const& path, contact::Problem const& problem) {
  hdf5::keep_reasons();
  auto const part = part_name(path);
  bool written = false;
  {
    auto const access = hdf5::file_access();
    H5Pset_small_data_block_size(access, 0); // a small file, written once
    hdf5::Handle const file(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, hdf5::timeless(H5P_FILE_CREATE), access),
                            H5Fclose);
    auto const n = static_cast<hsize_t>(problem.free.size());
    auto const& entries = problem.W.dense();
    std::vector<double> const W(entries.data(), entries.data() + entries.size()); // column by column
    std::vector<double> const free(problem.free.data(), problem.free.data() + problem.free.size());
    auto const shift = shifts(problem.points);
    written = file.valid() && write(file, "W", {n, n}, W) && write(file, "free", {n}, free) &&
              write(file, "points", {problem.points.size(), point_columns}, flatten(problem.points)) &&
              write(file, "friction", {problem.points.size()}, frictions_of(problem.points)) &&
              hdf5::write_attribute(file, "laws", text_of_laws(problem)) &&
              (shift.empty() || write(file, "shift", {problem.points.size(), 3}, shift)) &&
              write(file, "dim", {1}, {static_cast<double>(problem.dim)}) &&
              H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0;
  }
  if (!written)
    throw unwritable(path, hdf5::last_reason());
  std::filesystem::rename(part, path);
}

contact::Problem load_problem(std::filesystem::path const& path) {
  ProblemReader const reader(path);
  if (reader.has("W_upper_packed"))
    return load_packed(reader);
  contact::Problem problem;
  auto const dim = reader.read("dim"), W = reader.read("W"), free = reader.read("free");
  auto const points = reader.read("points");
  auto const n = free.size();
  reader.require(dim.size() == 1 && (dim[0] == 1 || dim[0] == 2 || dim[0] == 3), "dim is 1, 2 or 3");
  problem.dim = static_cast<int>(dim[0]);
  reader.require(W.size() == n * n && points.size() % point_columns == 0 &&
                     n == static_cast<std::size_t>(problem.dim) * (points.size() / point_columns),
                 "sizes of W, free and points");
  auto const size = static_cast<Eigen::Index>(n);
  problem.W = Eigen::Map<Dense const>(W.data(), size, size);
  problem.free = Eigen::Map<Vector const>(free.data(), size);
  load_laws(reader, problem);
  for (std::size_t k = 0; k < points.size(); k += point_columns)
    problem.points.push_back(point_of(&points[k], reader, problem.adhesions.size()));
  load_frictions(reader, problem);
  if (reader.has("shift")) {
    auto const values = reader.read("shift");
    reader.require(values.size() == 3 * problem.points.size(), "sizes of shift and points");
    for (std::size_t k = 0; k < problem.points.size(); ++k)
      problem.points[k].shift = Eigen::Map<Eigen::Vector3d const>(&values[3 * k]);
  }
  return problem;
}

} // namespace stiction::record
