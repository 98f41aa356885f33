// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/plasticity/pass_results.hpp"

#include "base/knots.hpp"
#include "base/threads.hpp"
#include "fem/stress/stress_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rollfem::fem {

namespace {

using contact::YieldedSection;
using contact::YieldEvidence;
using contact::YieldVerdict;

/// Linear between the depths, constant outside.
double over_depth(const std::vector<double>& depths, const std::vector<double>& values,
                  double depth) {
  if (values.size() < 2) return values.empty() ? 0.0 : values.front();
  const auto [k, length, part] = contact::piece_of(depths, depth);
  return values[k] + std::clamp(part, 0.0, 1.0) * (values[k + 1] - values[k]);
}

/// Stress before the first pass, MPa, along and across.
std::array<double, 2> stress_before(const PlasticLaw& law, double depth) {
  const auto& residual = law.parameters().residual;
  return {over_depth(residual.depth, residual.along, depth),
          over_depth(residual.depth, residual.across, depth)};
}

std::vector<Place> section_places(const Body& body, const Streamlines& streamlines,
                                  std::size_t station, bool surface) {
  std::vector<Place> places;
  const double s = streamlines.s(station);
  const std::size_t count = surface ? streamlines.width() : streamlines.streams();
  for (std::size_t stream = 0; stream < count; ++stream) {
    const auto [t, depth] = streamlines.section(stream);
    const auto place = body.shape().place(s, t, surface ? 0.0 : depth);
    places.push_back({place[0], place[1], place[2]});
  }
  return places;
}

std::array<float, 6> single(const contact::SymmetricTensor& tensor) {
  std::array<float, 6> rounded{};
  std::copy(tensor.begin(), tensor.end(), rounded.begin());
  return rounded;
}

/// Largest increase of the accumulated plastic strain, and largest change of plastic strain.
std::pair<double, double> gained(const std::vector<PlasticState>& before,
                                 const std::vector<PlasticState>& after) {
  std::pair<double, double> largest{0.0, 0.0};
  for (std::size_t k = 0; k < after.size(); ++k) {
    const Deviator change = sum(after[k].strain, -1.0, before[k].strain);
    largest.first = std::max(largest.first, after[k].accumulated - before[k].accumulated);
    largest.second = std::max(largest.second, std::sqrt(2.0 / 3.0) * norm(change));
  }
  return largest;
}

}  // namespace

Deviator initial_strain(const PlasticLaw& law, double depth) {
  const auto [along, across] = stress_before(law, depth);
  const double mean = (along + across) / 3.0, twice_g = 2.0 * law.shear_modulus();
  return {(along - mean) / twice_g, (across - mean) / twice_g, -mean / twice_g, 0.0, 0.0, 0.0};
}

PassResults::PassResults(const Body& body, const PlasticLaw& law, const Streamlines& streamlines,
                         int cycle, bool pressed)
    : body_(body),
      law_(law),
      streamlines_(streamlines),
      station_(pressed ? streamlines.stations() / 2 : streamlines.section_station()),
      recovery_(body),
      cycle_(cycle) {
  const BodyLocator locator(body);
  const double reach = body.options().cell_size;
  places_ = locator.find(section_places(body, streamlines, station_, false), reach);
  surface_ = locator.find(section_places(body, streamlines, station_, true), reach);
}

