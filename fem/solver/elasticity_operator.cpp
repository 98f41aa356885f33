#include "fem/solver/elasticity_operator.hpp"

#include "fem/solver/cell_terms.hpp"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::fem {

namespace {

/// Reorders data of the chosen cells from [cell][item] into [batch][item][lane]; absent lanes hold
/// zero.
template <typename Number, typename Out, typename In>
dealii::AlignedVector<Out> pack(const std::vector<In>& data, std::size_t items,
                                const std::vector<std::size_t>& chosen) {
  constexpr std::size_t width = lanes<Number>;
  if (data.empty()) return {};
  const std::size_t batches = (chosen.size() + width - 1) / width;
  dealii::AlignedVector<Out> packed(batches * items * width, Out(0));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    for (std::size_t item = 0; item < items; ++item)
      packed[((k / width) * items + item) * width + k % width] =
          static_cast<Out>(data[chosen[k] * items + item]);
  return packed;
}

/// Mean of sqrt(det J) d xi / d x over the points of every cell, and which cells have it
/// everywhere, up to a part of it.
struct StraightCells {
  std::vector<double> matrix;  ///< [cell][e][d]
  std::vector<std::size_t> straight, bent;

  StraightCells(const LocalCells& cells, double tolerance) {
    const bool plain = tolerance > 0 && cells.flow.empty() && cells.dilatation.empty();
    const std::vector<double> roots = root_weights(cells.degree);
    if (plain) matrix.resize(9 * cells.count);
    for (std::size_t cell = 0; cell < cells.count; ++cell) {
      const double* const geometry = cells.geometry.data() + cell * roots.size() * 9;
      const bool same = plain && is_straight(geometry, roots, tolerance, &matrix[9 * cell]);
      (same ? straight : bent).push_back(cell);
    }
  }

 private:
  static std::vector<double> root_weights(int degree) {
    const dealii::QGauss<3> quadrature(static_cast<unsigned int>(degree) + 1);
    std::vector<double> roots;
    for (const double weight : quadrature.get_weights()) roots.push_back(std::sqrt(weight));
    return roots;
  }
  static bool is_straight(const double* geometry, const std::vector<double>& roots,
                          double tolerance, double* mean) {
    double size = 0.0, largest = 0.0;
    for (int i = 0; i < 9; ++i) {
      mean[i] = 0.0;
      for (std::size_t q = 0; q < roots.size(); ++q) mean[i] += geometry[9 * q + i] / roots[q];
      mean[i] /= static_cast<double>(roots.size());
      size += mean[i] * mean[i];
    }
    for (std::size_t q = 0; q < roots.size(); ++q) {
      double change = 0.0;
      for (int i = 0; i < 9; ++i) change += std::pow(geometry[9 * q + i] / roots[q] - mean[i], 2);
      largest = std::max(largest, change);
    }
    return largest < tolerance * tolerance * size;
  }
};

/// u at constrained local dofs from their masters.
template <typename Number>
void expand(const LocalDofs& dofs, dealii::LinearAlgebra::distributed::Vector<Number>& u) {
  for (const auto& row : dofs.constrained) {
    double value = 0;
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k)
      value += dofs.terms[k].weight * u.local_element(dofs.terms[k].master);
    u.local_element(row.row) = static_cast<Number>(value);
  }
}

/// The transpose of expand() for the first `rows` of the constrained dofs.
template <typename Number>
void contract(const LocalDofs& dofs, std::size_t rows,
              dealii::LinearAlgebra::distributed::Vector<Number>& b) {
  for (std::size_t i = 0; i < rows; ++i) {
    const auto& row = dofs.constrained[i];
    const auto value = std::exchange(b.local_element(row.row), Number(0));
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k)
      b.local_element(dofs.terms[k].master) += static_cast<Number>(dofs.terms[k].weight * value);
  }
}

/// The unconstrained dofs that each dof of a cell stands for.
class CellConstraints {
 public:
  explicit CellConstraints(const LocalDofs& dofs) : dofs_(dofs) {
    const std::size_t local =
        dofs.with_ghosts->locally_owned_size() + dofs.with_ghosts->n_ghost_indices();
    position_.assign(local, -1);
    for (std::size_t i = 0; i < dofs.constrained.size(); ++i)
      position_[dofs.constrained[i].row] = static_cast<int>(i);
  }
  /// Calls f(master, weight) for one local dof.
  template <typename F>
  void for_each_master(unsigned int dof, const F& f) const {
    if (position_[dof] < 0) {
      f(dof, 1.0);
      return;
    }
    const ConstrainedRow& row = dofs_.constrained[position_[dof]];
    for (unsigned int k = row.first_term; k < row.end_of_terms; ++k)
      f(dofs_.terms[k].master, dofs_.terms[k].weight);
  }

