// The bulk seen from the contact points: rows of H and geometric stiffness reduced to the Delassus operator.
#pragma once
#include <Eigen/LU>

#include "linear/bulk_factor.hpp"

namespace stiction::dynamics {

/// Rows of H and K_geo of the active points over the surface unknowns, kept point by point as they are
/// sparse. Workspace is kept between calls.
class Condensation {
public:
  void clear();
  /// The rows of H alone, for `go_on`.
  void clear_rows();
  /// unknowns[columns]: surface unknown behind each column of H, -1 if driven. H: [components, columns].
  void add_point(Indices const& unknowns, Eigen::Ref<Dense const> const& H);
  void add_stiffness(Indices const& unknowns, Eigen::Ref<Dense const> const& K);

  /// weight: of the step's end reaction in the balance. With V the bulk's compliance, (I - weight V K_geo) du
  /// = y + weight V H^T p gives x = free + W p, where x = H du. What holds the bulk's surface is taken away
  /// like a K_geo. W is left as it is where nothing that it is made of has changed since the last problem.
  void eliminate(linear::BulkFactor& bulk, Vector const& y, double weight, Dense& W, Vector& free);
  /// The same about the forces p of points that are where they were but for little: W, K_geo and all that is
  /// made of them stay those last eliminated, and free is such that W p leads where these rows do. False
  /// where that is a matter of another bulk or of other unknowns.
  [[nodiscard]] bool go_on(linear::BulkFactor& bulk, Vector const& y, Vector const& p, Dense const& W,
                           Vector& free);
  /// The rows of H for a bulk that contact is solved together with, and free = H y; there is no K_geo then.
  [[nodiscard]] linear::SurfaceRows rows(Vector const& y, double weight, Vector& free);
  /// W is not what it was left as.
  void forget() { made_of_ = {}; }
  /// Has the problem last eliminated a K_geo?
  [[nodiscard]] bool turns() const { return support_ > 0; }
  /// Of the problem last eliminated: would the bulk with K_geo be stable without contact, V^-1 - weight K_geo
  /// positive definite in its symmetric part? Nothing is said of a bulk that has to be held.
  [[nodiscard]] bool stable() const;
  /// c += weight (K_geo du + H^T p) for the forces p of the problem last eliminated.
  void add_forces(Vector const& force, double weight, Vector& c) const;

private:
  using Entry = linear::SurfaceEntry; ///< of K: two unknowns
  /// What W is made of.
  struct Origin {
    std::shared_ptr<void const> bulk; ///< its matrix
    double weight = 0;
    std::vector<Entry> H;
    bool turns = false; ///< there is a K
  };
  Index rows_ = 0;
  bool symmetric_ = true, held_ = false; ///< the bulk last eliminated
  std::vector<Entry> H_, K_;
  Origin made_of_; ///< the last W
  void find_used(Index surface);
  [[nodiscard]] bool one_to_one() const;
  [[nodiscard]] bool same_unknowns() const;
  void set_mobility(linear::BulkFactor& bulk, Dense& W);
  void add_stiffness_of_contact(Dense& W);
  void move(Vector const& y, Vector& free);

  Indices used_, slot_; ///< unknowns that K and H touch, those of K first; the slot of each there or -1
  double weight_ = 1;   ///< of the problem last eliminated
  Index support_ = 0;   ///< how many of them K touches
  Dense V_;             ///< between them
  Dense right_;         ///< weight V H^T, [used, rows]
  Dense left_;          ///< weight V^T H^T on the support, [support, rows]; where V is not symmetric
  Dense small_;         ///< I - weight V K on the support
  Dense K_all_;         ///< weight K on the support, where it has more entries than slots
  Eigen::PartialPivLU<Dense> inverse_; ///< of small_
  Dense motion_;                       ///< du on the support per force, [support, rows]
  Dense K_motion_;                     ///< weight K motion
  Vector K_moved_;                     ///< the same of the motion without forces, or with those of `about_`
  Vector about_;                       ///< forces that the last problem is about; empty: none
};

} // namespace stiction::dynamics
