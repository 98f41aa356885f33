// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/iteration/friction_state.hpp"

#include "contact/iteration/leading_edge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// exp(-t), (1 - exp(-t))/t and its derivative.
struct Decay {
  double left, mean, mean_by_t;
};

Decay decay(double t) {
  const double left = std::exp(-t);
  if (t < 1e-4) return {left, 1.0 - 0.5 * t, -0.5 + t / 3.0};
  const double mean = -std::expm1(-t) / t;
  return {left, mean, (left - mean) / t};
}

}  // namespace

PlasticDisplacement yielding(const Plasticity& layer, const YieldStep& step) {
  const double stress = layer.yield_stress + layer.hardening * step.before;
  if (step.friction <= stress) return {step.before};
  double part = 1.0, part_by_stress = 0.0;
  if (step.friction_ahead < stress) {
    const double rise =
        (step.friction - step.friction_ahead) * (step.friction + step.friction_ahead);
    part = (step.friction - stress) * (step.friction + stress) / rise;
    part_by_stress = -2.0 * stress / rise;
  }
  const double own = step.way * part * (1.0 - 0.5 * part);
  const double ahead = step.way * 0.5 * part * part;
  const double by_part = step.way * ((1.0 - part) * step.slip + part * step.slip_ahead);
  return {step.before + own * step.slip + ahead * step.slip_ahead, own, ahead,
          1.0 + by_part * part_by_stress * layer.hardening};
}

void FrictionState::begin(const ContactGrid& grid, const TangentialProblem& problem,
                          const std::vector<Index>& places, double r) {
  static const CoulombFriction none(0.0);
  grid_ = &grid;
  problem_ = &problem;
  law_ = problem.friction ? problem.friction.get() : &none;
  r_ = r;
  places_ = &places;
  count_ = static_cast<Index>(places.size());
  rows_.clear();
  if (law_->varies())
    for (int j = 0; j < grid.ny; ++j) rows_.push_back(law_->of_row(grid.y(j)));
  rest_.setConstant(count_, law_->coefficient());
  if (!rows_.empty())
    for (Index e = 0; e < count_; ++e) rest_[e] = law(e).coefficient();
  plasticity_ = law_->plasticity;
  if (!feels_slip()) return;
  memory_ = law_->memory();
  for (Eigen::VectorXd* values : {&coefficient_, &by_own_, &by_ahead_, &carried_})
    values->resize(count_);
  warming_.resize(0);
  if (const TemperatureFriction* by = law_->by_temperature()) {
    const SurfaceHeat& heat = by->heat();
    const double passed = problem.motion.past ? problem.motion.past->length / grid.dx : grid.nx;
    const int most = std::clamp(static_cast<int>(std::ceil(passed - 1e-9)), 1, grid.nx);
    warming_ = heat.speed / heat.effusivity() * heat.warming(grid.dx, most);
    for (Eigen::VectorXd* values :
         {&sizes_, &flow_, &by_temperature_, &part_, &part_ahead_, &flow_change_})
      values->resize(count_);
  }
  direction_.resize(2 * count_);
  yield_.assign(plasticity_ ? places.size() : 0, {});
  trial_direction_.resize(plasticity_ ? 2 * count_ : 0);
  if (memory_ || plasticity_) find_ways();
}

void FrictionState::find_ways() {
  const ContactGrid& grid = *grid_;
  ways_.resize(count_);
  leads_.assign(static_cast<std::size_t>(count_), 1);
  if (problem_->motion.past) {
    ways_.setConstant(problem_->motion.past->length);
    return;
  }
  const Field edges = leading_edges(grid, problem_->pressure);
  for (Index e = 0; e < count_; ++e) {
    const Index k = (*places_)[static_cast<std::size_t>(e)];
    const bool follows = e + 1 < count_ && (*places_)[static_cast<std::size_t>(e) + 1] == k + 1 &&
                         (k + 1) % grid.nx != 0;
    leads_[static_cast<std::size_t>(e)] = !follows;
    ways_[e] = follows ? grid.dx : std::max(0.0, 0.5 + edges[k]) * grid.dx;
  }
}

