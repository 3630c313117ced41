// PETSc objects that are destroyed with their owner.
#pragma once

#include <petscksp.h>

#include <utility>

namespace bondstatic {

template <class Object, PetscErrorCode (*destroy)(Object*)>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Handle() {
    if (object_) destroy(&object_);
  }

  operator Object() const { return object_; }
  /// For a function that makes one; what was there before goes.
  Object* fresh() {
    if (object_) destroy(&object_);
    object_ = nullptr;
    return &object_;
  }

 private:
  Object object_ = nullptr;
};

using PetscMatrix = Handle<Mat, MatDestroy>;
using PetscVector = Handle<Vec, VecDestroy>;
using PetscNullSpace = Handle<MatNullSpace, MatNullSpaceDestroy>;
using PetscKrylov = Handle<KSP, KSPDestroy>;

}  // namespace bondstatic
