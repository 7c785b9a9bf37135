// stiction-figures SPEC.json --out DIR: draws every figure of a spec, or says why not.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkStringOutputWindow.h>

#include "core/error.hpp"
#include "figure.hpp"
#include "film.hpp"

namespace {

using namespace stiction;
namespace fs = std::filesystem;

constexpr int exit_failed = 1, exit_bad_input = 2;

struct Options {
  fs::path spec, out;
  std::string only;
};

void refuse_errors(vtkStringOutputWindow& log) {
  std::string const said = log.GetOutput();
  if (auto const error = said.find("ERR"); error != std::string::npos)
    throw core::RunError("VTK says: " + said.substr(error, 400));
}

bool is_film(postproc::FigureSpec const& figure) {
  auto const* field = std::get_if<postproc::FieldSpec>(&figure.content);
  return field != nullptr && field->film;
}

/// Draws and writes `file`, NAME.png or the film NAME.ogv, and NAME.svg and NAME.pdf if asked for; what VTK
/// complains about meanwhile makes the figure fail instead of going to the screen.
void draw_to_files(postproc::FigureSpec const& figure, fs::path const& file) {
  vtkNew<vtkStringOutputWindow> log;
  vtkOutputWindow::SetInstance(log);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  std::error_code ignored;
  for (char const* kind : {".png", ".svg", ".pdf", ".ogv"}) // no picture of an earlier run survives a failure
    fs::remove(fs::path(file).replace_extension(kind), ignored);
  if (is_film(figure)) {
    postproc::write_film(figure, file);
    return refuse_errors(*log);
  }
  auto const drawing = postproc::draw(figure);
  auto const picture = postproc::shoot(drawing, figure.dpi);
  if (figure.svg)
    postproc::write_svg(drawing, fs::path(file).replace_extension(".svg"));
  if (figure.pdf)
    postproc::write_pdf(drawing, fs::path(file).replace_extension(".pdf"));
  refuse_errors(*log);
  postproc::write_png(picture, file, figure.dpi);
}

/// Draws one figure and returns its exit code.
int attempt(postproc::FigureSpec const& figure, fs::path const& out) {
  auto const file = out / (figure.name + (is_film(figure) ? ".ogv" : ".png"));
  try {
    draw_to_files(figure, file);
    fmt::print("{}\n", file.string());
    return 0;
  } catch (core::InputError const& error) {
    fmt::print(stderr, "figure {}: {}\n", figure.name, error.what());
    return exit_bad_input;
  } catch (std::exception const& error) {
    fmt::print(stderr, "figure {}: {}\n", figure.name, error.what());
    return exit_failed;
  }
}

void keep_only(std::vector<postproc::FigureSpec>& figures, std::string const& name) {
  std::string names;
  for (auto const& figure : figures)
    names += (names.empty() ? "" : ", ") + figure.name;
  std::erase_if(figures, [&](auto const& figure) { return figure.name != name; });
  if (figures.empty())
    throw core::InputError(fmt::format("--only {}: no such figure; there are: {}", name, names));
}

int run(Options const& options) {
  auto figures = postproc::read_spec(options.spec);
  if (!options.only.empty())
    keep_only(figures, options.only);
  std::error_code problem;
  fs::create_directories(options.out, problem);
  if (problem)
    throw core::InputError(fmt::format("--out {}: {}; give a folder that can be written",
                                       options.out.string(), problem.message()));
  int worst = 0;
  for (auto const& figure : figures)
    worst = std::max(worst, attempt(figure, options.out));
  return worst;
}

} // namespace

int main(int count, char** words) {
  setenv("LP_NUM_THREADS", "1", 0); // Mesa's software renderer: no slower, and kind to runs beside it
  Options options;
  CLI::App app("Draws figures from result files, off screen.\n"
               "Exit code: 0 all drawn, 1 a figure failed, 2 the spec is wrong.",
               "stiction-figures");
  app.add_option("spec", options.spec, "the figures to draw, a SPEC.json; paths in it start at its folder")
      ->required();
  app.add_option("--out", options.out, "folder for the PNG files, made if need be")->required();
  app.add_option("--only", options.only, "draw this figure alone");
  try {
    app.parse(count, words);
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? 0 : exit_bad_input;
  }
  try {
    return run(options);
  } catch (core::InputError const& error) {
    fmt::print(stderr, "{}\n", error.what());
    return exit_bad_input;
  } catch (std::exception const& error) {
    fmt::print(stderr, "{}\n", error.what());
    return exit_failed;
  }
}
