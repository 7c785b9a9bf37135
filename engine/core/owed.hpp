// What the alternatives of a variant owe its visitors, asked of one after another when it is compiled.
#pragma once
#include <concepts>
#include <type_traits>
#include <variant>

#include "core/schema.hpp"

namespace stiction::core {

/// Has a description, from which reader, messages, help and manifest are made, and can be filled by it.
template<class T>
concept Described = std::default_initializable<T> && std::copyable<T> && requires {
  { T::schema() } -> std::same_as<Schema const&>;
};

/// Asks `Owed<T>`, whose static_asserts say in words what T lacks, of every alternative T of the variant.
template<class Choice, template<class> class Owed> inline constexpr bool every = false;
template<class... T, template<class> class Owed>
inline constexpr bool every<std::variant<T...>, Owed> = (Owed<T>::given && ...);

} // namespace stiction::core
