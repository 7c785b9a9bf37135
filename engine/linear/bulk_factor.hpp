// A bulk's factored matrix as contact needs it: loads condensed onto the surface, the surface's compliance,
// corrections expanded. Who holds one knows nothing of how the factor is stored.
#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "linear/pattern.hpp"

namespace stiction::linear {

/// What one factorization takes.
struct Effort {
  double entries = 0;    ///< numbers that the factor stores
  double operations = 0; ///< of floating point
};

/// What the compliance of surface unknowns has taken.
struct Spent {
  long columns = 0;
  double operations = 0; ///< of floating point
};

/// What a factor has beside its matrix when a step ends: it saves work in the next, whose answers may depend
/// on it in their last digits.
struct Carried {
  Indices columns;     ///< of the compliance that are known: the first of each group
  Vector load, motion; ///< loads on the surface and motions of all, end to end, the last first; or empty
};

/// A number beside the symmetric matrix: in the column of a surface unknown, counted from the first of them.
struct ColumnEntry {
  Index row, column;
  double value;
};

/// When the surface is held beside what the matrix itself does.
enum class Hold { if_needed, always };

/// One number of H: row of a contact force over the surface's unknowns.
struct SurfaceEntry {
  Index row, column;
  double value;
  bool operator==(SurfaceEntry const&) const = default;
};

/// Rows of contact forces on the surface: p acts as weight H^T p, and x = H u.
struct SurfaceRows {
  std::vector<SurfaceEntry> H;
  Index count = 0;
  double weight = 1;
};

/// A linear law between forces p and displacements x of points of C rows each: A p + B x = right.
struct PointLaws {
  Dense A, B; ///< [rows, C], a block per point, one below the other
  Vector right;
};

/// What a bulk without columns does instead: contact is solved together with it. Motions are those of W p =
/// weight H V H^T p for the rows last given.
class CoupledBulk {
public:
  virtual ~CoupledBulk() = default;
  virtual void couple(SurfaceRows rows) = 0;
  /// x += W p. Not finite where that cannot be solved for.
  virtual void add_motion(Vector const& p, Eigen::Ref<Vector> x) = 0;
  /// About the diagonal blocks of W, [rows, components]: what sets scales.
  [[nodiscard]] virtual Dense blocks(Index components) const = 0;
  /// Changes of forces and motions that follow the laws, about the forces p and the motion last found or
  /// advanced to; to |error| <= tolerance |all that is wrong|. What is wrong with that motion goes into dx.
  /// False where there is no finite answer.
  [[nodiscard]] virtual bool solve(PointLaws const& laws, Vector const& p, double tolerance, Vector& dp,
                                   Vector& dx) = 0;
  /// Takes up this part of the change last found.
  virtual void advance(double part) = 0;
};

/// Of a matrix of fixed pattern; its last unknowns are those of the surface.
class BulkFactor {
public:
  explicit BulkFactor(Index surface) : surface_(surface) {}
  BulkFactor(BulkFactor const&) = delete;
  BulkFactor& operator=(BulkFactor const&) = delete;
  virtual ~BulkFactor() = default;
  /// One of the same pattern that holds nothing yet.
  [[nodiscard]] virtual std::unique_ptr<BulkFactor> another() const = 0;

  /// values[entries] of the lower triangle; where they are not positive definite alone but would be with the
  /// surface held, ten times their largest is added on its diagonal. columns: of surface unknowns, beside
  /// values, not symmetric. False if that does not help either.
  [[nodiscard]] bool factorize(std::span<double> values, std::vector<ColumnEntry> columns = {},
                               Hold hold = Hold::if_needed);
  /// What the last matrix got on the diagonal of its surface to be held, or 0. Condensed loads, compliance
  /// and corrections are those of the held matrix: without it, and without the stiffness that contact brings
  /// along, there may be none. Who adds the one takes away the other.
  [[nodiscard]] double hold() const { return hold_; }
  /// Of the matrix last factored: who keeps it can tell whether that is still the same one.
  [[nodiscard]] std::shared_ptr<void const> const& identity() const { return identity_; }
  /// Is the compliance?
  [[nodiscard]] virtual bool symmetric() const { return true; }

  /// b[n] becomes what `expand` wants; returns the motion of the surface that b alone gives.
  [[nodiscard]] virtual Vector condense(Vector& b) = 0;
  /// From what `condense` left the motion of all with `surface_load` on the surface beside b.
  virtual void expand(Vector const& surface_load, Vector& b) = 0;
  /// Those of several right sides at once, which take less than one by one; the numbers do not depend on
  /// which of them come together.
  [[nodiscard]] virtual std::vector<Vector> condense_all(std::span<Vector* const> b);
  virtual void expand_all(std::span<Vector const* const> surface_loads, std::span<Vector* const> b);
  /// C(i, j): motion of surface unknown used[i] per load on used[j]. Only columns that have not been asked
  /// for since the matrix was factored take work; the numbers do not depend on what was asked for before.
  virtual void compliance(Indices const& used, Dense& C) = 0;
  /// A x = b in place.
  void solve(Vector& b);
  /// What a step that ends now leaves to the next; null: nothing.
  [[nodiscard]] virtual std::shared_ptr<Carried const> carried() const { return nullptr; }
  /// From here on all is as if the present matrix had just been factored and `what` were left by the step
  /// before; null: nothing. Columns that are known stay known.
  virtual void carry_on(Carried const* what) { static_cast<void>(what); }
  /// This, if columns of the compliance cost it a solution each; else none.
  [[nodiscard]] virtual CoupledBulk* coupled() { return nullptr; }

  [[nodiscard]] virtual Pattern const& pattern() const = 0;
  [[nodiscard]] Index surface() const { return surface_; }
  [[nodiscard]] Index first_of_surface() const { return pattern().size() - surface_; }
  [[nodiscard]] virtual Effort effort() const = 0;
  /// Since this was asked for last.
  [[nodiscard]] Spent spent() { return std::exchange(spent_, {}); }
  /// Numbers held beside the factor for the sake of the surface.
  [[nodiscard]] virtual double surface_numbers() const = 0;

protected:
  [[nodiscard]] virtual bool take(std::span<double const> values) = 0;
  [[nodiscard]] virtual bool add(std::vector<ColumnEntry> columns) = 0;
  void spend(long columns, double operations) {
    spent_.columns += columns;
    spent_.operations += operations;
  }

private:
  Index surface_;
  double hold_ = 0;
  std::shared_ptr<void const> identity_;
  Spent spent_;
};

/// The factor that suits the pattern, which comes in elimination order but for its surface: diagonal where
/// nothing is coupled; else the surface last, or wherever it fills least if that is expected to cost less.
/// skew: will there be columns beside the symmetric matrix?
[[nodiscard]] std::unique_ptr<BulkFactor> make_bulk_factor(Pattern pattern, Index surface, bool skew = false);

} // namespace stiction::linear
