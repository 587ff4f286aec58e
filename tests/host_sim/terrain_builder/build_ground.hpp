/// The stages of a terrain build up to its chunks, for tests of single parts: plan, posts, border lines, slopes.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/border_lines.hpp"
#include "host_sim/terrain_builder/coarse_chunks.hpp"
#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/slope_map.hpp"
#include "host_sim/terrain_builder/surface_heights.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/lattice_windows.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_support {

/// Keeps parts in memory, by the place that a database would give them.
class MemoryStore final : public host_sim::PartStore {
public:
    void put(host_sim::ChunkPart, const terrain::ChunkKey& key, const terrain::PartPlace& place,
             base::Span<const std::uint8_t> bytes) override {
        parts[place.offset].assign(bytes.begin(), bytes.end());
        keys.push_back(key);
    }
    void get(const terrain::PartPlace& place, std::uint8_t* bytes) const override {
        const std::vector<std::uint8_t>& part = parts.at(place.offset);
        std::copy(part.begin(), part.end(), bytes);
    }

    std::map<std::uint64_t, std::vector<std::uint8_t>> parts;
    std::vector<terrain::ChunkKey> keys;
};

struct BuildGround {
    TemporaryFolder folder;
    host_sim::Raster raster;
    host_sim::PostReaderFactory open = posts_of(raster);
    host_sim::BuildPlan plan;
    host_sim::InsetCoverage coverage;
    host_sim::TdbLayout layout;
    host_sim::PostsFile posts;
    host_sim::BorderLines lines;
    host_sim::SlopeMap slopes;
    MemoryStore store;
    host_sim::EntriesFile entries;
    host_sim::ChunkSources sources{plan, layout, posts, lines, slopes, store};
    host_sim::PostStatistics statistics;

    explicit BuildGround(host_sim::Raster source)
        : raster(std::move(source)),
          plan(host_sim::make_build_plan(open()->grid(), {})),
          layout(plan, plan.lattice, coverage),
          posts(folder.file("posts"), plan.header.columns, plan.header.rows, plan.lattice.is_closed()),
          lines(plan, folder.path()),
          slopes(plan, folder.file("slopes")),
          entries(folder.file("entries"), plan.lattice) {
        host_sim::PostImport import(plan, open, posts);
        for (std::uint32_t block = 0; block < import.block_count(); ++block) statistics.include(import.import(block));
        host_sim::make_pole_rows(plan, posts);
        for (std::uint32_t piece = 0; piece < lines.piece_count(); ++piece) lines.build_piece(posts, piece);
        for (std::uint32_t unit = 0; unit < plan.unit_count(); ++unit) slopes.measure(posts, unit);
    }
    BuildGround(const BuildGround&) = delete;
    BuildGround& operator=(const BuildGround&) = delete;

    /// With surface; may reach beyond the lattice.
    [[nodiscard]] host_sim::LatticeWindow window(std::int64_t i, std::int64_t j, std::uint32_t columns,
                                                 std::uint32_t rows) const {
        host_sim::LatticeWindow w = window_of(i, j, columns, rows);
        posts.read(w);
        host_sim::add_undulation(plan, w);
        return w;
    }
    [[nodiscard]] host_sim::LatticeWindow all() const { return window(-1, -1, plan.header.columns + 2, plan.header.rows + 2); }

    /// All chunks of the units, their payloads in the store.
    void build_units() {
        std::uint64_t end = layout.open_parts;
        for (std::uint32_t unit = 0; unit < plan.unit_count(); ++unit) {
            host_sim::FineUnit made = host_sim::build_fine_unit(sources, unit);
            for (const terrain::ChunkEntry& entry : made.regular) entries.write(entry);
            for (host_sim::IrregularChunk& chunk : made.irregular) end = append(chunk, end);
        }
        end_of_units = end;
    }
    std::uint64_t append(host_sim::IrregularChunk& chunk, std::uint64_t end) {
        chunk.entry.payload.offset = end;
        store.put(host_sim::ChunkPart::irregular, terrain::key_of(chunk.entry), chunk.entry.payload,
                  {chunk.payload.data(), chunk.payload.size()});
        entries.write(chunk.entry);
        return end + chunk.payload.size();
    }
    std::uint64_t end_of_units = 0;
};

/// A raster round the Earth with heights that repeat a few times.
inline host_sim::Raster make_earth_raster(double step_deg) {
    const auto columns = static_cast<std::uint32_t>(std::lround(360 / step_deg)), rows = columns / 2;
    return make_raster(
        columns, rows, [](std::uint32_t i, std::uint32_t j) { return 200.0f * static_cast<float>((i * 7 + j * j) % 13); },
        -180 + step_deg / 2, 90 - step_deg / 2, step_deg);
}

}  // namespace tedavis::test_support
