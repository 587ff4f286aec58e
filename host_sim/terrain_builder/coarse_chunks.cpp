#include "host_sim/terrain_builder/coarse_chunks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "host_sim/terrain_builder/chunk_builder.hpp"
#include "host_sim/terrain_builder/chunk_summary.hpp"
#include "host_sim/terrain_builder/surface_heights.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint32_t kSpreadLevel = 4;  // chunks have as many spread posts as those of this level have posts

/// A chunk as it was put into the store.
ChunkDraft load_draft(const ChunkSources& s, const ChunkEntry& entry) {
    std::vector<std::uint8_t> bytes(entry.payload.bytes);
    s.store.get(entry.payload, bytes.data());
    ChunkDraft draft;
    draft.entry = entry;
    draft.vertices.resize(entry.vertex_count);
    const bool is_regular = (entry.flags & kChunkRegular) != 0;
    draft.triangles.resize(is_regular ? 0 : std::size_t{entry.triangle_count} * 3);
    const std::size_t vertex_bytes = draft.vertices.size() * sizeof(ChunkVertex);
    std::memcpy(draft.vertices.data(), bytes.data(), vertex_bytes);
    if (!draft.triangles.empty()) std::memcpy(draft.triangles.data(), bytes.data() + vertex_bytes, bytes.size() - vertex_bytes);
    for (ChunkVertex& v : draft.vertices) {
        v.i = static_cast<std::uint16_t>(v.i >> s.lift);
        v.j = static_cast<std::uint16_t>(v.j >> s.lift);
    }
    return draft;
}

/// Heights of vertices above the ellipsoid, with the bits that the posts have.
std::vector<double> surfaces_of(const BuildPlan& plan, const ChunkDraft& draft) {
    const PostRange posts = plan.lattice.posts_of(key_of(draft.entry));
    const PostUndulation undulation(plan.undulation, plan.lattice);
    std::vector<double> surfaces, at_post;
    for (const ChunkVertex& v : draft.vertices) {
        undulation.row(posts.i0 + v.i, 1, posts.j0 + v.j, at_post);
        surfaces.push_back(static_cast<float>(double{v.height_m} + at_post[0]));
    }
    return surfaces;
}

/// How far rounding moves a vertex of the chunk: border vertices lie on the grid of the highest level that has them.
double rounding_of(const ChunkSources& s, const ChunkKey& key) {
    std::uint32_t level = key.level;
    for (const BorderPost& post : chunk_border(s.plan, s.lines, key)) level = std::max<std::uint32_t>(level, post.top_level);
    return 0.5 * std::sqrt(3.0) * s.plan.quantum_m(level);
}

/// A post with its eight neighbours.
struct Neighbourhood {
    LatticeWindow window;
    PostPlaces places;

    Neighbourhood(const ChunkSources& s, std::uint32_t i, std::uint32_t j)
        : window(read(s, i, j)), places(s.plan.lattice, window.i0, window.j0, 3, 3) {}

    static LatticeWindow read(const ChunkSources& s, std::uint32_t i, std::uint32_t j) {
        LatticeWindow window;
        window.i0 = std::int64_t{i} - 1;
        window.j0 = std::int64_t{j} - 1;
        window.columns = window.rows = 3;
        s.posts.read(window);
        add_undulation(s.plan, window);
        return window;
    }
};

TinPost tin_post(const PostRange& posts, const Neighbourhood& around, std::uint32_t i, std::uint32_t j) {
    const std::size_t n = around.window.at(i, j);
    return {static_cast<std::uint16_t>(i - posts.i0), static_cast<std::uint16_t>(j - posts.j0), around.window.surface_m[n],
            around.window.post_class[n]};
}

/// Vertices of the meshes some levels below, each once.
void add_vertices_below(const ChunkSources& s, const EntriesFile& entries, const ChunkKey& key, const PostRange& posts,
                        std::vector<TinPost>& result) {
    const std::uint32_t level = key.level - kLevelsBelow, side = 1u << kLevelsBelow;
    for (std::uint32_t j = key.j * side; j < std::min((key.j + 1) * side, s.plan.lattice.grid_rows(level)); ++j)
        for (std::uint32_t i = key.i * side; i < std::min((key.i + 1) * side, s.plan.lattice.grid_columns(level)); ++i) {
            const ChunkDraft draft = load_draft(s, entries.read({level, i, j}));
            const std::vector<double> surfaces = surfaces_of(s.plan, draft);
            const PostRange below = s.plan.lattice.posts_of({level, i, j});
            for (std::size_t n = 0; n < draft.vertices.size(); ++n) {
                const ChunkVertex& v = draft.vertices[n];
                const std::uint32_t at_i = below.i0 + v.i, at_j = below.j0 + v.j;
                if (v.i == 0 || v.j == 0 || at_i == posts.i1 || at_j == posts.j1) continue;
                result.push_back({static_cast<std::uint16_t>(at_i - posts.i0), static_cast<std::uint16_t>(at_j - posts.j0),
                                  static_cast<float>(surfaces[n]), v.post_class()});
            }
        }
}

