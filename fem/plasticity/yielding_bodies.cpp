// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/yielding_bodies.hpp"

#include "base/errors.hpp"
#include "contact/iteration/anderson.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "fem/plasticity/steady_pass.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "result/heat/temperature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::fem {

namespace {

/// Weight, MPa, of numbers that follow the others: too small to affect the least-squares fit.
constexpr double weight_of_followers = 1e-3;

/// Calls visit(number, weight) for every number of a state, that of the vector being weight times
/// the number of the state.
template <class Visit>
void for_each_number(PlasticState& state, const Visit& visit) {
  for (Deviator& back : state.back)
    for (double& component : back) visit(component, 1.0);
  for (double& component : state.strain) visit(component, weight_of_followers);
  visit(state.accumulated, weight_of_followers);
}

}  // namespace

void LimitState::approach(const std::vector<Deviator>& residual,
                          std::vector<PlasticState>& states) {
  std::vector<double> end;
  for (std::size_t k = 0; k < states.size(); ++k) {
    end.insert(end.end(), residual[k].begin(), residual[k].end());
    for_each_number(states[k],
                    [&](double number, double weight) { end.push_back(weight * number); });
  }
  if (cycles_.empty()) cycles_.emplace_back(end.size(), 0.0);
  cycles_.push_back(end);
  constexpr int depth = 5;
  if (cycles_.size() > 2 * (depth + 1)) cycles_.erase(cycles_.begin(), cycles_.begin() + 2);
  contact::Anderson anderson(depth);
  Eigen::VectorXd next;
  const auto vector = [](std::vector<double>& of) {
    return Eigen::Map<Eigen::VectorXd>(of.data(), static_cast<Eigen::Index>(of.size()));
  };
  for (std::size_t k = 0; k < cycles_.size(); k += 2)
    next = anderson.next(vector(cycles_[k]), vector(cycles_[k + 1]));
  cycles_.emplace_back(next.begin(), next.end());
  const double* from = next.data();
  for (PlasticState& state : states) {
    from += residual.front().size();
    for_each_number(state, [&](double& number, double weight) { number = *from++ / weight; });
    state.accumulated = std::max(state.accumulated, 0.0);
  }
}

namespace {

/// The fine region of the mesh.
StreamLattice lattice_of(const BodyOptions& options) {
  const double h = options.cell_size;
  const auto cells = [h](double length) { return static_cast<int>(std::lround(length / h)); };
  const auto within = [h](double length) {
    return static_cast<int>(std::floor(length / h + 1e-6));
  };
  StreamLattice lattice;
  lattice.cell = h;
  lattice.along = {-within(options.fine_half_length), within(options.fine_half_length)};
  const int middle = cells(options.middle), wide = within(options.plastic_half_width);
  lattice.across = {options.half ? 0 : middle - wide, middle + wide};
  lattice.down = within(options.plastic_depth * h);
  lattice.rows = options.rows;
  return lattice;
}

/// While the contact is sought: a part of the last change of the load, within bounds; and for a
/// pass that counts.
constexpr double part_of_change = 0.02;
constexpr double loosest_residual = 1e-2;
constexpr double loose_residual = 1e-5;
constexpr double tight_residual = 1e-6;

/// |a - b| over |a|.
double relative_change(const std::vector<Deviator>& a, const std::vector<Deviator>& b) {
  if (b.size() != a.size()) return 1.0;
  double change = 0.0, all = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Deviator difference = sum(a[k], -1.0, b[k]);
    change += product(difference, difference);
    all += product(a[k], a[k]);
  }
  return all > 0.0 ? std::sqrt(change / all) : 0.0;
}

}  // namespace