YieldedSection PassResults::after_pass(const PassReport& report, const YieldedBody& before,
                                       const YieldedBody& after) {
  if (cycle_ended()) cycle_start_ = before.leaving;
  ++passes_;
  YieldedSection section;
  section.body = body_.shape().is_wheel ? "wheel" : "rail";
  section.iterations = report.iterations;
  section.residual = report.residual;
  section.plastic_work = report.plastic_work * (body_.options().half ? 2.0 : 1.0);
  section.utilisation = report.utilisation;
  std::tie(section.increment, section.net_increment) = gained(before.leaving, after.leaving);
  for (const PlasticState& out : after.leaving)
    section.plastic_strain = std::max(section.plastic_strain, out.accumulated);
  judge(after, section);
  // Nothing enters and leaves a body that is pressed.
  const std::vector<PlasticState> untouched(after.pressed() ? streamlines_.streams() : 0);
  const auto& entering = after.pressed() ? untouched : before.leaving;
  const auto& leaving = after.pressed() ? untouched : after.leaving;
  fields_ = streamlines_.at_nodes(after.plastic, after.accumulated, entering, leaving,
                                  [&](double depth) { return stress_before(law_, depth); });
  fields_.displacement = after.displacement;
  fields_.displacement.update_ghost_values();
  fields_.residual = recovery_.recover(after.displacement);
  add(-1.0, fields_.excess, fields_.residual);
  fill_section(after, section);
  return section;
}

void PassResults::judge(const YieldedBody& after, YieldedSection& section) {
  constexpr double nothing = 2e-3;  // plastic strain of a cycle over the yield strain
  constexpr double closed = 0.05;   // lasting strain of all further cycles over that of one
  constexpr double steady = 0.02;   // relative change of the strain from cycle to cycle
  constexpr double same = 0.1;      // relative change of its lasting part
  const double yield_strain = law_.parameters().yield_stress / (3.0 * law_.shear_modulus());
  const double last_increment = increment_, last_net = net_increment_;
  if (passes_ < cycle_ || cycle_ended())
    std::tie(increment_, net_increment_) = gained(cycle_start_, after.leaving);
  const double change = std::abs(increment_ - last_increment), fall = last_net - net_increment_;
  // Largest lasting strain, summed over all further cycles as a geometric series.
  const double still_to_come =
      passes_ > cycle_ && fall > 0.0 ? net_increment_ * net_increment_ / fall : contact::infinity;
  YieldVerdict verdict = YieldVerdict::settling;
  if (!cycle_ended())
    verdict = verdict_.value_or(verdict);
  else if (section.plastic_strain == 0.0)
    verdict = YieldVerdict::elastic;
  else if (after.pressed())
    verdict = increment_ <= nothing * yield_strain ? YieldVerdict::holds : YieldVerdict::yields;
  else if (increment_ <= nothing * yield_strain)
    verdict = YieldVerdict::elastic_shakedown;
  else if (net_increment_ <= nothing * yield_strain ||
           std::max(net_increment_, still_to_come) <= closed * increment_)
    verdict = YieldVerdict::plastic_shakedown;
  else if (passes_ > 2 * cycle_ && change <= steady * increment_ && fall >= -same * net_increment_)
    verdict =
        fall <= same * net_increment_ ? YieldVerdict::ratchetting : YieldVerdict::beyond_shakedown;
  if (verdict != verdict_) from_pass_ = passes_;
  verdict_ = section.verdict = verdict;
  section.from_pass = from_pass_;
  section.cycle = cycle_;
  section.cycle_increment = increment_;
  section.cycle_net_increment = net_increment_;
  if (cycle_ended()) cycle_start_.clear();
}

void PassResults::fill_section(const YieldedBody& after, YieldedSection& section) {
  section.across = static_cast<int>(streamlines_.width());
  section.down = static_cast<int>(streamlines_.streams() / streamlines_.width());
  const auto stress = stress_at(places_, fields_.residual);
  for (std::size_t stream = 0; stream < streamlines_.streams(); ++stream) {
    const auto [y, depth] = streamlines_.section(stream);
    const PlasticState& state =
        after.leaving[after.pressed() ? stream * streamlines_.stations() + station_ : stream];
    section.y.push_back(y);
    section.depth.push_back(depth);
    section.strain.push_back(single(state.strain));
    section.accumulated.push_back(static_cast<float>(state.accumulated));
    section.stress.push_back(single(streamlines_.in_section(stress[stream], station_, stream)));
  }
  const auto moved = surface_.values(after.displacement, {1, 1, 1});
  const double s = streamlines_.s(station_);
  const double outwards = body_.shape().is_wheel ? -1.0 : 1.0;
  for (std::size_t j = 0; j < streamlines_.width(); ++j) {
    const double y = streamlines_.section(j)[0];
    const SurfaceFrame frame = body_.shape().frame(s, y);
    const dealii::Tensor<1, 3> u({moved[j][0], moved[j][1], moved[j][2]});
    section.surface_y.push_back(y);
    section.groove.push_back(outwards * (u * frame[2]));
    if (!after.pressed()) section.forward_flow.push_back(u * frame[0]);
  }
}

