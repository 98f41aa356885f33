// SPDX-License-Identifier: LGPL-2.1-or-later
// One driver for every elasticity: every problem gives the half-space's numbers with its compliance
// in the iteration used by finite elements, and those of the curved half-space by the hybrid
// without a correction, so that differences between two models come from elasticity only.
#include "contact/solve/contact_run.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "hybrid/hybrid_model.hpp"
#include "track/motion/placed_scenes.hpp"

#include "support/committed_cases.hpp"

namespace {

Case on_16_across(const std::string& name) {
  Case input = committed_case(name);
  input.contact_grid.cell_size.reset();
  input.contact_grid.extent.reset();
  input.contact_grid.elements_across = 16;
  return input;
}

/// The half-space as if it could not be solved with: an unknown compliance, preconditioned by the
/// half-space of other constants, as finite elements are.
class Disguised : public contact::Elasticity {
 public:
  Disguised(const Scene& scene, const contact::ContactGrid& grid, double scale)
      : whole_(grid, scene.material), halfspace_(grid, scaled(scene.material, scale)) {}
  const contact::Compliance& compliance() const override { return whole_; }
  const contact::SolvableCompliance& halfspace() const override { return halfspace_; }
  Eigen::Vector2d rolling_stiffness(const contact::PatchSize&) const override {
    return Eigen::Vector2d::Constant(2e8);
  }
  Eigen::Vector2d shift_stiffness(const contact::PatchSize&) const override {
    return Eigen::Vector2d::Constant(1e7);
  }

 private:
  static contact::CombinedMaterial scaled(contact::CombinedMaterial material, double factor) {
    material.shear_modulus *= factor;
    material.contact_modulus *= factor;
    return material.uncoupled();
  }

