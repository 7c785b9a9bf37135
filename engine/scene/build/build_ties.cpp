// Tied surfaces of a scene: mortar integrals become links, and the nodes that follow move onto the other
// surface.
#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "contact/mortar/tied.hpp"
#include "mesh/topology/quality.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

using Row = std::map<Index, double>; ///< nodes, and their coefficients in a sum that stays 0
using Rows = std::map<Index, Row>;   ///< by the node that follows

constexpr double no_move = 1e-12; ///< of a body's size: shorter moves are none

/// Adds a share of row j of a facet.
void add_row(contact::TiedFacet const& facet, std::size_t j, double share, Row& row) {
  auto const number = static_cast<Index>(j);
  for (std::size_t k = 0; k < facet.own.size(); ++k)
    if (double const D = facet.D(number, static_cast<Index>(k)); D != 0)
      row[facet.own[k]] += share * D;
  for (std::size_t l = 0; l < facet.other.size(); ++l)
    row[facet.other[l]] -= share * facet.M(number, static_cast<Index>(l));
}

/// Rows of nodes that do not follow go to those beside them on the facet, so that the functions still sum to
/// 1. The facet on which none is left though the other surface moves there; null if all is well.
template<class Moves>
contact::TiedFacet const* sum_rows(std::vector<contact::TiedFacet> const& facets, std::set<Index> const& kept,
                                   Moves const& moves, Rows& rows) {
  for (auto const& facet : facets) {
    std::vector<std::size_t> free, others;
    for (std::size_t j = 0; j < facet.own.size(); ++j)
      (kept.contains(facet.own[j]) ? others : free).push_back(j);
    if (free.empty() && std::ranges::any_of(facet.other, moves))
      return &facet;
    for (std::size_t const i : free) {
      auto& row = rows[facet.own[i]];
      add_row(facet, i, 1, row);
      for (std::size_t const j : others)
        add_row(facet, j, 1 / static_cast<double>(free.size()), row);
    }
  }
  return nullptr;
}

/// Which constraint of the script a place is in, from 0.
std::size_t constraint_number(std::string const& key) {
  return std::stoul(key.substr(key.find('[') + 1)) - 1;
}

} // namespace

void Builder::add_constraint(Where const& where, TiedPart const& part) {
  auto const own = surface({where[0], "set"}, part.set), other = surface({where[0], "to"}, part.to);
  if (!own || !other)
    return;
  auto const& model = *scene_.model;
  Tie tie{where, &part, {}, {}};
  std::ranges::set_intersection(own->nodes, other->nodes, std::inserter(tie.both, tie.both.end()));
  try {
    tie.facets = contact::tie({own->facets, model.reference, Vec3::UnitX()},
                              {other->facets, model.reference, Vec3::UnitX()},
                              model.kinematics == solid::Kinematics::axisymmetric);
  } catch (core::InputError const& error) {
    for (auto const& complaint : error.complaints())
      complain(where, complaint.message());
    return;
  }
  if (!covered(tie))
    return;
  for (int c = 0; c < model.dim(); ++c)
    follow_facets(tie, c);
  scene_.moved[constraint_number(where[0])] = move_bodies(where);
}

/// Does all of the surface that follows lie on the other?
bool Builder::covered(Tie const& tie) {
  auto const bare = std::ranges::find_if(tie.facets, [](auto const& facet) { return facet.D.size() == 0; });
  if (bare == tie.facets.end())
    return true;
  auto const there = words(middle_of(*scene_.model, bare->own), scene_.part.dim());
  auto const how = bare->covered > 1 ? std::string("more than once")
                                     : fmt::format("over {:.3g} % of its area", 100 * bare->covered);
  auto const beyond =
      bare->gap > 0 ? fmt::format("; the nearest beyond that is {:.3g} m off", bare->gap) : std::string();
  complain(tie.where, fmt::format("the facet of {} at {} faces {} {} within {:.3g} m, a tenth of a facet{}; "
                                  "`set` has to lie on `to` as a whole: make the surfaces meet, name the "
                                  "part that does, or exchange the two",
                                  tie.part->set, there, tie.part->to, how, bare->reach, beyond));
  return false;
}

/// Nodes whose component does not follow here: motions drive it, another constraint has it, or the node is in
/// both surfaces.
std::set<Index> Builder::kept_nodes(Tie const& tie, int component) const {
  std::set<Index> kept = tie.both;
  for (auto const& facet : tie.facets)
    for (Index const node : facet.own)
      if (auto const dof = ix(scene_.model->dim() * node + component);
          driven_[dof] != nullptr || link_of_[dof] >= 0 || leads_[dof])
        kept.insert(node);
  return kept;
}

/// One component of displacement; D X = M X moves the nodes as well.
void Builder::follow_facets(Tie const& tie, int component) {
  auto& model = *scene_.model;
  int const dim = model.dim();
  auto const kept = kept_nodes(tie, component);
  Rows rows;
  auto const moves = [&](Index node) { return driven_[ix(dim * node + component)] == nullptr; };
  if (auto const* none = sum_rows(tie.facets, kept, moves, rows)) {
    complain(tie.where,
             fmt::format("all nodes of the facet of {} at {} are driven along {} or in other "
                         "constraints, so none is left to follow; exchange `set` and `to`, or "
                         "make the mesh finer there",
                         tie.part->set, words(middle_of(model, none->own), dim), "xyz"[component]));
    return;
  }
  auto const borrows = [&](auto const& entry) {
    return std::ranges::any_of(entry.second, [&](auto const& term) {
      return term.first != entry.first && rows.contains(term.first);
    });
  };
  for (bool const second : {false, true}) // middles after the corners that they have a part of
    for (auto const& entry : rows)
      if (borrows(entry) == second)
        follow_row(entry.first, entry.second, component);
}

/// The node's own part of the sum is the rest of it.
void Builder::follow_row(Index node, std::map<Index, double> const& row, int component) {
  auto& reference = scene_.model->reference;
  int const dim = scene_.model->dim();
  Terms terms;
  terms.reserve(row.size());
  double place = 0;
  for (auto const& [other, coefficient] : row) {
    double const part = coefficient / row.at(node);
    terms.emplace_back(dim * other + component, part);
    place -= other == node ? 0 : part * reference(other, component);
  }
  reference(node, component) = place;
  follow(dim * node + component, settled(terms));
}

/// Bodies whose nodes have moved are made anew; moves of rounding are taken back. The largest, m.
double Builder::move_bodies(Where const& where) {
  auto& model = *scene_.model;
  double largest = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto& mesh = model.bodies[b]->mesh;
    auto now = model.reference.middleRows(model.first_node[b], mesh.node_count());
    double const size = (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
    Matrix const moves = ((now - mesh.nodes).array().abs() > no_move * size).select(now - mesh.nodes, 0);
    now = mesh.nodes + moves;
    if (moves.isZero(0))
      continue;
    largest = std::max(largest, moves.rowwise().norm().maxCoeff());
    mesh.nodes = now;
    try {
      mesh::check(mesh, scene_.bodies[b]);
    } catch (core::InputError const& error) {
      for (auto const& complaint : error.complaints())
        complain(where, "with the nodes that follow moved onto the other surface: " + complaint.message());
      continue;
    }
    model.cells[b] = dynamics::cells_of(model, b);
    set_velocities(b);
  }
  return largest;
}

} // namespace stiction::scene
