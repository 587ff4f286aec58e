#include "host_sim/evaluation/picture_meter.hpp"

#include <algorithm>
#include <new>

#include "host_sim/user_error.hpp"
#include "render_core/perception/layer_saliency.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kAlignmentRoom = 64;  // of the parts of an arena

perception::PictureView perception_view(const RgbaPicture& picture) {
    return perception::packed_picture(picture.pixels.data(), static_cast<int>(picture.width), static_cast<int>(picture.height),
                                      4);
}

void add_layers(const perception::SaliencyMap& map, const LayerMask& mask, PictureMeasures& measures) {
    perception::LayerSaliencies layers;
    const perception::LayerView view{
        {mask.layers.data(), mask.layers.size()}, static_cast<int>(mask.width), static_cast<int>(mask.height)};
    if (!perception::layer_saliency(map, view, layers)) return;
    for (std::size_t n = 0; n < std::min(mask.names.size(), layers.size()); ++n)
        measures.layers.push_back({mask.names[n], layers[n].share, layers[n].area});
}

}  // namespace

void PictureMeter::make_room(int width, int height) {
    if (width <= most_width_ && height <= most_height_) return;
    most_width_ = std::max(width, most_width_);
    most_height_ = std::max(height, most_height_);
    const std::size_t edge_bytes = perception::EdgeDetector::bytes(most_width_, most_height_);
    const std::size_t model_bytes = perception::SaliencyModel::bytes(most_width_, most_height_, settings_.saliency_start_level);
    memory_.assign(edge_bytes + model_bytes + 2 * kAlignmentRoom, std::byte{});
    base::Arena arena(memory_.data(), memory_.size());
    detector_ = {};
    model_ = {};
    if (!detector_.start(arena, most_width_, most_height_) ||
        !model_.start(arena, most_width_, most_height_, settings_.saliency_start_level))
        throw std::bad_alloc();
}

PictureMeasures PictureMeter::measure(const RgbaPicture& picture, const std::string& name, const LayerMask* mask,
                                      const std::vector<GazePixel>& gaze) {
    constexpr auto kMax = static_cast<std::uint32_t>(perception::kMaxPictureSide);
    if (picture.width > kMax || picture.height > kMax)
        throw UserError(name + ": larger than " + std::to_string(kMax) + " pixels a side; scale it down");
    const perception::PictureView view = perception_view(picture);
    make_room(view.width, view.height);
    width_ = picture.width;
    height_ = picture.height;
    PictureMeasures measures;
    measures.width = width_;
    measures.height = height_;
    measure_edges(view, measures);
    measure_saliency(view, mask, measures);
    if (!gaze.empty()) measures.gaze = gaze_score(saliency().values, width_, gaze);
    return measures;
}

void PictureMeter::measure_edges(const perception::PictureView& view, PictureMeasures& measures) {
    const base::Span<const std::uint8_t> found = detector_.detect(view, settings_.canny);
    edges_.assign(found.begin(), found.end());
    measures.clutter_grid.resize(static_cast<std::size_t>(settings_.grid.count()));
    const perception::EdgeView edges{found, view.width, view.height};
    if (found.empty() ||
        !perception::region_densities(edges, settings_.grid, {measures.clutter_grid.data(), measures.clutter_grid.size()}))
        throw std::logic_error("settings of an evaluation that are not valid");
    measures.clutter = perception::edge_density(edges);
}

void PictureMeter::measure_saliency(const perception::PictureView& view, const LayerMask* mask, PictureMeasures& measures) {
    if (!model_.look(view, settings_.saliency_start_level)) throw std::logic_error("a picture that is not valid");
    const perception::SaliencyMap fixed = model_.map(perception::SaliencyScale::fixed);
    double sum = 0;
    for (const float value : fixed.values) sum += static_cast<double>(value);
    measures.saliency_level = sum / static_cast<double>(fixed.values.size());
    if (mask != nullptr) add_layers(model_.map(perception::SaliencyScale::per_picture), *mask, measures);
}

FloatMap PictureMeter::saliency() {
    const perception::SaliencyMap map = saliency_map();
    const auto cell = static_cast<float>(1 << map.level);
    const FloatMap cells{static_cast<std::uint32_t>(map.width),
                         static_cast<std::uint32_t>(map.height),
                         cell,
                         cell,
                         {map.values.begin(), map.values.end()}};
    return enlarged(cells, width_, height_);
}

FloatMap PictureMeter::second_opinion(const RgbaPicture& picture) {
    if (opinion_memory_.empty()) {
        opinion_memory_.resize(perception::SpectralResidual::bytes() + kAlignmentRoom);
        base::Arena arena(opinion_memory_.data(), opinion_memory_.size());
        if (!opinion_.start(arena)) throw std::bad_alloc();
    }
    if (!opinion_.look(perception_view(picture))) throw std::logic_error("a picture that is not valid");
    constexpr auto kSide = static_cast<std::uint32_t>(perception::kResidualSide);
    const base::Span<const float> values = opinion_.values();
    const FloatMap map{kSide,
                       kSide,
                       static_cast<float>(picture.width) / kSide,
                       static_cast<float>(picture.height) / kSide,
                       {values.begin(), values.end()}};
    return enlarged(map, picture.width, picture.height);
}

}  // namespace tedavis::host_sim
