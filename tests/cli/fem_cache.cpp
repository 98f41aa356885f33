// SPDX-License-Identifier: LGPL-2.1-or-later
// The cached corrections of the model hybrid: found for scenes with the same correction, never for
// other bodies, complete or absent, listed and cleared.
#include "support/program.hpp"

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// On a few hundred finite elements.
std::string coarse_case(const std::string& radius, const std::string& force,
                        const std::string& friction, const std::string& creepage) {
  return "models = [\"hybrid\"]\n[load]\nnormal_force = " + force +
         "\n[friction]\ncoefficient = " + friction + "\n[wheel]\nrolling_radius = " + radius +
         "\ntransverse_radius = inf\n[rail]\ntransverse_radius = 500.0\n[rolling]\n"
         "longitudinal_creepage = " +
         creepage + "\n[contact_grid]\nelements_across = 12\n[fem]\ndegree = 1\nextent = 30\n";
}

class Cache {
 public:
  /// The model's result.
  json run(const std::string& name, const std::string& text, const std::string& folder = "cache",
           int processes = 1) {
    const std::string file = folder_.file(name + ".toml", text);
    checked(folder_.execute(command_of({"run", file, "-o", name, "--no-report", "-q"}, processes),
                            {"ROLLFEM_CACHE=" + folder}));
    return folder_.json(name + "/summary.json")["models"][0];
  }

  /// stress.json of a stored result.
  json stress(const std::string& name) {
    folder_.done({"stress", name, "--no-figures", "-o", "stress"}, {"ROLLFEM_CACHE=cache"});
    return folder_.json("stress/stress.json");
  }

  std::string list(const std::string& action) {
    return folder_.done({"cache", action}, {"ROLLFEM_CACHE=cache"}).out;
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_.work() / "cache"))
      found.push_back(entry.path());
    return found;
  }

 private:
  Folder folder_;
};

bool notes(const json& model, const std::string& part) {
  for (const json& note : model["notes"])
    if (says(note, part)) return true;
  return false;
}

void expect_same_point(const json& one, const json& other, double tolerance) {
  for (const char* name : {"max_pressure", "approach", "longitudinal_force", "semi_axis_x"}) {
    const double value = one["points"][0][name];
    EXPECT_NEAR(value, other["points"][0][name], tolerance * std::abs(value)) << name;
  }
}

}  // namespace

TEST(Cache, ServesAnotherLoadFrictionAndCreepage) {
  Cache cache;
  EXPECT_FALSE(
      notes(cache.run("first", coarse_case("405", "50e3", "0.55", "0.001")), "from the cache"));
  const std::string other = coarse_case("405", "47e3", "0.3", "0.002");
  const json found = cache.run("found", other);
  EXPECT_TRUE(notes(found, "from the cache"));
  // The same as without the cache: results do not depend on the origin of the correction.
  const json computed = cache.run("computed", other, "");
  EXPECT_FALSE(notes(computed, "from the cache"));
  expect_same_point(found, computed, 1e-13);
  EXPECT_LT(found["seconds"]["correction"].get<double>(),
            0.2 * computed["seconds"]["correction"].get<double>());
}

TEST(Cache, IsOfTheBodiesThatItWasFoundFor) {
  Cache cache;
  EXPECT_TRUE(says(cache.list("list"), "0 corrections"));
  cache.run("one", coarse_case("405", "50e3", "0.55", "0.001"));
  EXPECT_FALSE(
      notes(cache.run("wheel", coarse_case("406", "50e3", "0.55", "0.001")), "from the cache"));
  EXPECT_FALSE(
      notes(cache.run("load", coarse_case("405", "80e3", "0.55", "0.001")), "from the cache"));
  const std::string listed = cache.list("list");
  EXPECT_TRUE(says(listed, "wheel 406, across inf; rail across 500", "3 corrections"));
  EXPECT_TRUE(says(cache.list("clear"), "removed 3 corrections"));
  EXPECT_TRUE(cache.files().empty());
}

TEST(Cache, IsKnownToTheModelAuto) {
  Cache cache;
  const std::string text = coarse_case("405", "50e3", "0.55", "0.001");
  const auto seconds = [&](const std::string& name) {  // a half-space suffices
    const std::string told = cache.run(name, text.substr(text.find('\n') + 1))["choice"];
    const std::string words = "hybrid would take about ";
    const auto at = told.find(words);
    EXPECT_NE(at, std::string::npos) << told;
    return std::stod(told.substr(at + words.size()));
  };
  const double anew = seconds("anew");
  EXPECT_GT(anew, 3.0);
  cache.run("kept", text);
  EXPECT_LT(seconds("found"), 0.2 * anew);
}

TEST(Cache, ADamagedFileIsReportedAndReplaced) {
  Cache cache;
  const std::string text = coarse_case("405", "50e3", "0.55", "0.001");
  const json first = cache.run("first", text);
  const auto files = cache.files();
  ASSERT_EQ(files.size(), 1u);
  {
    std::fstream file(files[0], std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(files[0]) / 2));
    file.write("damage", 6);
  }
  EXPECT_TRUE(says(cache.list("list"), "is damaged"));
  const json anew = cache.run("anew", text);
  EXPECT_TRUE(notes(anew, "is damaged; the correction was recomputed"));
  expect_same_point(first, anew, 1e-13);
  EXPECT_TRUE(notes(cache.run("again", text), "from the cache"));
}

TEST(Cache, AFolderThatCannotBeWrittenIsNoFailure) {
  Cache cache;
  const json model =
      cache.run("case", coarse_case("405", "50e3", "0.55", "0.001"), "/dev/null/nowhere");
  EXPECT_TRUE(notes(model, "could not be stored for other runs"));
}

TEST(Cache, TwoProcessesShareWhatTheFirstFinds) {
  Cache cache;
  const std::string text = coarse_case("405", "50e3", "0.55", "0.001");
  const json alone = cache.run("alone", text, "");
  const json two = cache.run("two", text, "cache", 2);
  EXPECT_FALSE(notes(two, "from the cache"));
  expect_same_point(alone, two, 1e-8);
  EXPECT_EQ(cache.files().size(), 1u);
  const json found = cache.run("found", text, "cache", 2);
  EXPECT_TRUE(notes(found, "from the cache"));
  expect_same_point(two, found, 1e-13);
}

TEST(Cache, KeepsStressesForCasesThatRequestThem) {
  Cache cache;
  const std::string plain = coarse_case("450", "50e3", "0.3", "0.001");
  const std::string asking = plain + "[output]\nstress_maxima = true\n";
  cache.run("none", plain);
  const json anew = cache.run("anew", asking);
  EXPECT_FALSE(notes(anew, "comes from the cache"));
  const json again = cache.run("again", asking);
  EXPECT_TRUE(notes(again, "comes from the cache"));
  EXPECT_EQ(anew["points"][0]["stress_maxima"], again["points"][0]["stress_maxima"]);
  EXPECT_TRUE(notes(cache.run("both", plain), "comes from the cache"));
  EXPECT_EQ(cache.files().size(), 1u);
  // From a stored result: the same largest stresses.
  const json stored = cache.stress("again");
  EXPECT_EQ(stored["models"][0]["maxima"].size(), 12u);
}
