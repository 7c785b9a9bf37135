// Assembly of the mass matrix; every variant keeps each body's total mass.
#include "dynamics/model/mass.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {

/// Consistent mass of one cell and which of its nodes lie on a contact surface.
struct CellMass {
  Dense values;
  std::vector<bool> on_surface;
  [[nodiscard]] bool touches(Eigen::Index a, Eigen::Index b) const {
    return on_surface[static_cast<std::size_t>(a)] || on_surface[static_cast<std::size_t>(b)];
  }
};

/// Entries of contact nodes go to the diagonal, row by row. Cells of second order, whose corners would be
/// left with no mass or a negative one, are lumped whole, in proportion to their diagonal.
void lump_surface(CellMass& cell) {
  auto& m = cell.values;
  bool const touched =
      std::find(cell.on_surface.begin(), cell.on_surface.end(), true) != cell.on_surface.end();
  if (touched && m.rowwise().sum().minCoeff() < 1e-6 * m.sum()) {
    m = (m.sum() / m.trace() * m.diagonal()).asDiagonal().toDenseMatrix();
    return;
  }
  for (Eigen::Index a = 0; a < m.rows(); ++a)
    for (Eigen::Index b = 0; b < m.cols(); ++b)
      if (a != b && cell.touches(a, b)) {
        m(a, a) += m(a, b);
        m(a, b) = 0;
      }
}

/// Entries of contact nodes vanish and the others grow so that the cell keeps its mass. A cell whose nodes
/// all lie on the surface is left empty.
void strip_surface(CellMass& cell) {
  auto& m = cell.values;
  double const whole = m.sum();
  for (Eigen::Index a = 0; a < m.rows(); ++a)
    for (Eigen::Index b = 0; b < m.cols(); ++b)
      if (cell.touches(a, b))
        m(a, b) = 0;
  if (double const rest = m.sum(); rest > 0)
    m *= whole / rest;
}

/// Adds one body's cells to the matrix, scaled so that the body keeps its mass.
void add_body(Model const& model, std::size_t body, std::vector<bool> const& on_surface,
              ContactInertia inertia, Mass& mass) {
  Index const first = model.first_node[body];
  double whole = 0, kept = 0;
  std::vector<std::pair<Index, double>> entries;
  model.cells[body].each_mass([&](std::span<Index const> nodes, Dense const& consistent) {
    CellMass cell{consistent, {}};
    for (Index const node : nodes)
      cell.on_surface.push_back(on_surface[ix(first + node)]);
    whole += consistent.sum();
    if (inertia == ContactInertia::none)
      strip_surface(cell);
    if (inertia == ContactInertia::implicit || inertia == ContactInertia::cells)
      lump_surface(cell);
    kept += cell.values.sum();
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      auto const row = static_cast<Eigen::Index>(a);
      mass.dead_load.segment(mass.dim * (first + nodes[a]), mass.dim) +=
          consistent.row(row).sum() * model.gravity.head(mass.dim);
      for (std::size_t b = 0; b <= a; ++b)
        entries.emplace_back(mass.pattern.find(first + nodes[a], first + nodes[b]),
                             cell.values(row, static_cast<Eigen::Index>(b)));
    }
  });
  for (auto const& [entry, value] : entries)
    mass.values[ix(entry)] += kept > 0 ? value * (whole / kept) : 0.0;
}

/// y += M x in D components; the first entry of a column is that of its diagonal.
template<int D> void add_product(Mass const& mass, Vector const& x, Vector& y) {
  auto const& pattern = mass.pattern;
  for (Index j = 0; j < pattern.size(); ++j) {
    Index const first = pattern.columns[ix(j)];
    Eigen::Matrix<double, D, 1> const of_j = x.segment<D>(D * j);
    Eigen::Matrix<double, D, 1> sum = mass.values[ix(first)] * of_j;
    for (Index k = first + 1; k < pattern.columns[ix(j) + 1]; ++k) {
      Index const i = pattern.rows[ix(k)];
      y.segment<D>(D * i) += mass.values[ix(k)] * of_j;
      sum += mass.values[ix(k)] * x.segment<D>(D * i);
    }
    y.segment<D>(D * j) += sum;
  }
}

} // namespace

Vector lumped(Dense const& consistent) {
  CellMass cell{consistent, std::vector<bool>(static_cast<std::size_t>(consistent.rows()), true)};
  lump_surface(cell);
  return cell.values.diagonal();
}

Mass assemble_mass(Model const& model, std::vector<bool> const& on_surface, ContactInertia inertia) {
  std::vector<Indices> cliques;
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    model.cells[body].each_cell([&](std::span<Index const> nodes) {
      cliques.emplace_back();
      for (Index const node : nodes)
        cliques.back().push_back(model.first_node[body] + node);
    });
  Mass mass;
  mass.dim = model.dim();
  mass.pattern = linear::pattern_of(model.node_count(), cliques);
  mass.values.assign(mass.pattern.rows.size(), 0.0);
  mass.dead_load.setZero(model.dofs());
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    add_body(model, body, on_surface, inertia, mass);
  for (auto const& rigid : model.rigids)
    if (rigid.free()) {
      mass.values[ix(mass.pattern.find(rigid.node, rigid.node))] = rigid.mass;
      mass.values[ix(mass.pattern.find(rigid.node + 1, rigid.node + 1))] = rigid.inertia;
      mass.dead_load.segment(mass.dim * rigid.node, mass.dim) =
          (rigid.mass * model.gravity + rigid.force).head(mass.dim);
    }
  return mass;
}

void Mass::times(Vector const& x, Vector& y) const {
  y.setZero(x.size());
  if (dim == 2)
    add_product<2>(*this, x, y);
  else
    add_product<3>(*this, x, y);
}

Vector Mass::diagonal() const {
  Vector all(dead_load.size());
  for (Index j = 0; j < pattern.size(); ++j)
    all.segment(dim * j, dim).setConstant(values[ix(pattern.columns[ix(j)])]);
  return all;
}

Vector Mass::solve(Vector const& f, std::vector<bool> const& held) const {
  Vector inverse = diagonal();
  for (Index i = 0; i < inverse.size(); ++i)
    inverse[i] = held[ix(i)] || !(inverse[i] > 0) ? 0 : 1 / inverse[i];
  auto const project = [&](Vector& y) { y = (inverse.array() > 0).select(y, 0.0); };
  Vector x = Vector::Zero(f.size()), r = f, y;
  project(r);
  Vector z = inverse.cwiseProduct(r), p = z;
  double rz = r.dot(z);
  double const target = 1e-32 * rz;
  for (Index iteration = 0; iteration < 1000 && rz > target; ++iteration) {
    times(p, y);
    project(y);
    double const length = rz / p.dot(y);
    x += length * p;
    r -= length * y;
    z = inverse.cwiseProduct(r);
    double const next = r.dot(z);
    p = z + (next / rz) * p;
    rz = next;
  }
  return x;
}

} // namespace stiction::dynamics
