#include "render_core/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>

#include "render_core/base/hash.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::scene::test_scene_reader {
namespace {

using Bytes = std::vector<std::uint8_t>;

SdbFailure read(const Bytes& bytes, bool fails = false) {
    test_support::FlakyBytes source(bytes);
    source.fails = fails;
    Bytes memory(1 << 16);
    base::Arena arena(memory.data(), memory.size());
    SceneHeader header{};
    base::Span<const Layer> layers;
    return SceneReader(source, arena).read(header, layers);
}

Bytes small() { return host_sim::sdb_bytes(test_support::small_scene()); }

SceneHeader& header_of(Bytes& bytes) { return *reinterpret_cast<SceneHeader*>(bytes.data()); }
LayerEntry& layer_of(Bytes& bytes, std::size_t n) {
    return reinterpret_cast<LayerEntry*>(bytes.data() + header_of(bytes).table_offset)[n];
}
AttributeEntry& attribute_of(Bytes& bytes, std::size_t n) {
    return reinterpret_cast<AttributeEntry*>(bytes.data() + header_of(bytes).table_offset +
                                             header_of(bytes).layer_count * sizeof(LayerEntry))[n];
}

/// As whoever changes a file on purpose would: all checksums fit again.
void seal(Bytes& bytes) {
    SceneHeader& h = header_of(bytes);
    const auto seal_part = [&bytes](ScenePart& part) {
        if (part.bytes > 0 && part.offset <= bytes.size() && part.bytes <= bytes.size() - part.offset)
            part.crc = base::crc32(&bytes[part.offset], part.bytes);
    };
    for (std::size_t n = 0; n < h.layer_count; ++n) {
        LayerEntry& e = layer_of(bytes, n);
        for (ScenePart* part : {&e.points, &e.starts, &e.levels, &e.times, &e.names, &e.vertices, &e.triangles}) seal_part(*part);
    }
    for (std::size_t n = 0; n < h.attribute_count; ++n) {
        AttributeEntry& e = attribute_of(bytes, n);
        for (ScenePart* part : {&e.values, &e.uncertainties, &e.states, &e.classes}) seal_part(*part);
    }
    h.table_crc = base::crc32(bytes.data() + h.table_offset,
                              h.layer_count * sizeof(LayerEntry) + h.attribute_count * sizeof(AttributeEntry));
    h.header_crc = base::crc32(&h, offsetof(SceneHeader, header_crc));
}

template <class T>
T& at(Bytes& bytes, const ScenePart& part, std::size_t n) {
    return reinterpret_cast<T*>(&bytes[part.offset])[n];
}

TEST(SceneReader, EveryFlippedBitIsFound) {
    const Bytes whole = small();
    ASSERT_EQ(read(whole).error, SdbError::none);
    std::size_t padding = 0;
    for (std::size_t n = 0; n < whole.size(); ++n) {
        Bytes bytes = whole;
        bytes[n] = static_cast<std::uint8_t>(bytes[n] ^ (1u << n % 8));
        padding += read(bytes).error == SdbError::none ? 1 : 0;
    }
    EXPECT_LT(padding, 8 * 20u) << "only what fills up parts to multiples of eight may change";
}

TEST(SceneReader, EveryCutIsFound) {
    const Bytes whole = small();
    for (std::size_t size = 0; size < whole.size(); size += 13)
        EXPECT_NE(read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))).error, SdbError::none) << size;
    Bytes longer = whole;
    longer.push_back(0);
    EXPECT_EQ(read(longer).error, SdbError::truncated);
}

TEST(SceneReader, OtherFilesAndOtherVersionsAreTold) {
    EXPECT_EQ(read({}).error, SdbError::not_an_sdb);
    EXPECT_EQ(read(Bytes(1000, 'x')).error, SdbError::not_an_sdb);
    EXPECT_EQ(read(small(), true).error, SdbError::unreadable);
    Bytes bytes = small();
    header_of(bytes).version = kSdbVersion + 1;
    seal(bytes);
    EXPECT_EQ(read(bytes).error, SdbError::wrong_version);
}

