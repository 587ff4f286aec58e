#include "host_sim/terrain_builder/terrain_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>

#include "render_core/base/hash.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/support/terrain/draped_database.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_terrain_check {
namespace {

using terrain::ChunkEntry;
using terrain::ChunkVertex;
using terrain::DirectoryPage;
using terrain::FileHeader;
using test_support::expect_user_error;
using ::testing::HasSubstr;

const Raster& raster() {
    static const Raster made = test_support::make_rough_raster(200, 97);
    return made;
}

/// A database that somebody damages and then signs anew, so that no checksum tells.
class Forgery {
public:
    Forgery() : Forgery(sound()) {}
    explicit Forgery(std::vector<std::uint8_t> database) : bytes_(std::move(database)) {
        test_support::for_entries(bytes_, [this](const ChunkEntry&, std::uint64_t page) {
            if (pages_.empty() || pages_.back() != page) pages_.push_back(page);
        });
    }

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
    /// The n-th chunk of the first row of a level.
    [[nodiscard]] std::size_t entry_at(std::uint32_t level, std::size_t n = 0) const {
        for (const std::uint64_t page : pages_)
            if (read<ChunkEntry>(page + offsetof(DirectoryPage, entries)).level == level)
                return page + offsetof(DirectoryPage, entries) + n * sizeof(ChunkEntry);
        return 0;
    }
    [[nodiscard]] ChunkEntry entry(std::uint32_t level, std::size_t n = 0) const { return read<ChunkEntry>(entry_at(level, n)); }

    void sign() {
        for (const std::uint64_t offset : pages_) {
            auto page = read<DirectoryPage>(offset);
            for (ChunkEntry& e : page.entries)
                for (terrain::PartPlace* part : {&e.payload, &e.attributes, &e.drape})
                    if (part->bytes != 0) part->crc = base::crc32(bytes_.data() + part->offset, part->bytes);
            page.crc = base::crc32(&page.level, sizeof page - offsetof(DirectoryPage, level));
            write(offset, page);
        }
        auto h = read<FileHeader>(0);
        h.undulation_crc = base::crc32(bytes_.data() + h.undulation_offset,
                                       std::size_t{h.undulation_columns} * h.undulation_rows * sizeof(float));
        h.header_crc = base::crc32(&h, offsetof(FileHeader, header_crc));
        write(0, h);
    }
    [[nodiscard]] TerrainCheck check(const Raster& against = raster()) const { return check(test_support::posts_of(against)); }
    [[nodiscard]] TerrainCheck check(const TerrainSources& against) const {
        const test_support::TemporaryFolder folder;
        const std::string path = folder.write("x.tdb", std::string(bytes_.begin(), bytes_.end()));
        TerrainCheck result = check_terrain(path, against, {});
        EXPECT_EQ(folder.entries(), 1u) << "work files are left behind";
        return result;
    }
    std::vector<std::uint8_t>& bytes() { return bytes_; }

private:
    static const std::vector<std::uint8_t>& sound() {
        static const std::vector<std::uint8_t> image = test_support::build_image(raster());
        return image;
    }

