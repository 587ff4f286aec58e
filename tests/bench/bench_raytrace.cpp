/// Primary rays over generated terrain at 1920 x 1080, on two threads: our tracer beside the fastest that Embree has for the same
/// heights (grid or triangles; 1, 4, 8 or 16 rays at a time, coherent), generation of the rays included on both sides. Five
/// cameras (trace_cameras.hpp), tile by tile as products trace, over 512 x 512 and 4096 x 4096 posts, and over needles. Then what
/// the structures cost, and how far the pictures agree with each other and with our reference in long double. `--json` prints the
/// lines as a list; `--quick` measures only 512 x 512, three times each; `--reference N` measures no times and compares N million
/// rays with the reference instead of 0.4.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "platform/clock/monotonic_clock.hpp"
#include "platform/threads/thread_workers.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/bench/embree_picture.hpp"
#include "tests/bench/own_picture.hpp"
#include "tests/support/raytrace/trace_agreement.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"
#include "tests/support/terrain/fractal_heights.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using test_support::EmbreeGrid;
using test_support::EmbreeMesh;
using test_support::TraceAgreement;
using test_support::TraceCamera;

constexpr std::uint32_t kWidth = 1920, kHeight = 1080, kThreads = 2;
constexpr double kMaxDifferent = 25;  // pixels of a million; Embree itself is wrong in some

struct Options {
    bool json = false, quick = false, times = true;
    double reference_millions = 0.4;
    [[nodiscard]] int runs() const { return quick ? 3 : 9; }
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

template <class Work>
double spent_ms(const Work& work) {
    const base::Time start = platform::monotonic_now();
    work();
    return (platform::monotonic_now() - start).to_seconds() * 1000;
}

/// Embree over the same heights, by grid and by triangles.
struct EmbreeScenes {
    struct Way {
        std::string name;
        const EmbreeGrid* grid;
        int lanes = 16;
    };
    std::vector<std::unique_ptr<EmbreeGrid>> grids;

    /// Triangles take the most memory, and time to build.
    EmbreeScenes(const raytrace::HeightGrid<std::int16_t>& posts, double steps, bool has_triangles,
                 const char* instruction_set = nullptr) {
        for (const EmbreeMesh mesh : {EmbreeMesh::grid, EmbreeMesh::triangles})
            if (mesh == EmbreeMesh::grid || has_triangles)
                grids.push_back(
                    std::make_unique<EmbreeGrid>(posts, static_cast<float>(1 / steps), mesh, kThreads, instruction_set));
    }
    /// Of three runs each, by the shortest.
    [[nodiscard]] Way fastest(const TraceCamera& camera, std::vector<float>& t, base::Workers& workers) const {
        Way best;
        double best_ms = INFINITY;
        for (const auto& grid : grids) {
            for (const int lanes : {1, 4, 8, 16}) {
                bench::EmbreePicture picture(*grid, camera, t);
                double ms = INFINITY;
                for (int run = 0; run < 3; ++run) ms = std::min(ms, spent_ms([&] { picture.draw(lanes, workers); }));
                if (ms >= best_ms) continue;
                best_ms = ms;
                best = {(&grid == grids.data() ? "Embree grid " : "Embree triangles ") + std::to_string(lanes), grid.get(),
                        lanes};
            }
        }
        return best;
    }
};

/// One terrain, for all tracers.
class Terrain {
public:
    Terrain(std::string name, std::uint32_t side, bool has_needles, base::Workers& workers, const Options& options)
        : name_(std::move(name)),
          field_(heights(side, has_needles)),
          workers_(workers),
          options_(options),
          steps_(test_support::steps_a_cell(side)) {
        bounds_ = std::make_unique<bench::OwnBounds>(field_.grid());
        embree_ = std::make_unique<EmbreeScenes>(field_.grid(), steps_, options.times);
    }

    /// Ours and Embree's structures; Embree is built once.
    void measure_build(std::vector<BenchResult>& lines) {
        std::vector<double> ms;
        for (int run = 0; run < options_.runs(); ++run) ms.push_back(spent_ms([&] { bounds_->build(workers_); }));
        const auto samples = static_cast<double>(field_.posts.size());
        const double ns = median(ms) * 1e6 / samples, bytes = static_cast<double>(bounds_->bytes()) / samples + 2;
        const EmbreeGrid& grid = *embree_->grids[0];
        const double other_ns = grid.build_ms() * 1e6 / samples, other_bytes = static_cast<double>(grid.bytes()) / samples;
        lines.push_back({name_ + ": build", ns, "ns/sample", 0.3, ns <= 0.3, other_ns});
        lines.push_back({name_ + ": heights and bounds", bytes, "B/sample", 5, bytes <= 5, other_bytes});
    }

