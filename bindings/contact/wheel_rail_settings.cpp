// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that set wheel, rail and track of module 1.
#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"

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

using Values = std::vector<double>;
using convert::WheelRail;

void set_pair(const char* function, const int* ire, std::initializer_list<const void*> others,
              const std::function<void(Problem&)>& work) {
  guarded(function, {ire}, nullptr, [&] {
    if (std::find(others.begin(), others.end(), nullptr) != others.end())
      throw Refusal(err_other, "an argument is null");
    for_pair(*ire, work);
    return 0;
  });
}

/// The first values in mm: a power of length for each.
Values taken(const Units& units, const double* values, int count, const std::vector<int>& powers) {
  demand_values(count, static_cast<int>(powers.size()));
  if (values == nullptr) throw Refusal(err_other, "an argument is null");
  Values made;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    if (!std::isfinite(values[k])) throw Refusal(err_other, "a value is not finite");
    made.push_back(units.in(values[k], powers[k]));
  }
  return made;
}

/// GAUGHT, GAUGSQ or RAILY0, GAUGWD or RAILZ0, CANT and, on rollers, NOMRAD.
void set_track(const double* params, int count, Problem& problem) {
  const Units& units = problem.units;
  const bool roller = problem.given.digits.config >= 4;
  const Values v = roller ? taken(units, params, count, {1, 0, 1, 0, 1})
                          : taken(units, params, count, {1, 0, 1, 0});
  const bool by_gauge = v[0] > 0.0;
  problem.given.wheel_rail.track = {v[0], by_gauge ? v[1] : units.in(params[1]), v[2],
                                    roller ? v[4] : v[3]};
  if (count > 5 && params[5] != 0.0) throw Refusal(err_other, "CURV: a curved track");
}

/// Whether the parameters or the ending of the file say that this is a wheel.
bool is_wheel(const int* iparam, int nints, const std::string& name) {
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

void set_profile(const std::string& name, const std::string& text, bool wheel, const int* iparam,
                 int nints, const double* rparam, int nreals, Problem& problem) {
  convert::ProfileFile profile;
  profile.name = name;
  if (nints > 2) profile.mirror_y = iparam[2];
  if (nints > 3) profile.mirror_z = iparam[3];
  profile.scale = nreals > 0 && rparam[0] > 0.0 ? rparam[0] : problem.units.length;
  if (nreals > 1) profile.smooth = rparam[1];
  WheelRail& pair = problem.given.wheel_rail;
  (wheel ? pair.wheel : pair.rail) = profile;
  problem.profile_text[wheel ? 1 : 0] = text;
}

void demand_arrays(const int* nints, const int* iparam, const int* nreals, const double* rparam) {
  if ((*nints > 0 && iparam == nullptr) || (*nreals > 0 && rparam == nullptr))
    throw Refusal(err_other, "an argument is null");
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
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (convert::ProfileFile* profile :
       {&problem.given.wheel_rail.rail, &problem.given.wheel_rail.wheel})
    if (!profile->name.empty()) profile->name = (folder / profile->name).string();
}

}  // namespace

