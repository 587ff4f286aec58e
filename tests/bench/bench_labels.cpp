/// What labels cost and how calm they are: 5,000 features with names and icons (places by their people, peaks, runways,
/// obstacles) in steady flight of 20 minutes at ten frames a second and 1024 x 768, put onto the sheet as the display does it,
/// over level ground that hides nothing. Of every frame: the time of the placement, intervals and text included; signs that
/// overlap, or leave the room that they have claimed; what came, went or looks different. A flight without a memory is the
/// baseline of the changes.
/// `--json` prints the lines as a list; `--minutes 2` flies less.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render_core/display/planner/element_labels.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;

constexpr double kSpeed_mps = 70, kFrames_hz = 10, kHeight_m = 1700;
constexpr double kTarget_ms = 1.5, kMaxChanges = 2;
constexpr std::size_t kPlaces = 4200, kPeaks = 400, kRunways = 200, kObstacles = 200;
constexpr double kSide_m = 160'000;

class Chance {
public:
    double share() { return static_cast<double>((state_ = state_ * 1664525u + 1013904223u) >> 8) / (1u << 24); }

private:
    std::uint32_t state_ = 2026;
};

scene::ScenePoint somewhere(Chance& chance) {
    return test_support::BillboardRoom::point(kSide_m * chance.share() - 10'000, kSide_m * (chance.share() - 0.5),
                                              std::numeric_limits<float>::quiet_NaN());
}

host_sim::AttributeDraft attribute(const char* name) {
    host_sim::AttributeDraft made;
    made.name = name;
    made.of = scene::AttributeOf::feature;
    return made;
}

host_sim::LayerDraft layer(const char* name, scene::LayerRole role, const char* word, std::size_t count, Chance& chance) {
    host_sim::LayerDraft made;
    made.name = name;
    made.role = role;
    for (std::size_t n = 0; n < count; ++n) {
        made.points.push_back(somewhere(chance));
        made.names.push_back(word + std::to_string(n));
    }
    return made;
}

host_sim::SceneDraft country() {
    Chance chance;
    host_sim::LayerDraft places = layer("places", scene::LayerRole::place, "Village ", kPlaces, chance);
    places.attributes = {attribute("population")};
    for (std::size_t n = 0; n < kPlaces; ++n)
        places.attributes[0].values.push_back(static_cast<float>(100 * std::exp(9 * std::pow(chance.share(), 3))));
    host_sim::LayerDraft peaks = layer("peaks", scene::LayerRole::place, "Mount ", kPeaks, chance);
    peaks.attributes = {attribute("elevation")};
    for (std::size_t n = 0; n < kPeaks; ++n) peaks.attributes[0].values.push_back(static_cast<float>(600 + 900 * chance.share()));
    host_sim::LayerDraft runways = layer("runways", scene::LayerRole::runway, "Field ", kRunways, chance);
    runways.attributes = {attribute("length")};
    runways.shape = scene::LayerShape::lines;
    for (std::size_t n = 0; n < kRunways; ++n) {
        runways.attributes[0].values.push_back(static_cast<float>(600 + 2400 * chance.share()));
        runways.starts.push_back(static_cast<std::uint32_t>(n));
    }
    runways.starts.push_back(kRunways);
    host_sim::LayerDraft obstacles = layer("obstacles", scene::LayerRole::obstacle, "", kObstacles, chance);
    for (std::string& name : obstacles.names) name.clear();
    return {"country", "made for a bench", 1, {places, peaks, runways, obstacles}};
}

struct Outcome {
    std::vector<double> intervals_ms, frames_ms;  ///< those that decide, and the others
    std::uint64_t overlaps = 0, astray = 0, changes = 0, worst_second = 0, calm_seconds = 0, named = 0, frames = 0;

    [[nodiscard]] double mean_ms() const {
        double sum = 0;
        for (const std::vector<double>* part : {&intervals_ms, &frames_ms})
            for (const double ms : *part) sum += ms;
        return sum / static_cast<double>(frames);
    }
    [[nodiscard]] double changes_a_second() const {
        return static_cast<double>(changes) * kFrames_hz / static_cast<double>(frames);
    }
};

/// Of this thread: what others do on the machine does not count.
double processor_ms() {
    std::timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
}

double percentile(std::vector<double> ms, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(ms.size() - 1));
    std::nth_element(ms.begin(), ms.begin() + at, ms.end());
    return ms[static_cast<std::size_t>(at)];
}

class Flight final : display::ElementLabels::Inputs {
public:
    Flight() : block_(1u << 16) {
        base::Arena arena(block_.data(), block_.size());
        static_cast<void>(labels_.start(arena));
        for (const scene::LayerRole role : {scene::LayerRole::obstacle, scene::LayerRole::runway, scene::LayerRole::place}) {
            design::DataElement element;
            element.role = role;
            element.technique = design::DataTechnique::billboard;
            static_cast<void>(elements_.try_push_back(element));
        }
        labels_.set(&scene_.scene(), elements_, {});
        ground_.undulation = 0;
    }