  halfspace::HalfspaceCompliance whole_;
  halfspace::HalfspaceCompliance halfspace_;
};

/// `scale`: constants of the half-space that preconditions over the true ones; 0: the half-space
/// is solved with directly.
contact::LevelResult run(const Scene& scene, const contact::ContactGrid& grid, double scale) {
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(scene);
  contact::RunOptions options;
  options.accuracy = {1e-9, 1e-8, 100, 5};
  options.force_accuracy = options.accuracy;
  options.force_tolerance = 1e-9;
  const contact::Progress silent;
  contact::ContactRun run(scene, geometry, options, silent, nullptr);
  const bool inside = run.solve(grid, [&]() -> std::unique_ptr<contact::Elasticity> {
    if (scale > 0.0) return std::make_unique<Disguised>(scene, grid, scale);
    return halfspace::halfspace_elasticity(scene, geometry, grid);
  });
  EXPECT_TRUE(inside);
  return run.take_result();
}

/// The half-space disguised: with itself as its preconditioner to rounding, with another one to the
/// tolerance of the outer iteration: the fit to the leading edge is that of the whole displacement.
void expect_disguised_alike(const Case& input) {
  const Scene scene(input);
  for (const auto& [scale, tolerance] : {std::pair{1.0, 1e-7}, {1.1, 1e-6}}) {
    SCOPED_TRACE(scale);
    const contact::ContactGrid grid = halfspace::PatchSearch(scene).grid();
    const auto plain = run(scene, grid, 0.0).points;
    const auto other = run(scene, grid, scale).points;
    ASSERT_EQ(plain.size(), other.size());
    for (std::size_t k = 0; k < plain.size(); ++k) {
      SCOPED_TRACE(k);
      const double sliding = scene.friction_coefficient() * plain[k].normal_force;
      EXPECT_NEAR(other[k].normal_force / plain[k].normal_force, 1.0, tolerance);
      EXPECT_NEAR(other[k].max_pressure / plain[k].max_pressure, 1.0, tolerance);
      EXPECT_NEAR(other[k].longitudinal_force, plain[k].longitudinal_force, tolerance * sliding);
      EXPECT_NEAR(other[k].lateral_force, plain[k].lateral_force, tolerance * sliding);
      EXPECT_NEAR(other[k].creepage.longitudinal, plain[k].creepage.longitudinal, 1e-2 * tolerance);
    }
  }
}

contact::ModelResult hybrid_of(const contact::Scene& scene, const hybrid::SmoothParts& parts) {
  return hybrid::run_hybrid(scene, {}, nullptr,
                            [&](const contact::Scene&, const contact::Progress&) { return parts; });
}

/// The hybrid without a correction is the half-space on the curved surface.
void expect_hybrid_alike(contact::Scene scene) {
  const auto hybrid = hybrid_of(scene, {});
  scene.follows_surface = 1.0;
  const auto half = halfspace::run_halfspace(scene, {});
  ASSERT_EQ(hybrid.points.size(), half.points.size());
  for (std::size_t k = 0; k < half.points.size(); ++k) {
    SCOPED_TRACE(k);
    const PointResult &one = hybrid.points[k], &other = half.points[k];
    const double force = other.normal_force;
    EXPECT_NEAR(one.max_pressure, other.max_pressure, 1e-5 * other.max_pressure);
    EXPECT_NEAR(one.normal_force, force, 1e-5 * force);
    EXPECT_NEAR(one.longitudinal_force, other.longitudinal_force, 1e-5 * force);
    EXPECT_NEAR(one.lateral_force, other.lateral_force, 1e-5 * force);
    EXPECT_NEAR(one.creepage.longitudinal, other.creepage.longitudinal, 1e-8);
    // Values that are exact or given in one model are so in the other.
    EXPECT_EQ(one.error_estimate.size(), other.error_estimate.size());
  }
}

/// A kind of problem, posed to any bodies.
struct ProblemKind {
  const char* name;
  void (*pose)(Case& input);
};

void PrintTo(const ProblemKind& kind, std::ostream* stream) {
  *stream << kind.name;
}

void shift(Case& input) {
  input.rolling.problem = Problem::shift;
  input.rolling.creepages.assign(3, {});
  for (const double way : {2e-3, -1e-3, 6e-3}) {
    contact::HistoryStep& step = input.history.emplace_back();
    step.longitudinal_shift = way;
    step.lateral_shift = 0.3 * way;
  }
}

const ProblemKind problems[] = {
    {"SteadyRolling",
     [](Case& input) {
       input.rolling.creepages = {{1e-3, 0.0, 0.0}, {1e-3, 5e-4, 1e-4}};
     }},
    {"PrescribedForces",
     [](Case& input) {
       input.rolling.creepages = {{}, {0.0, 0.0, 1e-4}};
       input.rolling.forces = {{-12e3, {}}, {-9e3, 6e3}};
     }},
    {"ApproachInPlaceOfTheForce",
     [](Case& input) {
       input.load = {};
       input.load.approach = 0.04;
       input.rolling.creepages = {{2e-3, 0.0, 0.0}};
     }},
    {"Shift", shift},
    {"LoadHistory",
     [](Case& input) {
       shift(input);
       for (std::size_t k = 0; k < 3; ++k)
         input.history[k].normal_force = 20e3 + 10e3 * static_cast<double>(k);
     }},
    {"TransientRolling",
     [](Case& input) {
       roll_on(input, 3, 1.0, {1e-3, 5e-4, 0.0});
     }},
    {"SteadyStart",
     [](Case& input) {
       roll_on(input, 3, 1.0, {1e-3, 5e-4, 0.0});
       input.starts_steady = true;
       input.rolling.creepages[2].longitudinal = 0.0;
     }},
    {"ALayerThatYields", [](Case& input) {
       input.rolling.creepages = {{0.002, 0.0, 0.0}, {0.004, 0.002, 1e-4}};
       input.layer = contact::Layer{0.02, 800.0, 100.0, 500.0};
     }}};

class OneDriver : public ::testing::TestWithParam<ProblemKind> {};

TEST_P(OneDriver, GivesTheHalfSpacesNumbers) {
  Case plane = thesis_case('b', 16);
  GetParam().pose(plane);
  expect_disguised_alike(plane);
}

TEST_P(OneDriver, GivesTheNumbersOfTheCurvedHalfSpaceToTheHybrid) {
  Case curved = on_16_across("thesis_e");
  GetParam().pose(curved);
  expect_hybrid_alike(curved);
}

INSTANTIATE_TEST_SUITE_P(Problems, OneDriver, ::testing::ValuesIn(problems),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(OneDriverOf, APrescribedForceCostsAsManyAppliesAsItsCreepage) {
  Case input = thesis_case('b', 16);
  input.rolling.creepages = {{}, {0.0, 0.0, 1e-4}, {}};
  input.rolling.forces = {{-12e3, {}}, {-9e3, 6e3}, {-26e3, {}}};
  const contact::ContactGrid grid = halfspace::PatchSearch(input).grid();
  const auto forced = run(input, grid, 1.1).points;
  Case again = input;
  again.rolling.forces.assign(3, {});
  for (std::size_t k = 0; k < 3; ++k) again.rolling.creepages[k] = forced[k].creepage;
  const auto given = run(again, grid, 1.1).points;
  for (std::size_t k = 0; k < 3; ++k) {
    SCOPED_TRACE(k);
    EXPECT_NEAR(given[k].longitudinal_force, forced[k].longitudinal_force, 1e-6 * 27.5e3);
    EXPECT_NEAR(given[k].lateral_force, forced[k].lateral_force, 1e-6 * 27.5e3);
    EXPECT_LE(forced[k].iterations, given[k].iterations + 2);
  }
}

TEST(OneDriverOf, AGivenPressure) {
  Case input = thesis_case('b', 16);
  input.given_pressure = contact::GivenPressure{5.0, 4.0, 800.0};
  input.rolling.creepages = {{1e-3, 0.0, 1e-4}};
  expect_disguised_alike(input);
}

TEST(OneDriverOf, ACurvedSurfaceCarriesTheLoadWithFriction) {
  Case input = thesis_case('b', 16);
  input.rail.transverse_radius = 50.0;
  input.wheel.transverse_radius = -51.282;
  input.surface = contact::SurfaceForm::curved;
  input.rolling.creepages = {{1e-3, 2e-3, 0.0}, {}};
  input.rolling.forces = {{}, {-8e3, -8e3}};
  expect_disguised_alike(input);
  for (const PointResult& point : halfspace::run_halfspace(input, {}).points)
    EXPECT_NEAR(point.normal_force, 50e3, 1e-6 * 50e3);
}

TEST(OneDriverOf, PatchesOfProfilesInBalance) {
  for (const char* name : {"s1002_uic60_left", "s1002_uic60_right"}) {
    Case input = on_16_across(name);
    input.rolling.creepages.resize(1);
    for (const track::PlacedScene& placed : track::make_scenes(input))
      expect_hybrid_alike(placed.scene);
  }
}

TEST(HybridDriver, AccuracyIsReached) {
  Case input = on_16_across("thesis_f");
  input.rolling.creepages.resize(1);
  input.accuracy = 0.002;
  input.accuracy_of = {"max_pressure"};
  const auto point = hybrid_of(input, {}).points.front();
  EXPECT_LE(point.error_estimate.at("max_pressure"), 0.002 * point.max_pressure);
}

TEST(HybridDriver, ASpringBelowTheRailSinks) {
  Case input = on_16_across("thesis_a");
  input.rolling.creepages.resize(1);
  // Constant displacement along the normal, mm per N of the normal force.
  const double softness = 1e-6;
  hybrid::SmoothParts springs;
  springs.rail.fields = {50.0, 50.0, 0.0};
  springs.rail.coefficients = Eigen::MatrixXd::Zero(3, 3);
  springs.rail.coefficients(2, 2) = softness;
  const auto with = hybrid_of(input, springs).points.front();
  const auto without = hybrid_of(input, {}).points.front();
  EXPECT_NEAR(with.approach - without.approach, softness * 50e3, 1e-4 * without.approach);
  EXPECT_NEAR(with.max_pressure, without.max_pressure, 1e-5 * without.max_pressure);
}

}  // namespace
