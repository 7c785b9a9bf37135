// The bulk seen from the contact points: rows of H and geometric stiffness reduced to the Delassus operator.
#pragma once
#include "linear/bulk_factor.hpp"
#include "linear/decompositions.hpp"

namespace stiction::dynamics {

/// Rows of H and K_geo of the active points over the surface unknowns, kept point by point as they are
/// sparse. Workspace is kept between calls.
class Condensation {
public:
  void clear();
  /// unknowns[columns]: surface unknown behind each column of H, -1 if driven. H: [components, columns].
  void add_point(Indices const& unknowns, Eigen::Ref<Dense const> const& H);
  /// Of the point last added: how gap and slip change with the unknowns beyond what H, the rows of its
  /// forces, says. [components, columns]
  void add_change(Indices const& unknowns, Eigen::Ref<Dense const> const& change);
  void add_stiffness(Indices const& unknowns, Eigen::Ref<Dense const> const& K);

  /// weight: of the step's end reaction in the balance. With V the bulk's compliance, (I - weight V K_geo) du
  /// = y + weight V H^T p gives x = free + W p, where x = (H + change) du. What holds the bulk's surface is
  /// taken away like a K_geo. W is left as it is where nothing that it is made of has changed since the last
  /// problem.
  void eliminate(linear::BulkFactor& bulk, Vector const& y, double weight, Dense& W, Vector& free);
  /// What the surface does without contact, [surface unknowns], and the forces of its rows with H^T p of
  /// them.
  struct Present {
    Vector const& y;
    Vector const& force;
    Vector const& reaction;
  };
  /// Lets the next problem be eliminated anew.
  void forget() { of_.reset(); }
  /// Are the rows and stiffnesses all but those that W was last made of? They may be off by `slight` of what
  /// is largest among them. False of rows without stiffness that are just those: `eliminate` leaves W then.
  [[nodiscard]] bool like_last(linear::BulkFactor const& bulk, double weight, double slight) const;
  /// As the problem that `lead` last eliminated, whose W holds, from present forces whose rows H differ a
  /// little: changes of forces act by the lead's. False, and nothing done, where that was of another matrix
  /// or of other nodes. `lead`, which may be this one, must stay as it is until the forces are added.
  [[nodiscard]] bool eliminate_as(Condensation const& lead, linear::BulkFactor const& bulk,
                                  Present const& now, double weight, Vector& free);
  /// The rows of H for a bulk that contact is solved together with, and free = H y; there is neither K_geo
  /// nor change then.
  [[nodiscard]] linear::SurfaceRows rows(Vector const& y, double weight, Vector& free);
  /// Has the problem last eliminated a K_geo?
  [[nodiscard]] bool turns() const { return support_ > 0; }
  /// Of the problem last eliminated: would the bulk with K_geo be stable without contact, V^-1 - weight K_geo
  /// positive definite in its symmetric part? Nothing is said of a bulk that has to be held.
  [[nodiscard]] bool stable() const;
  /// c += weight (K_geo du + H^T p) for the forces p of the problem last eliminated.
  void add_forces(Vector const& force, double weight, Vector& c) const;

private:
  using Entry = linear::SurfaceEntry; ///< of K: two unknowns
  /// What W is made of where there is no K.
  struct Origin {
    std::shared_ptr<void const> bulk; ///< its matrix
    double weight = 0;
    std::vector<Entry> H;
  };
  struct Gathered {
    Index rows = 0;
    std::vector<Entry> H, change, K;
  };
  bool symmetric_ = true, held_ = false; ///< the bulk last eliminated
  Gathered now_;                         ///< since the last clear
  Gathered made_;                        ///< of the problem last eliminated, but for one like a lead's
  Origin made_of_;                       ///< the last W
  std::shared_ptr<void const> of_;       ///< the matrix of the problem last eliminated
  Condensation const* lead_ = nullptr;   ///< whose problem that was like; null: like none
  void find_used(Index surface);
  [[nodiscard]] bool one_to_one() const;
  [[nodiscard]] bool alike() const { return symmetric_ && made_.change.empty(); } ///< rows and columns of W
  /// weight (H + change) V on the support, [rows, support]
  [[nodiscard]] auto sides() const {
    return (alike() ? right_ : left_).topLeftCorner(support_, made_.rows).transpose();
  }
  template<class Act> void each_row_entry(Act const& act) const;
  void set_mobility(linear::BulkFactor& bulk, Dense& W);
  void add_stiffness_of_contact(Dense& W);
  void move_without_forces(Condensation const& made, Vector const& y, Vector& free);

  Indices used_, slot_; ///< unknowns that K and H touch, those of K first; the slot of each there or -1
  double weight_ = 1;   ///< of the problem last eliminated
  Index support_ = 0;   ///< how many of them K touches
  Dense V_;             ///< between them
  Dense right_;         ///< weight V H^T, [used, rows]
  Dense across_;        ///< its transpose
  Dense left_;  ///< weight V^T (H + change)^T on the support, [support, rows]; where it is not that of right_
  Dense small_; ///< I - weight V K on the support
  Dense K_all_; ///< weight K on the support, where it has more entries than slots
  Eigen::PartialPivLU<Dense> small_factor_;
  Dense K_motion_;  ///< weight K du on the support, a row per force, [rows, support]
  Vector K_moving_; ///< the same without forces, [support]
  Vector extra_;    ///< of a problem like a lead's: weight (H - H of the lead)^T p, [surface unknowns]
  Vector moved_;    ///< the surface by y and these, m
};

} // namespace stiction::dynamics
