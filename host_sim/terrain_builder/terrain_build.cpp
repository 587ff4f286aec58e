#include "host_sim/terrain_builder/terrain_build.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "host_sim/atomic_file.hpp"
#include "host_sim/terrain_builder/attribute_baker.hpp"
#include "host_sim/terrain_builder/coarse_chunks.hpp"
#include "host_sim/terrain_builder/directory_writer.hpp"
#include "host_sim/terrain_builder/height_pyramid.hpp"
#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/ordered_tasks.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "platform/threads/thread_workers.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// Writes parts where they belong.
class DatabaseStore final : public PartStore {
public:
    explicit DatabaseStore(WorkFile& database) : database_(database) {}

    void put(ChunkPart, const ChunkKey&, const PartPlace& place, base::Span<const std::uint8_t> bytes) override {
        database_.write(place.offset, bytes.data(), bytes.size());
    }
    void get(const PartPlace& place, std::uint8_t* bytes) const override { database_.read(place.offset, bytes, place.bytes); }

private:
    WorkFile& database_;
};

std::unique_ptr<base::Workers> make_workers(std::uint32_t threads) {
    auto workers = platform::make_thread_workers({threads == 0 ? platform::usable_processors() : threads, nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().sentence.view()));
    return std::move(workers.value());
}

class TerrainBuild {
public:
    TerrainBuild(const PostReaderFactory& open, const std::string& output, const BuildOptions& options)
        : open_(open),
          options_(options),
          folder_(output + ".part"),
          plan_(make_build_plan(open()->grid(), options)),
          layout_(plan_, true),
          workers_(make_workers(options.threads)) {
        make_folder(folder_);
    }

    void run(const std::string& output) {
        PostsFile posts(folder_ + "/posts", plan_.header.columns, plan_.header.rows, plan_.lattice.is_closed());
        import(posts);
        HeightPyramid pyramid(folder_, posts, plan_.lattice.is_closed());
        pyramid.build(*workers_, [this](std::uint64_t done, std::uint64_t total) { progress("pyramid", done, total); });
        if (statistics_.void_posts > 0)
            pyramid.fill_voids(*workers_, [this](std::uint64_t done, std::uint64_t total) { progress("voids", done, total); });
        BorderLines lines(plan_, folder_);
        lines.build(posts, *workers_, [this](std::uint64_t done, std::uint64_t total) { progress("borders", done, total); });
        const SlopeMap slopes(plan_, posts, *workers_,
                              [this](std::uint32_t unit) { progress("slopes", unit + 1, plan_.unit_count()); });
        WorkFile database(folder_ + "/database");
        DatabaseStore store(database);
        EntriesFile entries(folder_ + "/entries", plan_.lattice);
        const ChunkSources sources{plan_, layout_, posts, lines, slopes, store};
        end_ = layout_.irregular;
        build_units(sources, entries);
        build_coarse(sources, entries);
        measure_coarse(sources, entries);
        bake(sources, entries, pyramid);
        finish(entries, database);
        database.sync();
        verify_database(OpenDatabase(folder_ + "/database"),
                        [this](std::uint64_t done, std::uint64_t total) { progress("verification", done, total); });
        if (std::rename((folder_ + "/database").c_str(), output.c_str()) != 0)
            throw UserError(output + ": cannot be put in its place; check the folder");
        std::filesystem::remove_all(folder_);
    }

private:
    void progress(std::string_view stage, std::uint64_t done, std::uint64_t total) const {
        if (options_.progress) options_.progress(stage, done, total);
    }

    void import(PostsFile& posts) {
        const std::uint32_t blocks = ImportBlocks(plan_).count();
        import_posts(plan_, open_, posts, *workers_, 0, [&](std::uint32_t block, const PostStatistics& statistics) {
            statistics_.include(statistics);
            progress("posts", block + 1, blocks);
        });
        if (statistics_.valid_posts == 0)
            throw UserError(plan_.source.source + ": no post has a height; check the file or its void value");
        make_pole_rows(plan_, posts);
    }

