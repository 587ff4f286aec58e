// The index as bytes: all that went in comes out, and every byte of it counts.
#include "host_sim/replay/flight_index.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_flight_index {
namespace {

const CheckpointSpacing kSpacing{100, 10, 8};

IndexKey key_of(std::uint64_t log) {
    IndexKey key;
    for (std::size_t n = 0; n < key.parts.size(); ++n) key.parts[n] = 10 + n;
    key.parts[IndexKey::log] = log;
    return key;
}

FlightIndex example() {
    FlightIndex index;
    index.facts.first = base::Time{1'700'000'000'000'000'001};
    index.facts.last = base::Time{1'700'000'099'999'999'999};
    index.facts.counters = {1, 2, 3, 4, 5, {6, 7, 8, 9, 10, 11}};
    index.facts.decoder.impossible_phases = 12;
    index.facts.decoder.first_impossible_phase = 99;
    index.facts.broken_lines = 6;
    index.facts.lines.other = 7;
    index.facts.lines.first_back = base::Duration{8};
    index.facts.reports = {{7, bus::LineFault::too_long}, {1ull << 40, bus::LineFault::none}};
    index.facts.interfaces = {{"can0", 13}, {"vcan1", 14}};
    index.facts.has_position = true;
    index.track = CheckpointTrack(kSpacing);
    for (std::int64_t n = 0; n < 20; ++n) {
        FlightProgress progress;
        progress.reached = base::Time{1'700'000'000'000'000'001 + n};
        progress.position.offset = static_cast<std::uint64_t>(100 * n);
        progress.next_edge = static_cast<std::size_t>(n);
        index.track.offer(progress);
    }
    index.outline = {4, {{base::Time{5}, 0.5, -0.25}, {base::Time{9}, 0.75, 3}}, {base::Time{6}, base::Time{7}, base::Time{8}}};
    return index;
}

TEST(FlightIndex, ComesBackAsItWas) {
    const FlightIndex index = example();
    const UnpackedIndex unpacked = unpack_index(pack_index(index, key_of(1)), key_of(1), kSpacing);
    ASSERT_TRUE(unpacked.index) << unpacked.refusal;
    const FlightIndex& back = *unpacked.index;
    const LogFacts& facts = back.facts;
    EXPECT_EQ(facts.first, index.facts.first);
    EXPECT_EQ(facts.last, index.facts.last);
    EXPECT_EQ(facts.counters.frames, 1u);
    EXPECT_EQ(facts.counters.decoded, 2u);
    EXPECT_EQ(facts.counters.alien, 3u);
    EXPECT_EQ(facts.counters.errors, 4u);
    EXPECT_EQ(facts.counters.dropped, 5u);
    EXPECT_EQ(facts.counters.traffic.no_room, 11u);
    EXPECT_EQ(facts.decoder.impossible_phases, 12u);
    EXPECT_EQ(facts.decoder.first_impossible_phase, 99);
    EXPECT_EQ(facts.broken_lines, 6u);
    EXPECT_EQ(facts.lines.other, 7u);
    EXPECT_EQ(facts.lines.first_back, base::Duration{8});
    ASSERT_EQ(facts.reports.size(), 2u);
    EXPECT_EQ(facts.reports[1].line, 1ull << 40);
    EXPECT_EQ(facts.reports[0].fault, bus::LineFault::too_long);
    ASSERT_EQ(facts.interfaces.size(), 2u);
    EXPECT_EQ(facts.interfaces[1].name, "vcan1");
    EXPECT_EQ(facts.interfaces[1].frames, 14u);
    EXPECT_TRUE(facts.has_position);
    EXPECT_EQ(back.outline.stride(), 4);
    ASSERT_EQ(back.outline.places().size(), 2u);
    EXPECT_EQ(back.outline.places()[1].time, base::Time{9});
    EXPECT_EQ(back.outline.places()[1].latitude_rad, 0.75);
    EXPECT_EQ(back.outline.places()[1].longitude_rad, 3);
    EXPECT_EQ(back.outline.phase_changes(), index.outline.phase_changes());
    EXPECT_EQ(back.track.stride(), index.track.stride());
    ASSERT_EQ(back.track.checkpoints().size(), index.track.checkpoints().size());
    for (std::size_t n = 0; n < back.track.checkpoints().size(); ++n) {
        const base::Time reached = index.track.checkpoints()[n].reached;
        EXPECT_EQ(back.track.checkpoints()[n].reached, reached);
        EXPECT_EQ(back.track.unpack(reached).next_edge, index.track.unpack(reached).next_edge);
    }
}

TEST(FlightIndex, IsRefusedWithAnotherKey) {
    const UnpackedIndex unpacked = unpack_index(pack_index(example(), key_of(1)), key_of(2), kSpacing);
    EXPECT_FALSE(unpacked.index);
    EXPECT_EQ(unpacked.refusal, "was made when the log was another");
}

TEST(FlightIndex, IsRefusedCutOffAnywhere) {
    const std::string whole = pack_index(example(), key_of(1));
    for (std::size_t size = 0; size < whole.size(); size += size < 400 ? 1 : 37)
        ASSERT_FALSE(unpack_index(std::string_view(whole).substr(0, size), key_of(1), kSpacing).index) << size;
    EXPECT_FALSE(unpack_index(whole + "x", key_of(1), kSpacing).index);
    EXPECT_TRUE(unpack_index(whole, key_of(1), kSpacing).index);
}

TEST(FlightIndex, IsRefusedWithAnyBitFlipped) {
    const std::string whole = pack_index(example(), key_of(1));
    for (std::size_t n = 0; n < whole.size(); n += n < 400 ? 1 : 101) {
        std::string flipped = whole;
        flipped[n] = static_cast<char>(flipped[n] ^ (1 << (n % 8)));
        ASSERT_FALSE(unpack_index(flipped, key_of(1), kSpacing).index) << n;
    }
}

TEST(FlightIndex, OtherFilesAreNone) {
    for (const char* bytes : {"", "TEDAVIS", "(1700000000.000000) can0 137#0902000000000000\n"})
        EXPECT_EQ(unpack_index(bytes, key_of(1), kSpacing).refusal, "is no index of this program version");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_index
