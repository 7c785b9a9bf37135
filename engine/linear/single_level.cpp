// Sweeps over the left triangle.
#include "linear/single_level.hpp"

namespace stiction::linear {

template<int B> void SingleLevel<B>::take_matrix(BlockMatrix<B, B> const& A) {
  auto rows = std::make_shared<PackedRows<float, B, B>>();
  rows->reserve(A.rows(), (A.column.size() - ix(A.rows())) / 2);
  for (Index i = 0; i < A.rows(); ++i) {
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1] && A.column[ix(k)] < i; ++k)
      rows->push(A.column[ix(k)], A.block(k));
    rows->end_row();
  }
  left = std::move(rows);
  inverse.assign(ix(B * lanes<B> * A.rows()), 0.0F);
  for (auto* vector : {&r, &z, &rest})
    vector->setZero(lanes<B> * A.rows());
}

template<int B> void SingleLevel<B>::take_prolongation(BlockMatrix<B, coarse> const& from) {
  P = {};
  P.reserve(from.rows(), from.column.size());
  for (Index i = 0; i < from.rows(); ++i) {
    for (Index k = from.starts[ix(i)]; k < from.starts[ix(i) + 1]; ++k)
      P.push(from.column[ix(k)], from.block(k));
    P.end_row();
  }
}

template<int B> void SingleLevel<B>::set_inverse(Index i, Square const& block) {
  for (int c = 0; c < B; ++c)
    Eigen::Map<Eigen::Matrix<float, B, 1>>(inverse.data() + lanes<B> * ix(B * i + c)) =
        block.col(c).template cast<float>();
}

template<int B>
Lanes<float, B> SingleLevel<B>::answer(Index i, Eigen::Array<float, B, 1> const& load_of_i) const {
  Lanes<float, B> motion = Lanes<float, B>::Zero();
  for (int c = 0; c < B; ++c)
    motion += load<B>(inverse.data() + lanes<B> * ix(B * i + c)) * load_of_i[c];
  return motion;
}

template<int B> void SingleLevel<B>::forwards() {
  rest.setZero();
  for (Index i = 0; i < left->rows(); ++i) {
    Eigen::Array<float, B, 1> const own = load<B>(r.data() + lanes<B> * ix(i)).template head<B>();
    Lanes<float, B> const motion = answer(i, own - left->template times<Way::up>(i, z.data()));
    store<B, float>(motion, z.data() + lanes<B> * ix(i));
    left->template add_transposed<Way::up>(i, -motion.template head<B>(), rest.data());
  }
}

template<int B> void SingleLevel<B>::backwards() {
  for (Index i = left->rows() - 1; i >= 0; --i) {
    auto const at = lanes<B> * ix(i);
    Eigen::Array<float, B, 1> const own = load<B>(r.data() + at).template head<B>();
    Lanes<float, B> const motion = answer(i, own - left->template times<Way::down>(i, z.data()));
    store<B, float>(motion, z.data() + at);
    left->template add_transposed<Way::down>(i, -motion.template head<B>(), r.data());
  }
}

template<int B> void SingleLevel<B>::restrict_to(Eigen::VectorXf& coarse_r) const {
  coarse_r.setZero();
  for (Index i = 0; i < P.rows(); ++i)
    P.template add_transposed<Way::up>(i, load<B>(rest.data() + lanes<B> * ix(i)).template head<B>(),
                                       coarse_r.data());
}

template<int B> void SingleLevel<B>::add_prolonged(Eigen::VectorXf const& coarse_z) {
  for (Index i = 0; i < P.rows(); ++i) {
    auto const more = P.template times<Way::up>(i, coarse_z.data());
    Eigen::Map<Eigen::Array<float, B, 1>>{z.data() + lanes<B> * ix(i)} += more;
  }
}

template struct SingleLevel<3>;
template struct SingleLevel<coarse>;

} // namespace stiction::linear
