// The parts of delassus.hpp that need no component count.
#include "contact/problem/delassus.hpp"

namespace stiction::contact {

Index Delassus::rows() const {
  auto const* matrix = std::get_if<Dense>(&kind_);
  return matrix != nullptr ? static_cast<Index>(matrix->rows()) : std::get<ByProduct>(kind_).rows();
}

double Delassus::diagonal(Index row) const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    return (*matrix)(row, row);
  auto const& product = std::get<ByProduct>(kind_);
  return product.blocks(product.first_of(row), row % product.blocks.cols());
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
  auto const& by = std::get<ByProduct>(kind_);
  if (by.entries)
    return *by.entries;
  by.entries = Dense::Zero(by.rows(), by.rows());
  for (Index j = 0; j < rows(); ++j)
    by.product(j, Vector::Ones(1), by.entries->col(j));
  return *by.entries;
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
