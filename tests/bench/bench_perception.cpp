/// What measures of perception cost on one core: edges of three colours and saliency of the shipped approach picture at 1024 x
/// 768 and 1920 x 1080, beside OpenCV's edges and the full-resolution saliency, what coarser starts change, and what parts cost;
/// and the edges of a display's own picture. The least of many turns that alternate, as other work on the machine only adds.
/// `--json` prints the lines as a list, `--picture X.png` measures another picture at its own size.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/commands/own_ground.hpp"
#include "host_sim/commands/shot.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/temporary_folder.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"
#include "render_core/perception/layer_saliency.hpp"
#include "render_core/perception/saliency_model.hpp"
#include "render_core/perception/spectral_residual.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/bench/surface_edges.hpp"
#include "tests/support/perception/rank_correlation.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::perception;
using bench::BenchResult;

constexpr int kIterations = 20, kInARow = 6;
constexpr double kEdgesTarget_ms = 6, kSaliencyTarget_ms = 3, kGrowthTarget = 2.9, kDisagreementTarget = 0.005,
                 kReadBackTarget = 1.5, kDensityTarget = 0.000001;
constexpr double kNoTarget = std::numeric_limits<double>::max();

/// The least of turns that alternate, each of some in a row, as over the pictures of a flight.
std::vector<double> least_ms(const std::vector<std::function<void()>>& works) {
    std::vector<double> least(works.size(), kNoTarget);
    for (int iteration = 0; iteration < kIterations; ++iteration)
        for (std::size_t n = 0; n < works.size(); ++n)
            for (int k = 0; k < kInARow; ++k) {
                const base::Time start = platform::monotonic_now();
                works[n]();
                least[n] = std::min(least[n], (platform::monotonic_now() - start).to_seconds() * 1000);
            }
    return least;
}

template <class Measure>
class Started {
public:
    template <class... Sizes>
    explicit Started(const Sizes&... sizes) : block_(Measure::bytes(sizes...)) {
        base::Arena arena(block_.data(), block_.size());
        if (!measure.start(arena, sizes...)) throw std::runtime_error("a measure finds no room");
    }
    Measure measure;

private:
    std::vector<unsigned char> block_;
};

class Picture {
public:
    explicit Picture(const host_sim::RgbaPicture& png)
        : width(static_cast<int>(png.width)), height(static_cast<int>(png.height)), rgba(png.pixels) {}
    [[nodiscard]] PictureView view() const { return packed_picture(rgba.data(), width, height, 4); }
    [[nodiscard]] std::size_t pixels() const { return pixels_of(width, height); }
    /// Means of n x n pixels.
    [[nodiscard]] Picture shrunk(int n) const {
        host_sim::RgbaPicture smaller;
        smaller.width = static_cast<std::uint32_t>(width / n);
        smaller.height = static_cast<std::uint32_t>(height / n);
        for (int y = 0; y < height / n; ++y)
            for (int x = 0; x < width / n * 4; ++x) {
                int sum = 0;
                for (int v = 0; v < n; ++v)
                    for (int u = 0; u < n; ++u)
                        sum += rgba[(pixels_of(width, n * y + v) + static_cast<std::size_t>(n * (x / 4) + u)) * 4 +
                                    static_cast<std::size_t>(x % 4)];
                smaller.pixels.push_back(static_cast<std::uint8_t>((sum + n * n / 2) / (n * n)));
            }
        return Picture(smaller);
    }
    int width, height;
    std::vector<std::uint8_t> rgba;
};

/// On final approach to the shipped strip, with the shipped scene.
Picture approach_picture(const host_sim::PictureOptions& ground, host_sim::PictureSize size, const std::string& folder) {
    host_sim::ShotOptions options;
    options.picture = ground;
    options.picture.size = size;
    options.picture.design = "approach";
    options.pose = {36.55, -84.25, 900, 40, -3, 0};
    options.phase = "approach.final";
    options.output = folder + "/approach.png";
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, true, false);
    if (host_sim::run_shot(options, console) != 0) throw std::runtime_error("the picture could not be taken");
    return Picture(host_sim::read_png(options.output));
}

cv::Mat edges_of_opencv(const Picture& picture, const CannySettings& settings) {
    cv::Mat all = cv::Mat::zeros(picture.height, picture.width, CV_8U), channels[4];
    const cv::Mat rgba(picture.height, picture.width, CV_8UC4, const_cast<std::uint8_t*>(picture.rgba.data()));
    cv::split(rgba, channels);
    for (int c = 0; c < 3; ++c) {
        cv::Mat blurred, edges;
        cv::GaussianBlur(channels[c], blurred, cv::Size(0, 0), settings.sigma, settings.sigma, cv::BORDER_REPLICATE);
        cv::Canny(blurred, edges, settings.low, settings.high, 3, true);
        all |= edges;
    }
    return all;
}

