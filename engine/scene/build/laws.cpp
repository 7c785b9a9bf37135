// Each cell finds its law by the set it is in; cells of one kind and law go together.
#include "scene/build/laws.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "mesh/cells/cell.hpp"

namespace stiction::scene {

namespace {

[[noreturn]] void refuse(std::string text) {
  throw core::InputError(core::Complaints{{"", "material", std::move(text)}});
}

/// "(x, y) m": the middle of a cell.
std::string place_of(mesh::Mesh const& mesh, Index cell) {
  for (auto const& block : mesh.blocks) {
    auto const width = static_cast<Index>(mesh::info(block.kind).nodes);
    auto const count = static_cast<Index>(block.nodes.size()) / width;
    if (cell >= count) {
      cell -= count;
      continue;
    }
    Vector middle = Vector::Zero(mesh.dim);
    for (Index k = 0; k < width; ++k)
      middle += mesh.nodes.row(block.nodes[ix(cell * width + k)]).transpose() / width;
    return fmt::format("({:.4g}) m", fmt::join(middle.data(), middle.data() + middle.size(), ", "));
  }
  return "";
}

/// Names of the sets that have cells, "all" last and only if there are no others.
std::string sets_of_cells(mesh::Mesh const& mesh) {
  std::string names;
  for (auto const& [name, set] : mesh.sets)
    if (!set.cells.empty() && name != "all")
      names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "none (a mesh file has them: physical groups of cells, element sets)" : names;
}

/// The number of each cell's law.
std::vector<int> laws_of_cells(mesh::Mesh const& mesh,
                               std::map<std::string, material::Material> const& laws) {
  std::vector<int> law(ix(mesh.cell_count()), -1);
  std::vector<std::string> names;
  for (auto const& [name, ignored] : laws) {
    auto const found = mesh.sets.find(name);
    if (found == mesh.sets.end() || found->second.cells.empty())
      refuse(fmt::format("names \"{}\", which is no set of cells of the mesh; those are: {}", name,
                         sets_of_cells(mesh)));
    for (Index const cell : found->second.cells) {
      if (law[ix(cell)] >= 0)
        refuse(fmt::format("gives two laws to the cell at {}, which is in {} and in {}; give each cell one",
                           place_of(mesh, cell), names[ix(law[ix(cell)])], name));
      law[ix(cell)] = static_cast<int>(names.size());
    }
    names.push_back(name);
  }
  auto const bare = std::find(law.begin(), law.end(), -1);
  if (bare != law.end())
    refuse(fmt::format("gives no law to {} of {} cells, such as that at {}; sets of cells are: {}",
                       std::count(law.begin(), law.end(), -1), law.size(),
                       place_of(mesh, static_cast<Index>(bare - law.begin())), sets_of_cells(mesh)));
  return law;
}

} // namespace

void give_laws(solid::Body& body, std::map<std::string, material::Material> const& laws) {
  if (laws.empty())
    return;
  auto const law_of = laws_of_cells(body.mesh, laws);
  std::vector<material::Material> all;
  all.reserve(laws.size());
  for (auto const& [name, law] : laws)
    all.push_back(law);
  std::map<std::pair<std::size_t, int>, Indices> nodes; // by block and law
  std::size_t cell = 0;
  for (std::size_t b = 0; b < body.mesh.blocks.size(); ++b) {
    auto const& block = body.mesh.blocks[b];
    auto const width = static_cast<std::ptrdiff_t>(mesh::info(block.kind).nodes);
    for (auto at = block.nodes.begin(); at != block.nodes.end(); at += width) {
      auto& own = nodes[{b, law_of[cell++]}];
      own.insert(own.end(), at, at + width);
    }
  }
  std::vector<mesh::Block> blocks;
  body.laws.clear();
  for (auto& [key, list] : nodes) {
    blocks.push_back({body.mesh.blocks[key.first].kind, std::move(list)});
    body.laws.push_back(all[ix(key.second)]);
  }
  body.mesh.blocks = std::move(blocks);
  for (auto& [name, set] : body.mesh.sets) // their numbers were those of the old order
    set.cells.clear();
  body.material = *std::ranges::min_element(
      all, {}, [](material::Material const& law) { return material::moduli(law).young; });
}

} // namespace stiction::scene
