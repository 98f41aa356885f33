// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elasticity_assembly.hpp"

#include "fem/discretisation/node_order.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::fem {

CellStiffness::CellStiffness(const ElasticProblem& problem)
    : nodes_(problem.dofs.get_fe().dofs_per_cell / 3),
      scalar_(problem.dofs.get_fe().degree),
      quadrature_(scalar_.degree + 1),
      values_(
          problem.mapping, scalar_, quadrature_,
          dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points),
      lambda_(lame_lambda(problem.material)),
      mu_(lame_mu(problem.material)),
      position_(3 * nodes_),
      gradients_(3 * nodes_),
      products_(9 * nodes_ * nodes_),
      projected_(projects_dilatation(problem)),
      space_(static_cast<int>(scalar_.degree)),
      projected_gradients_(DilatationSpace::largest_size * 3 * nodes_),
      density_(has_inertia(problem) ? problem.material.density : 0.0),
      motion_(problem.motion),
      inertia_(nodes_ * nodes_, 0.0),
      stiffness_(9 * nodes_ * nodes_) {
  const auto& element = problem.dofs.get_fe();
  for (unsigned int dof = 0; dof < element.dofs_per_cell; ++dof) {
    const auto [component, node] = element.system_to_component_index(dof);
    position_[3 * node + component] = dof;
  }
}

void CellStiffness::integrate() {
  const unsigned int n = 3 * nodes_;
  std::fill(products_.begin(), products_.end(), 0.0);
  for (unsigned int q = 0; q < quadrature_.size(); ++q) {
    for (unsigned int a = 0; a < nodes_; ++a)
      for (unsigned int i = 0; i < 3; ++i) gradients_[3 * a + i] = values_.shape_grad(a, q)[i];
    for (unsigned int r = 0; r < n; ++r) {
      const double left = values_.JxW(q) * gradients_[r];
      double* const row = &products_[r * n];
      for (unsigned int c = r; c < n; ++c) row[c] += left * gradients_[c];
    }
  }
  for (unsigned int r = 1; r < n; ++r)
    for (unsigned int c = 0; c < r; ++c) products_[r * n + c] = products_[c * n + r];
}