 private:
  const LocalDofs& dofs_;
  std::vector<int> position_;
};

}  // namespace

template <typename Number>
ElasticityOperator<Number>::ElasticityOperator(const LocalCells& cells, double straightened)
    : dofs_(cells.dofs),
      kernel_(elasticity_kernel<Number>(cells.degree)),
      cell_dofs_(3 * (cells.degree + 1) * (cells.degree + 1) * (cells.degree + 1)),
      source_(cells.dofs->with_ghosts),
      result_(cells.dofs->with_ghosts) {
  material_.lambda = static_cast<Number>(lame_lambda(cells.material));
  material_.mu = static_cast<Number>(lame_mu(cells.material));
  const StraightCells shapes(cells, straightened);
  groups_.push_back(make_group(cells, shapes.straight, shapes.matrix));
  groups_.push_back(make_group(cells, shapes.bent, {}));
}

template <typename Number>
typename ElasticityOperator<Number>::Group ElasticityOperator<Number>::make_group(
    const LocalCells& cells, const std::vector<std::size_t>& chosen,
    const std::vector<double>& one_matrix) {
  const std::size_t items = cells.count == 0 ? 0 : cells.indices.size() / cells.count;
  const std::size_t points = items / 3;
  const auto functions = static_cast<std::size_t>(DilatationSpace::size_of_degree(cells.degree));
  Group group;
  group.cells = chosen.size();
  group.indices = pack<Number, unsigned int>(cells.indices, items, chosen);
  group.batches.parallelepipeds = !one_matrix.empty();
  group.geometry = group.batches.parallelepipeds
                       ? pack<Number, Number>(one_matrix, 9, chosen)
                       : pack<Number, Number>(cells.geometry, 9 * points, chosen);
  group.flow = pack<Number, Number>(cells.flow, 3 * points, chosen);
  group.dilatation = pack<Number, Number>(cells.dilatation, functions * points, chosen);
  group.batches.count = (group.cells + lanes<Number> - 1) / lanes<Number>;
  group.batches.indices = group.indices.data();
  group.batches.geometry = group.geometry.data();
  group.batches.flow = group.flow.empty() ? nullptr : group.flow.data();
  group.batches.dilatation = group.dilatation.empty() ? nullptr : group.dilatation.data();
  return group;
}

template <typename Number>
typename ElasticityOperator<Number>::VectorType ElasticityOperator<Number>::make_vector() const {
  return VectorType(dofs_->owned_only);
}

/// source_ = C x with its ghosts.
template <typename Number>
void ElasticityOperator<Number>::load(const VectorType& x) const {
  std::copy(x.begin(), x.end(), source_.begin());
  source_.update_ghost_values();
  expand(*dofs_, source_);
}

/// y = owned part of C^T result_, the first `rows` constrained dofs being this process's to move.
template <typename Number>
void ElasticityOperator<Number>::unload(VectorType& y, std::size_t rows) const {
  contract(*dofs_, rows, result_);
  result_.compress(dealii::VectorOperation::add);
  std::copy(result_.begin(), result_.end(), y.begin());
}

template <typename Number>
void ElasticityOperator<Number>::vmult(VectorType& product, const VectorType& x) const {
  load(x);
  result_ = Number(0);
  for (const Group& group : groups_)
    kernel_.add_product(group.batches, material_, source_.begin(), result_.begin());
  unload(product, dofs_->constrained.size());
  for (std::size_t i = 0; i < dofs_->owned_constrained; ++i) {
    const auto row = dofs_->constrained[i].row;
    product.local_element(row) = x.local_element(row);
  }
}

