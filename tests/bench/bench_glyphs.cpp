/// What 100,000 wind glyphs add to a frame at 1024 x 768 on the processor's own OpenGL: selection, encoding, upload and drawing,
/// over a cleared surface. With instances (es3), in batches (the es2 calls with as much memory), and on es2-small, whose field
/// merges them. Seen whole, so that most are aggregated, and from within, where near ones stand for themselves, at most 1500 of
/// them; and both with a line from every one down to the ground, which takes two thirds of the instances.
/// In every frame drawn + aggregated + hidden are all, no glyph of 6 pixels in view is left to an aggregate unless there is no
/// room for it, and nothing is allocated. `--json` prints the lines as a list.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/heap_trap/heap_trap.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/draw/data/glyph_encoding.hpp"
#include "render_core/draw/data/glyph_room.hpp"
#include "render_core/draw/drawers/data/glyph_drawer.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/scene/glyph_sites.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;

constexpr std::uint32_t kWidth = 1024, kHeight = 768, kSites = 100'000;
constexpr int kIterations = 31;
constexpr double kTarget_ms = 12, kBuildStepTarget_ms = 4;
constexpr int kCores = 2;
constexpr std::uint32_t kSitesAStep = 2048;

double median(std::vector<double> ms) {
    std::nth_element(ms.begin(), ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2), ms.end());
    return ms[ms.size() / 2];
}

/// Of this process, all threads.
template <class Work>
double processor_ms(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) * 1e3 / CLOCKS_PER_SEC;
}

template <class Work>
double spent_ms(const Work& work) {
    const base::Time start = platform::monotonic_now();
    work();
    return (platform::monotonic_now() - start).to_seconds() * 1000;
}

design::DataScale speed_colors() {
    design::DataScale scale;
    for (const design::ColorStop& stop : {design::ColorStop{0, {60, 90, 220}}, {10, {240, 240, 120}}, {20, {220, 40, 30}}})
        static_cast<void>(scale.palette.stops.try_push_back(stop));
    return scale;
}

struct Camera {
    const char* name;
    glm::dvec3 from, to;  ///< m, east, north and up of the middle
    bool sees_all;
    std::uint32_t most_drawn;
    bool linked;
};
constexpr int kColumns = 250, kRows = 200, kLevels = 2;
const Camera kCameras[] = {{"whole", {0, -75'000, 50'000}, {0, 0, 0}, true, kSites, false},
                           {"within", {-9'000, -14'000, 1500}, {4000, 9000, 600}, false, 1500, false},
                           {"whole, linked", {0, -75'000, 50'000}, {0, 0, 0}, true, kSites, true},
                           {"within, linked", {-9'000, -14'000, 1500}, {4000, 9000, 600}, false, 1500, true}};

class Bench {
public:
    /// Calls and lane of one device, memory of another.
    Bench(std::string name, const char* device, const char* memory)
        : name_(std::move(name)),
          session_("egl", device, kWidth, kHeight),
          budget_(test_support::shipped_device(memory).budget),
          block_(budget_.find(effects::kSceneGlyphs)->bytes),
          scale_(speed_colors()) {
        base::BudgetLine& gpu = *budget_.find(effects::kSceneGlyphVertices);
        base::Arena arena(block_.data(), block_.size());
        const draw::GlyphRoom room = draw::glyph_room(draw::GlyphDrawer::has_instances(session_.gl), block_.size(), gpu.bytes, 1);
        const bool has_started = drawer_.start(session_.gl, gpu, arena).message.empty() && selection_.start(arena, room.glyphs) &&
                                 field_.start(arena, room.sites);
        instances_ = arena.allocate_array<draw::GlyphInstance>(room.glyphs);
        if (!has_started || instances_.empty()) throw std::runtime_error("the glyphs find no room");
        batch_ = draw::GlyphBatch(instances_);
        style_.full_value = 20;
        for (scene::GlyphSite& site : sites_) site.over_ground_m = 500;
        session_.gl.seal();
    }
    ~Bench() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    void measure(std::vector<BenchResult>& lines) {
        build(lines);
        for (const Camera& camera : kCameras) look(camera, lines);
    }

private:
    void build(std::vector<BenchResult>& lines) {
        double longest_ms = 0;
        field_.begin(frame_, scene::GlyphValues::wind);
        for (std::size_t n = 0; n < sites_.size(); n += kSitesAStep)
            longest_ms = std::max(longest_ms, processor_ms([&] {
                                      for (std::size_t k = n; k < std::min(sites_.size(), n + kSitesAStep); ++k)
                                          field_.add(sites_[k]);
                                  }));
        bool is_done = false;
        while (!is_done)
            longest_ms =
                std::max(longest_ms, processor_ms([&] { is_done = field_.step(kSitesAStep) == scene::GlyphProgress::done; }));
        lines.push_back({name_ + ": longest step of the field", longest_ms, "ms", kBuildStepTarget_ms,
                         longest_ms <= kBuildStepTarget_ms, kBuildStepTarget_ms});
    }