/// A blur of `sigma` makes of a step of 255 levels a gradient of so much at most.
double step_gradient(double sigma) {
    return 1020 * 0.5 * (std::erf(1.5 / sigma / std::sqrt(2)) + std::erf(0.5 / sigma / std::sqrt(2)));
}

class Bench {
public:
    Bench(Picture picture, std::vector<BenchResult>& lines)
        : picture_(std::move(picture)),
          name_(std::to_string(picture_.width) + " x " + std::to_string(picture_.height) + ": "),
          lines_(&lines),
          detector_(picture_.width, picture_.height),
          model_(picture_.width, picture_.height, 0) {}

    /// The work alone, to be compared with another picture's.
    void find_edges() { edges_ = detector_.measure.detect(picture_.view(), settings_); }
    void find_salient() { look(2); }

    void edges(bool has_target) {
        cv::Mat of_opencv;
        const std::vector<double> ms =
            least_ms({[&] { find_edges(); }, [&] { of_opencv = edges_of_opencv(picture_, settings_); }});
        std::size_t differing = 0;
        for (std::size_t n = 0; n < edges_.size(); ++n) differing += edges_[n] != of_opencv.data[n] ? 1 : 0;
        density_ = edge_density({edges_, picture_.width, picture_.height});
        const double disagreement = static_cast<double>(differing) / static_cast<double>(edges_.size());
        add("edges of three colours", ms[0], "ms", has_target ? kEdgesTarget_ms : kNoTarget, ms[1]);
        add("of OpenCV's time", ms[0] / ms[1], "", kNoTarget, 1);
        add("pixels unlike OpenCV's", disagreement, "share", kDisagreementTarget, 0);
        add("edge density", density_, "share", kNoTarget, cv::countNonZero(of_opencv) / static_cast<double>(picture_.pixels()));
        edges_ms_ = ms[0];
    }

    /// Of pictures of half and a quarter of the size, with sigma the same on the display and thresholds the same for a step.
    void smaller_edges() {
        for (const int n : {2, 4}) {
            const Picture smaller = picture_.shrunk(n);
            Started<EdgeDetector> started(smaller.width, smaller.height);
            base::Span<const std::uint8_t> edges;
            CannySettings settings;
            settings.sigma = settings_.sigma / n;
            const double gain = step_gradient(settings.sigma) / step_gradient(settings_.sigma);
            settings.low *= gain;
            settings.high *= gain;
            const std::vector<double> ms = least_ms({[&] { edges = started.measure.detect(smaller.view(), settings); }});
            const std::string size = "edges at 1/" + std::to_string(n);
            add(size, ms[0], "ms", kNoTarget, edges_ms_);
            // Lines are as long in pixels as the picture is small, and one pixel wide.
            add(size + ": density off by", std::fabs(edge_density({edges, smaller.width, smaller.height}) / n - density_),
                "share", kNoTarget, density_);
        }
    }

    /// Of a display's own picture, which is read back from the machine's own OpenGL.
    void edges_of_surface() {
        bench::SurfaceEdges surface(picture_.rgba.data(), static_cast<std::uint32_t>(picture_.width),
                                    static_cast<std::uint32_t>(picture_.height));
        effects::ClutterMap map;
        const std::vector<double> ms = least_ms({[&] { map = surface.measure(); }, [&] { find_edges(); }});
        std::vector<double> densities(48);
        static_cast<void>(region_densities({edges_, picture_.width, picture_.height}, {}, densities));
        double most = 0;
        for (std::size_t n = 0; n < densities.size(); ++n)
            most = std::max(most, std::fabs(static_cast<double>(map.measure[n]) - densities[n]));
        add("clutter of a surface, read back", ms[0], "ms", kNoTarget, ms[1]);
        add("of the time without reading back", ms[0] / ms[1], "", kReadBackTarget, 1);
        add("regions' densities of a surface, most off by", most, "share", kDensityTarget, 0);
    }

    void saliency(bool has_target) {
        const std::vector<double> ms = least_ms({[&] { look(0); }, [&] { look(1); }, [&] { look(2); },
                                                 [&] { static_cast<void>(model_.measure.map(SaliencyScale::fixed)); }});
        const std::vector<float> full = values(0, SaliencyScale::per_picture), fixed = values(0, SaliencyScale::fixed);
        add("saliency from 1/4", ms[2], "ms", has_target ? kSaliencyTarget_ms : kNoTarget, ms[0]);
        add("saliency from 1/2", ms[1], "ms", kNoTarget, ms[0]);
        add("saliency from full resolution", ms[0], "ms", kNoTarget, ms[0]);
        add("another map of the same features", ms[3], "ms", kNoTarget, ms[2]);
        for (const int start_level : {1, 2}) {
            const std::string from_level = "saliency from 1/" + std::to_string(1 << start_level) + ": ";
            rank(from_level + "rank correlation to full", full, values(start_level, SaliencyScale::per_picture));
            rank(from_level + "the same, fixed scale", fixed, values(start_level, SaliencyScale::fixed));
        }
    }