/// Calls f(masters, matrix) for every cell: the unconstrained dofs its dofs stand for, and
/// matrix(i, j), its element matrix.
template <typename Number>
template <typename F>
void ElasticityOperator<Number>::for_each_cell(const F& f) const {
  const CellConstraints constraints(*dofs_);
  constexpr std::size_t width = lanes<Number>;
  dealii::AlignedVector<Number> matrices(width * cell_dofs_ * cell_dofs_);
  std::vector<CellMaster> masters;
  for (const Group& group : groups_)
    for (std::size_t cell = 0; cell < group.cells; ++cell) {
      const std::size_t batch = cell / width, lane = cell % width;
      if (lane == 0) kernel_.element_matrices(group.batches, material_, batch, matrices.data());
      const unsigned int* index = group.indices.data() + batch * cell_dofs_ * width + lane;
      masters.clear();
      for (int i = 0; i < cell_dofs_; ++i)
        constraints.for_each_master(index[i * width], [&](unsigned int master, double weight) {
          masters.push_back({master, i, weight});
        });
      f(masters,
        [&](int i, int j) -> double { return matrices[(i * cell_dofs_ + j) * width + lane]; });
    }
}

template <typename Number>
typename ElasticityOperator<Number>::VectorType ElasticityOperator<Number>::inverse_diagonal()
    const {
  result_ = Number(0);
  for_each_cell([&](std::vector<CellMaster>& masters, const auto& matrix) {
    std::sort(masters.begin(), masters.end(),
              [](const auto& a, const auto& b) { return a.master < b.master; });
    for (auto first = masters.begin(); first != masters.end();) {
      const auto last = std::find_if(first, masters.end(),
                                     [&](const auto& m) { return m.master != first->master; });
      double sum = 0;
      for (auto a = first; a != last; ++a)
        for (auto b = first; b != last; ++b) sum += a->weight * b->weight * matrix(a->dof, b->dof);
      result_.local_element(first->master) += static_cast<Number>(sum);
      first = last;
    }
  });
  VectorType diagonal = make_vector();
  unload(diagonal, 0);
  for (std::size_t i = 0; i < dofs_->owned_constrained; ++i)
    diagonal.local_element(dofs_->constrained[i].row) = 1;
  for (auto& value : diagonal) value = 1 / value;
  return diagonal;
}

template <typename Number>
std::vector<MatrixEntry> ElasticityOperator<Number>::assemble() const {
  const auto& numbers = *dofs_->with_ghosts;
  const auto global = [&](unsigned int local) {
    return static_cast<unsigned int>(numbers.local_to_global(local));
  };
  std::vector<std::vector<MatrixEntry>> rows(numbers.locally_owned_size() +
                                             numbers.n_ghost_indices());
  for_each_cell([&](const std::vector<CellMaster>& masters, const auto& matrix) {
    for (const auto& a : masters)
      for (const auto& b : masters)
        if (global(b.master) <= global(a.master))
          rows[a.master].push_back(
              {global(a.master), global(b.master), a.weight * b.weight * matrix(a.dof, b.dof)});
  });
  for (std::size_t i = 0; i < dofs_->owned_constrained; ++i) {
    const auto row = dofs_->constrained[i].row;
    rows[row].push_back({global(row), global(row), 1.0});
  }
  std::vector<MatrixEntry> entries;
  for (auto& row : rows) {
    std::stable_sort(row.begin(), row.end(),
                     [](const auto& a, const auto& b) { return a.column < b.column; });
    for (std::size_t i = 0; i < row.size(); ++i)
      if (i > 0 && row[i].column == row[i - 1].column)
        entries.back().value += row[i].value;
      else
        entries.push_back(row[i]);
    std::vector<MatrixEntry>().swap(row);
  }
  return entries;
}

template <typename Number>
void ElasticityOperator<Number>::condense(VectorType& b) const {
  result_ = Number(0);
  std::copy(b.begin(), b.end(), result_.begin());
  // b is complete at its owner: ghosts hold nothing, only owned rows are to be moved.
  unload(b, dofs_->owned_constrained);
}

template <typename Number>
void ElasticityOperator<Number>::distribute(VectorType& u) const {
  load(u);
  std::copy(source_.begin(), source_.end(), u.begin());
}

template <typename Number>
double ElasticityOperator<Number>::memory_bytes() const {
  const auto rows = static_cast<double>(dofs_->constrained.size() * sizeof(ConstrainedRow) +
                                        dofs_->terms.size() * sizeof(ConstraintTerm));
  double packed = 0;
  for (const Group& group : groups_)
    packed += static_cast<double>(
        group.indices.memory_consumption() + group.geometry.memory_consumption() +
        group.flow.memory_consumption() + group.dilatation.memory_consumption());
  return packed + rows +
         static_cast<double>(source_.memory_consumption() + result_.memory_consumption());
}

template class ElasticityOperator<float>;
template class ElasticityOperator<double>;

}  // namespace rollfem::fem
