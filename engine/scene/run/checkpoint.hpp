// Where a case stands, on its way to the checkpoint's file and back.
#pragma once
#include <chrono>
#include <nlohmann/json.hpp>

#include "record/archive.hpp"
#include "record/manifest.hpp"
#include "scene/run/remesh.hpp"
#include "scene/run/run.hpp"

namespace stiction::scene {

class Checkpoint;

/// One time that a case was taken up.
struct Continuation {
  std::string at;  ///< UTC
  double time = 0; ///< of the simulated problem, s
  long steps = 0;  ///< made before
  template<class Archive> void visit(Archive& archive) {
    auto& [when, where, made] = *this;
    archive(when, where, made);
  }
};

/// What a case has behind it beside the present pass over its schedule.
struct Story {
  int pass = 1;
  CellSizes sizes;                     ///< of the meshes of this pass, where they are not the scene's
  std::string meshes = "[]";           ///< of the passes before, for the manifest
  double cells_evaluated = 0;          ///< by them
  std::uint32_t mesh = 0;              ///< checksum of this pass's meshes
  std::string started, kept;           ///< UTC
  std::vector<std::string> processors; ///< that it has run on
  std::vector<Continuation> continued;
  bool under_way = false; ///< is it taken up within this pass?
  template<class Archive> void visit(Archive& archive) {
    auto& [number, cells, before, evaluated, checksum, first, last, on, times, begun] = *this;
    archive(number, cells, before, evaluated, checksum, first, last, on, times, begun);
  }
  /// That of a case which begins now, here.
  [[nodiscard]] static Story anew();
  /// It is taken up there and here, and says so.
  void go_on(double time, long steps, Checkpoint const& checkpoint);
  /// The next pass is to begin.
  void begin_pass(CellSizes finer);
  void add_remarks(std::vector<std::string>& remarks) const;
  [[nodiscard]] nlohmann::json continuations() const;
};

/// Checksum of nodes and cells of all bodies.
[[nodiscard]] std::uint32_t mesh_checksum(dynamics::Model const& model);

/// The checkpoint of one case.
class Checkpoint {
public:
  explicit Checkpoint(Keeping const& keeping) : keeping_(&keeping) {}
  /// What was kept, else a new story; tells why, if it does not fit. Then it is gone, as what it goes with
  /// will be.
  [[nodiscard]] Story open();
  /// Behind the story that was opened.
  [[nodiscard]] record::ByteReader rest() const;
  /// What was opened cannot be gone on with. why: words that follow the file's name.
  void refuse(std::string const& why) const;
  void tell(std::string const& text) const;
  /// Is it time to keep where the case stands?
  [[nodiscard]] bool due() const;
  [[nodiscard]] bool wanted() const { return !keeping_->file.empty(); }
  /// Another rank keeps it: counts as kept.
  [[nodiscard]] bool pass_over() {
    last_ = std::chrono::steady_clock::now();
    return true;
  }
  /// Is there one to go on from?
  [[nodiscard]] bool stands() const;
  /// Puts a story without a pass under way in place of what is kept.
  void keep(Story const& story) {
    if (wanted())
      static_cast<void>(keep(story, [](auto&) {}));
  }
  /// Puts a story, and what `write(archive)` adds, in place of what is kept. False, and told, if it cannot.
  template<class Write> bool keep(Story story, Write const& write) {
    record::ByteWriter archive;
    story.kept = record::utc_now();
    archive(story);
    write(archive);
    return put(archive.bytes());
  }

private:
  bool put(std::string const& bytes);

  Keeping const* keeping_;
  std::string bytes_;
  std::size_t behind_ = 0; ///< bytes after the story
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool told_ = false; ///< that it cannot be written
};

} // namespace stiction::scene
