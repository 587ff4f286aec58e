#include "host_sim/terrain_builder/chunk_tin.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "host_sim/terrain_builder/delaunay_mesh.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;

constexpr std::uint32_t kNone = DelaunayMesh::kNone;
constexpr std::size_t kFewestNear = 10, kMaxNear = 100;  // triangles searched round a miss
constexpr std::size_t kMaxVertices = 65536;              // what 16-bit indices name

MeshPost place_of(const TinPost& post) { return {post.i, post.j}; }

/// North before south, then west before east.
std::uint32_t reading_order(const TinPost& post) { return (std::uint32_t{post.j} << 16) | post.i; }

/// A triangle against its candidates, one after the other.
struct TriangleFit {
    double height_m = 0, per_i = 0, per_j = 0;  // of its plane, about (i0, j0)
    std::int32_t i0 = 0, j0 = 0;
    double curvature_m = 0;
    double error_m = 0;
    std::uint32_t worst = kNone;  // candidate
    bool void_corner = false, void_inside = false;

    TriangleFit(const TinPost& a, const TinPost& b, const TinPost& c) : height_m(a.height_m), i0(a.i), j0(a.j) {
        const double bi = b.i - a.i, bj = b.j - a.j, bh = double{b.height_m} - a.height_m;
        const double ci = c.i - a.i, cj = c.j - a.j, ch = double{c.height_m} - a.height_m;
        const double area = bi * cj - bj * ci;
        per_i = (bh * cj - ch * bj) / area;
        per_j = (ch * bi - bh * ci) / area;
        for (const TinPost* corner : {&a, &b, &c}) void_corner = void_corner || corner->post_class == PostClass::void_;
    }

    void include(const std::vector<TinPost>& candidates, std::uint32_t candidate) {
        const TinPost& post = candidates[candidate];
        if (post.post_class == PostClass::void_) {
            void_inside = true;
            return;
        }
        const double above = height_m + per_i * (post.i - i0) + per_j * (post.j - j0) - post.height_m;
        const double error = std::max(above, curvature_m - above);
        if (error < error_m) return;
        if (error == error_m && worst != kNone && reading_order(candidates[worst]) < reading_order(post)) return;
        error_m = error;
        worst = candidate;
    }
};

/// A candidate for insertion. Out of date when its triangle has changed since.
struct Offer {
    double error_m;
    std::uint32_t order;  // of the candidate, for ties
    std::uint32_t candidate, triangle, change;

    bool operator<(const Offer& o) const { return error_m != o.error_m ? error_m < o.error_m : order > o.order; }
};

/// A triangle that misses the true surface by too much.
struct Flaw {
    TinMiss miss;
    std::uint32_t triangle, change;

    bool operator<(const Flaw& o) const {
        return miss.error_m != o.miss.error_m ? miss.error_m < o.miss.error_m : triangle > o.triangle;
    }
};

class ChunkTin {
public:
    explicit ChunkTin(const TinInput& input) : in_(input), mesh_(border_places(input)), vertices_(input.border) {
        hand_out();
        for (std::uint32_t t = 0; t < holdings_.size(); ++t) settle(t, fit_of(t, true));
    }

    [[nodiscard]] Tin run() {
        mend_candidates();
        if (in_.miss != nullptr) mend_misses();
        Tin tin;
        for (const DelaunayMesh::Triangle& t : mesh_.triangles())
            for (const std::uint32_t corner : t.corner) tin.triangles.push_back(static_cast<std::uint16_t>(corner));
        for (const Holding& holding : holdings_) tin.candidate_error_m = std::max(tin.candidate_error_m, holding.error_m);
        tin.vertices = std::move(vertices_);
        return tin;
    }

private:
    /// What a triangle has: its candidates as a list through next_, and its error.
    struct Holding {
        std::uint32_t first = kNone;
        std::uint32_t change = 0, measured = 0;  // counts of changes; whose miss is known
        double error_m = 0;
    };
    /// A triangle round the vertex just inserted; (di, dj) leads from the vertex to its corner 1.
    struct Sector {
        std::uint32_t triangle;
        std::int32_t di, dj;
        std::uint32_t first;
        TriangleFit fit;
    };

    static std::vector<MeshPost> border_places(const TinInput& input) {
        std::vector<MeshPost> places;
        for (const TinPost& post : input.border) places.push_back(place_of(post));
        return places;
    }

