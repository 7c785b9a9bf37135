// The commands and their options, described to CLI11.
#include "bind/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>
#include <iostream>

#include "core/schema.hpp"

namespace stiction::bind {

namespace {

constexpr char const* closing = "STUDY is a folder with study.lua, or a .lua file. Exit codes: 0 all held; 1 "
                                "a case failed, a check did not\n"
                                "hold, or the run was stopped; 2 bad input.";

/// What is wrong with this as a time; "" if nothing.
std::string seconds(std::string const& text) {
  double value = -1;
  bool const good = CLI::detail::lexical_cast(text, value) && value >= 0;
  return good ? "" : fmt::format("{} is no number of seconds, 0 or more", text);
}

/// Adds the options of each command; what is given lands in `line`.
class Commands {
public:
  Commands(CLI::App& app, CommandLine& line) : app_(app), line_(line) {}
  void add_all();

private:
  CLI::App& command(std::string const& name, std::string const& meaning) {
    auto* const sub = app_.add_subcommand(name, meaning);
    sub->footer(closing);
    sub->callback([this, name] { line_.command = name; });
    return *sub;
  }
  void flag(CLI::App& sub, std::string const& name, std::string const& meaning) {
    sub.add_flag_callback(
        "--" + name, [this, name] { line_.options[name] = true; }, meaning);
  }
  /// An option or, without dashes in `name`, a positional word; `type` names its value in the help.
  template<class T>
  CLI::Option* value(CLI::App& sub, std::string const& name, std::string const& type,
                     std::string const& meaning) {
    auto const key = name.substr(name.find_first_not_of('-'));
    auto const keep = [this, key](T const& given) { line_.options[key] = given; };
    return sub.add_option_function<T>(name, keep, meaning)->type_name(type);
  }
  /// A whole number from `least` to `most`.
  void whole(CLI::App& sub, std::string const& name, std::string const& meaning, long most, long least = 1) {
    auto const check = [=](std::string const& text) -> std::string {
      double number = 0;
      bool const good = CLI::detail::lexical_cast(text, number) && number == std::floor(number) &&
                        number >= static_cast<double>(least) && number <= static_cast<double>(most);
      return good ? "" : fmt::format("{} is no whole number from {} to {}", text, least, most);
    };
    value<double>(sub, name, "N", meaning)->check(CLI::Validator(check, ""));
  }
  void jobs(CLI::App& sub, std::string const& what = "Cases") {
    whole(sub, "--jobs", what + " at a time (default: number of cores)", 4096);
  }
  void threads(CLI::App& sub, std::string const& meaning) { whole(sub, "--threads", meaning, 1024); }
  void study_options(CLI::App& sub) {
    flag(sub, "quick", "The study's quick form: fewer cases, coarser");
    value<std::vector<std::string>>(sub, "--set", "NAME=VALUE",
                                    "Replace a given, chosen or swept value, e.g. --set 'radius=5 mm'")
        ->expected(1)
        ->take_all();
    flag(sub, "trust", "Let the script open files and start programs (io, os)");
  }
  CLI::Option* study(CLI::App& sub) {
    return value<std::string>(sub, "study", "STUDY", "Folder or .lua file");
  }
  CLI::Option* out(CLI::App& sub) {
    return value<std::string>(sub, "--out", "DIR", "Output folder (default: out/<study>)");
  }
  CLI::Option* one_case(CLI::App& sub) {
    return value<std::string>(sub, "--case", "ID", "Only the case of this name");
  }
  void add_run();
  void add_sharing(CLI::App& run);
  void add_trade();
  void add_fit();
  void add_extremes();
  void add_peers();
  void add_status();
  void add_looking();
  void add_keeping();
  void add_again();
  void add_others();
  void add_internal();