    /// By the widest lanes that there are.
    void measure_pictures(double target, std::vector<BenchResult>& lines) {
        for (const TraceCamera& camera : test_support::trace_cameras(field_.columns, kWidth, kHeight))
            measure(camera, raytrace::view_kernels<std::int16_t>()[0], *embree_, target, "", lines);
    }
    /// One ray after the other, beside Embree as it is without wide vectors; and every other width.
    void measure_widths(std::vector<BenchResult>& lines) {
        const TraceCamera camera = test_support::trace_cameras(field_.columns, kWidth, kHeight)[4];
        const auto kernels = raytrace::view_kernels<std::int16_t>();
        for (std::size_t n = 1; n + 1 < kernels.size(); ++n)
            measure(camera, kernels[n], *embree_, 1, std::string(", ") + kernels[n].name, lines);
        const EmbreeScenes narrow(field_.grid(), steps_, true, "sse2");
        measure(camera, kernels[kernels.size() - 1], narrow, 1, ", scalar beside SSE2", lines);
    }

    /// `rays` of all cameras' pixels, spread evenly, against the reference.
    void compare_with_reference(double rays, TraceAgreement& ours, TraceAgreement& embree) {
        const double pixels = 5.0 * kWidth * kHeight;
        const auto every = static_cast<std::uint32_t>(std::max(1.0, std::round(pixels / rays)));
        for (const TraceCamera& camera : test_support::trace_cameras(field_.columns, kWidth, kHeight)) {
            std::vector<float> other_t(std::size_t{kWidth} * kHeight);
            own_.draw(bounds_->field(kSurface), camera.in_steps(steps_), raytrace::view_kernels<std::int16_t>()[0], workers_);
            bench::EmbreePicture(*embree_->grids[0], camera, other_t).draw(16, workers_);
            Comparison work{this, camera.in_steps(steps_), own_.t, other_t, every, {}};
            work.rows.resize(kHeight);
            workers_.parallel_for(kHeight, Comparison::compare_row, &work);
            for (const auto& row : work.rows) {
                ours.add(row.first);
                embree.add(row.second);
            }
        }
    }

private:
    static constexpr raytrace::CellSurface kSurface = raytrace::CellSurface::two_triangles;

    static test_support::HeightField<std::int16_t> heights(std::uint32_t side, bool has_needles) {
        auto field = test_support::fractal_heights(side);
        if (has_needles) test_support::add_needles(field);
        return field;
    }
    struct Comparison {
        Terrain* terrain;
        TraceCamera camera;
        const std::vector<float>&ours, &embree;
        std::uint32_t every;
        std::vector<std::pair<TraceAgreement, TraceAgreement>> rows;

        static void compare_row(void* context, std::uint32_t y) {
            auto& work = *static_cast<Comparison*>(context);
            const std::uint32_t first = (work.every - y * kWidth % work.every) % work.every;
            for (std::uint32_t x = first; x < kWidth; x += work.every) {
                const std::size_t pixel = std::size_t{y} * kWidth + x;
                const test_support::ReferenceHit hit = work.terrain->reference_.trace(work.camera.ray(x, y));
                work.rows[y].first.add(hit, work.ours[pixel] < INFINITY, work.ours[pixel]);
                work.rows[y].second.add(hit, work.embree[pixel] < INFINITY, work.embree[pixel]);
            }
        }
    };

