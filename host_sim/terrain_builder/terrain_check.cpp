#include "host_sim/terrain_builder/terrain_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/terrain/chunk_mesh.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::string chunk_name(const ChunkEntry& e) {
    return std::to_string(e.level) + "/" + std::to_string(e.i) + "/" + std::to_string(e.j);
}

struct Image {
    FileHeader header{};
    std::vector<ChunkEntry> entries;
};

Image parse(const std::vector<std::uint8_t>& bytes, const std::string& name) {
    Image image;
    if (bytes.size() < sizeof image.header)
        throw UserError(name + ": not a terrain database; give a file that 'terrain build' wrote");
    std::memcpy(&image.header, bytes.data(), sizeof image.header);
    if (std::memcmp(image.header.magic, kTdbMagic, sizeof kTdbMagic) != 0 || image.header.version != kTdbVersion)
        throw UserError(name + ": not a terrain database of this version; build it again with 'terrain build'");
    const std::uint64_t end = sizeof image.header + std::uint64_t{image.header.chunk_count} * sizeof(ChunkEntry);
    if (image.header.chunk_count == 0 || end > bytes.size())
        throw UserError(name + ": offset " + std::to_string(bytes.size()) +
                        ": the file ends inside its directory; get a whole copy");
    image.entries.resize(image.header.chunk_count);
    std::memcpy(image.entries.data(), bytes.data() + sizeof image.header, image.entries.size() * sizeof(ChunkEntry));
    return image;
}

void require_same_lattice(const Image& image, const Raster& raster, const std::string& name) {
    const FileHeader& h = image.header;
    const bool same = h.columns == raster.columns && h.rows == raster.rows && std::abs(h.west_deg - raster.west_deg) < 1e-9 &&
                      std::abs(h.north_deg - raster.north_deg) < 1e-9 && std::abs(h.step_lon_deg - raster.step_lon_deg) < 1e-12;
    if (!same)
        throw UserError(name + ": was not built from these rasters (other posts); name the rasters and options of its build");
}

/// One chunk of the file against the same chunk made anew.
class ChunkComparison {
public:
    ChunkComparison(const std::vector<std::uint8_t>& file, const std::vector<std::uint8_t>& fresh, const ChunkEntry& stated,
                    const ChunkEntry& expected)
        : file_(file), fresh_(fresh), stated_(stated), expected_(expected) {}

    /// An empty reason when nothing is wrong.
    [[nodiscard]] ChunkViolation run() const {
        ChunkViolation violation{chunk_name(expected_), "", 0};
        if (stated_.offset > file_.size() || stated_.bytes > file_.size() - stated_.offset) {
            violation.reason = "lies beyond the end of the file";
        } else if (base::crc32(file_.data() + stated_.offset, stated_.bytes) != stated_.crc) {
            violation.reason = "checksum does not match its bytes";
        } else if (stated_.bytes != expected_.bytes ||
                   std::memcmp(file_.data() + stated_.offset, fresh_.data() + expected_.offset, stated_.bytes) != 0) {
            violation.reason = "differs from the rasters";
            violation.excess_m = largest_height_difference();
        }
        const double excess = std::max(expected_.above_m - stated_.above_m, expected_.below_m - stated_.below_m);
        if (violation.reason.empty() && (excess > 0 || expected_.bound_m > stated_.bound_m)) {
            violation.reason = "its mesh is farther from the true surface than it states";
            violation.excess_m = std::max(excess, double{expected_.bound_m} - stated_.bound_m);
        }
        return violation;
    }

private:
    [[nodiscard]] double largest_height_difference() const {
        const std::size_t count = std::min(stated_.vertex_count, expected_.vertex_count);
        double largest = 0;
        if (stated_.bytes < count * sizeof(ChunkVertex)) return largest;
        for (std::size_t n = 0; n < count; ++n) {
            ChunkVertex a, b;
            std::memcpy(&a, file_.data() + stated_.offset + n * sizeof a, sizeof a);
            std::memcpy(&b, fresh_.data() + expected_.offset + n * sizeof b, sizeof b);
            largest = std::max(largest, std::abs(double{a.height_m} - b.height_m));
        }
        if (stated_.level != 0 || stated_.bytes != expected_.bytes) return largest;
        for (std::size_t n = 0; n < std::size_t{kChunkPosts} * kChunkPosts; ++n) {
            float a, b;
            const std::size_t offset = stated_.bytes - kLeafPostBytes + n * sizeof(float);
            std::memcpy(&a, file_.data() + stated_.offset + offset, sizeof a);
            std::memcpy(&b, fresh_.data() + expected_.offset + offset, sizeof b);
            if (!(std::abs(double{a} - b) <= largest)) largest = std::abs(double{a} - b);
        }
        return largest;
    }

    const std::vector<std::uint8_t>& file_;
    const std::vector<std::uint8_t>& fresh_;
    const ChunkEntry& stated_;
    const ChunkEntry& expected_;
};

}  // namespace

TerrainCheck check_tdb(const std::vector<std::uint8_t>& bytes, const std::string& name, const TerrainModel& model,
                       const BuildOptions& options) {
    const Image image = parse(bytes, name);
    require_same_lattice(image, model.raster, name);
    const std::vector<std::uint8_t> fresh_bytes = make_tdb(model, options);
    const Image fresh = parse(fresh_bytes, "recomputed database");
    TerrainCheck check;
    check.chunks = fresh.entries.size();
    if (fresh.entries.size() != image.entries.size())
        throw UserError(name + ": has " + std::to_string(image.entries.size()) + " chunks where its rasters give " +
                        std::to_string(fresh.entries.size()) + "; build it again");
    for (std::size_t n = 0; n < fresh.entries.size(); ++n) {
        const ChunkViolation violation = ChunkComparison(bytes, fresh_bytes, image.entries[n], fresh.entries[n]).run();
        if (violation.reason.empty()) continue;
        check.violations.push_back(violation);
        check.worst_excess_m = std::max(check.worst_excess_m, violation.excess_m);
    }
    const bool header_differs =
        std::memcmp(bytes.data(), fresh_bytes.data(), sizeof(FileHeader)) != 0 && check.violations.empty();
    if (header_differs && std::memcmp(&image.header, &fresh.header, offsetof(FileHeader, le90_m)) != 0)
        check.violations.push_back({"header", "differs from the rasters", 0});
    return check;
}

}  // namespace tedavis::host_sim