double FrictionState::slip_at(const Given& slip, Index e) const {
  return problem_->motion.slip_factor * std::hypot(slip[e], slip[count_ + e]);
}

double steepest_fall(const FrictionLaw& law, double way,
                     const std::optional<FrictionMemory>& memory) {
  constexpr double slowest = 1e-12, fastest = 1e3, ratio = 1.5;
  double largest = 0.0;
  for (double slip = slowest; slip < fastest; slip *= ratio) {
    double fall = -law.at(slip).by_slip;
    if (memory)
      fall *= 1.0 - decay(way * std::max(slip, memory->least_slip) / memory->distance).left;
    largest = std::max(largest, fall);
  }
  return largest;
}

double steepness(const FrictionLaw& law, double pressure, double compliance, double way) {
  return steepest_fall(law, way, law.memory()) * pressure * compliance;
}

namespace {

/// The memory distance, mm, with which the law is no longer steep.
double sufficient_memory(const FrictionLaw& law, double steepness, double way) {
  const double wanted = steep * steepest_fall(law, way, law.memory()) / steepness;
  const double least_slip = law.memory() ? law.memory()->least_slip : 0.0;
  double lower = 1e-9, upper = 1e3;
  while (upper > 1.01 * lower) {
    const double middle = std::sqrt(lower * upper);
    const bool enough = steepest_fall(law, way, FrictionMemory{middle, least_slip}) < wanted;
    (enough ? upper : lower) = middle;
  }
  return upper;
}

}  // namespace

SteepCause steep_cause(const FrictionLaw& law, double steepness, double way) {
  SteepCause reason{"friction falls so steeply with the slip velocity",
                    "give friction.memory_distance, or a larger one, or a larger half_velocity"};
  if (law.feels_slip() && way > 0.0 && steepness > steep)
    reason.cure = fmt::format(
        "give friction.memory_distance (one state from about {:.2g} mm), or a larger half_velocity",
        sufficient_memory(law, steepness, way));
  if (!law.plasticity || law.plasticity->hardening >= 0.0) return reason;
  const std::string cure = "give a layer.hardening nearer to 0";
  if (!law.feels_slip()) return {"the layer softens so fast", cure};
  return {"friction falls with the slip velocity and the layer softens so fast",
          cure + ", or " + reason.cure};
}

double FrictionState::steepness(double compliance) const {
  const bool steps = problem_->motion.past.has_value();
  const double way = steps ? problem_->motion.past->length : grid_->dx;
  double largest = 0.0;
  for (Index e = 0; e < count_; ++e)
    if (e == 0 || &law(e) != &law(e - 1))
      largest =
          std::max(largest, contact::steepness(law(e), problem_->pressure.maxCoeff(),
                                               problem_->motion.slip_factor * compliance, way));
  if (warming_.size() > 0) {
    const TemperatureFriction& by = *law_->by_temperature();
    const double p = problem_->pressure.maxCoeff(),
                 fall = by.cold().coefficient - by.hot().coefficient;
    largest =
        std::max(largest, fall / (by.hot().temperature - by.cold().temperature) * warming_.sum() *
                              p * p * by.largest() * problem_->motion.slip_factor * compliance);
  }
  if (!hardens()) return largest;
  // A layer that softens loses -k |w| h, in steady rolling half of it by the element's own slip.
  return std::max(largest, -plasticity_->hardening * (steps ? way : 0.5 * way) *
                               problem_->motion.slip_factor * compliance);
}

void FrictionState::set_rest(Vector bound) const {
  for (Index e = 0; e < count_; ++e) {
    const double friction = friction_at_rest(e);
    bound[e] = friction;
    if (!plasticity_) continue;
    const double before = problem_->motion.past ? plastic_before(e) : 0.0;
    bound[e] = std::min(friction, yield_stress(before, friction));
  }
}

