// Bodies put into frames, and the list of frames over time.
#include "record/fields.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "record/checkpoint_file.hpp"
#include "record/file.hpp"

namespace stiction::record {

namespace {

/// "000123.vtu" or .vti: only such files are ours to remove.
bool is_frame(std::filesystem::path const& path) {
  std::string const stem = path.stem().string();
  return (path.extension() == ".vtu" || path.extension() == ".vti") && stem.size() == 6 &&
         stem.find_first_not_of("0123456789") == std::string::npos;
}

std::string name_of_frame(std::size_t number, char const* extension) {
  return fmt::format("fields/{:06}{}", number, extension);
}

/// Those from `first` on.
void remove_frames(std::filesystem::path const& folder, std::size_t first) {
  std::error_code error; // a frame that cannot be removed is overwritten or reported when written
  std::vector<std::filesystem::path> frames;
  for (auto const& entry : std::filesystem::directory_iterator(folder, error))
    if (is_frame(entry.path()) && std::stoul(entry.path().stem().string()) >= first)
      frames.push_back(entry.path());
  for (auto const& frame : frames)
    std::filesystem::remove(frame, error);
  std::filesystem::remove(folder, error); // if nothing is left in it
}

} // namespace

std::size_t FieldFrame::cell_count() const {
  std::size_t count = 0;
  for (auto const& block : blocks)
    count += block.nodes.size() / static_cast<std::size_t>(mesh::info(block.kind).nodes);
  return count;
}

void add_body(FieldFrame& frame, mesh::Mesh const& mesh) {
  auto const first = static_cast<Index>(frame.points.rows());
  double const body = frame.cell_body.empty() ? 0 : frame.cell_body.back() + 1;
  frame.points.conservativeResize(first + mesh.nodes.rows(), 3);
  frame.points.bottomRows(mesh.nodes.rows()).setZero();
  frame.points.block(first, 0, mesh.nodes.rows(), mesh.nodes.cols()) = mesh.nodes;
  for (auto block : mesh.blocks) {
    for (Index& node : block.nodes)
      node += first;
    frame.blocks.push_back(std::move(block));
  }
  frame.cell_body.resize(frame.cell_count(), body);
}

FieldSeries::FieldSeries(std::filesystem::path case_folder, FieldMark from)
    : folder_(std::move(case_folder)), done_(std::move(from)) {
  bool const grids = done_.entries.find(".vti") != std::string::npos;
  for (std::size_t k = 0; k < done_.count; ++k)
    if (auto const name = name_of_frame(k, grids ? ".vti" : ".vtu"); !std::filesystem::exists(folder_ / name))
      throw Unfit(fmt::format("wants {}, which is gone", name));
  std::error_code ignored;
  if (done_.count > 0)
    write_list();
  else
    std::filesystem::remove(folder_ / "fields.pvd", ignored); // first: it must not list what is gone
  remove_frames(folder_ / "fields", done_.count);
}

void FieldSeries::write_list() const {
  replace_file(folder_ / "fields.pvd",
               fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
                           "byte_order=\"LittleEndian\">\n<Collection>\n{}</Collection>\n</VTKFile>\n",
                           done_.entries));
}

template<class Write> void FieldSeries::write_next(double time, char const* extension, Write const& write) {
  auto const name = name_of_frame(done_.count, extension);
  if (done_.count == 0)
    prepare_output(folder_ / "fields");
  write(folder_ / name);
  done_.entries += fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", time, name);
  ++done_.count;
  write_list();
}

void FieldSeries::write(FieldFrame const& frame) {
  write_next(frame.time, ".vtu", [&](std::filesystem::path const& path) { write_vtu(path, frame); });
}

void FieldSeries::write(GridFrame const& frame) {
  write_next(frame.time, ".vti", [&](std::filesystem::path const& path) { write_vti(path, frame); });
}

} // namespace stiction::record