class YieldingBody {
 public:
  YieldingBody(const contact::Scene& scene, const contact::BodyPlasticity& steel, const Body& body,
               const LinearSolver& solver)
      : body_(body),
        heat_(resolves_heat(scene, body.shape().is_wheel, body.options()) ? scene.heat
                                                                          : std::nullopt),
        law_(steel, lame_mu(body.material())),
        streamlines_(body, lattice_of(body.options())),
        solver_(streamlines_, solver),
        results_(body, law_, streamlines_, options_of(scene).cycle, scene.is_history()),
        extrapolates_(options_of(scene).limit_state),
        before_(before_first_pass(streamlines_, body)),
        now_(before_) {
    for (std::size_t stream = 0; stream < streamlines_.streams(); ++stream)
      initial_.push_back(initial_strain(law_, streamlines_.section(stream)[1]));
    if (!scene.is_history()) return;
    // Without load the contact is judged on the whole grid.
    solver_.in_part.reset();
    now_ = before_ = before_first_step(
        streamlines_, body, with_initial(std::vector<Deviator>(streamlines_.points(), Deviator{})));
  }

  /// Solves the pass in question anew, from its last solution.
  PassReport pass(const Vector& elastic, bool counts) {
    std::vector<Deviator> strain = with_initial(streamlines_.strains(elastic));
    const std::vector<double> hot = heat(strain);
    YieldedBody next = now_;
    next.leaving = before_.leaving;
    next.strain = before_.strain;
    PassAccuracy accuracy;
    accuracy.whole_body = counts;
    accuracy.once = now_.pressed() && !counts;
    // The contact no longer gives way.
    if (now_.pressed() && counts) solver_.steps.restart();
    accuracy.residual = counts ? tight_residual
                               : std::clamp(part_of_change * relative_change(strain, last_strain_),
                                            loose_residual, loosest_residual);
    const PassReport report = steady_pass(streamlines_, law_, solver_, strain, accuracy, next, hot);
    now_ = std::move(next);
    last_strain_ = std::move(strain);
    imbalance_ = accuracy.once ? report.residual : 0.0;
    return report;
  }

  double imbalance() const { return imbalance_; }

  /// Gives the material points the temperature that these elements of the surface have, degC.
  void warm(const contact::ContactGrid& grid, const contact::Field& surface) {
    if (!heat_ || surface.size() == 0) return;
    std::vector<std::array<double, 3>> places;
    for (std::size_t stream = 0; stream < streamlines_.streams(); ++stream) {
      const auto [t, depth] = streamlines_.section(stream);
      const auto down = body_.shape().place(0.0, t, depth) - body_.shape().place(0.0, t, 0.0);
      const double below = std::abs(body_.shape().frame(0.0, t)[2] * down);
      for (std::size_t station = 0; station < streamlines_.stations(); ++station) {
        const auto place = body_.shape().place(streamlines_.s(station), t, 0.0);
        places.push_back({place[0], place[1], below});
      }
    }
    rise_ = contact::rise_below(grid, heated(), heat_->speed, surface, places);
    // Steel cools down before the next pass: at once, before the section that results show.
    for (std::size_t k = 0; k < rise_.size(); ++k)
      if (k % streamlines_.stations() + 1 >= streamlines_.section_station()) rise_[k] = 0.0;
  }

  /// `traction`: the largest one along rolling, MPa, which is xz at the surface.
  contact::YieldedSection finish(const Vector& elastic, double traction) {
    const PassReport report = pass(elastic, true);
    refuse_beyond_streamlines();
    contact::YieldedSection section = results_.after_pass(report, before_, now_);
    if (!now_.pressed())
      section.shakedown_load = std::max(shakedown_load(law_, streamlines_, last_strain_),
                                        traction / law_.parameters().shear_yield_stress());
    before_ = now_;
    if (extrapolates_ && results_.cycle_ended())
      limit_.approach(residual_behind_load(), before_.leaving);
    last_strain_.clear();  // the next pass begins as in a run that is resumed
    solver_.steps.restart();
    return section;
  }
  /// What the next pass starts from; by reading it the body goes on from there.
  void exchange(contact::Record& record) {
    results_.exchange(record);
    limit_.exchange(record);
    record.values(before_.leaving, before_.strain, rise_);
    for (Vector* vector : {&before_.displacement, &before_.load}) {
      std::vector<double> numbers(vector->begin(), vector->end());
      record.values(numbers);
      record.demand(numbers.size() == static_cast<std::size_t>(vector->end() - vector->begin()));
      std::copy(numbers.begin(), numbers.end(), vector->begin());
      vector->update_ghost_values();
    }
    if (record.reading()) now_ = before_;
  }

