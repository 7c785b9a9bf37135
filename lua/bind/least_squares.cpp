// Least squares by a trust region, and what their judgement takes: singular values, quantiles of
// distributions. GSL and Eigen.
#include "bind/engine.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include "bind/push.hpp"
#include "bind/wrap.hpp"
#include "linear/decompositions.hpp"

namespace stiction::bind {

namespace {

using Matrix = Eigen::MatrixXd;

/// Elements of the list at `index`; false where one is no finite number, or there are others than `count`.
bool read_list(lua_State* lua, int index, std::size_t count, double* values) {
  bool good = lua_istable(lua, index) && lua_rawlen(lua, index) == count;
  for (std::size_t i = 0; i < count && good; ++i) {
    lua_rawgeti(lua, index, static_cast<lua_Integer>(i + 1));
    good = lua_isnumber(lua, -1) != 0 && std::isfinite(lua_tonumber(lua, -1));
    values[i] = lua_tonumber(lua, -1);
    lua_pop(lua, 1);
  }
  return good;
}

[[noreturn]] void refuse(char const* what) {
  throw core::RunError(std::string("least squares: ") + what);
}

/// Where the functions of a script stand on the stack, and how its calls went.
struct Problem {
  lua_State* lua;
  int residuals, jacobian;
  bool failed = false;    ///< then the error value is on top of the stack
  bool malformed = false; ///< an answer was no list of as many finite numbers
};

/// Calls one of the functions with x; its answer is left on the stack. False if it failed or gave nothing:
/// no Lua error may pass through GSL.
bool ask(Problem& problem, int function, gsl_vector const* x) {
  auto* const lua = problem.lua;
  lua_pushvalue(lua, function);
  lua_createtable(lua, static_cast<int>(x->size), 0);
  for (std::size_t i = 0; i < x->size; ++i) {
    push(lua, gsl_vector_get(x, i));
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  problem.failed = lua_pcall(lua, 1, 1, 0) != LUA_OK;
  if (problem.failed || lua_istable(lua, -1))
    return !problem.failed;
  lua_pop(lua, 1);
  return false;
}

int residuals(gsl_vector const* x, void* data, gsl_vector* f) {
  auto& problem = *static_cast<Problem*>(data);
  if (!ask(problem, problem.residuals, x))
    return GSL_EBADFUNC;
  problem.malformed = !read_list(problem.lua, lua_gettop(problem.lua), f->size, f->data);
  lua_pop(problem.lua, 1);
  return problem.malformed ? GSL_EBADFUNC : GSL_SUCCESS;
}

/// The answer is a list of columns.
int jacobian(gsl_vector const* x, void* data, gsl_matrix* J) {
  auto& problem = *static_cast<Problem*>(data);
  if (!ask(problem, problem.jacobian, x))
    return GSL_EBADFUNC;
  std::vector<double> column(J->size1);
  for (std::size_t k = 0; k < J->size2 && !problem.malformed; ++k) {
    lua_rawgeti(problem.lua, -1, static_cast<lua_Integer>(k + 1));
    problem.malformed = !read_list(problem.lua, lua_gettop(problem.lua), J->size1, column.data());
    lua_pop(problem.lua, 1);
    for (std::size_t i = 0; i < J->size1; ++i)
      gsl_matrix_set(J, i, k, column[i]);
  }
  lua_pop(problem.lua, 1);
  return problem.malformed ? GSL_EBADFUNC : GSL_SUCCESS;
}

/// Whether each(x) of a script gives something other than false or nil.
bool told_to_end(Problem& problem, int each, gsl_vector const* x) {
  auto* const lua = problem.lua;
  lua_pushvalue(lua, each);
  push(lua, std::vector<double>(x->data, x->data + x->size));
  lua_call(lua, 1, 1);
  bool const end = lua_toboolean(lua, -1) != 0;
  lua_pop(lua, 1);
  return end;
}

using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;
using Start = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;

/// least_squares(start, count, residuals, jacobian, each, most): Levenberg and Marquardt's steps from `start`
/// to least squares of the `count` residuals(x), a list, whose jacobian(x) is a list of columns. Ends when
/// each(x), called after every step, gives true, when a function gives nothing, or after `most` steps. -> the
/// last x and "ended", "most", or "stuck" (no step lessens the sum).
int least_squares(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  auto const parameters = static_cast<std::size_t>(luaL_len(lua, 1));
  auto const count = static_cast<std::size_t>(luaL_checkinteger(lua, 2));
  auto const most = luaL_checkinteger(lua, 6);
  if (parameters == 0 || count < parameters)
    refuse("fewer residuals than parameters");
  gsl_set_error_handler_off();
  Start const start(gsl_vector_alloc(parameters), gsl_vector_free);
  if (!read_list(lua, 1, parameters, start->data))
    refuse("the start is no list of finite numbers");
  Problem problem{lua, 3, 4};
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residuals;
  functions.df = jacobian;
  functions.n = count;
  functions.p = parameters;
  functions.params = &problem;
  auto const settings = gsl_multifit_nlinear_default_parameters();
  Workspace const work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, count, parameters),
                       gsl_multifit_nlinear_free);
  int status = gsl_multifit_nlinear_init(start.get(), &functions, work.get());
  char const* word = "most";
  for (lua_Integer i = 0; i < most && status == GSL_SUCCESS; ++i) {
    status = gsl_multifit_nlinear_iterate(work.get());
    if (status == GSL_SUCCESS && told_to_end(problem, 5, work->x)) {
      word = "ended";
      break;
    }
  }
  if (problem.failed)
    return lua_error(lua);
  if (problem.malformed)
    refuse("a function gave something else than lists of finite numbers, one for each residual");
  push(lua, std::vector<double>(work->x->data, work->x->data + parameters));
  push(lua, status == GSL_EBADFUNC ? "ended" : status == GSL_SUCCESS ? word : "stuck");
  return 2;
}

/// The matrix of the list of columns at `index`.
Matrix read_columns(lua_State* lua, int index) {
  luaL_checktype(lua, index, LUA_TTABLE);
  auto const columns = static_cast<Eigen::Index>(luaL_len(lua, index));
  lua_rawgeti(lua, index, 1);
  auto const rows = lua_istable(lua, -1) ? static_cast<Eigen::Index>(lua_rawlen(lua, -1)) : 0;
  lua_pop(lua, 1);
  Matrix A(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    lua_rawgeti(lua, index, k + 1);
    if (!read_list(lua, lua_gettop(lua), static_cast<std::size_t>(rows), A.col(k).data()))
      refuse("the columns are no lists of as many finite numbers");
    lua_pop(lua, 1);
  }
  return A;
}

/// singular(columns) -> singular values of the matrix of these columns, the largest first, and the right
/// vectors as a list of lists
int singular(lua_State* lua) {
  Matrix const A = read_columns(lua, 1);
  Eigen::JacobiSVD<Matrix> const svd(A, Eigen::ComputeFullV | Eigen::ComputeThinU);
  std::vector<double> values(static_cast<std::size_t>(A.cols()));
  for (Eigen::Index k = 0; k < std::min(A.rows(), A.cols()); ++k)
    values[static_cast<std::size_t>(k)] = svd.singularValues()(k);
  push(lua, values);
  lua_createtable(lua, static_cast<int>(A.cols()), 0);
  for (Eigen::Index k = 0; k < A.cols(); ++k) {
    push(lua, std::vector<double>(svd.matrixV().col(k).begin(), svd.matrixV().col(k).end()));
    lua_rawseti(lua, -2, k + 1);
  }
  return 2;
}

/// cholesky(rows) -> the rows of the lower factor L of a symmetric matrix, and the trace of its inverse; or
/// nil and the least eigenvalue of one that is not positive definite beyond rounding
int cholesky(lua_State* lua) {
  Matrix const A = read_columns(lua, 1);
  Eigen::Index const n = A.rows();
  if (A.cols() != n)
    refuse("the rows are not as long as they are many");
  Eigen::LLT<Matrix> const factor(A);
  if (factor.info() != Eigen::Success || factor.rcond() < 1e-13) {
    lua_pushnil(lua);
    push(lua, Eigen::SelfAdjointEigenSolver<Matrix>(A, Eigen::EigenvaluesOnly).eigenvalues().minCoeff());
    return 2;
  }
  Matrix const L = factor.matrixL();
  lua_createtable(lua, static_cast<int>(n), 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::VectorXd const row = L.row(i).head(i + 1);
    push(lua, std::vector<double>(row.begin(), row.end()));
    lua_rawseti(lua, -2, i + 1);
  }
  push(lua, L.triangularView<Eigen::Lower>().solve(Matrix::Identity(n, n)).squaredNorm());
  return 2;
}

/// What the first row of each group of so many is off by where the group is left out; Q: orthonormal columns,
/// off: what rows are off by with all.
Eigen::ArrayXd left_out(Matrix const& Q, Eigen::VectorXd const& off, Eigen::Index group) {
  if (group == 1)
    return off.array() / (1 - Q.rowwise().squaredNorm().array()).max(1e-12);
  Eigen::ArrayXd first(Q.rows() / group);
  for (Eigen::Index k = 0; k < first.size(); ++k) {
    auto const own = Q.middleRows(k * group, group);
    Matrix const rest = Matrix::Identity(group, group) - own * own.transpose();
    first[k] = rest.colPivHouseholderQr().solve(off.segment(k * group, group))[0];
  }
  return first;
}

/// regress(columns, values [, group]) -> coefficients of least squares, and the mean square of what each
/// value is off where it is left out, or with `group` rows that belong together (default 1) the first value
/// of each group where that is left out; nothing where the rows do not tell the columns apart
int regress(lua_State* lua) {
  Matrix const A = read_columns(lua, 1);
  Eigen::VectorXd y(A.rows());
  if (!read_list(lua, 2, static_cast<std::size_t>(A.rows()), y.data()))
    refuse("the values are no list of as many finite numbers as the columns have");
  auto const group = static_cast<Eigen::Index>(luaL_optinteger(lua, 3, 1));
  if (group < 1 || A.rows() % group != 0)
    refuse("the rows are not in groups of that size");
  Eigen::ColPivHouseholderQR<Matrix> const qr(A);
  if (A.rows() < A.cols() || qr.rank() < A.cols())
    return 0;
  Eigen::VectorXd const x = qr.solve(y), off = y - A * x;
  Matrix const Q = linear::first_columns(qr.householderQ(), A.cols());
  push(lua, std::vector<double>(x.begin(), x.end()));
  push(lua, left_out(Q, off, group).square().mean());
  return 2;
}

/// quantile(p [, degrees]) of the normal distribution, or of Student's with so many degrees of freedom
int quantile(lua_State* lua) {
  double const p = luaL_checknumber(lua, 1);
  push(lua,
       lua_isnoneornil(lua, 2) ? gsl_cdf_ugaussian_Pinv(p) : gsl_cdf_tdist_Pinv(p, luaL_checknumber(lua, 2)));
  return 1;
}

/// beyond(x [, degrees]): the probability of more than x, of the normal distribution or, with degrees of
/// freedom, of chi square
int beyond(lua_State* lua) {
  double const x = luaL_checknumber(lua, 1);
  push(lua, lua_isnoneornil(lua, 2) ? gsl_cdf_ugaussian_Q(x) : gsl_cdf_chisq_Q(x, luaL_checknumber(lua, 2)));
  return 1;
}

} // namespace

void add_least_squares_functions(lua_State* lua) {
  add<least_squares>(lua, "least_squares");
  add<singular>(lua, "singular");
  add<cholesky>(lua, "cholesky");
  add<regress>(lua, "regress");
  add<quantile>(lua, "quantile");
  add<beyond>(lua, "beyond");
}

} // namespace stiction::bind
