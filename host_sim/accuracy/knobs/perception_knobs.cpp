#include "host_sim/accuracy/knobs/perception_knobs.hpp"

#include <array>
#include <cmath>

#include "host_sim/accuracy/knobs/measured_picture.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kPictures = 16, kQuickPictures = 1;
constexpr int kStartLevels[] = {2, 1, 0};
constexpr int kShrinkings[] = {4, 2, 1};
constexpr const char* kPerceptionNeverTrades =
    "No picture is drawn from a measure; gaze and contracts state the size they measured at.";

std::vector<MeasuredPicture> measured_pictures(std::uint64_t seed, bool is_quick) {
    SeededRandom numbers(seed);
    std::vector<MeasuredPicture> pictures;
    for (std::size_t n = 0; n < (is_quick ? kQuickPictures : kPictures); ++n) pictures.emplace_back(numbers);
    return pictures;
}

std::vector<KnobLevel> levels_of_size() { return {{"a quarter of the size", 0.25}, {"half of the size", 0.5}, {"full size", 1}}; }

std::string place_in_picture(std::size_t sample, std::size_t number, int columns, const char* what) {
    return "picture " + std::to_string(sample) + ", " + what + " column " +
           std::to_string(number % static_cast<std::size_t>(columns)) + ", row " +
           std::to_string(number / static_cast<std::size_t>(columns));
}

KnobFacts saliency_start_facts() {
    return {"saliency_start",
            "Size at which saliency begins",
            "perception::SaliencyModel::look(): full size for pictures, a quarter for the frames of a flight (kFlightStartLevel)",
            "difference of the saliency of a pixel of the map, on the fixed scale",
            "share of the scale",
            {"the same model from full size", 0.002,
             "over 30 pictures it is within this of the same model in double (tests/support/itti_reference)"},
            "the model pixel by pixel in double (tests/render_core/perception)",
            kPerceptionNeverTrades,
            "size along a side",
            std::nullopt,
            levels_of_size()};
}

class SaliencyStartKnob final : public Knob {
public:
    explicit SaliencyStartKnob(const KnobGround& ground)
        : Knob(saliency_start_facts()),
          pictures_(measured_pictures(18, ground.is_quick)),
          memory_(perception::SaliencyModel::bytes(MeasuredPicture::kWidth, MeasuredPicture::kHeight, 0)) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!model_.start(arena, MeasuredPicture::kWidth, MeasuredPicture::kHeight, 0))
            throw UserError("no memory for a map of saliency");
        for (std::size_t sample = 0; sample < pictures_.size(); ++sample) {
            const perception::SaliencyMap map = map_of(std::size(kStartLevels) - 1, sample);
            exact_.emplace_back(map.values.begin(), map.values.end());
        }
    }

    [[nodiscard]] std::size_t samples() const override { return pictures_.size(); }
    void run(std::size_t level, std::size_t sample) override { static_cast<void>(map_of(level, sample)); }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const perception::SaliencyMap map = map_of(level, sample);
        for (std::size_t n = 0; n < map.values.size(); ++n)
            errors.push_back(std::abs(static_cast<double>(map.values[n]) - static_cast<double>(exact_[sample][n])));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return place_in_picture(sample, error, MeasuredPicture::kWidth / 4, "4 x 4 pixels:");
    }
    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override {
        return perception::SaliencyModel::bytes(MeasuredPicture::kWidth, MeasuredPicture::kHeight, kStartLevels[level]);
    }

private:
    perception::SaliencyMap map_of(std::size_t level, std::size_t sample) {
        if (!model_.look(pictures_[sample].view(), kStartLevels[level])) throw UserError("saliency refuses a measured picture");
        return model_.map(perception::SaliencyScale::fixed);
    }

    std::vector<MeasuredPicture> pictures_;
    std::vector<unsigned char> memory_;
    perception::SaliencyModel model_;
    std::vector<std::vector<float>> exact_;
};