    std::vector<std::uint8_t> bytes_;
    std::vector<std::uint64_t> pages_;
};

TEST(TerrainCheck, ASoundDatabaseHasNoViolations) {
    const TerrainCheck check = Forgery().check();
    EXPECT_EQ(check.chunks, Forgery().read<FileHeader>(0).chunk_count);
    EXPECT_EQ(check.violations, 0u);
    EXPECT_TRUE(check.first.empty());
    EXPECT_EQ(check.worst_excess_m, 0);
}

TEST(TerrainCheck, SigningAnewChangesNothing) {
    Forgery forgery;
    const std::vector<std::uint8_t> before = forgery.bytes();
    forgery.sign();
    EXPECT_EQ(forgery.bytes(), before);
}

TEST(TerrainCheck, AVertexThatWasMovedAndSignedIsFoundAtEveryLevel) {
    for (const std::uint32_t level : {0u, 1u, 2u})
        for (const bool height : {true, false}) {
            Forgery forgery;
            const std::size_t place = forgery.entry(level).payload.offset + 7 * sizeof(ChunkVertex);
            auto vertex = forgery.read<ChunkVertex>(place);
            (height ? vertex.height_m : vertex.x) += 1.0f;
            forgery.write(place, vertex);
            forgery.sign();
            const TerrainCheck check = forgery.check();
            ASSERT_EQ(check.violations, 1u) << level;
            EXPECT_EQ(check.first[0].reason, "differs from the rasters");
            EXPECT_EQ(check.first[0].chunk, std::to_string(level) + "/0/0");
            EXPECT_NEAR(check.worst_excess_m, 1, 1e-3);
        }
}

TEST(TerrainCheck, AHeightThatIsNoNumberIsTheWorst) {
    Forgery forgery;
    forgery.write(forgery.entry(0).payload.offset + offsetof(ChunkVertex, height_m), std::nanf(""));
    forgery.sign();
    EXPECT_EQ(forgery.check().worst_excess_m, kHighestHeight_m);
}

TEST(TerrainCheck, AHeightOfTheRasterThatChangedIsFoundInEveryChunkThatShowsIt) {
    Raster other = raster();
    other.height_m[other.at(40, 50)] += 1;
    const TerrainCheck check = Forgery().check(other);
    EXPECT_GE(check.violations, 3u);
    EXPECT_GE(check.worst_excess_m, 0.99);
}

/// Posts that rise by two metres make other meshes; whatever the report says of them, heights differ by two metres.
TEST(TerrainCheck, WhereTheMeshHasOtherVerticesHeightsOfPostsAreCompared) {
    Raster other = raster();
    for (std::uint32_t j = 3; j < other.rows; j += 11)
        for (std::uint32_t i = 5; i < other.columns; i += 13) other.height_m[other.at(i, j)] += 2;
    const TerrainCheck check = Forgery().check(other);
    std::size_t other_meshes = 0;
    double worst_m = 0;
    for (const ChunkViolation& violation : check.first) {
        EXPECT_LT(violation.excess_m, 2.01) << violation.chunk << " " << violation.reason;
        if (violation.reason != "its mesh has other vertices than the rasters give") continue;
        ++other_meshes;
        worst_m = std::max(worst_m, violation.excess_m);
    }
    EXPECT_GE(other_meshes, 3u);
    EXPECT_NEAR(worst_m, 2, 0.01);
    EXPECT_NEAR(check.worst_excess_m, 2, 0.01);
}

TEST(TerrainCheck, AVertexThatWasPutOnAnotherPostIsHeldAgainstTheRasterThere) {
    Forgery forgery;
    const ChunkEntry e = forgery.entry(1);
    const std::size_t place = e.payload.offset + e.border_count * sizeof(ChunkVertex);
    auto vertex = forgery.read<ChunkVertex>(place);
    bool taken = true;
    while (taken) {  // a post that the mesh does not have
        ++vertex.i;
        taken = false;
        for (std::size_t n = 0; n < e.vertex_count; ++n) {
            const auto v = forgery.read<ChunkVertex>(e.payload.offset + n * sizeof vertex);
            taken = taken || (v.i == vertex.i && v.j == vertex.j);
        }
    }
    ASSERT_LT(vertex.i, 2 * terrain::kChunkCells);
    vertex.height_m = raster().height_m[raster().at(vertex.i, vertex.j)] - 40;
    forgery.write(place, vertex);
    forgery.sign();
    const TerrainCheck check = forgery.check();
    ASSERT_EQ(check.violations, 1u);
    EXPECT_THAT(check.first[0].reason, HasSubstr("other vertices"));
    EXPECT_NEAR(check.worst_excess_m, 40, 1e-3);
}

TEST(TerrainCheck, ErrorsStatedTooSmallAreFoundWithWhatTheyHide) {
    for (float ChunkEntry::*stated : {&ChunkEntry::above_m, &ChunkEntry::below_m, &ChunkEntry::strip_above_m,
                                      &ChunkEntry::strip_below_m, &ChunkEntry::bound_m}) {
        Forgery forgery;
        ChunkEntry e = forgery.entry(1, 1);
        const float hidden = e.*stated / 2;
        ASSERT_GT(hidden, 0);
        e.*stated -= hidden;
        forgery.write(forgery.entry_at(1, 1), e);
        forgery.sign();
        const TerrainCheck check = forgery.check();
        ASSERT_EQ(check.violations, 1u);
        EXPECT_THAT(check.first[0].reason, HasSubstr("farther from the true surface than it states"));
        EXPECT_NEAR(check.worst_excess_m, hidden, 1e-5f * hidden);
    }
}

TEST(TerrainCheck, BoxesAndCountsOfTheDirectoryAreProven) {
    Forgery forgery;
    ChunkEntry e = forgery.entry(0);
    e.half_extent_m[1] *= 0.5f;
    forgery.write(forgery.entry_at(0), e);
    forgery.sign();
    const TerrainCheck check = forgery.check();
    ASSERT_EQ(check.violations, 1u);
    EXPECT_THAT(check.first[0].reason, HasSubstr("entry in the directory"));
}

TEST(TerrainCheck, AttributesAreProven) {
    Forgery forgery;
    const std::size_t place = forgery.entry(1).attributes.offset + 1234;
    forgery.write(place, static_cast<std::uint8_t>(forgery.read<std::uint8_t>(place) ^ 1));
    forgery.sign();
    const TerrainCheck check = forgery.check();
    ASSERT_EQ(check.violations, 1u);
    EXPECT_EQ(check.first[0].chunk, "1/0/0 attributes");
}

class DrapeCheck : public ::testing::Test {
protected:
    DrapeCheck() {
        test_support::ImageFile image = test_support::image_over(raster(), 2, test_support::wavy(13));
        with_image_.drape = DrapeOptions{image.write(folder_.file("i.tif")), {}, {}};
        image.color = [](int, int) { return test_support::Rgba{1, 2, 3, 255}; };
        with_another_.drape = DrapeOptions{image.write(folder_.file("other.tif")), {}, {}};
        database_ = test_support::build_image(with_image_);
    }
    test_support::TemporaryFolder folder_;
    TerrainSources with_image_{test_support::posts_of(raster())}, with_another_{test_support::posts_of(raster())};
    std::vector<std::uint8_t> database_;
};

TEST_F(DrapeCheck, ASoundOneHoldsWithItsImageAndWithout) {
    const Forgery sound(database_);
    ASSERT_EQ(sound.read<FileHeader>(0).drape_posts, terrain::kDrapePosts);
    EXPECT_EQ(sound.check(with_image_).violations, 0u);
    EXPECT_EQ(sound.check().violations, 0u);
}

TEST_F(DrapeCheck, AChangedTexelIsFoundByItsChecksumOrByTheImage) {
    Forgery forgery(database_);
    const std::size_t place = forgery.entry(1).drape.offset + 4321;
    forgery.write(place, static_cast<std::uint8_t>(forgery.read<std::uint8_t>(place) ^ 1));
    ASSERT_EQ(forgery.check().violations, 1u);
    EXPECT_EQ(forgery.check().first[0].chunk, "1/0/0 drape");
    EXPECT_THAT(forgery.check().first[0].reason, HasSubstr("checksum does not match"));
    forgery.sign();
    EXPECT_EQ(forgery.check().violations, 0u) << "without the image nobody can tell";
    const TerrainCheck check = forgery.check(with_image_);
    ASSERT_EQ(check.violations, 1u);
    EXPECT_EQ(check.first[0].chunk, "1/0/0 drape");
    EXPECT_EQ(check.first[0].reason, "differs from the image");
}

TEST_F(DrapeCheck, AnotherImageOrNoneIsFoundInEveryPage) {
    const TerrainCheck other = Forgery(database_).check(with_another_), none = Forgery().check(with_image_);
    EXPECT_EQ(other.violations, 8u + 2 + 1) << "chunks of levels 1 to 3";
    EXPECT_EQ(other.first[0].reason, "differs from the image");
    EXPECT_EQ(none.violations, 8u + 2 + 1 + 1);
    EXPECT_EQ(none.first[0].chunk, "header");
}

TEST(TerrainCheck, TheGeoidAndTheHeaderAreProven) {
    Forgery geoid;
    const std::size_t grid = geoid.read<FileHeader>(0).undulation_offset;
    geoid.write(grid, geoid.read<float>(grid) + 1);
    geoid.sign();
    ASSERT_EQ(geoid.check().violations, 2u) << "the header names the grid's checksum";
    EXPECT_THAT(geoid.check().first[1].reason, HasSubstr("EGM96"));
    Forgery header;
    auto h = header.read<FileHeader>(0);
    h.max_height_m -= 10;
    header.write(0, h);
    header.sign();
    ASSERT_EQ(header.check().violations, 1u);
    EXPECT_EQ(header.check().first[0].chunk, "header");
}

TEST(TerrainCheck, DamageWithoutASignatureIsNamed) {
    Forgery payload, page, header;
    payload.bytes()[payload.entry(2).payload.offset + 5] ^= 8;
    ASSERT_EQ(payload.check().violations, 1u);
    EXPECT_THAT(payload.check().first[0].reason, HasSubstr("checksum does not match"));
    page.bytes()[page.entry_at(1) + offsetof(ChunkEntry, reserved1)] ^= 1;
    EXPECT_GE(page.check().violations, 1u);
    header.bytes()[offsetof(FileHeader, source)] ^= 1;
    ASSERT_EQ(header.check().violations, 1u);
    EXPECT_EQ(header.check().first[0].chunk, "header");
}

TEST(TerrainCheck, OffsetsBeyondTheFileAreFoundNotFollowed) {
    Forgery forgery;
    ChunkEntry e = forgery.entry(2);
    e.payload.offset = ~std::uint64_t{0} - 10;
    forgery.write(forgery.entry_at(2), e);
    bool found = false;
    for (const ChunkViolation& violation : forgery.check().first)
        found = found || violation.reason == "lies beyond the end of the file";
    EXPECT_TRUE(found);
}

TEST(TerrainCheck, RefusesWhatIsNoDatabaseOfTheseRasters) {
    const test_support::TemporaryFolder folder;
    const auto refuses = [&](const std::string& bytes, const Raster& against, const std::string& words) {
        const std::string path = folder.write("x.tdb", bytes);
        expect_user_error([&] { (void)check_terrain(path, test_support::posts_of(against), {}); }, words);
        EXPECT_EQ(folder.entries(), 1u);
    };
    Forgery sound;
    const std::string image(sound.bytes().begin(), sound.bytes().end());
    refuses("short", raster(), "x.tdb: is not a terrain database (offset 0); name a file");
    refuses(std::string(5000, 'x'), raster(), "x.tdb: is not a terrain database (offset 0); name a file");
    refuses(image.substr(0, image.size() / 2), raster(),
            "x.tdb: is shorter than its header says (offset " + std::to_string(image.size() / 2) + "); get a whole copy");
    std::string older = image;
    older[offsetof(FileHeader, version)] = 2;
    refuses(older, raster(), "x.tdb: was written by another version of the terrain builder (offset 8); build it again");
    refuses(image, test_support::make_rough_raster(199, 97), "was not built from these rasters");
    expect_user_error([&] { (void)check_terrain(folder.file("none.tdb"), test_support::posts_of(raster()), {}); }, "none.tdb");
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_check