  /// By plastic strain, mm, with ghost values.
  const Vector& displacement() const { return now_.displacement; }
  const YieldedFields& fields() const { return results_.fields(); }

 private:
  const contact::HeatedBody& heated() const {
    return body_.shape().is_wheel ? heat_->wheel : heat_->rail;
  }
  /// Adds the elastic strain of the thermal stress: the material around the heated layer, which is
  /// thin, holds it along and across, and nothing normal to the surface. Returns how hot the points
  /// are (PlasticLaw::advance).
  std::vector<double> heat(std::vector<Deviator>& strain) const {
    if (rise_.empty()) return {};
    const double nu = body_.material().poisson_ratio;
    const double per_kelvin = heated().expansion * (1.0 + nu) / (1.0 - nu);
    const double to_hot =
        law_.parameters().hot_temperature.value_or(contact::infinity) - heated().temperature;
    std::vector<double> hot;
    for (std::size_t k = 0; k < strain.size(); ++k) {
      const std::size_t stream = k / streamlines_.stations();
      const auto n = body_.shape().frame(0.0, streamlines_.section(stream)[0])[2];
      const Deviator held{n[0] * n[0] - 1.0 / 3.0,
                          n[1] * n[1] - 1.0 / 3.0,
                          n[2] * n[2] - 1.0 / 3.0,
                          n[0] * n[1],
                          n[1] * n[2],
                          n[0] * n[2]};
      strain[k] = sum(strain[k], per_kelvin * rise_[k], held);
      hot.push_back(std::clamp(rise_[k] / to_hot, 0.0, 1.0));
    }
    return hot;
  }

  /// With the strain of the residual stress before.
  std::vector<Deviator> with_initial(std::vector<Deviator> strain) const {
    for (std::size_t k = 0; k < strain.size(); ++k)
      strain[k] = sum(strain[k], 1.0, initial_[k / streamlines_.stations()]);
    return strain;
  }

  /// Deviator, MPa, on every streamline.
  std::vector<Deviator> residual_behind_load() const {
    const std::vector<Deviator> strain = streamlines_.strains(now_.displacement);
    std::vector<Deviator> stress;
    for (std::size_t stream = 0; stream < streamlines_.streams(); ++stream)
      stress.push_back(
          law_.stress(now_.leaving[stream],
                      strain[stream * streamlines_.stations() + streamlines_.section_station()]));
    return stress;
  }

  /// At the border of the lattice nothing may yield by more than a small part of the largest strain
  /// of the pass, except where streamlines leave.
  void refuse_beyond_streamlines() const {
    const std::size_t width = streamlines_.width(), all = streamlines_.streams();
    constexpr double small = 5e-3;
    double least = 1e-3 * law_.parameters().yield_stress / law_.shear_modulus();
    for (std::size_t path = 0; path < now_.leaving.size(); ++path)
      least = std::max(
          least, small * (now_.leaving[path].accumulated - before_.leaving[path].accumulated));
    const auto refuse = [&](const char* border, YieldsBeyondStreamlines::Direction direction) {
      const BodyOptions& options = body_.options();
      throw YieldsBeyondStreamlines(
          fmt::format("the {} yielded at the {} of the region that may yield, {:.3g} mm along and "
                      "{:.3g} mm across to both sides, {:.3g} mm deep",
                      body_.shape().is_wheel ? "wheel" : "rail", border, options.fine_half_length,
                      options.plastic_half_width,
                      options.rows.depth(options.plastic_depth * options.cell_size)),
          direction);
    };
    using Beyond = YieldsBeyondStreamlines;
    for (std::size_t path = 0; path < now_.leaving.size(); ++path) {
      const double gained = now_.leaving[path].accumulated - before_.leaving[path].accumulated;
      if (gained <= least) continue;
      const std::size_t stream = now_.pressed() ? path / streamlines_.stations() : path;
      if (stream + width >= all) refuse("lower border", Beyond::down);
      const bool left = stream % width == 0 && !body_.options().half;
      if (left || (stream + 1) % width == 0) refuse("lateral border", Beyond::across);
      const std::size_t first = stream * streamlines_.stations();
      if (now_.pressed()) {
        if (path == first || path + 1 == first + streamlines_.stations())
          refuse("border along", Beyond::along);
        continue;
      }
      // What streams gain before their first point they gain at it. In passes of a gauge corner
      // where it is 5 % of a stream's strain, 1.7 times the extent changes no strain by 0.5 %.
      if (now_.accumulated[first] - before_.leaving[stream].accumulated > 0.1 * gained + least)
        refuse("leading border", Beyond::along);
      if (now_.leaving[stream].accumulated -
              now_.accumulated[first + streamlines_.section_station()] >
          0.05 * gained + least)
        refuse("trailing border", Beyond::along);
    }
  }

