// The readers that are fed with arbitrary bytes, by libFuzzer and by the replay of the kept seeds.
#pragma once
#include <string_view>

namespace stiction::fuzz {

/// Each reads the bytes as one kind of input. Refusing them as bad input is fine; anything else is a finding
/// and leaves as an exception or a crash.
void stl(std::string_view bytes);       ///< a surface file
void msh(std::string_view bytes);       ///< a text mesh file, for its triangles
void heights(std::string_view bytes);   ///< a height map, as text or of NumPy
void mesh_file(std::string_view bytes); ///< what the mesher hands over; a tree as in tree.hpp
void problem(std::string_view bytes);   ///< a saved contact problem; a tree as in tree.hpp
void series(std::string_view bytes);    ///< a history; a tree as in tree.hpp
void result(std::string_view bytes);    ///< manifest.json of a case
void script(std::string_view bytes);    ///< a study

} // namespace stiction::fuzz
