/// All data of a terrain build, in its work folder.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/attribute_baker.hpp"
#include "host_sim/terrain_builder/build_journal.hpp"
#include "host_sim/terrain_builder/coarse_proof.hpp"
#include "host_sim/terrain_builder/directory_writer.hpp"
#include "host_sim/terrain_builder/drape_baker.hpp"
#include "host_sim/terrain_builder/inset_region.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"

namespace tedavis::host_sim {

/// Writes parts to their places in the database.
class DatabaseStore final : public PartStore {
public:
    explicit DatabaseStore(WorkFile& database) : database_(database) {}

    void put(ChunkPart part, const terrain::ChunkKey& chunk, const terrain::PartPlace& place,
             base::Span<const std::uint8_t> bytes) override;
    void get(const terrain::PartPlace& place, std::uint8_t* bytes) const override;

private:
    WorkFile& database_;
};

class BuildParts {
public:
    /// Opens or makes the folder, and continues an interrupted build of the same inputs and options. Throws UserError.
    BuildParts(const TerrainSources& sources, const std::string& folder, const BuildOptions& options);
    BuildParts(const BuildParts&) = delete;
    BuildParts& operator=(const BuildParts&) = delete;

    /// Appends a part whose place is not known beforehand; returns its offset. One thread, in the order of the tasks.
    std::uint64_t append(ChunkPart part, const terrain::ChunkKey& chunk, const terrain::PartPlace& place,
                         base::Span<const std::uint8_t> bytes);
    /// Sets the range of heights in the plans, once all posts have been read.
    void know_heights();
    /// Writes all files to the disk.
    void sync();
    /// The written database, opened as by the display. Any thread.
    const OpenDatabase& written();

    const TerrainSources& sources;
    const std::string folder;
    TerrainPlan plan;
    const TdbLayout layout;
    BuildJournal journal;
    BuildRecord record;
    PostsFile posts;
    PostImport import;
    HeightPyramid pyramid;
    BorderLines lines;
    SlopeMap slopes;
    WorkFile database;
    DatabaseStore store;
    EntriesFile coarse_entries, unproven_entries, changed_entries;
    EntryBook entries;
    CoarseProof proof, inset_proof;
    const ChunkSources chunks;  ///< sources of chunks of the coarse posts
    std::vector<std::unique_ptr<InsetRegion>> regions;
    InsetPyramid inset_pyramid;
    AttributeBaker baker;
    std::unique_ptr<DrapeBaker> drape;  ///< null: no image was given
    const DirectorySources directory;

private:
    std::mutex mutex_;
    std::optional<OpenDatabase> written_;
};

}  // namespace tedavis::host_sim
