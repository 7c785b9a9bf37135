// What PETSc's objects need to be held and used: owners of them, and failures as exceptions.
#pragma once
#include <petscksp.h>
#include <petscsf.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace stiction::linear {

inline void check(PetscErrorCode code) {
  if (code == 0)
    return;
  char const* words = nullptr;
  char* told = nullptr;
  PetscErrorMessage(static_cast<int>(code), &words, &told);
  throw std::runtime_error(std::string("PETSc: ") + (words != nullptr ? words : "unknown failure") +
                           (told != nullptr && *told != 0 ? std::string(": ") + told : ""));
}

/// Owner of an object of PETSc's.
template<class Object, PetscErrorCode (*destroy)(Object*)> class Owned {
public:
  Owned() = default;
  Owned(Owned const&) = delete;
  Owned& operator=(Owned const&) = delete;
  Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Owned() { reset(); }
  void reset() {
    if (object_ != nullptr)
      static_cast<void>(destroy(&object_));
    object_ = nullptr;
  }
  /// Where a function of PETSc's puts a new one.
  Object* fresh() {
    reset();
    return &object_;
  }
  /// One more owner of it.
  void share(Object object) {
    reset();
    check(PetscObjectReference(reinterpret_cast<PetscObject>(object)));
    object_ = object;
  }
  /// Becomes the owner of it.
  void take(Object object) {
    reset();
    object_ = object;
  }
  operator Object() const { return object_; } // NOLINT(google-explicit-constructor)

private:
  Object object_ = nullptr;
};

using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedPC = Owned<PC, PCDestroy>;
using OwnedSF = Owned<PetscSF, PetscSFDestroy>;
using OwnedNullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

} // namespace stiction::linear
