// The Delassus operator as a matrix and as a product alone: the same answers, and who needs its entries.
#include <doctest/doctest.h>
#include <filesystem>

#include "contact/problem/uniqueness.hpp"
#include "contact/saved.hpp"
#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// The same operator, known by its products and diagonal blocks; the matrix must outlive it.
Delassus by_product(Delassus const& W, int dim) {
  Dense blocks(W.rows(), dim);
  for (Index i = 0; i < W.rows() / dim; ++i)
    blocks.middleRows(dim * i, dim) = W.dense().block(dim * i, dim * i, dim, dim);
  return {blocks,
          [&entries = W.dense()](Index first, Eigen::Ref<Vector const> const& force, Eigen::Ref<Vector> x) {
            for (Index k = 0; k < force.size(); ++k)
              x += force[k] * entries.col(first + k);
          }};
}

Problem with_product(Problem const& problem) {
  Problem other = problem;
  other.W = by_product(problem.W, problem.dim);
  return other;
}

std::vector<std::filesystem::path> saved_problems() {
  std::vector<std::filesystem::path> files;
  for (auto const& entry : std::filesystem::directory_iterator(saved_problems_folder()))
    if (entry.path().extension() == ".h5")
      files.push_back(entry.path());
  return files;
}

bool near(Vector const& a, Vector const& b, double part) {
  return (a - b).norm() <= part * std::max(a.norm(), b.norm());
}

void check_doubts(Problem const& one, Problem const& other, Vector const& force) {
  auto const x = displacement(one, force);
  auto const a = doubts(one, force, x, Checked::all), b = doubts(other, force, x, Checked::all);
  CHECK(a.friction.points == b.friction.points);
  CHECK(a.friction.together == b.friction.together);
  CHECK(a.friction.worst == b.friction.worst);
  CHECK(a.softening.points == b.softening.points);
  CHECK(a.softening.together == doctest::Approx(b.softening.together));
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("an operator made of a product has the blocks, columns and entries of its matrix") {
    auto const problem = random_problem(3, 5, 2, 0.1);
    auto const& entries = problem.W.dense();
    CHECK(problem.W.formed());
    auto const W = by_product(problem.W, 3);
    CHECK(W.rows() == 15);
    CHECK(W.diagonal(7) == entries(7, 7));
    CHECK(W.block<3>(2) == entries.block(6, 6, 3, 3));
    Vector const force = Vector::LinSpaced(15, -1, 2);
    CHECK(near(W * force, entries * force, 1e-14));
    Vector x = Vector::Zero(15);
    W.add_column<3>(4, Eigen::Vector3d(1, -2, 3), x);
    CHECK(near(x, entries.rightCols(3) * Eigen::Vector3d(1, -2, 3), 1e-14));
    CHECK_FALSE(W.formed());
    CHECK(W.dense() == entries);
    CHECK(W.formed());
  }

  TEST_CASE("saved problems: sweeps, judge and doubts need products, columns and diagonal blocks alone") {
    int converged = 0;
    for (auto const& file : saved_problems()) {
      auto const problem = record::load_problem(file), other = with_product(problem);
      GaussSeidel exact{1e-8, 300};
      BipotentialUzawa projected{1e-8, 300};
      for (SolverChoice const& choice : {SolverChoice(exact), SolverChoice(projected)}) {
        INFO(file.stem().string() << ", " << choice.index());
        auto const one = solve(choice, problem), two = solve(choice, other);
        auto const verdict = judge(other, one.force);
        CHECK(verdict.relative() == doctest::Approx(one.verdict.relative()).epsilon(1e-3).scale(1e-8));
        CHECK(natural_scale(other, 0) == natural_scale(problem, 0));
        check_doubts(problem, other, one.force);
        CHECK_FALSE(other.W.formed());
        if (!one.converged || one.iterations > 150) // an end that rounding may move beyond the limit
          continue;
        ++converged;
        CHECK(two.converged);
        CHECK(near(problem.W * one.force, problem.W * two.force, 1e-6));
      }
    }
    CHECK(converged >= 12);
  }

  TEST_CASE("saved problems: Newton asks for the entries and answers alike") {
    for (auto const* name : {"plate_mu04_slide", "block_3d_flat", "hertz_frictionless", "greco_mu15",
                             "belt_90"}) { // the last by proximal points
      auto const problem = saved(name);
      auto const other = with_product(problem);
      INFO(name);
      auto const one = solve(BipotentialNewton{}, problem), two = solve(BipotentialNewton{}, other);
      CHECK(one.converged == two.converged);
      CHECK(near(problem.W * one.force, problem.W * two.force, 1e-6));
      CHECK(other.W.formed());
    }
  }
}