double shakedown_load(const PlasticLaw& law, const Streamlines& streamlines,
                      const std::vector<Deviator>& elastic) {
  const std::size_t stations = streamlines.stations();
  const double twice_g = 2.0 * law.shear_modulus(), yield = law.parameters().yield_stress;
  std::vector<double> of_stream(streamlines.streams(), 0.0);
  contact::for_each_index(of_stream.size(), [&](std::size_t stream) {
    const Deviator* strain = &elastic[stream * stations];
    double shear = 0.0, change = 0.0;
    for (std::size_t i = 0; i < stations; ++i) {
      shear = std::max(shear, std::abs(strain[i][5]));
      for (std::size_t j = 0; j < i; ++j) {
        const Deviator difference = sum(strain[i], -1.0, strain[j]);
        change = std::max(change, product(difference, difference));
      }
    }
    of_stream[stream] =
        twice_g / yield * std::max(std::sqrt(3.0) * shear, std::sqrt(0.375 * change));
  });
  return *std::max_element(of_stream.begin(), of_stream.end());
}

namespace {

/// Of a body that is pressed, not rolled over.
bool is_pressed(const YieldedSection& section) {
  return section.forward_flow.empty();
}

double imprint_of(const YieldedSection& section) {
  return -*std::min_element(section.groove.begin(), section.groove.end());
}

YieldEvidence evidence_of(const YieldedSection& coarse, const YieldedSection& fine,
                          bool thick_rows) {
  constexpr double about = 0.3;  // relative change between the meshes
  const bool flows =
      fine.verdict == YieldVerdict::ratchetting || fine.verdict == YieldVerdict::settling ||
      fine.verdict == YieldVerdict::beyond_shakedown || fine.verdict == YieldVerdict::yields;
  const auto decisive = fine.verdict == YieldVerdict::ratchetting
                            ? &YieldedSection::cycle_net_increment
                            : &YieldedSection::cycle_increment;
  const double here = fine.*decisive, there = coarse.*decisive;
  if (flows && (thick_rows || std::abs(here - there) > about * std::max(here, there)))
    return YieldEvidence::not_resolved;
  return coarse.verdict == fine.verdict ? YieldEvidence::both_meshes : YieldEvidence::meshes_differ;
}

/// Where the shakedown map says otherwise, and why.
std::string beside_the_map(const YieldedSection& section) {
  constexpr double near = 0.1;
  const double load = section.shakedown_load, elastic = section.elastic_shakedown_load;
  const char* const limit = "of the limit of shakedown of steel that does not harden";
  if (load == 0.0 || section.verdict == YieldVerdict::elastic) return {};
  const bool flows = section.verdict == YieldVerdict::ratchetting ||
                     section.verdict == YieldVerdict::beyond_shakedown;
  if (flows && load < 1.0 - near)
    return fmt::format("; the load is {:.0f} % {}", 100.0 * load, limit);
  if (flows) return {};
  if (load <= 1.0 && elastic > 1.0 && load < (1.0 - 0.3 * near) * elastic)
    return fmt::format(
        "; it settles because the groove conforms: the load falls from {:.0f} to {:.0f} % {}",
        100.0 * elastic, 100.0 * load, limit);
  if (load > 1.0 + near)
    return fmt::format("; yet the load is {:.0f} % {}, which hardening raises", 100.0 * load,
                       limit);
  return {};
}

}  // namespace