  CLI::App& app_;
  CommandLine& line_;
};

void Commands::add_sharing(CLI::App& run) {
  flag(run, "join", "Share the sweep with other runs that join: each case is run once");
  flag(run, "worker",
       "Do cases that no other run has, one at a time, until none is left: start any number, anywhere that "
       "sees "
       "the folder");
  value<std::string>(run, "--on", "SYSTEM", "Submit workers to a batch system: slurm");
  whole(run, "--workers", "--on: how many (default: 16, or one a case)", 100000);
  value<std::string>(run, "--time", "TIME", "--on: time limit of each, as sbatch takes it, e.g. 12:00:00");
  value<std::string>(run, "--partition", "NAME", "--on: partition (queue)");
  value<std::vector<std::string>>(run, "--sbatch", "OPTION",
                                  "--on: a further option of sbatch, e.g. --sbatch=--mem=2G")
      ->expected(1)
      ->take_all();
}

void Commands::add_run() {
  auto& run = command("run", "Run the cases of a study, check them, draw its figures");
  study(run)->required();
  study_options(run);
  one_case(run);
  value<std::string>(run, "--where", "EXPR",
                     "Only cases for which this holds, in SI, e.g. 'mu > 0.3 and speed < 0.01'");
  flag(run, "list", "List the cases and whether they are done; run nothing");
  add_sharing(run);
  jobs(run);
  threads(run,
          "Threads of each case, whose numbers do not depend on it (default: cores that --jobs leaves free; "
          "one where runs share a sweep)");
  whole(run, "--ranks",
        "Processes that share each case, by MPI: its cells, matrix and vectors (default: one has it all)",
        100000);
  out(run);
  value<std::string>(run, "--accuracy", "SHARE",
                     "With the cheapest settings that the study's trade measured to be so near, e.g. 2%");
  value<std::string>(run, "--of", "NAMES",
                     "Results or curves of the trade, comma separated, that the accuracy is about");
  flag(run, "check-accuracy",
       "Run the cases again with each setting a level finer, and say what they may be off by");
  whole(run, "--problems", "Save the contact problem of every N-th step as well, for solve", 1000000);
  value<double>(run, "--checkpoint", "SECONDS",
                "Keep where a case stands so often, to go on from there (default: 600; 0: after every step)")
      ->check(CLI::Validator(seconds, ""));
  flag(run, "force", "Run finished cases again, and those that were stopped from their beginning");
  flag(run, "strict", "Run nothing that explain would warn of");
  flag(run, "no-figures", "Draw no figures");
}

void Commands::add_trade() {
  auto& trade = command("trade", "Measure what accuracy costs in a study, knob by knob and combined");
  study(trade)->required();
  study_options(trade);
  jobs(trade);
  out(trade);
  flag(trade, "force", "Run finished cases again");
  flag(trade, "no-figures", "Draw no figures");
}

void Commands::add_fit() {
  auto& fit = command("fit", "Fit parameters of a study to measured curves, with errors and a verdict");
  study(fit)->required();
  study_options(fit);
  jobs(fit);
  out(fit);
  flag(fit, "force", "Run finished cases again");
  flag(fit, "no-profiles", "Intervals from the covariance alone: fewer cases");
  flag(fit, "no-figures", "Draw no figures");
  auto& sample = command(
      "sample", "Sample uncertain parameters: spread, quantiles and shares of the variance of results");
  study(sample)->required();
  study_options(sample);
  value<double>(sample, "--count", "N", "Points (more keep those there are; default: the study's)");
  jobs(sample);
  out(sample);
  flag(sample, "force", "Run finished cases again");
  flag(sample, "no-figures", "Draw no figures");
}

void Commands::add_extremes() {
  auto& extremes = command("extremes", "Drive small scenes to extremes; a map of how each ends");
  study(extremes);
  flag(extremes, "quick", "Without the cells that take long");
  one_case(extremes);
  flag(extremes, "list", "List the cells and how they ended; run nothing");
  jobs(extremes, "Cells");
  out(extremes);
  flag(extremes, "force", "Run cells again that have ended");
  flag(extremes, "no-figures", "Draw no map");
}

void Commands::add_peers() {
  auto& peers = command("peers", "Run cases that other programs have run, side by side with them");
  value<std::vector<std::string>>(peers, "cases", "CASE",
                                  "Folders of studies/peers: block3d, slide2d, friction (default: all)");
  value<std::string>(peers, "--size", "SIZE", "Up to small, medium (default), large or largest");
  flag(peers, "quick", "The same as --size small");
  flag(peers, "stored", "Run no peers: compare results with those stored");
  value<std::string>(peers, "--problems", "DIR", "Folder of the friction problems, also of larger ones");
  whole(peers, "--turns", "Runs of each side, in turns; times are medians (default: 1)", 99);
  out(peers);
}

void Commands::add_status() {
  auto& status =
      command("status", "Say what is done, running, waiting and failed, and which workers live; run nothing");
  value<std::string>(status, "study", "STUDY", "Study or output folder")->required();
  study_options(status);
  out(status);
}

void Commands::add_looking() {
  auto& show =
      command("show", "Show the cases that an output folder holds, filtered and sorted; run nothing");
  value<std::string>(show, "study", "STUDY", "Study or output folder")->required();
  out(show);
  one_case(show);
  value<std::string>(show, "--where", "EXPR",
                     "Only cases for which this holds, in SI, e.g. 'mu > 0.3 and verdict == \"finished\"'");
  value<std::string>(show, "--sort", "NAME", "By this parameter or result; -NAME: from the largest on");
  value<std::string>(show, "--columns", "NAMES", "These parameters and results, comma separated");
  value<std::string>(show, "--csv", "FILE",
                     "Write rows and columns there with every digit, in SI (-: print)");
  value<std::string>(show, "--h5", "FILE", "Write rows and columns there as HDF5: a table 'cases', in SI");
  value<std::string>(show, "--sheet", "FILE", "Draw a field of every row's case there, side by side (PNG)");
  value<std::string>(show, "--animate", "FILE",
                     "Film a field of one --case over its time there (Ogg/Theora)");
  value<std::string>(show, "--field", "NAME",
                     "The field that --sheet and --animate draw (default: von_mises)");
  whole(show, "--frames", "Frames of --animate, spread evenly (default: all that were kept)", 100000, 2);
  whole(show, "--rate", "Frames a second of --animate (default: 10)", 60);
  auto& compare = command("compare", "Say what differs between two outputs, and by how much; exit code 1 if "
                                     "cases are missing or results differ");
  value<std::string>(compare, "a", "OUT", "Output folder or study")->required();
  value<std::string>(compare, "b", "OUT", "Output folder or study")->required();
  value<double>(compare, "--tolerance", "SHARE",
                "Relative difference up to which results are equal (default: 0)");
  flag(compare, "all", "Print all lines, not the first of each kind");
}

void Commands::add_keeping() {
  auto& verify = command("verify", "Recompute cases from the source that is kept with them, and compare");
  value<std::string>(verify, "study", "OUT", "Output folder, study, or what pack made")->required();
  whole(verify, "--sample", "Only N cases, always the same ones (default: all)", 1000000000);
  value<double>(verify, "--tolerance", "SHARE",
                "Relative difference that is allowed where another build computed them (default: 1e-6)");
  jobs(verify);
  flag(verify, "trust", "Let the study open files and start programs (io, os)");
  auto& pack = command("pack", "Make one archive of an output, described as a Workflow Run RO-Crate");
  value<std::string>(pack, "study", "OUT", "Output folder or study")->required();
  value<std::string>(pack, "--to", "FILE", "Archive to write (default: the folder's name with .tar.gz)");
  value<std::string>(pack, "--license", "NAME",
                     "Under which it may be used: a name of SPDX, e.g. CC-BY-4.0, or an address");
  out(pack);
  auto& report = command("report", "Write one page (HTML) on a study and what its output holds");
  value<std::string>(report, "study", "STUDY", "Study or output folder")->required();
  out(report);
  value<std::string>(report, "--to", "FILE", "File to write (default: report.html in the output folder)");
}

void Commands::add_again() {
  auto& results =
      command("results", "Results and checks of what has run, anew from the histories; run nothing");
  study(results)->required();
  study_options(results);
  one_case(results);
  out(results);
  auto& why = command("why", "Say of each case whether run would reuse it, and else what has changed");
  study(why)->required();
  study_options(why);
  one_case(why);
  out(why);
  auto& clean = command("clean", "Remove what no case of the study refers to from its output folder");
  study(clean)->required();
  flag(clean, "list", "List what would be removed; remove nothing");
  flag(clean, "trust", "Let the script open files and start programs (io, os)");
  out(clean);
}

void Commands::add_others() {
  auto& fresh = command("new", "Write a study to start from into a folder of your own");
  value<std::string>(fresh, "name", "NAME", "Folder to write, which must not exist or be empty");
  value<std::string>(fresh, "--from", "EXAMPLE", "Copy this example, one of --list");
  flag(fresh, "list", "List the examples");
  auto& figures = command("figures", "Draw a study's figures again from its output");
  study(figures)->required();
  study_options(figures);
  out(figures);
  auto& explain =
      command("explain", "Show what a study asks, models and costs, and what to change, without running it");
  study(explain)->required();
  study_options(explain);
  one_case(explain);
  flag(explain, "json", "Print JSON instead of text");
  auto& solve = command("solve", "Solve a saved contact problem again");
  value<std::string>(solve, "file", "FILE", "Contact problem saved by a run (HDF5)")->required();
  value<std::string>(solve, "--with", "SOLVER", "A solver of 'stiction help solver' (default: all)");
  value<double>(solve, "--tolerance", "NUMBER", "Natural-map residual to reach");
  flag(solve, "json", "Print JSON instead of text, with forces (N) and displacements (m)");
  auto& bench = command("bench", "Time one case of a study (default: the first), phase by phase, beside the "
                                 "work that it cannot do without");
  study(bench);
  study_options(bench);
  one_case(bench);
  threads(bench, "Threads of the case; times are of the processor, of all of them (default: 1)");
  flag(bench, "json", "Print JSON instead of a table");
  auto& help = command("help", "Explain commands, studies, units, and everything a scene can hold");
  value<std::string>(help, "topic", "TOPIC", "E.g. study, units, material, rcc");
  value<std::string>(help, "--html", "DIR", "Write the whole reference to DIR/index.html, searchable");
}

void Commands::add_internal() {
  auto& one = command("case", "");
  one.group("");
  study(one)->required();
  study_options(one);
  one_case(one)->required();
  out(one)->required();
  flag(one, "trade", "");
  value<std::string>(one, "--point", "JSON", "");
  flag(one, "alone", "");
  threads(one, "");
  value<std::string>(one, "--fingerprint", "HEX", "");
  value<std::string>(one, "--for", "WORKER", "");
  value<double>(one, "--rehearse", "N", "");
  value<double>(one, "--checkpoint", "SECONDS", "");
  value<double>(one, "--stop-after", "N", "");
  flag(one, "force", "");
  value<double>(one, "--problems", "N", "");
  value<double>(one, "--ranks", "N", "");
  flag(one, "member", "");
  auto& cases = command("cases", "");
  cases.group("");
  flag(cases, "trust", "");
  value<std::string>(cases, "--for", "WORKER", "");
  auto& test = command("luatest", "");
  test.group("");
  value<std::string>(test, "file", "FILE", "Lua file of tests")->required();
}

void Commands::add_all() {
  add_run();
  add_trade();
  add_fit();
  add_extremes();
  add_peers();
  add_status();
  add_looking();
  add_keeping();
  add_again();
  add_others();
  add_internal();
}

std::string meant(std::string const& word, std::vector<std::string> const& known) {
  auto const near = core::nearest(word, known);
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

std::vector<std::string> option_names(CLI::App const& app) {
  std::vector<std::string> names;
  for (auto const* sub : app.get_subcommands())
    for (auto const* option : sub->get_options())
      if (!option->get_lnames().empty())
        names.push_back("--" + option->get_lnames().front());
  return names;
}

/// One message for a wrong command line; CLI11's own where it says enough.
std::string complaint(CLI::App const& app, CLI::ParseError const& error, char const* const* words) {
  auto const used = app.get_subcommands();
  if (used.empty()) {
    std::vector<std::string> known;
    for (auto const* sub : app.get_subcommands([](CLI::App const* s) { return !s->get_group().empty(); }))
      known.push_back(sub->get_name());
    return fmt::format("unknown command '{}'{}", words[1], meant(words[1], known));
  }
  auto const extras = app.remaining(true);
  if (dynamic_cast<CLI::ExtrasError const*>(&error) != nullptr && !extras.empty())
    return fmt::format("{}: unexpected '{}'{}", used[0]->get_name(), extras[0],
                       meant(extras[0], option_names(app)));
  return fmt::format("{}: {}", used[0]->get_name(), error.what());
}

} // namespace

CommandLine parse_command_line(int count, char const* const* words) {
  CommandLine line;
  CLI::App app("Stiction: adhesive frictional contact of soft bodies.", "stiction");
  app.footer("'stiction COMMAND --help' lists a command's options. Also: 'stiction test [--all]'.");
  app.set_version_flag("--version", STICTION_VERSION);
  app.require_subcommand(1);
  Commands commands(app, line); // called back while the words are parsed
  commands.add_all();
  if (count < 2) {
    std::cout << app.help();
    line.code = 2;
    return line;
  }
  try {
    app.parse(count, words);
  } catch (CLI::Success const& answer) {
    app.exit(answer, std::cout, std::cerr);
    line.command.clear();
  } catch (CLI::ParseError const& error) {
    line.command.clear();
    line.code = 2;
    std::cerr << "stiction: " << complaint(app, error, words) << "\n";
  }
  return line;
}

} // namespace stiction::bind
