/// Flies poses over a database and measures, against the raster, what the selections state: drawn points of every chunk where
/// its mesh is farthest from the true surface, and random ones, projected in double.
///
/// A selection is the display's own, with every chunk at hand. Three poses of ten have budgets that forbid tau, or draw the
/// surface lifted above the true one.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "render_core/terrain/drawn_surface.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/near_ground.hpp"
#include "tests/support/terrain/hard_poses.hpp"
#include "tests/support/terrain/mesh_places.hpp"

namespace tedavis::test_support {

/// A frame's worst found place.
struct FoundFrame {
    double found_px = 0, stated_px = 0, tau_px = 0;
    std::uint32_t pose = 0;
    PoseKind kind = PoseKind::random;

    [[nodiscard]] std::string text() const {
        return std::to_string(found_px) + " px found, " + std::to_string(stated_px) + " px stated, tau " +
               std::to_string(tau_px) + ", pose " + std::to_string(pose) + " (" + to_string(kind) + ")";
    }
};

struct PoseProof {
    std::uint64_t frames = 0, met = 0, points = 0, excesses = 0, contradictions = 0;
    std::map<std::string, std::uint64_t> reasons;  ///< frames by what kept them from tau
    FoundFrame closest_to_tau;                     ///< of those that met it, by found over tau
    FoundFrame closest_to_stated;                  ///< by found over stated
    FoundFrame first_excess;
    double worst_excess_px = 0, deepest_lifted_m = -1e9;  ///< true surface above the lifted one
    double worst_mesh_excess_m = -1e9;                    ///< a mesh's found error over its stated one

    void include(const PoseProof& other) {
        frames += other.frames;
        met += other.met;
        points += other.points;
        contradictions += other.contradictions;
        for (const auto& [reason, count] : other.reasons) reasons[reason] += count;
        if (ratio_to_tau(other.closest_to_tau) > ratio_to_tau(closest_to_tau)) closest_to_tau = other.closest_to_tau;
        if (ratio_to_stated(other.closest_to_stated) > ratio_to_stated(closest_to_stated))
            closest_to_stated = other.closest_to_stated;
        if (excesses == 0) first_excess = other.first_excess;
        excesses += other.excesses;
        worst_excess_px = std::max(worst_excess_px, other.worst_excess_px);
        deepest_lifted_m = std::max(deepest_lifted_m, other.deepest_lifted_m);
        worst_mesh_excess_m = std::max(worst_mesh_excess_m, other.worst_mesh_excess_m);
    }
    [[nodiscard]] static double ratio_to_tau(const FoundFrame& f) { return f.tau_px > 0 ? f.found_px / f.tau_px : 0; }
    [[nodiscard]] static double ratio_to_stated(const FoundFrame& f) { return f.stated_px > 0 ? f.found_px / f.stated_px : 0; }
};

class PoseProver {
public:
    /// What it is given must outlive it.
    PoseProver(MemoryTerrain& drawn, const GdalTerrain& truth) : drawn_(drawn), truth_(truth) {}

    static constexpr std::array<double, 4> kTaus_px{0.5, 1, 2, 4};

    /// Poses 0..poses-1 of the seed, each with every tau, on as many threads as given. `lie` scales what selections state: the
    /// control. `progress` gets the poses that are done.
    PoseProof prove(std::uint32_t poses, std::uint32_t seed, unsigned threads, double lie = 1,
                    const std::function<void(std::uint32_t)>& progress = {}) {
        std::atomic<std::uint32_t> next{0};
        std::vector<PoseProof> proofs(threads);
        std::vector<std::thread> workers;
        std::mutex speaking;
        for (unsigned t = 0; t < threads; ++t)
            workers.emplace_back([&, t] {
                Worker worker(*this, lie);
                for (std::uint32_t n = next++; n < poses; n = next++) {
                    worker.prove(HardPose(truth_, seed, n), n, proofs[t]);
                    if (!progress) continue;
                    const std::lock_guard<std::mutex> lock(speaking);
                    progress(n + 1);
                }
            });
        for (std::thread& worker : workers) worker.join();
        PoseProof all;
        for (const PoseProof& proof : proofs) all.include(proof);
        return all;
    }

private:
    using Places = std::vector<DrawnPlace>;
    enum class Budget { ample, few_chunks, few_milliseconds, lifted };

