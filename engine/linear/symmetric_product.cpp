// Each block of the left triangle serves its row and, transposed, its column.
#include "linear/symmetric_product.hpp"

namespace stiction::linear {

void SymmetricProduct::take(BlockMatrix<3, 3> const& A, Waves const& waves) {
  waves_ = waves;
  left_ = {};
  left_.reserve(A.rows(), (A.column.size() - ix(A.rows())) / 2);
  own_.clear();
  for (Index i = 0; i < A.rows(); ++i) {
    Index k = A.starts[ix(i)];
    for (; A.column[ix(k)] < i; ++k)
      left_.push(A.column[ix(k)], A.block(k));
    left_.end_row();
    own_.emplace_back(A.block(k));
  }
  x_.setZero(lanes<3> * A.rows());
  y_.setZero(lanes<3> * A.rows());
}

void SymmetricProduct::operator()(Vector const& x, Vector& y) {
  unpadded<3>(x_) = by_node<3>(x);
  y_.setZero();
  waves_.forwards([&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      Eigen::Vector3d const own = x.segment<3>(3 * i);
      y_.segment<3>(lanes<3> * i) += left_.times<Way::up>(i, x_.data()).matrix() + own_[ix(i)] * own;
      left_.add_transposed<Way::up>(i, own.array(), y_.data());
    }
  });
  y.resize(x.size());
  by_node<3>(y) = unpadded<3>(y_);
}

} // namespace stiction::linear
