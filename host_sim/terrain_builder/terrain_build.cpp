#include "host_sim/terrain_builder/terrain_build.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "host_sim/terrain_builder/attribute_baker.hpp"
#include "host_sim/terrain_builder/build_journal.hpp"
#include "host_sim/terrain_builder/coarse_proof.hpp"
#include "host_sim/terrain_builder/directory_writer.hpp"
#include "host_sim/terrain_builder/height_pyramid.hpp"
#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/staged_run.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint32_t kBuilderVersion = 1;  // another one makes other files: work folders are not taken over

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
    const std::uint32_t most = std::min(platform::usable_processors(), kMostThreads);
    auto workers = platform::make_thread_workers({threads == 0 ? most : threads, nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().sentence.view()));
    return std::move(workers.value());
}

/// What makes two builds the same: posts, options and the program.
std::uint64_t key_of_build(const BuildPlan& plan, const BuildOptions& options) {
    base::Fnv1a64 hash;
    hash.add_u32_little_endian(kBuilderVersion);
    hash.add(&plan.header, sizeof plan.header);
    hash.add(options.identity.data(), options.identity.size());
    return hash.value();
}

// Processor time of the stages, microseconds a post; only their proportions count.
namespace cost {
constexpr double kImport = 0.2, kPyramid = 0.03, kVoids = 0.03, kBorders = 0.05, kSlopes = 0.02, kChunks = 2.2, kCoarse = 0.03,
                 kProof = 0.25, kAttributes = 1.6, kDirectory = 0.02, kVerification = 0.3;
}

class TerrainBuild {
public:
    TerrainBuild(const PostReaderFactory& open, const std::string& output, const BuildOptions& options)
        : open_(open),
          options_(options),
          folder_(output + ".part"),
          plan_(make_build_plan(open()->grid(), options)),
          layout_(plan_),
          journal_(folder_, key_of_build(plan_, options)),
          posts_(folder_ + "/posts", plan_.header.columns, plan_.header.rows, plan_.lattice.is_closed()),
          import_(plan_, open_, posts_),
          pyramid_(folder_, posts_, plan_.lattice.is_closed()),
          lines_(plan_, folder_),
          slopes_(plan_, folder_ + "/slopes"),
          database_(folder_ + "/database"),
          store_(database_),
          entries_(folder_ + "/entries", plan_.lattice),
          unproven_(folder_ + "/unproven", plan_.lattice),
          proof_(folder_ + "/proof"),
          sources_{plan_, layout_, posts_, lines_, slopes_, store_},
          baker_(plan_, layout_, pyramid_, store_),
          workers_(make_workers(options.threads)),
          record_(journal_.last()) {
        if (!journal_.resumes()) record_.end = layout_.irregular;
    }

    void run(const std::string& output) {
        StagedRun(
            journal_, record_, *workers_, options_.progress, [this] { sync(); }, options_.between_records)
            .run(stages());
        if (std::rename((folder_ + "/database").c_str(), output.c_str()) != 0)
            throw UserError(output + ": cannot be put in its place; check the folder");
        std::filesystem::remove_all(folder_);
    }

private:
    using Finish = std::function<void()>;

    std::vector<BuildStage> stages() {
        std::vector<BuildStage> stages;
        add_post_stages(stages);
        add_ground_stages(stages);
        add_chunk_stages(stages);
        add_directory_stages(stages);
        const double posts = static_cast<double>(plan_.header.columns) * plan_.header.rows;
        for (BuildStage& stage : stages) stage.cost *= posts;
        return stages;
    }

    /// A stage whose tasks leave nothing to be done in order.
    template <class Task>
    static BuildStage plain_stage(std::string_view name, double cost, std::uint32_t count, Task task) {
        return {name, cost, [count] { return count; },
                [task](std::uint32_t index) {
                    task(index);
                    return Finish([] {});
                }};
    }