    Outcome fly(double minutes, bool remembers) {
        Outcome outcome;
        std::vector<std::uint64_t> changes;
        for (int frame = 0; frame < minutes * 60 * kFrames_hz; ++frame) {
            look(frame / kFrames_hz);
            const base::Time now = base::Time{} + base::Duration::from_seconds(frame / kFrames_hz);
            const bool decides = frame % static_cast<int>(kFrames_hz / 2) == 0;
            if (decides && !remembers) forget();
            const double start_ms = processor_ms();
            const display::LabelCounts counts = place(now);
            const double ms = processor_ms() - start_ms;
            (decides ? outcome.intervals_ms : outcome.frames_ms).push_back(ms);
            check(outcome);
            outcome.named += counts.placed;
            changes.push_back(frame == 0 ? 0 : counts.changed);
            ++outcome.frames;
        }
        for (std::size_t n = 0; n < changes.size(); ++n) {
            outcome.changes += changes[n];
            std::uint64_t second = 0;
            for (std::size_t k = n; k < std::min(n + static_cast<std::size_t>(kFrames_hz), changes.size()); ++k)
                second += changes[k];
            outcome.worst_second = std::max(outcome.worst_second, second);
            outcome.calm_seconds += second <= kMaxChanges ? 1 : 0;
        }
        return outcome;
    }

private:
    const draw::ElementInput* input(const design::DataElement& element, const scene::Layer& layer) override {
        return &input_.emplace(draw::ElementInput{element, 0, layer, ground_, {}});
    }

    /// North, with the small motions of an autopilot in calm air.
    void look(double time_s) {
        const double latitude = base::radians(test_support::BillboardRoom::kEyeLatitude_deg) +
                                kSpeed_mps * time_s / earth::meridian_radius_m(base::radians(46.8));
        const double longitude = base::radians(test_support::BillboardRoom::kEyeLongitude_deg);
        const double heading = base::radians(0.4) * std::sin(0.21 * time_s), pitch = base::radians(0.5) * std::sin(0.37 * time_s),
                     roll = base::radians(1.0) * std::sin(0.29 * time_s);
        room_.view = test_support::free_view(earth::to_ecef({latitude, longitude, {kHeight_m}}),
                                             earth::body_axes(latitude, longitude, heading, pitch, roll), 1024, 768, 1);
    }

    display::LabelCounts place(base::Time now) {
        labels_.decide({ground_, room_.view, {}, {}, now, 16});
        room_.begin();
        display::ElementLabels::Pass pass(labels_, room_.sheet, *this, nullptr);
        pass.add_protected();
        pass.add_others();
        return pass.count();
    }

    /// All but what the frame before showed.
    void forget() {
        display::LabelHistory memory;
        labels_.keep(memory);
        memory.forget();
        labels_.restore(memory);
    }

    /// By the boxes that were claimed, and by every corner that is drawn.
    void check(Outcome& outcome) const {
        const base::Span<const draw::Rect> boxes = room_.sheet.boxes();
        for (std::size_t n = 0; n < boxes.size(); ++n)
            for (std::size_t k = 0; k < n; ++k) outcome.overlaps += boxes[n].overlaps(boxes[k]) ? 1 : 0;
        constexpr float kSmoothed_px = 2;
        for (const draw::QuadVertex& vertex : room_.batch.vertices()) {
            const auto holds = [&](const draw::Rect& box) {
                return box.shrunk(-kSmoothed_px).contains(draw::Point{vertex.x, vertex.y});
            };
            outcome.astray += std::any_of(boxes.begin(), boxes.end(), holds) ? 0 : 1;
        }
    }

    test_support::LoadedScene scene_{country()};
    std::vector<unsigned char> block_;
    design::DataElementList elements_;
    display::ElementLabels labels_;
    test_support::BillboardRoom room_{65'536};
    test_support::LevelGround ground_;
    std::optional<draw::ElementInput> input_;
};

}  // namespace

int main(int argc, char** argv) {
    bool json = false;
    double minutes = 20;
    for (int n = 1; n < argc; ++n) {
        if (std::strcmp(argv[n], "--json") == 0) {
            json = true;
        } else if (std::strcmp(argv[n], "--minutes") == 0 && n + 1 < argc) {
            char* rest = nullptr;
            minutes = std::strtod(argv[++n], &rest);
            if (*rest != 0 || !(minutes > 0)) {
                std::fprintf(stderr, "bench_labels: --minutes takes a number of minutes above 0, not '%s'\n", argv[n]);
                return 2;
            }
        } else {
            std::fprintf(stderr, "bench_labels: unknown argument '%s'; --json and --minutes M are known\n", argv[n]);
            return 2;
        }
    }
    Flight flight;
    const Outcome calm = flight.fly(minutes, true), nervous = flight.fly(std::min(minutes, 2.0), false);
    const bool is_right = calm.overlaps == 0 && calm.astray == 0 && calm.named > 10 * calm.frames;
    std::vector<BenchResult> lines;
    const auto add = [&](const char* name, double value, const char* unit, double target, double baseline) {
        lines.push_back({name, value, unit, target, is_right && value <= target, baseline});
    };
    const double interval_ms = percentile(calm.intervals_ms, 0.5), frame_ms = percentile(calm.frames_ms, 0.5);
    add("placement of 5000: mean of all frames", calm.mean_ms(), "ms", kTarget_ms, frame_ms);
    add("placement of 5000: frames that decide, median", interval_ms, "ms", kTarget_ms, frame_ms);
    add("placement of 5000: frames that decide, 95 %", percentile(calm.intervals_ms, 0.95), "ms", kTarget_ms, interval_ms);
    add("overlaps", static_cast<double>(calm.overlaps + calm.astray), "signs", 0, static_cast<double>(nervous.overlaps));
    add("visible changes a second", calm.changes_a_second(), "changes", kMaxChanges, nervous.changes_a_second());
    for (const Outcome* outcome : {&calm, &nervous}) {
        const auto frames = static_cast<double>(outcome->frames);
        std::fprintf(stderr, "%s: %.0f frames, %.1f names a frame, %.1f %% of seconds with at most 2 changes, at most %.0f\n",
                     outcome == &calm ? "as it is" : "without a memory", frames, static_cast<double>(outcome->named) / frames,
                     100 * static_cast<double>(outcome->calm_seconds) / frames, static_cast<double>(outcome->worst_second));
    }
    return bench::report(lines, json);
}
