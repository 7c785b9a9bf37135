// Aggregates, smoothed prolongators and coarse matrices from GAMG, cycles on them from PCMG.
#include "linear/petsc/coarse_levels.hpp"

namespace stiction::linear {

namespace {

constexpr PetscReal strong = 0.02; ///< as the multigrid of one process has it
constexpr PetscInt few = 600;      ///< unknowns that are factored at once
constexpr PetscInt share = 600;    ///< unknowns of a coarse level that a rank has at least, or none
constexpr PetscInt sweeps = 2;
constexpr PetscReal moved = 1e-12; ///< of the largest diagonal entry

} // namespace

GamgLevels::GamgLevels(MPI_Comm ranks, int rank, Indices const& first)
    : ranks_(ranks), own_(3 * (first[ix(rank + 1)] - first[ix(rank)])), all_(3 * first.back()),
      begin_(first[ix(rank)]) {
  check(VecCreateMPIWithArray(ranks_, 1, own_, all_, nullptr, r_.fresh()));
  check(VecCreateMPIWithArray(ranks_, 1, own_, all_, nullptr, z_.fresh()));
}

OwnedMat GamgLevels::matrix_of(BlockMatrix<3, 3> const& A) const {
  std::vector<PetscInt> starts{0}, columns;
  std::vector<PetscScalar> values;
  columns.reserve(9 * A.column.size());
  values.reserve(9 * A.column.size());
  for (Index i = 0; i < A.rows(); ++i)
    for (int c = 0; c < 3; ++c) {
      for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
        for (int d = 0; d < 3; ++d) {
          columns.push_back(3 * A.column[ix(k)] + d);
          values.push_back(A.block(k)(c, d));
        }
      starts.push_back(static_cast<PetscInt>(columns.size()));
    }
  OwnedMat made;
  Mat& M = *made.fresh();
  check(MatCreate(ranks_, &M));
  check(MatSetSizes(M, own_, own_, all_, all_));
  check(MatSetBlockSize(M, 3));
  check(MatSetType(M, MATAIJ));
  check(MatSeqAIJSetPreallocationCSR(M, starts.data(), columns.data(), values.data()));
  check(MatMPIAIJSetPreallocationCSR(M, starts.data(), columns.data(), values.data()));
  return made;
}

void GamgLevels::set_modes(Mat A, Dense const& modes) const {
  std::vector<OwnedVec> owned(static_cast<std::size_t>(modes.cols()));
  std::vector<Vec> all;
  for (auto& mode : owned) {
    check(MatCreateVecs(A, mode.fresh(), nullptr));
    PetscScalar* values = nullptr;
    check(VecGetArray(mode, &values));
    auto const column = static_cast<Eigen::Index>(all.size());
    std::copy_n(modes.col(column).data(), own_, values);
    check(VecRestoreArray(mode, &values));
    for (Vec const before : all) {
      PetscScalar part = 0;
      check(VecDot(mode, before, &part));
      check(VecAXPY(mode, -part, before));
    }
    check(VecNormalize(mode, nullptr));
    all.push_back(mode);
  }
  OwnedNullSpace space;
  check(
      MatNullSpaceCreate(ranks_, PETSC_FALSE, static_cast<PetscInt>(all.size()), all.data(), space.fresh()));
  check(MatSetNearNullSpace(A, space));
}

/// Prolongators and coarse matrices, which outlive it.
void GamgLevels::take_levels(PC gamg) {
  P_.clear();
  free_ = Hierarchy();
  changed_ = Hierarchy();
  change_ = Change();
  PetscInt levels = 0;
  check(PCMGGetLevels(gamg, &levels));
  for (PetscInt l = 1; l < levels; ++l) {
    Mat P = nullptr, coarse = nullptr;
    KSP below = nullptr;
    check(PCMGGetInterpolation(gamg, l, &P));
    P_.emplace_back().share(P);
    check(PCMGGetSmoother(gamg, l - 1, &below));
    check(KSPGetOperators(below, nullptr, &coarse));
    free_.A.emplace_back().share(coarse);
    hold_unmoved(coarse);
  }
  if (P_.empty())
    return;
  check(MatCreateVecs(P_.back(), coarse_r_.fresh(), nullptr));
  check(VecDuplicate(coarse_r_, coarse_z_.fresh()));
  make_cycle(free_);
}

void GamgLevels::set_up(BlockMatrix<3, 3> const& A, Dense const& modes) {
  auto const M = matrix_of(A);
  check(MatSetOption(M, MAT_SPD, PETSC_TRUE));
  set_modes(M, modes);
  OwnedPC gamg;
  check(PCCreate(ranks_, gamg.fresh()));
  check(PCSetOperators(gamg, M, M));
  check(PCSetType(gamg, PCGAMG));
  PetscReal threshold = strong;
  check(PCGAMGSetThreshold(gamg, &threshold, 1));
  check(PCGAMGSetAggressiveLevels(gamg, 1));
  check(PCGAMGSetCoarseEqLim(gamg, few));
  check(PCGAMGSetProcEqLim(gamg, share));
  check(PCSetUp(gamg));
  take_levels(gamg);
}

/// A coarse motion that moves nothing, as the sixth of an aggregate of one node, has a stiffness too.
void GamgLevels::hold_unmoved(Mat A) {
  OwnedVec diagonal;
  check(MatCreateVecs(A, diagonal.fresh(), nullptr));
  check(MatGetDiagonal(A, diagonal));
  PetscReal largest = 0;
  check(VecMax(diagonal, nullptr, &largest));
  PetscScalar* values = nullptr;
  PetscInt count = 0;
  check(VecGetLocalSize(diagonal, &count));
  check(VecGetArray(diagonal, &values));
  for (PetscInt k = 0; k < count; ++k)
    values[k] = values[k] > moved * largest ? 0 : largest;
  check(VecRestoreArray(diagonal, &values));
  check(MatDiagonalSet(A, diagonal, ADD_VALUES));
}

/// The cycle on these matrices, or the one that was made on them as they are now.
void GamgLevels::make_cycle(Hierarchy& levels) const {
  auto const count = static_cast<PetscInt>(levels.A.size());
  bool const anew = levels.cycle == nullptr;
  if (anew) {
    check(PCCreate(ranks_, levels.cycle.fresh()));
    check(PCSetType(levels.cycle, PCMG));
    check(PCMGSetLevels(levels.cycle, count, nullptr));
    check(PCMGSetGalerkin(levels.cycle, PC_MG_GALERKIN_NONE));
  }
  check(PCSetOperators(levels.cycle, levels.A.back(), levels.A.back()));
  for (PetscInt l = 0; l < count; ++l) {
    KSP smoother = nullptr;
    check(PCMGGetSmoother(levels.cycle, l, &smoother));
    Mat const A = levels.A[static_cast<std::size_t>(l)];
    check(KSPSetOperators(smoother, A, A));
    if (!anew || l == 0)
      continue;
    check(PCMGSetInterpolation(levels.cycle, l, P_[static_cast<std::size_t>(l - 1)]));
    check(KSPSetType(smoother, KSPCHEBYSHEV));
    check(KSPSetTolerances(smoother, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, sweeps));
    check(KSPSetNormType(smoother, KSP_NORM_NONE));
    PC inner = nullptr;
    check(KSPGetPC(smoother, &inner));
    check(PCSetType(inner, PCPBJACOBI));
  }
  check(PCSetUp(levels.cycle));
}

/// Whether all ranks have the blocks of the last change.
bool GamgLevels::fits(BlockMatrix<3, 3> const& change) const {
  int all = !change_.at.empty() && change.starts == change_.starts && change.column == change_.column ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, ranks_);
  return all != 0;
}