void FrictionState::set_bound(const Given& slip, const Given& trial, Vector bound) {
  follow(slip, trial);
  for (Index e = 0; e < count_; ++e)
    bound[e] =
        yields(e) ? yield_[static_cast<std::size_t>(e)].stress : coefficient_[e] * pressure(e);
}

bool FrictionState::yields(Index e) const {
  if (!plasticity_) return false;
  if (feels_slip()) return yield_[static_cast<std::size_t>(e)].yields;
  return plasticity_->yield_stress < friction_at_rest(e);
}

double FrictionState::plastic_before(Index e) const {
  if (!hardens()) return 0.0;
  if (problem_->motion.past)
    return problem_->motion.past->plastic[(*places_)[static_cast<std::size_t>(e)]];
  return leads_[static_cast<std::size_t>(e)] ? 0.0 : plastic(e + 1);
}

double FrictionState::yield_stress(double plastic, double friction) const {
  constexpr double least = 1e-6;
  return std::max(least * friction, plasticity_->yield_stress + plasticity_->hardening * plastic);
}

void FrictionState::follow(const Given& slip, const Given& trial) {
  Ahead ahead;
  double size_ahead = 0.0;
  for (Index e = count_; e-- > 0;) {
    const double size = slip_at(slip, e);
    Ahead own = warming_.size() > 0 ? follow_temperature(e, size, ahead)
                                    : follow_friction(e, size, ahead, law(e).at(size));
    if (plasticity_) follow_yield(e, size, size_ahead, std::hypot(trial[e], trial[count_ + e]));
    if (yields(e)) {  // without slip
      own = follow_friction(e, 0.0, ahead, law(e).at(0.0));
      by_own_[e] = own.law.by_slip = 0.0;
    }
    ahead = own;
    size_ahead = size;
  }
}

/// With dt = h (r + r')/2, r the rate max(|w|, s_0)/d_c here and r' that of the element ahead, and
/// mu_s linear in t between both, dmu/dt = mu_s - mu has the solution
/// mu = e^-dt mu' + (1 - m) mu_s + (m - e^-dt) mu_s', m = (1 - e^-dt)/dt:
/// second order, a mean with positive weights however long the step, and mu_s for dt to infinity.
FrictionState::Ahead FrictionState::follow_friction(Index e, double size, const Ahead& ahead,
                                                    const FrictionLaw::Coefficient& own) {
  coefficient_[e] = own.value;
  by_own_[e] = own.by_slip;
  by_ahead_[e] = carried_[e] = 0.0;
  if (!memory_) return {own};
  const double rate = std::max(size, memory_->least_slip) / memory_->distance;
  const double rate_by_slip = size > memory_->least_slip ? 1.0 / memory_->distance : 0.0;
  if (leads_[static_cast<std::size_t>(e)]) {
    const Index k = (*places_)[static_cast<std::size_t>(e)];
    const double before = problem_->motion.past ? problem_->motion.past->coefficient[k] : rest_[e];
    const double left = std::exp(-ways_[e] * rate);
    coefficient_[e] = own.value + left * (before - own.value);
    by_own_[e] = (1.0 - left) * own.by_slip - left * (before - own.value) * ways_[e] * rate_by_slip;
  } else {
    const auto [left, mean, mean_by_t] = decay(0.5 * ways_[e] * (rate + ahead.rate));
    const double before = coefficient_[e + 1];
    coefficient_[e] = left * before + (1.0 - mean) * own.value + (mean - left) * ahead.law.value;
    const double by_t =
        left * (ahead.law.value - before) + mean_by_t * (ahead.law.value - own.value);
    by_own_[e] = (1.0 - mean) * own.by_slip + 0.5 * ways_[e] * rate_by_slip * by_t;
    by_ahead_[e] = (mean - left) * ahead.law.by_slip + 0.5 * ways_[e] * ahead.rate_by_slip * by_t;
    carried_[e] = left;
  }
  return {own, rate, rate_by_slip};
}

