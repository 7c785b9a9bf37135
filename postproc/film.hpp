// A field over time as a film.
#pragma once
#include <filesystem>

#include "spec/spec.hpp"

namespace stiction::postproc {

/// Draws a field that has a `film` at its times and writes them as Ogg/Theora: one window and one range of
/// colours hold all frames, each of which tells its time. Throws what draw throws, core::InputError where
/// fewer frames are there than asked for, core::RunError when the file cannot be written.
void write_film(FigureSpec const& figure, std::filesystem::path const& file);

} // namespace stiction::postproc
