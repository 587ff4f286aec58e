/// Measures the pictures of peers against the full surface that each was given, in double.
///
///     peer_measure FOLDER WIDTH HEIGHT
///     in   pose X Y Z HEADING PITCH ROLL             the reference rays of this pose are traced
///     in   picture FILE SURFACE BOUND UNIT           out  a line of JSON
///
/// SURFACE is `flat` (two triangles a cell, divided from south-west to north-east), `either` (the range between both divisions)
/// or `earth` (the same posts on the WGS84 ellipsoid plus undulation, as FOLDER/ground.tdb has them). BOUND is the peer's own, in
/// UNIT `px` or `m`, or `none`.
///
/// The error of a pixel: its ray and its depth give a point of the drawn surface; the vertical distance from there to the full
/// surface, projected, is the error in pixels. Points within two cells of the raster's border are left out. Of every eighth pixel
/// each way, where SURFACE is over the plane, the depth is compared with that of the exact first hit: `wrong` are those
/// that show sky instead of ground, ground instead of sky, or ground whose depth is off by more than a hundredth.
#include <array>
#include <iostream>
#include <memory>
#include <sstream>
#include <thread>

#include "tests/bench/peers/earth_ground.hpp"
#include "tests/bench/peers/flat_ground.hpp"
#include "tests/bench/peers/peer_loop.hpp"

namespace {

using namespace tedavis;
using peers::Pose;

constexpr unsigned kThreads = 2;
constexpr std::uint32_t kEvery = 8;  // of the pixels whose exact hits are traced
constexpr double kOtherDepth = 0.01;

enum class Surface { flat, either, earth };

/// Counts by size, 64 bins an octave, from 2^-24 to 2^24.
struct Histogram {
    static constexpr int kBins = 48 * 64;
    std::array<std::uint64_t, kBins> counts{};

    void add(double size) {
        const double bin = size > 0 ? 64 * (std::log2(size) + 24) : 0;
        ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
    }
    void include(const Histogram& other) {
        for (std::size_t n = 0; n < kBins; ++n) counts[n] += other.counts[n];
    }
    /// The occupied bins, as JSON; run adds those of all poses up.
    [[nodiscard]] std::string text() const {
        std::string all = "{";
        for (std::size_t n = 0; n < kBins; ++n)
            if (counts[n] > 0) all += (all.size() > 1 ? ", \"" : "\"") + std::to_string(n) + "\": " + std::to_string(counts[n]);
        return all + "}";
    }
};

struct Found {
    double max_px = 0, max_m = 0;
    std::uint64_t pixels = 0, beyond = 0, compared = 0, wrong = 0;
    Histogram px;

    void include(const Found& other) {
        max_px = std::max(max_px, other.max_px);
        max_m = std::max(max_m, other.max_m);
        pixels += other.pixels;
        beyond += other.beyond;
        compared += other.compared;
        wrong += other.wrong;
        px.include(other.px);
    }
};

struct Question {
    Surface surface = Surface::flat;
    double bound = std::numeric_limits<double>::infinity();
    bool is_in_metres = false;
};

class Measure {
public:
    explicit Measure(const peers::PeerArguments& given)
        : size_(given.size),
          folder_(given.folder),
          ground_(peers::read_ground(given.folder)),
          hits_(std::size_t{size_.width / kEvery} * (size_.height / kEvery)) {}