    class Worker {
    public:
        Worker(PoseProver& prover, double lie)
            : prover_(prover),
              lie_(lie),
              memory_(terrain::LodSelector::bytes_needed(kNodes) + terrain::HeightQuery::bytes_needed()),
              selected_(kMaxChunks) {
            base::Arena arena(memory_.data(), memory_.size());
            EXPECT_TRUE(selector_.start(arena, kNodes) && heights_.start(prover.drawn_.database(), arena));
        }

        void prove(const HardPose& pose, std::uint32_t number, PoseProof& proof) {
            terrain::View view = pose.view;
            view.ground = terrain::near_ground(heights_, view);
            for (const double tau_px : kTaus_px) {
                const Budget budget = budget_of(number / static_cast<std::uint32_t>(PoseKind::count) + number);
                const terrain::LodResult stated =
                    selector_.select(prover_.drawn_, view, settings_for(tau_px, budget), terrain::SelectionKind::ideal, span());
                chunks_ = stated.chunks;
                random_.seed(number);
                FoundFrame frame{0, stated.worst_error_px * lie_, tau_px, number, pose.kind};
                if (budget != Budget::lifted) frame.found_px = worst_of_meshes(pose.view, proof);
                frame.found_px = std::max(frame.found_px, worst_of_random(pose.view, budget == Budget::lifted, proof));
                note(stated, frame, proof);
            }
        }

    private:
        static constexpr std::uint32_t kNodes = 60'000, kMaxChunks = 12'000;
        static constexpr int kRandomPoints = 120, kChunksForThem = 6;

        static Budget budget_of(std::uint32_t n) {
            switch (n % 10) {
                case 7: return Budget::few_chunks;
                case 8: return Budget::few_milliseconds;
                case 9: return Budget::lifted;
                default: return Budget::ample;
            }
        }
        static terrain::LodSettings settings_for(double tau_px, Budget budget) {
            terrain::LodSettings settings;
            settings.tau_px = tau_px;
            settings.max_chunks = budget == Budget::few_chunks ? 24 : kMaxChunks;
            settings.max_triangles = 20'000'000;
            settings.conservative_up = budget == Budget::lifted;
            if (budget == Budget::few_milliseconds) {
                settings.cost = {60, 25};
                settings.max_ms = 3;
                settings.haze_per_m = 1.0 / 60'000;
            }
            return settings;
        }
        base::Span<terrain::SelectedChunk> span() { return {selected_.data(), selected_.size()}; }

        double worst_of_meshes(const terrain::View& view, PoseProof& proof) {
            double worst_px = 0;
            for (std::uint32_t n = 0; n < chunks_; ++n)
                for (const DrawnPlace& place : prover_.places(selected_[n], *scratch_, proof))
                    worst_px = std::max(worst_px, error_px(view, place, proof));
            return worst_px;
        }
        /// In the nearest chunks and in others, in triangles at random.
        double worst_of_random(const terrain::View& view, bool lifted, PoseProof& proof) {
            double worst_px = 0;
            for (int n = 0; n < kChunksForThem && chunks_ > 0; ++n) {
                const std::uint32_t which = n < kChunksForThem / 2 ? n % chunks_ : random_() % chunks_;
                const terrain::SelectedChunk& chunk = selected_[which];
                const ChunkTriangles mesh = prover_.drawn_.triangles(chunk.key, *chunk.entry, chunk.coarser_edges, *scratch_);
                const auto raised = [&](const terrain::ChunkVertex& v) {
                    return double{terrain::vertex_lift_m(chunk.lift, mesh.posts, v)} * up_at(mesh, v);
                };
                for (int k = 0; k < kRandomPoints / kChunksForThem; ++k) {
                    DrawnPlace place;
                    if (!make_drawn_place(prover_.truth_, random_point(mesh, random_, raised), place)) continue;
                    worst_px = std::max(worst_px, error_px(view, place, proof));
                    if (lifted) proof.deepest_lifted_m = std::max(proof.deepest_lifted_m, -place.error_m);
                }
            }
            return worst_px;
        }
        [[nodiscard]] glm::dvec3 up_at(const ChunkTriangles& mesh, const terrain::ChunkVertex& v) const {
            const double latitude = base::radians(prover_.truth_.latitude_deg(mesh.posts.j0 + v.j)),
                         longitude = base::radians(prover_.truth_.longitude_deg(mesh.posts.i0 + v.i));
            return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
        }

