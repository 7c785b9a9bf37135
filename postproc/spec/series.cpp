// Reading with the HDF5 C API; every dataset carries its unit as an attribute.
#include "spec/series.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <hdf5.h>

#include "core/error.hpp"
#include "core/handle.hpp"

namespace stiction::postproc {

namespace {

using core::Handle;

struct Column {
  std::vector<double> values; ///< SI, or the axis unit when they stood in the spec
  std::string unit = "1";
};

std::string fixed_text(hid_t attribute, hid_t type) {
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    return "";
  return text.substr(0, text.find('\0'));
}

std::string variable_text(hid_t attribute, hid_t type) {
  char* text = nullptr;
  if (H5Aread(attribute, type, &text) < 0 || text == nullptr)
    return "";
  std::string copy = text;
  H5free_memory(text);
  return copy;
}

std::string unit_of(hid_t dataset, std::string const& where) {
  if (H5Aexists(dataset, "unit") <= 0)
    throw core::RunError(fmt::format("{}: has no attribute \"unit\"", where));
  Handle const attribute(H5Aopen(dataset, "unit", H5P_DEFAULT), H5Aclose);
  Handle const type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING)
    throw core::RunError(fmt::format("{}: the attribute \"unit\" is not a text", where));
  return H5Tis_variable_str(type) > 0 ? variable_text(attribute, type) : fixed_text(attribute, type);
}

/// Rows and columns of a dataset; a vector has one column.
std::pair<hsize_t, hsize_t> shape_of(hid_t dataset, std::string const& where) {
  Handle const space(H5Dget_space(dataset), H5Sclose);
  int const rank = H5Sget_simple_extent_ndims(space);
  if (rank != 1 && rank != 2)
    throw core::RunError(fmt::format("{}: has {} dimensions; 1 or 2 are wanted", where, rank));
  hsize_t extent[2] = {0, 1};
  H5Sget_simple_extent_dims(space, extent, nullptr);
  return {extent[0], extent[1]};
}

Column read_column(std::filesystem::path const& file, std::string const& name, std::size_t component) {
  std::string const where = fmt::format("{}: dataset {}", file.string(), name);
  if (!std::filesystem::exists(file))
    throw core::RunError(fmt::format("{}: no such file; run its study first", file.string()));
  Handle const handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (handle < 0)
    throw core::RunError(fmt::format("{}: is not a readable HDF5 file", file.string()));
  Handle const dataset(H5Dopen2(handle, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (dataset < 0)
    throw core::RunError(fmt::format("{} is not there", where));
  auto const [rows, columns] = shape_of(dataset, where);
  if (component >= columns)
    throw core::InputError(
        fmt::format("{}: component {} is asked for, but it has {}", where, component, columns));
  std::vector<double> all(rows * columns);
  if (!all.empty() && H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0)
    throw core::RunError(fmt::format("{} cannot be read as numbers", where));
  Column column{{}, unit_of(dataset, where)};
  for (std::size_t row = 0; row < rows; ++row)
    column.values.push_back(all[row * columns + component]);
  return column;
}

void check_finite(std::vector<double> const& values, std::string const& where) {
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isfinite(values[row]))
      throw core::RunError(
          fmt::format("{}: value {} is {}; only finite numbers can be drawn", where, row + 1, values[row]));
}

std::vector<double> load_coordinate(CurveSpec const& curve, CoordinateSpec const& spec, AxisSpec const& axis,
                                    std::size_t component) {
  if (spec.dataset.empty()) {
    check_finite(spec.numbers, fmt::format("curve \"{}\"", curve.label));
    return spec.numbers;
  }
  auto column = read_column(curve.file, spec.dataset, component);
  std::string const where = fmt::format("{}: dataset {}", curve.file.string(), spec.dataset);
  auto const unit = core::parse_unit(column.unit);
  if (!unit)
    throw core::RunError(fmt::format("{}: its unit \"{}\" is not known", where, column.unit));
  if (unit->dimension != axis.unit.si.dimension)
    throw core::InputError(fmt::format("{} is in {} [{}], but its axis \"{}\" is in {} [{}]", where,
                                       column.unit, core::to_string(unit->dimension), axis.label,
                                       axis.unit.word, core::to_string(axis.unit.si.dimension)));
  check_finite(column.values, where);
  for (auto& value : column.values)
    value = spec.sign * (value * unit->value - spec.shift) / axis.unit.si.value;
  return column.values;
}

/// The place of a colour in the order of all colours of the figure, 0 to 0.9: the palest end is left out.
double fraction_of(std::size_t colour, LinesSpec const& figure) {
  std::size_t low = colour, high = colour;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    low = std::min(low, figure.curves[i].colour.value_or(i));
    high = std::max(high, figure.curves[i].colour.value_or(i));
  }
  return high == low ? 0 : 0.9 * static_cast<double>(colour - low) / static_cast<double>(high - low);
}

/// The n-th curve of a figure: by colour while they last, then by dash as well; sequential colours do not
/// end.
Pen pen_of(CurveSpec const& spec, std::size_t index, LinesSpec const& figure) {
  static constexpr Dash order[] = {Dash::solid, Dash::dash, Dash::dot, Dash::dash_dot};
  std::size_t const colour = spec.colour.value_or(index);
  if (figure.sequential)
    return {viridis(fraction_of(colour, figure)), points(curve_width), spec.dash.value_or(Dash::solid)};
  return {palette(colour), points(curve_width), spec.dash.value_or(order[colour / palette_size % 4])};
}

} // namespace

Curve load_curve(CurveSpec const& spec, std::size_t index, LinesSpec const& figure) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // failures are reported in our words
  auto const x = load_coordinate(spec, spec.x, figure.x, 0);
  auto const y = load_coordinate(spec, spec.y, figure.y, spec.component);
  Curve curve{spec.label, pen_of(spec, index, figure), {}, {}, {}, {}};
  bool const bars = !spec.x_error.empty() || !spec.y_error.empty();
  auto const error = [](std::vector<double> const& errors, std::size_t i) {
    return errors.empty() ? 0 : errors[i];
  };
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if ((!figure.x.log || x[i] > 0) && (!figure.y.log || y[i] > 0)) {
      curve.points.push_back({x[i], y[i]});
      if (bars)
        curve.errors.push_back({error(spec.x_error, i), error(spec.y_error, i)});
      if (!spec.names.empty())
        curve.names.push_back(spec.names[i]);
      if (!spec.at_most.empty())
        curve.at_most.push_back(spec.at_most[i] != 0);
    }
  if (curve.points.empty())
    throw core::RunError(fmt::format("curve \"{}\"{}: has no point to draw", spec.label,
                                     spec.file.has_filename() ? " of " + spec.file.string() : ""));
  if (curve.points.size() == 1)
    curve.pen.dash = Dash::points; // a line of one point would not be seen
  return curve;
}

} // namespace stiction::postproc
