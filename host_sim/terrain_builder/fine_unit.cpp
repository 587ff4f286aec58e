#include "host_sim/terrain_builder/fine_unit.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "host_sim/terrain_builder/chunk_builder.hpp"
#include "host_sim/terrain_builder/chunk_proof.hpp"
#include "host_sim/terrain_builder/chunk_summary.hpp"
#include "host_sim/terrain_builder/surface_heights.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// The posts of a chunk and those beside it.
LatticeWindow read_domain(const ChunkSources& s, const ChunkKey& domain) {
    const PostRange posts = s.plan.lattice.posts_of(domain);
    LatticeWindow window;
    window.i0 = std::int64_t{posts.i0} - 1;
    window.j0 = std::int64_t{posts.j0} - 1;
    window.columns = posts.i1 - posts.i0 + 3;
    window.rows = posts.j1 - posts.j0 + 3;
    s.posts.read(window);
    add_undulation(s.plan, window);
    return window;
}

/// Makes the chunks within the domain of one of them, from its posts.
class FineUnitBuilder {
public:
    FineUnitBuilder(const ChunkSources& sources, const ChunkKey& domain, const InsetCoverage& coverage)
        : s_(sources),
          domain_(domain),
          coverage_(coverage),
          window_(read_domain(sources, domain)),
          places_(sources.plan.lattice, window_.i0, window_.j0, window_.columns, window_.rows) {}

    /// Levels 0 to `top`.
    FineUnit run(std::uint32_t top) {
        for (std::uint32_t level = 0; level <= top; ++level) for_chunks(level);
        return std::move(unit_);
    }

private:
    /// Those of a level, row by row.
    void for_chunks(std::uint32_t level) {
        const std::uint32_t side = 1u << (domain_.level - level);
        const Lattice& lattice = s_.plan.lattice;
        for (std::uint32_t j = domain_.j * side; j < std::min((domain_.j + 1) * side, lattice.grid_rows(level)); ++j)
            for (std::uint32_t i = domain_.i * side; i < std::min((domain_.i + 1) * side, lattice.grid_columns(level)); ++i) {
                const ChunkKey key{level, i, j};
                if (coverage_.exists(key)) coverage_.has_children(key) ? add_irregular(key) : add_regular(key);
            }
    }
    [[nodiscard]] bool is_inset() const { return coverage_.base_level() != 0; }

    void add_regular(const ChunkKey& key) {
        ChunkDraft draft = make_regular_chunk(s_.plan, s_.lines, key, window_, places_);
        summarise_posts(s_.plan.lattice, window_, draft.entry);
        prove(draft);
        summaries_.emplace(key, draft.entry);
        if (is_inset()) return add_open(draft);
        const std::vector<std::uint8_t> payload = payload_of(draft, s_.lift);
        draft.entry.payload = s_.layout.regular_place(key.i, key.j);
        draft.entry.payload.crc = checksum(payload.data(), payload.size());
        s_.store.put(ChunkPart::regular, key, draft.entry.payload, {payload.data(), payload.size()});
        unit_.regular.push_back(draft.entry);
    }

    void add_open(const ChunkDraft& draft) {
        IrregularChunk chunk{draft.entry, payload_of(draft, s_.lift)};
        chunk.entry.payload = {0, static_cast<std::uint32_t>(chunk.payload.size()),
                               checksum(chunk.payload.data(), chunk.payload.size())};
        unit_.irregular.push_back(std::move(chunk));
    }

    void add_irregular(const ChunkKey& key) {
        const PostRange posts = s_.plan.lattice.posts_of(key);
        const std::vector<BorderPost> border = chunk_border(s_.plan, s_.lines, key);
        std::vector<TinPost> border_posts;
        for (const BorderPost& post : border) border_posts.push_back(tin_post(posts, post.i, post.j));
        const Tin tin = triangulate_chunk(s_.plan, s_.slopes, key, std::move(border_posts), candidates(key, posts), &window_);
        ChunkAssembly assembly(s_.plan, key);
        assembly.reserve(tin.vertices.size());
        for (std::size_t n = 0; n < tin.vertices.size(); ++n) {
            if (n < border.size()) assembly.add_border(border[n], window_, places_);
            if (n >= border.size())
                assembly.add_inner(posts.i0 + tin.vertices[n].i, posts.j0 + tin.vertices[n].j, window_, places_);
        }
        ChunkDraft draft = assembly.finish();
        set_triangles(draft, tin.triangles);
        summarise(key, draft.entry);
        prove(draft);
        keep_vertices(key, tin);
        add_open(draft);
    }

