// Measures of meshes that several tests share.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <string>
#include <unistd.h>

#include "core/error.hpp"
#include "mesh/topology/mesh.hpp"
#include "mesh/topology/surface.hpp"

namespace stiction::mesh::test {

/// Area by the stiffness rule, m^2.
inline double area(Mesh const& mesh) {
  double sum = 0;
  for (auto const& block : mesh.blocks) {
    auto const& rule = stiffness_rule(block.kind);
    int const n = info(block.kind).nodes;
    for (std::size_t first = 0; first < block.nodes.size(); first += static_cast<std::size_t>(n))
      for (std::size_t q = 0; q < rule.gradients.size(); ++q) {
        Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
        for (int i = 0; i < n; ++i)
          jacobian += mesh.nodes.row(block.nodes[first + static_cast<std::size_t>(i)]).transpose() *
                      rule.gradients[q].row(i);
        sum += (jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0)) *
               rule.weights[static_cast<Eigen::Index>(q)];
      }
  }
  return sum;
}

/// Volume by the mass rule, m^3.
inline double volume(Mesh const& mesh) {
  double sum = 0;
  for (auto const& block : mesh.blocks) {
    auto const& rule = mass_rule(block.kind);
    auto const n = static_cast<std::size_t>(info(block.kind).nodes);
    for (std::size_t first = 0; first < block.nodes.size(); first += n) {
      Matrix positions(static_cast<Eigen::Index>(n), 3);
      for (std::size_t i = 0; i < n; ++i)
        positions.row(static_cast<Eigen::Index>(i)) = mesh.nodes.row(block.nodes[first + i]);
      for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
        Matrix3 const jacobian = positions.transpose() * rule.gradients[ix(static_cast<Index>(q))];
        sum += jacobian.determinant() * rule.weights[q];
      }
    }
  }
  return sum;
}

/// Checks that make(metre), of a shape whose lengths are so many metres, gives one mesh in every unit.
template<class Make> void check_units(Make const& make) {
  Mesh const mesh = make(1.0);
  for (double const metre : {1e-9, 3e-4, 1e6}) {
    CAPTURE(metre);
    Mesh const same = make(metre);
    REQUIRE(same.blocks[0].nodes == mesh.blocks[0].nodes);
    CHECK((same.nodes / metre - mesh.nodes).cwiseAbs().maxCoeff() < 1e-12);
    for (auto const& [name, set] : mesh.sets)
      CHECK(same.sets.at(name).nodes == set.nodes);
  }
}

/// Integral over facets of a function of position and outward normal times area, f(x, n dA).
template<class Function>
double over_facets(Mesh const& mesh, std::vector<Facet> const& facets, Function const& f) {
  double sum = 0;
  for (auto const& facet : facets) {
    auto const& rule = mass_rule(facet_kind(facet));
    Matrix positions(static_cast<Eigen::Index>(facet.nodes.size()), 3);
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
      positions.row(i) = mesh.nodes.row(facet.nodes[ix(static_cast<Index>(i))]);
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      Eigen::Matrix<double, 3, 2> const t = positions.transpose() * rule.gradients[ix(static_cast<Index>(q))];
      Eigen::Vector3d const position = positions.transpose() * rule.shape.row(q).transpose();
      sum += f(position, Eigen::Vector3d(t.col(0).cross(t.col(1)) * rule.weights[q]));
    }
  }
  return sum;
}

/// Volume by the divergence theorem: right only when every facet faces outwards, m^3.
inline double enclosed_volume(Mesh const& mesh, std::vector<Facet> const& facets) {
  return over_facets(mesh, facets,
                     [](Eigen::Vector3d const& x, Eigen::Vector3d const& n) { return x.dot(n) / 3; });
}

/// Area of a surface in 3D, m^2.
inline double surface_area(Mesh const& mesh, Set const& set) {
  return over_facets(mesh, set.facets,
                     [](Eigen::Vector3d const&, Eigen::Vector3d const& n) { return n.norm(); });
}

/// Length of a set by its facets; those with a mid node count as two straight pieces, m.
inline double length(Mesh const& mesh, Set const& set) {
  double sum = 0;
  for (auto const& facet : set.facets) {
    Indices path{facet.nodes[0], facet.nodes[1]};
    if (facet.nodes.size() == 3)
      path.insert(path.begin() + 1, facet.nodes[2]);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      sum += (mesh.nodes.row(path[i + 1]) - mesh.nodes.row(path[i])).norm();
  }
  return sum;
}

/// Area by Green's theorem over straight facets: right only when every facet has the body to its left, m^2.
inline double enclosed_area(Mesh const& mesh, std::vector<Facet> const& facets) {
  double sum = 0;
  for (auto const& facet : facets) {
    auto const a = mesh.nodes.row(facet.nodes[0]), b = mesh.nodes.row(facet.nodes[1]);
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

/// Every facet's nodes lie in the set's nodes, which are sorted, unique and in range.
inline bool consistent(Mesh const& mesh, Set const& set) {
  bool good = std::is_sorted(set.nodes.begin(), set.nodes.end()) &&
              std::adjacent_find(set.nodes.begin(), set.nodes.end()) == set.nodes.end() &&
              (set.nodes.empty() || (set.nodes.front() >= 0 && set.nodes.back() < mesh.node_count()));
  for (auto const& facet : set.facets)
    for (Index const node : facet.nodes)
      good = good && std::binary_search(set.nodes.begin(), set.nodes.end(), node);
  return good;
}

/// The words of the InputError that `act` throws, or "" when it throws none.
template<class Act> std::string refusal(Act act) {
  try {
    act();
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

inline bool mentions(std::string const& text, std::string const& words) {
  return text.find(words) != std::string::npos;
}

/// A folder that is gone at the end of the test.
class Folder {
public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("stiction-mesh-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  [[nodiscard]] std::string operator/(std::string const& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::filesystem::path const& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace stiction::mesh::test
