/// A LodSelector with its memory, and what it selected last.
#pragma once

#include <gtest/gtest.h>

#include "render_core/terrain/lod_selection.hpp"

namespace tedavis::test_support {

class Selection {
public:
    explicit Selection(std::uint32_t nodes = 4000, std::size_t slots = 2000)
        : memory_(terrain::LodSelector::bytes_needed(nodes)), slots_(slots) {
        base::Arena arena(memory_.data(), memory_.size());
        EXPECT_TRUE(selector.start(arena, nodes));
    }
    const terrain::LodResult& select(terrain::ChunkCatalogue& catalogue, const terrain::View& view,
                                     const terrain::LodSettings& settings,
                                     terrain::SelectionKind kind = terrain::SelectionKind::ideal) {
        chunks.assign(slots_, {});
        result = selector.select(catalogue, view, settings, kind, {chunks.data(), chunks.size()});
        chunks.resize(result.chunks);
        return result;
    }
    std::vector<terrain::WantedChunk> wanted(std::size_t most = 4000) {
        std::vector<terrain::WantedChunk> list(most);
        list.resize(selector.wanted({list.data(), list.size()}));
        return list;
    }
    [[nodiscard]] std::vector<terrain::ChunkKey> keys() const {
        std::vector<terrain::ChunkKey> list;
        for (const terrain::SelectedChunk& chunk : chunks) list.push_back(chunk.key);
        return list;
    }

    terrain::LodSelector selector;
    std::vector<terrain::SelectedChunk> chunks;
    terrain::LodResult result;

private:
    std::vector<std::uint8_t> memory_;
    std::size_t slots_;
};

}  // namespace tedavis::test_support
