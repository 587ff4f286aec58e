#include "host_sim/terrain_builder/terrain_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

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
    const bool sound_header = base::crc32(&image.header, offsetof(FileHeader, header_crc)) == image.header.header_crc;
    if (sound_header && image.header.file_bytes != bytes.size())
        throw UserError(name + ": offset " + std::to_string(bytes.size()) + ": the file ends here, but its header says " +
                        std::to_string(image.header.file_bytes) + " bytes; get a whole copy");
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

double distance_m(const ChunkVertex& a, const ChunkVertex& b) {
    return std::hypot(double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z);
}

/// One chunk of the file against the same chunk made anew.
class ChunkComparison {
public:
    ChunkComparison(const std::vector<std::uint8_t>& file, const std::vector<std::uint8_t>& fresh, const ChunkEntry& stated,
                    const ChunkEntry& expected)
        : file_(file), fresh_(fresh), stated_(stated), expected_(expected) {}

    /// An empty reason when nothing is wrong.
    [[nodiscard]] ChunkViolation run() const {
        const std::string name = chunk_name(expected_);
        if (stated_.offset > file_.size() || stated_.bytes > file_.size() - stated_.offset)
            return {name, "lies beyond the end of the file", 0};
        if (base::crc32(file_.data() + stated_.offset, stated_.bytes) != stated_.crc)
            return {name, "checksum does not match its bytes", 0};
        if (stated_.bytes != expected_.bytes) return {name, "has other vertices than the rasters give", 0};
        if (std::memcmp(file_.data() + stated_.offset, fresh_.data() + expected_.offset, stated_.bytes) != 0)
            return {name, "differs from the rasters", largest_difference_m()};
        const double excess_m = std::max(
            {expected_.above_m - stated_.above_m, expected_.below_m - stated_.below_m, expected_.bound_m - stated_.bound_m});
        if (excess_m > 0) return {name, "its mesh is farther from the true surface than it states", excess_m};
        if (!same_description()) return {name, "its entry in the directory differs from the rasters", 0};
        return {name, "", 0};
    }

private:
    /// Everything of the entry but where its bytes lie.
    [[nodiscard]] bool same_description() const {
        ChunkEntry a = stated_, b = expected_;
        a.offset = b.offset = 0;
        return std::memcmp(&a, &b, sizeof a) == 0;  // the bytes count. NOLINT(bugprone-suspicious-memory-comparison)
    }

    template <class T>
    [[nodiscard]] T read(const std::vector<std::uint8_t>& bytes, const ChunkEntry& entry, std::size_t offset) const {
        T value;
        std::memcpy(&value, bytes.data() + entry.offset + offset, sizeof value);
        return value;
    }

    /// Of positions and heights; values that are no numbers count as the largest height there is.
    [[nodiscard]] double largest_difference_m() const {
        double largest = 0;
        const auto include = [&largest](double difference_m) {
            largest = std::max(largest, std::isfinite(difference_m) ? std::abs(difference_m) : kHighestHeight_m);
        };
        for (std::size_t n = 0; n < expected_.vertex_count; ++n) {
            const auto a = read<ChunkVertex>(file_, stated_, n * sizeof(ChunkVertex)),
                       b = read<ChunkVertex>(fresh_, expected_, n * sizeof(ChunkVertex));
            include(double{a.height_m} - b.height_m);
            include(distance_m(a, b));
        }
        if (expected_.level != 0) return largest;
        for (std::size_t n = 0; n < std::size_t{kChunkPosts} * kChunkPosts; ++n) {
            const std::size_t offset = expected_.bytes - kLeafPostBytes + n * sizeof(float);
            include(double{read<float>(file_, stated_, offset)} - read<float>(fresh_, expected_, offset));
        }
        return largest;
    }

    const std::vector<std::uint8_t>& file_;
    const std::vector<std::uint8_t>& fresh_;
    const ChunkEntry& stated_;
    const ChunkEntry& expected_;
};

/// Places and names are the file's own; everything else follows from the rasters.
bool same_header(FileHeader stated, FileHeader expected) {
    for (FileHeader* h : {&stated, &expected}) {
        h->le90_m = 0;
        h->directory_crc = h->header_crc = 0;
        std::memset(h->source, 0, sizeof h->source);
        std::memset(h->vertical_datum, 0, sizeof h->vertical_datum);
    }
    return std::memcmp(&stated, &expected, sizeof stated) == 0;  // the bytes count. NOLINT(bugprone-suspicious-memory-comparison)
}

bool same_undulation(const std::vector<std::uint8_t>& file, const FileHeader& stated, const std::vector<std::uint8_t>& fresh,
                     const FileHeader& expected) {
    const std::size_t bytes = std::size_t{expected.undulation_columns} * expected.undulation_rows * sizeof(float);
    if (stated.undulation_offset > file.size() || bytes > file.size() - stated.undulation_offset) return false;
    return std::memcmp(file.data() + stated.undulation_offset, fresh.data() + expected.undulation_offset, bytes) == 0;
}

void check_frame(const std::vector<std::uint8_t>& file, const Image& image, const std::vector<std::uint8_t>& fresh_file,
                 const Image& fresh, std::vector<ChunkViolation>& violations) {
    const auto add = [&violations](bool holds, const char* part, const char* reason) {
        if (!holds) violations.push_back({part, reason, 0});
    };
    const FileHeader& h = image.header;
    add(base::crc32(&h, offsetof(FileHeader, header_crc)) == h.header_crc, "header", "checksum does not match its bytes");
    add(base::crc32(image.entries.data(), image.entries.size() * sizeof(ChunkEntry)) == h.directory_crc, "directory",
        "checksum does not match its bytes");
    add(same_header(h, fresh.header), "header", "differs from the rasters");
    add(same_undulation(file, h, fresh_file, fresh.header), "geoid undulation", "differs from EGM96");
}

}  // namespace

TerrainCheck check_tdb(const std::vector<std::uint8_t>& bytes, const std::string& name, const TerrainModel& model,
                       const BuildOptions& options) {
    const Image image = parse(bytes, name);
    require_same_lattice(image, model.raster, name);
    const std::vector<std::uint8_t> fresh_bytes = make_tdb(model, options);
    const Image fresh = parse(fresh_bytes, "recomputed database");
    if (fresh.entries.size() != image.entries.size())
        throw UserError(name + ": has " + std::to_string(image.entries.size()) + " chunks where its rasters give " +
                        std::to_string(fresh.entries.size()) + "; build it again");
    TerrainCheck check;
    check.chunks = fresh.entries.size();
    check_frame(bytes, image, fresh_bytes, fresh, check.violations);
    for (std::size_t n = 0; n < fresh.entries.size(); ++n) {
        const ChunkViolation violation = ChunkComparison(bytes, fresh_bytes, image.entries[n], fresh.entries[n]).run();
        if (violation.reason.empty()) continue;
        check.violations.push_back(violation);
        check.worst_excess_m = std::max(check.worst_excess_m, violation.excess_m);
    }
    return check;
}

}  // namespace tedavis::host_sim