    [[nodiscard]] TinPost tin_post(const PostRange& posts, std::uint32_t i, std::uint32_t j) const {
        const std::size_t n = window_.at(i, j);
        return {static_cast<std::uint16_t>(i - posts.i0), static_cast<std::uint16_t>(j - posts.j0), window_.surface_m[n],
                window_.post_class[n]};
    }

    /// All inner posts, or the vertices of the meshes some levels below.
    [[nodiscard]] std::vector<TinPost> candidates(const ChunkKey& key, const PostRange& posts) const {
        std::vector<TinPost> result;
        if (key.level > kLevelsBelow && !is_inset()) {
            const auto inside = [&posts](std::uint32_t i, std::uint32_t j) {
                return i > posts.i0 && j > posts.j0 && i < posts.i1 && j < posts.j1;
            };
            for (const auto& [j, i] : vertices_[key.level - kLevelsBelow])
                if (inside(i, j)) result.push_back(tin_post(posts, i, j));
            return result;
        }
        result.reserve(std::size_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0));
        for (std::uint32_t j = posts.j0 + 1; j < posts.j1; ++j)
            for (std::uint32_t i = posts.i0 + 1; i < posts.i1; ++i) result.push_back(tin_post(posts, i, j));
        return result;
    }

    /// Of levels from which others are made; posts on borders come from up to four chunks and are kept once.
    void keep_vertices(const ChunkKey& key, const Tin& tin) {
        if (key.level + kLevelsBelow > kUnitLevel) return;
        const PostRange posts = s_.plan.lattice.posts_of(key);
        std::vector<std::pair<std::uint32_t, std::uint32_t>>& kept = vertices_[key.level];
        for (const TinPost& v : tin.vertices)
            if (v.i > 0 && v.j > 0) kept.emplace_back(posts.j0 + v.j, posts.i0 + v.i);
    }

    void summarise(const ChunkKey& key, ChunkEntry& entry) {
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            const auto child = summaries_.find(key.child(quadrant));
            if (child != summaries_.end()) summarise_child(child->second, entry);
        }
        summaries_.emplace(key, entry);
    }

    void prove(ChunkDraft& draft) {
        const PostRange posts = s_.plan.lattice.posts_of(key_of(draft.entry));
        std::vector<double> surface;
        surface.reserve(draft.vertices.size());
        for (const ChunkVertex& v : draft.vertices)
            surface.push_back(window_.surface_m[window_.at(posts.i0 + v.i, posts.j0 + v.j)]);
        ChunkProof proof(s_.plan, s_.slopes, draft, surface, sides_of_parent(s_.plan, key_of(draft.entry)));
        proof.include(window_.view());
        proof.errors().state(draft.entry);
    }

    const ChunkSources& s_;
    const ChunkKey domain_;
    const InsetCoverage& coverage_;
    const LatticeWindow window_;
    const PostPlaces places_;
    FineUnit unit_;
    std::map<ChunkKey, ChunkEntry> summaries_;
    std::array<std::vector<std::pair<std::uint32_t, std::uint32_t>>, kUnitLevel + 1> vertices_;  // row and column, by level
};

}  // namespace

FineUnit build_fine_unit(const ChunkSources& sources, std::uint32_t unit) {
    const std::uint32_t across = sources.plan.unit_columns();
    const ChunkKey domain{kUnitLevel, unit % across, unit / across};
    return FineUnitBuilder(sources, domain, InsetCoverage()).run(std::min(kUnitLevel, sources.plan.levels() - 1));
}

std::vector<IrregularChunk> build_inset_block(const ChunkSources& sources, const InsetCoverage& coverage, const ChunkKey& block) {
    return FineUnitBuilder(sources, block, coverage).run(block.level - 1).irregular;
}

}  // namespace tedavis::host_sim
