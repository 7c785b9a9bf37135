// Loops that the threads of a process share, with the same results however many there are.
#pragma once
#include <algorithm>
#include <array>

#include "core/types.hpp"

namespace stiction::core {

/// From now on loops are shared by so many threads, the caller's among them; until then by it alone. Not
/// within a loop. A process that is forked afterwards has one of them and must not loop.
void use_threads(int count);
[[nodiscard]] int threads();

namespace detail {
void share(Index count, void (*call)(void const* act, Index i), void const* act);
} // namespace detail

/// act(0), ... act(count - 1), each once, begun in this order and run at the same time: none may write what
/// another touches, but may wait for those before it. Within another loop they come one after the other.
/// Throws what the first of those threw that threw; then not all have been called.
template<class Act> void each(Index count, Act const& act) {
  if (count > 1 && threads() > 1)
    return detail::share(
        count, [](void const* one, Index i) { (*static_cast<Act const*>(one))(i); }, &act);
  for (Index i = 0; i < count; ++i)
    act(i);
}

/// act(first, last) for pieces of 0 ... n - 1, the same ones whatever the number of threads: at least `least`
/// long, but for the last, and most_pieces at most.
inline constexpr Index most_pieces = 64;
template<class Act> void each_piece(Index n, Index least, Act const& act) {
  Index const size = std::max(least, (n + most_pieces - 1) / most_pieces);
  each((n + size - 1) / size, [&](Index k) { act(k * size, std::min(n, (k + 1) * size)); });
}

/// The number of the piece that begins with `first`.
[[nodiscard]] constexpr Index piece_of(Index n, Index least, Index first) {
  return first / std::max(least, (n + most_pieces - 1) / most_pieces);
}

/// Sum of part(first, last) over such pieces, in their order.
template<class Part> [[nodiscard]] double sum_of_pieces(Index n, Index least, Part const& part) {
  std::array<double, most_pieces> parts{};
  each_piece(n, least,
             [&](Index first, Index last) { parts[ix(piece_of(n, least, first))] = part(first, last); });
  double sum = 0;
  for (double const one : parts)
    sum += one;
  return sum;
}

} // namespace stiction::core