double FrictionState::cold(Index e) const {
  if (!problem_->motion.past) return law(e).by_temperature()->heat().contact_temperature();
  return problem_->motion.past->temperature[(*places_)[static_cast<std::size_t>(e)]];
}

double FrictionState::warmed(Index e, const Eigen::VectorXd& flows) const {
  const auto place = [&](Index f) { return (*places_)[static_cast<std::size_t>(f)]; };
  const Index own = place(e), row = own - own % grid_->nx,
              end = std::min(row + grid_->nx, own + warming_.size());
  double sum = 0.0;
  for (Index f = e + 1; f < count_ && place(f) < end; ++f)
    sum += warming_[place(f) - own] * flows[f];
  return sum;
}

/// The element's own heat g |w| warms it as well, with g = p_n (c_0 + c mu(T)) and mu linear in T
/// between two kinks: the lowest temperature at which both agree, to which it warms first.
FrictionState::Ahead FrictionState::follow_temperature(Index e, double size, const Ahead& ahead) {
  const TemperatureFriction& own = *law(e).by_temperature();
  const auto coefficient = [&](double mu) {
    follow_friction(e, size, ahead, {mu, 0.0});
    return coefficient_[e];
  };
  const double without = coefficient(0.0), part = coefficient(1.0) - without;
  const bool alone = !memory_ || leads_[static_cast<std::size_t>(e)];
  part_[e] = part;
  part_ahead_[e] = alone ? 0.0 : 1.0 - carried_[e] - part;
  const double before = cold(e) + warmed(e, flow_);
  const double by_bound = warming_[0] * size * pressure(e);
  const auto lacking = [&](double temperature) {
    return before + by_bound * (without + part * own.warm(temperature).value) - temperature;
  };
  double temperature = before;
  bool found = false;
  for (const double kink : {own.cold().temperature, own.hot().temperature}) {
    if (found || temperature >= kink) continue;
    const double here = lacking(temperature), there = lacking(kink);
    found = there <= 0.0;
    temperature = found ? temperature + (kink - temperature) * here / (here - there) : kink;
  }
  if (!found) temperature += lacking(temperature);
  const FrictionLaw::Coefficient law = own.warm(temperature);
  const Ahead made = follow_friction(e, size, ahead, {law.value, 0.0});
  by_temperature_[e] = law.by_slip;
  sizes_[e] = size;
  flow_[e] = coefficient_[e] * pressure(e) * size;
  return made;
}

/// Where friction is the lower bound, a layer that hardens has yielded until its stress reached
/// friction, and any other has not yielded on the way.
void FrictionState::follow_yield(Index e, double size, double size_ahead, double trial) {
  const Plasticity& layer = *plasticity_;
  const bool leads = leads_[static_cast<std::size_t>(e)];
  const double k = layer.hardening;
  YieldStep step{plastic_before(e),   ways_[e], size, leads ? size : size_ahead,
                 friction_at_rest(e), 0.0};
  if (problem_->motion.past)
    step.friction_ahead = step.friction;
  else if (!leads)
    step.friction_ahead = friction_at_rest(e + 1);
  Yield& own = yield_[static_cast<std::size_t>(e)];
  own.by_trial = 0.0;
  double upstream = 1.0;  // part of what comes from upstream that the own slip leaves
  if (k > 0.0 && r_ > 0.0) {
    step.slip = 0.0;
    if (leads) step.slip_ahead = 0.0;
    const PlasticDisplacement still = yielding(layer, step);
    const double by_slip = still.by_slip + (leads ? still.by_slip_ahead : 0.0);
    const double softness =
        problem_->motion.slip_factor / (r_ + k * by_slip * problem_->motion.slip_factor);
    const double excess = trial - layer.yield_stress - k * still.value;
    if (excess > 0.0) {
      step.slip = softness * excess;
      if (leads) step.slip_ahead = step.slip;
      own.by_trial = by_slip * softness;
      upstream = 1.0 - k * own.by_trial;
    }
  }
  PlasticDisplacement end = yielding(layer, step);
  own.stress = yield_stress(end.value, step.friction);
  own.stress_by_plastic = own.stress > layer.yield_stress + k * end.value ? 0.0 : k;
  const double friction = coefficient_[e] * pressure(e);
  own.yields = own.stress < friction;
  own.by_coefficient = 0.0;
  if (!own.yields) {
    end = {step.before};
    upstream = 1.0;
    own.by_trial = 0.0;
    const double until = k > 0.0 ? (friction - layer.yield_stress) / k : 0.0;
    if (until > step.before) {
      end = {until, 0.0, 0.0, 0.0};
      own.by_coefficient = pressure(e) / k;
    }
  }
  own.plastic = end.value;
  own.by_own = k > 0.0 && r_ > 0.0 ? 0.0 : end.by_slip + (leads ? end.by_slip_ahead : 0.0);
  own.by_ahead = leads ? 0.0 : upstream * end.by_slip_ahead;
  own.carried = leads ? 0.0 : upstream * end.by_before;
}

