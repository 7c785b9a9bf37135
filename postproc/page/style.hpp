// The looks that all figures share: sizes in print, fonts, colours.
#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace stiction::postproc {

/// Pixels of a length in print, at 300 dots per inch.
inline constexpr int dots_per_inch = 300;
constexpr double points(double length) {
  return length * dots_per_inch / 72.0;
}
constexpr double millimetres(double length) {
  return length * dots_per_inch / 25.4;
}

/// What VTK is told, so that its text sizes are whole pixels: at 72 dots per inch a point is a pixel.
inline constexpr int text_dpi = 72;

/// Text heights, in points.
inline constexpr double title_size = 8.5, label_size = 8, tick_size = 7, legend_size = 7;
/// Line widths, in points.
inline constexpr double curve_width = 1.4, frame_width = 0.6, grid_width = 0.35, mesh_width = 0.25,
                        error_width = 0.8;
/// White space along the edges of a picture, in points.
inline constexpr double edge = 3;

struct Colour {
  unsigned char red = 0, green = 0, blue = 0;
};
inline constexpr Colour black{0, 0, 0}, white{255, 255, 255}, ink{38, 38, 38}, grid_grey{222, 222, 222},
    mark_grey{110, 110, 110}, mesh_light{215, 215, 215}, obstacle_grey{226, 226, 226};

/// Colours that stay apart for the colour-blind (Okabe and Ito 2008), the pale yellow left out; repeats
/// after 7.
[[nodiscard]] Colour palette(std::size_t index);
inline constexpr std::size_t palette_size = 7;

/// The viridis map (van der Walt and Smith 2015), between 16 of its colours; `fraction` in [0, 1].
[[nodiscard]] Colour viridis(double fraction);

/// "N/m^2" -> "N/m²", "um" -> "µm"; a pure number gives "".
[[nodiscard]] std::string printed_unit(std::string const& unit);
/// −12 -> "⁻¹²".
[[nodiscard]] std::string superscript(int exponent);
/// "time [ms]", or the label alone for a pure number; `power` adds a factor: "[10⁻⁶ J]".
[[nodiscard]] std::string axis_title(std::string const& label, std::string const& unit, int power);

} // namespace stiction::postproc
