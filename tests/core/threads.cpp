// Loops that threads share: everything once, the same pieces and sums for any number of them, what is thrown.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <doctest/doctest.h>
#include <stdexcept>
#include <thread>

#include "core/error.hpp"
#include "threads.hpp"

using namespace stiction;
using test::Threads;

TEST_SUITE("core") {
  TEST_CASE("a loop calls everything once, whoever does it") {
    for (int const count : {1, 2, 3, 7}) {
      Threads const threads(count);
      CHECK(core::threads() == count);
      for (Index const n : {0, 1, 2, 1000}) {
        std::vector<std::atomic<int>> calls(ix(n));
        core::each(n, [&](Index i) { ++calls[ix(i)]; });
        CHECK(std::all_of(calls.begin(), calls.end(), [](auto const& one) { return one == 1; }));
      }
    }
    CHECK(core::threads() == 1);
  }

  TEST_CASE("every thread takes part, and many short loops follow each other") {
    Threads const threads(3);
    std::atomic<int> inside{0};
    core::each(3, [&](Index) { // none ends before all are there
      ++inside;
      while (inside < 3)
        std::this_thread::yield();
    });
    CHECK(inside == 3);
    long sum = 0;
    for (int turn = 0; turn < 2000; ++turn) {
      std::array<int, 4> found{};
      core::each(4, [&](Index i) { found[ix(i)] = i; });
      sum += found[0] + found[1] + found[2] + found[3];
    }
    CHECK(sum == 12000);
  }

  TEST_CASE("calls begin in order, so that one may wait for those before it") {
    Threads const threads(3);
    std::vector<std::atomic<bool>> done(200);
    core::each(200, [&](Index i) {
      while (i > 0 && !done[ix(i - 1)])
        std::this_thread::yield();
      done[ix(i)] = true;
    });
    CHECK(done[199]);
  }

  TEST_CASE("a loop within a loop is the caller's alone") {
    Threads const threads(2);
    std::vector<Index> sums(50, 0);
    std::atomic<int> apart{0};
    core::each(50, [&](Index i) {
      auto const self = std::this_thread::get_id();
      core::each(i, [&](Index k) {
        sums[ix(i)] += k;
        apart += std::this_thread::get_id() != self;
      });
    });
    CHECK(apart == 0);
    for (Index i = 0; i < 50; ++i)
      CHECK(sums[ix(i)] == i * (i - 1) / 2);
  }

  TEST_CASE("what a call throws comes out once all have ended, and the next loop runs") {
    for (int const count : {1, 2, 3}) {
      Threads const threads(count);
      std::atomic<int> calls{0};
      auto const loop = [&] {
        core::each(1000, [&](Index i) {
          ++calls;
          if (i == 7)
            throw std::runtime_error("seven");
          if (i > 7)
            std::this_thread::sleep_for(
                std::chrono::milliseconds(1)); // the others do not get through meanwhile
        });
      };
      CHECK_THROWS_WITH(loop(), "seven");
      CHECK(calls < 1000);
      calls = 0;
      core::each(10, [&](Index) { ++calls; });
      CHECK(calls == 10);
    }
  }

  TEST_CASE("of several that throw the first one's is told") {
    Threads const threads(2);
    std::atomic<int> there{0};
    auto const loop = [&] {
      core::each(2, [&](Index i) {
        ++there;
        while (there < 2)
          std::this_thread::yield();
        throw std::runtime_error(i == 0 ? "first" : "second");
      });
    };
    CHECK_THROWS_WITH(loop(), "first");
  }

  TEST_CASE("pieces and sums over them do not depend on the number of threads") {
    Vector const x = Vector::LinSpaced(100'003, -1, 1.7).array().sin();
    auto const sum = [&] {
      return core::sum_of_pieces(static_cast<Index>(x.size()), 100, [&](Index first, Index last) {
        return x.segment(first, last - first).squaredNorm();
      });
    };
    double const alone = sum();
    CHECK(alone == doctest::Approx(x.squaredNorm()).epsilon(1e-13));
    for (int const count : {2, 3}) {
      Threads const threads(count);
      CHECK(sum() == alone);
    }
    std::vector<std::pair<Index, Index>> pieces;
    core::each_piece(1000, 300, [&](Index first, Index last) { pieces.emplace_back(first, last); });
    CHECK(pieces == std::vector<std::pair<Index, Index>>{{0, 300}, {300, 600}, {600, 900}, {900, 1000}});
    core::each_piece(0, 300, [&](Index, Index) { CHECK(false); });
    CHECK(core::sum_of_pieces(0, 1, [](Index, Index) { return 1.0; }) == 0);
  }

  TEST_CASE("no shared loop changes the number of threads, and there is at least one") {
    CHECK_THROWS_AS(core::use_threads(0), core::Bug);
    Threads const threads(2);
    CHECK_THROWS_AS(core::each(2, [](Index) { core::use_threads(3); }), core::Bug);
    CHECK(core::threads() == 2);
  }
}
