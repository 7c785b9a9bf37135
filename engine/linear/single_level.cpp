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
  auto const at = columns_of(from);
  P_transposed = {};
  P_transposed.reserve(from.columns, from.column.size());
  place_transposed.resize(from.column.size());
  for (Index j = 0, place = 0; j < from.columns; ++j) {
    for (Index k = at.starts[ix(j)]; k < at.starts[ix(j) + 1]; ++k) {
      place_transposed[ix(at.place[ix(k)])] = place++;
      P_transposed.push(at.row[ix(k)], from.block(at.place[ix(k)]).transpose());
    }
    P_transposed.end_row();
  }
}

template<int B>
void SingleLevel<B>::set_prolongation(Index k, Eigen::Matrix<double, B, coarse> const& block) {
  P.set(k, block);
  P_transposed.set(place_transposed[ix(k)], block.transpose());
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
  waves.forwards([&](Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      Eigen::Array<float, B, 1> const own = load<B>(r.data() + lanes<B> * ix(i)).template head<B>();
      Lanes<float, B> const motion = answer(i, own - left->template times<Way::up>(i, z.data()));
      store<B, float>(motion, z.data() + lanes<B> * ix(i));
      left->template add_transposed<Way::up>(i, -motion.template head<B>(), rest.data());
    }
  });
}

template<int B> void SingleLevel<B>::clear_padding(Eigen::VectorXf& all) const {
  constexpr int padding = lanes<B> - B;
  each_row(left->rows(), [&](Index i) { all.segment<padding>(lanes<B> * i + B).setZero(); });
}

template<int B> void SingleLevel<B>::backwards() {
  waves.backwards([&](Index first, Index last) {
    for (Index i = last - 1; i >= first; --i) {
      auto const at = lanes<B> * ix(i);
      Eigen::Array<float, B, 1> const own = load<B>(r.data() + at).template head<B>();
      Lanes<float, B> const motion = answer(i, own - left->template times<Way::down>(i, z.data()));
      store<B, float>(motion, z.data() + at);
      left->template add_transposed<Way::down>(i, -motion.template head<B>(), r.data());
    }
  });
}

template<int B> void SingleLevel<B>::restrict_to(Eigen::VectorXf& coarse_r) {
  clear_padding(rest);
  each_row(P_transposed.rows(), [&](Index j) {
    Eigen::Map<Eigen::Array<float, coarse, 1>>{coarse_r.data() + lanes<coarse> * ix(j)} =
        P_transposed.template times<Way::up>(j, rest.data());
  });
}

template<int B> void SingleLevel<B>::add_prolonged(Eigen::VectorXf const& coarse_z) {
  each_row(P.rows(), [&](Index i) {
    auto const more = P.template times<Way::up>(i, coarse_z.data());
    Eigen::Map<Eigen::Array<float, B, 1>>{z.data() + lanes<B> * ix(i)} += more;
  });
}

template struct SingleLevel<3>;
template struct SingleLevel<coarse>;

} // namespace stiction::linear
