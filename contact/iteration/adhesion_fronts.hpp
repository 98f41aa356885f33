// SPDX-License-Identifier: LGPL-2.1-or-later
// Accelerates Newton's method at the ends of adhesion zones. Where the border of a row is too far
// upstream, Newton's method moves it back by only one element a step, because with slipping
// tractions at their bounds only the first element has the wrong direction of slip. A few such rows
// then cost as many steps as the border has elements to move. This class watches the adhesion areas
// of successive steps and moves such borders further at once.
#pragma once

#include "base/grid.hpp"

#include <vector>

namespace rollfem::contact {

class AdhesionFronts {
 public:
  AdhesionFronts() = default;
  AdhesionFronts(const ContactGrid& grid, const std::vector<Eigen::Index>& elements) {
    begin(grid, elements);
  }

  /// Starts another problem in the existing memory. `elements`: grid indices of the contact
  /// elements, in the order of `adheres` below.
  void begin(const ContactGrid& grid, const std::vector<Eigen::Index>& elements);

  /// `adheres`: state of each contact element in the iterate. Behind an element that slipped at the
  /// last call and now adheres like the element ahead of it, slipping elements are set to adhesion:
  /// those between two adhering elements of the neighbouring rows, and 1, 3, 7, ... elements where
  /// the row's border has moved in this way at 2, 3, 4, ... successive calls. Nothing happens
  /// without such a change, so a solution stays unchanged. True when elements were set to adhesion.
  bool extend(std::vector<char>& adheres);

  /// Forgets earlier calls.
  void forget() { before_.clear(); }

 private:
  enum class State : char { exterior, slip, adhesion };

  State at(const std::vector<State>& states, int i, int j) const;
  bool extend_row(int j, std::vector<char>& adheres);

  ContactGrid grid_;
  std::vector<int> place_;  ///< index of a grid element among the contact elements, -1: none
  std::vector<State> before_, now_;
  std::vector<int> moves_;  ///< successive calls, for each row
};

}  // namespace rollfem::contact