    void look(const Camera& camera, std::vector<BenchResult>& lines) {
        constexpr std::uint32_t kParts = 1 + draw::kLinkParts;
        const auto room = static_cast<std::uint32_t>(instances_.size());
        settings_.most_drawn = camera.linked ? std::min(camera.most_drawn, room / kParts) : camera.most_drawn;
        style_.link_per_px = camera.linked ? 1.0 / 890 : 0;
        const scene::GlyphView view = test_support::glyph_view(frame_, camera.from, camera.to, 890, kWidth, kHeight);
        draw::DataFrame frame;
        frame.view = terrain_view(view);
        frame.towards_light = frame_.axes[2];
        frame.haze_per_m = 1 / 60'000.0;
        frame.haze = {190, 200, 215};
        std::vector<double> floor, planned, whole, floor_work, whole_work;
        for (std::vector<double>* times : {&floor, &planned, &whole, &floor_work, &whole_work}) times->reserve(kIterations);
        std::uint64_t allocations = 0;
        for (int iteration = 0; iteration < kIterations; ++iteration) {
            floor_work.push_back(processor_ms([&] { floor.push_back(spent_ms([&] { clear(true); })); }));
            host_sim::HeapTrap trap;
            whole_work.push_back(processor_ms([&] {
                whole.push_back(spent_ms([&] {
                    clear(false);
                    planned.push_back(spent_ms([&] { plan(view); }));
                    drawer_.upload(session_.gl, batch_);
                    drawer_.draw(session_.gl, frame, {view.near_m, view.far_m});
                    session_.gl->Finish();
                }));
            }));
            trap.close();
            allocations += trap.counts().ours;
        }
        const scene::GlyphCounts& counts = selection_.counts();
        const bool is_right = counts.drawn + counts.aggregated + counts.hidden == kSites &&
                              (!camera.sees_all || counts.hidden == 0) && large_ones_are_drawn(view) &&
                              session_.gl.denied().total == 0;
        const std::string name = name_ + ", " + camera.name;
        const double floor_ms = median(floor), added_ms = median(whole) - floor_ms;
        lines.push_back({name + ": added to a frame", added_ms, "ms", kTarget_ms, is_right && added_ms <= kTarget_ms, floor_ms});
        const double work_ms = (median(whole_work) - median(floor_work)) / kCores;
        lines.push_back(
            {name + ": processor time of a core", work_ms, "ms", kTarget_ms, is_right && work_ms <= kTarget_ms, added_ms});
        lines.push_back({name + ": of it selection and encoding", median(planned), "ms", kTarget_ms,
                         is_right && median(planned) <= kTarget_ms, added_ms});
        lines.push_back({name + ": glyphs", double(counts.glyphs), "glyphs", double(kSites), is_right, double(counts.drawn)});
        lines.push_back({name + ": allocations", double(allocations), "calls", 0, allocations == 0, 0});
        std::fprintf(stderr, "%s: %u drawn + %u aggregated + %u hidden, %u not parted for want of room\n", name.c_str(),
                     counts.drawn, counts.aggregated, counts.hidden, counts.over_most);
    }

    void plan(const scene::GlyphView& view) {
        selection_.select(field_, view, settings_);
        batch_.clear();
        draw::encode_glyphs(selection_.glyphs(), field_.values(), style_, scale_, view.eye, batch_);
    }

    void clear(bool finish) {
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(0.3f, 0.4f, 0.5f, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (finish) session_.gl->Finish();
    }

    /// As many sites of the definition as there are drawn ones of that size, where there was room for all.
    [[nodiscard]] bool large_ones_are_drawn(const scene::GlyphView& view) const {
        if (selection_.counts().over_most > 0 || field_.leaves() < kSites) return true;
        std::size_t large = 0, drawn = 0;
        const auto px = [&](double size_m, double distance_m) { return size_m * view.focal_px / distance_m; };
        for (const scene::GlyphSite& site : sites_)
            large += px(site.size_m, glm::distance(site.place, view.eye)) >= settings_.least_px &&
                     test_support::sees_sphere(view, site.place, 0.5 * site.size_m);
        for (const scene::SelectedGlyph& glyph : selection_.glyphs())
            drawn += !glyph.is_aggregate && px(glyph.summary.size_m, glm::length(glyph.summary.place)) >= settings_.least_px;
        return std::max(large, drawn) - std::min(large, drawn) <= 2;  // places are rounded to floats
    }

    [[nodiscard]] static terrain::View terrain_view(const scene::GlyphView& view) {
        terrain::View made;
        made.eye = view.eye;
        made.forward = view.forward;
        made.right = view.right;
        made.down = view.down;
        made.focal_px = view.focal_px;
        made.width = kWidth;
        made.height = kHeight;
        return made;
    }

    std::string name_;
    scene::GlyphFrame frame_ = scene::level_frame(test_support::kGlyphAnchor, 50'000);
    std::vector<scene::GlyphSite> sites_ = test_support::wind_lattice(frame_, kColumns, kRows, kLevels, 300, 800);
    test_support::GlSession session_;
    base::BudgetTable budget_;
    std::vector<unsigned char> block_;
    design::DataScale scale_;
    draw::GlyphDrawer drawer_;
    scene::GlyphSelection selection_;
    scene::GlyphField field_;
    base::Span<draw::GlyphInstance> instances_;
    draw::GlyphBatch batch_;
    draw::GlyphStyle style_;
    scene::GlyphSettings settings_;
};

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_glyphs: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    std::vector<BenchResult> lines;
    Bench("instances", "es3-mid", "es3-mid").measure(lines);
    Bench("batches", "es2-small", "es3-mid").measure(lines);
    Bench("es2-small", "es2-small", "es2-small").measure(lines);
    return bench::report(lines, json);
}