    void hand_out() {
        holdings_.resize(mesh_.triangles().size());
        next_.resize(in_.candidates.size(), kNone);
        std::uint32_t triangle = 0;
        for (std::uint32_t c = 0; c < next_.size(); ++c) {
            const TinPost& post = in_.candidates[c];
            if (post.i == 0 || post.j == 0 || post.i >= in_.last_i || post.j >= in_.last_j) continue;
            triangle = mesh_.locate(place_of(post), triangle);
            next_[c] = holdings_[triangle].first;
            holdings_[triangle].first = c;
        }
    }

    [[nodiscard]] TriangleFit fit_of(std::uint32_t triangle, bool with_candidates) const {
        const DelaunayMesh::Triangle& t = mesh_.triangles()[triangle];
        const TinPost &a = vertices_[t.corner[0]], &b = vertices_[t.corner[1]], &c = vertices_[t.corner[2]];
        TriangleFit fit(a, b, c);
        if (in_.curvature_m != nullptr) {
            const auto [west, east] = std::minmax({a.i, b.i, c.i});
            const auto [north, south] = std::minmax({a.j, b.j, c.j});
            fit.error_m = fit.curvature_m = in_.curvature_m(in_.context, east - west, south - north, north);
        }
        if (!with_candidates) return fit;
        for (std::uint32_t n = holdings_[triangle].first; n != kNone; n = next_[n]) fit.include(in_.candidates, n);
        return fit;
    }

    [[nodiscard]] bool is_full() const { return vertices_.size() >= std::min<std::size_t>(in_.max_vertices, kMaxVertices); }

    void mend_candidates() {
        while (!offers_.empty() && !is_full()) {
            const Offer offer = offers_.top();
            offers_.pop();
            if (offer.change == holdings_[offer.triangle].change) insert(offer.candidate, offer.triangle);
        }
    }

    void mend_misses() {
        for (measure_changed(); !flaws_.empty() && !is_full(); measure_changed()) {
            const Flaw flaw = flaws_.top();
            flaws_.pop();
            if (flaw.change != holdings_[flaw.triangle].change) continue;
            const auto [candidate, holder] = nearest_to(flaw.miss, flaw.triangle);
            if (candidate == kNone) continue;
            insert(candidate, holder);
            mend_candidates();
            if (flaw.change == holdings_[flaw.triangle].change) flaws_.push(flaw);  // not reached yet
        }
    }

    void measure_changed() {
        for (const std::uint32_t triangle : changed_) {
            Holding& holding = holdings_[triangle];
            if (holding.measured == holding.change) continue;
            holding.measured = holding.change;
            const DelaunayMesh::Triangle& t = mesh_.triangles()[triangle];
            const TinMiss miss = in_.miss(in_.context, vertices_[t.corner[0]], vertices_[t.corner[1]], vertices_[t.corner[2]]);
            if (miss.error_m > in_.miss_tolerance_m) flaws_.push({miss, triangle, holding.change});
        }
        changed_.clear();
    }

    struct Held {
        std::uint32_t candidate = kNone, triangle = kNone;
    };

    /// Among the candidates of the triangles round one: kFewestNear of them, more while there is none.
    [[nodiscard]] Held nearest_to(const TinMiss& miss, std::uint32_t triangle) {
        Held nearest;
        double least = std::numeric_limits<double>::infinity();
        near_.assign(1, triangle);
        for (std::size_t at = 0; at < near_.size() && at < kMaxNear; ++at) {
            if (at >= kFewestNear && nearest.candidate != kNone) break;
            const std::uint32_t holder = near_[at];
            for (std::uint32_t n = holdings_[holder].first; n != kNone; n = next_[n]) {
                const TinPost& post = in_.candidates[n];
                const double distance = (post.i - miss.i) * (post.i - miss.i) + (post.j - miss.j) * (post.j - miss.j);
                if (distance > least) continue;
                if (distance == least && reading_order(in_.candidates[nearest.candidate]) < reading_order(post)) continue;
                least = distance;
                nearest = {n, holder};
            }
            for (const std::uint32_t beyond : mesh_.triangles()[holder].beyond)
                if (beyond != kNone && std::find(near_.begin(), near_.end(), beyond) == near_.end()) near_.push_back(beyond);
        }
        return nearest;
    }

    void insert(std::uint32_t candidate, std::uint32_t triangle) {
        const TinPost post = in_.candidates[candidate];
        mesh_.insert(place_of(post), triangle);
        vertices_.push_back(post);
        holdings_.resize(mesh_.triangles().size());
        lists_.clear();
        for (const std::uint32_t t : mesh_.star())
            if (holdings_[t].first != kNone) lists_.push_back(holdings_[t].first);
        look_round(place_of(post));
        deal(place_of(post));
        for (const Sector& sector : round_) {
            holdings_[sector.triangle].first = sector.first;
            settle(sector.triangle, sector.fit);
        }
    }

