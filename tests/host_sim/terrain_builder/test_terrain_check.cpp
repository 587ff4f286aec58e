#include "host_sim/terrain_builder/terrain_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>

#include "render_core/base/hash.hpp"
#include "tests/support/expect_user_error.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::ChunkEntry;
using terrain::ChunkVertex;
using terrain::FileHeader;
using test_support::expect_user_error;
using ::testing::HasSubstr;

const TerrainModel& model() {
    static const TerrainModel made = make_model(test_support::make_rough_raster(129, 97), {});
    return made;
}

/// A database that somebody damages and then signs anew, so that no checksum tells.
class Forgery {
public:
    Forgery() : bytes_(make_tdb(model(), {})) {}

    template <class T>
    T read(std::size_t offset) const {
        T value;
        std::memcpy(&value, bytes_.data() + offset, sizeof value);
        return value;
    }
    template <class T>
    void write(std::size_t offset, const T& value) {
        std::memcpy(bytes_.data() + offset, &value, sizeof value);
    }
    [[nodiscard]] static std::size_t entry_at(std::size_t n) { return sizeof(FileHeader) + n * sizeof(ChunkEntry); }
    [[nodiscard]] ChunkEntry entry(std::size_t n) const { return read<ChunkEntry>(entry_at(n)); }
    [[nodiscard]] std::size_t chunks() const { return read<FileHeader>(0).chunk_count; }

