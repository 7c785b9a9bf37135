// Opening, refusing and replacing a checkpoint.
#include "scene/run/checkpoint.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "record/file.hpp"
#include "scene/description/human.hpp"

namespace stiction::scene {

Story Story::anew() {
  Story story;
  story.started = record::utc_now();
  story.processors = {record::host_facts()["processor"]};
  return story;
}

void Story::go_on(double time, long steps, Checkpoint const& checkpoint) {
  if (kept.empty())
    return; // a further pass of this process
  checkpoint.tell(fmt::format("goes on from t = {}, step {}{}, where it stood at {}", human(time, "s"), steps,
                              pass > 1 ? fmt::format(" of pass {} over finer meshes", pass) : "", kept));
  continued.push_back({record::utc_now(), time, steps});
  kept.clear();
  std::string const here = record::host_facts()["processor"];
  if (std::ranges::find(processors, here) == processors.end())
    processors.push_back(here);
}

void Story::begin_pass(CellSizes finer) {
  ++pass;
  sizes = std::move(finer);
  under_way = false;
}

void Story::add_remarks(std::vector<std::string>& remarks) const {
  if (processors.size() > 1)
    remarks.push_back(
        fmt::format("it was continued on another processor ({}): its last digits may not be those "
                    "of a run without a stop",
                    fmt::join(processors, ", then ")));
}

nlohmann::json Story::continuations() const {
  auto all = nlohmann::json::array();
  for (auto const& one : continued)
    all.push_back({{"at", one.at}, {"time", one.time}, {"steps", one.steps}});
  return all;
}

std::uint32_t mesh_checksum(dynamics::Model const& model) {
  auto const bytes = [](auto const* data, std::size_t count) {
    return std::string_view(reinterpret_cast<char const*>(data), count * sizeof *data);
  };
  auto sum =
      record::checksum(bytes(model.reference.data(), static_cast<std::size_t>(model.reference.size())));
  for (auto const& body : model.bodies)
    for (auto const& block : body->mesh.blocks)
      sum = record::checksum(bytes(block.nodes.data(), block.nodes.size()), sum);
  return sum;
}

Story Checkpoint::open() {
  if (!wanted())
    return Story::anew();
  std::error_code ignored;
  for (auto part = record::part_name(keeping_->file); auto const& name : {part, record::part_name(part)})
    std::filesystem::remove(name, ignored); // of one that was killed as it wrote
  auto found = keeping_->anew ? std::nullopt : record::read_checkpoint(keeping_->file, keeping_->owner);
  if (!found) {
    std::filesystem::remove(keeping_->file, ignored);
    return Story::anew();
  }
  Story story;
  try {
    if (found->reason.empty()) {
      bytes_ = std::move(found->bytes);
      record::ByteReader archive(bytes_);
      archive(story);
      behind_ = archive.left();
      return story;
    }
  } catch (record::Unfit const&) {
    found->reason = "is damaged";
  }
  refuse(found->reason);
  return Story::anew();
}

record::ByteReader Checkpoint::rest() const {
  return record::ByteReader(std::string_view(bytes_).substr(bytes_.size() - behind_));
}

void Checkpoint::refuse(std::string const& why) const {
  std::error_code ignored;
  std::filesystem::remove(keeping_->file, ignored);
  tell(fmt::format("the checkpoint {} {}: the case starts anew", keeping_->file.string(), why));
}

void Checkpoint::tell(std::string const& text) const {
  if (keeping_->tell)
    keeping_->tell(text);
}

bool Checkpoint::due() const {
  return wanted() &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - last_).count() >= keeping_->every;
}

bool Checkpoint::stands() const {
  std::error_code ignored;
  return wanted() && std::filesystem::exists(keeping_->file, ignored);
}

bool Checkpoint::put(std::string const& bytes) {
  try {
    record::write_checkpoint(keeping_->file, keeping_->owner, bytes);
  } catch (core::RunError const& error) {
    if (!std::exchange(told_, true))
      tell(fmt::format("where the case stands is not kept: {}", error.what()));
    last_ = std::chrono::steady_clock::now();
    return false;
  }
  last_ = std::chrono::steady_clock::now();
  return true;
}

} // namespace stiction::scene
