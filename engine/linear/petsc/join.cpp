// The processes that mpirun or srun has started together: messages between them by MPI and PETSc.
#include <chrono>
#include <thread>

#include "linear/petsc/coarse_levels.hpp"

namespace stiction::linear {

namespace {

/// Values of nodes beyond by a star forest.
class StarBorder final : public Ranks::Border {
public:
  StarBorder(MPI_Comm ranks, int rank, RankNodes const& nodes) : size_(3 * nodes.beyond.size()) {
    std::vector<PetscSFNode> from;
    for (Index const node : nodes.beyond) {
      auto const owner = std::ranges::upper_bound(nodes.first, node) - nodes.first.begin() - 1;
      from.push_back({static_cast<PetscInt>(owner), node - nodes.first[static_cast<std::size_t>(owner)]});
    }
    check(PetscSFCreate(ranks, sf_.fresh()));
    check(PetscSFSetGraph(sf_, nodes.first[ix(rank + 1)] - nodes.first[ix(rank)],
                          static_cast<PetscInt>(from.size()), nullptr, PETSC_COPY_VALUES, from.data(),
                          PETSC_COPY_VALUES));
    MPI_Type_contiguous(3, MPI_DOUBLE, &node_);
    MPI_Type_commit(&node_);
    check(PetscSFSetUp(sf_));
  }
  StarBorder(StarBorder const&) = delete;
  StarBorder& operator=(StarBorder const&) = delete;
  ~StarBorder() override { MPI_Type_free(&node_); }
  void exchange(Vector const& own, Vector& beyond) override {
    beyond.resize(static_cast<Eigen::Index>(size_));
    check(PetscSFBcastBegin(sf_, node_, own.data(), beyond.data(), MPI_REPLACE));
    check(PetscSFBcastEnd(sf_, node_, own.data(), beyond.data(), MPI_REPLACE));
  }

private:
  OwnedSF sf_;
  MPI_Datatype node_ = MPI_DATATYPE_NULL;
  std::size_t size_;
};

class PetscRanks final : public Ranks {
public:
  PetscRanks() {
    check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"));
    check(PetscInitializeNoArguments());
    check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    MPI_Comm_dup(PETSC_COMM_WORLD, &all_);
    MPI_Comm_dup(PETSC_COMM_WORLD, &ends_);
    MPI_Comm_rank(all_, &rank_);
    MPI_Comm_size(all_, &count_);
  }
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  using Ranks::sum;
  void sum(std::span<double> numbers) const override {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_SUM, all_);
  }
  [[nodiscard]] double largest(double number) const override {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_DOUBLE, MPI_MAX, all_);
    return number;
  }
  void gather(Vector const& own, Indices const& first, Vector& all) const override {
    all.resize(first.back());
    std::vector<int> counts;
    for (std::size_t r = 0; r + 1 < first.size(); ++r)
      counts.push_back(first[r + 1] - first[r]);
    MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, all.data(), counts.data(),
                   first.data(), MPI_DOUBLE, all_);
  }
  [[nodiscard]] std::unique_ptr<Border> border(RankNodes const& nodes) const override {
    return std::make_unique<StarBorder>(all_, rank_, nodes);
  }
  [[nodiscard]] std::unique_ptr<CoarseLevels> coarse_levels(Indices const& first) const override {
    return std::make_unique<GamgLevels>(all_, rank_, first);
  }
  [[nodiscard]] bool part(double seconds) const override {
    using namespace std::chrono;
    auto const until = steady_clock::now() + duration<double>(seconds);
    MPI_Request all_here = MPI_REQUEST_NULL;
    MPI_Ibarrier(ends_, &all_here);
    for (;;) {
      int here = 0;
      MPI_Test(&all_here, &here, MPI_STATUS_IGNORE);
      if (here != 0)
        return PetscFinalize() == 0;
      if (steady_clock::now() > until)
        return false;
      std::this_thread::sleep_for(milliseconds(1));
    }
  }
  [[noreturn]] void abort(int code) const override {
    MPI_Abort(all_, code);
    std::abort();
  }

private:
  MPI_Comm all_ = MPI_COMM_NULL, ends_ = MPI_COMM_NULL;
  int rank_ = 0, count_ = 1;
};

} // namespace

} // namespace stiction::linear

extern "C" __attribute__((visibility("default"))) stiction::linear::Ranks& stiction_join_ranks() {
  static auto* const joined = new stiction::linear::PetscRanks; // lives as long as the process
  return *joined;
}