KnobFacts edge_size_facts() {
    return {"edge_size",
            "Size at which edges are counted",
            "the picture that perception::EdgeDetector is given; every measure of the product gives it the full size",
            "difference of the density of edges in a region, of 8 x 6 in a picture",
            "share of the pixels",
            {"edges at full size", 0, "the detector calculates in integers; the density at full size is the measure itself"},
            "OpenCV's GaussianBlur and Canny, equal bit for bit (tests/render_core/perception)",
            kPerceptionNeverTrades,
            "size along a side",
            std::nullopt,
            levels_of_size()};
}

/// The greatest gradient that a step from 0 to 255 has after a blur.
double gradient_of_step(double sigma) {
    const auto share = [&](double px) { return std::erf(px / sigma / std::sqrt(2.0)); };
    return 1020 * 0.5 * (share(1.5) + share(0.5));
}

/// The same blur on the display, and the same step as a threshold.
perception::CannySettings canny_at(int shrinking) {
    perception::CannySettings settings;
    const double full = gradient_of_step(settings.sigma);
    settings.sigma /= shrinking;
    const double gain = gradient_of_step(settings.sigma) / full;
    settings.low *= gain;
    settings.high *= gain;
    return settings;
}

class EdgeSizeKnob final : public Knob {
public:
    using Densities = std::array<double, 48>;

    explicit EdgeSizeKnob(const KnobGround& ground)
        : Knob(edge_size_facts()), memory_(perception::EdgeDetector::bytes(MeasuredPicture::kWidth, MeasuredPicture::kHeight)) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!detector_.start(arena, MeasuredPicture::kWidth, MeasuredPicture::kHeight)) throw UserError("no memory for edges");
        const std::vector<MeasuredPicture> pictures = measured_pictures(19, ground.is_quick);
        for (std::size_t level = 0; level < std::size(kShrinkings); ++level)
            for (const MeasuredPicture& picture : pictures) pictures_[level].push_back(picture.shrunk(kShrinkings[level]));
        for (std::size_t sample = 0; sample < pictures.size(); ++sample)
            exact_.push_back(densities(std::size(kShrinkings) - 1, sample));
    }

    [[nodiscard]] std::size_t samples() const override { return exact_.size(); }
    void run(std::size_t level, std::size_t sample) override { static_cast<void>(densities(level, sample)); }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const Densities found = densities(level, sample);
        for (std::size_t n = 0; n < found.size(); ++n) errors.push_back(std::abs(found[n] - exact_[sample][n]));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return place_in_picture(sample, error, perception::RegionGrid{}.columns, "region");
    }
    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override {
        return perception::EdgeDetector::bytes(MeasuredPicture::kWidth / kShrinkings[level],
                                               MeasuredPicture::kHeight / kShrinkings[level]);
    }

private:
    Densities densities(std::size_t level, std::size_t sample) {
        const perception::PictureView picture = pictures_[level][sample].view();
        const base::Span<const std::uint8_t> edges = detector_.detect(picture, canny_at(kShrinkings[level]));
        Densities found{};
        if (edges.empty() ||
            !perception::region_densities({edges, picture.width, picture.height}, {}, {found.data(), found.size()}))
            throw UserError("the detector of edges refuses a measured picture");
        // A line stays one pixel wide, while a picture has fewer pixels.
        for (double& density : found) density /= kShrinkings[level];
        return found;
    }

    std::array<std::vector<MeasuredPicture>, std::size(kShrinkings)> pictures_;
    std::vector<unsigned char> memory_;
    perception::EdgeDetector detector_;
    std::vector<Densities> exact_;
};

}  // namespace

std::unique_ptr<Knob> make_saliency_start_knob(const KnobGround& ground) { return std::make_unique<SaliencyStartKnob>(ground); }
std::unique_ptr<Knob> make_edge_size_knob(const KnobGround& ground) { return std::make_unique<EdgeSizeKnob>(ground); }

}  // namespace tedavis::host_sim