struct Forgery {
    const char* what;
    std::function<void(Bytes&)> change;
};

/// Whatever a file says with checksums that fit is looked at all the same.
TEST(SceneReader, NothingOutOfRangeIsTaken) {
    const float nan = std::nanf("");
    const Forgery forgeries[] = {
        {"shape", [](Bytes& b) { layer_of(b, 0).shape = static_cast<LayerShape>(9); }},
        {"role", [](Bytes& b) { layer_of(b, 1).role = LayerRole::count; }},
        {"datum", [](Bytes& b) { layer_of(b, 1).height_datum = static_cast<HeightDatum>(3); }},
        {"name without end", [](Bytes& b) { std::memset(layer_of(b, 0).name, 'a', sizeof(LayerEntry::name)); }},
        {"two of a name", [](Bytes& b) { std::memcpy(layer_of(b, 1).name, layer_of(b, 0).name, sizeof(LayerEntry::name)); }},
        {"validity runs back", [](Bytes& b) { layer_of(b, 0).valid_until_ns = INT64_MIN, layer_of(b, 0).valid_from_ns = 0; }},
        {"attributes beyond the table", [](Bytes& b) { layer_of(b, 0).first_attribute = 0xFFFFFFFFu; }},
        {"no columns", [](Bytes& b) { layer_of(b, 0).grid.columns = 0; }},
        {"posts overflow", [](Bytes& b) { layer_of(b, 0).grid.columns = layer_of(b, 0).grid.rows = 0xFFFFFFFFu; }},
        {"step of none", [](Bytes& b) { layer_of(b, 0).grid.step_lat_rad = 0; }},
        {"step is NaN", [](Bytes& b) { layer_of(b, 0).grid.step_lon_rad = std::nan(""); }},
        {"beyond the pole", [](Bytes& b) { layer_of(b, 0).grid.north_rad = 2; }},
        {"levels fall", [](Bytes& b) { at<float>(b, layer_of(b, 0).levels, 1) = 0; }},
        {"times stand still", [](Bytes& b) { at<std::int64_t>(b, layer_of(b, 0).times, 1) = 0; }},
        {"latitude is NaN", [](Bytes& b) { at<ScenePoint>(b, layer_of(b, 1).points, 0).latitude_rad = std::nan(""); }},
        {"longitude in degrees", [](Bytes& b) { at<ScenePoint>(b, layer_of(b, 1).points, 2).longitude_rad = 9.8; }},
        {"above the sky", [](Bytes& b) { at<ScenePoint>(b, layer_of(b, 1).points, 0).height_m = 1e9F; }},
        {"names run on", [](Bytes& b) { at<char>(b, layer_of(b, 1).names, kNameBytes - 1) = 'x'; }},
        {"runs fall", [](Bytes& b) { at<std::uint32_t>(b, layer_of(b, 2).starts, 1) = 8; }},
        {"an area of two points", [](Bytes& b) { at<std::uint32_t>(b, layer_of(b, 2).starts, 1) = 2; }},
        {"runs end early", [](Bytes& b) { at<std::uint32_t>(b, layer_of(b, 2).starts, 2) = 6; }},
        {"triangle without vertex", [](Bytes& b) { at<std::uint16_t>(b, layer_of(b, 3).triangles, 4) = 4; }},
        {"vertex is NaN", [nan](Bytes& b) { at<ModelVertex>(b, layer_of(b, 3).vertices, 1).place_m[2] = nan; }},
        {"attribute without a name", [](Bytes& b) { attribute_of(b, 0).name[0] = 0; }},
        {"scale", [](Bytes& b) { attribute_of(b, 0).scale = static_cast<AttributeScale>(3); }},
        {"limits are NaN", [nan](Bytes& b) { attribute_of(b, 0).minimum = nan; }},
        {"limits too narrow", [](Bytes& b) { attribute_of(b, 0).maximum = 300; }},
        {"class beyond all", [](Bytes& b) { at<float>(b, attribute_of(b, 1).values, 0) = 2; }},
        {"half a class", [](Bytes& b) { at<float>(b, attribute_of(b, 1).values, 0) = 0.5F; }},
        {"infinite value", [](Bytes& b) { at<float>(b, attribute_of(b, 0).values, 0) = INFINITY; }},
        {"state", [](Bytes& b) { at<std::uint8_t>(b, attribute_of(b, 0).states, 0) = 3; }},
        {"too few values", [](Bytes& b) { attribute_of(b, 0).value_count = 47; }},
        {"part beyond the file", [](Bytes& b) { attribute_of(b, 0).values.offset = b.size() - 4; }},
        {"part wraps round", [](Bytes& b) { attribute_of(b, 0).values.offset = UINT64_MAX - 8; }},
        {"part too long", [](Bytes& b) { attribute_of(b, 0).values.bytes += 4; }},
        {"growth is NaN", [nan](Bytes& b) { attribute_of(b, 0).uncertainty_growth_per_hour = nan; }},
        {"kind of uncertainty", [](Bytes& b) { attribute_of(b, 0).uncertainty_kind = static_cast<UncertaintyKind>(9); }},
        {"more layers than there is room for", [](Bytes& b) { header_of(b).layer_count = kMaxLayers + 1; }},
        {"table beyond the file", [](Bytes& b) { header_of(b).table_offset = b.size() - 8; }},
    };
    for (const Forgery& forgery : forgeries) {
        Bytes bytes = small();
        forgery.change(bytes);
        const bool whole_table =
            header_of(bytes).layer_count <= kMaxLayers && header_of(bytes).table_offset == sizeof(SceneHeader);
        if (whole_table)
            seal(bytes);
        else
            header_of(bytes).header_crc = base::crc32(bytes.data(), offsetof(SceneHeader, header_crc));
        EXPECT_EQ(read(bytes).error, SdbError::damaged) << forgery.what;
    }
    Bytes untouched = small();
    seal(untouched);
    EXPECT_EQ(read(untouched).error, SdbError::none);
}

