// Contact problems that runs have left, in tests/contact/problems.
#pragma once
#include <filesystem>
#include <string>

#include "record/problem_file.hpp"

namespace stiction::test {

inline std::filesystem::path saved_problems_folder() {
  return std::filesystem::path(__FILE__).parent_path() / "problems";
}

inline std::filesystem::path friction_problems_folder() {
  return saved_problems_folder().parent_path().parent_path().parent_path() /
         "studies/peers/friction_problems/problems";
}

inline contact::Problem saved(std::string const& name) {
  return record::load_problem(saved_problems_folder() / (name + ".h5"));
}

} // namespace stiction::test
