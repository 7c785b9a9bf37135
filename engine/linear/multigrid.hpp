// Algebraic multigrid by smoothed aggregation for bodies in space (Vanek, Mandel & Brezina 1996).
#pragma once
#include <memory>
#include <vector>

#include "linear/block_matrix.hpp"
#include "linear/layers.hpp"

namespace stiction::linear {

/// A diagonal block that is added to the matrix in the preconditioner, as of a node that contact holds.
struct HeldNode {
  Index node;
  Matrix3 stiffness; ///< symmetric, positive semi-definite, N/m
  bool operator==(HeldNode const&) const = default;
};

/// Of matrices that couple nodes of three unknowns.
class Multigrid {
public:
  Multigrid();
  Multigrid(Multigrid const&);
  Multigrid& operator=(Multigrid const&);
  Multigrid(Multigrid&&) noexcept;
  Multigrid& operator=(Multigrid&&) noexcept;
  ~Multigrid();

  /// modes: motions that take no energy where nothing is held, [3 nodes, 6]; waves: of its nodes. The matrix
  /// has to outlive this.
  void set_up(BlockMatrix<3, 3> const& A, Dense const& modes, Waves const& waves);
  void set_up(BlockMatrix<3, 3> const& A, Dense const& modes) {
    set_up(A, modes, Waves::one_by_one(A.rows()));
  }
  /// Holds these nodes and no others, in ascending order; takes work by how many that changes.
  void hold(std::vector<HeldNode> held);
  /// z = about (A + held)^-1 r, by one V cycle: symmetric and positive definite where A is.
  void cycle(Vector const& r, Vector& z);
  /// Blocks of all levels over those of the first.
  [[nodiscard]] double complexity() const;
  [[nodiscard]] std::size_t levels() const;
  /// Numbers stored, the matrix itself left out.
  [[nodiscard]] double numbers() const;

private:
  struct Levels;
  std::unique_ptr<Levels> levels_;
};

} // namespace stiction::linear
