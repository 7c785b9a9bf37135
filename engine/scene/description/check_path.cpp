// Checks of values along times.
#include "scene/description/check_path.hpp"

#include <fmt/format.h>

namespace stiction::scene {

namespace {

bool is_empty(core::Reader& reader, char const* key) {
  auto const* list = reader.at(key, core::Need::optional).list();
  return list != nullptr && list->empty();
}

} // namespace

void check_path(core::Reader& reader, core::Numbers const& times, core::Numbers const& values,
                char const* key) {
  if (!reader.has(key) || (times.empty() && reader.has("times") && !is_empty(reader, "times")) ||
      (values.empty() && !is_empty(reader, key)))
    return; // what could not be read has its own complaint
  if (values.size() != times.size() || times.empty())
    reader.complain_at(
        key, fmt::format("has {} values for {} times; give one value per time", values.size(), times.size()));
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] <= times[k - 1])
      return reader.complain_at("times", fmt::format("must grow; entry {} does not", k + 1));
}

} // namespace stiction::scene
