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
                char const* key, double rest) {
  if (!reader.has(key) || (times.empty() && reader.has("times") && !is_empty(reader, "times")) ||
      (values.empty() && !is_empty(reader, key)))
    return; // what could not be read has its own complaint
  if (values.size() != times.size() || times.empty())
    return reader.complain_at(
        key, fmt::format("has {} values for {} times; give one value per time", values.size(), times.size()));
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] <= times[k - 1])
      return reader.complain_at("times", fmt::format("must grow; entry {} does not", k + 1));
  if (!values.empty() && times.front() > 0 && values.front() != rest)
    reader.complain_at(
        "times", fmt::format("begin at {:g} s, where {} is {:g}, not {:g} as at the start; give the path a "
                             "first point at 0 s",
                             times.front(), key, values.front(), rest));
}

} // namespace stiction::scene
