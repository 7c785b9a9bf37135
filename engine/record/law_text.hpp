// The laws of a contact problem as text, each parameter by its name.
#pragma once
#include <string>

#include "contact/problem/problem.hpp"

namespace stiction::record {

/// The problem's adhesion and friction laws as JSON; numbers keep every digit.
[[nodiscard]] std::string text_of_laws(contact::Problem const& problem);

/// Sets the laws from such a text; parameters that it does not name keep their defaults. The reason where it
/// is none, else "".
[[nodiscard]] std::string read_laws(std::string const& text, contact::Problem& problem);

} // namespace stiction::record
