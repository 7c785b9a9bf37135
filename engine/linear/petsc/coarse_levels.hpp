// The levels of multigrid below the finest by PETSc's GAMG.
#pragma once
#include "linear/petsc/petsc.hpp"
#include "linear/ranks.hpp"

namespace stiction::linear {

class GamgLevels final : public CoarseLevels {
public:
  GamgLevels(MPI_Comm ranks, int rank, Indices const& first);
  void set_up(BlockMatrix<3, 3> const& A, Dense const& modes) override;
  void change(BlockMatrix<3, 3> const& change) override;
  void correct(Vector const& r, bool changed, Vector& z) override;

private:
  [[nodiscard]] OwnedMat matrix_of(BlockMatrix<3, 3> const& A) const;
  void set_modes(Mat A, Dense const& modes) const;
  void take_levels(PC gamg);
  static void hold_unmoved(Mat A);
  [[nodiscard]] bool fits(BlockMatrix<3, 3> const& change) const;
  void put(BlockMatrix<3, 3> const& values, Mat into) const;
  struct Hierarchy {
    std::vector<OwnedMat> A; ///< from the coarsest on
    OwnedPC cycle;
  };
  void make_cycle(Hierarchy& levels) const;

  /// A change, from the coarsest level on; the last one is the finest's. Its blocks are looked for once.
  struct Change {
    Indices starts, column; ///< of the finest's blocks
    std::vector<OwnedMat> at;
  };

  MPI_Comm ranks_;
  PetscInt own_, all_;      ///< unknowns
  PetscInt begin_;          ///< node
  std::vector<OwnedMat> P_; ///< from the coarsest on; the last one leads to the finest level
  Hierarchy free_, changed_;
  Change change_;
  OwnedVec r_, z_, coarse_r_, coarse_z_;
};

} // namespace stiction::linear
