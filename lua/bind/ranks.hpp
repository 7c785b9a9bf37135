// A case on several ranks: what starts them, and one of them among the others.
#pragma once
#include <string>
#include <vector>

#include "bind/command_line.hpp"
#include "linear/ranks.hpp"

namespace stiction::bind {

/// Why this program cannot start ranks, and what changes that; "" if it can.
[[nodiscard]] std::string why_no_ranks();

/// True of the words of a case that several ranks are to share, each of which has yet to be started.
[[nodiscard]] bool starts_ranks(CommandLine const& line);
/// This process becomes what starts them (mpirun): each runs these words as one of them.
[[noreturn]] void become_ranks(CommandLine const& line, std::vector<std::string> words);

/// Joins the others, if the line says that this is one of several ranks. What others than the first print is
/// not heard of.
void join_ranks(CommandLine const& line);
/// Those that this process has joined, or null.
[[nodiscard]] linear::Ranks const* ranks();
/// A line for whoever started the ranks: the first one's goes out at once, another's is its last word if it
/// has to end all.
void tell_of_ranks(std::string const& line);
/// Ends this rank with the others, or, where they do not come to their end, these too; the exit code.
[[nodiscard]] int leave_ranks(int code);

} // namespace stiction::bind
