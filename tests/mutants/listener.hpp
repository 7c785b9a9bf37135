// Notes which planted faults each test of the engine reaches, and how long it takes.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>

#include "mutants/switch.hpp"

namespace stiction::mutants {

/// A line a test in the file STICTION_MUTANTS_TESTS: 1 if it passed, seconds, name, the numbers; parted by
/// tabs.
class Listener : public doctest::IReporter {
public:
  explicit Listener(doctest::ContextOptions const&) {
    if (char const* path = std::getenv("STICTION_MUTANTS_TESTS"); path != nullptr && reached != nullptr)
      file_.open(path, std::ios::app);
  }
  void test_case_start(doctest::TestCaseData const& data) override {
    name_ = data.m_name;
    if (file_.is_open())
      std::fill_n(reached, most, static_cast<unsigned char>(0));
  }
  void test_case_end(doctest::CurrentTestCaseStats const& stats) override {
    if (!file_.is_open())
      return;
    file_ << (stats.failure_flags == 0) << '\t' << stats.seconds << '\t' << name_;
    for (int k = 0; k < most; ++k)
      if (reached[k] != 0)
        file_ << '\t' << k;
    file_ << std::endl;
  }
  void report_query(doctest::QueryData const&) override {}
  void test_run_start() override {}
  void test_run_end(doctest::TestRunStats const&) override {}
  void test_case_reenter(doctest::TestCaseData const&) override {}
  void test_case_exception(doctest::TestCaseException const&) override {}
  void subcase_start(doctest::SubcaseSignature const&) override {}
  void subcase_end() override {}
  void log_assert(doctest::AssertData const&) override {}
  void log_message(doctest::MessageData const&) override {}
  void test_case_skipped(doctest::TestCaseData const&) override {}

private:
  std::ofstream file_;
  char const* name_ = "";
};

} // namespace stiction::mutants

REGISTER_LISTENER("mutants", 1, stiction::mutants::Listener);