    void sign() {
        for (std::size_t n = 0; n < chunks(); ++n) {
            ChunkEntry e = entry(n);
            e.crc = base::crc32(bytes_.data() + e.offset, e.bytes);
            write(entry_at(n), e);
        }
        auto h = read<FileHeader>(0);
        h.directory_crc = base::crc32(bytes_.data() + sizeof h, chunks() * sizeof(ChunkEntry));
        h.undulation_crc = base::crc32(bytes_.data() + h.undulation_offset,
                                       std::size_t{h.undulation_columns} * h.undulation_rows * sizeof(float));
        h.header_crc = base::crc32(&h, offsetof(FileHeader, header_crc));
        write(0, h);
    }
    [[nodiscard]] TerrainCheck check() const { return check_tdb(bytes_, "x.tdb", model(), {}); }
    std::vector<std::uint8_t>& bytes() { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
};

TEST(TerrainCheck, ASoundDatabaseHasNoViolations) {
    const Forgery sound;
    const TerrainCheck check = sound.check();
    EXPECT_EQ(check.chunks, sound.chunks());
    EXPECT_TRUE(check.violations.empty());
    EXPECT_EQ(check.worst_excess_m, 0);
}

TEST(TerrainCheck, SigningAnewChangesNothing) {
    Forgery forgery;
    const std::vector<std::uint8_t> before = forgery.bytes();
    forgery.sign();
    EXPECT_EQ(forgery.bytes(), before);
}

TEST(TerrainCheck, AVertexThatWasMovedAndSignedIsFound) {
    for (const bool height : {true, false}) {
        Forgery forgery;
        const std::size_t chunk = forgery.chunks() - 1, place = forgery.entry(chunk).offset + 7 * sizeof(ChunkVertex);
        auto vertex = forgery.read<ChunkVertex>(place);
        (height ? vertex.height_m : vertex.x) += 12.5f;
        forgery.write(place, vertex);
        forgery.sign();
        const TerrainCheck check = forgery.check();
        ASSERT_EQ(check.violations.size(), 1u);
        EXPECT_EQ(check.violations[0].reason, "differs from the rasters");
        EXPECT_NEAR(check.worst_excess_m, 12.5, 1e-3);
    }
}

TEST(TerrainCheck, TheWorstOfSeveralIsReported) {
    Forgery forgery;
    for (const std::size_t chunk : {std::size_t{0}, std::size_t{2}, std::size_t{5}}) {
        const ChunkEntry e = forgery.entry(chunk);
        ASSERT_EQ(e.level, 0);
        const std::size_t post = e.offset + e.bytes - terrain::kLeafPostBytes + 100 * sizeof(float);
        forgery.write(post, forgery.read<float>(post) - static_cast<float>(3 * (chunk + 1)));
    }
    forgery.sign();
    const TerrainCheck check = forgery.check();
    EXPECT_EQ(check.violations.size(), 3u);
    EXPECT_NEAR(check.worst_excess_m, 18, 1e-3);
}

TEST(TerrainCheck, AHeightThatIsNoNumberIsTheWorst) {
    Forgery forgery;
    const ChunkEntry e = forgery.entry(1);
    forgery.write(e.offset + e.bytes - terrain::kLeafPostBytes, std::nanf(""));
    forgery.sign();
    EXPECT_EQ(forgery.check().worst_excess_m, kHighestHeight_m);
}

TEST(TerrainCheck, AnErrorStatedTooSmallIsFoundWithWhatItHides) {
    Forgery forgery;
    const std::size_t chunk = forgery.chunks() - 1;
    ChunkEntry e = forgery.entry(chunk);
    const float hidden = e.below_m / 2;
    ASSERT_GT(hidden, 0);
    e.below_m -= hidden;
    forgery.write(Forgery::entry_at(chunk), e);
    forgery.sign();
    const TerrainCheck check = forgery.check();
    ASSERT_EQ(check.violations.size(), 1u);
    EXPECT_THAT(check.violations[0].reason, HasSubstr("farther from the true surface than it states"));
    EXPECT_NEAR(check.worst_excess_m, hidden, 1e-6);
}

TEST(TerrainCheck, BoxesAndCountsOfTheDirectoryAreProven) {
    Forgery forgery;
    ChunkEntry e = forgery.entry(3);
    e.half_extent_m[1] *= 0.5f;
    forgery.write(Forgery::entry_at(3), e);
    forgery.sign();
    const TerrainCheck check = forgery.check();
    ASSERT_EQ(check.violations.size(), 1u);
    EXPECT_THAT(check.violations[0].reason, HasSubstr("entry in the directory"));
}

TEST(TerrainCheck, TheGeoidAndTheHeaderAreProven) {
    Forgery geoid;
    const std::size_t grid = geoid.read<FileHeader>(0).undulation_offset;
    geoid.write(grid, geoid.read<float>(grid) + 1);
    geoid.sign();
    ASSERT_FALSE(geoid.check().violations.empty());
    EXPECT_THAT(geoid.check().violations.back().reason, HasSubstr("EGM96"));
    Forgery header;
    auto h = header.read<FileHeader>(0);
    h.max_height_m += 100;
    header.write(0, h);
    header.sign();
    ASSERT_EQ(header.check().violations.size(), 1u);
    EXPECT_EQ(header.check().violations[0].chunk, "header");
}

TEST(TerrainCheck, EveryFlippedBitIsFound) {
    const Forgery sound;
    for (std::size_t position = 0; position < Forgery().bytes().size(); position += 4099) {
        Forgery forgery;
        forgery.bytes()[position] ^= static_cast<std::uint8_t>(1u << (position % 8));
        bool found = false;
        try {
            found = !forgery.check().violations.empty();
        } catch (const UserError&) {
            found = true;
        }
        EXPECT_TRUE(found) << "bit at byte " << position;
    }
}

TEST(TerrainCheck, OffsetsBeyondTheFileAreFoundNotFollowed) {
    Forgery forgery;
    ChunkEntry e = forgery.entry(2);
    e.offset = ~std::uint64_t{0} - 10;
    forgery.write(Forgery::entry_at(2), e);
    bool found = false;
    for (const ChunkViolation& violation : forgery.check().violations)
        found = found || violation.reason == "lies beyond the end of the file";
    EXPECT_TRUE(found);
}

TEST(TerrainCheck, RefusesWhatIsNoDatabaseOfTheseRasters) {
    const auto refused = [](const std::vector<std::uint8_t>& bytes, const TerrainModel& of, const std::string& words) {
        expect_user_error([&] { (void)check_tdb(bytes, "x.tdb", of, {}); }, words);
    };
    Forgery forgery;
    refused({}, model(), "x.tdb: not a terrain database");
    refused(std::vector<std::uint8_t>(1000, 'x'), model(), "not a terrain database of this version");
    std::vector<std::uint8_t> cut = forgery.bytes();
    cut.resize(sizeof(FileHeader) + 50);
    refused(cut, model(), "offset 442: the file ends here, but its header says");
    cut[offsetof(FileHeader, header_crc)] ^= 1u;  // then its size cannot be believed either
    refused(cut, model(), "offset 442: the file ends inside its directory");
    refused(forgery.bytes(), make_model(test_support::make_rough_raster(129, 98), {}), "was not built from these rasters");
    const TerrainCheck other =
        check_tdb(forgery.bytes(), "x.tdb", make_model(test_support::make_rough_raster(129, 97, 2), {}), {});
    EXPECT_FALSE(other.violations.empty()) << "the same lattice with other heights";
}

}  // namespace
}  // namespace tedavis::host_sim
