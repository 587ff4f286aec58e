#include "render_core/terrain/chunk_payload.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_chunk_payload {
namespace {

using test_support::TdbSpec;
using test_support::WrittenTdb;

const WrittenTdb& written() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = 100;
        spec.rows = 81;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 900 + 100 * std::sin(i * 0.3) * std::cos(j * 0.2); };
        return spec;
    }());
    return tdb;
}

struct Payload {
    explicit Payload(const ChunkKey& key) : entry(written().entry(key)), words(entry.payload.bytes / 4 + 1) {
        std::memcpy(words.data(), written().bytes.data() + entry.payload.offset, entry.payload.bytes);
    }
    ChunkVertex* vertices() { return reinterpret_cast<ChunkVertex*>(words.data()); }
    std::uint16_t* indices() { return reinterpret_cast<std::uint16_t*>(vertices() + entry.vertex_count); }
    base::Span<const std::uint8_t> bytes() const {
        return {reinterpret_cast<const std::uint8_t*>(words.data()), words.size() * 4};
    }
    bool holds() const { return payload_holds(written().lattice(), entry, bytes()); }
    ChunkEntry entry;
    std::vector<std::uint32_t> words;
};

TEST(ChunkPayload, WhatWasWrittenHolds) {
    for (const ChunkKey& key : written().keys()) {
        const Payload payload(key);
        EXPECT_TRUE(payload.holds()) << key.level << "/" << key.i << "/" << key.j;
        EXPECT_EQ(payload_vertices(payload.entry, payload.bytes()).size(), payload.entry.vertex_count);
        EXPECT_EQ(payload_indices(payload.entry, payload.bytes()).size(),
                  key.level == 0 ? 0u : std::size_t{payload.entry.triangle_count} * 3);
    }
}

TEST(ChunkPayload, WhatCannotBeDrawnDoesNot) {
    const float nan = std::nanf("");
    const std::function<void(Payload&)> any[] = {
        [&](Payload& p) { p.vertices()[40].x = nan; },
        [](Payload& p) { p.vertices()[40].z = INFINITY; },
        [](Payload& p) { p.vertices()[40].y += 3 * p.entry.half_extent_m[0] + 3 * p.entry.half_extent_m[1] + 100; },
        [&](Payload& p) { p.vertices()[40].height_m = nan; },
        [](Payload& p) { p.vertices()[40].kind |= 0x40; },
        [](Payload& p) { p.vertices()[40].kind = 3; },
        [](Payload& p) { p.vertices()[p.entry.border_count].kind |= 4; },
        [](Payload& p) { p.vertices()[0].kind = 0; },
        [](Payload& p) { p.vertices()[p.entry.border_count].i = 0; },
        [](Payload& p) { p.vertices()[p.entry.border_count].i = 0xFFFF; },
        [](Payload& p) { std::swap(p.vertices()[3], p.vertices()[4]); },
        [](Payload& p) { p.vertices()[3].j = 1; },
    };
    const std::function<void(Payload&)> with_indices[] = {
        [](Payload& p) { p.indices()[77] = p.entry.vertex_count; },
        [](Payload& p) { p.indices()[1] = p.indices()[0]; },
        [](Payload& p) { std::swap(p.indices()[30], p.indices()[31]); },
        [](Payload& p) { std::memcpy(p.indices(), p.indices() + 3 * (p.entry.triangle_count - 1), 6); },
        [](Payload& p) { --p.entry.strip_count; },
        [](Payload& p) { ++p.entry.strip_count; },
    };
    int n = 0;
    for (const auto& change : any) {
        for (const ChunkKey& key : {ChunkKey{0, 1, 1}, ChunkKey{1, 0, 0}}) {
            Payload payload(key);
            change(payload);
            EXPECT_FALSE(payload.holds()) << "change " << n << ", level " << key.level;
        }
        ++n;
    }
    n = 0;
    for (const auto& change : with_indices) {
        Payload payload({1, 0, 0});
        change(payload);
        EXPECT_FALSE(payload.holds()) << "indices, change " << n;
        ++n;
    }
    Payload moved({0, 1, 1});
    std::swap(moved.vertices()[moved.entry.border_count], moved.vertices()[moved.entry.border_count + 1]);
    EXPECT_FALSE(moved.holds()) << "posts of a regular chunk out of order";
}

}  // namespace
}  // namespace tedavis::terrain::test_chunk_payload
