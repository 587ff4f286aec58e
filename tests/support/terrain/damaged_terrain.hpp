/// A terrain database whose header and directory are sound and whose chunks are not.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

#include "render_core/base/hash.hpp"
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

/// Writes checksums of payloads, attributes and pages that match whatever is there now.
inline void sign_chunks(std::vector<std::uint8_t>& image) {
    std::uint64_t last = 0;
    for_entries(image, [&](const terrain::ChunkEntry&, std::uint64_t offset) {
        if (offset == last) return;
        last = offset;
        terrain::DirectoryPage page;
        std::memcpy(&page, image.data() + offset, sizeof page);
        for (terrain::ChunkEntry& entry : page.entries)
            for (terrain::PartPlace* part : {&entry.payload, &entry.attributes, &entry.drape})
                if (part->bytes != 0) part->crc = base::crc32(image.data() + part->offset, part->bytes);
        page.crc = base::crc32(&page.level, sizeof page - offsetof(terrain::DirectoryPage, level));
        std::memcpy(image.data() + offset, &page, sizeof page);
    });
}

/// One triangle becomes another one of the same area, in every chunk that has two such inside: sums of areas do not tell.
inline void remove_a_triangle_of_each_chunk(std::vector<std::uint8_t>& image) {
    for_entries(image, [&](const terrain::ChunkEntry& entry, std::uint64_t) {
        if ((entry.flags & terrain::kChunkRegular) != 0) return;
        const auto* vertices = reinterpret_cast<const terrain::ChunkVertex*>(image.data() + entry.payload.offset);
        auto* indices = reinterpret_cast<std::uint16_t*>(image.data() + entry.payload.offset +
                                                         entry.vertex_count * sizeof(terrain::ChunkVertex));
        std::map<int, std::uint32_t> of_area;
        std::uint32_t largest = 0, twin = 0;
        int largest_area = 0;
        for (std::uint32_t n = entry.strip_count; n < entry.triangle_count; ++n) {
            const terrain::ChunkVertex &a = vertices[indices[3 * n]], &b = vertices[indices[3 * n + 1]],
                                       &c = vertices[indices[3 * n + 2]];
            const int area = std::abs((b.i - a.i) * (c.j - a.j) - (c.i - a.i) * (b.j - a.j));
            const auto [same, is_first] = of_area.emplace(area, n);
            if (is_first || area <= largest_area) continue;
            largest_area = area;
            largest = n;
            twin = same->second;
        }
        if (largest_area > 0) std::copy_n(indices + 3 * twin, 3, indices + 3 * largest);
    });
    sign_chunks(image);
}

}  // namespace tedavis::test_support