    /// Medians of alternating runs; the baseline of times is Embree's.
    void measure(const TraceCamera& camera, const bench::OwnKernel& kernel, const EmbreeScenes& embree, double target,
                 const std::string& how, std::vector<BenchResult>& lines) {
        std::vector<float> theirs(own_.t.size());
        const EmbreeScenes::Way best = embree.fastest(camera, theirs, workers_);
        bench::EmbreePicture other(*best.grid, camera, theirs);
        const auto field = bounds_->field(kSurface);
        const TraceCamera own_camera = camera.in_steps(steps_);
        std::vector<double> own_ms, other_ms;
        for (int run = 0; run < options_.runs(); ++run) {
            other_ms.push_back(spent_ms([&] { other.draw(best.lanes, workers_); }));
            own_ms.push_back(spent_ms([&] { own_.draw(field, own_camera, kernel, workers_); }));
        }
        const double ms = median(own_ms), embree_ms = median(other_ms), ratio = embree_ms / ms;
        const std::string what = name_ + ", " + camera.name + how;
        lines.push_back({what + ": picture", ms, "ms", embree_ms / target, ratio >= target, embree_ms});
        lines.push_back({what + ": " + best.name, ratio, "times", target, ratio >= target, 1});
        std::size_t hits = 0, different = 0;
        for (std::size_t n = 0; n < theirs.size(); ++n) {
            hits += own_.t[n] < INFINITY;
            different += (own_.t[n] < INFINITY) != (theirs[n] < INFINITY);
        }
        const auto rays = static_cast<double>(theirs.size());
        const double per_million = static_cast<double>(different) * 1e6 / rays;
        lines.push_back({what + ": differ from Embree", per_million, "per 1e6", kMaxDifferent, per_million <= kMaxDifferent,
                         static_cast<double>(hits) / rays});
    }

    std::string name_;
    test_support::HeightField<std::int16_t> field_;
    base::Workers& workers_;
    const Options& options_;
    double steps_;
    std::unique_ptr<bench::OwnBounds> bounds_;
    std::unique_ptr<EmbreeScenes> embree_;
    bench::OwnPicture own_{kWidth, kHeight};
    test_support::ReferenceTracer<std::int16_t> reference_{field_.grid(), kSurface};
};

void report_agreement(const std::string& name, TraceAgreement& ours, TraceAgreement& embree, std::vector<BenchResult>& lines) {
    const std::string what = name + ", " + std::to_string(ours.rays) + " rays: ";
    const double far = ours.quantile(0.999), embree_far = embree.quantile(0.999), rays = static_cast<double>(ours.rays);
    const auto count = [](std::uint64_t n) { return static_cast<double>(n); };
    lines.push_back({what + "unexplained against the reference", count(ours.unexplained), "rays", 0, ours.unexplained == 0,
                     count(embree.unexplained)});
    lines.push_back({what + "differ, explained or not", count(ours.different), "rays", count(ours.close),
                     ours.different <= ours.close, count(embree.different)});
    lines.push_back(
        {what + "further in t than floats err", count(ours.misplaced), "rays", 0, ours.misplaced == 0, count(embree.misplaced)});
    lines.push_back({what + "p99.9 of relative depth", far, "of t", 1e-6, far <= 1e-6, embree_far});
    lines.push_back({what + "Embree differs, per million", count(embree.different) * 1e6 / rays, "rays", 11, true, 11});
}

void measure(const Options& options, std::vector<BenchResult>& lines) {
    auto workers = platform::make_thread_workers({kThreads, bench::flush_denormals});
    if (!workers.ok()) std::exit(2);
    bench::flush_denormals();
    struct Case {
        const char* name;
        std::uint32_t side;
        bool has_needles;
        double target;  ///< times as fast as Embree
        double share;   ///< of the rays that go to the reference: over large fields it is slow
    };
    const std::vector<Case> all = {{"512", 512, false, 2, 0.7},
                                   {"4096", 4096, false, 2.5, 0.1},
                                   {"512 needles", 512, true, 1.75, 0.15},
                                   {"4096 needles", 4096, true, 1.75, 0.05}};
    for (const Case& one : all) {
        if (options.quick && one.side > 512) continue;
        Terrain terrain(one.name, one.side, one.has_needles, *workers.value(), options);
        terrain.measure_build(lines);
        if (options.times) terrain.measure_pictures(one.target, lines);
        if (options.times && one.side == 512 && !one.has_needles) terrain.measure_widths(lines);
        TraceAgreement ours, embree;
        terrain.compare_with_reference(options.reference_millions * 1e6 * one.share, ours, embree);
        report_agreement(one.name, ours, embree, lines);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    for (int n = 1; n < argc; ++n) {
        const std::string word = argv[n];
        if (word == "--json") {
            options.json = true;
        } else if (word == "--quick") {
            options.quick = true;
        } else if (word == "--reference" && n + 1 < argc && std::strtod(argv[n + 1], nullptr) > 0) {
            options.reference_millions = std::strtod(argv[++n], nullptr);
            options.times = false;
        } else {
            std::fprintf(stderr, "bench_raytrace: cannot use '%s'; known are --json, --quick and --reference MILLIONS\n",
                         argv[n]);
            return 2;
        }
    }
    std::vector<BenchResult> lines;
    measure(options, lines);
    return bench::report(lines, options.json);
}