    void parts() {
        Started<SpectralResidual> residual;
        find_salient();
        const SaliencyMap map = model_.measure.map(SaliencyScale::per_picture);
        std::vector<std::uint8_t> layers(picture_.pixels());
        for (std::size_t n = 0; n < layers.size(); ++n) layers[n] = static_cast<std::uint8_t>(n / 37 % 5);
        std::vector<double> densities(48);
        LayerSaliencies sums;
        const std::vector<double> ms =
            least_ms({[&] { static_cast<void>(residual.measure.look(picture_.view())); },
                      [&] {
                          static_cast<void>(layer_saliency(map, {layers, picture_.width, picture_.height}, sums));
                      },
                      [&] {
                          static_cast<void>(region_densities({edges_, picture_.width, picture_.height}, {}, densities));
                      }});
        add("spectral residual", ms[0], "ms", kNoTarget, ms[0]);
        add("saliency by layer", ms[1], "ms", kNoTarget, ms[1]);
        add("edge density of 8 x 6 regions", ms[2], "ms", kNoTarget, ms[2]);
    }

private:
    void add(const std::string& what, double value, const char* unit, double target, double baseline) {
        lines_->push_back({name_ + what, value, unit, target, value <= target, baseline});
    }
    void rank(const std::string& what, const std::vector<float>& full, const std::vector<float>& coarser) {
        const double correlation = test_support::rank_correlation(full, coarser);
        lines_->push_back({name_ + what, correlation, "", 0.9, correlation >= 0.9, 1});
    }
    void look(int start_level) {
        static_cast<void>(model_.measure.look(picture_.view(), start_level));
        static_cast<void>(model_.measure.map(SaliencyScale::per_picture));
    }
    [[nodiscard]] std::vector<float> values(int start_level, SaliencyScale scale) {
        look(start_level);
        const SaliencyMap map = model_.measure.map(scale);
        return {map.values.begin(), map.values.end()};
    }

    Picture picture_;
    std::string name_;
    std::vector<BenchResult>* lines_;
    Started<EdgeDetector> detector_;
    Started<SaliencyModel> model_;
    base::Span<const std::uint8_t> edges_;
    CannySettings settings_;
    double edges_ms_ = 0, density_ = 0;
};

void measure_shipped(std::vector<BenchResult>& lines) {
    const host_sim::TemporaryFolder folder;
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    host_sim::PictureOptions ground;
    host_sim::use_own_ground(ground, folder.path(), console);
    Bench usual(approach_picture(ground, {1024, 768}, folder.path()), lines);
    Bench large(approach_picture(ground, {1920, 1080}, folder.path()), lines);
    usual.edges(true);
    large.edges(false);
    usual.smaller_edges();
    usual.edges_of_surface();
    large.edges_of_surface();
    usual.saliency(true);
    large.saliency(false);
    usual.parts();
    const std::vector<double> ms = least_ms(
        {[&] { usual.find_edges(); }, [&] { large.find_edges(); }, [&] { usual.find_salient(); }, [&] { large.find_salient(); }});
    const double pixels = 1920.0 * 1080 / (1024 * 768);
    for (const auto& [name, growth] : {std::pair{"edges", ms[1] / ms[0]}, {"saliency", ms[3] / ms[2]}})
        lines.push_back(
            {std::string(name) + ": 1920 x 1080 of 1024 x 768", growth, "", kGrowthTarget, growth <= kGrowthTarget, pixels});
}

}  // namespace

int main(int argc, char** argv) {
    bool json = false;
    std::string picture;
    for (int n = 1; n < argc; ++n) {
        if (std::strcmp(argv[n], "--json") == 0) {
            json = true;
        } else if (std::strcmp(argv[n], "--picture") == 0 && n + 1 < argc) {
            picture = argv[++n];
        } else {
            std::fprintf(stderr, "bench_perception: unknown argument '%s'; --json and --picture X.png are known\n", argv[n]);
            return 2;
        }
    }
    cv::setNumThreads(1);
    std::vector<BenchResult> lines;
    if (picture.empty()) {
        measure_shipped(lines);
    } else {
        Bench of(Picture(host_sim::read_png(picture)), lines);
        of.edges(false);
        of.smaller_edges();
        of.edges_of_surface();
        of.saliency(false);
        of.parts();
    }
    return bench::report(lines, json);
}