    void look(const Pose& pose) {
        pose_ = pose;
        axes_ = peers::axes_of(pose);
        in_threads([&](unsigned thread) {
            for (std::uint32_t y = thread; y < size_.height / kEvery; y += kThreads)
                for (std::uint32_t x = 0; x < size_.width / kEvery; ++x)
                    hits_[std::size_t{y} * (size_.width / kEvery) + x] =
                        ground_.first_hit_m({pose_.x_m, pose_.y_m, pose_.z_m}, direction(x * kEvery, y * kEvery));
        });
    }
    Found compare(const std::string& file, const Question& question) {
        const std::vector<float> depth = peers::read_values<float>(file, size_.pixels());
        if (question.surface == Surface::earth && !earth_)
            earth_ = std::make_unique<peers::EarthGround>(folder_ + "/ground.tdb", ground_);
        if (earth_) earth_->look(pose_);
        std::array<Found, kThreads> parts;
        in_threads([&](unsigned thread) {
            for (std::uint32_t y = thread; y < size_.height; y += kThreads) compare_row(depth, y, question, parts[thread]);
        });
        for (unsigned n = 1; n < kThreads; ++n) parts[0].include(parts[n]);
        return parts[0];
    }

private:
    template <class Work>
    static void in_threads(const Work& work) {
        std::thread other([&] { work(1); });
        work(0);
        other.join();
    }
    /// Of the pixel's middle; the depth along the axis grows by 1.
    [[nodiscard]] glm::dvec3 direction(std::uint32_t x, std::uint32_t y) const {
        const double u = (x + 0.5 - 0.5 * size_.width) / size_.focal_px(), v = (y + 0.5 - 0.5 * size_.height) / size_.focal_px();
        return axes_.forward + u * axes_.right + v * axes_.down;
    }
    void compare_row(const std::vector<float>& depth, std::uint32_t y, const Question& question, Found& found) const {
        for (std::uint32_t x = 0; x < size_.width; ++x) {
            const double depth_m = depth[std::size_t{y} * size_.width + x];
            if (question.surface != Surface::earth && x % kEvery == 0 && y % kEvery == 0) compare_hit(x, y, depth_m, found);
            if (!std::isfinite(depth_m)) continue;
            const glm::dvec3 relative = depth_m * direction(x, y);
            double above_m = 0;
            glm::dvec3 up(0, 0, 1);
            const bool is_inside = question.surface == Surface::earth ? earth_->above(relative, above_m, up)
                                                                      : is_above(relative, question.surface, above_m);
            if (!is_inside) continue;
            const double px = projected_px(relative, above_m * up);
            found.px.add(px);
            found.max_px = std::max(found.max_px, px);
            found.max_m = std::max(found.max_m, std::fabs(above_m));
            ++found.pixels;
            if ((question.is_in_metres ? std::fabs(above_m) : px) > question.bound) ++found.beyond;
        }
    }
    void compare_hit(std::uint32_t x, std::uint32_t y, double depth_m, Found& found) const {
        const double exact_m = hits_[std::size_t{y / kEvery} * (size_.width / kEvery) + x / kEvery];
        ++found.compared;
        if (!std::isfinite(depth_m) && !std::isfinite(exact_m)) return;
        if (!(std::fabs(depth_m - exact_m) <= kOtherDepth * exact_m) || !std::isfinite(exact_m)) ++found.wrong;
    }
    [[nodiscard]] bool is_above(const glm::dvec3& relative, Surface surface, double& above_m) const {
        const double column = (pose_.x_m + relative.x) / peers::kSpacing_m;
        const double row = (peers::kExtent_m - pose_.y_m - relative.y) / peers::kSpacing_m;
        if (!peers::FlatGround::is_inside(column, row)) return false;
        const auto diagonal = surface == Surface::either ? peers::Diagonal::either : peers::Diagonal::north_east;
        above_m = ground_.above_m(column, row, pose_.z_m + relative.z, diagonal);
        return true;
    }
    /// Between the projections of a drawn point and of the point that lies `offset` below it.
    [[nodiscard]] double projected_px(const glm::dvec3& drawn, const glm::dvec3& offset) const {
        const auto place = [&](const glm::dvec3& at) {
            const double depth = std::max(1.0, glm::dot(at, axes_.forward));
            return glm::dvec2(glm::dot(at, axes_.right), glm::dot(at, axes_.down)) * (size_.focal_px() / depth);
        };
        return glm::length(place(drawn) - place(drawn - offset));
    }

    peers::PictureSize size_;
    std::string folder_;
    peers::FlatGround ground_;
    std::unique_ptr<peers::EarthGround> earth_;
    std::vector<double> hits_;
    Pose pose_;
    peers::Axes axes_{};
};

Question question_of(std::istringstream& words) {
    Question question;
    std::string surface, bound, unit;
    words >> surface >> bound >> unit;
    question.surface = surface == "earth" ? Surface::earth : surface == "either" ? Surface::either : Surface::flat;
    if (bound != "none") question.bound = std::stod(bound);
    question.is_in_metres = unit == "m";
    return question;
}

void answer(Measure& measure, const std::string& line) {
    std::istringstream words(line);
    std::string kind, file;
    words >> kind;
    if (kind == "pose") {
        Pose pose;
        if (!peers::parse_pose(line.substr(5), pose)) throw std::runtime_error("is no pose: " + line);
        return measure.look(pose);
    }
    words >> file;
    const Found found = measure.compare(file, question_of(words));
    std::cout << "{\"max_px\": " << found.max_px << ", \"max_m\": " << found.max_m << ", \"pixels\": " << found.pixels
              << ", \"beyond\": " << found.beyond << ", \"compared\": " << found.compared << ", \"wrong\": " << found.wrong
              << ", \"px\": " << found.px.text() << "}" << std::endl;
}

}  // namespace

int main(int count, char** given) {
    return peers::run_peer("peer_measure", [&] {
        Measure measure(peers::PeerArguments::of(count, given));
        for (std::string line; std::getline(std::cin, line);) answer(measure, line);
    });
}
