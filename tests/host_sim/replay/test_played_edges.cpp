#include "host_sim/replay/played_edges.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_played_edges {
namespace {

base::Time at(std::int64_t seconds) { return base::Time{} + base::Duration::seconds(seconds); }

struct Played {
    std::vector<bus::SwitchEdge> edges = {{at(1), 0, true}, {at(2), 0, false}, {at(2), 1, true}, {at(5), 1, false}};
    std::size_t next = 0;
    PlayedEdges source{edges, next};
    bus::SwitchEdge out[2];

    std::size_t read(std::int64_t seconds) { return source.read(at(seconds), base::Span<bus::SwitchEdge>(out)); }
};

TEST(PlayedEdges, AreThoseUpToTheTimeInTheirOrder) {
    Played played;
    EXPECT_EQ(played.read(0), 0u);
    EXPECT_EQ(played.read(4), 2u) << "no more than there is room for";
    EXPECT_EQ(played.out[1].time.ns, at(2).ns);
    EXPECT_FALSE(played.out[1].level);
    EXPECT_EQ(played.read(4), 1u);
    EXPECT_EQ(played.out[0].line, 1);
    EXPECT_EQ(played.read(4), 0u) << "the last one is later";
    EXPECT_EQ(played.source.health(), bus::SourceHealth::running);
    EXPECT_EQ(played.read(5), 1u);
    EXPECT_EQ(played.source.health(), bus::SourceHealth::ended);
    EXPECT_EQ(played.source.statistics().edges, 4u);
}

TEST(PlayedEdges, GoOnFromAnotherPlaceAndWithOtherEdges) {
    Played played;
    EXPECT_EQ(played.read(1), 1u);
    played.edges.erase(played.edges.begin() + 1, played.edges.end());
    EXPECT_EQ(played.source.health(), bus::SourceHealth::ended);
    EXPECT_EQ(played.read(9), 0u);
    played.edges.push_back({at(3), 2, true});
    EXPECT_EQ(played.read(9), 1u);
    EXPECT_EQ(played.out[0].line, 2);
    played.next = 0;
    EXPECT_EQ(played.read(9), 2u) << "again from the first";
}

}  // namespace
}  // namespace tedavis::host_sim::test_played_edges