Bytes ensemble() {
    host_sim::SceneDraft draft = test_support::small_scene();
    draft.layers[0] = test_support::small_ensemble();
    return host_sim::sdb_bytes(draft);
}

TEST(SceneReader, MembersAreVerifiedAsValuesAre) {
    const Forgery forgeries[] = {
        {"one member", [](Bytes& b) { attribute_of(b, 0).member_count = 1; }},
        {"one too many", [](Bytes& b) { attribute_of(b, 0).member_count = 4; }},
        {"more than ever", [](Bytes& b) { attribute_of(b, 0).member_count = 17; }},
        {"members without a count", [](Bytes& b) { attribute_of(b, 0).member_count = 0; }},
        {"a count without members", [](Bytes& b) { attribute_of(b, 0).members = {}; }},
        {"of classes", [](Bytes& b) { attribute_of(b, 1).member_count = 2; }},
        {"infinite", [](Bytes& b) { at<float>(b, attribute_of(b, 0).members, 0) = INFINITY; }},
        {"beyond the limits", [](Bytes& b) { at<float>(b, attribute_of(b, 0).members, 143) = 400; }},
        {"flipped",
         [](Bytes& b) {
             b[attribute_of(b, 0).members.offset] = static_cast<std::uint8_t>(b[attribute_of(b, 0).members.offset] ^ 1u);
         }},
    };
    for (const Forgery& forgery : forgeries) {
        Bytes bytes = ensemble();
        forgery.change(bytes);
        if (forgery.what != std::string("flipped")) seal(bytes);
        EXPECT_EQ(read(bytes).error, SdbError::damaged) << forgery.what;
    }
    Bytes untouched = ensemble();
    seal(untouched);
    EXPECT_EQ(read(untouched).error, SdbError::none);
}

}  // namespace
}  // namespace tedavis::scene::test_scene_reader
