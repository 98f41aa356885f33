// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/adhesion_fronts.hpp"

#include <algorithm>
#include <utility>

namespace rollfem::contact {

void AdhesionFronts::begin(const ContactGrid& grid, const std::vector<Eigen::Index>& elements) {
  grid_ = grid;
  place_.assign(static_cast<std::size_t>(grid.size()), -1);
  forget();
  int place = 0;
  for (const Eigen::Index k : elements) place_[static_cast<std::size_t>(k)] = place++;
}

AdhesionFronts::State AdhesionFronts::at(const std::vector<State>& states, int i, int j) const {
  const bool inside = i >= 0 && i < grid_.nx && j >= 0 && j < grid_.ny;
  return inside ? states[static_cast<std::size_t>(grid_.index(i, j))] : State::exterior;
}

bool AdhesionFronts::extend(std::vector<char>& adheres) {
  now_.assign(place_.size(), State::exterior);
  for (std::size_t k = 0; k < place_.size(); ++k)
    if (place_[k] >= 0)
      now_[k] = adheres[static_cast<std::size_t>(place_[k])] ? State::adhesion : State::slip;
  if (before_.empty())
    moves_.assign(static_cast<std::size_t>(grid_.ny), 0);
  else
    for (int j = 0; j < grid_.ny; ++j) {
      int& moves = moves_[static_cast<std::size_t>(j)];
      moves = extend_row(j, adheres) ? moves + 1 : 0;
    }
  std::swap(before_, now_);
  bool extended = false;
  for (std::size_t k = 0; k < place_.size(); ++k)
    if (before_[k] == State::slip && adheres[static_cast<std::size_t>(place_[k])]) {
      before_[k] = State::adhesion;
      extended = true;
    }
  return extended;
}

/// Whether a border has moved.
bool AdhesionFronts::extend_row(int j, std::vector<char>& adheres) {
  constexpr int most_doublings = 8;
  const int moves = std::min(moves_[static_cast<std::size_t>(j)], most_doublings);
  const int further = (1 << moves) - 1;
  bool moved = false;
  for (int i = grid_.nx - 2; i > 0; --i) {
    const bool is_moved_border =
        at(now_, i, j) == State::adhesion && at(before_, i, j) == State::slip &&
        at(now_, i + 1, j) == State::adhesion && at(now_, i - 1, j) == State::slip;
    if (!is_moved_border) continue;
    moved = true;
    for (int d = 1; at(now_, i - d, j) == State::slip; ++d) {
      const bool enclosed =
          at(now_, i - d, j - 1) == State::adhesion && at(now_, i - d, j + 1) == State::adhesion;
      if (d > further && !enclosed) break;
      adheres[static_cast<std::size_t>(place_[static_cast<std::size_t>(grid_.index(i - d, j))])] =
          1;
    }
  }
  return moved;
}

}  // namespace rollfem::contact
