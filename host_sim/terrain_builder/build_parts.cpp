#include "host_sim/terrain_builder/build_parts.hpp"

#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint32_t kBuilderVersion = 3;  // another one makes other files: work folders are not taken over

/// What makes two builds the same: posts, options and the program.
std::uint64_t key_of_build(const TerrainPlan& plan, const std::optional<DrapeOptions>& drape, const BuildOptions& options) {
    base::Fnv1a64 hash;
    hash.add_u32_little_endian(kBuilderVersion);
    hash.add(&plan.fine.header, sizeof plan.fine.header);
    for (const PostRange& region : plan.coverage.regions()) hash.add(&region, sizeof region);
    if (drape) hash.add(drape->file.data(), drape->file.size());
    hash.add(options.identity.data(), options.identity.size());
    return hash.value();
}

std::vector<std::unique_ptr<InsetRegion>> make_regions(BuildParts& parts) {
    std::vector<std::unique_ptr<InsetRegion>> regions;
    for (const PostRange& region : parts.plan.coverage.regions()) {
        const std::string path = parts.folder + "/inset." + std::to_string(regions.size());
        regions.push_back(
            std::make_unique<InsetRegion>(parts.plan, region, parts.chunks, parts.posts, parts.lines, parts.slopes, path));
        parts.entries.add(std::make_unique<RegionEntries>(path + ".entries", region, parts.plan.coverage.base_level()));
        parts.inset_pyramid.add(regions.back()->pyramid);
    }
    return regions;
}

}  // namespace

void DatabaseStore::put(ChunkPart, const ChunkKey&, const PartPlace& place, base::Span<const std::uint8_t> bytes) {
    database_.write(place.offset, bytes.data(), bytes.size());
}

void DatabaseStore::get(const PartPlace& place, std::uint8_t* bytes) const { database_.read(place.offset, bytes, place.bytes); }

BuildParts::BuildParts(const TerrainSources& from, const std::string& in, const BuildOptions& options)
    : sources(from),
      folder(in),
      plan(from, options),
      layout(plan.coarse, plan.fine.lattice, plan.coverage),
      journal(folder, key_of_build(plan, sources.drape, options)),
      record(journal.last()),
      posts(folder + "/posts", plan.coarse.header.columns, plan.coarse.header.rows, plan.coarse.lattice.is_closed()),
      import(plan.coarse, sources.open, posts),
      pyramid(folder, posts, plan.coarse.lattice.is_closed()),
      lines(plan.coarse, folder),
      slopes(plan.coarse, folder + "/slopes"),
      database(folder + "/database"),
      store(database),
      coarse_entries(folder + "/entries", plan.coarse.lattice),
      unproven_entries(folder + "/unproven", plan.coarse.lattice),
      changed_entries(folder + "/changed", plan.coarse.lattice),
      entries(plan.coverage, coarse_entries, changed_entries),
      proof(folder + "/proof"),
      inset_proof(folder + "/inset_proof"),
      chunks{plan.coarse, layout, posts, lines, slopes, store, plan.coverage.base_level()},
      inset_pyramid(pyramid, plan.coverage.base_level(), plan.fine.lattice),
      baker(plan.fine, layout, plan.coverage, inset_pyramid, store),
      directory{plan.fine, plan.coverage, layout, entries} {
    regions = make_regions(*this);
    if (sources.drape)
        drape = std::make_unique<DrapeBaker>(plan.coarse, plan.coverage.base_level(), *sources.drape, store,
                                             [this](const ChunkKey& key) { return entries.read(key).drape; });
    if (!journal.resumes()) record.end = layout.open_parts;
    if (record.statistics.valid_posts > 0) know_heights();
}

void BuildParts::know_heights() {
    for (BuildPlan* const known : {&plan.coarse, &plan.fine})
        known->know_heights(double{record.statistics.min_height_m}, double{record.statistics.max_height_m});
}

std::uint64_t BuildParts::append(ChunkPart part, const ChunkKey& chunk, const PartPlace& place,
                                 base::Span<const std::uint8_t> bytes) {
    const PartPlace at{record.end, place.bytes, place.crc};
    store.put(part, chunk, at, bytes);
    record.end += (bytes.size() + 7) / 8 * 8;
    return at.offset;
}

void BuildParts::sync() {
    posts.sync();
    pyramid.sync();
    lines.sync();
    slopes.sync();
    for (const auto& region : regions) region->sync();
    database.sync();
    unproven_entries.sync();
    entries.sync();
    if (!proof.all().empty()) proof.save();
    if (!inset_proof.all().empty()) inset_proof.save();
}

const OpenDatabase& BuildParts::written() {
    const std::lock_guard lock(mutex_);
    if (!written_) written_.emplace(folder + "/database");
    return *written_;
}

}  // namespace tedavis::host_sim
