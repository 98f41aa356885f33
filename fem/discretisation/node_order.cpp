// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/node_order.hpp"

#include "base/errors.hpp"

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

namespace rollfem::fem {

namespace {

/// Nested dissection only: also trying AMD costs seconds and was never better in 3D.
std::vector<int> dissected(NodeGraph& graph) {
  cholmod_sparse view{};
  view.nrow = view.ncol = graph.start.size() - 1;
  view.nzmax = graph.row.size();
  view.p = graph.start.data();
  view.i = graph.row.data();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 0;
  view.packed = 1;
  cholmod_common common{};
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SIMPLICIAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  common.postorder = 1;
  std::vector<int> order(view.ncol), parents(view.ncol), members(view.ncol);
  const bool done = cholmod_nested_dissection(&view, nullptr, 0, order.data(), parents.data(),
                                              members.data(), &common) >= 0;
  cholmod_factor* analysis =
      done ? cholmod_analyze_p(&view, order.data(), nullptr, 0, &common) : nullptr;
  if (analysis != nullptr) std::copy_n(static_cast<int*>(analysis->Perm), view.ncol, order.begin());
  const bool found = analysis != nullptr;
  cholmod_free_factor(&analysis, &common);
  cholmod_finish(&common);
  if (!found)
    throw contact::SolveError(
        "ordering the unknowns of a factorisation failed: memory ran out; do: use a coarser "
        "fem.cell_size");
  return order;
}

}  // namespace

std::vector<int> Nodes::unknowns(const std::vector<int>& sequence) const {
  std::vector<int> result;
  result.reserve(of.size());
  for (const int node : sequence)
    for (int k = first[node]; k < first[node + 1]; ++k) result.push_back(k);
  return result;
}

std::vector<int> order_of_elimination(const NodeGraph& graph) {
  // METIS uses the random sequence of the process: two simultaneous orderings would differ from run
  // to run, and with them the last digits of every result.
  static std::mutex one_at_a_time;
  static std::deque<std::pair<NodeGraph, std::vector<int>>> known;
  constexpr std::size_t most_known = 2;  // wheel and rail are factorised side by side
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  for (const auto& [other, order] : known)
    if (other.start == graph.start && other.row == graph.row) return order;
  if (known.size() == most_known) known.pop_front();
  NodeGraph copy = graph;
  std::vector<int> order = dissected(copy);
  known.emplace_back(std::move(copy), order);
  return order;
}

}  // namespace rollfem::fem
