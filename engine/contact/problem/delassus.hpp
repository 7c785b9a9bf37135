// The Delassus operator of a contact problem: displacements of the points per force on them.
#pragma once
#include <functional>
#include <optional>
#include <variant>

#include "core/types.hpp"
#include "interface/cone.hpp"
#include "linear/bulk_factor.hpp"

namespace stiction::contact {

/// W [dim n, dim n], m/N, as a matrix or as a product alone. Solvers that need no more than products,
/// diagonal blocks and columns never ask for its entries.
class Delassus {
public:
  /// x += columns `first`, `first` + 1, ... of W times these forces.
  using Product =
      std::function<void(Index first, Eigen::Ref<Vector const> const& force, Eigen::Ref<Vector> x)>;

  Delassus() = default;
  template<class Matrix>
  Delassus(Eigen::EigenBase<Matrix> const& entries) : kind_(Dense(entries.derived())) {}
  /// blocks: the diagonal ones, one below the other, [dim n, dim].
  Delassus(Dense blocks, Product product)
      : kind_(ByProduct{std::move(blocks), std::move(product), nullptr, {}}) {}
  /// The same diagonal block [dim, dim] for so many points.
  Delassus(Index points, Dense block, Product product)
      : kind_(ByProduct{std::move(block), std::move(product), nullptr, {}, points}) {}
  /// Of so many points that neither columns nor entries are to be asked for; the blocks are about those.
  /// together: outlives this.
  Delassus(Dense blocks, linear::CoupledBulk& together);

  [[nodiscard]] Index rows() const;
  [[nodiscard]] double diagonal(Index row) const;
  /// The diagonal block of one point.
  template<int D> [[nodiscard]] interface::LocalMatrix<D> block(Index point) const;
  /// x += W force.
  void add_product(Vector const& force, Vector& x) const;
  [[nodiscard]] Vector operator*(Vector const& force) const {
    Vector x = Vector::Zero(rows());
    add_product(force, x);
    return x;
  }
  /// x += W of a force on one point alone.
  template<int D> void add_column(Index point, interface::Local<D> const& force, Vector& x) const;

  /// All entries, for what factors them or writes them down; those of a product are formed once.
  [[nodiscard]] Dense const& dense() const;
  /// Where a column costs as much as a product: what solves with W at once; else none.
  [[nodiscard]] linear::CoupledBulk* together() const;
  /// Has anyone needed them?
  [[nodiscard]] bool formed() const;
  /// To fill or change them; only of a matrix.
  [[nodiscard]] Dense& entries() { return std::get<Dense>(kind_); }

private:
  struct ByProduct {
    Dense blocks;
    Product product;
    linear::CoupledBulk* together = nullptr;
    mutable std::optional<Dense> entries;
    Index alike = 0; ///< points with the one block that there is; 0: each has its own
    [[nodiscard]] Index rows() const {
      return static_cast<Index>(alike > 0 ? alike * blocks.cols() : blocks.rows());
    }
    [[nodiscard]] Index first_of(Index row) const {
      return alike > 0 ? row % static_cast<Index>(blocks.cols()) : row;
    }
  };
  std::variant<Dense, ByProduct> kind_;
};

template<int D> interface::LocalMatrix<D> Delassus::block(Index point) const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    return matrix->block<D, D>(D * point, D* point);
  auto const& product = std::get<ByProduct>(kind_);
  return product.blocks.middleRows<D>(product.first_of(D * point));
}

template<int D>
void Delassus::add_column(Index point, interface::Local<D> const& force, Vector& x) const {
  if (auto const* matrix = std::get_if<Dense>(&kind_))
    x.noalias() += matrix->middleCols<D>(D * point) * force;
  else
    std::get<ByProduct>(kind_).product(D * point, force, x);
}

} // namespace stiction::contact