extern "C" {

void cntc_readinpfile(const int* ire, const int* inp_type, const char* fname, const int* len_fname,
                      int* ierror) {
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

void cntc_setverticalforce(const int* ire, const double* fz) {
  set_pair("cntc_setverticalforce", ire, {fz}, [&](Problem& problem) {
    problem.normal_force = *fz;
    problem.given.digits.N = 1;
  });
}

void cntc_setprofileinputfname(const int* ire, const char* fname, const int* len_fname,
                               const int* nints, const int* iparam, const int* nreals,
                               const double* rparam) {
  set_pair("cntc_setprofileinputfname", ire, {fname, len_fname, nints, nreals},
           [&](Problem& problem) {
             demand_arrays(nints, iparam, nreals, rparam);
             const std::string name = text_of(fname, *len_fname);
             set_profile(Library::here().path_of(name), "", is_wheel(iparam, *nints, name), iparam,
                         *nints, rparam, *nreals, problem);
           });
}

void cntc_setprofileinputvalues(const int* ire, const int* npoint, const double* values,
                                const int* nints, const int* iparam, const int* nreals,
                                const double* rparam) {
  set_pair("cntc_setprofileinputvalues", ire, {npoint, values, nints, nreals},
           [&](Problem& problem) {
             demand_arrays(nints, iparam, nreals, rparam);
             if (*npoint < 3 || *npoint > 1'000'000)
               throw Refusal(err_profil, "NPOINT: allowed: 3 to 1000000");
             std::string text;
             for (int k = 0; k < *npoint; ++k)
               text += fmt::format("{:.17g} {:.17g}\n", values[2 * k], values[2 * k + 1]);
             set_profile("values.txt", text, is_wheel(iparam, *nints, ""), iparam, *nints, rparam,
                         *nreals, problem);
           });
}

void cntc_settrackdimensions(const int* ire, const int* ztrack, const int* nparam,
                             const double* params) {
  set_pair("cntc_settrackdimensions", ire, {ztrack, nparam}, [&](Problem& problem) {
    WheelRail& pair = problem.given.wheel_rail;
    const std::vector<int> deviations{1, 1, 0, 1, 1, 0};
    if (*ztrack == 0) return;
    if (*ztrack == 32 || *ztrack == 33) {
      pair.springs = taken(problem.units, params, *nparam, {-1, 0, -1, 0});
      problem.given.digits.F = 3;
      return;
    }
    if (*ztrack < 0 || *ztrack > 3)
      throw Refusal(err_other, fmt::format("ZTRACK = {}: allowed: 0 to 3, 32, 33", *ztrack));
    // Older clients leave out NOMRAD and CURV, or CURV alone.
    const int dimensions = *ztrack == 3 ? *nparam - 6 : *nparam;
    if (*ztrack != 2) set_track(params, dimensions, problem);
    if (*ztrack == 2) pair.rail_deviations = taken(problem.units, params, *nparam, deviations);
    if (*ztrack == 3)
      pair.rail_deviations = taken(problem.units, params + dimensions, 6, deviations);
  });
}

void cntc_setwheelsetdimensions(const int* ire, const int* ewheel, const int* nparam,
                                const double* params) {
  set_pair("cntc_setwheelsetdimensions", ire, {ewheel, nparam}, [&](Problem& problem) {
    if (*ewheel != 3 && *ewheel != 5) return;
    const Values v = taken(problem.units, params, *nparam, {1, 1, 1});
    std::copy(v.begin(), v.end(), problem.given.wheel_rail.wheelset.begin());
  });
}

void cntc_setwheelsetposition(const int* ire, const int* ewheel, const int* nparam,
                              const double* params) {
  set_pair("cntc_setwheelsetposition", ire, {ewheel, nparam}, [&](Problem& problem) {
    if (*ewheel <= 0) return;
    const Values v = taken(problem.units, params, *nparam, {1, 1, 1, 0, 0, 0});
    std::copy(v.begin(), v.end(), problem.given.wheel_rail.position.begin());
  });
}

void cntc_setwheelsetvelocity(const int* ire, const int* ewheel, const int* nparam,
                              const double* params) {
  set_pair("cntc_setwheelsetvelocity", ire, {ewheel, nparam}, [&](Problem& problem) {
    if (*ewheel <= 1) return;
    const bool roller = problem.given.digits.config >= 4;
    const Values v = taken(problem.units, params, *nparam, {roller ? 0 : 1, 1, 1, 0, 0, 0});
    std::copy(v.begin(), v.end(), problem.given.wheel_rail.velocity.begin());
  });
}

void cntc_setwheelsetflexibility(const int* ire, const int* ewheel, const int* nparam,
                                 const double* params) {
  set_pair("cntc_setwheelsetflexibility", ire, {ewheel, nparam}, [&](Problem& problem) {
    std::vector<double>& wheel = problem.given.wheel_rail.wheel_deviations;
    wheel.clear();
    if (*ewheel == 4 || *ewheel == 5)
      wheel = taken(problem.units, params, *nparam, {1, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0});
  });
}

}  // extern "C"

}  // namespace rollfem::addon
