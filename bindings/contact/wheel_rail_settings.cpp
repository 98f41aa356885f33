// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that set wheel, rail and track of module 1.
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "bindings/contact/rows.hpp"

#include <fmt/format.h>

#include "convert/contact_reader.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace rollfem::addon {

namespace {

using convert::WheelRail;

/// GAUGHT, GAUGSQ or RAILY0, GAUGWD or RAILZ0, CANT and, on rollers, NOMRAD.
void set_dimensions(const Values& given, Problem& problem) {
  const bool by_gauge = !given.empty() && given[0] > 0.0;
  std::vector<int> powers{1, by_gauge ? 0 : 1, 1, 0};
  if (problem.given.digits.config >= 4) powers.push_back(1);
  const Values v = taken(problem.units, given, powers);
  problem.given.wheel_rail.track = {v[0], v[1], v[2], v.back()};
  if (given.size() > 5 && given[5] != 0.0) throw Refusal(err_other, "CURV: a curved track");
}

void set_track(int digit, const Values& given, Problem& problem) {
  WheelRail& pair = problem.given.wheel_rail;
  if (digit == 32 || digit == 33) {
    pair.springs = taken(problem.units, given, {-1, 0, -1, 0});
    problem.given.digits.F = 3;
    return;
  }
  if (digit < 0 || digit > 3)
    throw Refusal(err_other, fmt::format("ZTRACK = {}: allowed: 0 to 3, 32, 33", digit));
  // Older clients leave out NOMRAD and CURV, or CURV alone.
  const std::size_t deviations = digit < 2    ? 0
                                 : digit == 2 ? given.size()
                                              : std::min<std::size_t>(6, given.size());
  const auto middle = given.end() - static_cast<std::ptrdiff_t>(deviations);
  if (digit == 1 || digit == 3) set_dimensions(Values(given.begin(), middle), problem);
  if (digit >= 2)
    pair.rail_deviations = taken(problem.units, Values(middle, given.end()), {1, 1, 0, 1, 1, 0});
}

/// The first values of an array.
template <std::size_t n>
void take(const Values& given, const std::vector<int>& powers, const Problem& problem,
          std::array<double, n>& to) {
  const Values v = taken(problem.units, given, powers);
  std::copy(v.begin(), v.end(), to.begin());
}

void set_wheelset(int digit, const Values& given, Problem& problem) {
  if (digit == 3 || digit == 5) take(given, {1, 1, 1}, problem, problem.given.wheel_rail.wheelset);
}

void set_position(int digit, const Values& given, Problem& problem) {
  if (digit > 0) take(given, {1, 1, 1, 0, 0, 0}, problem, problem.given.wheel_rail.position);
}

/// The last is VPITCH, or FX or MY where F = 1 or 2.
void set_velocity(int digit, const Values& given, Problem& problem) {
  const auto& [config, F] = std::pair(problem.given.digits.config, problem.given.digits.F);
  if (digit > 1)
    take(given, {config >= 4 ? 0 : 1, 1, 1, 0, 0, F == 2 ? 1 : 0}, problem,
         problem.given.wheel_rail.velocity);
}

void set_flexibility(int digit, const Values& given, Problem& problem) {
  std::vector<double>& wheel = problem.given.wheel_rail.wheel_deviations;
  wheel.clear();
  if (digit == 4 || digit == 5)
    wheel = taken(problem.units, given, {1, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0});
}

/// Whether the parameters or the ending of the file say that this is a wheel.
bool is_wheel(Int iparam, int nints, const std::string& name) {
  if (nints > 0 && (iparam[0] == 0 || iparam[0] == 1)) return iparam[0] == 1;
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* wheel : {".prw", ".whl", ".slcw"})
    if (ending == wheel) return true;
  for (const char* rail : {".prr", ".ban", ".slcs"})
    if (ending == rail) return false;
  throw Refusal(err_profil, name + ": neither ITYPE nor the ending tells wheel from rail");
}

/// `name_and_text`: one of them is empty.
void set_profile(const char* function, std::initializer_list<const void*> arguments, Int ire,
                 Int nints, Int iparam, Int nreals, Real rparam,
                 const std::function<std::pair<std::string, std::string>()>& name_and_text) {
  guarded(function, arguments, [&] {
    for_pair(*ire, [&](Problem& problem) {
      demand_arrays(nints, iparam, nreals, rparam);
      const auto [name, text] = name_and_text();
      const bool wheel = is_wheel(iparam, *nints, name);
      convert::ProfileFile profile;
      profile.name = Library::here().path_of(name.empty() ? "values.txt" : name);
      if (*nints > 2) profile.mirror_y = iparam[2];
      if (*nints > 3) profile.mirror_z = iparam[3];
      profile.scale = *nreals > 0 && rparam[0] > 0.0 ? rparam[0] : problem.units.length;
      if (*nreals > 1) profile.smooth = rparam[1];
      WheelRail& pair = problem.given.wheel_rail;
      (wheel ? pair.wheel : pair.rail) = profile;
      problem.profile_text[wheel ? 1 : 0] = text;
    });
  });
}

