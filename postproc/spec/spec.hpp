// What is to be drawn, as read from a SPEC.json.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/unit.hpp"
#include "page/canvas.hpp"

namespace stiction::postproc {

using Interval = std::optional<std::pair<double, double>>;

/// A unit word with what it means.
struct Unit {
  std::string word = "1";
  core::Quantity si{1, {}};
};

struct AxisSpec {
  std::string label;
  Unit unit;
  bool log = false;
  Interval range; ///< in the unit
};

/// One coordinate of a curve: a dataset of an HDF5 file, or numbers in the axis unit.
struct CoordinateSpec {
  std::string dataset; ///< empty: `numbers` hold the values
  std::vector<double> numbers;
  double shift = 0; ///< subtracted first, in SI
  double sign = 1;
};

struct CurveSpec {
  std::string label;
  std::filesystem::path file;
  CoordinateSpec x, y;
  std::vector<double> x_error,
      y_error;                    ///< half lengths of the bars at the points, in the axis unit; empty: none
  std::vector<std::string> names; ///< beside the points; empty: none
  std::vector<double> at_most;    ///< not 0: the point lies here or below; empty: none does
  std::size_t component = 0;      ///< column of y when it has several
  std::optional<std::size_t> colour;
  std::optional<Dash> dash;
};

struct MarkSpec {
  double x = 0; ///< in the unit of the x axis
  std::string label;
};

struct LinesSpec {
  AxisSpec x, y;
  bool sequential = false; ///< colours along viridis in the order of the curves
  std::string legend;      ///< a corner, "below", "none", or "" for the first place free of curves
  std::vector<CurveSpec> curves;
  std::vector<MarkSpec> marks;
};

struct ScaleBarSpec {
  double length = 0;
  Unit unit;
};

using Vector = std::array<double, 3>;

/// From where a solid is seen: azimuth 0 looks along y, 90 against x; elevation 90 looks down z.
struct ViewSpec {
  double azimuth = 30, elevation = 25; ///< degrees
};

/// xmin, xmax, ymin, ymax, zmin, zmax in m; an empty side is open.
using CropBox = std::array<std::optional<double>, 6>;

/// Displacements at `times` (s), in m, straight in between.
struct PathSpec {
  std::vector<double> times;
  std::array<std::vector<double>, 3> moves; ///< x, y, z; each empty or as long as `times`
  std::vector<double> angle;                ///< rad, likewise
};

/// A rigid sphere, its lengths in m.
struct SphereSpec {
  Vector centre{};
  double radius = 0;
  PathSpec path;
};

/// A rigid obstacle in a plane picture, its lengths in m: a disc, a half-plane or an outline.
struct ObstacleSpec {
  double radius = 0;           ///< > 0: a disc about `at`
  std::optional<Point> normal; ///< outward, of a half-plane through `at`
  std::vector<Point> outline;
  bool closed = false; ///< the outline
  bool hollow = false; ///< the inside is what is touched
  Point at, pivot;     ///< it turns about the pivot
  PathSpec path;
};

/// A field over time: its frames, spread evenly over those that there are.
struct FilmSpec {
  int frames = 0; ///< 0: all
  int rate = 10;  ///< a second
};

struct FieldSpec {
  std::filesystem::path file;
  std::optional<double> time; ///< s; nothing: the last step
  std::string array;
  std::optional<int> component; ///< nothing: the magnitude
  std::string label;
  Unit unit;
  bool deformed = false, mesh = true, show_time = true;
  Interval range;             ///< in the unit
  std::vector<double> window; ///< xmin, xmax, ymin, ymax in m, in the plane of the picture; empty: all
  std::optional<ScaleBarSpec> scale_bar;
  std::optional<ViewSpec> view; ///< nothing: a plane mesh seen along z
  std::vector<int> mirror;      ///< axes 0, 1, 2 across whose plane the mesh is repeated, in this order
  CropBox crop;
  std::optional<SphereSpec> sphere;
  std::vector<ObstacleSpec> obstacles;
  std::optional<FilmSpec> film; ///< all in one window and one range, instead of one picture
};

/// An outcome that cells of a map show: a letter, what it means, its colour in the palette.
struct MapKind {
  std::string letter, label;
  std::size_t colour = 0;
};

struct MapRow {
  std::string group, label;
  std::string cells; ///< a letter of a kind per column, or '.' for no cell
};

struct MapSpec {
  int blocks = 1; ///< side by side, the rows shared out
  std::vector<std::string> columns;
  std::vector<MapKind> kinds;
  std::vector<MapRow> rows;
};

struct FigureSpec;
struct PanelSpec {
  int columns = 2;
  bool common_range = false; ///< of fields of one array and unit that leave theirs open
  std::vector<FigureSpec> figures;
};

/// Least room between a plot and the edges of its picture, pixels.
struct Margins {
  double left = 0, right = 0, bottom = 0, top = 0;
};

struct FigureSpec {
  std::string name, title;
  int dpi = 300;      ///< of the PNG; layouts count pixels at 300
  bool svg = false;   ///< the same as lines too
  bool pdf = false;   ///< the same with letters as text
  Margins margins;    ///< of a plot beside others
  int width = 0;      ///< pixels
  double height = 0;  ///< pixels; 0: chosen
  std::string letter; ///< "(a)" within a panel
  std::variant<LinesSpec, FieldSpec, MapSpec, PanelSpec> content;
};

/// "(a) title", or what there is of it.
[[nodiscard]] inline std::string heading(FigureSpec const& figure) {
  bool const both = !figure.letter.empty() && !figure.title.empty();
  return figure.letter + (both ? " " : "") + figure.title;
}

/// Reads and checks a whole spec; paths become relative to its folder.
/// Throws core::InputError with every problem found.
[[nodiscard]] std::vector<FigureSpec> read_spec(std::filesystem::path const& file);

} // namespace stiction::postproc
