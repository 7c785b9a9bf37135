// The parts of delassus.hpp that need no component count.
#include "contact/problem/delassus.hpp"

namespace stiction::contact {

Index Delassus::rows() const {
  return static_cast<Index>(std::visit(
      [](auto const& kind) {
        if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, Dense>)
          return kind.rows();
        else
          return kind.blocks.rows();
      },
      kind_));
}

double Delassus::diagonal(Index row) const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    return (*matrix)(row, row);
  auto const& blocks = std::get<ByProduct>(kind_).blocks;
  return blocks(row, row % blocks.cols());
}

void Delassus::add_product(Vector const& force, Vector& x) const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    x.noalias() += *matrix * force;
  else
    std::get<ByProduct>(kind_).product(0, force, x);
}

Dense const& Delassus::dense() const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    return *matrix;
  auto const& [blocks, product, together, entries] = std::get<ByProduct>(kind_);
  if (entries)
    return *entries;
  entries = Dense::Zero(blocks.rows(), blocks.rows());
  for (Index j = 0; j < rows(); ++j)
    product(j, Vector::Ones(1), entries->col(j));
  return *entries;
}

Delassus::Delassus(Dense blocks, linear::CoupledBulk& together)
    : kind_(ByProduct{std::move(blocks), {}, &together, {}}) {
  auto& made = std::get<ByProduct>(kind_);
  made.product = [&together, rows = made.blocks.rows()](Index first, Eigen::Ref<Vector const> const& force,
                                                        Eigen::Ref<Vector> x) {
    Vector all = Vector::Zero(rows);
    all.segment(first, force.size()) = force;
    Vector motion = Vector::Zero(rows);
    together.add_motion(all, motion);
    x += motion;
  };
}

linear::CoupledBulk* Delassus::together() const {
  auto const* by_product = std::get_if<ByProduct>(&kind_);
  return by_product == nullptr ? nullptr : by_product->together;
}

bool Delassus::formed() const {
  auto const* by_product = std::get_if<ByProduct>(&kind_);
  return by_product == nullptr || by_product->entries.has_value();
}

} // namespace stiction::contact
