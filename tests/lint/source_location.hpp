// Gives clang-tidy the std::source_location that libstdc++ shows to compilers with GCC's builtin only.
#pragma once
#if defined(__clang__) && !__has_builtin(__builtin_source_location)
namespace std { // NOLINT: a stand-in for the standard's own
struct source_location {
  static constexpr source_location current() noexcept { return {}; }
  [[nodiscard]] constexpr unsigned line() const noexcept { return 0; }
  [[nodiscard]] constexpr char const* file_name() const noexcept { return ""; }
  [[nodiscard]] constexpr char const* function_name() const noexcept { return ""; }
};
} // namespace std
#endif
