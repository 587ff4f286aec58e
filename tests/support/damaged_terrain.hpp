/// A terrain database whose header and directory are sound and whose chunks are not.
#pragma once

#include <cstring>
#include <string>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::test_support {

/// Turns one bit of the payload of every chunk of the database in `image`.
inline void damage_payloads(std::string& image) {
    terrain::FileHeader header;
    std::memcpy(&header, image.data(), sizeof header);
    for (std::uint32_t n = 0; n < header.chunk_count; ++n) {
        terrain::ChunkEntry entry;
        std::memcpy(&entry, image.data() + sizeof header + n * sizeof entry, sizeof entry);
        char& byte = image.at(static_cast<std::size_t>(entry.offset) + entry.bytes / 2);
        byte = static_cast<char>(byte ^ 4);
    }
}

}  // namespace tedavis::test_support