void FrictionState::linearise(const Given& slip, const Given& trial) {
  follow(slip, trial);
  for (Index e = 0; e < count_; ++e) {
    const double size = std::hypot(slip[e], slip[count_ + e]);
    const double factor = size > 0.0 ? problem_->motion.slip_factor / size : 0.0;
    direction_[e] = factor * slip[e];
    direction_[count_ + e] = factor * slip[count_ + e];
    if (!plasticity_) continue;
    const double trial_size = std::hypot(trial[e], trial[count_ + e]);
    const double inverse = trial_size > 0.0 ? 1.0 / trial_size : 0.0;
    trial_direction_[e] = inverse * trial[e];
    trial_direction_[count_ + e] = inverse * trial[count_ + e];
  }
}

void FrictionState::add_stiff(std::vector<char>& adheres) const {
  for (std::size_t e = 0; e < yield_.size(); ++e)
    if (yield_[e].yields && plasticity_->hardening * yield_[e].by_trial > 0.5) adheres[e] = 1;
}

void FrictionState::change(const Given& slip_change, const Given& trial_change,
                           Vector bound_change) const {
  double ahead = 0.0, coefficient_ahead = 0.0, law_ahead = 0.0, plastic_ahead = 0.0;
  for (Index e = count_; e-- > 0;) {
    const Index f = count_ + e;
    const double size = direction_[e] * slip_change[e] + direction_[f] * slip_change[f];
    double coefficient = by_own_[e] * size + by_ahead_[e] * ahead + carried_[e] * coefficient_ahead;
    if (warming_.size() > 0) {
      coefficient += part_ahead_[e] * law_ahead;
      const double own = warming_[0] * pressure(e);
      const double others =
          warmed(e, flow_change_) + own * (coefficient_[e] * size + sizes_[e] * coefficient);
      law_ahead =
          by_temperature_[e] * others / (1.0 - by_temperature_[e] * own * sizes_[e] * part_[e]);
      coefficient += part_[e] * law_ahead;
      flow_change_[e] = pressure(e) * (coefficient_[e] * size + sizes_[e] * coefficient);
    }
    bound_change[e] = coefficient * pressure(e);
    if (plasticity_) {
      const Yield& own = yield_[static_cast<std::size_t>(e)];
      const double trial =
          trial_direction_[e] * trial_change[e] + trial_direction_[f] * trial_change[f];
      plastic_ahead = own.by_own * size + own.by_ahead * ahead + own.carried * plastic_ahead +
                      own.by_coefficient * coefficient + own.by_trial * trial;
      if (own.yields) bound_change[e] = own.stress_by_plastic * plastic_ahead;
    }
    ahead = size;
    coefficient_ahead = coefficient;
  }
}

}  // namespace rollfem::contact