    void append(const ChunkSources& sources, EntriesFile& entries, IrregularChunk&& chunk) {
        chunk.entry.payload.offset = end_;
        sources.store.put(ChunkPart::irregular, key_of(chunk.entry), chunk.entry.payload, chunk.payload);
        end_ += (chunk.payload.size() + 7) / 8 * 8;
        entries.write(chunk.entry);
    }

    void build_units(const ChunkSources& sources, EntriesFile& entries) {
        run_in_order(
            *workers_, 0, plan_.unit_count(), [&](std::uint32_t unit) { return build_fine_unit(sources, unit); },
            [&](std::uint32_t unit, FineUnit&& made) {
                for (const ChunkEntry& entry : made.regular) entries.write(entry);
                for (IrregularChunk& chunk : made.irregular) append(sources, entries, std::move(chunk));
                progress("chunks", unit + 1, plan_.unit_count());
            });
    }

    void build_coarse(const ChunkSources& sources, EntriesFile& entries) {
        for (std::uint32_t level = kUnitLevel + 1; level < plan_.levels(); ++level) {
            const std::uint32_t across = plan_.lattice.grid_columns(level), count = across * plan_.lattice.grid_rows(level);
            run_in_order(
                *workers_, 0, count,
                [&](std::uint32_t n) {
                    return build_coarse_chunk(sources, entries, {level, n % across, n / across});
                },
                [&](std::uint32_t n, IrregularChunk&& chunk) {
                    append(sources, entries, std::move(chunk));
                    progress("coarse chunks", n + 1, count);
                });
        }
    }

    void measure_coarse(const ChunkSources& sources, EntriesFile& entries) {
        if (plan_.levels() <= kUnitLevel + 1) return;
        std::map<ChunkKey, ChunkErrors> all;
        run_in_order(
            *workers_, 0, plan_.unit_count(), [&](std::uint32_t unit) { return measure_above(sources, entries, unit); },
            [&](std::uint32_t unit, const std::vector<CoarseErrors>& errors) {
                for (const CoarseErrors& one : errors) all[one.chunk].include(one.errors);
                progress("proof", unit + 1, plan_.unit_count());
            });
        for (const auto& [key, errors] : all) {
            ChunkEntry entry = entries.read(key);
            errors.state(entry);
            entries.write(entry);
        }
    }

    void bake(const ChunkSources& sources, EntriesFile& entries, HeightPyramid& pyramid) {
        AttributeBaker baker(plan_, layout_, pyramid, sources.store);
        run_in_order(
            *workers_, 0, baker.task_count(), [&](std::uint32_t task) { return baker.run(task); },
            [&](std::uint32_t task, const std::vector<BakedPage>& pages) {
                for (const BakedPage& page : pages) {
                    ChunkEntry entry = entries.read(page.chunk);
                    entry.attributes = page.place;
                    entries.write(entry);
                }
                progress("attributes", task + 1, baker.task_count());
            });
    }

    void finish(EntriesFile& entries, WorkFile& database) {
        set_bounds(plan_, entries, [this](std::uint64_t done, std::uint64_t total) { progress("directory", done, total); });
        database.resize(end_);
        FileHeader header = plan_.header;
        header.chunk_count = entries.count();
        header.void_posts = statistics_.void_posts;
        header.min_height_m = statistics_.min_height_m;
        header.max_height_m = statistics_.max_height_m;
        header.file_bytes = end_;
        write_directory(plan_, layout_, entries, header, database);
    }

    const PostReaderFactory& open_;
    const BuildOptions& options_;
    const std::string folder_;
    const BuildPlan plan_;
    const TdbLayout layout_;
    std::unique_ptr<base::Workers> workers_;
    PostStatistics statistics_;
    std::uint64_t end_ = 0;
};

}  // namespace

void build_terrain(const PostReaderFactory& open, const std::string& output, const BuildOptions& options) {
    TerrainBuild(open, output, options).run(output);
}

}  // namespace tedavis::host_sim