/// Values where there are some already.
void GamgLevels::put(BlockMatrix<3, 3> const& values, Mat into) const {
  check(MatSetOption(into, MAT_ROW_ORIENTED, PETSC_FALSE));
  for (Index i = 0; i < values.rows(); ++i)
    for (Index k = values.starts[ix(i)]; k < values.starts[ix(i) + 1]; ++k) {
      PetscInt const row = begin_ + i, column = values.column[ix(k)];
      check(MatSetValuesBlocked(into, 1, &row, 1, &column, values.block(k).data(), INSERT_VALUES));
    }
  check(MatAssemblyBegin(into, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(into, MAT_FINAL_ASSEMBLY));
}

void GamgLevels::change(BlockMatrix<3, 3> const& change) {
  if (P_.empty())
    return;
  bool const again = fits(change), first = changed_.A.empty();
  if (again) {
    put(change, change_.at.back());
  } else {
    change_ = {change.starts, change.column, std::vector<OwnedMat>(P_.size() + 1)};
    change_.at.back() = matrix_of(change);
  }
  if (first)
    changed_.A.resize(free_.A.size());
  for (std::size_t l = P_.size(); l-- > 0;) {
    Mat product = change_.at[l];
    check(MatPtAP(change_.at[l + 1], P_[l], again ? MAT_REUSE_MATRIX : MAT_INITIAL_MATRIX, PETSC_DEFAULT,
                  again ? &product : change_.at[l].fresh()));
    if (first)
      check(MatDuplicate(free_.A[l], MAT_COPY_VALUES, changed_.A[l].fresh()));
    else
      check(MatCopy(free_.A[l], changed_.A[l], SAME_NONZERO_PATTERN));
    check(MatAXPY(changed_.A[l], 1, change_.at[l], SUBSET_NONZERO_PATTERN));
  }
  make_cycle(changed_);
}

void GamgLevels::correct(Vector const& r, bool changed, Vector& z) {
  z.setZero(r.size());
  if (P_.empty())
    return;
  check(VecPlaceArray(r_, r.data()));
  check(VecPlaceArray(z_, z.data()));
  check(MatMultTranspose(P_.back(), r_, coarse_r_));
  check(PCApply(changed && changed_.cycle != nullptr ? changed_.cycle : free_.cycle, coarse_r_, coarse_z_));
  check(MatMult(P_.back(), coarse_z_, z_));
  check(VecResetArray(r_));
  check(VecResetArray(z_));
}

} // namespace stiction::linear