        static double error_px(const terrain::View& view, const DrawnPlace& place, PoseProof& proof) {
            if (!is_in_picture(view, place.drawn)) return 0;
            ++proof.points;
            return displacement_px(view, place);
        }

        static void note(const terrain::LodResult& stated, const FoundFrame& frame, PoseProof& proof) {
            constexpr double kRounding_px = 1e-6;
            ++proof.frames;
            ++proof.reasons[terrain::to_string(stated.reason)];
            const bool meets_tau = stated.reason == terrain::LodStop::met;
            // A frame that says why it has not reached tau has not, and one that has reached it says nothing else.
            if (meets_tau != (stated.worst_error_px <= frame.tau_px) || !stated.within_budget) ++proof.contradictions;
            const double most_px = meets_tau ? std::min(frame.stated_px, frame.tau_px) : frame.stated_px;
            const double excess_px = frame.found_px - most_px;
            if (excess_px > kRounding_px && proof.excesses++ == 0) proof.first_excess = frame;
            proof.worst_excess_px = std::max(proof.worst_excess_px, excess_px);
            if (PoseProof::ratio_to_stated(frame) > PoseProof::ratio_to_stated(proof.closest_to_stated))
                proof.closest_to_stated = frame;
            if (!meets_tau) return;
            ++proof.met;
            if (PoseProof::ratio_to_tau(frame) > PoseProof::ratio_to_tau(proof.closest_to_tau)) proof.closest_to_tau = frame;
        }

        PoseProver& prover_;
        const double lie_;
        std::vector<std::uint8_t> memory_;
        terrain::LodSelector selector_;
        terrain::HeightQuery heights_;
        std::vector<terrain::SelectedChunk> selected_;
        std::uint32_t chunks_ = 0;
        std::unique_ptr<terrain::ChunkMeshScratch> scratch_ = std::make_unique<terrain::ChunkMeshScratch>();
        std::mt19937 random_;
    };

    /// Of a chunk beside its present neighbours; found out once.
    const Places& places(const terrain::SelectedChunk& chunk, terrain::ChunkMeshScratch& scratch, PoseProof& proof) {
        const std::pair<std::uint64_t, std::uint8_t> key{chunk.key.packed(), chunk.coarser_edges};
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (const auto known = places_.find(key); known != places_.end()) return known->second;
        }
        Places found = MeshPlaces(truth_).worst(drawn_.triangles(chunk.key, *chunk.entry, chunk.coarser_edges, scratch));
        const terrain::ChunkEntry& entry = *chunk.entry;
        const bool strips = chunk.coarser_edges != 0;
        const double above_m = double{strips ? std::max(entry.above_m, entry.strip_above_m) : entry.above_m},
                     below_m = double{strips ? std::max(entry.below_m, entry.strip_below_m) : entry.below_m};
        for (const DrawnPlace& place : found)
            proof.worst_mesh_excess_m = std::max({proof.worst_mesh_excess_m, place.error_m - above_m, -place.error_m - below_m});
        const std::lock_guard<std::mutex> lock(mutex_);
        return places_.emplace(key, std::move(found)).first->second;
    }

    MemoryTerrain& drawn_;
    const GdalTerrain& truth_;
    std::mutex mutex_;
    std::map<std::pair<std::uint64_t, std::uint8_t>, Places> places_;
};

}  // namespace tedavis::test_support
