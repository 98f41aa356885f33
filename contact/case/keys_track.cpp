#include "contact/case/key_builder.hpp"

namespace rollfem::contact {

SectionWithKeys track_section() {
  Keys<Track> keys("track", "The track under wheels with profiles", &Case::track);
  keys.section().of_profiles = true;
  keys.real("gauge")
      .unit("mm")
      .between(1.0, 1e4)
      .says("Distance between the rails.")
      .into(&Track::gauge);
  keys.real("gauge_height")
      .unit("mm")
      .between(0.1, 100.0)
      .says("How far below the top of the rails the gauge is measured.")
      .into(&Track::gauge_height);
  keys.choice("inclination")
      .example(R"("1:40")")
      .otherwise("required with profiles")
      .says(
          "How far the rails lean towards the middle of the track; `none` also where the rail's "
          "profile was measured in place.")
      .into(&Track::inclination, {{"none", 0.0}, {"1:20", 1.0 / 20.0}, {"1:40", 1.0 / 40.0}});
  return keys;
}

}  // namespace rollfem::contact
