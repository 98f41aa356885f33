// SPDX-License-Identifier: LGPL-2.1-or-later
// From a case in CONTACT's words to solved patches, without text or files between. What the next
// call can use is kept: the case, the placed profiles, influence coefficients, the last solution.
#pragma once

#include "case/case.hpp"
#include "case/reading/case_reader.hpp"
#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/preconditioned_elasticity.hpp"
#include "halfspace/model/few_contact.hpp"
#include "track/balance/balance.hpp"
#include "track/history/wheel_history.hpp"

#include "convert/contact_case.hpp"
#include "convert/equivalent.hpp"
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rollfem::addon {

// The numbers by which CONTACT's clients name flags, units, fields and errors.
inline constexpr int if_units = 1933, un_cntc = 1934, un_spck = 1935, un_si = 1936;
inline constexpr int ic_config = 1967, ic_pvtime = 1970, ic_bound = 1971, ic_tang = 1972,
                     ic_norm = 1973, ic_force = 1974, ic_frclaw = 1976, ic_discns = 1977,
                     ic_inflcf = 1978, ic_mater = 1979, ic_exrhs = 1980, ic_heat = 1982,
                     ic_iestim = 1983, ic_output = 1984, ic_flow = 1985, ic_return = 1986,
                     ic_matfil = 1987, ic_sens = 1988, ic_npomax = 1993;
inline constexpr int if_idebug = 2000, if_openmp = 2003, if_ncase = 2005;
inline constexpr int fld_h = 1, fld_mu = 2, fld_px = 3, fld_py = 4, fld_pn = 5, fld_ux = 7,
                     fld_uy = 8, fld_un = 9, fld_taucrt = 11, fld_uplsx = 12, fld_uplsy = 13,
                     fld_sx = 15, fld_sy = 16, fld_temp1 = 20, fld_temp2 = 21, fld_wx = 22,
                     fld_wy = 23;
inline constexpr int err_norm = -27, err_icp = -31, err_profil = -32, err_frclaw = -33,
                     err_discr = -34, err_input = -39, err_other = -99;

/// What a client is refused, with the error code of the interface.
class Refusal : public std::runtime_error {
 public:
  Refusal(int code, const std::string& text) : std::runtime_error(text), code_(code) {}
  int code() const { return code_; }

 private:
  int code_;
};

/// Stresses of one block of points: x fastest, then y, then z; CONTACT's axes and signs.
struct BlockStresses {
  std::array<int, 3> count{};
  std::vector<std::array<double, 21>> rows;  ///< the columns of subs_getresults
};

/// A contact on the track: what its place, frames and the forces of the wheel follow from.
struct PlacedPatch {
  track::WheelRailContact contact;
  double sinking = 0.0;  ///< mm, of the wheel below first touch
  /// mm, of the wheelset under the load.
  double height() const { return contact.pose.height + sinking; }
  double circumferential = 1.0;    ///< speed of the wheel's surface over the forward speed
  track::RailVector rail_moved{};  ///< by its springs
};

struct Patch {
  contact::ContactGrid grid;  ///< of the solution: the potential contact area, or around it
  int first_column = 0, first_row = 0, nx = 0, ny = 0;  ///< that area
  std::shared_ptr<const contact::Scene> scene;
  contact::PointResult point;
  std::optional<PlacedPatch> placed;  ///< module 1
  /// CONTACT's axes against ours: signs of components on its body 1, and whether rows (columns) run
  /// the other way.
  double along = 1.0, across = 1.0;
  bool turns_columns = false, turns_rows = false;
  std::map<int, BlockStresses> stresses{};
  /// Along the surface, found when a client asks for it where the solution has none.
  mutable std::optional<contact::SurfaceField> displacement{};

  /// Index of ours of element (i, j) of CONTACT's, both from 0.
  int index(int i, int j) const {
    const int column = turns_columns ? nx - 1 - i : i, row = turns_rows ? ny - 1 - j : j;
    return grid.index(first_column + column, first_row + row);
  }
  int size() const { return nx * ny; }
  /// Middle of a column or row of CONTACT's, from 0, in its axes, mm.
  double x(double column) const {
    return turns_columns ? -grid.x(first_column) - (nx - 1 - column) * grid.dx
                         : grid.x(first_column) + column * grid.dx;
  }
  double y(double row) const {
    return turns_rows ? -grid.y(first_row) - (ny - 1 - row) * grid.dy
                      : grid.y(first_row) + row * grid.dy;
  }
};

/// Points y, z as lines of text, instead of the profile files of rail and wheel; or empty.
using ProfileTexts = std::array<std::string, 2>;

/// Added to the rigid slip of each element of a contact that rolls, over the rolling speed:
/// components in CONTACT's axes, by rows of its elements; empty: nothing.
using ElementSlip = std::array<std::vector<double>, 2>;
/// By the number of the patch; 1 in module 3.
using PatchSlips = std::map<int, ElementSlip>;

class Solver {
 public:
  /// Throws Refusal, contact::InputError and contact::SolveError.
  std::vector<Patch> solve(const convert::ContactCase& given, const ProfileTexts& texts,
                           const PatchSlips& extra);
  /// The profiles, read as the case says; as solve().
  const track::ProfilePair& profiles(const convert::ContactCase& given, const ProfileTexts& texts);

  const contact::Case& input() const { return input_; }
  const track::SearchScene& search() const { return placed_.search; }

 private:
  void set_case(convert::Equivalent made, const ProfileTexts& texts,
                const convert::Equivalent* start = nullptr);
  void read_profiles(const ProfileTexts& texts, bool goes_on);
  std::optional<convert::Equivalent> start_of(const convert::ContactCase& given,
                                              convert::Equivalent& made);
  Patch solve_single(const convert::ContactCase& given, const convert::Equivalent& made,
                     const PatchSlips& extra);
  std::vector<Patch> solve_pair(const PatchSlips& extra);
  std::vector<Patch> take_step(std::vector<contact::Scene> contacts, const PatchSlips& extra);
  Patch placed_patch(const contact::Scene& scene, contact::PointResult point,
                     const contact::ContactGrid& grid,
                     const std::vector<track::PlacedScene>& placed,
                     const track::RailVector& rail_moved) const;
  contact::LevelResult solve_on(const contact::Scene& scene, contact::ContactGrid& grid);
  void remember(const contact::Scene& scene, const contact::LevelResult& level);
  std::unique_ptr<contact::Elasticity> elasticity(const contact::Scene& scene,
                                                  const contact::ChartedGeometry& geometry,
                                                  const contact::ContactGrid& grid);

  std::optional<convert::Equivalent> made_;  ///< that input_ follows from
  contact::NamedValues values_;              ///< of it; empty: none
  contact::Case input_;
  std::string profile_keys_, search_keys_;  ///< by which profiles_ and placed_ were made
  track::ProfilePair profiles_;
  track::PlacedWheels placed_;
  std::optional<halfspace::Halfspaces> halfspaces_;
  std::optional<convert::Equivalent> before_;   ///< of the last call; none: not solved
  std::optional<contact::LevelResult> last_;    ///< of module 3
  std::optional<contact::History> history_;     ///< of its steps
  std::shared_ptr<track::WheelHistory> wheel_;  ///< of the steps of module 1; null: none
  double rotation_ = 0.0;                       ///< of the wheel (Wheelset::rotation_change)
  std::shared_ptr<halfspace::FewContact> few_;  ///< null: not yet needed
};

}  // namespace rollfem::addon