std::string finding(const YieldedSection& section, const YieldedSection* coarse, int passes) {
  std::string text = word_of(section.verdict);
  if (section.from_pass < passes)
    text += fmt::format(" since {} {}", is_pressed(section) ? "step" : "pass", section.from_pass);
  if (is_pressed(section))
    return section.plastic_strain == 0.0
               ? text
               : text + fmt::format(", plastic strain up to {:.2g}, an imprint {:.3g} mm deep",
                                    section.plastic_strain, imprint_of(section));
  const std::string cycle =
      section.cycle == 1 ? "pass" : fmt::format("cycle of {} points", section.cycle);
  const bool resolved = section.evidence != YieldEvidence::not_resolved;
  const auto strain = [&](double value, double on_coarse) {
    return fmt::format("{}{:.2g}", !resolved && value > on_coarse ? "at least " : "", value);
  };
  const double net = section.cycle_net_increment, all = section.cycle_increment;
  const double coarse_net = coarse ? coarse->cycle_net_increment : net,
               coarse_all = coarse ? coarse->cycle_increment : all;
  if (!resolved) text += ", not resolved";
  switch (section.verdict) {
    case YieldVerdict::ratchetting:
      text += fmt::format(", {} of lasting plastic strain a {}", strain(net, coarse_net), cycle);
      break;
    case YieldVerdict::plastic_shakedown:
      text += fmt::format(", at most {:.2g} of lasting plastic strain a {}", net, cycle);
      break;
    case YieldVerdict::settling:
    case YieldVerdict::beyond_shakedown:
      text += fmt::format(", {} of plastic strain in the last {}, {} of it lasting{}",
                          strain(all, coarse_all), cycle, strain(net, coarse_net),
                          section.verdict == YieldVerdict::settling ? ": more passes will tell"
                                                                    : " and still falling");
      break;
    default:
      if (section.cycle > 1) text += fmt::format(", judged over a {}", cycle);
  }
  if (coarse && section.evidence != YieldEvidence::both_meshes)
    text += fmt::format("; on cells of twice the size {}, {:.2g} and {:.2g}",
                        word_of(coarse->verdict), coarse_all, coarse_net);
  return text + beside_the_map(section);
}

std::string verdict_note(const YieldedSection& section, int passes) {
  const bool steps = is_pressed(section);
  return fmt::format("the {} after {} {}{}: {}", section.body, passes, steps ? "step" : "pass",
                     passes == 1 ? "" : (steps ? "s" : "es"), section.finding);
}

void compare_verdicts(const std::vector<contact::PointResult>& coarse,
                      std::vector<contact::PointResult>& fine, bool thick_rows) {
  for (std::size_t k = 0; k < fine.size(); ++k)
    for (std::size_t b = 0; b < fine[k].yielded.size(); ++b) {
      YieldedSection& section = fine[k].yielded[b];
      const YieldedSection& other = coarse[k].yielded[b];
      section.evidence = evidence_of(other, section, thick_rows);
      section.finding = finding(section, &other, static_cast<int>(k) + 1);
    }
}

void sum_up(contact::PointResult& point) {
  const auto largest = [](std::optional<double>& value, double other) {
    value = std::max(value.value_or(0.0), other);
  };
  for (const YieldedSection& section : point.yielded) {
    largest(point.plastic_strain, section.plastic_strain);
    largest(point.plastic_increment, section.increment);
    if (!is_pressed(section)) {
      largest(point.net_plastic_increment, section.net_increment);
      point.plastic_work = point.plastic_work.value_or(0.0) + section.plastic_work;
    }
    for (const auto& stress : section.stress) largest(point.residual_stress, -stress[0]);
    largest(point.groove_depth, imprint_of(section));
    for (const double flow : section.forward_flow)
      if (std::abs(flow) >= std::abs(point.forward_flow.value_or(0.0))) point.forward_flow = flow;
  }
}

}  // namespace rollfem::fem
