// SPDX-License-Identifier: LGPL-2.1-or-later
// Structs of results list all their members, so that no file, record or check misses one.
#include "base/members.hpp"

#include "result/patch_size.hpp"
#include "result/quantities.hpp"
#include "result/rigid_wheelset.hpp"
#include "result/write/output.hpp"

#include "support/test.hpp"

namespace rollfem::testing {
namespace {

/// Whether the list, in the order of the declarations, fills the struct: none is forgotten.
template <class Whole>
constexpr bool lists_all_members() {
  std::size_t end = 0;
  const auto follow = [&](std::size_t size, std::size_t alignment) {
    end = (end + alignment - 1) / alignment * alignment + size;
  };
  const auto add = [&](const auto& each) {
    if constexpr (std::is_member_object_pointer_v<decltype(each.part)>) {
      using Part = std::remove_reference_t<decltype(std::declval<Whole&>().*each.part)>;
      follow(sizeof(Part), alignof(Part));
    }
  };
  std::apply([&](const auto&... each) { (add(each), ...); }, Whole::members());
  follow(0, alignof(Whole));
  return end == sizeof(Whole);
}

struct Forgetful {
  double listed = 0.0, forgotten = 0.0;
  static constexpr auto members() {
    return std::tuple(contact::member("listed", &Forgetful::listed));
  }
};

TEST(Members, NoneIsForgotten) {
  static_assert(!lists_all_members<Forgetful>());
  static_assert(lists_all_members<contact::ContactPlace>());
  static_assert(lists_all_members<contact::SubsurfaceField>());
  static_assert(lists_all_members<contact::StressMaximum>());
  static_assert(lists_all_members<contact::YieldedSection>());
  static_assert(lists_all_members<contact::BodyValues>());
  static_assert(lists_all_members<contact::BodyField>());
  static_assert(lists_all_members<contact::ProfileRows>());
  static_assert(lists_all_members<contact::ModelResult>());
  static_assert(lists_all_members<contact::PatchPart>());
  static_assert(lists_all_members<contact::RigidWheelset>());
  static_assert(lists_all_members<result::Provenance>());
  static_assert(lists_all_members<result::PlacedPair>());
}

TEST(Members, TheFieldsOfALoadPointAreAllInTheirTable) {
  // All but the state of the elements.
  EXPECT_EQ(contact::point_fields().size() * sizeof(contact::Field) +
                sizeof(contact::ContactFields::state),
            sizeof(contact::ContactFields));
}

}  // namespace
}  // namespace rollfem::testing
