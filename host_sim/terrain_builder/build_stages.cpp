#include "host_sim/terrain_builder/build_stages.hpp"

#include <cmath>
#include <utility>

#include "host_sim/terrain_builder/inset_stages.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;
using Finish = std::function<void()>;
using Stages = std::vector<BuildStage>;

// Processor time, microseconds a post; only the proportions count.
namespace cost {
constexpr double kImport = 0.2, kPyramid = 0.03, kVoids = 0.03, kBorders = 0.05, kSlopes = 0.02, kChunks = 2.2, kCoarse = 0.03,
                 kProof = 0.25, kAttributes = 1.6, kDrape = 1.8, kDirectory = 0.02, kVerification = 0.3;
}

double posts_of(const BuildPlan& plan) { return static_cast<double>(plan.header.columns) * plan.header.rows; }

void add_post_stages(BuildParts& p, Stages& stages) {
    stages.push_back({"posts", cost::kImport, [&p] { return p.import.block_count(); },
                      [&p](std::uint32_t block) {
                          return Finish([&p, found = p.import.import(block)] { p.record.statistics.include(found); });
                      }});
    stages.push_back(plain_stage("posts", 0, 1, [&p](std::uint32_t) {
        if (p.record.statistics.valid_posts == 0)
            throw UserError(p.plan.coarse.source.source + ": no post has a height; check the file or its void value");
        make_pole_rows(p.plan.coarse, p.posts);
    }));
}

void add_pyramid_stages(BuildParts& p, Stages& stages) {
    double part = 0.75;  // of the posts of all levels
    for (std::uint32_t m = 1; m < p.pyramid.level_count(); ++m, part /= 4)
        stages.push_back(plain_stage("pyramid", cost::kPyramid * part, p.pyramid.block_count(m),
                                     [&p, m](std::uint32_t block) { p.pyramid.build_block(m, block); }));
    for (std::uint32_t m = p.pyramid.level_count(); m-- > 0; part *= 4) {
        BuildStage stage =
            plain_stage("voids", cost::kVoids * part, 0, [&p, m](std::uint32_t block) { p.pyramid.fill_block(m, block); });
        stage.count = [&p, m] { return p.record.statistics.void_posts == 0 ? 0 : p.pyramid.block_count(m); };
        stages.push_back(stage);
    }
}

void add_ground_stages(BuildParts& p, Stages& stages) {
    stages.push_back(plain_stage("slopes", cost::kSlopes, p.plan.coarse.unit_count(),
                                 [&p](std::uint32_t unit) { p.slopes.measure(p.posts, unit); }));
    stages.push_back(plain_stage("borders", cost::kBorders, p.lines.piece_count(),
                                 [&p](std::uint32_t piece) { p.lines.build_piece(p.posts, piece); }));
}

/// Payloads that have no place beforehand.
void append_chunk(BuildParts& p, const IrregularChunk& chunk, bool is_proven) {
    ChunkEntry entry = chunk.entry;
    entry.payload.offset =
        p.append(ChunkPart::irregular, key_of(entry), entry.payload, {chunk.payload.data(), chunk.payload.size()});
    p.coarse_entries.write(entry);
    if (!is_proven) p.unproven_entries.write(entry);
}

void add_coarse_stages(BuildParts& p, Stages& stages) {
    const BuildPlan& plan = p.plan.coarse;
    for (std::uint32_t level = kUnitLevel + 1; level < plan.levels(); ++level) {
        const std::uint32_t across = plan.lattice.grid_columns(level), count = across * plan.lattice.grid_rows(level);
        stages.push_back({"chunks", cost::kCoarse / (level - kUnitLevel), [count] { return count; },
                          [&p, level, across](std::uint32_t n) {
                              const ChunkKey key{level, n % across, n / across};
                              return Finish([&p, chunk = build_coarse_chunk(p.chunks, p.coarse_entries, key)] {
                                  append_chunk(p, chunk, false);
                              });
                          }});
    }
    if (plan.levels() <= kUnitLevel + 1) return;
    stages.push_back({"proof", cost::kProof, [&plan] { return plan.unit_count(); },
                      [&p](std::uint32_t unit) {
                          return Finish(
                              [&p, errors = measure_above(p.chunks, p.unproven_entries, unit)] { p.proof.include(errors); });
                      }});
    stages.push_back(plain_stage("proof", 0, 1, [&p](std::uint32_t) {
        for (const auto& [key, errors] : p.proof.all()) {
            ChunkEntry entry = p.unproven_entries.read(key);
            errors.state(entry);
            p.coarse_entries.write(entry);
        }
    }));
}