/// Posts of every so many rows and columns: where sides of coarse triangles cross a ridge between two of the vertices below,
/// these show it.
void add_spread_posts(const ChunkSources& s, const ChunkKey& key, const PostRange& posts, std::vector<TinPost>& result) {
    const std::uint32_t step = 1u << (key.level - kSpreadLevel);
    LatticeWindow row;
    row.i0 = posts.i0;
    row.columns = posts.i1 - posts.i0 + 1;
    row.rows = 1;
    for (std::uint32_t j = posts.j0 + step; j < posts.j1; j += step) {
        row.j0 = j;
        s.posts.read(row);
        add_undulation(s.plan, row);
        for (std::uint32_t i = posts.i0 + step; i < posts.i1; i += step)
            result.push_back({static_cast<std::uint16_t>(i - posts.i0), static_cast<std::uint16_t>(j - posts.j0),
                              row.surface_m[row.at(i, j)], row.post_class[row.at(i, j)]});
    }
}

std::vector<TinPost> candidates(const ChunkSources& s, const EntriesFile& entries, const ChunkKey& key, const PostRange& posts) {
    std::vector<TinPost> result;
    add_vertices_below(s, entries, key, posts, result);
    add_spread_posts(s, key, posts, result);
    return result;
}

/// A coarse draft as the database's lattice sees it; its triangles stand for themselves even if they are regular.
void lift(ChunkDraft& draft, const Lattice& coarse, std::uint32_t levels) {
    if ((draft.entry.flags & kChunkRegular) != 0) {
        const PostRange posts = coarse.posts_of(key_of(draft.entry));
        draft.triangles = regular_triangles(regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, 0));
        draft.entry.flags = static_cast<std::uint8_t>(draft.entry.flags & ~unsigned{kChunkRegular});
    }
    draft.entry.level = static_cast<std::uint8_t>(draft.entry.level + levels);
    for (ChunkVertex& v : draft.vertices) {
        v.i = static_cast<std::uint16_t>(v.i << levels);
        v.j = static_cast<std::uint16_t>(v.j << levels);
    }
}

/// The posts of a chunk, without those beside it.
LatticeWindow read_chunk(const ChunkSources& s, const ChunkKey& key) {
    const PostRange posts = s.plan.lattice.posts_of(key);
    LatticeWindow window;
    window.i0 = posts.i0;
    window.j0 = posts.j0;
    window.columns = posts.i1 - posts.i0 + 1;
    window.rows = posts.j1 - posts.j0 + 1;
    s.posts.read(window);
    add_undulation(s.plan, window);
    return window;
}

}  // namespace

IrregularChunk build_coarse_chunk(const ChunkSources& s, const EntriesFile& entries, const ChunkKey& key) {
    const PostRange posts = s.plan.lattice.posts_of(key);
    const std::vector<BorderPost> border = chunk_border(s.plan, s.lines, key);
    std::vector<TinPost> border_posts;
    for (const BorderPost& post : border)
        border_posts.push_back(tin_post(posts, Neighbourhood(s, post.i, post.j), post.i, post.j));
    const Tin tin =
        triangulate_chunk(s.plan, s.slopes, key, std::move(border_posts), candidates(s, entries, key, posts), nullptr);
    ChunkAssembly assembly(s.plan, key);
    for (std::size_t n = 0; n < tin.vertices.size(); ++n) {
        const std::uint32_t i = posts.i0 + tin.vertices[n].i, j = posts.j0 + tin.vertices[n].j;
        const Neighbourhood around(s, i, j);
        if (n < border.size()) assembly.add_border(border[n], around.window, around.places);
        if (n >= border.size()) assembly.add_inner(i, j, around.window, around.places);
    }
    ChunkDraft draft = assembly.finish();
    set_triangles(draft, tin.triangles);
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
        if (s.plan.lattice.contains(key.child(quadrant))) summarise_child(entries.read(key.child(quadrant)), draft.entry);
    IrregularChunk chunk{draft.entry, payload_of(draft, s.lift)};
    chunk.entry.payload = {0, static_cast<std::uint32_t>(chunk.payload.size()),
                           checksum(chunk.payload.data(), chunk.payload.size())};
    return chunk;
}

std::vector<CoarseErrors> measure_above(const ChunkSources& s, const EntriesFile& entries, std::uint32_t unit) {
    ChunkKey key{kUnitLevel, unit % s.plan.unit_columns(), unit / s.plan.unit_columns()};
    const LatticeWindow window = read_chunk(s, key);
    std::vector<CoarseErrors> errors;
    for (key = key.parent(); key.level < s.plan.levels(); key = key.parent()) {
        ChunkDraft draft = load_draft(s, entries.read(key));
        draft.rounding_m = rounding_of(s, key);
        ChunkProof proof(s.plan, s.slopes, draft, surfaces_of(s.plan, draft), sides_of_parent(s.plan, key));
        proof.include(window.view());
        errors.push_back({key, proof.errors()});
    }
    return errors;
}

std::vector<CoarseErrors> measure_inset_block(const ChunkSources& fine, const ChunkSources& coarse, const EntriesFile& entries,
                                              const ChunkKey& block) {
    const LatticeWindow window = read_chunk(fine, block);
    std::vector<CoarseErrors> errors;
    for (ChunkKey key = block; key.level < fine.plan.levels(); key = key.parent()) {
        const ChunkKey coarse_key{key.level - block.level, key.i, key.j};
        ChunkDraft draft = load_draft(coarse, entries.read(coarse_key));
        draft.rounding_m = rounding_of(coarse, coarse_key);
        lift(draft, coarse.plan.lattice, block.level);
        ChunkProof proof(fine.plan, fine.slopes, draft, surfaces_of(fine.plan, draft), sides_of_parent(fine.plan, key));
        proof.include(window.view());
        errors.push_back({key, proof.errors()});
    }
    return errors;
}

}  // namespace tedavis::host_sim
