/// A terrain database whose header and directory are sound and whose chunks are not.
#pragma once

#include <cstring>
#include <memory>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::test_support {

/// Calls action(entry, page's offset in the file) for every chunk of the database in `image`.
template <class Image, class Action>
void for_entries(Image& image, Action action) {
    terrain::FileHeader header;
    std::memcpy(&header, image.data(), sizeof header);
    const auto page = std::make_unique<terrain::DirectoryPage>();
    for (std::uint32_t n = 0; n < header.page_count; ++n) {
        std::uint64_t offset;
        std::memcpy(&offset, image.data() + header.page_table_offset + n * sizeof offset, sizeof offset);
        if (offset == 0) continue;
        std::memcpy(page.get(), image.data() + offset, sizeof *page);
        for (const terrain::ChunkEntry& entry : page->entries)
            if (entry.vertex_count != 0) action(entry, offset);
    }
}

/// Turns one bit of the payload of every chunk of the database in `image` below its coarsest level, which a display reads
/// before it starts.
template <class Image>
void damage_payloads(Image& image) {
    terrain::FileHeader header;
    std::memcpy(&header, image.data(), sizeof header);
    for_entries(image, [&](const terrain::ChunkEntry& entry, std::uint64_t) {
        if (entry.level + 1u == header.levels) return;
        auto& byte = image.at(static_cast<std::size_t>(entry.payload.offset) + entry.payload.bytes / 2);
        byte = static_cast<typename Image::value_type>(byte ^ 4);
    });
}

}  // namespace tedavis::test_support
