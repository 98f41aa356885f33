#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>
#include <cmath>

namespace rollfem::convert {

namespace {

const char* friction_words(int L) {
  if (L == 2) return "friction falling linearly with slip velocity";
  if (L == 3) return "friction falling with slip velocity by a rational formula";
  if (L == 4) return "friction falling exponentially with slip velocity";
  return "temperature-dependent friction";
}

const char* material_words(int M) {
  if (M == 1) return "viscoelastic bodies";
  if (M == 2) return "the simplified theory with a user-defined flexibility";
  if (M == 4) return "an elasto-plastic interface layer";
  return "FaStrip";
}

const char* bound_words(int B) {
  if (B == 1) return "a thin sheet instead of the half-space";
  if (B == 3) return "a parabolic traction bound with the full theory";
  if (B == 4) return "normal contact by SDEC";
  return B == 5 ? "normal contact by KPEC" : "normal contact by ANALYN";
}

class Judgement {
 public:
  Judgement(const ContactCase& given, Equivalent& made)
      : given_(given), digits_(given.digits), made_(made) {}

  void friction() {
    if (digits_.T == 0) return;
    if (digits_.V != 0) refuse("V", digits_.V, "friction that varies with position");
    if (given_.friction_law != 0)
      refuse("L", given_.friction_law, friction_words(given_.friction_law));
    else if (std::abs(given_.fstat - given_.fkin) > 1e-3 * given_.fstat)
      made_.impossible.push_back(fmt::format(
          "FSTAT = {:g} and FKIN = {:g} differ: rollfem has one coefficient for adhesion and slip",
          given_.fstat, given_.fkin));
  }

  void bodies() {
    const int M = digits_.M, B = digits_.B;
    if (M != 0 && M != 3) refuse("M", M, material_words(M));
    if (M == 3) fastsim();
    if (M == 0 && B != 0 && B != 2) refuse("B", B, bound_words(B));
    if (M == 0 && B == 2 && digits_.N == 0)
      made_.impossible.push_back("digits B = 2 and N = 0: Hertz's pressure needs the normal force");
    if (digits_.M2 != 0) refuse("M2", digits_.M2, "material damping");
    const int C = given_.bodies.influence;
    if (C == 4)
      refuse("C", C,
             "influence coefficients for conformal contact (for profiles see halfspace.surface)");
    if (C == 9) refuse("C", C, "influence coefficients read from a file");
  }

  void problem() {
    if (digits_.T > 3) refuse("T", digits_.T, "an unknown kind of problem");
    if (digits_.F > 2) refuse("F", digits_.F, "a rail on springs");
    if (given_.module == 3 && digits_.E != 0)
      refuse("E", digits_.E,
             "extra rigid slip given per element (write a file for rolling.extra_slip_file)");
    if (given_.module == 1 && (digits_.T == 1 || digits_.T == 2))
      refuse("T", digits_.T, "shifts and transient rolling of wheel and rail profiles");
  }

 private:
  void refuse(const char* digit, int value, const char* what) {
    made_.impossible.push_back(fmt::format("digit {} = {}: {}", digit, value, what));
  }

  void fastsim() {
    if (given_.module == 1) return refuse("M", 3, "FASTSIM on the patches of profiles");
    if (digits_.T != 3) refuse("M", 3, "FASTSIM for anything but steady rolling");
    if (digits_.B != 2 && digits_.B != 3)
      made_.impossible.push_back(fmt::format(
          "digits M = 3, B = {}: FASTSIM with a pressure other than Hertz's", digits_.B));
    const auto& k = given_.bodies.slope_reduction;
    if (std::any_of(k.begin(), k.end(), [](double factor) { return factor != 1.0; }))
      made_.impossible.push_back(fmt::format(
          "K0_MF, ALFAMF, BETAMF = {:g}, {:g}, {:g}: a reduced initial slope of the creep curve",
          k[0], k[1], k[2]));
    if (digits_.F != 0) refuse("F", digits_.F, "prescribed forces in FASTSIM");
  }

  const ContactCase& given_;
  const Digits& digits_;
  Equivalent& made_;
};

}  // namespace

void judge_digits(const ContactCase& given, Equivalent& made) {
  Judgement judge(given, made);
  judge.friction();
  judge.bodies();
  judge.problem();
}

void note_settings(const ContactCase& given, Equivalent& made) {
  const Digits& digits = given.digits;
  const auto note = [&](const std::string& text) { made.notes.push_back(text); };
  note(
      "digits G, I, A, O, W and MAXGS to EPS are ignored: the solvers need no settings, and all "
      "fields are in results.h5");
  if (digits.S > 0 && (given.module == 1 || digits.M != 0))
    note(
        "stresses below the surface (digit S) are not converted: rollfem stress computes them "
        "after the run");
  if (digits.H > 0) note("temperatures (digit H) are not calculated");
  if (digits.R >= 2) note(fmt::format("digit R = {}: CONTACT would not run this case", digits.R));
  if (digits.V != 0 && digits.T == 0) note("digit V has no effect without friction");
  if (given.bodies.influence == 3)
    note("digit C = 3: tractions are constant in each element here, not linear");
  if (digits.M == 3)
    note(
        "FASTSIM uses Kalker's three flexibilities at all creepages; CONTACT blends them into one "
        "as creepages grow");
  if (digits.M == 0 && (digits.T == 2 || digits.T == 3))
    note(
        "upwind_order = \"first\" is CONTACT's scheme and gives its numbers on its elements; "
        "delete the line for the more accurate second-order scheme");
  if (given.module == 3 && given.rolling[3] != 1.0 / 6.0 && digits.T >= 2 &&
      given.kinematics[3] != 0.0)
    note(fmt::format("FACPHI = {:g}: the spin is taken at x + dq/6 here", given.rolling[3]));
  const auto& nu = given.bodies.poisson;
  const auto& g = given.bodies.shear_modulus;
  if (given.max_outer == 1 && (nu[0] != nu[1] || g[0] != g[1]) && digits.T != 0)
    note(
        "MAXOUT = 1: CONTACT stops after one pass over pressure and friction, which are coupled "
        "for unlike materials; here both are solved together");
}

}  // namespace rollfem::convert