  const Body& body_;
  std::optional<contact::SurfaceHeat> heat_;  ///< none: the steel is as before contact
  PlasticLaw law_;
  Streamlines streamlines_;
  PassSolver solver_;
  PassResults results_;
  bool extrapolates_;
  LimitState limit_;
  std::vector<Deviator> last_strain_;  ///< under the last load
  std::vector<Deviator> initial_;  ///< strain of the residual stress before, of every streamline
  std::vector<double> rise_;       ///< K, of the last pass that ended, at all points; or empty
  double imbalance_ = 0.0;
  YieldedBody before_, now_;
};

YieldingBodies::YieldingBodies(const contact::Scene& scene, const BodyPair& bodies,
                               const Solvers& solvers, const contact::ContactGrid& grid)
    : grid_(grid), elastic_pressure_(halfspace::PatchSearch(scene).patch().max_pressure) {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& steel = (k == 0 ? scene.wheel : scene.rail).plasticity;
    if (steel && bodies[k] != nullptr)
      parts_[k] = std::make_unique<YieldingBody>(scene, *steel, *bodies[k], *solvers[k]);
  }
}

YieldingBodies::~YieldingBodies() = default;

std::vector<Vector> YieldingBodies::respond(const std::vector<Vector>& elastic) {
  std::vector<Vector> plastic(2);
  for (std::size_t k = 0; k < 2; ++k) {
    if (!parts_[k]) continue;
    parts_[k]->pass(elastic[k], false);
    plastic[k] = parts_[k]->displacement();
    plastic[k].update_ghost_values();  // copies have none
  }
  return plastic;
}

double YieldingBodies::imbalance() const {
  double most = 0.0;
  for (const auto& part : parts_)
    if (part) most = std::max(most, part->imbalance());
  return most;
}

void YieldingBodies::finish_pass(const std::vector<Vector>& elastic, contact::PointResult& point) {
  const contact::Field& along = point.fields.traction.x;
  const double traction = along.size() == 0 ? 0.0 : along.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < 2; ++k) {
    if (!parts_[k]) continue;
    parts_[k]->warm(grid_, k == 0 ? point.fields.temperature_wheel : point.fields.temperature_rail);
    contact::YieldedSection& section =
        point.yielded.emplace_back(parts_[k]->finish(elastic[k], traction));
    if (point.max_pressure > 0.0)
      section.elastic_shakedown_load =
          section.shakedown_load * elastic_pressure_ / point.max_pressure;
  }
  sum_up(point);
}

std::string YieldingBodies::memory() const {
  contact::Record record;
  for (const auto& part : parts_)
    if (part) part->exchange(record);
  return record.bytes();
}

void YieldingBodies::recall(const std::string& memory) {
  if (memory.empty()) return;
  contact::Record record(memory);
  for (const auto& part : parts_)
    if (part) part->exchange(record);
}

const YieldedFields* YieldingBodies::fields(std::size_t body) const {
  const auto& part = parts_[body];
  return part ? &part->fields() : nullptr;
}

}  // namespace rollfem::fem