    void add_post_stages(std::vector<BuildStage>& stages) {
        stages.push_back({"posts", cost::kImport, [this] { return import_.block_count(); },
                          [this](std::uint32_t block) {
                              return Finish(
                                  [this, statistics = import_.import(block)] { record_.statistics.include(statistics); });
                          }});
        stages.push_back(plain_stage("posts", 0, 1, [this](std::uint32_t) {
            if (record_.statistics.valid_posts == 0)
                throw UserError(plan_.source.source + ": no post has a height; check the file or its void value");
            make_pole_rows(plan_, posts_);
        }));
    }

    void add_ground_stages(std::vector<BuildStage>& stages) {
        double part = 0.75;  // of the posts of all levels
        for (std::uint32_t m = 1; m < pyramid_.level_count(); ++m, part /= 4)
            stages.push_back(plain_stage("pyramid", cost::kPyramid * part, pyramid_.block_count(m),
                                         [this, m](std::uint32_t block) { pyramid_.build_block(m, block); }));
        for (std::uint32_t m = pyramid_.level_count(); m-- > 0; part *= 4) {
            BuildStage stage =
                plain_stage("voids", cost::kVoids * part, 0, [this, m](std::uint32_t block) { pyramid_.fill_block(m, block); });
            stage.count = [this, m] { return record_.statistics.void_posts == 0 ? 0 : pyramid_.block_count(m); };
            stages.push_back(stage);
        }
        stages.push_back(plain_stage("slopes", cost::kSlopes, plan_.unit_count(),
                                     [this](std::uint32_t unit) { slopes_.measure(posts_, unit); }));
        stages.push_back(plain_stage("borders", cost::kBorders, lines_.piece_count(),
                                     [this](std::uint32_t piece) { lines_.build_piece(posts_, piece); }));
    }

    void add_chunk_stages(std::vector<BuildStage>& stages) {
        stages.push_back(
            {"chunks", cost::kChunks, [this] { return plan_.unit_count(); },
             [this](std::uint32_t unit) { return Finish([this, made = build_fine_unit(sources_, unit)] { keep(made); }); }});
        for (std::uint32_t level = kUnitLevel + 1; level < plan_.levels(); ++level) add_coarse_stage(stages, level);
        if (plan_.levels() > kUnitLevel + 1) add_proof_stages(stages);
        stages.push_back({"attributes", cost::kAttributes, [this] { return baker_.task_count(); },
                          [this](std::uint32_t task) { return Finish([this, pages = baker_.run(task)] { keep(pages); }); }});
    }

    void add_coarse_stage(std::vector<BuildStage>& stages, std::uint32_t level) {
        const std::uint32_t across = plan_.lattice.grid_columns(level), count = across * plan_.lattice.grid_rows(level);
        stages.push_back({"chunks", cost::kCoarse / (level - kUnitLevel), [count] { return count; },
                          [this, level, across](std::uint32_t n) {
                              const ChunkKey key{level, n % across, n / across};
                              return Finish([this, chunk = build_coarse_chunk(sources_, entries_, key)] { append(chunk, true); });
                          }});
    }

    void add_proof_stages(std::vector<BuildStage>& stages) {
        stages.push_back({"proof", cost::kProof, [this] { return plan_.unit_count(); },
                          [this](std::uint32_t unit) {
                              return Finish(
                                  [this, errors = measure_above(sources_, unproven_, unit)] { proof_.include(errors); });
                          }});
        stages.push_back(plain_stage("proof", 0, 1, [this](std::uint32_t) {
            for (const auto& [key, errors] : proof_.all()) {
                ChunkEntry entry = unproven_.read(key);
                errors.state(entry);
                entries_.write(entry);
            }
        }));
    }

