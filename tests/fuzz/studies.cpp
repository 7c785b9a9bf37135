// Scripts and what cases leave behind, through the Lua library as the program uses it.
#include "fuzz/lua_state.hpp"
#include "fuzz/scratch.hpp"
#include "fuzz/targets.hpp"

namespace stiction::fuzz {

/// Loads the study, makes its cases and validates the scenes of the first ones.
void script(std::string_view bytes) {
  constexpr char const* driver = R"(
    local path, validate = ...
    local study = require("stiction.study").load(path)
    for _, quick in ipairs { false, true } do
      local cases = require("stiction.sweep").cases(study, { quick = quick })
      for i = 1, math.min(3, #cases) do
        validate(study.scene(cases[i].p))
      end
    end)";
  run_lua(driver, scratch_file("study.lua", bytes));
}

/// Reads the result in a manifest as a sweep does that goes on from what is there, and as a check does.
void result(std::string_view bytes) {
  constexpr char const* driver = R"(
    local output = require "stiction.output"
    local folder = ...
    local case = { id = "case", p = {} }
    local result = output.read_result(folder, case)
    local study = { results = { { name = "peak" } }, source = { folder = folder, hashes = {} } }
    output.is_done(result, result and result.fingerprint, study)
    if result then
      output.write_summary(folder, study, {}, { { case = case, result = result } })
      if result.verdict == "finished" then
        local _ = require("stiction.case").new("case", {}, folder .. "/case").cost
      end
    end)";
  std::filesystem::create_directories(scratch_folder() / "case");
  scratch_file("case/manifest.json", bytes);
  run_lua(driver, scratch_folder().string());
}

} // namespace stiction::fuzz
