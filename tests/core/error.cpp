// Messages of complaints and the expectations that guard against our own bugs.
#include <doctest/doctest.h>
#include <string>

#include "core/error.hpp"

using namespace stiction::core;

TEST_SUITE("core") {
  TEST_CASE("a complaint joins the parts that it has") {
    CHECK(Complaint{"a.lua:3", "mesh.size", "is 0"}.message() == "a.lua:3: mesh.size: is 0");
    CHECK(Complaint{"", "mesh.size", "is 0"}.message() == "mesh.size: is 0");
    CHECK(Complaint{"", "", "is 0"}.message() == "is 0");
    InputError const error(Complaints{{"a", "", "one"}, {"b", "", "two"}});
    CHECK(std::string(error.what()) == "a: one\nb: two");
    CHECK(error.complaints().size() == 2);
  }

  TEST_CASE("a broken expectation is a Bug with its place") {
    CHECK_NOTHROW(expect(true, "nothing"));
    try {
      expect(false, "two and two to be five");
      FAIL("no Bug was thrown");
    } catch (Bug const& bug) {
      CHECK(std::string(bug.what()).find("two and two to be five") != std::string::npos);
      CHECK(std::string(bug.what()).find("core/error.cpp") != std::string::npos);
    }
  }
}
