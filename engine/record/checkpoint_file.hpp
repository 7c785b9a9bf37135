// The file that holds where a case stands: bytes with all that tells whether they may be taken up.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace stiction::record {

/// What a checkpoint goes with is not there, or it is not what it should be: words that follow its name.
class Unfit : public core::RunError {
  using core::RunError::RunError;
};

/// What must agree with whoever takes a checkpoint up, as texts that others do not have.
struct CheckpointOwner {
  std::string program; ///< its build
  std::string scene;   ///< what the case is made of
};

/// What a checkpoint was found to be.
struct FoundCheckpoint {
  std::string bytes;
  std::string reason; ///< why they cannot be taken up, as words behind the file's name; empty: they can
};

/// CRC-32 of `bytes`, going on from that of what stands before them.
[[nodiscard]] std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

/// Writes the file aside, waits until it is on the disk, and renames it: a kill or a power cut leaves the old
/// file or the new one. Throws core::RunError; the old file stays then.
void write_checkpoint(std::filesystem::path const& path, CheckpointOwner const& owner,
                      std::string_view bytes);

/// Nothing where there is no file.
[[nodiscard]] std::optional<FoundCheckpoint> read_checkpoint(std::filesystem::path const& path,
                                                             CheckpointOwner const& owner);

} // namespace stiction::record
