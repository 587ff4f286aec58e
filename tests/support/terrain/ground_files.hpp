/// Databases for tests of what the tracer reads of them: rough, with voids, sea and coarser exact chunks; and a heights query.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "render_core/base/units.hpp"
#include "render_core/raytrace/ground/ground_reader.hpp"
#include "render_core/terrain/height_query.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::test_support {

inline TdbSpec rough_file(std::uint32_t columns, std::uint32_t rows) {
    TdbSpec spec;
    spec.columns = columns;
    spec.rows = rows;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return 800 + 300 * std::sin(i * 0.11) * std::cos(j * 0.07) + 40 * std::sin(i * 2.3 + j);
    };
    spec.measured = false;
    return spec;
}

/// 257 x 257; coarser in the middle of the north, and finest in the rest. With voids where asked for.
inline TdbSpec mixed_file(bool has_voids) {
    TdbSpec spec = rough_file(257, 257);
    spec.is_exact = [](const terrain::ChunkKey& key) {
        return (key.level == 2 && key.i == 1 && key.j == 0) || (key.level == 1 && key.i == 0 && key.j == 0);
    };
    if (has_voids)
        spec.post_class = [](std::uint32_t i, std::uint32_t j) {
            const bool is_void = (i == 140 && j == 80) || (i % 41 == 0 && j % 37 == 20) || (i > 200 && i < 215 && j > 210);
            return is_void ? terrain::PostClass::void_ : terrain::PostClass::land;
        };
    return spec;
}

/// A file in memory that can be damaged and fail between reads. Any thread may read.
class FailingBytes final : public base::ByteSource {
public:
    explicit FailingBytes(std::vector<std::uint8_t> bytes) : content(std::move(bytes)) {}
    [[nodiscard]] std::uint64_t size() const override { return content.size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        return !fails && MemoryBytes(content).read(offset, destination, count);
    }
    std::vector<std::uint8_t> content;
    bool fails = false;
};

/// Such a file, opened.
struct OpenedGround {
    explicit OpenedGround(const TdbSpec& spec) : tdb(spec), bytes(tdb.bytes), database(open()) {
        base::Arena arena(query_memory.data(), query_memory.size());
        EXPECT_TRUE(query.start(database, arena));
    }
    OpenedGround(const OpenedGround&) = delete;
    OpenedGround& operator=(const OpenedGround&) = delete;

    terrain::TerrainDatabase open() {
        base::Arena arena(table.data(), table.size());
        return terrain::TerrainDatabase::open(bytes, arena).value();
    }
    [[nodiscard]] terrain::PostRange all() const {
        return {0, 0, database.lattice().columns() - 1, database.lattice().rows() - 1};
    }
    /// Of the query at a place in lattice coordinates, off the rows at poles.
    terrain::HeightAnswer ask(double i, double j) {
        const terrain::Lattice& lattice = database.lattice();
        const auto row = static_cast<std::uint32_t>(std::min(std::floor(j), lattice.rows() - 2.0));
        const double north = lattice.latitude_rad(row), south = lattice.latitude_rad(row + 1);
        return query.at(north + (south - north) * (j - row),
                        base::radians(database.header().west_deg + i * database.header().step_lon_deg));
    }

    WrittenTdb tdb;
    FailingBytes bytes;
    std::vector<std::uint8_t> table = std::vector<std::uint8_t>(1 << 17);
    terrain::TerrainDatabase database;
    std::vector<std::uint8_t> query_memory = std::vector<std::uint8_t>(terrain::HeightQuery::bytes_needed());
    terrain::HeightQuery query;
};

template <class Height>
struct ReadGround {
    ReadGround(const terrain::TerrainDatabase& database, const terrain::PostRange& posts, double step_m, base::Workers& workers,
               std::uint32_t desks)
        : memory(raytrace::GroundReader::bytes_needed(desks) / 8 + 1) {
        window.window = posts;
        window.step_m = step_m;
        heights.resize(std::size_t{window.columns()} * window.rows());
        window.posts = heights;
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(reader.start(database, desks, arena));
        reading = reader.read(window, workers);
    }
    ReadGround(const ReadGround&) = delete;
    ReadGround& operator=(const ReadGround&) = delete;
    [[nodiscard]] Height at(std::uint32_t i, std::uint32_t j) const {
        return window.grid().at(i - window.window.i0, j - window.window.j0);
    }

    std::vector<std::uint64_t> memory;
    std::vector<Height> heights;
    raytrace::GroundWindow<Height> window;
    raytrace::GroundReader reader;
    raytrace::GroundReading reading;
};

}  // namespace tedavis::test_support