    void add_directory_stages(std::vector<BuildStage>& stages) {
        for (std::uint32_t level = 0; level < plan_.levels(); ++level)
            stages.push_back(plain_stage("directory", cost::kDirectory / (level + 1), plan_.lattice.grid_rows(level),
                                         [this, level](std::uint32_t row) { set_bounds(plan_, entries_, level, row); }));
        stages.push_back(plain_stage("directory", cost::kDirectory, plan_.lattice.page_count(),
                                     [this](std::uint32_t page) { write_page(plan_, layout_, entries_, page, database_); }));
        stages.push_back(plain_stage("directory", 0, 1, [this](std::uint32_t) { write_header(); }));
        stages.push_back(plain_stage("verification", cost::kVerification, plan_.lattice.page_count(),
                                     [this](std::uint32_t page) { (void)verify_page(written(), page); }));
    }

    void keep(const FineUnit& unit) {
        for (const ChunkEntry& entry : unit.regular) entries_.write(entry);
        for (const IrregularChunk& chunk : unit.irregular) append(chunk, false);
    }
    void keep(const std::vector<BakedPage>& pages) {
        for (const BakedPage& page : pages) {
            ChunkEntry entry = entries_.read(page.chunk);
            entry.attributes = page.place;
            entries_.write(entry);
        }
    }
    /// Errors of coarse chunks come later, from an entry that nobody else changes.
    void append(const IrregularChunk& chunk, bool coarse) {
        ChunkEntry entry = chunk.entry;
        entry.payload.offset = record_.end;
        store_.put(ChunkPart::irregular, key_of(entry), entry.payload, {chunk.payload.data(), chunk.payload.size()});
        record_.end += (chunk.payload.size() + 7) / 8 * 8;
        entries_.write(entry);
        if (coarse) unproven_.write(entry);
    }

    void write_header() {
        database_.resize(record_.end);
        FileHeader header = plan_.header;
        header.chunk_count = entries_.count();
        header.void_posts = record_.statistics.void_posts;
        header.min_height_m = record_.statistics.min_height_m;
        header.max_height_m = record_.statistics.max_height_m;
        header.file_bytes = record_.end;
        write_frame(plan_, layout_, header, database_);
    }

    const OpenDatabase& written() {
        const std::lock_guard lock(mutex_);
        if (!written_) written_.emplace(folder_ + "/database");
        return *written_;
    }

    void sync() {
        posts_.sync();
        pyramid_.sync();
        lines_.sync();
        slopes_.sync();
        database_.sync();
        entries_.sync();
        unproven_.sync();
        if (!proof_.all().empty()) proof_.save();
    }

    const PostReaderFactory& open_;
    const BuildOptions& options_;
    const std::string folder_;
    const BuildPlan plan_;
    const TdbLayout layout_;
    BuildJournal journal_;
    PostsFile posts_;
    PostImport import_;
    HeightPyramid pyramid_;
    BorderLines lines_;
    SlopeMap slopes_;
    WorkFile database_;
    DatabaseStore store_;
    EntriesFile entries_, unproven_;
    CoarseProof proof_;
    const ChunkSources sources_;
    AttributeBaker baker_;
    std::unique_ptr<base::Workers> workers_;
    BuildRecord record_;
    std::mutex mutex_;
    std::optional<OpenDatabase> written_;
};

}  // namespace

namespace {

void require_place(const std::string& output) {
    const std::filesystem::path folder = std::filesystem::absolute(output).parent_path();
    if (!std::filesystem::is_directory(folder))
        throw UserError(output + ": there is no folder " + folder.string() + "; make it or name another output");
    if (std::filesystem::is_directory(output)) throw UserError(output + ": is a folder; name a file for the database");
}

}  // namespace

void build_terrain(const PostReaderFactory& open, const std::string& output, const BuildOptions& options) {
    require_place(output);
    try {
        TerrainBuild(open, output, options).run(output);
    } catch (const UserError&) {
        // What was wrong will be wrong again; a build that was stopped goes on from its work folder.
        std::error_code ignored;
        std::filesystem::remove_all(output + ".part", ignored);
        throw;
    }
}

}  // namespace tedavis::host_sim
