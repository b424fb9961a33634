// A segment with one number more than there is: what adding one takes is its member and its row.
#pragma once

#include "model/painting/fields.h"

namespace suffuse::test {

struct TriedSegment : Segment {
    float wetness = 0.25f;
    friend bool operator==(const TriedSegment &, const TriedSegment &) = default;
};

} // namespace suffuse::test

namespace suffuse {

template <>
struct FieldsOf<test::TriedSegment> {
    static constexpr auto list = std::tuple_cat(
        FieldsOf<Segment>::list,
        std::tuple{field("water.wetness", &test::TriedSegment::wetness,
                         {.unit = Unit::Share, .domain = share, .presence = Presence::Unusual, .since = 2})});
};

} // namespace suffuse