void CellStiffness::project_dilatation() {
  const unsigned int n = 3 * nodes_;
  space_.reinit(values_.get_quadrature_points(), values_.get_JxW_values());
  std::fill(projected_gradients_.begin(), projected_gradients_.end(), 0.0);
  for (unsigned int q = 0; q < quadrature_.size(); ++q) {
    const auto functions = space_.values(values_.quadrature_point(q));
    for (int k = 0; k < space_.size(); ++k)
      for (unsigned int a = 0; a < nodes_; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          projected_gradients_[k * n + 3 * a + i] +=
              values_.JxW(q) * functions[k] * values_.shape_grad(a, q)[i];
  }
}

void CellStiffness::integrate_inertia() {
  std::fill(inertia_.begin(), inertia_.end(), 0.0);
  std::vector<double> along(nodes_);
  for (unsigned int q = 0; q < quadrature_.size(); ++q) {
    const auto velocity = motion_.at(values_.quadrature_point(q));
    for (unsigned int a = 0; a < nodes_; ++a) along[a] = velocity * values_.shape_grad(a, q);
    for (unsigned int a = 0; a < nodes_; ++a)
      for (unsigned int b = 0; b < nodes_; ++b)
        inertia_[a * nodes_ + b] += density_ * values_.JxW(q) * along[a] * along[b];
  }
}

const std::vector<double>& CellStiffness::compute(
    const dealii::DoFHandler<3>::active_cell_iterator& cell) {
  const unsigned int n = 3 * nodes_;
  values_.reinit(static_cast<const dealii::Triangulation<3>::active_cell_iterator&>(cell));
  integrate();
  if (projected_) project_dilatation();
  if (density_ > 0) integrate_inertia();
  for (unsigned int a = 0; a < nodes_; ++a)
    for (unsigned int b = 0; b < nodes_; ++b) {
      const auto product = [&](unsigned int i, unsigned int j) {
        return products_[(3 * a + i) * n + 3 * b + j];
      };
      const auto dilatations = [&](unsigned int i, unsigned int j) {
        if (!projected_) return product(i, j);
        double sum = 0;
        for (int k = 0; k < space_.size(); ++k)
          sum += projected_gradients_[k * n + 3 * a + i] * projected_gradients_[k * n + 3 * b + j];
        return sum;
      };
      const double laplace =
          mu_ * (product(0, 0) + product(1, 1) + product(2, 2)) - inertia_[a * nodes_ + b];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          stiffness_[position_[3 * a + i] * n + position_[3 * b + j]] =
              lambda_ * dilatations(i, j) + mu_ * product(j, i) + (i == j ? laplace : 0.0);
    }
  return stiffness_;
}

FreeUnknowns number_free_unknowns(const dealii::AffineConstraints<double>& constraints,
                                  const std::vector<Multiple>& multiples) {
  const auto size = static_cast<int>(multiples.size());
  FreeUnknowns unknowns;
  std::vector<int> number(multiples.size(), -1);
  for (int i = 0; i < size; ++i)
    if (multiples[i].of == i && multiples[i].factor != 0.0 && !constraints.is_constrained(i))
      number[i] = unknowns.count++;
  unknowns.row_start.reserve(multiples.size() + 1);
  unknowns.row_start.push_back(0);
  const auto add = [&](const Multiple& term, double weight) {
    if (number[term.of] < 0) return;
    unknowns.column.push_back(number[term.of]);
    unknowns.weight.push_back(term.factor * weight);
  };
  for (int i = 0; i < size; ++i) {
    if (!constraints.is_constrained(i))
      add(multiples[i], 1.0);
    else  // a closed AffineConstraints refers to unconstrained unknowns only
      for (const auto& [master, weight] : *constraints.get_constraint_entries(i))
        add(multiples[master], weight);
    unknowns.row_start.push_back(static_cast<std::int64_t>(unknowns.column.size()));
  }
  return unknowns;
}

FreeUnknowns number_free_unknowns(const dealii::DoFHandler<3>& dofs,
                                  const dealii::AffineConstraints<double>& constraints) {
  std::vector<Multiple> each(dofs.n_dofs());
  for (std::size_t i = 0; i < each.size(); ++i) each[i] = {static_cast<int>(i), 1.0};
  return number_free_unknowns(constraints, each);
}

void FreeUnknowns::condense(const Vector& b, std::vector<double>& x) const {
  x.assign(count, 0.0);
  for (std::size_t i = 0; i + 1 < row_start.size(); ++i)
    for (auto k = row_start[i]; k < row_start[i + 1]; ++k)
      x[column[k]] += weight[k] * b.local_element(static_cast<unsigned int>(i));
}

void FreeUnknowns::expand_and_add(const double* x, Vector& u) const {
  for (std::size_t i = 0; i + 1 < row_start.size(); ++i) {
    double value = 0.0;
    for (auto k = row_start[i]; k < row_start[i + 1]; ++k) value += weight[k] * x[column[k]];
    u.local_element(static_cast<unsigned int>(i)) += value;
  }
}

void SymmetricMatrix::multiply(const std::vector<double>& x, std::vector<double>& y) const {
  y.assign(size, 0.0);
  for (int c = 0; c < size; ++c)
    for (auto k = column_start[c]; k < column_start[c + 1]; ++k) {
      y[row[k]] += value[k] * x[c];
      if (row[k] != c) y[c] += value[k] * x[row[k]];
    }
}

namespace {

/// The free unknowns coupled by each cell's matrix, sorted.
struct CellUnknowns {
  std::vector<std::int64_t> start{0};
  std::vector<int> unknown;
};

CellUnknowns collect_cell_unknowns(const dealii::DoFHandler<3>& dofs,
                                   const FreeUnknowns& unknowns) {
  CellUnknowns cells;
  std::vector<dealii::types::global_dof_index> indices(dofs.get_fe().dofs_per_cell);
  std::vector<int> reached;
  std::size_t number = 0;
  for (const auto& cell : dofs.active_cell_iterators()) {
    reached.clear();
    if (unknowns.takes(number++)) {
      cell->get_dof_indices(indices);
      for (const auto dof : indices)
        for (auto k = unknowns.row_start[dof]; k < unknowns.row_start[dof + 1]; ++k)
          reached.push_back(unknowns.column[k]);
    }
    std::sort(reached.begin(), reached.end());
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    cells.unknown.insert(cells.unknown.end(), reached.begin(), reached.end());
    cells.start.push_back(static_cast<std::int64_t>(cells.unknown.size()));
  }
  return cells;
}

/// The cells that contain each of the unknowns.
struct CellsOfUnknowns {
  std::vector<std::int64_t> start;
  std::vector<int> cell;

  CellsOfUnknowns(int size, const CellUnknowns& cells)
      : start(size + 1, 0), cell(cells.unknown.size()) {
    for (const int unknown : cells.unknown) ++start[unknown + 1];
    for (int c = 0; c < size; ++c) start[c + 1] += start[c];
    std::vector<std::int64_t> next(start.begin(), start.end() - 1);
    for (std::size_t k = 0; k + 1 < cells.start.size(); ++k)
      for (auto n = cells.start[k]; n < cells.start[k + 1]; ++n)
        cell[next[cells.unknown[n]]++] = static_cast<int>(k);
  }
  bool same(int a, int b) const {
    return std::equal(cell.begin() + start[a], cell.begin() + start[a + 1], cell.begin() + start[b],
                      cell.begin() + start[b + 1]);
  }
};

/// Pattern of the lower triangle: column c couples to every unknown of the cells that contain c.
SymmetricMatrix make_pattern(int size, const CellUnknowns& cells) {
  const CellsOfUnknowns holding(size, cells);
  SymmetricMatrix matrix;
  matrix.size = size;
  matrix.column_start.reserve(size + 1);
  matrix.column_start.push_back(0);
  std::vector<int> seen_by(size, -1);
  for (int c = 0; c < size; ++c) {
    for (auto n = holding.start[c]; n < holding.start[c + 1]; ++n) {
      const auto begin = cells.unknown.begin() + cells.start[holding.cell[n]];
      const auto end = cells.unknown.begin() + cells.start[holding.cell[n] + 1];
      for (auto it = std::lower_bound(begin, end, c); it != end; ++it)
        if (seen_by[*it] != c) {
          seen_by[*it] = c;
          matrix.row.push_back(*it);
        }
    }
    std::sort(matrix.row.begin() + matrix.column_start[c], matrix.row.end());
    matrix.column_start.push_back(static_cast<std::int64_t>(matrix.row.size()));
  }
  matrix.value.assign(matrix.row.size(), 0.0);
  return matrix;
}

/// A matrix C^T K C under assembly.
class Assembly {
 public:
  Assembly(const ElasticProblem& problem, const FreeUnknowns& unknowns)
      : unknowns_(unknowns),
        cells_(collect_cell_unknowns(problem.dofs, unknowns)),
        matrix_(make_pattern(unknowns.count, cells_)) {}
  bool takes(std::size_t cell) const { return cells_.start[cell + 1] > cells_.start[cell]; }

  /// Rows, then columns of K are distributed to the free unknowns of the cell. Both row lists of
  /// the lower triangle are sorted, so that one pass down the column finds every entry.
  void add(std::size_t cell, const std::vector<dealii::types::global_dof_index>& indices,
           const std::vector<double>& stiffness) {
    const auto count = static_cast<std::size_t>(cells_.start[cell + 1] - cells_.start[cell]);
    const int* const reached = &cells_.unknown[cells_.start[cell]];
    const std::size_t n = indices.size();
    spread_.clear();
    for (std::size_t i = 0; i < n; ++i)
      for (auto k = unknowns_.row_start[indices[i]]; k < unknowns_.row_start[indices[i] + 1]; ++k) {
        const int* const place = std::lower_bound(reached, reached + count, unknowns_.column[k]);
        spread_.push_back({i, static_cast<std::size_t>(place - reached), unknowns_.weight[k]});
      }
    half_.assign(count * n, 0.0);
    for (const auto& entry : spread_)
      for (std::size_t j = 0; j < n; ++j)
        half_[entry.to * n + j] += entry.weight * stiffness[entry.from * n + j];
    for (std::size_t c = 0; c < count; ++c) {
      column_.assign(count, 0.0);
      for (const auto& entry : spread_)
        column_[entry.to] += entry.weight * half_[c * n + entry.from];
      auto place = matrix_.column_start[reached[c]];
      for (std::size_t r = c; r < count; ++r) {
        while (matrix_.row[place] < reached[r]) ++place;
        matrix_.value[place] += column_[r];
      }
    }
  }
  SymmetricMatrix take() { return std::move(matrix_); }

 private:
  struct Entry {
    std::size_t from;
    std::size_t to;
    double weight;
  };
  const FreeUnknowns& unknowns_;
  CellUnknowns cells_;
  SymmetricMatrix matrix_;
  std::vector<Entry> spread_;
  std::vector<double> half_, column_;
};

}  // namespace

void order_for_elimination(const dealii::DoFHandler<3>& dofs, FreeUnknowns& unknowns) {
  const auto cells = collect_cell_unknowns(dofs, unknowns);
  const CellsOfUnknowns holding(unknowns.count, cells);
  // The components of a node are consecutive and in the same cells.
  Nodes nodes;
  for (int c = 0; c < unknowns.count; ++c) nodes.add(c > 0 && holding.same(c, c - 1));
  const NodeGraph graph(nodes, [&](int c, const auto& reach) {
    for (auto n = holding.start[c]; n < holding.start[c + 1]; ++n)
      std::for_each(cells.unknown.begin() + cells.start[holding.cell[n]],
                    cells.unknown.begin() + cells.start[holding.cell[n] + 1], reach);
  });
  const std::vector<int> order = nodes.unknowns(order_of_elimination(graph));
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
  for (int& column : unknowns.column) column = number[column];
}

std::vector<SymmetricMatrix> assemble(const ElasticProblem& problem,
                                      const std::vector<const FreeUnknowns*>& unknowns) {
  std::vector<Assembly> parts;
  parts.reserve(unknowns.size());
  for (const FreeUnknowns* of_part : unknowns) parts.emplace_back(problem, *of_part);
  CellStiffness cell_stiffness(problem);
  std::vector<dealii::types::global_dof_index> indices(problem.dofs.get_fe().dofs_per_cell);
  std::size_t number = 0;
  for (const auto& cell : problem.dofs.active_cell_iterators()) {
    const std::vector<double>* stiffness = nullptr;
    for (Assembly& part : parts) {
      if (!part.takes(number)) continue;
      if (stiffness == nullptr) {
        cell->get_dof_indices(indices);
        stiffness = &cell_stiffness.compute(cell);
      }
      part.add(number, indices, *stiffness);
    }
    ++number;
  }
  std::vector<SymmetricMatrix> matrices;
  matrices.reserve(parts.size());
  for (Assembly& part : parts) matrices.push_back(part.take());
  return matrices;
}

}  // namespace rollfem::fem
