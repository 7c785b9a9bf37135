// Four cells at once against each by itself.
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

#include "material/states.hpp"
#include "solid/helpers.hpp"
#include "solid/responses.hpp"

using namespace stiction;
using namespace stiction::solid;

namespace {

template<int N, class Law> void check_lanes(Law const& law) {
  using material::Voigt, material::Wanted;
  auto const states = test::states<N>();
  for (std::size_t first = 0; first + Pack::lanes <= states.size(); ++first) {
    Voigt<N, Pack> strain;
    for (int lane = 0; lane < Pack::lanes; ++lane)
      for (int i = 0; i < N; ++i)
        strain[i].set(lane, test::green<N>(states[first + static_cast<std::size_t>(lane)])[i]);
    auto const all = respond_in_lanes<N, Wanted::tangent>(law, strain);
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      auto const one =
          law.template respond<N>(test::green<N>(states[first + static_cast<std::size_t>(lane)]));
      double const size = one.tangent.norm();
      CHECK(std::abs(all.energy[lane] - one.energy) <= 1e-13 * size);
      for (int i = 0; i < N; ++i)
        CHECK(std::abs(all.stress[i][lane] - one.stress[i]) <= 1e-13 * size);
      for (int k = 0; k < N * N; ++k)
        CHECK(std::abs(all.tangent(k)[lane] - one.tangent(k)) <= 1e-13 * size);
    }
  }
}

/// The body's cell `number` alone.
Body alone(Body const& body, Index number) {
  Body one = body;
  auto& block = one.mesh.blocks.front();
  auto const width = mesh::info(block.kind).nodes;
  block.nodes = Indices(block.nodes.begin() + number * width, block.nodes.begin() + (number + 1) * width);
  return one;
}

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("every law answers in four lanes as it does in one") {
    test::each_law([](auto const& law) {
      CAPTURE(law.schema().name);
      check_lanes<4>(law);
      check_lanes<6>(law);
    });
  }

  TEST_CASE("forces, energy and stiffness of a block are those of its cells, however many are left over") {
    test::each_case([](test::Case const& each) {
      Body const body = each.body(material::NeoHookean{5e6, 0.3}, 3);
      Cells const cells(body, each.kinematics);
      std::vector<double> u(ix(each.dim() * body.mesh.node_count()));
      for (std::size_t k = 0; k < u.size(); ++k)
        u[k] = 0.01 * std::sin(3.0 * static_cast<double>(k));
      auto const width = ix(each.dim() * mesh::info(each.kind).nodes), entries = width * (width + 1) / 2;
      std::vector<double> force(u.size(), 0.0), sum(u.size(), 0.0);
      std::vector<double> values(entries * ix(cells.count())), one_by_one;
      solid::ScatterMap map(values.size()), first(entries);
      std::iota(map.begin(), map.end(), 0);
      std::iota(first.begin(), first.end(), 0);
      double energy = 0;
      for (Index number = 0; number < cells.count(); ++number) {
        Body const single = alone(body, number);
        Cells const one(single, each.kinematics);
        energy += one.add_force(u, sum).energy;
        std::vector<double> own(entries, 0.0);
        one.add_stiffness(u, 2.0, first, own);
        one_by_one.insert(one_by_one.end(), own.begin(), own.end());
      }
      auto const pass = cells.add_force(u, force);
      REQUIRE(pass.sound());
      cells.add_stiffness(u, 2.0, map, values);
      CHECK(pass.energy == doctest::Approx(energy).epsilon(1e-13));
      auto const near = [](std::vector<double> const& a, std::vector<double> const& b) {
        Eigen::Map<Vector const> const x(a.data(), static_cast<Eigen::Index>(a.size())),
            y(b.data(), static_cast<Eigen::Index>(b.size()));
        return (x - y).norm() <= 1e-13 * y.norm();
      };
      CHECK(near(force, sum));
      CHECK(near(values, one_by_one));
    });
  }
}