    /// The star, counter-clockwise.
    void look_round(MeshPost centre) {
        round_.clear();
        std::uint32_t triangle = mesh_.star().front();
        do {
            const MeshPost corner = mesh_.corner(triangle, 1);
            round_.push_back({triangle, corner.i - centre.i, corner.j - centre.j, kNone, fit_of(triangle, false)});
            triangle = mesh_.triangles()[triangle].beyond[2];
        } while (triangle != mesh_.star().front());
    }

    /// Every candidate of the star goes to the sector it lies in. Neighbours in a list are neighbours on the ground.
    void deal(MeshPost centre) {
        std::size_t at = 0;
        for (const std::uint32_t list : lists_) {
            for (std::uint32_t n = list, following = kNone; n != kNone; n = following) {
                following = next_[n];
                const MeshPost offset{in_.candidates[n].i - centre.i, in_.candidates[n].j - centre.j};
                if (offset == MeshPost{}) continue;  // the vertex itself, or the same post given twice
                at = sector_of(offset, at);
                next_[n] = round_[at].first;
                round_[at].first = n;
                round_[at].fit.include(in_.candidates, n);
            }
        }
    }

    [[nodiscard]] std::size_t sector_of(MeshPost offset, std::size_t at) const {
        const auto left_of = [&](const Sector& s) { return std::int64_t{s.dj} * offset.i - std::int64_t{s.di} * offset.j >= 0; };
        while (!left_of(round_[at])) at = at == 0 ? round_.size() - 1 : at - 1;
        for (;;) {
            const std::size_t following = at + 1 == round_.size() ? 0 : at + 1;
            if (!left_of(round_[following])) return at;
            at = following;
        }
    }

    /// Takes down a triangle's error and offers the candidate that would mend it.
    void settle(std::uint32_t triangle, const TriangleFit& fit) {
        Holding& holding = holdings_[triangle];
        holding.error_m = fit.error_m;
        ++holding.change;
        changed_.push_back(triangle);
        if (holding.first == kNone) return;
        const bool hides_void = fit.void_inside && !fit.void_corner;
        std::uint32_t candidate = fit.worst;
        if (hides_void || fit.curvature_m > in_.tolerance_m) candidate = nearest_to_middle(triangle, hides_void);
        if (candidate == kNone) return;
        const double error = hides_void ? std::numeric_limits<double>::infinity() : fit.error_m;
        if (error <= in_.tolerance_m) return;
        offers_.push({error, reading_order(in_.candidates[candidate]), candidate, triangle, holding.change});
    }

    [[nodiscard]] std::uint32_t nearest_to_middle(std::uint32_t triangle, bool only_void) const {
        const MeshPost a = mesh_.corner(triangle, 0), b = mesh_.corner(triangle, 1), c = mesh_.corner(triangle, 2);
        std::uint32_t nearest = kNone;
        std::int64_t least = std::numeric_limits<std::int64_t>::max();
        for (std::uint32_t n = holdings_[triangle].first; n != kNone; n = next_[n]) {
            const TinPost& post = in_.candidates[n];
            if (only_void && post.post_class != PostClass::void_) continue;
            const std::int64_t di = 3 * std::int64_t{post.i} - a.i - b.i - c.i, dj = 3 * std::int64_t{post.j} - a.j - b.j - c.j;
            const std::int64_t distance = di * di + dj * dj;
            if (distance > least) continue;
            if (distance == least && reading_order(in_.candidates[nearest]) < reading_order(post)) continue;
            least = distance;
            nearest = n;
        }
        return nearest;
    }

    const TinInput& in_;
    DelaunayMesh mesh_;
    std::vector<TinPost> vertices_;
    std::vector<std::uint32_t> next_;  // the candidate behind one in its triangle's list
    std::vector<Holding> holdings_;    // by triangle
    std::priority_queue<Offer> offers_;
    std::priority_queue<Flaw> flaws_;
    std::vector<std::uint32_t> changed_;  // triangles whose miss is not known
    std::vector<Sector> round_;
    std::vector<std::uint32_t> lists_, near_;
};

}  // namespace

Tin make_chunk_tin(const TinInput& input) { return ChunkTin(input).run(); }

}  // namespace tedavis::host_sim
