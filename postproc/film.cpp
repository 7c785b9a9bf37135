// Twice through the frames: what all of them show, then each as a picture.
#include "film.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include "core/error.hpp"
#include "fields/field.hpp"
#include "fields/field_data.hpp"
#include "figure.hpp"

namespace stiction::postproc {

namespace {

/// The times to show, the first and the last among them.
std::vector<double> chosen_times(FieldSpec const& field) {
  auto const all = times_of(field.file);
  auto const wanted = static_cast<std::size_t>(field.film->frames);
  if (all.size() < 2 || wanted == 1 || wanted > all.size())
    throw core::InputError(fmt::format(
        "{} has {} frame{}, and a film of {} is wanted; ask for 2 to as many as there are, and for "
        "more of them when the case runs: output{{frames = ...}}",
        field.file.string(), all.size(), all.size() == 1 ? "" : "s",
        wanted == 0 ? "all" : std::to_string(wanted)));
  if (wanted == 0)
    return all;
  std::vector<double> times;
  for (std::size_t i = 0; i < wanted; ++i)
    times.push_back(all[(2 * i * (all.size() - 1) + wanted - 1) / (2 * (wanted - 1))]);
  return times;
}

/// With the window and the range that hold all of these times, where the figure leaves them open.
FieldSpec with_common_scales(FieldSpec field, std::vector<double> const& times) {
  Extent view;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (double const time : times) {
    field.time = time;
    auto const data = load_field(field);
    low = std::min(low, data.low);
    high = std::max(high, data.high);
    view.x[0] = std::min(view.x[0], data.view.x[0]);
    view.x[1] = std::max(view.x[1], data.view.x[1]);
    view.y[0] = std::min(view.y[0], data.view.y[0]);
    view.y[1] = std::max(view.y[1], data.view.y[1]);
  }
  if (!field.range)
    field.range = colour_range(low, high);
  if (field.window.empty())
    field.window = {view.x[0], view.x[1], view.y[0], view.y[1]};
  return field;
}

/// White where the picture is smaller; sides are even, as the film stores colours of 2 x 2 pixels.
Picture fitted(Picture const& picture, int width, int height) {
  auto page = blank(width, height);
  auto const whole = width_of(picture) <= width && height_of(picture) <= height;
  core::expect(whole, "frames of one size");
  paste(picture, page, 0, 0);
  return page;
}

int even(int pixels) {
  return pixels + pixels % 2;
}

} // namespace

void write_film(FigureSpec const& figure, std::filesystem::path const& file) {
  auto const times = chosen_times(std::get<FieldSpec>(figure.content));
  auto own = figure;
  auto& field =
      own.content.emplace<FieldSpec>(with_common_scales(std::get<FieldSpec>(figure.content), times));
  auto const part = std::filesystem::path(file).concat(".part");
  std::error_code problem;
  vtkNew<vtkOggTheoraWriter> writer;
  writer->SetFileName(part.c_str());
  writer->SetRate(field.film->rate);
  writer->SetQuality(2);
  writer->SetSubsampling(1); // what all players show
  int width = 0, height = 0;
  for (double const time : times) {
    field.time = time;
    auto const picture = shoot(draw(own), own.dpi);
    if (width == 0) {
      width = even(width_of(picture));
      height = even(height_of(picture));
    }
    auto const frame = fitted(picture, width, height);
    writer->SetInputData(frame);
    if (time == times.front())
      writer->Start();
    writer->Write();
    if (writer->GetError() != 0)
      break;
  }
  bool const failed = writer->GetError() != 0;
  writer->End();
  if (!failed && std::filesystem::file_size(part, problem) > 0 && !problem) {
    std::filesystem::rename(part, file, problem);
    if (!problem)
      return;
  }
  std::filesystem::remove(part, problem);
  throw core::RunError(
      fmt::format("cannot write {}: is the folder writable and the disk not full?", file.string()));
}

} // namespace stiction::postproc