void add_chunk_stages(BuildParts& p, Stages& stages) {
    stages.push_back({"chunks", cost::kChunks, [&p] { return p.plan.coarse.unit_count(); },
                      [&p](std::uint32_t unit) {
                          return Finish([&p, made = build_fine_unit(p.chunks, unit)] {
                              for (const ChunkEntry& entry : made.regular) p.coarse_entries.write(entry);
                              for (const IrregularChunk& chunk : made.irregular) append_chunk(p, chunk, true);
                          });
                      }});
    add_coarse_stages(p, stages);
}

void keep_pages(BuildParts& p, const std::vector<BakedPage>& pages) {
    for (const BakedPage& page : pages) {
        ChunkEntry entry = p.entries.read(page.chunk);
        entry.attributes = page.place;
        if (!page.bytes.empty())
            entry.attributes.offset =
                p.append(ChunkPart::attributes, page.chunk, page.place, {page.bytes.data(), page.bytes.size()});
        p.entries.write(entry);
    }
}

void keep_drape(BuildParts& p, const std::optional<BakedPage>& page) {
    if (!page) return;
    ChunkEntry entry = p.entries.read(page->chunk);
    entry.drape = page->place;
    entry.drape.offset = p.append(ChunkPart::drape, page->chunk, page->place, {page->bytes.data(), page->bytes.size()});
    p.entries.write(entry);
}

/// A level is made from the whole one below it.
void add_drape_stages(BuildParts& p, Stages& stages) {
    if (p.drape == nullptr) return;
    double part = std::exp2(-2.0 * p.drape->first_level());  // of the texels of level 0
    for (std::uint32_t level = p.drape->first_level(); level < p.drape->end_level(); ++level, part /= 4)
        stages.push_back({"drape", cost::kDrape * part, [&p, level] { return p.drape->task_count(level); },
                          [&p, level](std::uint32_t task) {
                              return Finish([&p, page = p.drape->run(level, task)] { keep_drape(p, page); });
                          }});
}

void write_header(BuildParts& p) {
    p.database.resize(p.record.end);
    const PostStatistics& statistics = p.record.statistics;
    FileHeader header = p.plan.fine.header;
    header.chunk_count = p.coarse_entries.count() + inset_chunk_count(p);
    header.void_posts = statistics.void_posts;
    header.min_height_m = statistics.min_height_m;
    header.max_height_m = statistics.max_height_m;
    header.file_bytes = p.record.end;
    if (p.drape != nullptr) {
        header.drape_posts = kDrapePosts;
        header.drape_level = static_cast<std::uint16_t>(p.drape->first_level() + p.plan.coverage.base_level());
    }
    write_frame(p.directory, header, p.database);
}

void add_directory_stages(BuildParts& p, Stages& stages) {
    stages.push_back({"attributes", cost::kAttributes, [&p] { return p.baker.task_count(); },
                      [&p](std::uint32_t task) { return Finish([&p, pages = p.baker.run(task)] { keep_pages(p, pages); }); }});
    add_drape_stages(p, stages);
    add_inset_entry_stages(p, stages);
    const Lattice& lattice = p.plan.fine.lattice;
    for (std::uint32_t level = p.plan.coverage.base_level(); level < p.plan.fine.levels(); ++level)
        stages.push_back(plain_stage("directory", cost::kDirectory, lattice.grid_rows(level), [&p, level](std::uint32_t row) {
            for (std::uint32_t i = 0; i < p.plan.fine.lattice.grid_columns(level); ++i)
                finish_entry(p.directory, {level, i, row});
        }));
    const auto pages = static_cast<std::uint32_t>(p.layout.existing_pages().size());
    stages.push_back(plain_stage("directory", cost::kDirectory, pages,
                                 [&p](std::uint32_t page) { write_page(p.directory, page, p.database); }));
    stages.push_back(plain_stage("directory", 0, 1, [&p](std::uint32_t) { write_header(p); }));
    stages.push_back(plain_stage("verification", cost::kVerification, lattice.page_count(),
                                 [&p](std::uint32_t page) { (void)verify_page(p.written(), page); }));
}

}  // namespace

std::vector<BuildStage> build_stages(BuildParts& parts) {
    Stages stages;
    add_post_stages(parts, stages);
    add_inset_post_stages(parts, stages);
    stages.push_back(plain_stage("pyramid", 0, 1, [&parts](std::uint32_t) { parts.know_heights(); }));
    add_pyramid_stages(parts, stages);
    add_ground_stages(parts, stages);
    add_chunk_stages(parts, stages);
    const double posts = posts_of(parts.plan.coarse);
    for (BuildStage& stage : stages) stage.cost *= posts;
    add_inset_chunk_stages(parts, stages);
    const std::size_t first = stages.size();
    add_directory_stages(parts, stages);
    for (std::size_t n = first; n < stages.size(); ++n) stages[n].cost *= posts;
    return stages;
}

}  // namespace tedavis::host_sim