/// The last case of an input file: it holds what the cases before have set.
void read_input(const std::string& file, Problem& problem) {
  constexpr std::size_t largest = 100'000'000;
  const std::vector<convert::ContactCase> cases =
      convert::read_contact_file(contact::text_of_file(file, file, largest), file);
  const convert::ContactCase& read = cases.back();
  if (read.module != problem.given.module)
    throw Refusal(err_input, fmt::format("{}: holds module {}, the result element is of module {}",
                                         file, read.module, problem.given.module));
  const bool steps = read.digits.T == 1 || read.digits.T == 2;
  if (steps && read.digits.P == 0 && cases.size() > 1)
    throw Refusal(err_input,
                  file + ": its last case continues the one before, which is not solved");
  problem.given = read;
  (read.digits.N == 1 ? problem.normal_force : problem.penetration) = read.kinematics[0];
  for (std::size_t k = 0; k < 2; ++k)
    (read.digits.F > static_cast<int>(k) ? problem.tangential[k] : problem.creepage[k]) =
        read.kinematics[1 + k];
  problem.creepage[2] = read.kinematics[3];
  if (read.module == 1) problem.normal_force = read.wheel_rail.position[2];
  problem.profile_text = {};
  problem.blocks.clear();
  const auto out = [&](const Values& mm) { return problem.units.out(mm, {1}); };
  for (const convert::StressBlock& block : read.stress_blocks)  // the numbers of elements, or mm
    problem.blocks[static_cast<int>(problem.blocks.size()) + 1] =
        block.by_element ? Block{7, {block.x, block.y, out(block.z)}}
                         : Block{9, {out(block.x), out(block.y), out(block.z)}};
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (convert::ProfileFile* profile :
       {&problem.given.wheel_rail.rail, &problem.given.wheel_rail.wheel})
    if (!profile->name.empty()) profile->name = (folder / profile->name).string();
}

}  // namespace

extern "C" {

void cntc_readinpfile(Int ire, Int inp_type, const char* fname, Int len_fname, int* ierror) {
  guarded("cntc_readinpfile", {ire, inp_type, fname, len_fname}, ierror, [&] {
    constexpr int of_module_1 = 1988;
    if (*inp_type != of_module_1 && *inp_type != 1 && *inp_type != 3)
      throw Refusal(err_input, fmt::format("there is no reader of inputs {}", *inp_type));
    const std::string file = Library::here().path_of(text_of(fname, *len_fname));
    const std::shared_ptr<Element> element = Library::here().at(*ire);
    try {
      for_problems(*ire, element->module == 1 ? -1 : 1,
                   [&](Problem& problem) { read_input(file, problem); });
    } catch (const contact::InputError& error) {
      throw Refusal(err_input, error.what());
    }
    return 0;
  });
}

ADDON_PAIR_VALUES(cntc_settrackdimensions, set_track)
ADDON_PAIR_VALUES(cntc_setwheelsetdimensions, set_wheelset)
ADDON_PAIR_VALUES(cntc_setwheelsetposition, set_position)
ADDON_PAIR_VALUES(cntc_setwheelsetvelocity, set_velocity)
ADDON_PAIR_VALUES(cntc_setwheelsetflexibility, set_flexibility)

void cntc_setverticalforce(Int ire, Real fz) {
  constexpr int one = 1;
  set_values("cntc_setverticalforce", ire, &of_pair, &one, &one, fz,
             [](int, const Values& v, Problem& p) { p.normal_force = v[0], p.given.digits.N = 1; });
}

void cntc_setprofileinputfname(Int ire, const char* fname, Int len_fname, Int nints, Int iparam,
                               Int nreals, Real rparam) {
  set_profile("cntc_setprofileinputfname", {ire, fname, len_fname, nints, nreals}, ire, nints,
              iparam, nreals, rparam, [&] { return std::pair(text_of(fname, *len_fname), ""); });
}

void cntc_setprofileinputvalues(Int ire, Int npoint, Real values, Int nints, Int iparam, Int nreals,
                                Real rparam) {
  set_profile("cntc_setprofileinputvalues", {ire, npoint, values, nints, nreals}, ire, nints,
              iparam, nreals, rparam, [&] {
                if (*npoint < 3 || *npoint > 1'000'000)
                  throw Refusal(err_profil, "NPOINT: allowed: 3 to 1000000");
                std::string text;
                for (int k = 0; k < *npoint; ++k)
                  text += fmt::format("{:.17g} {:.17g}\n", values[2 * k], values[2 * k + 1]);
                return std::pair(std::string(), text);
              });
}

}  // extern "C"

}  // namespace rollfem::addon
